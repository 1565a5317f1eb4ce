// SPDX-License-Identifier: Apache-2.0
#include "spec_engine/engine.h"

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "spec/language/alarm.h"
#include "spec/language/run_end.h"
#include "spec_engine/case_data.h"
#include "spec_engine/data.h"
#include "spec_engine/events.h"

namespace toolcomp::spec_engine {

bool available() { return true; }

std::vector<std::string> sections() {
  return {"fanuc/canned-cycle",
          "fanuc/cutter-compensation-b",
          "fanuc/cutter-compensation-c",
          "fanuc/leading-edge-offset",
          "fanuc/tool-center-point-control",
          "fanuc/tool-length-measurement",
          "fanuc/tool-length-offset",
          "fanuc/tool-offset",
          "fanuc/tool-posture-control",
          "fanuc/tool-side-compensation",
          "heidenhain/face-milling",
          "heidenhain/peripheral-milling",
          "heidenhain/programmed-contour"};
}

namespace {

// Of a run that is not judged at a block that can be read: heidenhain.program.unknown-position.
constexpr const char* kUnknownPosition = "an unknown position is needed here";

// The specification names causes. `beyond`: what of the block is not followed, if it cannot be read; else nullptr.
// Throws where it names one that the table of alarms does not have.
void name_end(spec::Event<exact::Real>& event, const spec::AlarmNumbers& numbers, const char* beyond) {
  const std::optional<spec::AlarmCause> cause = spec::find_alarm(event.number.view());
  if (!cause) throw std::logic_error("no alarm of spec/alarms.toml: " + std::string(event.number.view()));
  const char* const ours = beyond != nullptr ? beyond : kUnknownPosition;
  spec::end_run(event, *cause, spec::is_beyond(*cause) ? ours : spec::info(*cause).text, numbers);
}

}  // namespace

Run run(const spec::Case& c) {
  const bool fanuc = c.dialect == "fanuc";
  CaseData made = fanuc ? fanuc_case(c) : klartext_case(c);
  // What Coq defines runs on the stack, a frame for each block.
  constexpr std::size_t kMostBlocks = 50'000;
  Run result;
  if (made.places.size() > kMostBlocks) {
    result.not_said = "the formal specification is not run for more than 50,000 blocks";
    return result;
  }
  const Data said = run_case(made.data);
  if (const std::string& what = said.list().at(1).text(); !what.empty()) {
    result.not_said = "the formal specification is not run for " + what;
    return result;
  }
  const spec::AlarmNumbers numbers(c.setup);
  for (const Data& data : said.list().at(0).list()) {
    spec::Event<exact::Real> event =
        fanuc ? fanuc_event(data.list(), c.setup.axes) : klartext_event(data.list(), c.setup.axes);
    const Place& place = made.places.at(static_cast<std::size_t>(data.list().at(0).integer()));
    event.line = place.line;
    event.n = place.n;
    if (event.number == spec::Name(kBadInput)) std::rethrow_exception(made.bad_input);
    if (event.kind == spec::EventKind::alarm)
      name_end(event, numbers, &place == &made.places.back() ? made.beyond : nullptr);
    result.events.push_back(std::move(event));
  }
  return result;
}

}  // namespace toolcomp::spec_engine

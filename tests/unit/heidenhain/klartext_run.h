// SPDX-License-Identifier: Apache-2.0
// Runs a Klartext program in the exact engine and shows numbers as the tests have them typed in.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/basis/recorder.h"
#include "model/heidenhain/engine.h"
#include "spec/language/event_names.h"
#include "spec/language/heidenhain/klartext_reader.h"
#include "spec/language/setup_format.h"
#include "tests/unit/model_run.h"

namespace toolcomp::test {

using Forced = std::pair<std::size_t, exact::Sign>;

inline Run run_klartext(const std::string& setup, std::string_view program, const Forced* force = nullptr) {
  Run result{spec::read_setup_toml("control = \"heidenhain\"\n" + setup, "setup.toml"), model::Recorder(true), {}};
  if (force != nullptr) result.recorder.force(force->first, force->second);
  spec::klartext::Reader reader(spec::text_source(program), result.setup);
  model::klartext::Engine engine(result.setup, result.recorder, result.sink);
  spec::klartext::Block block;
  while (!engine.stopped() && reader.next(block)) engine.block(block);
  engine.end();
  return result;
}

inline std::string shown(const std::array<exact::Real, 3>& v, int digits = 15) {
  return v[0].decimal(digits) + ' ' + v[1].decimal(digits) + ' ' + v[2].decimal(digits);
}
// X Y Z of values by axis (setups here begin with X Y Z).
inline std::string shown(const spec::AxisValues<exact::Real>& v, int digits = 15) {
  return shown(std::array<exact::Real, 3>{v[0], v[1], v[2]}, digits);
}

inline std::vector<model::Event> events_of(const std::string& setup, std::string_view program) {
  return run_klartext(setup, program).sink.events;
}
inline std::vector<model::Event> moves(const Run& run) {
  std::vector<model::Event> result;
  for (const model::Event& event : run.events())
    if (event.kind == spec::EventKind::move) result.push_back(event);
  return result;
}
inline model::Event last_move(const std::string& setup, std::string_view program) {
  const std::vector<model::Event> all = moves(run_klartext(setup, program));
  return all.empty() ? model::Event() : all.back();
}

// "2 W_N_BELOW", "3 X1 Y2 Z3 (start-up)": line and point of moves, line and number of all else.
inline Lines story(const std::string& setup, std::string_view program, int digits = 6) {
  Lines result;
  for (const model::Event& event : events_of(setup, program)) {
    std::string line = std::to_string(event.line) + ' ';
    if (event.kind == spec::EventKind::move) {
      line += shown(event.point, digits);
      if (event.cause != spec::Cause::programmed) line += " (" + std::string(spec::name(event.cause)) + ')';
    } else {
      line += event.number.view();
    }
    result.push_back(line);
  }
  return result;
}

// The clause the last event of a run rests on last.
inline std::string last_clause(const std::string& setup, std::string_view program) {
  const std::vector<model::Event> events = events_of(setup, program);
  return events.empty() || events.back().clauses.empty() ? ""
                                                         : std::string(spec::info(events.back().clauses.back()).id);
}

// A tool table of one row: number 1 and these keys.
inline std::string tool(const std::string& keys) { return "[[tool]]\nnumber = 1\n" + keys; }

}  // namespace toolcomp::test

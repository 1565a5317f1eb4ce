// SPDX-License-Identifier: Apache-2.0
#include "certify/long_program.h"

#include <algorithm>
#include <utility>

#include "certify/event_fields.h"
#include "judge/oracle/agreement.h"
#include "judge/oracle/trial.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify {
namespace {

constexpr std::size_t kBeginning = 1 << 16;  // bytes

bool breaks_a_law(const Beginning& beginning) {
  judge::Verdict verdict;
  judge::hold_laws(beginning.c, beginning.run, verdict);
  return verdict.outcome == judge::Outcome::differs;
}

// The fields that agree are added to `fields`.
std::optional<judge::Agreed> agreement(const Capabilities& capabilities, const spec::Case& c, const Answer* answer,
                                       spec::FieldSet& fields) {
  if (answer == nullptr)
    return judge::streamed_agreement(c, {.fields = {}, .resolution = {}, .known = capabilities.known});
  const auto* const events = std::get_if<TextEvents>(&answer->result);
  if (events == nullptr || answer->missing || !meets_minimum(capabilities)) return std::nullopt;
  return judge::streamed_agreement(c, *events, judge_options(capabilities),
                                   [&fields](const model::Event& event) { fields.add(fields_of(event)); });
}

}  // namespace

std::optional<Beginning> beginning_of(const spec::Case& c) {
  const std::size_t end = c.program.rfind('\n', kBeginning);
  if (end == std::string::npos) return std::nullopt;
  Beginning beginning;
  // All of the case but its program, which is long.
  beginning.c.section = c.section;
  beginning.c.dialect = c.dialect;
  beginning.c.setup = c.setup;
  beginning.c.samples = c.samples;
  beginning.c.program = c.program.substr(0, end + 1);
  beginning.lines = static_cast<std::size_t>(std::ranges::count(beginning.c.program, '\n'));
  beginning.c.id = c.id + ", lines 1 to " + std::to_string(beginning.lines);
  try {
    beginning.run = judge::run_model(beginning.c);
  } catch (const spec::InputError&) {
    return std::nullopt;
  }
  // It may call or go to what stands behind it.
  const auto& events = beginning.run.events;
  if (!events.empty() && spec::ends_run(events.back().kind)) return std::nullopt;
  return beginning;
}

std::optional<LongProgram> judge_long(const Capabilities& capabilities, const spec::Case& c, const Answer* answer,
                                      const std::optional<Beginning>& beginning) {
  if (beginning && breaks_a_law(*beginning)) return std::nullopt;
  spec::FieldSet fields;
  auto agreed = agreement(capabilities, c, answer, fields);
  if (!agreed) return std::nullopt;
  return LongProgram{judged(std::move(agreed->verdict)), std::move(agreed->clauses), fields};
}

}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
#include "corpus/vector.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/sha256.h"
#include "judge/oracle/compare.h"
#include "model/basis/print.h"
#include "spec/language/event_json.h"
#include "spec/language/number_text.h"
#include "spec/language/setup_format.h"

namespace toolcomp::corpus {
namespace {

constexpr std::string_view kUnrestricted = "generated-unrestricted";

// Whether the run rests on the clause: it was applied, or decided by sign, or its fact holds.
bool rests_on(const spec::ClauseInfo& clause, const model::ClauseCount& count) {
  return clause.outcomes == spec::ClauseOutcomes::fact ? count.positive != 0 : count.reached != 0;
}

// A run that a clause leaves open is a result like any other; one whose arithmetic could not decide is none.
bool is_undecided(const judge::Trial& trial) {
  return trial.verdict.outcome == judge::Outcome::undecided ||
         std::ranges::any_of(trial.run.events, [](const model::Event& event) {
           return event.kind == spec::EventKind::undecided && !judge::left_open(event);
         });
}

// What keeps the engines from agreeing; empty if nothing does.
std::string disagreement(const judge::Trial& trial) {
  if (trial.acceptance == judge::Acceptance::no_setup) return "no control could have this setup";
  if (trial.acceptance == judge::Acceptance::no_text) return "the program cannot be read";
  if (is_undecided(trial)) return "a decision cannot be certified";
  if (trial.verdict.difference) return "fast engine: " + judge::explain(*trial.verdict.difference);
  if (trial.verdict.outcome != judge::Outcome::agrees) return "nothing could be judged";
  return {};
}

// Both lists, for a message.
std::string lists(const std::vector<std::string>& has, const std::vector<std::string>& should) {
  return fmt::format("has {}, the run has {}", fmt::join(has, " "), fmt::join(should, " "));
}

}  // namespace

std::string vector_id(const spec::Case& c) {
  constexpr std::size_t kHexDigits = 10;
  std::string control(c.section.substr(0, c.section.find('/')));
  const std::string topic = c.section.substr(std::min(control.size() + 1, c.section.size()));
  const std::string digest =
      host::sha256(spec::write_setup_json(c.setup) + '\n' + std::to_string(c.samples) + '\n' + c.program);
  return control + '.' + topic + '.' + digest.substr(0, kHexDigits);
}

std::vector<std::string> clauses_of(const model::Recorder& recorder) {
  std::vector<std::string> ids;
  for (std::size_t i = 0; i < recorder.counts().size(); ++i)
    if (rests_on(spec::clauses()[i], recorder.counts()[i])) ids.emplace_back(spec::clauses()[i].id);
  return ids;
}

std::vector<std::string> flags_of(const judge::Trial& trial) {
  const model::Recorder& recorder = trial.run.recorder;
  std::vector<std::string> flags;
  if (!trial.run.events.empty() && trial.run.events.back().kind == spec::EventKind::alarm) flags.emplace_back("alarm");
  if (trial.verdict.near_ties != 0) flags.emplace_back("near-tie");
  for (std::size_t i = 0; i < recorder.counts().size(); ++i) {
    const spec::ClauseInfo& clause = spec::clauses()[i];
    if (clause.kind != spec::ClauseKind::open || !rests_on(clause, recorder.counts()[i])) continue;
    flags.emplace_back("open");
    break;
  }
  if (std::ranges::any_of(recorder.counts(), [](const model::ClauseCount& count) { return count.tie != 0; }))
    flags.emplace_back("tie");
  return flags;
}

std::vector<spec::TextEvent> expected_events(const judge::ModelRun& run) {
  std::vector<spec::TextEvent> events;
  events.reserve(run.events.size());
  for (const model::Event& event : run.events) {
    events.push_back(model::text_event(event, kDigits));
    events.back().message = "";  // for people; not part of what is expected
  }
  return events;
}

std::string event_text(const spec::TextEvent& event, const spec::Axes& axes) {
  std::string text;
  spec::append_event_json(text, event, axes, spec::append_number_text);
  return text;
}

std::string verify(const spec::Case& vector, const judge::Trial& trial) {
  if (std::string wrong = disagreement(trial); !wrong.empty()) return wrong;
  const std::vector<spec::TextEvent> events = expected_events(trial.run);
  for (std::size_t i = 0; i < std::max(events.size(), vector.expect.size()); ++i) {
    const std::string now = i < events.size() ? event_text(events[i], vector.setup.axes) : "nothing";
    const std::string then = i < vector.expect.size() ? event_text(vector.expect[i], vector.setup.axes) : "nothing";
    if (now != then) return fmt::format("event {}: {} expected, the model gives {}", i + 1, then, now);
  }
  if (const auto clauses = clauses_of(trial.run.recorder); clauses != vector.clauses)
    return "clauses: " + lists(vector.clauses, clauses);
  std::vector<std::string> flags = vector.flags;
  std::erase(flags, kUnrestricted);
  if (const auto earned = flags_of(trial); earned != flags) return "flags: " + lists(flags, earned);
  return {};
}

std::string complete(spec::Case& c) {
  const judge::Trial trial = judge::try_case(c);
  if (std::string wrong = disagreement(trial); !wrong.empty()) return wrong;
  const bool unrestricted = std::ranges::find(c.flags, kUnrestricted) != c.flags.end();
  try {
    c.expect = expected_events(trial.run);
  } catch (const exact::Undecided& error) {
    return error.what();
  }
  c.has_expect = true;
  c.id = vector_id(c);
  c.clauses = clauses_of(trial.run.recorder);
  c.flags = flags_of(trial);
  if (unrestricted) {
    c.flags.emplace_back(kUnrestricted);
    std::ranges::sort(c.flags);
  }
  return {};
}

}  // namespace toolcomp::corpus

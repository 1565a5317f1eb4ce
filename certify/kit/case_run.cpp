// SPDX-License-Identifier: Apache-2.0
#include "certify/kit/case_run.h"

#include <algorithm>
#include <cmath>

#include "certify/convert.h"
#include "certify/kit/offsets.h"
#include "certify/kit/trail.h"
#include "corpus/vector.h"
#include "judge/oracle/number.h"
#include "model/basis/print.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify::kit {
namespace {

judge::ModelRun run_text(const spec::Setup& setup, const std::string& text, std::uint32_t samples) {
  spec::Case c;
  c.setup = setup;
  c.program = text;
  c.samples = samples;
  return judge::run_model(c);
}

bool inside(const CaseLines& lines, std::uint64_t line) { return lines.first <= line && line <= lines.last; }

// A choice of cases, no tolerance of a verdict: decisions as near to their boundary as this, but not on it, are left
// to no control.
constexpr double kTooNear = 1.0 / 1'000'000;

bool decides_near_a_tie(const model::Recorder& recorder) {
  return std::ranges::any_of(recorder.decisions(), [](const model::Decision& decision) {
    const double margin = judge::margin(decision);
    return margin != 0 && margin < kTooNear;
  });
}

// Where the axes stand at the end of a run, as text.
std::vector<std::string> end_of(const judge::ModelRun& run) {
  constexpr int kDigits = 12;
  std::vector<std::string> end;
  for (const model::Event& event : run.events) {
    if (event.kind != spec::EventKind::move && !event.hole) continue;
    end.clear();
    for (const spec::NumberText& value : certify::in_text(event, kDigits).axes.value) end.push_back(value.v);
  }
  return end;
}

}  // namespace

spec::Setup program_setup(const Machine& machine, const Overlay& overlay, const spec::Setup& offsets) {
  spec::Setup setup = with_offsets(with_parameters(machine.setup, overlay), offsets.h, offsets.d);
  if (machine.setup.control == spec::Control::heidenhain) setup.tools = offsets.tools;
  setup.block_skip = true;
  return setup;
}

std::string event_lines(const judge::ModelRun& run, const spec::Axes& axes) {
  std::string lines;
  for (const spec::TextEvent& event : corpus::expected_events(run)) lines += corpus::event_text(event, axes) + "\n";
  return lines;
}

CaseRunner::CaseRunner(const Machine& machine, const Outcomes& outcomes) : machine_(machine), outcomes_(outcomes) {
  const ProgramText empty = write_program(machine, kFirstProgram + 1, "", ProgramKind::recorded, {});
  const judge::ModelRun run = run_text(program_setup(machine, {}, {}), empty.text, 0);
  frame_ = run.recorder;
  end_ = end_of(run);
}

std::vector<std::string> CaseRunner::events_of(const Machine& machine, const judge::ModelRun& run,
                                               const CaseLines& lines) {
  std::vector<std::string> events;
  constexpr int kDigits = 12;
  for (const model::Event& event : run.events) {
    if (!inside(lines, event.line)) continue;
    spec::TextEvent text = model::text_event(event, kDigits);
    text.line -= lines.first - 1;
    text.n.reset();
    text.message = "";
    text.setting = {};
    text.clauses = {};  // which clauses were asked may depend on what was before; what they gave may not
    events.push_back(corpus::event_text(text, machine.setup.axes));
  }
  return events;
}

std::string CaseRunner::end_of_case(const judge::ModelRun& run, const CaseLines& lines, CaseRun& result,
                                    bool& ending_fails) const {
  for (const model::Event& event : run.events) {
    if (event.kind != spec::EventKind::undecided && !spec::ends_run(event.kind)) continue;
    ending_fails = event.line > lines.last;
    if (event.kind != spec::EventKind::undecided && event.kind != spec::EventKind::alarm) return event.message;
    if (event.kind == spec::EventKind::undecided) return "the specification leaves open what happens";
    if (ending_fails || event.line < lines.first) return "none of the safe endings of a kit can end it";
    result.stop = Stop{event.alarm, std::string(event.number.view()), event.line - lines.first};
  }
  if (result.stop || end_of(run) == end_) return {};
  ending_fails = true;
  return "it leaves the axes shifted";
}

std::string CaseRunner::shown(const judge::ModelRun& run, const CaseLines& lines, CaseRun& result) const {
  if (!outside_travels(machine_, run.events).empty()) return "outside the travels";
  if (std::ranges::any_of(run.events, [](const model::Event& event) { return event.unknown != 0; }))
    return "a position is not known";
  if (decides_near_a_tie(run.recorder)) return "a decision is too near its boundary";
  const bool moves = std::ranges::any_of(run.events, [&](const model::Event& event) {
    return (event.kind == spec::EventKind::move || event.hole) && inside(lines, event.line);
  });
  if (result.stop &&
      (result.stop->cause == spec::AlarmCause::unknown_code || result.stop->cause == spec::AlarmCause::g10_kind))
    return "the control may know a code that the model does not";
  if (!result.stop && !moves) return "it moves no axis";
  result.shows = result.stop ? outcomes_.shown_by_alarm(run.recorder, run.events.back().clauses)
                             : outcomes_.reached(run.recorder, &frame_);
  for (const model::Event& event : run.events)
    if (event.kind == spec::EventKind::setting && inside(lines, event.line))
      result.settings.emplace_back(event.setting.view());
  return {};
}

CaseRun CaseRunner::with_ending(CaseText text, const Overlay& overlay, const spec::Setup& offsets,
                                std::uint32_t samples, bool& ending_fails) const {
  ending_fails = false;
  const spec::Setup setup = program_setup(machine_, overlay, offsets);
  ProgramText program = write_program(machine_, kFirstProgram + 1, "", ProgramKind::recorded, {text});
  judge::ModelRun run = run_text(setup, program.text, samples);
  if (!outside_travels(machine_, run.events).empty())
    if (const auto start = shifted_start(run, text.start)) {
      text.start = *start;
      program = write_program(machine_, kFirstProgram + 1, "", ProgramKind::recorded, {text});
      run = run_text(setup, program.text, samples);
    }
  const CaseLines lines = program.cases.front();
  CaseRun result;
  result.text = std::move(text);
  result.why = end_of_case(run, lines, result, ending_fails);
  if (result.why.empty()) result.why = shown(run, lines, result);
  if (result.why.empty() && samples != 0) result.events = events_of(machine_, run, lines);
  return result;
}

OutcomeSet CaseRunner::told_apart(const CaseText& text, const Overlay& overlay, const spec::Setup& offsets,
                                  const OutcomeSet& outcomes, double tolerance) const {
  constexpr int kMostTried = 4;  // decisions an outcome
  spec::Case c;
  c.setup = program_setup(machine_, overlay, offsets);
  c.program = write_program(machine_, kFirstProgram + 1, "", ProgramKind::recorded, {text}).text;
  const judge::ModelRun run = judge::run_model(c);
  const Trail way(run.events, tolerance);
  const auto otherwise = [&](std::size_t decision, exact::Sign sign) {
    try {
      const judge::ModelRun forced = judge::run_model(c, {{decision, sign}});
      const spec::EventKind last = forced.events.empty() ? spec::EventKind::alarm : forced.events.back().kind;
      return spec::ends_run(last) || last == spec::EventKind::undecided || way.differs(Trail(forced.events, tolerance));
    } catch (const model::NotFinite&) {
      return true;  // no way at all
    }
  };
  OutcomeSet told;
  for (const std::size_t outcome : outcomes) {
    const std::optional<exact::Sign> sign = outcomes_.sign(outcome);
    bool shown = !sign;
    int tried = 0;
    const auto& decisions = run.recorder.decisions();
    for (std::size_t i = 0; i < decisions.size() && !shown && tried < kMostTried; ++i) {
      if (decisions[i].clause != outcomes_.clause(outcome) || decisions[i].outcome != *sign) continue;
      ++tried;
      for (const exact::Sign other : {exact::Sign::positive, exact::Sign::negative, exact::Sign::zero})
        shown = shown || (other != *sign && otherwise(i, other));
    }
    if (shown) told.push_back(outcome);
  }
  return told;
}

std::optional<spec::AxisTable> CaseRunner::shifted_start(const judge::ModelRun& run,
                                                         const spec::AxisTable& start) const {
  spec::AxisTable shifted = start;
  bool differs = false;
  for (const auto& [axis, extent] : extents(machine_, run.events)) {
    if (!spec::is_linear_axis(axis)) continue;
    const Travel& travel = machine_.travels.at(axis);
    const double least = judge::approximate(travel.least);
    const double greatest = judge::approximate(travel.greatest);
    if (extent.least >= least && extent.greatest <= greatest) continue;
    if (extent.greatest - extent.least > greatest - least) return std::nullopt;
    const double shift = std::round((least + greatest - extent.least - extent.greatest) / 2);
    shifted[axis] = sum(shifted[axis], spec::decimal(static_cast<std::int64_t>(shift)));
    differs = true;
  }
  if (!differs) return std::nullopt;
  return shifted;
}

CaseRun CaseRunner::run(const CaseText& text, const Overlay& overlay, const spec::Setup& offsets,
                        std::uint32_t samples) const {
  CaseRun result;
  try {
    for (std::size_t ending = 0; ending < ending_count(machine_.setup.control); ++ending) {
      CaseText candidate = text;
      candidate.ending = ending;
      bool ending_fails = false;
      result = with_ending(std::move(candidate), overlay, offsets, samples, ending_fails);
      if (!ending_fails) break;
    }
  } catch (const spec::InputError& error) {
    result.why = "no control could have this setup: " + error.message();
  } catch (const exact::Undecided&) {
    result.why = "its digits cannot be certified";
  }
  return result;
}

}  // namespace toolcomp::certify::kit

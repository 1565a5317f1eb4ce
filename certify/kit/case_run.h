// SPDX-License-Identifier: Apache-2.0
// One case on the machine: the model runs a program with only this case.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "certify/kit/machine.h"
#include "certify/kit/outcomes.h"
#include "certify/kit/parameters.h"
#include "certify/kit/program.h"
#include "judge/oracle/verdict.h"

namespace toolcomp::certify::kit {

// The setup of the programs of a kit: the machine, beginning at the place of the marks, with block skip on.
spec::Setup program_setup(const Machine& machine, const Overlay& overlay, const spec::Setup& offsets);

struct Stop {
  spec::AlarmCause cause = spec::AlarmCause::none;
  std::string number;       // PS0041
  std::uint64_t block = 0;  // index of the case's block, from 0
};

// The result of the model for a case.
struct CaseRun {
  std::string why;           // why it is of no use here; empty if it is useful
  std::optional<Stop> stop;  // the alarm in which it ends
  OutcomeSet shows;  // outcomes that the program without a case does not show; with an alarm, the outcomes that the
                     // alarm shows
  CaseText text;     // with the ending that works, and a start that fits the travels
  std::vector<std::string> events;    // of the case, as JSON, lines counted from its first one; only with samples
  std::vector<std::string> settings;  // entries it writes to the offset memory: "H1", "D2.wear"
};

// The events of a run in the form of the expected events of a kit, one in each line.
std::string event_lines(const judge::ModelRun& run, const spec::Axes& axes);

class CaseRunner {
 public:
  CaseRunner(const Machine& machine, const Outcomes& outcomes);

  // Runs `text` with the first ending that works. The events have `samples` in blocks under tool center point control.
  [[nodiscard]] CaseRun run(const CaseText& text, const Overlay& overlay, const spec::Setup& offsets,
                            std::uint32_t samples = 0) const;

  // The outcomes among these that a recording of the case shows. The outcome of a decision by sign is shown if there is
  // at least one such decision after which the path would differ by more than twice the tolerance with another outcome.
  // A fact, and a clause that is reached, is always shown, because it cannot be forced to another outcome.
  [[nodiscard]] OutcomeSet told_apart(const CaseText& text, const Overlay& overlay, const spec::Setup& offsets,
                                      const OutcomeSet& outcomes, double tolerance) const;

  // The events of one case of a program that was run.
  static std::vector<std::string> events_of(const Machine& machine, const judge::ModelRun& run, const CaseLines& lines);

 private:
  CaseRun with_ending(CaseText text, const Overlay& overlay, const spec::Setup& offsets, std::uint32_t samples,
                      bool& ending_fails) const;
  // Both return why the case is of no use, and fill in the rest.
  std::string end_of_case(const judge::ModelRun& run, const CaseLines& lines, CaseRun& result,
                          bool& ending_fails) const;
  std::string shown(const judge::ModelRun& run, const CaseLines& lines, CaseRun& result) const;
  [[nodiscard]] std::optional<spec::AxisTable> shifted_start(const judge::ModelRun& run,
                                                             const spec::AxisTable& start) const;

  const Machine& machine_;
  const Outcomes& outcomes_;
  model::Recorder frame_;         // of the program without a case
  std::vector<std::string> end_;  // positions of its axes at the end
};

}  // namespace toolcomp::certify::kit

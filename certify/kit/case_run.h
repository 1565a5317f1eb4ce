// SPDX-License-Identifier: Apache-2.0
// One case on the machine: the program with this case alone, run through the model.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "certify/kit/machine.h"
#include "certify/kit/outcomes.h"
#include "certify/kit/parameters.h"
#include "certify/kit/program.h"
#include "fuzz/oracle/verdict.h"

namespace toolcomp::certify::kit {

// The setup of a kit's programs: the machine that begins at the place of the marks and skips blocks with a /.
spec::Setup program_setup(const Machine& machine, const Overlay& overlay, const spec::Setup& offsets);

struct Stop {
  spec::AlarmCause cause = spec::AlarmCause::none;
  std::string number;       // PS0041
  std::uint64_t block = 0;  // index of the case's block, from 0
};

// What the model says of it.
struct CaseRun {
  std::string why;                    // why it is of no use here; empty: it is
  std::optional<Stop> stop;           // the alarm in which it ends
  OutcomeSet shows;                   // more than the program without a case; with an alarm what that shows
  CaseText text;                      // with the ending that works, and a start that fits the travels
  std::vector<std::string> events;    // of the case, as JSON, lines counted from its first; where samples are asked for
  std::vector<std::string> settings;  // "H1", "D2.wear": what it writes to the offset memory
};

// The events of a run as a kit expects them, a line each.
std::string event_lines(const fuzz::ModelRun& run, const spec::Axes& axes);

class CaseRunner {
 public:
  CaseRunner(const Machine& machine, const Outcomes& outcomes);

  // `text` with its first ending; of the events, `samples` are asked for blocks under tool center point control.
  [[nodiscard]] CaseRun run(const CaseText& text, const Overlay& overlay, const spec::Setup& offsets,
                            std::uint32_t samples = 0) const;

  // Of these outcomes of the case, those that a recording shows: of decisions by sign, where at least one goes this way
  // and the path would be another by more than twice the tolerance if it went otherwise. A fact, and a clause that is
  // reached, is shown where it is met: it cannot be made otherwise.
  [[nodiscard]] OutcomeSet told_apart(const CaseText& text, const Overlay& overlay, const spec::Setup& offsets,
                                      const OutcomeSet& outcomes, double tolerance) const;

  // The events of one case of a program that was run.
  static std::vector<std::string> events_of(const Machine& machine, const fuzz::ModelRun& run, const CaseLines& lines);

 private:
  CaseRun with_ending(CaseText text, const Overlay& overlay, const spec::Setup& offsets, std::uint32_t samples,
                      bool& ending_fails) const;
  // Both say why the case is of no use, and fill in the rest.
  std::string end_of_case(const fuzz::ModelRun& run, const CaseLines& lines, CaseRun& result, bool& ending_fails) const;
  std::string shown(const fuzz::ModelRun& run, const CaseLines& lines, CaseRun& result) const;
  [[nodiscard]] std::optional<spec::AxisTable> shifted_start(const fuzz::ModelRun& run,
                                                             const spec::AxisTable& start) const;

  const Machine& machine_;
  const Outcomes& outcomes_;
  model::Recorder frame_;         // of the program without a case
  std::vector<std::string> end_;  // where its axes stand at the end
};

}  // namespace toolcomp::certify::kit

// SPDX-License-Identifier: Apache-2.0
// Chooses the vectors that show the outcomes, and their parameters.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "certify/kit/case_run.h"
#include "certify/kit/klartext.h"
#include "certify/kit/offsets.h"
#include "certify/kit/outcomes.h"
#include "certify/kit/screen.h"
#include "corpus/golden.h"

namespace toolcomp::certify::kit {

// Why a control cannot run each of these programs; empty if it can.
using WhyNot = std::function<std::vector<std::string>(const std::vector<spec::Case>&)>;

// A chosen vector, in the form in which it goes into a program.
struct Chosen {
  const spec::Case* vector = nullptr;
  std::size_t group = 0;
  bool same_machine = false;
  CaseRun run;       // with the numbers of the kit's offsets
  OutcomeSet shows;  // outcomes for which it was chosen, and others that it is proven to show
};

struct Choice {
  std::vector<Overlay> groups;  // the first is empty: the parameters of the machine
  std::vector<Chosen> recorded;
  std::vector<Chosen> stopped;  // cases that end in an alarm
  OutcomeSet missing;
  std::map<std::size_t, std::string> why;  // the reason for every missing outcome
};

class Chooser {
 public:
  Chooser(const Machine& machine, const Outcomes& outcomes, const std::vector<corpus::Vector>& vectors,
          std::uint32_t first_offset, double tolerance, std::function<void(const std::string&)> progress);

  // Leaves out programs that the control refuses, that end in an alarm, or that need other parameters.
  void leave_out(const WhyNot& why_not);
  // Covers `wanted`: first by recordings with the parameters of the machine, then with other parameters, then by
  // alarms.
  Choice choose(OutcomeSet wanted);
  // The tables that the chosen cases share: H and D, or the tools.
  [[nodiscard]] const OffsetTable& offsets() const { return table_; }
  [[nodiscard]] const ToolTable& tools() const { return tools_; }

 private:
  struct Candidate {
    const spec::Case* vector = nullptr;
    CaseText text;
    spec::Setup offsets;  // H and D of the vector, for this machine
    CaseOffsets numbers;
    Overlay overlay;
    bool same_machine = false;
    std::string why;       // why it is refused because of its words
    std::string why_here;  // why it is refused because of its run with the parameters of the machine
    OutcomeSet at_home;    // reached in the setup of the corpus
    CaseRun here;          // run with the parameters of the machine
  };

  void prepare(Candidate& candidate);
  std::string prepare_fanuc(Candidate& candidate) const;
  std::string prepare_klartext(Candidate& candidate) const;
  void cover(std::size_t group, const std::vector<std::pair<std::size_t, CaseRun>>& runs, bool stopped);
  void cover_with_parameters(bool stopped);
  bool accept(const Candidate& candidate, const CaseRun& run, std::size_t group, const OutcomeSet& shows);
  [[nodiscard]] std::size_t blocks_needed(const Candidate& candidate, const CaseRun& run, const Overlay& overlay) const;
  std::size_t group_of(const Overlay& overlay);
  Overlay reduced(const Candidate& candidate, const Overlay& overlay, bool stopped);
  [[nodiscard]] std::string why_missing(std::size_t outcome) const;
  void say(const std::string& what) const {
    if (progress_) progress_(what);
  }

  const Machine& machine_;
  const Outcomes& outcomes_;
  CaseRunner runner_;
  OffsetTable table_;
  ToolTable tools_;
  std::vector<Candidate> candidates_;
  std::function<void(const std::string&)> progress_;
  double tolerance_;
  bool as_it_is_ = false;  // no other parameters
  OutcomeSet wanted_;
  std::map<std::size_t, int> not_told_;  // for each outcome, the number of cases whose path did not show it
  Choice choice_;
};

}  // namespace toolcomp::certify::kit

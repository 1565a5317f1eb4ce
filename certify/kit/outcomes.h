// SPDX-License-Identifier: Apache-2.0
// Outcomes of clauses by index: what a run reaches, and which of them a kit is asked for.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "certify/kit/cover.h"
#include "model/basis/recorder.h"
#include "spec/trace/coverage.h"

namespace toolcomp::certify::kit {

// An index counts through spec::required_outcomes.
class Outcomes {
 public:
  Outcomes();

  // "fanuc.cutter-c.ccn=true".
  [[nodiscard]] std::string name(std::size_t outcome) const;
  [[nodiscard]] std::string_view text(std::size_t outcome) const { return all_[outcome].text; }
  [[nodiscard]] spec::Clause clause(std::size_t outcome) const { return all_[outcome].clause; }

  // The sign that the outcome of a decision by sign is; nothing for facts and clauses that are reached.
  [[nodiscard]] std::optional<exact::Sign> sign(std::size_t outcome) const;

  // Those of the clauses of these sections, and of what all sections of the dialect share, which no vectors are for.
  [[nodiscard]] OutcomeSet of_sections(const std::vector<std::string>& sections, std::string_view dialect) const;

  // What the run reached more often than `frame` did, a run of the same program without its cases.
  [[nodiscard]] OutcomeSet reached(const model::Recorder& run, const model::Recorder* frame = nullptr) const;

  // What an alarm of the run shows: of the clauses that its event rests on, facts as true, and of decisions by sign the
  // outcome where the run had but one.
  [[nodiscard]] OutcomeSet shown_by_alarm(const model::Recorder& run, const spec::ClauseList& clauses) const;

 private:
  std::vector<spec::ClauseOutcome> all_;
};

}  // namespace toolcomp::certify::kit

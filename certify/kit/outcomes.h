// SPDX-License-Identifier: Apache-2.0
// Outcomes of clauses by index: the outcomes that a run reaches, and those that a kit must show.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "certify/kit/cover.h"
#include "model/basis/recorder.h"
#include "spec/coverage/coverage.h"

namespace toolcomp::certify::kit {

// An index is a position in spec::required_outcomes.
class Outcomes {
 public:
  Outcomes();

  // "fanuc.cutter-c.ccn=true".
  [[nodiscard]] std::string name(std::size_t outcome) const;
  [[nodiscard]] std::string_view text(std::size_t outcome) const { return all_[outcome].text; }
  [[nodiscard]] spec::Clause clause(std::size_t outcome) const { return all_[outcome].clause; }

  // The sign of an outcome of a decision by sign; std::nullopt for facts, and for clauses that are only reached.
  [[nodiscard]] std::optional<exact::Sign> sign(std::size_t outcome) const;

  // The outcomes of the clauses of these sections, and of the clauses that all sections of the dialect share, which
  // have no vectors of their own.
  [[nodiscard]] OutcomeSet of_sections(const std::vector<std::string>& sections, std::string_view dialect) const;

  // The outcomes that the run reached more often than `frame`, a run of the same program without its cases.
  [[nodiscard]] OutcomeSet reached(const model::Recorder& run, const model::Recorder* frame = nullptr) const;

  // The outcomes that an alarm of the run shows. Of the clauses that its event rests on, these are: true for facts,
  // and, for decisions by sign, the outcome if the run had only one.
  [[nodiscard]] OutcomeSet shown_by_alarm(const model::Recorder& run, const spec::ClauseList& clauses) const;

 private:
  std::vector<spec::ClauseOutcome> all_;
};

}  // namespace toolcomp::certify::kit

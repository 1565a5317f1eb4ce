// SPDX-License-Identifier: Apache-2.0
// Results of campaigns: added up, passed between processes, printed.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/campaign/campaign.h"

namespace toolcomp::fuzz {

// One execution more.
void add(CampaignResult& total, const Trial& trial);
// The sums of both; what was reached and worst values are the larger ones, findings follow each other. Time is the
// longer one and the rate that of all executions over it: parts run side by side.
void add(CampaignResult& total, const CampaignResult& part);

// Keeps the case of the two that has the shorter program.
void keep_shortest(std::optional<NotDecided>& kept, NotDecided other);

// Everything but cases, as lines of names and numbers.
std::string write_summary(const CampaignResult& result);
// Reads it back; lines it does not know are left out.
CampaignResult read_summary(std::string_view text);

// Of the outcomes that the clauses of a section can have.
struct Reached {
  std::size_t seen = 0;
  std::size_t all = 0;
  std::vector<std::string> missing;  // "fanuc.leading-edge.near-90 false"
};
Reached outcomes_reached(std::string_view section, const std::vector<model::ClauseCount>& clauses);

// How many outcomes of a section were reached, and those that were not.
void print_outcomes(std::ostream& out, std::string_view section, const std::vector<model::ClauseCount>& clauses);

}  // namespace toolcomp::fuzz

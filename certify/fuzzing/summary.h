// SPDX-License-Identifier: Apache-2.0
// The summary at the end of a campaign: what was covered, and whether "nothing found" counts as a pass.
#pragma once

#include <string>
#include <vector>

#include "certify/fuzzing/campaign.h"

namespace toolcomp::certify::fuzzing {

struct CampaignResult {
  int status = 0;  // 0 nothing found, 1 findings, 3 nothing found, but the search was too short to count as a pass
  std::string words;
  std::vector<std::string> shortfalls;  // "tool_offset_directed: not run"
};
CampaignResult campaign_result(const CampaignOptions& options, const CampaignEnd& end);

// For people.
std::string summary_text(const CampaignOptions& options, const CampaignEnd& end, const CampaignResult& result);
// For programs: one JSON object.
std::string summary_json(const CampaignOptions& options, const CampaignEnd& end, const CampaignResult& result);

}  // namespace toolcomp::certify::fuzzing

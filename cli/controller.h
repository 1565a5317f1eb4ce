// SPDX-License-Identifier: Apache-2.0
// Judges the answers of a controller.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "certify/finding.h"
#include "judge/oracle/trial.h"

namespace toolcomp::cli {

// Told what differs, as it was seen.
using Watch = std::function<void(certify::Finding)>;

// Judges what the command answers; `timeout` in seconds. Throws spec::InputError if it cannot be used, or announces a
// resolution coarser than what is certified and than `accepted_resolution`, which is looked at if it is there.
judge::CaseJudge judge_of_controller(const std::string& command, double timeout,
                                     const std::optional<std::string>& accepted_resolution = {}, Watch watch = {});

}  // namespace toolcomp::cli

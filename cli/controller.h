// SPDX-License-Identifier: Apache-2.0
// A controller as the subject of a campaign.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "certify/evidence.h"
#include "fuzz/oracle/trial.h"

namespace toolcomp::cli {

// Who wants to know what differs: asked whether this one is wanted, and under which number, then told all that was
// seen. Jobs call at once.
struct Watch {
  std::function<std::optional<std::size_t>(const certify::FailureKey&, const std::string& program)> wants;
  std::function<void(const certify::Capabilities&, std::size_t number, certify::Witness)> keep;
};

// Judges what the command answers; `timeout` in seconds. Throws spec::InputError if it cannot be used, or announces a
// resolution coarser than what is certified and than `accepted_resolution`, which is looked at if it is there.
fuzz::Subject controller_subject(const std::string& command, double timeout,
                                 const std::optional<std::string>& accepted_resolution = {}, Watch watch = {});

}  // namespace toolcomp::cli

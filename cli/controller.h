// A controller as the subject of a campaign.
#pragma once

#include <string>

#include "fuzz/oracle/trial.h"

namespace toolcomp::cli {

// Judges what the command answers; `timeout` in seconds. Throws spec::InputError if it cannot be used.
fuzz::Subject controller_subject(const std::string& command, double timeout);

}  // namespace toolcomp::cli

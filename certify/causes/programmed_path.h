// SPDX-License-Identifier: Apache-2.0
// The path of a control that takes positions under tool center point control for positions of its axes.
#pragma once

#include <memory>

#include "certify/trace/path.h"
#include "certify/trace/program_path.h"
#include "spec/language/case.h"

namespace toolcomp::certify {

// Straight from one programmed end to the next, with rotary axes turning evenly, and without the tool length. Machine
// coordinates exist for FANUC programs. nullptr for a program without tool center point control, or one that the model
// cannot decide.
std::unique_ptr<PathSource> programmed_path(const spec::Case& c, const TraceSpace& space, PathFrame frame);

}  // namespace toolcomp::certify

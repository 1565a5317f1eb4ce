// SPDX-License-Identifier: Apache-2.0
// The registry of the stages of compensation.
#pragma once

#include <vector>

#include "model/fanuc/program/pipeline.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// In the order in which a step passes them.
std::vector<StageMaker> stages(const spec::Setup& setup);

}  // namespace toolcomp::model

// SPDX-License-Identifier: Apache-2.0
// The passes of compensation that there are.
#pragma once

#include <vector>

#include "model/fanuc/passes/passes.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// In the order in which a step goes through them.
std::vector<PassMaker> sections(const spec::Setup& setup);

}  // namespace toolcomp::model

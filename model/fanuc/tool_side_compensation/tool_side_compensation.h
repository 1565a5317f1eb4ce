// SPDX-License-Identifier: Apache-2.0
// Tool side compensation: G41.2 G42.2, under G43.5 G41.6 G42.6, and G40. Clauses: fanuc.tool-side.*, and those of
// fanuc.cutter-c.* that they name. Throws spec::InputError for a parameter that makes no sense.
#pragma once

#include <memory>

#include "model/fanuc/program/pass.h"

namespace toolcomp::model {

std::unique_ptr<Pass> tool_side_compensation(const Pass::Place& place);

}  // namespace toolcomp::model

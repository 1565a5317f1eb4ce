// SPDX-License-Identifier: Apache-2.0
// Cutter compensation B: G40, G41, G42 and G39. Clauses: fanuc.cutter-b.*.
#pragma once

#include <memory>

#include "model/fanuc/program/pass.h"

namespace toolcomp::model {

std::unique_ptr<Pass> cutter_compensation_b(const Pass::Place& place);

}  // namespace toolcomp::model

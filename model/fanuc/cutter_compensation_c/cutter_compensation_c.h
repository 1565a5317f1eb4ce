// SPDX-License-Identifier: Apache-2.0
// Cutter compensation C: G40, G41, G42 and G39. Clauses: fanuc.cutter-c.*.
#pragma once

#include <memory>

#include "model/fanuc/program/pass.h"

namespace toolcomp::model {

std::unique_ptr<Pass> cutter_compensation_c(const Pass::Place& place);

}  // namespace toolcomp::model

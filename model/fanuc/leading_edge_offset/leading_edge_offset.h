// SPDX-License-Identifier: Apache-2.0
// Leading edge offset: G41.3 and G40. Clauses: fanuc.leading-edge.*. Throws spec::InputError naming parameter 19631.
#pragma once

#include <memory>

#include "model/basis/number.h"
#include "model/fanuc/program/pass.h"

namespace toolcomp::model {

// What a block says to the leading edge offset, where that is on before it or from it on.
struct EdgeBlock {
  enum class Code : std::uint8_t { none, start, cancel };
  Code code = Code::none;
  Rational radius;  // offset of the D number in force at the end of the block, but for a cancel block
};

std::unique_ptr<Pass> leading_edge_offset(const Pass::Place& place);

}  // namespace toolcomp::model

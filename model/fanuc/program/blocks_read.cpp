// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/program/blocks_read.h"

#include <optional>

#include "model/basis/number.h"
#include "spec/language/input_error.h"

namespace toolcomp::model {

int blocks_read(const spec::Setup& setup) {
  const std::optional<spec::Decimal> given = setup.parameter(19625);
  if (setup.series != spec::Series::series_30i || !given) return 3;
  for (int blocks = 3; blocks <= 8; ++blocks)
    if (plain(*given) == blocks) return blocks;
  throw spec::InputError("setup", 0, 0, "parameters.\"19625\": expected a number of blocks from 3 to 8");
}

}  // namespace toolcomp::model

// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/corner/corner_group.h"

#include <string>

#include "fast/fanuc/program/words.h"
#include "spec/language/input_error.h"

namespace toolcomp::fast {
namespace {

unsigned read_at_a_time(const spec::Setup& setup) {
  constexpr unsigned kUsual = 3;
  const auto given = setup.parameter(19625);
  if (!given || setup.series != spec::Series::series_30i) return kUsual;
  const unsigned blocks = whole_number(*given, kMostBlocksRead);
  if (blocks < kUsual || blocks > kMostBlocksRead)
    throw spec::InputError("setup", 0, 0, "parameters.\"19625\": 3 to 8");
  return blocks;
}

}  // namespace

Count length_parameter(const spec::Setup& setup, std::uint32_t number) {
  const auto value = setup.parameter(number);
  if (!value) return {};
  if (!fits_count(*value))
    throw spec::InputError("setup", 0, 0, "parameters.\"" + std::to_string(number) + "\": too large");
  return Count::of(*value);
}

CornerParameters::CornerParameters(const spec::Setup& setup)
    : type_b(setup.bit(5003, 0)),
      no_interference(setup.bit(5008, 0)),
      limit(length_parameter(setup, 5010)),
      limit_value(limit.nearest()),
      keeps_all(limit < Count()),
      still_limit(read_at_a_time(setup) - 1U) {}

}  // namespace toolcomp::fast

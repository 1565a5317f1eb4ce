// SPDX-License-Identifier: Apache-2.0
#include "spec/language/setup.h"

namespace toolcomp::spec {

std::optional<Decimal> Setup::parameter(std::uint32_t number) const {
  const auto found = parameters.find({number, -1});
  if (found == parameters.end()) return std::nullopt;
  return found->second;
}

bool Setup::bit(std::uint32_t number, int bit, bool otherwise) const {
  if (const auto found = parameters.find({number, bit}); found != parameters.end()) return !found->second.is_zero();
  const std::optional<Decimal> whole = parameter(number);
  if (!whole || !whole->is_integer()) return otherwise;
  return (whole->digits >> bit & 1U) != 0;
}

}  // namespace toolcomp::spec

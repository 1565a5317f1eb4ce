// SPDX-License-Identifier: Apache-2.0
// Q, QL and QR parameters: what words may take their value from.
#pragma once

#include <cstddef>
#include <vector>

#include "fast/arithmetic/count.h"
#include "spec/language/heidenhain/klartext_block.h"

namespace toolcomp::fast::klartext {

class Parameters {
 public:
  Parameters() : value_(spec::klartext::kMostQ + std::size_t{1} + 2 * (spec::klartext::kMostLocal + std::size_t{1})) {}

  // The value of a word in units of the program; a parameter that was never assigned counts 0. False: 1e17 or more.
  [[nodiscard]] bool read(const spec::klartext::Value& word, Count& value) const {
    if (word.parameter.kind == spec::klartext::ParameterKind::none) [[likely]] {
      if (const std::int64_t small = Count::small_of(word.number); small != Count::kNotSmall) [[likely]] {
        value.set_small(small);
        return true;
      }
      if (!fits_count(word.number)) return false;
      value = Count::of(word.number);
      return true;
    }
    value = this->value(word.parameter);
    if (word.number.negative) value = -value;
    return true;
  }
  // One that was never assigned counts 0.
  [[nodiscard]] const Count& value(const spec::klartext::Parameter& parameter) const { return value_[slot(parameter)]; }
  void assign(const spec::klartext::Parameter& target, const Count& value) { value_[slot(target)] = value; }

 private:
  static std::size_t slot(const spec::klartext::Parameter& parameter) {
    constexpr std::size_t kQ = spec::klartext::kMostQ + std::size_t{1};
    constexpr std::size_t kLocal = spec::klartext::kMostLocal + std::size_t{1};
    switch (parameter.kind) {
      case spec::klartext::ParameterKind::ql:
        return kQ + parameter.index;
      case spec::klartext::ParameterKind::qr:
        return kQ + kLocal + parameter.index;
      default:
        return parameter.index;
    }
  }
  std::vector<Count> value_;
};

}  // namespace toolcomp::fast::klartext

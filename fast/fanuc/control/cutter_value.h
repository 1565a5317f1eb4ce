// SPDX-License-Identifier: Apache-2.0
// The number of the cutter and its value: D, or with 5001#2 = 1 also H. For G40 G41 G42, G41.2 and the like, G45 to
// G48.
#pragma once

#include <cstdint>
#include <optional>

#include "fast/arithmetic/count.h"
#include "fast/fanuc/program/words.h"
#include "fast/fanuc/tool_length_offset/offset_memory.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

class CutterValue {
 public:
  struct Number {
    std::uint32_t number = 0;
    bool from_h = false;
  };
  // Reads 5001#2 and 5001#4.
  CutterValue(const spec::Setup& setup, const OffsetMemory& memory);

  // The number a block commands: its D, or with 5001#2 = 1 its H where it has no D.
  [[nodiscard]] std::optional<Number> commanded(const Words& words) const {
    if (words.has('D')) return Number{whole_number(words['D'], memory_.count()), false};
    if (by_h_ && words.has('H')) return Number{whole_number(words['H'], memory_.count()), true};
    return std::nullopt;
  }
  // The number in force, and that behind a block.
  [[nodiscard]] const Number& number() const { return number_; }
  [[nodiscard]] Number number_after(const Words& words) const { return commanded(words).value_or(number_); }
  void take_number(const Words& words) { number_ = number_after(words); }

  // What the memory has for a number.
  [[nodiscard]] Count of(const Number& number) const {
    return number.from_h ? memory_.h(number.number) : memory_.d(number.number);
  }
  // Of the number in force, as it was when it came into force.
  [[nodiscard]] const Count& value() const { return value_; }
  void take_value() {
    value_ = of(number_);
    edited_ = false;
  }
  // The memory has changed. With 5001#4 = 1 the next block takes the value.
  void edit() { edited_ = true; }
  [[nodiscard]] bool takes_edited() const { return edited_ && edited_at_next_block_; }

 private:
  const OffsetMemory& memory_;
  bool by_h_;                  // 5001#2
  bool edited_at_next_block_;  // 5001#4
  Number number_;
  Count value_;
  bool edited_ = false;
};

}  // namespace toolcomp::fast

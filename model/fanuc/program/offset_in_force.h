// SPDX-License-Identifier: Apache-2.0
// The offset number of the cutter, and the value of it that is in force: in every compensation that runs beside the
// path.
#pragma once

#include <cstdint>
#include <optional>

#include "model/basis/recorder.h"
#include "model/fanuc/program/codes.h"
#include "model/fanuc/program/offset_memory.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// An offset number and the table it reads.
struct OffsetNumber {
  std::uint32_t number = 0;
  bool of_h = false;  // it came with H
};

// Follows the number through the program. Clauses: fanuc.cutter.number, fanuc.cutter.value-edited.
class OffsetInForce {
 public:
  // Parameters 5001#2 and 5001#4.
  OffsetInForce(const spec::Setup& setup, const OffsetMemory& memory, Recorder& recorder);

  [[nodiscard]] const OffsetNumber& number() const { return number_; }
  // The number in force at the end of a block with these codes.
  [[nodiscard]] OffsetNumber number_after(const Codes& codes) const;
  // Takes the number of a block; whether it gives one.
  bool take(const Codes& codes);
  // Decides whether the H of a block without D gives the number.
  void decide_address(const Codes& codes) const;
  // The value at the end of a block, setup units, with its sign. `taken_anew`: the block gives a number, or brings
  // compensation into force. Throws Alarm PS0029.
  const Rational& value(bool taken_anew);

 private:
  // From the address that counts.
  [[nodiscard]] std::optional<OffsetNumber> given(const Codes& codes) const;

  const OffsetMemory& memory_;
  Recorder& recorder_;
  bool ofh_;  // 5001#2: H numbers count too
  bool evr_;  // 5001#4: an edited value counts from the next block on
  OffsetNumber number_;
  Rational value_;  // of the number in force, as it was when it was taken
};

// G40, G41, G42: where the tool runs, seen in the direction of travel.
enum class CutterSide : std::uint8_t { none, left, right };

struct CutterOffset {
  int side = 1;  // 1 left of the path, -1 right
  Rational distance;
  Rational value;  // as the memory has it, with its sign

  [[nodiscard]] Rational left() const { return side * distance; }
};

// Where a side is in force. A value of 0 has the side of a positive one. Clause: fanuc.cutter.side.
CutterOffset offset_of(Recorder& recorder, CutterSide side, const Rational& value);

}  // namespace toolcomp::model

// The words of cutter compensation, B and C alike: G40, G41, G42, G39, the offset number and I J K as a direction.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/program/interpreter.h"
#include "model/program/offset_memory.h"
#include "model/program/step.h"
#include "model/recorder.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// An offset number and the table it reads.
struct OffsetNumber {
  std::uint32_t number = 0;
  bool of_h = false;  // it came with H
};

// The number that a block gives, from the address that counts; `ofh`: 5001#2, H gives it too.
std::optional<OffsetNumber> given_number(const Codes& codes, bool ofh);

// Follows group 07 and the offset number through the program. Clauses: fanuc.cutter.*.
class CutterWords {
 public:
  CutterWords(const spec::Setup& setup, const OffsetMemory& memory, Recorder& recorder);

  // What the block says, without the value of its number and its movement; nothing before the first G41,
  // G42 or G39 of the program.
  [[nodiscard]] std::optional<CutterBlock> read(const Command& command, const Interpreter& interpreter);
  // The value in force at the end of the block. Throws Alarm PS0029.
  void add_value(CutterBlock& block);
  // Its movement: from where the block starts (a leg that stays there) along its legs.
  void add_movement(CutterBlock& block, const Leg& start, const std::vector<Leg>& legs) const;

  // In force at the end of the block read last; G45 to G48 use it too.
  [[nodiscard]] const OffsetNumber& number() const { return number_; }

 private:
  [[nodiscard]] bool has_word(const Command& command, char letter) const;
  [[nodiscard]] PlanePoint point(spec::Plane plane, const Leg& leg) const;
  [[nodiscard]] std::optional<PlanePoint> direction(const Command& command, const Interpreter& interpreter) const;

  const OffsetMemory& memory_;
  Recorder& recorder_;
  spec::Axes axes_;
  bool ofh_;  // 5001#2: H numbers count too
  bool evr_;  // 5001#4: an edited value counts from the next block on
  bool seen_ = false;
  CutterSide side_ = CutterSide::none;
  spec::Plane plane_ = spec::Plane::xy;
  OffsetNumber number_;
  Rational offset_;  // of the number in force, as it was when it was taken
};

}  // namespace toolcomp::model

// SPDX-License-Identifier: Apache-2.0
// Cutter compensation B, G39 to G42 (chapter 14.4): every block ends with a vector of its own, at once.
#pragma once

#include <array>
#include <cstdint>

#include "fast/arithmetic/double_double.h"
#include "fast/basis/event.h"
#include "fast/fanuc/program/cutter_block.h"
#include "fast/geometry/whole_pair.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// Keeps the vector in the plane from block to block; nothing is held, no block waits for another.
class CutterCompensationB {
 public:
  CutterCompensationB(const spec::Setup& setup, EventSink& sink);

  // The mode: G41 or G42 is in force.
  [[nodiscard]] bool active() const { return active_; }
  // PS0035, then PS0034: the alarms that follow from the words and the state alone.
  [[nodiscard]] Alarm check(const CutterCommand& command) const;
  // The block to fill in next: every field.
  [[nodiscard]] CutterBlock& next() { return block_; }
  // Takes next() and sends its move.
  StageEnd block();
  // Nothing is ever held.
  [[nodiscard]] StageEnd release() const { return {}; }

 private:
  using Fine = std::array<DoubleDouble, 2>;  // in the plane, units of 1 / (127 * 10^18)

  // A vector `length` at right angles to a direction, left of it where `length` is positive.
  struct Vector {
    std::array<double, 2> value{};  // setup units
    Fine normal{};                  // of any length
    Count length;
    [[nodiscard]] bool zero() const { return length.is_zero(); }
    [[nodiscard]] Fine fine() const;
  };
  [[nodiscard]] static Vector vector_along(const Fine& normal, const Count& length);

  [[nodiscard]] Count signed_offset() const;
  void straight();
  [[nodiscard]] Alarm arc();
  // Such an arc (arc_in_doubles.h), made and sent; false: doubles are not enough, and nothing is done.
  [[nodiscard]] bool arc_in_doubles();
  void corner_arc();
  void cancel();
  void set_tool_arc(const Fine& old_head, const Fine& new_head, const DoubleDouble& scale);
  // A vector along a normal of whole numbers.
  void set_vector(DoublePair value, const WholePair& normal, const Count& length);
  void send(const Vector& vector, bool own);

  EventSink& sink_;
  CutterBlock block_;
  bool active_ = false;
  bool made_ = false;  // a start-up was made, and the vector not taken away since
  std::uint32_t d_ = 0;
  Vector vector_;
  Event setting_;
};

}  // namespace toolcomp::fast

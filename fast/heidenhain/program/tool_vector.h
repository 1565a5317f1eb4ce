// SPDX-License-Identifier: Apache-2.0
// The direction of the tool, tip to carrier: along whole numbers, or turned by rotary words.
#pragma once

#include <array>
#include <cstddef>

#include "fast/arithmetic/count.h"
#include "fast/heidenhain/program/whole_vector.h"

namespace toolcomp::fast::klartext {

// Vectors of LN blocks and axes are whole. Rotary words turn a tool axis by Rz(C) Ry(B) Rx(A)
// (heidenhain.program.direction-of-rotary-axes); by multiples of 90 degrees that is whole again.
class ToolVector {
 public:
  [[nodiscard]] const Vector& unit() const { return unit_; }
  [[nodiscard]] bool is_whole() const { return whole_; }
  // Where is_whole().
  [[nodiscard]] const WholeVector& vector() const { return vector_; }

  void set_axis(std::size_t axis) {
    whole_ = true;
    vector_.set_axis(axis);
    unit_ = {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
  }
  // `unit` is that of `vector`.
  void set(const WholeVector& vector, const Vector& unit) {
    whole_ = true;
    vector_.copy(vector);
    unit_ = unit;
  }
  // Of an LN block; false where it is not normalized.
  [[nodiscard]] bool set(const std::array<spec::Decimal, 3>& components) {
    whole_ = true;
    vector_.set(components);
    const UnitVector u = unit_of(vector_);
    unit_ = u.unit;
    return u.normalized;
  }
  void turn(std::size_t axis, const std::array<Count, 3>& degrees);

  // Bit i: its component along X, Y or Z is not exactly 0.
  [[nodiscard]] unsigned components() const;
  // So far along the tool: from here to there, and by how many units of Count each of X, Y and Z may be off; 0: exact.
  [[nodiscard]] double way(const Count& length, std::array<Count, 3>& xyz) const;

  // Only what counts.
  void copy(const ToolVector& other) {
    whole_ = other.whole_;
    unit_ = other.unit_;
    if (whole_) {
      vector_.copy(other.vector_);
    } else {
      axis_ = other.axis_;
      degrees_ = other.degrees_;
    }
  }

  // In double-double, of any length: a whole one within 2^-106, else within kFineError.
  [[nodiscard]] FineVector3 fine() const;
  static constexpr double kFineError = 0x1p-95;

 private:
  bool whole_ = true;
  std::size_t axis_ = 2;
  Vector unit_{0, 0, 1};
  WholeVector vector_;
  std::array<Count, 3> degrees_;
};

}  // namespace toolcomp::fast::klartext

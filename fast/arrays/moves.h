// SPDX-License-Identifier: Apache-2.0
// The moves of many blocks, an array for each axis.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "spec/language/axes.h"

namespace toolcomp::fast {

// Columns of one length, in the order of the moves. What there is stays where it is until more is appended or the
// object goes; clear() keeps the memory.
class Moves {
 public:
  // `axes`: how many, at most kMaxAxes.
  explicit Moves(std::size_t axes) : axes_(axes) {}

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t axes() const { return axes_; }
  // What axis i of the setup is sent to: workpiece coordinates, setup units, degrees.
  // No number: the move does not say it (of Klartext programs: a rotary axis without a word in the block, an axis whose
  // position is unknown).
  [[nodiscard]] std::span<const double> axis(std::size_t i) const { return {axis_[i].get(), size_}; }
  // The block that each move belongs to, from 1: an inserted move has that of the block that made it.
  [[nodiscard]] std::span<const std::uint64_t> block() const { return {block_.get(), size_}; }
  void clear() { size_ = 0; }

  // --- for those who write ---
  // Room for so many more.
  void reserve(std::size_t more);
  // Where the next move goes. Behind reserve(); what has been written counts with append().
  [[nodiscard]] double* next_of(std::size_t axis) { return axis_[axis].get() + size_; }
  [[nodiscard]] std::uint64_t* next_block() { return block_.get() + size_; }
  // So many, of blocks with consecutive numbers.
  void append_lines(std::size_t count, std::uint64_t first_block);
  // An axis that stays, of as many.
  void set_axis(std::size_t axis, std::size_t count, double value);
  void append(std::size_t count) { size_ += count; }

 private:
  std::size_t axes_;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
  std::array<std::unique_ptr<double[]>, spec::kMaxAxes> axis_;  // NOLINT(modernize-avoid-c-arrays): their length varies
  std::unique_ptr<std::uint64_t[]> block_;                      // NOLINT(modernize-avoid-c-arrays)
};

}  // namespace toolcomp::fast

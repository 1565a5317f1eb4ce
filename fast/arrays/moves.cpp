// SPDX-License-Identifier: Apache-2.0
#include "fast/arrays/moves.h"

#include <algorithm>

namespace toolcomp::fast {
namespace {

template <class Number>
// NOLINTNEXTLINE(modernize-avoid-c-arrays): nothing is written to memory that is not used yet
void grow(std::unique_ptr<Number[]>& column, std::size_t size, std::size_t capacity) {
  auto more = std::make_unique_for_overwrite<Number[]>(capacity);  // NOLINT(modernize-avoid-c-arrays)
  std::copy_n(column.get(), size, more.get());
  column = std::move(more);
}

}  // namespace

void Moves::reserve(std::size_t more) {
  if (capacity_ - size_ >= more) return;
  capacity_ = std::max(size_ + more, 2 * capacity_);
  for (std::size_t i = 0; i < axes_; ++i) grow(axis_[i], size_, capacity_);
  grow(block_, size_, capacity_);
}

void Moves::append_lines(std::size_t count, std::uint64_t first_block) {
  std::uint64_t* const block = next_block();
  for (std::size_t i = 0; i < count; ++i) block[i] = first_block + i;
  append(count);
}

void Moves::set_axis(std::size_t axis, std::size_t count, double value) {
  double* const to = next_of(axis);
  for (std::size_t i = 0; i < count; ++i) to[i] = value;
}

}  // namespace toolcomp::fast

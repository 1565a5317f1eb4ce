// SPDX-License-Identifier: Apache-2.0
#include "certify/trace/path_window.h"

#include <algorithm>

namespace toolcomp::certify {

bool PathWindow::has(std::size_t number) {
  while (number >= end() && !ended_) {
    WindowPiece w;
    if (!source_.next(w.piece)) {
      ended_ = true;
      break;
    }
    const PathPiece& piece = w.piece;
    w.magnitude = std::max(metric_.magnitude(piece.begin), metric_.magnitude(piece.end));
    w.length = metric_.in_tolerances(metric_.between(piece.begin, piece.end));
    w.move_first = end();
    if (!pieces_.empty()) {
      const WindowPiece& before = pieces_.back();
      w.begins = before.begins + before.length;
      if (!before.piece.corner) w.move_first = before.move_first;
    }
    largest_error_.linear = std::max(largest_error_.linear, piece.error.linear);
    largest_error_.rotary = std::max(largest_error_.rotary, piece.error.rotary);
    largest_magnitude_ = std::max(largest_magnitude_, w.magnitude);
    corners_ += piece.corner && !piece.jump ? 1 : 0;
    free_moves_ += piece.corner && piece.free ? 1 : 0;
    boxes_.add(piece.begin, piece.end);
    pieces_.push_back(w);
    linear_ += linear_length(end() - 1);
  }
  return number < end();
}

void PathWindow::drop_before(std::size_t number) {
  // The last piece stays: the next one continues its length.
  for (; first_ < number && pieces_.size() > 1; ++first_) pieces_.pop_front();
  boxes_.drop_before(first_);
}

AxisPoint PathWindow::point(const PathPlace& place) const {
  const PathPiece& piece = (*this)[place.piece].piece;
  return point_at(piece.begin, piece.end, place.at);
}

double PathWindow::length_to(const PathPlace& place) const {
  const WindowPiece& w = (*this)[place.piece];
  return w.begins + place.at * w.length;
}

std::size_t PathWindow::first_beyond(double length) const {
  const auto beyond = std::ranges::upper_bound(pieces_, length, {}, &WindowPiece::begins);
  return first_ + static_cast<std::size_t>(beyond - pieces_.begin());
}

double PathWindow::linear_length(std::size_t number) const {
  const PathPiece& piece = (*this)[number].piece;
  return piece.jump ? 0 : metric_.between(piece.begin, piece.end).linear;
}

Limit PathWindow::limit(std::size_t number, double magnitude) const {
  const WindowPiece& w = (*this)[number];
  return metric_.limit(w.piece.error, std::max(w.magnitude, magnitude));
}

}  // namespace toolcomp::certify

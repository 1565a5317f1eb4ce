// SPDX-License-Identifier: Apache-2.0
// The stretch of the path that a match may still need.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>

#include "certify/trace/boxes.h"
#include "certify/trace/metric.h"
#include "certify/trace/path.h"

namespace toolcomp::certify {

// A place of the path: its piece, and its position on the piece, from 0 to 1.
struct PathPlace {
  std::size_t piece = 0;
  double at = 0;
  friend auto operator<=>(const PathPlace&, const PathPlace&) = default;
};

struct WindowPiece {
  PathPiece piece;
  double magnitude = 0;        // the largest coordinate
  double begins = 0;           // length of the path before it, in tolerances
  double length = 0;           // in tolerances
  std::size_t move_first = 0;  // the first piece of its move
};

// The pieces by number, from 0 on. They are fetched on request and kept until they are dropped.
class PathWindow {
 public:
  PathWindow(PathSource& source, const Metric& metric) : source_(source), metric_(metric) {}

  // Whether the path has a piece with this number. Fetches the pieces up to it.
  bool has(std::size_t number);
  [[nodiscard]] const WindowPiece& operator[](std::size_t number) const { return pieces_[number - first_]; }
  // The held pieces are [first, end).
  [[nodiscard]] std::size_t first() const { return first_; }
  [[nodiscard]] std::size_t end() const { return first_ + pieces_.size(); }
  void drop_before(std::size_t number);

  [[nodiscard]] AxisPoint point(const PathPlace& place) const;
  // The length of the path up to this place, in tolerances.
  [[nodiscard]] double length_to(const PathPlace& place) const;
  // The length of a piece in the linear axes, in setup units; 0 for a jump.
  [[nodiscard]] double linear_length(std::size_t number) const;
  // The first piece that begins beyond this length of the path; the end of the held pieces if there is none.
  [[nodiscard]] std::size_t first_beyond(double length) const;
  [[nodiscard]] Limit limit(std::size_t number, double magnitude) const;

  // Calls `each(number, part)` for the judged pieces in [from, to) near `p`, in order.
  template <class Each>
  void near(std::size_t from, std::size_t to, const AxisPoint& p, Each each) const {
    const double magnitude = metric_.magnitude(p);
    const Limit widest = metric_.limit(largest_error_, std::max(magnitude, largest_magnitude_));
    boxes_.visit(
        from, to, [&](const AxisBox& box) { return metric_.exceeds(metric_.outside(box, p), widest); },
        [&](std::size_t number) {
          const WindowPiece& w = (*this)[number];
          if (w.piece.free) return;
          if (const auto part = metric_.part_near(w.piece.begin, w.piece.end, p, limit(number, magnitude)))
            each(number, *part);
        });
  }
  [[nodiscard]] const Boxes& boxes() const { return boxes_; }

  // The number of corners of all fetched pieces.
  [[nodiscard]] std::uint64_t corners() const { return corners_; }
  [[nodiscard]] std::uint64_t free_moves() const { return free_moves_; }
  [[nodiscard]] double fetched_length() const { return linear_; }  // linear axes, setup units, without jumps

 private:
  PathSource& source_;
  const Metric& metric_;
  std::deque<WindowPiece> pieces_;
  Boxes boxes_;
  std::size_t first_ = 0;
  bool ended_ = false;
  Distance largest_error_;
  double largest_magnitude_ = 0;
  std::uint64_t corners_ = 0;
  std::uint64_t free_moves_ = 0;
  double linear_ = 0;
};

}  // namespace toolcomp::certify

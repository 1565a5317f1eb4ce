// The scale of an event's coordinates and the condition of its compensation vector, from exact events alone.
#pragma once

#include <array>
#include <span>

#include "model/engine.h"
#include "spec/language/setup.h"

namespace toolcomp::fuzz {

// What the policy multiplies its k with, in setup units.
struct Scale {
  double position = 0;   // the largest linear magnitude that enters the event's coordinates
  double vector = 0;     // length of the compensation vector
  double condition = 1;  // error of the vector over error of the directions it is made of
};

// Follows the events of one run, in order.
//
// A leading edge vector is R · V/|V| with V = (VM × VT) × VT: an error of the directions VM and VT turns it by that
// error over sin(VM, VT). VM is the next movement, before a cancel the block's own; a vector that is kept keeps its
// condition. Which of the two made the vector is not asked: the worse counts. Pairs inside the ranges of parameter
// 19631 made none.
class Conditions {
 public:
  explicit Conditions(const spec::Setup& setup);
  // The scale of window[0]; `window` holds the events from it to the next one that moves, or all that follow.
  Scale next(std::span<const model::Event> window);

 private:
  using Vector = std::array<double, 3>;
  [[nodiscard]] double condition(std::span<const model::Event> window, const Vector& at, const Vector& tool) const;
  [[nodiscard]] Vector vector(const spec::AxisValues<model::Real>& values) const;

  std::array<std::size_t, 3> index_;  // of X Y Z; Axes::kNone
  std::array<bool, spec::kMaxAxes> linear_{};
  double setup_scale_ = 0;
  double smallest_sine_ = 0;  // of an angle that is not classified as 0 or 180
  Vector position_{};         // programmed, of the event before
  Vector vector_{};           // compensation, of the event before
  double condition_ = 1;      // of vector_
};

}  // namespace toolcomp::fuzz

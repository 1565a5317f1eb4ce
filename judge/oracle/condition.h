// SPDX-License-Identifier: Apache-2.0
// The scale of an event's coordinates and the condition of its compensation vector, from exact events only.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "judge/oracle/corner.h"
#include "judge/oracle/policy.h"
#include "judge/oracle/pose_error.h"
#include "judge/oracle/scale.h"
#include "judge/oracle/space_scale.h"
#include "judge/oracle/tool_plane.h"
#include "model/basis/event.h"
#include "spec/language/setup.h"

namespace toolcomp::judge {

// Follows the events of one run, in order.
//
// The vector is `point` less `programmed`, less the shift of G45 to G48 from before the start of the compensation.
// Between a cancel and a start-up all of it is shift.
//
// A leading edge vector is R · V/|V| with V = (VM × VT) × VT: an error of the directions VM and VT turns it by that
// error over sin(VM, VT). VM is the next movement, before a cancel the block's own; a vector that is kept keeps its
// condition. It does not matter which of the two pairs made the vector: the worse one counts. Pairs inside the ranges
// of parameter 19631 made no vector, and neither did pairs whose plane does not contain the vector. Corners of cutter
// compensation: see corner.h; of tool side compensation: see tool_plane.h. Every condition that fits counts, and of
// these the worst.
//
// A sample is between two heads and has the worse of their scales.
//
// The sweep of an arc with a vector, or by R, turns by the errors of its ends and its centre over their distances.
//
// Heidenhain: space_scale.h.
class Conditions {
 public:
  // `facts`: of the program, if it is available (program_facts.h). Kept by reference. `k`: of lengths.
  explicit Conditions(const spec::Setup& setup, const ProgramFacts* facts = nullptr,
                      double k = policy::kAnySection.coordinate);
  // The scale of window[0]; `window` has the events from this one to the next one that moves, or to the last one.
  Scale next(std::span<const model::Event> window);

 private:
  using Vector = Space;
  [[nodiscard]] Scale move(std::span<const model::Event> window, Scale scale);
  [[nodiscard]] Scale hole(const model::Event& event, Scale scale);
  [[nodiscard]] Scale sample(std::span<const model::Event> window, Scale scale);
  [[nodiscard]] double condition(std::span<const model::Event> window, const Vector& tool,
                                 const Vector& compensation) const;
  // Whether the way is exactly along the tool: it makes no vector, whatever parameter 19631 is. If that cannot be
  // decided, it is not.
  [[nodiscard]] bool along(const std::optional<std::array<model::Real, 3>>& tool, const Programmed& from,
                           const Programmed& to) const;
  [[nodiscard]] Vector vector(const spec::AxisValues<model::Real>& values) const { return space_of(values, index_); }
  void head(std::span<const model::Event> window, const View& view, const Vector& compensation, Scale& scale) const;
  void arc(const model::Event& event, const Vector& compensation, Scale& scale) const;

  std::array<std::size_t, 3> index_;  // of X Y Z; Axes::kNone
  double k_;
  std::array<bool, spec::kMaxAxes> linear_{};
  double setup_scale_ = 0;
  double smallest_sine_ = 0;  // of an angle that is not classified as 0 or 180
  Programmed programmed_;     // of the event before
  Vector position_{};         // the same
  Vector vector_{};           // compensation, of the event before
  double condition_ = 1;      // of vector_
  Heads heads_;               // heads that may have placed it
  double rest_ = 1;           // condition of everything else that placed it
  Vector point_{};            // of the event before
  Vector shift_{};            // of point against programmed, if there is no vector
  bool compensated_ = false;  // from a start-up to a cancel
  Corners corners_;
  std::optional<ToolPlane> tool_plane_;  // for machines whose events have a tool axis
  const ProgramFacts* facts_;
  PoseErrors pose_;
  std::optional<Scale> of_move_;      // of the move whose samples these are
  std::optional<SpaceScales> space_;  // Heidenhain
};

}  // namespace toolcomp::judge

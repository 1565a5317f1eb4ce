// SPDX-License-Identifier: Apache-2.0
// The scale of events of 3D tool compensation (Heidenhain), from exact events only.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "judge/oracle/corner.h"
#include "judge/oracle/scale.h"
#include "model/basis/event.h"
#include "spec/language/setup.h"

namespace toolcomp::judge {

// Follows the events of one run, in order.
//
// Blocks with a normal: the ring of radius rho is along u, the part of n across t, whose error is that of n and t over
// the sine of their angle. With a table of deviations the radius is off by its slope times the error of the angle.
//
// Blocks of peripheral milling: c = t x d / |t x d| has the error of t and of d, which is that of its programmed ends
// over its length, over the sine of their angle. If a direction does not exist, the error of the one before is kept.
//
// Their mitre: let c and c' be 2 phi apart. v = delta (c + c')/(1 + c.c') is delta/cos phi long, along the bisector.
// Errors of e in either turn the bisector by e and change phi by e: v moves by v e across and by v tan phi e along
// itself, tan phi < v/delta; together v e (1 + v/delta). It is the condition of the point, however it is computed: near
// a reversal v grows without bound, and metres are few ulps of t compared with a mitre of thousands of kilometres. The
// decision on the reversal is by 1 + c.c' = 2 (delta/v)^2: from v = 2^20 delta on (policy::kDoubleBand) E_REVERSAL is
// permitted, too. (The sum 1 + c.c' itself, rounded, is worse than that by v/delta: beyond about a hundred it needs
// |c x c'|^2/(1 - c.c').)
class SpaceScales {
 public:
  explicit SpaceScales(const spec::Setup& setup);
  // The units of the program. Before this call, those of the setup apply.
  void units(spec::Units units);
  // The scale of window[0]; `window` as for Conditions::next.
  Scale next(std::span<const model::Event> window);

 private:
  Scale hole(const model::Event& event, Scale scale);
  [[nodiscard]] double face(const model::Event& event) const;
  [[nodiscard]] double steepest(double angle) const;
  void beside(std::span<const model::Event> window, const Space& at, Scale& scale);

  std::array<std::size_t, 3> index_;  // of X Y Z
  double to_program_ = 1;             // mm to units of the program
  double radius_ = 0;                 // the largest of the tool table, mm
  std::vector<std::vector<std::pair<double, double>>> tables_;
  Space before_{};     // programmed, of the move before
  double former_ = 0;  // error of the direction made last
};

}  // namespace toolcomp::judge

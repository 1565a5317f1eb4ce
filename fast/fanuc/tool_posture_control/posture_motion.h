// SPDX-License-Identifier: Apache-2.0
// The law by which rotary axes and tool move inside a block (fanuc.tool-center-point.conventional,
// fanuc.tool-posture.great-circle), and its samples.
#pragma once

#include <array>
#include <cstdint>

#include "fast/fanuc/tool_posture_control/great_circle.h"
#include "fast/kinematics/machine.h"

namespace toolcomp::fast {

struct PostureSample {
  std::array<double, 2> degrees{};  // of the 1st and 2nd rotary axis, whole turns included
  Turns<double> turns;              // their sines and cosines
  Vector3<double> tool;             // unit, as Pose::tool: in the system events report
};

// Holds everything it needs but the machine: blocks that wait in the look-ahead of compensation keep a copy.
class PostureMotion {
 public:
  enum class Law : std::uint8_t {
    still,     // nothing turns
    linear,    // both rotary axes evenly: conventional control, and passing a singular posture
    circle,    // V(t) on the great circle, the tool-side axis on its branch
    meridian,  // the same on a circle through the work-side axis, which V(t) may cross
  };

  [[nodiscard]] Law law() const { return law_; }
  // The sample at t = numerator / denominator, cheapest in ascending order.
  void at(std::uint32_t numerator, std::uint32_t denominator, PostureSample& sample);

  void set_still(const Machine& machine, const Pose& pose);
  void set_linear(const Machine& machine, const Pose& start, const Pose& end);
  // `azimuth`: the sign with which V(t) turns about the work-side axis, 0 for none. `branch` at the start.
  void set_circle(const Machine& machine, const Pose& start, const Pose& end, int branch, int azimuth);
  // `pole` +1, -1: the circle runs through, or at the side of, u_w or -u_w. `branch`: on the side of `heading`, the
  // azimuth of the tool (horizontal unit vector) before it crosses.
  void set_meridian(const Machine& machine, const Pose& start, const Pose& end, int branch, int pole,
                    const Vector2<double>& heading);
  // In place of the great circle of the rounded ends: where they are nearly opposite.
  void refine_circle(const Vector3<DoubleDouble>& start_seen, const Vector3<DoubleDouble>& end_seen);

 private:
  void set_ends(const Machine& machine, const Pose& start, const Pose& end);
  void set_arc(Law law, const Machine& machine, const Pose& start, const Pose& end, int branch);
  // What only samples need, before the first one.
  void prepare();
  void prepare_circle();
  void prepare_meridian();
  void set_great_circle(const Vector3<double>& start, const Vector3<double>& side, double radians);
  void linear_at(std::uint32_t numerator, std::uint32_t denominator, PostureSample& sample);
  void wide_at(std::size_t i, const DoubleDouble& t, PostureSample& sample) const;
  void circle_at(const Vector3<double>& seen, PostureSample& sample);
  void meridian_at(const Vector3<double>& seen, PostureSample& sample);
  // Notes the sample that is asked for; true if it is the next one and its values may be led on from the last ones.
  [[nodiscard]] bool goes_on(std::uint32_t numerator, std::uint32_t denominator);
  // Leads psi_and_work_ on to this sine and cosine; false, and nothing done, where they are not near the last ones.
  [[nodiscard]] bool follow(DoublePair sine, DoublePair cosine);
  // The way of both positions from one sample to the next, linear.
  void set_steps(DoublePair degrees);
  void set_angles(DoublePair sine, DoublePair cosine, PostureSample& sample) const;
  // Brings the work-side position of a sample, and those led on from it, to its turn.
  void settle(PostureSample& sample);
  struct OnMeridian {
    double sin_psi;
    Vector2<double> lean;
  };
  [[nodiscard]] OnMeridian on_meridian(const Vector3<double>& seen) const;

  // How an end is known beyond its double.
  struct WideEnd {
    bool by_turn = false;
    SineCosine<double> turn{};
    DoubleDouble position;
  };
  void set_wide(WideEnd& to, const Pose& pose, std::size_t i) const;
  void prepare_wide();

  const Machine* machine_ = nullptr;
  Law law_ = Law::still;
  std::array<double, 2> start_{};
  std::array<double, 2> end_{};
  std::array<bool, 2> wide_{};  // of the linear law: many turns from 0
  std::array<WideEnd, 2> wide_start_;
  std::array<WideEnd, 2> wide_end_;
  std::array<DoubleDouble, 2> from_{};
  std::array<DoubleDouble, 2> by_{};
  PostureSample still_;
  bool prepared_ = true;
  Vector3<double> start_seen_;  // Pose::seen of both ends
  Vector3<double> end_seen_;
  double start_psi_ = 0;  // 0 or 180 in a pole itself
  Circle seen_;           // in the system of the work-side axis
  Circle reported_;       // in that of events
  EvenAngle angle_;
  double tool_base_ = 0;  // of the tool-side position: psi = 0
  double branch_ = 1;
  int pole_ = 0;
  int azimuth_ = 0;
  // The last sample: its fraction, sines and cosines, the angles; from there on by the step to the next one.
  std::uint32_t numerator_ = 0;
  std::uint32_t denominator_ = 0;
  bool goes_on_ = false;
  bool small_steps_ = false;
  DoublePair sine_{};  // linear: of the 1st and 2nd position; else of psi and the work-side axis, mechanical
  DoublePair cosine_{};
  DoublePair step_sine_{};         // linear
  DoublePair step_versine_{};      // 1 - cosine
  DoublePair psi_and_work_{};      // degrees; of the work-side axis from the start
  Vector2<double> start_heading_;  // of the tool at the start, horizontal
  Vector2<double> start_lean_;     // of c(psi) at the start; of a meridian: with the half turns taken off
};

}  // namespace toolcomp::fast

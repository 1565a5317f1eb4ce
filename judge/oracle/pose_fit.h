// SPDX-License-Identifier: Apache-2.0
// Judges poses by backward error: from the rotary positions that a controller reports, forward to their effect.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "judge/oracle/compare.h"
#include "judge/oracle/program_facts.h"
#include "judge/oracle/rotary.h"
#include "model/kinematics/machine.h"

namespace toolcomp::judge {

// Inverse kinematics is ill-conditioned near singular postures and edges of reach, and later blocks depend on its
// results. Forward kinematics is well-conditioned everywhere. So a controller's rotary positions are right if they fit,
// and everything else is judged as seen from them:
// * either they turn the tool into the direction expected, on its branch, less than half a turn away (where directions
//   are commanded, and inside blocks of posture control);
// * or each axis moves as expected from the controller's own earlier position: it stands still, runs evenly, or takes a
//   number of the program.
// Tool axis and linear axes then follow from the positions reported, the tool length and the tip, with the programming
// coordinate system frozen at the controller's own pose. So no tolerance grows from block to block.
//
// The reported positions are taken as exact: a double or a decimal text is a rational number, and the kinematics of the
// model are run on it.
template <class Number>
class PoseFit {
 public:
  // `facts` as for Conditions. Both are kept by reference.
  PoseFit(const Rules& rules, const spec::Setup& setup, const ProgramFacts* facts);

  // The event that is expected of a controller with the rotary positions of `actual`; the distance of its tool axis
  // from the expected one; and the angle, in radians, by which these positions may differ from the controller's own
  // because it reported them rounded.
  struct Seen {
    model::Event event;
    double direction = 0;
    double rounded = 0;
  };
  // Of window[0]; `window` as for Conditions::next. std::nullopt if the positions do not fit, or if there are none.
  [[nodiscard]] std::optional<Seen> seen(std::span<const model::Event> window, const spec::Event<Number>& actual,
                                         const Scale& scale);

  // Goes on after a pair that agreed; `direction` as above.
  void follow(const model::Event& expected, const spec::Event<Number>& actual, double direction);

  // By how much programmed positions may be off because they once were positions of axes under tool center point
  // control.
  [[nodiscard]] double carried() const { return carried_; }
  // By how much X Y Z of `event`, the next one, differ because they are the controller's own at a block in which the
  // mode ends or begins again: there axes under tool center point control become programmed positions. std::nullopt if
  // none do.
  [[nodiscard]] std::optional<model::Vector> taken_over(const model::Event& event,
                                                        const spec::Event<Number>& actual) const;
  // The deviations of the controller's rotary positions that are larger than their rounding.
  [[nodiscard]] const std::vector<Deviation>& deviations() const { return deviations_; }

 private:
  using Rational = exact::Rational;
  // Mechanical angles of both rotary axes, in degrees; 0 for a hypothetical axis.
  struct Positions {
    Rational tool;
    Rational work;
    [[nodiscard]] model::Pose pose() const { return {tool, work}; }
  };
  // The error of an axis, in degrees.
  struct Off {
    double tool = 0;
    double work = 0;
  };
  struct View;  // one event from both positions

  [[nodiscard]] bool has_positions(const model::Event& expected, const spec::Event<Number>& actual) const;
  [[nodiscard]] Positions of(const model::Event& expected) const;
  [[nodiscard]] Positions of(const spec::Event<Number>& actual) const;
  [[nodiscard]] Off off(const model::Event& expected, const spec::Event<Number>& actual) const;
  void find_zeros(const model::Event& event);
  [[nodiscard]] bool begins(const model::Event& event) const;
  static bool controlled(const model::Event& event);
  // Whether axes under tool center point control become programmed positions here.
  [[nodiscard]] bool takes_over(const model::Event& event) const { return !controlled(event) || begins(event); }
  // Whether both have a position of this axis at the end of the move before.
  [[nodiscard]] bool were_both(std::size_t axis) const;
  // The distance of both at the end of the move before, along X, Y or Z or together; 0 without positions.
  [[nodiscard]] double apart() const;
  [[nodiscard]] model::Vector reported(const Positions& positions) const;
  [[nodiscard]] View view(const model::Event& event, const spec::Event<Number>& actual) const;

  [[nodiscard]] Posture posture_at(const Positions& positions) const;

  // Whether its positions come from a direction, as far as is known.
  [[nodiscard]] bool directed(const model::Event& event) const {
    return facts_ == nullptr || facts_->directed(event.line);
  }
  // The error of positions that are doubles, in radians. The direction at a pose, outside tool center point control.
  [[nodiscard]] model::Vector outside_the_mode(const model::Pose& pose) const;
  static double rounded(const View& view);
  [[nodiscard]] bool turns_into(const View& view, const Scale& scale) const;
  [[nodiscard]] bool goes_as_expected(std::span<const model::Event> window, const View& view) const;
  [[nodiscard]] model::Vector off_tip(const model::Event& event, const spec::Event<Number>& actual,
                                      const Scale& scale) const;
  [[nodiscard]] model::Event adjusted(const View& view, const model::Vector& off_tip) const;
  [[nodiscard]] std::optional<Seen> without_kinematics(const model::Event& expected, const spec::Event<Number>& actual,
                                                       const Scale& scale) const;
  // The difference between the angle by which a rotary axis turns and its position.
  [[nodiscard]] Rational angle_zero(std::size_t axis) const { return mechanical_ ? zero_.at(axis) : Rational(0); }
  [[nodiscard]] model::Vector linear(const spec::AxisValues<model::Real>& values) const;
  void set_linear(spec::AxisValues<model::Real>& values, const model::Vector& to) const;

  const Rules& rules_;
  const ProgramFacts* facts_;
  std::array<std::size_t, 3> index_;  // of X Y Z
  std::optional<RotaryMachine> estimate_;
  std::optional<model::Machine> machine_;
  bool mechanical_ = false;    // the angles that turn tool and table are those of machine coordinates
  bool in_workpiece_ = false;  // 19696#5 = 1 on a table
  bool table_stands_ = false;  // 30i: outside the mode, directions are those in the machine, except with 19746#4
  bool active_ = false;        // the move before was under tool center point control
  Positions frozen_;           // pose at which the programming coordinate system is fixed, as expected
  Positions own_frozen_;       // and as the controller has it
  std::array<Rational, spec::kMaxAxes> zero_;  // machine minus workpiece coordinates
  Off before_;                                 // at the end of the move before
  double direction_ = 0;                       // of the tool axis there
  spec::AxisValues<model::Real> axes_before_;  // there, if that was under tool center point control
  spec::AxisValues<Number> own_before_;        // and the positions that the controller had
  double carried_ = 0;
  std::vector<Deviation> deviations_;
};

}  // namespace toolcomp::judge

// SPDX-License-Identifier: Apache-2.0
// Tool direction from rotary axes (fanuc.tool-direction.*).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "fast/arithmetic/double_double.h"
#include "fast/arithmetic/trigonometry.h"
#include "fast/geometry/vector3.h"
#include "fast/kinematics/direction.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// One rotary axis of the chain: turns by sign * (position - reference) about `axis`.
struct RotaryAxis {
  static constexpr std::size_t kNone = spec::kMaxAxes;
  std::size_t index = kNone;  // of the setup; kNone: the angle is fixed (hypothetical axis, or none)
  FineVector axis;            // unit
  bool reversed = false;
  bool stands = false;  // turns nothing for now
  Count reference;      // degrees; the fixed angle is -reference
};

// The rotary axes of a setup and the direction they give the tool:
//   V(inner, outer) = R(outer.axis, outer angle) R(inner.axis, inner angle) v0.
// Expanded, V is a sum of constant vectors times {1, cos, sin} of the inner and of the outer angle; the constants are
// made once, in double-double, and only those that are not zero are kept.
class Kinematics {
 public:
  // Throws spec::InputError, naming the parameter, for parameters that describe no machine.
  explicit Kinematics(const spec::Setup& setup);

  // Whether the setup has kinematics at all (19680 or 19610 not 0).
  [[nodiscard]] bool defined() const { return defined_; }
  // Whether the direction depends on this axis of the setup.
  [[nodiscard]] bool turns_with(std::size_t axis) const { return inner_.index == axis || outer_.index == axis; }
  // The machine unit type 19680 (0: none, or the parameters 19610 ff.).
  [[nodiscard]] int type() const { return type_; }

  // Machine positions of the zeros from which direct() is given positions, by axis index; at first 0.
  void set_zeros(const std::array<Count, spec::kMaxAxes>& zero);
  // Whether direct() gives directions as seen from the table, as always in tool center point control: false, where the
  // series lets the table stand outside of it, those in the machine.
  void see_from_table(bool from_table) {
    inner_.stands = table_may_stand_ && !from_table && type_ == 12;
    outer_.stands = table_may_stand_ && !from_table;
  }
  // Sets `direction` for the axis positions (degrees, by axis index of the setup).
  void direct(const std::array<Count, spec::kMaxAxes>& position, Direction& direction);
  // The unit vector in double-double, each component within direction.refined_error().
  [[nodiscard]] const FineVector& refine(const Direction& direction) const;
  // The same to 2^-65 a component, in a tenth of the time. Nothing: the direction is not that of rotary axes at usual
  // angles, or seen in a frame that is turned.
  [[nodiscard]] const FineVector* extended(const Direction& direction) const;
  // As refine(), seen from the table at its zero pose, whatever the frame.
  [[nodiscard]] FineVector refine_on_table(const Direction& direction) const;

  // The rotary axes in the order in which they turn the direction, and the direction with both at 0.
  [[nodiscard]] const RotaryAxis& inner() const { return inner_; }
  [[nodiscard]] const RotaryAxis& outer() const { return outer_; }
  [[nodiscard]] const FineVector& zero_direction() const { return zero_direction_; }

  // Sine and cosine of the angles of the inner (0) and the outer axis (1) that direct() was asked for last.
  [[nodiscard]] SineCosine<double> turned(std::size_t i) const { return {trigonometry_[i][2], trigonometry_[i][1]}; }
  // Every component of the direction is one product at most, as heads and tables along axes give, for any angles.
  [[nodiscard]] bool has_one_term() const { return one_term_; }
  [[nodiscard]] Vector3<double> one_term_direction(const SineCosine<double>& inner,
                                                   const SineCosine<double>& outer) const {
    const std::array<double, 3> i{1, inner.cosine, inner.sine};
    const std::array<double, 3> o{1, outer.cosine, outer.sine};
    const auto value = [&](const OneTerm& term) { return term.coefficient * i[term.inner] * o[term.outer]; };
    return {value(term_[0]), value(term_[1]), value(term_[2])};
  }

  // The programming coordinate system of tool center point control: table directions turned by `rows`. Directions
  // marked `framed` are refined in it.
  struct Frame {
    bool turned = false;                           // not the identity
    bool along_axes = true;                        // every entry is 0 or +-1
    double fine_error = 0;                         // of an entry of `fine`
    std::array<std::array<double, 3>, 3> rough{};  // rows
    std::array<FineVector, 3> fine{};              // rows
  };
  void set_frame(const std::array<FineVector, 3>& rows, double fine_error);
  void clear_frame() {
    frame_ = Frame{};
    refined_.valid = false;
  }
  [[nodiscard]] const Frame& frame() const { return frame_; }

 private:
  struct Term {
    double coefficient;
    std::uint8_t component, inner, outer;  // which of {1, cos, sin}
    DoubleDouble fine;
  };

  void from_unit_type(const spec::Setup& setup, int type);
  void from_axis_groups(const spec::Setup& setup);
  void expand(const FineVector& v0);
  [[nodiscard]] FineVector sum_of_terms(const SineCosine<DoubleDouble>& inner,
                                        const SineCosine<DoubleDouble>& outer) const;
  // The angle of an axis; the same as a plain count of 10^-6 degrees, or kNotSmall.
  [[nodiscard]] static std::int64_t set_angle(const RotaryAxis& axis, const std::array<Count, spec::kMaxAxes>& position,
                                              Count& turned);
  void set_trigonometry(std::size_t i, double sine, double cosine);
  [[nodiscard]] static Count angle(const RotaryAxis& axis, const std::array<Count, spec::kMaxAxes>& position);

  bool defined_ = false;
  int type_ = 0;
  bool table_may_stand_ = false;
  RotaryAxis inner_;
  RotaryAxis outer_;
  std::array<Count, 2> reference_;  // of both, with zeros of 0
  std::vector<Term> terms_;
  bool whole_terms_ = false;  // every coefficient is 0 or +-1
  FineVector zero_direction_{};
  Frame frame_;
  // Where a component has one term at most, as heads and tables along axes give: that term, or 0.
  struct OneTerm {
    double coefficient = 0;
    std::uint8_t inner = 0, outer = 0;
  };
  bool one_term_ = false;
  std::array<OneTerm, 3> term_;  // by component
  double error_ = 0;
  double fine_error_ = 0x1p-98;
  // {1, cos, sin} of the angles computed last, and whether they are multiples of 90 degrees.
  std::array<std::array<double, 3>, 2> trigonometry_{{{1, 0, 0}, {1, 0, 0}}};
  std::array<bool, 2> quarters_{};
  std::array<std::int64_t, 2> last_{Count::kNotSmall, Count::kNotSmall};  // of 10^-6, where they are
  // The direction refined last: a tool that stands still is refined once.
  struct Refined {
    bool valid = false;
    bool is_whole = false;
    bool framed = false;
    std::array<Int128, 3> whole{};
    std::array<Count, 2> angle;
    FineVector unit{};
  };
  mutable Refined refined_;
  // The one that extended() gave last.
  struct Extended {
    std::array<std::int64_t, 2> angle{Count::kNotSmall, Count::kNotSmall};
    FineVector unit{};
  };
  mutable Extended extended_;
};

}  // namespace toolcomp::fast

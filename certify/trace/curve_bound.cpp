// SPDX-License-Identifier: Apache-2.0
#include "certify/trace/curve_bound.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "certify/trace/jet.h"
#include "certify/trace/posture_jets.h"
#include "model/kinematics/machine.h"

namespace toolcomp::certify {
namespace {

using exact::Rational;
using model::Machine;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// Of an interval of sizes; what is no number has no bound.
double bound(const Interval& x) {
  const double upper = x.upper();
  return upper >= 0 ? upper : kInfinite;
}

Interval degrees(const Interval& radians) { return radians * 180.0 / boost::numeric::interval_lib::pi<Interval>(); }

// The path of the tip.
class Tip {
 public:
  explicit Tip(const model::PointPath& path) : from_(enclosed(path.from)), by_(enclosed(path.to - path.from)) {
    if (!path.turn) return;
    const model::PlaneLetters letters = model::letters(path.turn->plane);
    const model::PlanePoint from = model::in_plane_of(path.turn->plane, path.from);
    turn_.emplace(Turn{model::space_index(letters.first),
                       model::space_index(letters.second),
                       {enclosed(path.turn->center[0]), enclosed(path.turn->center[1])},
                       {enclosed(from[0] - path.turn->center[0]), enclosed(from[1] - path.turn->center[1])},
                       radians(enclosed(path.turn->sweep)),
                       enclosed(path.turn->growth)});
  }

  [[nodiscard]] JetVector at(const Interval& t) const {
    JetVector result;
    for (std::size_t i = 0; i < 3; ++i) result.at(i) = {from_.at(i) + t * by_.at(i), by_.at(i), 0.0};
    if (!turn_) return result;
    const Turned swept = turning(t, 0.0, turn_->sweep);
    const Jet growth{1.0 + t * turn_->growth, turn_->growth, 0.0};
    const auto& [x, y] = turn_->radius;
    result.at(turn_->first) = Jet(turn_->center[0]) + growth * (x * swept.cosine - y * swept.sine);
    result.at(turn_->second) = Jet(turn_->center[1]) + growth * (y * swept.cosine + x * swept.sine);
    return result;
  }

  // Of an arc: the length of the second derivative, √((r θ'²)² + (2 r' θ')²).
  [[nodiscard]] std::optional<Interval> bend(const Interval& t) const {
    using boost::numeric::square;
    if (!turn_) return std::nullopt;
    const Interval radius = boost::numeric::sqrt(square(turn_->radius[0]) + square(turn_->radius[1]));
    const Interval outward = radius * (1.0 + t * turn_->growth) * square(turn_->sweep);
    const Interval around = 2.0 * radius * turn_->growth * turn_->sweep;
    return boost::numeric::sqrt(square(outward) + square(around));
  }

 private:
  struct Turn {
    std::size_t first;
    std::size_t second;
    std::array<Interval, 2> center;
    std::array<Interval, 2> radius;  // from the centre to the start
    Interval sweep;                  // radians
    Interval growth;
  };
  IntervalVector from_;
  IntervalVector by_;
  std::optional<Turn> turn_;
};

// What carries tool and table.
struct Mechanism {
  explicit Mechanism(const model::ControlFrame& frame)
      : type(frame.machine.type()),
        tool(frame.machine.tool_side()),
        work(frame.machine.work_side()),
        reference(enclosed(frame.machine.reference())),
        table(enclosed(frame.machine.arms().table)),
        table_step(enclosed(frame.machine.arms().table_step)),
        head(enclosed(frame.machine.arms().head)),
        head_step(enclosed(frame.machine.arms().head_step)),
        origin(enclosed(frame.frame.origin())),
        frozen{turn_at(frame.machine.tool_side(), frame.frame.frozen().tool),
               turn_at(frame.machine.work_side(), frame.frame.frozen().work)} {}

  // The control point less the workpiece zero, as ProgrammingFrame has it.
  [[nodiscard]] JetVector control_point(const JetVector& tip, const Turns& now, const Jet& length) const {
    const JetVector tool_vector = length * constant(reference);
    switch (type) {
      case model::MachineType::table: {
        const JetVector first = tip + constant(origin) - constant(table);
        const JetVector second = tool.turned(first, frozen.tool) - constant(table_step);
        const JetVector carried = work.turned(second, frozen.work + -now.work) + constant(table_step);
        return tool.turned(carried, -now.tool) + constant(table) - constant(origin) + tool_vector;
      }
      case model::MachineType::mixed: {
        const JetVector first = tip + constant(origin) - constant(table);
        const JetVector carried = work.turned(first, frozen.work + -now.work) + constant(table) - constant(origin);
        return carried + tool.turned(tool_vector + constant(head), now.tool);
      }
      default:
        return tip + work.turned(tool.turned(tool_vector + constant(head), now.tool) + constant(head_step), now.work);
    }
  }

  model::MachineType type;
  RotaryAxis tool;
  RotaryAxis work;
  IntervalVector reference;
  IntervalVector table;
  IntervalVector table_step;
  IntervalVector head;
  IntervalVector head_step;
  IntervalVector origin;
  Turns frozen;
};

}  // namespace

struct CurveBound::Motion {
  using Posture = std::variant<std::monostate, Even, Swing, Lifted, Meridian>;

  // What is measured.
  void measure(const spec::Axes& axes, const TraceSpace& space) {
    for (const std::size_t axis : space.linear)
      if (model::is_space_axis(axes.letter(axis))) measured.at(model::space_index(axes.letter(axis))) = true;
  }

  struct At {
    JetVector position;
    std::optional<Turns> turns;
  };
  [[nodiscard]] At at(const Interval& t) const {
    const JetVector point = tip.at(t);
    const Jet along{length + t * growth, growth, 0.0};
    if (const auto* swing = std::get_if<Swing>(&posture)) return {point + along * swing->at(t), {}};
    if (!mechanism) {
      At result{point, {}};
      for (std::size_t i = 0; i < 3; ++i)
        result.position.at(i) = result.position.at(i) + Jet(offset.at(i) + t * drift.at(i), drift.at(i), 0.0);
      return result;
    }
    Turns turns;
    if (const auto* even = std::get_if<Even>(&posture)) turns = even->at(t);
    if (const auto* lifted = std::get_if<Lifted>(&posture)) turns = lifted->at(t);
    if (const auto* meridian = std::get_if<Meridian>(&posture)) turns = meridian->at(t);
    return {mechanism->control_point(point, turns, along), turns};
  }

  explicit Motion(const model::PointPath& path) : tip(path) {}
  // The axes bend as the tip does.
  [[nodiscard]] bool is_arc() const { return std::holds_alternative<std::monostate>(posture); }

  Tip tip;
  Posture posture;
  Interval length = 0.0;
  Interval growth = 0.0;  // of the length
  std::optional<Mechanism> mechanism;
  IntervalVector offset{0.0, 0.0, 0.0};  // without a mechanism
  IntervalVector drift{0.0, 0.0, 0.0};   // its growth
  std::array<bool, 3> measured{};
  bool tool_measured = false;
  bool work_measured = false;
};

CurveBound::CurveBound(CurveBound&&) noexcept = default;
CurveBound& CurveBound::operator=(CurveBound&&) noexcept = default;
CurveBound::~CurveBound() = default;

CurveBound::CurveBound(const model::InsideMove::Form& move, const spec::Axes& axes, const TraceSpace& space) {
  auto motion = std::make_unique<Motion>(move.tip);
  motion->measure(axes, space);
  motion->length = enclosed(move.length_before);
  motion->growth = enclosed(Rational(move.length_after - move.length_before));
  if (const auto* direction = std::get_if<model::DirectionSwing>(&move.posture)) {
    motion->posture.emplace<Swing>(*direction);
    motion_ = std::move(motion);
    return;
  }
  const Machine& machine = move.frame->machine;
  motion->mechanism.emplace(*move.frame);
  if (const auto* turns = std::get_if<model::EvenTurns>(&move.posture)) {
    motion->posture.emplace<Even>(machine, *turns);
  } else {
    const auto& swing = std::get<model::LiftedSwing>(move.posture);
    const auto& poles = machine.singular_postures();
    // Axes at right angles have both poles, and run evenly through them.
    if (swing.level)
      motion->posture.emplace<Even>(machine, swing);
    else if (swing.side == 0 && poles.size() == 1)
      motion->posture.emplace<Meridian>(machine, swing, poles.front().side);
    else
      motion->posture.emplace<Lifted>(machine, swing);
    const auto measured = [&space](const model::Turn& turn) {
      return turn.axis && std::ranges::find(space.rotary, *turn.axis) != space.rotary.end();
    };
    motion->tool_measured = measured(machine.tool_side());
    motion->work_measured = measured(machine.work_side());
  }
  motion_ = std::move(motion);
}

CurveBound::CurveBound(const model::PointPath& tip, const exact::Vector3& offset_before,
                       const exact::Vector3& offset_after, const spec::Axes& axes, const TraceSpace& space) {
  auto motion = std::make_unique<Motion>(tip);
  motion->measure(axes, space);
  motion->offset = enclosed(offset_before);
  motion->drift = enclosed(offset_after - offset_before);
  motion_ = std::move(motion);
}

CurveBound::Part CurveBound::part(const Rational& t0, const Rational& t1) const {
  const Interval t(enclosed(t0).lower(), enclosed(t1).upper());
  const Interval length = enclosed(Rational(t1 - t0));
  const Rounding upward;
  const Motion::At at = motion_->at(t);
  const Interval eighth = boost::numeric::square(length) / 8.0;
  Interval second2 = 0.0;
  Interval extent2 = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!motion_->measured.at(i)) continue;
    second2 += boost::numeric::square(at.position.at(i).second);
    extent2 += boost::numeric::square(Interval(width(at.position.at(i).value)));
  }
  Part result;
  result.sagitta.linear = bound(boost::numeric::sqrt(second2) * eighth);
  if (motion_->is_arc())
    if (const auto bend = motion_->tip.bend(t))
      result.sagitta.linear = std::min(result.sagitta.linear, bound(*bend * eighth));
  result.extent.linear = bound(boost::numeric::sqrt(extent2));
  // An angle that goes without a jump while its point of the unit circle stays in a box of the diameter d: by at most
  // 2 asin(d/2), which is not more than d π/3 up to d = 1.
  const auto rotate = [&](const Turned& turned) {
    const Interval diameter = boost::numeric::sqrt(boost::numeric::square(Interval(width(turned.cosine.value))) +
                                                   boost::numeric::square(Interval(width(turned.sine.value))));
    result.sagitta.rotary =
        std::max(result.sagitta.rotary, bound(boost::numeric::abs(degrees(second_of_angle(turned))) * eighth));
    result.extent.rotary = std::max(result.extent.rotary, diameter.upper() <= 1 ? bound(diameter * 60.0) : kInfinite);
  };
  if (at.turns && motion_->tool_measured) rotate(at.turns->tool);
  if (at.turns && motion_->work_measured) rotate(at.turns->work);
  return result;
}

std::array<exact::DoubleEnclosure, 3> CurveBound::space_at(const Rational& t) const {
  const Interval place = enclosed(t);
  const Rounding upward;
  const Motion::At at = motion_->at(place);
  std::array<exact::DoubleEnclosure, 3> result;
  for (std::size_t i = 0; i < 3; ++i) result.at(i) = {at.position.at(i).value.lower(), at.position.at(i).value.upper()};
  return result;
}

}  // namespace toolcomp::certify

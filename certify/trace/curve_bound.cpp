#include "certify/trace/curve_bound.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "certify/trace/jet.h"
#include "model/kinematics/machine.h"

namespace toolcomp::certify {
namespace {

using exact::Rational;
using exact::Real;
using model::Machine;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

Interval enclosed(const Real& x) {
  const exact::DoubleEnclosure bounds = x.double_enclosure();
  return {bounds.lower, bounds.upper};
}
IntervalVector enclosed(const exact::Vector3& v) { return {enclosed(v.x), enclosed(v.y), enclosed(v.z)}; }

Interval pi() { return boost::numeric::interval_lib::pi<Interval>(); }
// Exact numbers are enclosed before an object of Rounding lives: libraries of theirs may count on rounding to nearest.
Interval radians(const Interval& degrees) {
  const Rounding upward;
  return degrees * pi() / 180.0;
}
Interval degrees(const Interval& radians) { return radians * 180.0 / pi(); }

// Of an interval of sizes; what is no number has no bound.
double bound(const Interval& x) {
  const double upper = x.upper();
  return upper >= 0 ? upper : kInfinite;
}
Interval size(const Interval& x) { return boost::numeric::abs(x); }

// A rotary axis.
struct Axis {
  std::size_t about = 2;  // 0, 1, 2: X, Y, Z; 3: another line
  IntervalVector line;

  explicit Axis(const model::Turn& turn) : about(turn.about), line(enclosed(turn.line)) {}

  // v - (line · v) line.
  [[nodiscard]] JetVector across(const JetVector& v) const {
    if (about == 3) return v - dot(constant(line), v) * constant(line);
    JetVector result = v;
    result.at(about) = Jet();
    return result;
  }
  [[nodiscard]] JetVector turned(const JetVector& v, const Turned& by) const {
    if (about == 3) {
      const JetVector k = constant(line);
      const JetVector part = across(v);
      return (v - part) + by.cosine * part + by.sine * cross(k, v);
    }
    const std::size_t j = (about + 1) % 3;
    const std::size_t k = (about + 2) % 3;
    JetVector result = v;
    result.at(j) = by.cosine * v.at(j) - by.sine * v.at(k);
    result.at(k) = by.sine * v.at(j) + by.cosine * v.at(k);
    return result;
  }
};

Turned turn_at(const model::Turn& turn, const model::Angle& position) {
  const model::Angle angle = turn.angle(position);
  return {enclosed(angle.cosine()), enclosed(angle.sine())};
}

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

// Turns of both axes, as they act on the tool.
struct Turns {
  Turned tool;
  Turned work;
};

// EvenTurns, and a level LiftedSwing.
class Even {
 public:
  Even(const Machine& machine, const model::EvenTurns& turns)
      : start_{turn_at(machine.tool_side(), turns.start.tool), turn_at(machine.work_side(), turns.start.work)},
        tool_(rate(machine.tool_side(), turns.end.tool - turns.start.tool)),
        work_(rate(machine.work_side(), turns.end.work - turns.start.work)) {}
  // A swing at right angles to the work-side axis, which alone turns: the tool-side axis may stand at the edge of its
  // reach, where its rate could not be bounded.
  Even(const Machine& machine, const model::LiftedSwing& level)
      : start_{turn_at(machine.tool_side(), level.start.tool), turn_at(machine.work_side(), level.start.work)},
        tool_(0.0),
        work_(static_cast<double>(level.side) * radians(enclosed(level.direction.degrees))) {}

  [[nodiscard]] Turns at(const Interval& t) const {
    return {start_.tool + turning(t, 0.0, tool_), start_.work + turning(t, 0.0, work_)};
  }

 private:
  static Interval rate(const model::Turn& turn, const model::Angle& by) {
    const Interval result = radians(enclosed(by.plain_degrees()));
    return turn.sense < 0 ? -result : result;
  }
  Turns start_;
  Interval tool_;  // radians
  Interval work_;
};

// DirectionSwing.
class Swing {
 public:
  explicit Swing(const model::DirectionSwing& swing)
      : from_(enclosed(swing.from)), ahead_(enclosed(swing.ahead)), rate_(radians(enclosed(swing.degrees))) {}

  [[nodiscard]] JetVector at(const Interval& t) const {
    const Turned swept = turning(t, 0.0, rate_);
    return swept.cosine * constant(from_) + swept.sine * constant(ahead_);
  }
  [[nodiscard]] const IntervalVector& from() const { return from_; }
  [[nodiscard]] const IntervalVector& ahead() const { return ahead_; }
  [[nodiscard]] const Interval& rate() const { return rate_; }

 private:
  IntervalVector from_;
  IntervalVector ahead_;
  Interval rate_;
};

// LiftedSwing, by inverse kinematics (model/kinematics/inverse.h). C is the height of the direction over the mean one,
// ρ its greatest. Where a pole is in reach ρ - C = 1 - u_w·V (ρ + C = 1 + u_w·V) is taken from the distance h of the
// direction from the work-side axis, so that it keeps its relative width beside the pole.
class Lifted {
 public:
  Lifted(const Machine& machine, const model::LiftedSwing& swing)
      : swing_(swing.direction),
        axis_(machine.work_side()),
        along_(enclosed(machine.heights().along)),
        across_(enclosed(machine.heights().across)),
        ahead_(enclosed(machine.heights().ahead)),
        mean_(enclosed(machine.heights().mean)),
        a_(enclosed(machine.heights().a)),
        b_(enclosed(machine.heights().b)),
        swing2_(enclosed(machine.heights().swing2)),
        upper_pole_(machine.singular(1) != nullptr),
        lower_pole_(machine.singular(-1) != nullptr),
        branch_(swing.branch) {}

  [[nodiscard]] Turns at(const Interval& t) const {
    const JetVector direction = swing_.at(t);
    const Jet along = dot(constant(axis_.line), direction);
    const JetVector aside = axis_.across(direction);
    const Jet aside2 = square(aside[0]) + square(aside[1]) + square(aside[2]);
    const Interval rho = boost::numeric::sqrt(swing2_);
    const Jet height = along - Jet(mean_);
    const Jet one(1.0);
    const Jet below = upper_pole_ && along.value.lower() > 0 ? aside2 * inverse(one + along) : Jet(rho) - height;
    const Jet above = lower_pole_ && along.value.upper() < 0 ? aside2 * inverse(one - along) : Jet(rho) + height;
    const Jet depth = branch_ * root(below * above);
    Turns result;
    const Interval scale = 1.0 / swing2_;
    result.tool.cosine = scale * (a_ * height - b_ * depth);
    result.tool.sine = scale * (b_ * height + a_ * depth);
    const JetVector tilted =
        constant(along_) + result.tool.cosine * constant(across_) + result.tool.sine * constant(ahead_);
    const Jet scale2 = inverse(aside2);
    result.work.cosine = dot(tilted, aside) * scale2;
    result.work.sine = dot(cross(constant(axis_.line), tilted), aside) * scale2;
    return result;
  }

 private:
  Swing swing_;
  Axis axis_;
  IntervalVector along_;
  IntervalVector across_;
  IntervalVector ahead_;
  Interval mean_;
  Interval a_;
  Interval b_;
  Interval swing2_;
  bool upper_pole_;
  bool lower_pole_;
  double branch_;
};

// LiftedSwing in the plane of the work-side axis, on a machine whose tool reaches the pole p u_w, p = 1 or -1, but
// whose axes are not at right angles. φ is the signed angle from the direction to the pole, α that of u_t and t0, which
// is also that of u_t and the pole. In the isosceles triangle of u_t, the pole and the tilted direction, which stands
// by the turn δ from the pole,
//   sin(δ/2) = ± sin(φ/2) / sin α,   tan ψ = cos α tan(δ/2),
// where ψ is the angle between the base and its direction at the pole: the azimuth that the tilted direction has swung
// about p u_w. The work-side axis turns back by it; where the direction passes the pole both azimuths change by 180
// degrees, and the axis does not. From φ: cos²ψ = (1 - sin²(δ/2)) / cos²(φ/2).
class Meridian {
 public:
  Meridian(const Machine& machine, const model::LiftedSwing& swing, int pole)
      : pole_(pole),
        work_(turn_at(machine.work_side(), swing.start.work)),
        cosine_(enclosed(exact::dot(machine.tool_side().line, machine.heights().along))) {
    const Swing direction(swing.direction);
    rate_ = direction.rate();
    const IntervalVector axis = enclosed(machine.work_side().line);
    const Interval a = enclosed(machine.heights().a);
    const Interval b = enclosed(machine.heights().b);
    const Interval swing2 = enclosed(machine.heights().swing2);
    const Rounding upward;
    const double side = pole;
    const Interval rho = boost::numeric::sqrt(swing2);
    tool_ = {side * a / rho, side * b / rho};
    // Behind the pole φ is negative.
    double before = -1;
    if (swing.pole == 0) {
      phi_ = angle(side * dot(constant(axis), constant(direction.from())).value,
                   side * dot(constant(axis), constant(direction.ahead())).value);
      before = phi_.lower() > 0 ? 1 : -1;
    }
    scale_ = before * side * swing.branch / boost::numeric::sqrt(1.0 - boost::numeric::square(cosine_));
    const Turned start = swung(0.0).second;
    turned_back_ = {start.cosine.value, start.sine.value};
  }

  [[nodiscard]] Turns at(const Interval& t) const {
    const auto [delta, psi] = swung(t);
    const Turned by = turned_back_ + -psi;
    return {tool_ + delta, work_ + (pole_ > 0 ? by : -by)};
  }

 private:
  // δ and ψ.
  [[nodiscard]] std::pair<Turned, Turned> swung(const Interval& t) const {
    const Turned half = turning(t, phi_ / 2.0, -rate_ / 2.0);
    const Jet s = scale_ * half.sine;
    const Jet c = root(Jet(1.0) - square(s));
    const Jet scale = inverse(half.cosine);
    return {{Jet(1.0) - Interval(2.0) * square(s), Interval(2.0) * (s * c)}, {c * scale, cosine_ * s * scale}};
  }
  // Of the middles; they, the function and its result are off by a few ulps.
  static Interval angle(const Interval& x, const Interval& y) {
    constexpr double ulps = 16 * std::numeric_limits<double>::epsilon();
    return Interval(std::atan2(median(y), median(x))) + Interval(-ulps, ulps) +
           size(width(x) + width(y)) * Interval(-2, 2);
  }
  int pole_;
  Turned tool_;         // at the pole
  Turned work_;         // at the start
  Turned turned_back_;  // ψ there
  Interval phi_ = 0.0;  // there
  Interval rate_;       // radians
  Interval cosine_;     // of α
  Interval scale_;      // 1 / sin α, with the sign of the branch
};

}  // namespace

struct CurveBound::Motion {
  using Posture = std::variant<std::monostate, Even, Swing, Lifted, Meridian>;

  // Of the mechanism.
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
    Axis tool;
    Axis work;
    IntervalVector reference;
    IntervalVector table;
    IntervalVector table_step;
    IntervalVector head;
    IntervalVector head_step;
    IntervalVector origin;
    Turns frozen;
  };

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
    result.sagitta.rotary = std::max(result.sagitta.rotary, bound(size(degrees(second_of_angle(turned))) * eighth));
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

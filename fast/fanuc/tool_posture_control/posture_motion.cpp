// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/tool_posture_control/posture_motion.h"

#include <algorithm>
#include <cmath>

namespace toolcomp::fast {
namespace {

using Frame = PolarFrame::Constants<double>;

// An angle that is known to lie in (-180, 180) about `middle`, brought there by whole turns.
double about(double degrees, double middle) {
  if (degrees - middle > 180) return degrees - 360;
  if (degrees - middle <= -180) return degrees + 360;
  return degrees;
}

// Beyond so many degrees a position in double is too coarse for its sine.
constexpr double kWide = 512;

DoubleDouble degrees(Int128 units) {
  return to_double_double(units) / DoubleDouble{static_cast<double>(Count::kRestPerOne), 0};
}

// A position in double-double by its sine and cosine: what its double has lost.
DoubleDouble by_turn(double position, const SineCosine<double>& turn) {
  const SineCosine<double> at = sine_cosine(position);
  constexpr double kDegrees = 0x1.ca5dc1a63c1f8p+5;
  return quick_two_sum(position, (turn.sine * at.cosine - turn.cosine * at.sine) * kDegrees);
}

// 1 - cos psi and 1 + cos psi times sin a sin b: the distances of k from the ends of its reach.
struct Room {
  double above, below;
};
Room room(const Frame& c, double k, double n2) {
  // Near u_w and -u_w from the horizontal parts, which are small there: 1 - k = n2 / (1 + k). Elsewhere k is the
  // smaller of the two; with axes that are nearly parallel it is all there is.
  constexpr double kNearAxis = 0.5;
  return {std::max(0.0, k > kNearAxis ? n2 / (1 + k) - c.above : c.top - k),
          std::max(0.0, k < -kNearAxis ? n2 / (1 - k) - c.below : k - c.bottom)};
}

// The horizontal part of c(psi) for the sine of psi.
Vector2<double> lean(const Frame& c, const Room& room, double sin_psi) {
  const double x = room.above <= room.below ? c.skew + c.sc_per_ss * room.above : c.sum - c.sc_per_ss * room.below;
  return {x, -c.sa * sin_psi};
}

// Sines and cosines that are off the unit circle by what small angles between the axes enlarge: a step of Newton's.
inline void on_unit_circle(DoublePair& sine, DoublePair& cosine) {
  const DoublePair by = 1.5 - 0.5 * (sine * sine + cosine * cosine);
  sine *= by;
  cosine *= by;
}

// The mechanical angle of the work-side axis that turns `from` to `to`, horizontal vectors of one length.
SineCosine<double> between(const Vector2<double>& from, const Vector2<double>& to) {
  const double per_n2 = 1 / dot(to, to);
  return {cross(from, to) * per_n2, dot(from, to) * per_n2};
}

}  // namespace

void PostureMotion::set_ends(const Machine& machine, const Pose& start, const Pose& end) {
  machine_ = &machine;
  for (std::size_t i = 0; i < 2; ++i) {
    start_[i] = start.axis[i].degrees;
    end_[i] = end.axis[i].degrees;
  }
}

void PostureMotion::set_still(const Machine& machine, const Pose& pose) {
  law_ = Law::still;
  set_ends(machine, pose, pose);
  still_.degrees = start_;
  still_.turns = turns(pose);
  still_.tool = {pose.tool.unit[0], pose.tool.unit[1], pose.tool.unit[2]};
}

void PostureMotion::set_linear(const Machine& machine, const Pose& start, const Pose& end) {
  law_ = Law::linear;
  denominator_ = 0;
  set_ends(machine, start, end);
  const double first = std::max(std::abs(start_[0]), std::abs(end_[0]));
  const double second = std::max(std::abs(start_[1]), std::abs(end_[1]));
  wide_ = {first > kWide, second > kWide};
  if (std::max(first, second) <= kWide) [[likely]]
    return;
  for (std::size_t i = 0; i < 2; ++i) {
    if (!wide_[i]) continue;
    set_wide(wide_start_[i], start, i);
    set_wide(wide_end_[i], end, i);
  }
}

void PostureMotion::set_wide(WideEnd& to, const Pose& pose, std::size_t i) const {
  const RotaryPosition& rotary = pose.axis[i];
  constexpr double kReduced = 0x1p36;  // of sine_cosine
  to.by_turn = rotary.kind == RotaryPosition::Kind::inverse && std::abs(rotary.degrees) < kReduced;
  if (to.by_turn)
    to.turn = rotary.turn;
  else
    to.position = degrees(machine_->count(pose, i).units());
}

void PostureMotion::prepare_wide() {
  for (std::size_t i = 0; i < 2; ++i) {
    if (!wide_[i]) continue;
    const auto position = [](const WideEnd& end, double rounded) {
      return end.by_turn ? by_turn(rounded, end.turn) : end.position;
    };
    from_[i] = position(wide_start_[i], start_[i]);
    by_[i] = position(wide_end_[i], end_[i]) - from_[i];
  }
}

void PostureMotion::set_arc(Law law, const Machine& machine, const Pose& start, const Pose& end, int branch) {
  law_ = law;
  denominator_ = 0;
  set_ends(machine, start, end);
  branch_ = branch;
  start_seen_ = start.seen;
  end_seen_ = end.seen;
  start_psi_ = branch < 0 ? -std::abs(start.psi) : std::abs(start.psi);
  prepared_ = false;
}

void PostureMotion::set_circle(const Machine& machine, const Pose& start, const Pose& end, int branch, int azimuth) {
  set_arc(Law::circle, machine, start, end, branch);
  azimuth_ = azimuth;
}

void PostureMotion::set_meridian(const Machine& machine, const Pose& start, const Pose& end, int branch, int pole,
                                 const Vector2<double>& heading) {
  set_arc(Law::meridian, machine, start, end, branch);
  pole_ = pole;
  start_heading_ = heading;
}

void PostureMotion::refine_circle(const Vector3<DoubleDouble>& start_seen, const Vector3<DoubleDouble>& end_seen) {
  prepare();
  double radians = 0;
  const Vector3<double> side = side_of(start_seen, end_seen, radians);
  set_great_circle(nearest(start_seen), side, radians);
}

void PostureMotion::prepare() {
  prepared_ = true;
  double radians = 0;
  const Vector3<double> side = side_of(start_seen_, end_seen_, radians);
  set_great_circle(start_seen_, side, radians);
  const std::size_t t = machine_->tool_side();
  tool_base_ = start_[t] - machine_->sense(t) * start_psi_;
  if (law_ == Law::circle)
    prepare_circle();
  else
    prepare_meridian();
}

void PostureMotion::set_great_circle(const Vector3<double>& start, const Vector3<double>& side, double radians) {
  angle_.set(radians);
  seen_ = {start, side};
  const Frame& frame = machine_->polar().constants();
  reported_ = {machine_->in_frame(seen_back(frame, start)), machine_->in_frame(seen_back(frame, side))};
}

void PostureMotion::prepare_circle() {
  start_heading_ = {start_seen_.x, start_seen_.y};
  const PolarFrame& polar = machine_->polar();
  if (polar.orthogonal()) return;
  // From psi itself: on the edge of reach the height tells only half of the digits.
  const SineCosine<double> turn = sine_cosine(start_psi_);
  const Frame& c = polar.constants();
  start_lean_ = {c.skew + c.sc * (1 - turn.cosine), -c.sa * turn.sine};
}

void PostureMotion::prepare_meridian() {
  // h / g, from half of psi: h = 2 sin(psi/2) (sc sin(psi/2), -sa cos(psi/2)), or the same about -u_w.
  const SineCosine<double> half = sine_cosine(start_psi_ / 2);
  const Frame& c = machine_->polar().constants();
  start_lean_ = pole_ > 0 ? Vector2<double>{branch_ * c.sc * half.sine, -branch_ * c.sa * half.cosine}
                          : Vector2<double>{-c.sc * half.cosine, -c.sa * half.sine};
}

[[gnu::always_inline]] inline bool PostureMotion::goes_on(std::uint32_t numerator, std::uint32_t denominator) {
  // Afresh every eighth time: what is led on keeps within a few roundings.
  constexpr std::uint32_t kAfresh = 8;
  const bool next = denominator == denominator_ && numerator == numerator_ + 1 && numerator % kAfresh != 0;
  numerator_ = numerator;
  denominator_ = denominator;
  return next;
}

// Steps of sine and cosine are exact, or as small as the step, so that their product loses nothing.
[[gnu::always_inline]] inline bool PostureMotion::follow(DoublePair sine, DoublePair cosine) {
  const DoublePair ds = sine - sine_;
  const DoublePair dc = cosine - cosine_;
  const DoublePair by = ds * cosine_ - dc * sine_;
  const DoublePair chord = ds * ds + dc * dc;
  sine_ = sine;
  cosine_ = cosine;
  constexpr double kNear = 0x1p-12;  // chords of 1/64
  if (!goes_on_ || chord[0] > kNear || chord[1] > kNear) [[unlikely]]
    return false;
  // The arc sine in degrees: the next term is below 2^-52 of the first.
  constexpr double kDegrees = 0x1.ca5dc1a63c1f8p+5;
  const DoublePair z = by * by;
  psi_and_work_ += by * (kDegrees + z * (kDegrees / 6 + z * (kDegrees * (3.0 / 40) + z * (kDegrees * (15.0 / 336)))));
  return true;
}

[[gnu::always_inline]] inline void PostureMotion::set_angles(DoublePair sine, DoublePair cosine,
                                                             PostureSample& sample) const {
  const auto set = [&](std::size_t t, std::size_t w) {
    sample.degrees[t] = tool_base_ + machine_->sense(t) * psi_and_work_[0];
    sample.degrees[w] = start_[w] + machine_->sense(w) * psi_and_work_[1];
    machine_->set_turns({sine[0], cosine[0]}, {sine[1], cosine[1]}, sample.turns[t], sample.turns[w]);
  };
  // Not by index: a processor that reads back what it has just written to an address it had to compute waits.
  if (machine_->tool_side() == 0)
    set(0, 1);
  else
    set(1, 0);
}

// The azimuth from the start is as badly known as that of the start, which near the work-side axis is hardly at all;
// the turn of the work-side axis itself is known well wherever the tool is. Between them lie a few roundings of the
// former.
void PostureMotion::settle(PostureSample& sample) {
  constexpr double kDegrees = 0x1.ca5dc1a63c1f8p+5;
  const std::size_t w = machine_->work_side();
  const SineCosine<double>& turn = sample.turns[w];
  const SineCosine<double> at = sine_cosine(sample.degrees[w]);
  const double off = (turn.sine * at.cosine - turn.cosine * at.sine) * kDegrees;
  // What is only rounded stays: multiples of 90 are exact.
  constexpr double kRoundings = 0x1p-50;
  if (std::abs(off) <= kRoundings * std::max(std::abs(sample.degrees[w]), 64.0)) return;
  sample.degrees[w] += off;
  psi_and_work_[1] += machine_->sense(w) * off;
}

[[gnu::always_inline]] inline void PostureMotion::circle_at(const Vector3<double>& seen, PostureSample& sample) {
  const PolarFrame& polar = machine_->polar();
  const Frame& c = polar.constants();
  const Vector2<double> heading{seen.x, seen.y};
  const double n2 = dot(heading, heading);
  double width = 0;  // |sin psi|
  double cos_psi = 0;
  Vector2<double> leaned;
  SineCosine<double> work;
  if (polar.orthogonal()) {
    width = std::sqrt(n2);
    cos_psi = seen.z;
    const double scale = branch_ * width * (1 / n2);  // the quotient does not wait for the root
    work = {seen.x * scale, -seen.y * scale};
  } else {
    const Room space = room(c, seen.z, n2);
    width = std::sqrt(space.above * space.below) * c.per_ss;
    cos_psi = (seen.z - c.cc) * c.per_ss;
    leaned = lean(c, space, branch_ * width);
    work = between(leaned, heading);
  }
  DoublePair sine{branch_ * width, work.sine};
  DoublePair cosine{cos_psi, work.cosine};
  if (!polar.orthogonal()) on_unit_circle(sine, cosine);
  const bool led_on = follow(sine, cosine);
  if (!led_on) [[unlikely]] {
    const DoublePair angles = arctangent(DoublePair{width, cross(start_heading_, heading)},
                                         DoublePair{cos_psi, dot(start_heading_, heading)});
    const double swung = polar.orthogonal() ? 0 : arctangent(cross(start_lean_, leaned), dot(start_lean_, leaned));
    // V(t) turns one way about the work-side axis, by less than 180.
    psi_and_work_ = DoublePair{branch_ * angles[0], about(angles[1], 90.0 * azimuth_) - swung};
  }
  set_angles(sine, cosine, sample);
  if (!led_on) [[unlikely]]
    settle(sample);
}

void PostureMotion::at(std::uint32_t numerator, std::uint32_t denominator, PostureSample& sample) {
  switch (law_) {
    case Law::still:
      sample = still_;
      return;
    case Law::linear:
      linear_at(numerator, denominator, sample);
      return;
    case Law::circle:
    case Law::meridian:
      break;
  }
  if (!prepared_) prepare();
  goes_on_ = goes_on(numerator, denominator);
  const SineCosine<double> angle = angle_.at(numerator, denominator);
  if (law_ == Law::circle)
    circle_at(seen_.at(angle), sample);
  else
    meridian_at(seen_.at(angle), sample);
  if (machine_->reports_machine_directions()) [[unlikely]] {
    sample.tool = machine_->tool_at(sample.turns);
    return;
  }
  sample.tool.x = reported_.start.x * angle.cosine + reported_.side.x * angle.sine;
  sample.tool.y = reported_.start.y * angle.cosine + reported_.side.y * angle.sine;
  sample.tool.z = reported_.start.z * angle.cosine + reported_.side.z * angle.sine;
}

void PostureMotion::linear_at(std::uint32_t numerator, std::uint32_t denominator, PostureSample& sample) {
  const double t = static_cast<double>(numerator) / denominator;
  const DoublePair start{start_[0], start_[1]};
  const DoublePair end{end_[0], end_[1]};
  const DoublePair degrees = start == end ? start : (1 - t) * start + t * end;
  const bool same_steps = denominator == denominator_;
  if (goes_on(numerator, denominator) && small_steps_) [[likely]] {
    // By the addition theorem.
    const DoublePair sine = sine_ - (sine_ * step_versine_ - cosine_ * step_sine_);
    cosine_ = cosine_ - (cosine_ * step_versine_ + sine_ * step_sine_);
    sine_ = sine;
  } else {
    if (!same_steps) {
      set_steps((end - start) / static_cast<double>(denominator));
      prepare_wide();
    }
    const SineCosine<DoublePair> turn = sine_cosine(degrees);
    sine_ = turn.sine;
    cosine_ = turn.cosine;
  }
  sample.degrees = {degrees[0], degrees[1]};
  sample.turns = apart(SineCosine<DoublePair>{sine_, cosine_});
  for (std::size_t i = 0; i < 2; ++i)
    if (wide_[i]) [[unlikely]]
      wide_at(i, DoubleDouble{static_cast<double>(numerator), 0} / DoubleDouble{static_cast<double>(denominator), 0},
              sample);
  sample.tool = machine_->tool_at(sample.turns);
}

void PostureMotion::set_steps(DoublePair degrees) {
  constexpr double kSmall = 4;  // their own error counts little
  small_steps_ = std::abs(degrees[0]) < kSmall && std::abs(degrees[1]) < kSmall;
  if (!small_steps_) return;
  const DoublePair half = sine_cosine(degrees * 0.5).sine;
  step_sine_ = sine_cosine(degrees).sine;
  step_versine_ = 2.0 * half * half;
}

void PostureMotion::wide_at(std::size_t i, const DoubleDouble& t, PostureSample& sample) const {
  const DoubleDouble position = from_[i] + by_[i] * t;
  sample.degrees[i] = position.hi;
  sample.turns[i] = sine_cosine(to_double(position - two_product(360, nearest_whole(position.hi / 360))));
}

PostureMotion::OnMeridian PostureMotion::on_meridian(const Vector3<double>& seen) const {
  const Frame& c = machine_->polar().constants();
  const double k = seen.z;
  // The horizontal distance from the axis: negative behind it. Both azimuths keep their side: h / g has no jump.
  const double g = seen.x * start_heading_.x + seen.y * start_heading_.y;
  const double slope =
      pole_ > 0 ? std::sqrt(std::max(0.0, k - c.bottom) / (1 + k)) : std::sqrt(std::max(0.0, c.top - k) / (1 - k));
  const double across = pole_ > 0 ? c.sc * g / (1 + k) : -c.sc * g / (1 - k);
  return {branch_ * g * slope / c.ss, {across / c.ss, -c.sa * branch_ * slope / c.ss}};
}

void PostureMotion::meridian_at(const Vector3<double>& seen, PostureSample& sample) {
  const Frame& c = machine_->polar().constants();
  const auto [sin_psi, leaned] = on_meridian(seen);
  const double cos_psi = (seen.z - c.cc) / c.ss;
  const double n = std::sqrt(dot(leaned, leaned));
  DoublePair sine{sin_psi, cross(leaned, start_heading_) / n};
  DoublePair cosine{cos_psi, dot(leaned, start_heading_) / n};
  on_unit_circle(sine, cosine);
  const bool led_on = follow(sine, cosine);
  if (!led_on) [[unlikely]] {
    const DoublePair angles =
        arctangent(DoublePair{sin_psi, cross(start_lean_, leaned)}, DoublePair{cos_psi, dot(start_lean_, leaned)});
    // Behind -u_w psi goes on beyond 180.
    psi_and_work_ = DoublePair{pole_ < 0 ? about(angles[0], 180 * branch_) : angles[0], -angles[1]};
  }
  set_angles(sine, cosine, sample);
  if (!led_on) [[unlikely]]
    settle(sample);
}

}  // namespace toolcomp::fast

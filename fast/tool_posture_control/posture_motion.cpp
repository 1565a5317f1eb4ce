#include "fast/tool_posture_control/posture_motion.h"

#include <algorithm>
#include <cmath>

#include "fast/fault.h"

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

// 1 - cos psi and 1 + cos psi times sin a sin b: the distances of k from the ends of its reach.
struct Room {
  double above, below;
};
Room room(const Frame& c, double k, double n2) {
  // Near u_w and -u_w from the horizontal parts, which are small there: 1 - k = n2 / (1 + k).
  return {std::max(0.0, k > 0 ? n2 / (1 + k) - c.above : c.top - k),
          std::max(0.0, k < 0 ? n2 / (1 - k) - c.below : k - c.bottom)};
}

// The horizontal part of c(psi) for the sine of psi.
Vector2<double> lean(const Frame& c, const Room& room, double sin_psi) {
  const double x = room.above <= room.below ? c.skew + c.sc * room.above / c.ss : c.sum - c.sc * room.below / c.ss;
  return {x, -c.sa * sin_psi};
}

// The mechanical angle of the work-side axis that turns `from` to `to`, horizontal vectors of one length.
SineCosine<double> between(const Vector2<double>& from, const Vector2<double>& to) {
  const double n2 = dot(to, to);
  return {cross(from, to) / n2, dot(from, to) / n2};
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
  set_ends(machine, start, end);
  for (std::size_t i = 0; i < 2; ++i) {
    wide_[i] = std::abs(start_[i]) > kWide || std::abs(end_[i]) > kWide;
    if (!wide_[i]) continue;
    const Int128 from = machine.count(start, i).units();
    from_[i] = degrees(from);
    by_[i] = degrees(machine.count(end, i).units() - from);
  }
}

void PostureMotion::set_arc(Law law, const Machine& machine, const Pose& start, const Pose& end, int branch) {
  law_ = law;
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

void PostureMotion::at(std::uint32_t numerator, std::uint32_t denominator, PostureSample& sample) {
  if (fault(Fault::tip_sample_from_the_end)) numerator = denominator - numerator;
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
  const SineCosine<double> angle = angle_.at(numerator, denominator);
  if (law_ == Law::circle)
    circle_at(seen_.at(angle), sample);
  else
    meridian_at(seen_.at(angle), sample);
  sample.tool = machine_->reports_machine_directions() ? machine_->tool_at(sample.turns) : reported_.at(angle);
}

void PostureMotion::linear_at(std::uint32_t numerator, std::uint32_t denominator, PostureSample& sample) const {
  const double t = static_cast<double>(numerator) / denominator;
  for (std::size_t i = 0; i < 2; ++i)
    sample.degrees[i] = start_[i] == end_[i] ? start_[i] : (1 - t) * start_[i] + t * end_[i];
  sample.turns = apart(sine_cosine(DoublePair{sample.degrees[0], sample.degrees[1]}));
  for (std::size_t i = 0; i < 2; ++i)
    if (wide_[i]) [[unlikely]]
      wide_at(i, DoubleDouble{static_cast<double>(numerator), 0} / DoubleDouble{static_cast<double>(denominator), 0},
              sample);
  sample.tool = machine_->tool_at(sample.turns);
}

void PostureMotion::wide_at(std::size_t i, const DoubleDouble& t, PostureSample& sample) const {
  const DoubleDouble position = from_[i] + by_[i] * t;
  sample.degrees[i] = position.hi;
  sample.turns[i] = sine_cosine(to_double(position - two_product(360, nearest_whole(position.hi / 360))));
}

void PostureMotion::circle_at(const Vector3<double>& seen, PostureSample& sample) const {
  const PolarFrame& polar = machine_->polar();
  const Frame& c = polar.constants();
  const std::size_t t = machine_->tool_side();
  const std::size_t w = machine_->work_side();
  const Vector2<double> heading{seen.x, seen.y};
  const double n2 = dot(heading, heading);
  double width = 0;  // |sin psi|
  double cos_psi = 0;
  SineCosine<double> work;
  double swung = 0;
  if (polar.orthogonal()) {
    width = std::sqrt(n2);
    cos_psi = seen.z;
    const double scale = branch_ / width;
    work = {seen.x * scale, -seen.y * scale};
  } else {
    const Room space = room(c, seen.z, n2);
    width = std::sqrt(space.above * space.below) / c.ss;
    cos_psi = (seen.z - c.cc) / c.ss;
    const Vector2<double> leaned = lean(c, space, branch_ * width);
    work = between(leaned, heading);
    swung = arctangent(cross(start_lean_, leaned), dot(start_lean_, leaned));
  }
  const DoublePair angles =
      arctangent(DoublePair{width, cross(start_heading_, heading)}, DoublePair{cos_psi, dot(start_heading_, heading)});
  // V(t) turns one way about the work-side axis, by less than 180.
  const double turned = about(angles[1], 90.0 * azimuth_) - swung;
  sample.degrees[t] = tool_base_ + machine_->sense(t) * branch_ * angles[0];
  sample.degrees[w] = start_[w] + machine_->sense(w) * turned;
  sample.turns = machine_->turns_of<double>({branch_ * width, cos_psi}, work);
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

void PostureMotion::meridian_at(const Vector3<double>& seen, PostureSample& sample) const {
  const Frame& c = machine_->polar().constants();
  const auto [sin_psi, leaned] = on_meridian(seen);
  const double cos_psi = (seen.z - c.cc) / c.ss;
  const DoublePair angles =
      arctangent(DoublePair{sin_psi, cross(start_lean_, leaned)}, DoublePair{cos_psi, dot(start_lean_, leaned)});
  // Behind -u_w psi goes on beyond 180.
  const double psi = pole_ < 0 ? about(angles[0], 180 * branch_) : angles[0];
  const std::size_t t = machine_->tool_side();
  const std::size_t w = machine_->work_side();
  sample.degrees[t] = tool_base_ + machine_->sense(t) * psi;
  sample.degrees[w] = start_[w] - machine_->sense(w) * angles[1];
  const double n = std::sqrt(dot(leaned, leaned));
  sample.turns = machine_->turns_of<double>({sin_psi, cos_psi},
                                            {cross(leaned, start_heading_) / n, dot(leaned, start_heading_) / n});
}

}  // namespace toolcomp::fast

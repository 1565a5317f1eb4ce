// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/cutter_compensation_b/cutter_compensation_b.h"

#include <cmath>

#include "fast/fanuc/cutter_compensation_b/arc_in_doubles.h"
#include "fast/fanuc/program/arc.h"

namespace toolcomp::fast {
namespace {

const DoubleDouble kUnitsPerOne = to_double_double(Count::kRestPerOne);

DoubleDouble fine_units(const Count& value) { return to_double_double(value.units()); }

// Left of a direction, of any length: few digits as whole numbers, which doubles hold.
std::array<DoubleDouble, 2> left_normal(const std::array<Count, 2>& direction) {
  const auto is_few = [](const Count& way) { return way.is_small() && Count::is_small(way.small()); };
  if (is_few(direction[0]) && is_few(direction[1]))
    return {DoubleDouble{static_cast<double>(-direction[1].small())},
            DoubleDouble{static_cast<double>(direction[0].small())}};
  return {-fine_units(direction[1]), fine_units(direction[0])};
}

DoubleDouble squared(const std::array<DoubleDouble, 2>& v) { return v[0] * v[0] + v[1] * v[1]; }

// What is left of a difference that would be zero in exact numbers: heads are sums of at most three terms, each within
// 2^-101 of the scale (a root and a quotient at 5u^2 and the rounding of the operands), their products within 2^-98 of
// its square.
constexpr double kTie = 0x1p-96;
bool vanishes(const DoubleDouble& value, double scale) { return std::abs(value.hi) <= kTie * scale; }

}  // namespace

CutterCompensationB::CutterCompensationB(const spec::Setup& /*setup*/, EventSink& sink) : sink_(sink) {}

CutterCompensationB::Fine CutterCompensationB::Vector::fine() const {
  if (zero()) return {};
  const DoubleDouble factor = fine_units(length) / sqrt(squared(normal));
  return {normal[0] * factor, normal[1] * factor};
}

CutterCompensationB::Vector CutterCompensationB::vector_along(const Fine& normal, const Count& length) {
  Vector made;
  made.normal = normal;
  made.length = length;
  if (made.zero()) return made;
  const double x = normal[0].hi;
  const double y = normal[1].hi;
  const double factor = length.nearest() / std::sqrt(x * x + y * y);
  made.value = {x * factor, y * factor};
  return made;
}

Alarm CutterCompensationB::check(const CutterCommand& command) const {
  const bool another_number = command.d_word && command.d != d_;
  if (command.corner_arc) {
    const bool format = command.word != CutterSide::unchanged || another_number || command.outside_word;
    if (!active_ || !made_ || format || command.no_direction) return AlarmCause::corner_arc;
  }
  if (!command.arc) return AlarmCause::none;
  switch (command.word) {
    case CutterSide::left:
    case CutterSide::right:
      return AlarmCause::arc_at_start_or_cancel;
    case CutterSide::off:
      return vector_.zero() ? AlarmCause::none : AlarmCause::arc_at_start_or_cancel;
    case CutterSide::unchanged:
      break;
  }
  return active_ && (another_number || !made_) ? AlarmCause::arc_at_start_or_cancel : AlarmCause::none;
}

// rho: the offset value under G41, its negative under G42.
Count CutterCompensationB::signed_offset() const {
  const bool right = block_.side == CutterSide::right;
  return right ? -block_.offset : block_.offset;
}

StageEnd CutterCompensationB::block() {
  const bool cancels = block_.word == CutterSide::off;
  active_ = block_.side != CutterSide::off;
  d_ = block_.d;
  if (cancels) {
    cancel();
    return {};
  }
  switch (block_.motion) {
    case CutterMotion::line:
    case CutterMotion::zero:
      straight();
      break;
    case CutterMotion::arc:
      if (const Alarm a = arc()) return {a, nullptr, block_.event.line, block_.event.n};
      break;
    case CutterMotion::corner_arc:
      corner_arc();
      break;
    case CutterMotion::to_machine:
    case CutterMotion::to_intermediate:
    case CutterMotion::to_reference:
    case CutterMotion::from_intermediate:
    case CutterMotion::from_reference:
      if (block_.named != 0) {
        vector_ = Vector{};
        made_ = false;
      }
      send(vector_, true);
      break;
    case CutterMotion::still:
    case CutterMotion::shift:
      send(vector_, block_.own);
      break;
  }
  return {};
}

// A block with an axis word of the plane: the vector at its end, from I J or the block's own travel.
void CutterCompensationB::straight() {
  const bool given = block_.has_direction;
  std::array<Count, 2> direction;
  for (std::size_t i = 0; i < 2; ++i) direction[i] = given ? block_.direction[i] : block_.end[i] - block_.start[i];
  if (!direction[0].is_zero() || !direction[1].is_zero()) {
    vector_ = vector_along(left_normal(direction), signed_offset());
    if (!made_) block_.event.cause = spec::Cause::start_up;
    made_ = true;
  }
  send(vector_, true);
}

// The vector at the end of an arc lies on the line of centre and end.
Alarm CutterCompensationB::arc() {
  if (arc_in_doubles()) return AlarmCause::none;
  const ArcWords words{block_.clockwise, block_.by_radius, block_.to_center, block_.radius};
  const Fine center = fine_center(block_.start, block_.end, words);  // from the start
  Fine end;
  for (std::size_t i = 0; i < 2; ++i) end[i] = fine_units(block_.end[i] - block_.start[i]) - center[i];
  if (!block_.by_radius && block_.start[0] + block_.to_center[0] == block_.end[0] &&
      block_.start[1] + block_.to_center[1] == block_.end[1])
    return AlarmCause::arc_ends_in_center;
  const Fine normal = block_.clockwise ? end : Fine{-end[0], -end[1]};
  const Vector made = vector_along(normal, signed_offset());
  const Fine old_vector = vector_.fine();
  const Fine new_vector = made.fine();
  Fine old_head;
  Fine new_head;
  for (std::size_t i = 0; i < 2; ++i) {
    old_head[i] = old_vector[i] - center[i];
    new_head[i] = end[i] + new_vector[i];
  }
  const DoubleDouble scale =
      sqrt(squared(center)) + sqrt(squared(end)) + sqrt(squared(old_vector)) + sqrt(squared(new_vector));
  set_tool_arc(old_head, new_head, scale);
  vector_ = made;
  send(vector_, true);
  return AlarmCause::none;
}

bool CutterCompensationB::arc_in_doubles() {
  if (block_.by_radius) return false;
  WholePair from{};
  WholePair to{};
  for (std::size_t i = 0; i < 2; ++i) {
    const Count& start = block_.start[i];
    const Count& end = block_.end[i];
    const Count& to_center = block_.to_center[i];
    if (!start.is_small() || !end.is_small() || !to_center.is_small()) return false;
    from[i] = -to_center.small();
    to[i] = end.small() - start.small() - to_center.small();
  }
  const Count length = signed_offset();
  const DoublePair vector{vector_.value[0], vector_.value[1]};
  ArcInDoubles arc;
  if (!make_arc_in_doubles(from, to, block_.clockwise ? -1 : 1, vector, length.nearest(), arc)) return false;
  block_.event.arc->sweep = arc.sweep;
  const DoublePair& radius = arc.radius;
  block_.event.arc->radius = {radius[0], radius[1]};
  set_vector(arc.vector, arc.normal, length);
  send(vector_, true);
  return true;
}

void CutterCompensationB::set_vector(DoublePair value, const WholePair& normal, const Count& length) {
  vector_.value = {value[0], value[1]};
  vector_.normal = {DoubleDouble{static_cast<double>(normal[0])}, DoubleDouble{static_cast<double>(normal[1])}};
  vector_.length = length;
}

// Sweep and radii of the tool's arc, heads from its centre.
void CutterCompensationB::set_tool_arc(const Fine& old_head, const Fine& new_head, const DoubleDouble& scale) {
  spec::Arc<double>& arc = *block_.event.arc;
  const double square = scale.hi * scale.hi;
  const auto in_center = [&](const Fine& head) { return vanishes(head[0], scale.hi) && vanishes(head[1], scale.hi); };
  arc.sweep.reset();
  if (!in_center(old_head) && !in_center(new_head)) {
    DoubleDouble along = old_head[0] * new_head[0] + old_head[1] * new_head[1];
    DoubleDouble across = old_head[0] * new_head[1] - old_head[1] * new_head[0];
    if (vanishes(along, square)) along = {};
    if (vanishes(across, square)) across = {};
    arc.sweep = positive_angle(along, arc.direction == spec::ArcDirection::cw ? -across : across);
  }
  const DoubleDouble first = squared(old_head);
  const DoubleDouble last = squared(new_head);
  arc.radius.reset();
  if (!vanishes(last - first, square))
    arc.radius = {to_double(sqrt(first) / kUnitsPerOne), to_double(sqrt(last) / kUnitsPerOne)};
}

// G39: an arc about the programmed point, to a vector at right angles to the direction.
void CutterCompensationB::corner_arc() {
  const Count length = signed_offset();
  const Vector made = vector_along(left_normal(block_.direction), length);
  const Fine old_vector = vector_.fine();
  const Fine new_vector = made.fine();
  const DoubleDouble scale = sqrt(squared(old_vector)) + sqrt(squared(new_vector));
  const bool same =
      vanishes(new_vector[0] - old_vector[0], scale.hi) && vanishes(new_vector[1] - old_vector[1], scale.hi);
  vector_ = made;
  if (same) {
    send(vector_, block_.own);
    return;
  }
  Event& event = block_.event;
  event.type = spec::MoveType::arc;
  event.cause = spec::Cause::corner;
  event.feed = block_.feed;
  event.arc.emplace();
  event.arc->plane = block_.plane;
  const bool clockwise = Count() < length;
  event.arc->direction = clockwise ? spec::ArcDirection::cw : spec::ArcDirection::ccw;
  for (const std::size_t axis : block_.axis) event.arc->center.set(axis, event.point.value[axis]);
  set_tool_arc(old_vector, new_vector, scale);
  send(vector_, true);
}

// G40 removes the vector at once; alone it moves the tool back.
void CutterCompensationB::cancel() {
  const bool machine = block_.motion >= CutterMotion::to_machine && block_.motion <= CutterMotion::from_reference;
  const bool still = block_.motion == CutterMotion::still || block_.motion == CutterMotion::shift;
  const bool alone = still && !block_.axis_word;
  const bool back = alone && !vector_.zero();
  if (back && block_.motion == CutterMotion::shift) block_.event = block_.renamed;
  if (!machine && (alone ? back : made_)) block_.event.cause = spec::Cause::cancel;
  vector_ = Vector{};
  made_ = false;
  send(vector_, block_.own || back);
}

void CutterCompensationB::send(const Vector& vector, bool own) {
  Event& event = block_.event;
  if (own) {
    if (!vector.zero())
      for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t axis = block_.axis[i];
        event.point.value[axis] += vector.value[i];
        event.axes.value[axis] += vector.value[i];
        event.machine.value[axis] += vector.value[i];  // read only where present
      }
    sink_.on(event);
  }
  if (!block_.sets) return;
  setting_.kind = spec::EventKind::setting;
  setting_.line = event.line;
  setting_.n = event.n;
  setting_.setting = block_.setting;
  setting_.value = block_.setting_value;
  sink_.on(setting_);
}

}  // namespace toolcomp::fast

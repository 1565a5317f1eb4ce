// SPDX-License-Identifier: Apache-2.0
#include "c/events.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>

#include "spec/language/alarm.h"

namespace toolcomp::c {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// The numbers of the header are those of the enumerations.
template <class Ours, class Theirs>
Theirs same(Ours ours) {
  return static_cast<Theirs>(static_cast<std::underlying_type_t<Ours>>(ours));
}
static_assert(static_cast<int>(spec::EventKind::undecided) == TOOLCOMP_UNDECIDED);
static_assert(static_cast<int>(spec::EventKind::not_judged) == TOOLCOMP_NOT_JUDGED);
static_assert(static_cast<int>(spec::EventKind::hole) == TOOLCOMP_HOLE);
static_assert(static_cast<int>(spec::EventKind::sample) == TOOLCOMP_SAMPLE);
static_assert(static_cast<int>(spec::MoveType::arc) == TOOLCOMP_ARC);
static_assert(static_cast<int>(spec::Cause::measure) == TOOLCOMP_MEASURE);
static_assert(static_cast<int>(spec::Cause::cancel) == TOOLCOMP_CANCEL);
static_assert(static_cast<int>(spec::Plane::yz) == TOOLCOMP_YZ);
static_assert(static_cast<int>(spec::ArcDirection::ccw) == TOOLCOMP_CCW);
static_assert(spec::kMaxAxes == TOOLCOMP_MOST_AXES);

void put(double (&to)[TOOLCOMP_MOST_AXES], const spec::AxisValues<double>& from) {
  for (std::size_t i = 0; i < TOOLCOMP_MOST_AXES; ++i) to[i] = from.has(i) ? from.value[i] : kNone;
}
void put(double (&to)[3], const std::array<double, 3>& from) { std::ranges::copy(from, to); }

void put_arc(toolcomp_event& out, const std::optional<spec::Arc<double>>& arc) {
  put(out.center, arc ? arc->center : spec::AxisValues<double>{});
  out.plane = arc ? same<spec::Plane, toolcomp_plane>(arc->plane) : TOOLCOMP_XY;
  out.direction = arc ? same<spec::ArcDirection, toolcomp_direction>(arc->direction) : TOOLCOMP_CW;
  out.sweep = arc && arc->sweep ? *arc->sweep : kNone;
  out.radius[0] = arc && arc->radius ? arc->radius->first : kNone;
  out.radius[1] = arc && arc->radius ? arc->radius->second : kNone;
}

void put_space(toolcomp_event& out, const std::optional<spec::SpaceCompensation<double>>& space) {
  constexpr std::array<double, 3> kNothing{kNone, kNone, kNone};
  put(out.tool_center, space ? space->tool_center : kNothing);
  put(out.shift, space ? space->shift : kNothing);
  put(out.tool_shift, space ? space->tool_shift : kNothing);
  put(out.contact, space && space->contact ? space->contact->point : kNothing);
  put(out.normal, space && space->contact ? space->contact->normal : kNothing);
}

}  // namespace

void CallbackSink::on(const fast::Event& event) {
  if (on_event_ == nullptr) return;
  const bool setting = event.kind == spec::EventKind::setting;
  const std::string number((setting ? event.setting : event.number).view());
  toolcomp_event out;
  out.size = sizeof out;
  out.kind = same<spec::EventKind, toolcomp_event_kind>(event.kind);
  out.line = event.line;
  out.n = event.n.value_or(TOOLCOMP_NO_NUMBER);
  out.type = same<spec::MoveType, toolcomp_move_type>(event.type);
  out.cause = same<spec::Cause, toolcomp_cause>(event.cause);
  put(out.programmed, event.programmed);
  put(out.point, event.point);
  put(out.axes, event.axes);
  put(out.machine, event.machine);
  put(out.tool_axis, event.tool_axis.value_or(std::array<double, 3>{kNone, kNone, kNone}));
  out.feed = event.feed.value_or(kNone);
  out.t_numerator = event.t_numerator;
  out.t_denominator = event.t_denominator;
  put_arc(out, event.arc);
  put_space(out, event.space);
  out.number = number.c_str();
  out.message = event.message;
  out.alarm = event.alarm == spec::AlarmCause::none ? "" : info(event.alarm).name.data();
  out.point_r = event.hole ? event.hole->point_r : kNone;
  out.bottom = event.hole ? event.hole->bottom : kNone;
  out.level = event.hole ? event.hole->level : kNone;
  out.value = setting ? event.value : kNone;
  on_event_(user_, &out);
}

}  // namespace toolcomp::c

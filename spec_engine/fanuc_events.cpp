// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cstddef>
#include <cstdint>

#include "spec/language/axes.h"
#include "spec_engine/events.h"
#include "spec_engine/positions.h"

namespace toolcomp::spec_engine {
namespace {

using exact::Real;
using Event = spec::Event<Real>;

// The travels of FanucCase.v.
enum Travel : std::int64_t { kRapid, kLinear, kClockwise, kCounterclockwise };

spec::Arc<Real> arc_of(const List& data, std::int64_t travel, const spec::Axes& axes) {
  constexpr std::array<const char*, 3> kAxes{"XY", "ZX", "YZ"};
  spec::Arc<Real> arc;
  const auto plane = static_cast<std::size_t>(data.at(1).integer());
  for (std::size_t i = 0; i < 2; ++i)  // a machine may lack an axis of the plane
    if (const char letter = kAxes.at(plane)[i]; axes.has(letter))
      arc.center.set(axes.index(letter), data.at(0).list().at(i).number());
  arc.plane = static_cast<spec::Plane>(plane);
  arc.direction = travel == kClockwise ? spec::ArcDirection::cw : spec::ArcDirection::ccw;
  if (const List& sweep = data.at(2).list(); !sweep.empty()) arc.sweep = sweep[0].number();
  if (const List& radii = data.at(3).list(); !radii.empty())
    arc.radius = {radii[0].list().at(0).number(), radii[0].list().at(1).number()};
  return arc;
}

// The fields of a move, in the order of FanucCase.v, behind place and kind.
void read_move(Event& event, const List& data, const spec::Axes& axes) {
  const std::int64_t travel = data.at(2).integer();
  event.type = travel == kRapid    ? spec::MoveType::rapid
               : travel == kLinear ? spec::MoveType::linear
                                   : spec::MoveType::arc;
  event.cause = static_cast<spec::Cause>(data.at(3).integer());
  event.programmed = linear_positions(data.at(4), axes);
  event.point = linear_positions(data.at(5), axes);
  event.axes = positions(data.at(6), axes);
  if (const List& machine = data.at(7).list(); !machine.empty()) event.machine = positions(machine[0], axes);
  if (const List& arc = data.at(8).list(); !arc.empty()) event.arc = arc_of(arc[0].list(), travel, axes);
  if (const List& feed = data.at(9).list(); !feed.empty()) event.feed = feed[0].number();
  if (const List& tool = data.at(10).list(); !tool.empty()) event.tool_axis = vector_of(tool[0]);
}

enum EventOf : std::int64_t { kMoves, kSetting, kRaised, kNotDecided, kWarned, kSampled, kDrilled };

void read_sample(Event& event, const List& data, const spec::Axes& axes) {
  event.kind = spec::EventKind::sample;
  event.t_numerator = static_cast<std::uint32_t>(data.at(2).integer());
  event.t_denominator = static_cast<std::uint32_t>(data.at(3).integer());
  event.point = linear_positions(data.at(4), axes);
  event.axes = positions(data.at(5), axes);
  event.tool_axis = vector_of(data.at(6));
}

}  // namespace

spec::Event<exact::Real> fanuc_event(const List& data, const spec::Axes& axes) {
  Event event;
  switch (data.at(1).integer()) {
    case kMoves:
      read_move(event, data, axes);
      break;
    case kSampled:
      read_sample(event, data, axes);
      break;
    case kDrilled:
      event.axes = positions(read_hole(event, data, axes), axes);
      break;
    case kSetting:
      event.kind = spec::EventKind::setting;
      event.setting = spec::Name(data.at(2).text());
      event.value = data.at(3).number();
      break;
    case kRaised:
    case kWarned:
      event.kind = data.at(1).integer() == kRaised ? spec::EventKind::alarm : spec::EventKind::warning;
      event.number = spec::Name(data.at(2).text());
      break;
    default:
      event.kind = spec::EventKind::undecided;
      event.permitted = {true, true, true};
      event.number = spec::Name(data.at(2).text());
  }
  return event;
}

}  // namespace toolcomp::spec_engine

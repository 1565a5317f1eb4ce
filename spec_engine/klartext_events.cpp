// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <cstdint>

#include "spec/language/axes.h"
#include "spec_engine/events.h"
#include "spec_engine/positions.h"

namespace toolcomp::spec_engine {
namespace {

using exact::Real;
using Event = spec::Event<Real>;

spec::Contact<Real> contact_of(const List& data) {
  spec::Contact<Real> contact{vector_of(data.at(0)), vector_of(data.at(1)), data.at(2).integer() != 0, {}};
  if (const List& angle = data.at(3).list(); !angle.empty()) contact.angle = angle[0].number();
  return contact;
}

// From a flag for each axis.
std::uint16_t mask_of(const List& flags) {
  std::uint16_t mask = 0;
  for (std::size_t i = 0; i < flags.size(); ++i)
    if (flags[i].integer() != 0) mask = static_cast<std::uint16_t>(mask | 1U << i);
  return mask;
}

// The fields of a move, in the order of KlartextCase.v, behind place and kind. Where an axis is not known the lists for
// what 3D compensation makes of the tool are empty.
void read_move(Event& event, const List& data, const spec::Axes& axes) {
  event.unknown = mask_of(data.back().list());
  std::size_t next = 2;
  const auto field = [&]() -> const Data& { return data.at(next++); };
  event.type = field().integer() != 0 ? spec::MoveType::rapid : spec::MoveType::linear;
  event.cause = static_cast<spec::Cause>(field().integer());
  event.programmed = linear_positions(field(), axes, event.unknown);
  event.point = linear_positions(field(), axes, event.unknown);
  const List& sent = field().list();
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (const List& here = sent.at(i).list(); !here.empty()) event.axes.set(i, here[0].number());
  event.tool_axis = vector_of(field());
  if (event.unknown == 0) {
    spec::SpaceCompensation<Real>& space = event.space.emplace();
    space.tool_center = vector_of(field());
    space.shift = vector_of(field());
    space.tool_shift = vector_of(field());
    if (const List& carrier = field().list(); !carrier.empty()) space.carrier = vector_of(carrier[0]);
    if (const List& contact = field().list(); !contact.empty()) space.contact = contact_of(contact[0].list());
  } else {
    constexpr std::size_t kFields = 5;
    next += kFields;
  }
  if (const List& f = field().list(); !f.empty()) event.feed = f[0].number();
}

// A hole has the number that it has in FanucCase.v.
enum EventOf : std::int64_t { kMoved = 0, kWarning = 1, kAlarm = 2, kOpen = 3, kOutOfScope = 4, kHole = 6 };

}  // namespace

spec::Event<exact::Real> klartext_event(const List& data, const spec::Axes& axes) {
  Event event;
  switch (data.at(1).integer()) {
    case kMoved:
      read_move(event, data, axes);
      break;
    case kWarning:
    case kAlarm:
      event.kind = data.at(1).integer() == kWarning ? spec::EventKind::warning : spec::EventKind::alarm;
      event.number = spec::Name(data.at(2).text());
      break;
    case kOpen:
      event.kind = spec::EventKind::undecided;
      event.permitted = {true, true, true};
      event.number = spec::Name(data.at(2).text());
      break;
    case kHole:
      event.axes = linear_positions(read_hole(event, data, axes), axes);
      break;
    default:
      event.kind = spec::EventKind::undecided;
      event.out_of_scope = true;
      event.number = "heidenhain.peripheral.out-of-scope";
  }
  return event;
}

}  // namespace toolcomp::spec_engine

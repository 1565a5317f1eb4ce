// SPDX-License-Identifier: Apache-2.0
// Events in room made beforehand.
#pragma once

#include "fast/basis/event.h"
#include "fast/heidenhain/program/motion.h"
#include "spec/language/alarm.h"
#include "spec/language/setup.h"

namespace toolcomp::fast::klartext {

// Where the tool stands against the programmed point. All vectors in X, Y, Z, units of the program.
struct Placement {
  Vector tool;        // unit, tip to carrier
  Vector tip;         // tip of the effective tool − programmed point
  Vector shift;       // of the tip against the nominal tool
  double corner = 0;  // tip to tool centre, along the tool
};

class EventWriter {
 public:
  EventWriter(const spec::Setup& setup, EventSink& sink);

  // A move of a block without contact. Where axes are unknown, without their coordinates and without vectors of the
  // tool (heidenhain.program.unknown-position).
  void move(const MoveHead& head, const Placement& placement, const ToolLength& length, spec::Cause cause);
  // One with the contact in contact().
  [[nodiscard]] spec::Contact<double>& contact() { return *contact_.space->contact; }
  [[gnu::always_inline]] void move_in_contact(const MoveHead& head, const Placement& placement,
                                              const ToolLength& length, spec::Cause cause) {
    send(contact_, head, placement, length, cause);
  }
  // A hole behind which the axes stand as `head` says.
  void hole(const MoveHead& head, const spec::Hole<double>& hole, const ToolLength& length);
  void warnings(const BlockHead& head, Warnings warnings);
  void undecided(const BlockHead& head);
  // `more`: a text that says more than the table of alarms; nullptr: none does.
  void alarm(const BlockHead& head, AlarmCause cause, const char* more = nullptr);

 private:
  [[gnu::always_inline]] void send(fast::Event& event, const MoveHead& head, const Placement& placement,
                                   const ToolLength& length, spec::Cause cause);
  [[gnu::always_inline]] void fill(fast::Event& event, const MoveHead& head, const Placement& placement,
                                   const ToolLength& length, spec::Cause cause);
  void move_to_unknown(const MoveHead& head, const Placement& placement, const ToolLength& length, spec::Cause cause);
  void other_axes(fast::Event& event, const MoveHead& head) const;
  void put_xyz(spec::AxisValues<double>& to, const Vector& v) const {
    if (in_order_) [[likely]] {
      std::memcpy(to.value.data(), &v.xy, sizeof v.xy);
      to.value[2] = v.z;
      return;
    }
    for (std::size_t i = 0; i < 3; ++i) to.value[xyz_[i]] = v[i];
  }
  void report(spec::EventKind kind, const BlockHead& head, std::string_view number, const char* message);

  EventSink& sink_;
  std::array<std::size_t, 3> xyz_;  // the axes X, Y, Z
  spec::AlarmNumbers numbers_;
  bool in_order_;  // they come first
  std::uint16_t linear_ = 0;
  std::uint16_t others_ = 0;  // linear axes but X, Y, Z
  fast::Event plain_;         // moves without contact
  fast::Event contact_;       // moves with one
  fast::Event hole_;
  fast::Event report_;
};

// v + length unit.
inline Vector along(const Vector& v, const Vector& unit, double length) { return v + unit * length; }

inline void EventWriter::send(fast::Event& event, const MoveHead& head, const Placement& placement,
                              const ToolLength& length, spec::Cause cause) {
  if (head.warnings != 0) [[unlikely]]
    warnings(head, head.warnings);
  fill(event, head, placement, length, cause);
  sink_.on(event);
}

inline void EventWriter::fill(fast::Event& event, const MoveHead& head, const Placement& placement,
                              const ToolLength& length, spec::Cause cause) {
  event.line = head.line;
  event.n = head.n;
  event.type = head.rapid ? spec::MoveType::rapid : spec::MoveType::linear;
  event.cause = cause;
  event.axes.present = static_cast<std::uint16_t>(linear_ | head.rotary);
  if (head.rapid)
    event.feed.reset();
  else
    event.feed = head.feed;
  if ((others_ | head.rotary) != 0) [[unlikely]]
    other_axes(event, head);
  spec::SpaceCompensation<double>& space = *event.space;
  const Vector& t = placement.tool;
  put(*event.tool_axis, t);
  const Vector& p = head.xyz;
  const Vector longer = t * length.length_delta;
  put_xyz(event.programmed, p);
  put_xyz(event.point, p + placement.tip);
  put_xyz(event.axes, p + (placement.tip + longer));
  put(space.tool_center, p + along(placement.tip, t, placement.corner));
  put(space.shift, placement.shift);
  put(space.tool_shift, placement.shift + longer);
  if (length.has_length) {
    if (!space.carrier) space.carrier.emplace();
    put(*space.carrier, p + along(placement.tip, t, length.length));
  } else {
    space.carrier.reset();
  }
}

}  // namespace toolcomp::fast::klartext

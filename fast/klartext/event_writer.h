// Events in room made beforehand.
#pragma once

#include "fast/engine.h"
#include "fast/klartext/motion.h"
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

  // The axes X, Y, Z.
  [[nodiscard]] const std::array<std::size_t, 3>& xyz() const { return xyz_; }
  // A move of a block without contact.
  void move(const MoveHead& head, const Placement& placement, const ToolValues& values, spec::Cause cause);
  // One with the contact in contact().
  [[nodiscard]] spec::Contact<double>& contact() { return *contact_.space->contact; }
  [[gnu::always_inline]] void move_in_contact(const MoveHead& head, const Placement& placement,
                                              const ToolValues& values, spec::Cause cause) {
    send(contact_, head, placement, values, cause);
  }
  void warnings(const BlockHead& head, Warnings warnings);
  void undecided(const BlockHead& head);
  void alarm(const BlockHead& head, std::string_view number, const char* message);

 private:
  [[gnu::always_inline]] void send(fast::Event& event, const MoveHead& head, const Placement& placement,
                                   const ToolValues& values, spec::Cause cause);
  void other_axes(fast::Event& event, const MoveHead& head) const;
  void report(spec::EventKind kind, const BlockHead& head, std::string_view number, const char* message);

  EventSink& sink_;
  std::array<std::size_t, 3> xyz_;
  std::uint16_t linear_ = 0;
  std::uint16_t others_ = 0;  // linear axes but X, Y, Z
  fast::Event plain_;         // moves without contact
  fast::Event contact_;       // moves with one
  fast::Event report_;
};

// v + length unit.
inline Vector along(const Vector& v, const Vector& unit, double length) { return v + unit * length; }

inline void EventWriter::send(fast::Event& event, const MoveHead& head, const Placement& placement,
                              const ToolValues& values, spec::Cause cause) {
  if (head.warnings != 0) [[unlikely]]
    warnings(head, head.warnings);
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
  const Vector p{head.position[xyz_[0]], head.position[xyz_[1]], head.position[xyz_[2]]};
  const Vector point = p + placement.tip;
  const Vector center = p + along(placement.tip, t, placement.corner);
  const Vector real = p + along(placement.tip, t, values.length_delta);
  for (std::size_t i = 0; i < 3; ++i) {
    event.programmed.value[xyz_[i]] = p[i];
    event.point.value[xyz_[i]] = point[i];
    event.axes.value[xyz_[i]] = real[i];
  }
  put(space.tool_center, center);
  put(space.shift, placement.shift);
  put(space.tool_shift, along(placement.shift, t, values.length_delta));
  if (values.has_length) {
    if (!space.carrier) space.carrier.emplace();
    put(*space.carrier, p + along(placement.tip, t, values.length));
  } else {
    space.carrier.reset();
  }
  sink_.on(event);
}

}  // namespace toolcomp::fast::klartext

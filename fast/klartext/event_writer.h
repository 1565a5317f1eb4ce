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
  void move_in_contact(const MoveHead& head, const Placement& placement, const ToolValues& values, spec::Cause cause);
  void warnings(const BlockHead& head, Warnings warnings);
  void undecided(const BlockHead& head);
  void alarm(const BlockHead& head, std::string_view number, const char* message);

 private:
  void send(fast::Event& event, const MoveHead& head, const Placement& placement, const ToolValues& values,
            spec::Cause cause);
  void report(spec::EventKind kind, const BlockHead& head, std::string_view number, const char* message);

  EventSink& sink_;
  std::array<std::size_t, 3> xyz_;
  std::uint16_t linear_ = 0;
  std::size_t count_;
  fast::Event plain_;    // moves without contact
  fast::Event contact_;  // moves with one
  fast::Event report_;
};

}  // namespace toolcomp::fast::klartext

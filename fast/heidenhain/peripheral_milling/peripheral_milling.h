// SPDX-License-Identifier: Apache-2.0
// Peripheral milling under RL and RR with TCPM: a stage that holds one block until the next motion is known
// (heidenhain.peripheral.*).
#pragma once

#include <array>
#include <cstdint>

#include "fast/heidenhain/peripheral_milling/lateral.h"
#include "fast/heidenhain/program/event_writer.h"

namespace toolcomp::fast::klartext {

class PeripheralMilling {
 public:
  explicit PeripheralMilling(EventWriter& writer) : writer_(writer) {}

  // A block is held: every motion needs its travel.
  [[nodiscard]] bool holds() const { return holds_; }
  // The block a geometry alarm names.
  [[nodiscard]] const BlockHead& held() const { return ring_[held_].head; }

  // The block to come, to be written.
  [[nodiscard]] PeripheralMotion& next() { return ring_[next_of(held_)]; }
  // next() is compensated: the one held is sent, and next() held.
  [[nodiscard]] Alarm hold();
  // A motion without this compensation follows, with the travel of next(): the block held is sent.
  [[nodiscard]] Alarm follow();
  // Nothing that moves follows: the block held, if any, is sent.
  [[nodiscard]] Alarm release();

 private:
  static std::uint8_t next_of(std::uint8_t slot) { return static_cast<std::uint8_t>(slot == 2 ? 0 : slot + 1); }
  [[nodiscard]] static Lateral lateral(const ToolVector& tool, const PeripheralMotion& motion);
  // Its direction into last_ and last_unit_; where there is none the one made last in this stretch stays, if any: else
  // false.
  [[gnu::always_inline]] [[nodiscard]] bool direct(const Lateral& made_from);
  [[nodiscard]] bool keep_direction();
  void keep(const Lateral& made_from, const Vector& unit);
  // Between a block and the coming one.
  [[gnu::always_inline]] [[nodiscard]] Alarm corner(const Lateral& own, const Lateral& coming, Vector& between);
  void send(const Vector& between);

  EventWriter& writer_;
  // The block before, the one held and the next: `last_` may point into the first two.
  std::array<PeripheralMotion, 3> ring_;
  std::uint8_t held_ = 0;
  bool holds_ = false;
  bool first_ = false;  // the one held is the first compensated block

  Lateral last_;  // made last in this stretch
  Vector last_unit_;
  struct {
    ToolVector tool;
    Displacement travel;
  } kept_;  // what last_ is made from, where it is used longer
};

}  // namespace toolcomp::fast::klartext

// SPDX-License-Identifier: Apache-2.0
// Leading edge offset G41.3 (fanuc.leading-edge.*): a stage that holds moves until their vector is known.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "fast/basis/alarm.h"
#include "fast/basis/event.h"
#include "fast/fanuc/leading_edge_offset/compensation_vector.h"
#include "fast/geometry/displacement.h"
#include "fast/geometry/vector3.h"
#include "fast/kinematics/kinematics.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// One move on its way through the stage. `event` is complete but for the compensation vector, which is added to
// `point` and `axes` when the move is sent on.
struct Move {
  Event event;
  Displacement displacement;             // of the block; set only while the mode is on
  const Direction* direction = nullptr;  // at the end of the block; set only while the mode is on
  double radius = 0;                     // offset value in force in the block
};

// Look-ahead: a start-up move, or a moving block and one block without movement after it. A second block without
// movement releases everything, so three moves are all that is ever kept.
class LeadingEdgeOffset {
 public:
  LeadingEdgeOffset(const spec::Setup& setup, const Kinematics& kinematics, EventSink& sink);
  // Where the moves go from here on. The stage holds none.
  void set_sink(EventSink& sink) { sink_ = &sink; }

  [[nodiscard]] bool active() const { return active_; }
  // The move to fill in next. It keeps what it held before: write every field.
  [[nodiscard]] Move& next() { return ring_[free_]; }

  // While the mode is off: sends next() on.
  void pass() { send(next(), {}); }
  // G41.3: next() is the start-up move, held until the block after it.
  void start();
  // A block in the mode; `own` if next() is a move of it, `moving` if it moves X, Y or Z by next().displacement.
  Alarm block(bool own, bool moving);
  // A block that keeps the control from reading ahead, an alarm, the end of the program: no further movement is known.
  Alarm release();
  // G40: everything held gets its vector. Then cancel(own): next() is a move of the G40 block if `own`.
  Alarm finish();
  void send_compensated() { send(next(), vector_); }
  // G40: next() is the cancel move.
  void cancel();

  // The block that a start-up alarm names.
  [[nodiscard]] std::uint64_t start_line() const { return start_line_; }
  [[nodiscard]] const std::optional<std::uint64_t>& start_n() const { return start_n_; }

 private:
  void hold() {
    held_[held_count_++] = free_;
    take_free();
  }
  void take_free();
  [[nodiscard]] Move& held() { return ring_[held_[0]]; }
  void send(Move& move, const Vector3<double>& vector);
  void send_held();
  // The vector of a move: `displacement` is that of the next one, or its own.
  Alarm update(const Displacement& displacement, const Direction& direction, double radius);

  const Kinematics& kinematics_;
  CompensationVector compensation_;
  EventSink* sink_;
  std::array<std::size_t, 3> xyz_;

  std::array<Move, 3> ring_;
  std::array<std::uint8_t, 2> held_{};
  std::uint8_t held_count_ = 0;
  std::uint8_t free_ = 0;

  bool active_ = false;
  bool starting_ = false;   // the start-up move is held
  std::uint8_t still_ = 0;  // blocks without movement since the last moving one, at most 2
  int backward_ = 1;        // the sense of the last computed vector: +1 backward, -1 forward
  Vector3<double> vector_;
  std::uint64_t start_line_ = 0;
  std::optional<std::uint64_t> start_n_;
};

[[gnu::always_inline]] inline Alarm LeadingEdgeOffset::update(const Displacement& displacement,
                                                              const Direction& direction, double radius) {
  const Lean lean = compensation_.lean(kinematics_, displacement, direction);
  // Near 0 and 180 degrees the vector is kept; a start-up has none to keep.
  if (lean.angle == AngleClass::near_0 || lean.angle == AngleClass::near_180) [[unlikely]]
    return starting_ ? AlarmCause::leading_edge_start : AlarmCause::none;
  if (lean.angle == AngleClass::near_90) {
    // The sense is inherited; without history that of the pair, backward at exactly 90 degrees.
    if (starting_) backward_ = CompensationVector::dot_sign(kinematics_, displacement, direction) >= 0 ? 1 : -1;
  } else {
    // Without a branch: angles follow no pattern.
    const bool above = lean.angle == AngleClass::above_90;
    backward_ = 1 - 2 * static_cast<int>(above);
  }
  vector_ = lean.backward * (backward_ * radius / lean.norm);
  return AlarmCause::none;
}

}  // namespace toolcomp::fast

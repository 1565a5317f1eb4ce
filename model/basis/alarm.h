// SPDX-License-Identifier: Apache-2.0
// How a block ends the run.
#pragma once

#include <cstdint>
#include <exception>
#include <memory>
#include <optional>

#include "model/basis/event.h"
#include "model/basis/recorder.h"
#include "spec/language/alarm.h"

namespace toolcomp::model {

using spec::AlarmCause;

// Ends the run with this alarm. The block at fault gives nothing else (docs/events.md, rules 4 and 5).
class Alarm : public std::exception {
 public:
  // `more`: a static text that says more than the table of alarms; nullptr if there is none.
  explicit Alarm(AlarmCause raised, const char* more = nullptr)
      : cause(raised), message(more != nullptr ? more : spec::info(raised).text) {}
  [[nodiscard]] const char* what() const noexcept override { return message; }

  AlarmCause cause;
  const char* message;     // static text
  std::uint64_t line = 0;  // of the block at fault; 0: the block being interpreted
  std::optional<std::uint64_t> n;
  std::shared_ptr<const Event> unmade;  // its move, if the moves before it were computed with it
  Real crossing;  // of interference: by how much the paths cross, in setup units; 0 if this is not a length
};

// The specification leaves open what a block does: the run ends with an `undecided` event that names the clause.
class LeftOpen : public std::exception {
 public:
  LeftOpen(Clause left_open_by, const char* text) : clause(left_open_by), message(text) {}
  [[nodiscard]] const char* what() const noexcept override { return message; }

  Clause clause;
  const char* message;     // static text: what is left open
  std::uint64_t line = 0;  // of the block; 0: the block being interpreted
  std::optional<std::uint64_t> n;
};

// Applies the clause that leaves it open, and ends the run there.
[[noreturn]] inline void leave_open(Recorder& recorder, Clause clause, const char* message) {
  recorder.reach(clause);
  throw LeftOpen(clause, message);
}

// The block is absent for those before it, and the clause stands alone: the run applies it at its end.
[[noreturn]] inline void leave_open_alone(Recorder& recorder, Clause clause, const char* message) {
  recorder.take_clauses();
  throw LeftOpen(clause, message);
}

// Applies the clause that states the alarm, and raises it.
[[noreturn]] inline void raise(Recorder& recorder, Clause clause, AlarmCause cause, const char* more = nullptr) {
  recorder.reach(clause);
  throw Alarm(cause, more);
}

}  // namespace toolcomp::model

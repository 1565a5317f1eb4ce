// SPDX-License-Identifier: Apache-2.0
// What a run gives: steps, alarms and what could not be decided, as events.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "model/basis/alarm.h"
#include "model/basis/event.h"
#include "model/basis/recorder.h"
#include "model/fanuc/program/step.h"
#include "model/fanuc/tool_center_point_control/tip_moves.h"
#include "spec/language/fanuc/block.h"

namespace toolcomp::model {

// Writes the events of one run to a sink, in their order (docs/events.md).
class Reporter {
 public:
  // `samples`: N of the fractions k/N inside blocks; 0: none. `motions`: null where nobody asks.
  Reporter(const spec::Setup& setup, Recorder& recorder, EventSink& sink, std::uint32_t samples, MotionSink* motions);
  Reporter(const Reporter&) = delete;
  Reporter& operator=(const Reporter&) = delete;

  // The block now read: what names no block of its own belongs to it.
  void at(const spec::Block& block);

  // Everything that a step makes: warning, moves, setting, alarm.
  void report(const Step& step);
  // The alarm that ends the run, and the clauses it rests on.
  void report(const Alarm& alarm, const spec::ClauseList& clauses);
  // The specification leaves it open; or the decision asked last could not be certified.
  void report(const LeftOpen& open, const spec::ClauseList& clauses);
  void report_undecided();

 private:
  // Of an alarm or of what is left open, in the block it names or in the one now read.
  template <class Fault>
  [[nodiscard]] Event fault_event(spec::EventKind kind, const Fault& fault, const spec::ClauseList& clauses) const;
  void report(const Move& move, std::shared_ptr<const InsideMove> inside);
  void report(Event sample);

  spec::Axes axes_;
  spec::AlarmNumbers numbers_;
  Recorder& recorder_;
  EventSink& sink_;
  MotionSink* motions_;
  TipMoves tip_moves_;
  const Step* step_ = nullptr;  // whose moves go out
  std::uint64_t line_ = 0;
  std::optional<std::uint64_t> n_;
};

}  // namespace toolcomp::model

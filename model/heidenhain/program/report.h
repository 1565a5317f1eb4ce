// SPDX-License-Identifier: Apache-2.0
// Events of a Klartext run.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "model/basis/alarm.h"
#include "model/basis/event.h"
#include "model/basis/recorder.h"
#include "model/heidenhain/program/compensated.h"
#include "model/heidenhain/program/motion.h"
#include "spec/language/setup.h"

namespace toolcomp::model::klartext {

// A block, as events name it.
struct Place {
  std::uint64_t line = 0;
  std::optional<std::uint64_t> n;
};

// The warnings of a motion and its move. Clause: heidenhain.program.length-along-the-tool.
void report_move(const Motion& motion, const Compensated& compensated, const spec::Setup& setup, EventSink& sink);
// Clause: heidenhain.program.length-along-the-tool.
void report_hole(const DrilledHole& hole, const spec::Setup& setup, EventSink& sink);
// The move of a motion that is not made (Event::unmade).
std::shared_ptr<const Event> unmade(const Motion& motion);
// The warnings of a motion whose compensation is not modelled, and the event that says so.
void report_out_of_scope(const Motion& motion, EventSink& sink);
void report_alarm(const Alarm& alarm, const spec::AlarmNumbers& numbers, const Place& current,
                  const spec::ClauseList& clauses, EventSink& sink);
void report_undecided(Recorder& recorder, const Place& current, EventSink& sink);

}  // namespace toolcomp::model::klartext

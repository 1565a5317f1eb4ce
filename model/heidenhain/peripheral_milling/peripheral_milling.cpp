// SPDX-License-Identifier: Apache-2.0
#include "model/heidenhain/peripheral_milling/peripheral_milling.h"

#include <utility>

#include "model/basis/alarm.h"
#include "model/heidenhain/program/report.h"

namespace toolcomp::model::klartext {

void PeripheralMilling::meet(const Motion& next) {
  release(&next);
  recorder_.at(next.line);
}

void PeripheralMilling::take(Motion motion) {
  held_is_first_ = !std::exchange(on_, true);
  held_ = std::move(motion);
}

bool PeripheralMilling::pass() { return std::exchange(on_, false); }

void PeripheralMilling::release(const Motion* next) {
  if (!held_) return;
  Motion motion = *std::exchange(held_, std::nullopt);
  recorder_.at(motion.line);
  recorder_.resume(std::move(motion.clauses));
  Compensated result;
  try {
    // heidenhain.program.length-along-the-tool: DL acts along the tool vector T. The axes of an event are the tip of a
    // tool of exactly the table length. The real tool is displaced by dL t from where it would be without deltas.
    recorder_.reach(Clause::heidenhain_program_length_along_the_tool);
    PeripheralEnd made = rules_.compensate(motion, next, held_is_first_, former_);
    result = std::move(made.end);
    former_ = std::move(made.latest);
  } catch (Alarm& alarm) {
    alarm.line = motion.line;
    alarm.n = motion.n;
    alarm.unmade = unmade(motion);
    throw;
  }
  if (next == nullptr || !next->is_peripheral()) former_.reset();
  result.cause = held_is_first_ ? spec::Cause::start_up : spec::Cause::programmed;
  motion.clauses = recorder_.take_clauses();
  output_(motion, result);
}

}  // namespace toolcomp::model::klartext

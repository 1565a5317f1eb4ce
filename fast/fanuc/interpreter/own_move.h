// A block's own move: its positions and its event.
#pragma once

#include "fast/fanuc/interpreter/interpreter.h"
#include "fast/fanuc/interpreter/usual_words.h"

namespace toolcomp::fast {

[[gnu::always_inline]] inline void Interpreter::fill_here(Event& event, spec::MoveType type, spec::Cause cause) {
  event.line = line_;
  event.n = n_;
  event.type = type;
  event.cause = cause;
  positions_.fill(event);
  event.t_numerator = 0;
  if (type != spec::MoveType::arc) event.arc.reset();
  if (type == spec::MoveType::rapid)
    event.feed.reset();
  else
    event.feed = modal_.feed();
  if (!positions_.along_tool() && !kinematics_.defined())
    event.tool_axis.reset();
  else
    attitude_.fill(event);
}

[[gnu::always_inline]] inline Alarm Interpreter::place_words(const Words& words, Mask axes) {
  if (attitude_.plans_tool()) [[unlikely]]
    return attitude_.place(words, axes);
  if (const Alarm a = positions_.place_words(words, axes, units_, modal_.incremental())) return a;
  if ((axes & axes_.turning) != 0) attitude_.turn();
  if (positions_.stale() != 0)
    if (const Alarm a = positions_.refresh()) return a;
  return alarm::kNone;
}

}  // namespace toolcomp::fast

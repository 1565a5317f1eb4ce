// The usual block: positions, F, G00 to G03 and the letters of an arc. Nothing of the modal state changes but feed and
// motion code, so that it needs neither check() nor apply().
#pragma once

#include "fast/basis/fault.h"
#include "fast/basis/short_cut.h"
#include "fast/fanuc/interpreter/interpreter.h"

namespace toolcomp::fast {

[[gnu::always_inline]] inline bool Interpreter::usual_block(const Words& words, Alarm& alarm) {
  // Nothing waits for a block to come.
  if (!is_open(ShortCut::block) || !words.plain() || positions_.length().pending()) [[unlikely]]
    return false;
  const Code code = words.code(Words::kMotion);
  const Code motion_after = code == kNone ? modal_.motion() : code;
  const auto take_modal_words = [&] {
    if (!fault(Fault::usual_block_motion_code)) modal_.set_motion(motion_after);
    if (words.has('F')) set_feed(words);
  };
  const auto uncompensated = [&] {
    return motion(words, leading_edge_.active() ? Compensation::stays : Compensation::off, true, false, std::nullopt);
  };
  const auto edited = [&] { return cutter_value_.takes_edited() && !fault(Fault::usual_block_edited_value); };
  const auto by_vector_alone = [&] {
    return (words.axes() & axes_.rotary) == 0 && ToolAttitude::names_direction(words);
  };
  const bool line = motion_after <= 10;
  if (positions_.along_tool()) {
    attitude_.set_sampled(true);
    if (!line) return false;
    if (attitude_.tip().active()) {
      if (edited() || !(modal_.by_vector() ? by_vector_alone() : !words.has_any(kArcLetters))) return false;
      take_modal_words();
      alarm = tool_side_on() ? tool_side_move(words) : uncompensated();
      return true;
    }
    if (tool_side_on()) {
      if (edited() || !by_vector_alone()) return false;
      take_modal_words();
      alarm = tool_side_move(words);
      return true;
    }
    if (attitude_.plans_tool() || cutter_active() || !by_vector_alone()) return false;
    take_modal_words();
    attitude_.directions().begin_block();
    attitude_.direct(words);
    alarm = uncompensated();
    return true;
  }
  const bool straight = line && !words.has_any(kArcLetters);
  if (tool_side_on()) {
    if (!straight || edited()) return false;
    take_modal_words();
    alarm = tool_side_move(words);
  } else if (!cutter_active()) {
    if (!straight) return false;
    take_modal_words();
    alarm = uncompensated();
  } else {
    if (edited() || !(straight || (!is_b_ && makes_tool_arc(words) && is_usual_cutter_plane()))) return false;
    take_modal_words();
    alarm = cutter_move(words);
  }
  return true;
}

}  // namespace toolcomp::fast

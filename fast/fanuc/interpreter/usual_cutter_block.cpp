// The usual block under cutter compensation B or C.
#include "fast/basis/fault.h"
#include "fast/fanuc/cutter_compensation_c/usual_line.h"
#include "fast/fanuc/interpreter/interpreter.h"
#include "fast/fanuc/interpreter/own_move.h"
#include "fast/fanuc/interpreter/usual_words.h"

namespace toolcomp::fast {

// The usual block: positions, F and the letters of an arc, or nothing but its number. What check(), begin_cutter(),
// plan_arc(), cutter_motion() and send_cutter() do for any block, without the detours.
Alarm Interpreter::cutter_move(const Words& words) {
  if (!is_usual_cutter_plane()) [[unlikely]] {
    start_cutter_leg(words, CutterSide::unchanged, false);
    return cutter_motion(words, kNone, false, std::nullopt, ArcWords{});
  }
  const std::array<std::size_t, 2>& plane = modal_.plane_axis();
  CutterBlock& block = cutter_next();
  const Mask axes = words.axes();
  const bool arc = modal_.is_arc(words);
  block.sets = false;
  block.word = CutterSide::unchanged;
  block.side = cutter_side_;
  block.d_word = false;
  block.d = cutter_value_.number().number;
  block.offset = cutter_value_.value();
  block.plane = modal_.plane();
  block.axis = plane;
  block.has_direction = false;
  block.feed = modal_.feed();
  block.own = axes != 0 || arc;
  block.start[0] = positions_.programmed()[plane[0]];
  block.start[1] = positions_.programmed()[plane[1]];
  block.named = static_cast<std::uint8_t>((axes >> plane[0] & 1U) | (axes >> plane[1] & 1U) << 1U);
  if (const Alarm placed = place_words(words, axes)) [[unlikely]]
    return refuse_cutter_move(words, block, placed);
  block.end[0] = positions_.programmed()[plane[0]];
  block.end[1] = positions_.programmed()[plane[1]];
  if (arc) {
    std::array<double, 2> center{};
    if (const Alarm a = read_cutter_arc(words, block, center)) return a;
    block.motion = CutterMotion::arc;
    block.path_made = !is_b_ && cutter_c_.make_arc_path(block);
    fill(block.event, spec::MoveType::arc, spec::Cause::programmed);
    if (!block.event.arc) block.event.arc.emplace();
    spec::Arc<double>& numbers = *block.event.arc;
    numbers.center.present = 0;
    numbers.plane = modal_.plane();
    numbers.direction = block.clockwise ? spec::ArcDirection::cw : spec::ArcDirection::ccw;
    for (std::size_t i = 0; i < 2; ++i) numbers.center.set(plane[i], center[i]);
  } else {
    if (block.named == 0) {
      block.motion = CutterMotion::still;
    } else if (block.start[0] == block.end[0] && block.start[1] == block.end[1]) {
      block.motion = fault(Fault::usual_cutter_block_zero) ? CutterMotion::still : CutterMotion::zero;
    } else {
      block.motion = CutterMotion::line;
      block.path_made = !is_b_ && cutter_c_.make_line_path(block);
    }
    fill_here(block.event, modal_.straight(), spec::Cause::programmed);
    if (block.motion == CutterMotion::line && block.path_made && cutter_c_.usual_line()) [[likely]]
      return alarm::kNone;
  }
  if (const StageEnd end = is_b_ ? cutter_b_.block() : cutter_c_.block()) end_run(end);
  return alarm::kNone;
}

}  // namespace toolcomp::fast

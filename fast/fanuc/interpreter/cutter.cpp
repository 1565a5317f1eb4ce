// Blocks that pass cutter compensation, B or C: what the stage is told about each.
#include "fast/fanuc/interpreter/interpreter.h"
#include "fast/fanuc/interpreter/own_move.h"
#include "fast/fanuc/interpreter/usual_words.h"

namespace toolcomp::fast {

CutterSide Interpreter::cutter_side(Code code) {
  switch (code) {
    case 400:
    case 412:  // of the same group
    case 413:
    case 416:
    case 422:
    case 426:
      return CutterSide::off;
    case 410:
      return CutterSide::left;
    case 420:
      return CutterSide::right;
    default:
      return CutterSide::unchanged;
  }
}

// What the codes and numbers of a block say to the stage, and where its path starts. The number is taken already.
void Interpreter::begin_cutter(const Words& words) {
  const bool d_word = cutter_value_.commanded(words).has_value();
  const CutterSide word = cutter_side(words.code(Words::kCompensation));
  const bool begins = cutter_side_ == CutterSide::off && word != CutterSide::off && word != CutterSide::unchanged;
  if (begins || d_word || cutter_value_.takes_edited()) {
    cutter_value_.take_value();
  }
  if (word != CutterSide::unchanged) cutter_side_ = word;
  start_cutter_leg(words, word, d_word);
}

// Everything about a move but where it ends. The second move of G28 or G29 commands nothing of its own.
void Interpreter::start_cutter_leg(const Words& words, CutterSide word, bool d_word) {
  CutterBlock& block = cutter_next();
  block.sets = false;
  block.word = word;
  block.side = cutter_side_;
  block.d_word = d_word;
  block.d = cutter_value_.number().number;
  block.offset = cutter_value_.value();
  block.plane = modal_.plane();
  block.axis = modal_.plane_axis();
  block.named = 0;
  block.has_direction = false;
  block.path_made = false;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t axis = block.axis[i];
    block.start[i] = positions_.actual(axis);
    if (axis != spec::Axes::kNone && (words.axes() & bit(axis)) != 0)
      block.named = static_cast<std::uint8_t>(block.named | 1U << i);
    const char letter = direction_letter(modal_.plane(), i);
    if (words.has(letter)) {
      block.direction[i] = units_.value(words[letter], true);
      block.has_direction = true;
    } else {
      block.direction[i] = Count();
    }
  }
}

// The alarm of a block whose words could not be placed: those of its arc come first.
Alarm Interpreter::refuse_cutter_move(const Words& words, CutterBlock& block, const Alarm& placed) {
  if (!modal_.is_arc(words)) return placed;
  for (std::size_t i = 0; i < 2; ++i) positions_.set_exact(modal_.plane_axis()[i], block.start[i]);
  for (std::size_t i = 0; i < 2; ++i)
    block.end[i] = (block.named >> i & 1U) != 0 ? target(words, modal_.plane_axis()[i]) : block.start[i];
  std::array<double, 2> center{};
  const Alarm a = read_cutter_arc(words, block, center);
  return a ? a : placed;
}

// The alarms of an arc from block.start to block.end, in their order, its words and its centre. Sweep and radii are
// left to the stage.
Alarm Interpreter::read_cutter_arc(const Words& words, CutterBlock& block, std::array<double, 2>& center) const {
  if (const Alarm a = cutter_c_.check_arc(CutterSide::unchanged, cutter_value_.number().number)) return a;
  if (!block.end[0].in_range() || !block.end[1].in_range()) return alarm::kRange;
  modal_.read_arc(words, units_, block);
  if (block.by_radius) return center_by_radius(block.start, block.end, block.radius, block.clockwise, center);
  // An arc about its start is refused by the stage.
  if (block.to_center[0].is_zero() && block.to_center[1].is_zero()) [[unlikely]]
    if (!is_b_ && cutter_wanted(words) && words.has_any(Words::set_of("IJK"))) return alarm::kNone;
  return center_by_center(block.start, block.to_center, center);
}

// A code that cutter compensation does not touch where nothing is wanted or to be removed (G37, G45 to G48, G41.3): the
// stage learns of a G40 in the block, which then goes its own way.
void Interpreter::retire_cutter() {
  CutterBlock& block = cutter_next();
  fill(block.event, modal_.straight(), spec::Cause::programmed);
  block.own = false;
  block.axis_word = false;
  block.named = 0;
  block.motion = CutterMotion::still;
  (void)send_cutter(block);
  in_cutter_ = false;
}

// G39 with axis words and without I J K: the words are a direction, from the current point.
Alarm Interpreter::corner_direction(const Words& words, CutterBlock& block) const {
  if (block.has_direction) return alarm::kNone;
  for (std::size_t i = 0; i < 2; ++i) {
    if ((block.named >> i & 1U) == 0) continue;
    const Count to = target(words, block.axis[i]);
    if (!to.in_range()) return alarm::kRange;
    block.direction[i] = to - positions_.programmed()[block.axis[i]];
    block.has_direction = true;
  }
  return alarm::kNone;
}

Alarm Interpreter::cutter_motion(const Words& words, Code one_shot, bool extra,
                                 const std::optional<spec::Arc<double>>& arc, const ArcWords& arc_words) {
  CutterBlock& block = cutter_next();
  const Mask axes = one_shot == kNone ? words.axes() : Mask{0};
  if (const Alarm a = place_words(words, axes)) return a;

  block.own = axes != 0 || extra || arc;
  block.axis_word = axes != 0;
  block.feed = modal_.feed();
  fill(block.event, arc ? spec::MoveType::arc : modal_.straight(), spec::Cause::programmed);
  if (arc) {
    block.event.arc = arc;
    block.clockwise = arc_words.clockwise;
    block.by_radius = arc_words.by_radius;
    block.to_center = arc_words.to_center;
    block.radius = arc_words.radius;
    block.motion = CutterMotion::arc;
  } else if (one_shot == 390) {
    if (const Alarm a = corner_direction(words, block)) return a;
    block.motion = CutterMotion::corner_arc;
  } else if (axes == 0 || block.named == 0) {
    block.named = 0;
    block.motion = CutterMotion::still;
  } else {
    block.motion = CutterMotion::line;
  }
  return send_cutter(block);
}

Alarm Interpreter::send_cutter(CutterBlock& block) {
  for (std::size_t i = 0; i < 2; ++i) block.end[i] = positions_.actual(block.axis[i]);
  if (block.motion == CutterMotion::line && block.start[0] == block.end[0] && block.start[1] == block.end[1])
    block.motion = CutterMotion::zero;
  if (const StageEnd end = is_b_ ? cutter_b_.block() : cutter_c_.block()) end_run(end);
  return alarm::kNone;
}

}  // namespace toolcomp::fast

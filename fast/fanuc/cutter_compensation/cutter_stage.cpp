// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/cutter_compensation/cutter_stage.h"

#include <type_traits>

#include "fast/fanuc/cutter_compensation_b/cutter_compensation_b.h"
#include "fast/fanuc/cutter_compensation_c/cutter_compensation_c.h"

namespace toolcomp::fast {
namespace {

constexpr std::uint32_t kDirectionLetters = Words::set_of("IJK");

template <class Compensation>
constexpr bool kIsC = std::is_same_v<Compensation, CutterCompensationC>;

CutterSide side_of(Code code) {
  switch (code) {
    case kG40:
    case kG41_2:  // of the same group
    case kG41_3:
    case kG41_6:
    case kG42_2:
    case kG42_6:
      return CutterSide::off;
    case kG41:
      return CutterSide::left;
    case kG42:
      return CutterSide::right;
    default:
      return CutterSide::unchanged;
  }
}

bool is_own(Code code) { return code == kG41 || code == kG42; }
// A code of another compensation of the same group.
bool is_other(Code code) { return code != kNone && code != kG40 && !is_own(code); }

}  // namespace

template <class Compensation>
void CutterStage<Compensation>::release() {
  if (!compensation_.active()) return;
  if (const StageEnd held = compensation_.release()) control_.end(held);
}

template <class Compensation>
bool CutterStage<Compensation>::is_on() const {
  if constexpr (kIsC<Compensation>)
    return compensation_.on();
  else
    return compensation_.active();
}

template <class Compensation>
bool CutterStage<Compensation>::in_force_after(const Words& words) const {
  const CutterSide word = side_of(words.code(Words::kCompensation));
  return (word == CutterSide::unchanged ? side_ : word) != CutterSide::off;
}

// Number 0 is none in C.
template <class Compensation>
void CutterStage<Compensation>::read(const Words& words, const Command& /*command*/) {
  const bool concerned =
      is_own(words.code(Words::kCompensation)) || words.code(Words::kOneShot) == kG39 || compensation_.active();
  const auto numbered = [&] { return !kIsC<Compensation> || control_.cutter_value.number_after(words).number != 0; };
  set_read(concerned, is_on(), in_force_after(words) && numbered());
}

// Three-dimensional tool compensation is not built.
template <class Compensation>
bool CutterStage<Compensation>::is_built(const Words& words) const {
  return !(kIsC<Compensation> && is_own(words.code(Words::kCompensation)) && words.has('I') && words.has('J') &&
           words.has('K'));
}

template <class Compensation>
CutterCommand CutterStage<Compensation>::command_of(const Words& words, Code motion, spec::Plane plane) const {
  const CutterValue& value = control_.cutter_value;
  Mask in_plane = 0;
  for (const std::size_t i : control_.modal.axes_of(plane))
    if (i != spec::Axes::kNone) in_plane = static_cast<Mask>(in_plane | bit(i));
  CutterCommand command;
  command.word = side_of(words.code(Words::kCompensation));
  command.corner_arc = words.code(Words::kOneShot) == kG39;
  command.axis_word = words.axes() != 0;
  command.plane_word = (words.axes() & in_plane) != 0;
  command.outside_word = (words.axes() & ~in_plane) != 0;
  command.letters_zero = true;
  for (std::size_t i = 0; i < 2; ++i) {
    const char letter = direction_letter(plane, i);
    if (!words.has(letter)) continue;
    command.letters = true;
    command.letters_zero &= words[letter].is_zero();
  }
  command.letters_zero &= command.letters;
  command.no_direction =
      command.letters ? command.letters_zero : (!command.plane_word || stays(words, words.axes() & in_plane));
  command.arc = motion > kG01 && words.code(Words::kOneShot) == kNone &&
                (command.plane_word || words.has('R') || words.has_any(kDirectionLetters));
  command.d_word = value.commanded(words).has_value();
  command.d = value.number_after(words).number;
  return command;
}

// The alarms that words and state alone show (clause fanuc.program.alarm-order).
template <class Compensation>
Alarm CutterStage<Compensation>::check(const Words& words, const Command& command) const {
  const ModalState& modal = control_.modal;
  const CutterValue& value = control_.cutter_value;
  const Code code = words.code(Words::kCompensation);
  const Code plane = words.code(Words::kPlane);
  const bool in_force = in_force_after(words);
  const spec::Plane selected = plane == kNone ? modal.plane() : plane_of(plane);
  const std::array<std::size_t, 2> axis = modal.axes_of(selected);
  if (in_force && (axis[0] == spec::Axes::kNone || axis[1] == spec::Axes::kNone)) return AlarmCause::plane_axis_missing;
  if (on_before() && selected != modal.plane()) return AlarmCause::plane_change;
  if ((on_before() && is_other(code)) || ((on_before() || in_force) && words.starts_tip_control()))
    return AlarmCause::forbidden_in_cutter_compensation;
  if (words.is_tool_offset() && (on_before() || on_after())) return AlarmCause::tool_offset_in_cutter_compensation;
  if (const Alarm a = compensation_.check(command_of(words, command.motion, selected))) return a;

  // The value is read where the number is given, where G41 or G42 comes into force, and after an edit.
  const bool reads = value.commanded(words) || (in_force && side_ == CutterSide::off) || value.takes_edited();
  if (in_force && reads && !control_.memory.fits(value.of(value.number_after(words)))) return AlarmCause::offset_value;
  return AlarmCause::none;
}

template <class Compensation>
bool CutterStage<Compensation>::stays(const Words& words, unsigned axes) const {
  const auto is = [&](std::size_t group, Code code, bool in_force) {
    return words.code(group) == kNone ? in_force : words.code(group) == code;
  };
  const bool add = is(Words::kDistance, 910, control_.modal.incremental());
  const bool inch = is(Words::kUnits, 200, control_.units.inch());
  const bool selects = words.code(Words::kWorkpiece) != kNone;
  const std::size_t chosen = selects ? words.workpiece() : control_.positions.system();
  for (; axes != 0; axes &= axes - 1) {
    const auto axis = static_cast<std::size_t>(__builtin_ctz(axes));
    const Count word = control_.units.value(words.axis(axis), (control_.axes.linear & bit(axis)) != 0, inch);
    if (add ? !word.is_zero() : !(word == control_.positions.in_system(axis, chosen))) return false;
  }
  return true;
}

template <class Compensation>
bool CutterStage<Compensation>::makes_arc(const Words& words) const {
  if (words.is_tool_offset()) return false;
  return is_on() && (kIsC<Compensation> || words.code(Words::kCompensation) == kNone);
}

template <class Compensation>
bool CutterStage<Compensation>::judges_arc_about_start() const {
  return kIsC<Compensation> && on_after();
}

// What the codes and numbers of a block say to the stage, and where its path starts.
template <class Compensation>
Alarm CutterStage<Compensation>::take(const Words& words, Command& command) {
  set_takes_moves(concerned());
  if (!concerned()) return AlarmCause::none;
  stops_ = kIsC<Compensation> && (words.suppresses_look_ahead() || words.code(Words::kOneShot) == kG53);
  CutterValue& value = control_.cutter_value;
  const bool d_word = value.commanded(words).has_value();
  const Code code = words.code(Words::kCompensation);
  const CutterSide word = side_of(code);
  const bool begins = side_ == CutterSide::off && word != CutterSide::off && word != CutterSide::unchanged;
  if (begins || d_word || value.takes_edited()) value.take_value();
  if (word != CutterSide::unchanged) side_ = word;
  begin_leg(words, word, d_word);
  const bool retires = command.taken || is_other(code) || words.is_tool_offset() || words.starts_tip_control();
  CutterBlock& block = compensation_.next();
  block.sets = command.writes && !retires;
  if (block.sets) {
    control_.store_offset(command.write, block.setting, block.setting_value);
    command.writes = false;
  }
  if (retires) retire();
  command.taken |= takes_moves();
  return AlarmCause::none;
}

template <class Compensation>
void CutterStage<Compensation>::read_direction(const Words& words, CutterBlock& block) const {
  block.has_direction = false;
  for (std::size_t i = 0; i < 2; ++i) {
    const char letter = direction_letter(control_.modal.plane(), i);
    if (words.has(letter)) {
      block.direction[i] = control_.units.value(words[letter], true);
      block.has_direction = true;
    } else {
      block.direction[i] = Count();
    }
  }
}

template <class Compensation>
void CutterStage<Compensation>::begin_leg(const Words& words, CutterSide word, bool d_word) {
  CutterBlock& block = compensation_.next();
  block.sets = false;
  block.word = word;
  block.side = side_;
  block.d_word = d_word;
  block.d = control_.cutter_value.number().number;
  block.offset = control_.cutter_value.value();
  block.plane = control_.modal.plane();
  block.axis = control_.modal.plane_axis();
  block.named = 0;
  block.path_made = false;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t axis = block.axis[i];
    block.start[i] = control_.positions.actual(axis);
    if (axis != spec::Axes::kNone && (words.axes() & bit(axis)) != 0)
      block.named = static_cast<std::uint8_t>(block.named | 1U << i);
  }
  read_direction(words, block);
}

// A code that cutter compensation does not touch where nothing is wanted or to be removed (G37, G45 to G48, G41.3): the
// stage learns of a G40 in the block, which then goes its own way.
template <class Compensation>
void CutterStage<Compensation>::retire() {
  CutterBlock& block = compensation_.next();
  control_.fill(block.event, control_.modal.straight(), spec::Cause::programmed);
  block.own = false;
  block.axis_word = false;
  block.named = 0;
  block.motion = CutterMotion::still;
  send(block);
  set_takes_moves(false);
}

template <class Compensation>
Alarm CutterStage<Compensation>::corner_direction(const Words& words, CutterBlock& block) const {
  if (block.has_direction) return AlarmCause::none;
  for (std::size_t i = 0; i < 2; ++i) {
    if ((block.named >> i & 1U) == 0) continue;
    const Count to = control_.target(words, block.axis[i]);
    if (!to.in_range()) return AlarmCause::position_range;
    block.direction[i] = to - control_.positions.programmed()[block.axis[i]];
    block.has_direction = true;
  }
  return AlarmCause::none;
}

template <class Compensation>
Alarm CutterStage<Compensation>::move(const Words& words, const OwnMove& own) {
  CutterBlock& block = compensation_.next();
  const std::optional<spec::Arc<double>>& arc = own.arc.event;
  const Mask axes = own.one_shot == kNone ? words.axes() : Mask{0};
  if (const Alarm a = control_.place_words(words, axes)) return a;

  block.own = axes != 0 || own.extra || arc;
  block.axis_word = axes != 0;
  block.feed = control_.modal.feed();
  control_.fill(block.event, arc ? spec::MoveType::arc : control_.modal.straight(), spec::Cause::programmed);
  if (arc) {
    block.event.arc = arc;
    block.clockwise = own.arc.words.clockwise;
    block.by_radius = own.arc.words.by_radius;
    block.to_center = own.arc.words.to_center;
    block.radius = own.arc.words.radius;
    block.motion = CutterMotion::arc;
  } else if (own.one_shot == kG39) {
    if (const Alarm a = corner_direction(words, block)) return a;
    block.motion = CutterMotion::corner_arc;
  } else if (axes == 0 || block.named == 0) {
    block.named = 0;
    block.motion = CutterMotion::still;
  } else {
    block.motion = CutterMotion::line;
  }
  send(block);
  return AlarmCause::none;
}

template <class Compensation>
void CutterStage<Compensation>::send(CutterBlock& block) {
  for (std::size_t i = 0; i < 2; ++i) block.end[i] = control_.positions.actual(block.axis[i]);
  if (block.motion == CutterMotion::line && block.start[0] == block.end[0] && block.start[1] == block.end[1])
    block.motion = CutterMotion::zero;
  if (stops_) [[unlikely]]
    return pass_alone(block);
  pass();
}

// What lies behind it is not read before it has run: it may be the next block of a corner, and has none itself.
template <class Compensation>
void CutterStage<Compensation>::pass_alone(const CutterBlock& block) {
  stops_ = false;
  const bool is_next = block.motion == CutterMotion::line || block.motion == CutterMotion::arc ||
                       block.motion == CutterMotion::to_intermediate;
  if (!is_next) release();
  if (!control_.stopped) pass();
  if (!control_.stopped) release();
  set_on(compensation_.active());
}

template <class Compensation>
[[gnu::always_inline]] inline void CutterStage<Compensation>::pass() {
  if (const StageEnd end = compensation_.block()) control_.end(end);
  set_on(compensation_.active());
}

template <class Compensation>
Alarm CutterStage<Compensation>::leave_path(CutterMotion motion, spec::Cause cause, bool with_machine) {
  CutterBlock& block = compensation_.next();
  control_.fill(block.event, spec::MoveType::rapid, cause);
  if (with_machine) control_.positions.fill_machine(block.event);
  block.own = true;
  block.axis_word = true;
  block.feed = control_.modal.feed();
  block.motion = motion;
  send(block);
  return AlarmCause::none;
}

// The stage is told where the block began and what the position is called after it. A move of the length offset alone
// has the coordinates from before, one that makes or removes a vector those after: the stage chooses.
template <class Compensation>
Alarm CutterStage<Compensation>::shift(const Words& words, const OwnMove& own) {
  CutterBlock& block = compensation_.next();
  if (const Alarm a = control_.positions.refresh()) return a;
  control_.fill(block.event, control_.modal.straight(), spec::Cause::programmed);
  if (const Alarm a = control_.shift_coordinates(words)) return a;
  // A code makes or removes a vector at once, in C number 0 too (clause fanuc.cutter-c.number-zero).
  const bool number_zero = block.d_word && block.d == 0;
  if (kIsC<Compensation> ? block.word != CutterSide::unchanged || number_zero : block.word == CutterSide::off) {
    if (const Alarm a = control_.positions.refresh()) return a;
    control_.fill(block.renamed, control_.modal.straight(), spec::Cause::programmed);
  }
  block.own = own.extra;
  block.axis_word = false;
  block.feed = control_.modal.feed();
  block.motion = CutterMotion::shift;
  send(block);
  rename();
  return AlarmCause::none;
}

// The position is called otherwise from here on: the corner before the next move too.
template <class Compensation>
void CutterStage<Compensation>::rename() {
  if constexpr (kIsC<Compensation>) {
    if (control_.stopped) return;
    control_.name_place(compensation_.next().event);
    compensation_.rebase();
  }
}

template <class Compensation>
Alarm CutterStage<Compensation>::plan_and_move(const Words& words) {
  BlockArc arc;
  const bool judges = kIsC<Compensation> && in_force_after(words) && control_.cutter_value.number().number != 0;
  if (const Alarm a = control_.plan_arc(words, arc, !makes_arc(words), judges)) return a;
  begin_leg(words, CutterSide::unchanged, false);
  return move(words, {kNone, false, arc});
}

template <class Compensation>
Alarm CutterStage<Compensation>::refuse(const Words& words, CutterBlock& block, Alarm placed) {
  if (!control_.modal.is_arc(words)) return placed;
  const std::array<std::size_t, 2>& plane = control_.modal.plane_axis();
  for (std::size_t i = 0; i < 2; ++i) control_.positions.set_exact(plane[i], block.start[i]);
  for (std::size_t i = 0; i < 2; ++i)
    block.end[i] = (block.named >> i & 1U) != 0 ? control_.target(words, plane[i]) : block.start[i];
  std::array<double, 2> center{};
  if (!control_.modal.runs_arc(words, block.start, block.end)) return placed;
  const Alarm a = read_arc(words, block, center);
  return a ? a : placed;
}

template <class Compensation>
Alarm CutterStage<Compensation>::read_arc(const Words& words, CutterBlock& block, std::array<double, 2>& center) const {
  if (!block.end[0].in_range() || !block.end[1].in_range()) return AlarmCause::position_range;
  control_.modal.read_arc(words, control_.units, block);
  if (block.by_radius) return center_by_radius(block.start, block.end, block.radius, block.clockwise, center);
  // An arc about its start is refused by the stage.
  if (kIsC<Compensation> && block.to_center[0].is_zero() && block.to_center[1].is_zero()) [[unlikely]]
    if (block.side != CutterSide::off && block.d != 0 && words.has_any(kDirectionLetters)) return AlarmCause::none;
  const Alarm a = center_by_center(block.start, block.to_center, center);
  return a ? a : control_.check_radii(block.start, block.end, block.to_center);
}

template <class Compensation>
void CutterStage<Compensation>::set_arc_event(CutterBlock& block, const std::array<double, 2>& center) {
  control_.fill(block.event, spec::MoveType::arc, spec::Cause::programmed);
  if (!block.event.arc) block.event.arc.emplace();
  spec::Arc<double>& numbers = *block.event.arc;
  numbers.center.present = 0;
  numbers.plane = block.plane;
  numbers.direction = block.clockwise ? spec::ArcDirection::cw : spec::ArcDirection::ccw;
  for (std::size_t i = 0; i < 2; ++i) numbers.center.set(block.axis[i], center[i]);
}

template <class Compensation>
[[gnu::always_inline]] inline Alarm CutterStage<Compensation>::take_arc(const Words& words, CutterBlock& block) {
  std::array<double, 2> center{};
  if (const Alarm a = read_arc(words, block, center)) return a;
  block.motion = CutterMotion::arc;
  if constexpr (kIsC<Compensation>) block.path_made = compensation_.make_arc_path(block);
  set_arc_event(block, center);
  pass();
  return AlarmCause::none;
}

// Words that make an arc, or would.
template <class Compensation>
[[gnu::always_inline]] inline Alarm CutterStage<Compensation>::check_plain_arc(const Words& words) const {
  const std::array<std::size_t, 2>& plane = control_.modal.plane_axis();
  const bool named = (words.axes() & (bit(plane[0]) | bit(plane[1]))) != 0;
  if (!named && !words.has_any(kArcLetters)) return AlarmCause::none;
  if constexpr (kIsC<Compensation>) {
    return compensation_.check_arc(CutterSide::unchanged, control_.cutter_value.number().number);
  } else {
    CutterCommand command;
    command.arc = true;
    return compensation_.check(command);
  }
}

template <class Compensation>
Alarm CutterStage<Compensation>::plain_block(const Words& words) {
  // At hand: behind whatever is written through control_ it would be looked up again.
  Control& control = control_;
  const ModalState& modal = control.modal;
  const AxisPositions& positions = control.positions;
  const std::array<std::size_t, 2>& plane = modal.plane_axis();
  if (plane[0] == spec::Axes::kNone || plane[1] == spec::Axes::kNone) [[unlikely]]
    return side_ == CutterSide::off ? plan_and_move(words) : AlarmCause::plane_axis_missing;
  bool arc = false;
  if (modal.motion() > kG01) {
    if (const Alarm a = check_plain_arc(words)) return a;
    arc = modal.is_arc(words);
  }
  if (positions.tool_offset().live() != 0 || (arc && !is_on())) [[unlikely]]
    return plan_and_move(words);
  const Mask axes = words.axes();
  CutterBlock& block = compensation_.next();
  block.sets = false;
  block.word = CutterSide::unchanged;
  block.side = side_;
  block.d_word = false;
  block.d = control.cutter_value.number().number;
  block.offset = control.cutter_value.value();
  block.plane = modal.plane();
  block.axis = modal.plane_axis();
  block.has_direction = false;
  if constexpr (!kIsC<Compensation>)  // of B they direct the vector; C asks for them beside a code only
    if (!arc && words.has_any(kDirectionLetters)) read_direction(words, block);
  block.feed = modal.feed();
  block.own = axes != 0 || arc;
  block.start[0] = positions.programmed()[plane[0]];
  block.start[1] = positions.programmed()[plane[1]];
  block.named = static_cast<std::uint8_t>((axes >> plane[0] & 1U) | (axes >> plane[1] & 1U) << 1U);
  if (const Alarm placed = control.place_words(words, axes)) [[unlikely]]
    return refuse(words, block, placed);
  block.end[0] = positions.programmed()[plane[0]];
  block.end[1] = positions.programmed()[plane[1]];
  if (arc) {
    if (control.modal.runs_arc(words, block.start, block.end)) [[likely]]
      return take_arc(words, block);
    block.own = axes != 0;
  }
  // What the stage makes of a line is begun early, while the rest of the block is filled in.
  const bool moves = !(block.start[0] == block.end[0] && block.start[1] == block.end[1]);
  if (block.named != 0 && moves) [[likely]] {
    block.motion = CutterMotion::line;
    if constexpr (kIsC<Compensation>) block.path_made = compensation_.make_line_path(block);
  } else {
    block.motion = block.named == 0 ? CutterMotion::still : CutterMotion::zero;
  }
  control.fill_here(block.event, modal.straight(), spec::Cause::programmed);
  pass();
  return AlarmCause::none;
}

// The words are those of the axes in the plane, which have no length offset.
template <class Compensation>
std::size_t CutterStage<Compensation>::lines(const LineChunk& chunk) {
  if constexpr (kIsC<Compensation>) {
    const std::array<std::size_t, 2>& axis = control_.modal.plane_axis();
    AxisPositions& positions = control_.positions;
    CutterLines lines;
    std::uint32_t words = 0;
    for (std::size_t i = 0; i < 2; ++i) {
      if (axis[i] == spec::Axes::kNone) return 0;
      const Count& at = positions.programmed()[axis[i]];
      if (!at.is_small()) return 0;
      lines.at[i] = at.small();
      lines.word[i] = word_place(control_.axes.names.letter(axis[i]));
      words |= place_bit(lines.word[i]);
    }
    if ((chunk.words & ~words) != 0 || positions.along_tool() ||
        (positions.length().live() & (bit(axis[0]) | bit(axis[1]))) != 0)
      return 0;
    const std::size_t taken = compensation_.lines(chunk, lines);
    for (std::size_t i = 0; i < 2 && taken != 0; ++i) positions.place_small(axis[i], lines.at[i]);
    return taken;
  } else {
    return Stage::lines(chunk);
  }
}

template class CutterStage<CutterCompensationB>;
template class CutterStage<CutterCompensationC>;

}  // namespace toolcomp::fast

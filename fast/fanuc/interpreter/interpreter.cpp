// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/interpreter/interpreter.h"

#include <algorithm>

namespace toolcomp::fast {

Interpreter::Interpreter(const spec::Setup& setup, Control& control, const Stages& stages, EventSink& sink)
    : control_(control),
      is_30i_(setup.series == spec::Series::series_30i),
      stages_(stages),
      measurement_(setup),
      cycle_(setup),
      shifts_system_(setup.bit(5006, 6)),
      sink_(sink),
      moves_(&sink) {
  control_.begin(setup);
}

void Interpreter::end() {
  if (control_.stopped) return;
  if (release_held()) return;
  control_.stopped = true;
}

bool Interpreter::release_held() {
  for (const auto& stage : stages_)
    if (!control_.stopped) stage->release();
  return control_.stopped;
}

void Interpreter::leave_open(const char* clause) {
  if (!release_held()) control_.end({AlarmCause::none, clause, control_.line, control_.n});
}

// A command alarm: what is held goes out as if the block and everything after it were absent. A block held may then
// itself be at fault.
void Interpreter::raise(Alarm alarm, const char* more) {
  if (!release_held()) control_.end(alarm.cause, more);
}

[[gnu::always_inline]] inline Alarm Interpreter::uncompensated(const Words& words, bool own, bool extra,
                                                               const std::optional<spec::Arc<double>>& arc) {
  constexpr std::uint32_t kToolLetters = Words::set_of("IJK");
  const ModalState& modal = control_.modal;
  const Mask axes = own ? words.axes() : Mask{0};
  if (const Alarm a = control_.place_words(words, axes)) return a;
  if (axes == 0 && !extra && !arc && !(own && modal.by_vector() && words.has_any(kToolLetters)))
    return AlarmCause::none;
  control_.fill_here(move_, arc ? spec::MoveType::arc : modal.straight(), spec::Cause::programmed);
  if (arc) move_.arc = arc;
  moves_->on(move_);
  return AlarmCause::none;
}

[[gnu::always_inline]] inline Alarm Interpreter::plain_block(const Words& words, Stage* stage) {
  ModalState& modal = control_.modal;
  const Code code = words.code(Words::kMotion);
  if (code != kNone) modal.set_motion(code);
  if (words.has('F')) set_feed(words);
  if (modal.lacks_feed() && cuts(words, modal.motion())) [[unlikely]]
    return AlarmCause::no_feed;
  if (control_.positions.along_tool()) {
    ToolAttitude& attitude = control_.attitude;
    attitude.directions().begin_block();
    if (const Alarm a = check_tip_move(words, modal.motion(), modal.by_vector(), stage)) return a;
    attitude.set_sampled(true);
    if (!attitude.plans_tool()) attitude.direct(words);
  }
  if (stage != nullptr) return stage->plain_block(words);
  if (modal.motion() > kG01) [[unlikely]]
    return uncompensated_arc(words);
  return uncompensated(words, true, false, std::nullopt);
}

Alarm Interpreter::uncompensated_arc(const Words& words) {
  BlockArc arc;
  if (const Alarm a = control_.plan_arc(words, arc, true, false)) return a;
  return uncompensated(words, true, false, arc.event);
}

Alarm Interpreter::block_with_commands(const Words& words) {
  const bool asks = !rest_ || wakes_stages(words);
  asked_ = asks ? std::span(stages_) : std::span<const std::unique_ptr<Stage>>();
  Command command;
  if (const Alarm a = check(words, command)) return a;
  if (command.undecided != nullptr) [[unlikely]] {
    leave_open(command.undecided);
    return AlarmCause::none;
  }
  const Alarm alarm = apply(words, command);
  if (!asks) return alarm;
  on_ = nullptr;
  rest_ = true;
  for (const auto& stage : stages_) {
    if (on_ == nullptr && stage->on()) on_ = stage.get();
    rest_ = rest_ && stage->rests();
  }
  return alarm;
}

bool Interpreter::wakes_stages(const Words& words) const {
  const Code one_shot = words.code(Words::kOneShot);
  const bool measures = one_shot == kG37;
  return words.code(Words::kCompensation) != kNone || control_.cutter_value.commanded(words) ||
         (one_shot != kNone && !words.is_tool_offset() && !measures) || control_.cutter_value.takes_edited();
}

void Interpreter::block(const spec::Block& block) {
  if (control_.stopped) return;
  control_.line = block.line;
  control_.n = block.n;
  if (block.alarm) [[unlikely]] {
    raise(block.alarm->cause, block.alarm->message);
    return;
  }
  const Words words(block, control_.axes.letters, control_.stop_codes);
  if (control_.refuses_repeats && !words.unknown() && repeats(block)) [[unlikely]]
    return raise(AlarmCause::address_repeated);
  if (on_ != nullptr && !on_->on()) [[unlikely]]
    on_ = nullptr;
  // Of an edited value or a length offset taken away: any block with words may bring it. In the drilling mode words do
  // not move.
  const bool waits =
      control_.positions.length().pending() || cycle_.on() || (on_ != nullptr && control_.cutter_value.takes_edited());
  if (!words.plain() || waits) [[unlikely]]
    return other_block(words);
  if (const Alarm a = plain_block(words, on_)) [[unlikely]]
    raise(a);
}

void Interpreter::other_block(const Words& words) {
  Alarm alarm;
  if (words.unknown()) {
    raise(AlarmCause::unknown_code);
  } else if (words.any()) {
    alarm = block_with_commands(words);
  } else if (on_ != nullptr) {
    // A sequence or program number alone is a block without movement where blocks are counted.
    alarm = on_->plain_block(words);
  }
  if (alarm)
    raise(alarm);
  else if (words.ends_program())
    end();
}

Alarm Interpreter::apply(const Words& words, Command& command) {
  take_codes(words, command);
  const Code one_shot = words.code(Words::kOneShot);
  bool extra = false;
  if (shifts_system_) {
    if (const Alarm a = take_length(words, command, extra)) return a;
    if (control_.stopped) return AlarmCause::none;
  }
  BlockArc arc;
  if (const Alarm a = take_arc(words, arc)) return a;
  std::optional<Shifts> shifts;
  if (words.is_tool_offset() && !command.cycle.on())
    if (const Alarm a = plan_tool_offset(words, arc, shifts.emplace())) return a;

  if (!shifts_system_)
    if (const Alarm a = take_length(words, command, extra)) return a;
  control_.cutter_value.take_number(words);
  Stage* through = nullptr;
  const std::optional<Words> still = for_stages(words, command);
  const Words& of_stages = still ? *still : words;
  for (const auto& stage : asked_) {
    if (const Alarm a = stage->take(of_stages, command)) return a;
    if (control_.stopped) return AlarmCause::none;
    if (through == nullptr && stage->takes_moves()) through = stage.get();
  }
  if (shifts)
    if (const Alarm a = shift_axes(*shifts)) return a;
  return move(words, command, through, {one_shot, extra, arc});
}

// The codes and values that stay in force, but for offsets.
void Interpreter::take_codes(const Words& words, const Command& command) {
  ModalState& modal = control_.modal;
  modal.set_motion(command.motion);
  if (const Code code = words.code(Words::kPlane); code != kNone) modal.select_plane(plane_of(code));
  if (const Code code = words.code(Words::kDistance); code != kNone) modal.set_incremental(code == kG91);
  if (const Code code = words.code(Words::kUnits); code != kNone) control_.units.select(code);
  if (const Code code = words.code(Words::kFeedMode); code != kNone) modal.set_feed_mode(code == kG94);
  if (words.has('F')) set_feed(words);
  cycle_.take(words, command.cycle, control_.units, modal.incremental());
  if (command.ends_along) {
    control_.attitude.end(command.along);
    send_to(sink_);
  }
  modal.set_by_vector(command.vector);
  const bool selects = words.code(Words::kWorkpiece) != kNone;
  if (selects) select_workpiece(words.workpiece());
  if (words.writes_origin()) write_origins(words);
  if (selects || words.writes_origin())
    for (const auto& stage : asked_)
      if (stage->concerned()) stage->rename();
}

Alarm Interpreter::take_arc(const Words& words, BlockArc& arc) const {
  if (control_.modal.motion() <= kG01 || cycle_.on()) return AlarmCause::none;
  const bool made = std::ranges::any_of(asked_, [&](const auto& stage) { return stage->makes_arc(words); });
  const bool judged = std::ranges::any_of(asked_, [](const auto& stage) { return stage->judges_arc_about_start(); });
  return control_.plan_arc(words, arc, !made, judged);
}

// The length offset, on the axes or along the tool. `extra`: the block moves without axis words too.
Alarm Interpreter::take_length(const Words& words, const Command& command, bool& extra) {
  AxisPositions& positions = control_.positions;
  ToolLengthOffset& length = positions.length();
  ToolAttitude& attitude = control_.attitude;
  length.begin_block();
  if (const Alarm a = length.restore(words, control_.memory)) return a;
  const Mask named = command.cycle.drills ? bit(command.cycle.axis) : words.axes();
  if (const Alarm a = length.apply(words, control_.memory, control_.modal.normal_axis(), named)) return a;
  if (length.changed()) positions.make_stale();
  if (command.along) attitude.take_length();
  if (shifts_system_ && !shift_system()) return AlarmCause::none;
  // G43.4 and G43.5 always make their move; the G49 that ends them makes one where the setup says so.
  extra = words.starts_tip_control() || (command.ends_along && attitude.cancel_moves()) ||
          (length.changed() && !command.ends_along && (!shifts_system_ || command.along));
  attitude.directions().begin_block();
  if (!command.along) return AlarmCause::none;
  // Moves that a compensation inserts are none of the block.
  const bool replaced = std::ranges::any_of(asked_, [&](const auto& stage) { return stage->replaces_move(extra); });
  attitude.set_sampled(!words.starts_tip_control() && !replaced);
  if (words.starts_tip_control()) {
    attitude.begin(words);
    if (attitude.completes_moves()) send_to(attitude.tip());
  }
  if (!attitude.tip().active() && (!attitude.plans_tool() || attitude.starts())) attitude.direct(words);
  return AlarmCause::none;
}

// With 5006#6 = 1 a change of the length offset renames the position. False: the run ends here.
bool Interpreter::shift_system() {
  AxisPositions& positions = control_.positions;
  bool shifted = false;
  for (std::size_t axis = 0; axis < control_.axes.count; ++axis) {
    const Count change = positions.length().change(axis);
    if (change.is_zero()) continue;
    shifted = true;
    positions.set(axis, positions.programmed()[axis] - change);
  }
  const bool compensated =
      std::ranges::any_of(asked_, [](const auto& stage) { return stage->on_before() || stage->on_after(); });
  if (!shifted || !compensated) return true;
  leave_open("fanuc.length-offset.shifted-in-compensation");
  return false;
}

Alarm Interpreter::move(const Words& words, const Command& command, Stage* stage, const OwnMove& own) {
  if (command.cycle.drills) return drill(words, command.cycle, stage, own.extra);
  if (words.axes() != 0) switch (own.one_shot) {
      case kG28:
      case kG30:
      case kG30_1:
        return to_reference(words, stage);
      case kG29:
        return from_reference(words, stage);
      case kG53:
        if (!control_.modal.incremental()) return to_machine_position(words, stage);
        break;
      case kG37:
        return measure(words, stage);
      default:
        break;
    }
  Alarm alarm;
  if (stage != nullptr) {
    alarm = words.shifts_coordinates() ? stage->shift(words, own) : stage->move(words, own);
  } else {
    alarm = uncompensated(words, own.one_shot == kNone || words.is_tool_offset(), own.extra, own.arc.event);
    if (!alarm && words.shifts_coordinates()) alarm = control_.shift_coordinates(words);
  }
  if (!alarm && command.writes) control_.write_offset(command.write);
  return alarm;
}

// Where the moves of blocks go. Nothing is held where G43.4 or G43.5 begins or ends.
void Interpreter::send_to(EventSink& sink) {
  moves_ = &sink;
  for (const auto& stage : stages_)
    if (stage->in_space()) stage->set_sink(sink);
}

}  // namespace toolcomp::fast

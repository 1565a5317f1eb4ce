// SPDX-License-Identifier: Apache-2.0
// The alarms of commands, in the order of the specification (clause fanuc.program.alarm-order).
#include <algorithm>
#include <bit>
#include <optional>

#include "fast/fanuc/interpreter/interpreter.h"

namespace toolcomp::fast {

Alarm Interpreter::check(const Words& words, Command& command) const {
  const OffsetMemory& memory = control_.memory;
  const Code one_shot = words.code(Words::kOneShot);
  if (words.code(Words::kCompensation) != kNone)
    for (const auto& stage : asked_)
      if (!stage->is_built(words)) return AlarmCause::unknown_code;
  const std::uint32_t list = words.has('L') ? whole_number(words['L'], 99) : 100;
  if (one_shot == kG10 && !words.writes_origin() && !memory.has_list(list)) return AlarmCause::g10_kind;
  for (const char letter : {'H', 'D'})
    if (words.has(letter) && whole_number(words[letter], memory.count()) > memory.count())
      return AlarmCause::offset_number;
  if (words.code(Words::kWorkpiece) != kNone && words.workpiece() == Words::kNoSystem)
    return AlarmCause::workpiece_number;

  read_command(words, command);
  const bool feeds = command.cycle.on() ? command.cycle.makes_holes() : cuts(words, command.motion);
  if (feeds && lacks_feed(words)) return AlarmCause::no_feed;
  const std::optional<Words> still = for_stages(words, command);
  const Words& of_stages = still ? *still : words;
  for (const auto& stage : asked_) stage->read(of_stages, command);

  if (words.starts_tip_control() || control_.positions.along_tool())
    if (const Alarm a = check_tip_control(words, command)) return a;
  if (command.cycle.on())
    if (const Alarm a = check_cycle(words, command); a || command.undecided != nullptr) return a;
  for (const auto& stage : asked_)
    if (stage->concerned())
      if (const Alarm a = stage->check(of_stages, command)) return a;
  if (one_shot == kG37)
    if (const Alarm a = check_measurement(words)) return a;
  if (words.writes_origin() && !names_origin(words, list)) return AlarmCause::g10_workpiece;
  if (one_shot == kG10 && !words.writes_origin())
    if (const Alarm a = check_offset_write(words, list, command)) return a;
  if (one_shot == kG30 && words.axes() != 0 && reference_point(words) == 0) return AlarmCause::reference_number;
  if (one_shot == kG29 && is_30i_ && !control_.positions.has_intermediate(words.axes()))
    return AlarmCause::no_intermediate_point;
  return AlarmCause::none;
}

std::optional<Words> Interpreter::for_stages(const Words& words, const Command& command) {
  if (!command.cycle.on() || words.shifts_coordinates()) return std::nullopt;
  return words.naming_no_axis();
}

void Interpreter::read_command(const Words& words, Command& command) const {
  const ModalState& modal = control_.modal;
  const Code motion = words.code(Words::kMotion);
  command.motion = motion == kNone ? modal.motion() : motion;
  const Code plane = words.code(Words::kPlane);
  command.cycle = cycle_.read(words, modal.normal_axis(plane == kNone ? modal.plane() : plane_of(plane)));
  const bool along_before = control_.positions.along_tool();
  const Code length = words.code(Words::kLength);
  command.along = words.starts_tip_control() || (along_before && length != kG49);
  command.vector = length == kG43_5 || (modal.by_vector() && length != kG43_4 && length != kG49);
  command.ends_along = along_before && (length == kG49 || words.starts_tip_control());
}

Alarm Interpreter::check_cycle(const Words& words, Command& command) const {
  const Code one_shot = words.code(Words::kOneShot);
  if (one_shot >= kG28 && one_shot <= kG30_1) return AlarmCause::reference_in_cycle;
  bool before = false;
  bool in_plane = false;
  bool in_space = false;
  for (const auto& stage : asked_) {
    before |= stage->on_before();
    if (stage->on_after()) (stage->in_space() ? in_space : in_plane) = true;
  }
  if (in_space) return AlarmCause::forbidden_in_compensation;
  if (in_plane) return AlarmCause::forbidden_in_cutter_compensation;
  // A vector on before the block goes in it, or waits to go.
  if (before || !cycle_.is_said(words, command.cycle)) {
    command.undecided = "fanuc.canned-cycle.not-said";
    return AlarmCause::none;
  }
  return cycle_.lacks_depth_of_cut(words, command.cycle) ? AlarmCause::cycle_without_depth_of_cut : AlarmCause::none;
}

bool Interpreter::lacks_feed(const Words& words) const {
  const ModalState& modal = control_.modal;
  const Code mode = words.code(Words::kFeedMode);
  const bool per_minute = mode == kNone ? modal.feed_per_minute() : mode == kG94;
  if (!per_minute) return false;
  if (words.has('F')) return words['F'].digits == 0;
  return !modal.feed_per_minute() || modal.lacks_feed();
}

// G10. R counts in the units and the mode (G90, G91) of this block.
Alarm Interpreter::check_offset_write(const Words& words, std::uint32_t list, Command& command) const {
  const auto is = [&](std::size_t group, Code code, bool in_force) {
    return words.code(group) == kNone ? in_force : words.code(group) == code;
  };
  const OffsetMemory& memory = control_.memory;
  const std::uint32_t number = words.has('P') ? whole_number(words['P'], memory.count()) : 0;
  command.writes = words.has('R');
  // Of a P that names none too.
  if (!command.writes && is_30i_) return AlarmCause::g10_number;
  const bool inch = is(Words::kUnits, 200, control_.units.inch());
  const bool add = is(Words::kDistance, 910, control_.modal.incremental());
  // Without R nothing is stored: 0 in its place passes every range.
  command.write = memory.plan(list, number, command.writes ? control_.units.value(words['R'], true, inch) : Count(),
                              command.writes && add);
  return command.write.alarm;
}

// Whether P of G10 L2 or L20 names a workpiece system.
bool Interpreter::names_origin(const Words& words, std::uint32_t list) {
  if (!words.has('P')) return false;
  const std::uint32_t number = whole_number(words['P'], spec::kAdditionalWorkpieces);
  return list == 2 ? number <= 6 : number >= 1 && number <= spec::kAdditionalWorkpieces;
}

// The alarms of G37, in their order.
Alarm Interpreter::check_measurement(const Words& words) const {
  if (words.has('H')) return AlarmCause::measurement_number_in_block;
  if (control_.positions.length().number() == 0) return AlarmCause::measurement_without_number;
  const Code distance = words.code(Words::kDistance);
  const bool add = distance == kNone ? control_.modal.incremental() : distance == kG91;
  if (add || std::popcount(words.axes()) != 1 || (words.axes() & control_.axes.linear) == 0)
    return AlarmCause::measurement_axis;
  if (words.code(Words::kLength) != kNone) return AlarmCause::measurement_format;
  if (std::ranges::any_of(asked_, [](const auto& stage) { return stage->on_before() || stage->on_after(); }))
    return AlarmCause::measurement_in_cutter_compensation;
  return measurement_.parameters();
}

// The index of the reference position that G28, G30 or G30.1 means; 0 where P of G30 means none.
std::uint32_t Interpreter::reference_point(const Words& words) const {
  if (words.code(Words::kOneShot) != kG30) return words.code(Words::kOneShot) == kG28 ? 1 : 0;
  const std::uint32_t point = words.has('P') ? whole_number(words['P'], 4) : 2;
  return point >= 2 && point <= 4 ? point : 0;
}

}  // namespace toolcomp::fast

// SPDX-License-Identifier: Apache-2.0
#include "fast/heidenhain/interpreter/interpreter.h"

#include <bit>
#include <utility>

#include "spec/language/input_error.h"

namespace toolcomp::fast::klartext {
namespace {

using spec::klartext::CorrectionTable;
using spec::klartext::FeedWord;
using spec::klartext::kAxisLetters;
using spec::klartext::ReferenceWord;
using spec::klartext::Statement;
using spec::klartext::ToolWord;

constexpr const char* kUnknownPosition =
    "an unknown position (after M140 MB MAX, or a departure from a contour) is not judged";

bool has_functions(Statement statement) {
  return statement == Statement::line || statement == Statement::line_with_vectors || statement == Statement::stop ||
         statement == Statement::miscellaneous;
}

}  // namespace

Interpreter::Interpreter(spec::Setup setup, EventSink& sink)
    : setup_(std::move(setup)), writer_(setup_, sink), tool_(setup_), face_(writer_), peripheral_(writer_) {
  if (setup_.control != spec::Control::heidenhain)
    throw spec::InputError("setup", 0, 0, "control: Klartext programs need a setup of control \"heidenhain\"");
  for (std::size_t slot = 0; slot < kSlots; ++slot) axis_[slot] = setup_.axes.index(kAxisLetters[slot]);
  for (const char parallel : {'U', 'V', 'W'})
    if (setup_.axes.has(parallel))
      parallel_axes_ = static_cast<std::uint16_t>(parallel_axes_ | 1U << setup_.axes.index(parallel));
  for (std::size_t slot = 0; slot < 3; ++slot)
    if (axis_[slot] == spec::Axes::kNone) throw spec::InputError("setup", 0, 0, "axes: X, Y and Z are needed");
  for (const auto& [letter, value] : setup_.position)
    if (!fits_count(value)) throw spec::InputError("setup", 0, 0, "position: must be below 1e17");
}

void Interpreter::start(const Block& block) {
  started_ = true;
  const bool inch_setup = setup_.units == spec::Units::inch;
  inch_ = block.statement == Statement::begin_program && !block.alarm ? block.unit == spec::Units::inch : inch_setup;
  tool_.set_units(inch_);
  const Factor factor = inch_ == inch_setup ? Factor::one : (inch_ ? Factor::mm_to_inch : Factor::inch_to_mm);
  for (std::size_t slot = 0; slot < kSlots; ++slot) {
    // Rotary axes start at 0.
    if (axis_[slot] == spec::Axes::kNone || !spec::is_linear_axis(kAxisLetters[slot])) continue;
    const auto value = setup_.position.find(kAxisLetters[slot]);
    if (value != setup_.position.end()) set_position(slot, Count::of(value->second, factor));
  }
}

void Interpreter::block(const Block& block) {
  if (stopped_) return;
  if (!started_) [[unlikely]]
    start(block);
  head_.line = block.line;
  head_.n = block.n;
  if (block.alarm) [[unlikely]] {
    raise(block.alarm->cause, block.alarm->message);
    return;
  }
  if (block.statement == Statement::line_with_vectors && block.functions == 0) [[likely]] {
    if (const Alarm a = line_with_vectors(block, 0)) [[unlikely]]
      raise(a);
    return;
  }
  Functions found = 0;
  if (has_functions(block.statement) && block.functions != 0) [[unlikely]] {
    found = functions(block);
    start_acting(found);
  }
  if (const Alarm a = execute(block, found)) [[unlikely]] {
    raise(a);
    return;
  }
  if (found != 0) [[unlikely]]
    end_acting(found);
}

void Interpreter::end() {
  if (stopped_) return;
  stopped_ = true;
  if (const Alarm a = peripheral_.release()) raise_at_held(a);
}

Interpreter::Functions Interpreter::functions(const Block& block) {
  Functions found = 0;
  for (std::size_t i = 0; i < block.functions && i < Block::kMostFunctions; ++i) switch (block.function[i]) {
      case 2:
      case 30:
        found |= kEnd;
        break;
      case 91:
      case 92:
        found |= kMachine;
        break;
      case 107:
        found |= kOversize;
        break;
      case 108:
        found |= kOversizeEnd;
        break;
      case 128:
        found |= kTcpm;
        break;
      case 129:
        found |= kTcpmEnd;
        break;
      default:
        break;
    }
  return found;
}

void Interpreter::start_acting(Functions functions) {
  if ((functions & kOversize) != 0) oversize_ = true;
  if ((functions & kTcpm) != 0) {
    switch_tcpm_on();
    center_ = setup_.m128_reference == spec::M128Reference::center;
  }
}

void Interpreter::end_acting(Functions functions) {
  if ((functions & kOversizeEnd) != 0) oversize_ = false;
  if ((functions & kTcpmEnd) != 0) switch_tcpm_off();
  if ((functions & kEnd) != 0) end();
}

// The tool stands as the rotary axes stand.
void Interpreter::switch_tcpm_on() {
  if (tcpm_) return;
  tcpm_ = true;
  face_.keep_tool();
  if (by_vector_)
    direction_->copy(left_);
  else
    turn_by_positions();
}

void Interpreter::switch_tcpm_off() {
  if (tcpm_ && by_vector_) left_.copy(*direction_);
  tcpm_ = false;
  face_.keep_tool();
  direction_->set_axis(tool_axis_);
}

// What is held is sent as if this block were absent; where that fails, its block is the one at fault.
void Interpreter::raise(AlarmCause cause, const char* more) {
  stopped_ = true;
  if (const Alarm a = peripheral_.release()) {
    raise_at_held(a);
    return;
  }
  writer_.alarm(head_, cause, more);
}

void Interpreter::raise(const Alarm& alarm) {
  if (!stopped_) raise(alarm.cause, alarm.cause == AlarmCause::not_judged ? kUnknownPosition : nullptr);
}

void Interpreter::raise_at_held(const Alarm& alarm) {
  stopped_ = true;
  writer_.alarm(peripheral_.held(), alarm.cause);
}

Alarm Interpreter::execute(const Block& block, Functions functions) {
  if ((functions & kMachine) != 0 && tcpm_) return AlarmCause::machine_coordinates_under_tcpm;
  switch (block.statement) {
    case Statement::line:
      if (const Alarm a = line(block, functions)) return a;
      if (block.calls_cycle && !stopped_) [[unlikely]]
        return call_cycle();
      break;
    case Statement::line_with_vectors:
      return line_with_vectors(block, functions);
    case Statement::end_program:
      end();
      break;
    case Statement::tool_call:
      return tool_call(block);
    case Statement::tcpm:
      switch_tcpm_on();
      center_ = block.reference == ReferenceWord::center_center;
      break;
    case Statement::reset_tcpm:
      switch_tcpm_off();
      break;
    case Statement::programmed_path:
      contour_ = block.contour;
      break;
    case Statement::correction_row:
      if (block.corrections == CorrectionTable::tcs) tool_.set_row(block.row);
      break;
    case Statement::reset_corrections:
      if (block.corrections != CorrectionTable::wpl) tool_.set_row(std::nullopt);
      break;
    case Statement::cycle:
      return block.cycle == 7 ? datum_shift(block) : define_cycle(block);
    case Statement::assignment:
      return assign(block.target, block.value);
    case Statement::call_program:
      side_ = 0;
      break;
    case Statement::miscellaneous:
      if (block.calls_cycle) return call_cycle();
      break;
    case Statement::begin_program:
    case Statement::block_form:
    case Statement::tool_definition:
    case Statement::select_corrections:
    case Statement::plane:
    case Statement::stop:
    case Statement::label:
    case Statement::call_label:
    case Statement::program_return:
    case Statement::without_effect:
      break;
  }
  return AlarmCause::none;
}

Alarm Interpreter::tool_call(const Block& block) {
  face_.forget();
  if (block.tool != ToolWord::none) {
    if (tcpm_) return AlarmCause::tool_call_under_tcpm;
    const bool found = block.tool == ToolWord::number
                           ? tool_.call(block.tool_number)
                           : block.tool == ToolWord::name && tool_.call(block.tool_name.view());
    if (!found) return AlarmCause::no_tool;
    side_ = 0;
  }
  Count value;
  if (block.dl) {
    if (!parameters_.read(*block.dl, value)) return AlarmCause::position_range;
    tool_.set_call_length(value);
  }
  if (block.dr) {
    if (!parameters_.read(*block.dr, value)) return AlarmCause::position_range;
    tool_.set_call_radius(value);
  }
  if (block.dr2) {
    if (!parameters_.read(*block.dr2, value)) return AlarmCause::position_range;
    tool_.set_call_corner(value);
  }
  if (block.tool_axis != 0) {
    tool_axis_ = static_cast<std::size_t>(block.tool_axis - 'X');
    if (!tcpm_) direction_->set_axis(tool_axis_);
  }
  return feed(block, true);
}

Alarm Interpreter::datum_shift(const Block& block) {
  for (unsigned rest = block.axes; rest != 0; rest &= rest - 1) {
    const auto slot = static_cast<std::size_t>(std::countr_zero(rest));
    Count value;
    if (!parameters_.read(block.axis[slot], value)) return AlarmCause::position_range;
    shift_[slot] = block.is_incremental(slot) ? shift_[slot] + value : value;
    if (!shift_[slot].in_range()) return AlarmCause::position_range;
  }
  shifted_ = false;
  for (const Count& shift : shift_) shifted_ = shifted_ || !shift.is_zero();
  return AlarmCause::none;
}

Alarm Interpreter::assign(const spec::klartext::Parameter& target, const spec::klartext::Value& word) {
  Count value;
  if (!parameters_.read(word, value)) return AlarmCause::position_range;
  parameters_.assign(target, value);
  return AlarmCause::none;
}

// F counts tenths of an inch a minute in inch programs.
Alarm Interpreter::feed(const Block& block, bool call) {
  switch (block.feed) {
    case FeedWord::none:
    case FeedWord::f_max:
      return AlarmCause::none;
    case FeedWord::f_auto:
      feed_ = call_feed_;
      return AlarmCause::none;
    case FeedWord::f_z:
    case FeedWord::f_u:
      feed_.reset();
      break;
    case FeedWord::f: {
      Count value;
      if (!parameters_.read(block.feed_value, value)) return AlarmCause::position_range;
      if (!inch_)
        feed_ = value.nearest();
      else if (value.is_small())
        feed_ = static_cast<double>(value.small()) / static_cast<double>(10 * Count::kSmallPerOne);
      else
        feed_ = value.nearest() / 10;
      break;
    }
  }
  if (call) call_feed_ = feed_;
  return AlarmCause::none;
}

}  // namespace toolcomp::fast::klartext

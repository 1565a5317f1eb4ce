// SPDX-License-Identifier: Apache-2.0
// Blocks that move: L and LN.
#include <algorithm>
#include <bit>

#include "fast/heidenhain/interpreter/interpreter.h"

namespace toolcomp::fast::klartext {
namespace {

using spec::klartext::FeedWord;
using spec::klartext::RadiusWord;

constexpr std::size_t kRotarySlot = 3;  // A, B, C
constexpr unsigned kRotarySlots = 0b111U << kRotarySlot;

}  // namespace

void Interpreter::set_position(std::size_t slot, const Count& value) {
  position_[slot] = value;
  write_position(slot, value.nearest());
}

void Interpreter::turn_by_positions() {
  direction_->turn(tool_axis_, {position_[kRotarySlot], position_[kRotarySlot + 1], position_[kRotarySlot + 2]});
}

void Interpreter::modal_words(const Block& block) {
  switch (block.radius) {
    case RadiusWord::none:
      break;
    case RadiusWord::r0:
      side_ = 0;
      break;
    case RadiusWord::rl:
      side_ = 1;
      break;
    case RadiusWord::rr:
      side_ = -1;
      break;
  }
}

inline void Interpreter::depart() {
  from_slack_ = slack_;
  from_small_ = slack_ == 0 && position_[0].is_small() && position_[1].is_small() && position_[2].is_small();
  for (std::size_t i = 0; i < 3; ++i) small_from_[i] = position_[i].small();
  if (!from_small_) [[unlikely]]
    from_ = {position_[0], position_[1], position_[2]};
}

inline void Interpreter::arrive(Displacement& travel) {
  const bool small = position_[0].is_small() && position_[1].is_small() && position_[2].is_small();
  if (small && from_small_) [[likely]] {
    set_displacement(travel, position_[0].small() - small_from_[0], position_[1].small() - small_from_[1],
                     position_[2].small() - small_from_[2]);
    return;
  }
  if (from_small_)
    for (std::size_t i = 0; i < 3; ++i) from_[i].set_small(small_from_[i]);
  set_displacement(travel, from_, {position_[0], position_[1], position_[2]}, from_slack_);
}

// X, Y and Z as plain usual numbers: two of three divisions at once.
inline bool Interpreter::place_xyz(const Block& block) {
  static constexpr std::array<std::uint64_t, 8> kMost = [] {
    std::array<std::uint64_t, 8> most{};
    std::ranges::copy(Count::kMostDigits, most.begin());
    return most;
  }();
  const spec::klartext::Value& x = block.axis[0];
  const spec::klartext::Value& y = block.axis[1];
  const spec::klartext::Value& z = block.axis[2];
  using spec::klartext::ParameterKind;
  if (x.parameter.kind != ParameterKind::none || y.parameter.kind != ParameterKind::none ||
      z.parameter.kind != ParameterKind::none) [[unlikely]]
    return false;
  if ((x.number.decimals | y.number.decimals | z.number.decimals) >= kMost.size()) [[unlikely]]
    return false;
  if (x.number.digits > kMost[x.number.decimals] || y.number.digits > kMost[y.number.decimals] ||
      z.number.digits > kMost[z.number.decimals]) [[unlikely]]
    return false;
  const std::array<std::int64_t, 3> small{Count::small_of_usual(x.number), Count::small_of_usual(y.number),
                                          Count::small_of_usual(z.number)};
  for (std::size_t i = 0; i < 3; ++i) position_[i].set_small(small[i]);
  constexpr auto kOne = static_cast<double>(Count::kSmallPerOne);
  head_.xyz.xy = DoublePair{static_cast<double>(small[0]), static_cast<double>(small[1])} / kOne;
  head_.xyz.z = static_cast<double>(small[2]) / kOne;
  return true;
}

inline Alarm Interpreter::place(const Block& block, Functions functions) {
  const bool travels = compensates() || peripheral_.holds();
  if (travels) depart();
  const unsigned shifted = shifted_ && (functions & kMachine) == 0 ? ~kRotarySlots : 0U;
  // Slots whose word is more than a plain position.
  const unsigned relative = block.incremental | shifted;
  unsigned rotary = 0;
  unsigned rest = block.axes;
  if ((rest & kMainSlots) == kMainSlots && (relative & kMainSlots) == 0 && place_xyz(block)) [[likely]]
    rest &= ~kMainSlots;
  for (; rest != 0; rest &= rest - 1) {
    const auto slot = static_cast<std::size_t>(std::countr_zero(rest));
    const std::size_t axis = axis_[slot];
    if (axis == spec::Axes::kNone) [[unlikely]]
      continue;  // refused by the reader
    const unsigned bit = 1U << slot;
    if ((bit & kRotarySlots) != 0) rotary |= 1U << axis;
    const spec::klartext::Value& word = block.axis[slot];
    if (word.parameter.kind == spec::klartext::ParameterKind::none && (relative & bit) == 0) [[likely]] {
      if (const std::int64_t small = Count::small_of(word.number); small != Count::kNotSmall) [[likely]] {
        position_[slot].set_small(small);
        write_position(slot, Count::nearest_small(small));
        continue;
      }
    }
    if (const Alarm a = place_word(block, slot, (shifted & bit) != 0)) return a;
  }
  head_.rotary = static_cast<std::uint16_t>(rotary);
  head_.more_axes = static_cast<std::uint16_t>(rotary | parallel_axes_);
  if ((unknown_ | rounded_) != 0) [[unlikely]]
    if (const Alarm a = settle(block)) return a;
  if (travels) arrive(peripheral_.next().travel);
  return AlarmCause::none;
}

Alarm Interpreter::place_word(const Block& block, std::size_t slot, bool shifted) {
  Count value;
  if (!parameters_.read(block.axis[slot], value)) return AlarmCause::position_range;
  if (block.is_incremental(slot) && (unknown_ >> slot & 1U) != 0) return AlarmCause::none;  // settle() ends the run
  if (block.is_incremental(slot))
    value += position_[slot];
  else if (shifted)
    value += shift_[slot];
  if (!value.in_range()) return AlarmCause::position_range;
  set_position(slot, value);
  return AlarmCause::none;
}

Alarm Interpreter::line(const Block& block, Functions functions) {
  modal_words(block);
  if (block.feed != FeedWord::none)
    if (const Alarm a = feed(block, false)) return a;
  if (block.axes == 0 && !moves_without_words(block)) return AlarmCause::none;
  head_.rapid = block.feed == FeedWord::f_max;
  head_.feed = feed_;
  head_.warnings = block.many_digits ? kDigits : 0;
  if (block.axes == 0) [[unlikely]] {
    if (const Alarm a = place_without_words(block)) return a;
  } else if (const Alarm a = place(block, functions)) {
    return a;
  }
  if ((block.axes & kRotarySlots) != 0) {
    by_vector_ = false;
    if (tcpm_) turn_by_positions();
  }
  if (side_ == 0) {
    plain_motion();
    return AlarmCause::none;
  }
  if (!tcpm_) {
    out_of_scope();
    return AlarmCause::none;
  }
  if (!tool_.called()) return AlarmCause::no_tool;
  if (const Alarm a = tool_.check(false, oversize_)) return a;
  peripheral_motion();
  return AlarmCause::none;
}

Alarm Interpreter::line_with_vectors(const Block& block, Functions functions) {
  modal_words(block);
  if (block.feed != FeedWord::none) [[unlikely]]
    if (const Alarm a = feed(block, false)) return a;
  head_.rapid = block.feed == FeedWord::f_max;
  head_.feed = feed_;
  unsigned warnings = block.many_digits ? kDigits : 0;
  if (block.has_tool_vector && !tcpm_) warnings |= kToolVectorIgnored;
  const bool turned = tcpm_ && block.has_tool_vector;
  if (turned && !new_direction().set(block.tool_vector)) [[unlikely]]
    warnings |= kToolNotNormalized;
  if (block.has_normal) [[likely]]
    return line_with_normal(block, functions, warnings, turned);
  if (const Alarm a = place(block, functions)) return a;
  if (!tool_.called()) return AlarmCause::no_tool;
  if (const Alarm a = tool_.check(false, oversize_)) return a;
  if (side_ == 0) warnings |= kNoLateral;
  head_.warnings = static_cast<Warnings>(warnings);
  if (side_ == 0)
    plain_motion();
  else if (!tcpm_)
    out_of_scope();
  else
    peripheral_motion();
  return AlarmCause::none;
}

// What takes the longest begins first: vectors, then the place, then what follows from both.
inline Alarm Interpreter::line_with_normal(const Block& block, Functions functions, unsigned warnings, bool turned) {
  face_.take_normal(block.normal);
  const bool along = tcpm_ && !turned;
  if (along) new_direction().set(face_.normal(), face_.unit_normal());
  const FaceMilling::Meeting meeting = face_.meet(*direction_, along, tool_);
  if (const Alarm a = place(block, functions)) [[unlikely]]
    return a;
  if (!tool_.called()) [[unlikely]]
    return AlarmCause::no_tool;
  if (side_ != 0) [[unlikely]]
    return AlarmCause::normal_with_radius_compensation;
  if (const Alarm a = face_.check(meeting, *direction_, tool_, oversize_)) [[unlikely]]
    return a;
  if (!release_before_motion()) [[unlikely]]
    return AlarmCause::none;
  head_.warnings = static_cast<Warnings>(warnings);
  face_.mill(head_, meeting, *direction_, programmed_point(), tool_, cause());
  return AlarmCause::none;
}

bool Interpreter::release_before_motion() {
  head_.cancels = false;
  if (!peripheral_.holds()) [[likely]]
    return true;
  head_.cancels = true;
  if (const Alarm a = peripheral_.follow()) {
    raise_at_held(a);
    return false;
  }
  return true;
}

void Interpreter::peripheral_motion() {
  face_.forget();
  head_.cancels = false;
  PeripheralMotion& motion = peripheral_.next();
  motion.head.copy(head_);
  motion.tool.copy(*direction_);
  motion.side = side_;
  const ToolValues& values = tool_.values();
  motion.radius_delta = values.radius_delta;
  motion.effective_corner = values.effective_corner;
  motion.length = values;
  const ProgrammedPoint programmed = programmed_point();
  motion.tip_below = programmed.tip_below(values, true);
  motion.lateral = programmed.lateral(values);
  if (const Alarm a = peripheral_.hold()) raise_at_held(a);
}

void Interpreter::plain_motion() {
  face_.forget();
  if (!release_before_motion()) return;
  const ToolValues& values = tool_.values();
  Placement placement;
  placement.tool = direction_->unit();
  placement.tip = placement.tool * -programmed_point().tip_below(values, false);
  placement.shift = zero_vector();
  placement.corner = values.effective_corner;
  writer_.move(head_, placement, values, cause());
}

void Interpreter::out_of_scope() {
  face_.forget();
  if (!release_before_motion()) return;
  writer_.warnings(head_, head_.warnings);
  writer_.undecided(head_);
}

}  // namespace toolcomp::fast::klartext

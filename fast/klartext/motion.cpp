// Blocks that move: L and LN.
#include <bit>

#include "fast/fault.h"
#include "fast/klartext/interpreter.h"

namespace toolcomp::fast::klartext {
namespace {

using spec::klartext::FeedWord;
using spec::klartext::kAxisLetters;
using spec::klartext::RadiusWord;

constexpr std::size_t kRotarySlot = 3;  // A, B, C
constexpr unsigned kRotarySlots = 0b111U << kRotarySlot;

}  // namespace

void Interpreter::set_position(std::size_t slot, const Count& value) {
  position_[slot] = value;
  head_.position[axis_[slot]] = value.nearest();
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
  from_small_ = position_[0].is_small() && position_[1].is_small() && position_[2].is_small();
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
  set_displacement(travel, from_, {position_[0], position_[1], position_[2]}, 0);
}

inline Alarm Interpreter::place(const Block& block, Functions functions) {
  const bool travels = compensates() || peripheral_.holds();
  if (travels) depart();
  const unsigned shifted = shifted_ && (functions & kMachine) == 0 ? ~kRotarySlots : 0U;
  // Slots whose word is more than a plain position.
  const unsigned relative = block.incremental | shifted;
  unsigned rotary = 0;
  for (unsigned rest = block.axes; rest != 0; rest &= rest - 1) {
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
        head_.position[axis] = Count::nearest_small(small);
        continue;
      }
    }
    if (const Alarm a = place_word(block, slot, (shifted & bit) != 0)) return a;
  }
  head_.rotary = static_cast<std::uint16_t>(rotary);
  if (travels) arrive(peripheral_.next().travel);
  return alarm::kNone;
}

Alarm Interpreter::place_word(const Block& block, std::size_t slot, bool shifted) {
  Count value;
  if (!parameters_.read(block.axis[slot], value)) return alarm::kRange;
  if (block.is_incremental(slot))
    value += position_[slot];
  else if (shifted)
    value += shift_[slot];
  if (!value.in_range()) return alarm::kRange;
  set_position(slot, value);
  return alarm::kNone;
}

Alarm Interpreter::line(const Block& block, Functions functions) {
  modal_words(block);
  if (block.feed != FeedWord::none)
    if (const Alarm a = feed(block, false)) return a;
  if (block.axes == 0) return alarm::kNone;
  head_.rapid = block.feed == FeedWord::f_max;
  head_.feed = feed_;
  head_.warnings = block.many_digits ? kDigits : 0;
  if (const Alarm a = place(block, functions)) return a;
  if (tcpm_ && (block.axes & kRotarySlots) != 0)
    direction_.turn(tool_axis_, {position_[kRotarySlot], position_[kRotarySlot + 1], position_[kRotarySlot + 2]});
  if (side_ == 0) {
    plain_motion();
    return alarm::kNone;
  }
  if (!tcpm_) {
    out_of_scope();
    return alarm::kNone;
  }
  if (!tool_.called()) return alarm::kNoTool;
  if (const Alarm a = tool_.check(false, oversize_)) return a;
  peripheral_motion();
  return alarm::kNone;
}

Alarm Interpreter::line_with_vectors(const Block& block, Functions functions) {
  modal_words(block);
  if (block.feed != FeedWord::none) [[unlikely]]
    if (const Alarm a = feed(block, false)) return a;
  head_.rapid = block.feed == FeedWord::f_max;
  head_.feed = feed_;
  if (const Alarm a = place(block, functions)) [[unlikely]]
    return a;
  unsigned warnings = block.many_digits ? kDigits : 0;
  if (block.has_tool_vector && !tcpm_) warnings |= kToolVectorIgnored;

  if (!tool_.called()) [[unlikely]]
    return alarm::kNoTool;
  const bool turned = tcpm_ && block.has_tool_vector;
  if (turned) {
    direction_.set(block.tool_vector);
    if (not_normalized(direction_.vector())) [[unlikely]]
      warnings |= kToolNotNormalized;
  }
  if (!block.has_normal) {
    if (const Alarm a = tool_.check(false, oversize_)) return a;
    if (side_ == 0) warnings |= kNoLateral;
    head_.warnings = static_cast<Warnings>(warnings);
    if (side_ == 0)
      plain_motion();
    else if (!tcpm_)
      out_of_scope();
    else
      peripheral_motion();
    return alarm::kNone;
  }
  if (side_ != 0) [[unlikely]]
    return alarm::kRadiusWithNormal;
  face_.normal().set(block.normal);
  const bool along = tcpm_ && !turned;
  if (along) direction_.set(face_.normal());
  if (const Alarm a = face_.check(direction_, along, tool_, oversize_)) [[unlikely]]
    return a;
  if (!release_before_motion()) [[unlikely]]
    return alarm::kNone;
  head_.warnings = static_cast<Warnings>(warnings);
  face_.mill(head_, direction_, along, programmed_point(), tool_, cause());
  return alarm::kNone;
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
  motion.head = head_;
  motion.tool.copy(direction_);
  motion.side = side_;
  motion.values = tool_.values();
  const ProgrammedPoint programmed = programmed_point();
  motion.tip_below = programmed.tip_below(motion.values, true);
  motion.lateral = programmed.lateral(motion.values);
  if (const Alarm a = peripheral_.hold()) raise_at_held(a);
}

void Interpreter::plain_motion() {
  face_.forget();
  if (!release_before_motion()) return;
  const ToolValues& values = tool_.values();
  Placement placement;
  placement.tool = direction_.unit();
  placement.tip = placement.tool * -programmed_point().tip_below(values, false);
  placement.shift = zero_vector();
  placement.corner = values.corner;
  writer_.move(head_, placement, values, cause());
}

void Interpreter::out_of_scope() {
  face_.forget();
  if (!release_before_motion()) return;
  writer_.warnings(head_, head_.warnings);
  writer_.undecided(head_);
}

}  // namespace toolcomp::fast::klartext

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

inline bool Interpreter::place_usual(const Block& block) {
  if (block.axes != 0b111U || block.incremental != 0 || shifted_ || compensates() || peripheral_.holds()) [[unlikely]]
    return false;
  std::array<std::int64_t, 3> small;  // NOLINT(cppcoreguidelines-pro-type-member-init): written below
  for (std::size_t i = 0; i < 3; ++i) {
    if (block.axis[i].parameter.kind != spec::klartext::ParameterKind::none) [[unlikely]]
      return false;
    small[i] = Count::small_of(block.axis[i].number);
    if (small[i] == Count::kNotSmall) [[unlikely]]
      return false;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    position_[i].set_small(small[i]);
    head_.position[axis_[i]] = Count::nearest_small(small[i]);
  }
  head_.rotary = 0;
  return true;
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

Alarm Interpreter::place(const Block& block, Functions functions) {
  if (compensates() || peripheral_.holds()) [[unlikely]]
    from_ = {position_[0], position_[1], position_[2]};
  const bool shifted = shifted_ && (functions & kMachine) == 0;
  unsigned rotary = 0;
  for (unsigned rest = block.axes; rest != 0; rest &= rest - 1) {
    const auto slot = static_cast<std::size_t>(std::countr_zero(rest));
    if (axis_[slot] == spec::Axes::kNone) continue;  // refused by the reader
    Count value;
    if (!parameters_.read(block.axis[slot], value)) [[unlikely]]
      return alarm::kRange;
    if (block.is_incremental(slot)) [[unlikely]]
      value += position_[slot];
    else if (shifted && (kRotarySlots >> slot & 1U) == 0) [[unlikely]]
      value += shift_[slot];
    if (!value.in_range()) [[unlikely]]
      return alarm::kRange;
    set_position(slot, value);
    if ((kRotarySlots >> slot & 1U) != 0) rotary |= 1U << axis_[slot];
  }
  head_.rotary = static_cast<std::uint16_t>(rotary);
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
  if (!place_usual(block)) [[unlikely]]
    if (const Alarm a = place(block, functions)) return a;
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
  Displacement& travel = peripheral_.next().travel;
  set_displacement(travel, from_, {position_[0], position_[1], position_[2]}, 0);
  head_.cancels = true;
  if (const Alarm a = peripheral_.follow(travel)) {
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
  set_displacement(motion.travel, from_, {position_[0], position_[1], position_[2]}, 0);
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

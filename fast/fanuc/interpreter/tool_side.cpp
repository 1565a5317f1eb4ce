// Blocks that pass tool side compensation: what the stage is told about each.
#include "fast/fanuc/interpreter/interpreter.h"

#include <bit>

namespace toolcomp::fast {

CutterSide Interpreter::tool_side(Code code) {
  switch (code) {
    case kNone:
      return CutterSide::unchanged;
    case 412:
    case 416:
      return CutterSide::left;
    case 422:
    case 426:
      return CutterSide::right;
    default:
      return CutterSide::off;  // of the same group
  }
}

// The code of a block, and the value of its number. cutter_number_ is taken already.
void Interpreter::begin_tool_side(const Words& words) {
  const CutterSide word = tool_side(words.code(Words::kCompensation));
  const CutterSide before = tool_side_word_;
  if (word != CutterSide::unchanged) tool_side_word_ = word;
  tool_side_.next().repeated = word == before && word != CutterSide::off;
  tool_side_wanted_ = tool_side_word_ != CutterSide::off && cutter_number_.number != 0;
  if (tool_side_word_ == CutterSide::off) return;
  if (before == CutterSide::off || commanded_number(words) || takes_edited_value()) {
    cutter_offset_ = cutter_value(cutter_number_);
    cutter_edited_ = false;
    tool_side_.set_value(cutter_offset_ < Count() ? -cutter_offset_ : cutter_offset_);
  }
  tool_side_sign_ = (tool_side_word_ == CutterSide::right) == (cutter_offset_ < Count()) ? 1 : -1;
}

// Everything about a line but Q and where it ends.
void Interpreter::start_tool_side_leg(ToolSideBlock& block) const {
  block.wanted = tool_side_wanted_;
  block.side = tool_side_sign_;
  block.treatment = Treatment::none;
  block.arc = false;
}

// Positions, under G43.5 I J K, and F, or nothing but its number.
Alarm Interpreter::tool_side_move(const Words& words) {
  direction_before_ = direction_;
  if (by_vector_ && !plans_tool_) direct(words);
  tool_side_.next().repeated = false;
  return tool_side_motion(words, false, std::nullopt, ArcWords{});
}

// The offsets of length are far below what the sum with a word of few digits could take.
void Interpreter::await_side_lines() {
  constexpr std::int64_t kMostOffset = std::int64_t{1} << 48U;
  constexpr Mask kXyz = 0b111;
  const auto is_usual = [](const Count& count, std::int64_t most) {
    return count.is_small() && count.small() <= most && count.small() >= -most;
  };
  const Count& x = programmed_[0];
  const Count& y = programmed_[1];
  const Count& z = programmed_[2];
  side_letters_ = 0;
  if (!tool_side_.awaits_line() || motion_ > 10 || takes_edited_value() || length_.pending()) return;
  if (!letters_.xyz_first || !plain_words_ || rounded_ != 0 || tool_offset_.live() != 0 || stale_ != 0) return;
  if (plans_tool_ || tip_.active() || (along_tool() && tip_.samples())) return;
  if (incremental_ && fault(Fault::incremental_from_offset_position)) return;
  if (!x.is_small() || !y.is_small() || !z.is_small()) return;
  for (std::size_t axis = 0; axis < count_; ++axis)
    if (!is_usual(length_[axis], kMostOffset)) return;
  const auto letter = [](char name) { return std::size_t{static_cast<unsigned char>(name)} - 'A' + 1; };
  side_letters_ = 1U << letter('X') | 1U << letter('Y') | 1U << letter('Z') | 1U << letter('F') | 1U << letter('G');
  if (along_tool()) {
    if (by_vector_) side_letters_ |= Words::set_of("IJK") << 1U;
  } else {
    for (std::size_t axis = 3; axis < count_; ++axis) side_letters_ |= std::uint32_t{2} << letters_.index[axis];
  }
  for (std::size_t i = 0; i < 3; ++i) side_word_[letter('X') + i] = programmed_[i].small();
  side_at_ = {static_cast<double>(x.small()), static_cast<double>(y.small()), static_cast<double>(z.small())};
  side_plain_ = linear_ == kXyz && length_.live() == 0 && (!along_tool() || (along_length_ == 0 && displaced_ == 0));
  tool_side_.await_lines(side_plain_);
}

void Interpreter::side_block(const spec::Block& block) {
  if (side_line(block)) [[likely]]
    return;
  leave_side_lines();
  any_block(block);
}

[[gnu::always_inline]] inline bool Interpreter::side_line(const spec::Block& block) {
  if (stopped_ || block.alarm) [[unlikely]]
    return false;
  constexpr std::size_t kF = 'F' - 'A' + 1;
  constexpr std::size_t kG = 'G' - 'A' + 1;
  constexpr std::size_t kI = 'I' - 'A' + 1;
  constexpr std::size_t kX = 'X' - 'A' + 1;
  constexpr std::uint32_t kDirection = Words::set_of("IJK") << 1U;
  constexpr std::uint32_t kXyz = Words::set_of("XYZ") << 1U;
  constexpr std::uint32_t kXyzF = kXyz | 1U << kF | 1U << kG;
  side_word_[kI] = 0;
  side_word_[kI + 1] = 0;
  side_word_[kI + 2] = 0;
  if (incremental_) [[unlikely]]
    for (std::size_t i = 0; i < 3; ++i) side_word_[kX + i] = 0;
  std::uint32_t letters = 0;
  std::uint64_t digits = 0;
  unsigned shapes = 0;
  for (const spec::Word& word : block.words()) {
    const std::size_t letter = static_cast<unsigned char>(word.address) & 31U;
    letters |= std::uint32_t{1} << letter;
    digits |= word.value.digits;
    shapes |= Count::shape(word.value) + 1U;
    side_word_[letter] = Count::small_of_short(word.value);
  }
  if ((letters & ~side_letters_) != 0 || !Count::are_short(digits, shapes) || letters == 0) [[unlikely]]
    return false;
  // The code in force again, and no other.
  if ((letters & 1U << kG) != 0 && (10 * side_word_[kG] != motion_ * Count::kSmallPerOne ||
                                    static_cast<std::size_t>(std::popcount(letters)) != block.words().size()))
    return false;
  // X and Y side by side: made so at once, and never apart in memory.
  DoublePair xy{static_cast<double>(side_word_[kX]), static_cast<double>(side_word_[kX + 1])};
  auto z = static_cast<double>(side_word_[kX + 2]);
  const std::int64_t i = side_word_[kI];
  const std::int64_t j = side_word_[kI + 1];
  const std::int64_t k = side_word_[kI + 2];
  const bool directed = (letters & kDirection) != 0;
  if (directed && (i | j | k) == 0) [[unlikely]]
    return false;
  if (incremental_) [[unlikely]] {
    if ((letters & ~kXyzF) != 0 && !directed) return false;
    xy += load_pair(&side_at_.x);
    z += side_at_.z;
    constexpr auto kLimit = static_cast<double>(std::int64_t{1} << 52U);
    if (std::abs(xy[0]) > kLimit || std::abs(xy[1]) > kLimit || std::abs(z) > kLimit) return false;
  }
  const DoublePair way_xy = xy - load_pair(&side_at_.x);
  const Vector3<double> way{way_xy[0], way_xy[1], z - side_at_.z};
  LineCorner corner;
  if (!tool_side_.see_line(way, corner)) [[unlikely]]
    return false;

  // What is done until the line is taken is of no harm where it is not.
  const std::uint8_t direction = direction_;
  if ((letters & ~kXyzF) != 0) {
    if (directed) {
      set_small_direction(new_direction(), i, j, k);
    } else {
      // Of those at a new place: a tool that stands still is not turned.
      unsigned turned = 0;
      for (unsigned rest = letters_.positions(letters >> 1U) & ~0b111U; rest != 0; rest &= rest - 1) {
        const auto axis = static_cast<std::size_t>(__builtin_ctz(rest));
        const std::int64_t small = side_word_[letters_.index[axis] + 1U];
        Count& place = programmed_[axis];
        if (place.is_small() && place.small() == small) continue;
        turned |= bit(axis);
        place.set_small(small);
        const double position = Count::nearest_small(small);
        programmed_value_[axis] = position;
        axes_value_[axis] = position;
        if ((length_.live() & bit(axis)) != 0) [[unlikely]]
          add_offset(axis);
      }
      if ((turned & turning_) != 0) turn();
    }
  }
  if ((letters & 1U << kF) != 0) [[unlikely]] {
    feed_ = Count::nearest_small(side_word_[kF]);
    tool_side_.await_lines(side_plain_);
  }
  fill_side_line(block, xy, z);
  if (!tool_side_.take_line(way, corner, directions_[direction_])) [[unlikely]] {
    direction_ = direction;
    return false;
  }
  store_pair(&side_at_.x, xy);
  side_at_.z = z;
  return true;
}

[[gnu::always_inline]] inline void Interpreter::fill_side_line(const spec::Block& block, DoublePair xy, double z) {
  Event& event = tool_side_.next().event;
  if (!tool_side_.is_line_filled() || !side_plain_) [[unlikely]] {
    place_side_lines(xy[0], xy[1], z);
    line_ = block.line;
    n_ = block.n;
    fill(event, straight(), spec::Cause::programmed);
    if (!side_plain_) return;
  }
  event.line = block.line;
  event.n = block.n;
  constexpr auto kPerOne = static_cast<double>(Count::kSmallPerOne);
  store_pair(event.programmed.value.data(), xy / kPerOne);
  event.programmed.value[2] = z / kPerOne;
  if (count_ > 3) {
    // Two on most machines: the one that is not there is not looked at.
    for (std::size_t axis = 3; axis < 5; ++axis) event.axes.value[axis] = axes_value_[axis];
    for (std::size_t axis = 5; axis < count_; ++axis) event.axes.value[axis] = axes_value_[axis];
  }
  if (event.tool_axis) {
    const Eigen::Vector3d& unit = directions_[direction_].unit;
    for (std::size_t i = 0; i < 3; ++i) (*event.tool_axis)[i] = unit[static_cast<Eigen::Index>(i)] + 0.0;  // never -0
  }
}

void Interpreter::place_side_lines(double x, double y, double z) {
  const std::array<double, 3> at{x, y, z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    programmed_[axis].set_small(static_cast<std::int64_t>(at[axis]));
    const double position = programmed_[axis].nearest();
    programmed_value_[axis] = position;
    axes_value_[axis] = position;
    if ((length_.live() & bit(axis)) != 0) add_offset(axis);
  }
}

void Interpreter::leave_side_lines() {
  place_side_lines(side_at_.x, side_at_.y, side_at_.z);
  side_letters_ = 0;
}

Alarm Interpreter::tool_side_motion(const Words& words, bool extra, const std::optional<spec::Arc<double>>& arc,
                                    const ArcWords& arc_words) {
  ToolSideBlock& block = tool_side_.next();
  const Mask axes = words.axes();
  start_tool_side_leg(block);
  const std::uint32_t q = words.has('Q') ? whole_number(words['Q'], 3) : 0;
  block.treatment = static_cast<Treatment>(q > 3 ? 0 : q);
  std::array<Count, 3> from;
  std::array<Count, 3> to;
  Mask xyz = 0;
  for (std::size_t i = 0; i < 3; ++i)
    if (xyz_[i] != spec::Axes::kNone) {
      from[i] = programmed_[xyz_[i]];
      xyz = static_cast<Mask>(xyz | bit(xyz_[i]));
    }
  if (arc) {
    block.arc = true;
    block.clockwise = arc_words.clockwise;
    block.by_radius = arc_words.by_radius;
    block.to_center = arc_words.to_center;
    block.radius = arc_words.radius;
    block.axis = plane_axes(plane_);
    for (std::size_t i = 0; i < 2; ++i) {
      block.in[i] = in_plane(plane_, i);
      block.start[i] = actual(block.axis[i]);
    }
  }

  Mask rounded = rounded_;
  if (const Alarm a = place_words(words, axes)) return a;

  rounded = static_cast<Mask>((rounded | rounded_) & axes & xyz);
  for (std::size_t i = 0; i < 3; ++i)
    if (xyz_[i] != spec::Axes::kNone) to[i] = programmed_[xyz_[i]];
  set_travel(tool_side_.next_travel(), from, to, rounded != 0 ? 2 : 0);
  block.tool = &directions_[direction_];
  block.tool_before = &directions_[direction_before_];
  block.own = axes != 0 || extra || arc || (by_vector_ && words.has_any(Words::set_of("IJK")));
  fill(block.event, arc ? spec::MoveType::arc : straight(), spec::Cause::programmed);
  if (arc) {
    block.event.arc = arc;
    for (std::size_t i = 0; i < 2; ++i) block.end[i] = actual(block.axis[i]);
  }
  if (const StageEnd end = tool_side_.block())
    end_run(end);
  else
    await_side_lines();
  return alarm::kNone;
}

}  // namespace toolcomp::fast

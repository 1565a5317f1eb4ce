// The usual line under tool side compensation: straight from the words of the block to the stage.
#include <bit>

#include "fast/fanuc/interpreter/interpreter.h"
#include "fast/fanuc/interpreter/usual_words.h"
#include "fast/fanuc/tool_side_compensation/usual_line.h"

namespace toolcomp::fast {
namespace {

// Of side_lines_.word and of the letters.
constexpr std::size_t kF = 'F' - 'A' + 1;
constexpr std::size_t kG = 'G' - 'A' + 1;
constexpr std::size_t kI = 'I' - 'A' + 1;
constexpr std::size_t kX = 'X' - 'A' + 1;
constexpr std::uint32_t kDirection = Words::set_of("IJK") << 1U;
constexpr std::uint32_t kXyzF = Words::set_of("XYZ") << 1U | 1U << kF | 1U << kG;

}  // namespace

// The offsets of length are far below what the sum with a word of few digits could take.
void Interpreter::await_side_lines() {
  constexpr std::int64_t kMostOffset = std::int64_t{1} << 48U;
  constexpr Mask kXyz = 0b111;
  const auto is_usual = [](const Count& count, std::int64_t most) {
    return count.is_small() && count.small() <= most && count.small() >= -most;
  };
  const Count& x = positions_.programmed()[0];
  const Count& y = positions_.programmed()[1];
  const Count& z = positions_.programmed()[2];
  side_lines_.letters = 0;
  if (!tool_side_.awaits_line() || modal_.motion() > 10 || cutter_value_.takes_edited() ||
      positions_.length().pending())
    return;
  if (!axes_.letters.xyz_first || !units_.plain() || positions_.rounded() != 0 ||
      positions_.tool_offset().live() != 0 || positions_.stale() != 0)
    return;
  if (attitude_.plans_tool() || attitude_.tip().active() || (positions_.along_tool() && attitude_.tip().samples()))
    return;
  if (modal_.incremental() && fault(Fault::incremental_from_offset_position)) return;
  if (!x.is_small() || !y.is_small() || !z.is_small()) return;
  for (std::size_t axis = 0; axis < axes_.count; ++axis)
    if (!is_usual(positions_.length()[axis], kMostOffset)) return;
  const auto letter = [](char name) { return std::size_t{static_cast<unsigned char>(name)} - 'A' + 1; };
  side_lines_.letters =
      1U << letter('X') | 1U << letter('Y') | 1U << letter('Z') | 1U << letter('F') | 1U << letter('G');
  if (positions_.along_tool()) {
    if (modal_.by_vector()) side_lines_.letters |= Words::set_of("IJK") << 1U;
  } else {
    for (std::size_t axis = 3; axis < axes_.count; ++axis)
      side_lines_.letters |= std::uint32_t{2} << axes_.letters.index[axis];
  }
  for (std::size_t i = 0; i < 3; ++i) side_lines_.word[letter('X') + i] = positions_.programmed()[i].small();
  side_lines_.at = {static_cast<double>(x.small()), static_cast<double>(y.small()), static_cast<double>(z.small())};
  side_lines_.plain = axes_.linear == kXyz && positions_.length().live() == 0 &&
                      (!positions_.along_tool() || (attitude_.along_length() == 0 && positions_.displaced() == 0));
  tool_side_.await_lines(side_lines_.plain);
}

void Interpreter::side_block(const spec::Block& block) {
  if (side_line(block)) [[likely]]
    return;
  leave_side_lines();
  any_block(block);
}

// The words of the line, and which letters there are. False: not those of a usual line.
[[gnu::always_inline]] inline bool Interpreter::read_side_line(const spec::Block& block, std::uint32_t& letters) {
  side_lines_.word[kI] = 0;
  side_lines_.word[kI + 1] = 0;
  side_lines_.word[kI + 2] = 0;
  if (modal_.incremental()) [[unlikely]]
    for (std::size_t i = 0; i < 3; ++i) side_lines_.word[kX + i] = 0;
  letters = 0;
  std::uint64_t digits = 0;
  unsigned shapes = 0;
  for (const spec::Word& word : block.words()) {
    const std::size_t letter = static_cast<unsigned char>(word.address) & 31U;
    letters |= std::uint32_t{1} << letter;
    digits |= word.value.digits;
    shapes |= Count::shape(word.value) + 1U;
    side_lines_.word[letter] = Count::small_of_short(word.value);
  }
  if ((letters & ~side_lines_.letters) != 0 || !Count::are_short(digits, shapes) || letters == 0) [[unlikely]]
    return false;
  // The code in force again, and no other.
  if ((letters & 1U << kG) != 0 && (10 * side_lines_.word[kG] != modal_.motion() * Count::kSmallPerOne ||
                                    static_cast<std::size_t>(std::popcount(letters)) != block.words().size()))
    return false;
  return true;
}

// The direction of the tool by these letters: I J K, or rotary axes.
[[gnu::always_inline]] inline void Interpreter::turn_side_line(std::uint32_t letters,
                                                               const std::array<std::int64_t, 3>& ijk) {
  if ((letters & kDirection) != 0) {
    set_small_direction(attitude_.directions().next(), ijk[0], ijk[1], ijk[2]);
    return;
  }
  // Of those at a new place: a tool that stands still is not turned.
  unsigned turned = 0;
  for (unsigned rest = axes_.letters.positions(letters >> 1U) & ~0b111U; rest != 0; rest &= rest - 1) {
    const auto axis = static_cast<std::size_t>(__builtin_ctz(rest));
    const std::int64_t small = side_lines_.word[axes_.letters.index[axis] + 1U];
    const Count& place = positions_.programmed()[axis];
    if (place.is_small() && place.small() == small) continue;
    turned |= bit(axis);
    positions_.place_small(axis, small);
    if ((positions_.length().live() & bit(axis)) != 0) [[unlikely]]
      positions_.add_offset(axis);
  }
  if ((turned & axes_.turning) != 0) attitude_.turn();
}

[[gnu::always_inline]] inline bool Interpreter::side_line(const spec::Block& block) {
  if (stopped_ || block.alarm) [[unlikely]]
    return false;
  std::uint32_t letters = 0;
  if (!read_side_line(block, letters)) [[unlikely]]
    return false;
  // X and Y side by side: made so at once, and never apart in memory.
  DoublePair xy{static_cast<double>(side_lines_.word[kX]), static_cast<double>(side_lines_.word[kX + 1])};
  auto z = static_cast<double>(side_lines_.word[kX + 2]);
  const std::array<std::int64_t, 3> ijk{side_lines_.word[kI], side_lines_.word[kI + 1], side_lines_.word[kI + 2]};
  if ((letters & kDirection) != 0 && (ijk[0] | ijk[1] | ijk[2]) == 0) [[unlikely]]
    return false;
  if (modal_.incremental()) [[unlikely]] {
    if ((letters & ~kXyzF) != 0 && (letters & kDirection) == 0) return false;
    xy += load_pair(&side_lines_.at.x);
    z += side_lines_.at.z;
    constexpr auto kLimit = static_cast<double>(std::int64_t{1} << 52U);
    if (std::abs(xy[0]) > kLimit || std::abs(xy[1]) > kLimit || std::abs(z) > kLimit) return false;
  }
  const DoublePair way_xy = xy - load_pair(&side_lines_.at.x);
  const Vector3<double> way{way_xy[0], way_xy[1], z - side_lines_.at.z};
  LineCorner corner;
  if (!tool_side_.see_line(way, corner)) [[unlikely]]
    return false;

  // What is done until the line is taken is of no harm where it is not.
  const std::uint8_t direction = attitude_.directions().place();
  if ((letters & ~kXyzF) != 0) turn_side_line(letters, ijk);
  if ((letters & 1U << kF) != 0 && !fault(Fault::usual_side_line_feed)) [[unlikely]] {
    modal_.set_feed(Count::nearest_small(side_lines_.word[kF]));
    tool_side_.await_lines(side_lines_.plain);
  }
  fill_side_line(block, xy, z);
  if (!tool_side_.take_line(way, corner, attitude_.directions().now())) [[unlikely]] {
    attitude_.directions().go_back(direction);
    return false;
  }
  store_pair(&side_lines_.at.x, xy);
  side_lines_.at.z = z;
  return true;
}

[[gnu::always_inline]] inline void Interpreter::fill_side_line(const spec::Block& block, DoublePair xy, double z) {
  Event& event = tool_side_.next().event;
  if (!tool_side_.is_line_filled() || !side_lines_.plain) [[unlikely]] {
    place_side_lines(xy[0], xy[1], z);
    line_ = block.line;
    n_ = block.n;
    fill(event, modal_.straight(), spec::Cause::programmed);
    if (!side_lines_.plain) return;
  }
  event.line = block.line;
  event.n = block.n;
  constexpr auto kPerOne = static_cast<double>(Count::kSmallPerOne);
  store_pair(event.programmed.value.data(), xy / kPerOne);
  event.programmed.value[2] = z / kPerOne;
  if (axes_.count > 3) {
    // Two on most machines: the one that is not there is not looked at.
    for (std::size_t axis = 3; axis < 5; ++axis) event.axes.value[axis] = positions_.sent_to(axis);
    for (std::size_t axis = 5; axis < axes_.count; ++axis) event.axes.value[axis] = positions_.sent_to(axis);
  }
  if (event.tool_axis) {
    const Eigen::Vector3d& unit = attitude_.directions().now().unit;
    for (std::size_t i = 0; i < 3; ++i) (*event.tool_axis)[i] = unit[static_cast<Eigen::Index>(i)] + 0.0;  // never -0
  }
}

void Interpreter::place_side_lines(double x, double y, double z) {
  const std::array<double, 3> at{x, y, z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    positions_.place_small(axis, static_cast<std::int64_t>(at[axis]));
    if ((positions_.length().live() & bit(axis)) != 0) positions_.add_offset(axis);
  }
}

void Interpreter::leave_side_lines() {
  place_side_lines(side_lines_.at.x, side_lines_.at.y, side_lines_.at.z);
  side_lines_.letters = 0;
}

}  // namespace toolcomp::fast

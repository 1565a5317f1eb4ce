// The usual line under tool side compensation: straight from the words of the block to the stage.
#include "fast/fanuc/control/read_words.h"
#include "fast/fanuc/control/usual_words.h"
#include "fast/fanuc/tool_side_compensation/tool_side_stage.h"
#include "fast/fanuc/tool_side_compensation/usual_line.h"

namespace toolcomp::fast {
namespace {

constexpr std::size_t kI = UsualWords::at('I');
constexpr std::size_t kX = UsualWords::at('X');
constexpr std::uint32_t kFeed = UsualWords::set('F');
constexpr std::uint32_t kDirection = UsualWords::set_of("IJK");
constexpr std::uint32_t kXyzF = UsualWords::set_of("XYZFG");

}  // namespace

// The offsets of length are far below what the sum with a word of few digits could take.
void ToolSideStage::await_lines() {
  constexpr std::int64_t kMostOffset = std::int64_t{1} << 48U;
  constexpr Mask kXyz = 0b111;
  const auto is_usual = [](const Count& count, std::int64_t most) {
    return count.is_small() && count.small() <= most && count.small() >= -most;
  };
  const Count& x = control_.positions.programmed()[0];
  const Count& y = control_.positions.programmed()[1];
  const Count& z = control_.positions.programmed()[2];
  if (!compensation_.awaits_line() || !control_.axes.letters.xyz_first || !usual_lines_may_come(control_)) return;
  if (control_.attitude.tip().active() || (control_.positions.along_tool() && control_.attitude.tip().samples()))
    return;
  if (!x.is_small() || !y.is_small() || !z.is_small()) return;
  for (std::size_t axis = 0; axis < control_.axes.count; ++axis)
    if (!is_usual(control_.positions.length()[axis], kMostOffset)) return;
  std::uint32_t letters = kXyzF;
  if (control_.positions.along_tool()) {
    if (control_.modal.by_vector()) letters |= kDirection;
  } else {
    for (std::size_t axis = 3; axis < control_.axes.count; ++axis)
      letters |= std::uint32_t{2} << control_.axes.letters.index[axis];
  }
  lines_.words.permit(letters);
  for (std::size_t i = 0; i < 3; ++i) lines_.words[kX + i] = control_.positions.programmed()[i].small();
  lines_.at = {static_cast<double>(x.small()), static_cast<double>(y.small()), static_cast<double>(z.small())};
  lines_.plain = control_.axes.linear == kXyz && control_.positions.length().live() == 0 &&
                 (!control_.positions.along_tool() ||
                  (control_.attitude.along_length() == 0 && control_.positions.displaced() == 0));
  compensation_.await_lines(lines_.plain);
  others_ = control_.taker;
  control_.taker = this;
}

void ToolSideStage::block(const spec::Block& block) {
  if (take_line(block)) [[likely]]
    return;
  leave_lines();
  others_->block(block);
}

void ToolSideStage::end() {
  leave_lines();
  others_->end();
}

// The words of the line, and which letters there are. False: not those of a usual line.
[[gnu::always_inline]] inline bool ToolSideStage::read_line(const spec::Block& block, std::uint32_t& letters) {
  for (std::size_t i = 0; i < 3; ++i) lines_.words[kI + i] = 0;
  if (control_.modal.incremental()) [[unlikely]]
    for (std::size_t i = 0; i < 3; ++i) lines_.words[kX + i] = 0;
  return lines_.words.read(block, control_.modal.motion(), letters);
}

// The direction of the tool by these letters: I J K, or rotary axes.
[[gnu::always_inline]] inline void ToolSideStage::turn_line(std::uint32_t letters,
                                                            const std::array<std::int64_t, 3>& ijk) {
  if ((letters & kDirection) != 0) {
    set_small_direction(control_.attitude.directions().next(), ijk[0], ijk[1], ijk[2]);
    return;
  }
  // Of those at a new place: a tool that stands still is not turned.
  unsigned turned = 0;
  for (unsigned rest = control_.axes.letters.positions(letters >> 1U) & ~0b111U; rest != 0; rest &= rest - 1) {
    const auto axis = static_cast<std::size_t>(__builtin_ctz(rest));
    const std::int64_t small = lines_.words[control_.axes.letters.index[axis] + 1U];
    const Count& place = control_.positions.programmed()[axis];
    if (place.is_small() && place.small() == small) continue;
    turned |= bit(axis);
    control_.positions.place_small(axis, small);
    if ((control_.positions.length().live() & bit(axis)) != 0) [[unlikely]]
      control_.positions.add_offset(axis);
  }
  if ((turned & control_.axes.turning) != 0) control_.attitude.turn();
}

[[gnu::always_inline]] inline bool ToolSideStage::take_line(const spec::Block& block) {
  if (block.alarm) [[unlikely]]
    return false;
  std::uint32_t letters = 0;
  if (!read_line(block, letters)) [[unlikely]]
    return false;
  // X and Y side by side: made so at once, and never apart in memory.
  DoublePair xy{static_cast<double>(lines_.words[kX]), static_cast<double>(lines_.words[kX + 1])};
  auto z = static_cast<double>(lines_.words[kX + 2]);
  const std::array<std::int64_t, 3> ijk{lines_.words[kI], lines_.words[kI + 1], lines_.words[kI + 2]};
  if ((letters & kDirection) != 0 && (ijk[0] | ijk[1] | ijk[2]) == 0) [[unlikely]]
    return false;
  if (control_.modal.incremental()) [[unlikely]] {
    if ((letters & ~kXyzF) != 0 && (letters & kDirection) == 0) return false;
    xy += load_pair(&lines_.at.x);
    z += lines_.at.z;
    constexpr auto kLimit = static_cast<double>(std::int64_t{1} << 52U);
    if (std::abs(xy[0]) > kLimit || std::abs(xy[1]) > kLimit || std::abs(z) > kLimit) return false;
  }
  const DoublePair way_xy = xy - load_pair(&lines_.at.x);
  const Vector3<double> way{way_xy[0], way_xy[1], z - lines_.at.z};
  LineCorner corner;
  if (!compensation_.see_line(way, corner)) [[unlikely]]
    return false;

  // What is done until the line is taken is of no harm where it is not.
  const std::uint64_t direction = control_.attitude.directions().number();
  if ((letters & ~kXyzF) != 0) turn_line(letters, ijk);
  if ((letters & kFeed) != 0 && !fault(Fault::usual_side_line_feed)) [[unlikely]] {
    control_.modal.set_feed(Count::nearest_small(lines_.words[UsualWords::at('F')]));
    compensation_.await_lines(lines_.plain);
  }
  fill_line(block.line, block.n, xy, z);
  if (!compensation_.take_line(way, corner, control_.attitude.directions().now())) [[unlikely]] {
    control_.attitude.directions().go_back(direction);
    return false;
  }
  store_pair(&lines_.at.x, xy);
  lines_.at.z = z;
  return true;
}

[[gnu::always_inline]] inline void ToolSideStage::fill_line(std::uint64_t line, const std::optional<std::uint64_t>& n,
                                                            DoublePair xy, double z) {
  Event& event = compensation_.next().event;
  if (!compensation_.is_line_filled() || !lines_.plain) [[unlikely]] {
    place_lines(xy[0], xy[1], z);
    control_.line = line;
    control_.n = n;
    control_.fill(event, control_.modal.straight(), spec::Cause::programmed);
    if (!lines_.plain) return;
  }
  event.line = line;
  event.n = n;
  constexpr auto kPerOne = static_cast<double>(Count::kSmallPerOne);
  store_pair(event.programmed.value.data(), xy / kPerOne);
  event.programmed.value[2] = z / kPerOne;
  if (control_.axes.count > 3) {
    // Two on most machines: the one that is not there is not looked at.
    for (std::size_t axis = 3; axis < 5; ++axis) event.axes.value[axis] = control_.positions.sent_to(axis);
    for (std::size_t axis = 5; axis < control_.axes.count; ++axis)
      event.axes.value[axis] = control_.positions.sent_to(axis);
  }
  if (event.tool_axis) {
    const Eigen::Vector3d& unit = control_.attitude.directions().now().unit;
    for (std::size_t i = 0; i < 3; ++i) (*event.tool_axis)[i] = unit[static_cast<Eigen::Index>(i)] + 0.0;  // never -0
  }
}

void ToolSideStage::fill_last_line(std::uint64_t line, const Vector3<double>& at) {
  fill_line(line, std::nullopt, DoublePair{at.x, at.y}, at.z);
}

void ToolSideStage::place_lines(double x, double y, double z) {
  const std::array<double, 3> at{x, y, z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    control_.positions.place_small(axis, static_cast<std::int64_t>(at[axis]));
    if ((control_.positions.length().live() & bit(axis)) != 0) control_.positions.add_offset(axis);
  }
}

void ToolSideStage::leave_lines() {
  place_lines(lines_.at.x, lines_.at.y, lines_.at.z);
  control_.taker = others_;
}

}  // namespace toolcomp::fast

// SPDX-License-Identifier: Apache-2.0
// The usual line under leading edge offset: straight from the words of the block to the stage.
#include <cmath>

#include "fast/fanuc/control/usual_space_lines.h"
#include "fast/fanuc/leading_edge_offset/leading_edge_stage.h"
#include "fast/fanuc/leading_edge_offset/usual_line.h"

namespace toolcomp::fast {

void LeadingEdgeStage::await_lines() {
  if (offset_.awaits_line()) (void)lines_.await(*this);
}

void LeadingEdgeStage::block(const spec::Block& block) {
  if (take_line(block)) [[likely]]
    return;
  leave_lines().block(block);
}

void LeadingEdgeStage::end() { leave_lines().end(); }

BlockTaker& LeadingEdgeStage::leave_lines() {
  offset_.complete_line(control_.attitude.directions().now(), lines_.are_plain());
  return lines_.leave();
}

[[gnu::always_inline]] inline bool LeadingEdgeStage::take_line(const spec::Block& block) {
  UsualSpaceLine line;
  if (!lines_.read(block, line)) [[unlikely]]
    return false;
  // Blocks without movement are counted, and a longer movement is no double for certain.
  constexpr double kMost = 0x1p53;
  const double size = std::abs(line.way.x) + std::abs(line.way.y) + std::abs(line.way.z);
  if (size == 0 || size > kMost) [[unlikely]]
    return false;

  // The move that is held has its vector by this movement and by how the tool stands before it.
  const Direction& before = control_.attitude.directions().now();
  lines_.turn(line);
  offset_.take_line(line.way, before, lines_.are_plain());
  const bool feed = UsualSpaceLines::names_feed(line);
  if (feed) [[unlikely]]
    lines_.take_feed();
  lines_.fill(offset_.held_event(), !feed, block.line, block.n, line.xy, line.z);
  lines_.go_to(line);
  return true;
}

}  // namespace toolcomp::fast

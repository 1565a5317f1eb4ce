// SPDX-License-Identifier: Apache-2.0
// The usual line under tool side compensation: straight from the words of the block to the stage.
#include "fast/fanuc/control/usual_space_lines.h"
#include "fast/fanuc/tool_side_compensation/tool_side_stage.h"
#include "fast/fanuc/tool_side_compensation/usual_line.h"

namespace toolcomp::fast {

void ToolSideStage::await_usual() {
  if (!refuses_arcs_ && compensation_.awaits_paths() && paths_.await()) return;
  if (compensation_.awaits_line() && lines_.await(*this)) compensation_.await_lines(lines_.are_plain());
}

void ToolSideStage::block(const spec::Block& block) {
  if (take_line(block)) [[likely]]
    return;
  lines_.leave().block(block);
}

void ToolSideStage::end() { lines_.leave().end(); }

[[gnu::always_inline]] inline bool ToolSideStage::take_line(const spec::Block& block) {
  UsualSpaceLine line;
  if (!lines_.read(block, line)) [[unlikely]]
    return false;
  LineCorner corner;
  if (!compensation_.see_line(line.way, corner)) [[unlikely]]
    return false;

  // What is done until the line is taken is of no harm where it is not.
  const std::uint64_t direction = control_.attitude.directions().number();
  lines_.turn(line);
  if (UsualSpaceLines::names_feed(line)) [[unlikely]] {
    lines_.take_feed();
    compensation_.await_lines(lines_.are_plain());
  }
  fill_line(block.line, block.n, line.xy, line.z);
  if (!compensation_.take_line(line.way, corner, control_.attitude.directions().now())) [[unlikely]] {
    control_.attitude.directions().go_back(direction);
    return false;
  }
  lines_.go_to(line);
  return true;
}

[[gnu::always_inline]] inline void ToolSideStage::fill_line(std::uint64_t line, const std::optional<std::uint64_t>& n,
                                                            DoublePair xy, double z) {
  const bool filled = compensation_.is_line_filled();
  lines_.fill(compensation_.next().event, filled, line, n, xy, z);
}

void ToolSideStage::fill_last_line(std::uint64_t line, const Vector3<double>& at) {
  fill_line(line, std::nullopt, DoublePair{at.x, at.y}, at.z);
}

}  // namespace toolcomp::fast

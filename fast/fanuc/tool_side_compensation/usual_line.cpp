// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/tool_side_compensation/usual_line.h"

#include "fast/basis/short_cut.h"

namespace toolcomp::fast {

void ToolSideCompensation::await_usual(const ToolSideBlock& block) {
  const bool usual = holds_usual_path(block);
  awaits_paths_ = usual && can_await_paths();
  line_.awaited = usual && is_open(ShortCut::tool_side_line) && can_await_line();
  if (!line_.awaited) return;
  line_.vector = at_start().head[0].vector;
  line_.radius = last_->side > 0 ? value_.nearest : -value_.nearest;
}

bool ToolSideCompensation::holds_usual_path(const ToolSideBlock& block) const {
  return block.wanted && mode_ == Mode::on && held_ == Held::path && last_ == &paths_[path_] && !starts_up_ &&
         !after_start_ && !repeated_ && treatment_ == Treatment::none && !parameters_.no_interference && waits_ == 0 &&
         last_->offset.nearest != 0 && block.side == last_->side && last_->offset_change == value_change_;
}

bool ToolSideCompensation::can_await_line() { return !last_->arc && last_->travel.narrow && at_start().size == 1; }

// |u|^2 + u . (vector - start), by |u|; u = U - (V . U) V.
bool ToolSideCompensation::goes_forward(const SidePath& path, double length, const Vector3<double>& vector) const {
  const Vector3<double> v{path.tool->unit[0], path.tool->unit[1], path.tool->unit[2]};
  const Vector3<double>& start = line_.vector;
  const Vector3<double> shift = vector - start;
  const double way = length * (1 / static_cast<double>(Count::kSmallPerOne));
  const double forward = way * length + (dot(path.travel.value, shift) - dot(v, path.travel.value) * dot(v, shift));
  const double size = std::abs(vector.x) + std::abs(vector.y) + std::abs(vector.z) + std::abs(start.x) +
                      std::abs(start.y) + std::abs(start.z);
  return forward > 0x1p-38 * length * (way + size);
}

SideLineStart ToolSideCompensation::lines_start() const {
  const SidePath& from = paths_[path_];
  SideLineStart start;
  start.travel = from.travel.value;
  start.square = from.travel.square;
  start.tool = {from.tool->unit[0], from.tool->unit[1], from.tool->unit[2]};
  start.vector = line_.vector;
  start.radius = line_.radius;
  start.shortest = shortest_;
  return start;
}

void ToolSideCompensation::set_lines(const TakenLine* before_last, const TakenLine& last,
                                     const Vector3<double>& vector) {
  const auto set = [](SidePath& path, const TakenLine& line) {
    path.travel.value = line.way;
    path.travel.square = dot(line.way, line.way);
    path.tool = &line.tool;
  };
  if (before_last != nullptr) set(paths_[path_], *before_last);
  path_ = after(path_);
  set(paths_[path_], last);
  line_.vector = vector;
  first_ = next_;
  pass_slot();
}

void ToolSideCompensation::complete_line() {
  line_.taken = false;
  // Of the path before the lines: what stands there but travel and tool.
  const int side = last_->side;
  const Amount offset = last_->offset;
  const std::uint32_t offset_change = last_->offset_change;
  SidePath& from = paths_[before(path_)];
  SidePath& to = paths_[path_];
  from.tool = &keep_tool(*from.tool);
  to.tool = &keep_tool(*to.tool);
  kept_number_ = kNoTool;
  for (SidePath* path : {&from, &to}) {
    Travel& travel = path->travel;
    travel.narrow = true;
    travel.zero = false;
    travel.fine_units = false;
    travel.unit = static_cast<double>(Count::kSmallPerOne);
    travel.slack = 0;
    path->arc = false;
    path->side = side;
    path->offset = offset;
    path->offset_change = offset_change;
    path->seen = geometry_.plane(*path->tool).see(travel);
  }
  ToolSideBlock& block = ring_[first_];
  block.own = true;
  block.arc = false;
  if (line_.held_plain) set_from_programmed(block.event, {});
  last_ = &to;
  moves_at_end_ = moves_in_plane_of(false, to.travel, *to.tool);
  start_of_path_ = {from.tool, to.side, &from.offset};
  still_ = 0;
  SideGroup& start = at_start();
  start.size = 1;
  start.head[0].vector = line_.vector;
  start.head[0].kind = HeadKind::tangents_meet;
  start.head[0].kept = false;
  SideCorner& corner = start.corner;
  corner.first = &from;
  corner.second = &to;
  corner.tool = from.tool;
  corner.first_side = from.side;
  corner.second_side = to.side;
  corner.offset = &from.offset;
  corner.flat = false;
  corner.turn.cross = 1;  // of use where it is 0: there what is left is as good
  corner.turn.dot = 1;
}

}  // namespace toolcomp::fast

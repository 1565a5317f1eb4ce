// SPDX-License-Identifier: Apache-2.0
// Usual lines of tool side compensation: the corner of two of them by doubles, and many of them as arrays.
#include <cmath>

#include "fast/fanuc/tool_side_compensation/tool_side_compensation.h"

namespace toolcomp::fast {
namespace {

// Of lines that turn by less than 90 degrees. Whether they turn at all is of use where it is certain that they do not;
// in that case what is left of the turn is as good.
void set_corner_of_doubles(SideGroup& group, const Vector3<double>& vector) {
  group.size = 1;
  group.head[0] = {vector, HeadKind::tangents_meet};
  group.corner.flat = false;
  group.corner.turn.cross = 1;
  group.corner.turn.dot = 1;
}

}  // namespace

// U and W: the movements before and behind the corner, V: the tool, u and w: what is seen of them along the tool.
// |u|^2 = |U|^2 - (V . U)^2, u . w = U . W - (V . U)(V . W). The vector: r (V x U / |u| + V x W / |w|) / (1 + cosine).
// Whether it turns left or right makes no difference. As in side_line_arrays.cpp, operation by operation.
bool ToolSideCompensation::make_corner_in_doubles(SideGroup& group, const SidePath& to) const {
  const SidePath& from = *last_;
  if (from.arc || to.arc || !from.travel.narrow || !to.travel.narrow || from.offset.nearest == 0 ||
      from.side != to.side)
    return false;
  const Vector3<double> v{from.tool->unit[0], from.tool->unit[1], from.tool->unit[2]};
  const Vector3<double>& first = from.travel.value;
  const Vector3<double>& way = to.travel.value;
  const double along1 = dot(v, first);
  const double along2 = dot(v, way);
  const double square1 = from.travel.square - along1 * along1;
  const double square2 = to.travel.square - along2 * along2;
  const double length1 = std::sqrt(square1);
  const double length2 = std::sqrt(square2);
  const double product = dot(first, way) - along1 * along2;
  const double lengths = length1 * length2;
  // Nearer than 30 degrees to the tool the projection loses digits. A direction is good to 2^-43, |U||W| is at most
  // 4 |u||w|: 14 times that and a few roundings.
  constexpr double kMostSquare = 0x1p60;
  constexpr double kUncertain = 0x1p-38;
  const bool usual = 4 * square1 >= from.travel.square && 4 * square2 >= to.travel.square &&
                     to.travel.square <= kMostSquare && product > kUncertain * lengths && length2 > shortest_ &&
                     length1 > shortest_;
  if (!usual) return false;
  const double radius = from.side > 0 ? from.offset.nearest : -from.offset.nearest;
  const double scale = radius / (lengths + product);
  set_corner_of_doubles(group, cross(v, first * length2 + way * length1) * scale);
  // What the interference check of the former asks for.
  group.corner.turn.length1 = length1 / from.travel.unit;
  group.corner.turn.ahead1 = (first - v * along1) * (1 / length1);
  return true;
}

bool ToolSideCompensation::awaits_lines() {
  if (mode_ != Mode::on || held_ != Held::path || count_ != 1) return false;
  const ToolSideBlock& block = held(0);
  return block.wanted && last_ == &paths_[path_] && !starts_up_ && !after_start_ && !repeated_ &&
         treatment_ == Treatment::none && !parameters_.no_interference && waits_ == 0 && last_->offset.nearest != 0 &&
         block.side == last_->side && last_->offset_change == value_change_ && !last_->arc && last_->travel.narrow &&
         at_start().size == 1;
}

SideLineStart ToolSideCompensation::lines_start() {
  const SidePath& path = *last_;
  SideLineStart start;
  start.travel = path.travel.value;
  start.square = path.travel.square;
  start.tool = {path.tool->unit[0], path.tool->unit[1], path.tool->unit[2]};
  start.vector = at_start().front().vector;
  start.radius = path.side > 0 ? path.offset.nearest : -path.offset.nearest;
  start.shortest = shortest_;
  return start;
}

void ToolSideCompensation::hold_last(const TakenLine& before_last, const TakenLine& last,
                                     const Vector3<double>& vector) {
  const SidePath& held_before = *last_;
  const int side = held_before.side;
  const Amount offset = held_before.offset;
  const std::uint32_t offset_change = held_before.offset_change;
  SidePath& from = paths_[before(path_)];
  SidePath& to = paths_[path_];
  from.tool = &keep_tool(before_last.tool);
  to.tool = &keep_tool(last.tool);
  kept_number_ = kNoTool;
  const auto set = [&](SidePath& path, const Vector3<double>& way) {
    set_travel(path.travel, static_cast<std::int64_t>(way.x), static_cast<std::int64_t>(way.y),
               static_cast<std::int64_t>(way.z));
    path.arc = false;
    path.side = side;
    path.offset = offset;
    path.offset_change = offset_change;
    path.seen = geometry_.plane(*path.tool).see(path.travel);
  };
  set(from, before_last.way);
  set(to, last.way);
  moves_at_end_ = moves_in_plane_of(false, to.travel, *to.tool);
  SideGroup& start = at_start();
  set_corner_of_doubles(start, vector);
  SideCorner& corner = start.corner;
  corner.first = &from;
  corner.second = &to;
  corner.tool = from.tool;
  corner.first_side = corner.second_side = side;
  corner.offset = &from.offset;
}

}  // namespace toolcomp::fast

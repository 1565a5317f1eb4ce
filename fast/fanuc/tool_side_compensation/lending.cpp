// SPDX-License-Identifier: Apache-2.0
// What tool side compensation lends to the short cut of paths, and takes back: a path in the selected plane, with the
// tool along the normal.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "fast/basis/short_cut.h"
#include "fast/fanuc/corner/lent_path.h"
#include "fast/fanuc/tool_side_compensation/tool_side_compensation.h"

namespace toolcomp::fast {
namespace {

std::size_t normal_of(const std::array<std::size_t, 2>& in) { return 3 - in[0] - in[1]; }

// From which side a tool along the normal looks on the plane; 0: it is not along it.
int facing(const Direction& tool, const std::array<std::size_t, 2>& in) {
  const auto component = [&](std::size_t i) { return tool.unit[static_cast<Eigen::Index>(i)]; };
  const double along = component(normal_of(in));
  const bool is_axis = tool.zero == (1U << in[0] | 1U << in[1]) && component(in[0]) == 0 && component(in[1]) == 0;
  return is_axis && std::abs(along) == 1 ? static_cast<int>(along) : 0;
}

}  // namespace

// Where lines alone come, they are for those who take lines.
bool ToolSideCompensation::can_await_paths() {
  const SidePath* const before = at_start().corner.first;
  return count_ == 1 && moves_at_end_ && (last_->arc || (before != nullptr && before->arc));
}

bool ToolSideCompensation::lend(UsualLoan& loan) {
  const SidePath& path = *last_;
  const SideGroup& start = at_start();
  if (!is_open(ShortCut::tool_side_path)) return false;
  const int looks = facing(*path.tool, loan.in);
  if (looks == 0 || !lend_path(loan)) return false;
  loan.event = &ring_[first_].event;
  loan.sink = sink_;
  loan.offset.radius = path.offset.nearest;
  loan.offset.left = looks * path.side * path.offset.nearest;
  loan.offset.limit = parameters_.limit_value;
  loan.offset.keeps_all = parameters_.keeps_all;
  loan.corner_move = &corner_move(start);
  loan.in_space = true;
  loan.shortest = shortest_;
  if (path.arc && !(starts_on_circle() && has_offset_path(loan.path, loan.offset))) return false;
  loan.start.size = 0;
  for (std::size_t i = 0; i < start.size; ++i) {
    const Vector3<double>& vector = start.head[i].vector;
    if (vector[normal_of(loan.in)] != 0) return false;
    loan.start.add(start.head[i].kind, DoublePair{vector[loan.in[0]], vector[loan.in[1]]});
  }
  if (start.size == 1) return true;
  return loan.corner_move->type == spec::MoveType::linear &&
         moves_in_plane_only({xyz_[loan.in[0]], xyz_[loan.in[1]]}, *loan.corner_move, *loan.event);
}

bool ToolSideCompensation::lend_path(UsualLoan& loan) const {
  if (last_->arc) return !ring_[first_].mismatches && set_usual_path(loan.path, last_->flat);
  if (!last_->travel.narrow) return false;
  const std::array<std::int64_t, 3> way = last_->travel.small();
  set_usual_line(loan.path, {way[loan.in[0]], way[loan.in[1]]});
  return way[normal_of(loan.in)] == 0;
}

bool ToolSideCompensation::starts_on_circle() {
  const SideHead& head = at_start().back();
  const SideCorner& corner = at_start().corner;
  return start_of_path_.tool == last_->tool && corner.second == last_ && corner.flat && corner.aligned && !head.kept &&
         corner.second_side == last_->side && corner.offset->exact == last_->offset.exact &&
         is_on_circle(last_->flat, corner.plane, head.kind);
}

void ToolSideCompensation::set_side_path(SidePath& to, const UsualPath& path,
                                         const std::array<std::size_t, 2>& in) const {
  const WholePair way = path.way();
  std::array<std::int64_t, 3> travel{};
  for (std::size_t i = 0; i < 2; ++i) travel[in[i]] = way[i];
  set_travel(to.travel, travel[0], travel[1], travel[2]);
  to.arc = path.is_arc();
  to.tool = last_->tool;
  to.side = last_->side;
  to.offset = last_->offset;
  to.offset_change = last_->offset_change;
  if (to.arc) {
    set_plane_path(to.flat, path);
    to.in = in;
    to.normal = normal_of(in);
  } else {
    to.seen = geometry_.plane(*to.tool).see(to.travel);
  }
}

void ToolSideCompensation::take_back(const UsualReturn& usual) {
  SidePath& to = paths_[path_];
  SidePath& from = paths_[before(path_)];
  set_side_path(from, usual.before, usual.in);
  set_side_path(to, usual.path, usual.in);
  start_of_path_ = {from.tool, to.side, &from.offset};
  ToolSideBlock& block = ring_[first_];
  block.own = true;
  block.arc = to.arc;
  block.mismatches = false;
  // What the centre of an arc by radius is counted from.
  block.by_radius = usual.path.by_radius != 0;
  for (std::size_t i = 0; i < 2; ++i) {
    block.axis[i] = xyz_[usual.in[i]];
    block.start[i].set_small(usual.at[i]);
  }

  SideGroup& start = at_start();
  SideCorner& corner = start.corner;
  corner.first = &from;
  corner.second = &to;
  corner.tool = from.tool;
  corner.first_side = corner.second_side = to.side;
  corner.offset = &from.offset;
  (void)geometry_.set_turn(corner);
  start.size = usual.corner.size;
  for (std::size_t i = 0; i < start.size; ++i) {
    start.head[i] = {};
    start.head[i].kind = usual.corner.kind[i];
    Vector3<double>& vector = start.head[i].vector;
    const DoublePair flat = usual.corner.vector[i];
    const auto along = [&](std::size_t axis) {
      return axis == usual.in[0] ? flat[0] : (axis == usual.in[1] ? flat[1] : 0);
    };
    vector = {along(0), along(1), along(2)};
  }
  if (start.size > 1) corner_move(start) = usual.corner_move;
}

}  // namespace toolcomp::fast

// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/corner/usual_paths.h"

#include <cmath>
#include <utility>

#include "fast/fanuc/control/read_words.h"
#include "fast/fanuc/control/usual_place.h"
#include "fast/fanuc/corner/corner_group.h"
#include "fast/fanuc/corner/tool_arc.h"

namespace toolcomp::fast {
namespace {

// So many lines behind one another, and more are worth the way to those who take lines alone.
constexpr unsigned kMostLines = 16;

}  // namespace

bool UsualPaths::await() {
  const ModalState& modal = control_.modal;
  axis_ = modal.plane_axis();
  loan_.in = {in_plane(modal.plane(), 0), in_plane(modal.plane(), 1)};
  if (!words_.begin() || !find_usual_place(control_, at_) || !is_usual_position(at_) || !lender_.lend(loan_))
    return false;
  lent_ = true;
  lines_ = 0;
  *held_ = loan_.path;
  *start_ = loan_.start;
  at_value_ = to_doubles(at_);
  start_value_ = at_value_ - to_doubles(loan_.path.way());
  const Event& event = *loan_.event;
  set_frame(line_, event, spec::MoveType::linear, event.cause);
  set_frame(corner_move_, event, spec::MoveType::linear, spec::Cause::corner);
  if (start_->size > 1) own_corner_move(*loan_.corner_move);
  set_frame(arc_, event, spec::MoveType::arc, event.cause);
  Event& own = event_of(*held_);
  own.line = event.line;
  own.n = event.n;
  if (!arc_.arc) arc_.arc.emplace();
  if (event.arc) {
    *arc_.arc = *event.arc;
  } else {
    arc_.arc->plane = modal.plane();
    arc_.arc->center.present = static_cast<std::uint16_t>(bit(axis_[0]) | bit(axis_[1]));
  }
  if (held_->by_radius != 0) set_center(start_value_ / kWholePerOne - held_->from_start);
  handover_.take(*this);
  return true;
}

void UsualPaths::block(const spec::Block& block) {
  if (take(block)) [[likely]]
    return;
  leave().block(block);
}

BlockTaker& UsualPaths::leave() {
  BlockTaker& others = handover_.back();
  if (lent_) return others;
  for (std::size_t i = 0; i < 2; ++i) control_.positions.place_small(axis_[i], at_[i]);
  Event& event = event_of(*held_);
  place_in_plane(event, axis_, at_value_, DoublePair{});
  Event& to = *loan_.event;
  set_frame(to, event, event.type, event.cause);
  to.line = event.line;
  to.n = event.n;
  to.arc = event.arc;
  place_in_plane(corner_move_, axis_, start_value_, DoublePair{});
  const WholePair way = held_->way();
  lender_.take_back({*before_, *held_, *start_, corner_move_, {at_[0] - way[0], at_[1] - way[1]}, loan_.in});
  return others;
}

[[gnu::always_inline]] inline void UsualPaths::set_center(DoublePair center) {
  for (std::size_t i = 0; i < 2; ++i) arc_.arc->center.value[axis_[i]] = center[i];
}

[[gnu::always_inline]] inline bool UsualPaths::make_path(const UsualMove& move) {
  const auto& [motion, has_feed, to, to_center, radius] = move;
  const WholePair way{to[0] - at_[0], to[1] - at_[1]};
  if (!is_usual_position(to) || !is_usual_way(way)) return false;
  if (motion == kG01) {
    set_usual_line(*next_, way);
    return next_->start.norm > loan_.shortest;
  }
  const int sigma = motion == kG02 ? -1 : 1;
  if (radius != 0) [[unlikely]]
    return is_usual_way({radius, 0}) && set_usual_arc_by_radius(*next_, way, radius, sigma) &&
           has_offset_path(*next_, loan_.offset);
  const WholePair from{-to_center[0], -to_center[1]};
  const WholePair end{from[0] + way[0], from[1] + way[1]};
  return is_usual_way(from) && is_usual_way(end) && set_usual_arc(*next_, from, end, sigma) &&
         has_offset_path(*next_, loan_.offset);
}

[[gnu::always_inline]] inline bool UsualPaths::make_corner() {
  return loan_.in_space && !held_->is_arc() && !next_->is_arc()
             ? make_corner_of_seen_lines(*held_, *next_, loan_.offset, *end_)
             : make_usual_corner(*held_, *next_, loan_.offset, *end_);
}

[[gnu::always_inline]] inline bool UsualPaths::is_clear(DoublePair vector, ToolArc& arc) const {
  const UsualPath& path = *held_;
  const DoublePair first = start_->back();
  if (!path.is_arc()) return goes_forward(path.start.unit, path.start.norm, first, vector);
  const Vector2<double> a = to_vector(path.from_start + first);
  const Vector2<double> b = to_vector(path.from_end + vector);
  if (path.spiral) {
    // Radii that are almost equal take a closer look.
    arc.radius = {length(a), length(b)};
    const double size = path.radius[0] + path.radius[1] + loan_.offset.radius;
    if (std::abs(arc.radius.first - arc.radius.second) <= 0x1p-36 * size) [[unlikely]]
      return false;
  }
  return is_off_center(path.radius[0], to_vector(first), a) && is_off_center(path.radius[1], to_vector(vector), b) &&
         set_clear_sweep(path.sigma, to_vector(path.from_start), to_vector(path.from_end), a, b, arc.sweep) &&
         ((arc.sweep > 180) == path.over_half);
}

// Corner moves belong to the block whose event this is.
void UsualPaths::own_corner_move(const Event& owner) {
  corner_move_.line = owner.line;
  corner_move_.n = owner.n;
  corner_move_.feed = owner.feed;
}

void UsualPaths::send_corner_moves() {
  const UsualCorner& corner = *start_;
  for (std::size_t i = 1; i < corner.size; ++i) {
    if (!(loan_.in_space && is_up_to_stop(corner.kind[i]))) own_corner_move(event_of(*held_));
    place_in_plane(corner_move_, axis_, start_value_, corner.vector[i]);
    loan_.sink->on(corner_move_);
  }
}

[[gnu::always_inline]] inline void UsualPaths::send_path(DoublePair vector, const ToolArc& tool) {
  const UsualPath& path = *held_;
  Event& event = event_of(path);
  place_in_plane(event, axis_, at_value_, vector);
  if (path.is_arc()) {
    spec::Arc<double>& arc = *event.arc;
    arc.sweep = tool.sweep;
    arc.radius.reset();
    if (path.spiral) arc.radius = tool.radius;
  }
  loan_.sink->on(event);
}

[[gnu::always_inline]] inline void UsualPaths::hold(const spec::Block& block, const UsualMove& move) {
  lent_ = false;
  if (end_->size > 1) own_corner_move(event_of(*held_));
  UsualPath* const last = before_;
  before_ = held_;
  held_ = next_;
  next_ = last;
  std::swap(start_, end_);
  Event& event = event_of(*held_);
  if (held_->is_arc()) {
    event.arc->direction = held_->sigma > 0 ? spec::ArcDirection::ccw : spec::ArcDirection::cw;
    set_center(move.radius == 0 ? (at_value_ + to_doubles(move.to_center)) / kWholePerOne
                                : at_value_ / kWholePerOne - held_->from_start);
  }
  event.line = block.line;
  event.n = block.n;
  start_value_ = at_value_;
  at_ = move.to;
  at_value_ = to_doubles(at_);
  control_.modal.set_motion(move.motion);
  if (move.has_feed) [[unlikely]]
    set_feed();
}

void UsualPaths::set_feed() {
  control_.modal.set_feed(words_.feed());
  line_.feed = arc_.feed = control_.modal.feed();
}

[[gnu::always_inline]] inline bool UsualPaths::take(const spec::Block& block) {
  UsualMove move;
  ToolArc arc;
  if (block.alarm || !words_.read(block, at_, move) || !make_path(move)) [[unlikely]]
    return false;
  lines_ = next_->is_arc() ? 0 : lines_ + 1;
  if (lines_ > kMostLines || !make_corner() || !is_clear(end_->front(), arc)) [[unlikely]]
    return false;
  if (start_->size > 1) send_corner_moves();
  send_path(end_->front(), arc);
  hold(block, move);
  return true;
}

}  // namespace toolcomp::fast

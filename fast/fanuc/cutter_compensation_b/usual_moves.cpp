// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/cutter_compensation_b/usual_moves.h"

#include <cmath>

#include "fast/basis/short_cut.h"
#include "fast/fanuc/control/read_words.h"
#include "fast/fanuc/control/usual_place.h"
#include "fast/fanuc/cutter_compensation_b/cutter_compensation_b.h"
#include "fast/fanuc/cutter_compensation_b/usual_arc.h"

namespace toolcomp::fast {

bool UsualCutterMoves::await() {
  if (!is_open(ShortCut::cutter_b_move) || !words_.begin() || !find_usual_place(control_, at_) ||
      !is_usual_position(at_) || !compensation_.lend(vector_))
    return false;
  const ModalState& modal = control_.modal;
  axis_ = modal.plane_axis();
  at_value_ = to_doubles(at_);
  set_frame(line_, *vector_.event, spec::MoveType::linear, spec::Cause::programmed);
  set_frame(arc_, *vector_.event, spec::MoveType::arc, spec::Cause::programmed);
  if (!arc_.arc) arc_.arc.emplace();
  arc_.arc->plane = modal.plane();
  arc_.arc->center.present = static_cast<std::uint16_t>(bit(axis_[0]) | bit(axis_[1]));
  handover_.take(*this);
  return true;
}

void UsualCutterMoves::block(const spec::Block& block) {
  if (take(block)) [[likely]]
    return;
  leave().block(block);
}

BlockTaker& UsualCutterMoves::leave() {
  for (std::size_t i = 0; i < 2; ++i) control_.positions.place_small(axis_[i], at_[i]);
  compensation_.take_back(vector_);
  return handover_.back();
}

[[gnu::always_inline]] inline bool UsualCutterMoves::make_line(const WholePair& way) {
  if (way[0] == 0 && way[1] == 0) [[unlikely]]
    return false;
  const DoublePair normal = left_of(to_doubles(way));
  const DoublePair squares = normal * normal;
  vector_.normal = {-way[1], way[0]};
  vector_.value = normal * (vector_.offset / std::sqrt(squares[0] + squares[1]));
  return true;
}

[[gnu::always_inline]] inline bool UsualCutterMoves::make_arc(const WholePair& way, const UsualMove& move) {
  const WholePair from{-move.to_center[0], -move.to_center[1]};
  const WholePair to{from[0] + way[0], from[1] + way[1]};
  const int sigma = move.motion == kG02 ? -1 : 1;
  UsualArc made;
  if (move.radius != 0 || !make_usual_arc(from, to, sigma, vector_.value, vector_.offset, made)) return false;
  spec::Arc<double>& arc = *arc_.arc;
  arc.direction = sigma > 0 ? spec::ArcDirection::ccw : spec::ArcDirection::cw;
  const DoublePair center = (at_value_ + to_doubles(move.to_center)) / kWholePerOne;
  for (std::size_t i = 0; i < 2; ++i) arc.center.value[axis_[i]] = center[i];
  set_usual_arc(arc, made);
  vector_.normal = made.normal;
  vector_.value = made.vector;
  return true;
}

void UsualCutterMoves::set_feed() {
  control_.modal.set_feed(words_.feed());
  line_.feed = arc_.feed = control_.modal.feed();
}

[[gnu::always_inline]] inline bool UsualCutterMoves::take(const spec::Block& block) {
  UsualMove move;
  if (block.alarm || !words_.read(block, at_, move)) [[unlikely]]
    return false;
  const WholePair way{move.to[0] - at_[0], move.to[1] - at_[1]};
  if (!is_usual_position(move.to) || !is_usual_way(way)) [[unlikely]]
    return false;
  const bool is_line = move.motion == kG01;
  if (!(is_line ? make_line(way) : make_arc(way, move))) [[unlikely]]
    return false;
  vector_.is_new = true;
  at_ = move.to;
  at_value_ = to_doubles(at_);
  control_.modal.set_motion(move.motion);
  if (move.has_feed) [[unlikely]]
    set_feed();
  Event& event = is_line ? line_ : arc_;
  event.line = block.line;
  event.n = block.n;
  place_in_plane(event, axis_, at_value_, vector_.value);
  vector_.sink->on(event);
  return true;
}

}  // namespace toolcomp::fast

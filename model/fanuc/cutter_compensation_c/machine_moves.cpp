// SPDX-License-Identifier: Apache-2.0
// G53, G28, G30, G30.1 and G29: the vector goes, and comes back by parameter 5003#2.
#include "model/fanuc/cutter_compensation_c/cutter_compensation_c.h"

namespace toolcomp::model {

void CutterCompensationC::take_machine_move(Step& now, bool wanted) {
  const CutterBlock& block = said(now);
  if (!block.has_plane_word()) {
    if (!wanted && ahead_.mode == CornerMode::on) {
      cancel_alone(now);
      return;
    }
    ahead_.end_before(now);
    // fanuc.cutter-c.outside-axes-only: A block with G53, G28, G30, G30.1 or G29 that names only axes outside the plane
    // keeps the vector. The block before ends with P1, and the next moving block starts from that vector.
    recorder().reach(Clause::fanuc_cutter_c_outside_axes_only);
    ahead_.keep(now);
    return;
  }
  // fanuc.cutter-c.ccn: No. 5003 bit 2, CCN, says whether the mode stays on after G53, G28, G30, G30.1 or G29 of the
  // plane. With CCN = 0 the mode is off, and the next moving block is a start-up block.
  const bool goes_on = wanted && recorder().decide(Clause::fanuc_cutter_c_ccn, keeps_the_mode_);
  const bool reference = block.motion == PlaneMotion::reference;
  if (reference && goes_on) {
    take_reference_with_intersection(now);
    return;
  }
  ahead_.end_before(now);
  // fanuc.cutter-c.reference-return: If CCN = 0, if G40 or number 0 is in force, or after a lone G40, the block before
  // a G28, G30 or G30.1 of the plane ends with P1, and the vector is removed on the way to the intermediate point.
  // fanuc.cutter-c.machine-position: With G53 and an axis word of the plane under G90 while the mode is on, the vector
  // vanishes in the G53 move (cause programmed). With G29 it vanishes likewise, at the intermediate point.
  recorder().reach(reference ? Clause::fanuc_cutter_c_reference_return : Clause::fanuc_cutter_c_machine_position);
  decide_axes(block);
  if (goes_on) {
    go_on_without_vector();
  } else {
    ahead_.set_vector({});
    ahead_.mode = wanted ? CornerMode::waiting : CornerMode::off;
  }
  ahead_.keep(now);
}

// The way to the intermediate point is a block of the offset mode; behind that point the vector goes.
void CutterCompensationC::take_reference_with_intersection(Step& now) {
  const CutterBlock& block = said(now);
  const PlanePoint travel = block.ends.front() - block.start;
  // fanuc.cutter-c.reference-intersection: With G28, G30 or G30.1 of the plane and CCN = 1, the way to the intermediate
  // point is a line B of the offset mode, and the group at its end is its own P1. After a start-up block, the group
  // before this B is that of the start-up (SUP).
  if (!recorder().decide(Clause::fanuc_cutter_c_reference_intersection, !is_zero(travel))) {
    ahead_.end_before(now);
    now.moves.front().offset = ahead_.here().front().vector;
  } else {
    const CutterOffset offset = ahead_.next_offset(now, true);
    const OffsetPath path = line_path(travel, offset.side * ahead_.last_offset().distance, offset.left());
    meet_corner(now, path, offset);
    ahead_.moved(offset);
    const Vector vector = in_space(block.plane, perpendicular(path.end));
    now.moves.front().offset = vector;
    ahead_.insert_corner_moves(now);
    ahead_.set_vector({vector, Seat::square, Seat::off});
  }
  decide_axes(block);
  go_on_without_vector();
  now.moves.back().offset = {};
  ahead_.emit(now);
}

// fanuc.cutter-c.one-plane-axis: If a block with G53, G28, G30, G30.1 or G29 names only one axis of the plane, both
// components of the vector are cleared all the same, with CCN = 0 and with CCN = 1.
void CutterCompensationC::decide_axes(const CutterBlock& block) const {
  recorder().decide(Clause::fanuc_cutter_c_one_plane_axis, block.word[0] != block.word[1]);
}

void CutterCompensationC::go_on_without_vector() {
  ahead_.set_vector({});
  made_by_move_ = false;
  unchecked_ = true;
}

}  // namespace toolcomp::model

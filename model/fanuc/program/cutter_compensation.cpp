#include "model/fanuc/program/cutter_compensation.h"

#include "model/basis/alarm.h"

namespace toolcomp::model {

void CutterCompensation::check(const CutterBlock& words) const {
  const bool in_force = words.side != CutterSide::none;
  if (in_force && words.lacks_axis)
    raise(recorder_, Clause::fanuc_cutter_plane_axes, "PS0028",
          "cutter compensation in a plane of which the machine lacks an axis");
  if (on() && words.plane_changed)
    raise(recorder_, Clause::fanuc_cutter_plane_change, "PS0037", "the plane changes while cutter compensation is on");
  if ((on() && words.other_compensation) || ((on() || in_force) && words.tip_control))
    raise(recorder_, Clause::fanuc_cutter_excluded, "FORBIDDEN_IN_CUTTER_COMPENSATION",
          "another compensation, G43.4 or G43.5 while cutter compensation is on");
  if ((on() || wanted(words)) && is_tool_offset(words.one_shot))
    raise(recorder_, Clause::fanuc_tool_offset_in_cutter_compensation, "PS0042",
          "G45 to G48 while cutter compensation is on");
}

}  // namespace toolcomp::model

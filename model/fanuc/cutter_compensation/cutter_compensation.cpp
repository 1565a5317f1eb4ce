// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/cutter_compensation/cutter_compensation.h"

#include "model/basis/alarm.h"

namespace toolcomp::model {

CutterCompensation::CutterCompensation(const Place& place)
    : Pass(place), words_(place.setup, place.memory, place.recorder) {}

bool CutterCompensation::on_after(const Command& command) const {
  return wanted(words_.side_after(command), words_.number_after(command));
}

void CutterCompensation::read(const BlockWords& now, StepWords& words) {
  words.cutter = words_.read(now);
  if (!words.cutter) return;
  check(*words.cutter);
  words_.add_value(*words.cutter);
}

void CutterCompensation::see(const BlockWay& way, StepWords& words) const {
  if (words.cutter) words_.add_movement(*words.cutter, way);
}

void CutterCompensation::check_common(const CutterBlock& words) const {
  const bool in_force = words.side != CutterSide::none;
  // fanuc.cutter.plane-axes: A block in which G41 or G42 is in force raises PS0028 if the machine lacks an axis of the
  // plane. U, V and W are axes outside every plane.
  if (in_force && words.lacks_axis) raise(recorder(), Clause::fanuc_cutter_plane_axes, AlarmCause::plane_axis_missing);
  // fanuc.cutter.plane-change: A G17, G18 or G19 that changes the plane raises PS0037 if cutter compensation is on
  // before the block. This holds also for the block that cancels it.
  if (on() && words.plane_changed) raise(recorder(), Clause::fanuc_cutter_plane_change, AlarmCause::plane_change);
  // fanuc.cutter.excluded: G41.3, G41.2, G42.2, G41.6 and G42.6 raise FORBIDDEN_IN_CUTTER_COMPENSATION if cutter
  // compensation is on before the block. G43.4 and G43.5 raise it if cutter compensation is on before the block, or if
  // G41 or G42 is in force in the block.
  if ((on() && words.other_compensation) || ((on() || in_force) && words.tip_control))
    raise(recorder(), Clause::fanuc_cutter_excluded, AlarmCause::forbidden_in_cutter_compensation);
  // fanuc.tool-offset.in-cutter-compensation: G45 to G48 raise PS0042 if cutter compensation B or C is on before or
  // after the block, with or without an axis word. It counts as on by fanuc.cutter.on, and also after a lone G40 while
  // a vector waits for its removal.
  if ((on() || wanted(words)) && is_tool_offset(words.one_shot))
    raise(recorder(), Clause::fanuc_tool_offset_in_cutter_compensation, AlarmCause::tool_offset_in_cutter_compensation);
}

}  // namespace toolcomp::model

#include "model/fanuc/cutter_compensation/cutter_compensation.h"

#include "model/basis/alarm.h"

namespace toolcomp::model {

CutterCompensation::CutterCompensation(const Place& place)
    : StageOf(place), words_(place.setup, place.memory, place.recorder) {}

bool CutterCompensation::on_after(const Command& command) const {
  return wanted(words_.side_after(command), words_.number_after(command));
}

std::shared_ptr<StageWords> CutterCompensation::read(const StageCommand& now) {
  std::shared_ptr<CutterBlock> block = words_.read(now);
  if (!block) return nullptr;
  check(*block);
  words_.add_value(*block);
  return block;
}

void CutterCompensation::add_way(StageWords& words, const BlockWay& way) const { words_.add_movement(own(words), way); }

void CutterCompensation::check_common(const CutterBlock& words) const {
  const bool in_force = words.side != CutterSide::none;
  if (in_force && words.lacks_axis)
    raise(recorder(), Clause::fanuc_cutter_plane_axes, "PS0028",
          "cutter compensation in a plane of which the machine lacks an axis");
  if (on() && words.plane_changed)
    raise(recorder(), Clause::fanuc_cutter_plane_change, "PS0037", "the plane changes while cutter compensation is on");
  if ((on() && words.other_compensation) || ((on() || in_force) && words.tip_control))
    raise(recorder(), Clause::fanuc_cutter_excluded, "FORBIDDEN_IN_CUTTER_COMPENSATION",
          "another compensation, G43.4 or G43.5 while cutter compensation is on");
  if ((on() || wanted(words)) && is_tool_offset(words.one_shot))
    raise(recorder(), Clause::fanuc_tool_offset_in_cutter_compensation, "PS0042",
          "G45 to G48 while cutter compensation is on");
}

}  // namespace toolcomp::model

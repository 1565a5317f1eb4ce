// SPDX-License-Identifier: Apache-2.0
#include "fast/heidenhain/peripheral_milling/peripheral_milling.h"

namespace toolcomp::fast::klartext {

inline void PeripheralMilling::keep(const Lateral& made_from, const Vector& unit) {
  // One by one: a processor that copies all bytes at once waits where a part has just been written.
  last_.tool = made_from.tool;
  last_.travel = made_from.travel;
  last_.side = made_from.side;
  last_unit_ = unit;
}

inline bool PeripheralMilling::direct(const Lateral& made_from) {
  Vector c;
  if (!direction_of(made_from, c)) [[unlikely]]
    return keep_direction();
  keep(made_from, c);
  return true;
}

bool PeripheralMilling::keep_direction() {
  if (last_.tool == nullptr) return false;
  if (last_.tool != &kept_.tool) {
    kept_.tool.copy(*last_.tool);
    kept_.travel = *last_.travel;
    last_.tool = &kept_.tool;
    last_.travel = &kept_.travel;
  }
  return true;
}

inline Lateral PeripheralMilling::lateral(const ToolVector& tool, const PeripheralMotion& motion) {
  return {&tool, &motion.travel, motion.side};
}

inline Alarm PeripheralMilling::corner(const Lateral& own, const Lateral& coming, Vector& between) {
  Vector c;
  Vector next;
  if (directions_of(own, coming, c, next)) [[likely]] {
    keep(coming, next);
    if (!mitre(c, own, next, coming, between)) return AlarmCause::opposite_directions;
    return AlarmCause::none;
  }
  if (!direct(own)) return AlarmCause::no_direction;
  c = last_unit_;
  const Lateral made_from = last_;
  (void)direct(coming);  // there is one
  if (!mitre(c, made_from, last_unit_, last_, between)) return AlarmCause::opposite_directions;
  return AlarmCause::none;
}

Alarm PeripheralMilling::hold() {
  PeripheralMotion& coming = next();
  if (!holds_) {
    holds_ = first_ = true;
    last_ = {};
    held_ = next_of(held_);
    return AlarmCause::none;
  }
  const PeripheralMotion& former = ring_[held_];
  const ToolVector& tool = former.tool;
  Vector between;
  if (first_) {
    if (!direct(lateral(tool, coming))) return AlarmCause::no_direction;
    between = last_unit_;
  } else if (const Alarm a = corner(lateral(tool, former), lateral(tool, coming), between)) [[unlikely]] {
    return a;
  }
  send(between);
  first_ = false;
  held_ = next_of(held_);
  return AlarmCause::none;
}

Alarm PeripheralMilling::follow() {
  const PeripheralMotion& former = ring_[held_];
  Lateral own = lateral(former.tool, former);
  if (first_) own.travel = &next().travel;
  if (!direct(own)) return AlarmCause::no_direction;
  send(last_unit_);
  holds_ = false;
  return AlarmCause::none;
}

Alarm PeripheralMilling::release() {
  if (!holds_) return AlarmCause::none;
  const PeripheralMotion& former = ring_[held_];
  if (!direct(lateral(former.tool, former))) return AlarmCause::no_direction;
  send(last_unit_);
  holds_ = false;
  return AlarmCause::none;
}

void PeripheralMilling::send(const Vector& between) {
  const PeripheralMotion& former = ring_[held_];
  Placement placement;
  placement.tool = former.tool.unit();
  placement.shift = between * former.radius_delta;
  placement.tip = between * former.lateral - placement.tool * former.tip_below;
  placement.corner = former.effective_corner;
  writer_.move(former.head, placement, former.length, first_ ? spec::Cause::start_up : spec::Cause::programmed);
}

}  // namespace toolcomp::fast::klartext

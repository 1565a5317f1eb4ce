#include "fast/peripheral_milling/peripheral_milling.h"

#include "fast/fault.h"

namespace toolcomp::fast::klartext {

inline bool PeripheralMilling::direct(const ToolVector& tool, const Displacement& travel, int side) {
  if (fault(Fault::peripheral_sides_exchanged)) side = -side;
  const Lateral own{&tool, &travel, side};
  Vector c;
  if (!direction_of(own, c)) [[unlikely]]
    return keep_direction();
  // One by one: a processor that copies all bytes at once waits where a part has just been written.
  last_.tool = &tool;
  last_.travel = &travel;
  last_.side = side;
  last_unit_ = c;
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

Alarm PeripheralMilling::hold() {
  PeripheralMotion& coming = next();
  if (!holds_) {
    holds_ = first_ = true;
    last_ = {};
    held_ = next_of(held_);
    return alarm::kNone;
  }
  const PeripheralMotion& former = ring_[held_];
  const ToolVector& tool = fault(Fault::peripheral_tool_of_next_block) ? coming.tool : former.tool;
  Vector between;
  if (first_) {
    if (!direct(tool, coming.travel, coming.side)) return alarm::kNoDirection;
    between = last_unit_;
  } else {
    if (!direct(tool, former.travel, former.side)) return alarm::kNoDirection;
    const Vector c = last_unit_;
    const Lateral made_from = last_;
    (void)direct(tool, coming.travel, coming.side);  // there is one
    if (fault(Fault::peripheral_own_direction_at_corner))
      between = c;
    else if (!mitre(c, made_from, last_unit_, last_, between))
      return alarm::kReversal;
  }
  send(between);
  first_ = false;
  held_ = next_of(held_);
  return alarm::kNone;
}

Alarm PeripheralMilling::follow() {
  const PeripheralMotion& former = ring_[held_];
  if (!(first_ ? direct(former.tool, next().travel, former.side) : direct(former.tool, former.travel, former.side)))
    return alarm::kNoDirection;
  send(last_unit_);
  holds_ = false;
  return alarm::kNone;
}

Alarm PeripheralMilling::release() {
  if (!holds_) return alarm::kNone;
  const PeripheralMotion& former = ring_[held_];
  if (!direct(former.tool, former.travel, former.side)) return alarm::kNoDirection;
  send(last_unit_);
  holds_ = false;
  return alarm::kNone;
}

void PeripheralMilling::send(const Vector& between) {
  const PeripheralMotion& former = ring_[held_];
  Placement placement;
  placement.tool = former.tool.unit();
  placement.shift = between * former.values.radius_delta;
  placement.tip = between * former.lateral - placement.tool * former.tip_below;
  placement.corner = former.values.effective_corner;
  writer_.move(former.head, placement, former.values, first_ ? spec::Cause::start_up : spec::Cause::programmed);
}

}  // namespace toolcomp::fast::klartext

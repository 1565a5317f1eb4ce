#include "fast/peripheral_milling/peripheral_milling.h"

#include "fast/fault.h"

namespace toolcomp::fast::klartext {

inline const Lateral& PeripheralMilling::direction(const ToolVector& tool, const Displacement& travel, int side) {
  if (fault(Fault::peripheral_sides_exchanged)) side = -side;
  if (const Lateral own = lateral(tool, travel, side)) [[likely]] {
    last_ = own;
    return last_;
  }
  return kept_direction();
}

const Lateral& PeripheralMilling::kept_direction() {
  if (last_ && last_.tool != &kept_.tool) {
    kept_.tool.copy(*last_.tool);
    kept_.travel = *last_.travel;
    last_.tool = &kept_.tool;
    last_.travel = &kept_.travel;
  }
  return last_;
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
    const Lateral& c = direction(tool, coming.travel, coming.side);
    if (!c) return alarm::kNoDirection;
    between = c.unit;
  } else {
    const Lateral c = direction(tool, former.travel, former.side);
    if (!c) return alarm::kNoDirection;
    const Lateral& d = direction(tool, coming.travel, coming.side);
    if (fault(Fault::peripheral_own_direction_at_corner))
      between = c.unit;
    else if (!mitre(c, d, between))
      return alarm::kReversal;
  }
  send(between);
  first_ = false;
  held_ = next_of(held_);
  return alarm::kNone;
}

Alarm PeripheralMilling::follow() {
  const PeripheralMotion& former = ring_[held_];
  const Lateral& c =
      first_ ? direction(former.tool, next().travel, former.side) : direction(former.tool, former.travel, former.side);
  if (!c) return alarm::kNoDirection;
  send(c.unit);
  holds_ = false;
  return alarm::kNone;
}

Alarm PeripheralMilling::release() {
  if (!holds_) return alarm::kNone;
  const PeripheralMotion& former = ring_[held_];
  const Lateral& c = direction(former.tool, former.travel, former.side);
  if (!c) return alarm::kNoDirection;
  send(c.unit);
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

// Peripheral milling without a surface normal: RL and RR under TCPM.
#pragma once

#include <functional>
#include <optional>

#include "model/basis/recorder.h"
#include "model/heidenhain/peripheral_milling/lateral_direction.h"
#include "model/heidenhain/program/compensated.h"
#include "model/heidenhain/program/motion.h"
#include "model/heidenhain/programmed_contour/programmed_contour.h"

namespace toolcomp::model::klartext {

// Compensates perpendicular to movement and tool. It holds one motion: the end point depends on the motion behind it.
// Clauses: heidenhain.peripheral.*.
class PeripheralMilling {
 public:
  using Output = std::function<void(const Motion&, const Compensated&)>;
  PeripheralMilling(Recorder& recorder, Output output)
      : recorder_(recorder), contour_(recorder), directions_(recorder), output_(std::move(output)) {}

  // Any motion, before it is compensated or held: the one held goes out. Throws Alarm.
  void meet(const Motion& next);
  // A compensated motion, to be held until the next one is known.
  void take(Motion motion);
  // A motion without this compensation: whether its move leaves the last compensated end point.
  bool pass();
  // Nothing that moves follows. Throws Alarm.
  void finish() { release(nullptr); }

 private:
  void release(const Motion* next);
  // c or the mitre at the end of a block.
  Vector side_vector(const Motion& motion, const Motion* next);
  Vector at_first_block(const Motion& motion, const Motion* next);

  Recorder& recorder_;
  ProgrammedContour contour_;
  LateralDirections directions_;
  Output output_;
  std::optional<Motion> held_;
  bool held_is_first_ = false;
  bool on_ = false;  // the motion before was compensated
};

}  // namespace toolcomp::model::klartext

// SPDX-License-Identifier: Apache-2.0
// Peripheral milling without a surface normal: RL and RR under TCPM.
#pragma once

#include <functional>
#include <optional>

#include "model/basis/recorder.h"
#include "model/heidenhain/peripheral_milling/rules.h"

namespace toolcomp::model::klartext {

// Compensates perpendicular to movement and tool. It holds one motion: the end point depends on the motion behind it.
// Clauses: heidenhain.peripheral.*.
class PeripheralMilling {
 public:
  using Output = std::function<void(const Motion&, const Compensated&)>;
  PeripheralMilling(Recorder& recorder, Output output)
      : recorder_(recorder), rules_(recorder), output_(std::move(output)) {}

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

  Recorder& recorder_;
  PeripheralRules rules_;
  Output output_;
  std::optional<Motion> held_;
  std::optional<LateralDirection> former_;  // made last, since the first compensated block
  bool held_is_first_ = false;
  bool on_ = false;  // the motion before was compensated
};

}  // namespace toolcomp::model::klartext

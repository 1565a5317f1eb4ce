// The lean angle Q of G43.5.
#pragma once

#include "model/basis/recorder.h"
#include "model/fanuc/program/step.h"
#include "model/kinematics/tool_direction.h"
#include "spec/language/axes.h"

namespace toolcomp::model {

// What the lean of a leg is toward: its travel; of an arc the tangent at its end, of any length.
Vector lean_travel(const Leg& leg, const spec::Axes& axes);

// The direction leaned by `degrees` towards lean_travel of the leg, or the direction itself where it lies along that.
// Clauses: fanuc.tool-center-point.lean, lean-along-the-travel, lean-in-an-arc.
Direction leaned(Recorder& recorder, const Direction& tool, const Leg& leg, const spec::Axes& axes,
                 const Rational& degrees);

}  // namespace toolcomp::model

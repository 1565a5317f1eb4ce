// SPDX-License-Identifier: Apache-2.0
// Tool posture control of single blocks on the machines of the worked examples, from exact poses and directions.
#pragma once

#include <memory>
#include <string>

#include "model/basis/alarm.h"
#include "model/fanuc/tool_posture_control/tool_posture_control.h"
#include "model/kinematics/pair_choice.h"
#include "spec/language/setup_format.h"
#include "tests/support/setup_with_feed.h"
#include "tests/support/usual_number.h"

namespace toolcomp::test {

// Axes X1 Y2 Z3 A4 B5 C6.
inline std::string machine_setup(const std::string& parameters) {
  return "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"A\", \"B\", \"C\"]\n[parameters]\n" + parameters;
}
// C carries B.
inline const std::string kHC = "19680 = 2\n19681 = 6\n19682 = 3\n19686 = 5\n19687 = 2\n";
// A carries C, tables.
inline const std::string kTAC = "19680 = 12\n19681 = 4\n19682 = 1\n19684 = 1\n19686 = 6\n19687 = 3\n19689 = 1\n";
// B turns the tool, C the table.
inline const std::string kMBC = "19680 = 21\n19681 = 5\n19682 = 2\n19686 = 6\n19687 = 3\n19689 = 1\n";
// C carries a nutating B about (0, 1, 1).
inline const std::string kN45 = "19680 = 2\n19681 = 6\n19682 = 3\n19686 = 5\n19687 = 5\n19688 = 45\n";

// The direction at a polar angle and an azimuth.
inline model::Direction polar(const model::Rational& angle, const model::Rational& azimuth) {
  const model::Real across = exact::sin_degrees(angle);
  const model::Vector unit{across * exact::cos_degrees(azimuth), across * exact::sin_degrees(azimuth),
                           exact::cos_degrees(angle)};
  return {unit, 1, unit, true};
}

// One machine with its frame at the zero pose.
struct PostureMachine {
  explicit PostureMachine(const std::string& parameters, const model::Pose& frozen = {})
      : setup(toolcomp::test::setup_with_feed(machine_setup(parameters))),
        machine(setup),
        choice(setup, machine, recorder),
        posture(setup, machine, choice, recorder),
        frame(std::make_shared<const model::ControlFrame>(machine, frozen, model::Vector())) {}

  // Type 2: from a pose to a direction.
  [[nodiscard]] model::PosturePlan to(const model::Pose& start, const model::Direction& end) const {
    return posture.plan(frame, {start, direction(start), end, {}, {}});
  }
  // Type 1: from pose to pose.
  [[nodiscard]] model::PosturePlan to(const model::Pose& start, const model::Pose& end) const {
    return posture.plan(frame, {start, direction(start), direction(end), end, {}});
  }
  [[nodiscard]] model::Direction direction(const model::Pose& pose) const {
    const model::Vector unit = frame->frame.from_table(machine.direction(pose));
    return {unit, 1, unit, true};
  }
  // The alarm of a block, or none.
  template <class End>
  [[nodiscard]] std::string alarm(const model::Pose& start, const End& end) const {
    try {
      static_cast<void>(to(start, end));
    } catch (const model::Alarm& alarm) {
      return toolcomp::test::usual_number(alarm.cause);
    }
    return "none";
  }

  spec::Setup setup;
  model::Recorder recorder{true};
  model::Machine machine;
  model::PairChoice choice;
  model::ToolPostureControl posture;
  model::SharedFrame frame;
};

// "tool-side work-side", degrees.
inline std::string text(const model::Pose& pose, int digits = 13) {
  return pose.tool.degrees().decimal(digits) + ' ' + pose.work.degrees().decimal(digits);
}
inline std::string text(const model::Vector& v, int digits = 15) {
  return v.x.decimal(digits) + ' ' + v.y.decimal(digits) + ' ' + v.z.decimal(digits);
}
inline std::string pose_at(const model::PosturePlan& plan, const model::Rational& t, int digits = 13) {
  return text(plan.motion->at(t).pose, digits);
}

}  // namespace toolcomp::test

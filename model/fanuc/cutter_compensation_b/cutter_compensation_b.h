// SPDX-License-Identifier: Apache-2.0
// Cutter compensation B: G40, G41, G42 and G39.
#pragma once

#include "model/fanuc/cutter_compensation/cutter_compensation.h"
#include "model/fanuc/cutter_compensation_b/rules.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// Every block by itself, without look-ahead: the tool goes from head to head. Clauses: fanuc.cutter-b.*.
class CutterCompensationB : public CutterCompensation {
 public:
  explicit CutterCompensationB(const Place& place);

  [[nodiscard]] int look_ahead() const override { return 0; }
  [[nodiscard]] bool on() const override { return side_ != CutterSide::none; }
  // Throws Alarm PS0038.
  void take(const Step& step) override;
  void finish() override {}

 private:
  [[nodiscard]] bool wanted(CutterSide side, std::uint32_t /*number*/) const override {
    return side != CutterSide::none;
  }
  // Throws Alarm PS0028, PS0037, FORBIDDEN_IN_CUTTER_COMPENSATION, PS0042, PS0035 or PS0034.
  void check(const CutterBlock& words) const override;
  void check_corner_arc(const CutterBlock& words) const;
  void check_arc(const CutterBlock& words) const;

  // The kinds of blocks; each gives the moves of `step` their vectors.
  void run(Step& step);
  void cancel(Step& step);
  void corner_arc(Step& step);
  void line(Step& step);
  void arc(Step& step);
  void machine_position(Step& step);
  // All moves end with the vector in force.
  void keep(Step& step) const;

  spec::Axes axes_;
  CutterBRules rules_;
  CutterSide side_ = CutterSide::none;  // group 07 in force
  bool started_ = false;                // the start-up is made
  PlanePoint vector_;                   // in force
};

}  // namespace toolcomp::model

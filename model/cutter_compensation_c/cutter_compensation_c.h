// Cutter compensation C: G40, G41, G42 and G39.
#pragma once

#include "model/program/cutter_compensation.h"
#include "model/recorder.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// Clauses: fanuc.cutter-c.*.
class CutterCompensationC : public CutterCompensation {
 public:
  CutterCompensationC(const spec::Setup& setup, Recorder& recorder, Output output);

  [[nodiscard]] bool on() const override { return false; }
  void read(const CutterBlock& words) override;
  void take(const Step& step) override;
  void finish() override;
};

}  // namespace toolcomp::model

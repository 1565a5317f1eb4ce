#include "model/cutter_compensation_c/cutter_compensation_c.h"

#include <utility>

namespace toolcomp::model {

CutterCompensationC::CutterCompensationC(const spec::Setup& /*setup*/, Recorder& recorder, Output output)
    : CutterCompensation(recorder, std::move(output)) {}

void CutterCompensationC::read(const CutterBlock& /*words*/) {}
void CutterCompensationC::take(const Step& step) { emit(step); }
void CutterCompensationC::finish() {}

}  // namespace toolcomp::model

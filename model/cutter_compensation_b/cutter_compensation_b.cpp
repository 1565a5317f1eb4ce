#include "model/cutter_compensation_b/cutter_compensation_b.h"

#include <utility>

namespace toolcomp::model {

CutterCompensationB::CutterCompensationB(const spec::Setup& /*setup*/, Recorder& recorder, Output output)
    : CutterCompensation(recorder, std::move(output)) {}

void CutterCompensationB::read(const CutterBlock& /*words*/) {}
void CutterCompensationB::take(const Step& step) { emit(step); }
void CutterCompensationB::finish() {}

}  // namespace toolcomp::model

#include "fast/cutter_compensation_c/cutter_compensation_c.h"

namespace toolcomp::fast {

CutterCompensationC::CutterCompensationC(const spec::Setup&, EventSink& sink) : sink_(sink) {}

Alarm CutterCompensationC::check(const CutterCommand&) const { return alarm::kNone; }

StageEnd CutterCompensationC::block() {
  active_ = next().side != CutterSide::off;
  if (next().own) sink_.on(next().event);
  return {};
}

StageEnd CutterCompensationC::release() { return {}; }

}  // namespace toolcomp::fast

#include "fast/cutter_compensation_b/cutter_compensation_b.h"

namespace toolcomp::fast {

CutterCompensationB::CutterCompensationB(const spec::Setup&, EventSink& sink) : sink_(sink) {}

Alarm CutterCompensationB::check(const CutterCommand&) const { return alarm::kNone; }

StageEnd CutterCompensationB::block() {
  active_ = block_.side != CutterSide::off;
  if (block_.own) sink_.on(block_.event);
  return {};
}

}  // namespace toolcomp::fast

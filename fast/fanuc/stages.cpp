// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/stages.h"

#include "fast/fanuc/cutter_compensation/cutter_stage.h"
#include "fast/fanuc/cutter_compensation_b/cutter_compensation_b.h"
#include "fast/fanuc/cutter_compensation_c/cutter_compensation_c.h"
#include "fast/fanuc/leading_edge_offset/leading_edge_stage.h"
#include "fast/fanuc/tool_side_compensation/tool_side_stage.h"

namespace toolcomp::fast {
namespace {

// Its parameters are examined, whether the setup has the section or not.
template <class Section>
void add(Stages& stages, const spec::Setup& setup, Control& control, EventSink& sink, bool built = true) {
  auto stage = std::make_unique<Section>(setup, control, sink);
  if (built) stages.push_back(std::move(stage));
}

}  // namespace

Stages make_stages(const spec::Setup& setup, Control& control, EventSink& sink) {
  const bool b = setup.cutter_compensation == spec::CutterCompensationType::b;
  Stages stages;
  add<LeadingEdgeStage>(stages, setup, control, sink);
  add<ToolSideStage>(stages, setup, control, sink);
  add<CutterStage<CutterCompensationB>>(stages, setup, control, sink, b);
  add<CutterStage<CutterCompensationC>>(stages, setup, control, sink, !b);
  return stages;
}

}  // namespace toolcomp::fast

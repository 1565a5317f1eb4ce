// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/stages.h"

#include "model/fanuc/cutter_compensation_b/cutter_compensation_b.h"
#include "model/fanuc/cutter_compensation_c/cutter_compensation_c.h"
#include "model/fanuc/leading_edge_offset/leading_edge_offset.h"
#include "model/fanuc/tool_side_compensation/tool_side_compensation.h"

namespace toolcomp::model {
namespace {

template <class Section>
std::unique_ptr<Stage> make(const Stage::Place& place) {
  return std::make_unique<Section>(place);
}

}  // namespace

std::vector<StageMaker> stages(const spec::Setup& setup) {
  const bool type_b = setup.cutter_compensation == spec::CutterCompensationType::b;
  return {
      make<LeadingEdgeOffset>,
      type_b ? make<CutterCompensationB> : make<CutterCompensationC>,
      make<ToolSideCompensation>,
  };
}

}  // namespace toolcomp::model

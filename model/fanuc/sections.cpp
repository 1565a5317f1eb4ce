// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/sections.h"

#include "model/fanuc/cutter_compensation_b/cutter_compensation_b.h"
#include "model/fanuc/cutter_compensation_c/cutter_compensation_c.h"
#include "model/fanuc/leading_edge_offset/leading_edge_offset.h"
#include "model/fanuc/tool_side_compensation/tool_side_compensation.h"

namespace toolcomp::model {
std::vector<PassMaker> sections(const spec::Setup& setup) {
  const bool type_b = setup.cutter_compensation == spec::CutterCompensationType::b;
  return {
      leading_edge_offset,
      type_b ? cutter_compensation_b : cutter_compensation_c,
      tool_side_compensation,
  };
}

}  // namespace toolcomp::model

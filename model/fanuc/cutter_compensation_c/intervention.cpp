// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/cutter_compensation_c/intervention.h"

namespace toolcomp::model {

std::optional<HeadsAfterIntervention> after_intervention(const CornerRules& rules, const Intervention& intervention) {
  const PlanePoint start = intervention.stop + intervention.moved;
  const PlanePoint end = intervention.incremental ? intervention.end + intervention.moved : intervention.end;
  const PlanePoint travel = end - start;
  if (is_zero(travel)) return std::nullopt;
  const OffsetPath path = line_path(travel, intervention.offset, intervention.offset);
  const std::optional<VectorGroup> group = intervention.offset == 0 ? std::optional(rules.square_to(path.end))
                                                                    : rules.offset_mode(path.end, intervention.next);
  if (!group) return std::nullopt;
  HeadsAfterIntervention heads;
  for (const CornerVector& vector : intervention.group) heads.at_stop.push_back(start + vector.vector);
  for (const CornerVector& vector : *group) heads.at_end.push_back(end + vector.vector);
  return heads;
}

}  // namespace toolcomp::model

// The interference check of cutter compensation C and the removal of vectors (chapter 14.6.5), and the tool's own arc.
#pragma once

#include <optional>

#include "fast/arithmetic/count.h"
#include "fast/fanuc/cutter_compensation_c/corner_group.h"
#include "fast/geometry/path.h"
#include "spec/language/event.h"

namespace toolcomp::fast {

// A block between the groups at its start and its end.
struct CheckedBlock {
  const PlanePath* path = nullptr;
  int start_side = 1;  // of the offset at the corner at its start
  const Amount* start_offset = nullptr;
  int end_side = 1;
  const Amount* end_offset = nullptr;
};

enum class Interference : std::uint8_t {
  none,
  straightened,  // an arc that lost a vector: a straight move
  alarm,         // PS0041
};

// How the distances of the two heads from the centre compare, where it is known without computing them.
enum class Radii : std::uint8_t { agree, differ, unknown };
// Sweep and radii of the arc from start + v to end + w.
void set_tool_arc(spec::Arc<double>& arc, const PlanePath& path, const Vector2<double>& v, const Vector2<double>& w,
                  Radii radii);
// The same of the arc as programmed.
void set_programmed_arc(spec::Arc<double>& arc, const PlanePath& path);

// Drops the vectors that interfere from the end of `start` and the beginning of `end`. `arc`: the tool's own, between
// the last of `start` and the first of `end`; of a line there is none.
Interference check_interference(const CheckedBlock& block, const std::optional<spec::Arc<double>>& arc,
                                CornerGroup& start, CornerGroup& end);

}  // namespace toolcomp::fast

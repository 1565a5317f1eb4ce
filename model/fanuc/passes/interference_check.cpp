// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/passes/interference_check.h"

namespace toolcomp::model {

// fanuc.cutter-c.interference-at-once: With No. 5008 bit 3, CNV, at 1, cutter compensation C on series 30i drops no
// vector. The first pair with interference is then the last one, so PS0041 comes at once. On series 16i the bit means
// nothing.
// fanuc.cutter-c.interference-without-alarm: With No. 5008 bit 1, CNC, at 1, cutter compensation C raises no alarm if
// the last pair interferes because the directions differ by 90 to 270 degrees (fanuc.cutter-c.interference-direction).
// The block then runs between the vectors that are left.
// fanuc.cutter-c.interference-straightened: An arc block that has interfered in its first pair is a straight block from
// then on. The next pairs are tested as for a line from P to Q. The block's own move is linear, from the last vector
// left at its start to the first vector left at its end, with the block's feed; the cause is programmed.
Checked check_interference(Recorder& recorder, const InterferenceRules& rules, const CheckedPath& path,
                           SpaceGroup& at_start, SpaceGroup& at_end, ToolArcRun* run) {
  bool by_direction = false;
  Vector last_from;
  Vector last_to;
  const auto interferes = [&](bool first, const SpaceVector& from, const SpaceVector& to) {
    by_direction = !first || run == nullptr;
    last_from = from.vector;
    last_to = to.vector;
    const bool result = by_direction ? path.line_interferes(from.vector, to.vector) : path.arc_interferes(*run);
    if (first && result && rules.by_parameters)
      recorder.decide(Clause::fanuc_cutter_c_interference_at_once, rules.keeps_vectors);
    return result;
  };
  const bool drops = !rules.keeps_vectors;
  Checked checked{remove_interference(recorder, at_start, at_end, interferes, drops), {}};
  if (checked.passage == Passage::blocked && by_direction && rules.by_parameters &&
      recorder.decide(Clause::fanuc_cutter_c_interference_without_alarm, rules.no_alarm))
    checked.passage = drops ? leave_outer_vectors(at_start, at_end) : Passage::free;
  if (checked.passage == Passage::blocked)
    checked.crossing = by_direction ? path.backwards(last_from, last_to) : path.excess();
  if (checked.passage == Passage::shortened)
    recorder.decide(Clause::fanuc_cutter_c_interference_straightened, run != nullptr);
  return checked;
}

}  // namespace toolcomp::model

// SPDX-License-Identifier: Apache-2.0
// The interference check of a block between the vectors at its start and at its end.
#pragma once

#include <functional>

#include "model/fanuc/corner/interference.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// What parameters say of the check.
struct InterferenceRules {
  bool checks = true;          // 5008#0, CNI, is 0
  bool by_parameters = false;  // the next two concern the section
  bool keeps_vectors = false;  // the first pair that interferes is the last one
  bool no_alarm = false;       // where the tool goes against the programmed direction
};

// How a section sees its block between two vectors.
struct CheckedPath {
  // Whether an arc interferes that the tool runs so. Clauses: fanuc.cutter-c.interference-radius, interference-sweep.
  std::function<bool(ToolArcRun& run)> arc_interferes;
  // Whether the block, as a line, interferes between two vectors. Clause: fanuc.cutter-c.interference-direction.
  std::function<bool(const Vector& from, const Vector& to)> line_interferes;
  // How far the tool goes against the block between two vectors that interfere so, setup units.
  std::function<Real(const Vector& from, const Vector& to)> backwards;
  // By how much the offset of an arc that interferes is larger than its radius, setup units; 0 where its sweep does.
  std::function<Real()> excess;
};

// Drops vectors of both groups until the block does not interfere. `run`: of an arc, between the inner vectors.
// `crossing`: of a blocked one, by how much its paths cross. Clauses: fanuc.cutter-c.interference-*.
struct Checked {
  Passage passage = Passage::free;
  Real crossing;
};
Checked check_interference(Recorder& recorder, const InterferenceRules& rules, const CheckedPath& path,
                           SpaceGroup& at_start, SpaceGroup& at_end, ToolArcRun* run);

}  // namespace toolcomp::model

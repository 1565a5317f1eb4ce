// What one block means to cutter compensation C: along which path the tool runs, on which side and how far away.
#pragma once

#include "model/fanuc/corner/offset_path.h"
#include "model/fanuc/cutter_compensation/cutter_block.h"
#include "model/fanuc/program/cutter_offset.h"

namespace toolcomp::model {

// The path of a moving block: at its start with the distance in force before it, each on the block's own side.
OffsetPath path_of(const CutterBlock& block, const CutterOffset& own, const Rational& distance_before);

}  // namespace toolcomp::model

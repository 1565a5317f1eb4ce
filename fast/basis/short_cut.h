// SPDX-License-Identifier: Apache-2.0
// Short cuts for usual blocks: they give what the general path gives, without its detours. A test build can close them,
// so that both can be compared (tests/harness/short_cuts.cpp).
#pragma once

namespace toolcomp::fast {

enum class ShortCut : unsigned char {
  axis_line,          // fanuc/interpreter/usual_axis_lines.*
  cutter_b_arc,       // fanuc/cutter_compensation_b/usual_arc.*
  cutter_b_move,      // fanuc/cutter_compensation_b/usual_moves.*
  cutter_line,        // fanuc/cutter_compensation_c/usual_line.cpp
  cutter_path,        // fanuc/corner/usual_paths.*, for cutter compensation C
  leading_edge_line,  // fanuc/leading_edge_offset/usual_edge_line.cpp, fanuc/leading_edge_offset/usual_line.h
  tool_side_line,     // fanuc/tool_side_compensation/usual_side_line.cpp, fanuc/tool_side_compensation/usual_line.h
  tool_side_path,     // fanuc/corner/usual_paths.*, for tool side compensation
  tip_line,           // fanuc/control/usual_tip_lines.*
  posture,            // fanuc/tool_posture_control/usual_posture.cpp
  pair,               // kinematics/usual_pair.cpp
};

#ifdef TOOLCOMP_FAULTS
// Bit i: short cut i is closed, for the runs of one thread.
inline thread_local unsigned closed_short_cuts = 0;
inline bool is_open(ShortCut s) { return (closed_short_cuts >> static_cast<unsigned>(s) & 1U) == 0; }
#elif defined(TOOLCOMP_GENERAL_PATHS)
// All short cuts are closed, for the benchmarks of the general paths.
constexpr bool is_open(ShortCut) { return false; }
#else
// In a normal build all short cuts are open, and the compiler removes this.
constexpr bool is_open(ShortCut) { return true; }
#endif

}  // namespace toolcomp::fast

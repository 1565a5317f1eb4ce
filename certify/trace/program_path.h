// SPDX-License-Identifier: Apache-2.0
// The exact path of a program, which the model gives piece by piece on request.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "certify/trace/path.h"
#include "certify/trace/space.h"
#include "model/basis/event.h"
#include "spec/language/case.h"

namespace toolcomp::certify {

// The coordinates of a path, and of the recording to be compared with it.
enum class PathFrame : std::uint8_t {
  workpiece,  // of the events' `axes`; they jump if the program changes the coordinates (G54 to G59, G92)
  machine,    // of the events' `machine`; they never jump
};

struct ProgramPathOptions {
  bool judge_rapids = true;  // false: rapid moves are free pieces
  PathFrame frame = PathFrame::workpiece;
  std::function<void(const model::Event&)> on_event;  // called for every event, before the pieces of its move
};

// The pieces of a run of `c.program`, in order. The model is fed as few blocks as the next piece needs, so that memory
// grows neither with the program nor with the pieces of a block (except for the text of the program, which belongs to
// the case).
//
// A straight move is one piece. Its ends are the exact positions as doubles, off by the same ulp as a recording in
// doubles, and its error is 0. Curves, that is arcs and what bends under tool center point control, are divided until a
// chord is certified to be within a hundredth of the tolerance (curve_bound.h; where the tool-side axis leaves the edge
// of its reach, whose rate is infinite, and the tolerance is near what doubles tell there, a few times that); the
// points between them are exact positions at the same fraction of the move, as doubles. Their error is that of the
// chord and what its ends are off. If the path moves along a curve evenly with t, the piece does so too, and the error
// holds at the same fraction of both.
class ProgramPath : public PathSource {
 public:
  // `tolerance` is for the axes of `space`, and must be positive. `c` must outlive the path. Samples of the case are
  // not used. Throws spec::InputError for a setup that the control could not have, for a tolerance that is not
  // positive, and for machine coordinates of a control that has none here (Klartext, in which all positions count from
  // the preset).
  ProgramPath(const spec::Case& c, TraceSpace space, Distance tolerance, ProgramPathOptions options = {});
  ProgramPath(const ProgramPath&) = delete;
  ProgramPath& operator=(const ProgramPath&) = delete;
  ~ProgramPath() override;

  // Throws spec::InputError for bytes that are not text, when it reaches them.
  bool next(PathPiece& piece) override;

  // At the end of the path: why the model could not decide how the path goes on; empty if it could.
  [[nodiscard]] const std::string& undecided() const;
  // At the end of the path: number and line of the alarm that stopped the run; empty if there was none.
  [[nodiscard]] const std::string& alarm() const;

 private:
  class Run;
  std::unique_ptr<Run> run_;
};

}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
// The exact path of a program, from the model, piece by piece as they are asked for.
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
  workpiece,  // of the events' `axes`; they jump where the program changes them (G54 to G59, G92)
  machine,    // of the events' `machine`; they never jump
};

struct ProgramPathOptions {
  bool judge_rapids = true;  // false: rapid moves are free pieces
  PathFrame frame = PathFrame::workpiece;
  std::function<void(const model::Event&)> on_event;  // gets every event, before the pieces of its move
};

// The pieces of a run of `c.program`, in order. The model is fed as few blocks as the next piece needs, so memory grows
// neither with the program nor with the pieces of a block (but for the text of the program, which is the case's).
//
// Straight moves are one piece; its ends are the exact ones as doubles, off by the ulp that a recording in doubles is
// off, too, and its error is 0. Curves, that is arcs and what bends under tool center point control, are divided until
// a chord is certified to be within a hundredth of the tolerance (curve_bound.h; where the tool-side axis leaves the
// edge of its reach, whose rate is infinite, and the tolerance is near what doubles tell there, a few times that); the
// points between them are exact positions at the same fraction of the move, as doubles. Their error is that of the
// chord and what its ends are off. Where the path goes along a curve evenly with t so does the piece: at the same
// fraction of it they are that near.
class ProgramPath : public PathSource {
 public:
  // `tolerance`: of what `space` measures; positive. `c` must outlive the path. Samples of the case are not made.
  // Throws spec::InputError for a setup the control could not have, a tolerance that is not positive, and machine
  // coordinates of a control that has none here (Klartext: all counts from the preset).
  ProgramPath(const spec::Case& c, TraceSpace space, Distance tolerance, ProgramPathOptions options = {});
  ProgramPath(const ProgramPath&) = delete;
  ProgramPath& operator=(const ProgramPath&) = delete;
  ~ProgramPath() override;

  // Throws spec::InputError for bytes that are no text, when they are reached.
  bool next(PathPiece& piece) override;

  // At the end of the path: why the model could not decide how it goes on. Empty: it could.
  [[nodiscard]] const std::string& undecided() const;
  // At the end of the path: the alarm that stopped the run, its number and line. Empty: none did.
  [[nodiscard]] const std::string& alarm() const;

 private:
  class Run;
  std::unique_ptr<Run> run_;
};

}  // namespace toolcomp::certify

// The exact path of a run, all of it at once.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "certify/trace/path.h"
#include "spec/language/case.h"
#include "spec/language/event.h"

namespace toolcomp::certify {

// Arcs become chords whose sagitta is at most a thousandth of the tolerance; a move with samples becomes chords from
// one to the next. Between two moves with a block that changes the workpiece system (G54–G59, G92) the coordinates may
// jump: the inside of the latter move is not judged, nor that of rapid moves if `judge_rapids` is false.
class OldProgramPath : public PathSource {
 public:
  OldProgramPath(const spec::Case& c, const TraceSpace& space, double tolerance, bool judge_rapids);
  bool next(PathPiece& piece) override;
  [[nodiscard]] std::vector<spec::Event<double>> take_events() { return std::move(events_); }
  // Why the model could not decide; empty: it could.
  [[nodiscard]] const std::string& undecided() const { return undecided_; }

 private:
  std::vector<PathPiece> pieces_;
  std::size_t next_ = 0;
  std::vector<spec::Event<double>> events_;
  std::string undecided_;
};

}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
#include "certify/causes/programmed_path.h"

#include <utility>
#include <vector>

#include "certify/causes/listed_path.h"
#include "certify/convert.h"
#include "certify/trace/blocks.h"
#include "certify/trace/metric.h"
#include "judge/oracle/number.h"
#include "model/fanuc/program/motion.h"

namespace toolcomp::certify {
namespace {

class Programmed : public model::EventSink, public model::MotionSink {
 public:
  Programmed(const spec::Case& c, const TraceSpace& space, PathFrame frame) : space_(space), frame_(frame) {
    for (const auto& [letter, start] : c.setup.position)
      if (const std::size_t axis = c.setup.axes.index(letter); axis != spec::Axes::kNone)
        at_.at(axis) = judge::approximate(start);
  }

  // Nothing where the model could not decide, or tool center point control was never in force.
  [[nodiscard]] std::unique_ptr<PathSource> path() && {
    if (!decided_ || !controlled_) return nullptr;
    return std::make_unique<ListedPath>(std::make_shared<const std::vector<PathPiece>>(std::move(pieces_)));
  }

  void on(const model::MoveMotion& motion) override { zero_ = motion.zero; }
  void stand(const model::SharedZero& zero, std::uint64_t line, const std::optional<std::uint64_t>&) override {
    if (line > 0) return;
    zero_ = zero;
    in_frame(at_);
  }
  void on(const model::Event& exact) override {
    if (exact.kind == spec::EventKind::undecided) decided_ = false;
    if (exact.hole) decided_ = false;  // what the axes do there is the cycle's
    if (exact.kind != spec::EventKind::move) return;
    // Turns of the work-side axis before and behind a block are made for the tool's sake alone.
    if (exact.cause == spec::Cause::pre_turn || exact.cause == spec::Cause::post_turn) return;
    const spec::Event<double> event = in_double(exact);
    controlled_ = controlled_ || event.tool_axis;
    PathPiece piece;
    piece.begin = at_;
    for (const std::size_t axis : space_.linear) at_.at(axis) = event.programmed[axis];
    for (const std::size_t axis : space_.rotary) at_.at(axis) = event.axes[axis];
    in_frame(at_);
    piece.end = at_;
    piece.line = event.line;
    piece.n = event.n;
    pieces_.push_back(piece);
  }

 private:
  void in_frame(AxisPoint& p) const {
    if (frame_ == PathFrame::workpiece || !zero_) return;
    for (const auto* axes : {&space_.linear, &space_.rotary})
      for (const std::size_t axis : *axes) p.at(axis) += zero_->at(axis).double_enclosure().lower;
  }

  const TraceSpace& space_;
  PathFrame frame_;
  AxisPoint at_{};
  model::SharedZero zero_;  // of what comes next
  std::vector<PathPiece> pieces_;
  bool decided_ = true;
  bool controlled_ = false;
};

}  // namespace

std::unique_ptr<PathSource> programmed_path(const spec::Case& c, const TraceSpace& space, PathFrame frame) {
  if (!c.setup.parameter(19680)) return nullptr;
  Programmed programmed(c, space, frame);
  const std::unique_ptr<Blocks> blocks = blocks_of(c, programmed, programmed);
  while (blocks->next()) continue;
  return std::move(programmed).path();
}

}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
// The last stage under tool center point control: axis positions of a move from its compensated tip, the turns before
// and behind it, and the positions inside it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "model/basis/event.h"
#include "model/fanuc/program/step.h"
#include "spec/language/axes.h"

namespace toolcomp::model {

// Takes the moves of a run in order.
class TipMoves {
 public:
  // Receives a move whose axes are known, with its inside where that is asked for, and a sample of the move that
  // follows.
  using MoveOutput = std::function<void(const Move& move, std::shared_ptr<const InsideMove> inside)>;
  using SampleOutput = std::function<void(const Event& sample)>;

  // `samples`: N of the fractions k/N inside a block; 0: none. `with_inside`: the inside of moves is asked for.
  TipMoves(spec::Axes axes, std::uint32_t samples, bool with_inside, MoveOutput moves, SampleOutput inside)
      : axes_(std::move(axes)),
        samples_(samples),
        with_inside_(with_inside),
        moves_(std::move(moves)),
        inside_(std::move(inside)) {}

  void take(const Move& move);

 private:
  void turn(const Move& at, const Pose& to, spec::Cause cause, const Move& of) const;

  spec::Axes axes_;
  std::uint32_t samples_;
  bool with_inside_;
  MoveOutput moves_;
  SampleOutput inside_;
  std::optional<Move> last_;  // where the tool stands, under tool center point control
};

// X Y Z of the axes, workpiece coordinates, at the end of a move under tool center point control.
Vector axes_at(const Move& move, const spec::Axes& axes);
// Where the tip is at the end of a move whose end is named for another pose, in the workpiece system: around a turn.
std::optional<Vector> tip_beside_name(const Move& move, const spec::Axes& axes);

}  // namespace toolcomp::model

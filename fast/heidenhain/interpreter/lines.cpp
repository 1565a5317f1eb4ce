// SPDX-License-Identifier: Apache-2.0
// LN blocks as arrays: usual ones of face milling.
#include <limits>

#include "fast/arrays/line_moves.h"
#include "fast/heidenhain/interpreter/interpreter.h"

namespace toolcomp::fast::klartext {
namespace {

constexpr std::uint32_t kXyz = 0b111U << word_place('X');
constexpr std::uint32_t kNormal = 0b111U << kNormalPlace;
constexpr std::uint32_t kToolVector = 0b111U << kToolVectorPlace;

std::array<std::int64_t, 3> whole(const LineChunk& chunk, std::size_t place, std::size_t i) {
  const auto at = [&](std::size_t component) { return static_cast<std::int64_t>(chunk.word(place + component)[i]); };
  return {at(0), at(1), at(2)};
}

}  // namespace

bool Interpreter::may_be_face_lines(const LineChunk& chunk) const {
  const bool turned = (chunk.words & kToolVector) != 0;
  return (chunk.words & ~kToolVector) == (kXyz | kNormal) && started_ && !stopped_ && !shifted_ && side_ == 0 &&
         !peripheral_.holds() && tool_.called() && tool_.deviations() == nullptr && (tcpm_ || !turned) &&
         !tool_.check(true, oversize_) && face_.sees_contact() && unknown_ == 0;
}

// X, Y, Z move; a rotary axis has no word in these blocks.
void Interpreter::fill(LineMoves& made) const {
  Event& event = made.event;
  event.type = spec::MoveType::linear;
  event.feed = feed_;
  made.of_held = false;
  made.by_vector = true;
  made.moving = static_cast<Mask>(1U << axis_[0] | 1U << axis_[1] | 1U << axis_[2]);
  event.axes.present = static_cast<std::uint16_t>(made.moving | parallel_axes_);
  for (std::size_t axis = 0; axis < setup_.axes.size(); ++axis) event.axes.value[axis] = head_.position[axis];
}

std::size_t Interpreter::lines(const LineChunk& chunk) {
  if (!may_be_face_lines(chunk)) return 0;
  FaceLineStart start;
  face_.set_start(start);
  const bool turned = (chunk.words & kToolVector) != 0;
  start.along = tcpm_ && !turned;
  start.tool = direction_->unit();
  start.whole_tool = direction_->vector().nearest();
  start.contour = contour_;
  start.tip_below = programmed_point().tip_below(tool_.values(), true);
  start.values = &tool_.values();
  const FaceLineEnd end = take_face_lines(chunk, start, {axis_[0], axis_[1], axis_[2]});
  if (end.taken == 0) return 0;
  if (chunk.made != nullptr) fill(*chunk.made);
  Moves& moves = *chunk.moves;
  for (std::size_t axis = 0; axis < moves.axes(); ++axis) {
    if (axis == axis_[0] || axis == axis_[1] || axis == axis_[2]) continue;
    const bool stays = (parallel_axes_ >> axis & 1U) != 0;  // a rotary axis has no word in these blocks
    moves.set_axis(axis, end.taken, stays ? head_.position[axis] : std::numeric_limits<double>::quiet_NaN());
  }
  moves.append_lines(end.taken, chunk.line);

  rounded_ = 0;
  slack_ = 0;
  const std::size_t last = end.taken - 1;
  const std::array<std::int64_t, 3> at = whole(chunk, word_place('X'), last);
  for (std::size_t i = 0; i < 3; ++i) {
    position_[i].set_small(at[i]);
    write_position(i, Count::nearest_small(at[i]));
  }
  face_.set_end(end, whole(chunk, kNormalPlace, last));
  if (start.along) {
    new_direction().set(face_.normal(), face_.unit_normal());
  } else if (turned) {
    WholeVector vector;
    vector.small = whole(chunk, kToolVectorPlace, last);
    new_direction().set(vector, unit_of(vector).unit);
  }
  face_.set_end_tool(*direction_);
  return end.taken;
}

}  // namespace toolcomp::fast::klartext

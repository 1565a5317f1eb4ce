// Own moves of blocks and the events they make: the path every block takes.
#include "fast/basis/fault.h"
#include "fast/fanuc/interpreter/fill.h"
#include "fast/fanuc/interpreter/interpreter.h"
#include "fast/fanuc/interpreter/usual_words.h"

namespace toolcomp::fast {

Factor Interpreter::factor(bool inch_program) const {
  if (inch_program == inch_setup_) return Factor::one;
  return inch_program ? Factor::inch_to_mm : Factor::mm_to_inch;
}

Count Interpreter::converted(const spec::Decimal& word, bool linear, bool inch_program) const {
  int places = 0;
  if (counts_increments_ && !word.point)
    places = increment_places_ + (linear && inch_program && !fault(Fault::inch_increment) ? 1 : 0);
  return Count::of(word, linear && !fault(Fault::inch_not_converted) ? factor(inch_program) : Factor::one, places);
}

Count Interpreter::target(const Words& words, std::size_t axis) const {
  const Count word = value(words.axis(axis), (linear_ & bit(axis)) != 0, inch_program_);
  if (!incremental_) return word;
  if (fault(Fault::incremental_from_offset_position)) return programmed_[axis] + length_[axis] + word;
  return programmed_[axis] + word;
}

Alarm Interpreter::place(std::size_t axis, const Count& position) {
  if (!position.in_range()) return alarm::kRange;
  programmed_[axis] = position;
  programmed_value_[axis] = position.nearest();
  stale_ = static_cast<Mask>(stale_ | bit(axis));
  return alarm::kNone;
}

Alarm Interpreter::refresh() {
  const Alarm a = for_each_axis(stale_, [this](std::size_t axis) {
    axes_value_[axis] = programmed_value_[axis];
    if (((length_.live() | tool_offset_.live()) & bit(axis)) != 0) {
      const Count position = actual(axis) + length_[axis];
      if (!position.in_range()) return alarm::kRange;
      axes_value_[axis] = position.nearest();
    }
    return alarm::kNone;
  });
  stale_ = 0;
  return a;
}

void Interpreter::fill(Event& event, spec::MoveType type, spec::Cause cause) { fill_here(event, type, cause); }

// L along the tool.
void Interpreter::add_length(Event& event) const {
  for (std::size_t i = 0; i < 3; ++i) {
    if (xyz_[i] == spec::Axes::kNone) continue;
    const double offset = along_length_ * directions_[direction_].unit[static_cast<Eigen::Index>(i)];
    event.axes.value[xyz_[i]] += offset;
    event.machine.value[xyz_[i]] += offset;
  }
}

void Interpreter::fill_displaced_machine(Event& event) const {
  for (std::size_t axis = 0; axis < count_; ++axis) {
    const bool displaced = ((displaced_ | stale_) & bit(axis)) != 0;
    event.machine.value[axis] =
        displaced ? (actual(axis) + length_[axis] + machine_origin(axis)).nearest() : axes_value_[axis];
  }
}

Alarm Interpreter::motion(const Words& words, Compensation compensation, bool own, bool extra,
                          const std::optional<spec::Arc<double>>& arc) {
  const Mask axes = own ? words.axes() : Mask{0};
  const bool compensated = compensation == Compensation::stays;
  if (fault(Fault::shift_lost) && !incremental_ && !words.is_tool_offset())
    (void)for_each_axis(axes, [this](std::size_t axis) {
      tool_offset_.clear(axis);
      return alarm::kNone;
    });
  const Count& x = programmed(xyz_[0]);
  const Count& y = programmed(xyz_[1]);
  const Count& z = programmed(xyz_[2]);
  const Mask rounded_before = rounded_;
  bool small = false;
  std::int64_t from_x = 0;
  std::int64_t from_y = 0;
  std::int64_t from_z = 0;
  std::array<Count, 3> from;
  if (compensated) {
    small = rounded_before == 0 && x.is_small() && y.is_small() && z.is_small();
    from_x = x.small();
    from_y = y.small();
    from_z = z.small();
    if (!small) from = {x, y, z};
  }

  if (const Alarm a = place_words(words, axes)) return a;

  // As early as can be: what has just been written is waited for.
  const bool usual = compensated && small && x.is_small() && y.is_small() && z.is_small();
  if (usual)
    set_displacement(leading_edge_.next().displacement, x.small() - from_x, y.small() - from_y, z.small() - from_z);

  constexpr std::uint32_t kDirectionLetters = Words::set_of("IJK");
  const bool event = axes != 0 || extra || arc || (own && by_vector_ && words.has_any(kDirectionLetters));
  // A start or cancel move takes a change of the length offset along; the block makes no second move.
  if (event && (compensation == Compensation::off || compensated)) {
    Event& move = leading_edge_.next().event;
    fill(move, arc ? spec::MoveType::arc : straight(), spec::Cause::programmed);
    if (arc) move.arc = arc;
  }
  switch (compensation) {
    case Compensation::off:
      if (event) leading_edge_.pass();
      return alarm::kNone;
    case Compensation::stays: {
      Move& move = leading_edge_.next();
      if (!usual) [[unlikely]] {
        if (small) {
          from[0].set_small(from_x);
          from[1].set_small(from_y);
          from[2].set_small(from_z);
        }
        Mask xyz = 0;
        for (const std::size_t axis : xyz_)
          if (axis != spec::Axes::kNone) xyz = static_cast<Mask>(xyz | bit(axis));
        const auto rounded = static_cast<Mask>((rounded_before | rounded_) & axes & xyz);
        set_displacement(move.displacement, from, {x, y, z}, rounded != 0 ? 2 : 0);
      }
      move.direction = &directions_[direction_];
      move.radius = radius_;
      // The only alarms here are those of the start-up move.
      if (const Alarm a = leading_edge_.block(event, !move.displacement.zero)) raise_at_start(a);
      return alarm::kNone;
    }
    case Compensation::starts: {
      Move& move = leading_edge_.next();
      fill(move.event, straight(), spec::Cause::start_up);
      move.direction = &directions_[direction_];
      move.radius = radius_;
      leading_edge_.start();
      return alarm::kNone;
    }
    case Compensation::cancels:
      if (const Alarm a = leading_edge_.finish()) return a;
      fill(leading_edge_.next().event, straight(), spec::Cause::cancel);
      leading_edge_.cancel();
      return alarm::kNone;
  }
  return alarm::kNone;
}

}  // namespace toolcomp::fast

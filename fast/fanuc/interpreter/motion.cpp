// Own moves of blocks and the events they make: the path every block takes.
#include "fast/basis/fault.h"
#include "fast/fanuc/interpreter/interpreter.h"
#include "fast/fanuc/interpreter/own_move.h"
#include "fast/fanuc/interpreter/usual_words.h"

namespace toolcomp::fast {

void Interpreter::fill(Event& event, spec::MoveType type, spec::Cause cause) { fill_here(event, type, cause); }

// The travel of a block, whatever its positions are.
void Interpreter::set_any_travel(Move& move, const std::array<Count, 3>& from, Mask rounded) const {
  Mask xyz = 0;
  for (const std::size_t axis : axes_.xyz)
    if (axis != spec::Axes::kNone) xyz = static_cast<Mask>(xyz | bit(axis));
  set_displacement(move.displacement, from, positions_.programmed_xyz(), (rounded & xyz) != 0 ? 2 : 0);
}

// The move that starts or ends leading edge offset.
Alarm Interpreter::edge_motion(Compensation compensation) {
  Move& move = leading_edge_.next();
  if (compensation == Compensation::starts) {
    fill(move.event, modal_.straight(), spec::Cause::start_up);
    move.direction = &attitude_.directions().now();
    move.radius = radius_;
    leading_edge_.start();
    return alarm::kNone;
  }
  if (const Alarm a = leading_edge_.finish()) return a;
  fill(leading_edge_.next().event, modal_.straight(), spec::Cause::cancel);
  leading_edge_.cancel();
  return alarm::kNone;
}

Alarm Interpreter::motion(const Words& words, Compensation compensation, bool own, bool extra,
                          const std::optional<spec::Arc<double>>& arc) {
  const Mask axes = own ? words.axes() : Mask{0};
  const bool compensated = compensation == Compensation::stays;
  if (fault(Fault::shift_lost) && !modal_.incremental() && !words.is_tool_offset())
    (void)for_each_axis(axes, [this](std::size_t axis) {
      positions_.tool_offset().clear(axis);
      return alarm::kNone;
    });
  const Count& x = positions_.programmed(axes_.xyz[0]);
  const Count& y = positions_.programmed(axes_.xyz[1]);
  const Count& z = positions_.programmed(axes_.xyz[2]);
  const Mask rounded_before = positions_.rounded();
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
  const bool event = axes != 0 || extra || arc || (own && modal_.by_vector() && words.has_any(kDirectionLetters));
  // A start or cancel move takes a change of the length offset along; the block makes no second move.
  if (event && (compensation == Compensation::off || compensated)) {
    Event& move = leading_edge_.next().event;
    fill(move, arc ? spec::MoveType::arc : modal_.straight(), spec::Cause::programmed);
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
        set_any_travel(move, from, static_cast<Mask>((rounded_before | positions_.rounded()) & axes));
      }
      move.direction = &attitude_.directions().now();
      move.radius = radius_;
      // The only alarms here are those of the start-up move.
      if (const Alarm a = leading_edge_.block(event, !move.displacement.zero)) raise_at_start(a);
      return alarm::kNone;
    }
    case Compensation::starts:
    case Compensation::cancels:
      return edge_motion(compensation);
  }
  return alarm::kNone;
}

}  // namespace toolcomp::fast

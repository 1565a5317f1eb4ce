// A block between the vectors at its start and at its end, and how it goes out.
#include <utility>

#include "model/basis/alarm.h"
#include "model/fanuc/corner/interference.h"
#include "model/fanuc/tool_side_compensation/tool_side_compensation.h"

namespace toolcomp::model {

void ToolSideCompensation::release(SideGroup at_end) {
  recorder().reach(Clause::fanuc_tool_side_plane);
  for (std::size_t i = 1; i < at_end.size(); ++i)
    recorder().decide(Clause::fanuc_tool_side_stop_point, !at_end[i].after_stop);
  Held& held = held_.front();
  const auto& arc = held.path.arc;
  std::optional<OffsetPath> as_seen;
  std::optional<ToolArcRun> run;
  if (arc) {
    as_seen = as_run(*arc, held.offset_at_start, held.end.offset);
    run.emplace(recorder(), *as_seen, head(*arc, here_plane_, here_.back()), head(*arc, held.plane, at_end.front()),
                pair_of(held, at_end.front()));
  }
  Passage passage = Passage::free;
  if (held.kind == Held::Kind::moving && recorder().decide(Clause::fanuc_cutter_c_interference_check, checks_))
    passage = remove_interference(held, at_end, run ? &*run : nullptr);

  Step step = std::move(held.step);
  step.clauses.add(recorder().take_clauses());
  flush();
  Move& own = step.moves.front();
  own.offset = at_end.front().vector;
  if (held.kind == Held::Kind::start_up) own.leg.cause = spec::Cause::start_up;
  if (arc && passage == Passage::shortened) {
    own.leg.type = spec::MoveType::linear;
    own.leg.arc.reset();
  } else if (arc) {
    const ToolArc tool = run->arc();
    step.clauses.add(recorder().take_clauses());
    own.leg.arc->sweep = tool.sweep;
    own.leg.arc->radius = tool.radius;
  }
  insert_corner_moves(step);
  corner_ = step.rest;
  here_ = std::move(at_end);
  here_plane_ = held.plane;
  waiting_.push_back(std::move(step));
  for (Step& other : held.keeping) waiting_.push_back(std::move(other));
  held_.pop_front();
  if (here_.size() == 1) flush();
}

Passage ToolSideCompensation::remove_interference(const Held& held, SideGroup& at_end, ToolArcRun* run) {
  const auto interferes = [&](bool first, std::size_t from, std::size_t to) {
    if (first && run != nullptr) {
      const PathEnd end = seen(held.plane, held.plane.frame(), held.end);
      return arc_interferes(recorder(), held.start, end, *run);
    }
    return line_interferes(held, here_[from].vector, at_end[to].vector);
  };
  const Kept kept = inner_pair(recorder(), here_.size(), at_end.size(), interferes);
  if (kept.passage == Passage::blocked)
    raise_held(Clause::fanuc_cutter_c_interference_alarm, "PS0041", "the tool's path goes against the programmed one");
  if (kept.passage == Passage::shortened)
    recorder().decide(Clause::fanuc_cutter_c_interference_straightened, run != nullptr);
  here_.resize(kept.from + 1);
  at_end.erase(at_end.begin(), at_end.begin() + static_cast<std::ptrdiff_t>(kept.to));
  return kept.passage;
}

// |VT|² u(Q - P) · ((Q + W) - (P + V)), in the plane at the end of the block.
bool ToolSideCompensation::line_interferes(const Held& held, const Vector& from, const Vector& to) const {
  const Vector& travel = held.path.travel;
  const Real along = dot(held.plane.along(travel), travel + (to - from));
  const Real length = sqrt(squared_norm(travel));
  const Real scale = held.plane.tool().norm2 * length * (length + sqrt(squared_norm(from)) + sqrt(squared_norm(to)));
  return recorder().decide(Clause::fanuc_cutter_c_interference_direction, along, scale) == Sign::negative;
}

// Square to an arc that starts and ends in one place, or opposite with respect to its centre, the vectors do so too.
HeadPair ToolSideCompensation::pair_of(const Held& held, const SideVector& to) const {
  const bool alike = here_.back().latter == Seat::square && to.former == Seat::square &&
                     held.offset_at_start == held.end.offset && here_plane_.is_same_as(held.plane);
  if (!alike) return HeadPair::any;
  const auto known_zero = [](const PlanePoint& v) { return v[0].is_rational() && v[1].is_rational() && is_zero(v); };
  const ArcEnds& ends = held.path.arc->ends;
  if (known_zero(ends.end - ends.start)) return HeadPair::same;
  return known_zero(ends.end + ends.start) ? HeadPair::opposite : HeadPair::any;
}

// A head in the plane of the arc. It lies on the offset circle there only if the tool stands upright on that plane.
CornerVector ToolSideCompensation::head(const SideArc& arc, const CompensationPlane& plane, const SideVector& vector) {
  CornerVector result;
  result.vector = in_plane_of(arc.plane, vector.vector);
  if (is_square_to(plane, arc.plane)) {
    result.former = vector.former;
    result.latter = vector.latter;
  }
  return result;
}

// The blocks that waited for the vectors at their end go out: moves up to the stop point belong to the one that ends
// there, those behind it to the next that moves.
void ToolSideCompensation::flush() {
  if (waiting_.empty()) return;
  Step& former = waiting_.front();
  Move move = corner_;
  const bool rapid = former.moves.back().leg.type == spec::MoveType::rapid;
  move.leg.type = rapid ? spec::MoveType::rapid : spec::MoveType::linear;
  move.leg.cause = spec::Cause::corner;
  std::size_t next = 1;
  for (; next < here_.size() && !here_[next].after_stop; ++next) {
    move.offset = here_[next].vector;
    former.moves.push_back(move);
  }
  here_.erase(here_.begin(), here_.begin() + static_cast<std::ptrdiff_t>(next - 1));
  hand_on(former);
  for (std::size_t i = 1; i < waiting_.size(); ++i) {
    Step& other = waiting_[i];
    for (Move& own : other.moves) own.offset = here_.back().vector;
    if (!other.moves.empty()) insert_corner_moves(other);
    hand_on(other);
  }
  waiting_.clear();
}

// The corner moves that are left, before the step's own move and with its feed; everything else as at the corner.
void ToolSideCompensation::insert_corner_moves(Step& step) {
  if (here_.size() < 2) return;
  const Move& own = step.moves.front();
  Move move = corner_;
  move.leg.type = own.leg.type == spec::MoveType::rapid ? spec::MoveType::rapid : spec::MoveType::linear;
  move.leg.cause = spec::Cause::corner;
  move.feed = own.feed;
  std::vector<Move> moves;
  moves.reserve(here_.size() - 1 + step.moves.size());
  for (std::size_t i = 1; i < here_.size(); ++i) {
    move.offset = here_[i].vector;
    moves.push_back(move);
  }
  for (Move& other : step.moves) moves.push_back(std::move(other));
  step.moves = std::move(moves);
  here_.erase(here_.begin(), here_.end() - 1);
}

void ToolSideCompensation::emit(Step& step) {
  step.clauses.add(recorder().take_clauses());
  hand_on(step);
}

void ToolSideCompensation::emit_at_head(Step& step) {
  for (Move& move : step.moves) move.offset = here_.back().vector;
  emit(step);
}

void ToolSideCompensation::emit_change_alone(Step& step, spec::Cause cause, bool changes) {
  if (step.moves.empty() && changes) step.moves.push_back(step.rest);
  if (!step.moves.empty()) step.moves.front().leg.cause = cause;
  emit_at_head(step);
}

}  // namespace toolcomp::model

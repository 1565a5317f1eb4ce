// SPDX-License-Identifier: Apache-2.0
#include "judge/oracle/condition.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "judge/oracle/number.h"
#include "judge/oracle/policy.h"
#include "model/basis/number.h"

namespace toolcomp::judge {
namespace {

constexpr std::uint32_t kAngleRange = 19631;
constexpr double kRadiansPerDegree = 0.017453292519943295;

double magnitude(const spec::Decimal& d) { return std::fabs(approximate(d)); }

// Whether vectors made so may be that of an event: the clauses it rests on are of such a section, or of none with
// vectors.
bool may_be(const model::Event& event, policy::VectorFrom made) {
  bool other = false;
  for (const spec::Clause clause : event.clauses) {
    const policy::VectorFrom of = policy::budget(spec::info(clause).section).vectors;
    if (of == made) return true;
    other = other || of != policy::VectorFrom::none;
  }
  return !other;
}

double length(const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); }

std::array<double, 3> difference(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

std::array<double, 3> cross(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Of the angle between a and the unit vector b.
double sine(const std::array<double, 3>& a, const std::array<double, 3>& b) { return length(cross(a, b)) / length(a); }

// Whether v lies in the plane of a and the unit vector b, whose angle has the sine s, as far as doubles can tell.
bool coplanar(const std::array<double, 3>& v, const std::array<double, 3>& a, const std::array<double, 3>& b,
              double s) {
  const std::array<double, 3> normal = cross(a, b);
  const double out = v[0] * normal[0] + v[1] * normal[1] + v[2] * normal[2];
  return std::fabs(out) <= (policy::kSlack + policy::kParallel / s) * length(v) * length(normal);
}

}  // namespace

Conditions::Conditions(const spec::Setup& setup, const ProgramFacts* facts, double k)
    : index_{setup.axes.index('X'), setup.axes.index('Y'), setup.axes.index('Z')},
      k_(k),
      facts_(facts),
      pose_(setup, facts) {
  for (std::size_t i = 0; i < setup.axes.size(); ++i) linear_[i] = spec::is_linear_axis(setup.axes.letter(i));
  const auto table = [this](const spec::AxisTable& values) {
    for (const auto& [axis, number] : values)
      if (spec::is_linear_axis(axis)) setup_scale_ = std::max(setup_scale_, magnitude(number));
  };
  for (const spec::AxisTable& origin : setup.workpiece) table(origin);
  for (const auto& entry : setup.additional_workpiece) table(entry.second);
  for (const auto& entry : setup.reference) table(entry.second);
  table(setup.floating_reference);
  table(setup.position);
  for (const auto* memory : {&setup.h, &setup.d})
    for (const auto& entry : *memory)
      setup_scale_ = std::max(setup_scale_, magnitude(entry.second.geometry) + magnitude(entry.second.wear));
  setup_scale_ = std::max(setup_scale_, longest_tool(setup));
  // Vectors of the table and of the head.
  for (std::uint32_t parameter = 19700; parameter <= 19714; ++parameter)
    if (const auto given = setup.parameter(parameter)) setup_scale_ = std::max(setup_scale_, magnitude(*given));
  const double range = setup.parameter(kAngleRange) ? magnitude(*setup.parameter(kAngleRange)) : 1.0;
  const bool positive = !setup.parameter(kAngleRange) || !setup.parameter(kAngleRange)->negative;
  // A hair below, so that a pair the model did not classify is never left out here.
  if (positive) smallest_sine_ = std::sin(std::min(range, 90.0) * kRadiansPerDegree) * (1 - policy::kSlack);
  position_ = {};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto start = setup.position.find("XYZ"[i]);
    if (start != setup.position.end()) position_[i] = approximate(start->second);
    if (index_.at(i) != spec::Axes::kNone)
      programmed_.set(index_.at(i), start != setup.position.end() ? model::plain(start->second) : exact::Rational(0));
  }
  point_ = position_;
  if (setup.control == spec::Control::heidenhain) space_.emplace(setup);
}

double Conditions::condition(std::span<const model::Event> window, const Vector& tool,
                             const Vector& compensation) const {
  double worst = 1;
  // Whether there is a movement.
  const auto pair = [&](const Programmed& from, const Programmed& to) {
    const Vector movement = way_of(from, to, index_);
    if (length(movement) == 0) return false;
    const double s = sine(movement, tool);
    if (s > 0 && s >= smallest_sine_ && coplanar(compensation, movement, tool, s) &&
        !(s < policy::kSlack && along(window.front().tool_axis, from, to)))
      worst = std::max(worst, 1 / s);
    return true;
  };
  const Programmed& at = window.front().programmed;
  (void)pair(programmed_, at);
  for (std::size_t i = 1; i < window.size(); ++i)
    if (window[i].kind == spec::EventKind::move && pair(at, window[i].programmed)) break;
  return worst;
}

bool Conditions::along(const std::optional<std::array<model::Real, 3>>& tool, const Programmed& from,
                       const Programmed& to) const {
  const auto way = [&](std::size_t i) {
    const std::size_t axis = index_[i];
    return axis != spec::Axes::kNone && from.has(axis) && to.has(axis) ? to[axis] - from[axis] : model::Real(0);
  };
  const std::array<model::Real, 3> movement{way(0), way(1), way(2)};
  const std::array<model::Real, 3> axis = tool.value_or(std::array<model::Real, 3>{0, 0, 1});
  const auto level = [&](std::size_t i, std::size_t j) {
    return (movement[i] * axis[j] - movement[j] * axis[i]).sign() == exact::Sign::zero;
  };
  try {
    return level(0, 1) && level(1, 2) && level(2, 0);
  } catch (const exact::Undecided&) {
    return false;
  }
}

Scale Conditions::next(std::span<const model::Event> window) {
  const model::Event& event = window.front();
  if (space_) {
    if (facts_ != nullptr && facts_->units()) space_->units(*facts_->units());
    return space_->next(window);
  }
  Scale scale;
  scale.position = setup_scale_;
  if (event.kind == spec::EventKind::hole) return hole(event, scale);
  if (event.kind != spec::EventKind::move && event.kind != spec::EventKind::sample) return scale;
  const auto include = [&](const spec::AxisValues<model::Real>& values) {
    for (std::size_t i = 0; i < spec::kMaxAxes; ++i)
      if (linear_[i] && values.has(i)) scale.position = std::max(scale.position, std::fabs(approximate(values[i])));
  };
  include(event.programmed);
  include(event.point);
  include(event.axes);
  include(event.machine);
  if (event.arc) include(event.arc->center);
  if (event.kind == spec::EventKind::sample) return sample(window, scale);
  of_move_.reset();
  return move(window, scale);
}

// Without a vector; the next move goes from there.
Scale Conditions::hole(const model::Event& event, Scale scale) {
  model::Event end = event;
  end.kind = spec::EventKind::move;
  end.point.set(event.hole->axis, event.hole->level);
  end.programmed = end.point;
  end.hole.reset();
  const std::array<model::Event, 1> window{end};
  const Scale of_end = next(window);
  for (const model::Real& level : {event.hole->point_r, event.hole->bottom})
    scale.position = std::max(scale.position, std::fabs(approximate(level)));
  scale.position = std::max(scale.position, of_end.position);
  return scale;
}

Scale Conditions::sample(std::span<const model::Event> window, Scale scale) {
  if (!of_move_) {
    const auto own = std::find_if(window.begin(), window.end(),
                                  [](const model::Event& event) { return event.kind == spec::EventKind::move; });
    const auto from = static_cast<std::size_t>(own - window.begin());
    of_move_.emplace();
    if (own != window.end()) of_move_ = Conditions(*this).next(window.subspan(from));
  }
  scale.position = std::max(scale.position, of_move_->position);
  scale.vector = of_move_->vector;
  scale.condition = of_move_->condition;
  scale.start = condition_ * policy::ulp(length(vector_));
  // On a line the sample lies between the heads as the controller has them (pairing.h).
  const auto own = std::ranges::find(window, spec::EventKind::move, &model::Event::kind);
  if (own != window.end() && !own->arc) {
    scale.heads = of_move_->heads;
    scale.rest = of_move_->rest;
    if (!heads_.empty()) scale.start = rest_ * policy::ulp(length(vector_));
    scale.between = true;
  }
  scale.pose = pose_.next(window, of_move_->turned);
  // Between its ends an arc is off by no more than its centre.
  scale.pose.tip += of_move_->center;
  scale.pose.hardly = scale.pose.hardly || of_move_->pose.hardly;
  return scale;
}

Scale Conditions::move(std::span<const model::Event> window, Scale scale) {
  const model::Event& event = window.front();
  const Vector at = vector(event.programmed);
  const Vector point = vector(event.point);
  if (event.cause == spec::Cause::start_up || (!compensated_ && event.clauses.contains(policy::kHasASide))) {
    // There is no vector before it: a reference return in the mode may have taken the shift away. Nor is there a
    // start-up where the corner moves of type C, by an offset of 0, went nowhere.
    shift_ = difference(point_, position_);
    compensated_ = true;
  }
  if (!compensated_) shift_ = difference(point, at);
  const View view{index_, shift_, {scale.position, k_}};
  RadiusArc by_radius;
  if (event.arc) {
    const Vector out = difference(at, difference(vector(event.arc->center), shift_));
    by_radius = radius_arc(event, way_of(programmed_, event.programmed, index_), out, view.rounded);
  }
  scale.center = by_radius.center;
  scale.turned = by_radius.turned;
  scale.pose = pose_.next(window, by_radius.turned);
  scale.pose.hardly = scale.pose.hardly || by_radius.hardly;
  const Vector compensation = difference(difference(point, at), shift_);
  const double noise = policy::kSlack * scale.position;  // of three differences of doubles, far below any vector
  scale.vector = length(compensation);
  corners_.follow(event, view, programmed_);
  if (event.tool_axis && !tool_plane_) tool_plane_.emplace();
  if (tool_plane_) tool_plane_->follow(event, view, programmed_);
  if (scale.vector > noise * policy::kNoVector)
    head(window, view, compensation, scale);
  else
    scale.vector = 0;
  if (event.arc) arc(event, compensation, scale);
  if (event.cause == spec::Cause::cancel) compensated_ = false;
  programmed_ = event.programmed;
  position_ = at;
  point_ = point;
  vector_ = compensation;
  condition_ = scale.condition;
  heads_ = scale.heads;
  rest_ = scale.rest;
  return scale;
}

// How well the vector is determined, that is one.
void Conditions::head(std::span<const model::Event> window, const View& view, const Vector& compensation,
                      Scale& scale) const {
  const model::Event& event = window.front();
  Vector tool{0, 0, 1};
  if (event.tool_axis)
    for (std::size_t i = 0; i < 3; ++i) tool[i] = approximate((*event.tool_axis)[i]);
  if (may_be(event, policy::VectorFrom::tool_and_way)) scale.condition = condition(window, tool, compensation);
  const bool kept = length(difference(compensation, vector_)) <= policy::kSlack * (scale.vector + scale.position);
  const auto corner_error = [&](Heads* heads) {
    double error = 0;
    if (may_be(event, policy::VectorFrom::corner)) error = corners_.error(window, view, compensation, heads);
    if (tool_plane_ && may_be(event, policy::VectorFrom::tool_corner))
      error = std::max(error, tool_plane_->error(window, view, compensation, tool, heads));
    return error;
  };
  // The vector is made of a tool axis that may be off by more than an ulp.
  const double tilt = std::max(1.0, scale.pose.direction / policy::ulp(1));
  double rest = scale.condition;
  scale.condition = std::max(rest, 1 + corner_error(nullptr) / scale.vector);
  if (kept) scale.condition = std::max(scale.condition, condition_);
  scale.condition *= tilt;
  if (scale.condition * policy::ulp(scale.vector) > policy::kByConditions) {
    Heads heads;
    rest = std::max(rest, 1 + corner_error(&heads) / scale.vector) * tilt;
    const double unit = tilt * policy::ulp(scale.vector) / scale.vector;
    const double position = policy::ulp(scale.position) + scale.pose.tip;
    for (Head& head : heads) {
      for (HeadBand& band : head.bands) band.width = position + unit * (scale.vector + band.width);
      head.across.width = position + unit * scale.vector;
      head.reach = position + unit * (scale.vector + head.reach);
    }
    if (kept) heads.insert(heads.end(), heads_.begin(), heads_.end());
    if (kept) rest = std::max(rest, heads_.empty() ? condition_ : rest_);
    scale.heads = std::move(heads);
    scale.rest = rest;
  }
}

void Conditions::arc(const model::Event& event, const Vector& compensation, Scale& scale) const {
  const double before = length(vector_);
  if (before > 0) scale.start = condition_ * policy::ulp(before);
  const bool compensated = before > 0 || length(compensation) > 0;
  if (!compensated && scale.center == 0) return;
  const Vector center = vector(event.arc->center);
  Vector from = difference(point_, center);
  Vector to = difference(vector(event.point), center);
  constexpr std::array<std::size_t, 3> normal = {2, 1, 0};  // of X Y, Z X, Y Z
  from.at(normal.at(static_cast<std::size_t>(event.arc->plane))) = 0;
  to.at(normal.at(static_cast<std::size_t>(event.arc->plane))) = 0;
  const double error = scale.center + (compensated ? policy::ulp(scale.position) + scale.pose.tip : 0);
  const double own = scale.vector > 0 ? scale.condition * policy::ulp(scale.vector) : 0;
  // An end whose direction is asked for, and that an estimate cannot tell from the centre, may have any.
  const auto turned = [&event](double by, double distance) {
    if (distance > 0) return by / distance;
    return event.arc->sweep ? std::numeric_limits<double>::infinity() : 0.0;
  };
  scale.turn += turned(error + scale.start, length(from)) + turned(error + own, length(to));
  scale.own_turn = turned(1, length(from)) + turned(1, length(to));
}

}  // namespace toolcomp::judge

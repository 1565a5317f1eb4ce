// SPDX-License-Identifier: Apache-2.0
#include "certify/trace/program_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "certify/trace/blocks.h"
#include "certify/trace/chords.h"
#include "certify/trace/curve_bound.h"
#include "model/basis/number.h"
#include "model/fanuc/program/motion.h"
#include "model/kinematics/posture_motion.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify {
namespace {

using exact::Rational;
using exact::Real;

// Of the tolerance.
constexpr double kMostOfTolerance = 100;
// Of what is left a sixteenth is for the rounding of coordinates.
constexpr double kForChords = 15.0 / 16;

using Reals = std::array<Real, spec::kMaxAxes>;

double upward(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }

// A place as doubles, and what they are off.
struct Place {
  AxisPoint at{};
  Distance off;
};

// What the model has given and no piece was made of yet.
struct Given {
  std::uint64_t line = 0;
  std::optional<std::uint64_t> n;
  model::MoveMotion motion;  // without a move: where positions are counted from
  std::optional<model::Event> move;
};

// Whether the tool that the program alone directs ends opposite to where it stands inside the whole move: no machine
// does that. Clause: fanuc.tool-center-point.without-kinematics.
bool turns_about(const Given& given) {
  if (!given.motion.inside || !given.move->tool_axis) return false;
  const model::MotionForm posture = given.motion.inside->form().posture;
  const auto* swing = std::get_if<model::DirectionSwing>(&posture);
  const auto& [x, y, z] = *given.move->tool_axis;
  return swing != nullptr && exact::known_zero(swing->degrees) &&
         dot(swing->from, exact::Vector3{x, y, z}).sign() == exact::Sign::negative;
}

// A curve in the making.
struct Curve {
  Chords chords;
  std::shared_ptr<const model::InsideMove> inside;  // none: an arc
  Reals from;                                       // all axes
  Reals by;
};

}  // namespace

class ProgramPath::Run : public model::EventSink, public model::MotionSink {
 public:
  Run(const spec::Case& c, TraceSpace space, Distance tolerance, ProgramPathOptions options);

  bool next(PathPiece& piece);
  [[nodiscard]] const std::string& undecided() const { return undecided_; }
  [[nodiscard]] const std::string& alarm() const { return alarm_; }

  void on(const model::Event& event) override;
  void on(const model::MoveMotion& motion) override { motion_ = motion; }
  void stand(const model::SharedZero& zero, std::uint64_t line, const std::optional<std::uint64_t>& n) override;

 private:
  bool next_piece(PathPiece& piece);
  [[nodiscard]] Place place(const Reals& positions) const;
  [[nodiscard]] bool same(const AxisPoint& a, const AxisPoint& b) const;
  [[nodiscard]] bool is_finite(const AxisPoint& point) const;
  bool rename(const Given& given, PathPiece& piece);
  bool begin(const Given& given, PathPiece& piece);
  [[nodiscard]] std::optional<CurveBound> bend(const Given& given, const Reals& from, const Reals& points) const;
  bool chord(PathPiece& piece);
  void end(std::string why);
  [[nodiscard]] Place inside(const Rational& t) const;

  const spec::Case& case_;
  TraceSpace space_;
  Distance most_;  // of a chord's error
  ProgramPathOptions options_;
  std::string undecided_;
  std::string alarm_;
  bool closed_ = false;  // what follows is not known

  std::deque<Given> given_;
  model::MoveMotion motion_;  // of the event to come
  std::unique_ptr<Blocks> blocks_;

  // Where the last piece has ended.
  Reals axes_;           // workpiece coordinates
  Reals point_;          // the tool point there
  bool of_tip_ = false;  // under tool center point control
  model::SharedZero zero_;
  Place here_;

  std::optional<Curve> curve_;
  PathPiece piece_;  // of the move: what its pieces share
  Place end_;        // of the move
};

ProgramPath::Run::Run(const spec::Case& c, TraceSpace space, Distance tolerance, ProgramPathOptions options)
    : case_(c), space_(std::move(space)), options_(std::move(options)) {
  const auto positive = [](double x) { return x > 0 && std::isfinite(x); };
  if ((!space_.linear.empty() && !positive(tolerance.linear)) ||
      (!space_.rotary.empty() && !positive(tolerance.rotary)))
    throw spec::InputError("--tolerance", 0, 0,
                           "must be positive: setup units for linear axes, degrees for rotary ones");
  const bool fanuc = c.setup.control == spec::Control::fanuc;
  if (!fanuc && options_.frame == PathFrame::machine)
    throw spec::InputError(
        "setup", 0, 0, "control: Klartext programs have no machine coordinates; their positions count from the preset");
  most_ = {tolerance.linear / kMostOfTolerance * kForChords, tolerance.rotary / kMostOfTolerance * kForChords};
  for (std::size_t i = 0; i < c.setup.axes.size(); ++i)
    if (const auto start = c.setup.position.find(c.setup.axes.letter(i)); start != c.setup.position.end())
      axes_.at(i) = model::plain(start->second);
  point_ = axes_;
  blocks_ = blocks_of(c, *this, *this);
  // At the beginning the engine has said where positions are counted from.
  if (!given_.empty()) {
    zero_ = given_.front().motion.zero;
    given_.pop_front();
  }
  here_ = place(axes_);
}

void ProgramPath::Run::stand(const model::SharedZero& zero, std::uint64_t line, const std::optional<std::uint64_t>& n) {
  // Most blocks change nothing.
  if (!given_.empty() ? given_.back().motion.zero == zero : zero_ == zero) return;
  if (!closed_) given_.push_back({line, n, {zero, nullptr, false}, {}});
}

void ProgramPath::Run::on(const model::Event& event) {
  if (options_.on_event) options_.on_event(event);
  if (closed_) return;
  switch (event.kind) {
    case spec::EventKind::move:
    case spec::EventKind::hole:
      if (event.unknown != 0) {
        closed_ = true;
        undecided_ = "line " + std::to_string(event.line) + " leaves the axes at positions that are not known";
        break;
      }
      given_.push_back({event.line, event.n, std::exchange(motion_, {}), event});
      break;
    case spec::EventKind::alarm:
      alarm_ = std::string(event.number.view()) + " in line " + std::to_string(event.line);
      break;
    case spec::EventKind::not_supported:
    case spec::EventKind::not_judged:
      closed_ = true;
      undecided_ = "line " + std::to_string(event.line) + ": " + event.message;
      break;
    case spec::EventKind::undecided:
      closed_ = true;
      undecided_ = "the model could not decide line " + std::to_string(event.line) + " (" +
                   std::string(event.number.view()) + ")";
      break;
    default:
      break;
  }
}

bool ProgramPath::Run::next(PathPiece& piece) {
  try {
    if (!next_piece(piece)) return false;
    // Whoever measures by what is no number does not come to an end.
    if (is_finite(piece.begin) && is_finite(piece.end)) return true;
    end("a position inside line " + std::to_string(piece.line) + " is not a number");
    return false;
  } catch (const exact::Undecided&) {
    end("a position inside line " + std::to_string(piece_.line) + " could not be certified");
    return false;
  }
}

void ProgramPath::Run::end(std::string why) {
  undecided_ = std::move(why);
  closed_ = true;
  given_.clear();
  curve_.reset();
}

bool ProgramPath::Run::next_piece(PathPiece& piece) {
  for (;;) {
    if (curve_) {
      if (chord(piece)) return true;
      continue;
    }
    if (given_.empty()) {
      if (closed_ || !blocks_->next()) return false;
      continue;
    }
    if (rename(given_.front(), piece)) return true;
    const Given given = std::move(given_.front());
    given_.pop_front();
    if (given.move && begin(given, piece)) return true;
  }
}

Place ProgramPath::Run::place(const Reals& positions) const {
  Place result;
  for (const auto* axes : {&space_.linear, &space_.rotary})
    for (const std::size_t axis : *axes) {
      const bool of_machine = options_.frame == PathFrame::machine;
      const Real position = of_machine ? positions.at(axis) + zero_->at(axis) : positions.at(axis);
      const exact::DoubleEnclosure bounds = position.double_enclosure();
      const double middle = bounds.lower + (bounds.upper - bounds.lower) / 2;
      result.at.at(axis) = middle;
      const double off = upward(std::max(bounds.upper - middle, middle - bounds.lower));
      if (axes == &space_.linear)
        result.off.linear = upward(result.off.linear + off);
      else
        result.off.rotary = std::max(result.off.rotary, off);
    }
  return result;
}

bool ProgramPath::Run::is_finite(const AxisPoint& point) const {
  const auto finite = [&](std::size_t axis) { return std::isfinite(point.at(axis)); };
  return std::ranges::all_of(space_.linear, finite) && std::ranges::all_of(space_.rotary, finite);
}

bool ProgramPath::Run::same(const AxisPoint& a, const AxisPoint& b) const {
  const auto equal = [&](std::size_t axis) { return a.at(axis) == b.at(axis); };
  return std::ranges::all_of(space_.linear, equal) && std::ranges::all_of(space_.rotary, equal);
}

// The place stays, machine coordinates do too: position + zero.
bool ProgramPath::Run::rename(const Given& given, PathPiece& piece) {
  const model::SharedZero zero = given.motion.zero;
  if (!zero || zero == zero_) return false;
  for (std::size_t i = 0; i < case_.setup.axes.size(); ++i) {
    const Real by = zero_->at(i) - zero->at(i);
    axes_.at(i) += by;
    point_.at(i) += by;
  }
  zero_ = zero;
  const Place before = std::exchange(here_, place(axes_));
  if (options_.frame == PathFrame::machine || same(before.at, here_.at)) return false;
  piece = {};
  piece.begin = before.at;
  piece.end = here_.at;
  piece.jump = true;
  piece.line = given.line;
  piece.n = given.n;
  return true;
}

// A straight move is a piece; a curve is left to be divided. False: there is no piece yet.
bool ProgramPath::Run::begin(const Given& given, PathPiece& piece) {
  const model::Event& event = *given.move;
  const Reals from = axes_;
  // What G49 leaves under tool center point control is the position of the axes.
  const Reals points = of_tip_ && !given.motion.of_tip ? axes_ : point_;
  of_tip_ = given.motion.of_tip;
  for (std::size_t i = 0; i < case_.setup.axes.size(); ++i) {
    if (event.axes.has(i)) axes_.at(i) = event.axes[i];
    point_.at(i) = event.point.has(i) ? event.point[i] : axes_.at(i);
  }
  if (event.hole) point_.at(event.hole->axis) = event.hole->level;
  end_ = place(axes_);
  piece_ = {};
  piece_.line = given.line;
  piece_.n = given.n;
  // What happens at a hole is the business of its cycle: its end alone is judged.
  piece_.free = event.hole || (!options_.judge_rapids && event.type == spec::MoveType::rapid);
  std::optional<CurveBound> bound = piece_.free ? std::nullopt : bend(given, from, points);
  if (bound && turns_about(given)) {
    end("inside line " + std::to_string(piece_.line) +
        " the tool turns to the opposite direction, no clause says which way");
    return false;
  }
  if (bound) {
    curve_.emplace(Curve{Chords(*std::move(bound), most_), given.motion.inside, from, {}});
    for (std::size_t i = 0; i < axes_.size(); ++i) curve_->by.at(i) = axes_.at(i) - from.at(i);
    return false;
  }
  piece = piece_;
  piece.begin = here_.at;
  piece.end = end_.at;
  here_ = end_;
  return !same(piece.begin, piece.end);
}

// How the axes go from there to where they now are, and the tool point from `points`; nothing where they go straight.
std::optional<CurveBound> ProgramPath::Run::bend(const Given& given, const Reals& from, const Reals& points) const {
  const spec::Axes& axes = case_.setup.axes;
  if (given.motion.inside) return CurveBound(given.motion.inside->form(), axes, space_);
  const std::optional<spec::Arc<Real>>& arc = given.move->arc;
  if (!arc || !arc->sweep || given.motion.of_tip) return std::nullopt;
  exact::Vector3 begin;
  exact::Vector3 end;
  exact::Vector3 offset_before;
  exact::Vector3 offset_after;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (!model::is_space_axis(axes.letter(i))) continue;
    const std::size_t k = model::space_index(axes.letter(i));
    const Real zero = options_.frame == PathFrame::machine ? zero_->at(i) : Real();
    model::component(begin, k) = points.at(i);
    model::component(end, k) = point_.at(i);
    model::component(offset_before, k) = from.at(i) - points.at(i) + zero;
    model::component(offset_after, k) = axes_.at(i) - point_.at(i) + zero;
  }
  return CurveBound(model::path_along(begin, end, *arc, axes), offset_before, offset_after, axes, space_);
}

// The next chord of the curve. False: there is none (no bound is found), or it moves no measured axis.
bool ProgramPath::Run::chord(PathPiece& piece) {
  const std::optional<Chords::Chord> chord = curve_->chords.next();
  if (!chord) {
    end("the curve inside line " + std::to_string(piece_.line) + " could not be bounded");
    return false;
  }
  const Place before = std::exchange(here_, chord->last ? end_ : inside(chord->end));
  piece = piece_;
  piece.begin = before.at;
  piece.end = here_.at;
  piece.corner = chord->last;
  piece.error = chord->error;
  if (piece.error.linear > 0)
    piece.error.linear = upward(piece.error.linear + std::max(before.off.linear, here_.off.linear));
  if (piece.error.rotary > 0)
    piece.error.rotary = upward(piece.error.rotary + std::max(before.off.rotary, here_.off.rotary));
  piece.curved = piece.error.linear > 0 || piece.error.rotary > 0;
  if (chord->last) curve_.reset();
  return piece.curved || !same(piece.begin, piece.end);
}

// The place at t of the curve.
Place ProgramPath::Run::inside(const Rational& t) const {
  const Curve& curve = *curve_;
  if (curve.inside) return place(curve.inside->axes_at(t).value);
  Reals even;
  for (std::size_t i = 0; i < even.size(); ++i) even.at(i) = curve.from.at(i) + Real(t) * curve.by.at(i);
  Place result = place(even);
  const auto space = curve.chords.bound().space_at(t);
  for (const std::size_t axis : space_.linear) {
    const char letter = case_.setup.axes.letter(axis);
    if (!model::is_space_axis(letter)) continue;
    const exact::DoubleEnclosure& bounds = space.at(model::space_index(letter));
    const double middle = bounds.lower + (bounds.upper - bounds.lower) / 2;
    result.at.at(axis) = middle;
    result.off.linear = upward(result.off.linear + upward(std::max(bounds.upper - middle, middle - bounds.lower)));
  }
  return result;
}

ProgramPath::ProgramPath(const spec::Case& c, TraceSpace space, Distance tolerance, ProgramPathOptions options)
    : run_(std::make_unique<Run>(c, std::move(space), tolerance, std::move(options))) {}
ProgramPath::~ProgramPath() = default;

bool ProgramPath::next(PathPiece& piece) { return run_->next(piece); }
const std::string& ProgramPath::undecided() const { return run_->undecided(); }
const std::string& ProgramPath::alarm() const { return run_->alarm(); }

}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
// Events, the items that a run yields (docs/events.md). Both engines use one template, each with its own number type.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "spec/clauses/clauses.h"
#include "spec/language/axes.h"
#include "spec/language/name.h"
#include "spec/parameters/alarm_causes.h"

namespace toolcomp::spec {

enum class EventKind : std::uint8_t {
  move,
  sample,
  alarm,
  warning,
  setting,
  undecided,
  not_supported,
  not_judged,
  hole
};

// Whether the run ends here: with an alarm of the control, or because it is not known what a control does from here on.
constexpr bool ends_run(EventKind kind) {
  return kind == EventKind::alarm || kind == EventKind::not_supported || kind == EventKind::not_judged;
}

enum class MoveType : std::uint8_t { rapid, linear, arc };
enum class Cause : std::uint8_t { programmed, start_up, corner, cancel, pre_turn, post_turn, reference, measure };
enum class Plane : std::uint8_t { xy, zx, yz };
enum class ArcDirection : std::uint8_t { cw, ccw };

// Arcs only (docs/events.md, rule 8). Lengths in setup units, sweep in degrees.
template <class Number>
struct Arc {
  AxisValues<Number> center;
  Plane plane = Plane::xy;
  ArcDirection direction = ArcDirection::cw;
  std::optional<Number> sweep;                      // of the arc that the tool runs; absent if an end is in the centre
  std::optional<std::pair<Number, Number>> radius;  // at the start and at the end, if they differ
};

// The point at which the cutter touches the workpiece (Heidenhain blocks with a surface normal). Vectors are X, Y, Z.
template <class Number>
struct Contact {
  std::array<Number, 3> point{};   // q
  std::array<Number, 3> normal{};  // n, unit, from the workpiece into the tool
  bool flat = false;               // the normal is along the tool (w = 0): the flat bottom touches
  std::optional<Number> angle;     // between normal and tool in degrees; only for tools with a table of deviations
};

// The fields that 3D tool compensation adds to a move (Heidenhain; docs/events.md). Vectors are X, Y, Z.
template <class Number>
struct SpaceCompensation {
  std::array<Number, 3> tool_center{};           // centre of the effective tool
  std::array<Number, 3> shift{};                 // tip of the effective tool less tip of the nominal tool
  std::array<Number, 3> tool_shift{};            // shift of the real tool against a tool without deltas
  std::optional<std::array<Number, 3>> carrier;  // if the tool table gives the overall length
  std::optional<Contact<Number>> contact;        // only in blocks with a surface normal
};

// A hole that a canned cycle drills, as coordinates along the drilling axis: in workpiece coordinates, in setup units,
// before length offset.
template <class Number>
struct Hole {
  std::size_t axis = 0;  // index of the drilling axis in the setup; events of controllers do not give it
  Number point_r{};
  Number bottom{};
  Number level{};  // the level to which the tool returns
};

// All clauses that an event rests on, each once, in the order in which they were applied. The deciding clause is the
// last.
class ClauseList {
 public:
  void add(Clause clause) {
    if (!contains(clause)) clauses_.push_back(clause);
  }
  void add(const ClauseList& more) {
    for (const Clause clause : more) add(clause);
  }
  [[nodiscard]] bool contains(Clause clause) const { return std::find(begin(), end(), clause) != end(); }

  [[nodiscard]] bool empty() const { return clauses_.empty(); }
  [[nodiscard]] std::size_t size() const { return clauses_.size(); }
  [[nodiscard]] Clause operator[](std::size_t i) const { return clauses_[i]; }
  [[nodiscard]] Clause back() const { return clauses_.back(); }
  [[nodiscard]] std::vector<Clause>::const_iterator begin() const { return clauses_.begin(); }
  [[nodiscard]] std::vector<Clause>::const_iterator end() const { return clauses_.end(); }

 private:
  std::vector<Clause> clauses_;
};

// Takes the place of the list in events in double precision: the fast engine marks no clauses, and its events stay
// small.
struct NoClauses {
  static constexpr bool empty() { return true; }
  static constexpr const Clause* begin() { return nullptr; }
  static constexpr const Clause* end() { return nullptr; }
};

// For undecided events: the outcomes of the decision that the specification permits.
struct PermittedOutcomes {
  bool positive = false;
  bool negative = false;
  bool tie = false;
  friend bool operator==(const PermittedOutcomes&, const PermittedOutcomes&) = default;
};

// Takes the place of the move of an event in the same way.
struct NoMove {};

// A plain value. Copying an event in double precision does not allocate. Fields that do not belong to `kind` are left
// at their defaults.
template <class Number>
struct Event {
  EventKind kind = EventKind::move;
  std::uint64_t line = 0;
  std::optional<std::uint64_t> n;

  // move
  MoveType type = MoveType::linear;
  Cause cause = Cause::programmed;
  AxisValues<Number> programmed;                   // linear axes, absolute, in workpiece coordinates
  AxisValues<Number> point;                        // linear axes: the compensated tool point, before length offset
  AxisValues<Number> axes;                         // all axes: positions they are sent to, in workpiece coordinates
  AxisValues<Number> machine;                      // G53, G28, G30 (docs/events.md, 9): all axes, machine coordinates
  std::optional<std::array<Number, 3>> tool_axis;  // unit, tip → holder; if the setup or the program defines one
  std::optional<Arc<Number>> arc;
  std::optional<Number> feed;                      // F in force, setup units; not for rapid moves
  std::optional<SpaceCompensation<Number>> space;  // Heidenhain
  std::uint16_t unknown = 0;  // Heidenhain, bit i: the position of axis i is unknown, and no field has it

  // Hole: `point` is its position in the linear axes without the drilling axis. `axes` has the positions after the
  // hole.
  std::optional<Hole<Number>> hole;

  // alarm, warning, undecided, not supported, not judged
  AlarmCause alarm = AlarmCause::none;  // of an alarm; none if a controller does not name it
  // Alarm: the number that the control shows, such as PS0041. Warning: a name. Undecided: the clause. Not supported and
  // not judged: the word of the program, such as G81.
  Name number;
  const char* message = "";  // static text

  // undecided
  PermittedOutcomes permitted;
  bool out_of_scope = false;  // reason OUT_OF_SCOPE: the model does not cover this block, and the run goes on

  // setting
  Name setting;    // "H1", "H1.wear"
  Number value{};  // not in any output: in an interference alarm of the model, by how much the paths cross, if not 0

  // sample
  std::uint32_t t_numerator = 0;
  std::uint32_t t_denominator = 1;

  // the model fills them
  [[no_unique_address]] std::conditional_t<std::is_same_v<Number, double>, NoClauses, ClauseList> clauses;
  // Not in any output. If an alarm or `undecided` takes the place of a move that the moves before it were computed
  // with: that move, as far as its block gives it (programmed, arc).
  [[no_unique_address]] std::conditional_t<std::is_same_v<Number, double>, NoMove, std::shared_ptr<const Event>> unmade;
};

// Takes the events of a run, in order.
template <class Number>
class EventSink {
 public:
  virtual ~EventSink() = default;
  virtual void on(const Event<Number>& event) = 0;
};

}  // namespace toolcomp::spec

// SPDX-License-Identifier: Apache-2.0
// What a run yields (docs/events.md): one type for both engines, over their own number.
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

// The run ends here: with an alarm of the control, or because what a control does from here on is not known.
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
  std::optional<Number> sweep;                      // of the tool's own arc; absent where an end lies in the centre
  std::optional<std::pair<Number, Number>> radius;  // start and end, where they differ
};

// Where the cutter touches the workpiece (Heidenhain blocks with a surface normal). Vectors are X, Y, Z.
template <class Number>
struct Contact {
  std::array<Number, 3> point{};   // q
  std::array<Number, 3> normal{};  // n, unit, from the workpiece into the tool
  bool flat = false;               // the normal is along the tool (w = 0): the flat bottom touches
  std::optional<Number> angle;     // between normal and tool in degrees; tools with a table of deviations only
};

// What 3D tool compensation adds to a move (Heidenhain; docs/events.md). Vectors are X, Y, Z.
template <class Number>
struct SpaceCompensation {
  std::array<Number, 3> tool_center{};           // of the effective tool
  std::array<Number, 3> shift{};                 // of the tip against the nominal tool
  std::array<Number, 3> tool_shift{};            // of the real tool against one without deltas
  std::optional<std::array<Number, 3>> carrier;  // where the tool table gives the length
  std::optional<Contact<Number>> contact;        // blocks with a surface normal
};

// Of a hole that a canned cycle drills, coordinates along the drilling axis: workpiece coordinates, setup units, before
// length offset.
template <class Number>
struct Hole {
  std::size_t axis = 0;  // the drilling axis, by its place in the setup; events of controllers do not say it
  Number point_r{};
  Number bottom{};
  Number level{};  // to which the tool returns
};

// The clauses an event rests on, all of them, each once, in the order they were applied: what decided comes last.
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

// The list of an event in double precision: the fast engine marks no clauses, and its events stay small.
struct NoClauses {
  static constexpr bool empty() { return true; }
  static constexpr const Clause* begin() { return nullptr; }
  static constexpr const Clause* end() { return nullptr; }
};

// Undecided only: which outcomes of the decision the specification permits.
struct PermittedOutcomes {
  bool positive = false;
  bool negative = false;
  bool tie = false;
  friend bool operator==(const PermittedOutcomes&, const PermittedOutcomes&) = default;
};

// The same of the move that an event stands for.
struct NoMove {};

// A plain value: copying one in double precision does not allocate. Fields that do not belong to `kind` are
// left at their defaults.
template <class Number>
struct Event {
  EventKind kind = EventKind::move;
  std::uint64_t line = 0;
  std::optional<std::uint64_t> n;

  // move
  MoveType type = MoveType::linear;
  Cause cause = Cause::programmed;
  AxisValues<Number> programmed;                   // linear axes, workpiece coordinates, absolute
  AxisValues<Number> point;                        // linear axes: the compensated tool point, before length offset
  AxisValues<Number> axes;                         // all axes: what they are sent to, workpiece coordinates
  AxisValues<Number> machine;                      // G53, G28, G30 (docs/events.md, 9): all axes, machine coordinates
  std::optional<std::array<Number, 3>> tool_axis;  // tip → holder, unit; where the setup or the program defines one
  std::optional<Arc<Number>> arc;
  std::optional<Number> feed;                      // F in force, setup units; not for rapid moves
  std::optional<SpaceCompensation<Number>> space;  // Heidenhain
  std::uint16_t unknown = 0;  // Heidenhain, bit i: where axis i stands is not known, and no field has it

  // hole: `point` is its position, the linear axes but the drilling axis; `axes` where they stand behind it.
  std::optional<Hole<Number>> hole;

  // alarm, warning, undecided, not supported, not judged
  AlarmCause alarm = AlarmCause::none;  // of an alarm; none where a controller does not name it
  // What the control shows (alarm: PS0041), a name (warning), the clause (undecided), what stands in the program (not
  // supported, not judged: G81).
  Name number;
  const char* message = "";  // static text

  // undecided
  PermittedOutcomes permitted;
  bool out_of_scope = false;  // reason OUT_OF_SCOPE: nothing here is modelled, and the run goes on

  // setting
  Name setting;  // "H1", "H1.wear"
  Number value{};  // in no output: of an alarm of interference of the model, by how much the paths cross, if not 0

  // sample
  std::uint32_t t_numerator = 0;
  std::uint32_t t_denominator = 1;

  // the model fills them
  [[no_unique_address]] std::conditional_t<std::is_same_v<Number, double>, NoClauses, ClauseList> clauses;
  // In no output. An alarm or `undecided` in place of a move that those before it were made with: that move, as far as
  // its block says it (programmed, arc).
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

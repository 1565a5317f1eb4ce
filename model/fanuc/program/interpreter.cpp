// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/program/interpreter.h"

#include <algorithm>

#include "model/basis/alarm.h"
#include "model/geometry/arc.h"
#include "model/geometry/plane_vector.h"
#include "model/kinematics/mechanism.h"

namespace toolcomp::model {
namespace {

// The kind of a straight move under a code of group 01.
spec::MoveType straight(Motion motion) {
  return motion == Motion::rapid ? spec::MoveType::rapid : spec::MoveType::linear;
}

[[noreturn]] void raise_reading(Recorder& recorder, const spec::ReadAlarm& alarm) {
  // fanuc.program.call: A block with M98 runs, then the program that it calls runs. That is the program of the number
  // P, and it runs as often as L says. Without L the digits of P before the last four say how often. M98 with a name in
  // < > calls by name. The program is looked for in the text, where its head (O and its number, or its name in < >)
  // begins a line, and then among the files beside the text. PS0076 is raised if there is no such program or none is
  // named. PS0077 is raised if more than 10 calls are one inside the other.
  if (alarm.cause == AlarmCause::program_missing || alarm.cause == AlarmCause::calls_too_deep)
    recorder.reach(Clause::fanuc_program_call);
  // fanuc.program.return: A block with M99 runs, then ends its program. The end of its text ends a program too. The
  // program that has called it goes on after the call. With P it goes on from the first block after the call that has
  // the sequence number P, and the program that has ended is not repeated. If there is no such block, PS0078 is raised.
  else if (alarm.cause == AlarmCause::sequence_number_missing)
    recorder.reach(Clause::fanuc_program_return);
  // fanuc.program.not-supported: A run ends without an alarm at a word that a control may well run and this project
  // does not support. The event not_supported names the word.
  else if (alarm.cause == AlarmCause::not_supported)
    recorder.reach(Clause::fanuc_program_not_supported);
  // fanuc.program.unreadable-block: A block that cannot be read raises its read alarm when the run reaches the block.
  // PS0003 means too many digits, PS0004 no address, PS0005 no digit, PS0006 a sign that is not allowed, PS0007 a point
  // that is not allowed, PS0009 an unknown letter. The alarm ends the run.
  else
    recorder.reach(Clause::fanuc_program_unreadable_block);
  throw Alarm(alarm.cause, alarm.message);
}

}  // namespace

Interpreter::Interpreter(const spec::Setup& setup, Recorder& recorder)
    : setup_(setup), recorder_(recorder), numbers_(setup, recorder), work_(setup) {
  std::ranges::copy(by_axis(setup.position, setup_.axes), position_.begin());
  // fanuc.program.feed: F is modal, and 1411 is the F at power-on unless it is 0.
  if (const auto at_start = setup.parameter(1411); at_start && !at_start->is_zero()) feed_ = plain(*at_start);
}

Command Interpreter::read(const spec::Block& block) {
  if (block.alarm) raise_reading(recorder_, *block.alarm);
  const Words words(block, recorder_);
  const Codes codes = read_codes(block, words, setup_, recorder_);
  if (codes.units) numbers_.program_units(*codes.units);
  motion_ = codes.motion.value_or(motion_);
  plane_ = codes.plane.value_or(plane_);
  incremental_ = codes.incremental.value_or(incremental_);
  Command command{words, codes, motion_, plane_, incremental_};
  // fanuc.program.call: A block with M98 runs, then the program that it calls runs. That is the program of the number
  // P, and it runs as often as L says. Without L the digits of P before the last four say how often.
  if (codes.calls) recorder_.reach(Clause::fanuc_program_call);
  // fanuc.program.return: A block with M99 runs, then ends its program. The end of its text ends a program too. The
  // program that has called it goes on after the call. With P it goes on from the first block after the call that has
  // the sequence number P, and the program that has ended is not repeated. If there is no such block, PS0078 is raised.
  if (codes.returns) recorder_.reach(Clause::fanuc_program_return);
  read_feed(command);
  // fanuc.program.letters-as-data: In a block with G04 G05 G05.1 G10 G22 or G50.1, axis letters and I J K are data (a
  // dwell time, limits, origins), not positions. They move nothing, turn nothing and name no axis. This holds even if
  // another code of the block counts in place of that code.
  if (!recorder_.decide(Clause::fanuc_program_letters_as_data, codes.letters_are_data)) {
    for (std::size_t i = 0; i < setup_.axes.size(); ++i)
      if (words.has(setup_.axes.letter(i))) command.axes = with(command.axes, i);
    command.direction = words.has('I') || words.has('J') || words.has('K');
  }
  return command;
}

void Interpreter::read_feed(const Command& command) {
  if (command.codes.feed_per_minute) {
    if (feed_per_minute_ != *command.codes.feed_per_minute) feed_.reset();
    feed_per_minute_ = *command.codes.feed_per_minute;
  }
  const spec::Decimal* const f = command.words.find('F');
  if (f == nullptr) return;
  // fanuc.program.feed-mode: Under G93 and G95 F is not a feed per minute, and moves carry no feed. After the next G94
  // moves carry no feed until F is given. G94 is in force at the start.
  if (feed_per_minute_)
    feed_ = numbers_.feed(*f);
  else
    recorder_.reach(Clause::fanuc_program_feed_mode);
}

void Interpreter::require_feed(const Command& command) const {
  const bool by_motion = command.codes.one_shot == OneShot::none || is_tool_offset(command.codes.one_shot);
  const bool arc = command.is_arc_motion() && (command.direction || command.words.has('R'));
  const bool cuts = by_motion && motion_ != Motion::rapid && (command.axes != 0 || arc);
  if (!feed_per_minute_ || !(command.cycle.on ? command.cycle.makes_holes() : cuts)) return;
  // fanuc.program.no-feed: Under G94 a block that cuts raises PS0011 if F is 0 or none has been given. Such a block
  // moves by G01, G02 or G03 with an axis word, or by G02 or G03 with I J K or R, or it drills
  // (fanuc.canned-cycle.drills; not with K0).
  if (recorder_.decide(Clause::fanuc_program_no_feed, !feed_ || *feed_ == 0)) throw Alarm(AlarmCause::no_feed);
}

Rational Interpreter::word(const Command& command, std::size_t axis) const {
  const char letter = setup_.axes.letter(axis);
  return numbers_.of_axis(letter, *command.words.find(letter));
}

void Interpreter::go(Leg& leg, std::size_t axis, const Coordinate& to, const Real& travel) const {
  leg.end.at(axis) = to;
  const char letter = setup_.axes.letter(axis);
  if (is_space_axis(letter)) component(leg.travel, space_index(letter)) = travel;
}

void Interpreter::go(Leg& leg, std::size_t axis, const Coordinate& to) const {
  // The travel of a rotary axis is nobody's concern, and may be a sum of angles.
  go(leg, axis, to, is_space_axis(setup_.axes.letter(axis)) ? (to - position_.at(axis)).value() : Real());
}

Leg Interpreter::standing(spec::MoveType type) const {
  Leg leg;
  leg.type = type;
  leg.end = position_;
  return leg;
}

Leg Interpreter::ordinary(const Command& command, spec::MoveType type) const {
  Leg leg = standing(type);
  for (const std::size_t i : axes_in(command.axes)) {
    const Rational value = word(command, i);
    // fanuc.program.incremental: Under G90 an axis word is the end position in the workpiece coordinate system, under
    // G91 it is the travel from the programmed position. Offsets are not included.
    if (recorder_.decide(Clause::fanuc_program_incremental, command.incremental))
      go(leg, i, position_.at(i) + value, value);
    else
      go(leg, i, value);
  }
  return leg;
}

// G53: machine coordinates of the named axes.
Leg Interpreter::machine_leg(const Command& command) const {
  // fanuc.program.machine-coordinates: G53 with axis words goes in rapid traverse to machine coordinates. The workpiece
  // position of the named axes is then the machine position less the work zero.
  recorder_.reach(Clause::fanuc_program_machine_coordinates);
  Leg leg = standing(spec::MoveType::rapid);
  for (const std::size_t i : axes_in(command.axes)) go(leg, i, Coordinate(word(command, i)) - work_.zero(i));
  return leg;
}

std::size_t Interpreter::reference_number(const Command& command) const {
  const OneShot one_shot = command.codes.one_shot;
  if (one_shot != OneShot::other_reference)
    return one_shot == OneShot::floating_reference ? WorkCoordinates::kFloating : 1;
  const Rational number = command.words.number('P', 2);
  // fanuc.program.reference-number: P of G30 names reference position 2, 3 or 4. Without P it is 2. Another number
  // raises PS0046.
  if (command.words.has('P') &&
      recorder_.decide(Clause::fanuc_program_reference_number, number != 2 && number != 3 && number != 4))
    throw Alarm(AlarmCause::reference_number);
  return static_cast<std::size_t>(numerator(number));
}

// G28, G30, G30.1: to the intermediate point, then the named axes to the reference position.
std::vector<Leg> Interpreter::reference_legs(const Command& command) {
  // fanuc.program.reference-return: G28, G30 and G30.1 take the named axes to the intermediate point and from there to
  // the reference position, both in rapid traverse. G28 goes to the first reference position, G30 to the second to
  // fourth by P, G30.1 to the floating one.
  if (!recorder_.decide(Clause::fanuc_program_reference_return, command.axes != 0)) return {};
  const std::size_t number = reference_number(command);
  Leg intermediate = ordinary(command, spec::MoveType::rapid);
  intermediate.cause = spec::Cause::reference;
  Leg reference_leg = intermediate;
  for (const std::size_t i : axes_in(command.axes)) {
    intermediate_.at(i) = intermediate.end.at(i);
    go(reference_leg, i, Coordinate(work_.reference(number, i)) - work_.zero(i));
  }
  return {intermediate, reference_leg};
}

// G29: the named axes by way of the last intermediate point.
std::vector<Leg> Interpreter::return_legs(const Command& command) const {
  // fanuc.program.return-from-reference: G29 takes the named axes through the intermediate point of the last G28, G30
  // or G30.1 to the commanded point, both in rapid traverse. The intermediate point is kept in workpiece coordinates.
  recorder_.reach(Clause::fanuc_program_return_from_reference);
  Leg intermediate = standing(spec::MoveType::rapid);
  for (const std::size_t i : axes_in(command.axes)) {
    // fanuc.program.return-without-intermediate: An axis that has no intermediate point yet uses its current position
    // as one. On the 30i, G29 with such an axis raises PS0305.
    if (recorder_.decide(Clause::fanuc_program_return_without_intermediate, !intermediate_.at(i))) {
      if (setup_.series == spec::Series::series_30i) throw Alarm(AlarmCause::no_intermediate_point);
      continue;
    }
    go(intermediate, i, *intermediate_.at(i));
  }
  Leg end = intermediate;
  for (const std::size_t i : axes_in(command.axes)) {
    const Coordinate value = word(command, i);
    // fanuc.program.return-incremental: Under G91 the words of G29 count from the intermediate point.
    const bool incremental = recorder_.decide(Clause::fanuc_program_return_incremental, command.incremental);
    go(end, i, incremental ? intermediate.end.at(i) + value : value);
  }
  return {intermediate, end};
}

std::optional<spec::Arc<Real>> Interpreter::arc(const Command& command, const Leg& leg, bool directed,
                                                bool compensated) {
  const PlaneLetters in_plane = letters(command.plane);
  const std::size_t first = setup_.axes.index(in_plane.first);
  const std::size_t second = setup_.axes.index(in_plane.second);
  const spec::Decimal* const r = command.words.find('R');
  const bool center = command.direction && !directed;
  if (r == nullptr && !center) {
    // fanuc.program.arc-without-plane-words: Under G02 or G03 a block without an axis word of the plane and without I J
    // K R moves the other axes in a straight line.
    if (!command.names(first) && !command.names(second)) recorder_.reach(Clause::fanuc_program_arc_without_plane_words);
    // fanuc.program.arc-without-center: With CIR (3403#5) = 1, which is the default, an axis word of the plane under
    // G02 or G03 raises PS0022 if the block has neither I J K nor R. With CIR = 0 the block runs as a straight line to
    // its end, with its F.
    else if (recorder_.decide(Clause::fanuc_program_arc_without_center, setup_.bit(3403, 5, true)))
      throw Alarm(AlarmCause::arc_without_center);
    return std::nullopt;
  }
  // A machine without an axis of the plane stands at 0 in it.
  const auto at = [&](std::size_t axis) { return axis == spec::Axes::kNone ? Real(0) : position_.at(axis).value(); };
  const PlanePoint start{at(first), at(second)};
  const PlanePoint travel = in_plane_of(command.plane, leg.travel);
  spec::Arc<Real> arc;
  arc.plane = command.plane;
  arc.direction = command.motion == Motion::arc_cw ? spec::ArcDirection::cw : spec::ArcDirection::ccw;
  ArcGeometry geometry;
  if (r != nullptr) {
    // fanuc.program.arc-radius-wins: If R and I J K are both given, R counts.
    recorder_.decide(Clause::fanuc_program_arc_radius_wins, center);
    // fanuc.program.arc-radius-without-chord: R with an end that is the start in the plane is an arc of 0 degrees. The
    // tool does not move in the plane, the other axes move in a straight line, and the block counts as one that does
    // not move in the plane.
    if (model::is_zero(travel)) {
      recorder_.reach(Clause::fanuc_program_arc_radius_without_chord);
      return std::nullopt;
    }
    geometry = arc_by_radius(recorder_, start, travel, numbers_.length(*r), arc.direction);
  } else {
    const Rational to_first = numbers_.length(command.words.find(in_plane.first_center));
    const Rational to_second = numbers_.length(command.words.find(in_plane.second_center));
    // fanuc.program.arc-center-in-start: Without R, I J K raise PS0022 if those of the plane are zero or missing. In
    // cutter compensation C they raise PS0038 instead (fanuc.cutter-c.arc-ends-in-center).
    if (!recorder_.decide(Clause::fanuc_program_arc_center_in_start, to_first == 0 && to_second == 0))
      geometry = arc_by_center(recorder_, start, travel, {to_first, to_second}, arc.direction, parameter(setup_, 3410));
    else if (compensated && setup_.cutter_compensation == spec::CutterCompensationType::c)
      geometry.center = start;
    else
      throw Alarm(AlarmCause::arc_without_center);
  }
  if (first != spec::Axes::kNone) arc.center.set(first, geometry.center[0]);
  if (second != spec::Axes::kNone) arc.center.set(second, geometry.center[1]);
  arc.sweep = geometry.sweep;
  arc.radius = geometry.radius;
  return arc;
}

void Interpreter::select_workpiece_system(const Command& command) {
  if (!command.codes.workpiece) return;
  // fanuc.program.workpiece-system: G54 to G59 and G54.1 select the workpiece system. The machine stays where it is.
  // The programmed position changes by the difference of the origins, without an event.
  recorder_.reach(Clause::fanuc_program_workpiece_system);
  work_.select(*command.codes.workpiece, position_);
}

void Interpreter::write_origins(const Command& command) {
  const bool additional = command.words.find('L')->digits == 20;
  const Rational number = command.words.number('P', -1);
  const std::size_t first = additional ? 1 : 0;
  const std::size_t last = additional ? spec::kAdditionalWorkpieces : setup_.workpiece.size();
  // fanuc.program.origin-number: P of G10 L2 is 1 to 6 for G54 to G59, or 0 for the origin that is added to all
  // systems. P of G10 L20 is that of G54.1. Another number, or no P, raises PS0031.
  if (recorder_.decide(Clause::fanuc_program_origin_number, !is_whole(number, first, last)))
    throw Alarm(AlarmCause::g10_workpiece);
  const std::size_t system = static_cast<std::size_t>(numerator(number)) + (additional ? setup_.workpiece.size() : 0);
  for (std::size_t i = 0; i < setup_.axes.size(); ++i) {
    if (!command.words.has(setup_.axes.letter(i))) continue;
    // fanuc.program.origin: G10 L2 and L20 write the workpiece origin of the axes that they name. Under G90 the words
    // replace the origin, under G91 they are added to it. The new origin counts from this block on. The machine stays
    // where it is. The programmed position changes, without an event.
    const bool add = recorder_.decide(Clause::fanuc_program_origin, command.incremental);
    work_.set_origin(system, i, word(command, i), add, position_);
  }
}

std::vector<Leg> Interpreter::legs(const Command& command, bool directed, bool always, bool compensated) {
  const OneShot one_shot = command.codes.one_shot;
  if (command.cycle.on) return {};
  if (is_reference_return(one_shot)) return reference_legs(command);
  const bool goes = command.axes != 0;
  if (one_shot == OneShot::from_reference) return goes ? return_legs(command) : std::vector<Leg>{};
  if (one_shot == OneShot::machine_coordinates) {
    // fanuc.program.machine-coordinates-incremental: G53 needs G90. Under G91 the code is ignored together with its
    // axis words, and makes no event.
    if (!goes || recorder_.decide(Clause::fanuc_program_machine_coordinates_incremental, command.incremental))
      return {};
    return {machine_leg(command)};
  }
  if (one_shot == OneShot::corner_arc) return {};
  if (is_shift(one_shot) || is_dwell_or_data(one_shot)) return always ? std::vector{stay(command)} : std::vector<Leg>{};
  Leg leg = toward(command);
  if (one_shot == OneShot::measure) return {leg};
  if (command.is_arc_motion() && (goes || command.direction || command.words.has('R')))
    leg.arc = arc(command, leg, directed, compensated);
  if (leg.arc) leg.type = spec::MoveType::arc;
  if (goes || leg.arc || always || (directed && command.direction)) return {leg};
  return {};
}

Leg Interpreter::toward(const Command& command) const { return ordinary(command, straight(command.motion)); }

Leg Interpreter::stay(const Command& command) const { return standing(straight(command.motion)); }

void Interpreter::arrive(const Command& command, const std::vector<Leg>& legs) {
  if (!legs.empty()) position_ = legs.back().end;
  if (!is_shift(command.codes.one_shot)) return;
  // fanuc.program.shift: G92 gives the programmed position of the axes that it names the values of its words. The shift
  // that results holds in all workpiece systems alike, and the local system of these axes ends. G92 gives no event. A
  // move that the block makes because an offset changes comes before the shift.
  // fanuc.program.local-system: G52 moves the origin of the local coordinate system, for the axes that it names, to the
  // values of its words. This holds in all workpiece systems alike, under G90 and G91. The value 0 ends it. The machine
  // stays where it is. G52 gives no event. A move that the block makes because an offset changes comes before it.
  const bool local = command.codes.one_shot == OneShot::local_coordinates;
  recorder_.reach(local ? Clause::fanuc_program_local_system : Clause::fanuc_program_shift);
  for (const std::size_t i : axes_in(command.axes)) {
    if (local)
      work_.set_local(i, word(command, i), position_);
    else
      work_.shift(i, word(command, i), position_);
  }
}

void Interpreter::shift_position(const Vector& by) {
  for (std::size_t i = 0; i < setup_.axes.size(); ++i)
    if (const char letter = setup_.axes.letter(i); is_space_axis(letter))
      position_.at(i) = position_.at(i) + Coordinate(component(by, space_index(letter)));
}

void Interpreter::stand_in_space(const Vector& at) {
  for (std::size_t i = 0; i < setup_.axes.size(); ++i)
    if (const char letter = setup_.axes.letter(i); is_space_axis(letter))
      position_.at(i) = Coordinate(component(at, space_index(letter)));
}

}  // namespace toolcomp::model

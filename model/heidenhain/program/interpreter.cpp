// SPDX-License-Identifier: Apache-2.0
#include "model/heidenhain/program/interpreter.h"

#include <array>

#include "model/basis/alarm.h"
#include "model/basis/number.h"
#include "model/heidenhain/program/calls.h"
#include "model/heidenhain/program/read_alarm.h"

namespace toolcomp::model::klartext {

using spec::klartext::Block;
using spec::klartext::CorrectionTable;
using spec::klartext::FeedWord;
using spec::klartext::RadiusWord;
using spec::klartext::Retraction;
using spec::klartext::Statement;

namespace {

Vector vector_of(const std::array<spec::Decimal, 3>& components) {
  return {plain(components[0]), plain(components[1]), plain(components[2])};
}

}  // namespace

Interpreter::Interpreter(const spec::Setup& setup, Recorder& recorder)
    : setup_(setup),
      recorder_(recorder),
      values_(setup, recorder),
      position_(values_, recorder),
      tool_(setup, values_, recorder),
      direction_(position_, recorder),
      feed_(values_) {}

std::optional<Motion> Interpreter::read(const Block& block) {
  tool_call_ = false;
  if (!begun_) begin(block);
  if (block.alarm) raise_read_alarm(recorder_, *block.alarm);
  const Functions functions = Functions::of(block);
  act_at_start(functions);
  // heidenhain.program.machine-coordinates-under-tcpm: M128 must be off before M91 and M92, so under TCPM a block with
  // M91 or M92 raises E_TCPM_M91. M128 in the same block is already on, and M129 in the same block is not yet off.
  if (functions.machine_coordinates && direction_.tcpm())
    raise(recorder_, Clause::heidenhain_program_machine_coordinates_under_tcpm,
          AlarmCause::machine_coordinates_under_tcpm);
  std::optional<Motion> motion = execute(block, functions);
  hole_.reset();
  if (block.calls_cycle) call_cycle(block);
  act_at_end(functions);
  ends_ = functions.ends_program || block.statement == Statement::end_program;
  return motion;
}

void Interpreter::begin(const Block& block) {
  begun_ = true;
  if (block.statement == Statement::begin_program && !block.alarm) values_.program_units(block.unit);
  // heidenhain.program.units: MM or INCH of BEGIN PGM sets the units of coordinates, TOOL CALL deltas and results.
  // Without BEGIN PGM they are the units of the setup.
  recorder_.decide(Clause::heidenhain_program_units, values_.inch());
  position_.start(setup_);
}

void Interpreter::act_at_start(const Functions& functions) {
  if (functions.m128) direction_.function_m128(setup_.m128_reference == spec::M128Reference::center);
  // heidenhain.program.oversize-switch: M107 permits positive deltas from the start of its block on. M108 ends the
  // permission at the end of its block.
  if (functions.m107) oversize_allowed_ = recorder_.decide(Clause::heidenhain_program_oversize_switch, true);
}

void Interpreter::act_at_end(const Functions& functions) {
  if (functions.m129) direction_.tcpm_off(true);
  if (functions.m108) oversize_allowed_ = recorder_.decide(Clause::heidenhain_program_oversize_switch, false);
}

std::optional<Motion> Interpreter::execute(const Block& block, const Functions& functions) {
  switch (block.statement) {
    case Statement::line:
    case Statement::line_with_vectors:
      return line(block, functions);
    case Statement::tool_call:
      call_tool(block);
      break;
    case Statement::tcpm:
      direction_.function_tcpm(block.reference);
      break;
    case Statement::reset_tcpm:
      direction_.tcpm_off(false);
      break;
    case Statement::programmed_path:
      // heidenhain.contour.switch: FUNCTION PROG PATH IS CONTOUR makes the programmed coordinates those of the contour,
      // until FUNCTION PROG PATH OFF. Tool calls do not end this.
      contour_ = recorder_.decide(Clause::heidenhain_contour_switch, block.contour);
      break;
    case Statement::correction_row:
    case Statement::reset_corrections:
      correct(block);
      break;
    case Statement::cycle:
      if (block.cycle == 7) position_.shift_datum(block);
      define_cycle(block);
      break;
    case Statement::assignment:
      values_.assign(block.target, block.value);
      break;
    case Statement::label:
    case Statement::call_label:
    case Statement::program_return:
      record_call(recorder_, block);
      break;
    case Statement::call_program:
      record_call(recorder_, block);
      // heidenhain.program.program-call-cancels: CALL PGM cancels the radius compensation. R0 is in force until RL or
      // RR is programmed again, in the called program or after the call.
      if (recorder_.decide(Clause::heidenhain_program_program_call_cancels, side_ != Side::none)) side_ = Side::none;
      break;
    case Statement::begin_program:
    case Statement::end_program:
    case Statement::block_form:
    case Statement::tool_definition:
    case Statement::select_corrections:
    case Statement::plane:
    case Statement::stop:
    case Statement::miscellaneous:
    case Statement::without_effect:
      break;
  }
  return std::nullopt;
}

void Interpreter::call_tool(const Block& block) {
  tool_call_ = true;
  if (tool_.call(block, direction_.tcpm())) side_ = Side::none;
  direction_.tool_axis(block.tool_axis);
  feed_.of_tool_call(block);
}

void Interpreter::correct(const Block& block) {
  // heidenhain.program.workpiece-corrections: FUNCTION CORRDATA WPL shifts the workpiece and is not a delta of the
  // tool. Its values are not part of the setup, and it changes nothing here.
  if (block.corrections != CorrectionTable::tcs) recorder_.reach(Clause::heidenhain_program_workpiece_corrections);
  if (block.corrections == CorrectionTable::wpl) return;
  if (block.statement == Statement::correction_row)
    tool_.use_correction(block.row);
  else
    tool_.drop_correction();
}

void Interpreter::define_cycle(const Block& block) {
  if (block.cycle_values.empty()) return;
  // heidenhain.program.drilling-cycle: CYCL DEF of one of the cycles 200 to 203, 205 to 207, 209, 240 and 241 defines a
  // drilling cycle. It sets the Q parameters that it names, as assignments do, in the order written, and it moves
  // nothing.
  recorder_.reach(Clause::heidenhain_program_drilling_cycle);
  for (const spec::klartext::Assignment& each : block.cycle_values) values_.assign(each.target, each.value);
}

void Interpreter::call_cycle(const Block& block) {
  const std::size_t slot = direction_.axis_index();
  const bool unknown = position_.unknown() != 0;
  const Vector before = position_.point();
  const std::optional<HoleLevels> levels = position_.drill(slot);
  if (!levels) return;
  if (unknown) require_positions(position_.unknown() != 0);
  Motion motion;
  motion.line = block.line;
  motion.n = block.n;
  add_position(motion);
  motion.travel = motion.position - before;
  motion.tool = tool_.effective();
  motion.direction = direction_.current();
  hole_ = {std::move(motion), setup_.axes.index(spec::klartext::kAxisLetters.at(slot)), levels->r, levels->bottom};
}

// Modal words count also where nothing moves.
std::optional<Motion> Interpreter::line(const Block& block, const Functions& functions) {
  if (block.radius != RadiusWord::none)
    side_ = block.radius == RadiusWord::rl ? Side::left : block.radius == RadiusWord::rr ? Side::right : Side::none;
  feed_.of_block(block);
  const bool retracts = block.retraction != Retraction::none;
  if (block.axes == 0 && !retracts && !block.departs_from_contour()) return std::nullopt;

  Motion motion;
  motion.line = block.line;
  motion.n = block.n;
  motion.vectors = block.statement == Statement::line_with_vectors;
  motion.side = side_;
  motion.contour = contour_;
  motion.oversize_allowed = oversize_allowed_;
  motion.feed = feed_.in_force();
  motion.rapid = block.feed == FeedWord::f_max || (retracts && block.feed == FeedWord::none);
  // heidenhain.program.many-digits: An L or LN block with more digits than the control accepts runs with the numbers as
  // written and gives W_DIGITS. This is so for coordinates with more than 5 decimals or beyond 99999.99999, and for
  // vector components with more than 8 decimals.
  if (recorder_.decide(Clause::heidenhain_program_many_digits, block.many_digits))
    motion.warnings.push_back(
        {"W_DIGITS", "more digits than the control accepts", Clause::heidenhain_program_many_digits});

  const Vector before = position_.point();
  move_to_end(block, functions);
  add_position(motion);
  motion.travel = block.retraction == Retraction::to_limit ? direction_.current().unit : motion.position - before;
  for (std::size_t slot = kFirstRotarySlot; slot < kFirstParallelSlot; ++slot)
    if (block.has_axis(slot))
      motion.rotary.set(setup_.axes.index(spec::klartext::kAxisLetters.at(slot)), position_.at(slot));
  motion.tool = tool_.effective();
  motion.tcpm = direction_.tcpm();
  // heidenhain.program.reference-point: Under REFPNT CNT-CNT the programmed point is the centre of the tool, R2 above
  // the tip along the tool. Otherwise, and always without TCPM, the programmed point is the tip. TIP-CNT differs only
  // in the point of rotation. Asked of every motion.
  motion.center = recorder_.decide(Clause::heidenhain_program_reference_point, direction_.at_center());
  direct(motion, block);
  return motion;
}

void Interpreter::add_position(Motion& motion) const {
  motion.unknown = position_.unknown();
  motion.position = position_.point();
  for (std::size_t slot = 0; slot < spec::klartext::kAxisLetters.size(); ++slot) {
    const std::size_t axis = setup_.axes.index(spec::klartext::kAxisLetters.at(slot));
    if (axis != spec::Axes::kNone && !is_rotary_slot(slot) && (motion.unknown >> slot & 1U) == 0)
      motion.programmed.set(axis, position_.at(slot));
  }
}

void Interpreter::move_to_end(const Block& block, const Functions& functions) {
  const unsigned before = position_.unknown();
  const bool increment = position_.needs_unknown(block);
  if (block.retraction == Retraction::by)
    position_.retract(values_.word(block.retraction_by), direction_.current().unit);
  else if (block.retraction == Retraction::to_limit)
    position_.retract_to_limit(direction_.current().unit);
  else if (block.departs_from_contour())
    position_.depart(direction_.current().unit);
  else
    position_.move(block, functions.machine_coordinates);
  if ((before | position_.unknown()) == 0) return;
  const bool vectors = block.statement == Statement::line_with_vectors;
  const bool lateral = direction_.tcpm() && side_ != Side::none && !(vectors && block.has_normal);
  require_positions(increment || lateral);
}

void Interpreter::require_positions(bool needs) {
  // heidenhain.program.unknown-position: If the position of an axis is unknown, events have no coordinates of that axis
  // and no vectors of the tool, and they name the axis in `unknown`. A word of the axis without I makes its position
  // known. A block that needs the position before that ends the run without an alarm, with not_judged. Such blocks are
  // a block with an increment of the axis; a block without a normal under RL or RR and TCPM, if a position is unknown
  // before the block or at its end; and a hole, if the position of a linear axis other than the tool axis is unknown.
  if (recorder_.decide(Clause::heidenhain_program_unknown_position, needs))
    throw Alarm(AlarmCause::not_judged,
                "an unknown position (after M140 MB MAX, or a departure from a contour) is not judged");
}

void Interpreter::direct(Motion& motion, const Block& block) {
  if (motion.vectors)
    take_vectors(motion, block);
  else
    direction_.take_rotary_words(block);
  motion.direction = direction_.current();
}

void Interpreter::take_vectors(Motion& motion, const Block& block) {
  const bool tcpm = direction_.tcpm();
  if (!tcpm) {
    // heidenhain.program.direction-without-tcpm: Without TCPM the tool is along the tool axis, whatever rotary words
    // and tool vectors say. The values of rotary words are remembered.
    recorder_.reach(Clause::heidenhain_program_direction_without_tcpm);
    // heidenhain.face.tool-vector-ignored: Without TCPM a tool vector T is ignored, even if the block defines it. Such
    // a block gives W_T_IGNORED. Asked in every LN block without TCPM.
    if (recorder_.decide(Clause::heidenhain_face_tool_vector_ignored, block.has_tool_vector))
      motion.warnings.push_back(
          {"W_T_IGNORED", "a tool vector without TCPM", Clause::heidenhain_face_tool_vector_ignored});
  }
  if (block.has_normal) {
    motion.normal = vector_of(block.normal);
    check_length(motion, *motion.normal, "the surface normal is not normalised");
  }
  if (!tcpm) return;
  if (block.has_normal) {
    // heidenhain.face.tool-vector: In an LN block with a surface normal under TCPM, the tool takes the direction T if
    // the block gives it. Otherwise the tool is perpendicular to the contour, along N. The direction stays in force for
    // the blocks that follow.
    if (!recorder_.decide(Clause::heidenhain_face_tool_vector, block.has_tool_vector)) {
      direction_.take_vector(*motion.normal);
      return;
    }
  } else {
    // heidenhain.peripheral.tool-vector: Under TCPM an LN block with a tool vector and no normal turns the tool to T.
    // The tool keeps that direction for the blocks that follow.
    recorder_.reach(Clause::heidenhain_peripheral_tool_vector);
  }
  const Vector vector = vector_of(block.tool_vector);
  check_length(motion, vector, "the tool vector is not normalised");
  direction_.take_vector(vector);
}

void Interpreter::check_length(Motion& motion, const Vector& vector, const char* message) {
  const Real norm2 = squared_norm(vector);
  const Real off = norm2 < 1 ? 1 - norm2 : norm2 - 1;
  // heidenhain.face.not-normalized: Every vector is normalised exactly, and a vector whose square differs from 1 by
  // more than 0.0002 gives W_NOT_NORMALIZED. N is checked first, then T, but not a T that is ignored.
  if (recorder_.decide(Clause::heidenhain_face_not_normalized, off - Rational(1, 5000), 1 + norm2) == Sign::positive)
    motion.warnings.push_back({"W_NOT_NORMALIZED", message, Clause::heidenhain_face_not_normalized});
}

}  // namespace toolcomp::model::klartext

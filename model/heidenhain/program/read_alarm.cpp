// SPDX-License-Identifier: Apache-2.0
#include "model/heidenhain/program/read_alarm.h"

#include <array>
#include <string_view>

#include "model/basis/alarm.h"

namespace toolcomp::model::klartext {
namespace {

struct Row {
  AlarmCause cause;
  Clause clause;
};
constexpr auto kRows = std::to_array<Row>({
    // heidenhain.program.too-many-functions: More than four M functions in a block raise E_TOO_MANY_M.
    {AlarmCause::too_many_functions, Clause::heidenhain_program_too_many_functions},
    // heidenhain.program.vector-order: In LN the position X, Y, Z comes first, then NX, NY, NZ, then TX, TY, TZ.
    // Another order raises E_LN_ORDER. It is our reading that the order also holds inside each of the three, and that a
    // word given twice breaks it.
    {AlarmCause::vector_order, Clause::heidenhain_program_vector_order},
    // heidenhain.program.vector-block-coordinates: LN always gives all three coordinates, even unchanged ones. If one
    // is missing, E_LN_COORD is raised.
    {AlarmCause::vector_coordinates, Clause::heidenhain_program_vector_block_coordinates},
    // heidenhain.program.vector-incomplete: A surface normal has all three components, even unchanged ones. If one is
    // missing, E_VEC_INCOMPLETE is raised. It is our reading that the tool vector is also given whole or not at all.
    {AlarmCause::vector_incomplete, Clause::heidenhain_program_vector_incomplete},
    // heidenhain.program.vector-range: A vector component beyond 9.99999999 or -9.99999999 raises E_VEC_RANGE.
    {AlarmCause::vector_range, Clause::heidenhain_program_vector_range},
    // heidenhain.program.vector-zero: A vector whose components are all 0 has no direction and raises E_VEC_ZERO. This
    // includes a tool vector that would be ignored.
    {AlarmCause::vector_zero, Clause::heidenhain_program_vector_zero},
    // heidenhain.program.not-supported: A run ends without an alarm at a word that a control may well run but this
    // project does not support. The event not_supported names the word.
    {AlarmCause::not_supported, Clause::heidenhain_program_not_supported},
    // heidenhain.program.not-judged: A run ends without an alarm at a word after which positions are not known here.
    // The event not_judged names the word.
    {AlarmCause::not_judged, Clause::heidenhain_program_not_judged},
    // heidenhain.program.label-missing: CALL LBL of a label that its program does not have raises E_LABEL_MISSING.
    {AlarmCause::label_missing, Clause::heidenhain_program_label_missing},
    // heidenhain.program.label-twice: CALL LBL of a label that its program has more than once raises E_LABEL_TWICE.
    {AlarmCause::label_twice, Clause::heidenhain_program_label_twice},
    // heidenhain.program.label-recursion: A subprogram that calls itself, directly or through others, raises
    // E_LABEL_RECURSION.
    {AlarmCause::label_recursion, Clause::heidenhain_program_label_recursion},
    // heidenhain.program.program-recursion: A program that calls itself, directly or through others, raises
    // E_PROGRAM_RECURSION.
    {AlarmCause::program_recursion, Clause::heidenhain_program_program_recursion},
    // heidenhain.program.nesting: Subprograms may be nested 19 deep, and so may programs. One more raises E_NESTING.
    {AlarmCause::nesting, Clause::heidenhain_program_nesting},
    // heidenhain.program.program-missing: CALL PGM of a program that does not exist raises E_NO_PROGRAM.
    {AlarmCause::called_program_missing, Clause::heidenhain_program_program_missing},
});

Clause clause_of(AlarmCause cause) {
  for (const Row& row : kRows)
    if (row.cause == cause) return row.clause;
  // heidenhain.program.unreadable-block: A block that is not Klartext raises E_SYNTAX when it is reached. This is so
  // for an unknown word or statement, a word out of place, a parameter among the components of a vector, an axis that
  // the setup does not have, BEGIN PGM after the first block, and LN without any vector.
  return Clause::heidenhain_program_unreadable_block;  // E_SYNTAX
}

}  // namespace

void raise_read_alarm(Recorder& recorder, const spec::klartext::ReadAlarm& alarm) {
  raise(recorder, clause_of(alarm.cause), alarm.cause, alarm.message);
}

}  // namespace toolcomp::model::klartext

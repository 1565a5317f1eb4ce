#include "model/heidenhain/program/read_alarm.h"

#include <array>
#include <string_view>

#include "model/basis/alarm.h"

namespace toolcomp::model::klartext {
namespace {

struct Row {
  std::string_view number;
  Clause clause;
};
constexpr std::array<Row, 6> kRows{{
    {"E_TOO_MANY_M", Clause::heidenhain_program_too_many_functions},
    {"E_LN_ORDER", Clause::heidenhain_program_vector_order},
    {"E_LN_COORD", Clause::heidenhain_program_vector_block_coordinates},
    {"E_VEC_INCOMPLETE", Clause::heidenhain_program_vector_incomplete},
    {"E_VEC_RANGE", Clause::heidenhain_program_vector_range},
    {"E_VEC_ZERO", Clause::heidenhain_program_vector_zero},
}};

Clause clause_of(const spec::Name& number) {
  for (const Row& row : kRows)
    if (row.number == number.view()) return row.clause;
  return Clause::heidenhain_program_unreadable_block;  // E_SYNTAX
}

}  // namespace

void raise_read_alarm(Recorder& recorder, const spec::klartext::ReadAlarm& alarm) {
  raise(recorder, clause_of(alarm.number), alarm.number, alarm.message);
}

}  // namespace toolcomp::model::klartext

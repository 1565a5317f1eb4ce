// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cstdint>
#include <exception>
#include <optional>
#include <string>
#include <utility>

#include "spec/language/alarm.h"
#include "spec/language/byte_source.h"
#include "spec/language/heidenhain/klartext_block.h"
#include "spec/language/heidenhain/klartext_reader.h"
#include "spec/language/input_error.h"
#include "spec_engine/case_data.h"
#include "spec_engine/plain.h"

namespace toolcomp::spec_engine {
namespace {

using spec::klartext::Block;
using spec::klartext::Statement;
using spec::klartext::Value;

template <class Enum>
Data place_of(Enum value) {
  return whole(static_cast<std::size_t>(value));
}

template <class Part, class Make>
Data maybe(bool given, const Part& part, const Make& make) {
  return given ? List{make(part)} : List{};
}

// Kinds and what a parameter is; place 0 is none.
Data parameter_kind(const spec::klartext::Parameter& p) { return whole(static_cast<std::size_t>(p.kind) - 1); }

Data written(const Value& value) {
  if (value.parameter.kind == spec::klartext::ParameterKind::none) return List{number(value.number)};
  return List{parameter_kind(value.parameter), whole(value.parameter.index), flag(value.number.negative)};
}

Data maybe_written(const std::optional<Value>& value) { return value ? List{written(*value)} : List{}; }

Data axis_words(const Block& block) {
  List words;
  for (std::size_t slot = 0; slot < spec::klartext::kAxisLetters.size(); ++slot)
    if (block.has_axis(slot))
      words.emplace_back(List{letter(spec::klartext::kAxisLetters[slot]), flag(block.is_incremental(slot)),
                              written(block.axis.at(slot))});
  return words;
}

Data cycle_values(const Block& block) {
  List values;
  for (const auto& [target, value] : block.cycle_values)
    values.emplace_back(List{parameter_kind(target), whole(target.index), written(value)});
  return values;
}

// The kinds of KlartextCase.v.
Data feed(const Block& block) {
  enum Kind : std::int64_t { kF, kMax, kAuto, kOther };
  const auto of_kind = [&](Kind kind) {
    return List{List{std::int64_t{kind}, kind == kF ? written(block.feed_value) : List{}}};
  };
  switch (block.feed) {
    case spec::klartext::FeedWord::none:
      return List{};
    case spec::klartext::FeedWord::f:
      return of_kind(kF);
    case spec::klartext::FeedWord::f_max:
      return of_kind(kMax);
    case spec::klartext::FeedWord::f_auto:
      return of_kind(kAuto);
    default:
      return of_kind(kOther);
  }
}

Data radius(const Block& block) {
  const bool given = block.radius != spec::klartext::RadiusWord::none;
  return given ? List{whole(static_cast<std::size_t>(block.radius) - 1)} : List{};
}

// By what an L block gets to its end: the kinds of KlartextCase.v, and what goes with them.
Data leading(const Block& block) {
  enum Kind : std::int64_t { kWords, kByDistance, kToLimit, kDeparture };
  const auto kind = [](Kind k) { return Data(std::int64_t{k}); };
  switch (block.retraction) {
    case spec::klartext::Retraction::by:
      return List{kind(kByDistance), written(block.retraction_by)};
    case spec::klartext::Retraction::to_limit:
      return List{kind(kToLimit)};
    default:
      return List{kind(block.departs ? kDeparture : kWords)};
  }
}

Data vector_data(const std::array<spec::Decimal, 3>& v) { return List{number(v[0]), number(v[1]), number(v[2])}; }

Data called_tool(const Block& block) {
  if (block.tool == spec::klartext::ToolWord::none) return List{};
  return List{whole(static_cast<std::size_t>(block.tool) - 1), whole(block.tool_number),
              std::string(block.tool_name.view())};
}

// The statements of KlartextCase.v, by their places there; an empty list: one without effect.
Data statement(const Block& block) {
  enum Kind : std::int64_t {
    kBegin,
    kEnd,
    kToolCall,
    kLine,
    kLineWithVectors,
    kTcpm,
    kResetTcpm,
    kProgPath,
    kCorrectionRow,
    kCorrectionReset,
    kCycle,
    kAssignment,
    kCallProgram,
    kCycleCall
  };
  const auto kind = [](Kind k) { return Data(std::int64_t{k}); };
  switch (block.statement) {
    case Statement::begin_program:
      return List{kind(kBegin), flag(block.unit == spec::Units::inch)};
    case Statement::end_program:
      return List{kind(kEnd)};
    case Statement::tool_call:
      return List{kind(kToolCall), called_tool(block), block.tool_axis != 0 ? List{letter(block.tool_axis)} : List{},
                  List{maybe_written(block.dl), maybe_written(block.dr), maybe_written(block.dr2)}, feed(block)};
    case Statement::line:
      return List{kind(kLine), axis_words(block), radius(block), feed(block), flag(block.many_digits), leading(block)};
    case Statement::line_with_vectors:
      return List{kind(kLineWithVectors),
                  axis_words(block),
                  radius(block),
                  feed(block),
                  flag(block.many_digits),
                  List{},
                  maybe(block.has_normal, block.normal, vector_data),
                  maybe(block.has_tool_vector, block.tool_vector, vector_data)};
    case Statement::tcpm:
      return List{kind(kTcpm), place_of(block.reference)};
    case Statement::reset_tcpm:
      return List{kind(kResetTcpm)};
    case Statement::programmed_path:
      return List{kind(kProgPath), flag(block.contour)};
    case Statement::correction_row:
      return List{kind(kCorrectionRow), place_of(block.corrections), whole(block.row)};
    case Statement::reset_corrections:
      return List{kind(kCorrectionReset), place_of(block.corrections)};
    case Statement::cycle:
      return List{kind(kCycle), whole(block.cycle), whole(block.cycle_part), axis_words(block), cycle_values(block)};
    case Statement::assignment:
      return List{kind(kAssignment), parameter_kind(block.target), whole(block.target.index), written(block.value)};
    case Statement::call_program:
      return List{kind(kCallProgram)};
    case Statement::miscellaneous:  // M99 of an L block is among its functions
      return block.calls_cycle ? List{kind(kCycleCall)} : List{};
    default:
      return List{};
  }
}

bool has_functions(Statement statement) {
  return statement == Statement::line || statement == Statement::line_with_vectors || statement == Statement::stop ||
         statement == Statement::miscellaneous;
}

Data block_data(const Block& block) {
  if (block.alarm) return List{std::string(spec::info(block.alarm->cause).name), List{}, List{}};
  List functions;
  if (has_functions(block.statement))
    for (std::size_t i = 0; i < block.functions; ++i) functions.push_back(whole(block.function.at(i)));
  return List{std::string(), std::move(functions), statement(block)};
}

template <class Row>
Data deltas(const Row& row) {
  return List{number(row.dl), number(row.dr), number(row.dr2)};
}

Data deviations(const spec::ToolRow& row, const spec::Setup& setup) {
  if (row.dr2_table.empty()) return List{};
  List points;
  for (const auto& [angle, value] : setup.dr2_tables.at(row.dr2_table))
    points.emplace_back(List{number(angle), number(value)});
  return List{std::move(points)};
}

Data setup_data(const spec::Setup& setup) {
  List axes;
  for (const char axis : setup.axes.letters()) axes.push_back(letter(axis));
  List tools;
  for (const spec::ToolRow& row : setup.tools)
    tools.emplace_back(List{whole(row.number), row.name, number(row.r), number(row.r2),
                            row.l ? List{number(*row.l)} : List{}, deltas(row), deviations(row, setup)});
  List corrections;
  for (const auto& [key, row] : setup.tcs) corrections.emplace_back(List{whole(key), deltas(row)});
  return List{std::move(axes),
              flag(setup.units == spec::Units::inch),
              axis_data(setup.position, setup.axes),
              std::move(tools),
              std::move(corrections),
              flag(setup.m128_reference == spec::M128Reference::center)};
}

}  // namespace

CaseData klartext_case(const spec::Case& c) {
  CaseData result;
  spec::klartext::Reader reader(spec::text_source(c.program), c.setup);
  List blocks;
  try {
    for (Block block; reader.next(block);) {
      result.places.push_back({block.line, block.n});
      blocks.push_back(block_data(block));
      if (block.alarm) {
        result.beyond = spec::beyond(block);
        break;
      }
    }
  } catch (const spec::InputError&) {
    result.bad_input = std::current_exception();
    result.places.emplace_back();
    blocks.emplace_back(List{std::string(kBadInput), List{}, List{}});
  }
  result.data = List{std::int64_t{1}, setup_data(c.setup), std::move(blocks)};
  return result;
}

}  // namespace toolcomp::spec_engine

#include "formal/klartext.h"

#include <array>
#include <exception>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "formal/data.h"
#include "formal/plain.h"
#include "spec/language/byte_source.h"
#include "spec/language/heidenhain/klartext_block.h"
#include "spec/language/heidenhain/klartext_reader.h"
#include "spec/language/input_error.h"

namespace toolcomp::formal {
namespace {

using exact::Real;
using spec::klartext::Block;
using spec::klartext::Statement;
using spec::klartext::Value;
using Event = spec::Event<Real>;
using Vector = std::array<Real, 3>;

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

// The kinds of klartext.ml.
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

Data vector_data(const std::array<spec::Decimal, 3>& v) { return List{number(v[0]), number(v[1]), number(v[2])}; }

Data called_tool(const Block& block) {
  if (block.tool == spec::klartext::ToolWord::none) return List{};
  return List{whole(static_cast<std::size_t>(block.tool) - 1), whole(block.tool_number),
              std::string(block.tool_name.view())};
}

// The statements of klartext.ml, by their places there; an empty list: one without effect.
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
    kAssignment
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
      return List{kind(kLine), axis_words(block), radius(block), feed(block), flag(block.many_digits)};
    case Statement::line_with_vectors:
      return List{kind(kLineWithVectors),
                  axis_words(block),
                  radius(block),
                  feed(block),
                  flag(block.many_digits),
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
      return List{kind(kCycle), whole(block.cycle), whole(block.cycle_part), axis_words(block)};
    case Statement::assignment:
      return List{kind(kAssignment), parameter_kind(block.target), whole(block.target.index), written(block.value)};
    default:
      return List{};
  }
}

bool has_functions(Statement statement) {
  return statement == Statement::line || statement == Statement::line_with_vectors || statement == Statement::stop ||
         statement == Statement::miscellaneous;
}

Data block_data(const Block& block) {
  if (block.alarm) return List{std::string(block.alarm->number.view()), List{}, List{}};
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
  return List{std::move(axes), flag(setup.units == spec::Units::inch), axis_data(setup.position, setup.axes),
              std::move(tools), std::move(corrections)};
}

spec::AxisValues<Real> linear_positions(const Data& data, const spec::Axes& axes) {
  spec::AxisValues<Real> values;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (spec::is_linear_axis(axes.letter(i))) values.set(i, data.list().at(i).number());
  return values;
}

Vector vector_of(const Data& data) {
  const List& v = data.list();
  return {v.at(0).number(), v.at(1).number(), v.at(2).number()};
}

spec::Contact<Real> contact_of(const List& data) {
  spec::Contact<Real> contact{vector_of(data.at(0)), vector_of(data.at(1)), data.at(2).integer() != 0, {}};
  if (const List& angle = data.at(3).list(); !angle.empty()) contact.angle = angle[0].number();
  return contact;
}

// The fields of a move, in the order of klartext.ml, behind place and kind.
void read_move(Event& event, const List& data, const spec::Axes& axes) {
  std::size_t next = 2;
  const auto field = [&]() -> const Data& { return data.at(next++); };
  event.type = field().integer() != 0 ? spec::MoveType::rapid : spec::MoveType::linear;
  event.cause = static_cast<spec::Cause>(field().integer());
  event.programmed = linear_positions(field(), axes);
  event.point = linear_positions(field(), axes);
  const List& sent = field().list();
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (const List& here = sent.at(i).list(); !here.empty()) event.axes.set(i, here[0].number());
  event.tool_axis = vector_of(field());
  spec::SpaceCompensation<Real>& space = event.space.emplace();
  space.tool_center = vector_of(field());
  space.shift = vector_of(field());
  space.tool_shift = vector_of(field());
  if (const List& carrier = field().list(); !carrier.empty()) space.carrier = vector_of(carrier[0]);
  if (const List& contact = field().list(); !contact.empty()) space.contact = contact_of(contact[0].list());
  if (const List& f = field().list(); !f.empty()) event.feed = f[0].number();
}

enum EventOf : std::int64_t { kMoved, kWarning, kAlarm, kOpen, kOutOfScope, kNotSaid };

Event event_of(const List& data, const spec::Axes& axes) {
  Event event;
  switch (data.at(1).integer()) {
    case kMoved:
      read_move(event, data, axes);
      break;
    case kWarning:
    case kAlarm:
      event.kind = data.at(1).integer() == kWarning ? spec::EventKind::warning : spec::EventKind::alarm;
      event.number = spec::Name(data.at(2).text());
      break;
    case kOpen:
      event.kind = spec::EventKind::undecided;
      event.permitted = {true, true, true};
      event.number = spec::Name(data.at(2).text());
      break;
    default:
      event.kind = spec::EventKind::undecided;
      event.out_of_scope = true;
      event.number = "heidenhain.peripheral.out-of-scope";
  }
  return event;
}

// As the alarm of a block in whose place there is bad input: it counts where the run reaches it.
constexpr const char* kBadInput = "bad input";

}  // namespace

Run run_klartext(const spec::Case& c) {
  spec::klartext::Reader reader(spec::text_source(c.program), c.setup);
  std::vector<std::pair<std::uint64_t, std::optional<std::uint64_t>>> places;
  List blocks;
  std::exception_ptr bad_input;
  try {
    for (Block block; reader.next(block);) {
      places.emplace_back(block.line, block.n);
      blocks.push_back(block_data(block));
      if (block.alarm) break;
    }
  } catch (const spec::InputError&) {
    bad_input = std::current_exception();
    places.emplace_back();
    blocks.emplace_back(List{std::string(kBadInput), List{}, List{}});
  }
  const Data said = call_ocaml("toolcomp_formal_klartext", setup_data(c.setup), std::move(blocks));
  Run result;
  if (const std::string& what = said.list().at(1).text(); !what.empty()) return {{}, not_said_yet(what)};
  for (const Data& data : said.list().at(0).list()) {
    if (data.list().at(1).integer() == kNotSaid) return {{}, not_said_yet(data.list().at(2).text())};
    Event event = event_of(data.list(), c.setup.axes);
    std::tie(event.line, event.n) = places.at(static_cast<std::size_t>(data.list().at(0).integer()));
    if (event.number == spec::Name(kBadInput)) std::rethrow_exception(bad_input);
    result.events.push_back(std::move(event));
  }
  return result;
}

}  // namespace toolcomp::formal

#include "formal/engine.h"

#include <array>
#include <tuple>
#include <utility>

#include "formal/data.h"
#include "formal/klartext.h"
#include "formal/plain.h"
#include "spec/language/byte_source.h"
#include "spec/language/fanuc/block.h"
#include "spec/language/fanuc/program_reader.h"

namespace toolcomp::formal {
namespace {

using exact::Rational;
using exact::Real;
using Event = spec::Event<Real>;

// Ten times a value that is a natural number then and has few digits; else -1.
std::int64_t tenths(const spec::Decimal& decimal) {
  constexpr std::int64_t kMost = 99'999'999;
  const Rational value = exactly(decimal) * 10;
  const bool natural = denominator(value) == 1 && value >= 0 && value <= kMost;
  return natural ? static_cast<std::int64_t>(numerator(value)) : -1;
}

Data block_data(const spec::Block& block) {
  List words;
  for (const spec::Word& word : block.words())
    words.emplace_back(List{letter(word.address), number(word.value), tenths(word.value), flag(word.value.negative),
                            flag(word.value.point)});
  return List{block.alarm ? std::string(block.alarm->number.view()) : std::string(), std::move(words)};
}

template <class Tables>
Data tables_data(const Tables& tables, const spec::Axes& axes) {
  List list;
  for (const auto& [key, table] : tables)
    list.emplace_back(List{whole(static_cast<std::size_t>(key)), axis_data(table, axes)});
  return list;
}

Data offset_data(const std::map<std::uint32_t, spec::OffsetEntry>& offsets) {
  List list;
  for (const auto& [key, entry] : offsets)
    list.emplace_back(List{whole(key), number(entry.geometry), number(entry.wear)});
  return list;
}

// Every bit that the setup gives, as "5001#2".
Data bits_data(const spec::Setup& setup) {
  constexpr int kBits = 8;
  List list;
  for (const auto& [id, value] : setup.parameters)
    for (int place = 0; place < kBits; ++place)
      if (id.bit < 0 ? value.is_integer() : id.bit == place)
        list.emplace_back(
            List{std::to_string(id.number) + '#' + std::to_string(place), flag(setup.bit(id.number, place))});
  return list;
}

// The whole ones.
Data parameters_data(const spec::Setup& setup) {
  List list;
  for (const auto& [id, value] : setup.parameters)
    if (id.bit < 0) list.emplace_back(List{std::to_string(id.number), number(value)});
  return list;
}

Data signals_data(const spec::Setup& setup) {
  List list;
  for (const char letter : setup.axes.letters()) {
    const auto given = setup.measurement.find(letter);
    list.emplace_back(given == setup.measurement.end() ? List{} : List{number(given->second)});
  }
  return list;
}

Data setup_data(const spec::Setup& setup) {
  List axes;
  for (const char axis : setup.axes.letters()) axes.push_back(letter(axis));
  List systems;
  for (const spec::AxisTable& origin : setup.workpiece) systems.push_back(axis_data(origin, setup.axes));
  const auto external = setup.additional_workpiece.find(0);
  return List{
      std::move(axes),
      flag(setup.units == spec::Units::inch),
      whole(static_cast<std::size_t>(setup.increment)),
      bits_data(setup),
      parameters_data(setup),
      whole(static_cast<std::size_t>(setup.memory)),
      whole(setup.offset_count),
      offset_data(setup.h),
      offset_data(setup.d),
      flag(setup.g49_sets_h0),
      std::move(systems),
      axis_data(external == setup.additional_workpiece.end() ? spec::AxisTable{} : external->second, setup.axes),
      tables_data(setup.additional_workpiece, setup.axes),
      axis_data(setup.position, setup.axes),
      tables_data(setup.reference, setup.axes),
      axis_data(setup.floating_reference, setup.axes),
      signals_data(setup)};
}

// What is said of the axes, of the linear ones alone or of all.
spec::AxisValues<Real> positions(const Data& data, const spec::Axes& axes, bool all) {
  spec::AxisValues<Real> values;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (all || spec::is_linear_axis(axes.letter(i))) values.set(i, data.list().at(i).number());
  return values;
}

// The travels of run.ml.
enum Travel : std::int64_t { kRapid, kLinear, kClockwise, kCounterclockwise };

spec::Arc<Real> arc_of(const List& data, std::int64_t travel, const spec::Axes& axes) {
  constexpr std::array<const char*, 3> kAxes{"XY", "ZX", "YZ"};
  spec::Arc<Real> arc;
  const auto plane = static_cast<std::size_t>(data.at(1).integer());
  for (std::size_t i = 0; i < 2; ++i) arc.center.set(axes.index(kAxes.at(plane)[i]), data.at(0).list().at(i).number());
  arc.plane = static_cast<spec::Plane>(plane);
  arc.direction = travel == kClockwise ? spec::ArcDirection::cw : spec::ArcDirection::ccw;
  if (const List& sweep = data.at(2).list(); !sweep.empty()) arc.sweep = sweep[0].number();
  if (const List& radii = data.at(3).list(); !radii.empty())
    arc.radius = {radii[0].list().at(0).number(), radii[0].list().at(1).number()};
  return arc;
}

// The fields of a move, in the order of run.ml, behind place and kind.
void read_move(Event& event, const List& data, const spec::Axes& axes) {
  const std::int64_t travel = data.at(2).integer();
  event.type = travel == kRapid    ? spec::MoveType::rapid
               : travel == kLinear ? spec::MoveType::linear
                                   : spec::MoveType::arc;
  event.cause = static_cast<spec::Cause>(data.at(3).integer());
  event.programmed = positions(data.at(4), axes, false);
  event.point = positions(data.at(5), axes, false);
  event.axes = positions(data.at(6), axes, true);
  if (const List& machine = data.at(7).list(); !machine.empty()) event.machine = positions(machine[0], axes, true);
  if (const List& arc = data.at(8).list(); !arc.empty()) event.arc = arc_of(arc[0].list(), travel, axes);
  if (const List& feed = data.at(9).list(); !feed.empty()) event.feed = feed[0].number();
  if (const List& tool = data.at(10).list(); !tool.empty()) {
    const List& axis = tool[0].list();
    event.tool_axis = {axis.at(0).number(), axis.at(1).number(), axis.at(2).number()};
  }
}

enum EventOf : std::int64_t { kMoves, kSetting, kRaised, kNotDecided, kWarned };

Event event_of(const List& data, const spec::Axes& axes) {
  Event event;
  switch (data.at(1).integer()) {
    case kMoves:
      read_move(event, data, axes);
      break;
    case kSetting:
      event.kind = spec::EventKind::setting;
      event.setting = spec::Name(data.at(2).text());
      event.value = data.at(3).number();
      break;
    case kRaised:
    case kWarned:
      event.kind = data.at(1).integer() == kRaised ? spec::EventKind::alarm : spec::EventKind::warning;
      event.number = spec::Name(data.at(2).text());
      break;
    default:
      event.kind = spec::EventKind::undecided;
      event.permitted = {true, true, true};
      event.number = spec::Name(data.at(2).text());
  }
  return event;
}

}  // namespace

std::string not_said_yet(const std::string& what) { return "the formal specification does not say yet: " + what; }

bool available() { return true; }

std::vector<std::string> sections() {
  return {"fanuc/tool-length-offset", "fanuc/tool-length-measurement", "fanuc/tool-offset",
          "heidenhain/face-milling",  "heidenhain/peripheral-milling", "heidenhain/programmed-contour"};
}

Run run(const spec::Case& c) {
  if (c.setup.control == spec::Control::heidenhain) return run_klartext(c);
  spec::ProgramReader reader(spec::text_source(c.program), c.setup.axes,
                             {.file = "program", .block_skip = c.setup.block_skip, .called_program = {}});
  std::vector<std::pair<std::uint64_t, std::optional<std::uint64_t>>> places;
  List blocks;
  for (spec::Block block; reader.next(block);) {
    places.emplace_back(block.line, block.n);
    blocks.push_back(block_data(block));
    if (block.alarm) break;
  }
  const Data said = call_ocaml("toolcomp_formal_run", setup_data(c.setup), std::move(blocks));
  Run result;
  for (const Data& data : said.list().at(0).list()) {
    Event event = event_of(data.list(), c.setup.axes);
    std::tie(event.line, event.n) = places.at(static_cast<std::size_t>(data.list().at(0).integer()));
    result.events.push_back(std::move(event));
  }
  if (const std::string& what = said.list().at(1).text(); !what.empty()) result.not_said = not_said_yet(what);
  return result;
}

}  // namespace toolcomp::formal

// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "spec/language/alarm.h"
#include "spec/language/byte_source.h"
#include "spec/language/fanuc/block.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec_engine/case_data.h"
#include "spec_engine/plain.h"

namespace toolcomp::spec_engine {
namespace {

Data block_data(const spec::Block& block) {
  List words;
  for (const spec::Word& word : block.words())
    words.emplace_back(
        List{letter(word.address), number(word.value), flag(word.value.negative), flag(word.value.point)});
  return List{block.alarm ? std::string(spec::info(block.alarm->cause).name) : std::string(), std::move(words)};
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

Data setup_data(const spec::Case& c) {
  const spec::Setup& setup = c.setup;
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
      signals_data(setup),
      flag(setup.rotary_angles == spec::RotaryAngles::programmed),
      whole(c.samples),
      flag(setup.cutter_compensation == spec::CutterCompensationType::b),
      flag(setup.type_b_without_perpendicular),
      flag(setup.series == spec::Series::series_30i),
      flag(setup.tip_control_cancel == spec::TipControlCancel::moves)};
}

}  // namespace

CaseData fanuc_case(const spec::Case& c) {
  CaseData result;
  spec::ProgramReader reader(spec::text_source(c.program), c.setup.axes, spec::reader_options(c.setup));
  List blocks;
  for (spec::Block block; reader.next(block);) {
    result.places.push_back({block.line, block.n});
    blocks.push_back(block_data(block));
    if (block.alarm) {
      result.beyond = spec::beyond(block);
      break;
    }
  }
  result.data = List{std::int64_t{0}, setup_data(c), std::move(blocks)};
  return result;
}

}  // namespace toolcomp::spec_engine

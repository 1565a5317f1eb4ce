// SPDX-License-Identifier: Apache-2.0
// Setups of which each differs from another in one value: every value of every key, and every other member of Setup and
// of its rows. What reads, writes, compares or encodes setups is held to all of them, so none can be forgotten there;
// and none can be forgotten here, for the members are counted.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "spec/language/setup_key.h"

namespace toolcomp::test {

// How many members a struct can be made of, its base counted as one.
struct Anything {
  template <class T>
  operator T() const;  // NOLINT(*-explicit-*): converts to whatever a member is; never called
};
template <class T, class... Members>
consteval std::size_t member_count() {
  if constexpr (requires { T{Members{}..., Anything{}}; })
    return member_count<T, Members..., Anything>();
  else
    return sizeof...(Members);
}

struct Changed {
  std::string what;
  spec::Setup plain;
  spec::Setup changed;
};

// Every value of every key against its default, under each control that has it.
inline std::vector<Changed> changed_keys() {
  std::vector<Changed> list;
  for (const spec::Control control : {spec::Control::fanuc, spec::Control::heidenhain})
    for (const spec::KeyInfo& key : spec::keys())
      for (std::size_t value = 0; key.is_of(control) && value < key.values.size(); ++value) {
        if (value == key.default_value) continue;
        Changed c{std::string(key.id) + " = " + std::string(key.values[value]), {}, {}};
        c.plain.control = c.changed.control = control;
        key.set(c.changed, value);
        list.push_back(c);
      }
  return list;
}

static_assert(member_count<spec::Setup>() == 18, "change a new member below: the keys are one, each other has a line");
static_assert(member_count<spec::OffsetEntry>() == 2 && member_count<spec::CorrectionRow>() == 3 &&
                  member_count<spec::ToolRow>() == 9,
              "change a new member of a row below");

inline std::vector<Changed> changed_tables_of_fanuc() {
  const spec::Decimal five = spec::decimal(5);
  std::vector<Changed> list;
  const auto add = [&list](const char* what, const auto& change) {
    list.push_back({what, {}, {}});
    change(list.back().changed);
  };
  using spec::Setup;
  add("axes", [](Setup& s) { s.axes = spec::Axes("XYZB"); });
  add("parameters", [&](Setup& s) { s.parameters[{5010, -1}] = five; });
  add("alarms", [](Setup& s) { s.alarms[spec::AlarmCause::interference] = "EX41"; });
  add("memory", [](Setup& s) { s.memory = spec::OffsetMemory::c; });
  add("offset_count", [](Setup& s) { s.offset_count = 99; });
  add("h", [&](Setup& s) { s.h[1] = {five, {}}; });
  add("d", [&](Setup& s) { s.d[1] = {five, {}}; });
  for (std::size_t i = 0; i < Setup().workpiece.size(); ++i)
    add("workpiece", [&](Setup& s) { s.workpiece.at(i)['X'] = five; });
  for (const std::uint32_t number : {0U, 1U, 48U})
    add("additional_workpiece", [&, number](Setup& s) { s.additional_workpiece[number]['X'] = five; });
  add("position", [&](Setup& s) { s.position['X'] = five; });
  for (int i = 1; i <= 4; ++i) add("reference", [&](Setup& s) { s.reference[i]['X'] = five; });
  add("floating_reference", [&](Setup& s) { s.floating_reference['X'] = five; });
  add("measurement", [&](Setup& s) { s.measurement['X'] = five; });
  for (const bool of_d : {false, true}) {
    add("wear", [&](Setup& s) { (of_d ? s.d : s.h)[1] = {five, five}; });
    for (Setup* const setup : {&list.back().plain, &list.back().changed}) setup->memory = spec::OffsetMemory::c;
    (of_d ? list.back().plain.d : list.back().plain.h)[1] = {five, {}};
  }
  return list;
}

inline std::vector<Changed> changed_tables_of_heidenhain() {
  const spec::Decimal five = spec::decimal(5);
  spec::Setup plain;
  plain.control = spec::Control::heidenhain;
  std::vector<Changed> list{{"control", {}, plain}};
  plain.tools.emplace_back().number = 10;
  plain.tcs[1] = {};
  plain.dr2_tables["T"] = {{spec::decimal(0), five}};
  const auto add = [&](const char* what, const auto& change) {
    list.push_back({what, plain, plain});
    change(list.back().changed);
  };
  using spec::Setup;
  add("tools", [](Setup& s) { s.tools.clear(); });
  add("tool.number", [](Setup& s) { s.tools[0].number = 11; });
  add("tool.name", [](Setup& s) { s.tools[0].name = "A"; });
  for (spec::Decimal spec::ToolRow::* const column :
       {&spec::ToolRow::r, &spec::ToolRow::r2, &spec::ToolRow::dl, &spec::ToolRow::dr, &spec::ToolRow::dr2})
    add("a column of a tool", [&](Setup& s) { s.tools[0].*column = five; });
  add("tool.l", [](Setup& s) { s.tools[0].l = spec::Decimal{}; });
  add("tool.dr2_table", [](Setup& s) { s.tools[0].dr2_table = "T"; });
  add("tcs", [](Setup& s) { s.tcs.clear(); });
  for (spec::Decimal spec::CorrectionRow::* const column :
       {&spec::CorrectionRow::dl, &spec::CorrectionRow::dr, &spec::CorrectionRow::dr2})
    add("a column of a correction", [&](Setup& s) { s.tcs[1].*column = five; });
  add("dr2_tables", [](Setup& s) { s.dr2_tables.clear(); });
  add("an angle", [&](Setup& s) { s.dr2_tables["T"][0].first = five; });
  add("a deviation", [](Setup& s) { s.dr2_tables["T"][0].second = spec::decimal(6); });
  return list;
}

inline std::vector<Changed> changed_setups() {
  std::vector<Changed> list = changed_keys();
  for (const auto& more : {changed_tables_of_fanuc(), changed_tables_of_heidenhain()})
    list.insert(list.end(), more.begin(), more.end());
  return list;
}

}  // namespace toolcomp::test

// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "spec/language/alarm.h"
#include "spec/language/parameter.h"
#include "spec/language/setup_document.h"
#include "spec/language/setup_format.h"
#include "spec/language/setup_key.h"
#include "spec/language/suggestion.h"

namespace toolcomp::spec {
namespace {

using document::in_quotes;
using document::Kind;
using document::Member;
using document::Node;
using document::Reader;

constexpr std::string_view kAxisLetters = "ABCUVWXYZ";
constexpr std::uint64_t kMaxOffsets = 999;

Axes axes_from(const Node& node, const Reader& read) {
  read.expect(node, Kind::array, "axes");
  std::string letters;
  for (const Node& item : node.items) {
    const std::string& letter = read.string(item, "axes");
    if (letter.size() != 1 || kAxisLetters.find(letter) == std::string_view::npos)
      read.fail(item.at, "axes: " + in_quotes(letter) + " is not an axis; expected one of A B C U V W X Y Z");
    if (letters.find(letter) != std::string::npos) read.fail(item.at, "axes: axis " + letter + " is given twice");
    letters += letter;
  }
  if (letters.empty()) read.fail(node.at, "axes: expected at least one axis");
  return Axes(letters);
}

// As a control shows a parameter of bits: eight of them, bit 7 first.
bool is_row_of_bits(const Node& value) {
  return value.kind == Kind::string && value.text.size() == 8 &&
         value.text.find_first_not_of("01") == std::string::npos;
}

// As a decimal number such a row would mean other bits. `id` is a number as a whole, and some of its bits are known.
void refuse_row_of_bits(const Node& value, ParameterId id, const Reader& read) {
  const unsigned known = known_bits(id.number);
  const unsigned ones = static_cast<unsigned>(std::stoul(value.text, nullptr, 2)) & known;
  const int bit = std::countr_zero(ones != 0 ? ones : known);
  read.fail(value.at, "parameters." + to_string(id) + ": bits must be given one by one, as in " +
                          in_quotes(to_string(ParameterId{id.number, bit})) + " = 1, found " + in_quotes(value.text));
}

void read_parameter(const Member& member, const Reader& read, Setup& setup) {
  const std::string& name = member.name;
  const std::optional<ParameterId> id = parse_parameter_id(name);
  if (!id)
    read.fail(member.at,
              "parameters: " + in_quotes(name) +
                  " is not a parameter; expected a number up to 99999, or number#bit with a bit from 0 to 7");
  if (!is_known(*id))
    read.fail(member.at, "parameters: " + in_quotes(name) + " is not known (`toolcomp spec parameters` lists them)" +
                             did_you_mean(name, std::vector{to_string(nearest_parameter(*id).id)}));
  const auto expect_allowed = [&](bool allowed, const std::string& found) {
    if (!allowed)
      read.fail(member.value.at,
                "parameters." + name + ": expected " + expected_value(*id, setup.axes) + ", found " + found);
  };
  if (id->bit >= 0 && member.value.kind == Kind::boolean) {
    const Decimal bit = decimal(member.value.boolean ? 1 : 0);
    expect_allowed(allows(*id, bit, setup.axes), member.value.boolean ? "true" : "false");
    setup.parameters[*id] = bit;
    return;
  }
  if (is_row_of_bits(member.value) && id->bit < 0 && known_bits(id->number) != 0)
    refuse_row_of_bits(member.value, *id, read);
  const Decimal value = read.decimal(member.value, name);
  // In quotes, too, a bit is one digit: a row of eight would be all bits of the number.
  const bool row = member.value.kind == Kind::string && member.value.text.size() > 1;
  if (id->bit >= 0 && (row || (value != decimal(0) && value != decimal(1))))
    read.fail(member.value.at, name + ": expected 0 or 1, found " + in_quotes(member.value.text));
  expect_allowed(allows(*id, value, setup.axes), in_quotes(member.value.text));
  setup.parameters[*id] = value;
}

// [alarms]: the numbers, or names, that this control shows.
void read_alarms(const Node& node, const Reader& read, Setup& setup) {
  read.expect(node, Kind::table, "alarms");
  std::vector<std::string_view> names;
  for (const AlarmInfo& alarm : alarms()) names.push_back(alarm.name);
  for (const Member& member : node.members) {
    const std::optional<AlarmCause> cause = find_alarm(member.name);
    if (!cause)
      read.fail(member.at, "alarms: " + in_quotes(member.name) +
                               " is not the cause of an alarm (`toolcomp spec alarms` lists them)" +
                               did_you_mean(member.name, names));
    const std::string& number = read.string(member.value, "alarms." + member.name);
    if (!is_alarm_number(number))
      read.fail(member.value.at, "alarms." + member.name + ": expected 1 to 32 letters, digits and _ - / . as in " +
                                     in_quotes("PS0022") + ", found " + in_quotes(number));
    setup.alarms[*cause] = number;
  }
}

OffsetEntry entry_from(const Node& node, const std::string& name, const Reader& read) {
  OffsetEntry entry;
  if (node.kind != Kind::table) {
    entry.geometry = read.decimal(node, name);
    return entry;
  }
  read.keys(node, name, {"geometry", "wear"});
  if (const Node* geometry = node.find("geometry")) entry.geometry = read.decimal(*geometry, name + ".geometry");
  if (const Node* wear = node.find("wear")) entry.wear = read.decimal(*wear, name + ".wear");
  return entry;
}

std::map<std::uint32_t, OffsetEntry> entries_from(const Node& node, const std::string& letter, std::uint32_t count,
                                                  const Reader& read) {
  read.expect(node, Kind::table, "offsets." + letter);
  std::map<std::uint32_t, OffsetEntry> entries;
  for (const Member& member : node.members) {
    const std::optional<std::uint32_t> number = parse_small_number(member.name, count);
    if (!number || *number == 0)
      read.fail(member.at, "offsets." + letter + ": " + in_quotes(member.name) +
                               " is not an offset number; expected 1 to offsets.count = " + std::to_string(count));
    entries[*number] = entry_from(member.value, "offsets." + letter + "." + member.name, read);
  }
  return entries;
}

// The first entry with geometry and wear, or nothing.
const Member* split_entry(const Node& offsets) {
  for (const std::string_view letter : {"H", "D"})
    if (const Node* entries = offsets.find(letter))
      for (const Member& member : entries->members)
        if (member.value.kind == Kind::table) return &member;
  return nullptr;
}

void read_offsets(const Node& node, const Reader& read, Setup& setup) {
  read.keys(node, "offsets", {"memory", "count", "H", "D"});
  if (const Node* count = node.find("count"))
    setup.offset_count = static_cast<std::uint32_t>(read.integer(*count, "offsets.count", 1, kMaxOffsets));
  if (const Node* h = node.find("H")) setup.h = entries_from(*h, "H", setup.offset_count, read);
  if (const Node* d = node.find("D")) setup.d = entries_from(*d, "D", setup.offset_count, read);
  const Member* split = split_entry(node);
  if (const Node* memory = node.find("memory")) {
    setup.memory = static_cast<OffsetMemory>(read.choice(*memory, "offsets.memory", {"A", "B", "C"}));
    if (setup.memory == OffsetMemory::a && split != nullptr)
      read.fail(split->value.at, "offsets: memory A has one value for each entry; expected a number, or memory B or C");
  } else {
    setup.memory = split != nullptr ? OffsetMemory::c : OffsetMemory::a;
  }
}

AxisTable axis_table(const Node& node, const std::string& name, const Setup& setup, const Reader& read) {
  read.expect(node, Kind::table, name);
  AxisTable table;
  for (const Member& member : node.members) {
    if (member.name.size() != 1 || !setup.axes.has(member.name[0]))
      read.fail(member.at, name + ": " + in_quotes(member.name) + " is not an axis of this setup; its axes are " +
                               setup.axes.letters());
    table[member.name[0]] = read.decimal(member.value, name + "." + member.name);
  }
  return table;
}

// The table of a workpiece origin: G54 to G59, P1 to P48, external; nullptr for any other name.
AxisTable* workpiece_table(const std::string& name, Setup& setup) {
  if (name == "external") return &setup.additional_workpiece[0];
  if (name.size() == 3 && name.starts_with("G5") && name[2] >= '4' && name[2] <= '9')
    return &setup.workpiece[static_cast<std::size_t>(name[2] - '4')];
  if (!name.starts_with('P')) return nullptr;
  const std::uint32_t number = parse_small_number(name.substr(1), kAdditionalWorkpieces).value_or(0);
  return number == 0 ? nullptr : &setup.additional_workpiece[number];
}

void read_workpiece(const Node& node, const Reader& read, Setup& setup) {
  read.expect(node, Kind::table, "workpiece");
  for (const Member& member : node.members) {
    AxisTable* const table = workpiece_table(member.name, setup);
    if (table == nullptr)
      read.fail(member.at, "workpiece: unknown key " + in_quotes(member.name) +
                               "; expected G54 to G59, P1 to P48 or external" +
                               did_you_mean(member.name, std::array{"external"}));
    *table = axis_table(member.value, "workpiece." + member.name, setup, read);
  }
  std::erase_if(setup.additional_workpiece, [](const auto& entry) { return entry.second.empty(); });
}

void read_reference(const Node& node, const Reader& read, Setup& setup) {
  read.keys(node, "reference", {"1", "2", "3", "4", "floating"});
  for (const Member& member : node.members) {
    const AxisTable table = axis_table(member.value, "reference." + member.name, setup, read);
    if (member.name == "floating")
      setup.floating_reference = table;
    else if (!table.empty())
      setup.reference[member.name[0] - '0'] = table;
  }
}

// Tables of a setup, in the order in which they are written, and axes.
constexpr std::array<std::string_view, 7> kFanucTables{"parameters", "alarms",    "offsets",    "workpiece",
                                                       "position",   "reference", "measurement"};
constexpr std::array<std::string_view, 5> kHeidenhainTables{"alarms", "position", "tool", "correction", "dr2table"};

// Every name of a setup of this control.
std::vector<std::string_view> names_of(Control control) {
  std::vector<std::string_view> names{"control"};
  for (const KeyInfo& key : keys()) {
    if (key.is_of(control)) names.push_back(key.id);
    if (key.id == kKeyBeforeAxes) names.emplace_back("axes");
  }
  const auto add = [&names](const auto& tables) { names.insert(names.end(), tables.begin(), tables.end()); };
  control == Control::fanuc ? add(kFanucTables) : add(kHeidenhainTables);
  return names;
}

// Names of one control are refused under the other.
void check_names(const Node& node, Control control, const Reader& read) {
  const bool fanuc = control == Control::fanuc;
  const std::vector<std::string_view> own = names_of(control);
  const std::vector<std::string_view> others = names_of(fanuc ? Control::heidenhain : Control::fanuc);
  const auto has = [](const std::vector<std::string_view>& names, std::string_view name) {
    return std::ranges::find(names, name) != names.end();
  };
  for (const Member& member : node.members)
    if (!has(own, member.name) && has(others, member.name))
      read.fail(member.at,
                "setup: " + in_quotes(member.name) + " belongs to control " + (fanuc ? "\"heidenhain\"" : "\"fanuc\""));
  read.keys(node, "setup", own);
}

void read_keys(const Node& node, const Reader& read, Setup& setup) {
  for (const KeyInfo& key : keys())
    if (const Node* given = node.find(key.id))
      key.set(setup, key.boolean ? static_cast<std::size_t>(read.boolean(*given, key.id))
                                 : read.choice(*given, key.id, key.values));
}

void read_axes(const Node& node, const Reader& read, Setup& setup) {
  const bool fanuc = setup.control == Control::fanuc;
  if (!fanuc) setup.axes = Axes("XYZABC");
  const Node* axes = node.find("axes");
  if (axes == nullptr) return;
  setup.axes = axes_from(*axes, read);
  for (const char letter : {'X', 'Y', 'Z'})
    if (!fanuc && !setup.axes.has(letter))
      read.fail(axes->at, std::string("axes: without ") + letter + "; control \"heidenhain\" needs X, Y and Z");
}

}  // namespace

Setup setup_from(const Node& node, const Reader& read) {
  Setup setup;
  read.expect(node, Kind::table, "setup");
  // First what decides which names belong here and which axes they may name.
  if (const Node* control = node.find("control"))
    setup.control = static_cast<Control>(read.choice(*control, "control", {"fanuc", "heidenhain"}));
  check_names(node, setup.control, read);
  read_axes(node, read, setup);
  read_keys(node, read, setup);
  if (const Node* parameters = node.find("parameters")) {
    read.expect(*parameters, Kind::table, "parameters");
    for (const Member& member : parameters->members) read_parameter(member, read, setup);
  }
  if (const Node* alarms = node.find("alarms")) read_alarms(*alarms, read, setup);
  if (const Node* offsets = node.find("offsets")) read_offsets(*offsets, read, setup);
  if (const Node* workpiece = node.find("workpiece")) read_workpiece(*workpiece, read, setup);
  if (const Node* position = node.find("position")) setup.position = axis_table(*position, "position", setup, read);
  if (const Node* reference = node.find("reference")) read_reference(*reference, read, setup);
  if (const Node* signal = node.find("measurement"))
    setup.measurement = axis_table(*signal, "measurement", setup, read);
  read_tool_tables(node, read, setup);
  return setup;
}

Setup read_setup_toml(std::string_view text, const std::string& file) {
  return setup_from(document::parse_toml(text, file), Reader(file));
}

Setup read_setup_json(std::string_view text, const std::string& file) {
  return setup_from(document::parse_json(text, file), Reader(file));
}

}  // namespace toolcomp::spec

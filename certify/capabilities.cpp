// SPDX-License-Identifier: Apache-2.0
#include "certify/capabilities.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "spec/language/alarm.h"
#include "spec/language/fields.h"
#include "spec/language/input_error.h"
#include "spec/language/outside_json.h"
#include "spec/language/parameter.h"
#include "spec/language/printable.h"
#include "spec/language/setup_format.h"

namespace toolcomp::certify {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFile = "capabilities";

[[noreturn]] void fail(const std::string& what) { throw spec::InputError(kFile, 0, 0, what); }

std::string text_at(const Json& object, const char* key) {
  const auto entry = object.find(key);
  if (entry == object.end() || entry->is_null()) return {};
  if (!entry->is_string()) fail(std::string(key) + " must be a string");
  return entry->get<std::string>();
}

std::vector<std::string> list_at(const Json& object, const char* key) {
  const auto entry = object.find(key);
  if (entry == object.end() || entry->is_null()) return {};
  if (!entry->is_array()) fail(std::string(key) + " must be an array of strings");
  std::vector<std::string> list;
  for (const Json& item : *entry) {
    if (!item.is_string()) fail(std::string(key) + " must be an array of strings");
    list.push_back(spec::printable(item.get<std::string>()));
  }
  return list;
}

void expect_increment(const std::string& text) {
  const auto value = spec::parse_decimal(text);
  if (!value || value->negative || value->is_zero()) fail("resolution must be a positive decimal");
}

// The decimal with its point moved: least increments of inches are a tenth of those of millimetres.
std::string times_ten_to(const std::string& text, int power) {
  spec::Decimal value = *spec::parse_decimal(text);
  std::string digits = std::to_string(value.digits);
  int decimals = static_cast<int>(value.decimals) - power;
  for (; decimals < 0; ++decimals) digits += '0';
  const auto behind = static_cast<std::size_t>(decimals);
  if (digits.size() <= behind) digits.insert(0, behind + 1 - digits.size(), '0');
  return behind == 0 ? digits : digits.insert(digits.size() - behind, ".");
}

// `inch`: the controller has lengths in inches alone, and one number is of those.
AnnouncedResolution resolution_at(const Json& json, bool inch) {
  AnnouncedResolution r;
  r.rounding = text_at(json, "rounding");
  constexpr std::array kRoundings{"", "nearest", "down", "toward zero"};
  if (std::ranges::find(kRoundings, r.rounding) == kRoundings.end())
    fail(R"(rounding must be "nearest", "down" or "toward zero")");
  const auto entry = json.find("resolution");
  if (entry == json.end() || entry->is_null()) return r;
  if (entry->is_object()) {
    for (const auto& [key, value] : entry->items()) {
      std::string* slot = key == "mm"        ? &r.mm
                          : key == "inch"    ? &r.inch
                          : key == "degrees" ? &r.degrees
                          : key == "vectors" ? &r.vectors
                                             : nullptr;
      if (slot == nullptr || !value.is_string()) fail("resolution has mm, inch, degrees and vectors, each a string");
      expect_increment(*slot = value.get<std::string>());
    }
  } else if (const std::string plain = text_at(json, "resolution"); !plain.empty()) {
    expect_increment(plain);
    r.degrees = r.vectors = plain;
    r.mm = inch ? times_ten_to(plain, 1) : plain;
    r.inch = inch ? plain : times_ten_to(plain, -1);
  }
  return r;
}

// The value without trailing zeros, so that 1.0 and 1 compare equal.
spec::Decimal reduced(spec::Decimal value) {
  while (value.decimals > 0 && value.digits % 10 == 0) {
    value.digits /= 10;
    --value.decimals;
  }
  if (value.digits == 0) value.negative = false;
  value.point = false;
  return value;
}

bool equal(const spec::Decimal& a, const spec::Decimal& b) { return reduced(a) == reduced(b); }

// Two maps to decimals in which a missing entry is 0.
template <class Key>
bool equal_tables(const std::map<Key, spec::Decimal>& a, const std::map<Key, spec::Decimal>& b) {
  const auto covered = [](const auto& some, const auto& other) {
    return std::ranges::all_of(some, [&](const auto& entry) {
      const auto match = other.find(entry.first);
      return equal(entry.second, match == other.end() ? spec::Decimal{} : match->second);
    });
  };
  return covered(a, b) && covered(b, a);
}

bool equal_offsets(const std::map<std::uint32_t, spec::OffsetEntry>& a,
                   const std::map<std::uint32_t, spec::OffsetEntry>& b) {
  const auto covered = [](const auto& some, const auto& other) {
    return std::ranges::all_of(some, [&](const auto& entry) {
      const auto match = other.find(entry.first);
      const spec::OffsetEntry value = match == other.end() ? spec::OffsetEntry{} : match->second;
      return equal(entry.second.geometry, value.geometry) && equal(entry.second.wear, value.wear);
    });
  };
  return covered(a, b) && covered(b, a);
}

bool equal_alarms(const spec::Setup& a, const spec::Setup& b) {
  const spec::AlarmNumbers of_a(a);
  const spec::AlarmNumbers of_b(b);
  return std::ranges::all_of(spec::alarms(),
                             [&](const spec::AlarmInfo& alarm) { return of_a(alarm.cause) == of_b(alarm.cause); });
}

// What counts where a setup does not give a parameter stands in the registry.
bool equal_parameters(const spec::Setup& a, const spec::Setup& b) {
  const auto value = [](const spec::Setup& setup, std::uint32_t number) {
    const std::optional<spec::Decimal> given = setup.parameter(number);
    return given ? given : spec::default_value({number, -1}, setup.units);
  };
  const auto bit = [](const spec::Setup& setup, spec::ParameterId id) {
    const std::optional<spec::Decimal> otherwise = spec::default_value(id, setup.units);
    return setup.bit(id.number, id.bit, otherwise && !otherwise->is_zero());
  };
  return std::ranges::all_of(spec::parameters(), [&](const spec::ParameterInfo& p) {
    if (p.id.bit >= 0) return bit(a, p.id) == bit(b, p.id);
    const std::optional<spec::Decimal> one = value(a, p.id.number);
    const std::optional<spec::Decimal> other = value(b, p.id.number);
    return one.has_value() == other.has_value() && (!one || equal(*one, *other));
  });
}

template <class Number>
bool equal_by_number(const std::map<Number, spec::AxisTable>& a, const std::map<Number, spec::AxisTable>& b) {
  const auto covered = [](const auto& some, const auto& other) {
    return std::ranges::all_of(some, [&](const auto& entry) {
      const auto match = other.find(entry.first);
      return equal_tables(entry.second, match == other.end() ? spec::AxisTable{} : match->second);
    });
  };
  return covered(a, b) && covered(b, a);
}

// The rows of two tool tables, in any order. A length that is not known is not a length of 0.
bool equal_tools(const spec::Setup& a, const spec::Setup& b) {
  return a.tools.size() == b.tools.size() && std::ranges::all_of(a.tools, [&](const spec::ToolRow& x) {
           const auto y = std::ranges::find(b.tools, x.number, &spec::ToolRow::number);
           return y != b.tools.end() && x.name == y->name && equal(x.r, y->r) && equal(x.r2, y->r2) &&
                  equal(x.dl, y->dl) && equal(x.dr, y->dr) && equal(x.dr2, y->dr2) &&
                  x.l.has_value() == y->l.has_value() && (!x.l || equal(*x.l, *y->l)) && x.dr2_table == y->dr2_table;
         });
}

// A row that is missing cannot be named, so it is no row of zeros.
bool equal_corrections(const std::map<std::uint32_t, spec::CorrectionRow>& a,
                       const std::map<std::uint32_t, spec::CorrectionRow>& b) {
  return std::ranges::equal(a, b, [](const auto& x, const auto& y) {
    return x.first == y.first && equal(x.second.dl, y.second.dl) && equal(x.second.dr, y.second.dr) &&
           equal(x.second.dr2, y.second.dr2);
  });
}

bool equal_deviations(const std::map<std::string, spec::DeviationTable>& a,
                      const std::map<std::string, spec::DeviationTable>& b) {
  return std::ranges::equal(a, b, [](const auto& x, const auto& y) {
    return x.first == y.first && std::ranges::equal(x.second, y.second, [](const auto& p, const auto& q) {
             return equal(p.first, q.first) && equal(p.second, q.second);
           });
  });
}

// The case's setup with the controller's fixed settings laid over it; nothing if no control could have both.
std::optional<spec::Setup> overlaid(const spec::Setup& setup, const std::string& fixed) {
  try {
    Json merged = Json::parse(spec::write_setup_json(setup));
    merged.merge_patch(Json::parse(fixed));
    return spec::read_setup_json(merged.dump(), "setup");
  } catch (const spec::InputError&) {
    return std::nullopt;
  }
}

bool has_inches_alone(const Capabilities& c) {
  return !c.setup.empty() && spec::read_setup_json(c.setup, std::string(kFile) + " setup").units == spec::Units::inch;
}

bool lists(const std::vector<std::string>& list, std::string_view item) {
  return std::ranges::find(list, item) != list.end();
}

}  // namespace

Capabilities read_capabilities(std::string_view line) {
  return capabilities_from(spec::read_outside_json(line, kFile));
}

Capabilities capabilities_from(const nlohmann::json& tree) {
  const Json json = tree;
  if (!json.is_object()) fail("the answer to hello is not a JSON object");
  const auto protocol = json.find("protocol");
  if (protocol == json.end() || *protocol != 1) fail("the answer to hello does not say \"protocol\": 1");
  Capabilities c;
  c.name = spec::printable(text_at(json, "name"));
  c.version = spec::printable(text_at(json, "version"));
  c.sections = list_at(json, "sections");
  c.fields = list_at(json, "fields");
  if (const auto setup = json.find("setup"); setup != json.end() && !setup->is_null()) {
    if (!setup->is_object()) fail("setup must be an object");
    c.setup = setup->empty() ? "" : setup->dump();
    if (!c.setup.empty()) spec::read_setup_json(c.setup, std::string(kFile) + " setup");
  }
  c.resolution = resolution_at(json, has_inches_alone(c));
  return c;
}

std::string write_capabilities(const Capabilities& capabilities) {
  Json json;
  json["name"] = capabilities.name;
  json["version"] = capabilities.version;
  json["protocol"] = 1;
  json["sections"] = capabilities.sections;
  json["fields"] = capabilities.fields;
  const AnnouncedResolution& r = capabilities.resolution;
  for (const auto& [key, value] :
       {std::pair{"mm", &r.mm}, {"inch", &r.inch}, {"degrees", &r.degrees}, {"vectors", &r.vectors}})
    if (!value->empty()) json["resolution"][key] = *value;
  if (!r.rounding.empty()) json["rounding"] = r.rounding;
  json["setup"] = capabilities.setup.empty() ? Json::object() : Json::parse(capabilities.setup);
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

judge::JudgeOptions judge_options(const Capabilities& capabilities) {
  return {capabilities.fields, capabilities.resolution.numbers(), capabilities.known};
}

std::vector<std::string> all_fields() {
  // What people read or the model alone knows is not judged.
  constexpr std::array not_judged{spec::Field::message, spec::Field::code, spec::Field::clause, spec::Field::clauses};
  std::vector<std::string> fields;
  for (const std::string_view field : spec::kFieldNames)
    if (std::ranges::find(not_judged, spec::find_field(field)) == not_judged.end()) fields.emplace_back(field);
  return fields;
}

std::vector<std::string> fields_not_judged(const Capabilities& capabilities) {
  std::vector<std::string> missing;
  for (std::string& field : all_fields())
    if (!lists(capabilities.fields, field)) missing.push_back(std::move(field));
  return missing;
}

bool meets_minimum(const Capabilities& capabilities) {
  const auto& fields = capabilities.fields;
  return lists(fields, "kind") && lists(fields, "line") && (lists(fields, "point") || lists(fields, "axes"));
}

std::string AnnouncedResolution::words() const {
  if (empty()) return "double precision";
  std::string text;
  for (const auto& [unit, value] :
       {std::pair{" mm", &mm}, {" inch", &inch}, {" degrees", &degrees}, {" of unit vectors", &vectors}})
    if (!value->empty()) text += (text.empty() ? "" : ", ") + *value + unit;
  if (rounding == "nearest") return text + ", rounded to nearest";
  return rounding.empty() ? text : text + ", rounded " + rounding;
}

judge::Resolution AnnouncedResolution::numbers() const {
  const auto number = [](const std::string& text) { return text.empty() ? 0.0 : std::stod(text); };
  const auto rounded = rounding == "nearest"       ? judge::Rounding::nearest
                       : rounding == "down"        ? judge::Rounding::down
                       : rounding == "toward zero" ? judge::Rounding::toward_zero
                                                   : judge::Rounding::unknown;
  return {number(mm), number(inch), number(degrees), number(vectors), rounded};
}

void expect_fine_resolution(const Capabilities& capabilities, const std::string& accepted) {
  constexpr double kFineMm = 0.01;
  constexpr double kFineInch = 0.0004;
  const AnnouncedResolution& r = capabilities.resolution;
  const bool inch = r.mm.empty() || has_inches_alone(capabilities);
  const std::string& announced = inch ? r.inch : r.mm;
  if (announced.empty() || std::stod(announced) <= (inch ? kFineInch : kFineMm)) return;
  if (!accepted.empty() && std::stod(announced) <= std::stod(accepted)) return;
  throw spec::InputError("--controller", 0, 0,
                         "the controller announces a resolution of " + announced + (inch ? " inch" : " mm") +
                             ", coarser than 0.01 mm (0.0004 inch); to accept it, give --accept-resolution " +
                             announced);
}

std::string why_not_applicable(const Capabilities& capabilities, const spec::Case& c) {
  // A program of the user's own belongs to no section and is for every controller.
  if (!c.section.empty() && !lists(capabilities.sections, c.section))
    return "section " + c.section + " is not announced";
  if (capabilities.setup.empty()) return {};
  const auto both = overlaid(c.setup, capabilities.setup);
  if (!both || !same_meaning(*both, c.setup)) return "setup contradicts the fixed settings of the controller";
  return {};
}

bool same_meaning(const spec::Setup& a, const spec::Setup& b) {
  if (a.control != b.control || a.axes != b.axes || a.memory != b.memory || a.offset_count != b.offset_count ||
      static_cast<const spec::SetupKeys&>(a) != b || !equal_alarms(a, b))
    return false;
  for (std::size_t i = 0; i < a.workpiece.size(); ++i)
    if (!equal_tables(a.workpiece.at(i), b.workpiece.at(i))) return false;
  return equal_parameters(a, b) && equal_offsets(a.h, b.h) && equal_offsets(a.d, b.d) &&
         equal_tables(a.position, b.position) && equal_by_number(a.reference, b.reference) &&
         equal_by_number(a.additional_workpiece, b.additional_workpiece) &&
         equal_tables(a.floating_reference, b.floating_reference) && equal_tables(a.measurement, b.measurement) &&
         equal_tools(a, b) && equal_corrections(a.tcs, b.tcs) && equal_deviations(a.dr2_tables, b.dr2_tables);
}

}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
#include "certify/bundle/record.h"

#include <limits>
#include <nlohmann/json.hpp>

#include "spec/language/document.h"
#include "spec/language/fields.h"
#include "spec/language/input_error.h"
#include "spec/language/outside_json.h"

namespace toolcomp::certify::bundle {
namespace {

using Json = nlohmann::ordered_json;

Json names(const spec::FieldSet& fields) {
  Json list = Json::array();
  for (std::size_t i = 0; i < spec::kFieldNames.size(); ++i)
    if (fields.has(static_cast<spec::Field>(i))) list.push_back(spec::kFieldNames.at(i));
  return list;
}

spec::FieldSet fields(const nlohmann::json& list) {
  spec::FieldSet set;
  for (const auto& name : list)
    if (const auto field = spec::find_field(name.get<std::string>())) set.add(*field);
  return set;
}

// JSON has no number for what is not finite: null.
double real(const nlohmann::json& number) {
  return number.is_null() ? std::numeric_limits<double>::infinity() : number.get<double>();
}

// The value of an enumeration that has a name.
template <class Value, std::size_t count>
Value named(const std::string& text, const std::string& place) {
  for (std::size_t i = 0; i < count; ++i)
    if (name(static_cast<Value>(i)) == text) return static_cast<Value>(i);
  throw spec::InputError(place, 0, 0, spec::document::in_quotes(text) + " is unknown");
}

// What is compared.
Json facts(const Record& record) {
  const CaseResult& r = record.result;
  const judge::Verdict& v = r.verdict;
  Json json{{"id", r.id},
            {"section", r.section},
            {"origin", name(r.origin)},
            {"asked", record.asked},
            {"result", name(r.result)}};
  if (!r.why.empty()) json["why"] = r.why;
  if (!r.known_difference.empty()) json["known_difference"] = r.known_difference;
  if (r.result == Result::differs) {
    json["kind"] = r.key.kind;
    json["clause"] = r.key.clause;
  }
  if (record.fault) json["fault"] = name(record.fault->kind);
  json["values"] = v.values;
  json["not_judged"] = v.wide;
  if (v.beyond) json["judged_before_line"] = v.beyond->line;
  json["events"] = v.events;
  json["out_of_scope"] = v.out_of_scope;
  if (v.left_out > 0) {
    json["left_out"] = v.left_out;
    json["left_out_for"] = Json::object();
    for (const auto& [clause, events] : v.left_out_for)
      json["left_out_for"][std::string(spec::info(clause).id)] = events;
  }
  json["decisions"] = v.decisions;
  json["near_ties"] = v.near_ties;
  json["ties"] = v.ties;
  json["worst_ulp"] = v.worst_ulp;
  json["worst_um"] = v.worst_um;
  json["largest_width_um"] = v.widths.largest();
  json["rounded"] = {{"count", v.bias.count}, {"sum", v.bias.sum}, {"worst", v.bias.worst}};
  json["sent"] = names(r.sent);
  json["due"] = names(r.due);
  return json;
}

std::string dump(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace

std::string write_record(std::uint64_t number, const Record& record) {
  Json json{{"case", number}};
  json.update(facts(record));
  if (record.fault) {
    json["what"] = record.fault->what;
    json["status"] = record.fault->status;
    json["errors"] = record.fault->errors;
  }
  if (record.cut) json["cut"] = true;
  return dump(json);
}

Record read_record(std::uint64_t number, std::string_view line) {
  const std::string place = "results.jsonl: line " + std::to_string(number + 1);
  Record record;
  CaseResult& r = record.result;
  try {
    const auto json = spec::read_outside_json(line, place);
    if (json.at("case") != number)
      throw spec::InputError(place, 0, 0, "is not the result of case " + std::to_string(number));
    const auto text = [&json](const char* key) { return json.contains(key) ? json.at(key).get<std::string>() : ""; };
    r.id = json.at("id").get<std::string>();
    r.section = json.at("section").get<std::string>();
    r.origin = named<Origin, 3>(json.at("origin").get<std::string>(), place);
    record.asked = json.at("asked").get<bool>();
    r.result = named<Result, kResultCount>(json.at("result").get<std::string>(), place);
    r.why = text("why");
    r.known_difference = text("known_difference");
    if (r.result == Result::differs) r.key = {r.section, text("clause"), text("kind")};
    if (json.contains("fault"))
      record.fault =
          Fault{named<FaultKind, kFaultKinds>(text("fault"), place), text("what"), text("status"), text("errors")};
    record.cut = json.contains("cut") && json.at("cut").get<bool>();
    judge::Verdict& v = r.verdict;
    v.values = json.at("values").get<std::uint64_t>();
    v.wide = json.at("not_judged").get<std::uint64_t>();
    if (json.contains("judged_before_line"))
      v.beyond = judge::Beyond{json.at("judged_before_line").get<std::uint64_t>(), 1, "", 0};
    v.events = json.at("events").get<std::uint64_t>();
    v.out_of_scope = json.at("out_of_scope").get<std::uint64_t>();
    if (json.contains("left_out")) {
      v.left_out = json.at("left_out").get<std::uint64_t>();
      for (const auto& [id, events] : json.at("left_out_for").items()) {
        const auto clause = spec::find_clause(id);
        if (!clause) throw spec::InputError(place, 0, 0, spec::document::in_quotes(id) + " is not a clause");
        v.left_out_for[*clause] = events.get<std::uint64_t>();
      }
    }
    v.decisions = json.at("decisions").get<std::uint64_t>();
    v.near_ties = json.at("near_ties").get<std::uint64_t>();
    v.ties = json.at("ties").get<std::uint64_t>();
    v.worst_ulp = real(json.at("worst_ulp"));
    v.worst_um = real(json.at("worst_um"));
    if (const double width = real(json.at("largest_width_um")); width > 0) v.widths.add(width);
    const auto& rounded = json.at("rounded");
    v.bias = {rounded.at("count").get<std::uint64_t>(), real(rounded.at("sum")), real(rounded.at("worst"))};
    r.sent = fields(json.at("sent"));
    r.due = fields(json.at("due"));
  } catch (const nlohmann::json::exception& error) {
    throw spec::InputError(place, 0, 0, error.what());
  }
  return record;
}

std::string difference(const Record& a, const Record& b) {
  const Json left = Json::parse(dump(facts(a)));
  const Json right = Json::parse(dump(facts(b)));
  for (const auto& [key, value] : left.items()) {
    const Json other = right.contains(key) ? right.at(key) : Json();
    if (value != other) return key + ": " + dump(value) + " and " + dump(other);
  }
  for (const auto& [key, value] : right.items())
    if (!left.contains(key)) return key + ": nothing and " + dump(value);
  return {};
}

}  // namespace toolcomp::certify::bundle

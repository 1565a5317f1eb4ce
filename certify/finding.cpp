// SPDX-License-Identifier: Apache-2.0
#include "certify/finding.h"

#include <charconv>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

#include "spec/language/case_document.h"
#include "spec/language/case_format.h"
#include "spec/language/input_error.h"
#include "spec/language/known.h"
#include "spec/language/outside_json.h"

namespace toolcomp::certify {
namespace {

using Json = nlohmann::ordered_json;
using spec::document::Kind;
using spec::document::Node;
using spec::document::Reader;

constexpr std::uint64_t kMostCount = 1'000'000'000'000;

std::string quoted(const std::string& text) { return Json(text).dump(-1, ' ', true, Json::error_handler_t::replace); }

// A member that may be left out, or null.
const Node* given(const Node& root, std::string_view key) {
  const Node* node = root.find(key);
  return node == nullptr || node->kind == Kind::null ? nullptr : node;
}

std::string text_of(const Node& root, const char* key, const Reader& read) {
  const Node* node = given(root, key);
  return node == nullptr ? std::string() : read.string(*node, key);
}

std::uint64_t count_of(const Node& root, const char* key, const Reader& read, std::uint64_t otherwise) {
  const Node* node = given(root, key);
  return node == nullptr ? otherwise : read.integer(*node, key, 0, kMostCount);
}

double number_of(const Node& root, const char* key, const Reader& read) {
  const Node* node = given(root, key);
  if (node == nullptr) return 0;
  read.expect(*node, Kind::number, key);
  double value = 0;
  std::from_chars(node->text.data(), node->text.data() + node->text.size(), value);
  return value;
}

spec::KnownSet known_of(const Node& judged, const Reader& read) {
  read.expect(judged, Kind::array, "judged");
  std::vector<std::string> names;
  names.reserve(judged.items.size());
  for (const Node& item : judged.items) names.push_back(read.string(item, "judged"));
  try {
    return spec::KnownSet::of(names);
  } catch (const std::invalid_argument& error) {
    read.fail(judged.at, std::string("judged: ") + error.what());
  }
}

}  // namespace

std::string how_known(const Finding& finding) {
  const auto clause = spec::find_clause(finding.key.clause);
  return clause ? spec::cited(spec::info(*clause)) : std::string();
}

std::string write_finding(const Finding& finding) {
  std::string out = "{\"finding\": 1";
  const auto add = [&out](std::string_view key, const std::string& value) {
    out += ",\n \"" + std::string(key) + "\": " + value;
  };
  const auto add_text = [&](std::string_view key, const std::string& text) {
    if (!text.empty()) add(key, quoted(text));
  };
  add("kind", quoted(finding.key.kind));
  add("clause", finding.key.clause.empty() ? "null" : quoted(finding.key.clause));
  if (const auto clause = spec::find_clause(finding.key.clause)) {
    add("known", quoted(std::string(spec::known_name(spec::info(*clause).known))));
    add("source", quoted(how_known(finding)));
  }
  if (!finding.subject.known.is_all()) add("judged", Json(finding.subject.known.names()).dump());
  const judge::Difference& d = finding.difference;
  add("line", std::to_string(d.line));
  add("field", quoted(d.field));
  add("expected", quoted(d.expected));
  add("actual", quoted(d.actual));
  add("deviation_um", Json(d.deviation_um).dump());
  add_text("status", finding.status);
  add_text("errors", finding.errors);
  add_text("alone", finding.alone);
  add("controller", quoted(finding.controller));
  add_text("directory", finding.directory);
  if (!finding.subject.name.empty()) add("capabilities", write_capabilities(finding.subject));
  add("seed", quoted(finding.seed));
  if (!finding.target.empty()) {
    add("target", quoted(finding.target));
    add("executions", std::to_string(finding.executions));
    add("seconds", Json(finding.seconds).dump());
  }
  add("tool", quoted(finding.tool));
  add("first_case", quoted(finding.first_case));
  add("occurrences", std::to_string(finding.occurrences));
  add("seen", std::to_string(finding.seen));
  add("tried", std::to_string(finding.tried));
  add_text("not_settled", finding.not_settled);
  if (!finding.before.empty()) {
    std::string cases;
    for (const spec::Case& c : finding.before) cases += (cases.empty() ? "\n  " : ",\n  ") + spec::write_case_line(c);
    add("before", "[" + cases + "]");
  }
  add("case", spec::write_case_line(finding.smallest));
  return out + "}\n";
}

Finding read_finding(std::string_view text, const std::string& file) {
  const Node root = spec::document::parse_json(text, file);
  const Reader read(file);
  Finding finding;
  if (root.find("finding") == nullptr) {
    finding.smallest = spec::case_from(root, read);
    finding.key.section = finding.smallest.section;
    finding.first_case = finding.smallest.id;
    return finding;
  }
  read.keys(root, "finding", {"finding",      "kind",         "clause", "line",       "field",       "expected",
                              "actual",       "deviation_um", "status", "errors",     "controller",  "directory",
                              "capabilities", "seed",         "tool",   "first_case", "occurrences", "seen",
                              "tried",        "before",       "case",   "target",     "executions",  "seconds",
                              "alone",        "not_settled",  "known",  "source",     "judged"});
  (void)read.integer(*root.find("finding"), "finding", 1, 1);
  finding.smallest = spec::case_from(read.needed(root, "case"), read);
  finding.key = {finding.smallest.section, text_of(root, "clause", read), text_of(root, "kind", read)};
  judge::Difference& d = finding.difference;
  d.kind = finding.key.kind.starts_with("law ") ? "law" : finding.key.kind;
  d.clause = spec::find_clause(finding.key.clause);
  d.line = count_of(root, "line", read, 0);
  d.field = text_of(root, "field", read);
  d.expected = text_of(root, "expected", read);
  d.actual = text_of(root, "actual", read);
  d.deviation_um = number_of(root, "deviation_um", read);
  finding.status = text_of(root, "status", read);
  finding.errors = text_of(root, "errors", read);
  finding.alone = text_of(root, "alone", read);
  finding.controller = text_of(root, "controller", read);
  finding.directory = text_of(root, "directory", read);
  if (const Node* capabilities = given(root, "capabilities")) {
    read.expect(*capabilities, Kind::table, "capabilities");
    finding.subject = capabilities_from(spec::tree_of(*capabilities, read));
  }
  // Both are said anew, by the clauses that are built in.
  if (const std::string known = text_of(root, "known", read); !known.empty() && !spec::find_known(known))
    read.fail(root.find("known")->at, "known: must be manual, sister, recollection or ours");
  (void)text_of(root, "source", read);
  if (const Node* judged = given(root, "judged")) finding.subject.known = known_of(*judged, read);
  finding.seed = text_of(root, "seed", read);
  finding.target = text_of(root, "target", read);
  finding.executions = count_of(root, "executions", read, 0);
  finding.seconds = number_of(root, "seconds", read);
  finding.tool = text_of(root, "tool", read);
  finding.first_case = text_of(root, "first_case", read);
  finding.occurrences = count_of(root, "occurrences", read, 1);
  finding.seen = count_of(root, "seen", read, 1);
  finding.tried = count_of(root, "tried", read, 1);
  finding.not_settled = text_of(root, "not_settled", read);
  if (const Node* before = given(root, "before")) {
    read.expect(*before, Kind::array, "before");
    for (const Node& item : before->items) finding.before.push_back(spec::case_from(item, read));
  }
  return finding;
}

}  // namespace toolcomp::certify

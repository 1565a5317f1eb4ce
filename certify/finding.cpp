#include "certify/finding.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "certify/controller.h"
#include "certify/event_fields.h"
#include "spec/language/byte_source.h"
#include "spec/language/case_format.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 15> kKeys{"finding",  "kind",   "clause",       "line",        "field",
                                                 "expected", "actual", "deviation_um", "errors",      "controller",
                                                 "seed",     "tool",   "first_case",   "occurrences", "case"};

// The end of the JSON string that begins at `i` (its opening quote): behind its closing quote.
std::size_t skip_string(std::string_view text, std::size_t i) {
  for (++i; i < text.size() && text[i] != '"'; ++i)
    if (text[i] == '\\') ++i;
  return std::min(i + 1, text.size());
}

// The text of the member `name` of the object `text`, which is valid JSON: the case keeps its digits as they were
// written, which a JSON library that reads numbers as doubles would not.
std::string_view member_text(std::string_view text, std::string_view name) {
  int depth = 0;
  std::string_view last_string;
  std::size_t begin = std::string_view::npos;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"') {
      const std::size_t end = skip_string(text, i);
      last_string = text.substr(i + 1, end - i - 2);
      i = end;
      continue;
    }
    if (c == ':' && depth == 1 && last_string == name) begin = i + 1;
    if (begin != std::string_view::npos && depth == 1 && (c == ',' || c == '}')) return text.substr(begin, i - begin);
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') --depth;
    ++i;
  }
  return {};
}

// The text before `part` with nothing but its line ends, then `part`: what stands in it keeps its line and column.
std::string in_its_place(std::string_view text, std::string_view part) {
  std::string placed(text.substr(0, static_cast<std::size_t>(part.data() - text.data())));
  std::ranges::replace_if(placed, [](char c) { return c != '\n'; }, ' ');
  return placed += part;
}

class Fields {
 public:
  Fields(const Json& json, std::string_view text, const std::string& file) : json_(json), text_(text), file_(file) {}

  // At the value of the member `key`, or at the object itself.
  [[noreturn]] void fail(const std::string& key, const std::string& what) const {
    const std::string_view value = member_text(text_, key);
    std::size_t at = value.empty() ? text_.find('{') : static_cast<std::size_t>(value.data() - text_.data());
    at = std::min(text_.find_first_not_of(" \t\r\n", at), text_.size());
    const std::string_view before = text_.substr(0, at);
    const std::size_t line_end = before.rfind('\n');
    throw spec::InputError(file_, static_cast<std::uint64_t>(std::ranges::count(before, '\n')) + 1,
                           line_end == std::string_view::npos ? at + 1 : at - line_end, what);
  }

  [[nodiscard]] std::string text(const char* key) const {
    const auto entry = json_.find(key);
    if (entry == json_.end() || entry->is_null()) return {};
    if (!entry->is_string()) fail(key, std::string(key) + " must be a string");
    return entry->get<std::string>();
  }
  [[nodiscard]] std::uint64_t count(const char* key, std::uint64_t otherwise) const {
    const auto entry = json_.find(key);
    if (entry == json_.end()) return otherwise;
    if (!entry->is_number_unsigned()) fail(key, std::string(key) + " must be a whole number");
    return entry->get<std::uint64_t>();
  }
  [[nodiscard]] double number(const char* key) const {
    const auto entry = json_.find(key);
    if (entry == json_.end() || entry->is_null()) return 0;
    if (!entry->is_number()) fail(key, std::string(key) + " must be a number");
    return entry->get<double>();
  }

 private:
  const Json& json_;
  std::string_view text_;
  const std::string& file_;
};

// Whether the field of the finding is still announced and still not sent.
void replay_never_sent(Replay& replay, Subject& subject) {
  const auto capabilities = subject.capabilities();
  const auto field = spec::find_field(replay.finding.field);
  const auto* const able = std::get_if<Capabilities>(&capabilities);
  if (able == nullptr || !field) return;
  const bool announced = std::ranges::find(able->fields, replay.finding.field) != able->fields.end();
  const Answer answer = subject.run(replay.finding.smallest);
  if (!announced || !std::holds_alternative<TextEvents>(answer.result) || answer.sent.has(*field)) return;
  replay.judgement.result = Result::differs;
  replay.key = replay.finding.key;
}

}  // namespace

std::string write_finding(const Finding& finding) {
  const auto quoted = [](const std::string& text) {
    return Json(text).dump(-1, ' ', true, Json::error_handler_t::replace);
  };
  std::string out = "{\"finding\": 1";
  const auto add = [&out](std::string_view key, const std::string& value) {
    out += ",\n \"" + std::string(key) + "\": " + value;
  };
  add("kind", quoted(finding.key.kind));
  add("clause", finding.key.clause.empty() ? "null" : quoted(finding.key.clause));
  add("line", std::to_string(finding.line));
  add("field", quoted(finding.field));
  add("expected", quoted(finding.expected));
  add("actual", quoted(finding.actual));
  add("deviation_um", Json(finding.deviation_um).dump());
  if (!finding.errors.empty()) add("errors", quoted(finding.errors));
  add("controller", quoted(finding.controller));
  add("seed", quoted(finding.seed));
  add("tool", quoted(finding.tool));
  add("first_case", quoted(finding.first_case));
  add("occurrences", std::to_string(finding.occurrences));
  add("case", spec::write_case_line(finding.smallest));
  return out + "}\n";
}

Finding read_finding(std::string_view text, const std::string& file) {
  const Json json = Json::parse(text, nullptr, false);
  Finding finding;
  // Not JSON at all, or a bare case: the reader of cases says what is wrong, and where.
  if (!json.is_object() || !json.contains("finding")) {
    finding.smallest = spec::read_case(text, file);
    finding.key.section = finding.smallest.section;
    finding.first_case = finding.smallest.id;
    return finding;
  }
  const Fields fields(json, text, file);
  for (const auto& [key, value] : json.items())
    if (std::ranges::find(kKeys, key) == kKeys.end()) fields.fail(key, "unknown key \"" + key + "\" in a finding");
  if (json["finding"] != 1) fields.fail("finding", "finding must be 1");
  if (!json.contains("case")) fields.fail("case", "a finding needs a case");
  finding.smallest = spec::read_case(in_its_place(text, member_text(text, "case")), file);
  finding.key = {finding.smallest.section, fields.text("clause"), fields.text("kind")};
  finding.line = fields.count("line", 0);
  finding.field = fields.text("field");
  finding.expected = fields.text("expected");
  finding.actual = fields.text("actual");
  finding.deviation_um = fields.number("deviation_um");
  finding.errors = fields.text("errors");
  finding.controller = fields.text("controller");
  finding.seed = fields.text("seed");
  finding.tool = fields.text("tool");
  finding.first_case = fields.text("first_case");
  finding.occurrences = fields.count("occurrences", 1);
  return finding;
}

std::unique_ptr<Subject> subject_of(const std::string& controller, std::chrono::milliseconds timeout,
                                    std::size_t reply_limit) {
  if (controller.empty()) return built_in_engine();
  ControllerOptions options;
  options.command = controller;
  options.timeout = timeout;
  options.reply_limit = reply_limit;
  return std::make_unique<Controller>(std::move(options));
}

Replay replay(const std::filesystem::path& file, const ReplayOptions& options) {
  Replay result;
  result.finding = read_finding(spec::read_file(file), file.string());
  const spec::Case& c = result.finding.smallest;
  const fuzz::ModelRun run = fuzz::run_model(c);
  const std::unique_ptr<Subject> subject =
      subject_of(options.controller.value_or(result.finding.controller), options.timeout);
  const auto capabilities = subject->capabilities();
  if (const auto* failure = std::get_if<Fault>(&capabilities))
    result.judgement = judge_answer({}, c, run, {*failure, {}, {}});
  else
    result.judgement = judge_case(*subject, std::get<Capabilities>(capabilities), c, run);
  result.key = key_of(c, result.judgement);
  if (result.finding.key.kind == kNeverSent) replay_never_sent(result, *subject);
  return result;
}

int exit_status(Result result) {
  switch (result) {
    case Result::agrees:
      return 0;
    case Result::differs:
      return 1;
    default:
      return 3;
  }
}

}  // namespace toolcomp::certify

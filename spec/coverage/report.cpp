// SPDX-License-Identifier: Apache-2.0
#include "spec/coverage/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <map>

#include "spec/language/edit_distance.h"
#include "spec/language/input_error.h"
#include "spec/language/json_text.h"
#include "spec/language/known.h"

namespace toolcomp::spec {
namespace {

constexpr std::array<std::string_view, 5> kKinds{"normative", "parameter", "alarm", "open", "note"};
constexpr std::array<std::string_view, 3> kOutcomes{"sign", "fact", "reach"};

std::string_view kind_name(ClauseKind kind) { return kKinds.at(static_cast<std::size_t>(kind)); }

// Appends JSON members and elements with their commas.
class Json {
 public:
  Json& open(char bracket) {
    comma();
    out_ += bracket;
    first_ = true;
    return *this;
  }
  Json& close(char bracket) {
    out_ += bracket;
    first_ = false;
    return *this;
  }
  Json& key(std::string_view name) {
    comma();
    append_json_string(out_, name);
    out_ += ':';
    first_ = true;
    return *this;
  }
  Json& value(std::string_view text) {
    comma();
    append_json_string(out_, text);
    return *this;
  }
  Json& value(std::uint64_t number) {
    comma();
    append_integer(out_, number);
    return *this;
  }
  Json& value(bool truth) {
    comma();
    out_ += truth ? "true" : "false";
    return *this;
  }
  // A member, left out where it is empty.
  Json& member(std::string_view name, std::string_view text) { return text.empty() ? *this : key(name).value(text); }
  template <class List>
  Json& members(std::string_view name, const List& list) {
    if (list.empty()) return *this;
    key(name).open('[');
    for (const auto& item : list) value(std::string_view(item));
    return close(']');
  }
  // Elements of the outermost array stand on lines of their own.
  Json& line() {
    if (!first_) out_ += ',';
    out_ += '\n';
    first_ = true;
    return *this;
  }
  std::string take() { return std::move(out_) + "\n"; }

 private:
  void comma() {
    if (!first_) out_ += ',';
    first_ = false;
  }

  std::string out_;
  bool first_ = true;
};

void append_clause(Json& json, const ClauseInfo& c) {
  json.open('{')
      .member("id", c.id)
      .member("section", c.section)
      .member("file", c.file)
      .member("kind", kind_name(c.kind));
  json.key("source").open('{').member("known", known_name(c.known)).member("document", c.document);
  json.member("edition", c.edition).member("page", c.page).member("words", c.words).close('}');
  json.member("text", c.text).member("formula", c.formula).members("notation", items(c.notation));
  json.members("parameters", items(c.parameters)).members("alternatives", items(c.alternatives));
  json.member("outcomes", kOutcomes.at(static_cast<std::size_t>(c.outcomes)));
  if (!c.positive.empty()) {
    const bool fact = c.outcomes == ClauseOutcomes::fact;
    json.key("outcome_text").open('{').member(fact ? "true" : "positive", c.positive);
    json.member(fact ? "false" : "negative", c.negative).member("tie", c.tie).close('}');
  }
  json.key("testable").value(c.testable).member("reason", c.reason);
  json.members("unreachable", items(c.unreachable)).member("unreachable_reason", c.unreachable_reason);
  json.members("replaced_by", items(c.replaced_by)).close('}');
}

// Ids for somebody who wrote another: those it is a part of, or else those of the nearest family ("fanuc.cutter" of
// "fanuc.cutter.on") with the nearest last part first.
std::vector<std::string_view> nearest_ids(std::string_view id) {
  constexpr std::size_t kShown = 5;
  std::vector<std::string_view> ids;
  for (const ClauseInfo& c : clauses())
    if (c.id.find(id) != std::string_view::npos) ids.push_back(c.id);
  const auto family = [](std::string_view whole) { return whole.substr(0, whole.rfind('.')); };
  const auto last = [](std::string_view whole) { return whole.substr(whole.rfind('.') + 1); };
  if (ids.empty() && id.find('.') != std::string_view::npos) {
    const auto distance = [&](const ClauseInfo& c) { return edit_distance(family(id), family(c.id)); };
    const std::string_view nearest = family(std::ranges::min_element(clauses(), {}, distance)->id);
    for (const ClauseInfo& c : clauses())
      if (family(c.id) == nearest) ids.push_back(c.id);
    std::ranges::sort(ids, {},
                      [&](std::string_view other) { return std::pair(edit_distance(last(id), last(other)), other); });
  }
  if (ids.size() > kShown) ids.resize(kShown);
  return ids;
}

[[noreturn]] void fail_unknown(std::string_view id) {
  std::string message = "no clause has this id";
  const std::vector<std::string_view> ids = nearest_ids(id);
  for (std::size_t i = 0; i < ids.size(); ++i)
    message += (i == 0 ? "; did you mean " : i + 1 == ids.size() ? " or " : ", ") + std::string(ids[i]);
  throw InputError(std::string(id), 0, 0, message + (ids.empty() ? "; `toolcomp spec list` lists them" : "?"));
}

Json& append_known(Json& json, const KnownCounts& counts) {
  json.key("known").open('{');
  for (const Known known : kAllKnown) json.key(known_name(known)).value(counts.of(known));
  return json.close('}');
}

std::string mention_text(const std::vector<Mention>& mentions) {
  std::string text;
  for (const Mention& m : mentions) text += fmt::format("{}{}:{}", text.empty() ? "" : ", ", m.file, m.line);
  return text;
}

// The first ids and how many more there are.
std::string vector_text(const std::vector<std::string>& ids) {
  constexpr std::size_t kShown = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, ids.size()); ++i) text += (i == 0 ? "" : ", ") + ids[i];
  if (ids.size() > kShown) text += fmt::format(" and {} more", ids.size() - kShown);
  return text;
}

// Section, total, and how many of it are known how well; rows of a table.
std::string known_table(const std::vector<std::pair<std::string_view, KnownCounts>>& sections) {
  std::string out = fmt::format("{:<32} {:>9}", "section", "clauses");
  for (const Known known : kAllKnown) out += fmt::format(" {:>12}", known_name(known));
  out += '\n';
  for (const auto& [section, counts] : sections) {
    out += fmt::format("{:<32} {:>9}", section, counts.total());
    for (const Known known : kAllKnown) out += fmt::format(" {:>12}", counts.of(known));
    out += '\n';
  }
  return out;
}

void append_line(std::string& out, std::string_view name, std::string_view text) {
  if (!text.empty()) out += fmt::format("  {:<13} {}\n", name, text);
}

}  // namespace

std::string list_clauses(ReportFormat format) {
  if (format == ReportFormat::json) {
    Json json;
    json.open('[');
    for (const ClauseInfo& c : clauses()) append_clause(json.line(), c);
    return json.close(']').take();
  }
  std::string out;
  for (const ClauseInfo& c : clauses())
    out += fmt::format("{:<55} {:<9}  {:<12}  {}\n", c.id, kind_name(c.kind), known_name(c.known), c.text);
  return out;
}

std::string show_clause(std::string_view id, ReportFormat format) {
  const std::optional<Clause> found = find_clause(id);
  if (!found) fail_unknown(id);
  const ClauseInfo& c = info(*found);
  if (format == ReportFormat::json) {
    Json json;
    append_clause(json, c);
    return json.take();
  }
  std::string out = fmt::format("{}\n", c.id);
  append_line(out, "section", c.section);
  append_line(out, "kind", kind_name(c.kind));
  append_line(out, "source", cited(c));
  append_line(out, "text", c.text);
  append_line(out, "formula", c.formula);
  for (const std::string_view symbols : items(c.notation)) append_line(out, "notation", symbols);
  append_line(out, "parameters", fmt::format("{}", fmt::join(items(c.parameters), ", ")));
  for (const std::string_view alternative : items(c.alternatives)) append_line(out, "alternative", alternative);
  const bool fact = c.outcomes == ClauseOutcomes::fact;
  append_line(out, fact ? "true" : "positive", c.positive);
  append_line(out, fact ? "false" : "negative", c.negative);
  append_line(out, "tie", c.tie);
  if (!c.testable) append_line(out, "not testable", c.reason);
  for (const std::string_view outcome : items(c.unreachable))
    append_line(out, "unreachable", fmt::format("{}: {}", outcome, c.unreachable_reason));
  append_line(out, "replaced by", c.replaced_by);
  return out;
}

std::string list_sections(ReportFormat format) {
  std::vector<std::string_view> sections;
  std::map<std::string_view, std::array<std::uint64_t, kKinds.size()>> kinds;
  const auto known = known_by_section([](Clause) { return true; });
  const auto of_section = [&known](std::string_view section) {
    return std::ranges::find(known, section, &std::pair<std::string_view, KnownCounts>::first)->second;
  };
  for (const ClauseInfo& c : clauses()) {
    if (!kinds.contains(c.section)) sections.push_back(c.section);
    ++kinds[c.section].at(static_cast<std::size_t>(c.kind));
  }
  if (format == ReportFormat::json) {
    Json json;
    json.open('[');
    for (const std::string_view section : sections) {
      json.line().open('{').member("section", section);
      for (std::size_t i = 0; i < kKinds.size(); ++i) json.key(kKinds.at(i)).value(kinds[section].at(i));
      append_known(json, of_section(section)).close('}');
    }
    return json.close(']').take();
  }
  std::string out = fmt::format("{:<32} {:>9}", "section", "clauses");
  for (const std::string_view kind : kKinds) out += fmt::format(" {:>9}", kind);
  out += '\n';
  for (const std::string_view section : sections) {
    std::uint64_t sum = 0;
    for (const std::uint64_t count : kinds[section]) sum += count;
    out += fmt::format("{:<32} {:>9}", section, sum);
    for (const std::uint64_t count : kinds[section]) out += fmt::format(" {:>9}", count);
    out += '\n';
  }
  const KnownCounts sum = sum_of(known);
  return out + fmt::format("\n{}\nof {} clauses, {}\n", known_table(known), sum.total(), sum.words());
}

std::string show_trace(std::span<const ClauseTrace> table, ReportFormat format) {
  if (format == ReportFormat::json) {
    Json json;
    json.open('[');
    for (std::size_t i = 0; i < table.size(); ++i) {
      const ClauseTrace& row = table[i];
      json.line().open('{').member("id", clauses()[i].id).key("needs_mark").value(needs_mark(clauses()[i]));
      for (const auto& [name, list] : {std::pair{"model", &row.model}, std::pair{"tests", &row.tests}}) {
        json.key(name).open('[');
        for (const Mention& m : *list)
          json.open('{').member("file", m.file).key("line").value(std::uint64_t{m.line}).close('}');
        json.close(']');
      }
      json.members("theorems", row.theorems).members("vectors", row.vectors).close('}');
    }
    return json.close(']').take();
  }
  std::string out;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const ClauseTrace& row = table[i];
    const ClauseInfo& c = clauses()[i];
    out += fmt::format("{} ({})\n", c.id, kind_name(c.kind));
    append_line(out, "model", row.model.empty() && needs_mark(c) ? "NOT MARKED" : mention_text(row.model));
    append_line(out, "theorems", fmt::format("{}", fmt::join(row.theorems, ", ")));
    append_line(out, "tests", mention_text(row.tests));
    append_line(out, "vectors", vector_text(row.vectors));
    if (!c.testable) append_line(out, "not testable", c.reason);
  }
  return out;
}

std::string show_coverage(std::span<const OutcomeCounts> counts, std::uint64_t runs, std::span<const ProofCount> proofs,
                          ReportFormat format) {
  const std::vector<ClauseOutcome> outcomes = required_outcomes(counts);
  const auto exercised = known_by_section([&](Clause clause) {
    const OutcomeCounts& count = counts[static_cast<std::size_t>(clause)];
    return needs_mark(info(clause)) && count.reached + count.positive + count.negative + count.tie > 0;
  });
  const auto reached = static_cast<std::uint64_t>(
      std::ranges::count_if(outcomes, [](const ClauseOutcome& outcome) { return outcome.count != 0; }));
  if (format == ReportFormat::json) {
    Json json;
    json.open('{').key("runs").value(runs).key("outcomes").value(std::uint64_t{outcomes.size()});
    json.key("reached").value(reached).key("clauses").open('[');
    for (const ClauseOutcome& outcome : outcomes)
      json.line()
          .open('{')
          .member("id", info(outcome.clause).id)
          .member("outcome", outcome.name)
          .key("count")
          .value(outcome.count)
          .close('}');
    json.close(']').key("proofs").open('[');
    for (const ProofCount& proof : proofs)
      json.line()
          .open('{')
          .member("section", proof.section)
          .key("vectors")
          .value(std::uint64_t{proof.vectors})
          .key("proven")
          .value(std::uint64_t{proof.proven})
          .close('}');
    json.close(']').key("sections").open('[');
    for (const auto& [section, known] : exercised)
      append_known(json.line().open('{').member("section", section), known).close('}');
    return json.close(']').close('}').take();
  }
  std::string out = fmt::format("{} runs; {} of {} outcomes reached\n", runs, reached, outcomes.size());
  for (const ClauseOutcome& outcome : outcomes) {
    const std::string count = outcome.count == 0 ? "NEVER" : std::to_string(outcome.count);
    out += fmt::format("{:>9}  {:<55} {:<9}{}{}\n", count, info(outcome.clause).id, outcome.name,
                       outcome.text.empty() ? "" : " ", outcome.text);
  }
  const KnownCounts known = sum_of(exercised);
  out += fmt::format("\n{}\nof {} clauses exercised, {}\n", known_table(exercised), known.total(), known.words());
  if (!proofs.empty()) out += "\ngolden vectors of which Coq proves every number (./dev proofs)\n";
  for (const ProofCount& proof : proofs)
    out += fmt::format("{:>4} of {:>4}  {}\n", proof.proven, proof.vectors, proof.section);
  return out;
}

}  // namespace toolcomp::spec

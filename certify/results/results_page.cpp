// SPDX-License-Identifier: Apache-2.0
// The table of several certificates, as a page and as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "certify/certificate.h"
#include "certify/markup.h"
#include "certify/page.h"
#include "certify/results/results.h"
#include "spec/clauses/clauses.h"
#include "spec/language/known.h"

namespace toolcomp::certify::results {
namespace {

// Findings of a section that stand open; a wrong controller has dozens.
constexpr std::uint64_t kAtOnce = 5;

std::string coded(std::string_view text) { return "<code>" + escape(text) + "</code>"; }

std::string row_name(std::string_view section) { return section.empty() ? "own programs" : std::string(section); }

// The id of what is said of controller `index` in a section: "c1-fanuc-tool-offset".
std::string anchor(std::size_t index, std::string_view section) {
  std::string id = fmt::format("c{}-{}", index + 1, section.empty() ? "own" : section);
  std::ranges::replace(id, '/', '-');
  return id;
}

Tone tone_of(Standing standing) {
  switch (standing) {
    case Standing::conforms:
    case Standing::by_design:
      return Tone::good;
    case Standing::finding:
      return Tone::bad;
    default:
      return Tone::open;
  }
}

// The class of the style that page() has.
std::string_view class_of(Standing standing) {
  switch (tone_of(standing)) {
    case Tone::good:
      return "good";
    case Tone::bad:
      return "bad";
    case Tone::open:
      break;
  }
  return standing == Standing::not_applicable ? "soft" : "open";
}

std::string counted(std::uint64_t n, std::string_view what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

std::string told(std::string_view text) { return text.empty() ? "not stated" : escape(text); }

// "LinuxCNC rs274 2.9 (2026-11-29)", each a link to what is said of it.
std::string first_line(std::span<const Controller> controllers) {
  std::string out = "<p>";
  for (std::size_t i = 0; i < controllers.size(); ++i) {
    const Controller& c = controllers[i];
    out += fmt::format(R"({}<a href="#c{}">{}</a>)", i == 0 ? "" : "; ", i + 1, escape(c.title()));
    if (c.version.empty()) out += ", version not stated";
    out += c.date.empty() ? ", date not stated" : ", certified " + escape(c.date);
  }
  return out + ".</p>\n";
}

std::string in_table(const Controller& c, std::size_t index, const std::string& section) {
  const Cell& cell = c.cell(section);
  if (cell.standing == Standing::not_asked) return "<span class=\"soft\">not asked</span>";
  return fmt::format(R"(<a class="{}" href="#{}">{}</a>)", class_of(cell.standing), anchor(index, section),
                     words(cell));
}

std::string the_table(std::span<const Controller> controllers) {
  std::vector<Row> all{{"section"}};
  for (const Controller& c : controllers) all[0].push_back(escape(c.title()));
  for (const std::string& section : rows(controllers)) {
    Row row{section.empty() ? row_name(section) : coded(section)};
    for (std::size_t i = 0; i < controllers.size(); ++i) row.push_back(in_table(controllers[i], i, section));
    all.push_back(std::move(row));
  }
  return table(all);
}

std::string legend() {
  return "<details><summary>What the words mean</summary>\n" +
         facts({{"conforms", "every case that was judged agrees with the exact model"},
                {"differs by design",
                 "the same; in other cases the controller says, or its adapter does, that it does otherwise by design: "
                 "these are counted and not judged"},
                {"findings", "the controller does otherwise than a clause says, and nobody calls that its design"},
                {"partly judged", "no finding, and more was left unjudged than a certificate of conformity permits"},
                {"not decided", "no finding, and the model could not decide, or nothing was judged"},
                {"not applicable", "the controller does not have this section"},
                {"not asked", "the certificate does not speak of it"}}) +
         "</details>\n";
}

std::string clause_of(const ToldFinding& finding) {
  if (finding.clause.empty()) return "";
  std::string out = ". Clause " + coded(finding.clause);
  const auto clause = spec::find_clause(finding.clause);
  if (!clause) return out + (finding.source.empty() ? "" : " (" + escape(finding.source) + ")");
  const spec::ClauseInfo& info = spec::info(*clause);
  return out + " <span class=\"soft\">(" + escape(spec::cited(info)) + ")</span>: " + escape(info.text);
}

std::string cell_details(const Controller& c, std::size_t index, const std::string& section) {
  const Cell& cell = c.cell(section);
  std::string out = fmt::format("<h3 id=\"{}\">{} {}</h3>\n<p>", anchor(index, section), escape(row_name(section)),
                                badge(words(cell), tone_of(cell.standing)));
  out += counted(cell.cases, "case") + (cell.cases == 1 ? " applies" : " apply");
  if (cell.cases > 0) out += fmt::format(", {} agree", cell.agree);
  if (cell.values > 0) out += "; " + counted(cell.values, "value") + " compared";
  if (cell.not_applicable > 0) out += "; " + counted(cell.not_applicable, "case") + " not applicable";
  out += (cell.why.empty() ? "" : "; " + escape(cell.why)) + ".</p>\n";
  std::string items;
  for (const auto& [id, cases] : cell.known_differences) {
    const auto reason = c.differences.find(id);
    items += "<li>" + words_by_design(cases, "case") + ": " + coded(id) +
             (reason == c.differences.end() ? "" : ". " + escape(reason->second)) + "</li>\n";
  }
  std::uint64_t shown = 0;
  std::string more;
  for (const ToldFinding& finding : c.findings) {
    if (finding.section != section) continue;
    (++shown <= kAtOnce ? items : more) +=
        "<li>" + escape(finding.what) + "; " + counted(finding.cases, "case") + clause_of(finding) + "</li>\n";
  }
  if (cell.findings > shown) more += "<li>" + counted(cell.findings - shown, "finding") + " not shown here</li>\n";
  if (!items.empty()) out += "<ul>\n" + items + "</ul>\n";
  if (!more.empty())
    out += fmt::format("<details><summary>{}</summary><ul>\n{}</ul></details>\n",
                       counted(cell.findings - std::min(shown, kAtOnce), "more finding"), more);
  if (cell.clauses.empty()) return out;
  out += fmt::format("<details><summary>{} judged by</summary><p>", counted(cell.clauses.size(), "clause"));
  for (std::size_t i = 0; i < cell.clauses.size(); ++i) out += (i == 0 ? "" : ", ") + coded(cell.clauses[i]);
  return out + "</p></details>\n";
}

std::string controller_details(const Controller& c, std::size_t index, const std::vector<std::string>& sections) {
  const Tone tone = c.exit_status == 0 ? Tone::good : c.exit_status == 3 ? Tone::open : Tone::bad;
  std::string out =
      fmt::format("<h2 id=\"c{}\">{}</h2>\n<p>{}</p>\n", index + 1, escape(c.title()), badge(c.verdict, tone));
  std::string fields;
  for (const std::string& field : c.fields_not_judged) fields += (fields.empty() ? "" : ", ") + coded(field);
  out += facts({{"version", told(c.version)},
                {"date", told(c.date)},
                {"serial number", told(c.serial)},
                {"tool", told(c.tool)},
                {"golden corpus", c.corpus.empty() ? "none" : escape(c.corpus)},
                {"judged by", c.judged_by.empty() ? "all clauses" : "clauses known as " + escape(c.judged_by)},
                {"fields not judged", fields.empty() ? "none" : fields},
                {"certificate", coded(c.folder)}});
  for (const ToldCause& cause : c.causes)
    out += "<p>" + counted(cause.findings, "finding") + " in " + counted(cause.cases, "case") +
           (cause.findings == 1 ? " looks" : " look") + " like: " + escape(cause.words) + ".</p>\n";
  for (const std::string& section : sections)
    if (c.cell(section).standing != Standing::not_asked) out += cell_details(c, index, section);
  return out;
}

nlohmann::ordered_json to_json(const Cell& cell) {
  nlohmann::ordered_json json{{"standing", name(cell.standing)}};
  if (cell.standing == Standing::not_asked) return json;
  json["cases"] = cell.cases;
  json["agree"] = cell.agree;
  json["not_applicable"] = cell.not_applicable;
  json["findings"] = cell.findings;
  json["values"] = cell.values;
  json["why"] = cell.why;
  json["known_differences"] = nlohmann::ordered_json(cell.known_differences);
  json["clauses"] = cell.clauses;
  return json;
}

}  // namespace

std::string page(std::span<const Controller> controllers) {
  const std::vector<std::string> sections = rows(controllers);
  std::string body =
      "<h1>Results of controllers</h1>\n" + first_line(controllers) +
      "<p class=\"soft\">From certificates as they stand: <code>toolcomp verify</code> checks the evidence "
      "of one. A word in the table leads to what it rests on.</p>\n" +
      the_table(controllers) + legend();
  for (std::size_t i = 0; i < controllers.size(); ++i) body += controller_details(controllers[i], i, sections);
  return certify::page("toolcomp: results of controllers", body);
}

std::string json(std::span<const Controller> controllers) {
  using Json = nlohmann::ordered_json;
  const std::vector<std::string> sections = rows(controllers);
  Json json{{"results", 1}, {"sections", sections}, {"controllers", Json::array()}};
  for (const Controller& c : controllers) {
    Json one{{"folder", c.folder},
             {"name", c.name},
             {"version", c.version},
             {"date", c.date},
             {"serial", c.serial},
             {"verdict", c.verdict},
             {"exit_status", c.exit_status},
             {"tool", c.tool},
             {"corpus", c.corpus},
             {"judged_by", c.judged_by},
             {"fields_not_judged", c.fields_not_judged},
             {"cells", Json::object()},
             {"findings", Json::array()},
             {"causes", Json::array()},
             {"known_differences", Json(c.differences)}};
    for (const std::string& section : sections) one["cells"][section] = to_json(c.cell(section));
    for (const ToldFinding& finding : c.findings)
      one["findings"].push_back({{"section", finding.section},
                                 {"clause", finding.clause},
                                 {"source", finding.source},
                                 {"what", finding.what},
                                 {"cases", finding.cases}});
    for (const ToldCause& cause : c.causes)
      one["causes"].push_back({{"cause", cause.words}, {"findings", cause.findings}, {"cases", cause.cases}});
    json["controllers"].push_back(std::move(one));
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace toolcomp::certify::results

// SPDX-License-Identifier: Apache-2.0
// The page of a certificate.
#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "certify/convert.h"
#include "certify/markup.h"
#include "certify/page.h"
#include "certify/path_svg.h"
#include "certify/report.h"
#include "certify/view/view.h"
#include "fuzz/gen/generator.h"
#include "judge/oracle/policy.h"
#include "spec/language/known.h"
#include "spec/language/setup_format.h"

namespace toolcomp::certify {
namespace {

std::string code(std::string_view text) { return "<code>" + escape(text) + "</code>"; }

std::string count(std::uint64_t n) { return std::to_string(n); }

std::string section_name(std::string_view section) { return section.empty() ? "own programs" : std::string(section); }

// A distance that may be far below a micrometre.
std::string small(double value) { return value == 0 ? "0" : fmt::format("{:.3g}", value); }

Tone tone_of(const Certificate& c) {
  const int status = exit_status(c);
  return status == 0 ? Tone::good : status == 3 ? Tone::open : Tone::bad;
}

std::string list_of(const std::vector<std::string>& items) {
  std::string out;
  for (const std::string& item : items) out += (out.empty() ? "" : ", ") + code(item);
  return out.empty() ? "none" : out;
}

std::string subject_name(const Certificate& c) {
  if (c.subject.name.empty()) return c.identity.controller.empty() ? "the built-in fast engine" : c.identity.controller;
  return c.subject.version.empty() ? c.subject.name : c.subject.name + " " + c.subject.version;
}

SectionResult all_sections(const Certificate& c) {
  SectionResult all;
  for (const SectionResult& s : c.sections) {
    for (std::size_t i = 0; i < all.cases.size(); ++i) all.cases.at(i) += s.cases.at(i);
    for (std::size_t i = 0; i < all.results.size(); ++i) all.results.at(i) += s.results.at(i);
    all.values += s.values;
    all.wide += s.wide;
    all.wide_cases += s.wide_cases;
    all.cut_cases += s.cut_cases;
    all.out_of_scope += s.out_of_scope;
    all.events += s.events;
    all.left_out += s.left_out;
    all.few_events += s.few_events;
    all.ties += s.ties;
    all.near_ties += s.near_ties;
    all.worst_ulp = std::max(all.worst_ulp, s.worst_ulp);
    all.worst_um = std::max(all.worst_um, s.worst_um);
    all.bias.add(s.bias);
  }
  return all;
}

std::string plural(std::uint64_t n, std::string_view what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

// What the verdict says nothing about: HTML, an item each.
std::vector<std::string> not_judged(const Certificate& c, const SectionResult& all) {
  std::vector<std::string> items;
  if (const std::string left_out = words_on_left_out(c); !left_out.empty())
    items.push_back("<span class=\"bad\">" + escape(left_out) + "</span> (<a href=\"#left-out\">which</a>)");
  if (const std::uint64_t not_run = cases_not_run(c); not_run > 0 || !c.interrupted.empty())
    items.push_back(fmt::format("<span class=\"bad\">{} not run{}</span>", plural(not_run, "case"),
                                c.interrupted.empty() ? "" : ": " + escape(c.interrupted)));
  std::vector<std::string> not_applicable;
  for (const SectionResult& s : c.sections)
    if (!s.section.empty() && s.total() > 0 && s.count(Result::not_applicable) == s.total())
      not_applicable.push_back(s.section);
  if (!not_applicable.empty()) items.push_back("not applicable, as the controller says: " + list_of(not_applicable));
  for (const auto& [id, cases] : known_differences(c)) {
    const auto reason = c.known_reasons.find(id);
    items.push_back(plural(cases, "case") + " that the controller does otherwise by design, as it says: " + code(id) +
                    (reason == c.known_reasons.end() ? "" : ". " + escape(reason->second)));
  }
  std::vector<std::string> not_asked;
  for (const std::string_view section : fuzz::sections())
    if (std::ranges::find(c.sections, section, &SectionResult::section) == c.sections.end())
      not_asked.emplace_back(section);
  if (!not_asked.empty()) items.push_back("not asked for: " + list_of(not_asked));
  const std::vector<std::string> fields = fields_not_judged(c.subject);
  if (!fields.empty()) items.push_back("event fields that the controller does not announce: " + list_of(fields));
  if (const std::uint64_t undecided = all.count(Result::undecided); undecided > 0)
    items.push_back(plural(undecided, "case") + " that the oracle could not decide");
  if (all.wide > 0)
    items.push_back(
        fmt::format("{} values with a tolerance of more than {} µm ({} cases have more than {} % of such values)",
                    all.wide, judge::policy::kCap, all.wide_cases, 100 * judge::policy::kMostWide));
  if (all.cut_cases > 0)
    items.push_back("the end of " + plural(all.cut_cases, "case") +
                    ", from the first word that is not supported or not judged");
  if (all.out_of_scope > 0) items.push_back(plural(all.out_of_scope, "event") + " after a block that is out of scope");
  if (const std::size_t clauses = clauses_not_exercised(c).size(); clauses > 0)
    items.push_back("<a href=\"#not-exercised\">" + plural(clauses, "clause") + " not exercised</a>");
  return items;
}

std::string told(const std::string& text) { return text.empty() ? "not stated" : escape(text); }

std::string identity(const Certificate& c) {
  const Identity& id = c.identity;
  const std::string golden =
      id.corpus_hash.empty() ? escape(id.corpus) : escape(id.corpus) + " " + code(id.corpus_hash);
  const bool unnamed = c.subject.name.empty();
  return facts({{"controller", unnamed ? escape(subject_name(c)) : escape(c.subject.name)},
                {"its version", told(c.subject.version)},
                {"its serial number", told(c.occasion.serial)},
                {"its command", id.controller.empty() ? "none: it runs in this process" : code(id.controller)},
                {"resolution", escape(c.subject.resolution.words())},
                {"fields judged", list_of(c.subject.fields)},
                {"fixed settings", c.subject.setup.empty() ? "none" : code(c.subject.setup)},
                {"date", told(c.occasion.date)},
                {"operator", told(c.occasion.operated)},
                {"command line", c.occasion.arguments.empty() ? "not stated" : code(c.occasion.arguments)},
                {"seed", count(id.seed) + fmt::format(", {} generated cases in each section", id.generated)},
                {"tool", escape(id.tool) + " " + code(id.tool_hash)},
                {"clause set", code(id.clause_hash)},
                {"golden corpus", golden},
                {"setups", fmt::format("{} different ones {}", id.setups, code(id.setup_hash))}}) +
         "<p class=\"soft\">Hashes are SHA-256. The same tool, seed and corpus give the same certificate, except for "
         "the date and for findings that there was no time to settle.</p>\n";
}

// For the one who signs: it stands alone on its sheet of paper.
std::string first_page(const Certificate& c) {
  const SectionResult all = all_sections(c);
  std::string out = "<section class=\"first\">\n<h1>Certificate of " + escape(subject_name(c)) + "</h1>\n<p>" +
                    badge(verdict(c), tone_of(c)) + "</p>\n";
  if (!c.self_check.empty())
    out += "<p class=\"bad\">The self-check of the harness failed: " + escape(c.self_check) + ".</p>\n";
  out += fmt::format(
      "<p>Judged: {}. Compared with the exact model: {} in {}. {} agree, {} differ in {}, {} could not be decided. {} "
      "values were compared. The worst accepted value is {} µm ({} ulp) outside its exact enclosure.</p>\n",
      escape(scope(c)), plural(all.total(), "case"), plural(c.sections.size(), "section"), all.count(Result::agrees),
      all.count(Result::differs), plural(c.findings.size(), "finding"), all.count(Result::undecided), all.values,
      small(all.worst_um), small(all.worst_ulp));
  out += "<p id=\"rests-on\">What it rests on: " + escape(words_on_known(c)) + ".</p>\n";
  if (all.bias.count > 0)
    out += fmt::format(
        "<p>{} rounded lengths differ from the exact ones by {:+.3g} µm on average, the worst by {:+.3g} µm. With "
        "rounding to nearest the average is 0, with rounding down it is half an increment.</p>\n",
        all.bias.count, all.bias.mean(), all.bias.worst);
  if (!c.chatter.empty())
    out += "<p class=\"soft\">The controller writes lines on its standard output that are not answers: " +
           code(c.chatter) + ".</p>\n";
  if (!c.without_effect.empty())
    out += "<p>Codes that were read and have no effect on what is judged: " +
           list_of({c.without_effect.begin(), c.without_effect.end()}) + ".</p>\n";
  out += "<h2 id=\"not-judged\">Not judged</h2>\n<ul>\n";
  const std::vector<std::string> items = not_judged(c, all);
  for (const std::string& item : items) out += "<li>" + item + "</li>\n";
  if (items.empty()) out += "<li>none: everything that was asked for was judged</li>\n";
  out += "</ul>\n<h2 id=\"identity\">Identity</h2>\n" + identity(c);
  out += std::string(kSignature) + "</section>\n";
  out += R"(<nav><a href="#sections">Sections</a><a href="#findings">Findings</a>)";
  if (!c.pictures.empty()) out += R"(<a href="#programs">Programs</a>)";
  return out + "<a href=\"#clauses\">Clauses</a></nav>\n";
}

std::string sections(const Certificate& c) {
  std::vector<Row> cases{{"section", "golden", "generated", "own", "agree", "differ", "undecided", "nothing judged",
                          "not applicable", "not run", "more than 1 % not judged", "fewer than three events"}};
  std::vector<Row> values{{"section", "values", "not judged", "out of scope", "decisions", "near ties", "ties",
                           "worst µm", "worst ulp", "permitted ulp", "proved for the fast engine"}};
  std::vector<std::string> not_applicable;
  for (const SectionResult& s : c.sections) {
    if (s.count(Result::not_applicable) == s.total()) {
      not_applicable.push_back(s.section);
      continue;
    }
    Row row{code(section_name(s.section)), count(s.count(Origin::golden)), count(s.count(Origin::generated)),
            count(s.count(Origin::own))};
    for (const Result result : {Result::agrees, Result::differs, Result::undecided, Result::nothing_judged,
                                Result::not_applicable, Result::not_run})
      row.push_back(count(s.count(result)));
    row.push_back(count(s.wide_cases));
    row.push_back(count(s.few_events));
    cases.push_back(std::move(row));
    values.push_back({code(section_name(s.section)), count(s.values), count(s.wide), count(s.out_of_scope),
                      count(s.decisions), count(s.near_ties), count(s.ties), small(s.worst_um), small(s.worst_ulp),
                      plain(judge::policy::budget(s.section).coordinate),
                      escape(judge::policy::budget(s.section).proved)});
  }
  std::string out = "<h2 id=\"sections\">Sections</h2>\n<h3>Cases</h3>\n" + table(cases, 1) +
                    "<h3>Values judged in these cases</h3>\n" + table(values, 1);
  if (!not_applicable.empty()) out += "<p>Not applicable: " + list_of(not_applicable) + ".</p>\n";
  out +=
      "<p class=\"soft\">A near tie is a decision whose exact margin is inside the band that double precision (or the "
      "resolution of the controller) cannot resolve. A tie is a near tie at which the controller took the other, "
      "permitted outcome. An exact tie between sums of decimals counts as neither: the controller must decide it as "
      "its clause says.</p>\n";
  if (c.unsettled.empty()) return out;
  std::vector<Row> unsettled{{"case", "section", "result", "why"}};
  for (const Unsettled& u : c.unsettled)
    unsettled.push_back({code(u.id), code(section_name(u.section)), escape(name(u.result)), escape(u.why)});
  return out + "<h3>Cases without a verdict</h3>\n" + table(unsettled);
}

// The text of a clause, its formula, and what the symbols in them mean.
std::string words_of(const spec::ClauseInfo& info) {
  std::string out = escape(info.text);
  if (!info.formula.empty()) out += " <code>" + escape(info.formula) + "</code>";
  std::string symbols;
  for (const std::string_view each : spec::items(info.notation)) {
    const std::size_t colon = each.find(": ");
    symbols += (symbols.empty() ? "" : "; ") + code(each.substr(0, colon)) + " " + escape(each.substr(colon + 2));
  }
  return symbols.empty() ? out : out + " <span class=\"soft\">Here " + symbols + ".</span>";
}

std::string clause_words(const Finding& f) {
  const auto clause = spec::find_clause(f.key.clause);
  if (!clause) return "<p>No clause was applied before the difference.</p>\n";
  const spec::ClauseInfo& info = spec::info(*clause);
  return "<p>Clause " + code(info.id) + " <span class=\"soft\">(" + escape(kind_name(info.kind)) + "; " +
         escape(spec::cited(info)) + ")</span>: " + words_of(info) + "</p>\n";
}

std::string finding(const Finding& f, std::size_t index) {
  std::string out = fmt::format("<article id=\"finding-{}\">\n<h3>{}. {} <span class=\"soft\">in {}</span></h3>\n",
                                index + 1, index + 1, escape(f.key.kind), escape(section_name(f.key.section)));
  out += clause_words(f) + "<p>" + escape(explanation(f)) + "</p>\n";
  const judge::Difference& d = f.difference;
  std::vector<Row> rows{{"field", code(d.field)}, {"expected", code(d.expected)}, {"actual", code(d.actual)}};
  if (d.deviation_um != 0) rows.push_back({"deviation", escape(small(d.deviation_um)) + " µm"});
  rows.push_back({"cases", fmt::format("{}, the first {}", f.occurrences, code(f.first_case))});
  if (!f.not_settled.empty()) rows.push_back({"not settled", escape(f.not_settled)});
  if (!f.status.empty()) rows.push_back({"the process", escape(f.status)});
  if (!f.before.empty())
    rows.push_back({"earlier requests", fmt::format("{} cases, listed in the file", f.before.size())});
  if (f.seen < f.tried) rows.push_back({"reproduced", fmt::format("in {} of {} runs", f.seen, f.tried)});
  rows.push_back({"judge again", code("toolcomp replay findings/" + file_name(f, index))});
  out += facts(rows);
  out += listing(f.smallest.program, d.line);
  out += "<details><summary>Setup</summary><pre>" + escape(spec::write_setup_toml(f.smallest.setup)) +
         "</pre></details>\n";
  if (!f.errors.empty())
    out +=
        "<details><summary>Standard error of the controller</summary><pre>" + escape(f.errors) + "</pre></details>\n";
  PathOptions options = path_options(f.smallest);
  options.other = f.actual_events;
  options.marked = d.event;
  const auto expected = in_doubles(judge::run_model(f.smallest).events);
  out += view(fmt::format("Finding {}", index + 1), f.smallest, view_run(f.smallest, expected), {options, {}},
              path_svg(expected, f.smallest.setup.axes, options));
  if (!f.complete) out += "<p class=\"soft\">Not shrunk completely: a smaller program may fail too.</p>\n";
  return out + "</article>\n";
}

std::string known_word(const std::string& id) {
  const auto clause = spec::find_clause(id);
  return clause ? escape(spec::known_name(spec::info(*clause).known)) : "—";
}

// Its row among all findings; where another stands for its group, that is all there is of it.
Row finding_row(const Finding& f, std::size_t index, bool shown) {
  const std::string number = shown ? fmt::format("<a href=\"#finding-{0}\">{0}</a>", index + 1)
                                   : fmt::format("<span id=\"finding-{0}\">{0}</span>", index + 1);
  return {number,
          code(section_name(f.key.section)),
          f.key.clause.empty() ? "—" : code(f.key.clause),
          known_word(f.key.clause),
          escape(f.key.kind),
          f.not_settled.empty() ? "yes" : "no: " + escape(f.not_settled),
          code("findings/" + file_name(f, index)),
          count(f.occurrences)};
}

std::string findings(const Certificate& c) {
  std::string out = "<h2 id=\"findings\">Findings</h2>\n";
  if (c.findings.empty()) return out + "<p>None.</p>\n";
  std::vector<bool> shown(c.findings.size(), c.causes.empty());
  if (!c.causes.empty()) {
    std::vector<Row> causes{{"likely cause", "findings", "cases", "findings, the representative one first"}};
    for (const SharedCause& cause : c.causes) {
      shown[cause.findings.front()] = true;
      std::string links;
      for (const std::size_t i : cause.findings) links += fmt::format("<a href=\"#finding-{0}\">{0}</a> ", i + 1);
      causes.push_back({escape(cause.words), count(cause.findings.size()), count(cause.cases), links});
    }
    out +=
        table(causes) +
        "<p class=\"soft\">Each cause explains its findings completely, but another mistake may look the same. " +
        escape(words_on_settling(c)) +
        ". A settled finding was reproduced and shrunk. The other findings are recorded as they were first seen.</p>\n";
  }
  std::vector<Row> rows{{"", "section", "clause of first divergence", "known", "kind", "settled", "file", "cases"}};
  for (std::size_t i = 0; i < c.findings.size(); ++i) rows.push_back(finding_row(c.findings[i], i, shown[i]));
  out += table(rows, 7);
  for (std::size_t i = 0; i < c.findings.size(); ++i)
    if (shown[i]) out += finding(c.findings[i], i);
  return out;
}

// The exact paths of the user's own programs.
std::string programs(const Certificate& c) {
  if (c.pictures.empty()) return {};
  std::string out = "<h2 id=\"programs\">Programs</h2>\n<p class=\"soft\">The exact paths that the model gives.</p>\n";
  for (const Picture& picture : c.pictures) out += "<h3>" + code(picture.id) + "</h3>\n" + picture.html;
  return out;
}

std::string outcome(const spec::ClauseInfo& clause, std::uint64_t n, spec::ClauseOutcomes least) {
  return clause.outcomes <= least ? count(n) : std::string("·");
}

// The clauses of one section with their outcomes.
std::string clause_table(const Certificate& c, std::string_view section) {
  std::vector<Row> rows{{"clause", "kind", "known", "text", "reached", "+ / true", "− / false", "tie"}};
  std::size_t reached = 0;
  for (std::size_t i = 0; i < spec::clauses().size() && i < c.clauses.size(); ++i) {
    const spec::ClauseInfo& info = spec::clauses()[i];
    if (info.section != section || !info.replaced_by.empty()) continue;
    const model::ClauseCount& n = c.clauses[i];
    reached += n.reached > 0 ? 1 : 0;
    std::string text = words_of(info);
    if (!info.testable) text += " <span class=\"soft\">(not testable: " + escape(info.reason) + ")</span>";
    rows.push_back({code(info.id), escape(kind_name(info.kind)), escape(spec::known_name(info.known)), text,
                    n.reached > 0 ? count(n.reached) : "<span class=\"open\">0</span>",
                    outcome(info, n.positive, spec::ClauseOutcomes::fact),
                    outcome(info, n.negative, spec::ClauseOutcomes::fact),
                    outcome(info, n.tie, spec::ClauseOutcomes::sign)});
  }
  if (rows.size() == 1) return {};
  return fmt::format("<details open=\"open\"><summary>{}: {} of {} clauses exercised</summary>\n", code(section),
                     reached, rows.size() - 1) +
         table(rows, 4) + "</details>\n";
}

std::string clause_list(std::string_view id, std::string_view title, std::string_view note,
                        const std::vector<spec::Clause>& clauses) {
  std::string out = "<h3 id=\"" + escape(id) + "\">" + escape(title) + "</h3>\n";
  if (clauses.empty()) return out + "<p>None.</p>\n";
  out += "<p class=\"soft\">" + escape(note) + "</p>\n<ul>\n";
  for (const spec::Clause clause : clauses)
    out += "<li>" + code(spec::info(clause).id) + ": " + escape(spec::info(clause).text) + "</li>\n";
  return out + "</ul>\n";
}

// How well the clauses judged are known, by section.
std::string known_table(const Certificate& c) {
  std::vector<Row> rows{{"section", "clauses", "manual", "sister", "recollection", "ours"}};
  for (const auto& [section, counts] : known_clauses(c)) {
    Row row{code(section), count(counts.total())};
    for (const spec::Known known : spec::kAllKnown) row.push_back(count(counts.of(known)));
    rows.push_back(std::move(row));
  }
  return "<h3>What they rest on</h3>\n<p>" + escape(words_on_known(c)) +
         ".</p>\n<p class=\"soft\">manual: a page of a manual of this control was seen. sister: a page of another "
         "series was seen, or of another vendor with the same rule. recollection: the text of a section, from memory. "
         "ours: our definition.</p>\n" +
         table(rows, 1);
}

// Clauses on which events rest that were not judged.
std::string left_out(const Certificate& c) {
  const std::string words = words_on_left_out(c);
  if (words.empty()) return {};
  std::vector<Row> rows{{"clause", "known", "events"}};
  for (const auto& [clause, events] : left_out_for(c))
    rows.push_back({code(spec::info(clause).id), escape(spec::cited(spec::info(clause))), count(events)});
  return "<h3 id=\"left-out\">Left out</h3>\n<p>" + escape(words) +
         ". An event may rest on several clauses. If the controller differs in an event that is left out, the events "
         "after it are left out too, without a clause of their own.</p>\n" +
         table(rows, 2);
}

std::string clauses(const Certificate& c) {
  std::string out = "<h2 id=\"clauses\">Clauses</h2>\n" + known_table(c) + left_out(c);
  std::vector<std::string_view> shown;
  for (std::size_t i = 0; i < spec::clauses().size() && i < c.clauses.size(); ++i) {
    const std::string_view section = spec::clauses()[i].section;
    const bool named = std::ranges::find(c.sections, section, &SectionResult::section) != c.sections.end();
    if ((named || c.clauses[i].reached > 0) && std::ranges::find(shown, section) == shown.end())
      shown.push_back(section);
  }
  for (const std::string_view section : shown) out += clause_table(c, section);
  out += clause_list("not-exercised", "Clauses not exercised", "The certificate says nothing about these.",
                     clauses_not_exercised(c));
  return out + clause_list("open", "Open clauses relied on",
                           "The manual does not decide these. The result rests on our own definition.",
                           open_clauses_relied_on(c));
}

}  // namespace

std::string html_report(const Certificate& certificate) {
  return page("toolcomp certificate: " + verdict(certificate), first_page(certificate) + sections(certificate) +
                                                                   findings(certificate) + programs(certificate) +
                                                                   clauses(certificate));
}

}  // namespace toolcomp::certify

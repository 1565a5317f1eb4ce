// SPDX-License-Identifier: Apache-2.0
// Reports: well-formed, escaped, complete.
#include "certify/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>

#include "certify/certification.h"
#include "certify/convert.h"
#include "certify/label_places.h"
#include "certify/markup.h"
#include "certify/path_svg.h"
#include "certify/view/tool_shapes.h"
#include "judge/oracle/verdict.h"
#include "spec/language/byte_source.h"
#include "spec/language/known.h"

namespace toolcomp::certify {
namespace {

// std::regex goes a level deeper for every character: of a value in quotes nothing but a < counts.
std::string with_empty_values(const std::string& tag) {
  std::string out;
  bool quoted = false;
  for (const char c : tag) {
    if (c == '"') quoted = !quoted;
    if (!quoted || c == '"' || c == '<') out += c;
  }
  return out;
}

// <script> elements without what is in them.
std::string without_scripts(std::string text) {
  for (std::size_t at = text.find("<script"); at != std::string::npos; at = text.find("<script", at + 1)) {
    const std::size_t begin = text.find('>', at) + 1;
    text.erase(begin, text.find("</script>", begin) - begin);
  }
  return text;
}

// The data of the view in a page.
nlohmann::json view_data(const std::string& html) {
  const std::string begin = "<script type=\"application/json\">";
  const std::size_t at = html.find(begin) + begin.size();
  return nlohmann::json::parse(html.substr(at, html.find("</script>", at) - at));
}

// Reads XML far enough to know that every element is closed, in order, that attributes are quoted and once each, and
// that no bare `<` or `&` is left. What is wrong, or empty. HTML written as XML passes but for its doctype, its <style>
// and its scripts.
std::string malformed(std::string text) {
  static const std::regex kProlog(R"(^(<\?xml[^>]*\?>|<!DOCTYPE html>)\s*)");
  text = std::regex_replace(without_scripts(text), kProlog, "");
  std::vector<std::string> open;
  std::size_t i = 0;
  static const std::regex kEntity(R"(&(amp|lt|gt|quot|#39);)");
  static const std::regex kTag(R"(^<(/?)([a-zA-Z][a-zA-Z0-9]*)((\s+[a-zA-Z][-a-zA-Z]*="[^"<]*")*)\s*(/?)>)");
  while (i < text.size()) {
    if (text[i] == '<') {
      std::smatch tag;
      const std::string rest = text.substr(i, std::min<std::size_t>(text.size() - i, text.find('>', i) - i + 1));
      const std::string short_rest = with_empty_values(rest);
      if (!std::regex_search(short_rest, tag, kTag)) return "bad tag: " + rest.substr(0, 80);
      const std::string name = tag[2];
      if (tag[1].length() > 0) {
        if (open.empty() || open.back() != name) return "closed but not open: " + name;
        open.pop_back();
      } else if (tag[5].length() == 0) {
        open.push_back(name);
      }
      i += rest.length();
    } else if (text[i] == '&') {
      std::smatch entity;
      const std::string rest = text.substr(i, 8);
      if (!std::regex_search(rest, entity, kEntity) || entity.position() != 0) return "bare &: " + rest;
      i += static_cast<std::size_t>(entity[0].length());
    } else {
      if (open.empty() && text[i] != '\n' && text[i] != ' ') return "text outside the root";
      ++i;
    }
  }
  return open.empty() ? "" : "never closed: " + open.back();
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

// A certificate with one finding whose texts are hostile.
Certificate example() {
  Certificate c;
  c.identity = {"toolcomp 0.1.0", "aaaa", clause_set_hash(), "1.2.3", "bbbb", "cccc", 4, 17, 200, "./cnc '<script>'"};
  c.subject.name = "CNC <3000> & \"Co\"";
  c.subject.fields = {"kind", "line", "axes"};
  c.subject.sections = {"fanuc/tool-length-offset"};
  c.subject.resolution.mm = "0.001";
  c.clauses.resize(spec::kClauseCount);
  c.sections.push_back({});
  SectionResult& s = c.sections.back();
  s.section = "fanuc/tool-length-offset";
  s.cases = {3, 200, 0};
  s.results = {202, 1, 0, 0, 0, 0};
  s.values = 4321;
  s.ties = 5;
  s.near_ties = 7;
  s.worst_um = 0.25;
  s.worst_ulp = 1.5;
  Finding f;
  f.smallest.section = s.section;
  f.smallest.setup.h[1] = {spec::decimal(20), {}};
  f.smallest.program = "N10 G90 G43 Z100. H1 (a <b> & \"c\")\nN20 G01 X10. Y5. F100\n";
  for (std::size_t i = 0; i < spec::kClauseCount; ++i)
    if (spec::clauses()[i].section == s.section) {
      c.clauses[i] = {9, 4, 5, 0};
      f.key.clause = spec::clauses()[i].id;
      break;
    }
  f.key.section = s.section;
  f.key.kind = "coordinate";
  f.difference.line = 1;
  f.difference.field = "axes.Z";
  f.difference.expected = "120";
  f.difference.actual = "-120";
  f.difference.deviation_um = 240000;
  f.errors = "]]> </pre><script>alert(1)</script>";
  f.first_case = "fanuc.tool-length-offset.seed-17.3";
  f.actual_events = in_doubles(judge::run_model(f.smallest).events);
  f.actual_events.at(0).axes.set(2, -120);
  c.findings.push_back(f);
  // Another one of the same group, as it was seen.
  f.not_settled = "finding 1 represents its group";
  f.smallest.program = "(not shown)\n" + f.smallest.program;
  f.key.kind = "missing event";
  f.seen = f.tried = 0;
  c.findings.push_back(f);
  c.causes = {{"Z of every position has the opposite sign", {0, 1}, 2}};
  c.settling = std::chrono::seconds(30);
  return c;
}

TEST(Report, HtmlIsWellFormedAndSelfContained) {
  const std::string html = html_report(example());
  EXPECT_EQ(malformed(html), "");
  EXPECT_FALSE(has(html, "<script>alert"));
  EXPECT_TRUE(has(html, "default-src 'none'"));
  const std::string written = without_scripts(html);
  EXPECT_FALSE(has(written, "<link"));
  EXPECT_FALSE(has(written, "src="));
  EXPECT_FALSE(has(written, "href=\"http"));
  EXPECT_FALSE(has(written, "url("));
  EXPECT_TRUE(has(html, "prefers-color-scheme:dark"));
  EXPECT_TRUE(has(html, "@media print"));
  EXPECT_TRUE(has(html, "width=device-width"));
}

// The scripts of a page: data of the one finding, and what draws it. Without anything to draw there is none.
TEST(Report, HtmlHasTheViewOnlyWhereThereIsSomethingToDraw) {
  Certificate c = example();
  EXPECT_EQ(count(html_report(c), "<script"), 2U);
  c.findings.clear();
  EXPECT_EQ(count(html_report(c), "<script"), 0U);
}

// Two blocks; in the first the controller's Z is -120 where 120 is due, and the clauses of the length offset decided.
TEST(Report, TheViewOfAFindingHasBothPathsAndTheClauses) {
  const std::string html = html_report(example());
  const auto data = view_data(html);
  EXPECT_EQ(data["unit"], "mm");
  EXPECT_EQ(data["compared"], "axes");
  EXPECT_EQ(data["marked"], 0);
  ASSERT_EQ(data["steps"].size(), 2U);
  const auto& step = data["steps"][0];
  EXPECT_EQ(step["line"], 1);
  EXPECT_EQ(step["n"], 10);
  EXPECT_EQ(step["text"], "N10 G90 G43 Z100. H1 (a <b> & \"c\")");
  EXPECT_EQ(step["programmed"], nlohmann::json::parse("[[0,0,100]]"));
  EXPECT_EQ(step["axes"], nlohmann::json::parse("[[0,0,120]]"));
  EXPECT_EQ(step["other"], nlohmann::json::parse("[[0,0,-120]]"));
  EXPECT_TRUE(step["rapid"]);
  std::vector<std::string> clauses;
  for (const auto& clause : step["clauses"]) clauses.push_back(data["clauses"][clause.get<std::size_t>()][0]);
  EXPECT_NE(std::ranges::find(clauses, "fanuc.length-offset.direction"), clauses.end());
  // What it was read from cannot end its element.
  const std::size_t at = html.find("application/json");
  EXPECT_EQ(html.substr(at, html.find("</script>", at) - at).find_first_of("<&"), std::string::npos);
}

// A cutter of 5 mm, 100 long from the second block on; without D there is no shape.
TEST(ToolShapes, FollowTheOffsetNumbersInForce) {
  spec::Case c;
  c.setup.d[1] = {spec::decimal(5), {}};
  c.setup.h[2] = {spec::decimal(100), {}};
  c.program = "G90 G01 X1. F100\nG41 D1 X2.\nG43 H2 Z1.\nX9.\nD0 G40 X10.\n";
  const ToolShapes shapes(c);
  EXPECT_EQ(shapes.at(1), std::nullopt);
  EXPECT_EQ(shapes.at(2), (ToolShape{5, 0, 0, "D1"}));
  EXPECT_EQ(shapes.at(4), (ToolShape{5, 0, 100, "D1 H2"}));
  EXPECT_EQ(shapes.at(5), std::nullopt);
}

// A ball of 3 mm with deltas of -0.1 in the table and +0.3 of its length.
TEST(ToolShapes, OfATableHaveTheirDeltas) {
  spec::Case c;
  c.setup.control = spec::Control::heidenhain;
  spec::ToolRow row;
  row.number = 10;
  row.r = row.r2 = spec::decimal(3);
  row.dr = row.dr2 = spec::parse_decimal("-0.1").value();
  row.l = spec::decimal(80);
  c.setup.tools.push_back(row);
  c.program = "TOOL CALL 1 Z\nL X+10 R0 F500\n";
  const auto shape = ToolShapes(c).at(2);
  ASSERT_TRUE(shape);
  EXPECT_DOUBLE_EQ(shape->radius, 2.9);
  EXPECT_DOUBLE_EQ(shape->corner, 2.9);
  EXPECT_DOUBLE_EQ(shape->length, 80);
}

TEST(LabelPlaces, NoneCoversAnother) {
  LabelPlaces places(100, 10);
  const Point2 middle{50, 50};
  std::vector<Point2> taken;
  while (const auto at = places.beside(middle, 2, 2)) taken.push_back(*at);
  // Right and left of it, above and below.
  ASSERT_EQ(taken.size(), 4U);
  for (std::size_t i = 0; i < taken.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_TRUE(std::abs(taken[i].first - taken[j].first) >= 10 || std::abs(taken[i].second - taken[j].second) >= 10);
  EXPECT_EQ(places.beside({98, 50}, 20, 2), std::nullopt) << "wider than the paper has room";
}

TEST(Report, HtmlSaysEverythingACertificateMust) {
  Certificate c = example();
  c.occasion = {"2026-01-02T03:04:05+0100", "A. Body", "SN 4711", "toolcomp certify 'x y'"};
  const std::string html = html_report(c);
  for (const std::string& part : {std::string("does not conform"),
                                  c.identity.clause_hash,
                                  std::string("aaaa"),
                                  std::string("bbbb"),
                                  std::string("cccc"),
                                  std::string("1.2.3"),
                                  std::string("17, 200 generated"),
                                  c.occasion.date,
                                  c.occasion.operated,
                                  c.occasion.serial,
                                  std::string("toolcomp certify &#39;x y&#39;"),
                                  std::string("Signature"),
                                  std::string("1 of 13 sections, 12 not asked for"),
                                  std::string("0.001"),
                                  std::string("tool_axis"),
                                  std::string("0.25"),
                                  std::string("1.5"),
                                  std::string("4321"),
                                  c.findings[0].key.clause,
                                  std::string("2.4e+05 µm"),
                                  std::string("<svg"),
                                  std::string("toolcomp replay findings/01-coordinate.json"),
                                  std::string("Z of every position has the opposite sign"),
                                  std::string("1 of 1 group settled, within 30 s"),
                                  std::string("no: finding 1 represents its group"),
                                  std::string("findings/02-missing-event.json"),
                                  std::string("Clauses not exercised"),
                                  std::string("Open clauses relied on"),
                                  std::string("CNC &lt;3000&gt; &amp; &quot;Co&quot;"),
                                  std::string("N10 G90 G43 Z100. H1 (a &lt;b&gt; &amp; &quot;c&quot;)")})
    EXPECT_TRUE(has(html, part)) << part;
  // Every clause of the section with its text.
  for (const spec::ClauseInfo& clause : spec::clauses())
    if (clause.section == "fanuc/tool-length-offset" && clause.replaced_by.empty()) {
      EXPECT_TRUE(has(html, escape(clause.text))) << clause.id;
    }
}

TEST(Report, JunitHasACaseForEveryClause) {
  const std::string xml = junit_report(example());
  EXPECT_EQ(malformed(xml), "");
  EXPECT_TRUE(has(xml, "failures=\"1\""));  // of clauses: both are findings of one
  EXPECT_TRUE(has(xml, "Not settled: finding 1 represents its group"));
  EXPECT_TRUE(has(xml, "<skipped"));
  for (const spec::ClauseInfo& clause : spec::clauses())
    if (clause.section == "fanuc/tool-length-offset" && clause.testable && clause.kind != spec::ClauseKind::note &&
        clause.replaced_by.empty()) {
      EXPECT_TRUE(has(xml, "name=\"" + std::string(clause.id) + "\"")) << clause.id;
    }
}

TEST(Report, JsonIsComplete) {
  const auto json = nlohmann::json::parse(json_report(example()));
  EXPECT_EQ(json["verdict"], "does not conform");
  EXPECT_EQ(json["exit_status"], 1);
  EXPECT_EQ(json["identity"]["seed"], 17);
  EXPECT_EQ(json["sections"][0]["values"], 4321);
  EXPECT_EQ(json["findings"][0]["file"], "findings/01-coordinate.json");
  EXPECT_EQ(json["findings"][0]["settled"], true);
  EXPECT_EQ(json["findings"][1]["settled"], false);
  EXPECT_EQ(json["findings"][1]["not_settled"], "finding 1 represents its group");
  EXPECT_EQ(json["causes"][0]["cases"], 2);
  EXPECT_EQ(json["settling"], nlohmann::json::parse(R"({"seconds": 30.0, "groups": 1, "settled": 1})"));
  EXPECT_FALSE(json["clauses_not_exercised"].empty());
  // One clause was reached, that of the findings.
  const Certificate c = example();
  const spec::ClauseInfo& clause = spec::info(*spec::find_clause(c.findings[0].key.clause));
  const std::string known(spec::known_name(clause.known));
  EXPECT_EQ(json["findings"][0]["known"], known);
  EXPECT_EQ(json["findings"][0]["source"], spec::cited(clause));
  EXPECT_EQ(json["known"]["clauses"][known], 1);
  EXPECT_EQ(json["known"]["sections"]["fanuc/tool-length-offset"][known], 1);
  EXPECT_EQ(json["known"]["sections"].size(), 1U);
  EXPECT_EQ(json["left_out"],
            nlohmann::json::parse(R"({"judged": ["manual", "sister", "recollection", "ours"], "clauses": {}})"));
  EXPECT_FALSE(json["controller"]["fields_not_judged"].empty());
}

// What --known leaves out is said on the first page and counted by clause; a section of which nothing is left is no
// section judged.
TEST(Report, SaysWhatWasLeftOut) {
  Certificate c = example();
  c.findings.clear();
  c.causes.clear();
  c.sections[0].results = {203, 0, 0, 0, 0, 0};
  EXPECT_EQ(words_on_left_out(c), "");
  EXPECT_TRUE(verdict(c).starts_with("conforms in 1 of ")) << verdict(c);
  EXPECT_EQ(verdict(c).find("judged only by"), std::string::npos);
  const spec::Clause first = *spec::find_clause(example().findings[0].key.clause);
  const spec::Clause other = *spec::find_clause("fanuc.program.own-move");
  c.subject.known = spec::KnownSet::of({"manual", "sister"});
  c.sections[0].events = 70;
  c.sections[0].left_out = 30;
  c.sections[0].left_out_for = {{first, 10}, {other, 25}};
  EXPECT_EQ(words_on_left_out(c),
            "30 of 100 events left out: they do not rest only on clauses known as manual, sister");
  EXPECT_TRUE(verdict(c).ends_with(", judged only by clauses known as manual, sister")) << verdict(c);
  EXPECT_EQ(exit_status(c), 0);
  const auto json = nlohmann::json::parse(json_report(c));
  EXPECT_EQ(json["left_out"]["clauses"]["fanuc.program.own-move"], 25);
  EXPECT_EQ(json["sections"][0]["events_left_out"], 30);
  const std::string html = html_report(c);
  EXPECT_EQ(malformed(html), "");
  EXPECT_TRUE(has(html, "30 of 100 events left out"));
  EXPECT_TRUE(has(html, "id=\"left-out\""));
  EXPECT_TRUE(has(html, "<code>fanuc.program.own-move</code>"));
  EXPECT_EQ(left_out_for(c).front().first, other) << "the most first";
  // A second section of which nothing was judged for this reason alone.
  c.sections.push_back(c.sections[0]);
  c.sections[1].section = "fanuc/tool-offset";
  c.sections[1].values = 0;
  EXPECT_EQ(exit_status(c), 0);
  EXPECT_NE(scope(c).find("1 of "), std::string::npos) << scope(c);
  EXPECT_NE(scope(c).find(", 1 left out"), std::string::npos) << scope(c);
  // Nothing judged at all is never a pass.
  c.sections.erase(c.sections.begin());
  EXPECT_EQ(exit_status(c), 3);
}

TEST(Report, IsWrittenWithItsFindingsAndWithoutThoseOfBefore) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "toolcomp-report";
  std::filesystem::remove_all(folder);
  Certificate c = example();
  EXPECT_EQ(write_report(c, folder).size(), 2U);
  EXPECT_TRUE(std::filesystem::exists(folder / "index.html"));
  EXPECT_TRUE(std::filesystem::exists(folder / "junit.xml"));
  EXPECT_TRUE(std::filesystem::exists(folder / "certificate.json"));
  EXPECT_EQ(read_finding(spec::read_file(folder / "findings" / "01-coordinate.json"), "f").key, c.findings[0].key);
  c.findings.clear();
  c.causes.clear();
  EXPECT_TRUE(write_report(c, folder).empty());
  EXPECT_FALSE(std::filesystem::exists(folder / "findings" / "01-coordinate.json"));
}

TEST(Report, VerdictsAndExitStatuses) {
  Certificate c = example();
  EXPECT_EQ(exit_status(c), 1);
  c.findings.clear();
  EXPECT_EQ(exit_status(c), 0);
  c.sections[0].results[static_cast<std::size_t>(Result::undecided)] = 1;
  EXPECT_EQ(exit_status(c), 3);
  c.sections[0].results[static_cast<std::size_t>(Result::undecided)] = 0;
  // One value of a hundred not judged is borne, two are not: named, and status 3.
  c.sections[0].values = 990;
  c.sections[0].wide = 10;
  EXPECT_EQ(exit_status(c), 0);
  c.sections[0].wide = 11;
  EXPECT_EQ(exit_status(c), 3);
  EXPECT_TRUE(has(std::string(verdict(c)), "not judged"));
  EXPECT_TRUE(has(html_report(c), "11 values with a tolerance of more than 1 µm"));
  EXPECT_EQ(nlohmann::json::parse(json_report(c))["sections"][0]["values_not_judged"], 11);
  EXPECT_TRUE(has(junit_report(c), "type=\"not judged\""));
  c.sections[0].wide = 0;
  c.sections[0].results[static_cast<std::size_t>(Result::partly_judged)] = 1;
  EXPECT_EQ(exit_status(c), 3);
  EXPECT_TRUE(has(std::string(verdict(c)), "not judged"));
  c.sections[0].results[static_cast<std::size_t>(Result::partly_judged)] = 0;
  // A section that does not apply needs no value, one of which a case applies does.
  SectionResult other;
  other.section = "fanuc/tool-offset";
  other.cases[0] = 5;
  other.results[static_cast<std::size_t>(Result::not_applicable)] = 5;
  c.sections.push_back(other);
  EXPECT_EQ(exit_status(c), 0);
  ++c.sections.back().cases[0];
  EXPECT_EQ(exit_status(c), 3);
  c.sections.pop_back();
  c.sections[0].values = 0;
  EXPECT_EQ(exit_status(c), 3);
  c.self_check = "broken";
  EXPECT_EQ(exit_status(c), 4);
  EXPECT_EQ(exit_status(Certificate{}), 3);
}

TEST(Report, OfATraceIsWellFormed) {
  TraceReport report;
  report.c.program = "G90 G01 X10. F100 (<&>)\nY10.\n";
  report.file = "trace <1>.csv";
  report.options.tolerance = 0.01;
  std::istringstream csv("X,Y\n0,0\n5,1\n10,0\n10,9\n");
  report.result = judge_trace(report.c, csv, report.file, report.options);
  const std::string html = html_report(report);
  EXPECT_EQ(malformed(html), "");
  EXPECT_TRUE(has(html, "off the path"));
  EXPECT_TRUE(has(html, "end not reached"));
  // Its pictures: the bump in red, both findings marked, the move with it red.
  EXPECT_TRUE(has(html, "class=\"tr-off\" d=\"M"));
  EXPECT_TRUE(has(html, ">2</text>"));
  EXPECT_TRUE(has(html, "class=\"tr-bad\""));
  EXPECT_EQ(malformed(junit_report(report)), "");
  const auto json = nlohmann::json::parse(json_report(report));
  EXPECT_EQ(json["findings_total"], 2);
  EXPECT_EQ(json["cause"], "");
}

// X and Y exchanged: the page and the file name the same mistake.
TEST(Report, OfATraceNamesTheCause) {
  TraceReport report;
  report.c.program = "G90 G01 X10. F100\nY5.\n";
  report.file = "trace.csv";
  report.options.tolerance = 0.01;
  std::istringstream csv("X,Y\n0,0\n0,10\n5,10\n");
  report.result = judge_trace(report.c, csv, report.file, report.options);
  EXPECT_TRUE(has(html_report(report), "axes X and Y are exchanged"));
  EXPECT_EQ(nlohmann::json::parse(json_report(report))["cause"], "axes X and Y are exchanged");
}

// Samples on a move that is judged at its end only are dotted, not red, and no bar counts them as off.
TEST(Report, OfATraceWithMovesThatAreNotJudgedInside) {
  TraceReport report;
  report.c.program = "G90 G00 X10. Y5.\nG01 X20. F100\n";
  report.file = "trace.csv";
  report.options.tolerance = 0.01;
  report.options.judge_rapids = false;
  std::istringstream csv("X,Y\n0,0\n5,5\n10,5\n20,5\n");
  report.result = judge_trace(report.c, csv, report.file, report.options);
  const std::string html = html_report(report);
  EXPECT_EQ(malformed(html), "");
  EXPECT_TRUE(has(html, "class=\"tr-free\" d=\"M"));
  EXPECT_TRUE(has(html, "<title>0 samples not on the path</title>"));
  EXPECT_TRUE(has(html, "without 2 samples on moves judged at their ends only"));
  EXPECT_EQ(count(html, "class=\"tr-off\" d="), 1U);  // the legend
}

TEST(Markup, EscapesWhatMarkupMeans) {
  EXPECT_EQ(escape("<a b=\"c\" d='e'>&"), "&lt;a b=&quot;c&quot; d=&#39;e&#39;&gt;&amp;");
  EXPECT_EQ(escape("µ\n\t"), "µ\n\t");
  EXPECT_EQ(escape(std::string("a\x01\xff\0b", 5)),
            "a\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD"
            "b");
  EXPECT_EQ(escape("\xEF\xBF\xBF"), "\xEF\xBF\xBD");
}

TEST(Markup, PlainNumbers) {
  EXPECT_EQ(plain(1.5), "1.5");
  EXPECT_EQ(plain(-0.0001), "0");
  EXPECT_EQ(plain(100), "100");
  EXPECT_EQ(plain(2.0 / 3), "0.667");
}

std::vector<spec::Event<double>> events(const spec::Case& c) {
  std::vector<spec::Event<double>> result;
  for (const model::Event& event : judge::run_model(c).events) result.push_back(in_double(event));
  return result;
}

TEST(PathSvg, DrawsBothPathsFromAboveAndFromTheSide) {
  spec::Case c;
  c.setup.h[1] = {spec::decimal(20), {}};
  c.program = "N10 G90 G43 Z100. H1\nN20 G01 X10. F100\n";
  const std::string svg = path_svg(events(c), c.setup.axes);
  EXPECT_EQ(malformed(svg), "");
  EXPECT_EQ(count(svg, "tp-paper\""), 2U);  // X and Z only: no axonometric view
  EXPECT_TRUE(has(svg, "axes, with length offset"));
  EXPECT_TRUE(has(svg, ">N20</text>"));
  EXPECT_TRUE(has(svg, "<title>N20 X10 Y0 Z100</title>"));
  EXPECT_FALSE(has(svg, "nan"));
}

TEST(PathSvg, ShowsACornerViewOfASolidPathAndAController) {
  spec::Case c;
  c.program = "G90 G01 X10. F100\nY10.\nZ-5.\nG17 G02 X0 Y0 I-5. J-5.\n";
  auto expected = events(c);
  auto actual = expected;
  actual[1].axes.set(1, 12);
  PathOptions options = path_options(c.setup);
  options.other = actual;
  options.other_name = "CNC <1>";
  options.marked = 1;
  const std::string svg = path_svg(expected, c.setup.axes, options);
  EXPECT_EQ(malformed(svg), "");
  EXPECT_EQ(count(svg, "tp-paper\""), 3U);
  EXPECT_EQ(count(svg, "\"tp-mark\""), 3U);
  EXPECT_TRUE(has(svg, "CNC &lt;1&gt;"));
}

// A tool (3/5, 0, 4/5) that runs along Y, 10 to the left or straight behind its programmed line.
std::vector<spec::Event<double>> tilted_moves(std::size_t count, const Point3& vector) {
  std::vector<spec::Event<double>> moves;
  for (std::size_t i = 1; i <= count; ++i) {
    spec::Event<double> e;
    e.line = i;
    e.tool_axis = {0.6, 0, 0.8};
    const Point3 end{0, static_cast<double>(i), 0};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      e.programmed.set(axis, end[axis]);
      e.point.set(axis, end[axis] + vector[axis]);
      e.axes.set(axis, end[axis] + vector[axis]);
    }
    moves.push_back(e);
  }
  return moves;
}

TEST(PathSvg, ShowsOnePlaceAlongATiltedTool) {
  const std::string svg = path_svg(tilted_moves(9, {-8, 0, 6}), spec::Axes("XYZ"));
  EXPECT_EQ(malformed(svg), "");
  EXPECT_EQ(count(svg, "tp-paper\""), 4U);
  EXPECT_EQ(count(svg, "\"tp-round\""), 1U);
  EXPECT_TRUE(has(svg, "along the tool at 5,"));
  EXPECT_TRUE(has(svg, "distance of the lines 10 mm"));
  EXPECT_TRUE(has(svg, "compensation vector"));
  PathOptions options;
  options.marked = 2;
  EXPECT_TRUE(has(path_svg(tilted_moves(9, {-8, 0, 6}), spec::Axes("XYZ"), options), "along the tool at 3,"));
}

TEST(PathSvg, AVectorAlongTheTravelHasNoPlaceBesideIt) {
  const std::string svg = path_svg(tilted_moves(9, {0, -10, 0}), spec::Axes("XYZ"));
  EXPECT_EQ(malformed(svg), "");
  EXPECT_EQ(count(svg, "tp-paper\""), 3U);
}

// What lies closer together than can be seen is left out.
TEST(PathSvg, LongPathsStaySmall) {
  constexpr std::size_t kMoves = 20'000;
  constexpr std::size_t kMost = 150'000;
  const std::string svg = path_svg(tilted_moves(kMoves, {-8, 0, 6}), spec::Axes("XYZ"));
  EXPECT_EQ(malformed(svg), "");
  EXPECT_LT(svg.size(), kMost);
}

TEST(PathSvg, SurvivesEmptyAndDegeneratePaths) {
  EXPECT_EQ(malformed(path_svg({}, spec::Axes("XYZ"))), "");
  spec::Case c;
  c.program = "G90 G01 X0 F100\n";
  const std::string svg = path_svg(events(c), c.setup.axes);
  EXPECT_EQ(malformed(svg), "");
  EXPECT_FALSE(has(svg, "nan"));
  auto broken = events(c);
  broken[0].axes.set(0, std::nan(""));
  EXPECT_FALSE(has(path_svg(broken, c.setup.axes), "nan"));
}

}  // namespace
}  // namespace toolcomp::certify

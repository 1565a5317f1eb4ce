// The vectors written by hand hold what their comments say. Every expected value is typed in from the fact sheets
// (14.1.1, 14.1.2, 14.8; LE1 to LE10) or worked out by hand in the vector's comment; fifteen decimals, as vectors have.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "corpus/golden.h"

namespace toolcomp::corpus {
namespace {

using Lines = std::vector<std::string>;

std::string values(const spec::AxisValues<spec::NumberText>& values, const spec::Axes& axes) {
  std::string text;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (values.has(i) && spec::is_linear_axis(axes.letter(i)))
      text += (text.empty() ? "" : " ") + std::string(1, axes.letter(i)) + values[i].v;
  return text;
}

// "2 X120 Y80 Z-36" for a move (what the axes are sent to), "3 PS0027" for an alarm, "2 H5.wear=-0.2" for a setting.
Lines shown(const spec::Case& c) {
  Lines lines;
  for (const spec::TextEvent& event : c.expect) {
    std::string line = std::to_string(event.line) + ' ';
    if (event.kind == spec::EventKind::move)
      line += values(event.axes, c.setup.axes);
    else if (event.kind == spec::EventKind::setting)
      line += std::string(event.setting.view()) + '=' + event.value.v;
    else
      line += event.number.view();
    lines.push_back(line);
  }
  return lines;
}

// The one vector of the section whose comment begins so.
const spec::Case& find(const std::string& section, const std::string& comment) {
  static std::map<std::string, std::vector<spec::Case>> files;
  auto [found, fresh] = files.try_emplace(section);
  if (fresh)
    for (const char* name : {"examples", "rules"})
      for (spec::Case& c : read_cases(default_folder() / section / (std::string(name) + ".jsonl")))
        found->second.push_back(std::move(c));
  const auto begins = [&](const spec::Case& c) { return c.comment.starts_with(comment); };
  EXPECT_EQ(std::ranges::count_if(found->second, begins), 1) << comment;
  return *std::ranges::find_if(found->second, begins);
}

struct Expected {
  const char* comment;
  Lines lines;
};

void expect(const std::string& section, const std::vector<Expected>& table) {
  for (const Expected& row : table) {
    SCOPED_TRACE(row.comment);
    EXPECT_EQ(shown(find(section, row.comment)), row.lines);
  }
}

TEST(LengthOffsetVectors, Sheet) {
  expect(
      "fanuc/tool-length-offset",
      {{"14.1.1, three holes",
        {"1 X120 Y80 Z0", "2 X120 Y80 Z-36", "3 X120 Y80 Z-57", "5 X120 Y80 Z-36", "6 X150 Y30 Z-36", "7 X150 Y30 Z-77",
         "8 X150 Y30 Z-36", "9 X200 Y60 Z-36", "10 X200 Y60 Z-61", "12 X200 Y60 Z0", "13 X0 Y0 Z0"}},
       {"14.1.1, H1 = 20, then H2 = 30", {"1 X0 Y0 Z120", "2 X0 Y0 Z130"}},
       {"14.1.1, OFH = 0", {"2 X0 Y0 Z-10", "3 X0 Y0 Z-37", "4 X0 Y0 Z-33"}},
       {"14.1.1, OFH = 1", {"2 X0 Y0 Z-20", "3 X0 Y0 Z-37"}},
       {"14.1.1, G91", {"2 X0 Y0 Z-5", "3 X0 Y0 Z-12"}},
       {"14.1.1, type C, TAL = 0", {"1 X14 Y0 Z0", "2 X16 Y0 Z0", "3 PS0027"}},
       {"14.1.1, type C, TAL = 1", {"1 X14 Y0 Z0", "2 X16 Y0 Z0", "3 X16 Y2 Z0", "4 X16 Y4 Z0"}},
       {"14.1.1, G49 alone", {"1 X0 Y0 Z120", "2 X0 Y0 Z100"}}});
}

// Work zero at machine Z-300: a machine position of the sheet plus 300.
TEST(LengthOffsetVectors, MachinePositions) {
  expect("fanuc/tool-length-offset",
         {{"14.1.2, work zero", {"1 X0 Y0 Z20", "2 X0 Y0 Z70", "3 X0 Y0 Z290", "4 X0 Y0 Z50", "5 X0 Y0 Z70"}},
          {"14.1.2, the same with EVO = 1", {"1 X0 Y0 Z20", "2 X0 Y0 Z70", "3 X0 Y0 Z290", "4 X0 Y0 Z70"}},
          {"14.1.2, G53 X0", {"1 X0 Y0 Z20", "2 X0 Y0 Z70", "3 X0 Y0 Z70", "4 X0 Y0 Z70"}},
          {"14.1.2, G28 Z80", {"1 X0 Y0 Z70", "2 X0 Y0 Z100", "2 X0 Y0 Z300", "3 X0 Y0 Z50"}},
          {"14.1.2, G49 G28 Z80", {"1 X0 Y0 Z70", "2 X0 Y0 Z80", "2 X0 Y0 Z300", "3 X0 Y0 Z50"}},
          {"14.1.2, type B", {"1 X4 Y0 Z0", "2 X4 Y0 Z20", "3 X4 Y0 Z100", "3 X0 Y0 Z0", "4 X5 Y0 Z5", "5 X5 Y0 Z25"}},
          {"14.1.2, EVO = 1", {"1 X0 Y0 Z70", "2 X0 Y0 Z290", "3 X10 Y0 Z290", "4 X50 Y0 Z310"}}});
}

TEST(LengthOffsetVectors, Memory) {
  expect("fanuc/tool-length-offset", {{"14.8, memory C", {"1 X0 Y0 Z100.25", "2 H5.wear=-0.2", "3 X0 Y0 Z100.3"}},
                                      {"14.8, memory A", {"1 H3=12", "2 X0 Y0 Z12"}},
                                      {"14.8, a wear of 100 mm", {"1 PS0032"}},
                                      {"14.8, number 1000", {"1 PS0031"}}});
}

TEST(LengthOffsetVectors, Rules) {
  expect(
      "fanuc/tool-length-offset",
      {{"Arcs by I J", {"1 X0 Y0 Z20", "2 X10 Y0 Z20", "3 X0 Y10 Z20", "4 X-20 Y0 Z20", "5 X10 Y0 Z20", "6 X0 Y0 Z20"}},
       {"Arcs by R", {"1 X20 Y0 Z0", "2 X10 Y0 Z0", "3 PS0023"}},
       {"R with the start", {"1 PS0023"}},
       {"An arc without centre", {"1 PS0023"}},
       {"Geometry 999.999", {"1 PS0029"}},
       {"G10 without R", {"2 X0 Y0 Z20", "3 H1=7", "4 X0 Y0 Z7"}},
       {"After G53 an H", {"1 X0 Y0 Z70", "2 X0 Y0 Z-10", "4 X0 Y0 Z50", "5 X0 Y0 Z57"}},
       {"G49 while three axes", {"1 X4 Y0 Z0", "2 X4 Y7 Z0", "3 X4 Y7 Z20", "4 PS0015"}},
       {"EVO = 1: X5 brings back",
        {"1 X0 Y0 Z15", "2 X0 Y0 Z25", "2 X0 Y0 Z100", "3 X5 Y0 Z105", "4 H1=7", "5 X6 Y0 Z107", "6 X7 Y0 Z107"}},
       {"Type C without an axis", {"1 PS0027"}},
       {"An H beyond", {"1 PS0030"}},
       {"G53 under G91", {"1 X0 Y0 Z20", "3 X0 Y0 Z20"}},
       {"OFH = 1, the first G43", {"2 X0 Y0 Z5", "3 X0 Y0 Z25", "4 X0 Y0 Z26"}}});
}

// Arcs of the rules: sweep, centre and radii, by hand in the comments of the vectors.
TEST(LengthOffsetVectors, Arcs) {
  struct ExpectedArc {
    const char* center;
    const char* sweep;
    const char* radii;
  };
  const auto check = [](const std::string& comment, std::size_t event, const ExpectedArc& expected) {
    const spec::Case& c = find("fanuc/tool-length-offset", comment);
    ASSERT_GT(c.expect.size(), event);
    ASSERT_TRUE(c.expect[event].arc.has_value());
    const spec::Arc<spec::NumberText>& arc = *c.expect[event].arc;
    EXPECT_EQ(values(arc.center, c.setup.axes), expected.center);
    EXPECT_EQ(arc.sweep ? arc.sweep->v : "none", expected.sweep);
    EXPECT_EQ(arc.radius ? arc.radius->first.v + ' ' + arc.radius->second.v : "one", expected.radii);
  };
  check("Arcs by I J", 2, {"X0 Y0", "90", "one"});
  check("Arcs by I J", 3, {"X0 Y0", "90", "10 20"});
  check("Arcs by I J", 4, {"X0 Y0", "180", "20 10"});
  check("Arcs by I J", 5, {"X0 Y0", "none", "10 0"});
  check("Arcs by R", 0, {"X10 Y0", "180", "one"});
  check("Arcs by R", 1, {"X15 Y-8.660254037844386", "300", "one"});
}

TEST(LeadingEdgeVectors, Sheet) {
  expect("fanuc/leading-edge-offset",
         {{"LE1:", {"1 X0 Y0 Z0", "2 X-8 Y0 Z6", "3 X92 Y0 Z6", "4 X100 Y0 Z0"}},
          {"LE2:", {"1 X0 Y0 Z0", "2 X8 Y0 Z6", "3 X108 Y0 Z6", "4 X100 Y0 Z0"}},
          {"LE5: B 15",
           {"1 X0 Y0 Z0", "2 X-5.635045313286907 Y1.75995760065834 Z1.071827206730735",
            "3 X34.364954686713093 Y-8.24004239934166 Z6.071827206730735", "4 X40 Y-10 Z5"}},
          {"LE5 the other way",
           {"1 X0 Y0 Z0", "2 X-5.635045313286907 Y1.75995760065834 Z1.071827206730735",
            "3 X-45.635045313286907 Y11.75995760065834 Z-3.928172793269265", "4 X-40 Y10 Z-5"}},
          {"LE7: VT along",
           {"1 X0 Y0 Z0", "2 X8 Y0 Z6", "3 X109.999500012499688 Y0 Z-0.099997500062498",
            "4 X209.999500012499688 Y0 Z-0.099997500062498", "5 X200 Y0 Z0"}},
          {"LE7 with backward before",
           {"1 X0 Y0 Z0", "2 X-8 Y0 Z6", "3 X90.000499987500312 Y0 Z0.099997500062498",
            "4 X190.000499987500312 Y0 Z0.099997500062498", "5 X200 Y0 Z0"}},
          {"LE7 with 19631 = 0.5",
           {"1 X0 Y0 Z0", "2 X8 Y0 Z6", "3 X90.000499987500312 Y0 Z0.099997500062498",
            "4 X190.000499987500312 Y0 Z0.099997500062498", "5 X200 Y0 Z0"}},
          {"LE9: exactly 90 twice",
           {"1 X0 Y0 Z0", "2 X-8 Y0 Z6", "3 X90 Y0 Z0", "4 X190 Y0 Z0", "5 X290 Y0 Z0", "6 X300 Y0 Z0"}},
          {"LE9 with forward before",
           {"1 X0 Y0 Z0", "2 X8 Y0 Z6", "3 X110 Y0 Z0", "4 X210 Y0 Z0", "5 X310 Y0 Z0", "6 X300 Y0 Z0"}},
          {"LE10: VM (60, 0, 80)", {"1 X0 Y0 Z0", "2 PS5408"}},
          {"LE10: VM (-60, 0, -80)", {"1 X0 Y0 Z0", "2 PS5408"}},
          {"A block without movement between",
           {"1 X0 Y0 Z0", "2 X-8 Y0 Z6", "3 X100 Y-10 Z0", "4 X100 Y-10 Z0", "5 X100 Y90 Z0", "6 X100 Y100 Z0"}},
          {"Moving along the tool",
           {"1 X0 Y0 Z0", "2 X-8 Y0 Z6", "3 X92 Y0 Z6", "4 X152 Y0 Z86", "5 X92 Y0 Z6", "6 X-8 Y0 Z6", "7 X0 Y0 Z0"}},
          {"A negative offset value", {"1 X0 Y0 Z0", "2 X8 Y0 Z-6", "3 X108 Y0 Z-6", "4 X100 Y0 Z0"}}});
}

TEST(LeadingEdgeVectors, ToolAxisOfLE5) {
  const spec::Case& c = find("fanuc/leading-edge-offset", "LE5: B 15");
  ASSERT_TRUE(c.expect[0].tool_axis.has_value());
  EXPECT_EQ((*c.expect[0].tool_axis)[0].v, "0.224143868042013");
  EXPECT_EQ((*c.expect[0].tool_axis)[1].v, "0.12940952255126");
  EXPECT_EQ((*c.expect[0].tool_axis)[2].v, "0.965925826289068");
}

// LE7 is rational: the sheet's fractions, to the last digit.
TEST(LeadingEdgeVectors, FractionsOfLE7) {
  const spec::Case& c = find("fanuc/leading-edge-offset", "LE7: VT along");
  EXPECT_EQ(c.expect[2].point[0].q, "4400090/40001");  // 100 + 399990/40001
  EXPECT_EQ(c.expect[2].point[2].q, "-4000/40001");
}

TEST(LeadingEdgeVectors, Rules) {
  const Lines start = {"1 X-10 Y0 Z0", "2 X-9 Y0 Z0"};  // VT = Z, VM = (1, 0, 0), exactly 90 at the start: backward
  const auto after_start = [&](const std::string& alarm) { return Lines{start[0], start[1], "3 " + alarm}; };
  expect("fanuc/leading-edge-offset",
         {{"19631 = 30",
           {"1 X0 Y0 Z0", "2 X-7.071067811865475 Y7.071067811865475 Z0",
            "3 X104.08248290463863 Y-4.08248290463863 Z8.16496580927726",
            "4 X94.08248290463863 Y-4.08248290463863 Z-1.83503419072274", "5 X90 Y0 Z-10"}},
          {"19631 = 45, VT (1, 0, 1), VM (100, 0, 0)", {"1 X0 Y0 Z0", "2 PS5408"}},
          {"19631 = 45, VT (1, 0, 1), VM (-100, 0, 0)", {"1 X0 Y0 Z0", "2 PS5408"}},
          {"19631 = 0", {"1 X0 Y0 Z0", "2 X-8 Y0 Z6", "3 X92 Y0 Z6", "4 X100 Y0 Z0"}},
          {"Two blocks without movement",
           {"1 X0 Y0 Z0", "2 X-8 Y0 Z6", "3 X92 Y0 Z6", "4 X92 Y0 Z6", "6 X190 Y0 Z0", "7 X200 Y0 Z0"}},
          {"M00 stops", {"1 X0 Y0 Z0", "2 X-8 Y0 Z6", "3 X92 Y0 Z6", "5 X100 Y90 Z0", "6 X100 Y100 Z0"}},
          {"Another D", {"1 X0 Y0 Z0", "2 X-8 Y0 Z6", "3 X104 Y0 Z-3", "4 X204 Y0 Z-3", "5 X200 Y0 Z0"}},
          {"D0 cancels", {"1 X0 Y0 Z0", "2 X-8 Y0 Z6", "3 X92 Y0 Z6", "4 X100 Y0 Z0", "6 X150 Y0 Z0"}},
          {"An axis word beside G41.3", {"1 PS5406"}},
          {"G41.3 under G02", {"2 PS5408"}},
          {"No movement after G41.3", {"1 PS5407"}},
          {"G41.3 again", after_start("PS5407")},
          {"G02 in the mode", after_start("PS5407")},
          {"G54 in the mode", after_start("FORBIDDEN_IN_3D_COMPENSATION")},
          {"An axis word beside G40", after_start("PS5406")},
          {"I J K all zero", {"1 PS5421"}},
          {"A rotary word under G43.5", {"1 PS5421"}},
          {"G43.5 under G02", {"1 TOOL_DIRECTION_FORMAT"}},
          {"G28 under G43.5", {"1 X0 Y0 Z0", "2 FORBIDDEN_UNDER_TOOL_DIRECTION"}},
          {"G43 under G43.5", {"1 X0 Y0 Z0", "2 LENGTH_OFFSET_EXCLUSION"}}});
}

// VT along (-1, 0, 1000): V = (VM . VT) VT - |VT|^2 VM, so VC = 10 (1000, 0, 1) / sqrt 1000001 for VM along X.
TEST(LeadingEdgeVectors, LeaningBackALittle) {
  const Lines lines = shown(find("fanuc/leading-edge-offset", "VT nearly at right angles"));
  EXPECT_EQ(lines[1], "2 X9.99999500000375 Y0 Z0.009999995000004");
}

// The tables above hold every vector that is written by hand.
TEST(ExampleVectors, AllAreHeldToFigures) {
  std::size_t length = 8 + 7 + 4 + 13;
  std::size_t edge = 14 + 20 + 1;
  for (const auto& [section, count] :
       {std::pair{"fanuc/tool-length-offset", length}, {"fanuc/leading-edge-offset", edge}})
    EXPECT_EQ(read_cases(default_folder() / section / "examples.jsonl").size() +
                  read_cases(default_folder() / section / "rules.jsonl").size(),
              count);
}

}  // namespace
}  // namespace toolcomp::corpus

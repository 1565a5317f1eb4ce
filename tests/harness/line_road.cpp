// SPDX-License-Identifier: Apache-2.0
// program: faults
// link: toolcomp_fast_faulty
// The law of the road (fast/arrays/line_road.h): a program from its text gives the same events as block by block, bit
// for bit. Random programs of every section, and contours of lines with all that may stand among them. Every mistake
// seeded into the road breaks the law.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/faults/fault.h"
#include "fuzz/gen/encode.h"
#include "fuzz/gen/generator.h"
#include "judge/oracle/control.h"
#include "judge/oracle/verdict.h"
#include "spec/language/event_json.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"
#include "tests/effort.h"

namespace toolcomp::fuzz {
namespace {

using fast::Fault;

struct Kept final : fast::EventSink {
  void on(const fast::Event& event) override { events.push_back(event); }
  std::vector<fast::Event> events;
};

std::vector<fast::Event> by_blocks(const spec::Case& c) {
  Kept kept;
  judge::with_control(c.setup, [&]<class Control>(Control) {
    auto engine = Control::fast(c.setup, kept, c.samples);
    auto reader = Control::reader(spec::text_source(c.program), c.setup, "program");
    typename Control::Block block;
    while (!engine.stopped() && reader.next(block)) engine.block(block);
    engine.end();
  });
  return kept.events;
}

// Every field of the events; or why there are none.
template <class Run>
std::string text_of(const spec::Case& c, const Run& run) {
  std::string all;
  try {
    for (const fast::Event& event : run(c)) {
      spec::append_event_json(all, event, c.setup.axes,
                              [](std::string& to, double value) { to += fmt::format("{:a}", value); });
      all += '\n';
    }
  } catch (const spec::InputError& error) {
    return error.what();
  }
  return all;
}

// Where the law is broken; empty: it holds. The fault is in force on the road alone.
std::string broken(const spec::Case& c, Fault fault = Fault::none) {
  fast::active_fault = fault;
  const std::string road = text_of(c, judge::run_fast);
  fast::active_fault = Fault::none;
  const std::string blocks = text_of(c, by_blocks);
  return road == blocks ? "" : "by the road\n" + road + "block by block\n" + blocks;
}

TEST(LineRoad, GivesWhatBlocksGive) {
  const std::uint64_t cases = test::effort(60U, 1500U);
  for (const std::string_view section : sections())
    for (std::uint64_t seed = 1; seed <= cases; ++seed) {
      SeededSource source(seed);
      const spec::Case c = generate(section, seed % 4 == 0 ? Mode::unrestricted : Mode::directed, source);
      ASSERT_EQ(broken(c), "") << section << " seed " << seed << '\n' << encode(c);
    }
}

// Lines under one compensation, as a program begins them.
struct Under {
  std::string_view section;
  std::string_view setup;
  std::string_view begin;
  std::string_view words;  // X Y Z, I: I J K
};
constexpr std::string_view kThree = R"(control = "fanuc"
axes = ["X", "Y", "Z"]
offsets = {H = {1 = 15}, D = {1 = "0.05", 2 = "0.5"}})";
constexpr std::string_view kFour = R"(control = "fanuc"
axes = ["Z", "A", "Y", "X"]
parameters = {5003 = 1, 5010 = "0.01"}
offsets = {H = {1 = 15}, D = {1 = "-0.02", 2 = "3"}})";
constexpr std::string_view kFive = R"(control = "fanuc"
axes = ["X", "Y", "Z", "B", "C"]
parameters = {19680 = 2, 19681 = 5, 19682 = 3, 19686 = 4, 19687 = 2}
offsets = {H = {1 = 15}, D = {1 = "0.05", 2 = "0.3"}})";
constexpr Under kUnder[] = {
    {"fanuc/tool-length-offset", kThree, "G90 G01 F1000\n", "XYZ"},
    {"fanuc/tool-length-offset", kFour, "G90 G01 F1000\nG43 H1 Z5.\n", "XYZ"},
    {"fanuc/cutter-compensation-c", kThree, "G90 G17 G01 F1000 X-5. Y-5.\nG41 D1 X0 Y0\n", "XY"},
    {"fanuc/cutter-compensation-c", kFour, "G90 G19 G00 Z-5. Y-5.\nG42 D1 Y0 Z0\n", "YZ"},
    {"fanuc/tool-side-compensation", kFive, "G90 G01 F1000\nB10. C5.\nG41.2 D1 X1. Y1.\n", "XYZ"},
    {"fanuc/tool-side-compensation", kThree, "G43.5 H0 I0 J0 K1\nG90 G01 F1000\nG41.6 D1 X1. Y1. I0 J0 K1\n", "XYZI"},
    {"fanuc/tool-center-point-control", kFive, "G90 G01 F1000\nG43.4 H1 X1. Y1.\n", "XYZ"}};
constexpr std::string_view kBetween[] = {
    "M08",    "F300", "G01",    "N77", "D2",        "D1",     "G39",   "G00",      "Z5.",    "G91", "G90",  "G04 P10",
    "G20",    "G21",  "M00",    "G42", "G43 H1",    "H0",     "G54",   "G91\nG90", "G92 X0", "O12", "/X1",  "X1 X2",
    "G40 X0", ";",    "M98 P5", "B12", "G02 X1 R5", "(text)", "X1;Y2", "#1=3",     "Q2",     "T1",  "+X1.", "X+1."};

// A walk: smooth pieces, corners of any angle, reversals, halts and long ways, by words of few or many places, with
// and without N, G01, blanks and all axes in each line; now and then what ends a row of lines.
spec::Case walk(const Under& under, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const auto about = [&](double width) { return (static_cast<double>(random() >> 11U) * 0x1p-53 - 0.5) * width; };
  spec::Case c;
  c.section = under.section;
  c.setup = spec::read_setup_toml(std::string(under.setup), "setup");
  c.program = under.begin;
  const bool numbered = below(2) == 0;
  const bool coded = below(3) == 0;
  std::array<double, 3> at{};
  double heading = 0;
  double lean = 0.1;
  int style = 0;
  int left = 0;
  for (int i = 0, blocks = 60 + below(500); i < blocks; ++i) {
    if (left-- == 0) {
      left = below(120);
      style = below(8);
    }
    double length = 0.7 + about(1);
    if (style == 0) heading += about(2 * std::numbers::pi);
    if (style == 1) heading = std::round(heading) + (below(20) == 0 ? std::numbers::pi : 0);
    if (style == 2) heading = std::numbers::pi / 2 * below(4);
    if (style == 3) length = below(3) == 0 ? 0 : length;
    if (style == 4) length = 100 + about(100);
    if (style > 2) heading += about(style == 4 ? 1 : 0.2);
    at = {at[0] + length * std::cos(heading), at[1] + length * std::sin(heading), at[2] + about(0.1)};
    lean += about(0.02);
    const std::string_view blank = style % 2 == 0 ? "" : " ";
    if (numbered) c.program += fmt::format("N{}{}", 10 * (i + 1), below(2) == 0 ? "" : " ");
    if (coded && below(3) == 0) c.program += below(2) == 0 ? "G01" : "G1 ";
    const std::size_t lacks = style == 6 ? random() % 4 : 9;
    for (std::size_t k = 0; k < under.words.size(); ++k) {
      const char letter = under.words[k];
      if (letter == 'I')
        c.program += fmt::format("I{:.4f}{}J0{}K{:.4f}", std::sin(lean), blank, blank, std::cos(lean));
      else if (k == 0 || k != lacks)
        c.program += fmt::format("{}{:.{}f}{}", letter, at.at(static_cast<std::size_t>(letter - 'X')),
                                 style == 5 ? 6 : 3, blank);
    }
    if (below(60) == 0) c.program += "F200";
    c.program += below(40) == 0 ? "\r\n" : "\n";
    if (below(60) == 0) {
      c.program += kBetween[static_cast<std::size_t>(below(std::size(kBetween)))];
      c.program += '\n';
    }
  }
  if (below(2) == 0) c.program += "G40 X0 Y0\nM30\n";
  return c;
}

TEST(LineRoad, GivesWhatBlocksGiveAlongWalks) {
  const std::uint64_t walks = test::effort(60U, 3000U);
  for (const Under& under : kUnder)
    for (std::uint64_t seed = 1; seed <= walks; ++seed) {
      const spec::Case c = walk(under, seed);
      ASSERT_EQ(broken(c), "") << under.section << " seed " << seed << '\n' << c.program;
    }
}

TEST(LineRoad, AMistakeOnTheRoadBreaksTheLaw) {
  for (const Fault mistake : {Fault::road_number_of_next_line, Fault::road_point_without_vector,
                              Fault::road_tool_stands, Fault::road_ignores_code}) {
    constexpr std::uint64_t kMost = 200;
    std::uint64_t found = 0;
    for (std::uint64_t seed = 1; seed <= kMost && found == 0; ++seed)
      for (const Under& under : kUnder)
        if (!broken(walk(under, seed), mistake).empty()) found = seed;
    EXPECT_NE(found, 0U) << static_cast<int>(mistake);
  }
}

}  // namespace
}  // namespace toolcomp::fuzz

// SPDX-License-Identifier: Apache-2.0
// program: faults
// link: toolcomp_fast_faulty
// The laws of the road (fast/arrays/line_road.h): a program from its text gives the same events as block by block, bit
// for bit, and the same text of its path. Random programs of every section, and contours of lines with all that may
// stand among them. Every mistake seeded into the road breaks the law of events.
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

#include "fast/arrays/line_moves.h"
#include "fast/arrays/line_road.h"
#include "fast/arrays/line_text.h"
#include "fast/basis/print.h"
#include "fuzz/faults/fault.h"
#include "fuzz/gen/encode.h"
#include "fuzz/gen/generator.h"
#include "judge/oracle/control.h"
#include "judge/oracle/verdict.h"
#include "spec/language/event_gcode.h"
#include "spec/language/event_json.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"
#include "spec/language/text_buffer.h"
#include "tests/effort.h"

namespace toolcomp::fuzz {
namespace {

using fast::Fault;

struct Kept final : fast::EventSink {
  void on(const fast::Event& event) override { events.push_back(event); }
  std::vector<fast::Event> events;
};

// The fast engine runs the case, `way`(reader, engine, block) leads it.
template <class Way>
void lead(const spec::Case& c, fast::EventSink& sink, const Way& way) {
  judge::with_control(c.setup, [&]<class Control>(Control) {
    auto engine = Control::fast(c.setup, sink, c.samples);
    auto reader = Control::reader(spec::text_source(c.program), c.setup, "program");
    typename Control::Block block;
    way(reader, engine, block);
    engine.end();
  });
}

std::vector<fast::Event> by_blocks(const spec::Case& c) {
  Kept kept;
  lead(c, kept, [](auto& reader, auto& engine, auto& block) {
    while (!engine.stopped() && reader.next(block)) engine.block(block);
  });
  return kept.events;
}

// As commands run it; the judge's own run gives the road every line.
std::vector<fast::Event> by_road(const spec::Case& c) {
  Kept kept;
  lead(c, kept, [](auto& reader, auto& engine, auto& block) { fast::LineRoad().run(reader, engine, block); });
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
  const std::string road = text_of(c, by_road);
  const std::string every_line = text_of(c, judge::run_fast);
  fast::active_fault = Fault::none;
  const std::string blocks = text_of(c, by_blocks);
  if (road == blocks && every_line == blocks) return "";
  return "by the road\n" + road + "every line by the road\n" + every_line + "block by block\n" + blocks;
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

// The path as text: moves of lines together where they come so.
class PathText final : public fast::EventSink, public fast::LineSink {
 public:
  explicit PathText(const spec::Axes& axes) : axes_(axes), lines_(axes) {}

  void on(const fast::Event& event) override {
    spec::TextCursor out(text_);
    const auto append = [](spec::TextCursor& to, double value) {
      to.write([&](char* at) { return fast::write_number(at, value); });
    };
    spec::append_event_gcode(out, event, axes_, append, state_);
  }
  void lines(fast::LineMoves& moves) override {
    together += moves.size;
    lines_.append(text_, moves, state_);
  }
  [[nodiscard]] std::string text() const { return std::string(text_.view()); }

  std::uint64_t together = 0;

 private:
  const spec::Axes& axes_;
  spec::TextBuffer text_;
  spec::GcodeState<double> state_;
  fast::LineText lines_;
};

// How many moves went together; texts that differ are a failure.
std::uint64_t moves_together(const spec::Case& c) {
  PathText road(c.setup.axes);
  std::string fault;
  try {
    lead(c, road, [&](auto& reader, auto& engine, auto& block) { fast::LineRoad(&road).run(reader, engine, block); });
  } catch (const spec::InputError& error) {
    fault = error.what();
  }
  PathText blocks(c.setup.axes);
  try {
    for (const fast::Event& event : by_blocks(c)) blocks.on(event);
    EXPECT_EQ(fault, "") << c.program;
  } catch (const spec::InputError& error) {
    EXPECT_EQ(fault, error.what()) << c.program;
    return road.together;
  }
  EXPECT_EQ(road.text(), blocks.text()) << c.program;
  return road.together;
}

TEST(LineRoad, GivesTheTextOfThePathOfBlocks) {
  const std::uint64_t walks = test::effort(60U, 3000U);
  std::uint64_t together = 0;
  for (const Under& under : kUnder)
    for (std::uint64_t seed = 1; seed <= walks; ++seed) {
      together += moves_together(walk(under, seed));
      ASSERT_FALSE(HasFailure()) << under.section << " seed " << seed;
    }
  EXPECT_GT(together, 20 * walks);
}

// LN blocks over a surface, with and without tool vectors, and what may stand among them.
constexpr std::string_view kMilling = R"(control = "heidenhain"
axes = ["X", "Y", "Z", "A", "C"]
[[tool]]
number = 1
L = 80
R = 6
R2 = 2
DR = "-0.05"
DR2 = "-0.03")";
constexpr std::string_view kMillingBegins[] = {
    "TOOL CALL 1 Z S1000 DR-0.02\nL X0 Y0 Z0 R0 F1000 M128\n", "TOOL CALL 1 Z S1000\nL X0 Y0 Z0 R0 F1000\n",
    "TOOL CALL 1 Z S1000\nFUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT CNT-CNT\nFUNCTION PROG PATH IS CONTOUR\n"
    "L X0 Y0 Z0 R0 F1000\n"};
constexpr std::string_view kMillingBetween[] = {"L X1 Y1 Z1",
                                                "L X1 Y1 F MAX",
                                                "; text",
                                                "* - text",
                                                "L M8",
                                                "LN X1 Y1 Z1 NX0 NY0 NZ1 F500",
                                                "Q1 = 5",
                                                "",
                                                "LN X1 Y1 Z1 NX0.1 NY0 NZ1",
                                                "ln x1 y1 z1 nx0 ny0 nz1",
                                                "LN X1.000001 Y1 Z1 NX0 NY0 NZ1",
                                                "LN X1,5 Y1 Z1 NX0 NY0 NZ1",
                                                "LN X100000 Y1 Z1 NX0 NY0 NZ1",
                                                "LN X1 Y1 Z1 NX0 NY0 NZ-1",
                                                "LN X1 Y1 Z1 NX0 NY0 NZ0",
                                                "LN Y1 X1 Z1 NX0 NY0 NZ1",
                                                "LN X1 Y1 Z1 NX0 NY0",
                                                "LN X1 Y1 Z1  NX0 NY0 NZ1",
                                                "LN X1 Y1 Z1 NX0 NY0 NZ1 ; text",
                                                "L A5",
                                                "L C10 F MAX",
                                                "LN X1 Y1 Z1 TX0 TY0 TZ1",
                                                "TOOL CALL 1 Z DR+0.1",
                                                "LN X1 Y1 Z1 NX10 NY0 NZ1",
                                                "/LN X1 Y1 Z1 NX0 NY0 NZ1",
                                                "LN X1 Y1 Z1 NX0 NY0 NZ1.",
                                                "LN X1 Y1 Z1 NX.6 NY0 NZ.8",
                                                "LN X+1 Y-1 Z+.5 NX+0 NY-0 NZ+1",
                                                "L X1 RL",
                                                "L IX1",
                                                "LN X1 ~\n Y1 Z1 NX0 NY0 NZ1",
                                                "FUNCTION RESET TCPM",
                                                "L Z5 M128",
                                                "LN X1 Y1 Z1 NX0 NY0 NZ1 TX0 TY0 TZ1",
                                                "STOP"};
spec::Case milling_walk(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  const auto about = [&](double width) { return (static_cast<double>(random() >> 11U) * 0x1p-53 - 0.5) * width; };
  spec::Case c;
  c.section = "heidenhain/face-milling";
  c.setup = spec::read_setup_toml(std::string(kMilling), "setup");
  c.program = below(2) == 0 ? "BEGIN PGM T MM\n" : "BEGIN PGM T INCH\n";
  c.program += kMillingBegins[seed % std::size(kMillingBegins)];
  const bool numbered = below(2) == 0;
  const bool turned = below(2) == 0;
  const int places = 6 + below(3);
  double lean = 0.2;
  double turn = 0;
  for (int i = 0, blocks = 60 + below(400); i < blocks; ++i) {
    lean += about(0.05);
    turn += about(0.1);
    if (numbered) c.program += fmt::format("{} ", i + 10);
    c.program += fmt::format("LN X{:+.{}f} Y{:+.4f} Z{:.3f}", 0.5 * i, 1 + below(5), about(3), about(1));
    const auto vector = [&](char letter, double from_z, double about_z) {
      c.program +=
          fmt::format(" {}X{:.{}f} {}Y{:+.{}f} {}Z{:.{}f}", letter, std::sin(from_z) * std::cos(about_z), places,
                      letter, std::sin(from_z) * std::sin(about_z), places, letter, std::cos(from_z), places);
    };
    vector('N', lean, turn);
    if (turned) vector('T', lean / 2, turn + 0.1);
    c.program += below(40) == 0 ? "\r\n" : "\n";
    if (below(60) == 0) {
      c.program += kMillingBetween[static_cast<std::size_t>(below(std::size(kMillingBetween)))];
      c.program += '\n';
    }
  }
  c.program += "END PGM T MM\n";
  return c;
}

TEST(LineRoad, GivesTheTextOfThePathOfKlartextBlocks) {
  const std::uint64_t walks = test::effort(200U, 10000U);
  std::uint64_t together = 0;
  for (std::uint64_t seed = 1; seed <= walks; ++seed) {
    together += moves_together(milling_walk(seed));
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
  EXPECT_GT(together, 20 * walks);
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

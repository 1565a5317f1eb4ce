// SPDX-License-Identifier: Apache-2.0
// program: faults
// link: toolcomp_fast_faulty
// The law of short cuts: where one is closed (fast/basis/short_cut.h), the general path gives the same events, bit for
// bit. Four of them compute in doubles what the general path computes otherwise: there the events are the same, and
// their numbers what the model permits. Every mistake seeded into a short cut breaks the law.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fast/basis/short_cut.h"
#include "fuzz/faults/fault.h"
#include "fuzz/faults/faults.h"
#include "fuzz/gen/encode.h"
#include "fuzz/gen/generator.h"
#include "judge/oracle/verdict.h"
#include "spec/language/event_json.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"
#include "spec/language/text_buffer.h"
#include "tests/effort.h"

namespace toolcomp::fuzz {
namespace {

using fast::Fault;
using fast::ShortCut;

constexpr unsigned set_of(ShortCut s) { return 1U << static_cast<unsigned>(s); }
constexpr unsigned kSameArithmetic = set_of(ShortCut::axis_line) | set_of(ShortCut::cutter_b_move) |
                                     set_of(ShortCut::cutter_line) | set_of(ShortCut::cutter_path) |
                                     set_of(ShortCut::leading_edge_line) | set_of(ShortCut::tip_line);
constexpr unsigned kOwnArithmetic = set_of(ShortCut::cutter_b_arc) | set_of(ShortCut::tool_side_line) |
                                    set_of(ShortCut::pair) | set_of(ShortCut::posture);
// As the general path does too, but some of its lines are also for a short cut that has formulas of its own.
constexpr unsigned kSameBesideOwn = set_of(ShortCut::tool_side_path);

// What a run gives with some short cuts closed and a fault in force; nothing: a setup that no control could have.
std::optional<std::vector<fast::Event>> run(const spec::Case& c, unsigned closed, Fault fault = Fault::none) {
  struct Restore {
    ~Restore() {
      fast::closed_short_cuts = 0;
      fast::active_fault = Fault::none;
    }
  } const restore;
  fast::closed_short_cuts = closed;
  fast::active_fault = fault;
  try {
    return judge::run_fast(c);
  } catch (const spec::InputError&) {
    return std::nullopt;
  }
}

enum class Numbers : bool { left_out, exact };

// Every field of the events.
std::string text(const std::vector<fast::Event>& events, const spec::Axes& axes, Numbers numbers) {
  std::string all;
  for (const fast::Event& event : events) {
    spec::append_event_json(all, event, axes, [numbers](std::string& to, double value) {
      to += numbers == Numbers::exact ? fmt::format("{:a}", value) : "0";
    });
    all += '\n';
  }
  return all;
}

spec::Case random_case(std::string_view section, std::uint64_t seed) {
  SeededSource source(seed);
  return generate(section, seed % 4 == 0 ? Mode::unrestricted : Mode::directed, source);
}

// Why the law is broken on a case; nothing: it holds.
std::string broken(const spec::Case& c, Fault fault = Fault::none) {
  const auto usual = run(c, 0, fault);
  const auto general = run(c, kSameArithmetic, fault);
  if (usual.has_value() != general.has_value()) return "a setup is refused";
  if (!usual) return "";
  const spec::Axes& axes = c.setup.axes;
  const std::string all = text(*usual, axes, Numbers::exact);
  if (const std::string other = text(*general, axes, Numbers::exact); all != other)
    return "with short cuts\n" + all + "without\n" + other;
  const auto beside = run(c, kSameArithmetic | kOwnArithmetic, fault);
  const auto otherwise = run(c, kSameArithmetic | kOwnArithmetic | kSameBesideOwn, fault);
  if (const std::string with = text(*beside, axes, Numbers::exact), without = text(*otherwise, axes, Numbers::exact);
      with != without)
    return "with a short cut\n" + with + "without\n" + without;
  if (text(*otherwise, axes, Numbers::exact) == all) return "";
  if (text(*otherwise, axes, Numbers::left_out) != text(*usual, axes, Numbers::left_out))
    return "with short cuts\n" + all + "without\n" + text(*otherwise, axes, Numbers::exact);
  const judge::ModelRun model = judge::run_model(c);
  for (const auto* events : {&*usual, &*otherwise})
    if (const judge::Verdict verdict = judge::judge(c, model, *events); verdict.outcome == judge::Outcome::differs)
      return explain(*verdict.difference);
  return "";
}

TEST(ShortCuts, GiveWhatTheGeneralPathGives) {
  const std::uint64_t cases = test::effort(100U, 1500U);
  for (const std::string_view section : sections())
    if (section.starts_with("fanuc/"))
      for (std::uint64_t seed = 1; seed <= cases; ++seed) {
        const spec::Case c = random_case(section, seed);
        const std::string why = broken(c);
        ASSERT_EQ(why, "") << section << " seed " << seed << '\n' << encode(c);
      }
}

constexpr std::string_view kPlanes[][5] = {
    {"G17", "X", "Y", "I", "J"}, {"G18", "Z", "X", "K", "I"}, {"G19", "Y", "Z", "J", "K"}};
constexpr std::string_view kBetween[] = {"M08", "F300",   "G01", "N77", "D2",  "G10 L12 P1 R0.3",
                                         "G39", "G00 X0", "Z5.", "G91", "G90", "G04 P10"};
constexpr std::string_view kSetups[] = {
    R"(control = "fanuc"
axes = ["X", "Y", "Z"]
offsets = {H = {1 = 15}, D = {1 = "0.05", 2 = "0.004"}})",
    R"(control = "fanuc"
axes = ["Z", "A", "Y", "X"]
parameters = {5003 = 1, 5010 = "0.01"}
offsets = {H = {1 = 15}, D = {1 = "-0.02", 2 = "3"}})"};

// Whole numbers from 0, by a seed.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  bool one_in(int n) { return below(n) == 0; }

 private:
  std::mt19937_64 random_;
};

// A contour of mostly lines in one plane, long enough for a short cut to be left and taken again: by absolute or
// incremental words, with F, repeated and other codes, one word alone, straight on, and blocks between that are none.
std::string contour(std::uint64_t seed) {
  Dice dice(seed);
  const auto below = [&](int n) { return dice.below(n); };
  const auto& plane = kPlanes[seed % 3];
  const bool incremental = below(3) == 0;
  const int scale = 1 + below(4) * 1000;
  std::string text =
      fmt::format("{} {} G01 F250.5\n{}", plane[0], incremental ? "G91" : "G90", below(3) == 0 ? "G43 H1\n" : "");
  std::array<int, 2> at{};
  std::array<int, 2> way{};
  for (int i = 0; i < 40; ++i) {
    if (below(12) == 0) text += fmt::format("{}\n", kBetween[static_cast<std::size_t>(below(std::size(kBetween)))]);
    if (below(5) != 0) way = {(below(41) - 20) * scale, (below(41) - 20) * scale};
    const int which = below(12);  // 0, 1: one of the words alone
    for (std::size_t k = 0; k < 2; ++k) {
      if (which == static_cast<int>(1 - k)) way[k] = 0;
      at[k] += way[k];
    }
    std::string block = i == 0 ? (below(2) == 0 ? "G41 D1 " : "G42 D1 ") : (below(10) == 0 ? "G01 " : "");
    if (i > 0 && below(30) == 0) block += below(2) == 0 ? "G41 " : "G42 ";
    for (std::size_t k = 0; k < 2; ++k)
      if (which != static_cast<int>(1 - k))
        block += fmt::format("{}{:.3f} ", plane[1 + k], (incremental ? way[k] : at[k]) / 1000.0);
    if (below(10) == 0) block += fmt::format("F{}", 1 + below(900));
    text += block + '\n';
  }
  return text + "M30\n";
}

// What contours with arcs are compensated by: codes to the left and to the right, and what stands between.
struct ArcsUnder {
  std::string_view left;
  std::string_view right;
  std::span<const std::string_view> between;
};
constexpr ArcsUnder kArcs{"G41 D1 ", "G42 D1 ", kBetween};

// The same with arcs among the lines, both ways, by their centre and some by their radius: circles, spirals by a
// rounded end and by a large one, tangent and acute corners, codes where they change or again.
std::string contour_with_arcs(std::uint64_t seed, const ArcsUnder& under) {
  Dice dice(seed);
  const auto& plane = kPlanes[seed % 3];
  bool incremental = dice.one_in(4);
  const double scale = dice.one_in(3) ? 0.1 : 1.0 + dice.below(20);
  std::string text =
      fmt::format("{} {} G01 F250.5\n{}", plane[0], incremental ? "G91" : "G90", dice.one_in(3) ? "G43 H1\n" : "");
  const std::string_view codes[] = {"G01 ", "G02 ", "G03 "};
  std::size_t in_force = 1;
  std::array<double, 2> at{};
  double heading = 0;
  const auto round = [](double v) { return std::round(v * 1000) / 1000; };
  // From where it is: to a point, as words.
  const auto words_to = [&](const std::array<double, 2>& to) {
    std::string words;
    for (std::size_t k = 0; k < 2; ++k)
      words += fmt::format("{}{:.3f} ", plane[1 + k], round(to[k]) - (incremental ? at[k] : 0));
    return words;
  };
  for (int i = 0; i < 40; ++i) {
    if (dice.one_in(16)) {
      const std::string_view between =
          under.between[static_cast<std::size_t>(dice.below(static_cast<int>(under.between.size())))];
      text += fmt::format("{}\n", between);
      if (between == "G90" || between == "G91") incremental = between == "G91";
      if (between.starts_with("G0")) in_force = 9;
    }
    // Tangent, a little off, or any corner.
    const int corner = dice.below(4);
    if (corner > 1) heading += (dice.below(2001) - 1000) * (corner == 2 ? 0.0003 : 0.003);
    const std::size_t motion = i == 0 ? 0 : static_cast<std::size_t>(dice.below(3));
    const double length = scale * (1 + dice.below(50)) / 10;
    const double turn = motion == 0 ? 0 : (motion == 2 ? 1 : -1) * (1 + dice.below(dice.one_in(4) ? 350 : 120)) / 57.3;
    const double radius = motion == 0 ? 0 : length / std::abs(turn) * (dice.one_in(6) ? 0.05 : 1);
    std::array<double, 2> to{at[0] + length * std::cos(heading), at[1] + length * std::sin(heading)};
    std::array<double, 2> center{};
    if (motion != 0) {
      const double side = motion == 2 ? 1 : -1;
      center = {-side * radius * std::sin(heading), side * radius * std::cos(heading)};
      const double grown = dice.one_in(8) ? 1.2 : 1;
      const double angle = heading + turn;
      to = {at[0] + center[0] + grown * side * radius * std::sin(angle),
            at[1] + center[1] - grown * side * radius * std::cos(angle)};
      heading = angle;
    }
    to = {round(to[0]), round(to[1])};
    std::string block;
    if (i == 0) block = dice.below(2) == 0 ? under.left : under.right;
    if (motion + 1 != in_force || dice.one_in(12)) block += codes[motion];
    in_force = motion + 1;
    block += words_to(to);
    if (motion != 0 && dice.one_in(10)) {
      const double chord = std::hypot(to[0] - at[0], to[1] - at[1]);
      block += fmt::format("R{:.3f} ", std::max(radius, chord / 2 + 0.001) * (std::abs(turn) > 3.14159 ? -1 : 1));
    } else if (motion != 0) {
      const bool whole = dice.one_in(2);
      for (std::size_t k = 0; k < 2; ++k) block += fmt::format("{}{:.{}f} ", plane[3 + k], center[k], whole ? 3 : 6);
    }
    if (dice.one_in(10)) block += fmt::format("F{}", 1 + dice.below(900));
    text += block + '\n';
    at = to;
  }
  return text + "M30\n";
}

TEST(ShortCuts, GiveWhatTheGeneralPathGivesAlongContours) {
  const std::uint64_t cases = test::effort(100U, 2000U);
  for (const std::string_view setup : kSetups)
    for (const std::string_view compensation : {"B", "C"}) {
      spec::Case c;
      c.section = compensation == "B" ? "fanuc/cutter-compensation-b" : "fanuc/cutter-compensation-c";
      c.setup = spec::read_setup_toml(fmt::format("cutter_compensation = \"{}\"\n{}", compensation, setup), "setup");
      for (std::uint64_t seed = 1; seed <= cases; ++seed)
        for (const std::string& program : {contour(seed), contour_with_arcs(seed, kArcs)}) {
          c.program = program;
          ASSERT_EQ(broken(c), "") << "compensation " << compensation << " seed " << seed << '\n' << c.program;
        }
    }
}

constexpr std::string_view kSideBetween[] = {"M08", "F300", "G01", "N77",   "D2",    "D1",  "G00 X0",         "Z5.",
                                             "G91", "G90",  "Q2",  "G41.2", "G42.2", "B12", "C10. B90\nC90.", "B0"};
constexpr ArcsUnder kArcsUnderToolSide{"G41.2 D1 ", "G42.2 D1 ", kSideBetween};
// The tool along the normal of G17, G18 and G19, and the other way.
constexpr std::string_view kToolAlong[] = {"B0 C0", "B90 C90", "B90 C0"};
constexpr std::string_view kToolAgainst[] = {"B180 C0", "B-90 C90", "B-90 C0"};
constexpr std::string_view kSideSetups[] = {
    R"(control = "fanuc"
axes = ["X", "Y", "Z", "B", "C"]
parameters = {19680 = 2, 19681 = 5, 19682 = 3, 19686 = 4, 19687 = 2}
offsets = {H = {1 = 15}, D = {1 = "0.05", 2 = "0.004"}})",
    R"(control = "fanuc"
axes = ["Z", "C", "Y", "X", "B"]
parameters = {5003 = 1, 5010 = "0.01", 19630 = "0.2", 19680 = 2, 19681 = 2, 19682 = 3, 19686 = 5, 19687 = 2}
offsets = {H = {1 = 15}, D = {1 = "-0.02", 2 = "3"}})"};

spec::Case side_arcs(std::string_view setup, std::uint64_t seed) {
  const std::string_view tool = (seed % 4 == 0 ? kToolAgainst : kToolAlong)[seed % 3];
  spec::Case c;
  c.section = "fanuc/tool-side-compensation";
  c.setup = spec::read_setup_toml(std::string(setup), "setup");
  c.program = fmt::format("G01 F100 {}\n{}", tool, contour_with_arcs(seed, kArcsUnderToolSide));
  return c;
}

TEST(ShortCuts, GiveWhatTheGeneralPathGivesAlongArcsUnderToolSideCompensation) {
  const std::uint64_t cases = test::effort(100U, 2000U);
  for (const std::string_view setup : kSideSetups) {
    std::uint64_t moves = 0;
    for (std::uint64_t seed = 1; seed <= cases; ++seed) {
      const spec::Case c = side_arcs(setup, seed);
      ASSERT_EQ(broken(c), "") << "seed " << seed << '\n' << setup << '\n' << c.program;
      moves += run(c, 0)->size();
    }
    // Most programs run on, though some of their blocks are refused.
    EXPECT_GE(moves, 10 * cases) << setup;
  }
}

// The short cut of paths serves two sections: what is seeded into it is seen in this one too.
TEST(ShortCuts, MistakesInUsualPathsBreakTheLawUnderToolSideCompensation) {
  for (const Fault mistake :
       {Fault::usual_path_small_movement, Fault::usual_path_unchecked, Fault::usual_path_spiral, Fault::usual_path_code,
        Fault::usual_path_feed, Fault::usual_path_corner_moves, Fault::usual_side_path_behind,
        Fault::usual_side_path_stop_owner, Fault::usual_side_path_shortest}) {
    constexpr std::uint64_t kMost = 500;
    std::uint64_t seed = 1;
    while (seed <= kMost && broken(side_arcs(kSideSetups[1], seed), mistake).empty()) ++seed;
    EXPECT_LE(seed, kMost) << static_cast<int>(mistake);
  }
}

constexpr std::string_view kEdgeBetween[] = {"M08",    "F300",      "G01",    "N77",    "D2", "D1",    "G00",
                                             "D2 X7.", "G91",       "G90 Z5", "G43 H1", "H2", "G49",   "X0",
                                             "G04 P1", "G91 X0 D1", "G90",    "G17",    "D0", "S1 M3", "G40\nG41.3 D2"};
// The tool stands by B and C; by rotary words that turn nothing; by I J K, with a length along it.
struct EdgeSetup {
  std::string_view setup;
  std::string_view rotary;
  bool by_vector;
};
constexpr EdgeSetup kEdgeSetups[] = {
    {R"(control = "fanuc"
axes = ["X", "Y", "Z", "B", "C"]
parameters = {19680 = 2, 19681 = 5, 19682 = 3, 19686 = 4, 19687 = 2}
offsets = {H = {1 = 15, 2 = "-7.25"}, D = {1 = "4.95", 2 = "-0.004"}})",
     "BC", false},
    {R"(control = "fanuc"
axes = ["X", "Y", "Z", "U", "A", "C"]
parameters = {19631 = 45, 19680 = 12, 19681 = 6, 19682 = 3, 19686 = 5, 19687 = 1}
offsets = {H = {1 = 15, 2 = "-7.25"}, D = {1 = "4.95", 2 = "-0.004"}})",
     "AC", false},
    {R"(control = "fanuc"
axes = ["X", "Y", "Z"]
offsets = {H = {1 = "100.25", 2 = 0}, D = {1 = "4.95", 2 = 3}})",
     "", true},
    {R"(control = "fanuc"
axes = ["X", "Y", "Z", "C", "W"]
parameters = {19631 = 0}
workpiece = {G54 = {X = 12}}
offsets = {H = {1 = "100.25", 2 = 0}, D = {1 = "4.95", 2 = 3}})",
     "", true},
    {R"(control = "fanuc"
axes = ["X", "Y", "Z"]
workpiece = {G54 = {X = 12}}
parameters = {19631 = 60}
offsets = {H = {1 = "100.25", 2 = 0}, D = {1 = "4.95", 2 = 3}})",
     "", true},
    {R"(control = "fanuc"
axes = ["Z", "X", "B", "Y", "C"]
parameters = {19680 = 2, 19681 = 5, 19682 = 3, 19686 = 3, 19687 = 5}
offsets = {H = {1 = 15, 2 = "-7.25"}, D = {1 = "4.95", 2 = "-0.004"}})",
     "BC", false},
};

// Lines under leading edge offset, long enough for its short cut to be left and taken again: along the tool, across it
// and anywhere, with the tool turned or not, blocks that turn alone or move nothing, and blocks between that are no
// lines.
std::string edge_contour(const EdgeSetup& setup, std::uint64_t seed) {
  Dice dice(seed);
  const int scale = dice.one_in(3) ? 1 : 1000;
  bool incremental = dice.one_in(4);
  std::string text = "G01 F250.5\n";
  std::array<int, 3> tool{0, 0, 1};
  if (setup.by_vector)
    text += fmt::format("G43.5 H{} I0 J0 K1.\n", 1 + dice.below(2));
  else if (dice.one_in(2))
    text += fmt::format("G43 H{}\n", 1 + dice.below(2));
  text += fmt::format("{}\nG41.3 D1\n", incremental ? "G91" : "G90");
  std::array<int, 3> at{};
  std::array<int, 3> way{};
  for (int i = 0; i < 40; ++i) {
    if (i > 0 && dice.one_in(16)) {
      const std::string_view between = kEdgeBetween[static_cast<std::size_t>(dice.below(std::size(kEdgeBetween)))];
      text += fmt::format("{}\n", between);
      if (between.starts_with("G9")) incremental = between.starts_with("G91");
    }
    const auto any = [&](int most) { return dice.below(2 * most + 1) - most; };
    const int kind = dice.below(10);
    if (kind < 6) way = {any(20) * scale, any(20) * scale, any(20) * scale};
    const int times = (1 + dice.below(9)) * (dice.one_in(2) ? 1 : -1) * scale;
    if (kind == 6) way = {tool[0] * times, tool[1] * times, tool[2] * times};
    if (kind == 7) way = {tool[1] * times, -tool[0] * times, tool[1] == 0 && tool[0] == 0 ? 0 : dice.below(2)};
    if (kind == 8 && !dice.one_in(3)) way = {way[1], way[2], way[0]};
    if (kind == 9 && dice.one_in(2)) way = {};
    std::string block = dice.one_in(10) ? "G01 " : "";
    for (std::size_t k = 0; k < 3; ++k) {
      at[k] += way[k];
      if (way[k] != 0 || dice.one_in(4))
        block += fmt::format("{}{:.3f} ", "XYZ"[k], (incremental ? way[k] : at[k]) / 1000.0);
    }
    if (setup.by_vector && dice.one_in(2)) {
      const std::array<int, 3> before = tool;
      tool = {any(4), any(4), any(dice.one_in(3) ? 4 : 1)};
      if (dice.one_in(4)) tool = {-before[0], before[1], 1};
      if (tool == std::array<int, 3>{} && !dice.one_in(8)) tool[2] = 1;
      for (std::size_t k = 0; k < 3; ++k)
        if (tool[k] != 0 || dice.one_in(2)) block += fmt::format("{}{} ", "IJK"[k], tool[k]);
    }
    for (const char letter : setup.rotary)
      if (!incremental && dice.one_in(2))
        block += fmt::format("{}{} ", letter, dice.one_in(2) ? 15 * any(12) : any(90'000) / 1000.0);
    if (dice.one_in(10)) block += fmt::format("F{}", 1 + dice.below(900));
    text += block + '\n';
  }
  return text + (dice.one_in(2) ? "G40\n" : "") + "M30\n";
}

TEST(ShortCuts, GiveWhatTheGeneralPathGivesUnderLeadingEdgeOffset) {
  const std::uint64_t cases = test::effort(100U, 1500U);
  for (const EdgeSetup& setup : kEdgeSetups) {
    spec::Case c;
    c.section = "fanuc/leading-edge-offset";
    c.setup = spec::read_setup_toml(std::string(setup.setup), "setup");
    std::uint64_t moves = 0;
    for (std::uint64_t seed = 1; seed <= cases; ++seed) {
      c.program = edge_contour(setup, seed);
      ASSERT_EQ(broken(c), "") << "seed " << seed << '\n' << setup.setup << '\n' << c.program;
      moves += run(c, 0)->size();
    }
    // Most programs run on, though some of their blocks are refused.
    EXPECT_GE(moves, 10 * cases) << setup.setup;
  }
}

constexpr std::string_view kAxisBetween[] = {
    "M08", "F300",    "G01",        "N77",   "H2",      "G43 H1",           "G49",
    "G00", "G91",     "G90",        "G54",   "G92 X1.", "G45 X2. D1",       "G20",
    "G21", "G04 P10", "G41 D1\nX9", "G40 X", "D2",      "G10 L10 P1 R-3.5", "X1.1234567"};
constexpr std::string_view kAxisSetups[] = {
    R"(control = "fanuc"
axes = ["X", "Y", "Z", "B", "C"]
workpiece = {G54 = {X = 12, C = 15}}
parameters = {19680 = 2, 19681 = 5, 19682 = 3, 19686 = 4, 19687 = 2}
offsets = {H = {1 = 15, 2 = "-7.1234567"}, D = {1 = "4.95"}})",
    R"(control = "fanuc"
axes = ["Z", "A", "U", "X"]
parameters = {5001 = 2}
offsets = {H = {1 = "0.3", 2 = 1000}, D = {1 = "4.95"}})",
    R"(control = "fanuc"
axes = ["X", "Y", "Z", "W"]
parameters = {5001 = 1, 3401 = 1}
offsets = {H = {1 = 0, 2 = 3}, D = {1 = "4.95"}})"};

// Lines without compensation in any order of their words, long enough for the short cut to be left and taken again.
spec::Case axis_contour(std::string_view setup, std::uint64_t seed) {
  Dice dice(seed);
  spec::Case c;
  c.section = "fanuc/tool-length-offset";
  c.setup = spec::read_setup_toml(std::string(setup), "setup");
  const std::string letters(c.setup.axes.letters());
  c.program = fmt::format("G90 {} F250.5\n{}", dice.one_in(3) ? "G00" : "G01", dice.one_in(2) ? "G43 Z H1\n" : "");
  for (int i = 0; i < 40; ++i) {
    if (dice.one_in(12))
      c.program += fmt::format("{}\n", kAxisBetween[static_cast<std::size_t>(dice.below(std::size(kAxisBetween)))]);
    std::string block = dice.one_in(10) ? "G01 " : "";
    const bool backwards = dice.one_in(5);
    for (std::size_t k = 0; k < letters.size(); ++k)
      if (!dice.one_in(4))
        block += fmt::format("{}{:.3f} ", letters[backwards ? letters.size() - 1 - k : k],
                             (dice.below(120'001) - 60'000) / 1000.0);
    if (dice.one_in(10)) block += fmt::format("F{}", 1 + dice.below(900));
    c.program += block + '\n';
  }
  c.program += "M30\n";
  return c;
}

TEST(ShortCuts, GiveWhatTheGeneralPathGivesWithoutCompensation) {
  const std::uint64_t cases = test::effort(100U, 2000U);
  for (const std::string_view setup : kAxisSetups) {
    std::uint64_t moves = 0;
    for (std::uint64_t seed = 1; seed <= cases; ++seed) {
      const spec::Case c = axis_contour(setup, seed);
      ASSERT_EQ(broken(c), "") << "seed " << seed << '\n' << setup << '\n' << c.program;
      moves += run(c, 0)->size();
    }
    // Most programs run on, though some of their blocks are refused.
    EXPECT_GE(moves, 10 * cases) << setup;
  }
}

constexpr std::string_view kTipBetween[] = {"M08",
                                            "F300",
                                            "G01",
                                            "N77",
                                            "G00",
                                            "G91",
                                            "G90",
                                            "X0",
                                            "G04 P1",
                                            "G54",
                                            "G55",
                                            "G92 X1.",
                                            "G49\nG43.4 H2",
                                            "G49\nG43.5 H1 P1",
                                            "H2",
                                            "G53 Z200.",
                                            "G02 X20. Y20. R80.\nG01",
                                            "G42.2 D1 X3. Y40.\nX60.\nG40 Y3.",
                                            "G45 X2. D1",
                                            "X1.1234567"};
// A head; a table and a mixed machine, with origins and ranges; a head of inclined axes with No. 19738; one whose axes
// are more than the tool needs.
constexpr std::string_view kTipSetups[] = {
    R"(control = "fanuc"
axes = ["X", "Y", "Z", "B", "C"]
parameters = {19680 = 2, 19681 = 5, 19682 = 3, 19686 = 4, 19687 = 2}
offsets = {H = {1 = 100, 2 = "-7.25"}, D = {1 = "4.95"}})",
    R"(control = "fanuc"
axes = ["X", "Y", "Z", "A", "C"]
workpiece = {G54 = {X = 12, C = 15}, G55 = {X = "-3.5", A = 7}}
parameters = {19680 = 12, 19681 = 4, 19682 = 1, 19686 = 5, 19687 = 3, 19700 = "0.5", 19705 = "-4.25"}
offsets = {H = {1 = 100, 2 = "-7.25"}, D = {1 = "4.95"}})",
    R"(control = "fanuc"
axes = ["X", "Y", "Z", "B", "C"]
workpiece = {G55 = {B = 7}}
parameters = {19680 = 21, 19681 = 4, 19682 = 2, 19686 = 5, 19687 = 3, 19711 = "12.5", 19741 = 100, 19742 = -80}
offsets = {H = {1 = 100, 2 = "-7.25"}, D = {1 = "4.95"}})",
    R"(control = "fanuc"
axes = ["X", "Y", "Z", "B", "C"]
parameters = {19680 = 2, 19681 = 5, 19682 = 3, 19686 = 4, 19687 = 5, 19688 = 45, 19738 = 12, 19739 = 30}
offsets = {H = {1 = 100, 2 = "-7.25"}, D = {1 = "4.95"}})",
    R"(control = "fanuc"
axes = ["X", "Y", "Z", "U", "B", "C", "V"]
parameters = {19680 = 2, 19681 = 6, 19682 = 3, 19686 = 5, 19687 = 2}
offsets = {H = {1 = 100, 2 = "-7.25"}, D = {1 = "4.95"}})"};

// Lines under tool center point control, long enough for its short cut to be left and taken again: by rotary words or
// I J K, with posture control or without, into singular postures and out of them, blocks that turn alone or move
// nothing, and blocks between that are no lines.
std::string tip_contour(std::string_view setup, std::uint64_t seed) {
  Dice dice(seed);
  const std::string rotary = setup.find("\"A\"") == std::string_view::npos ? "BC" : "AC";
  const auto any = [&](int most) { return dice.below(2 * most + 1) - most; };
  bool by_vector = dice.one_in(2);
  std::string text = fmt::format("G90 G01 F250.5\nX1. {}{}\n{} H{} P{}\n", rotary[0], dice.one_in(2) ? 0 : 20,
                                 by_vector ? "G43.5" : "G43.4", 1 + dice.below(2), dice.below(2));
  for (int i = 0; i < 40; ++i) {
    if (dice.one_in(16)) {
      const std::string_view between = kTipBetween[static_cast<std::size_t>(dice.below(std::size(kTipBetween)))];
      text += fmt::format("{}\n", between);
      if (between.starts_with("G49")) by_vector = between.find("G43.5") != std::string_view::npos;
    }
    std::string block = dice.one_in(10) ? "G01 " : "";
    for (const char letter : std::string_view("XYZ"))
      if (!dice.one_in(4)) block += fmt::format("{}{:.3f} ", letter, any(60'000) / 1000.0);
    if (by_vector && !dice.one_in(3)) {
      std::array<int, 3> tool{any(4), any(4), 1 + dice.below(9)};
      if (dice.one_in(4)) tool[0] = tool[1] = 0;
      for (std::size_t k = 0; k < 3; ++k)
        if (tool[k] != 0 || dice.one_in(2)) block += fmt::format("{}{} ", "IJK"[k], tool[k]);
    }
    if (!by_vector)
      for (const char letter : rotary)
        if (!dice.one_in(3)) block += fmt::format("{}{} ", letter, dice.one_in(2) ? 15 * any(6) : any(90'000) / 1000.0);
    if (dice.one_in(10)) block += fmt::format("F{}", 1 + dice.below(900));
    text += block + '\n';
  }
  return text + (dice.one_in(2) ? "G49\nX5.\n" : "") + "M30\n";
}

TEST(ShortCuts, GiveWhatTheGeneralPathGivesUnderToolCenterPointControl) {
  const std::uint64_t cases = test::effort(40U, 400U);
  for (const std::string_view setup : kTipSetups) {
    spec::Case c;
    c.section = "fanuc/tool-posture-control";
    c.setup = spec::read_setup_toml(std::string(setup), "setup");
    std::uint64_t moves = 0;
    for (std::uint64_t seed = 1; seed <= cases; ++seed) {
      c.program = tip_contour(setup, seed);
      ASSERT_EQ(broken(c), "") << "seed " << seed << '\n' << setup << '\n' << c.program;
      moves += run(c, 0)->size();
    }
    // Most programs run on, though some of their blocks are refused.
    EXPECT_GE(moves, 10 * cases) << setup;
  }
}

// A short cut that were never taken would make the law empty.
TEST(ShortCuts, AMistakeInOneBreaksTheLaw) {
  constexpr std::pair<std::string_view, Fault> kFaults[] = {
#define TOOLCOMP_FAULT(name, mistake, section, budget, clauses) {#name, Fault::name},
#include "fuzz/faults/faults.inc"
#undef TOOLCOMP_FAULT
  };
  int faults = 0;
  for (const SeededFault& fault : seeded_faults()) {
    if (!fault.name.starts_with("usual_")) continue;
    if (++faults % 2 == 0 && !test::whole()) continue;
    const auto* found =
        std::find_if(std::begin(kFaults), std::end(kFaults), [&](const auto& f) { return f.first == fault.name; });
    std::uint64_t seed = 1;
    while (seed <= fault.budget && broken(random_case(fault.section, seed), found->second).empty()) ++seed;
    fmt::print("{:34}{:28}{:>8}\n", fault.name, fault.section, seed);
    EXPECT_LE(seed, fault.budget) << fault.name;
  }
  EXPECT_GE(faults, 24);
}

}  // namespace
}  // namespace toolcomp::fuzz

// program: faults
// link: toolcomp_fast_faulty
// The law of short cuts: where one is closed (fast/basis/short_cut.h), the general path gives the same events, bit for
// bit. Three of them compute in doubles what the general path computes otherwise: there the events are the same, and
// their numbers what the model permits. Every mistake seeded into a short cut breaks the law.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fast/basis/fault.h"
#include "fast/basis/short_cut.h"
#include "fuzz/faults/faults.h"
#include "fuzz/gen/encode.h"
#include "fuzz/gen/generator.h"
#include "fuzz/oracle/verdict.h"
#include "spec/language/event_json.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"
#include "spec/language/text_buffer.h"
#include "tests/sanitized.h"

namespace toolcomp::fuzz {
namespace {

using fast::Fault;
using fast::ShortCut;

constexpr unsigned set_of(ShortCut s) { return 1U << static_cast<unsigned>(s); }
constexpr unsigned kSameArithmetic = set_of(ShortCut::cutter_line);
constexpr unsigned kOwnArithmetic =
    set_of(ShortCut::tool_side_line) | set_of(ShortCut::pair) | set_of(ShortCut::posture);

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
    return run_fast(c);
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
  const auto otherwise = run(c, kSameArithmetic | kOwnArithmetic, fault);
  if (text(*otherwise, axes, Numbers::exact) == all) return "";
  if (text(*otherwise, axes, Numbers::left_out) != text(*usual, axes, Numbers::left_out))
    return "with short cuts\n" + all + "without\n" + text(*otherwise, axes, Numbers::exact);
  const ModelRun model = run_model(c);
  for (const auto* events : {&*usual, &*otherwise})
    if (const Verdict verdict = judge(c, model, *events); verdict.outcome == Outcome::differs)
      return explain(*verdict.difference);
  return "";
}

TEST(ShortCuts, GiveWhatTheGeneralPathGives) {
  constexpr std::uint64_t cases = test::kSanitized ? 100 : 1500;
  for (const std::string_view section : sections())
    if (section.starts_with("fanuc/"))
      for (std::uint64_t seed = 1; seed <= cases; ++seed) {
        const spec::Case c = random_case(section, seed);
        const std::string why = broken(c);
        ASSERT_EQ(why, "") << section << " seed " << seed << '\n' << encode(c);
      }
}

// A contour of mostly lines in one plane, long enough for a short cut to be left and taken again: by absolute or
// incremental words, with F, repeated and other codes, one word alone, straight on, and blocks between that are none.
std::string contour(std::uint64_t seed) {
  static constexpr std::string_view kPlanes[][3] = {{"G17", "X", "Y"}, {"G18", "Z", "X"}, {"G19", "Y", "Z"}};
  static constexpr std::string_view kBetween[] = {"M08", "F300",   "G01", "N77", "D2",  "G10 L12 P1 R0.3",
                                                  "G39", "G00 X0", "Z5.", "G91", "G90", "G04 P10"};
  std::mt19937_64 random(seed);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
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

TEST(ShortCuts, GiveWhatTheGeneralPathGivesAlongContours) {
  constexpr std::uint64_t cases = test::kSanitized ? 100 : 2000;
  static constexpr std::string_view kSetups[] = {
      R"(control = "fanuc"
axes = ["X", "Y", "Z"]
offsets = {H = {1 = 15}, D = {1 = "0.05", 2 = "0.004"}})",
      R"(control = "fanuc"
axes = ["Z", "A", "Y", "X"]
parameters = {5003 = 1, 5010 = "0.01"}
offsets = {H = {1 = 15}, D = {1 = "-0.02", 2 = "3"}})"};
  for (const std::string_view setup : kSetups) {
    spec::Case c;
    c.section = "fanuc/cutter-compensation-c";
    c.setup = spec::read_setup_toml(std::string(setup), "setup");
    for (std::uint64_t seed = 1; seed <= cases; ++seed) {
      c.program = contour(seed);
      ASSERT_EQ(broken(c), "") << "seed " << seed << '\n' << c.program;
    }
  }
}

// A short cut that were never taken would make the law empty.
TEST(ShortCuts, AMistakeInOneBreaksTheLaw) {
  constexpr std::pair<std::string_view, Fault> kFaults[] = {
#define TOOLCOMP_FAULT(name, mistake, section, budget, clauses) {#name, Fault::name},
#include "fast/basis/faults.inc"
#undef TOOLCOMP_FAULT
  };
  int faults = 0;
  for (const SeededFault& fault : seeded_faults()) {
    if (!fault.name.starts_with("usual_")) continue;
    ++faults;
    const auto* found =
        std::find_if(std::begin(kFaults), std::end(kFaults), [&](const auto& f) { return f.first == fault.name; });
    std::uint64_t seed = 1;
    while (seed <= fault.budget && broken(random_case(fault.section, seed), found->second).empty()) ++seed;
    fmt::print("{:34}{:28}{:>8}\n", fault.name, fault.section, seed);
    EXPECT_LE(seed, fault.budget) << fault.name;
  }
  EXPECT_GE(faults, 11);
}

}  // namespace
}  // namespace toolcomp::fuzz

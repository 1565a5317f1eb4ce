// SPDX-License-Identifier: Apache-2.0
// What the generators of directed cases give the judge to do.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "fuzz/gen/generator.h"
#include "judge/oracle/verdict.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_key.h"
#include "tests/effort.h"

namespace toolcomp::fuzz {
namespace {

const std::uint64_t kCases = test::effort(200U, 1000U);

struct Seen {
  std::uint64_t few = 0;          // cases with fewer than three events that are judged
  std::uint64_t alarms = 0;       // cases that end in one
  std::uint64_t early = 0;        // … in the first half of the program
  std::uint64_t first_block = 0;  // … before any other event
  std::uint64_t other_units = 0;  // setup in millimetres, program in inches, or the other way round
  std::uint64_t long_ones = 0;    // of 40 lines and more
  std::map<std::string, int> numbers;
};

std::uint64_t line_count(const spec::Case& c) {
  return static_cast<std::uint64_t>(std::ranges::count(c.program, '\n'));
}

void look_at(const spec::Case& c, Seen& seen) {
  const judge::ModelRun run = judge::run_model(c);
  std::size_t judged = 0;
  for (const model::Event& event : run.events) {
    if (event.kind == spec::EventKind::undecided) break;
    ++judged;
    if (event.kind != spec::EventKind::alarm) continue;
    ++seen.alarms;
    ++seen.numbers[std::string(event.number.view())];
    seen.early += 2 * event.line <= line_count(c) ? 1 : 0;
    seen.first_block += judged == 1 ? 1 : 0;
  }
  seen.few += judged < 3 ? 1 : 0;
  seen.long_ones += line_count(c) >= 40 ? 1 : 0;
  const bool mm = c.setup.units == spec::Units::mm;
  const bool inch_program = c.program.find(mm ? "G20" : "G21") != std::string::npos ||
                            (c.dialect == "klartext" && c.program.find(mm ? "INCH" : " MM") != std::string::npos);
  seen.other_units += inch_program ? 1 : 0;
}

Seen look(std::string_view section) {
  Seen seen;
  for (std::uint64_t seed = 1; seed <= kCases; ++seed) {
    SeededSource source(seed * 7919);
    look_at(generate(section, Mode::directed, source), seen);
  }
  return seen;
}

// The shares are ours to choose: they are what a search can live with, far from what the generators would give if what
// they make was not looked at (up to 37 %).
TEST(Generators, DirectedCasesGiveTheJudgeSomethingToDo) {
  for (const std::string_view section : sections()) {
    const Seen seen = look(section);
    const auto share = [](std::uint64_t n) { return 100.0 * static_cast<double>(n) / static_cast<double>(kCases); };
    fmt::print("{:34} fewer than three events {:.1f} %, alarms {:.1f} % ({} kinds), in the first half {:.1f} %\n",
               section, share(seen.few), share(seen.alarms), seen.numbers.size(), share(seen.early));
    if (!test::whole()) continue;  // too few cases for shares
    EXPECT_LE(share(seen.few), 5) << section;
    EXPECT_GE(share(seen.alarms), 5) << section;
    EXPECT_LE(3 * seen.early, seen.alarms) << section << ": alarms come late";
    EXPECT_GE(seen.first_block + seen.few, 1U) << section << ": and some at once";
    EXPECT_GE(seen.long_ones, 2U) << section;
    EXPECT_GE(share(seen.other_units), 1.5) << section;
  }
}

TEST(Generators, ChooseEveryValueOfEveryKey) {
  std::set<std::string> left;
  const auto name = [](const spec::KeyInfo& key, std::size_t value) {
    return std::string(key.id) + " = " + std::string(key.values[value]);
  };
  for (const spec::KeyInfo& key : spec::keys())
    for (std::size_t value = 0; value < key.values.size(); ++value) left.insert(name(key, value));
  for (const std::string_view section : sections())
    for (std::uint64_t seed = 1; seed <= kCases && !left.empty(); ++seed) {
      SeededSource source(seed);
      const spec::Case c = generate(section, Mode::directed, source);
      for (const spec::KeyInfo& key : spec::keys())
        if (key.is_of(c.setup.control)) left.erase(name(key, key.get(c.setup)));
    }
  for (const std::string& value : left) ADD_FAILURE() << "no generator chooses " << value;
}

// Lengths near the ends of the range, and pieces of arcs of more than a metre: I, J, K or R of seven digits and more.
TEST(Generators, ReachTheEndsOfTheRange) {
  for (const std::string_view section : sections()) {
    // Klartext has its own; most setups of tool side compensation begin at zero.
    if (section.starts_with("heidenhain/") || section == "fanuc/tool-side-compensation") continue;
    std::uint64_t far = 0;
    for (std::uint64_t seed = 1; seed <= kCases; ++seed) {
      SeededSource source(seed);
      const spec::Case c = generate(section, Mode::directed, source);
      far += std::ranges::any_of(c.setup.position,
                                 [](const auto& entry) {
                                   return entry.second.digits >= 99'999'997 && spec::is_linear_axis(entry.first);
                                 })
                 ? 1
                 : 0;
    }
    EXPECT_GE(far, 1U) << section;
  }
}

TEST(Generators, ReachArcsOfManyMetres) {
  for (const std::string_view section : {"fanuc/cutter-compensation-c", "fanuc/cutter-compensation-b",
                                         "fanuc/tool-side-compensation", "fanuc/tool-center-point-control"}) {
    std::uint64_t huge = 0;
    for (std::uint64_t seed = 1; seed <= kCases; ++seed) {
      SeededSource source(seed);
      const spec::Case c = generate(section, Mode::directed, source);
      try {
        for (const model::Event& event : judge::run_model(c).events) {
          if (event.kind != spec::EventKind::move || !event.arc || !event.arc->sweep) continue;
          // Half a degree and less: of a chord of millimetres that is a radius of metres.
          huge += event.arc->sweep->double_enclosure().upper < 0.5 ? 1 : 0;
        }
      } catch (const spec::InputError&) {
        continue;
      }
    }
    EXPECT_GE(huge, kCases / 500) << section;
  }
}

// Holes of drilling cycles: where the tool was beside the programmed position, and where its height was not known.
TEST(Generators, KlartextProgramsDrill) {
  std::uint64_t drilling = 0;
  std::uint64_t beside = 0;
  std::uint64_t unknown = 0;
  std::uint64_t higher = 0;
  for (const std::string_view section :
       {"heidenhain/face-milling", "heidenhain/peripheral-milling", "heidenhain/programmed-contour"})
    for (std::uint64_t seed = 1; seed <= kCases; ++seed) {
      SeededSource source(seed);
      const spec::Case c = generate(section, Mode::directed, source);
      const model::Event* before = nullptr;
      bool drills = false;
      const judge::ModelRun run = judge::run_model(c);
      for (const model::Event& event : run.events) {
        if (event.hole) {
          drills = true;
          higher += event.hole->level != event.hole->point_r ? 1U : 0U;
          unknown += before != nullptr && before->unknown != 0 ? 1U : 0U;
          for (std::size_t i = 0; before != nullptr && i < spec::kMaxAxes; ++i)
            beside +=
                event.point.has(i) && before->point.has(i) && event.point[i] != before->point[i] ? std::uint64_t{1} : 0;
        }
        if (event.hole || event.kind == spec::EventKind::move) before = &event;
      }
      drilling += drills ? 1U : 0U;
    }
  fmt::print("{} programs drill; holes beside the move before {}, from an unknown height {}, with a higher return {}\n",
             drilling, beside, unknown, higher);
  EXPECT_GE(drilling, 3 * kCases / 20);
  EXPECT_GE(beside, kCases / 100);
  EXPECT_GE(unknown, kCases / 100);
  EXPECT_GE(higher, kCases / 10);
}

// A slip is one change: the lines but one or two are those of the directed case of the same choices.
TEST(Generators, ASlipChangesOneWord) {
  for (const std::string_view section : sections()) {
    int changed = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      SeededSource a(seed);
      SeededSource b(seed);
      const std::string sound = generate(section, Mode::directed, a).program;
      const std::string slipped = generate_with_slip(section, b).program;
      changed += sound != slipped ? 1 : 0;
    }
    EXPECT_GE(changed, 130) << section;
  }
}

}  // namespace
}  // namespace toolcomp::fuzz

// SPDX-License-Identifier: Apache-2.0
// The law of moved origins (judge/laws) on generated programs of every section: it holds, and it is asked of those that
// change the workpiece system.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "judge/laws/changed_program.h"
#include "tests/property/fanuc/cutter_paths.h"

namespace toolcomp::laws {
namespace {

constexpr const char* kSectionsOfFanuc[] = {
    "fanuc/tool-length-offset",    "fanuc/tool-length-measurement",   "fanuc/tool-offset",
    "fanuc/cutter-compensation-b", "fanuc/cutter-compensation-c",     "fanuc/tool-side-compensation",
    "fanuc/leading-edge-offset",   "fanuc/tool-center-point-control", "fanuc/tool-posture-control"};

judge::laws::LawResult moved_origins(const spec::Case& c, const judge::ModelRun& run) {
  return judge::laws::hold_changed("moved-origins", c, run.events,
                                   [](const spec::Case& other) { return judge::run_model(other).events; });
}

bool selects_another_system(const std::string& word) {
  return is_one_of(word, {"G55", "G56", "G57", "G58", "G59", "G54.1"});
}

// The first move from the block on that selects another system; the number of events where there is none.
std::size_t move_in_another_system(const spec::Case& c, const judge::ModelRun& run) {
  const std::vector<std::string> text = fuzz::lines(c.program);
  const auto first =
      std::ranges::find_if(text, [](const std::string& l) { return has_word(l, selects_another_system); });
  const auto line = static_cast<std::uint64_t>(first - text.begin()) + 1;
  const auto move = std::ranges::find_if(
      run.events, [&](const model::Event& e) { return e.kind == EventKind::move && e.line >= line; });
  return static_cast<std::size_t>(move - run.events.begin());
}

// Nothing is asked behind what is left open.
bool is_open_before(const judge::ModelRun& run, std::size_t event) {
  return std::any_of(run.events.begin(), run.events.begin() + static_cast<std::ptrdiff_t>(event),
                     [](const model::Event& e) { return e.kind == EventKind::undecided; });
}

// Other systems here and there, with origins of their own.
spec::Case with_systems(spec::Case c) {
  std::vector<std::string> text = fuzz::lines(c.program);
  for (std::string& line : text)
    if (*rc::gen::inRange(0, 3) == 0)
      line += *rc::gen::element<std::string>(" G54", " G55", " G59", " G54.1 P1", " G54.1 P48");
  c.program = fuzz::joined(text);
  for (const std::size_t system : {0U, 1U, 5U})
    for (const char letter : c.setup.axes.letters())
      if (spec::is_linear_axis(letter))
        c.setup.workpiece.at(system)[letter] = spec::decimal(*rc::gen::inRange(-99, 100));
  return c;
}

RC_GTEST_PROP(LawOfMovedOrigins, HoldsWhereverSystemsChange, ()) {
  const spec::Case c = with_systems(generated(
      *rc::gen::elementOf(std::vector<std::string_view>(std::begin(kSectionsOfFanuc), std::end(kSectionsOfFanuc)))));
  const auto run = model_run(c);
  RC_PRE(run.has_value());
  const judge::laws::LawResult verdict = moved_origins(c, *run);
  RC_CLASSIFY(verdict.checks > 0, "asked");
  if (verdict.violation)
    RC_LOG() << fuzz::encode(c) << "line " << verdict.violation->line << ": " << verdict.violation->text << ": "
             << verdict.violation->amount;
  RC_ASSERT(!verdict.violation);
}

// The block that cancels selects a system: the corner at its start is in the coordinates of the block.
RC_GTEST_PROP(LawOfMovedOrigins, HoldsWhereTheCancelSelectsASystem, ()) {
  const std::string section = *rc::gen::element(kToolSide, std::string("fanuc/cutter-compensation-b"),
                                                std::string("fanuc/cutter-compensation-c"));
  Writing how;
  how.absolute = *rc::gen::arbitrary<bool>();
  how.right = *rc::gen::arbitrary<bool>();
  spec::Case c = make(section, any_path(), how);
  c.program.insert(c.program.size() - 1, " G59");
  c.setup.workpiece[5]['X'] = spec::decimal(*rc::gen::inRange(-99, 100));
  const auto run = model_run(c);
  RC_LOG() << fuzz::encode(c);
  const judge::laws::LawResult verdict = moved_origins(c, *run);
  RC_ASSERT(verdict.checks > 0);
  RC_ASSERT(!verdict.violation);
  fast_agrees(c, *run);
}

// Of the programs that generators make, those that move in another system are asked it but for few.
TEST(LawOfMovedOrigins, IsAskedWhereGeneratedProgramsChangeTheSystem) {
  constexpr std::uint64_t programs = 400;
  std::uint64_t all_reached = 0;
  std::uint64_t all_asked = 0;
  for (const char* const section : kSectionsOfFanuc) {
    std::uint64_t reached = 0;
    std::uint64_t asked = 0;
    for (std::uint64_t seed = 1; seed <= programs; ++seed) {
      fuzz::SeededSource source(seed);
      const spec::Case c =
          fuzz::generate(section, seed % 2 == 0 ? fuzz::Mode::directed : fuzz::Mode::unrestricted, source);
      if (!has_word(c.program, selects_another_system)) continue;
      try {
        const judge::ModelRun run = judge::run_model(c);
        const std::size_t move = move_in_another_system(c, run);
        if (move == run.events.size()) continue;
        ++reached;
        const judge::laws::LawResult verdict = moved_origins(c, run);
        EXPECT_FALSE(verdict.violation) << c.program << verdict.violation->text;
        if (verdict.checks > 0 && !is_open_before(run, move)) ++asked;
      } catch (const std::exception&) {  // NOLINT(bugprone-empty-catch): no run, nothing to ask
      }
    }
    std::printf("%-32s %llu of %llu programs move in another system, %llu are asked\n", section,
                static_cast<unsigned long long>(reached), static_cast<unsigned long long>(programs),
                static_cast<unsigned long long>(asked));
    all_reached += reached;
    all_asked += asked;
  }
  EXPECT_GE(all_reached, 40U);
  EXPECT_GE(4 * all_asked, 3 * all_reached);
}

}  // namespace
}  // namespace toolcomp::laws

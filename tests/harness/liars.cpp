// Acceptance of the harness: controllers that lie in one number of one event in one case of a hundred must be found,
// and those that do nothing wrong must not be accused. The answers are the model's own, as doubles and as decimals, so
// what is expected is known without computing it: a lie is a difference, its absence is none.
//
// TOOLCOMP_LIARS=1000 takes as many cases a section as `certify` does (minutes); without it a few tens.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <set>

#include "certify/selection.h"
#include "fuzz/gen/generator.h"
#include "fuzz/oracle/compare.h"
#include "tests/harness/liar.h"
#include "tests/sanitized.h"

namespace toolcomp::fuzz {
namespace {

std::size_t number_of_cases() {
  const char* const wanted = std::getenv("TOOLCOMP_LIARS");  // NOLINT(concurrency-mt-unsafe): one thread
  if (wanted != nullptr) return std::strtoul(wanted, nullptr, 10);
  return test::kSanitized ? 20 : 60;
}

constexpr std::size_t kLiars = 40;  // a section
constexpr double kLies[] = {1e-6, 1e-3, 1, 1e5};

// A case of a section and what an honest controller answers.
struct Honest {
  spec::Case c;
  ModelRun run;
  bool judged_whole = false;  // nothing in it was granted more than the cap
  bool narrow = false;        // … nor more than a nanometre
};

// Where a lie is looked for: the state of the control, or how the tool stands.
enum class Where : std::uint8_t { anywhere, after_cancel, after_q, near_singular, at_singular };
constexpr Where kWheres[] = {Where::anywhere, Where::after_cancel, Where::after_q, Where::near_singular,
                             Where::at_singular};

bool after(const spec::Case& c, std::string_view word, std::uint64_t line) {
  std::size_t at = 0;
  for (std::uint64_t n = 1; n < line && at != std::string::npos; ++n) {
    const std::size_t end = c.program.find('\n', at);
    if (std::string_view(c.program).substr(at, end - at).find(word) != std::string_view::npos) return true;
    at = end == std::string::npos ? end : end + 1;
  }
  return false;
}

bool is_there(Where where, const spec::Case& c, const spec::Event<double>& e) {
  constexpr double near = 0.02;  // of a unit vector: a degree or so
  const double beside =
      e.tool_axis ? std::hypot((*e.tool_axis)[0], (*e.tool_axis)[1]) : std::numeric_limits<double>::infinity();
  switch (where) {
    case Where::anywhere:
      return true;
    case Where::after_cancel:
      return after(c, "G49", e.line);
    case Where::after_q:
      return after(c, "Q", e.line);
    case Where::near_singular:
      return beside > 0 && beside < near;
    case Where::at_singular:
      return beside == 0;
  }
  return false;
}

template <class Event>
Verdict judged(const Honest& honest, const std::vector<Event>& answer) {
  return judge(honest.c, honest.run, std::span<const Event>(answer));
}

// One liar: a field, a size, a form of numbers, a preference of where.
struct Liar {
  std::string field;
  double by = 0;
  bool decimals = false;
  Where where = Where::anywhere;
};

struct Told {
  bool told = false;
  bool found = false;
  bool undecided = false;  // exit status 3: no pass, and no finding either
  std::string what;
};

template <class Event>
Told tell(const Honest& honest, std::vector<Event> answer, const std::vector<spec::Event<double>>& seen,
          const Liar& liar, SeededSource& source) {
  auto all = test::places(answer, honest.c.setup.axes);
  std::erase_if(all, [&](const auto& place) {
    return place.field != liar.field || !is_there(liar.where, honest.c, seen[place.event]);
  });
  if (all.empty()) return {};
  const auto place = all[source.below(all.size())];
  place.add(source.below(2) == 0 ? liar.by : -liar.by);
  const Verdict v = judged(honest, answer);
  return {true, v.outcome == Outcome::differs, v.outcome == Outcome::undecided,
          fmt::format("{}, event {}, {} off by {} {}\n{}", honest.c.id, place.event, liar.field, liar.by, v.undecided,
                      honest.c.program)};
}

Told tell(const Honest& honest, const Liar& liar, SeededSource& source) {
  const std::vector<spec::Event<double>> seen = test::in_doubles(honest.run);
  return liar.decimals ? tell(honest, test::in_texts(honest.run), seen, liar, source)
                       : tell(honest, seen, seen, liar, source);
}

// Lies in one case of a hundred, in the first that has the place it wants; found if one of the lies is.
Told lie_in_cases(const std::vector<Honest>& cases, const Liar& liar, SeededSource& source) {
  const std::size_t lies = (cases.size() + 99) / 100;
  const std::size_t first = source.below(cases.size());
  Told result;
  std::size_t told = 0;
  for (std::size_t i = 0; i < cases.size() && told < lies; ++i) {
    const Honest& honest = cases[(first + i) % cases.size()];
    // What is granted a nanometre cannot be told from a lie of one.
    if (!(liar.by < kLies[1] ? honest.narrow : honest.judged_whole)) continue;
    const Told one = tell(honest, liar, source);
    if (!one.told) continue;
    ++told;
    result.told = true;
    result.found = result.found || one.found;
    result.undecided = result.undecided || one.undecided;
    if (!one.found) result.what = one.what;
  }
  return result;
}

class Liars : public testing::TestWithParam<std::string_view> {
 protected:
  void SetUp() override {
    for (spec::Case& c : certify::select_cases(GetParam(), 77, number_of_cases()).cases) {
      Honest honest{std::move(c), {}, false};
      honest.run = run_model(honest.c);
      cases_.push_back(std::move(honest));
    }
  }

  std::vector<Honest> cases_;
};

// Both forms in which a controller can send numbers: neither is accused of anything; and the liars of the section.
TEST_P(Liars, AreFoundAndTheModelIsNotAccused) {
  std::set<std::string> fields;
  std::size_t whole = 0;
  for (Honest& honest : cases_) {
    std::vector<spec::Event<double>> doubles = test::in_doubles(honest.run);
    for (const auto& place : test::places(doubles, honest.c.setup.axes)) fields.insert(place.field);
    const Verdict a = judged(honest, doubles);
    EXPECT_NE(a.outcome, Outcome::differs) << explain(*a.difference) << '\n' << honest.c.program;
    const Verdict b = judged(honest, test::in_texts(honest.run));
    EXPECT_NE(b.outcome, Outcome::differs) << explain(*b.difference) << '\n' << honest.c.program;
    honest.judged_whole = a.outcome == Outcome::agrees && b.outcome == Outcome::agrees && a.wide == 0 && b.wide == 0;
    honest.narrow = honest.judged_whole && a.widths.share_above_nm() == 0;
    whole += honest.judged_whole ? 1 : 0;
  }
  EXPECT_GE(10 * whole, 5 * cases_.size()) << "cases in which every value is judged";
  std::size_t made = 0;
  std::size_t found = 0;
  std::size_t undecided = 0;
  const std::vector<std::string> names(fields.begin(), fields.end());
  SeededSource source(GetParam().size() * 1000 + cases_.size());
  // Every field with every size comes before any comes twice; those that have no place there take any.
  for (std::size_t k = 0; made < kLiars && k < 8 * kLiars; ++k) {
    Liar liar{names[k % names.size()], kLies[(k / names.size() + k) % std::size(kLies)], source.below(2) == 0,
              kWheres[source.below(std::size(kWheres))]};
    Told told = lie_in_cases(cases_, liar, source);
    if (!told.told) {
      liar.where = Where::anywhere;
      told = lie_in_cases(cases_, liar, source);
    }
    if (!told.told) continue;
    ++made;
    found += told.found ? 1 : 0;
    undecided += told.found || !told.undecided ? 0 : 1;
    EXPECT_TRUE(told.found || told.undecided) << told.what;
    if (!told.found && told.undecided) fmt::print("not decided: {}", told.what);
  }
  fmt::print("{:34} {} cases, {} judged whole, {} fields, {} of {} liars found, {} not decided\n", GetParam(),
             cases_.size(), whole, names.size(), found, made, undecided);
  // Where a program is full of near ties the forks of the judge may run out before a lie is one: exit status 3.
  EXPECT_LE(10 * undecided, kLiars);
  EXPECT_EQ(made, kLiars);
}

INSTANTIATE_TEST_SUITE_P(Sections, Liars, testing::ValuesIn(sections().begin(), sections().end()),
                         [](const auto& section) {
                           std::string name(section.param);
                           std::ranges::replace_if(name, [](char c) { return c == '/' || c == '-'; }, '_');
                           return name;
                         });

// A run of the model with some of its near ties taken otherwise: what a controller of other rounding gives.
ModelRun decided_otherwise(const spec::Case& c, SeededSource& source, std::uint64_t of_eight, std::size_t& otherwise) {
  const Rules rules(c.setup, c.section, {});
  Forced forced;
  ModelRun run = run_model(c);
  for (std::size_t i = 0; i < run.recorder.decisions().size(); ++i) {
    PositionErrors positions(c.setup);
    for (const model::Event& event : run.events) positions.follow(event);
    const model::Decision& decision = run.recorder.decisions()[i];
    if (!rules.is_near_tie(decision, policy::kDoubleBand, positions) || source.below(8) >= of_eight) continue;
    constexpr exact::Sign signs[] = {exact::Sign::negative, exact::Sign::zero, exact::Sign::positive};
    const exact::Sign outcome = signs[source.below(3)];
    if (outcome == decision.outcome) continue;
    Forced more = forced;
    more[i] = outcome;
    try {
      ModelRun other = run_model(c, more);
      // Neither an answer nor permitted.
      if (!other.events.empty() && other.events.back().kind == spec::EventKind::undecided) continue;
      run = std::move(other);
      forced = std::move(more);
    } catch (const std::exception&) {
      continue;  // no finite vectors
    }
  }
  otherwise = forced.size();
  return run;
}

TEST_P(Liars, WhoDecideNearTiesOtherwiseAreNotAccused) {
  SeededSource source(GetParam().size());
  std::size_t otherwise = 0;
  std::size_t accused = 0;
  std::size_t undecided = 0;
  std::size_t controllers = 0;
  for (const Honest& honest : cases_)
    for (const std::uint64_t of_eight : {1U, 4U, 8U}) {
      std::size_t n = 0;
      const ModelRun other = decided_otherwise(honest.c, source, of_eight, n);
      if (n == 0) continue;
      ++controllers;
      otherwise += n;
      const Verdict v = judged(honest, test::in_doubles(other));
      accused += v.outcome == Outcome::differs ? 1 : 0;
      undecided += v.outcome == Outcome::undecided ? 1 : 0;
      if (v.outcome == Outcome::differs) fmt::print("accused: {} {} {}\n{}\n", honest.c.id, n, explain(*v.difference), honest.c.program);
    }
  fmt::print("{:34} {} controllers, {} near ties otherwise, {} accused, {} not decided\n", GetParam(), controllers,
             otherwise, accused, undecided);
  EXPECT_EQ(accused, 0U);
}

// A tool 1e-13 off the work-side axis, which no double can tell from one on it: a head whose C axis carries B. On it C
// may stand anywhere and keeps its position; off it C goes to the azimuth of the tool. A control may do either.
TEST(Singular, AControlMayTakeTheOtherWorkSidePosition) {
  Honest honest;
  spec::Case& c = honest.c;
  c.id = "singular";
  c.section = "fanuc/tool-center-point-control";
  c.setup.axes = spec::Axes("XYZBC");
  for (const auto& [number, value] :
       {std::pair{19680U, 2}, std::pair{19681U, 5}, std::pair{19682U, 3}, std::pair{19686U, 4}, std::pair{19687U, 2}})
    c.setup.parameters[{number, -1}] = spec::decimal(value);
  c.setup.h[1] = {spec::decimal(50), {}};
  c.program =
      "G90 G00 X0 Y0 Z100. B0 C0\nG43.5 H1 I0 J0 K1.\nG01 X10. I0 J3. K4. F1000\nX20. Y5. I.00001 J0 K100000000.\n";
  honest.run = run_model(c);
  const std::vector<spec::Event<double>> exact = test::in_doubles(honest.run);
  ASSERT_EQ(judged(honest, exact).outcome, Outcome::agrees);
  // The last question of the clause, answered the other way.
  std::optional<std::size_t> question;
  const auto& decisions = honest.run.recorder.decisions();
  for (std::size_t i = 0; i < decisions.size(); ++i)
    if (decisions[i].clause == spec::Clause::fanuc_tool_center_point_parallel_to_the_work_side) question = i;
  ASSERT_TRUE(question);
  const ModelRun other = run_model(c, {{*question, exact::Sign::zero}});
  const std::vector<spec::Event<double>> stays = test::in_doubles(other);
  const std::size_t c_axis = c.setup.axes.index('C');
  ASSERT_GT(std::fabs(stays.back().axes[c_axis] - exact.back().axes[c_axis]), 10) << "another position, by hand 90";
  EXPECT_EQ(judged(honest, stays).outcome, Outcome::agrees);
  // A lie in the other position is one, too.
  for (const double by : kLies) {
    std::vector<spec::Event<double>> liar = stays;
    test::lie_in_axis(liar.back().axes, c.setup.axes.index('B'), by);
    EXPECT_EQ(judged(honest, liar).outcome, Outcome::differs) << by;
  }
}

}  // namespace
}  // namespace toolcomp::fuzz

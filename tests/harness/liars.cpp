// SPDX-License-Identifier: Apache-2.0
// Acceptance of the harness: controllers that lie in one value of one event in one case of a hundred must be found,
// and those that do nothing wrong must not be accused, however they decide near ties. The answers are the model's own,
// as doubles and as decimals, so what is expected is known without computing it: a lie is a difference, its absence is
// none.
//
// TOOLCOMP_LIARS=1000 takes as many cases a section as `certify` does (minutes); without it a few tens.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "certify/selection.h"
#include "fuzz/gen/generator.h"
#include "judge/oracle/number.h"
#include "judge/oracle/pairing.h"
#include "tests/effort.h"
#include "tests/harness/liar.h"

namespace toolcomp::judge {
namespace {

std::size_t number_of_cases() {
  const char* const wanted = std::getenv("TOOLCOMP_LIARS");  // NOLINT(concurrency-mt-unsafe): one thread
  if (wanted != nullptr) return std::strtoul(wanted, nullptr, 10);
  return test::effort(20U, 50U);
}

constexpr std::size_t kLiars = 40;  // a section
constexpr double kLies[] = {1e-6, 1e-3, 1, 1e5};

// A case of a section and what an honest controller answers.
struct Honest {
  spec::Case c;
  ModelRun run;
  std::vector<spec::Event<double>> doubles;
  std::vector<spec::TextEvent> texts;
  bool judged = false;  // to its end, in both forms
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
      return c.setup.control == spec::Control::fanuc && after(c, "Q", e.line);
    case Where::near_singular:
      return beside > 0 && beside < near;
    case Where::at_singular:
      return beside == 0;
  }
  return false;
}

template <class Event>
Verdict judged(const Honest& honest, const std::vector<Event>& answer) {
  return judge::judge(honest.c, honest.run, std::span<const Event>(answer));
}

// How far a value may lie off, in micrometres; what turns counts as what it moves at one metre. Of a field of an event
// the widest component counts; where two conditions place it (head.h) it may slide along them; a rotary position may
// be off as its posture has it, and of one in a line without commanded direction that is no more than it is rounded.
double width(const Honest& honest, const test::Place& place) {
  const spec::Case& c = honest.c;
  const ProgramFacts facts = ProgramFacts::of(c);
  Rules rules(c.setup, c.section, {{place.field}, {}});
  if (facts.units()) rules.units(*facts.units());
  Pairing<double> pairing(rules, c.setup, &facts);
  Conditions conditions(c.setup, &facts);
  const std::span<const model::Event> events(honest.run.events);
  for (std::size_t i = 0; i < place.event; ++i) {
    Tally unused;
    pairing.next(events.subspan(i), honest.doubles[i], unused);
    conditions.next(events.subspan(i));
  }
  Tally tally;
  pairing.next(events.subspan(place.event), honest.doubles[place.event], tally);
  const Scale scale = conditions.next(events.subspan(place.event));
  double um = tally.widths.largest();
  if (place.measure == test::Measure::length)
    for (const Head& head : scale.heads)
      um = std::max(um, rules.budget().coordinate * head.reach * rules.um_per_unit());
  const auto machine = RotaryMachine::of(c.setup);
  const model::Event& event = events[place.event];
  if (place.rotary && machine && machine->tool != spec::Axes::kNone && event.axes.has(machine->tool)) {
    RotaryZeros zeros(c.setup, machine);
    for (std::size_t i = 0; i <= place.event; ++i) zeros.follow(events[i]);
    const Posture posture(*machine, approximate(event.axes[machine->tool]) + zeros.tool());
    const double error = std::max(policy::ulp(1), scale.pose.direction);
    const double radians = std::max(posture.tool_error(error), posture.work_error(error));
    um = std::max(um, rules.budget().rotary * radians * policy::kMicrometresAtOneMetre);
  }
  return um;
}

// The same of a lie.
double size(const Honest& honest, const test::Place& place, double by) {
  constexpr double radians_per_degree = 0.017453292519943295;
  switch (place.measure) {
    case test::Measure::length: {
      const spec::Units units = ProgramFacts::of(honest.c).units().value_or(honest.c.setup.units);
      return by * (units == spec::Units::mm ? 1e3 : 25.4e3);
    }
    case test::Measure::angle:
      return by * radians_per_degree * policy::kMicrometresAtOneMetre;
    case test::Measure::direction:
      return by * policy::kMicrometresAtOneMetre;
    case test::Measure::exact:
      return std::numeric_limits<double>::infinity();
  }
  return 0;
}

// Only what is known well below the lie.
bool can_be_told(const Honest& honest, const test::Place& place, double by) {
  constexpr double well_below = 8;
  return place.measure == test::Measure::exact || size(honest, place, by) > well_below * width(honest, place);
}

// One liar: a field, a size, a form of numbers, a preference of where.
struct Liar {
  std::string field;
  double by = 0;
  bool decimals = false;
  Where where = Where::anywhere;
};

struct Told {
  std::size_t told = 0;
  std::size_t found = 0;
  std::size_t undecided = 0;  // exit status 3: no pass, and no finding either
  std::string what;
};

template <class Event>
void tell(const Honest& honest, std::vector<Event> answer, const Liar& liar, fuzz::SeededSource& source, Told& result) {
  auto all = test::places(answer, honest.c.setup.axes);
  std::erase_if(all, [&](const test::Place& place) {
    return place.name() != liar.field || !is_there(liar.where, honest.c, honest.doubles[place.event]);
  });
  // A few of them are looked at.
  for (std::size_t tries = 0; tries < 4 && !all.empty(); ++tries) {
    const auto place = all[source.below(all.size())];
    if (!can_be_told(honest, place, liar.by)) continue;
    place.add(source.below(2) == 0 ? liar.by : -liar.by);
    const Verdict v = judged(honest, answer);
    ++result.told;
    result.found += v.outcome == Outcome::differs ? 1 : 0;
    result.undecided += v.outcome == Outcome::undecided ? 1 : 0;
    if (v.outcome != Outcome::differs)
      result.what += fmt::format("{}, event {}, {} off by {} {}\n{}\n", honest.c.id, place.event, liar.field, liar.by,
                                 v.undecided, honest.c.program);
    return;
  }
}

// Lies in one case of a hundred, in the first that has the place it wants.
Told lie_in_cases(const std::vector<Honest>& cases, const Liar& liar, fuzz::SeededSource& source) {
  const std::size_t lies = (cases.size() + 99) / 100;
  const std::size_t first = source.below(cases.size());
  Told result;
  for (std::size_t i = 0; i < cases.size() && result.told < lies; ++i) {
    const Honest& honest = cases[(first + i) % cases.size()];
    if (!honest.judged) continue;
    if (liar.decimals)
      tell(honest, honest.texts, liar, source, result);
    else
      tell(honest, honest.doubles, liar, source, result);
  }
  return result;
}

class Liars : public testing::TestWithParam<std::string_view> {
 protected:
  static std::vector<Honest> cases(std::size_t count) {
    std::vector<Honest> cases;
    for (spec::Case& c : certify::select_cases(GetParam(), 77, count).cases) {
      Honest honest{std::move(c), {}, {}, {}};
      honest.run = run_model(honest.c);
      honest.doubles = test::in_doubles(honest.run);
      honest.texts = test::in_texts(honest.run);
      cases.push_back(std::move(honest));
    }
    return cases;
  }
};

// Both forms in which a controller can send numbers: neither is accused of anything; and the liars of the section.
TEST_P(Liars, AreFoundAndTheModelIsNotAccused) {
  std::vector<Honest> honests = cases(number_of_cases());
  std::set<std::string> fields;
  std::set<Where> wheres;
  std::size_t whole = 0;
  for (Honest& honest : honests) {
    const Verdict a = judged(honest, honest.doubles);
    EXPECT_NE(a.outcome, Outcome::differs) << explain(*a.difference) << '\n' << honest.c.program;
    const Verdict b = judged(honest, honest.texts);
    EXPECT_NE(b.outcome, Outcome::differs) << explain(*b.difference) << '\n' << honest.c.program;
    honest.judged = a.outcome == Outcome::agrees && b.outcome == Outcome::agrees;
    if (!honest.judged) continue;
    whole += a.wide == 0 && b.wide == 0 ? 1 : 0;
    for (const auto& place : test::places(honest.doubles, honest.c.setup.axes)) fields.insert(place.name());
    for (const auto& event : honest.doubles)
      for (const Where where : kWheres)
        if (is_there(where, honest.c, event)) wheres.insert(where);
  }
  EXPECT_GE(10 * whole, 5 * honests.size()) << "cases in which every value is judged";
  std::size_t made = 0;
  Told all;
  std::map<Where, std::size_t> told_at;
  std::set<std::string> told_in;
  const std::vector<std::string> names(fields.begin(), fields.end());
  fuzz::SeededSource source(GetParam().size() * 1000 + honests.size());
  // Every field comes before any comes twice; those that have no place there take any.
  for (std::size_t k = 0; made < kLiars && k < 8 * kLiars; ++k) {
    Liar liar{names[k % names.size()], kLies[(k / names.size() + k) % std::size(kLies)], source.below(2) == 0,
              kWheres[source.below(std::size(kWheres))]};
    Told told = lie_in_cases(honests, liar, source);
    if (told.told == 0) {
      liar.where = Where::anywhere;
      told = lie_in_cases(honests, liar, source);
    }
    // Of what is left open a controller's decimals are not judged.
    if (told.told == 0) {
      liar.decimals = false;
      told = lie_in_cases(honests, liar, source);
    }
    // No value of the field is known that well.
    for (const double by : kLies) {
      if (told.told > 0 || by <= liar.by) continue;
      liar.by = by;
      told = lie_in_cases(honests, liar, source);
    }
    if (told.told == 0) continue;
    ++made;
    ++told_at[liar.where];
    told_in.insert(liar.field);
    all.told += told.told;
    all.found += told.found;
    all.undecided += told.undecided;
    EXPECT_EQ(told.found, told.told) << told.what;
  }
  fmt::print(
      "{:34} {} cases, {} judged whole; {} liars, {} of {} fields, {} after G49, {} after Q, {} near and {} at "
      "singular; {} of {} lies found, {} not decided\n",
      GetParam(), honests.size(), whole, made, told_in.size(), names.size(), told_at[Where::after_cancel],
      told_at[Where::after_q], told_at[Where::near_singular], told_at[Where::at_singular], all.found, all.told,
      all.undecided);
  EXPECT_EQ(all.undecided, 0U);
  EXPECT_EQ(made, kLiars);
  for (const Where where : wheres)
    EXPECT_TRUE(told_at[where] > 0 || number_of_cases() < 60) << "place " << static_cast<int>(where);
  for (const std::string& name : names) EXPECT_TRUE(told_in.contains(name)) << name;
}

// A run of the model with some of its near ties taken otherwise, as a controller whose numbers are rounded otherwise
// may: so many of eight, or all those that choose between rotary
// positions. Nothing where none was.
constexpr std::uint64_t kPositions = 0;
std::optional<ModelRun> decided_otherwise(const spec::Case& c, fuzz::SeededSource& source, std::uint64_t of_eight) {
  const auto chooses_position = [](spec::Clause clause) {
    return policy::compares_positions(clause) ||
           clause == spec::Clause::fanuc_tool_center_point_parallel_to_the_work_side;
  };
  const Rules rules(c.setup, c.section, {});
  Forced forced;
  ModelRun run = run_model(c);
  for (std::size_t i = 0; i < run.recorder.decisions().size(); ++i) {
    PositionErrors positions(c.setup);
    for (const model::Event& event : run.events) positions.follow(event);
    const model::Decision& decision = run.recorder.decisions()[i];
    if (!rules.is_near_tie(decision, policy::kDoubleBand, positions)) continue;
    if (of_eight == kPositions ? !chooses_position(decision.clause) : source.below(8) >= of_eight) continue;
    constexpr exact::Sign signs[] = {exact::Sign::negative, exact::Sign::zero, exact::Sign::positive};
    const exact::Sign outcome = signs[source.below(3)];
    if (outcome == decision.outcome) continue;
    Forced more = forced;
    more[i] = outcome;
    try {
      ModelRun other = run_model(c, more);
      // A run that is not decided is no answer.
      if (!other.events.empty() && other.events.back().kind == spec::EventKind::undecided) continue;
      run = std::move(other);
      forced = std::move(more);
    } catch (const std::exception&) {
      continue;  // no finite vectors: not permitted
    }
  }
  if (forced.empty()) return std::nullopt;
  return run;
}

// Not even those that take another rotary position wherever one is as good (at a singular posture, the other one), or
// all of their near ties otherwise.
TEST_P(Liars, WhoDecideNearTiesOtherwiseAreNotAccused) {
  fuzz::SeededSource source(GetParam().size());
  std::size_t controllers = 0;
  std::size_t undecided = 0;
  std::size_t of_position = 0;
  for (const Honest& honest : cases(number_of_cases() / 4)) {
    for (const std::uint64_t of_eight : {kPositions, std::uint64_t{1}, std::uint64_t{4}, std::uint64_t{8}}) {
      const std::optional<ModelRun> other = decided_otherwise(honest.c, source, of_eight);
      if (!other) continue;
      ++controllers;
      of_position += of_eight == kPositions ? 1 : 0;
      const Verdict v = judged(honest, test::in_doubles(*other));
      undecided += v.outcome == Outcome::undecided ? 1 : 0;
      EXPECT_NE(v.outcome, Outcome::differs) << honest.c.id << ", " << of_eight << '\n'
                                             << explain(*v.difference) << '\n'
                                             << honest.c.program;
    }
  }
  fmt::print(
      "{:34} {} controllers that decide near ties otherwise, {} of them take other rotary positions; {} not "
      "decided\n",
      GetParam(), controllers, of_position, undecided);
  EXPECT_LE(100 * undecided, controllers);
}

INSTANTIATE_TEST_SUITE_P(Sections, Liars, testing::ValuesIn(fuzz::sections().begin(), fuzz::sections().end()),
                         [](const auto& section) {
                           std::string name(section.param);
                           std::ranges::replace_if(name, [](char c) { return c == '/' || c == '-'; }, '_');
                           return name;
                         });

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
}  // namespace toolcomp::judge

// SPDX-License-Identifier: Apache-2.0
// The comparator must see every kind of wrong answer. Events here are made by hand: no engine is involved.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "certify/convert.h"
#include "judge/oracle/policy.h"
#include "judge/oracle/verdict.h"

namespace toolcomp::judge {
namespace {

using exact::Rational;
using exact::Real;
using spec::AxisValues;

constexpr std::size_t kAxes = 4;  // X Y Z C

template <class Number>
AxisValues<Number> values(std::initializer_list<Number> numbers) {
  AxisValues<Number> v;
  std::size_t axis = 0;
  for (const Number& n : numbers) v.set(axis++, n);
  return v;
}

// Numbers that are exact in double: eighths.
template <class Number>
Number eighths(int n) {
  return Number(n) / Number(8);
}

// One event of each kind, every field in use.
template <class Number>
std::vector<spec::Event<Number>> events() {
  using Event = spec::Event<Number>;
  const auto e = [](int n) { return eighths<Number>(n); };
  std::vector<Event> list;

  Event rapid;
  rapid.line = 1;
  rapid.type = spec::MoveType::rapid;
  rapid.cause = spec::Cause::reference;
  rapid.programmed = values<Number>({e(80), e(-16), e(5)});
  rapid.point = values<Number>({e(80), e(-16), e(5)});
  rapid.axes = values<Number>({e(80), e(-16), e(5), e(240)});
  rapid.machine = values<Number>({e(880), e(784), e(-795), e(240)});
  list.push_back(rapid);

  Event linear;
  linear.line = 2;
  linear.n = 20;
  linear.programmed = values<Number>({e(800), e(0), e(0)});
  linear.point = values<Number>({e(736), e(0), e(48)});
  linear.axes = values<Number>({e(736), e(0), e(148), e(720)});
  linear.tool_axis = {Number(3) / Number(8), Number(0), Number(5) / Number(8)};  // the length is not judged
  linear.feed = Number(1000);
  list.push_back(linear);

  Event arc;
  arc.line = 3;
  arc.n = 30;
  arc.type = spec::MoveType::arc;
  arc.programmed = values<Number>({e(880), e(80), e(0)});
  arc.point = values<Number>({e(880), e(80), e(0)});
  arc.axes = values<Number>({e(880), e(80), e(0), e(720)});
  arc.arc.emplace();
  arc.arc->center.set(0, e(800));
  arc.arc->center.set(1, e(80));
  arc.arc->plane = spec::Plane::xy;
  arc.arc->direction = spec::ArcDirection::ccw;
  arc.arc->sweep = Number(90);
  arc.arc->radius = std::pair(e(80), e(88));
  arc.feed = Number(500);
  list.push_back(arc);

  Event sample;
  sample.kind = spec::EventKind::sample;
  sample.line = 4;
  sample.t_numerator = 1;
  sample.t_denominator = 4;
  sample.point = values<Number>({e(8), e(16), e(24)});
  sample.axes = values<Number>({e(8), e(16), e(24), e(32)});
  sample.tool_axis = {Number(0), Number(0), Number(1)};
  list.push_back(sample);

  Event setting;
  setting.kind = spec::EventKind::setting;
  setting.line = 5;
  setting.setting = "H1.wear";
  setting.value = e(-4);
  list.push_back(setting);

  Event warning;
  warning.kind = spec::EventKind::warning;
  warning.line = 6;
  warning.n = 60;
  warning.number = "ARC_PLANE_MISMATCH";
  list.push_back(warning);

  Event alarm;
  alarm.kind = spec::EventKind::alarm;
  alarm.line = 6;
  alarm.n = 60;
  alarm.number = "PS5407";
  list.push_back(alarm);
  return list;
}

spec::Case plain_case() {
  spec::Case c;
  c.section = "fanuc/leading-edge-offset";
  c.setup.axes = spec::Axes("XYZC");
  return c;
}

ModelRun expected() {
  ModelRun run;
  run.events = events<Real>();
  return run;
}

Verdict verdict(const std::vector<fast::Event>& actual, const JudgeOptions& options = {}) {
  return judge::judge(plain_case(), expected(), actual, options);
}

// A wrong answer, and the field in which it is wrong; empty: the list itself.
struct Wrong {
  std::string what;
  std::string field;
  std::function<void(std::vector<fast::Event>&)> apply;
};

constexpr double kNanometre = 1e-6;  // mm
constexpr double kSmall = 1e-9;      // a value this far off is far outside the policy (some 1e-14)

std::vector<Wrong> wrong_answers() {
  std::vector<Wrong> list = {
      {"first event dropped", "", [](auto& e) { e.erase(e.begin()); }},
      {"middle event dropped", "", [](auto& e) { e.erase(e.begin() + 2); }},
      {"last event dropped", "", [](auto& e) { e.pop_back(); }},
      {"all events dropped", "", [](auto& e) { e.clear(); }},
      {"event doubled", "", [](auto& e) { e.insert(e.begin() + 1, fast::Event(e[1])); }},
      {"event added at the end", "", [](auto& e) { e.push_back(fast::Event(e[1])); }},
      {"two events swapped", "", [](auto& e) { std::swap(e[1], e[2]); }},
      {"kind", "", [](auto& e) { e[3].kind = spec::EventKind::move; }},
      {"alarm becomes warning", "", [](auto& e) { e[6].kind = spec::EventKind::warning; }},
      {"line of a move", "", [](auto& e) { e[1].line = 3; }},
      {"line of an alarm", "", [](auto& e) { e[6].line = 7; }},
      {"sequence number changed", "n", [](auto& e) { e[1].n = 21; }},
      {"sequence number lost", "n", [](auto& e) { e[1].n.reset(); }},
      {"sequence number of a sample", "n", [](auto& e) { e[3].n = 40; }},
      {"sequence number of a setting", "n", [](auto& e) { e[4].n = 50; }},
      {"sequence number of a warning lost", "n", [](auto& e) { e[5].n.reset(); }},
      {"sequence number of an alarm", "n", [](auto& e) { e[6].n = 61; }},
      {"line of a setting", "", [](auto& e) { e[4].line = 4; }},
      {"line of a warning", "", [](auto& e) { e[5].line = 5; }},
      {"warning becomes undecided", "", [](auto& e) { e[5].kind = spec::EventKind::undecided; }},
      {"arc lost", "center", [](auto& e) { e[2].arc.reset(); }},
      {"arc of a line", "center", [](auto& e) { e[1].arc = e[2].arc; }},
      {"one radius where there are two", "radius", [](auto& e) { e[2].arc->radius->second = e[2].arc->radius->first; }},
      {"type", "type", [](auto& e) { e[1].type = spec::MoveType::rapid; }},
      {"cause", "cause", [](auto& e) { e[1].cause = spec::Cause::cancel; }},
      {"alarm number", "number", [](auto& e) { e[6].number = "PS5408"; }},
      {"warning number", "number", [](auto& e) { e[5].number = "OTHER"; }},
      {"tool axis lost", "tool_axis", [](auto& e) { e[1].tool_axis.reset(); }},
      {"tool axis turned round", "tool_axis", [](auto& e) { (*e[1].tool_axis)[0] = -(*e[1].tool_axis)[0]; }},
      {"tool axis slightly off", "tool_axis", [](auto& e) { (*e[1].tool_axis)[2] += kSmall; }},
      {"tool axis where there is none", "tool_axis", [](auto& e) { e[0].tool_axis = {0.0, 0.0, 1.0}; }},
      {"tool axis of a sample", "tool_axis", [](auto& e) { (*e[3].tool_axis)[1] = kSmall; }},
      {"centre", "center", [](auto& e) { e[2].arc->center.value[1] += kSmall; }},
      {"centre of one axis only", "center", [](auto& e) { e[2].arc->center.clear(1); }},
      {"plane", "plane", [](auto& e) { e[2].arc->plane = spec::Plane::zx; }},
      {"direction", "direction", [](auto& e) { e[2].arc->direction = spec::ArcDirection::cw; }},
      {"sweep", "sweep", [](auto& e) { *e[2].arc->sweep += kSmall; }},
      {"sweep a full turn more", "sweep", [](auto& e) { *e[2].arc->sweep += 360; }},
      {"sweep lost", "sweep", [](auto& e) { e[2].arc->sweep.reset(); }},
      {"start radius", "radius", [](auto& e) { e[2].arc->radius->first += kSmall; }},
      {"end radius", "radius", [](auto& e) { e[2].arc->radius->second += kSmall; }},
      {"radius lost", "radius", [](auto& e) { e[2].arc->radius.reset(); }},
      {"feed", "feed", [](auto& e) { *e[1].feed += kSmall; }},
      {"feed lost", "feed", [](auto& e) { e[1].feed.reset(); }},
      {"feed of a rapid move", "feed", [](auto& e) { e[0].feed = 100; }},
      {"t of a sample", "t", [](auto& e) { e[3].t_numerator = 3; }},
      {"parts of a sample's block", "t", [](auto& e) { e[3].t_denominator = 8; }},
      {"sample dropped", "", [](auto& e) { e.erase(e.begin() + 3); }},
      {"sample doubled", "", [](auto& e) { e.insert(e.begin() + 3, fast::Event(e[3])); }},
      {"sample behind what follows it", "", [](auto& e) { std::swap(e[3], e[4]); }},
      {"sample of another line", "", [](auto& e) { e[3].line = 5; }},
      {"tool axis of a sample lost", "tool_axis", [](auto& e) { e[3].tool_axis.reset(); }},
      {"tool axis of a sample turned round", "tool_axis", [](auto& e) { (*e[3].tool_axis)[2] = -1; }},
      {"name of a setting", "name", [](auto& e) { e[4].setting = "H1.geometry"; }},
      {"value of a setting", "value", [](auto& e) { e[4].value += kSmall; }},
  };
  // Every number of every table: off by a little, with the other sign, not finite, and left out.
  using Table = AxisValues<double> fast::Event::*;
  const std::pair<std::string, Table> tables[] = {{"programmed", &fast::Event::programmed},
                                                  {"point", &fast::Event::point},
                                                  {"axes", &fast::Event::axes},
                                                  {"machine", &fast::Event::machine}};
  const std::vector<fast::Event> good = events<double>();
  for (const auto& [name, table] : tables)
    for (std::size_t i = 0; i < good.size(); ++i)
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const AxisValues<double>& v = good[i].*table;
        const std::string what = name + "[" + std::to_string(axis) + "] of event " + std::to_string(i);
        const auto change = [&](const std::string& how, const std::function<void(AxisValues<double>&)>& apply) {
          list.push_back({what + how, name, [i, member = table, apply](auto& e) { apply(e[i].*member); }});
        };
        if (!v.has(axis)) {
          if (good[i].kind == spec::EventKind::move && !v.empty())
            change(" too many", [axis](auto& t) { t.set(axis, 0); });
          continue;
        }
        change(" 1e-9 off", [axis](auto& t) { t.value[axis] += kSmall; });
        change(" 1e-9 under", [axis](auto& t) { t.value[axis] -= kSmall; });
        change(" a nanometre off", [axis](auto& t) { t.value[axis] += kNanometre; });
        if (v[axis] != 0) change(" negated", [axis](auto& t) { t.value[axis] = -t.value[axis]; });
        change(" not a number", [axis](auto& t) { t.value[axis] = std::numeric_limits<double>::quiet_NaN(); });
        change(" infinite", [axis](auto& t) { t.value[axis] = std::numeric_limits<double>::infinity(); });
        change(" lost", [axis](auto& t) { t.clear(axis); });
      }
  return list;
}

std::vector<std::string> all_fields() {
  return {"n",     "type",      "cause", "programmed", "point", "axes", "machine", "tool_axis", "center",
          "plane", "direction", "sweep", "radius",     "feed",  "t",    "number",  "name",      "value"};
}

TEST(Comparator, AcceptsTheSameEvents) {
  const Verdict v = verdict(events<double>());
  EXPECT_EQ(v.outcome, Outcome::agrees) << (v.difference ? explain(*v.difference) : "");
  // Rapid 3+3+4+4; linear 3+3+4, tool axis 3, feed; arc 3+3+4, centre 2, sweep, radii 2, feed; sample 3+4+3; a setting
  // and the numbers of a warning and an alarm.
  EXPECT_EQ(v.values, 14U + 14U + 16U + 10U + 3U);
  EXPECT_EQ(v.numbers, v.values - 2);
  EXPECT_EQ(v.events, 7U);
  EXPECT_EQ(v.out_of_scope, 0U);
  EXPECT_EQ(v.worst_ulp, 0);
}

TEST(Comparator, SeesEveryWrongAnswer) {
  for (const Wrong& wrong : wrong_answers()) {
    std::vector<fast::Event> actual = events<double>();
    wrong.apply(actual);
    const Verdict v = verdict(actual);
    EXPECT_EQ(v.outcome, Outcome::differs) << wrong.what;
    ASSERT_TRUE(v.difference) << wrong.what;
    EXPECT_FALSE(v.difference->kind.empty()) << wrong.what;
    EXPECT_NE(v.difference->expected, v.difference->actual) << wrong.what;
  }
}

// Without the samples.
template <class Number>
std::vector<spec::Event<Number>> moves_of(std::vector<spec::Event<Number>> events) {
  std::erase_if(events, [](const spec::Event<Number>& e) { return e.kind == spec::EventKind::sample; });
  return events;
}

// Whether nothing but samples is wrong.
bool only_samples_differ(const std::vector<fast::Event>& actual) {
  ModelRun run;
  run.events = moves_of(events<Real>());
  return judge::judge(plain_case(), run, moves_of(actual)).outcome == Outcome::agrees;
}

// The battery above measures the comparator only if it would miss something with a step left out: one that skips a
// field is caught for every field.
TEST(Comparator, TheWrongAnswersCatchAComparatorThatSkipsAField) {
  for (const std::string& skipped : all_fields()) {
    JudgeOptions options;
    for (const std::string& field : all_fields())
      if (field != skipped) options.fields.push_back(field);
    std::size_t missed = 0;
    for (const Wrong& wrong : wrong_answers()) {
      std::vector<fast::Event> actual = events<double>();
      wrong.apply(actual);
      const bool seen = verdict(actual, options).outcome == Outcome::differs;
      if (!seen) {
        ++missed;
        // Without `t` no sample is judged.
        if (skipped == "t" && only_samples_differ(actual)) continue;
        EXPECT_EQ(wrong.field, skipped) << wrong.what;
      }
    }
    EXPECT_GT(missed, 0U) << "no wrong answer depends on " << skipped;
  }
}

TEST(Comparator, NamesWhatDiffers) {
  const auto difference = [](const std::function<void(std::vector<fast::Event>&)>& apply) {
    std::vector<fast::Event> actual = events<double>();
    apply(actual);
    return *verdict(actual).difference;
  };
  EXPECT_EQ(difference([](auto& e) { e.erase(e.begin() + 1); }).kind, "missing event");
  EXPECT_EQ(difference([](auto& e) { e.insert(e.begin(), e[2]); }).kind, "extra event");
  EXPECT_EQ(difference([](auto& e) { std::swap(e[0], e[1]); }).kind, "order");
  EXPECT_EQ(difference([](auto& e) { e.pop_back(); }).kind, "missing event");
  EXPECT_EQ(difference([](auto& e) { e[6].number = "PS5408"; }).kind, "alarm");
  const Difference d = difference([](auto& e) { e[1].point.value[2] += 0.25; });
  EXPECT_EQ(d.kind, "coordinate");
  EXPECT_EQ(d.field, "point.Z");
  EXPECT_EQ(d.line, 2U);
  EXPECT_EQ(d.event, 1U);
  EXPECT_EQ(d.expected, "6");
  EXPECT_EQ(d.actual, "6.25");
  EXPECT_NEAR(d.deviation_um, 250, 1e-9);
}

// A difference as it is told, and a field that is named by its kind.
TEST(Comparator, ExplainsADifference) {
  Difference d;
  d.kind = "coordinate";
  d.field = "point.Z";
  d.line = 2;
  d.expected = "6";
  d.actual = "6.25";
  d.deviation_um = 250;
  d.clause = spec::Clause::fanuc_cutter_c_corner_side;
  EXPECT_EQ(explain(d), "line 2, coordinate point.Z: 6 expected, 6.25 given, 250 um off (fanuc.cutter-c.corner-side)");
  Difference kind;
  kind.kind = kind.field = "type";
  kind.expected = "linear";
  kind.actual = "rapid";
  EXPECT_EQ(explain(kind), "type: linear expected, rapid given");
}

// Micrometres are of lengths alone.
TEST(Comparator, AnAngleIsNoDeviationInLength) {
  std::vector<fast::Event> actual = events<double>();
  actual[1].axes.value[3] += policy::ulp(90);
  const Verdict v = verdict(actual);
  EXPECT_EQ(v.outcome, Outcome::agrees);
  EXPECT_GT(v.worst_ulp, 0);
  EXPECT_EQ(v.worst_um, 0);
}

// Half the granted roundings pass, twice as many do not: the tolerance is the policy's, not a round figure.
TEST(Comparator, GrantsWhatThePolicySays) {
  const double k = policy::budget("fanuc/leading-edge-offset").coordinate;
  // Event 1: the largest linear value is 100, its vector (-8, 0, 6) is 10 long, the angle of VM and VT is 59°, so the
  // condition lies between 1 and 2.
  const double least = policy::ulp(100) + policy::ulp(10);
  const double most = policy::ulp(100) + 2 * policy::ulp(10);
  for (const double sign : {-1.0, 1.0}) {
    std::vector<fast::Event> actual = events<double>();
    actual[1].point.value[0] += sign * k / 2 * least;
    EXPECT_EQ(verdict(actual).outcome, Outcome::agrees);
    EXPECT_GT(verdict(actual).worst_ulp, k / 4);
    actual = events<double>();
    actual[1].point.value[0] += sign * 2 * k * most;
    EXPECT_EQ(verdict(actual).outcome, Outcome::differs);
  }
}

// A long vector: G41 r = 10 along X to (40, 0) and back at (-1000, 1), x = 40 - 10·(1000 + √(1000² + 1)). It is 20000
// long and slides by 2·√(1000² + 1) = 2000 times an error of the directions (conditions.cpp), so that much is granted.
TEST(Comparator, GrantsALongVectorItsCondition) {
  const Real x = 40 - Real(10) * (Real(1000) + sqrt(Real(1'000'001)));
  const std::vector<std::array<Real, 4>> heads = {{Real(0), Real(0), Real(0), Real(10)},
                                                  {Real(40), Real(0), x, Real(10)},
                                                  {Real(-49'960), Real(50), Real(-49'960), Real(50)}};
  ModelRun run;
  std::vector<fast::Event> right;
  for (const std::array<Real, 4>& head : heads) {
    model::Event e;
    e.cause = run.events.empty() ? spec::Cause::start_up : spec::Cause::programmed;
    e.line = run.events.size() + 1;
    e.programmed = values<Real>({head[0], head[1], Real(0)});
    e.point = values<Real>({head[2], head[3], Real(0)});
    e.axes = e.point;
    run.events.push_back(e);
    right.push_back(certify::in_double(e));
  }
  spec::Case c = plain_case();
  c.section = "fanuc/cutter-compensation-c";
  const double k = policy::budget(c.section).coordinate;
  const auto off_by = [&](std::size_t event, double distance) {
    std::vector<fast::Event> actual = right;
    actual[event].point.value[0] += distance;
    return judge::judge(c, run, actual).outcome;
  };
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_EQ(off_by(1, sign * k * 1000 * policy::ulp(20'000)), Outcome::agrees);
    EXPECT_EQ(off_by(1, sign * k * 4000 * policy::ulp(20'000)), Outcome::differs);
    EXPECT_EQ(off_by(0, sign * k * 1000 * policy::ulp(20'000)), Outcome::differs);
  }
}

// Every kind of number has the width of the policy's row and no more: a little less passes, a little more does not.
// Units by hand: of the numbers of events() the largest linear one, its vector and the condition of the block.
TEST(Comparator, GrantsEveryNumberWhatThePolicySays) {
  struct Number {
    std::string name;
    double k, least, most;  // budget, and bounds of its unit
    double& (*of)(std::vector<fast::Event>&);
  };
  const policy::Budget& row = policy::budget("fanuc/leading-edge-offset");
  const double ulp_100 = policy::ulp(100);
  const double ulp_110 = policy::ulp(110);
  const Number numbers[] = {
      {"programmed", row.coordinate, ulp_100, ulp_100 + 2 * policy::ulp(10),
       [](auto& e) -> double& { return e[1].programmed.value[1]; }},
      {"axes", row.coordinate, ulp_100, ulp_100 + 2 * policy::ulp(10),
       [](auto& e) -> double& { return e[1].axes.value[2]; }},
      {"machine", row.coordinate, ulp_110, 2 * ulp_110, [](auto& e) -> double& { return e[0].machine.value[1]; }},
      // A rotary axis: 90 and 30 degrees.
      {"rotary", row.rotary, policy::ulp(90), policy::ulp(90), [](auto& e) -> double& { return e[1].axes.value[3]; }},
      {"rotary of the machine", row.rotary, policy::ulp(30), policy::ulp(30),
       [](auto& e) -> double& { return e[0].machine.value[3]; }},
      // At 4 degrees behind an end at 90, which it is rounded as.
      {"rotary of a sample", row.rotary, policy::ulp(4) + policy::ulp(90), policy::ulp(4) + policy::ulp(90),
       [](auto& e) -> double& { return e[3].axes.value[3]; }},
      {"tool axis", row.tool_axis, policy::ulp(1), policy::ulp(1),
       [](auto& e) -> double& { return (*e[1].tool_axis)[0]; }},
      {"tool axis of a sample", row.tool_axis, policy::ulp(1), policy::ulp(1),
       [](auto& e) -> double& { return (*e[3].tool_axis)[0]; }},
      {"centre", row.coordinate, ulp_110, 2 * ulp_110, [](auto& e) -> double& { return e[2].arc->center.value[0]; }},
      {"start radius", row.coordinate, ulp_110, 2 * ulp_110,
       [](auto& e) -> double& { return e[2].arc->radius->first; }},
      {"end radius", row.coordinate, ulp_110, 2 * ulp_110, [](auto& e) -> double& { return e[2].arc->radius->second; }},
      {"sweep", row.sweep, policy::ulp(360), 2 * policy::ulp(360), [](auto& e) -> double& { return *e[2].arc->sweep; }},
  };
  for (const Number& number : numbers)
    for (const double sign : {-1.0, 1.0}) {
      const auto off_by = [&](double distance) {
        std::vector<fast::Event> actual = events<double>();
        number.of(actual) += sign * distance;
        return verdict(actual).outcome;
      };
      EXPECT_EQ(off_by(number.k * number.least / 2), Outcome::agrees) << number.name;
      EXPECT_EQ(off_by(number.k * number.most * 2), Outcome::differs) << number.name;
    }
}

// A whole list as a controller prints it.
std::vector<spec::TextEvent> as_text(const std::function<std::string(double)>& print) {
  std::vector<spec::TextEvent> list;
  const auto table = [&](const AxisValues<double>& from) {
    AxisValues<spec::NumberText> to;
    for (std::size_t i = 0; i < kAxes; ++i)
      if (from.has(i)) to.set(i, {print(from[i]), {}, {}});
    return to;
  };
  for (const fast::Event& e : events<double>()) {
    spec::TextEvent t;
    t.kind = e.kind;
    t.line = e.line;
    t.n = e.n;
    t.type = e.type;
    t.cause = e.cause;
    t.number = e.number;
    t.setting = e.setting;
    t.t_numerator = e.t_numerator;
    t.t_denominator = e.t_denominator;
    t.programmed = table(e.programmed);
    t.point = table(e.point);
    t.axes = table(e.axes);
    t.machine = table(e.machine);
    if (e.tool_axis) {
      t.tool_axis.emplace();
      for (std::size_t i = 0; i < 3; ++i) (*t.tool_axis)[i].v = print((*e.tool_axis)[i]);
    }
    if (e.arc) {
      t.arc.emplace();
      t.arc->center = table(e.arc->center);
      t.arc->plane = e.arc->plane;
      t.arc->direction = e.arc->direction;
      t.arc->sweep = spec::NumberText{print(*e.arc->sweep), {}, {}};
      t.arc->radius = std::pair(spec::NumberText{print(e.arc->radius->first), {}, {}},
                                spec::NumberText{print(e.arc->radius->second), {}, {}});
    }
    if (e.feed) t.feed = spec::NumberText{print(*e.feed), {}, {}};
    if (e.kind == spec::EventKind::setting) t.value.v = print(e.value);
    list.push_back(std::move(t));
  }
  return list;
}

std::string three_decimals(double x) {
  char text[64];
  std::snprintf(text, sizeof text, "%.3f", x);
  return text;
}
std::string two_decimals(double x) {
  char text[64];
  std::snprintf(text, sizeof text, "%.2f", x);
  return text;
}
std::string exponent(double x) {
  char text[64];
  std::snprintf(text, sizeof text, "%.17e", x);
  return text;
}

TEST(Comparator, JudgesTextsExactly) {
  const spec::Case c = plain_case();
  EXPECT_EQ(judge::judge(c, expected(), std::span<const spec::TextEvent>(as_text(three_decimals))).outcome,
            Outcome::agrees);
  EXPECT_EQ(judge::judge(c, expected(), std::span<const spec::TextEvent>(as_text(exponent))).outcome, Outcome::agrees);
  // 1e-20 is no double's distance from 100, and is seen all the same where the policy grants nothing: a feed.
  std::vector<spec::TextEvent> events = as_text(three_decimals);
  events[1].feed->v = "1000.00000000000000000001";
  const Verdict v = judge::judge(c, expected(), std::span<const spec::TextEvent>(events));
  ASSERT_EQ(v.outcome, Outcome::differs);
  EXPECT_EQ(v.difference->field, "feed");
}

Resolution all_of(double r, Rounding rounding = Rounding::unknown) { return {r, r, r, r, rounding}; }

TEST(Comparator, AResolutionGrantsOneIncrement) {
  const spec::Case c = plain_case();
  const std::vector<spec::TextEvent> coarse = as_text(two_decimals);  // eighths lose 0.005
  EXPECT_EQ(judge::judge(c, expected(), std::span<const spec::TextEvent>(coarse)).outcome, Outcome::differs);
  EXPECT_EQ(judge::judge(c, expected(), std::span<const spec::TextEvent>(coarse), {{}, all_of(0.01)}).outcome,
            Outcome::agrees);
  EXPECT_EQ(judge::judge(c, expected(), std::span<const spec::TextEvent>(coarse), {{}, all_of(0.001)}).outcome,
            Outcome::differs);
}

// Where the controller says how it rounds, only that passes. two_decimals() goes to nearest.
TEST(Comparator, ARoundingThatIsAnnounced) {
  const auto judged = [](const std::vector<spec::TextEvent>& events, Rounding rounding) {
    return judge::judge(plain_case(), expected(), std::span<const spec::TextEvent>(events),
                        {{}, all_of(0.01, rounding)})
        .outcome;
  };
  EXPECT_EQ(judged(as_text(two_decimals), Rounding::nearest), Outcome::agrees);
  EXPECT_EQ(judged(as_text(three_decimals), Rounding::nearest), Outcome::agrees);
  // What lies 0.006 off is no rounding to nearest; what lies above is none downward.
  std::vector<spec::TextEvent> off = as_text(three_decimals);
  off[1].point.value[0].v = fmt::format("{:.3f}", std::stod(off[1].point.value[0].v) + 0.006);
  EXPECT_EQ(judged(off, Rounding::nearest), Outcome::differs);
  EXPECT_EQ(judged(off, Rounding::down), Outcome::differs);
  EXPECT_EQ(judged(off, Rounding::unknown), Outcome::agrees);
  off[1].point.value[0].v = fmt::format("{:.3f}", std::stod(off[1].point.value[0].v) - 0.012);
  EXPECT_EQ(judged(off, Rounding::nearest), Outcome::differs);
  EXPECT_EQ(judged(off, Rounding::down), Outcome::agrees);
}

// Inches are not judged by the millimetres announced, nor degrees.
TEST(Comparator, AResolutionIsOfItsUnit) {
  spec::Case inch = plain_case();
  inch.setup.units = spec::Units::inch;
  std::vector<fast::Event> off = events<double>();
  off[1].axes.value[0] += 0.001;
  const auto judged = [&](const Resolution& r) { return judge::judge(inch, expected(), off, {{}, r}).outcome; };
  EXPECT_EQ(judged({.mm = 0.01, .degrees = 0.01}), Outcome::differs);
  EXPECT_EQ(judged({.inch = 0.0001}), Outcome::differs);
  EXPECT_EQ(judged({.inch = 0.001}), Outcome::agrees);
  const Verdict v = judge::judge(inch, expected(), off, {{}, {.inch = 0.002}});
  EXPECT_EQ(v.bias.count, 1U);
  EXPECT_NEAR(v.bias.worst, 25.4, 0.001);
}

TEST(Comparator, ATextThatIsNoNumberIsADifference) {
  for (const std::string text : {"", "1,5", "0x10", "nan", "1e999", "--1", "1.", ".5", "1 ", "1e"}) {
    std::vector<spec::TextEvent> events = as_text(three_decimals);
    events[1].point.value[0].v = text;
    const Verdict v = judge::judge(plain_case(), expected(), std::span<const spec::TextEvent>(events));
    ASSERT_EQ(v.outcome, Outcome::differs) << text;
    EXPECT_EQ(v.difference->kind, "malformed number") << text;
    EXPECT_EQ(v.difference->line, 2U) << text;
  }
}

TEST(Comparator, NothingJudgedIsNoAgreement) {
  ModelRun nothing;
  EXPECT_EQ(judge::judge(plain_case(), nothing, std::span<const fast::Event>()).outcome, Outcome::nothing_judged);
  // Only fields that no event has.
  ModelRun one;
  one.events = {events<Real>()[1]};
  const std::vector<fast::Event> actual = {events<double>()[1]};
  EXPECT_EQ(judge::judge(plain_case(), one, actual, {{"sweep"}, {}}).outcome, Outcome::nothing_judged);
}

TEST(Comparator, AnUndecidedModelIsUndecidedButNotBeforeADifference) {
  ModelRun run = expected();
  run.events[4].kind = spec::EventKind::undecided;
  std::vector<fast::Event> actual = events<double>();
  EXPECT_EQ(judge::judge(plain_case(), run, actual).outcome, Outcome::undecided);
  actual[1].point.value[0] += 1;
  EXPECT_EQ(judge::judge(plain_case(), run, actual).outcome, Outcome::differs);
}

// A controller that does not announce `t` may give samples or none.
TEST(Comparator, SamplesAreJudgedWhereTheirTimeIs) {
  JudgeOptions without;
  for (const std::string& field : all_fields())
    if (field != "t") without.fields.push_back(field);
  std::vector<fast::Event> actual = events<double>();
  EXPECT_EQ(verdict(actual, without).outcome, Outcome::agrees);
  actual[3].axes.value[0] += 1;
  EXPECT_EQ(verdict(actual, without).outcome, Outcome::agrees);
  EXPECT_EQ(verdict(actual).outcome, Outcome::differs);
  EXPECT_EQ(verdict(moves_of(events<double>()), without).outcome, Outcome::agrees);
  EXPECT_EQ(verdict(moves_of(events<double>())).outcome, Outcome::differs);
}

// Radii nearer to each other than either is known are one or two, as an engine has it; a little more is two.
TEST(Comparator, RadiiOfAnArcMayBeOneWhereTheyHardlyDiffer) {
  const auto radii = [](const Real& second) {
    ModelRun run = expected();
    run.events[2].arc->radius->second = second;
    return run;
  };
  std::vector<fast::Event> one = events<double>();
  one[2].arc->radius.reset();
  const Real first = expected().events[2].arc->radius->first;
  const Real hair = Real(1) / Real(1'000'000'000);
  EXPECT_EQ(judge::judge(plain_case(), radii(first + hair * hair), one).outcome, Outcome::agrees);
  EXPECT_EQ(judge::judge(plain_case(), radii(first + hair), one).outcome, Outcome::differs);
  // The other way round.
  ModelRun equal = expected();
  equal.events[2].arc->radius.reset();
  std::vector<fast::Event> two = events<double>();
  two[2].arc->radius->second = std::nextafter(two[2].arc->radius->first, 1000.0);
  EXPECT_EQ(judge::judge(plain_case(), equal, two).outcome, Outcome::agrees);
  two[2].arc->radius->second += kSmall;
  EXPECT_EQ(judge::judge(plain_case(), equal, two).outcome, Outcome::differs);
}

}  // namespace
}  // namespace toolcomp::judge

// SPDX-License-Identifier: Apache-2.0
// Events of 3D tool compensation in the comparator: every field counts, and as far as the policy says. Events here are
// made by hand: no engine is involved.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "certify/convert.h"
#include "judge/oracle/condition.h"
#include "judge/oracle/policy.h"
#include "judge/oracle/verdict.h"

namespace toolcomp::judge {
namespace {

using exact::Real;

// Golden example E16: N = (0.6, 0, 0.8), t = ez, R = 5, R2 = 2, dL 0.25 dR 0.3 dR2 0.1, P = 0; L = 10. Eighths and such
// would hide a field that is skipped no less, so the numbers are those of an example worked out by hand.
template <class Number>
spec::Event<Number> face() {
  const auto e = [](int n, int d) { return Number(n) / Number(d); };
  spec::Event<Number> event;
  event.line = 3;
  for (std::size_t i = 0; i < 3; ++i) event.programmed.set(i, Number(0));
  event.point.set(0, e(13, 50));
  event.point.set(1, Number(0));
  event.point.set(2, e(-1, 50));
  event.axes = event.point;
  event.axes.set(2, e(23, 100));
  event.tool_axis = {Number(0), Number(0), Number(1)};
  spec::SpaceCompensation<Number>& space = event.space.emplace();
  space.tool_center = {e(13, 50), Number(0), e(52, 25)};
  space.shift = {e(13, 50), Number(0), e(-1, 50)};
  space.tool_shift = {e(13, 50), Number(0), e(23, 100)};
  space.carrier = {e(13, 50), Number(0), e(1023, 100)};
  spec::Contact<Number>& contact = space.contact.emplace();
  contact.point = {e(-21, 5), Number(0), e(2, 5)};
  contact.normal = {e(3, 5), Number(0), e(4, 5)};
  contact.angle = e(45, 1);
  event.feed = Number(500);
  return event;
}

template <class Number>
std::vector<spec::Event<Number>> events() {
  spec::Event<Number> open;
  open.kind = spec::EventKind::undecided;
  open.line = 4;
  open.number = "heidenhain.peripheral.out-of-scope";
  open.out_of_scope = true;
  spec::Event<Number> after = face<Number>();
  after.line = 5;
  return {face<Number>(), open, after};
}

spec::Case plain_case() {
  spec::Case c;
  c.section = "heidenhain/face-milling";
  c.dialect = "klartext";
  c.setup.control = spec::Control::heidenhain;
  c.setup.axes = spec::Axes("XYZ");
  return c;
}

Verdict verdict(const std::vector<fast::Event>& actual, const JudgeOptions& options = {}) {
  ModelRun run;
  run.events = events<Real>();
  return judge::judge(plain_case(), run, actual, options);
}

struct Wrong {
  std::string field;
  std::string what;
  std::function<void(fast::Event&)> apply;
};

std::vector<Wrong> wrong_answers() {
  constexpr double small = 1e-9;
  std::vector<Wrong> list;
  const auto vector = [&](const std::string& field, auto member) {
    for (std::size_t i = 0; i < 3; ++i)
      list.push_back({field, "1e-9 off", [member, i](fast::Event& e) { member(e)[i] += small; }});
    list.push_back({field, "negated", [member](fast::Event& e) { member(e)[0] = -member(e)[0]; }});
    list.push_back({field, "not a number", [member](fast::Event& e) { member(e)[1] = std::nan(""); }});
  };
  vector("tool_center", [](fast::Event& e) -> auto& { return e.space->tool_center; });
  vector("shift", [](fast::Event& e) -> auto& { return e.space->shift; });
  vector("tool_shift", [](fast::Event& e) -> auto& { return e.space->tool_shift; });
  vector("carrier", [](fast::Event& e) -> auto& { return *e.space->carrier; });
  vector("contact", [](fast::Event& e) -> auto& { return e.space->contact->point; });
  vector("normal", [](fast::Event& e) -> auto& { return e.space->contact->normal; });
  list.push_back({"feed", "off", [](fast::Event& e) { *e.feed += small; }});
  list.push_back({"carrier", "lost", [](fast::Event& e) { e.space->carrier.reset(); }});
  list.push_back({"angle", "off", [](fast::Event& e) { *e.space->contact->angle += small; }});
  list.push_back({"angle", "lost", [](fast::Event& e) { e.space->contact->angle.reset(); }});
  list.push_back({"flat", "wrong", [](fast::Event& e) { e.space->contact->flat = true; }});
  return list;
}

const std::vector<std::string>& fields() {
  static const std::vector<std::string> all = {"programmed", "point",   "axes",   "tool_axis", "tool_center",
                                               "shift",      "carrier", "angle",  "flat",      "tool_shift",
                                               "contact",    "normal",  "reason", "number",    "feed"};
  return all;
}

TEST(SpaceEvents, TheSameAreAccepted) {
  const Verdict v = verdict(events<double>());
  EXPECT_EQ(v.outcome, Outcome::agrees) << (v.difference ? explain(*v.difference) : "");
  // Of a face move: programmed, point, axes, tool axis, centre, contact, normal, both shifts and carrier, angle, feed.
  EXPECT_EQ(v.numbers, 2U * 32U);
}

TEST(SpaceEvents, EveryFieldIsJudged) {
  for (const Wrong& wrong : wrong_answers()) {
    std::vector<fast::Event> actual = events<double>();
    wrong.apply(actual[2]);
    const Verdict v = verdict(actual);
    ASSERT_EQ(v.outcome, Outcome::differs) << wrong.field << ' ' << wrong.what;
    EXPECT_EQ(v.difference->field.substr(0, wrong.field.size()), wrong.field) << wrong.what;
    EXPECT_EQ(v.difference->event, 2U);
    // And alone: without this field nothing is wrong.
    JudgeOptions options;
    for (const std::string& field : fields())
      if (field != wrong.field) options.fields.push_back(field);
    EXPECT_EQ(verdict(actual, options).outcome, Outcome::agrees) << wrong.field << ' ' << wrong.what;
  }
}

TEST(SpaceEvents, AMoveWithoutItsCompensationIsNoticed) {
  std::vector<fast::Event> actual = events<double>();
  actual[0].space.reset();
  EXPECT_EQ(verdict(actual).difference->kind, "missing field");
  actual = events<double>();
  actual[0].space->contact.reset();
  EXPECT_EQ(verdict(actual).difference->field, "contact");
}

TEST(SpaceEvents, OutOfScopeIsSaidByBoth) {
  std::vector<fast::Event> actual = events<double>();
  actual[1].out_of_scope = false;
  EXPECT_EQ(verdict(actual).difference->field, "reason");
}

// One field of an undecided event at a time.
TEST(SpaceEvents, WhatIsUndecidedIsJudged) {
  const auto difference = [](const std::function<void(fast::Event&)>& apply) {
    std::vector<fast::Event> actual = events<double>();
    apply(actual[1]);
    const Verdict v = verdict(actual);
    return v.difference ? v.difference->field : std::string("none");
  };
  EXPECT_EQ(difference([](fast::Event&) {}), "none");
  EXPECT_EQ(difference([](fast::Event& e) { e.number = "heidenhain.peripheral.mitre"; }), "number");
  EXPECT_EQ(difference([](fast::Event& e) { e.line = 5; }), "line");
  EXPECT_EQ(difference([](fast::Event& e) { e.n = 4; }), "n");
  EXPECT_EQ(difference([](fast::Event& e) { e.kind = spec::EventKind::warning; }), "kind");
  EXPECT_EQ(difference([](fast::Event& e) { e.permitted.positive = true; }), "permitted");
  EXPECT_EQ(difference([](fast::Event& e) { e.permitted.negative = true; }), "permitted");
  EXPECT_EQ(difference([](fast::Event& e) { e.permitted.tie = true; }), "permitted");
  std::vector<fast::Event> actual = events<double>();
  actual.erase(actual.begin() + 1);
  EXPECT_EQ(verdict(actual).difference->kind, "missing event");
}

// What a move of 3D compensation shares with any other: tables, feed, and that the list is as long.
TEST(SpaceEvents, AMoveIsJudgedAsAnyOther) {
  const auto differs = [](const std::function<void(std::vector<fast::Event>&)>& apply) {
    std::vector<fast::Event> actual = events<double>();
    apply(actual);
    return verdict(actual).outcome == Outcome::differs;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(differs([i](auto& e) { e[2].programmed.value[i] += 1e-9; }));
    EXPECT_TRUE(differs([i](auto& e) { e[2].point.value[i] += 1e-9; }));
    EXPECT_TRUE(differs([i](auto& e) { e[2].axes.value[i] += 1e-9; }));
    EXPECT_TRUE(differs([i](auto& e) { (*e[2].tool_axis)[i] += 1e-9; }));
  }
  EXPECT_TRUE(differs([](auto& e) { *e[2].feed += 1e-9; }));
  EXPECT_TRUE(differs([](auto& e) { e[2].feed.reset(); }));
  EXPECT_TRUE(differs([](auto& e) { e[2].n = 1; }));
  EXPECT_TRUE(differs([](auto& e) { e[2].cause = spec::Cause::cancel; }));
  EXPECT_TRUE(differs([](auto& e) { e[2].type = spec::MoveType::rapid; }));
  EXPECT_TRUE(differs([](auto& e) { e.pop_back(); }));
  EXPECT_TRUE(differs([](auto& e) { e.push_back(fast::Event(e[0])); }));
}

// Every number has the width of the policy's row and no more. The ring of the tool is 0 here (no setup has a tool), so
// the unit of a length is an ulp of the largest number, 10.23; of a normal an ulp of 1, of an angle one of 180.
TEST(SpaceEvents, NumbersAreGrantedWhatThePolicySays) {
  const policy::Budget& row = policy::budget("heidenhain/face-milling");
  struct Number {
    std::string name;
    double k, unit;
    double& (*of)(fast::Event&);
  };
  const Number numbers[] = {
      {"tool_center", row.coordinate, policy::ulp(10.23),
       [](fast::Event& e) -> double& { return e.space->tool_center[2]; }},
      {"shift", row.coordinate, policy::ulp(10.23), [](fast::Event& e) -> double& { return e.space->shift[0]; }},
      {"tool_shift", row.coordinate, policy::ulp(10.23),
       [](fast::Event& e) -> double& { return e.space->tool_shift[0]; }},
      {"carrier", row.coordinate, policy::ulp(10.23), [](fast::Event& e) -> double& { return (*e.space->carrier)[0]; }},
      {"contact", row.coordinate, policy::ulp(10.23),
       [](fast::Event& e) -> double& { return e.space->contact->point[0]; }},
      {"point", row.coordinate, policy::ulp(10.23), [](fast::Event& e) -> double& { return e.point.value[0]; }},
      {"normal", row.tool_axis, policy::ulp(1), [](fast::Event& e) -> double& { return e.space->contact->normal[1]; }},
      {"tool_axis", row.tool_axis, policy::ulp(1), [](fast::Event& e) -> double& { return (*e.tool_axis)[1]; }},
      {"angle", row.sweep, policy::ulp(180), [](fast::Event& e) -> double& { return *e.space->contact->angle; }},
  };
  for (const Number& number : numbers)
    for (const double sign : {-1.0, 1.0}) {
      const auto off_by = [&](double distance) {
        std::vector<fast::Event> actual = events<double>();
        number.of(actual[0]) += sign * distance;
        return verdict(actual).outcome;
      };
      EXPECT_EQ(off_by(number.k * number.unit / 2), Outcome::agrees) << number.name;
      EXPECT_EQ(off_by(number.k * number.unit * 4), Outcome::differs) << number.name;
    }
}

// The same as texts of a controller: each field is read for itself.
TEST(SpaceEvents, TheTextsOfAControllerAreJudgedFieldByField) {
  ModelRun run;
  run.events = {face<Real>()};
  const auto judged = [&](const std::function<void(spec::TextEvent&)>& apply) {
    std::vector<spec::TextEvent> texts = {certify::in_text(face<Real>(), 30)};
    apply(texts[0]);
    const Verdict v = judge::judge(plain_case(), run, std::span<const spec::TextEvent>(texts));
    return v.difference ? v.difference->field : std::string("none");
  };
  EXPECT_EQ(judged([](spec::TextEvent&) {}), "none");
  // No number of the event is 7.
  const auto seven = [](spec::NumberText& text) { text.v = "7"; };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string letter = std::string(".") + "XYZ"[i];
    EXPECT_EQ(judged([&](auto& e) { seven(e.space->tool_center[i]); }), "tool_center" + letter);
    EXPECT_EQ(judged([&](auto& e) { seven(e.space->shift[i]); }), "shift" + letter);
    EXPECT_EQ(judged([&](auto& e) { seven(e.space->tool_shift[i]); }), "tool_shift" + letter);
    EXPECT_EQ(judged([&](auto& e) { seven((*e.space->carrier)[i]); }), "carrier" + letter);
    EXPECT_EQ(judged([&](auto& e) { seven(e.space->contact->point[i]); }), "contact" + letter);
    EXPECT_EQ(judged([&](auto& e) { seven(e.space->contact->normal[i]); }), "normal[" + std::to_string(i) + "]");
  }
  EXPECT_EQ(judged([&](auto& e) { seven(*e.space->contact->angle); }), "angle");
  EXPECT_EQ(judged([](auto& e) { e.space->contact->flat = true; }), "flat");
  EXPECT_EQ(judged([](auto& e) { e.space->contact->angle.reset(); }), "angle");
  EXPECT_EQ(judged([](auto& e) { e.space->carrier.reset(); }), "carrier");
  EXPECT_EQ(judged([](auto& e) { e.space.reset(); }), "tool_center");
}

// What the program says of a run goes on, so a controller is judged up to there.
TEST(SpaceEvents, AControllerIsNotJudgedBehindWhatIsOutOfScope) {
  std::vector<spec::TextEvent> none;
  ModelRun run;
  run.events = events<Real>();
  run.events.erase(run.events.begin());
  EXPECT_EQ(judge::judge(plain_case(), run, none).outcome, Outcome::nothing_judged);
}

// One that announces what only undecided events say must give them, each with what it says.
TEST(SpaceEvents, AControllerThatAnnouncesReasonsMustGiveThem) {
  ModelRun run;
  run.events = events<Real>();
  run.events[1].permitted = {true, true, true};
  const auto judged = [&](const std::vector<std::string>& fields,
                          const std::function<void(std::vector<spec::TextEvent>&)>& apply) {
    std::vector<spec::TextEvent> texts;
    for (const model::Event& event : run.events) texts.push_back(certify::in_text(event, 30));
    apply(texts);
    JudgeOptions options;
    options.fields = fields;
    const Verdict v = judge::judge(plain_case(), run, texts, options);
    return v.difference ? v.difference->kind + " " + v.difference->field : std::string("none");
  };
  const std::vector<std::string> none = {"kind", "line", "point"};
  const std::vector<std::string> reason = {"kind", "line", "point", "reason"};
  const std::vector<std::string> permitted = {"kind", "line", "point", "permitted"};
  for (const auto& fields : {none, reason, permitted}) EXPECT_EQ(judged(fields, [](auto&) {}), "none");
  const auto no_reason = [](auto& e) { e[1].out_of_scope = false; };
  EXPECT_EQ(judged(reason, no_reason), "undecided reason");
  EXPECT_EQ(judged(permitted, no_reason), "none");
  const auto no_tie = [](auto& e) { e[1].permitted.tie = false; };
  EXPECT_EQ(judged(permitted, no_tie), "undecided permitted");
  EXPECT_EQ(judged(reason, no_tie), "none");
  // A move in its place, or nothing.
  const auto move = [](auto& e) { e.erase(e.begin() + 1); };
  EXPECT_EQ(judged(none, move), "none");
  EXPECT_EQ(judged(reason, move), "missing event event");
  EXPECT_EQ(judged(permitted, [](auto& e) { e.resize(1); }), "missing event event");
  // What follows is not judged.
  EXPECT_EQ(judged(reason, [](auto& e) { e[2].point.value[0].v = "7"; }), "none");
  EXPECT_EQ(judged(reason, [](auto& e) { e.resize(2); }), "none");
}

// Of a face move, an OUT_OF_SCOPE and a face move the engine is judged in all three, a controller in the first.
TEST(SpaceEvents, WhatStandsBehindAnOutOfScopeEventIsCounted) {
  const Verdict engine = verdict(events<double>());
  EXPECT_EQ(engine.events, 3U);
  EXPECT_EQ(engine.out_of_scope, 1U);
  ModelRun run;
  run.events = events<Real>();
  const std::vector<spec::TextEvent> texts = {certify::in_text(face<Real>(), 30)};
  const Verdict controller = judge::judge(plain_case(), run, texts);
  EXPECT_EQ(controller.events, 1U);
  EXPECT_EQ(controller.out_of_scope, 1U);
  // A second one changes nothing: the last three stand behind the first.
  run.events.push_back(run.events[1]);
  run.events.push_back(run.events[2]);
  std::vector<fast::Event> actual = events<double>();
  actual.push_back(fast::Event(actual[1]));
  actual.push_back(fast::Event(actual[2]));
  EXPECT_EQ(judge::judge(plain_case(), run, actual).events, 5U);
  EXPECT_EQ(judge::judge(plain_case(), run, actual).out_of_scope, 3U);
}

// An event without a partner is none that was judged.
TEST(SpaceEvents, EventsAreCountedInPairs) {
  std::vector<fast::Event> actual = events<double>();
  actual.pop_back();
  EXPECT_EQ(verdict(actual).events, 2U);
  EXPECT_EQ(verdict(actual).out_of_scope, 0U);
  actual = events<double>();
  actual.push_back(fast::Event(actual[0]));
  EXPECT_EQ(verdict(actual).events, 3U);
}

Scale scale_of(const model::Event& event, spec::Setup setup) {
  setup.control = spec::Control::heidenhain;
  Conditions conditions(setup);
  return conditions.next(std::span(&event, 1));
}

// The ring of the tool turns with n and t by their errors over the sine of their angle: 5 mm over 3/5 here, since both
// n and t are good to an ulp.
TEST(SpaceScales, TheRingTurnsWithItsDirections) {
  spec::Setup setup;
  setup.axes = spec::Axes("XYZ");
  spec::ToolRow& tool = setup.tools.emplace_back();
  tool.number = 10;
  tool.r = spec::decimal(5);
  tool.r2 = spec::decimal(2);
  const Scale scale = scale_of(face<Real>(), setup);
  // Contact to centre: R2' n + rho' u = (2.1 * 0.6 + 3.2, 0, 2.1 * 0.8).
  EXPECT_DOUBLE_EQ(scale.pose.tip, policy::ulp(5) / 0.6);
  EXPECT_DOUBLE_EQ(scale.position, 10.23);
  model::Event along = face<Real>();
  along.space->contact->angle.reset();
  along.space->contact->flat = true;
  EXPECT_EQ(scale_of(along, setup).pose.tip, 0);
}

// The deviation is off by the slope of its segment times the error of the angle: 0.05 mm over 10 degrees.
TEST(SpaceScales, DeviationsFollowTheirSlope) {
  spec::Setup setup;
  setup.axes = spec::Axes("XYZ");
  const auto decimal = [](const char* text) { return *spec::parse_decimal(text); };
  setup.dr2_tables["D"] = {{decimal("40"), decimal("0.03")}, {decimal("50"), decimal("-0.02")}};
  model::Event event = face<Real>();
  event.space->contact->flat = true;
  EXPECT_NEAR(scale_of(event, setup).pose.tip / policy::ulp(180), 0.005, 1e-12);
}

model::Event beside(double x, double y, const Real& px, const Real& py) {
  model::Event e;
  e.line = 1;
  e.programmed.set(0, Real(exact::Rational(x)));
  e.programmed.set(1, Real(exact::Rational(y)));
  e.programmed.set(2, Real(0));
  e.point.set(0, px);
  e.point.set(1, py);
  e.point.set(2, Real(0));
  e.axes = e.point;
  e.tool_axis = {Real(0), Real(0), Real(1)};
  e.space.emplace();
  return e;
}

// A mitre of a right angle: offset 1, vector of length root 2; both directions are good to an ulp and the errors of the
// ends over their distance.
TEST(SpaceScales, AMitreStretchesItsErrors) {
  spec::Setup setup;
  setup.control = spec::Control::heidenhain;
  setup.axes = spec::Axes("XYZ");
  const std::vector<model::Event> events = {beside(8, 0, Real(7), Real(1)), beside(8, 8, Real(7), Real(8))};
  Conditions conditions(setup);
  const double vector = std::sqrt(2.0);
  const double direction = policy::ulp(1) + policy::ulp(8) / 8;
  EXPECT_NEAR(conditions.next(events).pose.tip / (vector * direction * (1 + vector)), 1, 1e-9);
}

// The same before a reversal that raises an alarm, or a block that is not modelled: its move counts, though it is not
// made.
TEST(SpaceScales, AMitreBeforeAMoveThatIsNotMade) {
  spec::Setup setup;
  setup.control = spec::Control::heidenhain;
  setup.axes = spec::Axes("XYZ");
  for (const spec::EventKind kind : {spec::EventKind::alarm, spec::EventKind::undecided}) {
    model::Event instead;
    instead.kind = kind;
    instead.unmade = std::make_shared<model::Event>(beside(8, 8, Real(0), Real(0)));
    const std::vector<model::Event> events = {beside(8, 0, Real(7), Real(1)), instead};
    Conditions conditions(setup);
    const double vector = std::sqrt(2.0);
    const double direction = policy::ulp(1) + policy::ulp(8) / 8;
    EXPECT_NEAR(conditions.next(events).pose.tip / (vector * direction * (1 + vector)), 1, 1e-9);
  }
}

// The same 1024 away along Y: directions are as good as the largest coordinate of their ends.
TEST(SpaceScales, AMitreFarAlongAnyAxis) {
  spec::Setup setup;
  setup.control = spec::Control::heidenhain;
  setup.axes = spec::Axes("XYZ");
  const std::vector<model::Event> events = {beside(0, 1024, Real(0), Real(1025)), beside(8, 1024, Real(7), Real(1025)),
                                            beside(8, 1032, Real(7), Real(1032))};
  Conditions conditions(setup);
  (void)conditions.next(events);
  const double vector = std::sqrt(2.0);
  const double direction = policy::ulp(1) + policy::ulp(1024) / 8;
  EXPECT_NEAR(conditions.next(std::span(events).subspan(1)).pose.tip / (vector * direction * (1 + vector)), 1, 1e-9);
}

// Near a reversal, the turn back by 2/far, the mitre is as long as its condition, and the directions stay those of the
// programmed ends.
TEST(SpaceScales, AMitreNearAReversal) {
  spec::Setup setup;
  setup.control = spec::Control::heidenhain;
  setup.axes = spec::Axes("XYZ");
  constexpr int far = 1'000'000'000;
  const std::vector<model::Event> events = {beside(8, 0, Real(8 + far), Real(1)),
                                            beside(0, -16.0 / far, Real(0), Real(2))};
  Conditions conditions(setup);
  const double direction = policy::ulp(1) + policy::ulp(8) / 8;
  const Scale scale = conditions.next(events);
  EXPECT_NEAR(scale.pose.tip / (far * direction * (1.0 + far)), 1, 1e-6);
  // So it is judged by both offset lines, which the errors of their own directions move at that distance.
  ASSERT_EQ(scale.heads.size(), 1U);
  for (const HeadBand& band : scale.heads[0].bands) {
    EXPECT_NEAR(std::fabs(band.normal[1]), 1, 1e-6);
    EXPECT_NEAR(band.width / (policy::ulp(8.0 + far) + far * direction), 1, 1e-6);
  }
  EXPECT_NEAR(scale.heads[0].across.width / (policy::ulp(8.0 + far) + far * policy::ulp(1)), 1, 1e-6);
  EXPECT_NEAR(scale.heads[0].reach / scale.pose.tip, 1, 1e-6);
}

// The same mitre in the comparison, 10^6 long: every length that has it may lie 1e-4 along the offset lines, but not
// 1e-5 beside them.
TEST(SpaceScales, AMitreNearAReversalMaySlide) {
  constexpr int far = 1'000'000;
  ModelRun run;
  run.events = {beside(8, 0, Real(8 + far), Real(1)), beside(0, -16.0 / far, Real(0), Real(2))};
  run.events[0].space->tool_center = {Real(8 + far), Real(1), Real(0)};
  run.events[0].space->shift = {Real(far), Real(1), Real(0)};
  spec::Case c;
  c.section = "heidenhain/peripheral-milling";
  c.setup.control = spec::Control::heidenhain;
  c.setup.axes = spec::Axes("XYZ");
  const auto agrees = [&](double along, double across) {
    std::vector<fast::Event> actual = certify::in_doubles(run.events);
    for (spec::AxisValues<double>* values : {&actual[0].point, &actual[0].axes}) {
      values->set(0, values->value.at(0) + along);
      values->set(1, values->value.at(1) + across);
    }
    for (std::array<double, 3>* values : {&actual[0].space->tool_center, &actual[0].space->shift}) {
      (*values)[0] += along;
      (*values)[1] += across;
    }
    return judge::judge(c, run, actual).outcome == Outcome::agrees;
  };
  EXPECT_TRUE(agrees(0, 0));
  EXPECT_TRUE(agrees(1e-4, 0));
  EXPECT_FALSE(agrees(0, 1e-5));
  EXPECT_FALSE(agrees(1e-4, 1e-5));
}

// The largest coordinate, whichever it is.
TEST(SpaceScales, ThePositionIsThatOfTheLargestCoordinate) {
  const spec::Setup setup;
  for (std::size_t i = 0; i < 3; ++i) {
    model::Event event = beside(1, 1, Real(1), Real(1));
    event.programmed.set(i, Real(50));
    event.point.set(i, Real(51));
    event.axes = event.point;
    EXPECT_EQ(scale_of(event, setup).position, 51) << i;
  }
}

// The same mitre IS CONTOUR with an effective radius of 0: no vector, but shifts of that length.
TEST(SpaceScales, AShiftMayBeLongerThanTheVector) {
  spec::Setup setup;
  setup.control = spec::Control::heidenhain;
  setup.axes = spec::Axes("XYZ");
  std::vector<model::Event> events = {beside(8, 0, Real(8), Real(0)), beside(8, 8, Real(8), Real(8))};
  events[0].space->shift = events[0].space->tool_shift = {Real(-1), Real(1), Real(0)};
  const double vector = std::sqrt(2.0);
  const double direction = policy::ulp(1) + policy::ulp(8) / 8;
  const double expected = vector * direction * (1 + vector);
  EXPECT_NEAR(Conditions(setup).next(events).pose.tip / expected, 1, 1e-9);
  events[0].space->shift = {Real(0), Real(0), Real(0)};
  EXPECT_NEAR(Conditions(setup).next(events).pose.tip / expected, 1, 1e-9);
  // Along the tool it has nothing of the direction, whichever axis that is.
  events[0].space->tool_shift = {Real(0), Real(0), Real(5)};
  EXPECT_EQ(Conditions(setup).next(events).pose.tip, 0);
  std::vector<model::Event> lying = {beside(0, 8, Real(0), Real(8)), beside(0, 16, Real(0), Real(16))};
  for (model::Event& event : lying) event.tool_axis = {Real(1), Real(0), Real(0)};
  lying[0].space->tool_shift = {Real(5), Real(0), Real(0)};
  EXPECT_EQ(Conditions(setup).next(lying).pose.tip, 0);
}

// An offset that is nearly gone in the sine of tool and path.
TEST(SpaceScales, APathAlongTheToolHasNoDirection) {
  spec::Setup setup;
  setup.control = spec::Control::heidenhain;
  setup.axes = spec::Axes("XYZ");
  model::Event steep = beside(0, 0, Real(0), Real(1));
  steep.programmed.set(2, Real(8));
  steep.programmed.set(0, Real(exact::Rational(8, 1000)));
  steep.point = steep.programmed;
  steep.point.set(1, Real(1));
  Conditions conditions(setup);
  const double sine = 0.008 / std::hypot(8, 0.008);
  const double direction = (policy::ulp(1) + policy::ulp(8) / std::hypot(8, 0.008)) / sine;
  EXPECT_NEAR(conditions.next(std::span(&steep, 1)).pose.tip / (direction * 2), 1, 1e-6);
}

}  // namespace
}  // namespace toolcomp::judge

// SPDX-License-Identifier: Apache-2.0
// The third voice: every law holds for right events and breaks for wrong ones, and finds a wrong clause that both
// engines follow. Programs are worked examples; the events broken are the model's, changed by hand.
#include "judge/laws/laws.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <set>
#include <string>
#include <vector>

#include "certify/judge.h"
#include "fuzz/faults/wrong_clauses.h"
#include "fuzz/gen/generator.h"
#include "judge/laws/changed_program.h"
#include "judge/laws/numbers.h"
#include "judge/oracle/trial.h"

namespace toolcomp::judge {
namespace {

using exact::Real;
using Events = std::vector<model::Event>;

spec::Case fanuc(std::string section, std::string program) {
  spec::Case c;
  c.section = "fanuc/" + std::move(section);
  c.setup.d[1].geometry = spec::decimal(10);
  c.setup.h[1].geometry = spec::decimal(20);
  c.setup.parameters[{5008, 0}] = spec::decimal(1);
  c.program = std::move(program);
  return c;
}

// Lines beside a tool that leans by 3-4-5: golden examples TS2 and TS3.
spec::Case flank() {
  return fanuc("tool-side-compensation",
               "G90 G01 F100 G43.5 H0 I3. K4.\nG41.6 Y50. D1\nY100.\nX100.\nX200. Y150.\nG40 Y0\n");
}

// A line, an arc inside and a line that goes on along its tangent, for a tool of this direction:
// golden example TS11.
spec::Case arc_of_the_side(const std::string& direction) {
  return fanuc("tool-side-compensation", "G90 G01 F100 G43.5 H0 " + direction +
                                             "\nG41.6 X50. D1\nX100.\nG02 X190. Y-30. R50.\nG01 Y-80.\nG40 Y-90.\n");
}

// A line, an arc inside and a line: chapter 14.6.3.
spec::Case rounded_corner() {
  return fanuc("cutter-compensation-c", "G90 G01 F100 X0\nG41 X40. D1\nX80.\nG03 X100. Y20. J20.\nG01 Y60.\nG40 X0\n");
}

// An inner, an obtuse and an acute corner between start-up and cancel.
spec::Case corners() {
  return fanuc("cutter-compensation-c",
               "G90 G01 F100 X0\nG41 X40. D1\nX80. Y10.\nX100. Y50.\nX150.\nX110. Y-40.\nG40 X0 Y-50.\n");
}

spec::Case type_b() {
  spec::Case c = fanuc("cutter-compensation-b", "G90 G00 X0\nG41 X30. Y40. D1\nG01 F100 X60.\nG40 X0\n");
  c.setup.cutter_compensation = spec::CutterCompensationType::b;
  return c;
}

// Head with C about Z carrying B about Y (fanuc.tool-direction.mechanism, 2), holder 5 long, zeros of its own.
spec::Case head(std::string program) {
  spec::Case c = fanuc("tool-center-point-control", std::move(program));
  c.setup.axes = spec::Axes("XYZBC");
  for (const auto& [number, value] : std::vector<std::pair<std::uint32_t, std::int64_t>>{
           {19680, 2}, {19681, 5}, {19682, 3}, {19686, 4}, {19687, 2}, {19666, 5}, {19711, 40}, {19712, 25}})
    c.setup.parameters[{number, -1}] = spec::decimal(value);
  c.setup.workpiece[0]['X'] = spec::decimal(7);
  c.samples = 4;
  return c;
}

// From B 10 past the pole to about B 12 on its other side, 4 degrees off: golden example 5 of tool posture control.
// Within 5 degrees the end is changed, within 3 it is not.
spec::Case near_the_pole(std::int64_t largest_error) {
  spec::Case c = head("G90 G01 F100 G43.5 H1 P1 I173.6 K984.8\nX50. I-207. J14. K978.\n");
  c.section = "fanuc/tool-posture-control";
  c.setup.parameters[{19738, -1}] = spec::decimal(1);
  c.setup.parameters[{19739, -1}] = spec::decimal(largest_error);
  return c;
}

// Trunnion with A carrying C (fanuc.tool-direction.mechanism, 12; golden example 9).
spec::Case table(std::string program) {
  spec::Case c = fanuc("tool-center-point-control", std::move(program));
  c.setup.axes = spec::Axes("XYZAC");
  for (const auto& [number, value] : std::vector<std::pair<std::uint32_t, std::int64_t>>{{19680, 12},
                                                                                         {19681, 4},
                                                                                         {19682, 1},
                                                                                         {19684, 1},
                                                                                         {19686, 5},
                                                                                         {19687, 3},
                                                                                         {19689, 1},
                                                                                         {19702, -100},
                                                                                         {19704, 30},
                                                                                         {19705, 50}})
    c.setup.parameters[{number, -1}] = spec::decimal(value);
  c.setup.workpiece[0]['Z'] = spec::decimal(20);
  c.samples = 4;
  return c;
}

const std::string kByPositions = "G90 G43.4 H1 P0 A20. C45.\nG01 F100 X20. Y-20. A-35. C10.\nG02 X40. Y0 I20.\n";
const std::string kHelix = "G90 G01 F100 G43.5 H1 Q5. P0\nG02 X40. Y10. Z15. R50. I-1. J1. K2.\n";
const std::string kByDirection = "G90 G01 F100 G43.5 H1 Q2. P1\nX50. I-1. J1. K2.\nX60. Y30. I1. J2. K5.\n";

spec::Case klartext(std::string section, std::string program) {
  spec::Case c;
  c.section = "heidenhain/" + std::move(section);
  c.dialect = "klartext";
  c.setup.control = spec::Control::heidenhain;
  spec::ToolRow& toroid = c.setup.tools.emplace_back();
  toroid.number = 10;
  toroid.r = spec::decimal(6);
  toroid.r2 = spec::decimal(1);
  toroid.dr = *spec::parse_decimal("-0.1");
  toroid.l = spec::decimal(100);
  c.program = std::move(program);
  return c;
}

// Golden example E11, without its deltas in the table.
spec::Case face() {
  return klartext("face-milling",
                  "TOOL CALL 1 Z DL+0.05\nL Z+100 R0 FMAX\nM128\n"
                  "LN X+36.0084 Y+6.177 Z-1.9209 NX-0.4658107 NY+0 NZ+0.8848844 TX+0 TY+0.6558846 TZ+0.7548612\n"
                  "LN X+40 Y+6.177 Z-1.9209 NX-0.4658107 NY+0 NZ+0.8848844\n");
}

spec::Case contour() {
  return klartext("programmed-contour",
                  "TOOL CALL 1 Z\nM128\nFUNCTION PROG PATH IS CONTOUR\n"
                  "LN X+1 Y+2 Z+3 NX+0.6 NY+0 NZ+0.8 TX+0 TY+0 TZ+1\n");
}

spec::Case side() {
  return klartext("peripheral-milling",
                  "TOOL CALL 1 Z\nM128\nL X+0 Y+0 Z+0 R0\nLN X+10 Y+0 Z+0 TX+0 TY+0 TZ+1 RL\n"
                  "LN X+50 Y+0 Z+0 TX+0 TY+0.6 TZ+0.8\nLN X+50 Y+80 Z+0 TX+0 TY+0 TZ+1\nL Y+90 R0\n");
}

spec::Case turned() {
  spec::Case c = klartext("face-milling", "TOOL CALL 1 Z\nL X+0 Y+0 Z+0 B+90\nM128\nL X+10 R0\nL B+0\n");
  c.setup.axes = spec::Axes("XYZABC");
  return c;
}

using Break = void (*)(Events&);

model::Event& last_move(Events& events) {
  for (auto e = events.rbegin(); e != events.rend(); ++e)
    if (e->kind == spec::EventKind::move) return *e;
  throw std::logic_error("no move");
}
model::Event& at_line(Events& events, std::uint64_t line, spec::EventKind kind = spec::EventKind::move) {
  for (model::Event& event : events)
    if ((event.kind == kind || event.hole) && event.line == line) return event;
  throw std::logic_error("no such event");
}
model::Event& hole_at(Events& events, std::uint64_t line) {
  for (model::Event& event : events)
    if (event.hole && event.line == line) return event;
  throw std::logic_error("no such hole");
}
template <std::uint64_t line, std::size_t axis>
void shift_point(Events& events) {
  at_line(events, line).point.value.at(axis) += Real(1);
}
template <std::uint64_t line>
void shift_axes(Events& events) {
  at_line(events, line).axes.value[2] += Real(1);
}
template <std::uint64_t line, Real spec::Hole<Real>::* level>
void shift_level(Events& events) {
  (*hole_at(events, line).hole).*level += Real(1);
}
void leave_out_a_hole(Events& events) {
  std::erase_if(events, [one = true](const model::Event& e) mutable {
    return e.hole && e.line == 3 && std::exchange(one, false);
  });
}
// To another place, with its axes.
template <std::uint64_t line, std::size_t axis>
void shift_hole(Events& events) {
  model::Event& hole = hole_at(events, line);
  hole.point.value.at(axis) += Real(1);
  hole.axes.value.at(axis) += Real(1);
}
template <std::uint64_t line, std::size_t axis>
void shift_hole_axes(Events& events) {
  hole_at(events, line).axes.value.at(axis) += Real(1);
}
// All of it along the tool, as if a datum were not shifted.
template <std::uint64_t line>
void shift_hole_along(Events& events) {
  model::Event& event = hole_at(events, line);
  for (Real* level : {&event.hole->point_r, &event.hole->bottom, &event.hole->level, &event.axes.value[2]})
    *level -= Real(3);
}
template <std::uint64_t line>
void leave_out_hole(Events& events) {
  std::erase_if(events, [](const model::Event& e) { return e.hole && e.line == line; });
}
template <std::uint64_t line>
void drill_twice(Events& events) {
  const model::Event hole = hole_at(events, line);
  const auto place = std::ranges::find_if(events, [](const model::Event& e) { return e.hole && e.line == line; });
  events.insert(place, hole);
}
// In a block that has none.
template <std::uint64_t from, std::uint64_t to>
void drill_elsewhere(Events& events) {
  model::Event hole = hole_at(events, from);
  hole.line = to;
  const auto place = std::ranges::find_if(events, [](const model::Event& e) { return e.line > to; });
  events.insert(place, hole);
}
template <std::uint64_t line, std::size_t axis>
void shift_programmed(Events& events) {
  at_line(events, line).programmed.value.at(axis) += Real(1);
}
void shorten_vector(Events& events) {
  model::Event& event = at_line(events, 3);
  for (std::size_t i = 0; i < 3; ++i)
    event.point.value.at(i) = event.programmed[i] + (event.point[i] - event.programmed[i]) / Real(2);
}
void shift_machine(Events& events) { last_move(events).machine.value[0] += Real(1); }
void turn_axis(Events& events) { last_move(events).machine.value[3] += Real(1); }
void turn_word(Events& events) { last_move(events).axes.value[3] += Real(1); }
void shift_sample(Events& events) {
  for (model::Event& event : events)
    if (event.kind == spec::EventKind::sample) event.point.value[0] += Real(1);
}
void turn_samples(Events& events) {
  for (model::Event& event : events)
    if (event.kind == spec::EventKind::sample) event.axes.value[4] += Real(1);
}
void lean_tool(Events& events) {
  for (model::Event& event : events)
    if (event.tool_axis) event.tool_axis = {0, Real(exact::Rational(3, 5)), Real(exact::Rational(4, 5))};
}
void end_as_commanded(Events& events) {
  const Real size = sqrt(Real(207 * 207 + 14 * 14 + 978 * 978));
  last_move(events).tool_axis = {Real(-207) / size, Real(14) / size, Real(978) / size};
}
void lean_samples(Events& events) {
  for (model::Event& event : events)
    if (event.kind == spec::EventKind::sample)
      event.tool_axis = {0, Real(exact::Rational(3, 5)), Real(exact::Rational(4, 5))};
}
void change_setting(Events& events) {
  for (model::Event& event : events)
    if (event.kind == spec::EventKind::setting) event.value += Real(1);
}
void shift_contact(Events& events) { last_move(events).space->contact->point[0] += Real(1); }
void shift_center(Events& events) { last_move(events).space->tool_center[1] += Real(1); }
void shift_carrier(Events& events) { (*last_move(events).space->carrier)[1] += Real(1); }
void shift_shift(Events& events) { last_move(events).space->shift[2] += Real(1); }

struct Example {
  std::string_view law;
  spec::Case c;
  Break wrong;
};

spec::Case row_of_holes() {
  return fanuc("canned-cycle",
               "G90 G00 X10. Y20. Z50. G43 H1\nG99 G81 X30. R5. Z-10. F100\nG91 X5. K3\nG98 Y7. R-30. Z-12.\n"
               "G80 G00 Z1.\n");
}

// Holes of a tool of 0.05 less than its table says: under a shifted datum, behind M140 MB MAX, and one that a
// peripheral contour comes before. Line 8 does nothing.
spec::Case klartext_holes() {
  return klartext("peripheral-milling",
                  "TOOL CALL 1 Z DL-0.05\nL X+10 Y+20 Z+50 R0 FMAX\nCYCL DEF 7.0\nCYCL DEF 7.1 Z+3\n"
                  "CYCL DEF 200 DRILLING Q200=+2 Q201=-20 Q203=+5 Q204=+30\nCYCL CALL\nQ201 = 0\nL X+15 M99\n"
                  "Q201 = -Q204 / 2\nM140 MB MAX\nL IX+15 Y+25 FMAX M99\nQ200 = 40\nM128\nL X+0 RL\n"
                  "L Y+40\nL R0\nM129\nCYCL CALL\nL X+1\n");
}

std::vector<Example> examples() {
  const spec::Case conventional = head("G90 G43.4 H1 P0\nG01 F100 X20. Y-20. B20. C45.\nX50. B40. C60.\n");
  return {
      {"perpendicular-to-the-tool", flank(), shift_point<4, 2>},
      {"not-nearer-than-the-radius", flank(), shorten_vector},
      {"beside-the-line-before", flank(), shift_point<3, 0>},
      {"beside-the-line-after", flank(), shift_point<4, 1>},
      {"beside-the-line-before", rounded_corner(), shift_point<3, 1>},
      {"beside-the-arc", rounded_corner(), shift_point<4, 0>},
      {"beside-the-arc", arc_of_the_side("K1."), shift_point<4, 0>},
      {"beside-the-arc", arc_of_the_side("K1."), shift_point<3, 1>},
      {"beside-the-arc", arc_of_the_side("K-1."), shift_point<4, 0>},
      {"beside-the-arc", arc_of_the_side("I3. K4."), shift_point<4, 0>},
      {"perpendicular-to-the-tool", arc_of_the_side("I3. K4."), shift_point<4, 2>},
      {"normal-of-the-block", type_b(), shift_point<3, 1>},
      {"on-the-path-without-a-mode", fanuc("tool-length-offset", "G01 F100 X10.\nX20.\n"), shift_point<2, 0>},
      {"on-the-path-without-a-mode", rounded_corner(), shift_point<6, 0>},
      {"where-the-tool-is-said-to-be",
       fanuc("cutter-compensation-c", "G90 G01 F100 G41 D1 X20.\nX50. Y30.\nG92 X0 Y0\nX40.\nG40 Y50.\n"),
       shift_point<2, 1>},
      {"leading-edge-vector",
       fanuc("leading-edge-offset", "G90 G01 F100 G43.5 H0 I3. K4.\nG41.3 D1\nX100.\nX200. Y10.\nG40\n"),
       shift_point<2, 0>},
      {"length-offset", fanuc("tool-length-offset", "G90 G00 G44 Z100. H1\nX10.\nG49 Z50.\n"), shift_axes<1>},
      {"length-offset", fanuc("tool-length-offset", "G90 G00 G44 Z100. H1\nX10.\nG49 Z50.\n"), shift_axes<3>},
      {"length-offset-stays", fanuc("tool-length-offset", "G90 G00 G44 Z100. H1\nX10.\n"), shift_axes<2>},
      {"by-the-words-alone",
       [] {
         spec::Case c = fanuc("tool-length-offset", "G91 G00 X0\nG43 H1\nX10. Z5.\n");
         c.setup.parameters[{5006, 6}] = spec::decimal(1);
         return c;
       }(),
       shift_axes<3>},
      {"signed-sums", fanuc("tool-offset", "G91 G46 G00 X80. Y50. D1\nG47 G01 F100 X50.\nG46 X-0 Y-5.\nG48 X40.\n"),
       shift_point<3, 0>},
      {"measured-difference",
       [] {
         spec::Case c = fanuc("tool-length-measurement", "H1\nG90 G00 Z700.\nG37 Z200.\n");
         c.setup.position['Z'] = spec::decimal(760);
         c.setup.measurement['Z'] = spec::decimal(198);
         c.setup.parameters[{6251, -1}] = spec::decimal(20);
         c.setup.parameters[{6254, -1}] = spec::decimal(5);
         return c;
       }(),
       change_setting},
      {"hole-where-commanded", row_of_holes(), shift_point<2, 0>},
      {"hole-where-commanded", row_of_holes(), leave_out_a_hole},
      {"hole-levels", row_of_holes(), shift_level<2, &spec::Hole<Real>::point_r>},
      {"hole-levels", row_of_holes(), shift_level<3, &spec::Hole<Real>::bottom>},
      {"hole-levels", row_of_holes(), shift_level<4, &spec::Hole<Real>::level>},
      {"hole-axes", row_of_holes(), shift_axes<2>},
      {"axis-of-the-positions", table(kByPositions), turn_axis},
      {"axis-of-the-positions", head(kByDirection), lean_samples},
      {"tip-of-the-axes", table(kByPositions), shift_machine},
      {"tip-of-the-axes", head(kByDirection), shift_machine},
      {"offset-taken-back",
       [] {
         spec::Case c = table("G90 G43.4 H1 P0 A20. C45.\nG01 F100 X20. Y-20. A-35. C10.\nG49\n");
         c.setup.tip_control_cancel = spec::TipControlCancel::moves;
         return c;
       }(),
       shift_axes<3>},
      {"tip-on-the-path", table(kByPositions), shift_sample},
      {"tip-on-the-path", head(kByDirection), shift_sample},
      {"commanded-direction", head(kByDirection), lean_tool},
      {"commanded-direction", head("G90 G01 F100 G43.5 H1 P0\nX50. I-1. J1. K2.\n"), lean_tool},
      {"commanded-direction", head(kHelix), lean_tool},
      {"changed-end", near_the_pole(3), lean_tool},
      {"changed-end", near_the_pole(5), lean_tool},
      {"changed-end", near_the_pole(5), end_as_commanded},
      {"great-circle", head(kByDirection), lean_samples},
      {"great-circle", near_the_pole(3), lean_samples},
      {"positions-in-proportion", near_the_pole(5), turn_samples},
      {"positions-in-proportion", conventional, turn_samples},
      {"positions-as-programmed", conventional, turn_word},
      {"touches-the-contact-plane", face(), shift_contact},
      {"touches-the-contact-plane", face(), shift_center},
      {"nominal-tool-touches", face(), shift_contact},
      {"nominal-tool-touches", contour(), shift_contact},
      {"direction-of-the-tool", face(), lean_tool},
      {"tool-as-the-axes-stand", turned(), lean_tool},
      {"length-along-the-tool", face(), shift_carrier},
      {"shift-of-the-tip", face(), shift_shift},
      {"cylinder-beside-the-line", side(), shift_point<4, 1>},
      {"cylinder-beside-the-line", side(), shift_point<5, 0>},
      {"cylinder-beside-the-line", side(), shift_point<6, 0>},
      {"hole-where-programmed", klartext_holes(), shift_hole<6, 0>},
      {"hole-where-programmed", klartext_holes(), shift_hole<11, 1>},
      {"hole-where-programmed", klartext_holes(), shift_hole<18, 0>},
      {"hole-where-programmed", klartext_holes(), leave_out_hole<6>},
      {"hole-where-programmed", klartext_holes(), leave_out_hole<18>},
      {"hole-where-programmed", klartext_holes(), drill_twice<11>},
      {"hole-where-programmed", klartext_holes(), drill_elsewhere<6, 8>},
      {"hole-where-programmed", klartext_holes(), shift_programmed<19, 2>},
      {"hole-by-its-parameters", klartext_holes(), shift_hole_along<6>},
      {"hole-by-its-parameters", klartext_holes(), shift_level<6, &spec::Hole<Real>::level>},
      {"hole-by-its-parameters", klartext_holes(), shift_level<11, &spec::Hole<Real>::bottom>},
      {"hole-by-its-parameters", klartext_holes(), shift_level<18, &spec::Hole<Real>::level>},
      {"hole-with-length", klartext_holes(), shift_hole_axes<6, 2>},
      {"hole-with-length", klartext_holes(), shift_hole_axes<11, 1>},
  };
}

TEST(Laws, HoldForRightEventsAndBreakForWrongOnes) {
  std::set<std::string_view> asked;
  for (const Example& example : examples()) {
    SCOPED_TRACE(std::string(example.law) + "\n" + example.c.program);
    asked.insert(example.law);
    Events events = run_model(example.c).events;
    const laws::LawResult right = laws::hold(example.law, example.c, events);
    EXPECT_GT(right.checks, 0U);
    EXPECT_EQ(right.left_open, 0U);
    EXPECT_FALSE(right.violation) << right.violation->text << ": " << right.violation->amount;
    const laws::LawResult every = laws::hold(example.c, events);
    EXPECT_FALSE(every.violation) << every.violation->law << ": " << every.violation->amount;
    example.wrong(events);
    const laws::LawResult wrong = laws::hold(example.law, example.c, events);
    ASSERT_TRUE(wrong.violation);
    EXPECT_EQ(wrong.violation->law, example.law);
    EXPECT_FALSE(wrong.violation->text.empty());
    EXPECT_LT(wrong.violation->event, events.size());
    EXPECT_EQ(wrong.violation->line, events[wrong.violation->event].line);
  }
  for (const laws::LawInfo& law : laws::all()) EXPECT_TRUE(asked.contains(law.name)) << law.name << " has no example";
}

// Exemptions that searches asked for.
TEST(Laws, HoldWhereTheyOnceCriedWolf) {
  // A line along the tool lies between the end of the arc and the block that changes the side.
  spec::Case side_change = fanuc("cutter-compensation-c", "G90 G01 F100\nG42 D1\nG02 X60. I30.\nG00 Z1.\nG41 X0\n");
  side_change.setup.parameters[{5003, 1}] = spec::decimal(1);
  // An inclined tool-side axis reaches the commanded direction by the changed end, and not along a great circle.
  spec::Case inclined = fanuc("tool-posture-control", "B1.\nG43.5 P1\nI-10. J1. K50.\n");
  inclined.setup.axes = spec::Axes("XYZCB");
  inclined.setup.rotary_angles = spec::RotaryAngles::programmed;
  for (const auto& [number, value] : std::vector<std::pair<std::uint32_t, std::int64_t>>{
           {19680, 21}, {19681, 5}, {19682, 5}, {19683, 45}, {19686, 4}, {19687, 3}, {19738, 120}, {19739, 31}})
    inclined.setup.parameters[{number, -1}] = spec::decimal(value);
  inclined.samples = 2;
  for (const spec::Case& c : {side_change, inclined}) {
    SCOPED_TRACE(c.program);
    const laws::LawResult verdict = laws::hold(c, run_model(c).events);
    EXPECT_GT(verdict.checks, 0U);
    EXPECT_EQ(verdict.left_open, 0U);
    EXPECT_FALSE(verdict.violation) << verdict.violation->law << ": " << verdict.violation->amount;
  }
}

// Words that are another's: of G04, and of a second block in the line (events name lines, so such lines are no places).
TEST(Laws, ReadWordsAsTheirOwnersDo) {
  for (const spec::Case& c :
       {head("G90 G01 F100\nG43.4 G04 H1 P1\nX50. B40. C80.\n"),
        head("G90 G01 F100\nG43.5 G04 H1 Q2. P1\nX50. I1. J2. K3.\n"),
        head("G90 G01 F100\nG43.4 H1 P0\nX50. B20.\nG49; G43.4 H0 P1\nX0 B40. C80.\n"),
        fanuc("tool-offset", "G91 G01 F100 X10.\nG04 G46 D1 X20.\nG45 G04 X3.\nX5.\n"),
        head("G90 G01 F100\nG45 X10. D1\nG43.5 H1 Q2. P0\nX0 I1 K1\nG02 X20. R15.\n"),
        fanuc("cutter-compensation-c", "G90 G01 F100 X0\nG41 X40. D1\nX80.\nX100. Y20.; Y40.; G40 Y60.; X70.\n")}) {
    SCOPED_TRACE(c.program);
    const laws::LawResult verdict = laws::hold(c, run_model(c).events);
    EXPECT_GT(verdict.checks, 0U);
    EXPECT_EQ(verdict.left_open, 0U);
    EXPECT_FALSE(verdict.violation) << verdict.violation->law << ": " << verdict.violation->amount;
  }
}

// A changed end 1e-29 from the commanded direction passes for it, however long I J K are.
TEST(Laws, AChangedEndHardlyBesideTheCommandedOne) {
  spec::Case c = table(
      "G91 G01 F3700 A30. C-90.\nG43.5 H1 P1\nX-12. I.0000000000001 J.0000000000001 K98\n"
      "X-6. I-.0000000000001 K-98\n");
  c.setup.parameters[{19738, -1}] = spec::decimal(2);
  c.setup.parameters[{19739, -1}] = spec::decimal(1);
  const laws::LawResult verdict = laws::hold(c, run_model(c).events);
  EXPECT_GT(verdict.checks, 0U);
  EXPECT_FALSE(verdict.violation) << verdict.violation->law << ": " << verdict.violation->amount;
}

// The tool of a helix without its pitch leans another way.
TEST(Laws, LeanAlongTheTangentOfAHelix) {
  const spec::Case helix = head(kHelix);
  spec::Case flat = helix;
  flat.program.erase(flat.program.find(" Z15."), 5);
  Events events = run_model(helix).events;
  Events other = run_model(flat).events;
  EXPECT_FALSE(laws::hold("commanded-direction", helix, events).violation);
  last_move(events).tool_axis = last_move(other).tool_axis;
  EXPECT_TRUE(laws::hold("commanded-direction", helix, events).violation);
}

TEST(Laws, OfChangedProgramsHoldAndBreak) {
  const laws::Runner right = [](const spec::Case& c) { return run_model(c).events; };
  const laws::Runner wrong = [](const spec::Case& c) {
    Events events = run_model(c).events;
    at_line(events, 4).point.value[1] += Real(1);
    return events;
  };
  const laws::Runner wrong_shift = [](const spec::Case& c) {
    Events events = run_model(c).events;
    shift_shift(events);
    return events;
  };
  for (const std::string_view law : laws::changes()) {
    SCOPED_TRACE(law);
    spec::Case c = law == "reversed" ? corners() : rounded_corner();
    if (law == "cut-at-a-stop") c.program += "M00\n";
    const Events events = run_model(c).events;
    const laws::LawResult held = laws::hold_changed(law, c, events, right);
    EXPECT_GE(held.checks, events.size());
    EXPECT_FALSE(held.violation) << held.violation->text << ": " << held.violation->amount;
    const laws::LawResult broken = laws::hold_changed(law, c, events, wrong);
    ASSERT_TRUE(broken.violation);
    EXPECT_EQ(broken.violation->law, law);
    EXPECT_FALSE(broken.violation->amount.empty());
  }
  spec::Case without_deltas = face();
  without_deltas.program.replace(without_deltas.program.find(" DL+0.05"), 8, "");
  const Events events = run_model(without_deltas).events;
  EXPECT_GT(laws::hold_changed("value-zero", without_deltas, events, right).checks, 0U);
  EXPECT_FALSE(laws::hold_changed("value-zero", without_deltas, events, right).violation);
  EXPECT_TRUE(laws::hold_changed("value-zero", without_deltas, events, wrong_shift).violation);
}

// A block that cancels and selects a system: the corner at its start is in the coordinates of the block.
spec::Case cancel_in_another_system() {
  spec::Case c = fanuc("tool-side-compensation", "G41.2 D1 X1\nY0\nG40 X0 G59\n");
  c.setup.d[1].geometry = spec::decimal(1);
  c.setup.parameters[{5003, 0}] = spec::decimal(1);
  c.setup.workpiece[5]['X'] = spec::decimal(230);
  c.setup.position['Y'] = spec::decimal(-120);
  return c;
}

using Coordinates = spec::AxisValues<Real> model::Event::*;
// What two engines agreed on: it is in those of the system before.
Events corner_in_the_system_before(const spec::Case& c, const std::vector<Coordinates>& fields) {
  Events events = run_model(c).events;
  spec::AxisTable before = c.setup.workpiece[0];
  spec::AxisTable after = c.setup.workpiece[5];
  for (model::Event& event : events)
    for (const Coordinates field : fields)
      if (event.cause == spec::Cause::corner && event.line == 3)
        for (std::size_t i = 0; i < 3; ++i)
          (event.*field).value.at(i) += Real(laws::rational(after["XYZ"[i]]) - laws::rational(before["XYZ"[i]]));
  return events;
}

TEST(Laws, FindACornerInTheCoordinatesOfTheSystemBefore) {
  const spec::Case c = cancel_in_another_system();
  const laws::Runner right = [](const spec::Case& other) { return run_model(other).events; };
  const laws::LawResult held = laws::hold_changed(c, right(c), right);
  EXPECT_GT(held.checks, 0U);
  EXPECT_FALSE(held.violation) << held.violation->text << ": " << held.violation->amount;
  const auto programmed = &model::Event::programmed;
  const auto point = &model::Event::point;
  const auto axes = &model::Event::axes;
  for (const std::vector<Coordinates>& fields :
       std::vector<std::vector<Coordinates>>{{programmed, point, axes}, {point, axes}, {programmed}, {point}, {axes}}) {
    const laws::Runner wrong = [&](const spec::Case& other) { return corner_in_the_system_before(other, fields); };
    // Whatever the share of its program.
    const laws::LawResult broken = laws::hold_changed(c, wrong(c), wrong);
    ASSERT_TRUE(broken.violation);
    EXPECT_EQ(broken.violation->law, "moved-origins");
    EXPECT_EQ(broken.violation->line, 3U);
  }
}

// Every way to name a place, in several systems.
std::vector<spec::Case> several_systems() {
  std::vector<spec::Case> cases{
      fanuc("tool-length-offset", "G90 G00 X10. Z5.\nG55 G43 H1 Z7.\nG56\nX3. Y1.\nG91 X2. G57\nG90 G54.1 Z0\n"),
      fanuc("tool-length-offset", "G55 X1.\nG52 X3. Y4.\nX2.\nG92 Y6. Z1.\nY2.\nG59 X1.\nG53 X0 Z1.\nX5. Z2.\n"),
      fanuc("tool-length-offset", "G56 X1.\nG28 X7. Z8.\nX3.\nG29 X5.\nG57 X2.\nG91 G30 X1.\nX1. Z1.\n"),
      fanuc("tool-length-offset", "G20 X1. Y2.\nG55 X1. Y.5\nG21 Y20\nG92 X3\nX4. Z-5\n"),
      fanuc("tool-length-offset", "G55 X1.\nG10 L2 P2 X5. Y6.\nX2. Y2.\nG91 G10 L20 P3 X4.\nG90 G54.1 P3 X1.\n"),
      fanuc("tool-offset", "G90 G01 F100 X10. G55\nG45 X20. D1\nG56 G46 Y-0 D1\nX5.\n"),
      fanuc("cutter-compensation-c",
            "G90 G01 F100 X0\nG41 X40. D1\nX80. G55\nG56\nG03 X100. Y20. J20.\nG54.1 P2 G01 Y60.\nG40 X0 G57\n")};
  cases[3].setup.parameters[{3401, 0}] = spec::decimal(0);
  return cases;
}

TEST(Laws, OfMovedOriginsHoldForEveryPlaceAndBreakForOtherOrigins) {
  const laws::Runner right = [](const spec::Case& c) { return run_model(c).events; };
  // The machine goes to another place when a system is selected.
  const laws::Runner selects_nothing = [](const spec::Case& c) {
    spec::Case other = c;
    for (const std::string_view code : {"G55", "G56"})
      for (std::size_t at = 0; (at = other.program.find(code, at)) != std::string::npos;) other.program.erase(at, 3);
    return run_model(other).events;
  };
  const laws::Runner confuses_two = [](const spec::Case& c) {
    spec::Case other = c;
    std::swap(other.setup.workpiece[1], other.setup.workpiece[2]);
    return run_model(other).events;
  };
  for (const spec::Case& c : several_systems()) {
    SCOPED_TRACE(c.program);
    const Events events = right(c);
    ASSERT_NE(events.back().kind, spec::EventKind::alarm) << events.back().number.view();
    const laws::LawResult held = laws::hold_changed("moved-origins", c, events, right);
    EXPECT_GE(held.checks, events.size());
    EXPECT_FALSE(held.violation) << held.violation->line << ' ' << held.violation->text << ": "
                                 << held.violation->amount;
    for (const laws::Runner& wrong : {selects_nothing, confuses_two})
      EXPECT_TRUE(laws::hold_changed("moved-origins", c, wrong(c), wrong).violation);
  }
}

// A coordinate that is kept for another system is no place of the machine.
TEST(Laws, OfMovedOriginsAreNotAskedWhereCoordinatesAreKept) {
  const laws::Runner right = [](const spec::Case& c) { return run_model(c).events; };
  for (const spec::Case& c : {fanuc("tool-length-offset", "G28 X7.\nX3.\nG55 G29 X5.\n"),
                              fanuc("tool-length-offset", "G54.1 G30 P2 X7.\nX3.\n")}) {
    SCOPED_TRACE(c.program);
    EXPECT_EQ(laws::hold_changed("moved-origins", c, right(c), right).checks, 0U);
  }
}

// What a broken law becomes: a difference that names it, flows on and is counted.
TEST(Laws, ABrokenLawIsADifference) {
  const spec::Case c = rounded_corner();
  ModelRun run = run_model(c);
  Verdict verdict = judge::judge(c, run, run_fast(c));
  ASSERT_EQ(verdict.outcome, Outcome::agrees);
  EXPECT_GT(hold_laws(c, run, verdict), 0U);
  EXPECT_EQ(verdict.outcome, Outcome::agrees);
  shift_point<4, 0>(run.events);
  hold_laws(c, run, verdict);
  ASSERT_EQ(verdict.outcome, Outcome::differs);
  EXPECT_EQ(verdict.difference->kind, "law");
  EXPECT_EQ(verdict.difference->line, 4U);
  EXPECT_FALSE(verdict.difference->field.empty());
  EXPECT_GT(verdict.values, 0U);
  // Findings, their shrinking and their replay go by the name of the law; no clause is to blame.
  const certify::FailureKey key = certify::key_of(c, *verdict.difference);
  EXPECT_EQ(key.kind, "law " + verdict.difference->field);
  EXPECT_TRUE(key.clause.empty());
  // A difference that is there already stays.
  verdict.difference->kind = "coordinate";
  EXPECT_EQ(hold_laws(c, run, verdict), 0U);
  EXPECT_EQ(verdict.difference->kind, "coordinate");
}

// With one wrong clause in both engines the verdict agrees, and its law finds it (others may find it sooner).
TEST(Laws, FindWrongClausesThatBothEnginesFollow) {
  std::set<std::string_view> sections;
  for (const fuzz::WrongClause& wrong : fuzz::wrong_clauses()) {
    SCOPED_TRACE(wrong.name);
    sections.insert(wrong.section);
    std::uint64_t executions = 0;
    std::string found;
    while (found.empty() && executions < wrong.budget) {
      fuzz::SeededSource source(++executions);
      const spec::Case c = fuzz::generate(wrong.section, fuzz::Mode::directed, source);
      const Trial trial = fuzz::try_wrong(wrong, c);
      if (!trial.found()) continue;
      // What is found without the fault by another law is none of the fault's.
      if (const Trial right = try_case(c); right.found() && right.verdict.difference->field != wrong.law) continue;
      ASSERT_EQ(trial.verdict.difference->kind, "law");
      if (trial.verdict.difference->field == wrong.law) found = wrong.law;
    }
    EXPECT_EQ(found, wrong.law);
    std::printf("%-28s %-28s %llu executions\n", std::string(wrong.name).c_str(), found.c_str(),
                static_cast<unsigned long long>(executions));
  }
  EXPECT_GE(sections.size(), 6U);
}

}  // namespace
}  // namespace toolcomp::judge

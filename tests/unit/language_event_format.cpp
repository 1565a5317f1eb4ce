// SPDX-License-Identifier: Apache-2.0
// Events as JSON, CSV and G-code: the fields in the order of docs/events.md, hand-written expectations.
#include "spec/language/event_format.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "spec/language/event_map.h"
#include "spec/language/number_text.h"
#include "spec/language/text_buffer.h"

namespace {

using namespace toolcomp::spec;

const Axes kAxes("XYZB");

AxisValues<double> values(std::initializer_list<std::pair<char, double>> list) {
  AxisValues<double> result;
  for (const auto& [letter, value] : list) result.set(kAxes.index(letter), value);
  return result;
}

Event<double> line_move() {
  Event<double> event;
  event.line = 5;
  event.n = 30;
  event.programmed = values({{'X', 10}, {'Y', -0.0}, {'Z', 0.1}});
  event.point = values({{'X', 10}, {'Y', 1.5}, {'Z', 0.1}});
  event.axes = values({{'X', 10}, {'Y', 1.5}, {'Z', 4.1}, {'B', 90}});
  event.feed = 250;
  return event;
}

Event<double> arc_move() {
  Event<double> event;
  event.line = 6;
  event.type = MoveType::arc;
  event.cause = Cause::corner;
  event.point = values({{'X', 15}, {'Y', 6.5}, {'Z', 0.1}});
  event.axes = values({{'X', 15}, {'Y', 6.5}, {'Z', 4.1}, {'B', 90}});
  event.arc = Arc<double>{.center = values({{'X', 10}, {'Y', 6.5}}),
                          .plane = Plane::xy,
                          .direction = ArcDirection::ccw,
                          .sweep = 90,
                          .radius = std::pair(5.0, 5.5)};
  return event;
}

std::string json(const Event<double>& event) {
  std::string out;
  append_event_json(out, event, kAxes, append_shortest);
  return out;
}
std::string csv(const Event<double>& event) {
  std::string out;
  append_event_csv(out, event, kAxes, append_shortest);
  return out;
}

TEST(EventJson, LineMove) {
  EXPECT_EQ(
      json(line_move()),
      R"({"kind":"move","line":5,"n":30,"type":"linear","cause":"programmed","programmed":{"X":10,"Y":0,"Z":0.1},)"
      R"("point":{"X":10,"Y":1.5,"Z":0.1},"axes":{"X":10,"Y":1.5,"Z":4.1,"B":90},"feed":250})");
}

TEST(EventJson, ArcMove) {
  EXPECT_EQ(json(arc_move()),
            R"({"kind":"move","line":6,"type":"arc","cause":"corner","point":{"X":15,"Y":6.5,"Z":0.1},)"
            R"("axes":{"X":15,"Y":6.5,"Z":4.1,"B":90},"center":{"X":10,"Y":6.5},"plane":"XY","direction":"ccw",)"
            R"("sweep":90,"radius":[5,5.5]})");
}

TEST(EventJson, MachineAndToolAxis) {
  Event<double> event;
  event.line = 1;
  event.type = MoveType::rapid;
  event.cause = Cause::reference;
  event.machine = values({{'Z', 300}});
  event.tool_axis = {0.6, 0.0, 0.8};
  EXPECT_EQ(
      json(event),
      R"({"kind":"move","line":1,"type":"rapid","cause":"reference","machine":{"Z":300},"tool_axis":[0.6,0,0.8]})");
}

TEST(EventJson, Others) {
  Event<double> alarm;
  alarm.kind = EventKind::alarm;
  alarm.line = 3;
  alarm.n = 7;
  alarm.number = "PS0041";
  alarm.message = "a \"cut\"";
  EXPECT_EQ(json(alarm), R"({"kind":"alarm","number":"PS0041","line":3,"n":7,"message":"a \"cut\""})");

  Event<double> setting;
  setting.kind = EventKind::setting;
  setting.line = 4;
  setting.setting = "H1";
  setting.value = -4;
  EXPECT_EQ(json(setting), R"({"kind":"setting","name":"H1","value":-4,"line":4})");

  Event<double> sample;
  sample.kind = EventKind::sample;
  sample.line = 9;
  sample.t_numerator = 1;
  sample.t_denominator = 4;
  sample.axes = values({{'X', 1}});
  EXPECT_EQ(json(sample), R"({"kind":"sample","line":9,"t":"1/4","axes":{"X":1}})");

  Event<double> undecided;
  undecided.kind = EventKind::undecided;
  undecided.line = 2;
  undecided.number = "a.clause";
  undecided.permitted = {.positive = true, .negative = false, .tie = true};
  EXPECT_EQ(json(undecided), R"({"kind":"undecided","line":2,"clause":"a.clause","permitted":["positive","tie"]})");
  undecided.permitted = {};
  EXPECT_EQ(json(undecided), R"({"kind":"undecided","line":2,"clause":"a.clause","permitted":[]})");
}

Event<double> space_move() {
  Event<double> event = line_move();
  event.n.reset();
  event.tool_axis = {0, 0, 1};
  event.space.emplace();
  event.space->tool_center = {1, 2, 3};
  event.space->shift = {0.5, -0.0, 0};
  event.space->tool_shift = {0.5, 0, 0.25};
  return event;
}

TEST(EventJson, SpaceCompensation) {
  Event<double> event = space_move();
  const std::string head =
      R"({"kind":"move","line":5,"type":"linear","cause":"programmed","programmed":{"X":10,"Y":0,"Z":0.1},)"
      R"("point":{"X":10,"Y":1.5,"Z":0.1},"axes":{"X":10,"Y":1.5,"Z":4.1,"B":90},"tool_axis":[0,0,1],)"
      R"("tool_center":{"X":1,"Y":2,"Z":3},)";
  const std::string shifts = R"("shift":{"X":0.5,"Y":0,"Z":0},"tool_shift":{"X":0.5,"Y":0,"Z":0.25},)";
  EXPECT_EQ(json(event), head + shifts + R"("feed":250})");
  event.space->carrier = {1, 2, 103};
  event.space->contact = Contact<double>{.point = {4, 5, 6}, .normal = {0.6, 0, 0.8}, .flat = true, .angle = 45};
  EXPECT_EQ(json(event), head + R"("contact":{"X":4,"Y":5,"Z":6},"normal":[0.6,0,0.8],)" + shifts +
                             R"("carrier":{"X":1,"Y":2,"Z":103},"angle":45,"flat":true,"feed":250})");
  const auto same = [](double value) { return value; };
  EXPECT_EQ(json(map_numbers<double>(event, same)), json(event));
  EXPECT_EQ(json(map_numbers<double>(space_move(), same)), json(space_move()));
}

TEST(EventJson, OutOfScope) {
  Event<double> event;
  event.kind = EventKind::undecided;
  event.line = 2;
  event.number = "a.clause";
  event.out_of_scope = true;
  const std::string text =
      R"({"kind":"undecided","line":2,"clause":"a.clause","permitted":[],"reason":"OUT_OF_SCOPE"})";
  EXPECT_EQ(json(event), text);
  EXPECT_EQ(json(map_numbers<double>(event, [](double value) { return value; })), text);
  std::string gcode;
  GcodeState<double> state;
  append_event_gcode(gcode, event, kAxes, append_shortest_fixed, state);
  EXPECT_EQ(gcode, "(line 2: undecided: a.clause, OUT_OF_SCOPE)\n");
}

TEST(EventCsv, ColumnsOfSpaceCompensation) {
  std::string header;
  append_csv_header(header, kAxes, Control::heidenhain);
  EXPECT_NE(header.find("radius.end,tool_center.X,tool_center.Y,tool_center.Z,contact.X,contact.Y,contact.Z,normal.i,"
                        "normal.j,normal.k,shift.X,shift.Y,shift.Z,tool_shift.X,tool_shift.Y,tool_shift.Z,carrier.X,"
                        "carrier.Y,carrier.Z,angle,flat,feed,unknown,"),
            std::string::npos)
      << header;
  EXPECT_TRUE(header.ends_with(",r,bottom,return,t,reason,clauses\n"));
  const auto row = [](const Event<double>& event) {
    std::string out;
    append_event_csv(out, event, kAxes, append_shortest, Control::heidenhain);
    return out;
  };
  Event<double> event = space_move();
  EXPECT_EQ(row(event),
            "move,5,,linear,programmed,10,0,0.1,10,1.5,0.1,10,1.5,4.1,90,,,,,0,0,1,,,,,,,,,"
            "1,2,3,,,,,,,0.5,0,0,0.5,0,0.25,,,,,,250,,,,,,,,,,,\n");
  event.space->carrier = {1, 2, 103};
  event.space->contact = Contact<double>{.point = {4, 5, 6}, .normal = {0.6, 0, 0.8}, .flat = true, .angle = 45};
  EXPECT_EQ(row(event),
            "move,5,,linear,programmed,10,0,0.1,10,1.5,0.1,10,1.5,4.1,90,,,,,0,0,1,,,,,,,,,"
            "1,2,3,4,5,6,0.6,0,0.8,0.5,0,0,0.5,0,0.25,1,2,103,45,true,250,,,,,,,,,,,\n");
  Event<double> undecided;
  undecided.kind = EventKind::undecided;
  undecided.out_of_scope = true;
  for (const Event<double>& each : {event, undecided, line_move(), arc_move()})
    EXPECT_EQ(std::ranges::count(row(each), ','), std::ranges::count(header, ','));
  EXPECT_TRUE(row(undecided).ends_with(",OUT_OF_SCOPE,\n"));
}

TEST(EventCsv, HeaderAndRowsHaveTheSameColumns) {
  std::string header;
  append_csv_header(header, kAxes);
  EXPECT_EQ(
      header,
      "kind,line,n,type,cause,programmed.X,programmed.Y,programmed.Z,point.X,point.Y,point.Z,axes.X,axes.Y,axes.Z,"
      "axes.B,machine.X,machine.Y,machine.Z,machine.B,tool_axis.i,tool_axis.j,tool_axis.k,center.X,center.Y,"
      "center.Z,plane,direction,sweep,radius.start,radius.end,feed,number,message,name,value,r,bottom,return,t,"
      "clauses\n");
  EXPECT_EQ(csv(line_move()),
            "move,5,30,linear,programmed,10,0,0.1,10,1.5,0.1,10,1.5,4.1,90,,,,,,,,,,,,,,,,250,,,,,,,,,\n");
  EXPECT_EQ(csv(arc_move()),
            "move,6,,arc,corner,,,,15,6.5,0.1,15,6.5,4.1,90,,,,,,,,10,6.5,,XY,ccw,90,5,5.5,,,,,,,,,,\n");
  Event<double> alarm;
  alarm.kind = EventKind::alarm;
  alarm.number = "PS0041";
  alarm.message = "a \"cut\", no more";
  const std::string row = csv(alarm);
  EXPECT_NE(row.find(",PS0041,\"a \"\"cut\"\", no more\",,,,,,,\n"), std::string::npos) << row;
}

TEST(EventGcode, ThePathAsAProgram) {
  std::string out;
  GcodeState<double> state;
  append_gcode_begin(out, Units::mm);
  Event<double> rapid = line_move();
  rapid.type = MoveType::rapid;
  rapid.n.reset();
  Event<double> alarm;
  alarm.kind = EventKind::alarm;
  alarm.line = 7;
  alarm.number = "PS0023";
  alarm.message = "radius (R) cannot be";
  for (const Event<double>& event : {rapid, line_move(), arc_move(), alarm})
    append_event_gcode(out, event, kAxes, append_shortest_fixed, state);
  append_gcode_end(out);
  // I J from the tool point (10, 1.5) of the move before to the centre (10, 6.5).
  EXPECT_EQ(out,
            "%\nG90 G94 G21\n"
            "G00 X10 Y1.5 Z4.1 B90\n"
            "N30 G01 X10 Y1.5 Z4.1 B90 F250\n"
            "G17 G03 X15 Y6.5 Z4.1 B90 I0 J5\n"
            "(line 7: PS0023: radius [R] cannot be)\n"
            "M30\n%\n");
}

TEST(EventNames, GoBothWays) {
  EXPECT_EQ(name(Cause::pre_turn), "pre-turn");
  EXPECT_EQ(from_name<Cause>("start-up"), Cause::start_up);
  EXPECT_EQ(from_name<Cause>("startup"), std::nullopt);
  const auto round = []<class Enum>(Enum) {
    for (std::size_t i = 0; i < kNames<Enum>.size(); ++i)
      EXPECT_EQ(from_name<Enum>(name(static_cast<Enum>(i))), static_cast<Enum>(i));
  };
  round(EventKind{});
  round(MoveType{});
  round(Cause{});
  round(Plane{});
  round(ArcDirection{});
}

// However many clauses an event rests on, all of them are written.
TEST(TextBuffer, AllClausesFit) {
  const Axes axes("XYZ");
  const auto integer = [](auto& out, int value) { out += std::to_string(value); };
  Event<int> event;
  for (const ClauseInfo& clause : clauses()) event.clauses.add(*find_clause(clause.id));
  std::string expected;
  TextBuffer buffer;
  append_event_json(expected, event, axes, integer);
  append_event_csv(expected, event, axes, integer);
  {
    TextCursor out(buffer);
    append_event_json(out, event, axes, integer);
  }
  {
    TextCursor out(buffer);
    append_event_csv(out, event, axes, integer);
  }
  EXPECT_EQ(buffer.view(), expected);
  for (const ClauseInfo& clause : clauses()) EXPECT_NE(expected.find(clause.id), std::string::npos) << clause.id;
}

// Every field of every kind at its longest, in the room that is made for one event.
TEST(TextBuffer, AnEventFits) {
  const Axes axes("XYZABCUVW");
  const auto longest = [](auto& out, double) { out += std::string(48, '8'); };
  Event<double> event;
  for (std::size_t axis = 0; axis < axes.size(); ++axis)
    for (auto* map : {&event.programmed, &event.point, &event.axes, &event.machine}) map->set(axis, 1);
  event.line = event.n.emplace(std::numeric_limits<std::uint64_t>::max());
  event.tool_axis = {1.0, 2.0, 3.0};
  event.arc = Arc<double>{.center = event.axes, .sweep = 90, .radius = std::pair(5.0, 5.5)};
  event.feed = 1;
  event.number = std::string_view(std::string(Name::kCapacity, '"'));
  event.setting = event.number;
  const std::string message(10'000, '"');
  event.message = message.c_str();
  event.permitted = {true, true, true};
  for (const EventKind kind : {EventKind::move, EventKind::sample, EventKind::alarm, EventKind::warning,
                               EventKind::setting, EventKind::undecided}) {
    event.kind = kind;
    std::string expected;
    TextBuffer buffer;
    for (int times = 0; times < 3; ++times) {
      append_event_json(expected, event, axes, longest);
      append_event_csv(expected, event, axes, longest);
      GcodeState<double> state;
      append_event_gcode(expected, event, axes, longest, state);
      {
        TextCursor out(buffer);
        append_event_json(out, event, axes, longest);
      }
      {
        TextCursor out(buffer);
        append_event_csv(out, event, axes, longest);
      }
      TextCursor out(buffer);
      GcodeState<double> again;
      append_event_gcode(out, event, axes, longest, again);
    }
    EXPECT_EQ(buffer.view(), expected);
    buffer.clear();
    EXPECT_EQ(buffer.view(), "");
  }
}

TEST(EventMap, EveryNumberIsMappedAndNothingElse) {
  Event<double> event = arc_move();
  event.programmed = values({{'Z', 3}});
  event.machine = values({{'B', 4}});
  event.tool_axis = {1.0, 2.0, 3.0};
  event.feed = 7;
  const auto mapped = map_numbers<int>(event, [](double value) { return static_cast<int>(value * 10); });
  std::string out;
  append_event_json(out, mapped, kAxes, [](std::string& text, int value) { text += std::to_string(value); });
  EXPECT_EQ(
      out,
      R"({"kind":"move","line":6,"type":"arc","cause":"corner","programmed":{"Z":30},"point":{"X":150,"Y":65,"Z":1},)"
      R"("axes":{"X":150,"Y":65,"Z":41,"B":900},"machine":{"B":40},"tool_axis":[10,20,30],)"
      R"("center":{"X":100,"Y":65},"plane":"XY","direction":"ccw","sweep":900,"radius":[50,55],"feed":70})");
  Event<double> setting;
  setting.kind = EventKind::setting;
  setting.value = 2.5;
  EXPECT_EQ((map_numbers<int>(setting, [](double value) { return static_cast<int>(value * 10); }).value), 25);
}

TEST(Names, AreShortEnoughToBeKept) {
  for (const ClauseInfo& clause : clauses()) EXPECT_LE(clause.id.size(), Name::kCapacity) << clause.id;
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// The parts of a kit: cover, marks, programs, offsets, parameters, travels, the alarm form. Expected values by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "certify/kit/alarm_form.h"
#include "certify/kit/cover.h"
#include "certify/kit/klartext.h"
#include "certify/kit/marks.h"
#include "certify/kit/offsets.h"
#include "certify/kit/parameters.h"
#include "certify/kit/program.h"
#include "certify/kit/recording.h"
#include "certify/kit/screen.h"
#include "certify/trace/recording.h"
#include "certify/trace/samples.h"
#include "judge/oracle/verdict.h"
#include "spec/language/byte_source.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"

namespace {

namespace certify = toolcomp::certify;
namespace kit = toolcomp::certify::kit;
namespace spec = toolcomp::spec;
using kit::OutcomeSet;

const auto kAll = [](std::size_t, const OutcomeSet& claimed) { return claimed; };
const auto kTake = [](std::size_t) { return true; };

TEST(KitCover, TakesTheMostFirstAndNothingInVain) {
  // {1 2 3} brings three; then {4 5} brings two; {3 4} and {1} nothing any more; 6 has nobody.
  OutcomeSet wanted{1, 2, 3, 4, 5, 6};
  EXPECT_EQ(kit::greedy_cover({{1}, {4, 5}, {1, 2, 3}, {3, 4}}, wanted, kAll, kTake), (std::vector<std::size_t>{2, 1}));
  EXPECT_EQ(wanted, OutcomeSet{6});
}

TEST(KitCover, OfSeveralTheFirst) {
  OutcomeSet wanted{1, 2};
  EXPECT_EQ(kit::greedy_cover({{1}, {2}, {1}}, wanted, kAll, kTake), (std::vector<std::size_t>{0, 1}));
}

TEST(KitCover, AClaimThatIsNotTrueWaitsForItsTurn) {
  // The first claims three and shows one of them, 3: the second comes before it.
  OutcomeSet wanted{1, 2, 3};
  const auto prove = [](std::size_t i, const OutcomeSet& claimed) {
    return i == 0 ? kit::common(claimed, {3}) : claimed;
  };
  EXPECT_EQ(kit::greedy_cover({{1, 2, 3}, {1, 2}}, wanted, prove, kTake), (std::vector<std::size_t>{1, 0}));
  EXPECT_TRUE(wanted.empty());
}

TEST(KitCover, WhatIsRefusedCoversNothing) {
  OutcomeSet wanted{1, 2};
  const auto take = [](std::size_t i) { return i != 0; };
  EXPECT_EQ(kit::greedy_cover({{1, 2}, {1}}, wanted, kAll, take), (std::vector<std::size_t>{1}));
  EXPECT_EQ(wanted, OutcomeSet{2});
}

// 27 = 1·16 + 2·4 + 3: digits 0 0 1 2 3; check 1 + 1 + 3·2 + 3 = 11, to the base 4: 3.
TEST(KitMarks, TheDigitsOfANumber) {
  EXPECT_EQ(kit::digits_of(27), (std::array<unsigned, 6>{0, 0, 1, 2, 3, 3}));
  for (unsigned number = 0; number <= kit::kMostNumber; ++number)
    EXPECT_EQ(kit::number_of(kit::digits_of(number)), number);
  EXPECT_EQ(kit::number_of(std::vector<unsigned>{0, 0, 1, 2, 3, 2}), std::nullopt);
  EXPECT_EQ(kit::number_of(std::vector<unsigned>{0, 0, 1, 2, 3}), std::nullopt);
}

TEST(KitMarks, OneWrongDigitIsFound) {
  for (std::size_t place = 0; place < kit::kDigits; ++place)
    for (unsigned off = 1; off < kit::kBase; ++off) {
      auto digits = kit::digits_of(27);
      digits.at(place) = (digits.at(place) + off) % kit::kBase;
      EXPECT_EQ(kit::number_of(digits), std::nullopt) << place;
    }
}

std::vector<kit::Rest> rests(const std::vector<std::pair<double, bool>>& lengths) {
  std::vector<kit::Rest> list;
  double time = 0;
  for (const auto& [length, above] : lengths) {
    kit::Rest rest;
    rest.begin = time;
    rest.end = time + length;
    rest.at_place = true;
    rest.above = above;
    list.push_back(rest);
    time += length + 1;
  }
  return list;
}

TEST(KitMarks, AProgramIsFoundWithItsCases) {
  // A rest of no length of marks, then 27 with rests that are a little long, two cases, an end.
  std::vector<kit::Rest> list = rests({{7, false},
                                       {1.05, false},
                                       {1.1, true},
                                       {1.55, false},
                                       {2.1, true},
                                       {2.5, false},
                                       {2.6, true},
                                       {3.5, false},
                                       {3.45, false},
                                       {4.6, false}});
  auto found = kit::find_programs(list);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].number, 27U);
  EXPECT_EQ(found[0].first_rest, 1U);
  EXPECT_EQ(found[0].case_ends, (std::vector<std::size_t>{7, 8}));
  EXPECT_EQ(found[0].end_rest, 9U);
  // Rests inside a case stand elsewhere and mean nothing.
  list[7].at_place = false;
  EXPECT_EQ(kit::find_programs(list)[0].case_ends, (std::vector<std::size_t>{8}));
  // Without its last rest it has no end.
  list.pop_back();
  EXPECT_EQ(kit::find_programs(list)[0].end_rest, std::nullopt);
  // A mark whose rests all stand at the place is none.
  list[2].above = false;
  EXPECT_TRUE(kit::find_programs(list).empty());
}

TEST(KitMarks, ALengthThatIsOffIsNone) {
  const auto length = [](double seconds) { return kit::length_of(rests({{seconds, false}})[0]); };
  EXPECT_EQ(length(1.2), 1000U);
  EXPECT_EQ(length(1.25), std::nullopt);
  EXPECT_EQ(length(3.4), kit::kCaseEnd);
  EXPECT_EQ(length(0.5), std::nullopt);
}

kit::Machine machine(const std::string& more = "") {
  kit::Machine m;
  m.setup = spec::read_setup_toml("control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n" + more, "machine");
  for (const std::string travel : {"X=-100,100", "Y=-100,100", "Z=-50,50"}) kit::add_travel(m, travel);
  return m;
}

std::vector<spec::Block> blocks(const std::string& text) {
  std::vector<spec::Block> list;
  spec::ProgramReader reader(spec::text_source(text), spec::Axes("XYZ"), {});
  spec::Block block;
  while (reader.next(block)) list.push_back(block);
  return list;
}

std::string text(const std::vector<spec::Block>& list) {
  std::string all;
  for (const spec::Block& block : list) all += spec::to_string(block) + "\n";
  return all;
}

TEST(KitProgram, CasesStandBetweenRestsAndAreFoundByTheirLines) {
  const kit::Machine m = machine("[position]\nX = 5\n");
  const kit::ProgramText program = kit::write_program(
      m, 8027, "TWO", kit::ProgramKind::recorded,
      {{"one", blocks("N7 X1\nY2\n"), {}, {{'Z', spec::decimal(3)}}, 0, {}}, {"two", blocks("X4\n"), {}, {}, 0, {}}});
  std::istringstream in(program.text);
  std::vector<std::string> lines(1);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  EXPECT_EQ(lines[2], "O8027 (TWO)");
  EXPECT_EQ(lines[4], "G21");
  EXPECT_EQ(lines[6], "G00 X5. Y0. Z0.");
  std::vector<std::string> dwells;
  for (const std::string& line : lines)
    if (line.starts_with("G04")) dwells.push_back(line);
  EXPECT_EQ(dwells, (std::vector<std::string>{"G04 P1000", "G04 P1000", "G04 P1500", "G04 P2000", "G04 P2500",
                                              "G04 P2500", "G04 P3500", "G04 P3500", "G04 P4500"}));
  ASSERT_EQ(program.cases.size(), 2U);
  EXPECT_EQ(lines[program.cases[0].first - 1], "G00 X0. Y0. Z3.");
  EXPECT_EQ(lines[program.cases[0].first], "N1001 X1");
  EXPECT_EQ(lines[program.cases[0].last], "N1002 Y2");
  EXPECT_EQ(lines[program.cases[1].first], "N2001 X4");
  EXPECT_EQ(lines[program.marks.first_rest], "G04 P1000");
  EXPECT_EQ(lines[program.marks.last_rest], "G04 P4500");
  // What is judged has the same lines, without the moves before the first rest and behind the last.
  std::istringstream cut(kit::between_rests(program.text, program.marks));
  std::size_t number = 0;
  for (std::string line; std::getline(cut, line);) {
    ++number;
    EXPECT_EQ(line, number >= program.marks.steps && number < program.marks.first_rest ? "" : lines[number]);
  }
  EXPECT_EQ(number, program.marks.last_rest);
}

TEST(KitOffsets, CasesShareEntriesButNumbersOfACaseStayApart) {
  const kit::Machine m = machine();
  kit::OffsetTable table(m, 11);
  spec::Case first;
  first.setup = spec::read_setup_toml(
      "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[offsets.H]\n1 = 5\n2 = 5\n3 = \"7.5\"\n", "first");
  std::vector<spec::Block> one = blocks("G43 H1\nH2\nG10 L11 P3 R1.\nH0\n");
  ASSERT_TRUE(table.take(*kit::offsets_for(m, first, one), one));
  EXPECT_EQ(text(one), "G43 H11\nH12\nG10 L11 P13 R1.\nH0\n");
  // 7.5 stands in 13 already; D reads the same table.
  std::vector<spec::Block> two = blocks("G41 D3\n");
  ASSERT_TRUE(table.take(*kit::offsets_for(m, first, two), two));
  EXPECT_EQ(text(two), "G41 D13\n");
  EXPECT_EQ(table.h().size(), 3U);
}

TEST(KitOffsets, WhatCannotBeTypedInIsRefused) {
  const kit::Machine m = machine();
  spec::Case vector;
  vector.setup = spec::read_setup_toml(
      "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\nincrement = \"IS-C\"\n[offsets.H]\n1 = \"1.0005\"\n"
      "2 = \"1.0010\"\n3 = 1000\n",
      "vector");
  EXPECT_FALSE(kit::offsets_for(m, vector, blocks("H1\n")));
  EXPECT_TRUE(kit::offsets_for(m, vector, blocks("H2\n")));
  EXPECT_FALSE(kit::offsets_for(m, vector, blocks("H3\n")));
}

TEST(KitScreen, WhatABareMachineMustNotDoStaysAtHome) {
  const kit::Machine m = machine();
  const auto why = [&m](const std::string& program) {
    spec::Case vector;
    vector.program = program;
    return kit::screen(m, vector).why;
  };
  EXPECT_EQ(why("G01 X1. F100\nG43 H1 Z5.\nM30\n"), "");
  for (const std::string program :
       {"M03\nX1.", "S500\nX1.", "T1\nX1.", "M08",      "X1. M00",      "G20",        "G92 X0",  "G55",
        "G81 X1.",  "G28 X0",    "G37 Z5.", "G04 P500", "G10 L2 P1 X0", "G10 P1 R1.", "X1.0005", "F0",
        "F20000",   "U1.",       "/X1.",    "O5",       "X1 X",         "X123456789."})
    EXPECT_NE(why(program), "") << program;
  EXPECT_EQ(kit::screen(m,
                        [] {
                          spec::Case vector;
                          vector.program = "(NOTE) X1. ; Y2.\nM30\n";
                          return vector;
                        }())
                .blocks.size(),
            2U);
}

kit::Statements statements(const std::string& program) {
  spec::Case vector;
  vector.setup = spec::read_setup_toml("control = \"heidenhain\"\naxes = [\"X\", \"Y\", \"Z\", \"B\"]\n", "setup");
  vector.program = program;
  kit::Machine m;
  m.setup = vector.setup;
  kit::add_travel(m, "B=-90,90");
  const kit::ScreenedKlartext screened = kit::screen_klartext(m, vector);
  EXPECT_EQ(screened.statements.empty(), !screened.why.empty());
  return screened.statements;
}

std::string text(const kit::Statements& list) {
  std::string all;
  for (const auto& statement : list) all += kit::klartext_of(statement) + "\n";
  return all;
}

TEST(KitKlartext, FrameAndNumbersFallWhatABareMachineMustNotDoStaysAtHome) {
  EXPECT_EQ(text(statements("0 BEGIN PGM A MM\n1 BLK FORM 0.1 Z X0 Y0 Z0\n2 TOOL CALL 1 Z S5000 DR+.5\n3 L X.5 B45 R0 "
                            "FMAX M128\n4 CYCL DEF 7.0 NULLPUNKT\n5 CYCL DEF 7.1 X+1\n6 M30\n7 END PGM A MM\n")),
            "TOOL CALL 1 Z DR+0.5\nL X0.5 B45 R0 FMAX M128\nCYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X1\n");
  for (const std::string program :
       {"L X1 M3\n", "M8\n", "L X1\nM30\nL X2\n", "L X1 FU0.5\n", "L X1 FQ1\n", "L B91\n", "L IB1\n",
        "PLANE RESET STAY\n", "CYCL DEF 9.0 X\n", "STOP\n", "BEGIN PGM A INCH\nL X1\n", "L X1.123456\n",
        "TOOL DEF 1 L0\n", "L A5\n", "/L X1\n"})
    EXPECT_TRUE(statements(program).empty()) << program;
}

TEST(KitKlartext, CasesShareToolsButToolsOfACaseStayApart) {
  kit::ToolTable table(5);
  const auto tool = [](std::uint32_t number, const std::string& name, std::int64_t radius) {
    spec::ToolRow row;
    row.number = number;
    row.name = name;
    row.r = spec::decimal(radius);
    return row;
  };
  kit::Statements one = statements("TOOL CALL 1\nTOOL CALL \"B\"\nTOOL CALL 7\nTOOL CALL 1\nTOOL CALL 0\n");
  ASSERT_TRUE(table.take({tool(10, "A", 4), tool(20, "B", 4)}, one));
  EXPECT_EQ(text(one), "TOOL CALL 5\nTOOL CALL 6\nTOOL CALL 32767\nTOOL CALL 5\nTOOL CALL 0\n");
  kit::Statements two = statements("TOOL CALL 3\n");
  ASSERT_TRUE(table.take({tool(30, "", 4)}, two));
  EXPECT_EQ(text(two), "TOOL CALL 5\n");
  EXPECT_EQ(table.rows().size(), 2U);
}

TEST(KitParameters, NothingThatDescribesOrProtectsTheMachineIsChanged) {
  // Every known parameter is on the list, or has a reason not to be.
  std::size_t may_change = 0;
  for (const spec::ParameterInfo& parameter : spec::parameters())
    if (kit::why_left_alone(parameter.id).empty()) ++may_change;
  EXPECT_EQ(may_change, 22U);
  for (std::uint32_t number = 19610; number <= 19623; ++number)
    EXPECT_FALSE(kit::why_left_alone({number, -1}).empty()) << number;
  for (std::uint32_t number = 19680; number <= 19714; ++number)
    for (int bit = -1; bit < 8; ++bit) EXPECT_FALSE(kit::why_left_alone({number, bit}).empty()) << number;
  EXPECT_FALSE(kit::why_left_alone({3401, 0}).empty());
  EXPECT_FALSE(kit::why_left_alone({19741, -1}).empty());
  EXPECT_TRUE(kit::why_left_alone({5003, 0}).empty());

  // A default is as good as a value written out; 19680 is the machine's.
  const spec::Setup a = machine("[parameters]\n\"5003#0\" = 0\n19680 = 0\n").setup;
  const spec::Setup b = machine("[parameters]\n19680 = 2\n5010 = \"1.0\"\n\"5003#1\" = 1\n").setup;
  EXPECT_EQ(kit::to_string(kit::overlay_for(a, b)), "5003#1 = 1, 5010 = 1.0");
  EXPECT_TRUE(kit::overlay_for(a, a).empty());
}

// By hand: from (0, 0) a half circle about (40, 0) reaches Y 40 below or above, X no further than 80.
TEST(KitTravels, ArcsCountWithAllTheyPass) {
  kit::Machine m = machine("[workpiece.G54]\nY = 10\n");
  spec::Case c;
  c.setup = m.setup;
  c.program = "G17 G90 G03 X80. Y0 I40. J0 F100\n";
  const auto below = kit::extents(m, toolcomp::judge::run_model(c).events);
  EXPECT_NEAR(below.at('Y').least, -30, 0.001);
  EXPECT_NEAR(below.at('X').greatest, 80, 0.001);
  EXPECT_EQ(kit::outside_travels(m, toolcomp::judge::run_model(c).events), "");
  c.program = "G17 G90 G02 X80. Y0 I40. J0 F100\n";
  EXPECT_NEAR(kit::extents(m, toolcomp::judge::run_model(c).events).at('Y').greatest, 50, 0.001);
  m.travels.at('Y').greatest = spec::decimal(49);
  EXPECT_EQ(kit::outside_travels(m, toolcomp::judge::run_model(c).events), "Y goes to 50, above 49");
}

kit::Kit two_alarms() {
  kit::Kit made;
  kit::KitProgram program;
  program.number = 8501;
  program.alarm = "PS0041";
  program.alarm_n = 1003;
  made.programs.push_back(program);
  program.number = 8502;
  program.alarm = "TYPE_C_FORMAT";
  made.programs.push_back(program);
  return made;
}

TEST(KitAlarmForm, WhatIsNotedIsJudged) {
  const kit::Kit made = two_alarms();
  const std::string form = kit::write_alarm_form(made);
  EXPECT_EQ(form, "program,alarm,block,note\nO8501,,,\nO8502,,,\n");
  for (const kit::NotedAlarm& noted : kit::read_alarm_form(form, "f", made))
    EXPECT_EQ(kit::judge_alarm(made.programs[0], noted), kit::AlarmVerdict::not_noted);
  const auto verdict = [&made](std::size_t program, const std::string& row) {
    const auto noted = kit::read_alarm_form(
        "program,alarm,block,note\r\nO" + std::to_string(8501 + program) + "," + row + "\r\n", "f", made);
    return kit::judge_alarm(made.programs[program], noted.at(0));
  };
  EXPECT_EQ(verdict(0, "41,,"), kit::AlarmVerdict::as_expected);
  EXPECT_EQ(verdict(0, " ps0041 , N1003 ,as it, came"), kit::AlarmVerdict::as_expected);
  EXPECT_EQ(verdict(0, "PS41,1004,"), kit::AlarmVerdict::other_alarm);
  EXPECT_EQ(verdict(0, "PS0014,,"), kit::AlarmVerdict::other_alarm);
  EXPECT_EQ(verdict(0, "none,,"), kit::AlarmVerdict::none_came);
  // A name of ours: any alarm will do, but one.
  EXPECT_EQ(verdict(1, "PS5409,,"), kit::AlarmVerdict::as_expected);
  EXPECT_EQ(verdict(1, "NONE,,"), kit::AlarmVerdict::none_came);
}

TEST(KitAlarmForm, AnythingElseIsRefusedWithItsPlace) {
  const auto refused = [](const std::string& form) {
    try {
      static_cast<void>(kit::read_alarm_form(form, "f", two_alarms()));
    } catch (const spec::InputError& error) {
      return std::to_string(error.line()) + ":" + std::to_string(error.column());
    }
    return std::string("read");
  };
  const std::string header = "program,alarm,block,note\n";
  EXPECT_EQ(refused(""), "1:1");
  EXPECT_EQ(refused(header), "read");
  EXPECT_EQ(refused(header + "\nO8501,1,,\n"), "read");
  EXPECT_EQ(refused(header + "O8501,1,\n"), "2:9");
  EXPECT_EQ(refused(header + "O8503,1,,\n"), "2:1");
  EXPECT_EQ(refused(header + "O8501,1,,\nO8501,1,,\n"), "3:1");
  EXPECT_EQ(refused(header + "O8501, a.b,,\n"), "2:8");
  EXPECT_EQ(refused(header + "O8501,1,x,\n"), "2:9");
}

// 20 ms apart: 1.2 s at X0, a step in 0.1 s, 1 s at X1, away for good.
TEST(KitRecording, RestsAreWhereTheAxesStand) {
  std::string csv = "X,time,Y\n";
  double time = 0;
  const auto sample = [&](double x) {
    csv += std::to_string(x) + "," + std::to_string(time) + ",3\n";
    time += 0.02;
  };
  for (int i = 0; i <= 60; ++i) sample(5 + 0.001 * (i % 2));
  for (int i = 1; i < 5; ++i) sample(5 + 0.2 * i);
  for (int i = 0; i <= 50; ++i) sample(6);
  for (int i = 1; i < 90; ++i) sample(6 + i);
  std::istringstream in(csv);
  const kit::Machine m = machine("[position]\nX = 5\nY = 3\n");
  certify::Recording reader(in, "f", m.setup.axes, m.setup.units);
  const certify::RecordedRun recording = certify::rest_of(reader);
  ASSERT_TRUE(recording.has_time);
  const auto found = kit::find_rests(recording, kit::mark_place(m, false, 0.01));
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].end - found[0].begin, 1.2, 0.001);
  EXPECT_TRUE(found[0].at_place);
  EXPECT_FALSE(found[0].above);
  EXPECT_NEAR(found[1].end - found[1].begin, 1, 0.001);
  EXPECT_TRUE(found[1].above);
  // Samples keep their lines.
  certify::SampleRange part(recording, 61, 63);
  certify::RecordedSample taken;
  for (const std::uint64_t line : {63U, 64U}) {
    ASSERT_TRUE(part.next(taken));
    EXPECT_EQ(taken.line, line);
  }
  EXPECT_FALSE(part.next(taken));
}

}  // namespace

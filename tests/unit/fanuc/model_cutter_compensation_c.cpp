// The worked examples of cutter compensation C in the sheet, run through the engine: 14.5 and 14.6.2 to 14.6.9. Numbers
// are the sheet's; where a comment says so, derived here.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/unit/fanuc/model_cutter_run.h"

namespace {

using namespace toolcomp;
using test::alarm;
using test::cutter_setup;
using test::expect_points;
using test::heads_at;
using test::Point;
using test::Points;
using test::points_from;
using test::run;

// 14.5

constexpr const char* kFigure =
    "G92 X0 Y0\nN1 G90 G17 G00 G41 D07 X250 Y550\nN2 G01 Y900 F150\nN3 X450\nN4 G03 X500 Y1150 R650\n"
    "N5 G02 X900 R-250\nN6 G03 X950 Y900 R650\nN7 G01 X1150\nN8 Y550\nN9 X700 Y650\nN10 X250 Y550\nN11 G00 G40 X0 Y0\n";

std::string figure_setup(const std::string& offset) {
  return "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\"]\n[offsets.D]\n7 = \"" + offset + "\"\n";
}

TEST(ModelCutterC, FigureWithOffset10) {
  expect_points({{240, 550},
                 {240, 910},
                 {443.295878967653, 910},
                 {489.9915665097066, 1146.714456444996},
                 {910.0084334902934, 1146.714456444996},
                 {956.704121032347, 910},
                 {1160, 910},
                 {1160, 540},
                 {1157.592566023653, 538.0688248199739},
                 {700, 639.756061714119},
                 {252.1693045781866, 540.2381293981605},
                 {0, 0}},
                points_from(run(figure_setup("10"), kFigure)), "d = 10");
}

TEST(ModelCutterC, FigureWithOffset20) {
  expect_points({{230, 550},
                 {230, 920},
                 {436.5151319446072, 920},
                 {479.9666946292995, 1143.522063767303},
                 {920.0333053707005, 1143.522063767303},
                 {963.4848680553928, 920},
                 {1170, 920},
                 {1170, 530},
                 {1165.185132047306, 526.1376496399478},
                 {700, 629.512123428238},
                 {254.3386091563731, 530.4762587963209},
                 {0, 0}},
                points_from(run(figure_setup("20"), kFigure)), "d = 20");
}

TEST(ModelCutterC, FigureWithNegativeOffset) {
  const Points expected{{260, 550},
                        {260, 890},
                        {456.6666666666667, 890},
                        {459.2307692307692, 896.1538461538462},
                        {510, 1150},
                        {510, 1153.333333333333},
                        {508, 1156},
                        {892, 1156},
                        {890, 1153.333333333333},
                        {890, 1150},
                        {940.7692307692308, 896.1538461538462},
                        {943.3333333333333, 890},
                        {1140, 890},
                        {1140, 562.4661605081032},
                        {700, 660.243938285881},
                        {247.8306954218134, 559.7618706018395},
                        {0, 0}};
  expect_points(expected, points_from(run(figure_setup("-10"), kFigure)), "d = -10");
  // G42 with 10 is G41 with -10; D00 cancels as G40 does.
  std::string other = kFigure;
  other.replace(other.find("G41"), 3, "G42");
  other.replace(other.find("G40"), 3, "D00");
  expect_points(expected, points_from(run(figure_setup("10"), other)), "G42, d = 10");
}

TEST(ModelCutterC, FigureArcs) {
  const auto figure = run(figure_setup("10"), kFigure);
  std::vector<double> sweeps;
  for (const model::Event& event : figure.events()) {
    if (event.type != spec::MoveType::arc) continue;
    EXPECT_FALSE(event.arc->radius);
    sweeps.push_back(test::value(*event.arc->sweep));
  }
  // atan2 differences of the printed heads about the centres (-150, 1150), (700, 1300), (1550, 1150).
  ASSERT_EQ(sweeps.size(), 3U);
  EXPECT_NEAR(sweeps[0], 21.730174390198, 1e-10);
  EXPECT_NEAR(sweeps[0], sweeps[2], 1e-12);
  EXPECT_NEAR(sweeps[1], 252.251550563443, 1e-10);
}

// 14.6.2: A = (0,0) → (40,0) starts up with d = 10; B follows.

struct StartUp {
  const char* code;
  const char* b;
  Points type_a;
  Points type_b;
};

TEST(ModelCutterC, StartUpTable) {
  const std::vector<StartUp> rows{
      {"G41", "X40 Y30", {{30, 0}}, {{30, 0}}},
      {"G41", "X80 Y0", {{40, 10}}, {{40, 10}}},
      {"G41", "X40 Y-30", {{50, 0}}, {{40, 10}, {50, 10}}},
      {"G41", "X80 Y-30", {{46, 8}}, {{40, 10}, {43.33333333333333, 10}}},
      {"G42", "X10 Y40", {{48, 6}}, {{40, -10}, {50, -10}, {54, -2}}},
      {"G41", "G02 X60 Y-40 I-30 J-40", {{46, 8}}, {{40, 10}, {43.33333333333333, 10}, {46, 8}}},
      {"G41", "G02 X0 Y-20 I-40 J30", {{48, -6}}, {{40, 10}, {50, 10}, {54, 2}, {48, -6}}},
  };
  for (const StartUp& row : rows) {
    const std::string program = std::string("G01 ") + row.code + " D1 X40 F100\n" + row.b + "\n";
    expect_points(row.type_a, heads_at(run(cutter_setup(), program), {40, 0}), program + "type A");
    expect_points(row.type_b, heads_at(run(cutter_setup("\"5003#0\" = 1"), program), {40, 0}), program + "type B");
  }
}

TEST(ModelCutterC, StartUpUnderOneDegree) {
  const Points expected{{100.099995000375, -9.999500037496875}};
  for (const char* type : {"0", "1"})
    expect_points(
        expected,
        heads_at(run(cutter_setup(std::string("\"5003#0\" = ") + type), "G01 G41 D1 X100 F100\nX0 Y-1\n"), {100, 0}),
        type);
}

// 14.6.3: A = (0,0) → (40,0) in the offset mode; the start-up before it comes along X.

std::string from_left(const std::string& parameters = "") { return cutter_setup(parameters, "[position]\nX = -40\n"); }
std::string after_a(const std::string& program, const std::string& start = "G41 D1") {
  return "G01 " + start + " X0 F100\nX40\n" + program + "\n";
}

struct Corner {
  const char* b;
  Points heads;
};

TEST(ModelCutterC, OffsetModeTable) {
  const std::vector<Corner> rows{
      {"X64 Y32", {{35, 10}}},
      {"X40 Y30", {{30, 10}}},
      {"X70 Y30", {{35.85786437626905, 10}}},
      {"X40 Y-30", {{50, 10}}},
      {"X10 Y-40", {{50, 10}, {54, 2}}},
      {"X0 Y0", {{50, 10}, {50, -10}}},
      {"G03 X0 Y80 I-40 J30", {{34.64101615137755, 10}}},
      {"G02 X60 Y-40 I-30 J-40", {{43.33333333333333, 10}, {46, 8}}},
      {"G02 X0 Y-20 I-40 J30", {{50, 10}, {54, 2}, {48, -6}}},
      {"G42 X40 Y30", {{50, 10}}},
      {"G42 X0 Y0", {{40, 10}}},
      {"G42 X80 Y0", {{40, -10}}},
      {"G42 G03 X0 Y80 I-40 J30", {{56.5685424949238, 10}}},
      {"G42 G03 X70 Y30 J30", {{40, -10}}},
      {"G41 X40 Y30", {{40, 10}}},
      {"G41\nX40 Y30", {{40, 10}}},
      {"X80 D8", {{40, -10}}},
  };
  for (const Corner& row : rows) expect_points(row.heads, heads_at(run(from_left(), after_a(row.b)), {40, 0}), row.b);
  expect_points({{30, 17.5}}, heads_at(run(from_left(), after_a("G03 X0 Y80 I-40 J30", "G41 D6")), {40, 0}), "17.5");
}

TEST(ModelCutterC, CornersBehindArcs) {
  const auto setup = [](const char* x, const char* y) {
    return cutter_setup("", std::string("[position]\nX = ") + x + "\nY = " + y + "\n");
  };
  expect_points({{46, 8}, {43.33333333333333, 10}},
                heads_at(run(setup("60", "-80"), "G01 G42 D1 Y-40 F100\nG03 X40 Y0 I-50\nG01 X0\n"), {40, 0}),
                "arc-line obtuse");
  expect_points({{48, -6}, {54, 2}, {50, 10}},
                heads_at(run(setup("-40", "-20"), "G01 G42 D1 X0 F100\nG03 X40 Y0 J50\nG01 X0\n"), {40, 0}),
                "arc-line acute");
  expect_points(
      {{-2.8, 33.6}, {0, 34.41666666666667}, {2.8, 33.6}},
      heads_at(run(setup("24", "-31"), "G01 G41 D1 X0 Y-24 F100\nG02 Y24 I7 J24\nG02 X0 Y-24 I-7 J-24\n"), {0, 24}),
      "arc-arc obtuse");
}

TEST(ModelCutterC, BlocksWithoutMotionBetween) {
  expect_points({{30, 10}, {30, 40}, {80, 40}}, points_from(run(from_left(), after_a("M05\nX40 Y30\nX80")), 2), "one");
  // Derived: the last block ends square to itself.
  const auto two = points_from(run(from_left(), after_a("M05\nM08\nX40 Y30\nX80")), 2);
  expect_points({{40, 10}, {30, 40}, {80, 40}}, two, "two");
  // A travel of zero has its move and counts two.
  expect_points({{40, 10}, {40, 10}, {30, 40}, {80, 40}},
                points_from(run(from_left(), after_a("G91 X0\nG90 X40 Y30\nX80")), 2), "zero travel");
  // A line without words is no block; O alone is one.
  expect_points({{30, 10}, {30, 40}, {80, 40}}, points_from(run(from_left(), after_a("\nM05\n\nX40 Y30\nX80")), 2),
                "empty");
  expect_points({{40, 10}, {30, 40}, {80, 40}}, points_from(run(from_left(), after_a("O7\nM05\nX40 Y30\nX80")), 2),
                "N");
}

TEST(ModelCutterC, ValueChangedAtABlock) {
  const auto changed = run(from_left(), after_a("X40 Y-40 D2\nX0 Y-40"));
  expect_points({{50, 10}}, heads_at(changed, {40, 0}), "A/B with the old value");
  expect_points({{45, -45}}, heads_at(changed, {40, -40}), "B/C with the new value");
}

TEST(ModelCutterC, SmallCornerMovements) {
  const Points both{{50, 10}, {51.78217821782178, 7.821782178217822}};
  expect_points({{50, 10}}, heads_at(run(from_left("5010 = \"2.2\""), after_a("X20 Y-99")), {40, 0}), "limit 2.2");
  expect_points(both, heads_at(run(from_left("5010 = 2"), after_a("X20 Y-99")), {40, 0}), "limit 2");

  const std::string circle = "G91 G01 G41 D1 X15 Y20 F100\nX15 Y20\nG02 J-60\n";
  for (const char* limit : {"0", "5"}) {
    const auto with_circle = run(cutter_setup(std::string("5010 = ") + limit), circle);
    expect_points({{25, 50}, {30, 50}, {30, 50}}, heads_at(with_circle, {30, 40}), limit);
    const model::Event& tool = with_circle.events().back();
    EXPECT_EQ(tool.arc->sweep->decimal(15), "360");
    EXPECT_FALSE(tool.arc->radius);
  }
}

TEST(ModelCutterC, FullCircleCancelledAlongADirection) {
  const std::string program = "G01 G41 D1 X100 F100\nG02 J-60\nG01 G40 X0 Y-200 I-10 J-10\n";
  const std::string start = "[position]\nX = 60\n";
  const auto unchecked = run(cutter_setup("\"5008#0\" = 1", start), program);
  expect_points({{100, 10}, {120.937502231726, 6.795366607995099}, {0, -200}}, points_from(unchecked), "CNI = 1");
  EXPECT_NEAR(test::value(*unchecked.events()[1].arc->sweep), 17.4039858696496, 1e-12);
  const auto checked = run(cutter_setup("", start), program);
  EXPECT_EQ(alarm(checked), "2 PS0041");
  expect_points({{100, 10}}, points_from(checked), "up to the circle");
}

TEST(ModelCutterC, ArcWhoseEndIsOffTheArc) {
  const auto spiral = run(from_left(), after_a("G02 X95 Y-50 J-50"));
  const model::Event& tool = spiral.events().back();
  expect_points({{105, -50}}, heads_at(spiral, {95, -50}), "end normal");
  EXPECT_EQ(tool.arc->radius->first.decimal(15), "60");
  EXPECT_EQ(tool.arc->radius->second.decimal(15), "65");
  EXPECT_EQ(tool.arc->sweep->decimal(15), "90");
}

// 14.6.4

struct Cancel {
  const char* b;
  Points type_a;
  Points type_b;
};

TEST(ModelCutterC, CancelTable) {
  const std::vector<Cancel> rows{
      {"X40 Y30", {{40, 10}}, {{40, 10}}},
      {"X40 Y-30", {{40, 10}}, {{50, 10}, {50, 0}}},
      {"X80 Y-30", {{40, 10}}, {{43.33333333333333, 10}, {46, 8}}},
      {"X10 Y-40", {{40, 10}}, {{50, 10}, {54, 2}, {48, -6}}},
      {"X70 Y-30", {{40, 10}}, {{44.14213562373095, 10}, {47.07106781186548, 7.071067811865475}}},
  };
  for (const Cancel& row : rows) {
    const std::string program = after_a(std::string("G40 ") + row.b);
    const auto type_a = run(from_left(), program);
    expect_points(row.type_a, heads_at(type_a, {40, 0}), program + "type A");
    EXPECT_EQ(type_a.events().back().cause, spec::Cause::cancel);
    expect_points(row.type_b, heads_at(run(from_left("\"5003#0\" = 1"), program), {40, 0}), program + "type B");
  }
}

TEST(ModelCutterC, CancelUnderOneDegree) {
  for (const char* type : {"0", "1"}) {
    const std::string setup = cutter_setup(std::string("\"5003#0\" = ") + type, "[position]\nX = -40\n");
    expect_points({{100, 10}}, heads_at(run(setup, "G01 G41 D1 X0 F100\nX100\nG40 X0 Y-1\n"), {100, 0}), type);
  }
}

TEST(ModelCutterC, CancelBehindArcs) {
  const auto with = [](const char* type, const char* x, const char* y, const std::string& program) {
    return heads_at(run(cutter_setup(std::string("\"5003#0\" = ") + type,
                                     std::string("[position]\nX = ") + x + "\nY = " + y + "\n"),
                        program),
                    {40, 0});
  };
  const std::string obtuse = "G01 G42 D1 Y-40 F100\nG03 X40 Y0 I-50\nG01 G40 X0\n";
  expect_points({{46, 8}}, with("0", "60", "-80", obtuse), "obtuse A");
  expect_points({{46, 8}, {43.33333333333333, 10}, {40, 10}}, with("1", "60", "-80", obtuse), "obtuse B");
  const std::string acute = "G01 G42 D1 X0 F100\nG03 X40 Y0 J50\nG01 G40 X0\n";
  expect_points({{48, -6}}, with("0", "-40", "-20", acute), "acute A");
  expect_points({{48, -6}, {54, 2}, {50, 10}, {40, 10}}, with("1", "-40", "-20", acute), "acute B");
  const std::string inner = "G01 G42 D1 X0 F100\nG02 X40 Y0 J-50\nG01 G40 X0\n";
  for (const char* type : {"0", "1"}) expect_points({{32, 6}}, with(type, "-40", "80", inner), "inner");
}

TEST(ModelCutterC, CancelWithoutMotion) {
  const std::string program = after_a("G40\nX40 Y-30");
  expect_points({{40, 10}, {40, -30}}, points_from(run(from_left(), program), 2), "SUV = 0");
  // SUV = 1 removes the vector at once.
  const auto at_once = run(from_left("\"5003#1\" = 1"), program);
  expect_points({{40, 10}, {40, 0}, {40, -30}}, points_from(at_once, 2), "SUV = 1");
  EXPECT_EQ(at_once.events()[2].cause, spec::Cause::cancel);
  EXPECT_EQ(at_once.events()[3].cause, spec::Cause::programmed);
}

// 14.6.5: blocks through these points, G41.

TEST(ModelCutterC, Interference) {
  const auto through = [](const std::string& blocks) { return run(from_left(), after_a(blocks)); };
  const auto groove = through("Y15\nX0");
  EXPECT_EQ(alarm(groove), "3 PS0041");
  expect_points({{30, 10}}, heads_at(groove, {40, 0}), "the block before runs");
  const auto width20 = through("Y20\nX0");
  EXPECT_EQ(alarm(width20), "");
  expect_points({{30, 10}}, heads_at(width20, {40, 20}), "width 20");
  expect_points({{30, 15}}, heads_at(through("Y25\nX0"), {40, 25}), "width 25");
  const auto step = through("Y5\nX80");
  expect_points({{30, 10}}, heads_at(step, {40, 0}), "step");
  expect_points({{30, 15}}, heads_at(step, {40, 5}), "step");
  EXPECT_EQ(alarm(through("X37 Y-4\nX80")), "3 PS0041");
  const auto free = through("X25 Y-20\nX80");
  expect_points({{50, 10}, {54, 2}}, heads_at(free, {40, 0}), "free");
  expect_points({{45, -10}}, heads_at(free, {25, -20}), "free");
  EXPECT_EQ(alarm(through("G03 X48 Y8 J8\nG01 Y40")), "3 PS0041");
  const auto in_center = through("G03 X50 Y10 J10\nG01 Y40");
  EXPECT_EQ(alarm(in_center), "");
  expect_points({{40, 10}}, heads_at(in_center, {50, 10}), "the tool stays in the centre");
}

TEST(ModelCutterC, InterferenceRemoved) {
  // G41, R' = -5: the first two pairs go, the tool runs straight from (50,10) to (60,10).
  const auto removed = run(from_left(), after_a("G03 X50 Y0 I5\nG01 Y-20"));
  EXPECT_EQ(test::lines(removed, test::Show::point),
            (test::Lines{"1 linear X0 Y10 Z0 (start-up)", "2 linear X50 Y10 Z0", "3 linear X60 Y10 Z0",
                         "4 linear X60 Y-20 Z0"}));
}

// 14.6.6

TEST(ModelCutterC, BlocksOutsideThePlaneBehindTheStartUp) {
  const std::string start = "N1 G91 G00 G41 X500 Y400 D1\n";
  expect_points({{490, 400}, {490, 400}, {490, 500}},
                points_from(run(cutter_setup(), start + "N3 G01 Z-300 F1\nN6 Y100\n")), "one Z block");
  expect_points({{493.7530495244558, 407.8086880944303}},
                {points_from(run(cutter_setup(), start + "N3 Z-250\nN5 G01 Z-50 F1\nN6 Y100\n")).front()}, "two");
  expect_points({{490, 400}, {490, 500}, {490, 500}, {490, 500}, {490, 600}},
                points_from(run(cutter_setup(), start + "N2 Y100\nN3 Z-250\nN5 G01 Z-50 F1\nN6 Y100\n")), "remedy");
}

// 14.6.8: A = (0,0) → (40,0), then G53 or G28; work zero and machine zero are one.

TEST(ModelCutterC, MachineCoordinates) {
  const auto at = [](const char* parameters, const std::string& n4) {
    return heads_at(run(from_left(parameters), after_a("G53 X200 Y100\nX80 Y60\n" + n4)), {80, 60});
  };
  const auto first = run(from_left(), after_a("G53 X200 Y100\nX80 Y60\nX0"));
  expect_points({{40, 10}}, heads_at(first, {40, 0}), "P1 before G53");
  expect_points({{200, 100}}, heads_at(first, {200, 100}), "vector 0");
  constexpr const char* kTypeB = "\"5003#0\" = 1";
  constexpr const char* kGoesOn = "\"5003#2\" = 1";
  expect_points({{80, 50}}, at("", "X0"), "type A");
  expect_points({{83.16227766016838, 50.51316701949486}, {81.62277660168379, 50}}, at(kTypeB, "X0"), "type B");
  expect_points({{81.62277660168379, 50}}, at(kGoesOn, "X0"), "CCN = 1");
  expect_points({{90, 60}}, at("", "Y0"), "inner");
  expect_points({{90, 52.79240779943874}}, at(kGoesOn, "Y0"), "inner, CCN = 1");
  expect_points({{70, 60}}, at("", "Y160"), "acute, type A");
  const Points acute{{83.16227766016838, 50.51316701949486}, {73.67544467966324, 47.35088935932648}, {70, 50}};
  expect_points(acute, at(kTypeB, "Y160"), "acute, type B");
  expect_points({acute[1], acute[2]}, at(kGoesOn, "Y160"), "acute, CCN = 1");
}

TEST(ModelCutterC, ReferenceReturn) {
  const std::string program = after_a("G28 X40 Y60");
  const auto goes_on = run(from_left("\"5003#2\" = 1"), program);
  expect_points({{30, 10}, {30, 60}, {0, 0}}, points_from(goes_on, 2), "CCN = 1");
  expect_points({{40, 10}, {40, 60}, {0, 0}}, points_from(run(from_left(), program), 2), "CCN = 0");
  expect_points({{43.33333333333333, 10}, {106, -37}, {0, 0}},
                points_from(run(from_left("\"5003#2\" = 1"), after_a("G28 X100 Y-45")), 2), "outer");
}

// 14.6.9

TEST(ModelCutterC, CornerArc) {
  const auto first = run(cutter_setup(), "G91 G01 G42 D2 Y10 F100\nG39\nX-10\n");
  expect_points({{5, 10}, {0, 15}, {-10, 15}}, points_from(first), "without letters");
  EXPECT_EQ(first.events()[1].arc->direction, spec::ArcDirection::ccw);
  EXPECT_EQ(first.events()[1].arc->sweep->decimal(15), "90");
  EXPECT_EQ(first.events()[1].cause, spec::Cause::corner);
  EXPECT_EQ(first.events()[1].line, 2U);
  expect_points({{5, 10}, {4.472135954999579, 12.23606797749979}},
                heads_at(run(cutter_setup(), "G91 G01 G42 D2 Y10 F100\nG39 I-1 J2\nX-10 Y20\n"), {0, 10}), "I J");
  const auto clockwise = run(from_left(), after_a("G39\nX80 Y-30"));
  expect_points({{40, 10}, {46, 8}}, heads_at(clockwise, {40, 0}), "clockwise");
  EXPECT_EQ(clockwise.events()[2].arc->direction, spec::ArcDirection::cw);
  expect_points({{40, 10}, {48, 6}}, heads_at(run(from_left(), after_a("G39 I3 J-4\nX70 Y-40")), {40, 0}), "I J");
  const auto inner = run(from_left(), after_a("G39\nX40 Y30", "G41 D2"));
  expect_points({{40, 5}, {35, 0}}, heads_at(inner, {40, 0}), "inner");
  EXPECT_EQ(inner.events()[2].arc->sweep->decimal(15), "270");
  expect_points({{40, 10}}, heads_at(run(from_left(), after_a("G39\nX80")), {40, 0}), "straight on: no move");
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// Tool side compensation: the vectors written by hand hold the figures of the worked examples TS1 to TS11 under both
// engines, typed in from the derivation. Heads that those do not name (at the ends of the first and the last block, and
// in the rules) are worked out by hand: the value times the unit normal, or the construction named in the vector's
// comment.
#include "tests/golden/rows.h"

namespace toolcomp::corpus {
namespace {

using rows::Rows;

const std::string kSection = "fanuc/tool-side-compensation";

// Where B is a rounded angle only so many decimals of the figures hold.
constexpr std::size_t kDecimalsByB = 12;
bool is_number(const std::string& token) { return token.find_first_not_of("-.0123456789") == std::string::npos; }
Rows to_fewer_decimals(const Rows& expected) {
  Rows result;
  for (const std::string& row : expected) {
    std::string text;
    std::size_t place = 0;
    for (std::string token : rows::tokens(row)) {
      if (place++ > 2 && is_number(token)) {
        if (token.find('.') == std::string::npos) token += '.';
        token.resize(token.find('.') + 1 + kDecimalsByB, '0');
      }
      text += (text.empty() ? "" : " ") + token;
    }
    result.push_back(text);
  }
  return result;
}

void expect(const std::string& name, const std::vector<worked::Example>& table) {
  worked::expect(kSection, name, table, [](const auto& events, const Rows& rows, const spec::Case& c) {
    const bool by_b = c.comment.find("but for the last digits of B") != std::string::npos;
    EXPECT_EQ(rows::shown(events, by_b ? to_fewer_decimals(rows) : rows, c.setup.axes), rows);
  });
}

// The G43.5 block in front: its own move at the start of the program, and every line one further.
Rows under_tip_control(const std::string& start, const Rows& rest) {
  Rows result{"1 p G0 " + start};
  for (const std::string& row : rest) {
    const std::size_t space = row.find(' ');
    result.push_back(std::to_string(std::stoi(row.substr(0, space)) + 1) + row.substr(space));
  }
  return result;
}

const std::string kBeforeX = "-40 0 0";
const std::string kBeforeY = "0 -40 0";

TEST(ToolSideVectors, WorkedExamples) {
  const Rows ts1_left = {"1 s G1 0 5 0", "2 p G1 95 5 0", "3 p G1 95 100 0", "4 e G1 100 150 0"};
  const Rows ts1_right = {"1 s G1 0 -5 0", "2 p G1 105 -5 0", "3 p G1 105 100 0", "4 e G1 100 150 0"};
  const Rows ts2_left = {"1 s G1 -8 0 6", "2 p G1 -8 110 6", "3 p G1 100 110 0", "4 e G1 150 100 0"};
  const Rows ts2_right = {"1 s G1 8 0 -6", "2 p G1 8 90 -6", "3 p G1 100 90 0", "4 e G1 150 100 0"};
  const Rows ts3_left = {"1 s G1 -8 0 6", "2 p G1 -8 110 6", "3 c G1 -1.6 114 1.2", "3 p G1 98.8 48 -11.6",
                         "4 e G1 188 -20 -16"};
  const Rows ts3_right = {"1 s G1 8 0 -6", "2 p G1 8 80 -6", "3 p G1 89.2 32 -4.4", "4 e G1 188 -20 -16"};
  const Rows ts6 = {"1 s G1 0 5 0",    "2 p G1 45 5 0",    "3 p G1 45 5 0",
                    "4 p G1 46 105 3", "5 p G1 150 105 0", "6 e G1 200 100 0"};
  const Rows ts7_b = {"1 s G1 -8 100 6", "1 c G1 -8 110 6", "2 c G1 -1.6 114 1.2", "2 p G1 98.8 48 -11.6"};
  const auto y = [](const Rows& rest) { return under_tip_control(kBeforeY, rest); };
  const auto x = [](const Rows& rest) { return under_tip_control(kBeforeX, rest); };
  const auto from_zero = [](const Rows& rest) { return under_tip_control("0 0 0", rest); };

  const Rows figure = {"1 p G0 0 40 40", "2 s G1 10 0 0"};
  const auto with = [&](Rows rest) {
    rest.insert(rest.begin(), figure.begin(), figure.end());
    return rest;
  };
  const Rows overcut = with({"3 PS0041"});
  const std::string v1 = "G1 10 -206.946583704589973 -207.193398003386511";
  const std::string v2 = "G1 -10 -206.946583704589973 -207.193398003386511";
  const Rows end = {"5 p G1 10 -400 0", "6 e G1 0 -440 40"};
  const auto to_end = [&](Rows rest) {
    rest.insert(rest.end(), end.begin(), end.end());
    return with(rest);
  };
  const Rows q1 = to_end({"3 p G1 10 -200 -200", "4 p G1 10 -200 -200"});
  const Rows both = to_end({"3 p " + v1, "4 c " + v2, "4 p " + v2});
  const Rows both_rational = to_end({"3 p G1 10 -206 -208", "4 c G1 -10 -206 -208", "4 p G1 -10 -206 -208"});

  const auto change = [](const Rows& rest) {
    Rows rows = rest;
    rows.insert(rows.begin(), "1 s G1 0 10 0");
    return rows;
  };
  const Rows reversal = change({"2 p G1 100 10 0", "3 p G1 0 10 0", "4 e G1 -40 0 0"});
  const Rows left = change({"2 p G1 110 10 0", "3 p G1 110 100 0", "4 e G1 100 140 0"});
  const Rows right = change({"2 p G1 90 10 0", "3 p G1 90 -100 0", "4 e G1 100 -140 0"});
  const Rows straight = change({"2 p G1 100 -10 0", "3 p G1 200 -10 0", "4 e G1 240 0 0"});
  const Rows kept = change({"2 p G1 110 10 0", "3 c G1 110 -10 0", "3 p G1 0 -10 0", "4 e G1 -40 0 0"});
  const Rows acute_arc =
      change({"2 p G1 110 10 0", "3 c G1 114 2 0", "3 c G1 108 -6 0", "3 p G2 24 -18 0 O 60 30", "4 e G1 -10 20 0"});

  expect("examples",
         {{"TS1: ", ts1_left},
          {"TS1 with G42.2", ts1_right},
          {"TS1 by I J K, G41.6", x(ts1_left)},
          {"TS1 by I J K, G42.6", x(ts1_right)},
          {"TS2 by I J K: ", y(ts2_left)},
          {"TS2 by I J K, G42.6", y(ts2_right)},
          {"TS2 by B, G41.2", ts2_left},
          {"TS2 by B, G42.2", ts2_right},
          {"TS3 by I J K: ", y(ts3_left)},
          {"TS3 by I J K, G42.6", y(ts3_right)},
          {"TS3 by B, G41.2", ts3_left},
          {"TS3 by B, G42.2", ts3_right},
          {"TS6 by I J K", x(ts6)},
          {"TS6 by B", ts6},
          {"TS7 start (a), type A", from_zero({"1 s G1 0 110 0", "2 p G1 100 110 0"})},
          {"TS7 start (a), type B", from_zero({"1 s G1 -8 100 6", "1 c G1 -8 110 6", "2 p G1 100 110 0"})},
          {"TS7 start (a), type C", from_zero({"1 p G1 0 100 0", "2 s G1 0 110 0", "3 p G1 100 110 0"})},
          {"TS7 start (b), type A", from_zero({"1 s G1 4.8 108 -3.6", "2 p G1 98.8 48 -11.6"})},
          {"TS7 start (b), type B", from_zero(ts7_b)},
          {"TS7 start (b), type C", from_zero({"1 p G1 0 100 0", "2 s G1 4.8 108 -3.6", "3 p G1 98.8 48 -11.6"})},
          {"TS7 start (a) with G42.6, type A", from_zero({"1 s G1 0 90 0", "2 p G1 100 90 0"})},
          {"TS7 start (a) with G42.6, type B", from_zero({"1 s G1 0 90 0", "2 p G1 100 90 0"})},
          {"TS7 cancel, type A", y({"1 s G1 -8 0 6", "2 p G1 -8 100 6", "3 e G1 100 100 0"})},
          {"TS7 cancel, type B", y({"1 s G1 -8 0 6", "2 p G1 -8 110 6", "3 c G1 0 110 0", "3 e G1 100 100 0"})},
          {"TS7 cancel, type C", from_zero({"1 s G1 -8 0 6", "2 p G1 -8 100 6", "3 e G1 0 100 0"})},
          {"TS7 by B", ts7_b},
          {"TS8, the manual's", overcut},
          {"TS8 with Q1", q1},
          {"TS8 with Q2", to_end({"3 p " + v1, "4 p " + v1})},
          {"TS8 with Q3", both},
          {"TS8 with G41.2 again", q1},
          {"TS8 with the tool turning", overcut},
          {"TS8 with 19605#5 = 1", both},
          {"TS8 with 6261 = 91,", overcut},
          {"TS8 with 6261 = 91.001", both},
          {"TS9: ", overcut},
          {"TS9 with Q1", q1},
          {"TS9 with Q2", to_end({"3 p G1 10 -206 -208", "4 p G1 10 -206 -208"})},
          {"TS9 with Q3", both_rational},
          {"TS9 with G41.6 again", q1},
          {"TS9 with 19605#5 = 1", both_rational},
          {"TS9c", x({"1 s G1 0 10 0", "2 p G1 57.639320225002103 10 0", "3 p G1 57.639320225002103 10 0",
                      "4 p G1 -2.873478855663454 44.253042288673092 -7.662610281769211", "5 e G1 -100 100 0"})},
          {"TS10, G41.2 to G42.2, reversal", reversal},
          {"TS10, G41.2 to G42.2, left turn", left},
          {"TS10, G41.2 to G42.2, right turn", right},
          {"TS10, G41.2 to G42.2, straight on", straight},
          {"TS10, reversal with G41.2 kept", kept},
          {"TS10 by I J K, G41.6 to G42.6, reversal", x(reversal)},
          {"TS10 by I J K, G41.6 to G42.6, left turn", x(left)},
          {"TS10 by I J K, G41.6 to G42.6, right turn", x(right)},
          {"TS10 by I J K, G41.6 to G42.6, straight on", x(straight)},
          {"TS10 by I J K, reversal with G41.6 kept", x(kept)},
          {"TS10 by I J K, the points of TS3",
           y({"1 s G1 -8 0 6", "2 p G1 -8 95 6", "3 p G1 89.2 32 -4.4", "4 e G1 188 -20 -16"})},
          {"TS11, clockwise arc about (60,30)", acute_arc},
          {"TS11, clockwise arc about (60,-30)",
           change({"2 p G1 105 10 0", "3 c G1 108 6 0", "3 p G2 96 -78 0 O 60 -30", "4 e G1 50 -100 0"})},
          {"TS11, clockwise arc about (140,-30)",
           change({"2 p G1 95.278640450004206 10 0", "3 p G2 176 18 0 O 140 -30", "4 e G1 210 -20 0"})},
          {"TS11, counter-clockwise arc",
           change({"2 p G1 94.641016151377546 10 0", "3 p G3 84 62 0 O 60 30", "4 e G1 50 100 0"})},
          {"TS11 under G43.5", x(acute_arc)},
          // By a computation of 50 digits from V . VT = 0 and the two lines; the first digits are those of the comment.
          {"Whether a block moves is",
           {"1 p G0 0 0 0", "2 p G0 -50 0 0", "3 s G1 0 0 -5", "4 p G1 55 0 -5", "5 p G1 55 0 45",
            "6 p G1 46.516308380364824 83.483691619635176 46.018638148988371",
            "7 p G1 100 84.341215710622296 47.519305308215831"}},
          {"No. 19630 is compared at",
           {"1 p G0 0 0 0", "2 p G0 -34.151 -80 -4", "3 s G1 -36.37782547090378 -52.632776944334234 -3.998176032184187",
            "4 p G1 -12.96582547090378 -30.632776944334234 26.446823967815813",
            "5 p G1 60 -30.666718951023702 24.182634082097225"}}});
}

// The corner move up to the stop point runs with the feed of the block before, the one behind it with that of the next.
TEST(ToolSideVectors, FeedAtACorner) {
  const spec::Case& ts3 = worked::vector_of(kSection, "examples", "TS3 by B, G41.2");
  const char* const feeds[] = {"1000", "700", "500", "500", "500"};
  ASSERT_EQ(ts3.expect.size(), std::size(feeds));
  for (std::size_t i = 0; i < std::size(feeds); ++i) {
    ASSERT_TRUE(ts3.expect[i].feed.has_value());
    EXPECT_EQ(ts3.expect[i].feed->v, feeds[i]);
  }
}

TEST(ToolSideVectors, Rules) {
  const auto left = [](Rows rest) {
    rest.insert(rest.begin(), "1 s G1 0 10 0");
    return rest;
  };
  const auto right = [](Rows rest) {
    rest.insert(rest.begin(), "1 s G1 0 -10 0");
    return rest;
  };
  // Line 2 ends with the perpendicular, line 3 is the alarm.
  const auto refused = [&](const std::string& alarm) { return left({"2 p G1 100 10 0", "3 " + alarm}); };
  const auto vector = [](const Rows& rest) { return under_tip_control(kBeforeX, rest); };
  const auto tilted = [](const Rows& rest) { return under_tip_control(kBeforeY, rest); };
  const std::string forbidden = "FORBIDDEN_IN_3D_COMPENSATION";
  const std::string arc = "G2 0 -30 0 O 0 30";
  const Rows below_a_degree = {"1 s G1 100.099995000374969 -9.999500037496875 0",
                               "2 p G1 0.099995000374969 -10.999500037496875 0"};
  const Rows reversal = left({"2 p G1 110 10 0", "3 p G1 0 -10 0", "4 e G1 -40 0 0"});
  expect("rules",
         {{"G41.6 without G43.5", {"1 TOOL_SIDE_MODE"}},
          {"G42.2 under G43.5", vector({"1 TOOL_SIDE_MODE"})},
          {"G18 in the mode", refused("PS0037")},
          {"G19 in the block that cancels", refused("PS0037")},
          {"G54 in the mode", refused(forbidden)},
          {"M08 with an axis word", refused(forbidden)},
          {"G04 in the block that cancels", refused(forbidden)},
          {"G41 in the mode", refused(forbidden)},
          {"G41.3 in the mode", refused(forbidden)},
          {"A rotary word under G43.5", vector(refused("PS5460"))},
          {"Q4 in the mode", refused("Q_FORMAT")},

          {"An outer corner of 135", left({"2 p G1 104.14213562373095 10 0",
                                           "3 p G1 157.071067811865475 -42.928932188134525 0", "4 e G1 200 -100 0"})},
          {"G19 with VT X",
           {"1 s G1 0 0 10", "2 p G1 0 110 10", "3 c G1 0 114 2", "3 c G1 0 108 -6", "3 p G2 0 24 -18 O 60 30",
            "4 e G1 0 -10 20"}},
          {"G18 with VT Y",
           {"1 s G1 10 0 0", "2 p G1 10 0 110", "3 c G1 2 0 114", "3 c G1 -6 0 108", "3 p G2 -18 0 24 O 30 60",
            "4 e G1 20 0 -10"}},
          {"VT against Z", right({"2 p G1 110 -10 0", "3 c G1 114 -2 0", "3 c G1 108 6 0", "3 p G3 24 18 0 O 60 -30",
                                  "4 e G1 -10 -20 0"})},
          {"VT in the plane of the arc", {"1 s G1 0 0 10", "2 p G1 0 50 10", "3 fanuc.tool-side.arc-plane"}},
          {"VT (3/5, 0, 4/5) and an arc of G17", tilted({"1 s G1 -8 0 6", "2 p G1 -8 100 6", "3 ARC_PLANE_MISMATCH",
                                                         "3 p G2 50 160 0 O 50 100 r 58 60 w 90", "4 e G1 100 150 0"})},
          {"A helix", left({"2 p G1 110 10 0", "3 c G1 114 2 0", "3 c G1 108 -6 0", "3 p G2 24 -18 20 O 60 30",
                            "4 e G1 -10 20 20"})},
          {"An arc that ends at", refused("PS0038")},
          {"An arc on the inside, smaller", refused("PS0041")},
          {"The value changes where the arc", refused("PS0041")},
          {"Offset circles of radius 2", left({"2 PS0033"})},

          {"A movement along the tool",
           tilted({"1 s G1 -8 0 6", "2 p G1 -8 110 6", "3 p G1 22 110 46", "4 p G1 130 110 40", "5 e G1 150 100 40"})},
          // Beside X10 Y0 to X80 Y1, of length sqrt 4901: (1 + sqrt 4901) / 70 and 150 - sqrt 4901.
          {"19630 = 0.5: line 6, after",
           {"1 p G0 0 0 0", "2 s G0 9 0 0", "3 p G0 9 2 0", "4 c G0 11 2 0", "4 p G0 11 1.014387749896408 0",
            "5 p G0 79.99285750725145 2 0", "6 p G0 90 2 0"}},
          {"19630 = 0.5, a block of 0.4",
           right({"2 p G1 110 -10 0", "3 p G1 110.4 -10 0", "4 p G1 110.4 100 0", "5 e G1 100.4 150 0"})},
          {"19630 = 0.5, a block of exactly",
           right({"2 p G1 100 -10 0", "3 p G1 110.5 -10 0", "4 p G1 110.5 100 0", "5 e G1 100.5 150 0"})},
          {"19630 = 0.5 is compared",
           right({"2 p G1 110 -10 0", "3 p G1 110.4 -10 30", "4 p G1 110.4 100 30", "5 e G1 100.4 150 30"})},
          {"Two blocks without movement", right({"2 p G1 100 -10 0", "5 p G1 110 100 0", "6 e G1 100 150 0"})},
          {"M00 stops", right({"2 p G1 100 -10 0", "4 p G1 110 100 0", "5 e G1 100 150 0"})},
          {"Two rotations in a row", vector(right({"2 p G1 100 -10 0", "3 p G1 100 -10 0", "4 p G1 100 -10 0",
                                                   "5 p G1 200 -8 6", "6 e G1 250 0 0"}))},
          {"A block across the tool at",
           vector(left({"2 p G1 100 10 0", "3 p G1 130 10 40", "4 p G1 122 100 46", "5 e G1 130 150 40"}))},
          {"A block along the previous tool",
           vector(left({"2 p G1 90 10 0", "3 p G1 92 -10 56", "4 p G1 92 100 56", "5 e G1 100 150 50"}))},
          {"A block that only turns", vector(left({"2 p G1 100 10 0", "3 p G1 100 10 0", "4 p G1 92 -10 56",
                                                   "5 p G1 92 100 56", "6 e G1 100 150 50"}))},
          {"A block that is skipped by the", vector(left({"2 p G1 110 10 0", "3 PS0041"}))},
          {"19630 = 6 in the plane",
           vector(left({"2 p G1 90 10 0", "3 p G1 90 10 9.999", "4 p G1 92 100 15.999", "5 e G1 100 150 9.999"}))},
          {"19630 = 6 and exactly",
           vector(left({"2 p G1 90 10 0", "3 p G1 92 -10 16", "4 p G1 92 100 16", "5 e G1 100 150 10"}))},
          {"No block follows at", left({"2 p G1 100 10 0"})},

          {"Types A and B: G41.2 without movement", {"2 s G1 0 10 0", "3 p G1 100 10 0", "4 e G1 150 0 0"}},
          {"The start-up block turns the tool", tilted({"1 s G1 -8 0 6", "2 p G1 -8 100 6", "3 e G1 0 150 0"})},
          {"Type B, obtuse before an arc",
           {"1 s G1 40 10 0", "1 c G1 43.333333333333333 10 0", "2 c G1 46 8 0", "2 p G2 70 -40 0 O 10 -40"}},
          {"Type B, acute before an arc",
           {"1 s G1 40 10 0", "1 c G1 50 10 0", "2 c G1 54 2 0", "2 c G1 48 -6 0", "2 p " + arc}},
          {"Type A before an arc", {"1 s G1 48 -6 0", "2 p " + arc}},
          {"Type B below 1 degree", below_a_degree},
          {"type_b_without_perpendicular, obtuse", {"1 s G1 110 10 0", "2 p G1 110 -110 0", "3 e G1 0 -100 0"}},
          {"type_b_without_perpendicular, acute", {"1 s G1 50 10 0", "2 c G1 54 2 0", "2 c G1 48 -6 0", "2 p " + arc}},
          {"An arc as start-up block", {"1 PS0034"}},
          {"The side changes in the block after", left({"2 DIR_CHANGE_AT_STARTUP"})},
          {"The side changes after the start-up", vector(left({"2 DIR_CHANGE_AT_STARTUP"}))},
          {"The side changes in the block with which the start-up",
           vector(left({"2 p G1 0 -10 50", "3 DIR_CHANGE_AT_STARTUP"}))},
          {"Start-up block and cancel", left({"2 e G1 0 -100 0"})},
          {"Type C before an arc", {"1 p G1 40 0 0", "2 s G1 48 -6 0", "3 p " + arc, "5 e G1 0 -20 0"}},
          {"Type C with an axis word in the G41.2", {"1 TYPE_C_FORMAT"}},
          {"Type C with a rotary word", {"1 TYPE_C_FORMAT"}},
          {"Type C under G02", {"2 TYPE_C_FORMAT"}},
          {"Type C, the next block", {"1 TYPE_C_FORMAT"}},
          {"Type C with an axis word in the G40", refused("TYPE_C_FORMAT")},

          {"Type B, obtuse after an arc",
           {"1 s G1 70 -40 0", "2 p G3 46 8 0 O 10 -40", "2 c G1 43.333333333333333 10 0", "3 c G1 40 10 0",
            "3 e G1 0 0 0"}},
          {"Type B, acute after an arc",
           {"1 s G1 0 -30 0", "2 p G3 48 -6 0 O 0 30", "2 c G1 54 2 0", "3 c G1 50 10 0", "3 c G1 40 10 0",
            "3 e G1 0 0 0"}},
          {"Type B, acute cancel of two lines",
           left({"2 p G1 50 10 0", "3 c G1 54 2 0", "3 c G1 48 -6 0", "3 e G1 10 -40 0"})},
          {"Type B, inner cancel", left({"2 p G1 100 10 0", "3 e G1 100 50 0"})},
          {"An arc as cancel block", refused("PS0034")},
          {"G40 without movement", right({"2 p G1 100 -10 0", "4 e G1 100 50 0"})},
          {"G40 with a movement along the tool", right({"2 p G1 100 -10 0", "3 p G1 100 -10 30", "4 e G1 100 50 30"})},
          {"G40 with a movement along the previous",
           vector(left({"2 p G1 100 10 0", "3 e G1 100 0 50", "4 p G1 0 0 50"}))},
          {"Type B, G40 with a movement",
           vector(left({"2 p G1 110 10 0", "3 c G1 110 0 0", "3 p G1 110 -30 40", "4 e G1 200 -30 40"}))},
          {"D0 cancels", left({"2 p G1 100 10 0", "3 e G1 100 100 0", "4 p G1 0 100 0"})},

          {"G41.2 again: ", left({"2 p G1 100 10 0", "3 p G1 90 100 0", "4 e G1 100 150 0"})},
          {"G41.2 again, in a block", left({"2 p G1 100 10 0", "4 p G1 90 100 0", "5 e G1 100 150 0"})},
          {"Another D takes", left({"2 p G1 96 4 0", "3 p G1 96 100 0", "4 e G1 100 150 0"})},
          {"A negative value", {"1 s G1 0 -5 0", "2 p G1 105 -5 0", "3 p G1 105 100 0", "4 e G1 100 150 0"}},
          {"An offset number whose", {"1 s G1 0 0 0", "2 p G1 100 0 0", "3 p G1 100 100 0", "4 e G1 100 150 0"}},
          {"The side changes at an arc",
           left({"2 p G2 38.729833462074169 -40 0 O 0 -30", "3 p G1 100 -40 0", "4 e G1 150 -30 0"})},
          {"5010 = 20,", reversal},
          {"5010 = 21,", reversal},
          {"5010 = 19.999", left({"2 p G1 110 10 0", "3 c G1 110 -10 0", "3 p G1 0 -10 0", "4 e G1 -40 0 0"})},
          {"Q1 at a change of side", left({"2 p G1 100 10 0", "3 p G1 110 100 0", "4 e G1 100 150 0"})},
          {"The same code again with a value", left({"2 p G1 110 10 0", "3 p G1 105 100 0", "4 e G1 100 150 0"})},
          {"Q1 before the same code again", left({"2 p G1 100 10 0", "3 p G1 105 100 0", "4 e G1 100 150 0"})},
          {"Q1 at a corner of one orientation", left({"2 p G1 100 10 0", "3 p G1 90 100 0", "4 e G1 100 150 0"})},
          {"Q2 at an acute corner", reversal},
          {"Q2 with one vector", left({"2 p G1 90 10 0", "3 p G1 90 100 0", "4 e G1 100 150 0"})},

          {"VT Z, then (-1, 0, 1) and a movement along it", vector(left({"2 PS0041"}))},
          {"VT Z, then (-1, 0, 1) and a further movement",
           vector(left({"2 p G1 100 10 0", "3 p G1 100 10 0", "4 p G1 150 10 0", "5 e G1 200 0 0"}))},
          {"VT Z, then (-1, 0, 1) and a movement in Y",
           vector(left({"2 p G1 90 10 0", "3 p G1 90 10 0", "4 p G1 92.928932188134525 50 -7.071067811865475",
                        "5 e G1 100 100 0"}))},
          {"A slot narrower", left({"2 p G1 90 10 0", "3 PS0041"})},
          {"The same with 5008#0 = 1", left({"2 p G1 90 10 0", "3 p G1 90 -5 0", "4 p G1 0 -5 0", "5 e G1 -40 5 0"})},

          {"G43 in the mode", left({"2 p G1 100 10 0", "3 p G1 200 10 0", "4 e G1 250 0 0"})}});
}

// The axes are the compensated point and the length along Z.
TEST(ToolSideVectors, LengthOffsetInTheMode) {
  const spec::Case& g43 = worked::vector_of(kSection, "rules", "G43 in the mode");
  ASSERT_EQ(g43.expect.size(), 4U);
  EXPECT_EQ(g43.expect[2].axes[0].v, "200");
  EXPECT_EQ(g43.expect[2].axes[1].v, "10");
  EXPECT_EQ(g43.expect[2].axes[2].v, "100");
}

}  // namespace
}  // namespace toolcomp::corpus

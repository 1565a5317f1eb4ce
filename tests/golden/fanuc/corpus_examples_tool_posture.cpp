// SPDX-License-Identifier: Apache-2.0
// Tool posture control: the vectors written by hand hold the figures of the worked examples 2 to 5, 7 to 9 and 11,
// typed in from a derivation in 50 digits; those of the rules are worked out by hand in the vectors' comments.
#include "tests/golden/fanuc/pose_rows.h"

namespace toolcomp::corpus {
namespace {

using worked::Rows;

const std::string kSection = "fanuc/tool-posture-control";

// The arc of example 3 at its ends and quarters, as lines of `line` with the letters of the axes.
Rows pyramid_edge(const std::string& line, char tool, const std::array<std::string, 5>& work,
                  const std::array<std::string, 5>& tilt) {
  const std::array<std::string, 5> direction = {"i=-0.408248290463863 j=0.408248290463863 k=0.816496580927726",
                                                "i=-0.437363799276446 j=0.208721190616481 k=0.874727598552893",
                                                "i=-0.447213595499958 j=0 k=0.894427190999916",
                                                "i=-0.437363799276446 j=-0.208721190616481 k=0.874727598552893",
                                                "i=-0.408248290463863 j=-0.408248290463863 k=0.816496580927726"};
  const std::array<std::string, 5> at = {"", "t=1/4", "t=1/2", "t=3/4", "programmed"};
  Rows rows;
  for (std::size_t i = 1; i < at.size(); ++i)
    rows.push_back(line + ' ' + at.at(i) + " C=" + work.at(i) + ' ' + tool + '=' + tilt.at(i) + ' ' + direction.at(i));
  return rows;
}

const std::array<std::string, 5> kOrthogonal = {"35.2643896827547", "28.9872466142404", "26.565051177078",
                                                "28.9872466142404", "35.2643896827547"};

// From upright at the zero pose to the edge, then along it.
Rows from_upright(char tool, const std::string& turn, const std::array<std::string, 5>& work) {
  const std::string t = std::string(1, tool) + '=';
  Rows rows = {"1 programmed",
               "2 pre-turn C=" + turn + " k=1",
               "2 t=1/4 " + t + "8.81609742068866 i=-0.108373643161723 j=0.108373643161723 k=0.988185360615968",
               "2 t=1/2 i=-0.214186495298066 j=0.214186495298066 k=0.953020613871423",
               "2 t=3/4 i=-0.314938275028657 j=0.314938275028657 k=0.895336677369998",
               "2 programmed C=" + turn + ' ' + t + "35.2643896827547"};
  for (const std::string& row : pyramid_edge("3", tool, work, kOrthogonal)) rows.push_back(row);
  return rows;
}

TEST(ToolPostureVectors, WorkedExamples) {
  const std::string edge_start = "1 programmed X=-20.8248290463863 Y=20.8248290463863 Z=81.6496580927726";
  Rows head = pyramid_edge("2", 'B', {"135", "154.488330009362", "180", "205.511669990638", "225"}, kOrthogonal);
  head[0] += " X=-23.7363799276446 Y=10.8721190616481 Z=87.4727598552893";
  head[1] += " X=-24.7213595499958 Y=0 Z=89.4427190999916";
  head[2] += " X=-23.7363799276446 Y=-10.8721190616481 Z=87.4727598552893";
  head[3] += " X=-20.8248290463863 Y=-20.8248290463863 Z=81.6496580927726";
  head.insert(head.begin(), edge_start + " C=135 B=35.2643896827547");
  Rows nutating =
      pyramid_edge("2", 'B', {"", "139.507322177772", "166.345415254024", "190.530662159048", "206.467819046821"},
                   {"", "41.4567926002351", "37.921419763845", "41.4567926002351", "50.7287005490466"});
  nutating.insert(nutating.begin(), edge_start + " C=116.467819046821 B=50.7287005490466");
  const std::string tip_n40 = " x=24.4721359549996 y=-20 z=2.23606797749979";
  const std::string tip_n50 = " x=23.7267799624996 y=23.7267799624996 z=3.72677996249965";
  const std::string tip_n60 = " x=-23.7267799624996 y=23.7267799624996 z=3.72677996249965";
  const std::string tip_n70 = " x=-23.7267799624996 y=-23.7267799624996 z=3.72677996249965";
  const std::string table_35 = " A=-35.2643896827547";
  const std::string tool_35 = " B=-35.2643896827547";

  const std::vector<worked::Example> table = {
      {"2 with P1: C-B head",
       {"1 programmed C=0 B=30 i=0.5 k=0.866025403784439",
        "2 t=1/2 C=85 B=2.88065908640527 i=0.004380082175591 j=0.050064568357393 k=0.9987363785681 ~",
        "2 programmed C=170 B=30 X=50 Y=0 Z=0 ~"}},
      {"2 with P1: B tool",
       // The table carries X50 round by 85 and 170.
       {"1 programmed B=30 C=0", "2 t=1/2 B=2.88065908640527 C=85 X=2.17889356869146 Y=-24.9048674522936 ~",
        "2 programmed B=30 C=170 X=-49.2403876506104 Y=-8.68240888334652 ~"}},
      {"3: the edge of the pyramid", head},
      {"3: the same arc on an A-C table",
       from_upright('A', "225", {"225", "244.488330009362", "270", "295.511669990638", "315"})},
      {"3: the same arc with B tool",
       from_upright('B', "135", {"135", "154.488330009362", "180", "205.511669990638", "225"})},
      {"3: the same arc with a nutating B", nutating},
      {"4: type 1, C 0 B 20",
       {"1 programmed C=0 B=20",
        "2 t=1/4 i=0.268133688322374 j=0.176528861603656 k=0.947070159073528 C=33.3593629436283 B=18.7250240410852",
        "2 t=1/2 i=0.184413141980199 j=0.346583337389474 k=0.919712880908474 C=61.9830533459686 B=23.1158568832211 "
        "X=27.6619712970299 Y=51.9875006084212 Z=137.956932136271",
        "2 t=3/4 i=0.0939290453595435 j=0.503926496601286 k=0.858624143884272 C=79.441555265135 B=30.8375489371282",
        "2 programmed C=90 B=40"}},
      {"4 with P0",
       {"1 programmed", "2 t=1/4 C=22.5 B=25", "2 t=1/2 X=53.0330085889911 Y=53.0330085889911 Z=129.903810567666",
        "2 t=3/4 C=67.5 B=35", "2 programmed C=90 B=40"}},
      {"4: type 1, C 0 to 200",
       {"1 programmed", "2 posture-branch", "2 t=1/4 C=50 B=20", "2 t=1/2 C=100 B=20", "2 t=3/4 C=150 B=20",
        "2 programmed C=200 B=20"}},
      {"5: near the singular posture",
       {"1 programmed C=0 B=10", "2 t=1/10 C=0.627160532895321 B=7.80345595842618 ~", "2 t=1/5",
        "2 t=3/10 C=4.27970316883873 B=3.41845337728643 ~", "2 t=2/5 C=15.6447476915161 B=1.25849039506375 ~",
        "2 t=1/2 C=156.749981593727 B=1.07228252285797 ~", "2 t=3/5 C=170.951321299778 B=3.2223902158916 ~", "2 t=7/10",
        "2 t=4/5", "2 t=9/10", "2 programmed C=176 B=12 ~"}},
      {"5 with NPC = 1", {"1 programmed", "2 PS5421"}},
      {"5 with 19739 = 5",
       {"1 programmed C=0 B=10",
        "2 t=1/4 B=4.5 C=0 i=0.0784590957278449 j=0 k=0.996917333733128 X=18.7767276582276 Z=79.7533866986502 ~",
        "2 t=1/2 B=-1 C=0 i=-0.0174524064372835 k=0.999847695156391 X=23.6038074850173 Z=79.9878156125113 ~",
        "2 t=3/4 B=-6.5 C=0 X=28.4437428985675 Z=79.485748454127 ~",
        "2 programmed B=-12 C=0 X=33.3670647345793 Z=78.2518080587045 i=-0.207911690817759 k=0.978147600733806 ~",
        "3 t=1/4", "3 t=1/2 C=14.1611368115305 B=-20.7582829496743 ~", "3 t=3/4", "3 programmed C=20 B=-30 ~"}},
      {"5 on an A-C table",
       {"1 programmed", "2 t=1/4 A=2.5 ~", "2 t=1/2 A=5 ~", "2 t=3/4", "2 programmed A=10 C=0 ~", "3 t=1/4 A=4.5 C=0 ~",
        "3 t=1/2 A=-1 i=0 j=0.0174524064372835 k=0.999847695156391 ~", "3 t=3/4 A=-6.5 ~", "3 programmed A=-12 C=0 ~"}},
      {"5 around -Z", {"1 programmed C=0 B=172", "2 programmed C=0 B=190 ~"}},
      // atan of 1/5; of sqrt 1.01/5, mirrored or not, at 174.289... = 180 - 5.710...
      {"7: from (1,0,5)",
       {"1 programmed", "2 programmed C=0 B=11.309932474020213", "3 programmed C=0 B=-11.3648769670337"}},
      {"7: the same with 19739 = 5",
       {"1 programmed", "2 programmed C=0", "3 programmed C=174.28940686250036 j=0.019607843137255"}},
      {"7: the same with 19738 = 0.57", {"1 programmed", "2 programmed C=0", "3 programmed C=174.28940686250036"}},
      {"7: exactly through",
       {"1 programmed", "2 t=1/4", "2 t=1/2", "2 t=3/4", "2 programmed C=0 B=26.565051177078", "3 t=1/4 C=0",
        "3 t=1/2 C=0 B=-3.5625081744509", "3 t=3/4 C=0", "3 programmed C=0 B=-33.6900675259798"}},
      {"8: O0010 on a C-B head",
       {"1 programmed X=30 Y=-30 Z=0",
        "2 programmed X=30 Y=-30 Z=100 k=1",
        "4 pre-turn C=-45 B=0 k=1 x=30 y=-30",
        "4 t=1/4 B=-8.81609742068866 C=-45 i=-0.108373643161723 j=0.108373643161723 k=0.988185360615968",
        "4 t=1/2 i=-0.214186495298066 j=0.214186495298066 k=0.953020613871423",
        "4 t=3/4 i=-0.314938275028657 j=0.314938275028657 k=0.895336677369998",
        "4 start-up C=-45 X=-16.3526930913867 Y=20.8248290463863 Z=83.8857260702724" + tool_35 + tip_n40,
        "5 t=1/4",
        "5 t=1/2 C=0 B=-26.565051177078 x=24.0994579587496 y=1.86338998124982 z=2.98142396999972 i=-0.447213595499958 "
        "j=0 X=-20.6219015912462 Y=1.86338998124982 Z=92.4241430699913",
        "5 t=3/4",
        "5 programmed C=45 X=-17.0980490838867 Y=-17.0980490838867 Z=85.3764380552723" + tool_35 + tip_n50,
        "6 t=1/4",
        "6 t=1/2 C=90 B=-26.565051177078",
        "6 t=3/4",
        "6 programmed C=135 X=17.0980490838867 Y=-17.0980490838867 Z=85.3764380552723" + tool_35 + tip_n60,
        "7 t=1/4",
        "7 t=1/2 C=180 B=-26.565051177078",
        "7 t=3/4",
        "7 programmed C=225 X=17.0980490838867 Y=17.0980490838867 Z=85.3764380552723" + tool_35 + tip_n70,
        "8 t=1/4",
        "8 t=1/2 C=270 B=-26.565051177078",
        "8 t=3/4",
        "8 programmed C=315" + tool_35,
        "9 t=1/4",
        "9 t=1/2",
        "9 t=3/4",
        "9 cancel C=315 x=30 y=-30 z=0"}},
      {"8: O0010 on an A-C table",
       {"1 programmed", "2 programmed Z=100", "4 pre-turn C=45 A=0 k=1", "4 t=1/2",
        "4 start-up C=45" + table_35 + tip_n40, "5 t=1/2 C=90 A=-26.565051177078",
        "5 programmed C=135" + table_35 + tip_n50, "6 t=1/2", "6 programmed C=225" + table_35 + tip_n60, "7 t=1/2",
        "7 programmed C=315" + table_35 + tip_n70, "8 t=1/2", "8 programmed C=405" + table_35, "9 t=1/2",
        "9 cancel x=30 y=-30"}},
      {"8: O0010 with B tool",
       {"1 programmed", "2 programmed Z=100", "4 pre-turn C=-45 B=0 k=1", "4 t=1/2",
        "4 start-up C=-45" + tool_35 + tip_n40, "5 t=1/2 C=0 B=-26.565051177078",
        "5 programmed C=45" + tool_35 + tip_n50, "6 t=1/2", "6 programmed C=135" + tool_35 + tip_n60, "7 t=1/2",
        "7 programmed C=225" + tool_35 + tip_n70, "8 t=1/2", "8 programmed C=315" + tool_35, "9 t=1/2",
        "9 cancel x=30 y=-30"}},
      // Machine coordinates of the control point less the workpiece origin (5, 10, 20).
      {"9: A-C table with offsets",
       {"1 programmed X=30 Y=-30 Z=100", "2 pre-turn C=45", "2 t=1/4", "2 t=1/2", "2 t=3/4",
        "2 programmed C=45 X=-15.6066017177982 Y=-92.314902372249 Z=68.7639589068648" + table_35,
        "3 t=1/4 A=-28.9872466142404 C=64.488330009362 X=-21.3075542211557 Y=-72.950174050187 Z=82.31002896252",
        "3 t=1/2 A=-26.565051177078 C=90 X=-25 Y=-59.1934955049954 Z=89.56733089749",
        "3 t=3/4 C=115.511669990638 X=-24.7923489480995 Y=-57.8805445089336 Z=90.658876587179",
        "3 programmed C=135 X=-22.6776695296637 Y=-69.220891604664 Z=85.093890525419" + table_35}},
      {"11: opposite directions",
       {"1 programmed i=0.5 k=0.866025403784439", "2 t=1/4 C=45 B=60 i=0.612372435695795 j=0.612372435695795 k=0.5",
        "2 t=1/2 C=90 B=90 i=0 j=1 k=0", "2 t=3/4 C=135 B=120", "2 programmed C=180 B=150"}},
  };
  poses::expect(kSection, "examples", table);
}

TEST(ToolPostureVectors, Rules) {
  const std::string half = "0.707106781186548";
  const std::string tilt = "35.2643896827547";  // of -1 1 2
  // acos of 5/sqrt 75, azimuth of (1,-7); the other end of the arc lies 90 degrees on.
  const std::string slope = "54.7356103172453";
  const std::vector<worked::Example> table = {
      {"P2", {"1 PS5421"}},
      {"Without P, TPC = 1",
       {"1 programmed", "2 t=1/2 B=45", "2 programmed B=90 C=0", "3 t=1/2 i=" + half + " j=" + half + " k=0 C=45",
        "3 programmed C=90 B=90"}},
      {"Without P, TPC = 0",
       {"1 programmed", "2 t=1/2", "2 programmed C=0 B=26.565051177078", "3 t=1/2 C=45 B=26.565051177078",
        "3 programmed C=90 B=26.565051177078"}},
      {"The same direction again",
       {"1 programmed", "2 t=1/2", "2 programmed C=0 B=26.565051177078", "3 t=1/2 C=0 B=26.565051177078",
        "3 programmed C=0 B=26.565051177078"}},
      {"From upright to -1 1 2 with C", {"1 programmed C=-45 B=0", "2 programmed C=-45 B=-" + tilt}},
      {"From upright to -1 1 2: C turns",
       {"1 programmed", "2 pre-turn C=-45 B=0 k=1", "2 t=1/2 C=-45 B=-17.6321948413773",
        "2 programmed C=-45 B=-" + tilt}},
      {"From upright to 1 1 2",
       {"1 programmed X=5 Z=10", "2 pre-turn C=45 X=3.535533905932738 Y=3.535533905932738 Z=10 x=0 k=1", "2 t=1/2 C=45",
        "2 programmed C=45 B=" + tilt}},
      {"A tilt of 1e-19 from",
       {"1 programmed", "2 t=1/4 X=2.5 C=-1350", "2 t=1/2 X=5 C=-1350", "2 t=3/4 X=7.5 C=-1350",
        "2 programmed X=10 C=-1350"}},
      {"Type 2 to upright", {"1 programmed", "2 programmed B=0 C=0"}},
      {"Type 1 to upright at C 90",
       {"1 programmed", "2 t=1/2 B=15 C=0", "2 programmed B=0 C=0", "2 post-turn B=0 C=90 x=10"}},
      {"Type 1 to upright at C -90", {"1 programmed", "2 programmed B=0 C=0", "2 post-turn C=-90"}},
      {"Type 1 to upright at C 0", {"1 programmed", "2 programmed B=0 C=0"}},
      {"Type 1 to upright at B 360", {"1 programmed", "2 posture-branch", "2 programmed B=360 C=0"}},
      {"Type 1 from upright to B 200", {"1 programmed", "2 posture-branch", "2 programmed B=200 C=0"}},
      {"Type 1 from B 30", {"1 programmed", "2 posture-branch", "2 programmed B=-30 C=90"}},
      {"Type 1 across", {"1 programmed", "2 t=1/2 B=0 C=0 k=1", "2 programmed B=-30 C=0"}},
      {"A nutating B on its edge of reach, from Y",
       {"1 programmed B=180 C=0 j=1", "2 t=1/2 B=180 C=-45 i=" + half + " j=" + half, "2 programmed B=180 C=-90 i=1"}},
      // In the middle, by angles of an independent computation: (1 + cos B)/2 is cos 45, C as far as its azimuth
      // from 90.
      {"A nutating B from its edge of reach",
       {"1 programmed B=180 C=0 X=0 Y=100 Z=0",
        "2 t=1/2 B=294.4698005207022 C=-65.5301994792978 X=5 Y=70.7106781186548 Z=70.7106781186548",
        "2 programmed B=360 C=-90 X=10 Y=0 Z=100 k=1"}},
      {"A nutating B from -180", {"1 programmed B=-180", "2 programmed B=0 C=-90 X=10 Y=0 Z=100"}},
      {"A nutating B from 540", {"1 programmed B=540", "2 programmed B=720 C=-90"}},
      {"The same on a mixed machine, B",
       {"1 programmed B=180 X=0 Y=100 Z=0", "2 t=1/2 B=294.4698005207022 C=-65.5301994792978",
        "2 programmed B=360 C=-90 X=0 Y=10 Z=100"}},
      {"The same on a mixed machine from -180", {"1 programmed", "2 programmed B=0 C=-90"}},
      {"The same on a mixed machine from 540", {"1 programmed", "2 programmed B=720 C=-90"}},
      {"The same on a table. Its", {"1 programmed k=1", "2 programmed B=360 C=-90 X=0 Y=-10 Z=100 j=1"}},
      {"Type 1 from the edge of reach to B 360", {"1 programmed", "2 programmed B=360 C=-90"}},
      {"Type 1 from the edge of reach to B 0", {"1 programmed", "2 programmed B=0 C=90"}},
      {"WKP = 1: the table",
       {"1 programmed X=10", "2 pre-turn C=90 X=0 Y=-10 x=0 y=-10", "2 programmed X=0 Y=-10 B=30 x=0 y=-10"}},
      {"WKP = 1: C turns after",
       {"1 programmed B=30 C=90", "2 programmed X=0 Y=-10 B=0 C=90 x=0 y=-10", "2 post-turn X=10 Y=0 C=0 x=10 y=0"}},
      {"C and B with their",
       {"1 programmed B=3 C=-20 i=0.17364817766693", "2 programmed B=-19 C=-20 i=-0.207911690817759 ~"}},
      {"Tilted by RA 45, from (0,-1,1)",
       {"1 programmed B=0", "2 t=1/2 i=0.408248290463863 j=-0.816496580927726 k=0.408248290463863",
        "2 programmed B=90 C=0 i=" + half + " j=-" + half + " k=0"}},
      {"Tilted by RA 45, a great circle over the", {"1 programmed", "2 programmed", "3 PS5459"}},
      {"Tilted by RA 45, from (1,-7,5)", {"1 programmed", "2 programmed B=" + tilt, "3 programmed B=" + tilt}},
      {"Tilted by RA 45, from (1,-7,1)",
       {"1 programmed", "2 t=1/2", "2 programmed",
        "3 t=1/2 i=-0.588348405414552 j=-0.784464540552736 k=0.196116135138184", "3 programmed"}},
      {"Tilted by RA 45, from (1,-7,-5)",
       {"1 programmed", "2 programmed B=144.735610317245", "3 programmed B=144.735610317245"}},
      {"Tilted by RA 45, a great circle over -Z", {"1 programmed", "2 programmed", "3 PS5459"}},
      {"A great circle",
       {"1 programmed", "2 t=1/2", "2 programmed C=0 B=26.565051177078", "3 t=1/2 C=0 B=45",
        "3 programmed C=0 B=63.434948822922"}},
      {"Along the equator: Z",
       {"1 programmed", "2 t=1/2", "2 programmed B=90 C=0", "3 t=1/2 B=90 C=45", "3 programmed B=90 C=90"}},
      {"Along the equator with", {"1 programmed", "2 programmed B=90 C=0", "3 programmed B=90 C=90"}},
      {"From (1,-7,5) to (-7,-1,5)",
       {"1 programmed", "2 pre-turn C=-81.869897645844", "2 programmed B=" + slope,
        "3 programmed C=-171.869897645844 B=" + slope}},
      {"The same with 19738 = 45.001",
       {"1 programmed", "2 pre-turn", "2 programmed B=" + slope, "3 programmed C=-81.869897645844 B=-" + slope}},
      {"The same around -Z",
       {"1 programmed", "2 pre-turn", "2 programmed B=125.264389682755",
        "3 programmed C=-81.869897645844 B=234.735610317245"}},
      {"From (1,0,1) to (-1,1,1)",
       {"1 programmed", "2 t=1/3 B=15", "2 t=2/3 B=30", "2 programmed B=45 C=0",
        // 45 - (45 + 54.7356103172453) t
        "3 t=1/3 B=11.7547965609182 C=0", "3 t=2/3 B=-21.4904068781636 C=0", "3 programmed B=-" + slope + " C=0"}},
      {"The same with 19739 = 44.999", {"1 programmed", "2 programmed B=45", "3 PS5421"}},
      {"The same with 19739 = 45 and", {"1 programmed", "2 programmed B=45", "3 PS5421"}},
      {"The tool leans by",
       {"1 programmed", "2 pre-turn C=53.130102354156", "2 programmed B=1 C=53.130102354156",
        "3 programmed B=-90 C=53.130102354156 i=-0.6 j=-0.8 k=0", "4 programmed B=-90 x=0 y=0"}},
      // By hand: the centre is (-30, 0), the tangent at the end (24, -18, -20 / 4.0689 rad).
      {"The same helix twice",
       {"1 programmed C=63.434948822922", "2 t=1/2", "2 programmed C=51.168096837986 B=24.095369062470",
        "3 t=1/2 C=51.168096837986 B=24.095369062470", "3 programmed C=51.168096837986 B=24.095369062470"}},
      {"The same with NPC = 0", {"1 programmed", "2 programmed B=45", "3 programmed C=135 B=" + slope}},
      {"The same with a range", {"1 programmed", "2 programmed B=45", "3 PS5459"}},
      // acos of 1/sqrt 11, atan of 1/3
      {"Away from a start that is near",
       {"1 programmed", "2 t=1/2", "2 programmed B=45", "3 t=1/2",
        "3 programmed B=72.4515993862077 C=18.434948822922"}},
      {"Away from a start at 45",
       {"1 programmed", "2 programmed B=45", "3 programmed B=72.4515993862077 C=18.434948822922"}},
      {"Toward an end",
       {"1 programmed", "2 pre-turn C=18.434948822922", "2 programmed B=72.4515993862077", "3 programmed B=45 C=0"}},
      {"An arc of XY",
       {"1 programmed X=10", "2 t=1/2 C=45 B=90 x=7.071067811865475 y=2.928932188134525", "2 programmed C=90 j=1"}},
      {"G00 goes",
       {"1 programmed", "2 t=1/2 C=45 i=0.235702260395516 j=0.235702260395516 k=0.942809041582063",
        "2 programmed C=90"}},
  };
  poses::expect(kSection, "rules", table);
}

}  // namespace
}  // namespace toolcomp::corpus

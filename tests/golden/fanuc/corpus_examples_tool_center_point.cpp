// SPDX-License-Identifier: Apache-2.0
// Tool center point control: the vectors written by hand hold the figures of the worked examples 1, 2, 3 with P0, 9
// and 11, typed in from a derivation in 50 digits; those of the rules are worked out by hand in the vectors' comments.
#include "tests/golden/fanuc/pose_rows.h"

namespace toolcomp::corpus {
namespace {

using worked::Rows;

const std::string kSection = "fanuc/tool-center-point-control";

Rows to(const std::string& pose) { return {"1 programmed", "2 programmed " + pose}; }
Rows alarm_at(const std::string& line, const std::string& alarm) {
  Rows rows;
  for (int i = 1; std::to_string(i) != line; ++i) rows.push_back(std::to_string(i) + " programmed");
  rows.push_back(line + ' ' + alarm);
  return rows;
}

TEST(ToolCenterPointVectors, Inverse) {
  const std::vector<worked::Example> table = {
      {"1: C-B head, -1 1 2, pair 1", to("C=135 B=35.2643896827547 i=-0.408248290463863 k=0.816496580927726")},
      {"1: C-B head, -1 1 2, pair 2", to("C=315 B=324.735610317245")},
      {"1: C-A head, -1 1 2, pair 1", to("C=225 A=35.2643896827547")},
      {"1: C-A head, -1 1 2, pair 2", to("C=45 A=324.735610317245")},
      {"1: A-C table, 1 2 3, pair 1", to("A=36.6992252004899 C=153.434948822922")},
      {"1: A-C table, 1 2 3, pair 2", to("A=323.30077479951 C=333.434948822922")},
      {"1: B-C table, 1 2 3, pair 1", to("B=36.6992252004899 C=63.434948822922")},
      {"1: B-C table, 1 2 3, pair 2", to("B=323.30077479951 C=243.434948822922")},
      {"1: B tool, C table, 1 2 3, pair 1", to("B=36.6992252004899 C=63.434948822922")},
      {"1: B tool, C table, 1 2 3, pair 2", to("B=323.30077479951 C=243.434948822922")},
      {"1: A tool, C table, 1 2 3, pair 1", to("A=36.6992252004899 C=153.434948822922")},
      {"1: A tool, C table, 1 2 3, pair 2", to("A=323.30077479951 C=333.434948822922")},
      {"1: A-B head, 1 2 3, pair 1", to("A=146.30993247402 B=164.498640433063")},
      {"1: A-B head, 1 2 3, pair 2", to("A=326.30993247402 B=15.501359566937")},
      {"1: A-B table, 1 2 3, pair 1", to("A=327.688466762576 B=18.434948822922")},
      {"1: A-B table, 1 2 3, pair 2", to("A=212.311533237424 B=198.434948822922")},
      {"1: A tool, B table, 1 2 3, pair 1", to("A=327.688466762576 B=18.434948822922")},
      {"1: A tool, B table, 1 2 3, pair 2", to("A=212.311533237424 B=198.434948822922")},
      {"1: C-B head, B nutating, 1 1 1, pair 1", to("C=13.8260478038529 B=81.1005711201888")},
      {"1: C-B head, B nutating, 1 1 1, pair 2", to("C=256.173952196147 B=278.899428879811")},
      {"1: B-C table, B nutating, 1 2 3, pair 1", to("B=52.8741729167231 C=44.0642169567833")},
      {"1: B-C table, B nutating, 1 2 3, pair 2", to("B=307.125827083277 C=262.805680689061")},
      {"1: C-B head, B nutating, 1 0 0", to("C=270 B=180")},
      {"1: C-B head, B nutating, 0 0 -1", alarm_at("2", "PS5459")},
      {"1: C-B head, 0 0 1", to("B=0 C=30 k=1")},
      {"1: C-B head tilted by RA 5", alarm_at("2", "PS5459")},

      {"2: C-B head at (0,0), -1 1 2", to("C=-45 B=-35.2643896827547")},
      {"2: C-B head at (100,0)", to("C=135 B=35.2643896827547")},
      {"2: C-B head at (350,0)", to("C=315 B=-35.2643896827547")},
      {"2: C-B head at (45,0)", to("C=-45 B=-35.2643896827547")},
      {"2: C-B head at (0,0), 0 1 1", to("C=90 B=45")},
      {"2: A-C table at (0,0), -1 1 2", to("A=-35.2643896827547 C=45")},
      {"2: A-C table at (0,0) with A", alarm_at("2", "PS5459")},
      {"2: B tool at 30, C table at 0, to the direction of (30,170): B -30", to("B=-30 C=-10 ~")},
      {"2: B tool at 30, C table at 0, to the direction of (30,170) with PRI = 1", to("B=30 C=170 ~")},
      {"2: A-C table at (30,0), to the direction of (30,170): A 30",
       {"1 programmed", "2 programmed A=30 C=0 ~", "3 programmed A=30 C=170 ~"}},
      {"2: A-C table at (30,0), to the direction of (30,170) with PRI = 1",
       {"1 programmed", "2 programmed A=30 C=0 ~", "3 programmed A=-30 C=-10 ~"}},

      {"3 with P0",
       {"1 programmed X=-20.8248290463863 Y=20.8248290463863 Z=81.6496580927726 x=20 y=-20 z=0",
        "2 t=1/4 C=157.5 B=35.2643896827547 i=-0.533402096794177 j=0.220942382690395 k=0.816496580927726",
        "2 t=1/2 C=180 i=-0.577350269189626 j=0 k=0.816496580927726 X=-37.7350269189626 Y=0 Z=81.6496580927726",
        "2 t=3/4 C=202.5", "2 programmed C=225 B=35.2643896827547"}},
      // Machine coordinates, tip z + 100, less the workpiece origin.
      {"9: ",
       {"1 programmed A=20 C=45",
        "2 programmed A=-35 C=10 X=62.5977865158401 Y=-94.213831437203 Z=60.2516544957449 x=20 y=-20 z=5 "
        "i=0.328989928337166 j=0.72167761037298 k=0.609054228898422"}},
      {"11: Q2", to("i=0.034899496702501 j=0 k=0.999390827019096")},
      {"11: Q3, V along",
       to("C=131.157551336705 B=37.2248886695106 i=-0.398133605769323 j=0.45546477337505 k=0.796267211538646")},
      {"11: Q3 from", to("C=311.157551336705 B=322.775111330489")},
      {"11: C-B head", {"1 programmed X=-31.724539849193 Y=31.724539849193 Z=198.804418757713"}},
  };
  poses::expect(kSection, "examples", table);
}

TEST(ToolCenterPointVectors, Rules) {
  const std::string half = "0.707106781186548";
  const std::vector<worked::Example> table = {
      {"G43.4 without kinematics", {"1 PS5459"}},
      {"G43.5 without kinematics, length",
       {"1 programmed X=10 Z=0", "2 t=1/2 x=5 i=" + half + " k=" + half, "2 programmed X=10 Z=10",
        "3 t=1/2 X=15 Z=10 k=1", "3 programmed X=20 Z=-10 k=-1"}},
      {"G43.5 without kinematics, Q 90", {"1 programmed Z=10", "2 programmed X=20 Z=0 i=1"}},
      {"A hypothetical axis, G43.5", {"1 PS5459"}},
      {"A hypothetical axis, G43.4",
       {"1 programmed X=10", "2 t=1/2 C=45 X=7.071067811865475 Y=-7.071067811865475", "2 programmed X=0 Y=-10 C=90"}},
      {"A head with a tool-side axis", {"1 PS5459"}},
      {"G43 with a length of 10", alarm_at("2", "LENGTH_OFFSET_EXCLUSION")},
      {"G44 under", alarm_at("2", "LENGTH_OFFSET_EXCLUSION")},
      {"G43.5 again under",
       {"1 programmed X=10 Y=0", "2 programmed X=0 Y=-10 x=10 y=0", "3 programmed X=0 Y=-10 x=0 y=-10",
        "4 programmed A=-45 C=90 y=-10 z=5"}},
      {"G49: ", {"1 programmed X=10 Z=0", "3 programmed X=15 Z=0 x=15"}},
      {"G49 on a turned", {"1 programmed X=10 Z=10", "2 programmed X=0 Y=-10 Z=10", "4 programmed X=5 Y=-10 Z=10"}},
      {"G49 with a shift",
       {"1 programmed X=2", "2 programmed X=12 Z=10", "3 programmed X=0 Y=-12 Z=10 x=12",
        "5 programmed X=5 Y=-12 Z=10"}},
      {"G43.5 again with",
       {"1 programmed X=2", "2 programmed X=12 Z=10", "3 programmed X=0 Y=-12 x=12 y=0",
        "4 programmed X=0 Y=-12 x=0 y=-12", "5 programmed A=-45 C=90 x=0 y=-12 z=5"}},
      {"G28 under", alarm_at("2", "FORBIDDEN_UNDER_TOOL_DIRECTION")},
      {"G43.4 under G02", {"1 TOOL_DIRECTION_FORMAT"}},
      {"G49 in tool side", {"1 programmed", "2 start-up x=10 y=1", "3 TOOL_DIRECTION_FORMAT"}},
      {"WKP = 1 and G43.5", {"1 PS5459"}},
      {"WKP = 1, the table turns by 90",
       {"1 programmed X=10 Y=0", "2 t=1/2 X=0 Y=0 C=45", "2 programmed X=0 Y=10 x=0 y=10"}},
      {"WKP = 1, only the table turns",
       {"1 programmed X=0 Y=10", "2 t=1/2 x=7.071067811865475 y=7.071067811865475", "2 programmed X=10 Y=0 x=10 y=0",
        "3 t=1/2 y=2.5", "3 programmed X=10 Y=5"}},
      {"WKP = 1 and tool side compensation on a table", alarm_at("2", "COMPENSATION_IN_WORKPIECE_SYSTEM")},
      {"WKP = 1 and tool side compensation on a head",
       {"1 programmed", "2 start-up y=1", "3 programmed x=20 y=1", "4 cancel x=30 y=0"}},
      {"WKP = 1, an arc while A", alarm_at("2", "PS5421")},
      {"WKP = 1, an arc of XY", alarm_at("2", "ARC_WITH_TABLE_TURNED")},
      {"WKP = 1, an arc while the table does not", {"1 programmed", "2 programmed X=10 Y=10"}},
      {"Rotary axes alone",
       {"1 programmed X=0 Z=10", "2 t=1/2 x=0 X=7.071067811865475 Z=7.071067811865475", "2 programmed X=10 Z=0"}},
      {"H2 alone", {"1 programmed X=10", "2 t=1/2 X=10", "2 programmed X=10", "3 t=1/2 X=15", "3 programmed X=20"}},
      {"A head with 19711 =", {"1 programmed Z=50", "2 programmed X=51 Z=0 x=1"}},
      {"Tool side compensation under G43.4",
       {"1 programmed Z=10", "2 t=1/2 x=5 y=0.5 Z=10", "2 start-up x=10 y=1", "3 t=1/2 x=15 y=1 Z=10",
        "3 programmed x=20 y=1", "4 t=1/2 x=25 y=0.5", "4 cancel x=30 y=0"}},
      {"I0 J0 K0", alarm_at("2", "PS5421")},
      {"A rotary word under G43.5: ", alarm_at("2", "PS5421")},
      {"A rotary word under G43.5 with", {"1 programmed", "2 start-up", "3 PS5460"}},
      {"I J K in the block of G43.5 on a table", {"1 PS5421"}},
      {"I J K in the block of G43.5 on a head", {"1 programmed B=90 C=0 X=10 Z=0"}},
      {"Q while the tool", {"1 programmed", "2 programmed k=1 z=10"}},
      {"Q 30 leans",
       {"1 programmed", "2 programmed i=0.5 j=0 k=0.866025403784439", "3 programmed i=0 j=0.5 k=0.866025403784439"}},
      {"Q 90 in an arc", {"1 programmed", "2 programmed i=0 j=1 k=0"}},
      // From an independent computation.
      {"Q 30 in a helix", {"1 programmed", "2 programmed i=0.866025403784439 j=0.308833912419428 k=0.393219550047692"}},
      {"Q 30 in a clockwise",
       {"1 programmed", "2 programmed i=0.866025403784439 j=-0.460262629256498 k=0.195341526844384"}},
      {"B with its zero at 30, length",
       {"1 programmed B=0 X=5 Z=8.66025403784439 i=0.5 k=0.866025403784439", "2 programmed B=60 X=20 Z=0 i=1"}},
      {"The same with programmed angles",
       {"1 programmed B=0 X=0 Z=10 k=1", "2 programmed B=60 X=18.6602540378444 Z=5 i=0.866025403784439 k=0.5"}},
      {"After G55 B 30",
       {"1 programmed B=30 i=0.5", "2 programmed B=0 i=0.5", "4 programmed B=5 i=0.5 k=0.866025403784439",
        "5 programmed B=5 X=7 i=0.5", "6 programmed B=30 i=0.819152044288992 k=0.573576436351046"}},
      {"C with its zero at", {"1 programmed C=-55", "2 programmed C=-145 B=-35.264389682754654"}},
      {"B with its zero at 30 and", {"1 programmed B=0", "2 programmed B=-3.434948822922 i=0.447213595499958"}},
      {"Without I J K and Q", {"1 programmed", "2 programmed B=0 C=0"}},
      // The azimuth of t0 is -90, that of (3,4) 53.130102354155978...
      {"Tilted by RA 45, (3,4,5)", to("B=0 C=143.130102354156")},
      {"Tilted by RA 45, (1,0,10)", alarm_at("2", "PS5459")},
      {"Tilted by RA 45, (3,4,-5)", to("B=180 C=143.130102354156")},
      {"Tilted by RA 45, (0,1,-10)", alarm_at("2", "PS5459")},
      {"At C 45", to("C=-45 B=35.2643896827547")},
      {"Tilted by RB 20", to("C=90 B=25")},
      {"Tilted by RB -20", to("C=-90 B=-25")},
      {"From B 90 to the opposite", to("C=180 B=90")},
      {"B 90 exactly", to("B=90 C=0")},
      {"The range of C", to("B=45 C=36.869897645844")},
      {"The tool upright", to("B=0 C=10")},
      {"A lower limit", {"1 PS5459"}},
      {"An arc about (0,10)",
       {"1 programmed X=10", "2 t=1/2 x=7.071067811865475 y=2.928932188134525 i=" + half + " j=" + half,
        "2 programmed X=10 Y=20 j=1"}},
      {"An arc under G43.5 without R", alarm_at("2", "PS5421")},
      {"A rotary axis alone under G02", alarm_at("2", "PS5421")},
      {"I J K alone under G02", alarm_at("2", "PS5421")},
  };
  poses::expect(kSection, "rules", table);
}

}  // namespace
}  // namespace toolcomp::corpus

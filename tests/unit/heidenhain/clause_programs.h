// Klartext programs that together reach every outcome of every clause of the Heidenhain sections.
#pragma once

#include <string>
#include <vector>

namespace toolcomp::test {

struct ClauseProgram {
  std::string setup;  // without control
  std::string text;
};

inline std::vector<ClauseProgram> heidenhain_clause_programs() {
  const auto tool = [](const std::string& keys) { return "[[tool]]\nnumber = 1\n" + keys; };
  const std::string toroid = tool("R = 5\nR2 = 1\nL = 100\n") + "[[correction.tcs]]\nnumber = 1\nDR = \"-0.5\"\n";
  const std::string call = "TOOL CALL 1 Z\n";
  const std::string at = "LN X0 Y0 Z0 ";
  const std::string up = "NX0 NY0 NZ1 ";
  std::vector<ClauseProgram> list{
      // Reading
      {toroid, "NONSENSE\n"},
      {toroid, "M1 M2 M3 M4 M5\n"},
      {toroid, "LN Y1 X1 Z1 " + up + "\n"},
      {toroid, "LN X1 Y1 " + up + "\n"},
      {toroid, at + "NX0 NZ1\n"},
      {toroid, at + "NX10 NY0 NZ0\n"},
      {toroid, at + "NX0 NY0 NZ0\n"},
      // State
      {toroid, "BEGIN PGM A INCH\nQ1 = 5\nL X+Q1 Y+Q2\nL IX1.0000001\nM30\n"},
      {toroid, "CYCL DEF 7.1 X1\nCYCL DEF 7.1 IX1\nL X1 M91\nM128\nM91\n"},
      {toroid, call + "TOOL CALL S1\nFUNCTION CORRDATA TCS #1\nFUNCTION CORRDATA RESET\nFUNCTION CORRDATA TCS #1\n" +
                   call + "FUNCTION CORRDATA WPL #1\nM107\nM108\n"},
      {toroid, call + "TOOL CALL 1\n"},
      {toroid, "TOOL CALL 9\n"},
      {toroid, "M128\nTOOL CALL 1\n"},
      {toroid, call + "M128\nM129\nFUNCTION TCPM F TCP AXIS POS PATHCTRL AXIS REFPNT CNT-CNT\nL X1\nL B90\n"
                      "FUNCTION PROG PATH IS CONTOUR\nL X1 RL\nFUNCTION PROG PATH OFF\nFUNCTION RESET TCPM\n"},
      // Face milling
      {toroid, call + at + up + "TX0 TY0 TZ1\n" + at + up + "\n" + at + up + "M128\n" + at + up + "TX1 TY0 TZ0\n" + at +
                   "NX0 NY1 NZ1 TX0 TY0 TZ1\n" + at + "NX1 NY0 NZ0 TX0 TY0 TZ1\n" + at + "NX0 NY-1 NZ1 TX0 TY0 TZ1\n" +
                   at + "NX0 NY1 NZ1 TX0 TY0 TZ1\n" + at + "NX0.2 NY0.9 NZ-1 TX0 TY0 TZ1\n" + at +
                   "NX1 NY0 NZ-0.00001 TX0 TY0 TZ1\n"},
      {toroid, call + at + "NX0.5 NY0.5 NZ0.1 TX0.7 TY0.7 TZ0.1414 M128\n"},
      {toroid, call + at + up + "RL\n"},
      {toroid, at + up + "\n"},
      {toroid, call + "M107\nFUNCTION PROG PATH IS CONTOUR\n" + at + up + "\n"},
      // Peripheral milling
      {toroid, call + "FUNCTION PROG PATH IS CONTOUR\nM128\nL X0 RL\nL X10\nL Z1\nL Y10 RR\n" + at +
                   "TX0 TY0 TZ1 R0\nL X1 RR\n"},
      {toroid, call + "M128\nL X0 RL\nL X10\nL X0\n"},
      {toroid, call + "M128\nL Z1 RL\n"},
      {toroid, call + "L X1 RL\n" + at + "TX0 TY0 TZ1 R0\n"},
  };
  // 1² + 0.01² + 0.01² = 1.0002 exactly.
  list.push_back({toroid, call + at + "NX0.01 NY0.01 NZ1\n"});
  // The tool and its deltas
  const auto block = call + at + "NX0 NY0.6 NZ0.8 \n";
  for (const char* keys :
       {"R = -1\n", "R = 1\nR2 = -1\n", "R = 1\nR2 = 2\n", "R = 0\n", "R = 1\nDR = -2\n", "R = 1\nDR = -1\n",
        "R = 1\nR2 = \"0.5\"\nDR2 = -1\n", "R = 1\nDR = 1\n", "R = 2\nR2 = 1\nDR2 = \"0.5\"\n",
        "R = 1\nR2 = 1\nDR = \"-0.5\"\n", "R = 3\nR2 = 3\nDR = \"-0.1\"\nDR2 = \"-0.1\"\n",
        "R = 3\nR2 = 3\nDR2 = \"-0.1\"\n", "R = 3\nR2 = 1\nDR2 = \"-0.1\"\n", "R = 3\nR2 = 1\nDR = \"-0.1\"\n"}) {
    list.push_back({tool(keys), block});
    list.push_back({tool(keys), "M107\n" + block});
  }
  // A table of deviations
  const std::string table = "[[dr2table]]\nname = \"W\"\npoints = [[30, 0], [45, -1], [60, -2], [90, -4]]\n";
  const std::string measured = tool("R = 3\nR2 = 3\nDR2TABLE = \"W\"\n") + table;
  for (const char* normal : {"NX0 NY0 NZ1", "NX1 NY0 NZ1", "NX1.1 NY0 NZ1", "NX1 NY0 NZ2", "NX1 NY0 NZ1.2",
                             "NX1 NY0 NZ0", "NX1 NY0 NZ-1", "NX1 NY1 NZ0.8", "NX3 NY0 NZ1"})
    list.push_back({measured, call + at + normal + "\n"});
  // cos² = 9/(6·2): 30 degrees exactly; cos² = 1/(2·2): 60.
  list.push_back({measured, call + at + "NX1 NY1 NZ2 TX0 TY1 TZ1 M128\n"});
  list.push_back({measured, call + at + "NX1 NY0 NZ1 TX0 TY1 TZ1 M128\n"});
  list.push_back({tool("R = 3\nR2 = 2\nDR2TABLE = \"W\"\n") + table, block});
  return list;
}

}  // namespace toolcomp::test

// The clause files: what every clause must state, and that the model reaches every outcome a clause has.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/unit/heidenhain/clause_programs.h"
#include "tests/unit/heidenhain/klartext_run.h"
#include "tests/unit/model_run.h"

namespace {

using namespace toolcomp;

TEST(Clauses, StateTheirSource) {
  for (const spec::ClauseInfo& clause : spec::clauses()) {
    static const std::vector<std::string_view> kProvenances{"manual",   "sister-manual", "other-vendor",
                                                            "geometry", "recollection",  "ours"};
    EXPECT_NE(std::ranges::find(kProvenances, clause.provenance), kProvenances.end()) << clause.id;
    EXPECT_TRUE(clause.id.starts_with("fanuc.") || clause.id.starts_with("heidenhain.")) << clause.id;
    // Nobody may read our word, or our memory, as the manual's.
    const bool ours = clause.provenance == "ours" || clause.provenance == "recollection";
    EXPECT_TRUE(!ours || clause.kind == spec::ClauseKind::open) << clause.id;
    EXPECT_TRUE(clause.kind != spec::ClauseKind::open || !clause.alternatives.empty()) << clause.id;
    EXPECT_TRUE(ours || clause.provenance == "geometry" || !clause.document.empty() ||
                clause.section == "fanuc/program")
        << clause.id;
    EXPECT_TRUE(clause.kind != spec::ClauseKind::parameter || !clause.parameters.empty()) << clause.id;
    EXPECT_TRUE(clause.testable || !clause.reason.empty()) << clause.id;
    EXPECT_TRUE(clause.unreachable.empty() || !clause.unreachable_reason.empty()) << clause.id;
    // Whoever reads an explanation must learn what an outcome means.
    const bool decides = clause.testable && clause.outcomes != spec::ClauseOutcomes::reach;
    EXPECT_TRUE(!decides || (!clause.positive.empty() && !clause.negative.empty())) << clause.id;
    EXPECT_TRUE(!decides || clause.outcomes != spec::ClauseOutcomes::sign || !clause.tie.empty()) << clause.id;
  }
}

TEST(Clauses, FitIntoAName) {
  for (const spec::ClauseInfo& clause : spec::clauses())
    EXPECT_LE(clause.id.size(), spec::Name::kCapacity) << clause.id;
}

const std::string kXyz = "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"B\"]\n";
const std::string kOffsets = "[offsets.H]\n1 = 10\n2 = 20\n5 = 1000\n[offsets.D]\n1 = 10\n2 = -5\n";
std::string setup(const std::string& parameters) { return kXyz + "[parameters]\n" + parameters + kOffsets; }

struct Program {
  std::string setup;
  std::string text;
};

// G45 to G48.
std::vector<Program> tool_offset_programs() {
  const std::string plain = setup("");
  const std::string tph = setup("\"5001#5\" = 1\n");
  return {
      {plain, "G45 X100 B1 D1\nG48 X0\nG47\nG45 X0\nG91 G46 X0\nX-0\nG46 X-0\nG53 X0\nG90 G53 Y0\nG53 X0 Y0\n"},
      {plain, "G91 G45 G02 X30 Y-30 J-30 D1\nG46 X10 Y-10 J-10\nG45 X9 Y-9 J-9 D2\nG45 X4 Y-4 J-4\n"},
      {plain, "G91 G45 G02 X30 Y0 I15 D1\n"},
      {tph, "G45 X1 H1\nG43 G45 X1\n"},
      {plain, "G41 G45 D1\n"},
  };
}

// G37.
std::vector<Program> measurement_programs() {
  const auto at = [](const std::string& parameters, const std::string& signal) {
    return setup(parameters) + "[position]\nZ = 300\n" + (signal.empty() ? "" : "[measurement]\nZ = " + signal + "\n");
  };
  const auto memory_c = [](const std::string& signal) {
    return "control = \"fanuc\"\naxes = [\"Z\"]\n[parameters]\n6241 = 100\n[offsets]\nmemory = \"C\"\n[offsets.H]\n1 = "
           "1\n"
           "[position]\nZ = 300\n[measurement]\nZ = " +
           signal + "\n";
  };
  return {
      {at("", "198"), "H1\nG37 Z200\n"},
      {at("", "188"), "G44 Z300 H1\nG00 Z230\nG37 Z200\n"},
      {memory_c("205"), "H1\nZ220\nG37 Z200\n"},
      {memory_c("195"), "H1\nZ210\nG37 Z200\n"},
      {at("", "220"), "H1\nG37 Z200\n"},
      {at("", "230"), "H1\nG37 Z200\n"},
      {at("", "190"), "H1\nG37 Z200\n"},
      {at("", ""), "H1\nG37 Z200\n"},
      {at("", ""), "H1\nG37 Z300\n"},
      {at("6254 = 20\n", ""), "H1\nG37 Z300\n"},
      {at("", ""), "H1\nG43 G37 Z200\n"},
      {at("", ""), "G37 Z200 H1\n"},
      {at("", ""), "G37 Z200\n"},
      {at("", ""), "H1\nG37\n"},
      {at("", ""), "H1\nG41 D1\nG37 Z200\n"},
  };
}

// Cutter compensation B.
std::vector<Program> cutter_b_programs() {
  const auto b = [](const std::string& parameters) { return "cutter_compensation = \"B\"\n" + setup(parameters); };
  const std::string plain = b("");
  const std::string on = "G01 G41 X40 D1\n";
  return {
      {plain, "G41 Z1 D1\nX40\nX40\nX50 I1\nX50 I0\nG41 X60\nG42 X70 D1\nX80 D2\nX90 D0\nG10 L11 P1 R1\nG40\n"},
      {plain, on + "G03 X60 Y20 J20\nX40 Y20 I-10\nG02 X60 I10\nG03 J20\nX40 Y40 R-30\nG40\n"},
      {plain, on + "G03 X50 Y10 J10\n"},
      {plain, on + "G02 X60 I10\nG01 X70\nG02 X100 I15\nG03 X110 I5\nX120 I5\n"},
      {plain, on + "G39 J1\nG39 J1\nG91 G39 X1\nG42\nG39 I-1\nG53 X1\nG90 G53 Z1\nG53 X1\nG40 X5\n"},
      {plain, "G41 D1\nG40 X5\n"},
      {plain, "G41 X5 D0\nG02 G40 X9 R2\nG40\n"},
      {plain, on + "G40\nG41 X50\nG02 G40 X60 R5\n"},
      {plain, "G41 X5 D0\nG40\n"},
      {plain, on + "G03 X50 I10\n"},
      {plain, on + "G03 G41 X50 I5\n"},
      {plain, on + "G03 X50 I5 D2\n"},
      {plain, "G41 D1\nG03 X50 I5\n"},
      {plain, "G39\n"},
      {b("\"5001#2\" = 1\n"), "G41 X5 H1\n"},
      {plain, "G41 X5 H1\n"},
      {plain, on + "G18\n"},
      {plain, on + "G41.3\n"},
      {"control = \"fanuc\"\naxes = [\"X\"]\n", "G41\n"},
  };
}

// Cutter compensation C. The first two lines start along X with offset 10, the start-up and a block of the mode.
std::vector<Program> cutter_c_programs() {
  const auto c = [](const std::string& parameters) {
    return kXyz + "[parameters]\n" + parameters +
           "[offsets.D]\n1 = 10\n2 = -5\n3 = 0\n4 = 15\n5 = 2\n6 = 20\n7 = 25\n[position]\nX = -20\n";
  };
  const std::string a = c("");
  const std::string b = c("\"5003#0\" = 1\n");
  const std::string at_once = c("\"5003#1\" = 1\n");
  const std::string goes_on = c("\"5003#2\" = 1\n");
  const std::string unchecked = c("\"5008#0\" = 1\n");
  const std::string on = "G01 G41 X0 D1\nX40\n";
  // An arc of radius 50 about (-40, -30) to the origin.
  const auto arcs = [](const std::string& number) {
    return "G00 X10 Y-60\nG01 G41 Y-30 " + number + "\nG03 X0 Y0 R50\n";
  };
  return {
      // Corners of lines
      {a, on + "Y30\nX80\nX120\nX120 Y-30\nX100 Y-60\nX120 Y-30\nG40 X200\n"},
      {a, on + "M05\nX64 Y32\nM05\nM09\nX90\nG91 X0\nG90 X120 Y40\nX150 D2\nX180\n"},
      {c("5010 = 10\n"), on + "Y-30\nX20\nX40\nG02 X60 Y-60 I20 J-10\n"},
      {c("5010 = 20\n"), on + "X0\n"},
      {a, on + "G02 X-30 Y-10 I-30 J-40\n"},
      {a, on + "G02 I-30 J-40\n"},
      // Arcs
      {a, on + "G03 X0 Y80 I-40 J30\n"},
      {a, on + "G02 X60 Y-40 I-30 J-40\nG01 X60 Y-80\nG02 X40 Y-100 I-20\nG03 X0 Y-100 I-20 J-5\n"},
      {a, on + "G03 X-40 Y20 I-40 J-30\n"},
      {unchecked, "G01 G41 X0 D4\nX40\nG03 X-40 Y20 I-40 J-30\n"},
      {unchecked, on + "G03 X40 Y6 I-3 J4\nG01 X80\n"},
      {a, on + "G03 X50 Y10 J10\nX60 Y20 J10\nX60 Y40 J10\n"},
      {unchecked, on + "G03 X60 Y20 J20 D4\nX60 Y60 R20\n"},
      {unchecked, on + "G03 X40 Y16 I-6 J8\nG01 X80\n"},
      {unchecked, "G01 G41 X40 Y0 D1\nX0\n"},
      // Arcs that meet, touch, or do not
      {unchecked, arcs("D1") + "G03 X-10 Y-30 I40 J-30\n"},
      {unchecked, arcs("D4") + "G03 X-10 Y-30 I40 J-30\n"},
      {unchecked, arcs("D5") + "G03 X-10 Y-30 I40 J-30\n"},
      {unchecked, "G00 X-10 Y-60\nG01 G42 Y-30 D5\nG02 X0 Y0 R50\nG02 X10 Y-30 I-40 J-30\n"},
      {unchecked, arcs("D6") + "G02 X-40 Y-40 I-40\n"},
      {unchecked, arcs("D7") + "G02 X-40 Y-40 I-40\n"},
      // Start-up and cancel of type B
      {b, "G01 G41 X40 D1\nY30\nG40 X80\n"},
      {b, "G01 G41 X40 D1\nY-30\nG40 X80\n"},
      {b, "G01 G41 X40 D1\nY-30\nG40 X0\n"},
      {b, "G01 G41 X40 D1\nX10 Y-40\nG40 X40 Y20\n"},
      {b, "G01 G41 X40 D1\nX-40\nG40 X10\n"},
      {a, on + "G40 Y30 J5\n"},
      {a, on + "G40 Y30 J-5\n"},
      {a, on + "G40 Y30 I5\n"},
      {at_once, "G41 D1\nX40\nX80\nG40\nX90\nG41 Z1\nX80\nG40 Z2\nG41\nG40\n"},
      {a, "G41 D1\nX40\nX80\nG40\nX90\nG41 D1 X80\nG40\nG41\n"},
      {a, "G02 G41 X40 D1 I20\n"},
      {a, "G41 G02 X40 D0 I20\nG41 I1 J1 K1\n"},
      {a, "G01 G41 X40 D3\nX80\nG42 X0\nD1 X40\nX80\n"},
      // Change of direction, repetition
      {a, on + "G42 Y30\nG41 X80\nG42 X120 Y-30\nG41 X160 Y-60\nX200\nG41 Y0\n"},
      {a, on + "G42 G03 X0 Y80 I-40 J30\n"},
      {a, on + "G42 X80\n"},
      {a, "G01 G41 X40 D1\nG42 Y30\n"},
      // Interference
      {a, on + "Y15\nX0\n"},
      {a, on + "Y20\nX0\n"},
      {a, on + "G03 X50 I5\nG01 Y-20\n"},
      {a, on + "X35.2 Y-6.4\nX80\n"},
      {a, on + "G03 X-41.5 Y58 I-40 J30\n"},
      {a, "G00 X60\nG01 G41 X40 D1\nX0\nM05\nM09\nG02 J-5\n"},
      {a, "G41 G01 X100 D1\nG02 J-60\nG01 G40 X0 Y-200 I-10 J-10\n"},
      {a, on + "G02 X45 Y5 I5 J5\n"},
      // G39
      {a, on + "G39\nX80\nG39 I0 J1\nG39 I0 J-1\nG39 I1 J0\nG39 I0 J-1\nG39\nG40 Y5\n"},
      {a, on + "G39\nM05\nM09\n"},
      {a, on + "G39\n"},
      {a, "G39\n"},
      // Machine moves
      {a, on + "G53 Z1\nX80\nG28 X1 Y1\nX40\nG53 X1\nX40\nX20\nG40 X0\n"},
      {goes_on, on + "G53 X1\nX40\nG28 X1 Y1\nX40\nX50\nG91 G28 X0 Y0\n"},
      {a, on + "G92 X0\n"},
  };
}

// Tool side compensation. Most programs start along X with offset 10 and the tool in Z.
std::vector<Program> tool_side_programs() {
  const auto with = [](const std::string& parameters, const std::string& position = "X = -20\n") {
    return kXyz + "[parameters]\n" + parameters + "[offsets.D]\n1 = 10\n2 = -5\n[position]\n" + position;
  };
  const std::string plain = with("");
  const std::string unchecked = with("\"5008#0\" = 1\n");
  const std::string b = with("\"5003#0\" = 1\n");
  const std::string without = "type_b_without_perpendicular = true\n" + b;
  const std::string c = with("\"5003#1\" = 1\n");
  const std::string on = "G43.5 K1\nG01 G41.6 D1 X0\nX40\n";
  // TS9: from the tool (0, -4, 3) to another.
  const std::string ts9 = with("", "Y = 40\nZ = 40\n");
  const auto plane_change = [](const std::string& q, const std::string& tool, const std::string& next) {
    return "G43.5 J-4 K3\nG01 G41.6 D1 X0 Y0 Z0\nY-200 Z-200" + q + "\n" + tool + "\n" + next + "\n";
  };
  return {
      // Corners of lines, blocks between them, the ends of a program
      {unchecked, on + "X80\nY40\nX120\nY0\nX160 Y-10\nM05\nX120 Y-20\nX60 Y-10\nI1 K1\nX300\nX0\nG41.6 Y90\nM05\nM09\n"
                       "X400\nM00\nX500\nG40 X600\n"},
      {with("19630 = 6\n"), on + "X46\nX51\nX57\n"},
      {with("\"19605#5\" = 1\n"), on + "Y100 J1 K0\nX200\n"},
      // Arcs
      {plain, on + "G02 X60 Y-20 R20\nG01 Y-60\n"},
      {plain, "G43.5 K-1\nG01 G41.6 D1 X0\nX40\nG02 X60 Y-20 R20\n"},
      {plain, "G43.5 I3 K4\nG01 G41.6 D1 X0\nX40\nG02 X60 Y-20 R20\n"},
      {plain, "G43.5 J1\nG01 G41.6 D1 X0\nX40\nG02 X60 Y-20 R20\n"},
      {plain, "G43.5 K1\nG02 G41.6 D1 X0 R10\n"},
      // Start-up and cancel
      {b, "G43.5 K1\nG01 G41.6 D1 X0\nY30\nG40 X-40\n"},
      {b, "G43.5 K1\nG01 G41.6 D1 X0\nY-30\nG40 X-40\n"},
      {b, "G43.5 K1\nG01 G41.6 D1 X0\nX-30 Y-30\nG40 Y30\n"},
      {b, "G43.5 K1\nG01 G41.6 D1 X0\nX-30\nG40 X-60 Y-90\n"},
      {without, "G43.5 K1\nG01 G41.6 D1 X0\nY-30\nG40 X-40\n"},
      {plain, "G43.5 K1\nG01 G41.6 D1 X0\nG40 X40\nG41.6 X80\nX120\nG40\nX160\n"},
      {plain, on + "G40\nG41.6 X80\n"},
      {c, "G43.5 K1\nG01\nG41.6 D1\nX40\nG40\n"},
      {c, "G41.2 D1 X5\n"},
      // Vectors that are dropped: from (10, 10) to (10, -10)
      {with("5010 = 19\n\"5008#0\" = 1\n"), on + "X0\n"},
      {with("5010 = 20\n\"5008#0\" = 1\n"), on + "X0\n"},
      {with("5010 = 21\n\"5008#0\" = 1\n"), on + "X0\n"},
      // A change of the compensation plane
      {ts9, plane_change("", "J4 K3", "Y-400 Z0")},
      {ts9, plane_change(" Q1", "J4 K3", "Y-400 Z0")},
      {ts9, plane_change(" Q2", "J4 K3", "Y-400 Z0\nY-600 Z200 Q2\nY-800 Z400")},
      {ts9, plane_change(" Q3", "J4 K3", "Y-400 Z0")},
      {ts9, plane_change(" Q4", "J4 K3", "Y-400 Z0")},
      {with("\"5008#0\" = 1\n"),
       on + "X80 J1 K1\nX120 J-1 K1\nX160 Y40 J1 K1\nX200 J0 K1\nI0 J3 K4\nX240 Y40 J-1 K0\n"},
      {with("6261 = 90\n\"5008#0\" = 1\n"), on + "Y40 J1 K0\nX40 Z40 I1 J0\nZ80 I0 J0 K1\n"},
      // Alarms of words
      {plain, "G43.5\nG41.2\n"},
      {plain, on + "G18\n"},
      {plain, on + "G04\n"},
      {plain, on + "B5\n"},
  };
}

// Machines for tool center point control, on axes X1 Y2 Z3 A4 B5 C6: heads with C about Z that carries B about Y
// (kHead), tilted by RA, or about (0, 1, 1) (kNutating); tables A about X that carry C about Z; B on the head and a
// table C.
std::string of_machine(const std::string& parameters) {
  return "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"A\", \"B\", \"C\"]\n[parameters]\n" + parameters +
         kOffsets;
}
const std::string kHead = "19680 = 2\n19681 = 6\n19682 = 3\n19686 = 5\n19687 = 2\n";
const std::string kNutating = "19680 = 2\n19681 = 6\n19682 = 3\n19686 = 5\n19687 = 5\n19688 = 45\n";
const std::string kTable = "19680 = 12\n19681 = 4\n19682 = 1\n19684 = 1\n19686 = 6\n19687 = 3\n19689 = 1\n";
const std::string kMixed = "19680 = 21\n19681 = 5\n19682 = 2\n19686 = 6\n19687 = 3\n19689 = 1\n";

// Tool center point control.
std::vector<Program> tool_center_point_programs() {
  const std::string head = of_machine(kHead);
  const std::string table = of_machine(kTable);
  const std::string workpiece = of_machine(kTable + "\"19696#5\" = 1\n");
  const std::string ranges = of_machine(kHead + "19741 = 90\n19742 = -90\n");
  const std::string reversed = of_machine(kHead + "\"19608#5\" = 1\n");
  const std::string tilted_45 = of_machine(kHead + "19698 = 45\n");
  const std::string nutating = of_machine(kNutating);
  return {
      {head, "G43.4 H1\nG43.5\nB5\n"},
      {head, "G43.4 H1\nB10\nG01 X10 F1\nG49\nX1\n"},
      {table, "G43.4 H1\nG02 X10 I5 A5\n"},
      {of_machine(kMixed), "G43.4 H1\nG02 B5\n"},
      {of_machine("19680 = 12\n19681 = 0\n19682 = 1\n19686 = 6\n19687 = 3\n\"19696#0\" = 1\n"), "G43.5\n"},
      {table, "G43.5 I1\n"},
      // 19696#5
      {workpiece, "G43.4 H1\nX10 C20\nC30\n"},
      {workpiece, "G43.5\n"},
      {workpiece, "G43.4\nG01 G41.2 D1 X10 F1\n"},
      {workpiece, "G43.4\nG02 X10 I5 A10 F1\n"},
      {workpiece, "G43.4\nG02 X10 I5 C10 F1\n"},
      // Lean, arcs by radius
      {head, "G43.5 Q10 P0\nX10 K1\nZ10 K1\nG02 X20 R5 I1 K1 F1\nG02 X30\n"},
      // Reach
      {head, "G43.5 P0\nX1 K1\nI1 K1\n"},
      {of_machine(kHead + "19698 = 5\n"), "G43.5 P0\nI1 K1\nI1 K100\n"},
      {tilted_45, "G43.5 P0\nI1 K1\nK1\n"},
      {nutating, "G43.5 P0\nI1 K1\nI1 K0\nI1 K-1\n"},
      // Choice: pairs and the positions they start from as in worked example 2
      {head, "G43.5 P0\nI-1 J1 K2\n"},
      {head, "G43.5 P0\nI1 J1 K2\n"},
      {head, "G43.5 P0\nI0 J1 K1\n"},
      {head, "C45\nG43.5 P0\nI-1 J1 K2\n"},
      {head, "C-45\nG43.5 P0\nI1 J1 K2\n"},
      {table, "G43.5 P0\nI-1 J1 K2\n"},
      {table, "G43.5 P0\nI1 J-1 K2\n"},
      {reversed, "C45\nG43.5 P0\nI-1 J1 K2\n"},
      {reversed, "C-45\nG43.5 P0\nI1 J1 K2\n"},
      // Ranges
      {ranges, "G43.5 P0\nI0 J1 K1\nI-1 J1 K2\n"},
      {of_machine(kHead + "19741 = 10\n19742 = -10\n"), "G43.5 P0\nI0 J1 K1\n"},
      {of_machine(kHead + "19741 = -10\n19742 = 10\n"), "G43.5\n"},
      // Zeros of rotary axes
      {of_machine(kHead) + "[workpiece.G54]\nB = 10\n", "X1\n"},
      {"rotary_angles = \"programmed\"\n" + of_machine(kHead) + "[workpiece.G54]\nB = 10\n", "X1\n"},
  };
}

// Tool posture control.
std::vector<Program> tool_posture_programs() {
  const std::string head = of_machine(kHead);
  const auto near = [](const std::string& limit, const std::string& veto, const std::string& more = "") {
    return of_machine(kHead + "19738 = " + limit + "\n19739 = " + veto + "\n" + more);
  };
  // Past +Z at 45 degrees, round it by 90.
  const std::string past = "C45\nG43.5 P1 I1 J1 K1\nI-1 J1 K1\n";
  const std::string nutating = of_machine(kNutating);
  return {
      {of_machine(kHead + "\"19604#0\" = 1\n"), "G43.5\nI1 K1\nI2 K2\n"},
      {head, "G43.5 P2\n"},
      // A singular start: the work side turns up, down, or stands
      {head, "G43.5 P1\nI1 J1 K2\nI-1 J1 K2\nI-1 J-1 K2\n"},
      {head, "G43.5 P1\nI1 J-1 K2\nI0 J-1 K2\n"},
      {head, "G43.5 P1\nI1 K2\nI-2 K3\nI0 K1\n"},
      // A singular end: the work side turns up, down, or stands
      {head, "B30\nG43.4 P1\nB0\nB30\nB0 C20\nB30\nB0 C0\n"},
      // Branches, and what they do not lead to
      {head, "B30\nG43.4 P1\nB40 C90\nB20 C300\n"},
      {head, "B-30\nG43.4 P1\nB-40 C-90\n"},
      {nutating, "B180\nG43.4 P1\nB100 C10\n"},
      // How arcs pass an axis
      {near("1", "5"), "G43.5 P1 I1 K1\nI1 K0\nI1 K1\n"},
      {near("1", "5"), "G43.5 P1 I1 K0\nI0 J1\n"},
      {near("1", "5"), "G43.5 P1 I1 J1 K-5\nI-1 J1 K-5\nI-1 J1 K5\nI1 J1 K5\n"},
      // Inside reach
      {of_machine(kHead + "19698 = 5\n"), "G43.5 P1 I1 J1 K5\nI-1 J1 K5\nI-1 J0 K5\nI1 J.1 K5\n"},
      {of_machine(kHead + "19698 = 45\n"), "G43.5 P1 I1 J1 K1\nI-1 J1 K1\n"},
      // Near a singular posture
      {near("45", "90"), past},
      {near("60", "90"), past},
      {near("60", "91"), past},
      {near("60", "89"), past},
      {near("60", "89", "\"19696#3\" = 1\n"), past},
  };
}

// One line for each group of outcomes; programs end at their first alarm.
std::vector<Program> programs() {
  const std::string plain = setup("");
  const std::string b = setup("\"5001#1\" = 1\n");
  const std::string c = setup("\"5001#0\" = 1\n");
  const std::string tal = setup("\"5001#0\" = 1\n\"5001#3\" = 1\n");
  const std::string ofh = setup("\"5001#2\" = 1\n");
  const std::string evo = setup("\"5001#6\" = 1\n");
  const std::string machine =
      "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"B\", \"C\"]\n[parameters]\n19680 = 2\n"
      "19681 = 4\n19682 = 2\n19686 = 5\n19687 = 3\n";
  std::vector<Program> list{
      // Units, numbers, codes
      {plain, "G20 X1 Y1 F5\nG21 X1 X2 G91 G90\nG91 X1\nM30\n"},
      {setup("\"3401#0\" = 0\n"), "X1\nG04 X1\n"},
      {plain, "X1.2.3\n"},
      {plain, "G99\n"},
      {plain, "H401\n"},
      // Arcs
      {plain, "X10\nG03 X0 Y10 I-10\nX10 Y0 J-10\nX20 I-10\nX10 I-20\nI-10\nX-10 I-10\nX5 I10\nX0 Y0 I-5\nZ5\n"},
      {plain, "X10\nG03 X0 Y10 R10 I3\nX10 Y0 R-10\nX0 R5\nX10 R4\n"},
      {plain, "G03 X10\n"},
      {plain, "G03 X10 I0\n"},
      {plain, "G03 R10\n"},
      // Coordinates
      {plain, "G55 X1\nG92 X5\nG53 X1\nG91 G53 X1\nG28\nG28 X1\nG29 X1 Y1\nG90 G29 X2\nG30 P3 X1\nG30 P7 X1\n"},
      // Memory
      {plain, "G10 L11 P1 R1\nG91 G10 L11 P1 R1\nG10 L11 P1\nG10 L11 P1 R9999\n"},
      {plain, "G10 L11 P0 R1\n"},
      {plain, "G10 L9\n"},
      {plain, "G43 H5\n"},
      // Length offset
      {plain, "H1\nG43 Z0\nG44 H2\nG44\nH0\nG49\n"},
      {b, "G19 G43 H1\nG18 G43 H1\nG17 G43 H1\nG49\n"},
      {c, "G43 X1 H1\nH2\nG43 Y1 H1\n"},
      {c, "G43 H1\n"},
      {tal, "G43 X1 Y1 H1\n"},
      {ofh, "G43 Z0\nG43 H1\nG43\nH2\n"},
      {evo, "G43 Z0 H1\nX1\nG53 Z0\nG40\nX1\nG53 X0\nG53 Z0\nG40 H2\nG53 Z0\nH1\n"},
      // Directions
      {machine, "B30.\nG43.5\nI1\nG49\n"},
      {plain, "X1\nG43.5\nG43\n"},
      {plain, "G43.5\nG28 X0\n"},
      {setup("19666 = 1\n"), "G43.5\n"},
      {plain, "G43.5 Q1\n"},
      {plain, "G02 G43.5\n"},
      {plain, "G43.5 B1\n"},
      {plain, "G43.5 I0\n"},
      // Leading edge
      {plain,
       "G43.5 I3 K4\nG41.3 D1\nG01 X100\nX130 Z40\nX100 Z0\nY50\nX150\nM08\nX200 D2\nM08\nM09\nX0 I-3 "
       "K4\nX50\nY0\nY5\nM00\nX0\nG40\n"},
      {plain, "G43.5 I3 K4\nG41.3 D1\nG01 X100\nD0\nG41.3 D0\n"},
      {plain, "G43.5 I1 K1000\nG41.3 D1\nG01 X100\n"},
      {plain, "G43.5 I-1 K1000\nG41.3 D1\nG01 X100\n"},
      {plain, "G43.5 I1\nG41.3 D1\nX100\n"},
      {setup("19631 = 0\n"), "G43.5 I3 K4\nG41.3 D1\nX100\nG40\n"},
      {setup("19631 = 45\n"), "G43.5 I1 K1\nG41.3 D1\nX100\n"},
      {setup("19631 = 45\n"), "G43.5 I1 K1\nG41.3 D1\nX-100\n"},
      {setup("19631 = 30\n"), "G43.5 I1 J1 K0\nG41.3 D1\nX100\nG91 X-10 Z-10\nG40\n"},
      {plain, "G41.3 D1 X1\n"},
      {plain, "G02\nG41.3 D1\n"},
      {plain, "G41.3 D1\nM08\n"},
      {plain, "G41.3 D1\nX1\nG41.3\n"},
      {plain, "G41.3 D1\nX1\nG02\n"},
      {plain, "G41.3 D1\nX1\nG54\n"},
      {plain, "G41.3 D1\nX1\nG40 X2\n"},
  };
  for (const auto& more : {tool_offset_programs(), measurement_programs(), cutter_b_programs(), cutter_c_programs(),
                           tool_side_programs(), tool_center_point_programs(), tool_posture_programs()})
    list.insert(list.end(), more.begin(), more.end());
  return list;
}

TEST(Clauses, EveryOutcomeIsReached) {
  std::vector<model::ClauseCount> total(spec::kClauseCount);
  const auto count = [&total](const test::Run& done) {
    for (std::size_t i = 0; i < total.size(); ++i) {
      const model::ClauseCount& one = done.recorder.counts()[i];
      total[i].reached += one.reached;
      total[i].positive += one.positive;
      total[i].negative += one.negative;
      total[i].tie += one.tie;
    }
  };
  for (const Program& program : programs()) count(test::run(program.setup, program.text));
  for (const test::ClauseProgram& program : test::heidenhain_clause_programs())
    count(test::run_klartext(program.setup, program.text));
  for (std::size_t i = 0; i < total.size(); ++i) {
    const spec::ClauseInfo& clause = spec::clauses()[i];
    const auto expect = [&clause](const char* outcome, std::uint64_t times) {
      const bool unreachable = clause.unreachable.find(outcome) != std::string_view::npos;
      EXPECT_EQ(times == 0, unreachable) << clause.id << ": " << outcome;
    };
    if (!clause.testable || !clause.replaced_by.empty()) {
      EXPECT_EQ(total[i].reached, 0U) << clause.id;
    } else if (clause.outcomes == spec::ClauseOutcomes::reach) {
      EXPECT_GT(total[i].reached, 0U) << clause.id;
    } else if (clause.outcomes == spec::ClauseOutcomes::fact) {
      expect("true", total[i].positive);
      expect("false", total[i].negative);
    } else {
      expect("positive", total[i].positive);
      expect("negative", total[i].negative);
      expect("tie", total[i].tie);
    }
  }
}

}  // namespace

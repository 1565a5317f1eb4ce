// SPDX-License-Identifier: Apache-2.0
// A block that moves, with everything the state of the program says about it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "model/basis/recorder.h"
#include "model/geometry/vector.h"
#include "model/kinematics/tool_direction.h"
#include "spec/language/axes.h"
#include "spec/language/name.h"

namespace toolcomp::model::klartext {

// A support point of a table of deviations: degrees, its cosine, and the deviation of the corner radius there.
struct SupportPoint {
  Rational angle;
  Real cosine;
  Real value;
};
using Deviations = std::vector<SupportPoint>;

// The tool in the spindle. Lengths in units of the program. Clause: heidenhain.program.delta-sum.
struct EffectiveTool {
  bool called = false;    // a TOOL CALL has named it; a tool of zeros otherwise
  Real r, r2;             // of the table: R, R2
  std::optional<Real> l;  // of the table: overall length L
  Real dl, dr, dr2;       // sums of the deltas of table, TOOL CALL and compensation table
  Real dr2_of_program;    // the same without the tool table
  Deviations deviations;  // of DR2TABLE; empty: the tool has none
};

// R0, RL, RR.
enum class Side : std::uint8_t { none, left, right };

struct Warning {
  spec::Name number;         // W_DIGITS …
  const char* message = "";  // static text
  Clause clause{};
};

// An L block with an axis word, or an LN block. Lengths in units of the program, workpiece coordinates.
struct Motion {
  std::uint64_t line = 0;
  std::optional<std::uint64_t> n;

  spec::AxisValues<Real> programmed;  // linear axes: the end point
  spec::AxisValues<Real> rotary;      // rotary axes with a word in this block
  Vector position;                    // P: X Y Z of the end point
  unsigned unknown = 0;               // bit i: X, Y or Z of position is not known, and programmed does not have it
  Vector travel;                      // d: from the end point of the motion before

  bool vectors = false;          // LN
  std::optional<Vector> normal;  // N, as written
  Direction direction;           // T, as written, or where axes and modes have it; unit: t
  bool tcpm = false;
  bool center = false;            // CNT-CNT: P is the centre of the tool
  bool contour = false;           // PROG PATH IS CONTOUR
  Side side = Side::none;         // RL, RR in force
  bool oversize_allowed = false;  // M107
  std::shared_ptr<const EffectiveTool> tool;

  std::optional<Real> feed;  // F in force
  bool rapid = false;        // FMAX

  std::vector<Warning> warnings;
  spec::ClauseList clauses;  // applied so far

  // Compensated by RL or RR in space (peripheral milling).
  [[nodiscard]] bool is_peripheral() const { return !normal && tcpm && side != Side::none; }
  // RL or RR in the plane, which is not modelled.
  [[nodiscard]] bool is_out_of_scope() const { return !normal && !tcpm && side != Side::none; }

  void warn(Recorder& recorder, Clause clause, spec::Name number, const char* message) {
    recorder.reach(clause);
    warnings.push_back({number, message, clause});
  }
};

// A hole of a drilling cycle, in its place among the motions.
struct DrilledHole {
  Motion motion;         // as L to its end, the tool at the level of return
  std::size_t axis = 0;  // along which it goes, by its place in the setup
  Real r, bottom;        // along it: where the cycle begins, and as deep as it goes
};

}  // namespace toolcomp::model::klartext

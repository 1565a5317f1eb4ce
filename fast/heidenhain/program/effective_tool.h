// SPDX-License-Identifier: Apache-2.0
// The tool that compensation reckons with: the row of the table, the deltas of three sources, and what may not be.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fast/arithmetic/count.h"
#include "fast/heidenhain/program/alarm.h"
#include "fast/heidenhain/program/deviation_table.h"
#include "spec/language/setup.h"

namespace toolcomp::fast::klartext {

// The length of the tool in units of the program: what the real tool is longer than its table says, and all of it.
struct ToolLength {
  double length_delta = 0;  // dL
  double length = 0;        // L + dL
  bool has_length = false;
};

// Lengths of the tool in units of the program. Letters of tool.toml: ' is the effective tool.
struct ToolValues : ToolLength {
  double corner = 0;            // R2
  double ring = 0;              // rho = R − R2
  double radius_delta = 0;      // dR
  double corner_delta = 0;      // dR2 without a table of deviations
  double effective_radius = 0;  // R'
  double effective_corner = 0;  // R2' without a table of deviations
  double effective_ring = 0;    // rho' = max(0, R' − R2')
  double ring_delta = 0;        // rho' − rho
  bool has_ring = false;        // rho or rho' is not 0
};

class EffectiveTool {
 public:
  // Throws spec::InputError for values a control could not have.
  explicit EffectiveTool(const spec::Setup& setup);

  // Once, at the first block: tables are in mm.
  void set_units(bool inch);

  // TOOL CALL of a tool, which drops deltas and correction row; false where the table has none.
  [[nodiscard]] bool call(std::uint32_t number);
  [[nodiscard]] bool call(std::string_view name);
  // Deltas of TOOL CALL.
  void set_call_length(const Count& value);
  void set_call_radius(const Count& value);
  void set_call_corner(const Count& value);
  // Row of the compensation table, or none.
  void set_row(std::optional<std::uint32_t> row);

  [[nodiscard]] bool called() const { return called_; }
  [[nodiscard]] const ToolValues& values() const { return values_; }
  // The table of deviations, or nullptr.
  [[nodiscard]] const DeviationTable* deviations() const { return deviations_; }

  // Checks of blocks without a normal, and of those with one but without a table of deviations, in
  // the order of heidenhain.tool.order-of-checks.
  [[nodiscard]] const Alarm& check(bool normal, bool permitted) const {
    return verdict_[normal ? 1 : 0][permitted ? 1 : 0];
  }
  // With a normal and a table of deviations: before the contact angle is looked at, and after.
  [[nodiscard]] const Alarm& check_before_angle() const { return before_angle_; }
  [[nodiscard]] const Alarm& check_after_angle(bool permitted) const { return after_angle_[permitted ? 1 : 0]; }
  // R2 + DR2_CALL + DR2_TCO: what the deviation is added to, exactly; and the deltas alone.
  [[nodiscard]] const Count& corner_without_deviation() const { return corner_without_deviation_; }
  [[nodiscard]] double nearest_corner_without_deviation() const { return nearest_corner_without_deviation_; }
  [[nodiscard]] double corner_delta_without_deviation() const { return corner_delta_without_deviation_; }

 private:
  struct Deltas {
    Count length, radius, corner;
  };
  void take(const spec::ToolRow* row);
  [[nodiscard]] Count table(const spec::Decimal& value) const { return Count::of(value, factor_); }
  void update();

  const spec::Setup& setup_;
  Factor factor_ = Factor::one;
  std::vector<DeviationTable> tables_;

  bool called_ = false;
  Count radius_, corner_;
  std::optional<Count> length_;
  Deltas own_, call_, row_;
  const DeviationTable* deviations_ = nullptr;

  ToolValues values_;
  Alarm verdict_[2][2];  // [with a normal][M107]
  Alarm before_angle_;
  Alarm after_angle_[2];
  Count corner_without_deviation_;
  double nearest_corner_without_deviation_ = 0;
  double corner_delta_without_deviation_ = 0;
};

}  // namespace toolcomp::fast::klartext

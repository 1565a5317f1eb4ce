// SPDX-License-Identifier: Apache-2.0
// The setup of a control (corpus/schema/setup.schema.json): one type for TOML files and the JSON inside cases.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "spec/language/axes.h"
#include "spec/language/decimal.h"
#include "spec/parameters/alarm_causes.h"
#include "spec/parameters/keys.h"

namespace toolcomp::spec {

enum class Control : std::uint8_t { fanuc, heidenhain };
enum class OffsetMemory : std::uint8_t { a, b, c };

// A FANUC parameter: the whole number, or one bit of it ("5001#2").
struct ParameterId {
  std::uint32_t number = 0;
  int bit = -1;  // 0 to 7, or -1 for the whole number
  friend auto operator<=>(const ParameterId&, const ParameterId&) = default;
};

// One entry of the tool offset memory, in setup units. Memory A uses only geometry.
struct OffsetEntry {
  Decimal geometry;
  Decimal wear;
  friend bool operator==(const OffsetEntry&, const OffsetEntry&) = default;
};

// Values by axis letter, in setup units (degrees for rotary axes).
using AxisTable = std::map<char, Decimal>;

// A row of the Heidenhain tool table, in mm.
struct ToolRow {
  std::uint32_t number = 0;  // tenths: 51 for tool 5.1
  std::string name;          // empty: none
  Decimal r, r2, dl, dr, dr2;
  std::optional<Decimal> l;  // overall length, if known
  std::string dr2_table;     // name of a table of deviations, or empty
  friend bool operator==(const ToolRow&, const ToolRow&) = default;
};

// A row of the compensation table in the tool system (.tco), in mm.
struct CorrectionRow {
  Decimal dl, dr, dr2;
  friend bool operator==(const CorrectionRow&, const CorrectionRow&) = default;
};

// Deviations of the corner radius (mm) by contact angle (degrees, ascending).
using DeviationTable = std::vector<std::pair<Decimal, Decimal>>;

// The largest P of G54.1 and of G10 L20.
inline constexpr std::uint32_t kAdditionalWorkpieces = 48;

// The values that are chosen by key (units, rotary_angles, …) are inherited; setup_key.h has their table.
struct Setup : SetupKeys {
  Control control = Control::fanuc;
  Axes axes;
  std::map<ParameterId, Decimal> parameters;
  std::map<AlarmCause, std::string> alarms;  // alarm numbers of this control that differ from those of its series

  OffsetMemory memory = OffsetMemory::a;
  std::uint32_t offset_count = 400;
  std::map<std::uint32_t, OffsetEntry> h;
  std::map<std::uint32_t, OffsetEntry> d;

  std::array<AxisTable, 6> workpiece;  // G54 … G59: machine coordinates of the workpiece origin
  // Entry 0 is added to all of them (EXT). Entries 1 to 48 are G54.1 P1 … P48.
  std::map<std::uint32_t, AxisTable> additional_workpiece;
  AxisTable position;                  // start, workpiece coordinates without offsets
  std::map<int, AxisTable> reference;  // 1, 2, 3, 4: machine coordinates for G28, G30
  AxisTable floating_reference;        // G30.1
  AxisTable measurement;               // G37

  std::vector<ToolRow> tools;                        // Heidenhain: [[tool]]
  std::map<std::uint32_t, CorrectionRow> tcs;        // [[correction.tcs]]
  std::map<std::string, DeviationTable> dr2_tables;  // [[dr2table]]

  // The parameter as it was written, or std::nullopt. A bit is first looked up as "n#b", then in the whole number, if
  // that is given as an integer.
  [[nodiscard]] std::optional<Decimal> parameter(std::uint32_t number) const;
  [[nodiscard]] bool bit(std::uint32_t number, int bit, bool otherwise = false) const;

  friend bool operator==(const Setup&, const Setup&) = default;
};

}  // namespace toolcomp::spec

// SPDX-License-Identifier: Apache-2.0
// The codes of one block: which G codes of which modal group, which M codes, which numbers of tool offsets.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/basis/number.h"
#include "model/basis/recorder.h"
#include "spec/language/event.h"
#include "spec/language/fanuc/block.h"
#include "spec/language/fanuc/g_codes.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// The value of a code is its number (spec::GCode), but for `none`.
enum class Motion : std::uint16_t {
  rapid = spec::kG00,
  linear = spec::kG01,
  arc_cw = spec::kG02,
  arc_ccw = spec::kG03
};
enum class Compensation : std::uint16_t {  // group 07
  cancel = spec::kG40,
  left = spec::kG41,
  right = spec::kG42,
  leading_edge = spec::kG41_3,
  tool_side_left = spec::kG41_2,
  tool_side_right = spec::kG42_2,
  directed_tool_side_left = spec::kG41_6,  // the same under G43.5
  directed_tool_side_right = spec::kG42_6
};
enum class LengthCode : std::uint16_t {  // group 08
  plus = spec::kG43,
  minus = spec::kG44,
  tip_control = spec::kG43_4,     // tool center point control, type 1
  tool_direction = spec::kG43_5,  // type 2
  cancel = spec::kG49
};
enum class Cycle : std::uint8_t {  // group 09
  cancel,                          // G80
  pecking,                         // G73, G83: by depths of cut
  back_boring,                     // G87
  other                            // G74 G76 G81 G82 G84 G85 G86 G88 G89
};
enum class OneShot : std::uint16_t {  // group 00
  none = 0,
  dwell = spec::kG04,
  data = spec::kG10,
  reference = spec::kG28,
  from_reference = spec::kG29,
  other_reference = spec::kG30,
  floating_reference = spec::kG30_1,
  measure = spec::kG37,
  corner_arc = spec::kG39,
  increase = spec::kG45,
  decrease = spec::kG46,
  double_increase = spec::kG47,
  double_decrease = spec::kG48,
  local_coordinates = spec::kG52,
  machine_coordinates = spec::kG53,
  shift = spec::kG92
};

using AxisMask = std::uint16_t;  // bit i: controlled axis i
// An axis that the machine does not have (spec::Axes::kNone) is in no mask.
constexpr bool in(AxisMask mask, std::size_t axis) { return (mask >> axis & 1U) != 0; }
// With this axis as well; without these.
constexpr AxisMask with(AxisMask mask, std::size_t axis) { return static_cast<AxisMask>(mask | 1U << axis); }
constexpr AxisMask without(AxisMask mask, AxisMask removed) { return static_cast<AxisMask>(mask & ~removed); }
// The axes of a mask, in order.
inline std::vector<std::size_t> axes_in(AxisMask mask) {
  std::vector<std::size_t> axes;
  for (std::size_t i = 0; i < spec::kMaxAxes; ++i)
    if (in(mask, i)) axes.push_back(i);
  return axes;
}

// The axes that have a value other than 0.
inline AxisMask nonzero(const std::array<Rational, spec::kMaxAxes>& values) {
  AxisMask mask = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!values.at(i).is_zero()) mask = with(mask, i);
  return mask;
}

// G45–G48.
constexpr bool is_tool_offset(OneShot code) { return code >= OneShot::increase && code <= OneShot::double_decrease; }

// G28, G30, G30.1.
constexpr bool is_reference_return(OneShot code) {
  return code == OneShot::reference || code == OneShot::other_reference || code == OneShot::floating_reference;
}
// G53, and those.
constexpr bool goes_by_machine_coordinates(OneShot code) {
  return is_reference_return(code) || code == OneShot::machine_coordinates;
}

// G52 and G92: the axis words say how positions are called, and move nothing.
constexpr bool is_shift(OneShot code) { return code == OneShot::local_coordinates || code == OneShot::shift; }
// G04 and G10: no code of the path.
constexpr bool is_dwell_or_data(OneShot code) { return code == OneShot::dwell || code == OneShot::data; }

// G41, G42.
constexpr bool is_cutter_side(Compensation code) { return code == Compensation::left || code == Compensation::right; }
// G43.4, G43.5.
constexpr bool is_tip_control(LengthCode code) {
  return code == LengthCode::tip_control || code == LengthCode::tool_direction;
}
// G41.2, G42.2, G41.6, G42.6.
constexpr bool is_tool_side(Compensation code) {
  return code != Compensation::cancel && code != Compensation::leading_edge && !is_cutter_side(code);
}

// The last word of each address.
class Words {
 public:
  Words(const spec::Block& block, Recorder& recorder);
  // Null where the block has no such word. G, M, N and O are not kept.
  [[nodiscard]] const spec::Decimal* find(char address) const { return word_[static_cast<std::size_t>(address - 'A')]; }
  [[nodiscard]] bool has(char address) const { return find(address) != nullptr; }
  // Its value as written, or `otherwise`.
  [[nodiscard]] Rational number(char address, const Rational& otherwise) const {
    return has(address) ? plain(*find(address)) : otherwise;
  }
  // One of them stands twice.
  [[nodiscard]] bool repeats() const { return repeats_; }

 private:
  bool repeats_ = false;
  std::array<const spec::Decimal*, 26> word_{};
};

// What a block says in G, M, H and D words; groups it does not mention are absent. Of several codes of one group the
// last counts.
struct Codes {
  OneShot one_shot = OneShot::none;
  std::optional<Motion> motion;
  std::optional<spec::Plane> plane;          // group 02
  std::optional<bool> incremental;           // group 03
  std::optional<spec::Units> units;          // group 06
  std::optional<Compensation> compensation;  // group 07
  std::optional<LengthCode> length;          // group 08
  std::optional<bool> feed_per_minute;       // group 05: G94, or G93 G95
  std::optional<Cycle> cycle;                // group 09
  std::optional<bool> to_initial_level;      // group 10: G98, or G99
  std::optional<std::size_t> workpiece;      // group 14: 1 for G54 … 6 for G59, behind them G54.1 P1 …
  bool writes_origin = false;                // G10 L2, G10 L20
  bool refused_in_space = false;             // G05 but for P10000, G96 G97 G160: not in a compensation in space
  bool letters_are_data = false;             // of G04 G05 G05.1 G10 G22 G50.1: axis letters, I J K
  std::optional<std::uint32_t> h;            // offset numbers
  std::optional<std::uint32_t> d;
  bool stops_look_ahead = false;  // M00 M01 M02 M30, and M codes of parameters
  bool ends_program = false;      // M02 M30
  bool auxiliary = false;         // an M, S or T word
  bool calls = false;             // M98
  bool returns = false;           // M99
  bool any = false;               // a word other than O
  bool repeats = false;           // two codes of one group
};

// Throws Alarm: PS0010 for the first code that does not exist, PS0030 for an offset number beyond the memory and for
// a P that G54.1 does not have.
Codes read_codes(const spec::Block& block, const Words& words, const spec::Setup& setup, Recorder& recorder);

}  // namespace toolcomp::model

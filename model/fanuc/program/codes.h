// SPDX-License-Identifier: Apache-2.0
// The codes of one block: which G codes of which modal group, which M codes, which numbers of tool offsets.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "model/basis/number.h"
#include "model/basis/recorder.h"
#include "spec/language/event.h"
#include "spec/language/fanuc/block.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

enum class Motion : std::uint8_t { rapid, linear, arc_cw, arc_ccw };  // group 01: G00–G03
enum class Compensation : std::uint8_t {                              // group 07
  cancel,                                                             // G40
  left,                                                               // G41
  right,                                                              // G42
  leading_edge,                                                       // G41.3
  tool_side_left,                                                     // G41.2
  tool_side_right,                                                    // G42.2
  directed_tool_side_left,                                            // G41.6: the same under G43.5
  directed_tool_side_right                                            // G42.6
};
enum class LengthCode : std::uint8_t {  // group 08
  plus,                                 // G43
  minus,                                // G44
  tip_control,                          // G43.4: tool center point control, type 1
  tool_direction,                       // G43.5: type 2
  cancel                                // G49
};
enum class Cycle : std::uint8_t {  // group 09
  cancel,                          // G80
  pecking,                         // G73, G83: by depths of cut
  back_boring,                     // G87
  other                            // G74 G76 G81 G82 G84 G85 G86 G88 G89
};
enum class OneShot : std::uint8_t {  // group 00
  none,
  dwell,                // G04
  data,                 // G10
  reference,            // G28
  from_reference,       // G29
  other_reference,      // G30
  floating_reference,   // G30.1
  measure,              // G37
  corner_arc,           // G39
  increase,             // G45
  decrease,             // G46
  double_increase,      // G47
  double_decrease,      // G48
  local_coordinates,    // G52
  machine_coordinates,  // G53
  shift                 // G92
};

using AxisMask = std::uint16_t;  // bit i: controlled axis i

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
constexpr bool is_tool_side(Compensation code) { return code >= Compensation::tool_side_left; }

// The last word of each address.
class Words {
 public:
  Words(const spec::Block& block, Recorder& recorder);
  // Null where the block has no such word. G, M, N and O are not kept.
  [[nodiscard]] const spec::Decimal* find(char address) const { return word_[static_cast<std::size_t>(address - 'A')]; }
  [[nodiscard]] bool has(char address) const { return find(address) != nullptr; }
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
  std::optional<std::size_t> workpiece;      // group 14: 0 for G54 … 5 for G59, behind them G54.1 P1 …
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

// SPDX-License-Identifier: Apache-2.0
// The words of one block by what they command: one G code per modal group, one value per letter.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "spec/language/axes.h"
#include "spec/language/fanuc/block.h"
#include "spec/language/fanuc/g_codes.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// G codes in tenths: G43.5 is 435. 0 (which is G00) is told from none by kNone.
using Code = std::int16_t;
using enum spec::GCode;
inline constexpr Code kNone = -1;

// The letters of the axes of a setup.
struct AxisLetters {
  explicit AxisLetters(const spec::Axes& axes)
      : count(axes.size()), xyz_first(axes.index('X') == 0 && axes.index('Y') == 1 && axes.index('Z') == 2) {
    for (std::size_t axis = 0; axis < count; ++axis) {
      index[axis] = static_cast<std::uint8_t>(axes.letter(axis) - 'A');
      set |= std::uint32_t{1} << index[axis];
      if (!xyz_first || axis >= 3) others |= std::uint32_t{1} << index[axis];
    }
  }
  // Bit i: the letter of axis i is among them.
  [[nodiscard]] unsigned positions(std::uint32_t letters) const {
    unsigned found = xyz_first ? letters >> ('X' - 'A') & 7U : 0;
    if ((letters & others) == 0) return found;
    for (std::size_t axis = xyz_first ? 3 : 0; axis < count; ++axis) found |= (letters >> index[axis] & 1U) << axis;
    return found;
  }

  std::size_t count;
  bool xyz_first;                                    // X Y Z are the first three axes
  std::array<std::uint8_t, spec::kMaxAxes> index{};  // in the alphabet, from 0
  std::uint32_t set = 0;                             // as of has_any()
  std::uint32_t others = 0;                          // of them those that positions() goes through
};

// An address other than G, M, N and O stands twice in the block, or two codes of one group do.
bool repeats(const spec::Block& block);
// The M codes that parameters name as those that keep the control from reading ahead (3411 to 3432): from first to
// last.
struct StopCodes {
  explicit StopCodes(const spec::Setup& setup);
  [[nodiscard]] bool has(std::uint32_t code) const {
    return std::ranges::any_of(ranges,
                               [code](const auto& range) { return range.first <= code && code <= range.second; });
  }

  std::vector<std::pair<std::uint32_t, std::uint32_t>> ranges;
};

// A block taken apart. Of several codes of a group, and of several words of one letter, the last one counts.
// Points into the block it was made from.
class Words {
 public:
  enum : std::uint8_t {
    kMotion,
    kPlane,
    kDistance,
    kUnits,
    kCompensation,
    kLength,
    kWorkpiece,
    kOneShot,
    kFeedMode,
    kCycle,
    kReturn,
    kGroups
  };

  // Refers to all of them.
  Words(const spec::Block& block, const AxisLetters& axes, const StopCodes& stops);

  // The code of a group, or kNone.
  [[nodiscard]] Code code(std::size_t group) const { return code_[group]; }
  // A code that the control does not have.
  [[nodiscard]] bool unknown() const { return unknown_; }
  // G10 L2, G10 L20.
  [[nodiscard]] bool writes_origin() const;
  // G05 but for P10000, G96, G97, G160.
  [[nodiscard]] bool refused_in_space() const;
  // G52, G92.
  [[nodiscard]] bool shifts_coordinates() const { return code_[kOneShot] == kG52 || code_[kOneShot] == kG92; }
  // The workpiece system that G54 to G59, G54.1 P or G54 P selects: 0 to 5, from 6 on; kNoSystem where P names none.
  // Only where there is such a code.
  static constexpr std::size_t kNoSystem = ~std::size_t{0};
  [[nodiscard]] std::size_t workpiece() const;
  [[nodiscard]] bool has(char letter) const { return (letters_ >> (letter - 'A') & 1U) != 0; }
  [[nodiscard]] bool has_any(std::uint32_t letters) const { return (letters_ & letters) != 0; }
  // Only where has(letter).
  [[nodiscard]] const spec::Decimal& operator[](char letter) const {
    return *value_[static_cast<std::size_t>(letter - 'A')];
  }
  // Words, and only positions, F, G00 to G03, I J K and R: nothing of the modal state changes but feed and group 01.
  [[nodiscard]] bool plain() const { return plain_; }
  // Bit i: axis i of the setup has a position. In a block with G04 G05 G05.1 G10 G22 or G50.1 axis letters and I J K
  // are data of that code: there the block has none of them.
  [[nodiscard]] std::uint16_t axes() const { return axes_; }
  // A code stands in the block to which its axis letters, P and Q belong.
  [[nodiscard]] bool letters_are_data() const { return data_letters_; }
  // L belongs to the M98 of the block.
  [[nodiscard]] bool calls_by_l() const { return calls_by_l_; }
  // The same block, its axis letters and I J K R as data: a block in the drilling mode moves nothing by them.
  [[nodiscard]] Words naming_no_axis() const {
    Words still = *this;
    still.letters_ &= ~set_of("ABCIJKRUVWXYZ");
    still.data_axes_ = axes_;
    still.axes_ = 0;
    return still;
  }
  // The axes that are named as data of a code.
  [[nodiscard]] std::uint16_t data_axes() const { return data_axes_; }
  [[nodiscard]] const spec::Decimal& axis(std::size_t index) const { return *value_[axis_letters_.index[index]]; }
  // G45 to G48.
  [[nodiscard]] bool is_tool_offset() const { return code_[kOneShot] >= kG45 && code_[kOneShot] <= kG48; }
  // G43.4, G43.5.
  [[nodiscard]] bool starts_tip_control() const { return code_[kLength] == kG43_4 || code_[kLength] == kG43_5; }
  // A word other than N and O.
  [[nodiscard]] bool any() const { return any_; }
  // M00 M01 M02 M30, or an M code of parameters, which keep the control from reading ahead.
  [[nodiscard]] bool suppresses_look_ahead() const { return stop_ || end_; }
  // M02 M30.
  [[nodiscard]] bool ends_program() const { return end_; }

  // The set of letters for has_any().
  static constexpr std::uint32_t set_of(const char* letters) {
    std::uint32_t set = 0;
    for (; *letters != 0; ++letters) set |= std::uint32_t{1} << (*letters - 'A');
    return set;
  }

 private:
  void read_codes(const spec::Block& block);
  void g_word(const spec::Decimal& value);
  // Branches that are foretold: a place in code_ that is looked up would keep whoever reads the codes waiting.
  void set_code(std::uint64_t tenths);
  void m_word(const spec::Decimal& value);
  // P belongs to a code or an M98 or M99 of the block.
  [[nodiscard]] bool takes_p() const {
    const bool drills = code_[kCycle] != kNone && code_[kCycle] != kG80;
    return data_letters_ || calls_ || code_[kOneShot] == kG30 || starts_tip_control() || drills;
  }

  const AxisLetters& axis_letters_;
  const StopCodes& stop_codes_;
  std::array<Code, kGroups> code_;
  std::array<const spec::Decimal*, 26> value_;  // set where letters_ has the bit
  std::uint32_t letters_ = 0;
  std::uint16_t axes_ = 0;
  std::uint16_t data_axes_ = 0;
  bool data_letters_ = false;
  bool high_speed_ = false;  // G05
  bool calls_ = false;       // M98, M99
  bool calls_by_l_ = false;  // M98
  bool spindle_ = false;     // G96, G97, G160
  bool any_ = false;
  bool plain_ = true;
  bool unknown_ = false;
  bool stop_ = false;
  bool end_ = false;
};

// NOLINTNEXTLINE: arrays are read only where marked as set
inline Words::Words(const spec::Block& block, const AxisLetters& axes, const StopCodes& stops)
    : axis_letters_(axes), stop_codes_(stops) {
  code_.fill(kNone);
  // Not in a member while the loop runs, and without a branch: which letter comes next follows no pattern.
  std::uint32_t codes = 0;  // bit i: a letter of the code 64 + i
  for (const spec::Word& word : block.words()) {
    const auto letter = static_cast<unsigned char>(word.address);
    codes |= std::uint32_t{1} << (letter & 31U);
    value_[std::size_t{letter} - 'A'] = &word.value;
  }
  const std::uint32_t letters = codes >> 1U;
  const std::uint32_t others = letters & ~axes.set;
  letters_ = letters;
  axes_ = static_cast<std::uint16_t>(axes.positions(letters));
  any_ = (letters & ~set_of("NO")) != 0;
  plain_ = any_ && (others & ~set_of("FGIJKR")) == 0;
  if ((others & set_of("GM")) != 0) read_codes(block);
  if (plain_) [[likely]]
    return;
  if (data_letters_) {
    letters_ &= ~set_of("ABCIJKUVWXYZ");
    data_axes_ = axes_;
    axes_ = 0;
  }
}

// The whole number a decimal is, if it is one not above `limit`; otherwise limit + 1.
std::uint32_t whole_number(const spec::Decimal& value, std::uint32_t limit);

}  // namespace toolcomp::fast

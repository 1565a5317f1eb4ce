// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/program/words.h"

#include <algorithm>

#include "spec/language/setup.h"

namespace toolcomp::fast {
namespace {

bool is_one_shot(std::uint64_t tenths) {
  switch (tenths) {
    case kG04:
    case kG10:
    case kG28:
    case kG29:
    case kG30:
    case kG30_1:
    case kG37:
    case kG39:
    case kG45:
    case kG46:
    case kG47:
    case kG48:
    case kG52:
    case kG53:
    case kG92:
      return true;
    default:
      return false;
  }
}

// G80 ends the others.
bool is_cycle(std::uint64_t tenths) {
  const bool drills_or_taps = tenths == kG73 || tenths == kG74 || tenths == kG76;
  return drills_or_taps || (tenths >= kG80 && tenths <= kG89 && tenths % 10 == 0);
}

// Codes that change no path of what is built: cancels of what is not, and how fast and exactly a path is run.
bool is_without_effect(std::uint64_t tenths) {
  constexpr std::array<std::uint16_t, 26> kCodes{kG05, kG05_1, kG08, kG09,   kG11,   kG13_1, kG15,   kG22, kG23,
                                                 kG25, kG40_1, kG50, kG50_1, kG50_2, kG61,   kG61_1, kG62, kG63,
                                                 kG64, kG67,   kG69, kG96,   kG97,   kG113,  kG150,  kG160};
  return std::ranges::binary_search(kCodes, tenths);
}

// What a parameter may name.
constexpr std::uint32_t kMostM = 99'999'999;

// Codes to which the axis letters of their block belong.
bool takes_letters(std::uint64_t tenths) {
  return tenths == kG04 || tenths == kG10 || tenths == kG05 || tenths == kG05_1 || tenths == kG22 || tenths == kG50_1;
}

constexpr std::uint64_t kNoCode = ~std::uint64_t{0};
// A code in tenths; kNoCode where it has more decimals or digits.
std::uint64_t tenths_of(const spec::Decimal& value) {
  std::uint64_t tenths = value.digits;
  unsigned decimals = value.decimals;
  while (decimals > 1 && tenths % 10 == 0) {
    tenths /= 10;
    --decimals;
  }
  if (decimals > 1 || tenths > 9999) return kNoCode;
  return decimals == 0 ? 10 * tenths : tenths;
}

// The group of a code of it, in tenths; kGroups for any other.
std::size_t group_of(std::uint64_t tenths) {
  switch (tenths) {
    case kG00:
    case kG01:
    case kG02:
    case kG03:
      return Words::kMotion;
    case kG17:
    case kG18:
    case kG19:
      return Words::kPlane;
    case kG20:
    case kG21:
      return Words::kUnits;
    case kG40:
    case kG41:
    case kG41_2:
    case kG41_3:
    case kG41_6:
    case kG42:
    case kG42_2:
    case kG42_6:
      return Words::kCompensation;
    case kG43:
    case kG43_4:
    case kG43_5:
    case kG44:
    case kG49:
      return Words::kLength;
    case kG54:
    case kG55:
    case kG56:
    case kG57:
    case kG54_1:
    case kG58:
    case kG59:
      return Words::kWorkpiece;
    case kG90:
    case kG91:
      return Words::kDistance;
    case kG93:
    case kG94:
    case kG95:
      return Words::kFeedMode;
    case kG98:
    case kG99:
      return Words::kReturn;
    default:
      if (is_cycle(tenths)) return Words::kCycle;
      return is_one_shot(tenths) ? Words::kOneShot : Words::kGroups;
  }
}

}  // namespace

void Words::read_codes(const spec::Block& block) {
  for (const spec::Word& word : block.words())
    if (word.address == 'G')
      g_word(word.value);
    else if (word.address == 'M')
      m_word(word.value);
}

void Words::g_word(const spec::Decimal& value) {
  if (value.digits <= 3 && value.decimals == 0) {  // without a detour
    code_[kMotion] = static_cast<Code>(10 * value.digits);
    return;
  }
  plain_ = false;
  const std::uint64_t tenths = tenths_of(value);
  if (tenths == kNoCode)
    unknown_ = true;
  else
    set_code(tenths);
}

void Words::set_code(std::uint64_t tenths) {
  const std::size_t group = group_of(tenths);
  if (group != kOneShot && group != kGroups) {
    code_[group] = static_cast<Code>(tenths);
    return;
  }
  data_letters_ = data_letters_ || takes_letters(tenths);
  high_speed_ = high_speed_ || tenths == kG05;
  spindle_ = spindle_ || tenths == kG96 || tenths == kG97 || tenths == kG160;
  if (is_without_effect(tenths)) return;
  if (group == kOneShot) {
    code_[kOneShot] = static_cast<Code>(tenths);
    return;
  }
  unknown_ = true;
}

bool repeats(const spec::Block& block) {
  std::uint32_t letters = 0;
  std::uint32_t groups = 0;
  for (const spec::Word& word : block.words()) {
    if (word.address == 'M' || word.address == 'N' || word.address == 'O') continue;
    const bool code = word.address == 'G';
    const std::size_t place = code ? group_of(tenths_of(word.value)) : static_cast<std::size_t>(word.address - 'A');
    if (code && place == Words::kGroups) continue;
    std::uint32_t& seen = code ? groups : letters;
    const std::uint32_t mark = std::uint32_t{1} << place;
    if ((seen & mark) != 0) return true;
    seen |= mark;
  }
  return false;
}

bool Words::writes_origin() const {
  if (code_[kOneShot] != kG10 || !has('L')) return false;
  const std::uint32_t list = whole_number((*this)['L'], 20);
  return list == 2 || list == 20;
}

bool Words::refused_in_space() const {
  return spindle_ || (high_speed_ && (!has('P') || whole_number((*this)['P'], 10000) != 10000));
}

std::size_t Words::workpiece() const {
  const Code code = code_[kWorkpiece];
  const bool additional = code == kG54_1 || (code == kG54 && has('P') && !takes_p());
  if (!additional) return static_cast<std::size_t>((code - kG54) / 10);
  const std::uint32_t number = has('P') ? whole_number((*this)['P'], spec::kAdditionalWorkpieces) : 1;
  return number == 0 || number > spec::kAdditionalWorkpieces ? kNoSystem : std::size_t{5} + number;
}

StopCodes::StopCodes(const spec::Setup& setup) {
  const auto value = [&setup](std::uint32_t number) {
    const auto given = setup.parameter(number);
    return given ? whole_number(*given, kMostM) : 0U;
  };
  const auto add = [this](std::uint32_t first, std::uint32_t last) {
    if (first <= last && last > 0) ranges.emplace_back(first, last);
  };
  for (std::uint32_t number = 3411; number <= 3420; ++number) add(value(number), value(number));
  for (std::uint32_t number = 3421; number <= 3431; number += 2) add(value(number), value(number + 1));
}

void Words::m_word(const spec::Decimal& value) {
  const std::uint32_t code = whole_number(value, kMostM);
  stop_ = stop_ || stop_codes_.has(code);
  switch (code) {
    case 0:
    case 1:
      stop_ = true;
      break;
    case 2:
    case 30:
      end_ = true;
      break;
    case 98:
      calls_by_l_ = true;
      calls_ = true;
      break;
    case 99:
      calls_ = true;
      break;
    default:
      break;
  }
}

std::uint32_t whole_number(const spec::Decimal& value, std::uint32_t limit) {
  std::uint64_t digits = value.digits;
  for (unsigned decimals = value.decimals; decimals > 0; --decimals) {
    if (digits % 10 != 0) return limit + 1;
    digits /= 10;
  }
  if (digits > limit || (value.negative && digits != 0)) return limit + 1;
  return static_cast<std::uint32_t>(digits);
}

}  // namespace toolcomp::fast

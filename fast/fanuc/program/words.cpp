// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/program/words.h"

#include <algorithm>

#include "spec/language/setup.h"

namespace toolcomp::fast {
namespace {

bool is_one_shot(std::uint64_t tenths) {
  switch (tenths) {
    case 40:
    case 100:
    case 280:
    case 290:
    case 300:
    case 301:
    case 370:
    case 390:
    case 450:
    case 460:
    case 470:
    case 480:
    case 520:
    case 530:
    case 920:
      return true;
    default:
      return false;
  }
}

// G80 ends the others.
bool is_cycle(std::uint64_t tenths) {
  const bool drills_or_taps = tenths == 730 || tenths == 740 || tenths == 760;
  return drills_or_taps || (tenths >= 800 && tenths <= 890 && tenths % 10 == 0);
}

// Codes that change no path of what is built: cancels of what is not, and how fast and exactly a path is run.
bool is_without_effect(std::uint64_t tenths) {
  constexpr std::array<std::uint16_t, 26> kCodes{50,  51,  80,  90,  110, 131, 150, 220, 230, 250, 401,  500,  501,
                                                 502, 610, 611, 620, 630, 640, 670, 690, 960, 970, 1130, 1500, 1600};
  return std::ranges::binary_search(kCodes, tenths);
}

// What a parameter may name.
constexpr std::uint32_t kMostM = 99'999'999;

// Codes to which the axis letters of their block belong.
bool takes_letters(std::uint64_t tenths) {
  return tenths == 40 || tenths == 100 || tenths == 50 || tenths == 51 || tenths == 220 || tenths == 501;
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
    case 0:
    case 10:
    case 20:
    case 30:
      return Words::kMotion;
    case 170:
    case 180:
    case 190:
      return Words::kPlane;
    case 200:
    case 210:
      return Words::kUnits;
    case 400:
    case 410:
    case 412:
    case 413:
    case 416:
    case 420:
    case 422:
    case 426:
      return Words::kCompensation;
    case 430:
    case 434:
    case 435:
    case 440:
    case 490:
      return Words::kLength;
    case 540:
    case 550:
    case 560:
    case 570:
    case 541:
    case 580:
    case 590:
      return Words::kWorkpiece;
    case 900:
    case 910:
      return Words::kDistance;
    case 930:
    case 940:
    case 950:
      return Words::kFeedMode;
    case 980:
    case 990:
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
  high_speed_ = high_speed_ || tenths == 50;
  spindle_ = spindle_ || tenths == 960 || tenths == 970 || tenths == 1600;
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
  if (code_[kOneShot] != 100 || !has('L')) return false;
  const std::uint32_t list = whole_number((*this)['L'], 20);
  return list == 2 || list == 20;
}

bool Words::refused_in_space() const {
  return spindle_ || (high_speed_ && (!has('P') || whole_number((*this)['P'], 10000) != 10000));
}

std::size_t Words::workpiece() const {
  const Code code = code_[kWorkpiece];
  const bool additional = code == 541 || (code == 540 && has('P') && !takes_p());
  if (!additional) return static_cast<std::size_t>((code - 540) / 10);
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

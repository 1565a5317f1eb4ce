// SPDX-License-Identifier: Apache-2.0
#include "certify/kit/offsets.h"

#include <algorithm>
#include <set>

#include "certify/kit/screen.h"
#include "spec/language/decimal_order.h"

namespace toolcomp::certify::kit {
namespace {

bool equal(const spec::OffsetEntry& a, const spec::OffsetEntry& b) {
  return spec::compare(a.geometry, b.geometry) == std::strong_ordering::equal &&
         spec::compare(a.wear, b.wear) == std::strong_ordering::equal;
}

// Trailing zeros say nothing in a memory.
spec::Decimal reduced(spec::Decimal value) {
  for (; value.decimals > 0 && value.digits % 10 == 0; --value.decimals) value.digits /= 10;
  value.negative = value.negative && value.digits != 0;
  value.point = false;
  return value;
}

bool names_offset(const spec::Block& block, char address) {
  return std::ranges::any_of(block.words(), [address](const spec::Word& word) { return word.address == address; });
}

bool is_g10(const spec::Block& block) {
  return std::ranges::any_of(block.words(), [](const spec::Word& word) {
    return word.address == 'G' && word.value.digits == 10 && word.value.decimals == 0;
  });
}

// Whether the G10 of this block writes the table of D (memory C).
bool writes_d(const spec::Block& block) {
  return std::ranges::any_of(block.words(), [](const spec::Word& word) {
    return word.address == 'L' && (word.value.digits == 12 || word.value.digits == 13);
  });
}

// Calls `visit(word, d)` for the words of the block that are offset numbers.
template <class Blocks, class Visit>
void for_each_number(Blocks& blocks, Visit visit) {
  for (auto& block : blocks)
    for (std::size_t i = 0; i < block.size; ++i) {
      auto& word = block.word[i];
      if (word.address == 'H') visit(word, false);
      if (word.address == 'D') visit(word, true);
      if (word.address == 'P' && is_g10(block)) visit(word, writes_d(block));
    }
}

bool is_number(const spec::Word& word, std::uint32_t count) {
  return word.value.is_integer() && !word.value.negative && word.value.digits >= 1 && word.value.digits <= count;
}

}  // namespace

std::optional<CaseOffsets> offsets_for(const Machine& machine, const spec::Case& vector,
                                       const std::vector<spec::Block>& blocks) {
  const spec::Setup& own = vector.setup;
  const bool one_for_both = own.memory != spec::OffsetMemory::c;
  const auto entry = [&](bool d, std::uint32_t number) {
    const auto& mine = d ? own.d : own.h;
    const auto& other = d ? own.h : own.d;
    const auto found = mine.find(number);
    if (found != mine.end()) return found->second;
    const auto beside = other.find(number);
    return one_for_both && beside != other.end() ? beside->second : spec::OffsetEntry{};
  };
  CaseOffsets offsets;
  bool fits = true;
  for_each_number(blocks, [&](const spec::Word& word, bool d) {
    if (!is_number(word, machine.setup.offset_count)) return;
    const auto number = static_cast<std::uint32_t>(word.value.digits);
    for (const bool table : {false, true}) {
      // With separate tables a number is only that of its own.
      if (machine.setup.memory == spec::OffsetMemory::c && table != d) continue;
      spec::OffsetEntry value = entry(table, number);
      if (machine.setup.memory == spec::OffsetMemory::a) value = {sum(value.geometry, value.wear), {}};
      value = {reduced(value.geometry), reduced(value.wear)};
      fits = fits && fits_memory(machine.setup, value);
      (table ? offsets.d : offsets.h)[number] = value;
    }
  });
  if (!fits) return std::nullopt;
  return offsets;
}

OffsetTable::OffsetTable(const Machine& machine, std::uint32_t first)
    : first_(first), count_(machine.setup.offset_count), separate_(machine.setup.memory == spec::OffsetMemory::c) {}

std::optional<std::uint32_t> OffsetTable::place(Entries& entries, const spec::OffsetEntry& entry,
                                                const std::vector<std::uint32_t>& taken) const {
  for (std::uint32_t number = first_; number <= count_; ++number) {
    const auto found = entries.find(number);
    if (found == entries.end()) {
      entries[number] = entry;
      return number;
    }
    if (equal(found->second, entry) && std::ranges::find(taken, number) == taken.end()) return number;
  }
  return std::nullopt;
}

bool OffsetTable::take(const CaseOffsets& offsets, std::vector<spec::Block>& blocks) {
  Entries h = h_;
  Entries d = d_;
  Numbers by_h;
  Numbers by_d;
  std::vector<std::uint32_t> taken_h;
  std::vector<std::uint32_t> taken_d;
  const auto put = [](const std::optional<std::uint32_t>& at, std::uint32_t number, Numbers& numbers,
                      std::vector<std::uint32_t>& taken) {
    if (!at) return false;
    numbers[number] = *at;
    taken.push_back(*at);
    return true;
  };
  std::set<std::uint32_t> used_d;
  for_each_number(blocks, [&](const spec::Word& word, bool of_d) {
    if (of_d && is_number(word, count_)) used_d.insert(static_cast<std::uint32_t>(word.value.digits));
  });
  for (const auto& [number, entry] : offsets.h)
    if (!put(place(h, entry, taken_h), number, by_h, taken_h)) return false;
  for (const auto& [number, entry] : offsets.d) {
    const auto same = offsets.h.find(number);
    if (!separate_ && same != offsets.h.end() && equal(same->second, entry)) {
      by_d[number] = by_h.at(number);
    } else if (used_d.contains(number) || separate_) {
      if (!put(place(separate_ ? d : h, entry, separate_ ? taken_d : taken_h), number, by_d,
               separate_ ? taken_d : taken_h))
        return false;
    }
  }
  for (const spec::Block& block : blocks)
    if (!separate_ && is_g10(block) && names_offset(block, 'P') && by_h != by_d && !by_d.empty()) return false;
  for_each_number(blocks, [&](spec::Word& word, bool of_d) {
    if (!is_number(word, count_)) return;
    const Numbers& numbers = of_d ? by_d : by_h;
    word.value = spec::decimal(numbers.at(static_cast<std::uint32_t>(word.value.digits)));
  });
  h_ = std::move(h);
  d_ = std::move(d);
  return true;
}

spec::Setup with_offsets(spec::Setup machine, const std::map<std::uint32_t, spec::OffsetEntry>& h,
                         const std::map<std::uint32_t, spec::OffsetEntry>& d) {
  machine.h = h;
  machine.d = d;
  return machine;
}

spec::Decimal sum(const spec::Decimal& a, const spec::Decimal& b) {
  const std::uint8_t decimals = std::max(a.decimals, b.decimals);
  const auto scaled = [decimals](const spec::Decimal& value) {
    auto digits = static_cast<std::int64_t>(value.digits);
    for (std::uint8_t i = value.decimals; i < decimals; ++i) digits *= 10;
    return value.negative ? -digits : digits;
  };
  spec::Decimal total = spec::decimal(scaled(a) + scaled(b));
  total.decimals = decimals;
  return total;
}

std::string with_point(const spec::Decimal& value) {
  std::string text = spec::to_string(value);
  if (text.find('.') == std::string::npos) text += '.';
  const std::size_t first = value.negative ? 1 : 0;
  if (text[first] == '.') text.insert(first, 1, '0');
  return text;
}

std::string enter_offset(const spec::Setup& setup, std::uint32_t number, const spec::OffsetEntry& entry, bool d) {
  const auto block = [number](int l, const spec::Decimal& value) {
    return "G10 L" + std::to_string(l) + " P" + std::to_string(number) + " R" + with_point(value) + "\n";
  };
  switch (setup.memory) {
    case spec::OffsetMemory::a:
      return block(11, entry.geometry);
    case spec::OffsetMemory::b:
      return block(10, entry.geometry) + block(11, entry.wear);
    case spec::OffsetMemory::c:
      break;
  }
  return block(d ? 12 : 10, entry.geometry) + block(d ? 13 : 11, entry.wear);
}

}  // namespace toolcomp::certify::kit

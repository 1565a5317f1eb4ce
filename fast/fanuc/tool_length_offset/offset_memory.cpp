// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/tool_length_offset/offset_memory.h"

#include <array>
#include <charconv>
#include <string>

#include "spec/language/input_error.h"

namespace toolcomp::fast {
namespace {

constexpr std::uint32_t kMostOffsets = 99'999;  // controls have 32 to 999

// The limit 99…9 with `digits` digits, `decimals` of them behind the point (14.8, table of ranges).
Count nines(int digits, int decimals) {
  spec::Decimal limit;
  for (int i = 0; i < digits; ++i) limit.digits = limit.digits * 10 + 9;
  limit.decimals = static_cast<std::uint8_t>(decimals);
  return Count::of(limit);
}

Count entry_value(const spec::Decimal& value, char table, std::uint32_t number) {
  if (!fits_count(value))
    throw spec::InputError("setup", 0, 0,
                           std::string("offsets.") + table + "." + std::to_string(number) + ": too large");
  return Count::of(value);
}

// "H12.wear"
spec::Name name(char table, std::uint32_t number, const char* part) {
  std::array<char, 32> text{};
  text[0] = table;
  char* end = std::to_chars(text.data() + 1, text.data() + 16, number).ptr;
  for (; *part != 0; ++part) *end++ = *part;
  return std::string_view(text.data(), static_cast<std::size_t>(end - text.data()));
}

}  // namespace

OffsetMemory::OffsetMemory(const spec::Setup& setup) : kind_(setup.memory), count_(setup.offset_count) {
  if (count_ > kMostOffsets) throw spec::InputError("setup", 0, 0, "offsets.count: too large");
  const bool inch = setup.units == spec::Units::inch;
  switch (setup.increment) {
    case spec::IncrementSystem::is_a:
      geometry_limit_ = nines(5, inch ? 3 : 2);
      wear_limit_ = nines(4, inch ? 3 : 2);
      break;
    case spec::IncrementSystem::is_b:
      geometry_limit_ = nines(6, inch ? 4 : 3);
      wear_limit_ = nines(5, inch ? 4 : 3);
      break;
    case spec::IncrementSystem::is_c:
      geometry_limit_ = nines(7, inch ? 5 : 4);
      wear_limit_ = nines(6, inch ? 5 : 4);
      break;
  }
  h_.resize(count_ + 1U);
  d_.resize(count_ + 1U);
  const auto fill = [&](const auto& from, auto& to, char table) {
    for (const auto& [number, entry] : from)
      if (number >= 1 && number <= count_) {
        to[number].geometry = entry_value(entry.geometry, table, number);
        if (kind_ != spec::OffsetMemory::a) to[number].wear = entry_value(entry.wear, table, number);
      }
  };
  // Memories A and B have one table: what one letter gives counts for both, unless each gives its own.
  if (kind_ != spec::OffsetMemory::c) {
    fill(setup.d, h_, 'D');
    fill(setup.h, d_, 'H');
  }
  fill(setup.h, h_, 'H');
  fill(setup.d, d_, 'D');
}

bool OffsetMemory::has_list(std::uint32_t list) const {
  if (list == 1 || list == 11) return true;
  if (list == 10) return kind_ != spec::OffsetMemory::a;
  return kind_ == spec::OffsetMemory::c && (list == 12 || list == 13);
}

OffsetMemory::Write OffsetMemory::plan(std::uint32_t list, std::uint32_t number, const Count& value, bool add) const {
  Write write{AlarmCause::none, list, number, value, value};
  if (number == 0 || number > count_) {
    write.alarm = AlarmCause::g10_number;
    return write;
  }
  const bool wear = in_wear(list);
  const auto stored = [&](const Entry& entry) -> const Count& { return wear ? entry.wear : entry.geometry; };
  if (add) {
    write.h += stored(h_[number]);
    write.d += stored(d_[number]);
  }
  const Count& limit = wear ? wear_limit_ : geometry_limit_;
  const bool to_h = !in_d(list);
  const bool to_d = in_d(list) || kind_ != spec::OffsetMemory::c;
  if ((to_h && !within(write.h, limit)) || (to_d && !within(write.d, limit))) write.alarm = AlarmCause::g10_value;
  return write;
}

spec::Name OffsetMemory::store(const Write& write) {
  const bool wear = in_wear(write.list);
  const auto put = [&](Entry& entry, const Count& value) { (wear ? entry.wear : entry.geometry) = value; };
  if (!in_d(write.list)) put(h_[write.number], write.h);
  if (in_d(write.list) || kind_ != spec::OffsetMemory::c) put(d_[write.number], write.d);
  return name(in_d(write.list) ? 'D' : 'H', write.number,
              kind_ == spec::OffsetMemory::a ? "" : (wear ? ".wear" : ".geometry"));
}

}  // namespace toolcomp::fast

// SPDX-License-Identifier: Apache-2.0
#include "judge/laws/fanuc/offsets.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>

#include "judge/laws/numbers.h"

namespace toolcomp::judge::laws {
namespace {

constexpr std::string_view kLetters = "XYZ";

bool leaves_the_path(const FanucScene& s) { return s.program.has_code({kG53, kG28, kG29, kG30, kG30_1}); }

// Up to here the offsets are those of the setup: the first block with G10 or G37; all blocks where there is none. Where
// programs are called, blocks do not run as they stand.
std::size_t first_edit(const FanucScene& s) {
  const auto& blocks = s.program.blocks();
  const auto first =
      std::ranges::find_if(blocks, [](const FanucBlock& b) { return b.has_code(kG10) || b.has_code(kG37); });
  if (first != blocks.end() && s.program.calls()) return 0;
  return static_cast<std::size_t>(first - blocks.begin());
}

// axes - point.
std::optional<Vector> offset_of(const FanucScene& s, const Stop& stop) {
  const auto axes = xyz(s.c.setup.axes, stop.own->axes);
  const auto point = xyz(s.c.setup.axes, stop.own->point);
  if (!axes || !point) return std::nullopt;
  return *axes - *point;
}

// How many codes of group 08 the block has.
std::ptrdiff_t length_codes(const FanucBlock& b) {
  return std::ranges::count_if(std::initializer_list<int>{kG43, kG44, kG49, kG43_4, kG43_5},
                               [&](int code) { return b.has_code(code); });
}

// Which of X, Y and Z a G43 or G44 block offsets: type A, B or C.
std::array<bool, 3> offset_axes(const FanucScene& s, const FanucBlock& b) {
  if (s.c.setup.bit(5001, 0)) return {b.has('X'), b.has('Y'), b.has('Z')};
  if (!s.c.setup.bit(5001, 1)) return {false, false, true};
  return {b.plane == kG19, b.plane == kG18, b.plane == kG17};
}

bool is_last_of_its_line(const FanucScene& s, std::size_t stop) {
  return stop + 1 == s.stops.size() || s.stops[stop + 1].block != s.stops[stop].block;
}

// 1, -1; 0 where it is not certain.
int sign_of(const Real& x) { return certainly_positive(x) ? 1 : certainly_negative(x) ? -1 : 0; }

}  // namespace

void length_offset(const FanucScene& s, Holding& holding) {
  if (leaves_the_path(s)) return;
  const std::size_t end = first_edit(s);
  for (std::size_t i = 0; i < s.stops.size() && s.stops[i].block < end; ++i) {
    const Stop& stop = s.stops[i];
    const FanucBlock& b = s.block(stop);
    const auto offset = offset_of(s, stop);
    if (!offset || !is_last_of_its_line(s, i)) continue;
    if (b.length == kG49) {
      holding.zero(*offset, stop.event, "axes, less the point, without a length offset");
      continue;
    }
    if (b.drills && s.c.setup.bit(5001, 0)) continue;
    if ((b.length != kG43 && b.length != kG44) || length_codes(b) != 1 || !b.has('H') || !b.h) continue;
    const auto value = length_value(s.c.setup, *b.h);
    if (!value) continue;
    const std::array<bool, 3> given = offset_axes(s, b);
    const Real signed_value = b.length == kG43 ? Real(*value) : -Real(*value);
    for (std::size_t k = 0; k < given.size(); ++k)
      if (given.at(k)) holding.zero(offset->at(k) - signed_value, stop.event, "axis, less point and offset");
  }
}

void length_offset_stays(const FanucScene& s, Holding& holding) {
  if (leaves_the_path(s)) return;
  const std::size_t end = first_edit(s);
  for (std::size_t i = 1; i < s.stops.size() && s.stops[i].block < end; ++i) {
    const Stop& before = s.stops[i - 1];
    const Stop& stop = s.stops[i];
    if (s.program.renames(before.block, stop.block)) continue;
    bool says = before.block == stop.block;
    for (std::size_t k = before.block + 1; k <= stop.block; ++k) {
      const FanucBlock& b = s.program.blocks()[k];
      says = says || b.has('H') || length_codes(b) > 0 || b.length == kG43_4 || b.length == kG43_5;
    }
    if (says || s.block(before).length == kG43_4 || s.block(before).length == kG43_5) continue;
    const auto was = offset_of(s, before);
    const auto is = offset_of(s, stop);
    if (was && is) holding.zero(*is - *was, stop.event, "length offset, less that of the block before");
  }
}

void by_the_words_alone(const FanucScene& s, Holding& holding) {
  const auto& blocks = s.program.blocks();
  if (!s.c.setup.bit(5006, 6) ||
      std::ranges::any_of(blocks, [](const FanucBlock& b) { return b.compensation != kG40; }))
    return;
  constexpr std::array others{kG10,   kG28, kG29, kG30, kG30_1, kG37, kG39, kG43_4,
                              kG43_5, kG45, kG46, kG47, kG48,   kG52, kG53, kG92};
  const auto goes_otherwise = [&](std::size_t k) {
    const FanucBlock& b = blocks[k];
    return b.drills || b.length == kG43_4 || b.length == kG43_5 || !b.system || blocks[k - 1].system != b.system ||
           std::ranges::any_of(others, [&](int code) { return b.has_code(code); });
  };
  for (std::size_t i = 1; i < s.stops.size(); ++i) {
    if (s.stops[i].block == s.stops[i - 1].block || s.block(s.stops[i - 1]).length == kG43_4 ||
        s.block(s.stops[i - 1]).length == kG43_5)
      continue;
    bool otherwise = false;
    for (std::size_t k = s.stops[i - 1].block + 1; k <= s.stops[i].block; ++k)
      otherwise = otherwise || goes_otherwise(k);
    if (otherwise) continue;
    const FanucBlock& b = s.block(s.stops[i]);
    if (b.absolute || b.inches != (s.c.setup.units == spec::Units::inch)) continue;
    const auto before = xyz(s.c.setup.axes, s.stops[i - 1].own->axes);
    const auto after = xyz(s.c.setup.axes, s.stops[i].own->axes);
    if (!before || !after) continue;
    for (std::size_t k = 0; k < kLetters.size(); ++k) {
      const auto words = std::ranges::count(b.words, kLetters[k], &spec::Word::address);
      const spec::Decimal* word = b.value(kLetters[k]);
      if (words > 1 || (word != nullptr && !word->point)) continue;
      const Real travel = word == nullptr ? Real(0) : Real(rational(*word));
      holding.zero(after->at(k) - before->at(k) - travel, s.stops[i].event, "travel of the axis, less its word");
    }
  }
}

void signed_sums(const FanucScene& s, Holding& holding) {
  const auto compensated = [](const FanucBlock& b) { return b.compensation != kG40; };
  if (leaves_the_path(s) || s.program.has_code({kG10, kG37, kG52, kG92}) || s.names_other_points() ||
      s.c.setup.bit(5001, 2) || s.c.setup.bit(5001, 5) || std::ranges::any_of(s.program.blocks(), compensated))
    return;
  for (std::size_t i = 1; i < s.stops.size(); ++i) {
    const Stop& stop = s.stops[i];
    if (!stop.displacement || stop.block == s.stops[i - 1].block) continue;
    const FanucBlock& b = s.block(stop);
    Vector expected = s.stops[i - 1].heads.front().vector;
    constexpr std::array codes{kG45, kG46, kG47, kG48};
    constexpr std::array multiples{1, -1, 2, -2};
    int said = 0;
    int multiple = 0;
    for (std::size_t k = 0; k < codes.size(); ++k)
      if (b.has_code(codes.at(k))) {
        ++said;
        multiple = multiples.at(k);
      }
    if (said > 1) continue;
    if (said == 1) {
      if (!b.d) continue;
      const auto value = cutter_value(s.c.setup, *b.d);
      if (!value) continue;
      bool twice = false;
      for (std::size_t k = 0; k < expected.size(); ++k) {
        const char letter = kLetters[k];
        const auto words = std::ranges::count(b.words, letter, &spec::Word::address);
        twice = twice || words > 1;
        if (words != 1) continue;
        const Real& travel = stop.displacement->at(k);
        int sense = sign_of(travel);
        if (sense == 0 && !b.absolute) sense = b.value(letter)->negative ? -1 : 1;
        expected.at(k) += Real(sense * multiple) * Real(*value);
      }
      if (twice) continue;
    }
    holding.zero(stop.heads.front().vector - expected, stop.event, "shift, less the one before and the signed offset");
  }
}

void measured_difference(const FanucScene& s, Holding& holding) {
  if (s.program.has_code({kG10, kG45, kG46, kG47, kG48})) return;
  std::map<std::uint64_t, exact::Real> stored;
  const Stop* latest = nullptr;
  std::size_t next = 0;
  for (std::size_t i = 0; i < s.events.size(); ++i) {
    while (next < s.stops.size() && s.stops[next].event <= i) latest = &s.stops[next++];
    const model::Event& event = s.events[i];
    if (event.kind != spec::EventKind::setting || latest == nullptr || latest->own->line != event.line) continue;
    const FanucBlock& b = s.block(*latest);
    const std::string name(event.setting.view());
    if (!b.has_code(kG37) || !name.starts_with("H")) continue;
    const std::uint64_t number = std::stoull(name.substr(1));
    const bool wear = name.ends_with(".wear");
    if (!stored.contains(number)) {
      const spec::Setup& setup = s.c.setup;
      const auto key = static_cast<std::uint32_t>(number);
      spec::OffsetEntry entry;
      if (const auto h = setup.h.find(key); h != setup.h.end())
        entry = h->second;
      else if (const auto d = setup.d.find(key); d != setup.d.end() && setup.memory != spec::OffsetMemory::c)
        entry = d->second;
      stored[number] = Real(rational(wear ? entry.wear : entry.geometry));
    }
    const Vector& reached = latest->heads.front().vector;  // less the commanded point
    for (std::size_t k = 0; k < reached.size(); ++k)
      if (b.has(kLetters[k]))
        holding.zero(event.value - stored[number] - reached.at(k), i,
                     "new offset, less the old one and the difference measured");
    stored[number] = event.value;
  }
}

}  // namespace toolcomp::judge::laws

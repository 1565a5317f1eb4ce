// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/program/offset_memory.h"

#include <string>

#include "model/basis/alarm.h"

namespace toolcomp::model {
namespace {

// The largest value with so many digits before the point.
Rational largest(unsigned whole, const spec::Setup& setup) {
  const unsigned behind = setup.increment == spec::IncrementSystem::is_a   ? 2
                          : setup.increment == spec::IncrementSystem::is_b ? 3
                                                                           : 4;
  const unsigned inch = setup.units == spec::Units::mm ? 0 : 1;
  return {exact::power_of_ten(whole + behind) - 1, exact::power_of_ten(behind + inch)};
}

std::optional<OffsetWrite> kind_of(std::uint64_t l, spec::OffsetMemory memory) {
  const bool one_value = memory == spec::OffsetMemory::a;
  OffsetWrite write;
  write.h = l == 11 || (l == 10 && !one_value);
  write.d = memory == spec::OffsetMemory::c ? l == 12 || l == 13 : write.h;
  write.wear = !one_value && (l == 11 || l == 13);
  if (!write.h && !write.d) return std::nullopt;
  return write;
}

}  // namespace

std::optional<OffsetWrite> offset_kind(const Words& words, spec::OffsetMemory memory) {
  const spec::Decimal* const l = words.find('L');
  return kind_of(l == nullptr ? 0 : l->digits == 1 ? 11 : l->digits, memory);
}

OffsetMemory::OffsetMemory(const spec::Setup& setup, Recorder& recorder)
    : setup_(setup), recorder_(recorder), geometry_limit_(largest(3, setup)), wear_limit_(largest(2, setup)) {
  const auto fill = [this](Table& table, const std::map<std::uint32_t, spec::OffsetEntry>& from) {
    for (const auto& [number, entry] : from)
      table[number] = {plain(entry.geometry), setup_.memory == spec::OffsetMemory::a ? Rational(0) : plain(entry.wear)};
  };
  // Where H and D share their numbers, each reads its own entry where the setup gives it one.
  if (setup_.memory != spec::OffsetMemory::c) {
    fill(h_, setup.d);
    fill(d_, setup.h);
  }
  fill(h_, setup.h);
  fill(d_, setup.d);
}

OffsetMemory::Entry OffsetMemory::entry(const Table& table, std::uint32_t number) {
  const auto found = table.find(number);
  return number == 0 || found == table.end() ? Entry{} : found->second;
}

Rational OffsetMemory::applied(const Table& table, std::uint32_t number) const {
  if (number == 0) {
    // fanuc.memory.number-zero: Offset number 0 is always 0.
    recorder_.reach(Clause::fanuc_memory_number_zero);
    return 0;
  }
  const Entry offset = entry(table, number);
  const Rational value = offset[0] + offset[1];
  // fanuc.memory.value-too-large: A value beyond the geometry range of the memory raises PS0029 when a command applies
  // it. The geometry ranges are IS-A 999.99 mm, 99.999 inch; IS-B 999.999, 99.9999; IS-C 999.9999, 99.99999.
  if (recorder_.decide(Clause::fanuc_memory_value_too_large, abs(value) > geometry_limit_))
    throw Alarm(AlarmCause::offset_value);
  return value;
}

std::optional<OffsetWrite> OffsetMemory::read_write(const Words& words, const Numbers& numbers,
                                                    bool incremental) const {
  OffsetWrite write = offset_kind(words, setup_.memory).value();  // read_codes has refused others
  write.add = incremental;
  const Rational number = words.number('P', 0);
  // fanuc.memory.g10-number: P of G10 names the offset number. A number that is not whole, is 0, is beyond the memory
  // or is missing raises PS0031.
  if (!is_whole(number, 1, setup_.offset_count))
    raise(recorder_, Clause::fanuc_memory_g10_number, AlarmCause::g10_number);
  write.number = static_cast<std::uint32_t>(numerator(number));

  const spec::Decimal* const r = words.find('R');
  // fanuc.memory.g10-value: R of G10 is the value. Without R nothing is written, and on the 30i PS0031 is raised.
  if (!recorder_.decide(Clause::fanuc_memory_g10_value, r != nullptr)) {
    if (setup_.series == spec::Series::series_30i) throw Alarm(AlarmCause::g10_number);
    return std::nullopt;
  }
  write.value = numbers.length(*r);
  const Rational& limit = write.wear ? wear_limit_ : geometry_limit_;
  const bool too_large = (write.h && abs(written(h_, write)) > limit) || (write.d && abs(written(d_, write)) > limit);
  // fanuc.memory.g10-range: G10 raises PS0032 if the value that it would store is beyond the range of its store. Wear
  // ranges have one whole digit less than geometry ranges: IS-A 99.99 mm, 9.999 inch; IS-B 99.999, 9.9999; IS-C
  // 99.9999, 9.99999.
  if (recorder_.decide(Clause::fanuc_memory_g10_range, too_large)) throw Alarm(AlarmCause::g10_value);
  return write;
}

OffsetWrite OffsetMemory::measured(std::uint32_t number, const Rational& difference) const {
  OffsetWrite write = kind_of(11, setup_.memory).value();  // every memory has an L11
  // fanuc.length-measurement.store: In memory A the value itself changes, in memory B the wear value, in memory C the
  // wear value of H.
  recorder_.decide(Clause::fanuc_length_measurement_store, write.wear);
  write.add = true;
  write.number = number;
  write.value = difference;
  return write;
}

Rational OffsetMemory::written(const Table& table, const OffsetWrite& write) const {
  return write.add ? entry(table, write.number)[write.wear] + write.value : write.value;
}

OffsetSetting OffsetMemory::write(const OffsetWrite& write) {
  // fanuc.memory.g10-adds: Under G90 the value of G10 replaces the stored one, under G91 it is added.
  recorder_.decide(Clause::fanuc_memory_g10_adds, write.add);
  const Rational h = written(h_, write);
  const Rational d = written(d_, write);
  if (write.h) h_[write.number][write.wear] = h;
  if (write.d) d_[write.number][write.wear] = d;
  std::string name = (write.h ? "H" : "D") + std::to_string(write.number);
  if (setup_.memory != spec::OffsetMemory::a) name += write.wear ? ".wear" : ".geometry";
  return {spec::Name(name), write.h ? h : d, {}};
}

OffsetInForce::OffsetInForce(const spec::Setup& setup, const OffsetMemory& memory, Recorder& recorder)
    : memory_(memory), recorder_(recorder), ofh_(setup.bit(5001, 2)), evr_(setup.bit(5001, 4)) {}

std::optional<OffsetNumber> OffsetInForce::given(const Codes& codes) const {
  if (codes.d) return OffsetNumber{*codes.d, false};
  if (ofh_ && codes.h) return OffsetNumber{*codes.h, true};
  return std::nullopt;
}

OffsetNumber OffsetInForce::number_after(const Codes& codes) const { return given(codes).value_or(number_); }

bool OffsetInForce::take(const Codes& codes) {
  const auto given_here = given(codes);
  if (given_here) number_ = *given_here;
  return given_here.has_value();
}

void OffsetInForce::decide_address(const Codes& codes) const {
  // fanuc.cutter.number: The offset number is that of the last D. If OFH = 1, an H in any block gives the number as
  // well, and the value is then that of the H number. If a block has both a D and an H, the D counts.
  if (codes.h && !codes.d) recorder_.decide(Clause::fanuc_cutter_number, ofh_);
}

const Rational& OffsetInForce::value(bool taken_anew) {
  // fanuc.cutter.value-edited: The value in force is the one that the memory held in the last block in which the number
  // was given (even if it was the same number again), or in which G41 or G42 came into force after G40.
  if (recorder_.decide(Clause::fanuc_cutter_value_edited, taken_anew || evr_)) value_ = memory_.value(number_);
  return value_;
}

CutterOffset offset_of(Recorder& recorder, CutterSide side, const Rational& value) {
  const int of_code = side == CutterSide::left ? 1 : -1;
  const Rational distance = abs(value);
  // fanuc.cutter.side: G41 with a positive value and G42 with a negative value offset to the left of the movement, and
  // the other two cases to the right. A negative value thus exchanges G41 and G42.
  const Sign decided = recorder.decide(Clause::fanuc_cutter_side, Rational(of_code * value), distance);
  return {decided == Sign::zero ? of_code : static_cast<int>(decided), distance, value};
}

}  // namespace toolcomp::model

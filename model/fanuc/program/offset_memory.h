// SPDX-License-Identifier: Apache-2.0
// Tool offset memory and G10. The offset number of the cutter, and the value of it that is in force: in every
// compensation that runs beside the path.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>

#include "model/basis/number.h"
#include "model/basis/recorder.h"
#include "model/fanuc/program/codes.h"
#include "spec/language/name.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// What G10 asks for, checked: one value of one number.
struct OffsetWrite {
  bool h = false;  // the table that H reads
  bool d = false;  // the table that D reads
  bool wear = false;
  bool add = false;  // G91
  std::uint32_t number = 0;
  Rational value;
};

// One entry as it now is, for the event.
struct OffsetSetting {
  spec::Name name;           // "H1", "D7.wear"
  Rational value;            // setup units
  spec::ClauseList clauses;  // applied in writing it
};

// Which table and value the L of G10 names, or nothing if this memory has no such L. Number and value are not read.
std::optional<OffsetWrite> offset_kind(const Words& words, spec::OffsetMemory memory);

// An offset number and the table it reads.
struct OffsetNumber {
  std::uint32_t number = 0;
  bool of_h = false;  // it came with H
};

// Offsets by number, setup units. Number 0 is always 0. Memory A has one value a number, B geometry and wear, both
// shared by H and D; C has geometry and wear for each. Clauses: fanuc.memory.*.
class OffsetMemory {
 public:
  OffsetMemory(const spec::Setup& setup, Recorder& recorder);

  // Geometry and wear together, as a command applies it. Throws Alarm PS0029 if it is beyond what the geometry store
  // could hold.
  [[nodiscard]] Rational h(std::uint32_t number) const { return applied(h_, number); }
  [[nodiscard]] Rational d(std::uint32_t number) const { return applied(d_, number); }
  [[nodiscard]] Rational value(const OffsetNumber& of) const { return of.of_h ? h(of.number) : d(of.number); }

  // The G10 block; throws Alarm PS0031 or PS0032. Nothing is written yet.
  [[nodiscard]] std::optional<OffsetWrite> read_write(const Words& words, const Numbers& numbers,
                                                      bool incremental) const;
  // What a measured difference is added to: as G10 L11 would for H.
  [[nodiscard]] OffsetWrite measured(std::uint32_t number, const Rational& difference) const;
  // Writes, and says what stands there now.
  OffsetSetting write(const OffsetWrite& write);

 private:
  using Entry = std::array<Rational, 2>;  // geometry, wear
  using Table = std::map<std::uint32_t, Entry>;

  [[nodiscard]] static Entry entry(const Table& table, std::uint32_t number);
  [[nodiscard]] Rational applied(const Table& table, std::uint32_t number) const;
  [[nodiscard]] Rational written(const Table& table, const OffsetWrite& write) const;

  const spec::Setup& setup_;
  Recorder& recorder_;
  Rational geometry_limit_;
  Rational wear_limit_;
  Table h_;
  Table d_;
};

// Follows the number through the program. Clauses: fanuc.cutter.number, fanuc.cutter.value-edited.
class OffsetInForce {
 public:
  // Parameters 5001#2 and 5001#4.
  OffsetInForce(const spec::Setup& setup, const OffsetMemory& memory, Recorder& recorder);

  [[nodiscard]] const OffsetNumber& number() const { return number_; }
  // The number in force at the end of a block with these codes.
  [[nodiscard]] OffsetNumber number_after(const Codes& codes) const;
  // Takes the number of a block; whether it gives one.
  bool take(const Codes& codes);
  // Decides whether the H of a block without D gives the number.
  void decide_address(const Codes& codes) const;
  // The value at the end of a block, setup units, with its sign. `taken_anew`: the block gives a number, or brings
  // compensation into force. Throws Alarm PS0029.
  const Rational& value(bool taken_anew);

 private:
  // From the address that counts.
  [[nodiscard]] std::optional<OffsetNumber> given(const Codes& codes) const;

  const OffsetMemory& memory_;
  Recorder& recorder_;
  bool ofh_;  // 5001#2: H numbers count too
  bool evr_;  // 5001#4: an edited value counts from the next block on
  OffsetNumber number_;
  Rational value_;  // of the number in force, as it was when it was taken
};

// G40, G41, G42: where the tool runs, seen in the direction of travel.
enum class CutterSide : std::uint8_t { none, left, right };

struct CutterOffset {
  int side = 1;  // 1 left of the path, -1 right
  Rational distance;
  Rational value;  // as the memory has it, with its sign

  [[nodiscard]] Rational left() const { return side * distance; }
};

// Where a side is in force. A value of 0 has the side of a positive one. Clause: fanuc.cutter.side.
CutterOffset offset_of(Recorder& recorder, CutterSide side, const Rational& value);

}  // namespace toolcomp::model

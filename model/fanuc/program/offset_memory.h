// SPDX-License-Identifier: Apache-2.0
// Tool offset memory and G10.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

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
std::optional<OffsetWrite> offset_kind(std::uint64_t l, spec::OffsetMemory memory);

// Offsets by number, setup units. Number 0 is always 0. Memory A has one value a number, B geometry and wear, both
// shared by H and D; C has geometry and wear for each. Clauses: fanuc.memory.*.
class OffsetMemory {
 public:
  OffsetMemory(const spec::Setup& setup, Recorder& recorder);

  // Geometry and wear together, as a command applies it. Throws Alarm PS0029 if it is beyond what the geometry store
  // could hold.
  [[nodiscard]] Rational h(std::uint32_t number) const { return applied(h_, number); }
  [[nodiscard]] Rational d(std::uint32_t number) const { return applied(d_, number); }

  // The G10 block; throws Alarm PS0031 or PS0032. Nothing is written yet.
  [[nodiscard]] std::optional<OffsetWrite> read_write(const Words& words, const Numbers& numbers,
                                                      bool incremental) const;
  // What a measured difference is added to: as G10 L11 would for H.
  [[nodiscard]] OffsetWrite measured(std::uint32_t number, const Rational& difference) const;
  // Writes, and says what stands there now.
  OffsetSetting write(const OffsetWrite& write);

 private:
  struct Entry {
    Rational geometry;
    Rational wear;
    [[nodiscard]] const Rational& part(bool is_wear) const { return is_wear ? wear : geometry; }
    [[nodiscard]] Rational& part(bool is_wear) { return is_wear ? wear : geometry; }
  };
  using Table = std::map<std::uint32_t, Entry>;

  [[nodiscard]] static Entry entry(const Table& table, std::uint32_t number);
  [[nodiscard]] Rational applied(const Table& table, std::uint32_t number) const;
  [[nodiscard]] Rational written(const Table& table, const OffsetWrite& write) const;

  Recorder& recorder_;
  spec::OffsetMemory kind_;
  spec::Series series_;
  std::uint32_t count_;
  Rational geometry_limit_;
  Rational wear_limit_;
  Table h_;
  Table d_;
};

}  // namespace toolcomp::model

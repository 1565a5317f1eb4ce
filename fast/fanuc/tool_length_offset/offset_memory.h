// SPDX-License-Identifier: Apache-2.0
// Tool offset memory A, B, C (chapter 14.8).
#pragma once

#include <cstdint>
#include <vector>

#include "fast/arithmetic/count.h"
#include "fast/basis/alarm.h"
#include "spec/language/name.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// Values in setup units, exact.
class OffsetMemory {
 public:
  // Throws spec::InputError for more offsets than a control has, and for values no control could hold.
  explicit OffsetMemory(const spec::Setup& setup);

  [[nodiscard]] std::uint32_t count() const { return count_; }
  // Geometry plus wear; 0 for number 0 and for numbers never set. `number` is at most count().
  [[nodiscard]] Count h(std::uint32_t number) const { return h_[number].geometry + h_[number].wear; }
  [[nodiscard]] Count d(std::uint32_t number) const { return d_[number].geometry + d_[number].wear; }
  // Whether an effective value is within the range of the memory.
  [[nodiscard]] bool fits(const Count& value) const { return within(value, geometry_limit_); }

  // Whether this memory has the L of a G10 block: A L11; B L10 geometry, L11 wear; C L10 to L13; L1 is L11.
  [[nodiscard]] bool has_list(std::uint32_t list) const;
  // One G10 write, checked: what it would store and where.
  struct Write {
    Alarm alarm;  // PS0031, PS0032
    std::uint32_t list = 0;
    std::uint32_t number = 0;
    Count h;  // of the H table, or the one table of memories A and B
    Count d;  // of the D table: differs from h only where a setup gave both in memory A or B
  };
  // G10 L P R: `value` replaces the stored one, or is added to it.
  [[nodiscard]] Write plan(std::uint32_t list, std::uint32_t number, const Count& value, bool add) const;
  // Stores a plan without alarm; the name of what was set: "H1", "D2.wear".
  spec::Name store(const Write& write);
  // The value that a plan stores, for its event.
  [[nodiscard]] const Count& value(const Write& write) const { return in_d(write.list) ? write.d : write.h; }
  // Whether the plan changes what h() gives.
  [[nodiscard]] bool changes_h(const Write& write) const { return !in_d(write.list); }

 private:
  struct Entry {
    Count geometry;
    Count wear;
  };
  [[nodiscard]] static bool within(const Count& value, const Count& limit) {
    return !(limit < value) && !(value < -limit);
  }

  [[nodiscard]] bool in_d(std::uint32_t list) const { return kind_ == spec::OffsetMemory::c && list >= 12; }
  [[nodiscard]] bool in_wear(std::uint32_t list) const {
    return kind_ != spec::OffsetMemory::a && (list == 1 || list == 11 || list == 13);
  }

  spec::OffsetMemory kind_;
  std::uint32_t count_;
  Count geometry_limit_;
  Count wear_limit_;
  std::vector<Entry> h_;
  std::vector<Entry> d_;
};

}  // namespace toolcomp::fast

// SPDX-License-Identifier: Apache-2.0
// The table of offsets that all cases of a kit share, and the numbers of their programs in it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "certify/kit/machine.h"
#include "spec/language/case.h"
#include "spec/language/fanuc/block.h"

namespace toolcomp::certify::kit {

// The offsets of a case as a control of this memory reads them, by the numbers of the case.
struct CaseOffsets {
  // By the numbers that the program names, except 0 and those beyond the memory.
  std::map<std::uint32_t, spec::OffsetEntry> h, d;
};

// The offsets of the vector for this machine. With memory A, geometry and wear are one value. A number that only one
// table of a vector with memory A or B gives counts for both. std::nullopt if an entry cannot be typed into the memory.
std::optional<CaseOffsets> offsets_for(const Machine& machine, const spec::Case& vector,
                                       const std::vector<spec::Block>& blocks);

class OffsetTable {
 public:
  // Numbers from `first` on are used.
  OffsetTable(const Machine& machine, std::uint32_t first);

  // Gives every number of the case a number of the table whose entry has its value, a different one for each number of
  // the case, and rewrites H, D and the P of G10 in the blocks. False, with nothing changed, if the table is full, or
  // if a G10 of memory A or B writes a number that H and D read differently.
  bool take(const CaseOffsets& offsets, std::vector<spec::Block>& blocks);

  [[nodiscard]] const std::map<std::uint32_t, spec::OffsetEntry>& h() const { return h_; }
  [[nodiscard]] const std::map<std::uint32_t, spec::OffsetEntry>& d() const { return separate_ ? d_ : h_; }
  // Memory C: H and D have separate tables.
  [[nodiscard]] bool separate() const { return separate_; }

 private:
  using Entries = std::map<std::uint32_t, spec::OffsetEntry>;
  using Numbers = std::map<std::uint32_t, std::uint32_t>;
  std::optional<std::uint32_t> place(Entries& entries, const spec::OffsetEntry& entry,
                                     const std::vector<std::uint32_t>& taken) const;

  std::uint32_t first_;
  std::uint32_t count_;
  bool separate_;
  Entries h_, d_;
};

// The machine with these offsets in place of its own.
spec::Setup with_offsets(spec::Setup machine, const std::map<std::uint32_t, spec::OffsetEntry>& h,
                         const std::map<std::uint32_t, spec::OffsetEntry>& d);

// The exact sum of decimals, such as offsets and positions have.
spec::Decimal sum(const spec::Decimal& a, const spec::Decimal& b);

// The number with a point, as a control reads it whatever 3401#0 is: "-4.", "0.5".
std::string with_point(const spec::Decimal& value);

// G10 blocks that enter one entry (fanuc.memory.g10-kind), one or two lines with line feeds. `d`: of the D table.
std::string enter_offset(const spec::Setup& setup, std::uint32_t number, const spec::OffsetEntry& entry, bool d);

}  // namespace toolcomp::certify::kit

// SPDX-License-Identifier: Apache-2.0
// Which vectors could be run on a machine at all: what their words say.
#pragma once

#include <string>
#include <vector>

#include "certify/kit/machine.h"
#include "spec/language/case.h"
#include "spec/language/fanuc/block.h"

namespace toolcomp::certify::kit {

struct Screened {
  std::vector<spec::Block> blocks;  // as they go to the machine: without comments, and without M02 or M30 at the end
  std::string why;                  // why it stays at home; empty: it may go
};

// Refuses, with the reason, what no kit sends to a machine: spindle, coolant and all other M, S and T words; words made
// at random; numbers finer than the machine's increments; codes that leave traces (G20 or G21, G92, other workpiece
// systems); references, probes and feeds that the machine does not have.
Screened screen(const Machine& machine, const spec::Case& vector);

// Digits behind the point that the machine's increment system has, of lengths in its units or of degrees.
int decimals_of(const spec::Setup& setup, bool length);
// Whether the decimal has no more digits behind the point than that, trailing zeros aside.
bool is_enterable(const spec::Decimal& value, int decimals);

// Whether an entry can be typed into the offset memory: its digits, and the ranges of fanuc.memory.g10-range.
bool fits_memory(const spec::Setup& setup, const spec::OffsetEntry& entry);

}  // namespace toolcomp::certify::kit

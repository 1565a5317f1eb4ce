// SPDX-License-Identifier: Apache-2.0
// Decides by their words which vectors could be run on a machine at all.
#pragma once

#include <string>
#include <vector>

#include "certify/kit/machine.h"
#include "spec/language/case.h"
#include "spec/language/fanuc/block.h"

namespace toolcomp::certify::kit {

struct Screened {
  std::vector<spec::Block> blocks;  // for the machine: without comments, and without M02 or M30 at the end
  std::string why;                  // why it is left out; empty if it may be used
};

// Refuses, with the reason, programs that no kit sends to a machine: with spindle, coolant or any other M, S or T word;
// with random words; with numbers finer than the least increment of the machine; with codes that leave traces (G20 or
// G21, G92, other workpiece systems); with reference positions, probes and feeds that the machine does not have.
Screened screen(const Machine& machine, const spec::Case& vector);

// The number of digits after the point in the increment system of the machine, for lengths in its units or for degrees.
int decimals_of(const spec::Setup& setup, bool length);
// Whether the decimal, without trailing zeros, has at most this number of digits after the point.
bool is_enterable(const spec::Decimal& value, int decimals);

// Whether an entry can be typed into the offset memory: its digits, and the ranges of fanuc.memory.g10-range.
bool fits_memory(const spec::Setup& setup, const spec::OffsetEntry& entry);

}  // namespace toolcomp::certify::kit

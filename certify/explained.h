// SPDX-License-Identifier: Apache-2.0
// What happens in each block of a program, and why: decisions with their exact values, events of both engines.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "certify/input/program.h"
#include "fast/basis/event.h"
#include "model/basis/event.h"
#include "model/basis/recorder.h"

namespace toolcomp::certify {

struct ExplainedEvent {
  model::Event event;
  std::string measured;  // of G37, in words (block_words.h); empty: no such move
  std::string corner;    // after an own move, in words; empty: no vector there
};

struct ExplainedBlock {
  std::uint64_t line = 0;  // where it begins
  std::optional<std::uint64_t> n;
  std::string text;                        // as read
  std::vector<model::Decision> decisions;  // by sign, in their order
  std::vector<ExplainedEvent> exact;
  std::vector<fast::Event> fast;

  // The clauses of an event that no decision of the block shows already.
  [[nodiscard]] std::vector<spec::Clause> other_clauses(const ExplainedEvent& event) const;
};

// The blocks of a program in its order, or those alone with the sequence number `block`, or where no block has it those
// on that line. Numbers in words have `digits` decimals. Throws spec::InputError for what is no text of a program, and
// where no block is `block`.
std::vector<ExplainedBlock> explain_blocks(const input::Program& program, std::optional<std::uint64_t> block,
                                           int digits);

}  // namespace toolcomp::certify

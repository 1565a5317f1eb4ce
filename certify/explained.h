// SPDX-License-Identifier: Apache-2.0
// Explains what happens in each block of a program, and why: decisions with their exact values, events of both engines.
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
  std::string measured;  // for G37, in words (block_words.h); otherwise empty
  std::string corner;    // after an own move, in words; empty if there is no vector
};

struct ExplainedBlock {
  std::uint64_t line = 0;  // where it begins
  std::optional<std::uint64_t> n;
  std::string text;                        // as read
  std::vector<model::Decision> decisions;  // decisions by sign, in order
  std::vector<ExplainedEvent> exact;
  std::vector<fast::Event> fast;

  // The clauses of an event that are not among the decisions of the block.
  [[nodiscard]] std::vector<spec::Clause> other_clauses(const ExplainedEvent& event) const;
};

// The blocks of a program in order, or only the blocks with the sequence number `block`, or, if no block has it, the
// blocks on that line. Numbers in words have `digits` decimals. Throws spec::InputError if the text is not the text of
// a program, and if there is no such `block`.
std::vector<ExplainedBlock> explain_blocks(const input::Program& program, std::optional<std::uint64_t> block,
                                           int digits);

}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
// A program run by both engines side by side, block by block in the order in which blocks run: what its page shows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fast/basis/event.h"
#include "model/basis/event.h"
#include "model/basis/recorder.h"
#include "spec/language/case.h"

namespace toolcomp::certify {

struct ProgramRun {
  // A block that was read. One that runs again is there again.
  struct Block {
    std::uint64_t line = 0;  // of the text, where it begins
    std::optional<std::uint64_t> n;
    std::uint64_t fault_line = 0;  // where an alarm of it points to
    std::uint64_t fault_column = 1;
  };
  std::vector<Block> blocks;

  // What the engines gave, in order, and the block each event belongs to: the latest read that begins in its line.
  std::vector<model::Event> events;
  std::vector<std::size_t> block_of;  // by event
  std::vector<fast::Event> fast;
  std::vector<std::size_t> block_of_fast;

  // Decisions by sign, in order, and their blocks.
  std::vector<model::Decision> decisions;
  std::vector<std::size_t> block_of_decision;

  bool undecided = false;  // an event was left undecided
};

// Runs the case. `file` stands for the program in messages; `on_block` is called before each block, and may throw to
// end it. Throws spec::InputError for what is no text of a program, and for a setup that no control could have.
ProgramRun run_program(const spec::Case& c, const std::string& file, const std::function<void()>& on_block);

}  // namespace toolcomp::certify

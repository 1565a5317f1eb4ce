// SPDX-License-Identifier: Apache-2.0
// Runs a program with both engines in parallel, block by block in the order in which blocks run, for its page.
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
  // A block that was read. A block that runs several times is listed several times.
  struct Block {
    std::uint64_t line = 0;  // line of the text in which it begins
    std::optional<std::uint64_t> n;
    std::uint64_t fault_line = 0;  // line to which an alarm of the block points
    std::uint64_t fault_column = 1;
  };
  std::vector<Block> blocks;

  // The events of the engines, in order, and the block that each event belongs to: the block read last that begins in
  // its line.
  std::vector<model::Event> events;
  std::vector<std::size_t> block_of;  // by event
  std::vector<fast::Event> fast;
  std::vector<std::size_t> block_of_fast;

  // Decisions by sign, in order, and their blocks.
  std::vector<model::Decision> decisions;
  std::vector<std::size_t> block_of_decision;

  bool undecided = false;  // an event was left undecided
};

// Runs the case. `file` is the name of the program in messages. `on_block` is called before each block, and may throw
// to end the run. Throws spec::InputError if the text is not the text of a program, and for a setup that no control
// could have.
ProgramRun run_program(const spec::Case& c, const std::string& file, const std::function<void()>& on_block);

}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
// Compensation of millions of lines, for CAM systems, post processors and simulators: from arrays of words to arrays of
// axis positions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "fast/arrays/instructions.h"
#include "fast/arrays/moves.h"
#include "fast/basis/event.h"
#include "spec/language/setup.h"

namespace toolcomp::fast {

// One word of many blocks. The word is the decimal nearest to the value with this number of places, as a post processor
// prints it: value * 10^decimals, rounded to a whole number (ties to even).
struct WordColumn {
  std::string_view word;           // a letter; for vectors of Klartext NX NY NZ TX TY TZ
  std::span<const double> values;  // mm or inch, degrees
  unsigned decimals = 3;           // at most 9
};

// A program that is given in parts: blocks as text, and lines as arrays. Its moves are bit for bit those of the
// streaming engine on the same blocks. Usual corners are computed many at a time, others one by one.
class Batch {
 public:
  // `others` takes the events other than moves: alarms, warnings, settings, holes. Throws spec::InputError for a setup
  // that the control could not have.
  explicit Batch(const spec::Setup& setup, EventSink* others = nullptr,
                 Instructions instructions = best_instructions());
  ~Batch();
  Batch(const Batch&) = delete;
  Batch& operator=(const Batch&) = delete;

  // Runs blocks given as the text of a program: modes, offsets, start-up and cancel. Throws spec::InputError if the
  // text cannot be the text of a program.
  void run(std::string_view text);
  // Runs one block for each index of the columns. A block has all the words, and the modes in force. In a Klartext
  // program it is an LN block if there are vectors, otherwise an L block. Throws std::invalid_argument, and runs
  // nothing, for columns of different lengths, a word that is given twice or that the control does not have, values
  // beyond 10^9 or that are not numbers, vectors that are 0 or reach 10.
  void lines(std::span<const WordColumn> columns);
  // Ends the program: gives the moves that are still held.
  void end();

  // Whether the program has ended or raised an alarm. Later blocks are ignored.
  [[nodiscard]] bool stopped() const;
  // The moves so far. They may be cleared at any time.
  [[nodiscard]] Moves& moves();
  // Blocks taken so far, and how many of them as arrays.
  [[nodiscard]] std::uint64_t blocks() const;
  [[nodiscard]] std::uint64_t blocks_as_arrays() const;

 private:
  class Run;
  std::unique_ptr<Run> run_;
};

}  // namespace toolcomp::fast

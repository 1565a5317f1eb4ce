// SPDX-License-Identifier: Apache-2.0
// Lines by the million: arrays of words in, arrays of axis positions out. What CAM systems, post processors and
// simulators call.
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

// One word of many blocks. Each is the decimal of so many places that is nearest to the value, as a post processor
// prints it: value * 10^decimals, rounded to a whole number (ties to even).
struct WordColumn {
  std::string_view word;           // a letter; Klartext vectors: NX NY NZ TX TY TZ
  std::span<const double> values;  // mm or inch, degrees
  unsigned decimals = 3;           // at most 9
};

// A program in parts: blocks as text, and lines as arrays. Its moves are those of the streaming engine on the same
// blocks, bit for bit: usual corners are computed many at a time, others one by one.
class Batch {
 public:
  // `others`: takes the events that are no moves: alarms, warnings, settings, holes. Throws spec::InputError for a
  // setup the control could not have.
  explicit Batch(const spec::Setup& setup, EventSink* others = nullptr,
                 Instructions instructions = best_instructions());
  ~Batch();
  Batch(const Batch&) = delete;
  Batch& operator=(const Batch&) = delete;

  // Blocks as a program has them: modes, offsets, start-up and cancel. Throws spec::InputError for what is no text of a
  // program.
  void run(std::string_view text);
  // As many blocks as the columns have values, each of all their words, under the modes in force: in a Klartext program
  // LN blocks where there are vectors, else L. Throws std::invalid_argument, and nothing is done: columns of different
  // lengths, a word twice or none the control has, values beyond 10^9 or that are no numbers, vectors that are 0 or
  // reach 10.
  void lines(std::span<const WordColumn> columns);
  // The end of the program: what is held goes out.
  void end();

  // An alarm or the end of the program: what comes is ignored.
  [[nodiscard]] bool stopped() const;
  // So far. May be cleared at any time.
  [[nodiscard]] Moves& moves();
  // Blocks taken so far, and how many of them as arrays.
  [[nodiscard]] std::uint64_t blocks() const;
  [[nodiscard]] std::uint64_t blocks_as_arrays() const;

 private:
  class Run;
  std::unique_ptr<Run> run_;
};

}  // namespace toolcomp::fast

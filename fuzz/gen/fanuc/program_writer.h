// SPDX-License-Identifier: Apache-2.0
// Writes program text block by block and keeps count of where the program stands.
#pragma once

#include <map>
#include <string>

#include "fuzz/gen/choices.h"
#include "fuzz/gen/fanuc/tool_direction.h"
#include "spec/language/setup.h"

namespace toolcomp::fuzz {

// Numbers are counts of the least increment. Positions follow what the program commands; after blocks that shift the
// coordinate system they are only near, which generators may not rely on.
class ProgramWriter {
 public:
  ProgramWriter(Choices& choose, const spec::Setup& setup);

  // Words of the block being written.
  ProgramWriter& word(std::string_view text);
  // A linear or rotary axis word that moves by `counts`, absolute or incremental as the mode is.
  ProgramWriter& axis(char letter, std::int64_t counts);
  // The number as written: with a point, or without one where that means the same.
  ProgramWriter& number(char address, std::int64_t counts);
  // In some programs G20 or G21, which may be other units than those of the setup: lengths are converted from there on.
  void units();
  // In some the other of the two from here on: what was written before stands in units that are finer, or coarser, than
  // what follows.
  void switch_units();
  // Counts of the setup as counts of the program.
  [[nodiscard]] std::int64_t in_program(std::int64_t counts) const;
  // Ends the block; nothing happens without words.
  void end_block();

  void incremental(bool on) { incremental_ = on; }
  [[nodiscard]] bool incremental() const { return incremental_; }
  // Forgets the rounding of `counts` to the whole: counts of one millimetre (inch, degree).
  [[nodiscard]] std::int64_t one() const { return one_; }
  [[nodiscard]] std::int64_t at(char letter) const;
  void place(char letter, std::int64_t counts) { position_[letter] = counts; }
  [[nodiscard]] Pose pose() const;
  [[nodiscard]] const spec::Setup& setup() const { return setup_; }
  [[nodiscard]] std::uint32_t blocks() const { return blocks_; }
  // With the programs that it calls behind it.
  [[nodiscard]] std::string text() const { return text_ + called_; }

 private:
  // What post processors write between the blocks: modes, cancels, coordinate systems.
  void idle_words();
  // Of the setup to the program.
  void convert_positions();

  Choices& choose_;
  const spec::Setup& setup_;
  std::map<char, std::int64_t> position_;
  std::string text_;
  std::string block_;
  std::int64_t one_ = 1;
  int decimals_ = 0;
  bool counts_without_point_ = false;  // 3401#0 = 0
  bool incremental_ = false;
  bool numbered_ = false;
  bool other_units_ = false;
  bool idles_ = false;    // has words that change no path
  bool calls_ = false;    // some of its blocks stand in programs of their own
  bool renames_ = false;  // has G52, G54.1, G10 L2 L20
  std::uint32_t called_programs_ = 0;
  std::string called_;
  std::uint32_t blocks_ = 0;
};

}  // namespace toolcomp::fuzz

// SPDX-License-Identifier: Apache-2.0
// What the words of a FANUC program say of a block, as far as laws ask: modal codes and numbers in force. Read anew
// from the text; nothing here knows a rule of compensation. Of canned cycles it knows what a manual for operators says:
// a code of a cycle (G73 G74 G76 G81 to G89) starts the drilling mode, G80 and every code of group 01 end it, and while
// it is on a word of an axis moves nothing: it is the position of a hole, or its bottom.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <vector>

#include "model/exact/real.h"
#include "spec/language/case.h"
#include "spec/language/fanuc/block.h"
#include "spec/language/fanuc/g_codes.h"

namespace toolcomp::judge::laws {

using enum spec::GCode;

// Those of G54 to G59.
inline constexpr int kSystems = 6;

// Ten times the number of a G code; -1 for a number that is no code.
int code_of(const spec::Decimal& d);

// A length that a block of a canned cycle gave, R or the word of the drilling axis: it keeps the meaning that it had
// there.
struct CycleLength {
  spec::Decimal value;
  bool absolute = true;
  bool inches = false;
};

// The drilling mode behind a block.
struct DrillingMode {
  std::size_t begun = 0;  // index of the block that started it
  int cycle = 0;
  char axis = 'Z';  // the drilling axis: Z, or with 5101#0 = 1 the one at right angles to the plane
  // Given last since the mode began. Nothing where there was none, where it stood twice in a block, where G20, G21, G52
  // or G92 came since, or where it is absolute and coordinates may have been renamed since.
  std::optional<CycleLength> point_r;
  std::optional<CycleLength> bottom;
  // Nothing makes it doubtful whether the mode is on and what its axis is: G80 beside a code of a cycle, another plane
  // with 5101#0 = 1, compensation, a code of a cycle beside one that takes the letters of its block, or G28 to G30,
  // G31, G37, G39, G43.4, G43.5 and G53 in the mode.
  bool clear = true;
};

// One block. Codes are ten times the number behind G: 412 is G41.2.
struct FanucBlock {
  std::uint64_t line = 0;
  std::vector<spec::Word> words;  // without those that G04 or G10 takes as data
  int compensation = kG40;        // group 07 behind the block
  int motion = kG00;              // group 01
  int plane = kG17;
  int length = kG49;     // group 08
  bool absolute = true;  // G90
  bool inches = false;   // G20
  std::optional<std::uint64_t> d;
  std::optional<std::uint64_t> h;
  // Workpiece system in force: 1 to 6 for G54 to G59, from 7 on for those of G54.1; nothing where P of G54.1 may be
  // another code's.
  std::optional<int> system = 1;
  bool posture = false;  // P1 of the last G43.4 or G43.5, or what 19604#0 stands for
  std::optional<DrillingMode> drilling;
  bool drills = false;      // in the mode, with a word of an axis or R: they are data of a hole
  bool to_point_r = false;  // G99

  [[nodiscard]] bool has(char address) const;
  [[nodiscard]] bool has_code(int code) const;
  [[nodiscard]] const spec::Decimal* value(char address) const;  // of the last such word
  // How often a block that drills does so: K, without it L, without both once. Nothing where a control may refuse it.
  [[nodiscard]] std::optional<std::uint64_t> repeats() const;
  // A code of a canned cycle beside one of group 01, which cancels it.
  [[nodiscard]] bool cancels_its_cycle() const;
  // A word of group 07.
  [[nodiscard]] bool says_compensation() const;
  // Nothing but movement, its kind and dimension, feed and vectors, and words of group 07; not in the drilling mode.
  [[nodiscard]] bool is_plain() const;
};

class FanucProgram {
 public:
  // Empty where the control is another.
  explicit FanucProgram(const spec::Case& c);

  [[nodiscard]] const std::vector<FanucBlock>& blocks() const { return blocks_; }
  // Index of the only block in this line; size of the list where there is none, or a second one (events name lines), or
  // programs are called.
  [[nodiscard]] std::size_t index(std::uint64_t line) const;
  // Whether any block has one of these codes.
  [[nodiscard]] bool has_code(std::initializer_list<int> codes) const;
  // Whether coordinates may be renamed in the blocks behind `from`, up to and including `to` (indices), or holes
  // drilled there: a position before does not subtract from one after.
  [[nodiscard]] bool renames(std::size_t from, std::size_t to) const;
  // Whether coordinates may be renamed in this block; not by G49 as the end of G43.4.
  [[nodiscard]] bool renames_at(std::size_t block) const;
  // Programs are called: blocks run in another order than they stand.
  [[nodiscard]] bool calls() const { return calls_; }
  // Any block stands in the drilling mode.
  [[nodiscard]] bool drills() const { return drills_; }
  // Every block was read.
  [[nodiscard]] bool complete() const { return complete_; }

 private:
  void follow_drilling(FanucBlock& state, const spec::Setup& setup, bool takes_letters);
  [[nodiscard]] bool renames_in(const FanucBlock& b) const;

  std::vector<FanucBlock> blocks_;
  bool drills_ = false;
  bool complete_ = false;
  bool calls_ = false;
  bool length_renames_ = false;  // 5006#6 = 1: a length offset shifts the coordinate system
  bool any_block_may_ = false;   // and with 5001#6 = 1 any block may bring one into force
};

// A word of a linear axis, or R of a hole, in the units of the program: without a point it may be in least increments
// (3401#0 = 0). And in those of the setup.
exact::Rational programmed_length(const spec::Setup& setup, bool inches, const spec::Decimal& word);
exact::Rational length_of(const spec::Setup& setup, bool inches, const spec::Decimal& word);

// Offsets as they stand in the setup, setup units; nothing where the number is none.
std::optional<exact::Rational> length_value(const spec::Setup& setup, std::uint64_t number);
std::optional<exact::Rational> cutter_value(const spec::Setup& setup, std::uint64_t number);

}  // namespace toolcomp::judge::laws

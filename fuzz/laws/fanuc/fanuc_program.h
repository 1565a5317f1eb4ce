// SPDX-License-Identifier: Apache-2.0
// What the words of a FANUC program say of a block, as far as laws ask: modal codes and numbers in force. Read anew
// from the text; nothing here knows a rule of compensation.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <vector>

#include "model/exact/real.h"
#include "spec/language/case.h"
#include "spec/language/fanuc/block.h"

namespace toolcomp::fuzz::laws {

// Those of G54 to G59.
inline constexpr int kSystems = 6;

// Ten times the number of a G code; -1 for a number that is no code.
int code_of(const spec::Decimal& d);

// One block. Codes are ten times the number behind G: 412 is G41.2.
struct FanucBlock {
  std::uint64_t line = 0;
  std::vector<spec::Word> words;  // without those that G04 or G10 takes as data
  int compensation = 400;         // group 07 behind the block
  int motion = 0;                 // group 01
  int plane = 170;
  int length = 490;      // group 08
  bool absolute = true;  // G90
  bool inches = false;   // G20
  std::optional<std::uint64_t> d;
  std::optional<std::uint64_t> h;
  // Workpiece system in force: 1 to 6 for G54 to G59, from 7 on for those of G54.1; nothing where P of G54.1 may be
  // another code's.
  std::optional<int> system = 1;
  bool posture = false;  // P1 of the last G43.4 or G43.5, or what 19604#0 stands for

  [[nodiscard]] bool has(char address) const;
  [[nodiscard]] bool has_code(int code) const;
  [[nodiscard]] const spec::Decimal* value(char address) const;  // of the last such word
  // A word of group 07.
  [[nodiscard]] bool says_compensation() const;
  // Nothing but movement, its kind and dimension, feed and vectors, and words of group 07.
  [[nodiscard]] bool is_plain() const;
};

class FanucProgram {
 public:
  // Empty where the control is another.
  explicit FanucProgram(const spec::Case& c);

  [[nodiscard]] const std::vector<FanucBlock>& blocks() const { return blocks_; }
  // Index of the only block in this line; size of the list where there is none, or a second one (events name lines).
  [[nodiscard]] std::size_t index(std::uint64_t line) const;
  // Whether any block has one of these codes.
  [[nodiscard]] bool has_code(std::initializer_list<int> codes) const;
  // Whether coordinates may be renamed in the blocks behind `from`, up to and including `to` (indices): a position
  // before does not subtract from one after.
  [[nodiscard]] bool renames(std::size_t from, std::size_t to) const;
  // Programs are called: blocks run in another order than they stand.
  [[nodiscard]] bool calls() const { return calls_; }

 private:
  std::vector<FanucBlock> blocks_;
  bool calls_ = false;
  bool length_renames_ = false;  // 5006#6 = 1: a length offset shifts the coordinate system
  bool any_block_may_ = false;   // and with 5001#6 = 1 any block may bring one into force
};

// Offsets as they stand in the setup, setup units; nothing where the number is none.
std::optional<exact::Rational> length_value(const spec::Setup& setup, std::uint64_t number);
std::optional<exact::Rational> cutter_value(const spec::Setup& setup, std::uint64_t number);

}  // namespace toolcomp::fuzz::laws

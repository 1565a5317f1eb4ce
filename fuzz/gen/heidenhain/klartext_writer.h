// SPDX-License-Identifier: Apache-2.0
// Writes Klartext program text block by block, in the ways a control or a CAM system may write it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "fuzz/gen/choices.h"

namespace toolcomp::fuzz {

// `count` units of 10^-decimals as Klartext takes it: with or without +, point or comma, any minus, zeros at the end.
std::string klartext_number(Choices& choose, std::int64_t count, int decimals);

class KlartextWriter {
 public:
  explicit KlartextWriter(Choices& choose);

  // Words of the block being written.
  KlartextWriter& word(std::string_view text);
  // A key with a literal.
  KlartextWriter& number(std::string_view key, std::int64_t count, int decimals);
  // The same, or, in so many of 100, through a parameter that is assigned in a block before.
  KlartextWriter& value(std::string_view key, std::int64_t count, int decimals, std::uint64_t by_parameter = 3);
  // Ends the block; nothing happens without words. `may_go_on`: the block may take two lines.
  void end_block(bool may_go_on = true);
  // Lines that are no blocks: comments, structure.
  void remark();

  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  void put(std::string block, bool may_go_on);

  Choices& choose_;
  std::string text_;
  std::string before_;  // blocks that go before the one being written
  std::string block_;
  std::uint64_t n_ = 0;
  bool numbered_ = false;
  bool lower_case_ = false;
};

}  // namespace toolcomp::fuzz

// SPDX-License-Identifier: Apache-2.0
// What the readers of both dialects may be told.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace toolcomp::spec {

// Finds a program that another calls and does not hold itself: its text, or nothing where there is none of this name
// ("O1000", "SUB.H"). `line` is its first line in the text of all programs joined, by which blocks are known.
using CalledProgram = std::function<std::optional<std::string>(std::string_view name, std::uint64_t line)>;

struct ReaderOptions {
  std::string file = "program";  // for messages
  bool block_skip = false;       // FANUC: blocks that begin with / are skipped
  // FANUC: those of the least input increment in mm, and whether the setup is in inches, for numbers that the control
  // rounds (fanuc.program.macro-variable). 0: such numbers are not followed.
  unsigned decimals = 0;
  bool inch = false;
  // NOLINTNEXTLINE(*-redundant-member-init): GCC warns where braces leave it out otherwise
  CalledProgram called_program = {};
  // How many blocks calls and repeats may add to those of the text.
  std::uint64_t most_repeated = 1'000'000;
};

struct Setup;

// Those that a setup says.
ReaderOptions reader_options(const Setup& setup, std::string file = "program", CalledProgram called = {});

}  // namespace toolcomp::spec

// SPDX-License-Identifier: Apache-2.0
// Options of the readers of both dialects.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace toolcomp::spec {

// Finds a called program that is not in the text of the caller: returns its text, or std::nullopt if there is no
// program with this name ("O1000", "SUB.H"). `line` is its first line in the joined text of all programs; blocks have
// the line numbers of that text.
using CalledProgram = std::function<std::optional<std::string>(std::string_view name, std::uint64_t line)>;

struct ReaderOptions {
  std::string file = "program";  // for messages
  bool block_skip = false;       // FANUC: blocks that begin with / are skipped
  // FANUC: decimals of the least input increment in mm, and whether the setup is in inches, for numbers that the
  // control rounds (fanuc.program.macro-variable). 0: toolcomp does not follow such numbers.
  unsigned decimals = 0;
  bool inch = false;
  // NOLINTNEXTLINE(*-redundant-member-init): GCC warns where braces leave it out otherwise
  CalledProgram called_program = {};
  // How many blocks calls and repeats may run in addition to those of the text.
  std::uint64_t most_repeated = 1'000'000;
};

struct Setup;

// The options that follow from a setup.
ReaderOptions reader_options(const Setup& setup, std::string file = "program", CalledProgram called = {});

}  // namespace toolcomp::spec

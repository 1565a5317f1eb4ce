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
  // NOLINTNEXTLINE(*-redundant-member-init): GCC warns where braces leave it out otherwise
  CalledProgram called_program = {};
  // How many blocks calls and repeats may add to those of the text.
  std::uint64_t most_repeated = 1'000'000;
};

}  // namespace toolcomp::spec

// What the readers of both dialects may be told.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace toolcomp::spec {

struct ReaderOptions {
  std::string file = "program";  // for messages
  bool block_skip = false;       // FANUC: blocks that begin with / are skipped
  // The text of a program that this one calls and does not hold itself; nothing where there is none of this name
  // ("O1000", "SUB.H"). NOLINTNEXTLINE(*-redundant-member-init): GCC warns where braces leave it out otherwise
  std::function<std::optional<std::string>(std::string_view name)> called_program = {};
  // How many blocks calls and repeats may add to those of the text.
  std::uint64_t most_repeated = 1'000'000;
};

}  // namespace toolcomp::spec

// What the readers of both dialects may be told.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace toolcomp::spec {

struct ReaderOptions {
  std::string file = "program";  // for messages
  bool block_skip = false;       // FANUC: blocks that begin with / are skipped
  // The text of a program that is called and does not stand in the text itself ("O1000"); without it there is none.
  std::function<std::optional<std::string>(std::string_view name)> called_program;
};

}  // namespace toolcomp::spec

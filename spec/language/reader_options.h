// What the readers of both dialects may be told.
#pragma once

#include <string>

namespace toolcomp::spec {

struct ReaderOptions {
  std::string file = "program";  // for messages
  bool block_skip = false;       // FANUC: blocks that begin with / are skipped
};

}  // namespace toolcomp::spec

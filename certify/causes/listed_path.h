// SPDX-License-Identifier: Apache-2.0
// A path whose pieces are all in memory.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "certify/trace/path.h"

namespace toolcomp::certify {

using Pieces = std::shared_ptr<const std::vector<PathPiece>>;

class ListedPath : public PathSource {
 public:
  explicit ListedPath(Pieces pieces) : pieces_(std::move(pieces)) {}
  bool next(PathPiece& piece) override {
    if (next_ == pieces_->size()) return false;
    piece = (*pieces_)[next_++];
    return true;
  }

 private:
  Pieces pieces_;
  std::size_t next_ = 0;
};

}  // namespace toolcomp::certify

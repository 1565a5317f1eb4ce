// SPDX-License-Identifier: Apache-2.0
// The findings of a recording as they come in.
#pragma once

#include <cstddef>
#include <optional>

#include "certify/trace/trace.h"

namespace toolcomp::certify {

// Counts all, keeps the first ones, and takes what one cause makes twice for one: a gap of the path and one of the time
// at the same sample.
class Findings {
 public:
  Findings(TraceResult& result, std::size_t most) : result_(result), most_(most) {}
  void add(TraceFinding finding);
  // The run of samples of the last finding that had one goes on.
  void extend(const TraceFinding& more);
  // By sample, in the end.
  void sort();

 private:
  TraceResult& result_;
  std::size_t most_;
  std::optional<std::size_t> run_;  // the last finding with samples, if it is kept
};

}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
// Collects the findings of a recording.
#pragma once

#include <cstddef>
#include <optional>

#include "certify/trace/trace.h"

namespace toolcomp::certify {

// Counts all findings and keeps the first ones. Two findings with one cause count once: a gap of the path and a gap of
// the time at the same sample.
class Findings {
 public:
  Findings(TraceResult& result, std::size_t most) : result_(result), most_(most) {}
  void add(TraceFinding finding);
  // Extends the run of samples of the last finding that has one.
  void extend(const TraceFinding& more);
  // Sorts the findings by sample, at the end.
  void sort();

 private:
  TraceResult& result_;
  std::size_t most_;
  std::optional<std::size_t> run_;  // the last finding with samples, if it is kept
};

}  // namespace toolcomp::certify

// The findings of a recording as they come in.
#pragma once

#include <cstddef>

#include "certify/trace/trace.h"

namespace toolcomp::certify {

// Counts all, keeps the first ones, and takes what one cause makes twice for one: a gap of the path and one of the time
// at the same sample.
class Findings {
 public:
  Findings(TraceResult& result, std::size_t most) : result_(result), most_(most) {}
  void add(TraceFinding finding);
  // By sample, in the end.
  void sort();

 private:
  TraceResult& result_;
  std::size_t most_;
};

}  // namespace toolcomp::certify

// A recording as far as it is kept.
#pragma once

#include <cstddef>
#include <vector>

#include "certify/trace/recording.h"

namespace toolcomp::certify {

struct RecordedRun {
  // Kept at most: causes are looked for in shorter recordings only.
  static constexpr std::size_t kMost = 200000;

  std::vector<RecordedSample> samples;
  bool whole = true;  // nothing was left out
  bool has_time = false;
};

}  // namespace toolcomp::certify

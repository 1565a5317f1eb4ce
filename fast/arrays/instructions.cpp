// SPDX-License-Identifier: Apache-2.0
#include "fast/arrays/instructions.h"

namespace toolcomp::fast {

Instructions best_instructions() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2") != 0) return Instructions::avx2;
#endif
  return Instructions::baseline;
}

}  // namespace toolcomp::fast

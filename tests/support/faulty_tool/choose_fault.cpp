// SPDX-License-Identifier: Apache-2.0
// Before main: the seeded fault that TOOLCOMP_FAULT names is in force, on the thread that does a command's work.
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <string_view>

#include "fuzz/faults/fault.h"

namespace {

constexpr std::string_view kNames[] = {
    "none",
#define TOOLCOMP_FAULT(name, mistake, section, budget, clauses) #name,
#include "fuzz/faults/faults.inc"
#undef TOOLCOMP_FAULT
};

const bool g_chosen = [] {
  const char* const wanted = std::getenv("TOOLCOMP_FAULT");
  if (wanted == nullptr) return false;
  for (std::size_t i = 0; i < std::size(kNames); ++i)
    if (kNames[i] == wanted) {
      toolcomp::fast::active_fault = static_cast<toolcomp::fast::Fault>(i);
      return true;
    }
  std::cerr << "no seeded fault is called " << wanted << '\n';
  std::exit(2);
}();

}  // namespace

// SPDX-License-Identifier: Apache-2.0
#include "spec/language/reader_options.h"

#include <utility>

#include "spec/language/setup.h"

namespace toolcomp::spec {

ReaderOptions reader_options(const Setup& setup, std::string file, CalledProgram called) {
  ReaderOptions options;
  options.file = std::move(file);
  options.block_skip = setup.block_skip;
  options.decimals = setup.increment == IncrementSystem::is_a ? 2 : setup.increment == IncrementSystem::is_b ? 3 : 4;
  options.inch = setup.units == Units::inch;
  options.called_program = std::move(called);
  return options;
}

}  // namespace toolcomp::spec

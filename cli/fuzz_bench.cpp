// SPDX-License-Identifier: Apache-2.0
#include "cli/fuzz_bench.h"

#include <filesystem>

#include "spec/language/data_folder.h"

namespace toolcomp::cli {

certify::fuzzing::Bench fuzz_bench(const FuzzOptions& options) {
  namespace fs = std::filesystem;
  certify::fuzzing::Bench bench;
  bench.program = fs::read_symlink("/proc/self/exe");
  if (!options.built_in) bench.targets = bench.program.parent_path().parent_path() / "fuzz";
  bench.inputs.push_back(spec::data_folder() / "corpus/seeds");
  bench.controller = options.controller;
  bench.timeout = options.timeout;
  return bench;
}

}  // namespace toolcomp::cli

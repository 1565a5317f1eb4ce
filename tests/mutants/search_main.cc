// SPDX-License-Identifier: Apache-2.0
// search_main RUNS: the fast engine linked with it, searched as a campaign searches: fresh directed cases of every
// section in turns, RUNS of each. Prints "found EXECUTIONS SECTION: what" or "not found EXECUTIONS"; a crash or a hang
// is seen by whoever runs it.
#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <exception>
#include <string>

#include "fuzz/gen/generator.h"
#include "judge/oracle/verdict.h"
#include "spec/language/input_error.h"

namespace {

using namespace toolcomp;

// What differs; empty where nothing does. Laws are not asked: they look at the model.
std::string difference(const spec::Case& c) {
  bool refused = false;
  judge::ModelRun run;
  try {
    run = judge::run_model(c);
  } catch (const spec::InputError&) {
    refused = true;
  }
  try {
    const auto events = judge::run_fast(c);
    if (refused) return "a setup that is refused";
    const judge::Verdict verdict = judge::judge(c, run, events);
    if (verdict.outcome == judge::Outcome::differs) return judge::explain(*verdict.difference);
  } catch (const spec::InputError& error) {
    if (!refused) return error.what();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t runs = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 0;
  std::uint64_t executions = 0;
  for (std::uint64_t seed = 1; seed <= runs; ++seed)
    for (const std::string_view section : fuzz::sections()) {
      ++executions;
      // Where it ends without a word this was the last.
      if (executions % 64 == 1) fmt::print("at {}\n", executions);
      fuzz::SeededSource source(seed);
      const std::string what = difference(fuzz::generate(section, fuzz::Mode::directed, source));
      if (what.empty()) continue;
      fmt::print("found {} {}: {}\n", executions, section, what);
      return 0;
    }
  fmt::print("not found {}\n", executions);
  return 0;
}

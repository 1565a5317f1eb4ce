// SPDX-License-Identifier: Apache-2.0
// voices_main SECTION RUNS: exact model, fast engine and formal specification, as they are linked with it, on fresh
// directed cases of the section. Prints "found EXECUTIONS CLAUSE: who stands alone" at the first on which two of them
// disagree and one is told to stand alone; cases before it that did not tell which are counted. Else "not found
// EXECUTIONS"; a crash or a hang is seen by whoever runs it.
#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <exception>
#include <memory>
#include <string>

#include "certify/judge.h"
#include "certify/voices.h"
#include "fuzz/gen/generator.h"
#include "spec/language/input_error.h"

namespace {

using namespace toolcomp;

// The clause of the first difference between the model and this one; nothing where there is none.
std::string clause(certify::Subject& subject, const spec::Case& c, const judge::ModelRun& run) {
  const auto able = std::get<certify::Capabilities>(subject.capabilities());
  const certify::Judgement judgement = certify::judge_case(subject, able, c, run);
  if (judgement.result != certify::Result::differs) return {};
  const auto key = certify::key_of(c, judgement);
  return key.clause.empty() ? key.kind : key.clause;
}

struct Found {
  std::string what;  // empty: nothing
  bool told = false;
};

// What is found in one case, and by whom.
Found found(certify::Subject& engine, certify::Subject& specification, const spec::Case& c) {
  try {
    const judge::ModelRun run = judge::run_model(c);
    std::string at = clause(specification, c, run);
    if (at.empty()) at = clause(engine, c, run);
    if (at.empty()) return {};
    const certify::Voices voices = certify::ask_all(c, engine, certify::kFastEngine);
    const bool told = voices.alone != certify::Alone::nobody && voices.alone != certify::Alone::not_known;
    return {at + ": " + voices.words, told};
  } catch (const spec::InputError&) {
    return {};
  } catch (const std::exception& error) {
    return {fmt::format("{}: an exception", error.what()), true};
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const std::uint64_t runs = std::strtoull(argv[2], nullptr, 10);
  const auto engine = certify::built_in_engine();
  const auto specification = certify::formal_specification();
  std::uint64_t not_told = 0;
  std::string last;
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    fuzz::SeededSource source(seed);
    const Found f = found(*engine, *specification, fuzz::generate(argv[1], fuzz::Mode::directed, source));
    if (!f.told) {
      if (!f.what.empty()) last = f.what;
      not_told += f.what.empty() ? 0 : 1;
      continue;
    }
    fmt::print("found {} {}{}\n", seed, f.what,
               not_told == 0 ? "" : fmt::format("; behind {} cases that did not tell", not_told));
    return 0;
  }
  if (not_told > 0) {
    fmt::print("found in {} cases, not told: {}\n", not_told, last);
    return 0;
  }
  fmt::print("not found {}\n", runs);
  return 0;
}

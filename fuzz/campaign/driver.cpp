// SPDX-License-Identifier: Apache-2.0
#include "fuzz/campaign/driver.h"

#include <fmt/format.h>

#include <utility>

#include "fuzz/campaign/long_program.h"
#include "fuzz/gen/mutate.h"

namespace toolcomp::fuzz {
namespace {

constexpr std::size_t kLargestCorpus = 4096;
// One in so many fresh directed cases has one word changed, moved or left out.
constexpr std::uint64_t kSlipEvery = 6;

}  // namespace

Driver::Driver(DriverOptions options) : options_(std::move(options)) {}

void Driver::step(std::uint64_t i) { execute(next(i), true); }

void Driver::revisit(spec::Case c) { execute(std::move(c), false); }

spec::Case Driver::next(std::uint64_t i) {
  const std::uint64_t seed = options_.seed ^ (i << 24U);
  SeededSource source(seed);
  spec::Case c;
  if (corpus_.empty() || source.below(2) == 0) {
    const bool slips = options_.mode == Mode::directed && source.below(kSlipEvery) == 0;
    c = slips ? generate_with_slip(options_.section, source) : generate(options_.section, options_.mode, source);
  } else {
    c = corpus_[source.below(corpus_.size())];
    if (source.below(10) == 0) c = splice(c, corpus_[source.below(corpus_.size())], source);
    change(c, options_.mode, true, source);
  }
  c.source = {"toolcomp fuzz", "1", fmt::format("{}", seed)};
  return c;
}

void Driver::execute(spec::Case c, bool keep) {
  if (options_.on_input) options_.on_input(c);
  const judge::Trial trial = try_short(c, options_.judged_by);
  add(result_, trial);
  if (trial.acceptance == judge::Acceptance::not_decided && options_.on_open)
    options_.on_open(c, trial.verdict.undecided);
  if (trial.found()) {
    if (options_.on_finding) options_.on_finding(c, *trial.verdict.difference);
    return;
  }
  if (!coverage_.add(trial.run) || corpus_.size() >= kLargestCorpus) return;
  if (keep && options_.on_corpus) options_.on_corpus(c);
  corpus_.push_back(std::move(c));
}

}  // namespace toolcomp::fuzz

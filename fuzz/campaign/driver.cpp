// SPDX-License-Identifier: Apache-2.0
#include "fuzz/campaign/driver.h"

#include <fmt/format.h>

#include "fuzz/campaign/diary.h"
#include "fuzz/campaign/long_program.h"
#include "fuzz/campaign/summary.h"
#include "fuzz/gen/mutate.h"

namespace toolcomp::fuzz {
namespace {

constexpr std::size_t kLargestCorpus = 4096;
// One in so many fresh directed cases has one word changed, moved or left out.
constexpr std::uint64_t kSlipEvery = 6;

}  // namespace

Driver::Driver(DriverOptions options) : options_(std::move(options)) {}

void Driver::step(std::uint64_t i) {
  spec::Case c = next(i);
  execute(std::move(c), mode_, true);
}

void Driver::revisit(spec::Case c, Mode mode) { execute(std::move(c), mode, false); }

spec::Case Driver::next(std::uint64_t i) {
  const auto& sections = options_.sections;
  const std::string& section = sections[i % sections.size()];
  mode_ = options_.modes[(i / sections.size()) % options_.modes.size()];
  auto& corpus = corpus_[{section, mode_}];
  // Seeds of searches and executions differ in the high and the low half.
  const std::uint64_t seed = options_.seed ^ (static_cast<std::uint64_t>(options_.number) << 56U) ^ (i << 24U);
  SeededSource source(seed);
  spec::Case c;
  if (corpus.empty() || source.below(2) == 0) {
    const bool slips = mode_ == Mode::directed && source.below(kSlipEvery) == 0;
    c = slips ? generate_with_slip(section, source) : generate(section, mode_, source);
  } else {
    c = corpus[source.below(corpus.size())];
    if (source.below(10) == 0) c = splice(c, corpus[source.below(corpus.size())], source);
    change(c, mode_, options_.steering, source);
  }
  c.source = {"toolcomp fuzz", "1", fmt::format("{}", seed)};
  return c;
}

void Driver::execute(spec::Case c, Mode mode, bool keep) {
  if (options_.on_input) options_.on_input(c);
  Trial trial = try_short(c, options_.subject);
  if (options_.stop && options_.stop()) return;
  add(result_, trial);
  if (trial.acceptance == Acceptance::not_decided) {
    keep_shortest(result_.not_decided, {c, trial.verdict.undecided});
    if (options_.on_open) options_.on_open(c, trial.verdict.undecided);
  }
  if (trial.found()) {
    record(std::move(c), *trial.verdict.difference);
    return;
  }
  const bool fresh = coverage_.add(trial.run, options_.steering);
  result_.reached = coverage_.reach();
  auto& corpus = corpus_[{c.section, mode}];
  if (!fresh || corpus.size() >= kLargestCorpus) return;
  if (keep && options_.on_corpus) options_.on_corpus(c, mode);
  corpus.push_back(std::move(c));
}

void Driver::record(spec::Case c, const Difference& difference) {
  const auto [place, fresh] = index_.try_emplace(group_of(c.section, difference), result_.findings.size());
  if (!fresh) ++result_.findings[place->second].executions;
  if (!fresh && !options_.on_finding) return;
  Finding finding{std::move(c), difference, 1, result_.executions};
  finding.input.id = fmt::format("finding.{}", finding.input.source.seed);
  finding.input.comment = explain(difference);
  if (options_.on_finding) options_.on_finding(finding, fresh);
  if (fresh) result_.findings.push_back(std::move(finding));
}

}  // namespace toolcomp::fuzz

// SPDX-License-Identifier: Apache-2.0
#include "corpus/check.h"

#include "corpus/vector.h"

namespace toolcomp::corpus {
namespace {

// What is wrong with a subject's answer to a vector; empty if nothing is. An undecided one is counted.
std::string judged(const judge::Trial& trial, CheckResult& result) {
  switch (trial.verdict.outcome) {
    case judge::Outcome::agrees:
      return {};
    case judge::Outcome::undecided:
      ++result.undecided;
      return {};
    case judge::Outcome::nothing_judged:
      return "nothing could be judged";
    case judge::Outcome::differs:
      break;
  }
  return trial.verdict.difference ? judge::explain(*trial.verdict.difference) : "differs";
}

}  // namespace

CheckResult check(const CheckOptions& options) {
  CheckResult result;
  const std::vector<Vector> vectors = read_vectors(options.folder, options.selection);
  for (const Vector& vector : vectors) {
    const judge::Trial trial =
        options.judged_by ? judge::try_case(vector.c, options.judged_by) : judge::try_case(vector.c);
    ++result.vectors;
    result.values += trial.verdict.values;
    result.ties += trial.verdict.ties;
    std::string wrong = options.judged_by ? judged(trial, result) : verify(vector.c, trial);
    if (!wrong.empty()) result.failures.push_back({vector.file, vector.line, vector.c.id, std::move(wrong)});
    if (options.progress) options.progress(result.vectors, vectors.size());
  }
  return result;
}

Coverage coverage(const std::filesystem::path& folder, const Selection& selection) {
  Coverage sum{std::vector<spec::OutcomeCounts>(spec::kClauseCount), 0};
  for (const Vector& vector : read_vectors(folder, selection)) {
    const judge::ModelRun run = judge::run_model(vector.c);
    ++sum.vectors;
    for (std::size_t i = 0; i < sum.counts.size(); ++i) {
      const model::ClauseCount& count = run.recorder.counts()[i];
      sum.counts[i].reached += count.reached;
      sum.counts[i].positive += count.positive;
      sum.counts[i].negative += count.negative;
      sum.counts[i].tie += count.tie;
    }
  }
  return sum;
}

}  // namespace toolcomp::corpus

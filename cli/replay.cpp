// SPDX-License-Identifier: Apache-2.0
// toolcomp replay: a finding, judged again.
#include <fmt/format.h>

#include <chrono>
#include <iostream>

#include "certify/replay.h"
#include "cli/difference.h"
#include "cli/manners.h"
#include "cli/verbs.h"
#include "spec/language/input_error.h"

namespace toolcomp::cli {

namespace {

// A program that no control would read is bad input of the finding's file.
certify::Replay judged(const std::string& file, const certify::ReplayOptions& how) {
  try {
    return certify::replay(file, how);
  } catch (const spec::InputError& error) {
    if (error.file() != "program") throw;
    throw spec::InputError(file, 0, 0, error.what());
  }
}

}  // namespace

int replay(const ReplayOptions& options) {
  certify::ReplayOptions how;
  if (!options.controller.empty()) how.controller = options.controller;
  how.timeout = std::chrono::milliseconds(static_cast<std::int64_t>(options.timeout * 1000));
  detail("reads " + options.finding);
  const certify::Replay replay = judged(options.finding, how);
  fmt::print("{}\n", replay.finding.smallest.program);
  if (replay.judgement.verdict.difference)
    print_difference(*replay.judgement.verdict.difference,
                     {options.finding, replay.judgement.verdict.difference->line});
  if (!replay.judgement.errors.empty()) std::cerr << replay.judgement.errors << '\n';
  std::string asked = "asked: " + (replay.asked.empty() ? "the built-in fast engine" : replay.asked);
  if (const std::size_t before = replay.finding.before.size(); before > 0)
    asked += fmt::format(", after {} requests before it", before);
  if (!replay.other_subject.empty()) asked += "; it is another now: " + replay.other_subject;
  note(asked);
  std::string result(certify::name(replay.judgement.result));
  if (replay.reproduced()) result += ", as in the finding";
  if (replay.finding.seen < replay.finding.tried)
    result += fmt::format(", at try {}; it came in {} of {} runs when it was found", replay.tried, replay.finding.seen,
                          replay.finding.tried);
  note(result);
  return certify::exit_status(replay.judgement.result);
}

}  // namespace toolcomp::cli

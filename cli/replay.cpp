// SPDX-License-Identifier: Apache-2.0
// toolcomp replay: a finding, judged again.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <chrono>
#include <iostream>
#include <string>

#include "certify/replay.h"
#include "cli/difference.h"
#include "cli/manners.h"
#include "cli/verbs.h"
#include "spec/language/input_error.h"
#include "spec/language/printable.h"

namespace toolcomp::cli {

namespace {

constexpr std::size_t kMostShown = 2000;  // of a command

// A program that no control would read is bad input of the finding's file.
certify::Replay judged(const std::string& file, const certify::ReplayOptions& how) {
  try {
    return certify::replay(file, how);
  } catch (const spec::InputError& error) {
    if (error.file() != "program") throw;
    throw spec::InputError(file, 0, 0, error.what());
  }
}

// A finding may come from anybody, and the command in it is a shell's.
void ask_whether_to_run(const ReplayOptions& options, const std::string& command) {
  std::cerr << "the finding names a command: " << spec::printable(command, kMostShown) << '\n';
  if (options.yes) return;
  if (::isatty(STDIN_FILENO) == 0 || ::isatty(STDERR_FILENO) == 0)
    throw spec::InputError(
        options.finding, 0, 0,
        "toolcomp runs its command only if you agree: --yes runs it, --controller names another one");
  std::cerr << "run it? [y/N] " << std::flush;
  std::string answer;
  std::getline(std::cin, answer);
  if (answer != "y" && answer != "Y" && answer != "yes")
    throw spec::InputError(options.finding, 0, 0, "its command was not run");
}

}  // namespace

int replay(const ReplayOptions& options) {
  certify::ReplayOptions how;
  if (!options.controller.empty()) how.controller = options.controller;
  how.timeout = std::chrono::milliseconds(static_cast<std::int64_t>(options.timeout * 1000));
  how.before_running = [&options](const std::string& command) { ask_whether_to_run(options, command); };
  detail("reads " + options.finding);
  const certify::Replay replay = judged(options.finding, how);
  fmt::print("{}\n", spec::printable_lines(replay.finding.smallest.program));
  if (replay.judgement.verdict.difference)
    print_difference(*replay.judgement.verdict.difference,
                     {options.finding, replay.judgement.verdict.difference->line});
  if (!replay.judgement.errors.empty())
    std::cerr << "standard error of the controller: " << spec::printable(replay.judgement.errors, kMostShown) << '\n';
  std::string asked = "asked: " + (replay.asked.empty() ? "the built-in fast engine" : replay.asked);
  if (const std::size_t before = replay.finding.before.size(); before > 0)
    asked += fmt::format(", after {} earlier requests", before);
  if (const spec::KnownSet& known = replay.finding.subject.known; !known.is_all())
    asked += fmt::format("; judged only by clauses known as {}", fmt::join(known.names(), ", "));
  if (!replay.other_subject.empty()) asked += "; the controller is now a different one: " + replay.other_subject;
  note(spec::printable(asked, kMostShown));
  std::string result(certify::name(replay.judgement.result));
  if (replay.reproduced()) result += ", as in the finding";
  if (replay.finding.seen < replay.finding.tried)
    result += fmt::format(", at attempt {}; it was reproduced in {} of {} runs when it was found", replay.tried,
                          replay.finding.seen, replay.finding.tried);
  note(spec::printable(result));
  return certify::exit_status(replay.judgement.result);
}

}  // namespace toolcomp::cli

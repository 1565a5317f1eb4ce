// SPDX-License-Identifier: Apache-2.0
#include "certify/replay.h"

#include <algorithm>

#include "certify/event_fields.h"
#include "certify/evidence.h"
#include "spec/language/byte_source.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify {
namespace {

// Of a program: all its events are in memory at once.
constexpr std::size_t kMostLines = 1'000'000;

// Whether the field of the finding is announced and not in the answer.
bool is_never_sent(const Finding& finding, const Capabilities& able, const Answer& answer) {
  const auto field = spec::find_field(finding.difference.field);
  const bool announced = std::ranges::find(able.fields, finding.difference.field) != able.fields.end();
  return field && announced && std::holds_alternative<TextEvents>(answer.result) && !answer.sent.has(*field);
}

std::uint64_t tries_for(const Finding& finding) {
  // It may have come every time by chance.
  constexpr std::uint64_t kLeast = 3;
  if (finding.seen >= finding.tried) return finding.controller.empty() ? 1 : kLeast;
  constexpr std::uint64_t kMost = 50;
  return std::min(kMost, 3 * finding.tried / std::max<std::uint64_t>(finding.seen, 1));
}

// The relative paths of a command are those of where it was run.
std::string command_of(const Finding& finding) {
  std::error_code none;
  const bool here = finding.directory.empty() || !std::filesystem::is_directory(finding.directory, none) ||
                    std::filesystem::equivalent(finding.directory, std::filesystem::current_path(), none);
  return here ? finding.controller : command_in(finding.directory, finding.controller);
}

std::string named(const Capabilities& c) { return c.version.empty() ? c.name : c.name + " " + c.version; }

void judge_once(Replay& replay, Subject& subject, const Capabilities& able, const judge::ModelRun& run) {
  const spec::Case& c = replay.finding.smallest;
  ++replay.tried;
  if (std::string why = why_not_applicable(able, c); !why.empty()) {
    replay.judgement = {};
    replay.judgement.result = Result::not_applicable;
    replay.judgement.why = std::move(why);
    return;
  }
  const Answer answer = ask_fresh(subject, replay.finding.before, c);
  replay.judgement = judge_answer(able, c, run, answer);
  replay.key = key_of(c, replay.judgement);
  if (replay.finding.key.kind == kNeverSent && is_never_sent(replay.finding, able, answer)) {
    replay.judgement.result = Result::differs;
    replay.key = replay.finding.key;
  }
}

}  // namespace

Replay replay(const std::filesystem::path& file, const ReplayOptions& options) {
  Replay result;
  result.finding = read_finding(spec::read_file(file), file.string());
  const spec::Case& c = result.finding.smallest;
  if (static_cast<std::size_t>(std::ranges::count(c.program, '\n')) > kMostLines)
    throw spec::InputError(
        file.string(), 0, 0,
        "program: has more than " + std::to_string(kMostLines) + " lines, the most that a finding can have");
  const judge::ModelRun run = judge::run_model(c);
  result.asked = options.controller.value_or(command_of(result.finding));
  const bool theirs = !options.controller && !result.asked.empty() && result.asked != kFormalSpecification;
  if (theirs && options.before_running) options.before_running(result.asked);
  const std::unique_ptr<Subject> subject = subject_of_finding(result.asked, options.timeout);
  const auto capabilities = subject->capabilities();
  if (const auto* failure = std::get_if<Fault>(&capabilities)) {
    result.tried = 1;
    result.judgement = judge_answer({}, c, run, {*failure, {}, {}});
    result.key = key_of(c, result.judgement);
    return result;
  }
  auto able = std::get<Capabilities>(capabilities);
  able.known = result.finding.subject.known;
  if (!result.finding.subject.name.empty() && named(able) != named(result.finding.subject))
    result.other_subject = named(able);
  for (std::uint64_t left = tries_for(result.finding); left > 0; --left) {
    judge_once(result, *subject, able, run);
    if (result.judgement.result == Result::differs) break;
  }
  return result;
}

}  // namespace toolcomp::certify

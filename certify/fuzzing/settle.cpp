// SPDX-License-Identifier: Apache-2.0
#include "certify/fuzzing/settle.h"

#include <fmt/format.h>

#include "certify/evidence.h"
#include "certify/fuzzing/shape.h"
#include "certify/shrink.h"
#include "certify/voices.h"
#include "fuzz/campaign/diary.h"
#include "fuzz/campaign/target.h"
#include "fuzz/gen/encode.h"
#include "host/process.h"
#include "spec/language/byte_source.h"

namespace toolcomp::certify::fuzzing {
namespace {

// What only a process of its own can be asked about.
bool ends_processes(const std::string& kind) { return kind == "crash" || kind == "hang" || kind == "out of memory"; }

std::string this_engine(const std::string& name) {
  return host::shell_quoted(std::filesystem::read_symlink("/proc/self/exe").string()) + " serve --engine " + name;
}

std::unique_ptr<Subject> subject_for(const Finding& seen, const SettleOptions& options) {
  const bool ours = seen.controller.empty() || seen.controller == kFormalSpecification;
  if (ours && ends_processes(seen.key.kind))
    return subject_of(this_engine(seen.controller.empty() ? "fast" : "spec"), options.timeout);
  return subject_of_finding(seen.controller, options.timeout);
}

// Who stands alone: of the fast engine or a controller the formal specification is asked, of that the fast engine.
std::string voices(const Finding& finding, Subject& subject) {
  if (is_fault(finding.key) || !finding.before.empty()) return {};
  if (finding.controller == kFormalSpecification)
    return ask_all(finding.smallest, *built_in_engine(), kFastEngine).words;
  return ask_all(finding.smallest, subject, finding.controller.empty() ? kFastEngine : "controller").words;
}

// Who found it and how, which looking again does not know.
Finding with_origin(Finding finding, const Finding& seen) {
  finding.target = seen.target;
  finding.seed = seen.seed;
  finding.executions = seen.executions;
  finding.seconds = seen.seconds;
  finding.controller = seen.controller;
  finding.directory = seen.directory;
  finding.tool = std::string("toolcomp ") + TOOLCOMP_VERSION;
  return finding;
}

Dossier as_it_was(const Finding& seen, Stage stage, std::string why) {
  Dossier dossier{with_origin(seen, seen), stage, {}, {}, std::move(why)};
  dossier.finding.complete = false;
  if (stage == Stage::gone) dossier.finding.seen = 0;
  return dossier;
}

// The plainest move, with the setup of a case.
spec::Case plainest_of(spec::Case c) {
  c.program = c.dialect == "klartext" ? "L X+1 R0 FMAX\n" : "G00 X1\n";
  return c;
}

// What is left of the shrunk program where a simpler one may differ in another way: by other events, at another clause.
// Faults of a process keep theirs: each costs a restart, and there is no way from one to a wrong value.
std::string core_of(Subject& subject, const Capabilities& capabilities, const Finding& finding,
                    const SettleOptions& options) {
  if (is_fault(finding.key) || !finding.before.empty()) return shape_of(finding.smallest);
  const auto differs = [&](const spec::Case& c) {
    if (options.stop && options.stop()) return false;
    try {
      const judge::ModelRun run = judge::run_model(c);
      if (!capabilities.fields.empty() && !why_not_applicable(capabilities, c).empty()) return false;
      const Answer answer = subject.run(c, short_patience(subject, options.timeout));
      const Judgement judgement = judge_answer(capabilities, c, run, answer);
      return judgement.result == Result::differs && !is_fault(key_of(c, judgement));
    } catch (const std::exception&) {
      return false;
    }
  };
  // Who fails at the plainest move fails at every program, of which each would be a core of its own.
  if (const spec::Case plainest = plainest_of(finding.smallest); differs(plainest)) return shape_of(plainest);
  return shape_of(shrink(finding.smallest, differs, {options.shrink_runs}).smallest);
}

Dossier undecided(const Finding& seen) {
  // A controller's answer to it is not asked for again.
  if (!seen.controller.empty()) return as_it_was(seen, Stage::seen, "a controller is not asked again");
  const judge::ModelRun run = judge::run_model(seen.smallest);
  const auto engine = built_in_engine();
  const auto able = std::get<Capabilities>(engine->capabilities());
  const Judgement judgement = judge_case(*engine, able, seen.smallest, run);
  if (judgement.result != Result::undecided)
    return as_it_was(seen, Stage::gone, fmt::format("judged again: {}", name(judgement.result)));
  return as_it_was(seen, Stage::reproduced, judgement.why);
}

}  // namespace

Dossier settle(const Finding& seen, const SettleOptions& options) {
  if (seen.key.section.empty()) return as_it_was(seen, Stage::seen, "the input of a reader is not shrunk");
  try {
    if (seen.key.kind == fuzz::kUndecidedKind) return undecided(seen);
    const auto subject = subject_for(seen, options);
    const auto said = subject->capabilities();
    const auto* const able = std::get_if<Capabilities>(&said);
    const judge::ModelRun run = judge::run_model(seen.smallest);
    const Capabilities capabilities = able != nullptr ? *able : Capabilities{};
    const Answer answer = ask_fresh(*subject, seen.before, seen.smallest);
    const Judgement judgement = judge_answer(capabilities, seen.smallest, run, answer);
    if (judgement.result != Result::differs)
      return as_it_was(seen, Stage::gone, fmt::format("judged again: {}", name(judgement.result)));
    EvidenceOptions evidence;
    evidence.timeout = options.timeout;
    evidence.shrink_runs = options.shrink_runs;
    evidence.stop = options.stop;
    Dossier dossier;
    const Finding again = as_seen(capabilities, seen.smallest, judgement, answer, seen.before);
    dossier.finding = with_origin(make_finding(*subject, again, evidence), seen);
    dossier.finding.alone = voices(dossier.finding, *subject);
    dossier.stage = dossier.finding.complete ? Stage::shrunk : Stage::reproduced;
    dossier.shape = shape_of(dossier.finding.smallest);
    if (dossier.stage == Stage::shrunk) dossier.core = core_of(*subject, capabilities, dossier.finding, options);
    return dossier;
  } catch (const std::exception& error) {
    // One engine refuses the setup and the other does not, or throws: there is no run to shrink.
    return as_it_was(seen, Stage::seen, error.what());
  }
}

bool fails_everywhere(const Dossier& dossier) {
  return !dossier.core.empty() && dossier.core == shape_of(plainest_of(dossier.finding.smallest));
}

Finding read_sighting(const std::filesystem::path& file, const std::string& target) {
  const std::string bytes = spec::read_file(file.string());
  if (file.extension() == ".json") return read_finding(bytes, file.string());
  const fuzz::Target* const known = fuzz::find_target(target);
  Finding finding;
  finding.target = target;
  const std::string name = file.filename().string();
  finding.key.kind = name.find("timeout-") != std::string::npos ? "hang"
                     : name.find("oom-") != std::string::npos   ? "out of memory"
                     : name.find("crash-") != std::string::npos ? "crash"
                                                                : "broken";
  // DIGEST.read_case.cpp-31.input: where the reader broke.
  const std::size_t dot = name.find('.');
  if (finding.key.kind == "broken" && name.ends_with(".input") && name.size() - dot > 7)
    finding.key.clause = name.substr(dot + 1, name.size() - dot - 7);
  if (known != nullptr && !known->is_reader()) {
    finding.smallest = fuzz::decode(known->section, bytes);
    finding.smallest.section = known->section;
    finding.key.section = known->section;
  } else {
    finding.smallest.program = bytes;
  }
  finding.smallest.id = "found." + fuzz::digest(bytes);
  finding.first_case = finding.smallest.id;
  finding.difference.kind = finding.key.kind;
  finding.difference.field = "process";
  finding.difference.expected = "events";
  finding.difference.actual = "ended at this input";
  return finding;
}

}  // namespace toolcomp::certify::fuzzing

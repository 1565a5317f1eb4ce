// SPDX-License-Identifier: Apache-2.0
#include "certify/comparison.h"

#include <cstdint>
#include <filesystem>
#include <system_error>
#include <variant>

#include "certify/long_program.h"
#include "certify/subject.h"
#include "judge/oracle/trial.h"
#include "spec/language/input_error.h"
#include "spec_engine/engine.h"

namespace toolcomp::certify {
namespace {

std::uintmax_t size_of(const input::Program& program) {
  if (program.is_case()) return program.as_case().program.size();
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(program.path(), unknown);
  return unknown ? kLargestAtOnce + 1 : size;
}

// Laws are asked with all events at hand, and not of what can be read only once.
std::uint64_t ask_laws(const input::Program& program, judge::Verdict& verdict) {
  if (verdict.outcome != judge::Outcome::agrees && verdict.outcome != judge::Outcome::nothing_judged) return 0;
  if (program.text().once || size_of(program) > kLargestAtOnce) return 0;
  const spec::Case c = program.as_case();
  return judge::hold_laws(c, judge::run_model(c), verdict);
}

}  // namespace

Comparison compare_fast(const input::Program& program, void (*on_block)(std::uint64_t)) {
  Comparison result;
  try {
    result.verdict = judge::judge_stream(program.text(), program.setup(), program.samples(), on_block);
  } catch (const spec::InputError& error) {
    throw program.placed(error);
  }
  result.questions = ask_laws(program, result.verdict);
  return result;
}

Judgement compare_specification(const input::Program& program) {
  if (!spec_engine::available())
    throw spec::InputError("--engines", 0, 0, "this toolcomp was built without the formal specification");
  const spec::Case c = program.as_case();
  const judge::ModelRun run = judge::run_model(c);
  const auto specification = formal_specification();
  const auto able = std::get<Capabilities>(specification->capabilities());
  Judgement judgement = judge_case(*specification, able, c, run);
  judgement.verdict.beyond = run.beyond;
  for (const model::Event& event : run.events)
    if (event.kind == spec::EventKind::undecided && judgement.verdict.open.count++ == 0)
      judgement.verdict.open = {1, event.line, event.out_of_scope};
  return judgement;
}

}  // namespace toolcomp::certify

#include "cli/controller.h"

#include <chrono>
#include <cmath>
#include <memory>
#include <variant>

#include "certify/finding.h"
#include "certify/judge.h"
#include "certify/subject.h"
#include "spec/language/input_error.h"

namespace toolcomp::cli {

fuzz::Subject controller_subject(const std::string& command, double timeout,
                                 const std::optional<std::string>& accepted_resolution) {
  const std::shared_ptr<certify::Subject> subject =
      certify::subject_of(command, std::chrono::milliseconds(std::llround(timeout * 1000)));
  const auto capabilities = subject->capabilities();
  if (const auto* fault = std::get_if<certify::Fault>(&capabilities))
    throw spec::InputError(command, 0, 0, "the controller cannot be used: " + fault->what);
  if (accepted_resolution)
    certify::expect_fine_resolution(std::get<certify::Capabilities>(capabilities), *accepted_resolution);
  return
      [subject, able = std::get<certify::Capabilities>(capabilities)](const spec::Case& c, const fuzz::ModelRun& run) {
        certify::Judgement judgement = certify::judge_case(*subject, able, c, run);
        if (judgement.difference) judgement.verdict.difference = judgement.difference;
        if (judgement.result == certify::Result::differs) judgement.verdict.outcome = fuzz::Outcome::differs;
        return judgement.verdict;
      };
}

}  // namespace toolcomp::cli

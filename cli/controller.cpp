// SPDX-License-Identifier: Apache-2.0
#include "cli/controller.h"

#include <chrono>
#include <cmath>
#include <memory>
#include <utility>
#include <variant>

#include "certify/asked.h"
#include "certify/evidence.h"
#include "certify/judge.h"
#include "certify/subject.h"
#include "spec/language/input_error.h"

namespace toolcomp::cli {
namespace {

class Watched {
 public:
  Watched(std::shared_ptr<certify::Subject> subject, certify::Capabilities able, Watch watch)
      : subject_(std::move(subject)), able_(std::move(able)), watch_(std::move(watch)) {}

  judge::Verdict judge(const spec::Case& c, const judge::ModelRun& run) {
    certify::Answer answer;
    certify::Judgement judgement;
    if (std::string why = certify::why_not_applicable(able_, c); !why.empty()) {
      judgement.result = certify::Result::not_applicable;
    } else {
      answer = subject_->run(c);
      asked_.add(*subject_, c);
      judgement = certify::judge_answer(able_, c, run, answer);
    }
    if (judgement.result == certify::Result::differs && watch_)
      watch_(certify::as_seen(able_, c, judgement, answer, asked_.before()));
    if (auto difference = judgement.difference()) judgement.verdict.difference = std::move(difference);
    return judgement.verdict;
  }

 private:
  std::shared_ptr<certify::Subject> subject_;
  certify::Capabilities able_;
  Watch watch_;
  certify::Asked<spec::Case> asked_;
};

}  // namespace

judge::CaseJudge judge_of_controller(const std::string& command, double timeout,
                                     const std::optional<std::string>& accepted_resolution, Watch watch) {
  const std::shared_ptr<certify::Subject> subject =
      certify::subject_of(command, std::chrono::milliseconds(std::llround(timeout * 1000)));
  const auto capabilities = subject->capabilities();
  if (const auto* fault = std::get_if<certify::Fault>(&capabilities))
    throw spec::InputError(command, 0, 0, "the controller cannot be used: " + fault->what);
  const auto& able = std::get<certify::Capabilities>(capabilities);
  if (accepted_resolution) certify::expect_fine_resolution(able, *accepted_resolution);
  const auto watched = std::make_shared<Watched>(subject, able, std::move(watch));
  return [watched](const spec::Case& c, const judge::ModelRun& run) { return watched->judge(c, run); };
}

}  // namespace toolcomp::cli

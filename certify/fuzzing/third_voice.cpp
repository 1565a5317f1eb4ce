// SPDX-License-Identifier: Apache-2.0
#include "certify/fuzzing/third_voice.h"

#include <chrono>
#include <deque>
#include <fstream>
#include <iostream>
#include <set>
#include <stdexcept>
#include <utility>

#include "certify/evidence.h"
#include "certify/exactly.h"
#include "certify/finding.h"
#include "fuzz/campaign/diary.h"
#include "fuzz/campaign/long_program.h"
#include "fuzz/gen/encode.h"
#include "spec/language/byte_source.h"
#include "spec/language/case_format.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify::fuzzing {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using judge::Acceptance;

// Between two looks for what a target's workers have kept.
constexpr std::chrono::seconds kLook{1};

// One target: what waits, and the time it has had.
struct Turn {
  const fuzz::Target* target = nullptr;
  Clock::duration spent{};
  Clock::time_point looked;
  std::deque<std::string> waiting;
  std::uint64_t generated = 0;
};

Judgement told(const char* kind, const std::string& expected, const std::string& actual) {
  Judgement j;
  j.result = Result::differs;
  judge::Difference& d = j.verdict.difference.emplace();
  d.kind = kind;
  d.field = "events";
  d.expected = expected;
  d.actual = actual;
  return j;
}

class ThirdVoice {
 public:
  explicit ThirdVoice(const ThirdVoiceOptions& options)
      : options_(options),
        diary_(options.work, third_voice().name, options.seed),
        specification_(formal_specification()),
        able_(std::get<Capabilities>(specification_->capabilities())),
        note_(options.asked, std::ios::app) {
    std::ifstream earlier(options.asked);
    for (std::string line; std::getline(earlier, line);) asked_.insert(line);
    for (const fuzz::Target* target : options.targets) turns_.push_back({target, {}, {}, {}, 0});
  }

  int run() {
    while (!diary_.failed() && !turns_.empty()) {
      if (options_.seconds > 0 && diary_.seconds() >= static_cast<double>(options_.seconds)) break;
      Turn& turn = *std::ranges::min_element(turns_, {}, &Turn::spent);
      const Clock::time_point begun = Clock::now();
      std::optional<spec::Case> c = next(turn);
      if (!c) {
        turns_.erase(turns_.begin() + (&turn - turns_.data()));
        continue;
      }
      ask(*turn.target, *c);
      turn.spent += Clock::now() - begun;
      diary_.tick(result_);
    }
    diary_.write(result_);
    return diary_.failed() ? fuzz::Diary::kCannotWrite : 0;
  }

 private:
  // What is kept comes first; nothing: only that is asked for, and all of it has been.
  std::optional<spec::Case> next(Turn& turn) {
    const fuzz::Target& target = *turn.target;
    if (turn.waiting.empty()) look(turn);
    while (!turn.waiting.empty()) {
      const std::string name = std::move(turn.waiting.front());
      turn.waiting.pop_front();
      try {
        spec::Case c = fuzz::decode(target.section, spec::read_file((options_.corpus / target.name / name).string()));
        note_ << target.name << '/' << name << std::endl;
        return c;
      } catch (const std::exception&) {  // NOLINT(bugprone-empty-catch)
        // A corpus may be made smaller by its workers.
      }
    }
    if (options_.seconds == 0) return std::nullopt;
    // Not the cases of a worker with the same seed.
    fuzz::SeededSource source(~options_.seed ^ (turn.generated++ << 24U));
    return fuzz::generate(target.section, target.mode, source);
  }

  void look(Turn& turn) {
    if (turn.looked != Clock::time_point{} && Clock::now() - turn.looked < kLook && options_.seconds > 0) return;
    turn.looked = Clock::now();
    const fs::path folder = options_.corpus / turn.target->name;
    if (!fs::is_directory(folder)) return;
    for (const auto& entry : fs::directory_iterator(folder)) {
      std::string name = entry.path().filename().string();
      if (name.ends_with(".part") || !asked_.insert(turn.target->name + '/' + name).second) continue;
      turn.waiting.push_back(std::move(name));
    }
    std::ranges::sort(turn.waiting);
  }

  void ask(const fuzz::Target& target, spec::Case& c) {
    c.section = target.section;
    c.id = "found." + fuzz::digest(fuzz::encode(c));
    diary_.begin(spec::write_case_line(c));
    ++result_.executions;
    Acceptance acceptance = Acceptance::not_decided;
    if (const auto judgement = judged(c, acceptance)) {
      result_.values += judgement->verdict.values;
      if (judgement->result == Result::differs) {
        note(target, c, *judgement);
        return;
      }
      if (judgement->result == Result::agrees) acceptance = Acceptance::accepted;
      if (judgement->result == Result::nothing_judged) acceptance = Acceptance::no_number;
    }
    ++result_.acceptance.at(static_cast<std::size_t>(acceptance));
  }

  // Nothing where the model says nothing: what it is then is said by the acceptance.
  std::optional<Judgement> judged(const spec::Case& c, Acceptance& acceptance) {
    judge::ModelRun run;
    try {
      if (fuzz::repeats_much(c)) {
        acceptance = Acceptance::too_long;
        return std::nullopt;
      }
      run = judge::run_model(c);
    } catch (const spec::InputError&) {
      acceptance = Acceptance::no_setup;
      return std::nullopt;
    } catch (const std::exception&) {
      return std::nullopt;  // the workers' finding
    }
    try {
      return judge_case(*specification_, able_, c, run);
    } catch (const spec::InputError& error) {
      return told("setup", "accepted", error.what());
    } catch (const std::exception& error) {
      return told("exception", "events of the formal specification", error.what());
    }
  }

  void note(const fuzz::Target& target, const spec::Case& c, const Judgement& judgement) {
    diary_.hit(
        fuzz::group_of(c.section, *judgement.difference()), result_.executions,
        [&](const fuzz::HowFound& how) {
          Finding seen = as_seen(able_, c, judgement, {}, {});
          seen.controller = kFormalSpecification;
          seen.target = target.name;
          seen.seed = std::to_string(how.seed);
          seen.executions = how.executions;
          seen.seconds = how.seconds;
          return write_finding(seen);
        },
        ".json");
  }

  const ThirdVoiceOptions& options_;
  fuzz::Diary diary_;
  std::unique_ptr<Subject> specification_;
  Capabilities able_;
  std::ofstream note_;
  std::set<std::string> asked_;
  std::vector<Turn> turns_;
  fuzz::Counters result_;
};

}  // namespace

const fuzz::Target& third_voice() {
  static const fuzz::Target target{"specification", "", fuzz::Mode::directed, ""};
  return target;
}

int run_third_voice(const ThirdVoiceOptions& options) {
  try {
    return ThirdVoice(options).run();
  } catch (const std::runtime_error& error) {
    std::cerr << error.what() << '\n';
    return fuzz::Diary::kCannotWrite;
  }
}

std::string ended_at(const std::string& case_line, const std::string& how) {
  Finding finding;
  finding.smallest = spec::read_case(case_line, "black_box");
  finding.difference.kind = how;
  finding.difference.field = "process";
  finding.difference.expected = "events";
  finding.difference.actual = "ended at this input";
  finding.key = key_of(finding.smallest, finding.difference);
  finding.first_case = finding.smallest.id;
  finding.controller = kFormalSpecification;
  return write_finding(finding);
}

VoiceCount voice_count(const TargetState& counted) {
  const auto of = [&](Acceptance acceptance) { return counted.sum.count(acceptance); };
  VoiceCount count;
  count.cases = counted.sum.executions;
  count.per_second = counted.sum.per_second();
  count.agreed = of(Acceptance::accepted) + of(Acceptance::no_number);
  count.undecided = of(Acceptance::not_decided);
  count.refused = of(Acceptance::no_setup) + of(Acceptance::no_text);
  count.differ = counted.sum.differed();
  return count;
}

}  // namespace toolcomp::certify::fuzzing

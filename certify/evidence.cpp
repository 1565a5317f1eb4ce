// SPDX-License-Identifier: Apache-2.0
#include "certify/evidence.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "certify/convert.h"
#include "certify/shrink.h"
#include "fuzz/gen/generator.h"

namespace toolcomp::certify {
namespace {

using std::chrono::milliseconds;

// How often shrinking starts a process again that did not survive: a hang costs its time-out, too.
constexpr std::uint64_t kMostRestarts = 40;
// So often a finding is asked for where it comes every time: by a process that goes on, where each costs a restart,
// where it is waited for; and where it does not.
constexpr std::uint64_t kTries = 5;
constexpr std::uint64_t kTriesOfFaults = 3;
constexpr std::uint64_t kTriesOfWaits = 2;
constexpr std::uint64_t kMostTries = 10;
// What comes only of fresh processes is shrunk by so many of them, and by so many requests, at most.
constexpr std::size_t kFreshRuns = 120;
constexpr std::size_t kRequests = 20'000;
constexpr std::size_t kOneByOne = 16;

// How a case is asked: of the process that is there, or of a fresh one that was asked others before.
struct Way {
  bool fresh = false;
  std::vector<spec::Case> before;
  std::size_t repeats = 0;  // instead: so many times the case itself

  // Repeats have ids of their own, so that an answer to one of them that comes late is none to the case.
  [[nodiscard]] std::vector<spec::Case> before_of(const spec::Case& c) const {
    if (repeats == 0) return before;
    std::vector<spec::Case> copies(repeats, c);
    for (std::size_t i = 0; i < repeats; ++i) copies[i].id += " before " + std::to_string(i + 1);
    return copies;
  }
};

// One finding on its way.
class Evidence {
 public:
  Evidence(Subject& subject, const Finding& seen, const EvidenceOptions& options)
      : subject_(subject),
        seen_(seen),
        options_(options),
        patience_(short_patience(subject, options.timeout)),
        finding_(seen) {}

  // What ends before it is known how the finding comes leaves it as it was seen.
  Finding find() {
    finding_.complete = false;
    finding_.seen = finding_.tried = 0;
    if (stopped()) return std::move(finding_);
    const Way all{.fresh = true, .before = seen_.before};
    if (comes({.fresh = true, .before = {}}))
      by_itself();
    else if (!all.before.empty() && comes(all) && every_time(all, 1))
      behind_others();
    else
      by_chance();
    return std::move(finding_);
  }

 private:
  // It could say hello.
  [[nodiscard]] bool is_known() const { return !seen_.subject.fields.empty(); }
  // An engine in this process has no memory and no moods.
  [[nodiscard]] bool has_moods() const { return subject_.starts() > 0; }
  [[nodiscard]] bool is_waited_for() const { return !is_known() || seen_.key.kind == name(FaultKind::hang); }
  // It never answered a case: no program is to blame, and each try costs the whole time-out.
  [[nodiscard]] bool answers_nothing() const {
    return !is_known() || (is_waited_for() && has_moods() && subject_.answers() == 0);
  }
  [[nodiscard]] std::uint64_t tries() const {
    return !has_moods() ? 1 : is_waited_for() ? kTriesOfWaits : is_fault(seen_.key) ? kTriesOfFaults : kTries;
  }
  [[nodiscard]] std::uint64_t most_tries() const { return has_moods() && !is_waited_for() ? kMostTries : tries(); }

  [[nodiscard]] bool stopped() const { return options_.stop && options_.stop(); }

  // It came of a fresh process that was asked nothing else. Whether it comes of one that was asked before, too, says
  // whether one process will do for all that follows.
  void by_itself() {
    finding_.before.clear();
    Way way;
    if (!every_time(way, tries() - 1)) {
      way.fresh = true;
      // What comes only now and then cannot be shrunk: any smaller program may fail by chance to show it.
      if (!every_time(way, tries() - 1)) {
        describe();
        count({}, 0);
        return;
      }
    }
    shrink_program(way);
  }

  void behind_others() {
    Way way{.fresh = true, .before = fewest(seen_.before)};
    // Where their number alone matters, the case itself will do for each.
    const Way counted{.fresh = true, .before = {}, .repeats = way.before.size()};
    if (comes(counted))
      way = counted;
    else
      way.before = without_the_needless(way.before);
    shrink_program(way);
  }

  void by_chance() {
    for (std::uint64_t n = 2; n <= most_tries() && !stopped(); ++n)
      if (comes({})) {
        finding_.before.clear();
        describe();
        count({}, 0);
        return;
      }
    if (stopped()) return;
    finding_.before = last_of(finding_.before, kRequestsKept);
    finding_.tried = most_tries();
  }

  // A case of which it is worth while to ask; nothing where no control could read it.
  std::optional<judge::ModelRun> candidate(const spec::Case& c) const {
    try {
      judge::ModelRun run = judge::run_model(c);
      // A fault costs a restart, a hang its time-out: no need to see it once more where the clause is another anyway.
      if (is_fault(seen_.key)) {
        const auto clause = clause_of_fault(run);
        if (seen_.key.clause != (clause ? spec::info(*clause).id : std::string_view())) return std::nullopt;
      }
      if (is_known() && !why_not_applicable(seen_.subject, c).empty()) return std::nullopt;
      return run;
    } catch (const std::exception&) {
      return std::nullopt;
    }
  }

  std::optional<Judgement> judge(const spec::Case& c, const Way& way, milliseconds patience) {
    const auto run = candidate(c);
    if (!run) return std::nullopt;
    try {
      if (way.fresh) subject_.restart();
      for (const spec::Case& earlier : way.before_of(c)) {
        if (stopped()) return std::nullopt;
        static_cast<void>(subject_.run(earlier, patience));
      }
      answer_ = subject_.run(c, patience);
      return judge_answer(seen_.subject, c, *run, answer_);
    } catch (const std::exception&) {
      return std::nullopt;
    }
  }

  // Whether the case fails so, asked this way.
  bool comes(const Way& way, const spec::Case& c, milliseconds patience) {
    const auto j = judge(c, way, patience);
    if (!j || j->result != Result::differs || key_of(c, *j) != seen_.key) return false;
    last_ = as_seen(seen_.subject, c, *j, answer_, way.before_of(c));
    return true;
  }
  bool comes(const Way& way) { return comes(way, seen_.smallest, options_.timeout); }

  bool every_time(const Way& way, std::uint64_t times) {
    for (std::uint64_t n = 0; n < times && !stopped(); ++n)
      if (!comes(way)) return false;
    return true;
  }

  // Whether fewer requests before it will do.
  bool suffice(std::vector<spec::Case> fewer) {
    requests_ += fewer.size() + 1;
    return ++fresh_runs_ <= kFreshRuns && requests_ <= kRequests && !stopped() &&
           comes({.fresh = true, .before = std::move(fewer)});
  }

  // The last of them that suffice.
  std::vector<spec::Case> fewest(const std::vector<spec::Case>& before) {
    // Too few are `few`, enough are `enough`.
    std::size_t few = 0;
    std::size_t enough = before.size();
    // One by one at first: a fault that comes every so often comes behind few, and not behind some more.
    for (std::size_t n = 1; n < before.size(); n = n < kOneByOne ? n + 1 : 2 * n) {
      if (suffice(last_of(before, n))) {
        enough = n;
        break;
      }
      few = n;
    }
    while (enough - few > 1) {
      const std::size_t n = few + (enough - few) / 2;
      (suffice(last_of(before, n)) ? enough : few) = n;
    }
    return last_of(before, enough);
  }

  std::vector<spec::Case> without_the_needless(std::vector<spec::Case> before) {
    for (std::size_t part = before.size() / 2; part > 0; part /= 2)
      for (std::size_t at = 0; at + part <= before.size() && before.size() > part;) {
        std::vector<spec::Case> fewer = before;
        const auto from = fewer.begin() + static_cast<std::ptrdiff_t>(at);
        fewer.erase(from, from + static_cast<std::ptrdiff_t>(part));
        if (suffice(fewer))
          before = std::move(fewer);
        else
          at += part;
      }
    return before;
  }

  void shrink_program(const Way& way) {
    const std::uint64_t begun = subject_.starts();
    const auto given_up = [&] { return stopped() || (!way.fresh && subject_.starts() - begun >= kMostRestarts); };
    const auto still_fails = [&](const spec::Case& c) {
      if (answers_nothing()) return !stopped() && candidate(c).has_value();
      return !given_up() && comes(way, c, patience_);
    };
    const Finding whole = last_;
    const Shrunk shrunk = shrink(seen_.smallest, still_fails,
                                 {way.fresh ? std::min(options_.shrink_runs, kFreshRuns) : options_.shrink_runs});
    finding_.runs = shrunk.runs;
    finding_.complete = shrunk.complete && !given_up();
    // What one process was asked must make no difference, and what looks like a hang under a short time-out must be one
    // under the real one; else the case stays as it was.
    Way again = way;
    again.fresh = true;
    const bool confirmed = (way.fresh && !is_waited_for()) || comes(again, shrunk.smallest, options_.timeout);
    if (!confirmed) {
      finding_.complete = false;
      last_ = whole;
    }
    describe();
    count(way, confirmed ? 1 : 0);
  }

  // The finding is what failed last.
  void describe() {
    const Finding shrunk = std::exchange(finding_, last_);
    finding_.first_case = shrunk.first_case;
    finding_.runs = shrunk.runs;
    finding_.complete = shrunk.complete;
    if (is_known() && answers_nothing())
      finding_.difference.actual += ", and none to any other request: the controller does not answer";
    if (finding_.errors.empty()) finding_.errors = subject_.errors();
  }

  // How often it comes, where it came so many times already.
  void count(const Way& way, std::uint64_t came) {
    const spec::Case smallest = finding_.smallest;
    finding_.seen = finding_.tried = came;
    while (finding_.tried < most_tries() && (finding_.tried == 0 || !stopped())) {
      ++finding_.tried;
      if (comes(way, smallest, options_.timeout)) ++finding_.seen;
      if (finding_.tried >= tries() && finding_.seen == finding_.tried) break;
    }
  }

  Subject& subject_;
  const Finding& seen_;
  const EvidenceOptions& options_;
  milliseconds patience_;
  std::size_t fresh_runs_ = 0;  // for the requests before it
  std::size_t requests_ = 0;
  Answer answer_;  // the last
  Finding last_;   // the last that failed
  Finding finding_;
};

// For people and pictures; none if it is not a list of events.
std::vector<spec::Event<double>> events_in_double(const Answer& answer) {
  if (const auto* fast = std::get_if<FastEvents>(&answer.result)) return *fast;
  if (const auto* exact = std::get_if<ExactEvents>(&answer.result)) return in_doubles(*exact);
  const auto* text = std::get_if<TextEvents>(&answer.result);
  return text == nullptr ? std::vector<spec::Event<double>>{} : in_doubles(*text);
}

}  // namespace

std::vector<spec::Case> last_of(const std::vector<spec::Case>& cases, std::size_t n) {
  return {cases.end() - static_cast<std::ptrdiff_t>(std::min(n, cases.size())), cases.end()};
}

bool is_fault(const FailureKey& key) {
  constexpr std::array kFaults = {FaultKind::crash, FaultKind::hang, FaultKind::malformed, FaultKind::too_long,
                                  FaultKind::error};
  return std::ranges::any_of(kFaults, [&](FaultKind kind) { return key.kind == name(kind); });
}

milliseconds short_patience(const Subject& subject, milliseconds timeout) {
  return std::min(timeout, milliseconds(200) + 10 * subject.slowest());
}

Answer ask_fresh(Subject& subject, const std::vector<spec::Case>& before, const spec::Case& c,
                 std::optional<milliseconds> patience) {
  subject.restart();
  for (const spec::Case& earlier : before) static_cast<void>(subject.run(earlier, patience));
  return subject.run(c, patience);
}

Finding as_seen(const Capabilities& capabilities, const spec::Case& c, const Judgement& judgement, const Answer& answer,
                std::vector<spec::Case> before) {
  Finding f;
  f.smallest = c;
  f.smallest.expect.clear();
  f.smallest.has_expect = false;
  f.difference = judgement.difference().value();
  f.key = key_of(c, f.difference);
  f.status = judgement.status;
  f.errors = judgement.errors;
  f.subject = capabilities;
  f.first_case = c.id;
  f.before = std::move(before);
  f.actual_events = events_in_double(answer);
  return f;
}

Finding make_finding(Subject& subject, const Finding& seen, const EvidenceOptions& options) {
  return Evidence(subject, seen, options).find();
}

}  // namespace toolcomp::certify

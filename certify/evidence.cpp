// SPDX-License-Identifier: Apache-2.0
#include "certify/evidence.h"

#include <algorithm>
#include <array>
#include <utility>

#include "certify/convert.h"
#include "certify/shrink.h"
#include "fuzz/gen/generator.h"

namespace toolcomp::certify {
namespace {

using std::chrono::milliseconds;

// Programs of a faulty controller that shrinking tries again: each costs a restart, a hang its time-out.
constexpr std::size_t kMostFaultyRuns = 40;
// Fresh processes that a finding is asked of again: so many where it came every time, so many where it did not.
constexpr std::uint64_t kTries = 3;
constexpr std::uint64_t kMostTries = 10;
// A sequence of requests is shrunk by so many fresh processes, and asked so many requests, at most.
constexpr std::size_t kSequenceRuns = 120;
constexpr std::size_t kSequenceRequests = 20'000;
constexpr std::size_t kOneByOne = 16;
// Of what never comes again, so many requests before it are kept.
constexpr std::size_t kKept = 50;

// One finding on its way.
class Evidence {
 public:
  Evidence(Subject& subject, const Capabilities& capabilities, const Witness& witness, const EvidenceOptions& options)
      : subject_(subject),
        capabilities_(capabilities),
        witness_(witness),
        options_(options),
        key_(key_of(witness.c, witness.judgement)),
        patience_(short_patience(subject, options.timeout)) {}

  Finding find() {
    finding_ = as_seen(capabilities_, witness_);
    finding_.complete = false;
    if (stopped()) {
      finding_.seen = finding_.tried = 0;
      return std::move(finding_);
    }
    finding_.seen = finding_.tried = 0;
    const std::uint64_t tries = tries_alone();
    if (tries > 0) {
      finding_.before.clear();
      // What comes only now and then cannot be shrunk: any smaller program may fail by chance to show it.
      if (tries == 1)
        shrink_program({});
      else
        describe(last_);
    } else if (!witness_.before.empty() && comes(witness_.before, witness_.c)) {
      finding_.before = fewest(witness_.before);
      shrink_program(finding_.before);
    } else if (finding_.before.size() > kKept) {
      finding_.before.erase(finding_.before.begin(), finding_.before.end() - static_cast<std::ptrdiff_t>(kKept));
    }
    count();
    return std::move(finding_);
  }

 private:
  // The try at which the case fails by itself, from 1; 0: at none.
  std::uint64_t tries_alone() {
    for (std::uint64_t n = 1; n <= most_tries() && !stopped(); ++n)
      if (comes({}, witness_.c)) return n;
    return 0;
  }

  // An engine in this process has no memory and no moods; a hang is waited for each time.
  [[nodiscard]] std::uint64_t most_tries() const {
    constexpr std::uint64_t kHangs = 2;
    return subject_.starts() == 0 ? 1 : key_.kind == name(FaultKind::hang) ? kHangs : kMostTries;
  }

  [[nodiscard]] bool stopped() const { return options_.stop && options_.stop(); }

  // Judged afresh; nothing if no control could read it.
  std::optional<Judgement> judge(const spec::Case& c, const std::function<Answer()>& ask) {
    try {
      const fuzz::ModelRun run = fuzz::run_model(c);
      // A fault costs a restart, a hang its time-out: no need to see it once more where the clause is another anyway.
      if (is_fault(key_)) {
        const auto clause = clause_of_fault(run);
        if (key_.clause != (clause ? spec::info(*clause).id : std::string_view())) return std::nullopt;
      }
      const bool known = !capabilities_.fields.empty();
      if (known && !why_not_applicable(capabilities_, c).empty()) return std::nullopt;
      answer_ = ask();
      return judge_answer(capabilities_, c, run, answer_);
    } catch (const std::exception&) {
      return std::nullopt;
    }
  }

  bool fails(const spec::Case& c, const std::optional<Judgement>& j) const {
    return j && j->result == Result::differs && key_of(c, *j) == key_;
  }

  // Whether a fresh process fails so too, given the real time-out.
  bool comes(const std::vector<spec::Case>& before, const spec::Case& c) {
    const auto j = judge(c, [&] { return ask_fresh(subject_, before, c, options_.timeout); });
    if (!fails(c, j)) return false;
    spec::Case bare = c;
    bare.expect.clear();
    bare.has_expect = false;
    last_ = Witness{std::move(bare), *j, events_in_double(answer_), before};
    return true;
  }

  // The last of them that suffice, then without those that are not needed.
  std::vector<spec::Case> fewest(std::vector<spec::Case> before) {
    std::size_t runs = 0;
    std::size_t requests = 0;
    const auto suffices = [&](const std::vector<spec::Case>& fewer) {
      requests += fewer.size() + 1;
      return ++runs <= kSequenceRuns && requests <= kSequenceRequests && !stopped() && comes(fewer, witness_.c);
    };
    const auto last = [&](std::size_t n) {
      return std::vector<spec::Case>(before.end() - static_cast<std::ptrdiff_t>(n), before.end());
    };
    // Too few are `few`, enough are `enough`.
    std::size_t few = 0;
    std::size_t enough = before.size();
    // One by one at first: a fault that comes every so often comes behind few, and not behind some more.
    for (std::size_t n = 1; n < before.size(); n = n < kOneByOne ? n + 1 : 2 * n) {
      if (suffices(last(n))) {
        enough = n;
        break;
      }
      few = n;
    }
    while (enough - few > 1) {
      const std::size_t n = few + (enough - few) / 2;
      (suffices(last(n)) ? enough : few) = n;
    }
    before = last(enough);
    for (std::size_t part = before.size() / 2; part > 0; part /= 2)
      for (std::size_t at = 0; at + part <= before.size();) {
        std::vector<spec::Case> fewer = before;
        const auto from = fewer.begin() + static_cast<std::ptrdiff_t>(at);
        fewer.erase(from, from + static_cast<std::ptrdiff_t>(part));
        if (!fewer.empty() && suffices(fewer))
          before = std::move(fewer);
        else
          at += part;
      }
    return before;
  }

  // One process for all candidates, where nothing has to be asked before: what it has been asked makes no difference,
  // which fresh processes then confirm.
  void shrink_program(const std::vector<spec::Case>& before) {
    const Witness whole = last_;
    const bool faulty = is_fault(key_);
    std::size_t faulty_runs = 0;
    const auto given_up = [&] { return stopped() || (faulty && faulty_runs == kMostFaultyRuns); };
    const auto still_fails = [&](const spec::Case& c) {
      if (given_up()) return false;
      const auto j = judge(
          c, [&] { return before.empty() ? subject_.run(c, patience_) : ask_fresh(subject_, before, c, patience_); });
      const bool failed = fails(c, j);
      if (failed) ++faulty_runs;
      return failed;
    };
    const std::size_t most = before.empty() ? options_.shrink_runs : std::min(options_.shrink_runs, kSequenceRuns);
    Shrunk shrunk = shrink(witness_.c, still_fails, {most});
    finding_.runs = shrunk.runs;
    finding_.complete = shrunk.complete && !given_up();
    // What looks like a hang under a short time-out must be one under the real one; else the case stays as it was.
    const bool confirmed = comes(before, shrunk.smallest);
    if (!confirmed) {
      finding_.complete = false;
      last_ = whole;
    }
    describe(last_);
    finding_.seen = finding_.tried = confirmed ? 1 : 0;
  }

  void describe(const Witness& witness) {
    const Finding shrunk = std::exchange(finding_, as_seen(capabilities_, witness));
    finding_.first_case = shrunk.first_case;
    finding_.before = shrunk.before;
    finding_.runs = shrunk.runs;
    finding_.complete = shrunk.complete;
    finding_.seen = finding_.tried = 0;
    if (finding_.errors.empty()) finding_.errors = subject_.errors();
  }

  // What was confirmed once already counts.
  void count() {
    const spec::Case smallest = finding_.smallest;
    while (finding_.tried < most_tries() && !stopped()) {
      ++finding_.tried;
      if (comes(finding_.before, smallest)) ++finding_.seen;
      if (finding_.tried == kTries && finding_.seen == kTries) break;
    }
  }

  Subject& subject_;
  const Capabilities& capabilities_;
  const Witness& witness_;
  const EvidenceOptions& options_;
  FailureKey key_;
  milliseconds patience_;
  Answer answer_;  // the last
  Witness last_;   // the last that failed, of a fresh process
  Finding finding_;
};

}  // namespace

bool is_fault(const FailureKey& key) {
  constexpr std::array kFaults = {FaultKind::crash, FaultKind::hang, FaultKind::malformed, FaultKind::too_long,
                                  FaultKind::error};
  return std::ranges::any_of(kFaults, [&](FaultKind kind) { return key.kind == name(kind); });
}

milliseconds short_patience(const Subject& subject, milliseconds timeout) {
  return std::min(timeout, milliseconds(200) + 10 * subject.slowest());
}

std::vector<spec::Event<double>> events_in_double(const Answer& answer) {
  if (const auto* fast = std::get_if<FastEvents>(&answer.result)) return *fast;
  if (const auto* exact = std::get_if<ExactEvents>(&answer.result)) return in_doubles(*exact);
  const auto* text = std::get_if<TextEvents>(&answer.result);
  return text == nullptr ? std::vector<spec::Event<double>>{} : in_doubles(*text);
}

Answer ask_fresh(Subject& subject, const std::vector<spec::Case>& before, const spec::Case& c,
                 std::optional<milliseconds> patience) {
  subject.restart();
  for (const spec::Case& earlier : before) static_cast<void>(subject.run(earlier, patience));
  return subject.run(c, patience);
}

Finding as_seen(const Capabilities& capabilities, const Witness& witness) {
  Finding f;
  f.smallest = witness.c;
  f.smallest.expect.clear();
  f.smallest.has_expect = false;
  f.key = key_of(witness.c, witness.judgement);
  f.subject = capabilities;
  f.first_case = witness.c.id;
  f.before = witness.before;
  f.status = witness.judgement.status;
  f.errors = witness.judgement.errors;
  f.expected_events = in_doubles(fuzz::run_model(f.smallest).events);
  f.actual_events = witness.answer;
  if (const auto& d = witness.judgement.difference) {
    f.line = d->line;
    f.field = d->field;
    f.expected = d->expected;
    f.actual = d->actual;
    f.deviation_um = d->deviation_um;
    f.event = d->event;
  }
  return f;
}

Finding make_finding(Subject& subject, const Capabilities& capabilities, const Witness& witness,
                     const EvidenceOptions& options) {
  return Evidence(subject, capabilities, witness, options).find();
}

}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
#include "certify/certification.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <thread>
#include <utility>

#include "certify/asked.h"
#include "certify/event_fields.h"
#include "certify/evidence.h"
#include "certify/long_program.h"
#include "certify/path_svg.h"
#include "certify/program_text.h"
#include "certify/selection.h"
#include "certify/self_check.h"
#include "certify/shrink.h"
#include "certify/view/view.h"
#include "fuzz/gen/generator.h"
#include "host/sha256.h"
#include "judge/oracle/control.h"
#include "model/basis/clause_counts.h"
#include "spec/language/byte_source.h"
#include "spec/language/fanuc/without_effect.h"
#include "spec/language/input_error.h"
#include "spec/language/naming_clause.h"
#include "spec/language/setup_format.h"

namespace toolcomp::certify {
namespace {

// A section is given up after so many hangs, or faults of any kind, in a row: the controller does not get well again.
constexpr unsigned kHangsInARow = 2;
constexpr unsigned kFaultsInARow = 20;
// And after so many hangs in all: each is waited for.
constexpr unsigned kMostHangs = 20;
constexpr std::size_t kMostUnsettled = 100;
constexpr std::size_t kMostPictures = 20;

// What a picture shows of a run: inside blocks under tool center point control the tool turns, so the picture has
// samples there, whether the case asks for them or not.
ViewRun drawn_run(const spec::Case& c, const judge::ModelRun& run) {
  constexpr std::uint32_t kSamples = 16;
  const bool moves_the_control_point = std::ranges::any_of(
      run.events, [](const model::Event& event) { return event.kind == spec::EventKind::move && event.tool_axis; });
  spec::Case sampled = c;
  sampled.samples = kSamples;
  const bool again = moves_the_control_point && c.samples < kSamples;
  return view_run((again ? judge::run_model(sampled) : run).events);
}

// The exact path, drawn.
std::string picture_of(const spec::Case& c, const judge::ModelRun& run) {
  const ViewRun drawn = drawn_run(c, run);
  const ViewOptions options{path_options(c), {}};
  return view("Program " + c.id, c, drawn, options, path_svg(drawn.events, c.setup.axes, options.path));
}

// Of a FANUC program, as far as it can be read.
std::set<std::string> words_without_effect(const spec::Case& c) {
  std::set<std::string> words;
  auto reader = judge::FanucControl::reader(spec::text_source(c.program), c.setup, c.id);
  spec::Block block;
  try {
    while (reader.next(block)) spec::add_words_without_effect(block, words);
  } catch (const spec::InputError&) {
    return words;
  }
  return words;
}

class Certification {
 public:
  explicit Certification(const CertificationOptions& options) : options_(options) {
    for (const std::string_view section : fuzz::sections())
      if (options.sections.empty() || std::ranges::find(options.sections, section) != options.sections.end())
        sections_.emplace_back(section);
    for (const std::string& section : options.sections)
      if (std::ranges::find(sections_, section) == sections_.end())
        throw spec::InputError("--section", 0, 0, "unknown section " + section);
    total_ = options.cases.size() + sections_.size() * options.generated;
    generated_.resize(sections_.size());
    certificate_.clauses.resize(spec::kClauseCount);
  }

  Certificate run() {
    certificate_.self_check = self_check();
    identify();
    const std::unique_ptr<Subject> first = new_subject();
    const auto capabilities = first->capabilities();
    if (const auto* failure = std::get_if<Fault>(&capabilities)) {
      if (why_to_stop().empty()) cannot_be_asked(*first, *failure);
      return std::move(certificate_);
    }
    certificate_.subject = std::get<Capabilities>(capabilities);
    certificate_.subject.known = options_.known;
    certificate_.hello = first->hello();
    expect_fine_resolution(certificate_.subject, options_.accepted_resolution);
    results_.resize(total_);
    run_all(*first);
    summarize();
    settle_all(*first);
    certificate_.chatter = first->chatter();
    return std::move(certificate_);
  }

 private:
  struct Faults {
    std::atomic<unsigned> hangs_in_a_row{0};
    std::atomic<unsigned> in_a_row{0};
    std::atomic<unsigned> hangs{0};

    [[nodiscard]] bool hopeless() const {
      return hangs_in_a_row >= kHangsInARow || in_a_row >= kFaultsInARow || hangs >= kMostHangs;
    }
    void count(const FailureKey& key, bool fault) {
      const bool hang = fault && key.kind == name(FaultKind::hang);
      in_a_row = fault ? in_a_row + 1 : 0;
      hangs_in_a_row = hang ? hangs_in_a_row + 1 : 0;
      if (hang) ++hangs;
    }
  };

  // Thrown where cases are still being chosen.
  struct Stopped {};

  // The failures of one key: how many cases, and of the smallest all that was seen.
  struct Failures {
    std::uint64_t cases = 0;
    std::pair<std::size_t, std::size_t> size;  // of the smallest, its blocks and bytes
    std::size_t index = 0;                     // its number among all cases
    Finding seen;                              // with the last requests before it
    std::vector<std::size_t> asked;            // all requests before it, of its process, by their numbers
  };

  // What one worker has.
  struct Work {
    Subject& subject;
    Asked<std::size_t> asked;  // by index
    std::vector<model::ClauseCount> clauses = std::vector<model::ClauseCount>(spec::kClauseCount);
  };

  std::unique_ptr<Subject> new_subject() const {
    return options_.subject ? options_.subject()
                            : subject_of(options_.controller, options_.timeout, options_.reply_limit);
  }

  std::string why_to_stop() {
    std::string why = options_.stop ? options_.stop() : std::string();
    if (why.empty()) return why;
    const std::scoped_lock lock(mutex_);
    return certificate_.interrupted = why;
  }

  void identify() {
    Identity& id = certificate_.identity;
    id.tool = std::string("toolcomp ") + TOOLCOMP_VERSION;
    try {
      id.tool_hash = host::sha256_file("/proc/self/exe");
    } catch (const spec::InputError&) {
      id.tool_hash.clear();
    }
    id.clause_hash = clause_set_hash();
    id.corpus = options_.corpus;
    id.corpus_hash = options_.corpus_hash;
    id.seed = options_.seed;
    id.generated = options_.generated;
    id.controller = options_.controller;
  }

  [[nodiscard]] CaseInput case_at(std::size_t index) {
    if (index < options_.cases.size()) return options_.cases[index];
    index -= options_.cases.size();
    const std::size_t section = index / options_.generated;
    return {generated(section).at(index % options_.generated), Origin::generated};
  }

  // Chosen when the first of them is asked for; none for a section the controller does not know.
  const std::vector<spec::Case>& generated(std::size_t section) {
    const std::scoped_lock lock(choosing_);
    std::vector<spec::Case>& cases = generated_[section];
    if (!cases.empty()) return cases;
    const std::string& name = sections_[section];
    const std::vector<std::string>& known = certificate_.subject.sections;
    if (std::ranges::find(known, name) == known.end()) {
      spec::Case none;
      none.section = name;
      none.id = name;
      cases.assign(options_.generated, none);
      return cases;
    }
    cases = select_cases(name, options_.seed, options_.generated, [&](std::uint64_t looked_at) {
              if (!why_to_stop().empty()) throw Stopped{};
              if (options_.choosing) options_.choosing(name, looked_at);
            }).cases;
    return cases;
  }

  // No capabilities, so nothing can be judged: one finding, on a case of the first section.
  void cannot_be_asked(Subject& subject, const Fault& failure) {
    if (total_ == 0) throw spec::InputError("certify", 0, 0, "no cases to judge");
    const CaseInput input =
        options_.cases.empty()
            ? CaseInput{select_cases(sections_.front(), options_.seed, 1).cases.front(), Origin::generated}
            : options_.cases.front();
    const judge::ModelRun run = judge::run_model(input.c);
    Answer answer;
    answer.result = failure;
    const Judgement judgement = judge_answer({}, input.c, run, answer);
    const Finding seen = as_seen({}, input.c, judgement, answer, {});
    const CaseResult result = asked_and_judged(input.c, input.origin, run, answer, judgement);
    add(section_of(input.c.section), result);
    if (options_.judged) options_.judged({input.c, &answer, result});
    settle({{seen, [&](const auto& stop) { return settled(subject, seen, stop); }}});
  }

  Finding settled(Subject& subject, const Finding& seen, const std::function<bool()>& stop) const {
    return signed_by_us(make_finding(subject, seen, {options_.shrink_runs, options_.timeout, stop}));
  }

  Finding signed_by_us(Finding f) const { return signed_finding(std::move(f), options_.controller, options_.seed); }

  void run_all(Subject& first) {
    std::vector<std::jthread> helpers;
    for (unsigned job = 1; job < options_.jobs; ++job)
      helpers.emplace_back([this] {
        const std::unique_ptr<Subject> subject = new_subject();
        work(*subject);
      });
    work(first);
    helpers.clear();  // joins
    if (error_) std::rethrow_exception(error_);
  }

  void work(Subject& subject) {
    Work work{subject, {}};
    try {
      for (std::size_t index = 0; why_to_stop().empty() && (index = next_++) < total_;) {
        auto result = judge(work, case_at(index), index);
        if (!result) break;
        results_[index] = std::move(*result);
        report_progress();
      }
    } catch (const Stopped&) {  // NOLINT(bugprone-empty-catch): what was judged is there
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      // The error of the earliest case would need all cases: any is as good, and ends the certification.
      if (!error_) error_ = std::current_exception();
      next_ = total_;
    }
    const std::scoped_lock lock(mutex_);
    add(certificate_.clauses, work.clauses);
  }

  // None: what came while all was being ended says nothing.
  std::optional<CaseResult> judge(Work& work, const CaseInput& input, std::size_t index) {
    const spec::Case& c = input.c;
    Faults& faults = faults_of(c.section);
    if (faults.hopeless()) return told(c, nullptr, not_asked(c, input.origin, Result::not_run, std::string(kLeftOut)));
    const Capabilities& capabilities = certificate_.subject;
    if (std::string why = why_not_applicable(capabilities, c); !why.empty())
      return told(c, nullptr, not_asked(c, input.origin, Result::not_applicable, std::move(why)));
    if (is_long(c)) return judge_long(work, input, index, faults);
    const judge::ModelRun run = judge::run_model(c);
    const auto answer = ask(work, c, index, faults);
    if (!answer) return std::nullopt;
    return judge(work, input, index, faults, run, *answer);
  }

  // None: while all is being ended.
  std::optional<Answer> ask(Work& work, const spec::Case& c, std::size_t index, const Faults& faults) {
    // A controller that has hung before is not waited for that long again.
    std::optional<std::chrono::milliseconds> patience;
    if (faults.hangs > 0) patience = short_patience(work.subject, options_.timeout);
    Answer answer = work.subject.run(c, patience);
    if (!why_to_stop().empty()) return std::nullopt;
    work.asked.add(work.subject, index);
    return answer;
  }

  // With all events at hand.
  CaseResult judge(Work& work, const CaseInput& input, std::size_t index, Faults& faults, const judge::ModelRun& run,
                   const Answer& answer) {
    const spec::Case& c = input.c;
    const Capabilities& capabilities = certificate_.subject;
    Judgement j = judge_answer(capabilities, c, run, answer);
    const FailureKey key = key_of(c, j);
    faults.count(key, j.result == Result::differs && is_fault(key));
    if (j.result == Result::differs) keep(work, as_seen(capabilities, c, j, answer, {}), index);
    CaseResult r = asked_and_judged(c, input.origin, run, answer, std::move(j));
    if (r.origin == Origin::own) say_of_own(r, c, index, &c, &run);
    add(work.clauses, run.recorder.counts());
    return told(c, &answer, std::move(r));
  }

  // What is said of programs of the user's own alone; `drawn` with its run: of which there is a picture.
  static void say_of_own(CaseResult& r, const spec::Case& c, std::size_t index, const spec::Case* drawn,
                         const judge::ModelRun* run) {
    if (index < kMostPictures && drawn != nullptr) r.picture = picture_of(*drawn, *run);
    if (c.setup.control == spec::Control::fanuc) r.without_effect = words_without_effect(c);
  }

  // While it is read, as far as that is enough.
  std::optional<CaseResult> judge_long(Work& work, const CaseInput& input, std::size_t index, Faults& faults) {
    const spec::Case& c = input.c;
    const bool here = work.subject.is_fast_engine();
    std::optional<Answer> answer;
    if (!here) {
      answer = ask(work, c, index, faults);
      if (!answer) return std::nullopt;
    }
    const std::optional<Beginning> beginning = beginning_of(c);
    auto whole = certify::judge_long(certificate_.subject, c, here ? nullptr : &*answer, beginning);
    if (!whole) {
      const judge::ModelRun run = judge::run_model(c);
      if (!answer) answer = ask(work, c, index, faults);
      if (!answer) return std::nullopt;
      return judge(work, input, index, faults, run, *answer);
    }
    if (here) answer.emplace();
    faults.count({}, false);
    CaseResult r = asked_and_judged(c, input.origin, whole->fields, *answer, std::move(whole->judgement));
    if (r.origin == Origin::own)
      say_of_own(r, c, index, beginning ? &beginning->c : nullptr, beginning ? &beginning->run : nullptr);
    add(work.clauses, whole->clauses);
    return told(c, &*answer, std::move(r));
  }

  CaseResult told(const spec::Case& c, const Answer* answer, CaseResult result) {
    if (!options_.judged) return result;
    const std::scoped_lock lock(mutex_);
    options_.judged({c, answer, result});
    return result;
  }

  // The smallest of one kind is kept with all that was seen, and told at once.
  void keep(const Work& work, Finding seen, std::size_t index) {
    {
      const std::scoped_lock lock(mutex_);
      Failures& failures = failures_[seen.key];
      const std::pair size{count_blocks(seen.smallest.program), seen.smallest.program.size()};
      // Of two of one size the earlier counts, so that the order in which cases are judged does not.
      if (failures.cases++ > 0 && std::pair{failures.size, failures.index} < std::pair{size, index}) return;
      failures.size = size;
      failures.index = index;
    }
    if (seen.errors.empty()) seen.errors = work.subject.errors();
    std::vector<std::size_t> asked;
    if (work.subject.starts() > 0) asked = work.asked.before();
    seen.before = cases_at(std::span(asked).last(std::min(asked.size(), kRequestsKept)));
    seen = signed_by_us(std::move(seen));
    const std::scoped_lock lock(mutex_);
    Failures& failures = failures_.at(seen.key);
    if (failures.index != index) return;  // meanwhile another is the smallest
    failures.seen = std::move(seen);
    failures.asked = std::move(asked);
    if (options_.found) options_.found(failures.seen);
  }

  std::vector<spec::Case> cases_at(std::span<const std::size_t> indices) {
    std::vector<spec::Case> cases;
    cases.reserve(indices.size());
    for (const std::size_t index : indices) cases.push_back(case_at(index).c);
    return cases;
  }

  Faults& faults_of(const std::string& section) {
    const std::scoped_lock lock(mutex_);
    return faults_[section];
  }

  void report_progress() {
    if (!options_.progress) return;
    const std::scoped_lock lock(mutex_);
    options_.progress(++done_, total_);
  }

  SectionResult& section_of(const std::string& name) {
    const auto found = std::ranges::find(certificate_.sections, name, &SectionResult::section);
    if (found != certificate_.sections.end()) return *found;
    certificate_.sections.push_back({});
    certificate_.sections.back().section = name;
    return certificate_.sections.back();
  }

  // Section and origin of a case that was not looked at.
  void place(std::size_t index) {
    CaseResult& r = results_[index];
    if (!r.id.empty() || !r.section.empty()) return;
    const bool own = index < options_.cases.size();
    r.origin = own ? options_.cases[index].origin : Origin::generated;
    r.section = own ? options_.cases[index].c.section : sections_[(index - options_.cases.size()) / options_.generated];
    r.id = own ? options_.cases[index].c.id : std::string();
  }

  void summarize() {
    for (std::size_t i = 0; i < results_.size(); ++i) place(i);
    // Sections in the order of fuzz::sections(), then programs of the user's own.
    for (const std::string_view section : fuzz::sections())
      if (std::ranges::any_of(results_, [&](const CaseResult& r) { return r.section == section; }))
        section_of(std::string(section));
    std::set<std::string> setups;
    for (const CaseResult& r : results_) {
      add(section_of(r.section), r);
      if (!r.setup.empty()) setups.insert(r.setup);
      certificate_.without_effect.insert(r.without_effect.begin(), r.without_effect.end());
      if (!r.picture.empty()) certificate_.pictures.push_back({r.id, r.picture});
      // Vectors and generated programs are here to try what a control refuses, too.
      const bool beyond = r.verdict.beyond && r.origin != Origin::own;
      const bool left_out = r.result == Result::nothing_judged && r.verdict.left_out > 0;
      const bool settled = beyond || left_out || counted(r) == Result::agrees || r.result == Result::differs ||
                           r.result == Result::not_applicable;
      const bool interrupted = r.result == Result::not_run && r.why.empty();
      if (!settled && !interrupted && certificate_.unsettled.size() < kMostUnsettled)
        certificate_.unsettled.push_back({r.id, r.section, r.result, r.why});
    }
    certificate_.identity.setup_hash = setups_hash(setups);
    certificate_.identity.setups = setups.size();
  }

  void settle_all(Subject& subject) {
    std::vector<Sighting> sightings;
    for (const auto& [key, failures] : failures_) {
      Sighting sighting{failures.seen, [&](const auto& stop) {
                          Finding seen = failures.seen;
                          seen.before = cases_at(failures.asked);
                          return settled(subject, seen, stop);
                        }};
      sighting.finding.occurrences = failures.cases;
      sightings.push_back(std::move(sighting));
    }
    add_fields_never_sent(sightings);
    settle(std::move(sightings));
  }

  void settle(std::vector<Sighting> sightings) {
    SettlingOptions how = options_.settling;
    how.stop = [this] { return why_to_stop(); };
    how.settled = options_.found;
    Settled settled = certify::settle(std::move(sightings), how);
    certificate_.findings = std::move(settled.findings);
    certificate_.causes = std::move(settled.causes);
    certificate_.settling = how.budget;
  }

  // One each, on the first such case.
  void add_fields_never_sent(std::vector<Sighting>& sightings) {
    for (const NeverSent& field : never_sent(certificate_.subject.fields, results_)) {
      const std::string_view name = spec::field_name(field.field);
      if (std::ranges::any_of(sightings, [&](const Sighting& s) { return s.finding.difference.field == name; }))
        continue;
      const spec::Case c = case_at(field.first).c;
      sightings.push_back({never_sent_finding(c, c, field.field), [this, c, field](const auto& stop) {
                             const bool asked = !stop();
                             const Shrunk shrunk = shrunk_with(c, field.field, stop);
                             Finding f = never_sent_finding(c, shrunk.smallest, field.field);
                             f.runs = shrunk.runs;
                             f.complete = shrunk.complete && !stop();
                             f.seen = f.tried = asked ? 1 : 0;
                             return f;
                           }});
      sightings.back().finding.occurrences = field.cases;
    }
  }

  // The smallest case in which the field is due.
  [[nodiscard]] Shrunk shrunk_with(const spec::Case& c, spec::Field field, const std::function<bool()>& stop) const {
    std::size_t runs = 0;
    const auto still_due = [&](const spec::Case& smaller) {
      if (stop()) return false;
      ++runs;
      try {
        return fields_of(judge::run_model(smaller)).has(field);
      } catch (const std::exception&) {
        return false;
      }
    };
    Shrunk shrunk = shrink(c, still_due, {options_.shrink_runs});
    shrunk.runs = runs;
    return shrunk;
  }

  [[nodiscard]] Finding never_sent_finding(const spec::Case& c, const spec::Case& smallest, spec::Field field) const {
    Finding f;
    f.smallest = smallest;
    f.first_case = c.id;
    f.difference.kind = kNeverSent;
    f.difference.field = spec::field_name(field);
    f.difference.expected = "sent, as announced in the capabilities";
    f.difference.actual = "in no answer";
    const judge::ModelRun run = judge::run_model(f.smallest);
    const auto event = std::ranges::find_if(run.events, [&](const model::Event& e) { return fields_of(e).has(field); });
    if (event != run.events.end()) {
      f.difference.event = static_cast<std::size_t>(event - run.events.begin());
      f.difference.line = event->line;
      f.difference.clause = spec::naming_clause(event->clauses);
    }
    f.key = key_of(c, f.difference);
    f.subject = certificate_.subject;
    return signed_by_us(std::move(f));
  }

  const CertificationOptions& options_;
  std::vector<std::string> sections_;
  std::size_t total_ = 0;
  std::vector<std::vector<spec::Case>> generated_;  // by section
  std::mutex choosing_;
  Certificate certificate_;
  std::vector<CaseResult> results_;
  std::atomic<std::size_t> next_{0};
  std::uint64_t done_ = 0;
  std::mutex mutex_;
  std::map<std::string, Faults> faults_;
  std::map<FailureKey, Failures> failures_;
  std::exception_ptr error_;
};

}  // namespace

Certificate certify(const CertificationOptions& options) { return Certification(options).run(); }

}  // namespace toolcomp::certify

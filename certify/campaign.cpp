#include "certify/campaign.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <utility>

#include "certify/convert.h"
#include "certify/event_fields.h"
#include "certify/path_svg.h"
#include "certify/program_text.h"
#include "certify/selection.h"
#include "certify/shrink.h"
#include "corpus/sha256.h"
#include "fuzz/gen/generator.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"

namespace toolcomp::certify {
namespace {

// After this many hangs, or faults of any kind, in one section its remaining cases are not run.
constexpr unsigned kMostHangs = 2;
constexpr unsigned kMostFaults = 20;
// Programs of a faulty controller that shrinking tries again: each costs a restart, a hang its time-out.
constexpr std::size_t kMostFaultyRuns = 40;
// Cases with fewer events judged are counted apart.
constexpr std::uint64_t kFewestEvents = 3;
constexpr std::size_t kMostUnsettled = 100;
constexpr std::size_t kMostPictures = 20;

// What remains of one judged case.
struct CaseResult {
  Result result = Result::not_run;
  Origin origin = Origin::own;
  std::string section;
  std::string setup;  // JSON
  fuzz::Verdict verdict;
  FailureKey key;
  std::string id;
  std::string why;
  std::string picture;
  spec::FieldSet sent;  // by the controller
  spec::FieldSet due;   // as the model's events have them
};

// What a picture shows of a run: inside blocks under tool center point control the tool turns, so the picture has
// samples there, whether the case asks for them or not.
FastEvents drawn_events(const spec::Case& c, const fuzz::ModelRun& run) {
  constexpr std::uint32_t kSamples = 16;
  const bool moves_the_control_point = std::ranges::any_of(
      run.events, [](const model::Event& event) { return event.kind == spec::EventKind::move && event.tool_axis; });
  spec::Case sampled = c;
  sampled.samples = kSamples;
  const bool again = moves_the_control_point && c.samples < kSamples;
  FastEvents events;
  for (const model::Event& event : (again ? fuzz::run_model(sampled) : run).events) events.push_back(in_double(event));
  return events;
}

// The exact path, drawn.
std::string picture_of(const spec::Case& c, const fuzz::ModelRun& run) {
  return path_svg(drawn_events(c, run), c.setup.axes, path_options(c));
}

bool is_fault(const FailureKey& key) {
  constexpr std::array kFaults = {FaultKind::crash, FaultKind::hang, FaultKind::malformed, FaultKind::too_long};
  return std::ranges::any_of(kFaults, [&](FaultKind kind) { return key.kind == name(kind); });
}

// The time-out while shrinking: short, because a hanging controller uses it up again and again.
std::chrono::milliseconds short_patience(const Subject& subject, std::chrono::milliseconds timeout) {
  return std::min(timeout, std::chrono::milliseconds(200) + 10 * subject.slowest());
}

class Campaign {
 public:
  explicit Campaign(const CampaignOptions& options) : options_(options) {
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
    const std::unique_ptr<Subject> first = subject_of(options_.controller, options_.timeout, options_.reply_limit);
    const auto capabilities = first->capabilities();
    if (const auto* failure = std::get_if<Fault>(&capabilities)) {
      cannot_be_asked(*first, *failure);
      return std::move(certificate_);
    }
    certificate_.subject = std::get<Capabilities>(capabilities);
    expect_fine_resolution(certificate_.subject, options_.accepted_resolution);
    results_.resize(total_);
    run_all(*first);
    summarize();
    shrink_all(*first);
    find_fields_never_sent();
    return std::move(certificate_);
  }

 private:
  struct Faults {
    std::atomic<unsigned> hangs{0};
    std::atomic<unsigned> all{0};
  };

  void identify() {
    Identity& id = certificate_.identity;
    id.tool = std::string("toolcomp ") + TOOLCOMP_VERSION;
    try {
      id.tool_hash = corpus::sha256_file("/proc/self/exe");
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
    const Judgement j = judge_answer({}, input.c, fuzz::run_model(input.c), {failure, {}, {}});
    certificate_.sections.push_back({});
    SectionResult& section = certificate_.sections.back();
    section.section = input.c.section;
    ++section.cases[static_cast<std::size_t>(input.origin)];
    ++section.results[static_cast<std::size_t>(Result::differs)];
    certificate_.findings.push_back(finding(subject, {}, input.c, key_of(input.c, j)));
  }

  Finding finding(Subject& subject, const Capabilities& capabilities, const spec::Case& c,
                  const FailureKey& key) const {
    Finding f = make_finding(subject, capabilities, c, key, options_.shrink_runs, options_.timeout);
    f.controller = options_.controller;
    f.seed = std::to_string(options_.seed);
    f.tool = certificate_.identity.tool;
    return f;
  }

  void run_all(Subject& first) {
    std::vector<std::jthread> helpers;
    for (unsigned job = 1; job < options_.jobs; ++job)
      helpers.emplace_back([this] {
        const std::unique_ptr<Subject> subject =
            subject_of(options_.controller, options_.timeout, options_.reply_limit);
        work(*subject);
      });
    work(first);
    helpers.clear();  // joins
    if (error_) std::rethrow_exception(error_);
  }

  void work(Subject& subject) {
    std::vector<model::ClauseCount> clauses(spec::kClauseCount);
    try {
      for (std::size_t index = 0; (index = next_++) < total_;) {
        results_[index] = judge(subject, case_at(index), index < kMostPictures, clauses);
        report_progress();
      }
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      // The error of the earliest case would need all cases: any is as good, and ends the campaign.
      if (!error_) error_ = std::current_exception();
      next_ = total_;
    }
    const std::scoped_lock lock(mutex_);
    for (std::size_t i = 0; i < clauses.size(); ++i) {
      certificate_.clauses[i].reached += clauses[i].reached;
      certificate_.clauses[i].positive += clauses[i].positive;
      certificate_.clauses[i].negative += clauses[i].negative;
      certificate_.clauses[i].tie += clauses[i].tie;
    }
  }

  CaseResult judge(Subject& subject, const CaseInput& input, bool draw, std::vector<model::ClauseCount>& clauses) {
    const spec::Case& c = input.c;
    CaseResult r;
    r.origin = input.origin;
    r.section = c.section;
    r.id = c.id;
    Faults& faults = faults_of(c.section);
    if (faults.hangs >= kMostHangs || faults.all >= kMostFaults) {
      r.why = "left out after repeated faults";
      return r;
    }
    const Capabilities& capabilities = certificate_.subject;
    if (std::string why = why_not_applicable(capabilities, c); !why.empty()) {
      r.result = Result::not_applicable;
      r.why = std::move(why);
      return r;
    }
    const fuzz::ModelRun run = fuzz::run_model(c);
    // A controller that has hung before is not waited for that long again.
    std::optional<std::chrono::milliseconds> patience;
    if (faults.hangs > 0) patience = short_patience(subject, options_.timeout);
    const Answer answer = subject.run(c, patience);
    Judgement j = judge_answer(capabilities, c, run, answer);
    r.result = j.result;
    r.sent = answer.sent;
    // What is missing where something differs is part of that finding.
    const bool agrees = j.result == Result::agrees || j.result == Result::partly_judged;
    if (agrees && std::holds_alternative<TextEvents>(answer.result)) r.due = fields_of(run);
    r.key = key_of(c, j);
    r.why = std::move(j.why);
    r.setup = spec::write_setup_json(c.setup);
    if (draw && r.origin == Origin::own) r.picture = picture_of(c, run);
    r.verdict = std::move(j.verdict);
    if (j.result == Result::differs && is_fault(r.key)) {
      ++faults.all;
      if (r.key.kind == name(FaultKind::hang)) ++faults.hangs;
    }
    for (std::size_t i = 0; i < clauses.size(); ++i) {
      const model::ClauseCount& count = run.recorder.counts()[i];
      clauses[i].reached += count.reached;
      clauses[i].positive += count.positive;
      clauses[i].negative += count.negative;
      clauses[i].tie += count.tie;
    }
    return r;
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

  void summarize() {
    // Sections in the order of fuzz::sections(), then programs of the user's own.
    for (const std::string_view section : fuzz::sections())
      if (std::ranges::any_of(results_, [&](const CaseResult& r) { return r.section == section; }))
        section_of(std::string(section));
    std::set<std::string> setups;
    for (const CaseResult& r : results_) {
      SectionResult& s = section_of(r.section);
      ++s.cases[static_cast<std::size_t>(r.origin)];
      // Of a user's own program each counts; of golden and generated cases, which go where it is steep, their section.
      const bool wide = r.result == Result::partly_judged;
      const Result result = wide && r.origin != Origin::own ? Result::agrees : r.result;
      ++s.results[static_cast<std::size_t>(result)];
      s.wide_cases += wide ? 1 : 0;
      s.wide += r.verdict.wide;
      s.widths.add(r.verdict.widths);
      s.out_of_scope += r.verdict.out_of_scope;
      const bool judged = r.result == Result::agrees || r.result == Result::partly_judged;
      s.few_events += judged && r.verdict.events < kFewestEvents ? 1 : 0;
      s.values += r.verdict.values;
      s.decisions += r.verdict.decisions;
      s.near_ties += r.verdict.near_ties;
      s.ties += r.verdict.ties;
      // The distance of a wrong answer is a finding, not a rounding error.
      if (judged) {
        s.worst_ulp = std::max(s.worst_ulp, r.verdict.worst_ulp);
        s.worst_um = std::max(s.worst_um, r.verdict.worst_um);
      }
      if (!r.setup.empty()) setups.insert(r.setup);
      if (!r.picture.empty()) certificate_.pictures.push_back({r.id, r.picture});
      const bool settled = result == Result::agrees || result == Result::differs || result == Result::not_applicable;
      if (!settled && certificate_.unsettled.size() < kMostUnsettled)
        certificate_.unsettled.push_back({r.id, r.section, r.result, r.why});
    }
    corpus::Sha256 hash;
    for (const std::string& setup : setups) {
      hash.update(setup);
      hash.update("\n");
    }
    certificate_.identity.setup_hash = hash.hex();
    certificate_.identity.setups = setups.size();
  }

  void shrink_all(Subject& subject) {
    std::map<FailureKey, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < results_.size(); ++i)
      if (results_[i].result == Result::differs) groups[results_[i].key].push_back(i);
    for (const auto& [key, indices] : groups) {
      // The smallest program of the group is the shortest way down.
      std::optional<std::pair<std::pair<std::size_t, std::size_t>, std::size_t>> best;
      for (const std::size_t i : indices) {
        const std::string program = case_at(i).c.program;
        const std::pair size{std::pair{count_blocks(program), program.size()}, i};
        if (!best || size < *best) best = size;
      }
      Finding f = finding(subject, certificate_.subject, case_at(best->second).c, key);
      f.occurrences = indices.size();
      certificate_.findings.push_back(std::move(f));
    }
  }

  // Announced, due in a case, and in no answer: a finding each, on the first such case.
  void find_fields_never_sent() {
    spec::FieldSet sent;
    for (const CaseResult& r : results_) add(sent, r.sent);
    for (const std::string& name : certificate_.subject.fields) {
      const auto field = spec::find_field(name);
      if (!field || sent.has(*field)) continue;
      const auto due = std::ranges::find_if(results_, [&](const CaseResult& r) { return r.due.has(*field); });
      const bool known = std::ranges::any_of(certificate_.findings, [&](const Finding& f) { return f.field == name; });
      if (due == results_.end() || known) continue;
      Finding f = never_sent(case_at(static_cast<std::size_t>(due - results_.begin())).c, *field);
      f.occurrences = static_cast<std::uint64_t>(
          std::ranges::count_if(results_, [&](const CaseResult& r) { return r.due.has(*field); }));
      certificate_.findings.push_back(std::move(f));
    }
  }

  Finding never_sent(const spec::Case& c, spec::Field field) const {
    Finding f;
    Shrunk shrunk = shrink(c,
                           [field](const spec::Case& smaller) {
                             try {
                               return fields_of(fuzz::run_model(smaller)).has(field);
                             } catch (const std::exception&) {
                               return false;
                             }
                           },
                           {options_.shrink_runs});
    f.smallest = std::move(shrunk.smallest);
    f.runs = shrunk.runs;
    f.complete = shrunk.complete;
    f.first_case = c.id;
    f.key.section = c.section;
    f.key.kind = kNeverSent;
    f.field = spec::field_name(field);
    f.expected = "sent, as announced in the capabilities";
    f.actual = "in no answer";
    const fuzz::ModelRun run = fuzz::run_model(f.smallest);
    const auto event = std::ranges::find_if(run.events, [&](const model::Event& e) { return fields_of(e).has(field); });
    if (event != run.events.end()) {
      f.event = static_cast<std::size_t>(event - run.events.begin());
      f.line = event->line;
      if (!event->clauses.empty()) f.key.clause = spec::info(event->clauses.back()).id;
    }
    for (const model::Event& e : run.events) f.expected_events.push_back(certify::in_double(e));
    f.controller = options_.controller;
    f.seed = std::to_string(options_.seed);
    f.tool = certificate_.identity.tool;
    return f;
  }

  const CampaignOptions& options_;
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
  std::exception_ptr error_;
};

FastEvents in_double(const Answer& answer) {
  if (const auto* fast = std::get_if<FastEvents>(&answer.result)) return *fast;
  FastEvents events;
  if (const auto* text = std::get_if<TextEvents>(&answer.result))
    for (const spec::TextEvent& event : *text) events.push_back(certify::in_double(event));
  return events;
}

// A candidate of the shrinker, judged afresh; nothing if no control could read it. A controller that cannot even say
// hello has no capabilities and fails every case alike.
std::optional<Judgement> judge_candidate(Subject& subject, const Capabilities& capabilities, const spec::Case& c,
                                         const FailureKey& key, std::optional<std::chrono::milliseconds> patience) {
  try {
    const fuzz::ModelRun run = fuzz::run_model(c);
    // A fault costs a restart, a hang its time-out: no need to see it once more where the clause is another anyway.
    if (is_fault(key)) {
      const auto clause = clause_of_fault(run);
      if (key.clause != (clause ? spec::info(*clause).id : std::string_view())) return std::nullopt;
    }
    if (capabilities.fields.empty()) return judge_answer(capabilities, c, run, subject.run(c, patience));
    return judge_case(subject, capabilities, c, run, patience);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

// Runs the case once more and takes what differs, for people and for the picture. Whether it still fails with the key.
bool describe(Finding& f, Subject& subject, const Capabilities& capabilities, spec::Case c,
              std::chrono::milliseconds timeout) {
  f.smallest = std::move(c);
  f.smallest.expect.clear();
  f.smallest.has_expect = false;
  const fuzz::ModelRun run = fuzz::run_model(f.smallest);
  f.expected_events.clear();
  for (const model::Event& event : run.events) f.expected_events.push_back(certify::in_double(event));
  const Answer answer = subject.run(f.smallest, timeout);
  f.actual_events = in_double(answer);
  const Judgement j = judge_answer(capabilities, f.smallest, run, answer);
  f.errors = j.errors;
  if (!j.difference) return false;
  f.line = j.difference->line;
  f.field = j.difference->field;
  f.expected = j.difference->expected;
  f.actual = j.difference->actual;
  f.deviation_um = j.difference->deviation_um;
  f.event = j.difference->event;
  return j.result == Result::differs && key_of(f.smallest, j) == f.key;
}

// The judge on a program whose last event sends an axis to a place that is known.
std::string check_judge(const spec::Case& c, std::size_t axis, std::string_view place) {
  const fuzz::ModelRun run = fuzz::run_model(c);
  TextEvents events;
  constexpr int kDigits = 40;
  for (const model::Event& event : run.events) events.push_back(in_text(event, kDigits));
  const auto judged = [&](const TextEvents& answer) { return fuzz::judge(c, run, answer).outcome; };
  if (events.size() != 2 || events.back().axes[axis].v != place)
    return fmt::format("{}: the model does not send {} to {}", c.section, c.setup.axes.letter(axis), place);
  if (judged(events) != fuzz::Outcome::agrees) return c.section + ": the model's own events are not accepted";
  const TextEvents fewer(events.begin(), events.end() - 1);
  if (judged(fewer) != fuzz::Outcome::differs) return c.section + ": a missing event is not noticed";
  TextEvents moved = events;
  moved.back().axes.set(axis,
                        {std::string(place) + (place.find('.') == std::string_view::npos ? ".001" : "1"), {}, {}});
  if (judged(moved) != fuzz::Outcome::differs) return c.section + ": a deviation is not noticed";
  return {};
}

}  // namespace

Finding make_finding(Subject& subject, const Capabilities& capabilities, const spec::Case& failing,
                     const FailureKey& key, std::size_t max_runs, std::chrono::milliseconds timeout) {
  const auto fails = [&](const spec::Case& c, std::optional<std::chrono::milliseconds> patience) {
    const auto j = judge_candidate(subject, capabilities, c, key, patience);
    return j && j->result == Result::differs && key_of(c, *j) == key;
  };
  const std::chrono::milliseconds patience = short_patience(subject, timeout);
  const bool faulty = is_fault(key);
  std::size_t faulty_runs = 0;
  const auto given_up = [&] { return faulty && faulty_runs == kMostFaultyRuns; };
  const auto still_fails = [&](const spec::Case& c) {
    if (given_up()) return false;
    const bool failed = fails(c, patience);
    if (failed) ++faulty_runs;
    return failed;
  };
  Shrunk shrunk = shrink(failing, still_fails, {max_runs});
  Finding f;
  f.key = key;
  f.first_case = failing.id;
  f.runs = shrunk.runs;
  f.complete = shrunk.complete && !given_up();
  // What looks like a hang under a short time-out must be one under the real one; else the case stays as it was.
  if (!describe(f, subject, capabilities, std::move(shrunk.smallest), timeout)) {
    f.complete = false;
    describe(f, subject, capabilities, failing, timeout);
  }
  return f;
}

Certificate certify(const CampaignOptions& options) { return Campaign(options).run(); }

std::string self_check() {
  spec::Case fanuc;
  fanuc.id = "self-check";
  fanuc.section = "fanuc/tool-length-offset";
  fanuc.setup.h[1] = {spec::decimal(20), {}};
  fanuc.program = "G90 G43 Z100. H1\nG01 X10. Y5. F100\n";
  if (const std::string failure = check_judge(fanuc, 2, "120"); !failure.empty()) return failure;
  // A toroid cutter of 5 and 2 mm against a wall of 3-4-5: the tip moves by dR2 (n - t) + (rho' - rho) u, in X by
  // 0.1 * 0.6 + 0.2.
  spec::Case heidenhain;
  heidenhain.id = "self-check";
  heidenhain.section = "heidenhain/face-milling";
  heidenhain.dialect = "klartext";
  heidenhain.setup.control = spec::Control::heidenhain;
  heidenhain.setup.axes = spec::Axes("XYZ");
  spec::ToolRow tool;
  tool.number = 10;
  tool.r = spec::decimal(5);
  tool.r2 = spec::decimal(2);
  heidenhain.setup.tools = {tool};
  heidenhain.program =
      "TOOL CALL 1 Z DL+0.25 DR+0.3 DR2+0.1\nL Z+9 R0 FMAX M107\nLN X+0 Y+0 Z+0 NX+0.6 NY+0 NZ+0.8 R0 F500\n";
  if (const std::string failure = check_judge(heidenhain, 0, "0.26"); !failure.empty()) return failure;
  if (corpus::sha256("abc") != "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad")
    return "SHA-256 is wrong";
  return {};
}

}  // namespace toolcomp::certify

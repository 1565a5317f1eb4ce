#include "fuzz/campaign/campaign.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "fuzz/campaign/features.h"
#include "fuzz/campaign/summary.h"
#include "fuzz/gen/mutate.h"

namespace toolcomp::fuzz {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kLargestCorpus = 4096;
// One in so many fresh directed cases has one word changed, moved or left out.
constexpr std::uint64_t kSlipEvery = 6;

// What the jobs share.
struct Shared {
  explicit Shared(const CampaignOptions& o) : options(o), start(Clock::now()) {}

  const CampaignOptions& options;
  Clock::time_point start;
  std::atomic<std::uint64_t> executions{0};
  std::atomic<std::uint64_t> findings{0};
  std::atomic<std::uint64_t> features{0};
  std::atomic<bool> stop{false};
  std::mutex reporting;

  [[nodiscard]] double seconds() const { return std::chrono::duration<double>(Clock::now() - start).count(); }
};

std::string key(const spec::Case& c, const Difference& d) {
  // No clause enters a law: what it is broken by is known by its name.
  if (d.kind == "law") return fmt::format("{}|law|{}", c.section, d.field);
  return fmt::format("{}|{}|{}", c.section, d.kind, d.clause ? static_cast<int>(*d.clause) : -1);
}

// One thread: its corpus, its engines, its findings.
class Job {
 public:
  Job(Shared& shared, unsigned number)
      : shared_(shared), number_(number), reached_(kFeatures, false), sections_(shared.options.sections) {
    if (shared.options.subject) subject_ = shared.options.subject(number);
  }

  void run(std::uint64_t runs) {
    for (std::uint64_t i = 0; !stopped(); ++i) {
      if (shared_.options.runs != 0 ? i >= runs : shared_.seconds() >= shared_.options.seconds) break;
      execute(next(i));
      ++shared_.executions;
      if (shared_.findings >= shared_.options.max_findings) shared_.stop = true;
    }
  }

  CampaignResult& result() { return result_; }

 private:
  bool stopped() {
    if (shared_.options.stop && shared_.options.stop()) shared_.stop = true;
    return shared_.stop;
  }

  // Fresh cases and changed corpus cases in turns, sections and modes in turns.
  spec::Case next(std::uint64_t i) {
    const auto& modes = shared_.options.modes;
    const std::string& section = sections_[i % sections_.size()];
    mode_ = modes[(i / sections_.size()) % modes.size()];
    auto& corpus = corpus_[{section, mode_}];
    // Seeds of jobs and executions differ in the high and the low half.
    const std::uint64_t seed = shared_.options.seed ^ (static_cast<std::uint64_t>(number_) << 56U) ^ (i << 24U);
    SeededSource source(seed);
    spec::Case c;
    if (corpus.empty() || source.below(2) == 0) {
      const bool slips = mode_ == Mode::directed && source.below(kSlipEvery) == 0;
      c = slips ? generate_with_slip(section, source) : generate(section, mode_, source);
    } else {
      c = corpus[source.below(corpus.size())];
      if (source.below(10) == 0) c = splice(c, corpus[source.below(corpus.size())], source);
      mutate(c, mode_, source);
    }
    c.source = {"toolcomp fuzz", "1", fmt::format("{}", seed)};
    return c;
  }

  void execute(spec::Case c) {
    Trial trial = try_case(c, subject_);
    if (shared_.options.stop && shared_.options.stop()) return;
    add(result_, trial);
    if (trial.acceptance == Acceptance::not_decided) keep_shortest(result_.not_decided, {c, trial.verdict.undecided});
    if (trial.found()) {
      record(std::move(c), *trial.verdict.difference);
      return;
    }
    bool fresh = false;
    for (const std::uint32_t feature : features(trial.run.recorder))
      if (!reached_[feature]) {
        reached_[feature] = fresh = true;
        ++result_.features;
      }
    auto& corpus = corpus_[{c.section, mode_}];
    if (fresh && corpus.size() < kLargestCorpus) corpus.push_back(std::move(c));
    if (number_ == 0) shared_.features = result_.features;
  }

  void record(spec::Case c, const Difference& difference) {
    const auto [place, fresh] = index_.try_emplace(key(c, difference), result_.findings.size());
    if (!fresh) {
      ++result_.findings[place->second].executions;
      return;
    }
    ++shared_.findings;
    Finding finding{std::move(c), difference, 1, result_.executions};
    finding.input.id = fmt::format("finding.{}", finding.input.source.seed);
    finding.input.comment = explain(difference);
    if (shared_.options.on_finding) {
      const std::scoped_lock lock(shared_.reporting);
      shared_.options.on_finding(finding);
    }
    result_.findings.push_back(std::move(finding));
  }

  Shared& shared_;
  unsigned number_;
  std::vector<bool> reached_;
  std::vector<std::string> sections_;
  Mode mode_ = Mode::directed;
  std::map<std::pair<std::string, Mode>, std::vector<spec::Case>> corpus_;
  std::map<std::string, std::size_t> index_;
  Subject subject_;
  CampaignResult result_;
};

// A failure in one thread ends the others and is thrown by the campaign.
void run_guarded(Shared& shared, Job& job, std::uint64_t runs, std::exception_ptr& failure) {
  try {
    job.run(runs);
  } catch (...) {
    failure = std::current_exception();
    shared.stop = true;
  }
}

void report_progress(const Shared& shared, const std::atomic<unsigned>& running) {
  auto next = shared.start + std::chrono::seconds(1);
  while (running != 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (Clock::now() < next) continue;
    next += std::chrono::seconds(1);
    shared.options.progress({shared.executions, shared.seconds(), shared.features, shared.findings});
  }
}

CampaignOptions completed(CampaignOptions options) {
  if (options.sections.empty())
    for (const std::string_view section : sections()) options.sections.emplace_back(section);
  for (const std::string& section : options.sections)
    if (std::find(sections().begin(), sections().end(), section) == sections().end())
      throw std::invalid_argument(fmt::format("no generator for section \"{}\"", section));
  if (options.modes.empty()) options.modes = {Mode::directed};
  options.jobs = std::max(1U, options.jobs);
  return options;
}

}  // namespace

double CampaignResult::accepted_share() const {
  return executions == 0 ? 0 : static_cast<double>(acceptance[0]) / static_cast<double>(executions);
}

CampaignResult run_campaign(const CampaignOptions& options_given) {
  const CampaignOptions options = completed(options_given);
  Shared shared(options);
  std::vector<CampaignResult> parts(options.jobs);
  std::vector<std::exception_ptr> failures(options.jobs);
  std::atomic<unsigned> running{options.jobs};
  std::vector<std::thread> threads;
  threads.reserve(options.jobs);
  for (unsigned n = 0; n < options.jobs; ++n)
    threads.emplace_back([&, n] {
      const std::uint64_t runs = options.runs / options.jobs + (n < options.runs % options.jobs ? 1 : 0);
      // Exact values belong to the thread that made them: the job lives and dies here.
      Job job(shared, n);
      run_guarded(shared, job, runs, failures[n]);
      parts[n] = std::move(job.result());
      --running;
    });
  if (options.progress) report_progress(shared, running);
  for (std::thread& thread : threads) thread.join();
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);

  CampaignResult total;
  for (CampaignResult& part : parts) {
    part.seconds = shared.seconds();
    part.cores = 1;
    add(total, part);
  }
  return total;
}

}  // namespace toolcomp::fuzz

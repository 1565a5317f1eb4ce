// SPDX-License-Identifier: Apache-2.0
#include "fuzz/campaign/campaign.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "fuzz/campaign/driver.h"
#include "fuzz/campaign/summary.h"

namespace toolcomp::fuzz {
namespace {

using Clock = std::chrono::steady_clock;

// What the jobs share.
struct Shared {
  explicit Shared(const CampaignOptions& o) : options(o), start(Clock::now()) {}

  const CampaignOptions& options;
  Clock::time_point start;
  std::atomic<std::uint64_t> executions{0};
  std::atomic<std::uint64_t> findings{0};
  std::atomic<std::uint64_t> reached{0};
  std::atomic<bool> stop{false};
  std::mutex reporting;

  [[nodiscard]] double seconds() const { return std::chrono::duration<double>(Clock::now() - start).count(); }
};

// One thread: a search, and when it ends.
class Job {
 public:
  Job(Shared& shared, unsigned number) : shared_(shared), number_(number), driver_(options()) {}

  void run(std::uint64_t runs) {
    for (std::uint64_t i = 0; !stopped(); ++i) {
      if (shared_.options.runs != 0 ? i >= runs : shared_.seconds() >= shared_.options.seconds) break;
      driver_.step(i);
      ++shared_.executions;
      if (number_ == 0) shared_.reached = driver_.result().reached.total();
      if (shared_.findings >= shared_.options.max_findings) shared_.stop = true;
    }
  }

  [[nodiscard]] const CampaignResult& result() const { return driver_.result(); }

 private:
  bool stopped() {
    if (shared_.options.stop && shared_.options.stop()) shared_.stop = true;
    return shared_.stop;
  }

  DriverOptions options() {
    DriverOptions driver;
    driver.sections = shared_.options.sections;
    driver.modes = shared_.options.modes;
    driver.seed = shared_.options.seed;
    driver.number = number_;
    if (shared_.options.subject) driver.subject = shared_.options.subject(number_);
    driver.stop = shared_.options.stop;
    driver.on_finding = [this](const Finding& finding, bool fresh) {
      if (!fresh) return;
      ++shared_.findings;
      const std::scoped_lock lock(shared_.reporting);
      if (shared_.options.on_finding) shared_.options.on_finding(finding);
    };
    return driver;
  }

  Shared& shared_;
  unsigned number_;
  Driver driver_;
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
    shared.options.progress({shared.executions, shared.seconds(), shared.reached, shared.findings});
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
      parts[n] = job.result();
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

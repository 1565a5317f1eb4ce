// SPDX-License-Identifier: Apache-2.0
#include "certify/fuzzing/campaign.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <thread>
#include <utility>

#include "certify/fuzzing/third_voice.h"
#include "certify/running_mark.h"
#include "fuzz/campaign/diary.h"
#include "host/date.h"
#include "spec_engine/engine.h"

namespace toolcomp::certify::fuzzing {
namespace {

constexpr std::chrono::milliseconds kLook{20};
constexpr std::chrono::seconds kSave{1};
// After so many bad ends of workers in a row, without an execution between, something is wrong with all of them.
constexpr unsigned kMostFailures = 5;
// Of the third voice, seconds.
constexpr std::uint64_t kThirdSlice = 120;

BoardRow row_of(const fuzz::Target& target, const fuzz::Counters& sum) {
  BoardRow row;
  row.target = target.name;
  row.executions = sum.executions;
  row.per_second = sum.per_second();
  row.accepted = sum.accepted_share();
  if (!target.is_reader()) {
    const fuzz::Reached reached = fuzz::outcomes_reached(target.section, sum.clauses);
    row.outcomes = reached.seen;
    row.of = reached.all;
  }
  row.law_checks = sum.law_checks;
  row.ties = sum.ties;
  row.hits = sum.differed();
  return row;
}

fuzz::Counters so_far(const Worker& worker) {
  fuzz::Counters counters = counters_in(worker.folder());
  counters.milliseconds = worker.milliseconds();
  return counters;
}

class Campaign {
 public:
  explicit Campaign(const CampaignOptions& options)
      : options_(options),
        folder_(options.folder),
        mark_(options.folder, options.bench.controller),
        settler_(folder_, options.bench.program, options.bench.timeout, [this] { return stopped(); }) {
    take_up();
  }

  CampaignEnd run() {
    try {
      while (!over()) {
        begin_slices();
        look();
      }
      for (auto& worker : workers_) worker->stop();
      if (third_) third_->stop();
      while (!workers_.empty()) close(workers_.size() - 1);
      if (third_) close_third();
      settle_rest();
      settler_.stop();
      save();
    } catch (...) {
      // What the workers have found stays in their folders.
      workers_.clear();
      third_.reset();
      settler_.stop();
      throw;
    }
    show("");
    Found found = found_in(folder_);
    folder_.log(fmt::format("ends after {:.0f} s: {} executions, {}", seconds(), executions_,
                            findings_text(found.findings.size(), found.ways.size())));
    return {state_, std::move(found), folder_.waiting().size(), seconds(), executions_};
  }

 private:
  [[nodiscard]] double seconds() const { return std::chrono::duration<double>(host::Clock::now() - begun_).count(); }
  [[nodiscard]] bool stopped() const { return options_.stop && options_.stop(); }

  void take_up() {
    std::optional<State> earlier = folder_.load();
    if (earlier) {
      state_ = std::move(*earlier);
    } else {
      state_.begun = host::time_of_now();
      state_.seed = options_.seed;
    }
    ++state_.starts;
    save();
    folder_.remove_work();
    folder_.log(fmt::format("start {}: seed {}, shard {}/{}, {} targets, {} at a time", state_.starts, options_.seed,
                            options_.shard.index, options_.shard.count, options_.targets.size(), options_.jobs));
  }

  bool over() {
    if (stopped()) return true;
    if (options_.runs > 0) return all_done() && !third_ && !third_waits();
    if (!options_.seconds) return false;
    return left() == 0 && (workers_.empty() || seconds() > static_cast<double>(*options_.seconds) + kGrace);
  }

  [[nodiscard]] std::uint64_t left() const {
    const double rest = static_cast<double>(*options_.seconds) - seconds();
    return rest < 0.5 ? 0 : static_cast<std::uint64_t>(std::llround(rest));
  }

  [[nodiscard]] bool all_done() const { return workers_.empty() && done_.size() == options_.targets.size(); }

  // Where every target runs once, it comes when all are done, and has what they kept.
  [[nodiscard]] bool third_waits() const {
    if (!options_.specification || !spec_engine::available() || third_ || third_failures_ >= kMostFailures)
      return false;
    return options_.runs > 0 ? all_done() && !third_done_ : !options_.seconds || left() > 0;
  }

  void begin_third() {
    Slice slice;
    for (const fuzz::Target* target : options_.targets)
      if (!target->is_reader()) slice.heard.push_back(target);
    third_done_ = true;
    if (slice.heard.empty()) {
      third_failures_ = kMostFailures;
      return;
    }
    slice.target = &third_voice();
    slice.number = state_.next_slice;
    slice.seed = slice_seed(options_.seed, options_.shard, slice.number);
    if (options_.runs == 0) slice.seconds = options_.seconds ? std::min(left(), kThirdSlice) : kThirdSlice;
    state_.next_slice = slice.number + 1;
    state_.open.insert(slice.number);
    third_ = std::make_unique<Worker>(options_.bench, slice, folder_.work(slice.number), folder_.corpus());
    save();
  }

  void close_third() {
    const std::unique_ptr<Worker> worker = std::move(third_);
    const bool none = counters_in(worker->folder()).executions == 0 && worker->executions() == 0;
    folder_.close(state_, worker->slice().number, worker->milliseconds(), running());
    if (worker->how().empty() || stopped()) return;
    third_failures_ = none ? third_failures_ + 1 : 0;
    ++state_.ends[worker->how()];
    say(fmt::format("formal specification: {} after {} cases; {}", worker->how(), worker->executions(),
                    worker->errors()));
    if (worker->how() == "cannot write") throw std::runtime_error(cannot_write(worker->errors()));
    if (third_failures_ == kMostFailures) say("formal specification: no longer asked");
    // What was kept and not asked yet is asked by the next one.
    third_done_ = false;
  }

  void begin_slices() {
    if (third_waits()) begin_third();
    while (workers_.size() < options_.jobs && !stopped()) {
      const std::optional<Slice> slice = next_slice();
      if (!slice) return;
      state_.next_slice = slice->number + 1;
      state_.open.insert(slice->number);
      workers_.push_back(std::make_unique<Worker>(options_.bench, *slice, folder_.work(slice->number),
                                                  folder_.corpus(slice->target->name)));
      save();
    }
  }

  std::optional<Slice> next_slice() {
    Slice slice;
    slice.number = state_.next_slice;
    slice.seed = slice_seed(options_.seed, options_.shard, slice.number);
    if (options_.runs > 0) {
      // Every target once, in their order.
      if (begun_targets_ == options_.targets.size()) return std::nullopt;
      slice.target = options_.targets[begun_targets_++];
      slice.runs = options_.runs;
      return slice;
    }
    const std::optional<std::uint64_t> rest = options_.seconds ? std::optional(left()) : std::nullopt;
    if (rest && *rest == 0) return std::nullopt;
    if (slice_seconds_ == 0) slice_seconds_ = slice_seconds(rest, options_.jobs, options_.targets.size());
    slice.seconds = rest ? std::min(*rest, slice_seconds_) : slice_seconds_;
    std::vector<std::uint64_t> spent;
    for (const fuzz::Target* target : options_.targets) {
      std::uint64_t time = state_.targets[target->name].sum.milliseconds;
      // What runs counts as if it had run to its end.
      for (const auto& worker : workers_)
        if (worker->slice().target == target) time += worker->slice().seconds * 1000;
      spent.push_back(time);
    }
    const std::size_t first = options_.targets.size() * (options_.shard.index - 1) / options_.shard.count;
    slice.target = options_.targets[next_target(spent, first)];
    return slice;
  }

  void look() {
    const auto wait = kLook / static_cast<int>(std::max<std::size_t>(1, workers_.size()));
    for (std::size_t i = 0; i < workers_.size();) {
      if (workers_[i]->goes_on(wait))
        ++i;
      else
        close(i);
    }
    if (third_ && !third_->goes_on(kLook / 4)) close_third();
    if (workers_.empty()) std::this_thread::sleep_for(kLook);
    settle_step();
    if (host::Clock::now() - saved_ < kSave) return;
    if (third_) folder_.take_sightings(third_->slice().number);
    for (const auto& worker : workers_) folder_.take_sightings(worker->slice().number);
    save();
    show(settler_.busy() ? "settling" : "");
  }

  void close(std::size_t at) {
    const std::unique_ptr<Worker> worker = std::move(workers_[at]);
    workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(at));
    const std::uint64_t number = worker->slice().number;
    done_.push_back(worker->slice().target);
    const std::uint64_t counted = counters_in(worker->folder()).executions;
    executions_ += counted;
    folder_.close(state_, number, worker->milliseconds(), running());
    failures_ = counted == 0 && !worker->how().empty() && worker->executions() == 0 ? failures_ + 1 : 0;
    // An end asked for ends the workers too.
    if (worker->how().empty() || stopped()) return;
    ++state_.ends[worker->how()];
    say(fmt::format("{}: {} after {} executions, {:.1f} s; seed {}", worker->slice().target->name, worker->how(),
                    worker->executions(), static_cast<double>(worker->milliseconds()) / 1000, worker->slice().seed));
    if (worker->how() == "cannot write") throw std::runtime_error(cannot_write(worker->errors()));
    if (failures_ >= kMostFailures)
      throw std::runtime_error(fmt::format("{} workers in a row ended before their first execution: {}\n{}",
                                           kMostFailures, worker->how(), worker->errors()));
  }

  [[nodiscard]] std::string cannot_write(const std::string& errors) const {
    return folder_.root().string() + ": a worker could no longer write" + (errors.empty() ? "" : ": " + errors) +
           "; the findings so far are kept, and the next start resumes the campaign";
  }

  void settle_step() {
    settler_.step(state_, [this](const Settled& settled) {
      if (settled.fresh)
        say((settled.open ? "NOT DECIDED open/" : "FINDING findings/") + settled.name + ": " + settled.words);
    });
  }

  // Not after an end asked for: the next start goes on.
  void settle_rest() {
    while (!stopped() && (settler_.busy() || !folder_.waiting().empty())) {
      settle_step();
      std::this_thread::sleep_for(kLook / 4);
      if (host::Clock::now() - saved_ < kSave) continue;
      save();
      show("settling");
    }
  }

  [[nodiscard]] std::vector<Running> running() const {
    std::vector<Running> list;
    list.reserve(workers_.size());
    for (const auto& worker : workers_)
      list.push_back({worker->slice().number, worker->slice().target->name, worker->process(), worker->executions()});
    return list;
  }

  void save() {
    const host::Clock::time_point now = host::Clock::now();
    state_.milliseconds +=
        static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::milliseconds>(now - counted_).count());
    counted_ = saved_ = now;
    mark_.progress(executions_, 0);
    folder_.save(state_, running());
  }

  void say(const std::string& line) {
    folder_.log(line);
    if (options_.say) options_.say(line);
  }

  void show(const std::string& what) {
    if (!options_.show) return;
    State now = state_;
    for (const auto& worker : workers_) {
      fuzz::add(now.targets[worker->slice().target->name].sum, so_far(*worker));
    }
    if (third_) fuzz::add(now.specification.sum, so_far(*third_));
    BoardView view = view_of(now, options_.targets);
    view.specification.silent = silence(options_);
    view.seconds = seconds();
    if (const std::size_t ways = dossiers_in(folder_.findings()).size(); ways != ways_) {
      findings_ = found_in(folder_).findings.size();
      ways_ = ways;
    }
    view.findings = findings_;
    view.ways = ways_;
    view.waiting = folder_.waiting().size();
    view.state = what;
    for (BoardRow& row : view.rows) {
      row.fresh = window_.fresh(row.target, row.outcomes, host::Clock::now());
      for (const auto& worker : workers_) row.workers += worker->slice().target->name == row.target ? 1 : 0;
    }
    options_.show(view);
  }

  // Workers of libFuzzer end behind their time: the execution at hand, the corpus read.
  static constexpr double kGrace = 10;

  const CampaignOptions& options_;
  Folder folder_;
  RunningMark mark_;
  Settler settler_;
  State state_;
  std::vector<std::unique_ptr<Worker>> workers_;
  std::vector<const fuzz::Target*> done_;  // with runs: which are
  std::size_t begun_targets_ = 0;
  std::uint64_t slice_seconds_ = 0;
  std::uint64_t executions_ = 0;
  // In the folder: read again when there are more of them.
  std::size_t findings_ = 0;
  std::size_t ways_ = 0;
  unsigned failures_ = 0;
  std::unique_ptr<Worker> third_;
  unsigned third_failures_ = 0;
  bool third_done_ = false;  // with runs: it has begun
  OutcomeWindow window_;
  host::Clock::time_point begun_ = host::Clock::now();
  host::Clock::time_point counted_ = begun_;
  host::Clock::time_point saved_ = begun_;
};

}  // namespace

CampaignEnd run_campaign(const CampaignOptions& options) { return Campaign(options).run(); }

BoardView view_of(const State& state, const std::vector<const fuzz::Target*>& targets) {
  BoardView view;
  for (const fuzz::Target* target : targets) {
    const auto known = state.targets.find(target->name);
    view.rows.push_back(row_of(*target, known == state.targets.end() ? fuzz::Counters{} : known->second.sum));
  }
  view.specification.count = voice_count(state.specification);
  return view;
}

std::string silence(const CampaignOptions& options) {
  if (!options.specification || spec_engine::available()) return {};
  return "not built in (TOOLCOMP_FORMAL; needs Coq and OCaml)";
}

}  // namespace toolcomp::certify::fuzzing

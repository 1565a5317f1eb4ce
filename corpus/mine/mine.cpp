// SPDX-License-Identifier: Apache-2.0
#include "corpus/mine/mine.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>

#include "corpus/mine/approach.h"
#include "corpus/mine/harvest.h"
#include "corpus/select.h"
#include "fuzz/gen/generator.h"
#include "spec/language/input_error.h"
#include "spec/language/parameter.h"

namespace toolcomp::corpus {
namespace {

using exact::Sign;

// Shares of a section's runs: until then cases are met, decisions followed; the rest is for deviations.
constexpr double kMeet = 0.15;
constexpr double kFollow = 0.75;
// Programs from which the search for one decision begins, and those for deviations.
constexpr std::size_t kMostStarts = 10;
constexpr std::size_t kMostHeights = 6;
// With a margin of exactly zero among them.
constexpr std::size_t kMostTies = 3;
// Changes in a row that raise no deviation.
constexpr int kPatience = 150;
// One generated case in so many is changed in one word.
constexpr std::size_t kSlipEvery = 8;

// What the sections share.
struct Shared {
  Shared(const HardCases& b, const MineOptions& o) : before(b), options(o) {}

  const HardCases& before;
  const MineOptions& options;
  std::chrono::steady_clock::time_point begun = std::chrono::steady_clock::now();
  std::mutex reporting;

  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  }
};

struct Start {
  double value = 0;
  spec::Case c;
  std::string found;
};

// The search in one section, in one thread.
class SectionMine {
 public:
  SectionMine(Shared& shared, std::string section, double seconds)
      : shared_(shared),
        section_(std::move(section)),
        seconds_(seconds),
        begun_(shared.seconds()),
        source_(seed_of(section_, shared.options.seed, 0)),
        choose_(source_) {}

  void run() {
    meet();
    follow();
    raise();
    harvest_.shorten();
    report();
  }

  [[nodiscard]] const Harvest& harvest() const { return harvest_; }
  [[nodiscard]] std::uint64_t climbs() const { return climbs_; }
  [[nodiscard]] const std::map<spec::Clause, std::uint64_t>& searches() const { return searches_; }

 private:
  [[nodiscard]] bool stopped() const { return shared_.options.stop && shared_.options.stop(); }
  [[nodiscard]] bool over(double share) const {
    const MineOptions& options = shared_.options;
    if (stopped()) return true;
    if (options.runs != 0) return static_cast<double>(harvest_.runs()) >= share * static_cast<double>(options.runs);
    return shared_.seconds() - begun_ >= share * seconds_;
  }

  void report() {
    if (!shared_.options.progress) return;
    const std::lock_guard lock(shared_.reporting);
    shared_.options.progress(section_, harvest_.runs());
  }

  // The hard cases and golden vectors there are, all of them: they reach every outcome. Then generated ones.
  void meet() {
    for (const Nearest& n : shared_.before.nearest)
      if (n.c.section == section_) try_start(n.c, n.found);
    for (const Worst& w : shared_.before.worst)
      if (w.c.section == section_) try_start(w.c, w.found);
    if (std::filesystem::exists(default_folder() / "manifest.json"))
      for (const Vector& vector : read_vectors(default_folder(), {{section_}, {1, 1}})) {
        if (stopped()) break;
        try_start(vector.c, "golden " + vector.c.id);
      }
    for (std::size_t i = 1; !over(kMeet); ++i) {
      const std::uint64_t seed = seed_of(section_, shared_.options.seed, i);
      fuzz::SeededSource source(seed);
      const bool slip = i % kSlipEvery == 0;
      const spec::Case c =
          slip ? fuzz::generate_with_slip(section_, source) : fuzz::generate(section_, fuzz::Mode::directed, source);
      if (spec::has_allowed_parameters(c.setup))
        try_start(c, fmt::format("generated{} {}", slip ? ", slip," : "", seed));
    }
    report();
  }

  void try_start(spec::Case c, const std::string& found) {
    c.section = section_;
    const auto run = harvest_.look(c, found);
    if (!run) return;
    std::map<spec::Clause, double> least;
    for (const model::Decision& d : run->recorder.decisions()) {
      const auto [at, first] = least.try_emplace(d.clause, fuzz::margin(d));
      if (!first) at->second = std::min(at->second, fuzz::margin(d));
    }
    for (const auto& [clause, margin] : least) begin_with(starts_[clause], {margin, c, found});
    if (const auto verdict = harvest_.judge(c, found))
      for (const Deviation of : {Deviation::ulp, Deviation::um})
        raise_from(heights_[of], {deviation(*verdict, of), c, found});
  }

  static void begin_with(std::vector<Start>& starts, Start start) {
    const auto ties = static_cast<std::size_t>(std::ranges::count(starts, 0.0, &Start::value));
    if (start.value == 0 && ties >= kMostTies) return;
    const auto at = std::ranges::upper_bound(starts, start.value, {}, &Start::value);
    starts.insert(at, std::move(start));
    if (starts.size() > kMostStarts) starts.pop_back();
  }
  static void raise_from(std::vector<Start>& starts, Start start) {
    const auto at = std::ranges::upper_bound(starts, start.value, std::ranges::greater(), &Start::value);
    starts.insert(at, std::move(start));
    if (starts.size() > kMostHeights) starts.pop_back();
  }

  // Every decision in turn, from each of its starts.
  void follow() {
    for (std::size_t round = 0; !over(kFollow) && !starts_.empty(); ++round)
      for (const auto& [clause, starts] : starts_) {
        if (over(kFollow)) break;
        follow(clause, starts[round % starts.size()]);
        ++searches_[clause];
        report();
      }
  }

  void follow(spec::Clause clause, const Start& start) {
    const fuzz::Numbers numbers(start.c);
    std::optional<std::size_t> which;
    std::size_t nearest = 0;
    const Quantity quantity = [&](const fuzz::Point& point) -> std::optional<double> {
      const auto run = harvest_.look(numbers.with(point), from(start, numbers, point));
      if (!run) return std::nullopt;
      const auto& decisions = run->recorder.decisions();
      // At the start the nearest of the clause's decisions; from there on the one in its place.
      std::size_t seen = 0;
      std::optional<double> value;
      for (const model::Decision& d : decisions) {
        if (d.clause != clause) continue;
        const double margin = d.outcome == Sign::negative ? -fuzz::margin(d) : fuzz::margin(d);
        if (which && *which == seen) return margin;
        if (!which && (!value || std::fabs(margin) < std::fabs(*value))) {
          value = margin;
          nearest = seen;
        }
        ++seen;
      }
      if (!which && value) which = nearest;
      return value;
    };
    approach(numbers, quantity, choose_,
             {fuzz::usual_decimals(start.c.setup.control), [this] { return over(kFollow); }});
  }

  // Both deviations in turn.
  void raise() {
    for (std::size_t round = 0; !over(1) && !heights_.empty(); ++round)
      for (const Deviation of : {Deviation::ulp, Deviation::um}) {
        const std::vector<Start>& starts = heights_[of];
        if (starts.empty() || over(1)) continue;
        raise(of, starts[round % starts.size()]);
        ++climbs_;
        report();
      }
  }

  void raise(Deviation of, const Start& start) {
    const fuzz::Numbers numbers(start.c);
    const Quantity height = [&](const fuzz::Point& point) -> std::optional<double> {
      const auto verdict = harvest_.judge(numbers.with(point), from(start, numbers, point));
      return verdict ? std::optional(deviation(*verdict, of)) : std::nullopt;
    };
    climb(numbers, height, choose_, {0, [this] { return over(1); }}, kPatience);
  }

  static std::string from(const Start& start, const fuzz::Numbers& numbers, const fuzz::Point& point) {
    const std::string changed = numbers.changed(point);
    return changed.empty() ? start.found : start.found + "; then " + changed;
  }

  Shared& shared_;
  std::string section_;
  double seconds_;
  double begun_;
  fuzz::SeededSource source_;
  fuzz::Choices choose_;
  Harvest harvest_;
  std::uint64_t climbs_ = 0;
  std::map<spec::Clause, std::vector<Start>> starts_;
  std::map<spec::Clause, std::uint64_t> searches_;
  std::map<Deviation, std::vector<Start>> heights_;
};

// What one section came to.
struct Part {
  std::string section;
  std::uint64_t runs = 0;
  std::uint64_t climbs = 0;
  std::uint64_t not_searched = 0;
  std::map<spec::Clause, Searched> predicates;
  std::vector<Nearest> nearest;
  std::vector<Worst> worst;
  std::vector<Met> differ;
  std::vector<Met> undecided;
};

Part part_of(const SectionMine& mine, const std::string& section) {
  const Harvest& harvest = mine.harvest();
  Part part;
  part.section = section;
  part.runs = harvest.runs();
  part.climbs = mine.climbs();
  part.not_searched = harvest.not_searched();
  for (const auto& [clause, runs] : harvest.decided()) part.predicates[clause].runs = runs;
  for (const auto& [clause, searches] : mine.searches()) part.predicates[clause].searches = searches;
  part.nearest = harvest.nearest();
  part.worst = harvest.worst();
  part.differ = harvest.differ();
  part.undecided = harvest.undecided();
  return part;
}

// Of those for the same outcome of a clause the nearest; of equals the first.
void keep_nearest(std::vector<Nearest>& all, Nearest n) {
  const auto same = std::ranges::find_if(all, [&](const Nearest& other) {
    return other.clause == n.clause && other.outcome == n.outcome && is_usual(other) == is_usual(n);
  });
  if (same == all.end())
    all.push_back(std::move(n));
  else if (std::stod(n.margin) < std::stod(same->margin))
    *same = std::move(n);
}

// With more digits than usual only what is nearer for them.
void drop_needless(std::vector<Nearest>& all) {
  std::map<std::pair<spec::Clause, Sign>, double> in_usual;
  for (const Nearest& n : all)
    if (is_usual(n)) in_usual[{n.clause, n.outcome}] = std::stod(n.margin);
  std::erase_if(all, [&in_usual](const Nearest& n) {
    const auto usual = in_usual.find({n.clause, n.outcome});
    return !is_usual(n) && usual != in_usual.end() && usual->second <= std::stod(n.margin);
  });
}

void add(MineResult& result, Part part) {
  HardCases& hard = result.hard;
  hard.sections[part.section].runs += part.runs;
  hard.sections[part.section].searches += part.climbs;
  for (const auto& [clause, searched] : part.predicates) {
    hard.predicates[clause].runs += searched.runs;
    hard.predicates[clause].searches += searched.searches;
  }
  for (Nearest& n : part.nearest) keep_nearest(hard.nearest, std::move(n));
  for (Worst& w : part.worst) hard.worst.push_back(std::move(w));
  std::ranges::move(part.differ, std::back_inserter(result.differ));
  std::ranges::move(part.undecided, std::back_inserter(result.undecided));
  result.runs += part.runs;
  result.not_searched += part.not_searched;
}

}  // namespace

MineResult mine(const HardCases& before, const MineOptions& options) {
  for (const std::string& section : options.sections)
    if (std::ranges::find(fuzz::sections(), section) == fuzz::sections().end())
      throw spec::InputError("--section", 0, 0, "there is no section " + section);
  // Each once, whatever the order in which they are named.
  std::vector<std::string> sections;
  for (const std::string_view section : fuzz::sections())
    if (options.sections.empty() || std::ranges::find(options.sections, section) != options.sections.end())
      sections.emplace_back(section);

  Shared shared(before, options);
  std::vector<Part> parts(sections.size());
  std::vector<std::exception_ptr> failures(sections.size());
  std::atomic<std::size_t> next{0};
  const unsigned jobs = std::min<unsigned>(options.jobs, static_cast<unsigned>(sections.size()));
  const double seconds = options.seconds * jobs / static_cast<double>(sections.size());
  std::vector<std::thread> threads;
  threads.reserve(jobs);
  for (unsigned n = 0; n < jobs; ++n)
    threads.emplace_back([&] {
      for (std::size_t i = next++; i < sections.size(); i = next++) try {
          SectionMine mine(shared, sections[i], seconds);
          mine.run();
          parts[i] = part_of(mine, sections[i]);
        } catch (...) {
          failures[i] = std::current_exception();
        }
    });
  for (std::thread& thread : threads) thread.join();
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);

  MineResult result;
  result.hard = before;
  result.hard.seeds.insert(options.seed);
  // What was searched again is measured again.
  const auto searched = [&](const std::string& section) {
    return std::ranges::find(sections, section) != sections.end();
  };
  std::erase_if(result.hard.nearest, [&](const Nearest& n) { return searched(n.c.section); });
  std::erase_if(result.hard.worst, [&](const Worst& w) { return searched(w.section); });
  for (Part& part : parts) add(result, std::move(part));
  drop_needless(result.hard.nearest);
  return result;
}

}  // namespace toolcomp::corpus

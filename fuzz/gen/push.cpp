// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/push.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "fuzz/gen/numbers.h"
#include "judge/oracle/verdict.h"
#include "spec/language/input_error.h"

namespace toolcomp::fuzz {
namespace {

// Numbers that are asked whether the decision hangs on them, and steps along the first that does.
constexpr int kAsked = 6;
constexpr int kSecants = 4;
// Farther than this no number is moved, in units of its last digit.
constexpr double kFarthestPush = 1e12;

// Lines before a decision's own whose numbers it mostly hangs on, and how often it is one of these, in percent.
constexpr std::uint64_t kLinesBefore = 2;
constexpr std::uint64_t kNear = 85;

// One decision of a run: the n-th of its clause.
struct Followed {
  spec::Clause clause{};
  std::size_t place = 0;
  std::uint64_t line = 0;
};

double signed_margin(const model::Decision& decision) {
  return decision.outcome == exact::Sign::negative ? -judge::margin(decision) : judge::margin(decision);
}

// Of one clause, each as likely, the decision nearest to its boundary that is no tie.
std::optional<Followed> chosen(const std::vector<model::Decision>& decisions, Choices& choose) {
  struct Nearest {
    double margin = 0;
    std::size_t place = 0;
    std::size_t seen = 0;
    std::uint64_t line = 0;
  };
  std::map<spec::Clause, Nearest> nearest;
  for (const model::Decision& decision : decisions) {
    const double m = judge::margin(decision);
    Nearest& n = nearest[decision.clause];
    if (m > 0 && (n.margin == 0 || m < n.margin)) {
      n.margin = m;
      n.place = n.seen;
      n.line = decision.line;
    }
    ++n.seen;
  }
  std::erase_if(nearest, [](const auto& entry) { return entry.second.margin == 0; });
  if (nearest.empty()) return std::nullopt;
  const auto at = std::next(nearest.begin(), static_cast<std::ptrdiff_t>(choose.below(nearest.size())));
  return Followed{at->first, at->second.place, at->second.line};
}

std::optional<double> value_of(const Followed& followed, const std::vector<model::Decision>& decisions) {
  std::size_t seen = 0;
  for (const model::Decision& decision : decisions)
    if (decision.clause == followed.clause && seen++ == followed.place) return signed_margin(decision);
  return std::nullopt;
}

// A number that the decision may hang on: mostly of its own block or of those just before.
std::size_t chosen(const Numbers& numbers, const Followed& followed, Choices& choose) {
  std::vector<std::size_t> near;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (numbers.line(i) <= followed.line && numbers.line(i) + kLinesBefore >= followed.line) near.push_back(i);
  if (near.empty() || !choose.chance(kNear)) return choose.below(numbers.size());
  return near[choose.below(near.size())];
}

// The model threw on this case.
struct Thrown : std::exception {
  explicit Thrown(spec::Case on) : c(std::move(on)) {}
  spec::Case c;
};

std::vector<model::Decision> decisions_of(const spec::Case& c) {
  try {
    return judge::run_model(c).recorder.decisions();
  } catch (const spec::InputError&) {
    return {};
  } catch (const std::exception&) {
    throw Thrown(c);
  }
}

// The way of one number: the decision's signed margin, a step of the number's last digit at a time.
class Along {
 public:
  Along(const Numbers& numbers, std::size_t number, int decimals, Followed followed)
      : numbers_(numbers), number_(number), decimals_(decimals), followed_(followed) {}

  std::optional<double> value(std::int64_t steps) {
    const auto there = moved(numbers_.values()[number_], steps, decimals_);
    if (!there) return std::nullopt;
    point_ = numbers_.values();
    point_[number_] = *there;
    return value_of(followed_, decisions_of(numbers_.with(point_)));
  }
  // Where value() was asked last.
  [[nodiscard]] spec::Case here() const { return numbers_.with(point_); }

 private:
  const Numbers& numbers_;
  std::size_t number_;
  int decimals_;
  Followed followed_;
  Point point_;
};

// By secants from a first step that changes the value, where `along` stands; the nearest case met, the first step among
// them, if it is nearer than the start.
std::optional<spec::Case> nearer(Along& along, double start, double first) {
  std::optional<spec::Case> best;
  double least = std::fabs(start);
  if (std::fabs(first) < least) {
    least = std::fabs(first);
    best = along.here();
  }
  std::int64_t before = 0;
  double value_before = start;
  std::int64_t now = 1;
  double value_now = first;
  for (int i = 0; i < kSecants && value_now != value_before; ++i) {
    const double slope = (value_now - value_before) / static_cast<double>(now - before);
    const double at = static_cast<double>(now) - value_now / slope;
    if (!std::isfinite(at) || std::fabs(at) > kFarthestPush) break;
    const std::int64_t next = std::llround(at);
    if (next == now || next == before) break;
    const auto there = along.value(next);
    if (!there) break;
    before = std::exchange(now, next);
    value_before = std::exchange(value_now, *there);
    if (std::fabs(value_now) >= least) continue;
    least = std::fabs(value_now);
    best = along.here();
  }
  return best;
}

}  // namespace

bool push_toward_boundary(spec::Case& c, Choices& choose) {
  if (!is_searched(c)) return false;
  try {
    const std::vector<model::Decision> decisions = decisions_of(c);
    const auto followed = chosen(decisions, choose);
    if (!followed) return false;
    const double start = *value_of(*followed, decisions);
    const Numbers numbers(c);
    if (numbers.size() == 0) return false;
    for (int i = 0; i < kAsked; ++i) {
      const std::size_t number = chosen(numbers, *followed, choose);
      Along along(numbers, number, numbers.is_whole(number) ? 0 : usual_decimals(c.setup.control), *followed);
      const auto first = along.value(1);
      if (!first || *first == start) continue;
      if (auto found = nearer(along, start, *first)) {
        c = *std::move(found);
        return true;
      }
    }
  } catch (Thrown& thrown) {
    c = std::move(thrown.c);
    return true;
  }
  return false;
}

}  // namespace toolcomp::fuzz

// SPDX-License-Identifier: Apache-2.0
#include "corpus/mine/approach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace toolcomp::corpus {
namespace {

// Numbers that are tried, and pairs of those that the quantity hangs on.
constexpr std::size_t kMostSites = 24;
constexpr int kPairs = 3;
constexpr int kMostSecants = 28;
// Values of the second number to either side, and how many of them are tried on each side of zero.
constexpr std::array<std::int64_t, 3> kSpans = {8, 400, 20'000};
constexpr std::size_t kTried = 6;
// Farther than this the step back cannot be told in double.
constexpr double kFarthest = 1e15;

struct Site {
  std::size_t number = 0;
  int decimals = 0;
  double slope = 0;  // of the quantity, a step
};

class Approach {
 public:
  Approach(const fuzz::Numbers& numbers, const Quantity& quantity, fuzz::Choices& choose,
           const ApproachOptions& options)
      : numbers_(numbers), quantity_(quantity), choose_(choose), options_(options), at_(numbers.values()) {}

  void run() {
    for (const bool all_digits : {false, true}) {
      nearest_.reset();
      const std::optional<double> here = value(at_);
      if (!here) return;
      const std::vector<Site> sites = slopes(*here, all_digits);
      for (int i = 0; i < kPairs && !sites.empty() && !options_.stop(); ++i) along(sites, i, *here);
      if (nearest_) at_ = nearest_point_;
    }
  }

 private:
  std::optional<double> value(const fuzz::Point& point) {
    if (options_.stop()) return std::nullopt;
    const std::optional<double> v = quantity_(point);
    if (v && *v != 0 && (!nearest_ || std::fabs(*v) < *nearest_)) {
      nearest_ = std::fabs(*v);
      nearest_point_ = point;
    }
    return v;
  }

  // The point with one number moved.
  static std::optional<fuzz::Point> stepped(const fuzz::Point& point, const Site& site, std::int64_t steps) {
    const auto number = fuzz::moved(point[site.number], steps, site.decimals);
    if (!number) return std::nullopt;
    fuzz::Point next = point;
    next[site.number] = *number;
    return next;
  }
  std::optional<double> value(const fuzz::Point& point, const Site& site, std::int64_t steps) {
    const auto next = stepped(point, site, steps);
    return next ? value(*next) : std::nullopt;
  }

  // The numbers the quantity hangs on; those first along which zero is the fewest steps away.
  std::vector<Site> slopes(double here, bool all_digits) {
    std::vector<std::size_t> order(numbers_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    for (std::size_t i = 1; i < order.size(); ++i) std::swap(order[i], order[choose_.below(i + 1)]);
    if (order.size() > kMostSites) order.resize(kMostSites);
    std::vector<Site> sites;
    for (const std::size_t number : order) {
      Site site{number, all_digits ? fuzz::most_decimals(at_[number]) : options_.decimals, 0};
      if (numbers_.is_whole(number)) site.decimals = 0;
      if (const std::optional<double> above = value(at_, site, 1))
        site.slope = *above - here;
      else if (const std::optional<double> below = value(at_, site, -1))
        site.slope = here - *below;
      if (site.slope != 0) sites.push_back(site);
    }
    std::ranges::sort(sites, {}, [here](const Site& s) { return std::pair(std::fabs(here / s.slope), s.number); });
    return sites;
  }

  void along(const std::vector<Site>& sites, int pair, double here) {
    // The nearest zero first, then any.
    Site x = sites[pair == 0 ? 0 : choose_.below(sites.size())];
    const std::optional<fuzz::Point> root = solved(x, here);
    if (!root || sites.size() < 2) return;
    const Site& y = sites[choose_.below(sites.size())];
    if (y.number == x.number) return;
    for (const std::int64_t span : kSpans) comb(*root, x, y, span);
  }

  // The point along x nearest to zero; the slope of x becomes the one there.
  std::optional<fuzz::Point> solved(Site& x, double here) {
    std::int64_t before = 0;
    double value_before = here;
    std::int64_t now = 0;
    double value_now = here;
    std::optional<std::int64_t> below;
    std::optional<std::int64_t> above;
    double slope = x.slope;
    for (int i = 0; i < kMostSecants && value_now != 0; ++i) {
      const double way = -value_now / slope;
      if (!std::isfinite(way) || std::fabs(way) > kFarthest) break;
      std::int64_t next = now + std::llround(way);
      if (next == now) next = now + (way < 0 ? -1 : 1);
      const bool between = below && above;
      if (between && (next <= std::min(*below, *above) || next >= std::max(*below, *above)))
        next = *below + (*above - *below) / 2;
      std::optional<double> there = value(at_, x, next);
      for (int halves = 0; !there && halves < 6 && next != now; ++halves) {
        next = now + (next - now) / 2;
        there = value(at_, x, next);
      }
      if (!there || next == now) break;
      before = now;
      value_before = value_now;
      now = next;
      value_now = *there;
      (value_now < 0 ? below : above) = now;
      if (value_now != value_before) slope = (value_now - value_before) / static_cast<double>(now - before);
      if (below && above && std::llabs(*above - *below) <= 1) break;
    }
    const double least = std::min(std::fabs(value_now), std::fabs(value_before));
    const bool better = std::fabs(value_before) < std::fabs(value_now) && value_before != 0;
    if (std::fabs(least) > std::fabs(here)) return std::nullopt;
    x.slope = slope;
    return stepped(at_, x, better ? before : now);
  }

  // How far along x zero lies from a point, in steps; nothing where it cannot be told.
  std::optional<double> distance(const fuzz::Point& root, const Site& x, const Site& y, std::int64_t along,
                                 double expected) {
    const auto moved_along = stepped(root, y, along);
    if (!moved_along) return std::nullopt;
    double at = expected;
    for (int i = 0; i < 3; ++i) {
      if (std::fabs(at) > kFarthest) return std::nullopt;
      const std::int64_t n = std::llround(at);
      const std::optional<double> there = value(*moved_along, x, n);
      if (!there) return std::nullopt;
      const double off = -*there / x.slope;
      at = static_cast<double>(n) + off;
      if (std::fabs(off) <= 1) return at;
    }
    return std::nullopt;
  }

  struct Tooth {
    double off = 0;  // of zero from the nearest whole step
    std::int64_t along = 0;
    std::int64_t steps = 0;
  };

  void comb(const fuzz::Point& root, const Site& x, const Site& y, std::int64_t span) {
    const std::optional<double> here = distance(root, x, y, 0, 0);
    if (!here) return;
    const double lean = -y.slope / x.slope * static_cast<double>(span);
    const std::optional<double> right = distance(root, x, y, span, *here + lean);
    if (!right) return;
    const std::optional<double> left = distance(root, x, y, -span, 2 * *here - *right);
    if (!left) return;
    const auto s = static_cast<double>(span);
    const double b = (*right - *left) / (2 * s);
    const double c = ((*right - *here) + (*left - *here)) / (2 * s * s);
    std::vector<Tooth> sides[2];
    for (std::int64_t k = -2 * span; k <= 2 * span; ++k) {
      const auto along = static_cast<double>(k);
      const double at = *here + along * (b + along * c);
      if (k == 0 || std::fabs(at) > kFarthest) continue;
      const double whole = std::round(at);
      sides[at > whole ? 0 : 1].push_back({std::fabs(at - whole), k, static_cast<std::int64_t>(whole)});
    }
    for (std::vector<Tooth>& side : sides) {
      const auto less = [](const Tooth& one, const Tooth& other) {
        return std::tie(one.off, one.along) < std::tie(other.off, other.along);
      };
      const auto end = side.begin() + static_cast<std::ptrdiff_t>(std::min(kTried, side.size()));
      std::partial_sort(side.begin(), end, side.end(), less);
      for (auto tooth = side.begin(); tooth != end; ++tooth)
        if (const auto point = stepped(root, y, tooth->along)) value(*point, x, tooth->steps);
    }
  }

  const fuzz::Numbers& numbers_;
  const Quantity& quantity_;
  fuzz::Choices& choose_;
  const ApproachOptions& options_;
  fuzz::Point at_;
  std::optional<double> nearest_;
  fuzz::Point nearest_point_;
};

}  // namespace

void approach(const fuzz::Numbers& numbers, const Quantity& quantity, fuzz::Choices& choose,
              const ApproachOptions& options) {
  Approach(numbers, quantity, choose, options).run();
}

fuzz::Point climb(const fuzz::Numbers& numbers, const Quantity& height, fuzz::Choices& choose,
                  const ApproachOptions& options, int patience) {
  fuzz::Point at = numbers.values();
  std::optional<double> highest = height(at);
  if (!highest) return at;
  for (int idle = 0; numbers.size() > 0 && idle < patience && !options.stop(); ++idle) {
    const std::size_t number = choose.below(numbers.size());
    const int decimals =
        numbers.is_whole(number) ? 0 : static_cast<int>(choose.between(-2, fuzz::most_decimals(at[number])));
    // Counted in the last digit there is, so that a number with many of them still goes by tens and hundreds.
    const int last = std::max({decimals, static_cast<int>(at[number].decimals), 0});
    std::int64_t steps = choose.between(1, 9) * (choose.chance(50) ? 1 : -1);
    for (int i = decimals; i < last; ++i) steps *= 10;
    const auto next = fuzz::moved(at[number], steps, last);
    if (!next) continue;
    fuzz::Point point = at;
    point[number] = *next;
    const std::optional<double> there = height(point);
    if (!there || *there < *highest) continue;
    if (*there > *highest) idle = -1;
    highest = there;
    at = std::move(point);
  }
  return at;
}

}  // namespace toolcomp::corpus

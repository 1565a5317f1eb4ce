// SPDX-License-Identifier: Apache-2.0
#include "corpus/flank.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "corpus/counts.h"

namespace toolcomp::corpus {
namespace {

// Lengths and angles are counts of 1/10,000 mm and degree, formulas have kFine parts of one.
constexpr std::int64_t kCount = 10'000;
constexpr std::int64_t kFine = std::int64_t{1} << 20U;
constexpr std::int64_t kOne = std::int64_t{1} << 56U;  // 1 as a sine or cosine
constexpr std::int64_t kPi = 226'375'608'064'910'080;  // pi of kOne
constexpr std::int64_t kDirection = 1'000'000;         // I J K
constexpr std::int64_t kHighest = 24;                  // mm above the hub: first pass
constexpr std::int64_t kLowest = 2;                    // last pass
constexpr std::int64_t kRetract = 15;                  // mm along the tool
constexpr std::size_t kMostInAPass = 2'000;            // while there are passes of their own for the rest
constexpr std::size_t kMostPasses = 20;

// Where b is parts of kOne.
Wide times(Wide a, Wide b) { return (a * b) >> 56U; }

struct Turn {
  Wide cos = kOne;
  Wide sin = 0;
};

// Of n / d degrees, within two turns, by the power series.
Turn turn(Wide n, Wide d) {
  const Wide x = n * kPi / (180 * d);
  Turn sum;
  sum.sin = x;
  Wide power = x;
  for (int k = 2; power != 0; k += 2) {
    power = times(power, x) / k;
    const bool minus = k % 4 == 2;
    sum.cos += minus ? -power : power;
    power = times(power, x) / (k + 1);
    sum.sin += minus ? -power : power;
  }
  return sum;
}

using Triple = std::array<std::int64_t, 3>;

// Where a pass stands at one place of the blade: counts, and I J K of kDirection.
struct Pose {
  Triple point{};
  std::int64_t b = 0;
  std::int64_t c = 0;
  Triple tool{};
};

// The place u = j / n, `height` mm above the hub along the ruling.
Pose pose(std::size_t j, std::size_t n, Wide height_n, Wide height_d) {
  const auto u = static_cast<Wide>(j);
  const auto d = static_cast<Wide>(n);
  Pose p;
  // 10,000 (68 - 44u + 6 sin 360u), 10,000 (55u + 12 cos 180u).
  p.b = nearest((68 * d - 44 * u) * kCount * kOne + 6 * turn(360 * u, d).sin * kCount * d, kOne * d);
  p.c = nearest(55 * u * kCount * kOne + 12 * turn(180 * u, d).cos * kCount * d, kOne * d);
  const Turn b = turn(p.b, kCount);
  const Turn c = turn(p.c, kCount);
  const std::array<Wide, 3> tool{times(b.sin, c.cos), times(b.sin, c.sin), b.cos};
  const Turn quarter = turn(90 * u, d);
  const Turn wrap = turn(55 * u, d);
  const Wide radius = times((80 * static_cast<Wide>(kOne) - 50 * quarter.cos) * kCount, kFine);
  const std::array<Wide, 3> hub{times(radius, wrap.cos), times(radius, wrap.sin),
                                times((50 * static_cast<Wide>(kOne) - 50 * quarter.sin) * kCount, kFine)};
  for (std::size_t i = 0; i < 3; ++i) {
    p.point[i] = nearest(hub[i] + times(height_n * kCount * kFine / height_d, tool[i]), kFine);
    p.tool[i] = nearest(tool[i] * kDirection, kOne);
  }
  return p;
}

class Writer {
 public:
  explicit Writer(const FlankOptions& options) : options_(options), vector_(options.tool == FlankTool::vector) {
    if (options.blocks < kLeastFlank || options.blocks > kMostFlank)
      throw std::invalid_argument(fmt::format("a flank has {} to {} blocks", kLeastFlank, kMostFlank));
    flank_.passes = std::clamp((options.blocks + kMostInAPass - 1) / kMostInAPass, std::size_t{2}, kMostPasses);
  }

  Flank write() {
    line("%");
    line(fmt::format("O0200 (FLANK OF AN IMPELLER BLADE, {} BLOCKS IN {} PASSES, TOOL AXIS BY {})", options_.blocks,
                     flank_.passes, vector_ ? "I J K" : "B C"));
    line("G90 G17 G94");
    for (std::size_t i = 0; i < flank_.passes; ++i) pass(i);
    line("M30");
    line("%");
    flank_.setup = setup();
    return std::move(flank_);
  }

 private:
  void line(const std::string& text) {
    flank_.program += text;
    flank_.program += '\n';
  }

  static std::string words(const Triple& p) {
    return fmt::format("X{} Y{} Z{}", decimal(p[0], 4), decimal(p[1], 4), decimal(p[2], 4));
  }
  [[nodiscard]] std::string tool_words(const Pose& p) const {
    if (vector_)
      return fmt::format(" I{} J{} K{}", decimal(p.tool[0], 6), decimal(p.tool[1], 6), decimal(p.tool[2], 6));
    return fmt::format(" B{} C{}", decimal(p.b, 4), decimal(p.c, 4));
  }

  // As far before (behind) the flank's end as `inner` lies behind (before) it.
  static Triple beyond(const Pose& end, const Pose& inner) {
    Triple p{};
    for (std::size_t i = 0; i < 3; ++i) p[i] = 2 * end.point[i] - inner.point[i];
    return p;
  }
  static Triple retracted(Triple p, const Pose& end) {
    for (std::size_t i = 0; i < 3; ++i) p[i] += nearest(static_cast<Wide>(end.tool[i]) * kRetract * kCount, kDirection);
    return p;
  }

  // Even passes (from 0) go from u = 0 to 1, odd ones back.
  void pass(std::size_t number) {
    const std::size_t n = options_.blocks * (number + 1) / flank_.passes - options_.blocks * number / flank_.passes;
    const bool back = number % 2 != 0;
    const auto last = static_cast<Wide>(flank_.passes - 1);
    const auto done = static_cast<Wide>(number);
    const auto at = [&](std::size_t j) {
      return pose(back ? n - j : j, n, kHighest * (last - done) + kLowest * done, last);
    };
    const Pose first = at(0);
    const Pose end = at(n);
    const Triple entry = beyond(first, at(n / 16));
    const Triple exit = beyond(end, at(n - n / 16));
    const int code = vector_ ? 6 : 2;
    if (number == 0) start_ = {retracted(entry, first), first};
    line(fmt::format("(PASS {})", number + 1));
    line(fmt::format("G00 {}{}{}", vector_ && number == 0 ? "G43.5 H0 " : "", words(retracted(entry, first)),
                     tool_words(first)));
    line("G01 " + words(entry) + " F3000");
    line(fmt::format("G{}.{} D1 {} F1500", back ? 42 : 41, code, words(first.point)));
    for (std::size_t j = 1; j <= n; ++j) {
      const Pose p = at(j);
      line(words(p.point) + tool_words(p));
    }
    line("G40 " + words(exit));
    line("G00 " + words(retracted(exit, end)));
  }

  [[nodiscard]] std::string setup() const {
    const std::string made =
        "# Made with its program by `toolcomp corpus flank`.\ncontrol = \"fanuc\"\nunits = \"mm\"\n";
    const auto& [x, y, z] = start_.first;
    std::string tool = fmt::format("[offsets.D]\n1 = \"5.0\"\n[position]\nX = \"{}\"\nY = \"{}\"\nZ = \"{}\"\n",
                                   decimal(x, 4), decimal(y, 4), decimal(z, 4));
    if (vector_) return made + "axes = [\"X\", \"Y\", \"Z\"]\n" + tool;
    tool += fmt::format("B = \"{}\"\nC = \"{}\"\n", decimal(start_.second.b, 4), decimal(start_.second.c, 4));
    return made +
           "axes = [\"X\", \"Y\", \"Z\", \"B\", \"C\"]\n[parameters]\n# C (about Z) carries B (about Y)\n"
           "19680 = 2\n19681 = 5\n19682 = 3\n19686 = 4\n19687 = 2\n" +
           tool;
  }

  const FlankOptions& options_;
  bool vector_;
  std::pair<Triple, Pose> start_;  // where the program starts
  Flank flank_;
};

}  // namespace

Flank make_flank(const FlankOptions& options) { return Writer(options).write(); }

}  // namespace toolcomp::corpus

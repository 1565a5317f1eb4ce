// SPDX-License-Identifier: Apache-2.0
#include "corpus/freeform.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "corpus/counts.h"

namespace toolcomp::corpus {
namespace {

constexpr std::int64_t kOne = std::int64_t{1} << 56U;  // 1 in the formulas
constexpr std::int64_t kCount = 10'000;                // of a millimetre
constexpr std::int64_t kComponent = 10'000'000;        // of a unit vector
constexpr std::int64_t kBall = 5;                      // mm
constexpr std::int64_t kAbove = 60;                    // mm: clear of the workpiece

using Triple = std::array<Wide, 3>;  // of kOne

// Where b is parts of kOne.
Wide times(Wide a, Wide b) { return (a * b) >> 56U; }

// The whole part of the square root, bit by bit.
Wide whole_root(Wide square) {
  Wide root = 0;
  for (Wide bit = Wide{1} << 60U; bit != 0; bit >>= 1U)
    if ((root + bit) * (root + bit) <= square) root += bit;
  return root;
}

Triple unit(const Triple& v) {
  const Wide length = whole_root(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  return {v[0] * kOne / length, v[1] * kOne / length, v[2] * kOne / length};
}

struct Contact {
  Triple q, n, t;
};

Contact contact(Wide u, Wide v, bool tool_vector) {
  const Wide uu = times(u, u);
  const Wide vv = times(v, v);
  const Wide z = 20 * static_cast<Wide>(kOne) - 24 * uu - 14 * vv + 10 * times(uu, u) + 12 * times(u, vv);
  const Wide slope_x = (-48 * u + 30 * uu + 12 * vv) / 60;
  const Wide slope_y = (-28 * v + 24 * times(u, v)) / 40;
  Contact c{{60 * u, 40 * v, z}, unit({-slope_x, -slope_y, kOne}), {0, 0, kOne}};
  if (tool_vector) c.t = unit({kOne / 10 - slope_x / 2, kOne / 20 - slope_y / 2, kOne});
  return c;
}

// +12.3400: always with its sign, and as many decimals.
std::string fixed(std::int64_t count, std::int64_t unit, int places) {
  const std::int64_t size = count < 0 ? -count : count;
  return fmt::format("{}{}.{:0{}}", count < 0 ? '-' : '+', size / unit, size % unit, places);
}

class Writer {
 public:
  explicit Writer(const FreeformOptions& options) : options_(options) {
    if (options.blocks < kLeastFreeform || options.blocks > kMostFreeform)
      throw std::invalid_argument(
          fmt::format("a free-form surface has {} to {} blocks", kLeastFreeform, kMostFreeform));
    // Half as many passes as a pass has points.
    while (2 * (freeform_.passes + 1) * (freeform_.passes + 1) <= options.blocks) ++freeform_.passes;
  }

  Freeform write() {
    line("BEGIN PGM FREEFORM MM");
    line(fmt::format("; FINISHING OF A FREE-FORM SURFACE, {} BLOCKS IN {} PASSES", options_.blocks, freeform_.passes));
    line("BLK FORM 0.1 Z X-60 Y-40 Z-60");
    line("BLK FORM 0.2 X+60 Y+40 Z+40");
    line("TOOL CALL 1 Z S15000 F3000");
    line("CYCL DEF 32.0 TOLERANCE");
    line("CYCL DEF 32.1 T0.01");
    line(fmt::format("L Z+{} R0 FMAX M3", kAbove));
    for (std::size_t i = 0; i < freeform_.passes; ++i) pass(i);
    line(fmt::format("L Z+{} R0 FMAX M{}", kAbove, options_.tool_vector ? "129" : "5"));
    line("M30");
    line("END PGM FREEFORM MM");
    freeform_.setup = fmt::format(
        "# Made with its program by `toolcomp corpus freeform`.\ncontrol = \"heidenhain\"\nunits = \"mm\"\n"
        "[position]\nZ = {}\n[[tool]]\n# a ball of {} mm, re-worked by 0.1 mm\nnumber = 1\nR = {}\nR2 = "
        "{}\nL = 95\nDR = -0.05\nDR2 = -0.05\n",
        kAbove, 2 * kBall, kBall, kBall);
    return std::move(freeform_);
  }

 private:
  void line(const std::string& text) { freeform_.program += fmt::format("{} {}\n", number_++, text); }

  // Even passes (from 0) go from u = -1 to 1, odd ones back.
  void pass(std::size_t number) {
    const std::size_t n =
        options_.blocks * (number + 1) / freeform_.passes - options_.blocks * number / freeform_.passes;
    const auto along = [](std::size_t place, std::size_t last) {
      return (2 * static_cast<Wide>(place) - static_cast<Wide>(last)) * kOne / static_cast<Wide>(last);
    };
    const Wide v = along(number, freeform_.passes - 1);
    for (std::size_t j = 0; j < n; ++j)
      block(contact(along(number % 2 == 0 ? j : n - 1 - j, n - 1), v, options_.tool_vector), number == 0 && j == 0);
  }

  void block(const Contact& c, bool first) {
    std::array<std::string, 3> tip;
    for (std::size_t i = 0; i < 3; ++i) {
      const Wide coordinate = c.q[i] + kBall * (c.n[i] - c.t[i]);
      tip.at(i) = "XYZ"[i] + fixed(nearest(coordinate * kCount, kOne), kCount, 4);
    }
    if (first) line(fmt::format("L {} {} R0 FMAX", tip[0], tip[1]));
    std::string text = fmt::format("LN {} {} {}", tip[0], tip[1], tip[2]) + components('N', c.n);
    if (options_.tool_vector) text += components('T', c.t);
    if (first) text += options_.tool_vector ? " R0 F2500 M128" : " R0 F2500";
    line(text);
  }

  static std::string components(char name, const Triple& v) {
    std::string text;
    for (std::size_t i = 0; i < 3; ++i)
      text += fmt::format(" {}{}{}", name, "XYZ"[i], fixed(nearest(v[i] * kComponent, kOne), kComponent, 7));
    return text;
  }

  const FreeformOptions& options_;
  Freeform freeform_;
  std::size_t number_ = 0;
};

}  // namespace

Freeform make_freeform(const FreeformOptions& options) { return Writer(options).write(); }

}  // namespace toolcomp::corpus

// SPDX-License-Identifier: Apache-2.0
#include "corpus/contour.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <vector>

#include "corpus/counts.h"
#include "fuzz/gen/generator.h"

namespace toolcomp::corpus {
namespace {

// Coordinates are counts of 1/10,000 mm; centres have hundredths of a count.
constexpr std::int64_t kMillimetre = 10'000;
constexpr std::int64_t kToolRadius = 3 * kMillimetre;
constexpr std::int64_t kSpacing = 20 * kMillimetre;  // of the splines' control points
constexpr std::int64_t kWave = 4 * kMillimetre;      // how far a control point may lie off the square's side
constexpr std::size_t kLeastSide = 3;                // control points a side

struct Point {
  std::int64_t x = 0;
  std::int64_t y = 0;
  friend Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
  friend Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
  friend Point operator*(std::int64_t k, Point a) { return {k * a.x, k * a.y}; }
};
Wide dot(Point a, Point b) { return static_cast<Wide>(a.x) * b.x + static_cast<Wide>(a.y) * b.y; }
Wide cross(Point a, Point b) { return static_cast<Wide>(a.x) * b.y - static_cast<Wide>(a.y) * b.x; }

// The whole root of n >= 0, rounded down.
std::int64_t root(Wide n) {
  Wide low = 0;
  Wide high = static_cast<Wide>(1) << 62;
  while (high - low > 1) {
    const Wide middle = low + (high - low) / 2;
    (middle * middle <= n ? low : high) = middle;
  }
  return static_cast<std::int64_t>(low);
}

// Hundredths of a count.
std::string fine(std::int64_t count) { return decimal(count, 6); }
std::string coordinate(std::int64_t count) { return decimal(count, 4); }

// A closed uniform cubic B-spline through the neighbourhood of a square, corner to corner counter-clockwise.
class Spline {
 public:
  Spline(std::size_t side, fuzz::ChoiceSource& source) {
    constexpr std::array<Point, 4> kAlong{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
    Point at;
    for (const Point& along : kAlong)
      for (std::size_t i = 0; i < side; ++i) {
        // Next to a corner the side stays straight, so that the corner keeps its radius.
        const bool waves = i > 1 && i + 1 < side;
        const std::int64_t off =
            waves ? static_cast<std::int64_t>(source.below(static_cast<std::uint64_t>(2 * kWave) + 1)) - kWave : 0;
        points_.push_back(at + off * Point{along.y, -along.x});
        at = at + kSpacing * along;
      }
  }

  // The point at the fraction j / n of the whole, to the nearest count.
  [[nodiscard]] Point at(std::size_t j, std::size_t n) const {
    const std::size_t part = j % n * points_.size();
    const std::size_t span = part / n;
    const auto u = static_cast<Wide>(part % n);
    const auto d = static_cast<Wide>(n);
    const Wide v = d - u;
    // 6 d^3 times the four weights.
    const std::array<Wide, 4> weights{v * v * v, 3 * u * u * u - 6 * u * u * d + 4 * d * d * d,
                                      -3 * u * u * u + 3 * u * u * d + 3 * u * d * d + d * d * d, u * u * u};
    Wide x = 0;
    Wide y = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const Point& p = points_[(span + i) % points_.size()];
      x += weights[i] * p.x;
      y += weights[i] * p.y;
    }
    return {nearest(x, 6 * d * d * d), nearest(y, 6 * d * d * d)};
  }

 private:
  std::vector<Point> points_;
};

class Writer {
 public:
  explicit Writer(const ContourOptions& options) : options_(options), source_(options.seed) {
    if (options.blocks < kLeastContour)
      throw std::invalid_argument(fmt::format("a contour has at least {} blocks", kLeastContour));
    choose_blocks();
    const Spline spline(std::max(kLeastSide, samples_ * 3 / 800), source_);
    for (std::size_t j = 0; j < samples_; ++j) points_.push_back(spline.at(j, samples_));
  }

  Contour write() {
    const std::string_view names[] = {"POCKET", "ISLAND", "POCKET WITH TIGHT PLACES"};
    const bool island = options_.variant == ContourVariant::island;
    const Point approach = 40 * (point(1) - point(0));
    line("%");
    line(fmt::format("O0100 ({} OF {} LINES AND ARCS FROM A SPLINE, SEED {})",
                     names[static_cast<std::size_t>(options_.variant)], options_.blocks, options_.seed));
    line("G90 G17 G00 " + words(point(0) - approach) + " Z10.");
    line("G01 Z-5. F300");
    line(fmt::format("{} D1 {} F1200", island ? "G42" : "G41", words(point(0))));
    path();
    line("G01 G40 " + words(point(0) + approach));
    line("G00 Z50.");
    line("M30");
    line("%");
    contour_.setup = fmt::format(
        "# Made with its program by `toolcomp corpus contour`.\ncontrol = \"fanuc\"\nunits = \"mm\"\n"
        "axes = [\"X\", \"Y\", \"Z\"]\n[offsets.D]\n1 = \"{}\"\n",
        coordinate(kToolRadius) + "0");
    return std::move(contour_);
  }

 private:
  // Which blocks take two samples and may be arcs.
  void choose_blocks() {
    for (std::size_t i = 0; i < options_.blocks; ++i) {
      wide_.push_back(source_.below(100) < options_.arcs);
      samples_ += wide_.back() ? 2 : 1;
    }
  }

  [[nodiscard]] Point point(std::size_t sample) const { return points_[sample % samples_]; }

  void line(const std::string& text) {
    contour_.program += text;
    contour_.program += '\n';
    ++lines_;
  }

  static std::string words(Point p) { return fmt::format("X{} Y{}", coordinate(p.x), coordinate(p.y)); }

  void line_to(Point end) {
    line((code_ == 1 ? "" : "G01 ") + words(end));
    code_ = 1;
    ++contour_.lines;
  }

  // The arc whose centre lies `offset` hundredths of the chord to the left of its middle; every eighth by R.
  void arc_to(Point start, Point end, std::int64_t offset) {
    const Point e = end - start;
    const int code = offset > 0 ? 3 : 2;
    std::string text = code_ == code ? "" : fmt::format("G0{} ", code);
    code_ = code;
    if (++contour_.arcs % 8 == 0) {
      const std::int64_t radius = root(dot(e, e) * (2500 + static_cast<Wide>(offset) * offset));
      text += fmt::format("{} R{}", words(end), coordinate(nearest(radius, 100)));
    } else {
      text += fmt::format("{} I{} J{}", words(end), fine(50 * e.x - offset * e.y), fine(50 * e.y + offset * e.x));
    }
    line(text);
  }

  // The circle through the samples a, a + 1 and a + 2, as arc_to wants it; 0 where it is nearly a line.
  [[nodiscard]] std::int64_t circle(std::size_t a) const {
    constexpr std::int64_t kFlattest = 200'000;  // radius of 2,000 chords
    const Point e = point(a + 2) - point(a);
    const Point m = point(a + 1) - point(a);
    Wide n = 100 * dot(m, m - e);
    Wide d = 2 * cross(e, m);
    if (d == 0) return 0;
    if (d < 0) {
      n = -n;
      d = -d;
    }
    const std::int64_t offset = nearest(n, d);
    return offset > kFlattest || offset < -kFlattest ? 0 : offset;
  }

  // Whether the path turns by less than 1/250 on either side of the chord from sample a to a + 1.
  [[nodiscard]] bool flat(std::size_t a) const {
    const auto slight = [](Point before, Point after) {
      const Wide turn = cross(before, after);
      return 250 * (turn < 0 ? -turn : turn) < dot(before, after);
    };
    const std::size_t b = a + samples_;
    const Point chord = point(a + 1) - point(a);
    return slight(point(a) - point(b - 1), chord) && slight(point(a) - point(b - 2), chord) &&
           slight(chord, point(a + 2) - point(a + 1)) && slight(chord, point(a + 3) - point(a + 1));
  }

  // A left arc over the chord, its radius `tenths` of the tool's. With its ends' tangents turned outward by
  // sin a = chord / 2R the corner heads lie r tan(a/2) inward of its ends: below half the tool's radius they pass each
  // other, and the last pair of vectors interferes; above, those that are left run straight.
  void tight_arc(Point start, Point end, std::int64_t tenths) {
    const Point e = end - start;
    const Wide radius = kToolRadius * tenths / 10;
    arc_to(start, end, root((10'000 * radius * radius - 2500 * dot(e, e)) / dot(e, e)));
  }

  // The groove: out to the right by three times the chord, along it and back. Its bottom is shorter than the tool is
  // wide.
  void groove(Point start, Point end) {
    const Point e = end - start;
    const Point out = 3 * Point{e.y, -e.x};
    line_to(start + out);
    contour_.alarm_line = lines_;
    line_to(end + out);
    line_to(end);
  }

  void path() {
    constexpr std::size_t kEvery = 997;  // blocks from one passable place to the next
    const bool tight = options_.variant == ContourVariant::tight;
    const std::size_t at = options_.at.value_or(options_.blocks / 2);
    std::size_t next = kEvery / 2;
    std::size_t last = 0;  // the place before
    std::size_t sample = 0;
    for (std::size_t block = 0; block < options_.blocks; ++block) {
      const Point start = point(sample);
      const std::size_t length = wide_[block] ? 2 : 1;
      const Point end = point(sample + length);
      // Between lines: beside an arc a corner keeps one more vector, with which the block may still run.
      const bool place = tight && !contour_.alarm_line && block > last + 2 && !wide_[block] && !wide_[block - 1] &&
                         block + 1 < options_.blocks && !wide_[block + 1] && flat(sample);
      if (place && block >= at) {
        const std::uint64_t here = lines_;
        if (options_.place == TightPlace::groove) {
          groove(start, end);
        } else {
          contour_.alarm_line = here;
          tight_arc(start, end, 2);
        }
      } else if (place && block >= next) {
        tight_arc(start, end, 7);
        ++contour_.dropped;
        next = block + kEvery;
        last = block;
      } else if (const std::int64_t offset = wide_[block] ? circle(sample) : 0; offset != 0) {
        arc_to(start, end, offset);
      } else {
        line_to(end);
      }
      sample += length;
    }
  }

  const ContourOptions& options_;
  fuzz::SeededSource source_;
  std::vector<bool> wide_;
  std::size_t samples_ = 0;
  std::vector<Point> points_;
  Contour contour_;
  std::uint64_t lines_ = 1;  // the line to be written
  int code_ = 1;             // G01, G02, G03 in force
};

}  // namespace

Contour make_contour(const ContourOptions& options) { return Writer(options).write(); }

}  // namespace toolcomp::corpus

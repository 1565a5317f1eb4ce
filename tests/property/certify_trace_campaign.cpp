// SPDX-License-Identifier: Apache-2.0
// A campaign of recordings made from the geometry of random programs of lines and arcs, and of lines under tool center
// point control: honest ones with noise, lag, dwell and another period, none of which may be accused, and ones with a
// fault, which must be found at its block. The programs run through the model; where their axes go is computed here, by
// formulas of its own.
//
// TOOLCOMP_TRACE_RECORDINGS=10000 makes so many.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "certify/trace/samples.h"
#include "certify/trace/trace.h"
#include "spec/language/setup_format.h"
#include "tests/effort.h"

namespace toolcomp::certify {
namespace {

using Random = std::mt19937_64;
constexpr double kTolerance = 0.01;
constexpr double kRotary = 0.05;
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kLength = 100;  // of the tool

// Each test has numbers of its own, the same in every run.
Random numbers_of(std::uint64_t test) { return Random(test); }

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
std::size_t below(Random& random, std::size_t n) {
  return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
}

// --- Programs and where they lead ------------------------------------------------------------------------------------

// Where the axes are at t, from 0 to 1; X Y Z B C.
using Curve = std::function<AxisPoint(double)>;

struct Block {
  std::uint64_t line = 0;
  bool straight = true;  // a G01
  AxisPoint end{};       // as programmed
  Curve at;
  std::vector<AxisPoint> fine;  // places in a row
  double reach = 0;             // the farthest of them from the one in the middle
};

struct Program {
  spec::Case c;
  std::size_t axes = 3;
  bool tip = false;  // tool center point control
  std::vector<Block> blocks;
};

AxisPoint between(const AxisPoint& a, const AxisPoint& b, double t) {
  AxisPoint p{};
  for (std::size_t i = 0; i < p.size(); ++i) p.at(i) = a.at(i) + t * (b.at(i) - a.at(i));
  return p;
}

double length(const AxisPoint& a, const AxisPoint& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

// A head whose C carries its B: the control point is the length of the tool above the tip, along it.
AxisPoint above_tip(AxisPoint p) {
  const double b = p[3] * kDegree;
  const double c = p[4] * kDegree;
  p[0] += kLength * std::sin(b) * std::cos(c);
  p[1] += kLength * std::sin(b) * std::sin(c);
  p[2] += kLength * std::cos(b);
  return p;
}

Curve line(const AxisPoint& from, const AxisPoint& to, bool tip) {
  return [=](double t) {
    const AxisPoint p = between(from, to, t);
    return tip ? above_tip(p) : p;
  };
}

double rounded(double value) { return std::round(value * 1000) / 1000; }

// The angle between the end of one block and the begin of the next, in degrees.
double bend(const Curve& before, const Curve& behind) {
  const AxisPoint a = before(0.999);
  const AxisPoint b = before(1);
  const AxisPoint c = behind(0.001);
  double dot = 0;
  for (const std::size_t i : {0U, 1U, 2U}) dot += (b.at(i) - a.at(i)) * (c.at(i) - b.at(i));
  return std::acos(std::clamp(dot / (length(a, b) * length(b, c)), -1.0, 1.0)) / kDegree;
}

class Maker {
 public:
  explicit Maker(Random& random) : random_(random) {
    program_.axes = std::array<std::size_t, 3>{2, 3, 5}.at(below(random, 3));
    program_.tip = program_.axes == 5;
    program_.c.id = "campaign";
    program_.c.setup = spec::read_setup_toml(
        program_.axes == 2   ? "control=\"fanuc\"\nunits=\"mm\"\naxes=[\"X\",\"Y\"]\n"
        : program_.axes == 3 ? "control=\"fanuc\"\nunits=\"mm\"\naxes=[\"X\",\"Y\",\"Z\"]\n"
                             : "control=\"fanuc\"\nunits=\"mm\"\naxes=[\"X\",\"Y\",\"Z\",\"B\",\"C\"]\n[parameters]\n"
                               "19680=2\n19681=5\n19682=3\n19686=4\n19687=2\n[offsets.H]\n1=100\n",
        "setup.toml");
  }

  Program made() {
    add("G90 G17 G01 X0 Y0 F1000");
    if (program_.tip) {
      add("G43.4 H1");
      AxisPoint up{};
      up[2] = kLength;
      program_.blocks.push_back({line_, true, {}, line({}, up, false), {}, 0});
    }
    const std::size_t count = program_.blocks.size() + 4 + below(random_, 5);
    while (program_.blocks.size() < count) {
      if (!program_.tip && below(random_, 3) == 0)
        add_arc();
      else
        add_line();
    }
    for (Block& block : program_.blocks) {
      constexpr int kSteps = 200;
      for (int i = 0; i <= kSteps; ++i) block.fine.push_back(block.at(static_cast<double>(i) / kSteps));
      for (const AxisPoint& p : block.fine) block.reach = std::max(block.reach, length(p, block.fine[kSteps / 2]));
    }
    return std::move(program_);
  }

 private:
  void add(const std::string& text) {
    program_.c.program += text + "\n";
    ++line_;
  }
  // Corners of 30 to 150 degrees.
  [[nodiscard]] bool joins(const Curve& next) const {
    if (program_.blocks.empty()) return true;
    const double angle = bend(program_.blocks.back().at, next);
    return angle > 30 && angle < 150;
  }

  void add_line() {
    AxisPoint to = at_;
    const double heading = uniform(random_, 0, 2 * std::numbers::pi);
    const double far = uniform(random_, 2, 6);
    to[0] = rounded(to[0] + far * std::cos(heading));
    to[1] = rounded(to[1] + far * std::sin(heading));
    if (program_.axes > 2) to[2] = rounded(to[2] + uniform(random_, -1, 1));
    if (program_.tip) {
      to[3] = rounded(uniform(random_, 2, 15));
      to[4] = rounded(at_[4] + uniform(random_, -20, 20));
    }
    const Curve curve = line(at_, to, program_.tip);
    if (!joins(curve)) return;
    std::string text = fmt::format("G01 X{:.3f} Y{:.3f}", to[0], to[1]);
    if (program_.axes > 2) text += fmt::format(" Z{:.3f}", to[2]);
    if (program_.tip) text += fmt::format(" B{:.3f} C{:.3f}", to[3], to[4]);
    add(text);
    program_.blocks.push_back({line_, true, to, curve, {}, 0});
    at_ = to;
  }

  // Rounding the end makes it a spiral by a thousandth at most; with three axes, a helix.
  void add_arc() {
    const double radius = uniform(random_, 1, 4);
    const double begin = uniform(random_, 0, 2 * std::numbers::pi);
    const double turn = below(random_, 2) == 0 ? 1 : -1;
    const double planned = turn * uniform(random_, 40, 200) * kDegree;
    const double i = rounded(-radius * std::cos(begin));
    const double j = rounded(-radius * std::sin(begin));
    AxisPoint to = at_;
    const double u = at_[0] + i;
    const double v = at_[1] + j;
    to[0] = rounded(u + radius * std::cos(begin + planned));
    to[1] = rounded(v + radius * std::sin(begin + planned));
    if (program_.axes > 2) to[2] = rounded(to[2] + uniform(random_, -1, 1));
    const double from_radius = std::hypot(i, j);
    const double to_radius = std::hypot(to[0] - u, to[1] - v);
    const double from_angle = std::atan2(-j, -i);
    double sweep = std::atan2(to[1] - v, to[0] - u) - from_angle;
    while (turn * sweep < 0) sweep += turn * 2 * std::numbers::pi;
    while (turn * sweep > 2 * std::numbers::pi) sweep -= turn * 2 * std::numbers::pi;
    const AxisPoint from = at_;
    const Curve curve = [=](double t) {
      AxisPoint p = between(from, to, t);
      const double r = from_radius + t * (to_radius - from_radius);
      p[0] = u + r * std::cos(from_angle + t * sweep);
      p[1] = v + r * std::sin(from_angle + t * sweep);
      return p;
    };
    if (!joins(curve)) return;
    std::string text = fmt::format("{} X{:.3f} Y{:.3f}", turn > 0 ? "G03" : "G02", to[0], to[1]);
    if (program_.axes > 2) text += fmt::format(" Z{:.3f}", to[2]);
    add(text + fmt::format(" I{:.3f} J{:.3f}", i, j));
    program_.blocks.push_back({line_, false, to, curve, {}, 0});
    at_ = to;
  }

  Random& random_;
  Program program_;
  std::uint64_t line_ = 0;
  AxisPoint at_{};  // programmed
};

// --- Recordings ------------------------------------------------------------------------------------------------------

struct Taken {
  AxisPoint at{};
  std::size_t block = 0;  // index
  double t = 0;
  double time = 0;
};
using Tape = std::vector<Taken>;

// So many steps that no chord is a tenth of the tolerance off the curve.
std::size_t steps_of(const Curve& curve, double from, double to, double longest) {
  for (std::size_t n = 1;; n = 2 * n) {
    double worst = 0;
    double step = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const auto at = [&](double part) {
        return curve(from + (to - from) * (static_cast<double>(i) + part) / static_cast<double>(n));
      };
      worst = std::max(worst, length(at(0.5), between(at(0), at(1), 0.5)));
      step = std::max(step, length(at(0), at(1)));
    }
    if (worst <= kTolerance / 10 && step <= longest) return n;
  }
}

// Along a curve, without its begin.
void run_along(Tape& tape, const Curve& curve, std::size_t block, double from, double to, double longest) {
  const std::size_t n = steps_of(curve, from, to, longest);
  for (std::size_t i = 1; i <= n; ++i) {
    const double t = from + (to - from) * static_cast<double>(i) / static_cast<double>(n);
    tape.push_back({curve(t), block, t});
  }
}

double random_step(Random& random) { return uniform(random, 0.03, 0.15); }

Tape exact_tape(const Program& program, double step) {
  Tape tape{{program.blocks[0].at(0), 0, 0}};
  for (std::size_t k = 0; k < program.blocks.size(); ++k) run_along(tape, program.blocks[k].at, k, 0, 1, step);
  return tape;
}

// Every linear axis follows with one delay; scaled so that the farthest sample is `most` tolerances behind.
void lag(Tape& tape, double share, double most) {
  AxisPoint follows = tape[0].at;
  std::vector<AxisPoint> behind;
  double largest = 0;
  for (const Taken& taken : tape) {
    for (std::size_t i = 0; i < 3; ++i) follows.at(i) += share * (taken.at.at(i) - follows.at(i));
    AxisPoint off{};
    for (std::size_t i = 0; i < 3; ++i) off.at(i) = follows.at(i) - taken.at.at(i);
    behind.push_back(off);
    largest = std::max(largest, length(off, {}));
  }
  const double scale = std::min(1.0, most * kTolerance / largest);
  for (std::size_t s = 0; s < tape.size(); ++s)
    for (std::size_t i = 0; i < 3; ++i) tape[s].at.at(i) += scale * behind[s].at(i);
}

void dwell(Random& random, Tape& tape) {
  for (std::size_t times = 1 + below(random, 3); times > 0; --times) {
    const auto at = tape.begin() + static_cast<std::ptrdiff_t>(below(random, tape.size()));
    tape.insert(at, 1 + below(random, 60), Taken(*at));
  }
}

void noise(Random& random, const Program& program, Tape& tape, double most) {
  for (Taken& taken : tape) {
    AxisPoint by{};
    for (std::size_t i = 0; i < std::min<std::size_t>(3, program.axes); ++i) by.at(i) = uniform(random, -1, 1);
    const double far = length(by, {});
    const double scale = most * kTolerance * uniform(random, 0, 1) / std::max(far, 1e-9);
    for (std::size_t i = 0; i < 3; ++i) taken.at.at(i) += scale * by.at(i);
    for (std::size_t i = 3; i < program.axes; ++i) taken.at.at(i) += most * kRotary * uniform(random, -1, 1);
  }
}

// Even steps, a little unsteady; with `change`, of another length from somewhere on.
void stamp(Random& random, Tape& tape, bool change) {
  constexpr std::size_t kApart = 45;
  double period = uniform(random, 0.001, 0.02);
  double time = 0;
  const std::size_t other =
      change && tape.size() > 3 * kApart ? kApart + below(random, tape.size() - 2 * kApart) : tape.size();
  const double factor = uniform(random, 0.3, 3);
  for (std::size_t s = 0; s < tape.size(); ++s) {
    if (s == other) period *= factor;
    tape[s].time = time += period * uniform(random, 0.9, 1.1);
  }
}

RecordedRun recorded(const Program& program, const Tape& tape) {
  RecordedRun run;
  for (std::size_t axis = 0; axis < program.axes; ++axis) run.recorded.push_back(axis);
  run.has_time = true;
  constexpr double kResolution = 1e-7;
  for (std::size_t s = 0; s < tape.size(); ++s) run.samples.push_back({s + 2, tape[s].at, tape[s].time, kResolution});
  return run;
}

TraceResult judged(const Program& program, const Tape& tape, bool causes = false) {
  const RecordedRun run = recorded(program, tape);
  SampleRange samples(run, 0, run.samples.size());
  TraceOptions options;
  options.tolerance = kTolerance;
  options.rotary_tolerance = kRotary;
  options.pictures = false;
  options.causes = causes;
  return judge_trace(program.c, samples, options);
}

// --- What is known of them -------------------------------------------------------------------------------------------

double to_segment(const AxisPoint& a, const AxisPoint& b, const AxisPoint& p) {
  double along = 0;
  double square = 0;
  for (const std::size_t i : {0U, 1U, 2U}) {
    along += (b.at(i) - a.at(i)) * (p.at(i) - a.at(i));
    square += (b.at(i) - a.at(i)) * (b.at(i) - a.at(i));
  }
  return length(p, between(a, b, square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0));
}

// From `p` to the recording between two samples, by the linear axes.
double to_tape(const Tape& tape, std::size_t first, std::size_t last, const AxisPoint& p) {
  double least = length(tape[first].at, p);
  for (std::size_t s = first; s < last; ++s) least = std::min(least, to_segment(tape[s].at, tape[s + 1].at, p));
  return least;
}

// From `p` to the blocks [first, last], by the linear axes, to within a fiftieth of the tolerance.
double to_path(const Program& program, std::size_t first, std::size_t last, const AxisPoint& p) {
  double least = 1e9;
  for (std::size_t k = first; k <= std::min(last, program.blocks.size() - 1); ++k) {
    const std::vector<AxisPoint>& fine = program.blocks[k].fine;
    const AxisPoint& middle = fine[fine.size() / 2];
    if (length(p, middle) - program.blocks[k].reach >= least) continue;
    for (std::size_t i = 0; i + 1 < fine.size(); ++i) least = std::min(least, to_segment(fine[i], fine[i + 1], p));
  }
  return least;
}

std::string words(const Program& program, const TraceResult& r) {
  std::string out = program.c.program + r.undecided + "\n";
  for (const TraceFinding& f : r.findings)
    out += fmt::format("{} sample {} ({}) line {}-{} by {}..{} {} {}..{} {} s\n", f.kind, f.sample, f.samples, f.line,
                       f.last_line, f.distance.lower, f.distance.upper, f.rotary_axis == 0 ? '-' : f.rotary_axis,
                       f.rotary.lower, f.rotary.upper, f.duration);
  return out;
}

enum class Told { right, missed, elsewhere, otherwise };  // of another kind, or out of its bounds

struct Outcome {
  Told told = Told::right;
  std::string why;
};

Outcome off(Told told, std::string why) { return {told, std::move(why)}; }

// Chords and steps of the formulas here.
constexpr double kFine = kTolerance / 20;

// `truth` between the bounds.
bool holds(const Bounds& bounds, double least, double most) {
  return bounds.lower <= most + kFine && bounds.upper >= least - kFine;
}

// --- Faults ----------------------------------------------------------------------------------------------------------

// The corner behind a block is cut by twice the tolerance.
Outcome corner_cut(Random& random, const Program& program) {
  const std::size_t first = program.tip ? 1 : 0;
  const std::size_t k = first + below(random, program.blocks.size() - 1 - first);
  const Curve& one = program.blocks[k].at;
  const Curve& other = program.blocks[k + 1].at;
  const AxisPoint corner = one(1);
  // As far before it as behind it, by bisection.
  const auto at_distance = [&](const Curve& curve, double begin, double end, double far) {
    double low = 0;
    double high = 0.5;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (length(curve(begin + (end - begin) * middle), corner) < far ? low : high) = middle;
    }
    return begin + (end - begin) * low;
  };
  double low = 0;
  double high = 0.5;
  for (int i = 0; i < 60; ++i) {
    const double far = (low + high) / 2;
    const double passed = to_segment(one(at_distance(one, 1, 0, far)), other(at_distance(other, 0, 1, far)), corner);
    (passed < 2 * kTolerance ? low : high) = far;
  }
  const double leaves = at_distance(one, 1, 0, low);
  const double comes = at_distance(other, 0, 1, low);
  const double step = random_step(random);
  Tape tape{{program.blocks[0].at(0), 0, 0}};
  std::size_t behind = 0;
  for (std::size_t b = 0; b < program.blocks.size(); ++b) {
    const Curve& curve = program.blocks[b].at;
    if (b == k + 1) {
      behind = tape.size();
      tape.push_back({curve(comes), b, comes});
    }
    run_along(tape, curve, b, b == k + 1 ? comes : 0, b == k ? leaves : 1, step);
  }
  noise(random, program, tape, 0.1);
  stamp(random, tape, false);
  const double truth = to_tape(tape, behind - 2, behind + 1, corner);
  const TraceResult r = judged(program, tape);
  if (r.findings_total == 0) return off(Told::missed, words(program, r));
  const TraceFinding& f = r.findings[0];
  if (f.line != program.blocks[k].line || r.findings_total > 1 || f.sample != behind + 2)
    return off(Told::elsewhere,
               fmt::format("line {} sample {}\n", program.blocks[k].line, behind + 2) + words(program, r));
  if (f.kind != "corner not reached" || r.corners_missed != 1 || !holds(f.distance, truth, truth))
    return off(Told::otherwise, fmt::format("by {}\n", truth) + words(program, r));
  return {};
}

// Some samples of one block are missing; time runs on.
Outcome gap(Random& random, const Program& program) {
  Tape tape = exact_tape(program, random_step(random));
  noise(random, program, tape, 0.2);
  stamp(random, tape, false);
  constexpr std::size_t kAround = 40;
  std::size_t first = 0;
  std::size_t end = 0;
  do {
    first = kAround + below(random, tape.size() - 2 * kAround - 25);
    end = first + 4 + below(random, 20);
  } while (tape[first - 1].block != tape[end].block);
  const std::size_t k = tape[end].block;
  const double from = tape[first - 1].t;
  const double to = tape[end].t;
  const double seconds = tape[end].time - tape[first - 1].time;
  tape.erase(tape.begin() + static_cast<std::ptrdiff_t>(first), tape.begin() + static_cast<std::ptrdiff_t>(end));
  double truth = 0;
  for (int i = 0; i <= 200; ++i)
    truth = std::max(truth, to_tape(tape, first - 1, first, program.blocks[k].at(from + (to - from) * i / 200)));
  const TraceResult r = judged(program, tape);
  if (r.findings_total == 0) return off(Told::missed, words(program, r));
  const TraceFinding& f = r.findings[0];
  if (f.line != program.blocks[k].line || f.sample != first + 2 || r.findings_total > 1)
    return off(Told::elsewhere,
               fmt::format("line {} sample {}\n", program.blocks[k].line, first + 2) + words(program, r));
  const bool beyond = truth > 1.1 * kTolerance;
  if (f.kind != "gap" || std::fabs(f.duration - seconds) > 1e-9 || (beyond && !holds(f.distance, truth, truth)))
    return off(Told::otherwise, fmt::format("{} s by {}\n", seconds, truth) + words(program, r));
  return {};
}

// A block in front of a line is not there: the line goes on from the one before.
std::optional<Outcome> left_out(Random& random, const Program& program) {
  const std::size_t first = program.tip ? 2 : 1;
  const std::size_t k = first + below(random, program.blocks.size() - 1 - first);
  if (!program.blocks[k + 1].straight) return std::nullopt;
  const Curve past = line(program.blocks[k - 1].end, program.blocks[k + 1].end, program.tip);
  const double step = random_step(random);
  Tape tape{{program.blocks[0].at(0), 0, 0}};
  std::size_t begin = 0;
  std::size_t end = 0;
  for (std::size_t b = 0; b < program.blocks.size(); ++b) {
    if (b == k) begin = tape.size();
    if (b != k) run_along(tape, b == k + 1 ? past : program.blocks[b].at, b, 0, 1, step);
    if (b == k + 1) end = tape.size() - 1;
  }
  noise(random, program, tape, 0.1);
  stamp(random, tape, false);
  // Beside the line lies what was left out: how far is the farthest of it?
  double truth = 0;
  for (const std::size_t b : {k, k + 1})
    for (int i = 0; i <= 500; ++i)
      truth = std::max(truth, to_tape(tape, begin - 1, end, program.blocks[b].at(i / 500.0)));
  const TraceResult r = judged(program, tape);
  if (r.findings_total == 0) return off(Told::missed, words(program, r));
  const std::uint64_t line = program.blocks[k].line;
  const auto names = [&](const TraceFinding& f) { return f.line <= line && line <= f.last_line; };
  const auto beside = [&](const TraceFinding& f) { return f.line >= line - 1 && f.last_line <= line + 2; };
  const std::string known = fmt::format("line {} by {}\n", line, truth);
  if (std::ranges::none_of(r.findings, names) || !std::ranges::all_of(r.findings, beside))
    return off(Told::elsewhere, known + words(program, r));
  double lower = 0;
  double upper = 0;
  for (const TraceFinding& f : r.findings) {
    lower = std::max(lower, f.kind == "off the path" ? 0 : f.distance.lower);
    upper = std::max(upper, f.distance.upper);
  }
  if (!holds({lower, upper}, 0.5 * truth, truth)) return off(Told::otherwise, known + words(program, r));
  return Outcome{};
}

// Samples in the middle of a block are beside it.
Outcome bump(Random& random, const Program& program) {
  Tape tape = exact_tape(program, random_step(random));
  noise(random, program, tape, 0.2);
  stamp(random, tape, false);
  const std::size_t skip = program.tip ? 1 : 0;
  const std::size_t k = skip + below(random, program.blocks.size() - skip);
  const Curve& curve = program.blocks[k].at;
  const AxisPoint a = curve(0.39);
  const AxisPoint b = curve(0.41);
  const double along = std::hypot(b[0] - a[0], b[1] - a[1]);
  const double by = kTolerance * uniform(random, 2, 30);
  std::size_t first = 0;
  std::size_t last = 0;
  for (std::size_t s = 0; s < tape.size(); ++s) {
    if (tape[s].block != k || tape[s].t < 0.38 || tape[s].t > 0.45) continue;
    tape[s].at[0] -= by * (b[1] - a[1]) / along;
    tape[s].at[1] += by * (b[0] - a[0]) / along;
    last = s;
    if (first == 0) first = s;
  }
  if (first == 0) {  // no sample there: the nearest one
    for (std::size_t s = 0; s < tape.size(); ++s)
      if (tape[s].block == k && tape[s].t < 0.6) first = last = s;
    tape[first].at[0] -= by * (b[1] - a[1]) / along;
    tape[first].at[1] += by * (b[0] - a[0]) / along;
  }
  double least = 0;
  double most = 0;
  for (std::size_t s = first; s <= last; ++s) {
    least = std::max(least, to_path(program, 0, program.blocks.size(), tape[s].at));
    most = std::max(most, to_path(program, k, k, tape[s].at));
  }
  const TraceResult r = judged(program, tape);
  if (r.findings_total == 0) return off(Told::missed, words(program, r));
  const TraceFinding& f = r.findings[0];
  const std::string known =
      fmt::format("line {} samples {} to {} by {} to {}\n", program.blocks[k].line, first + 2, last + 2, least, most);
  if (f.line != program.blocks[k].line || f.sample < first + 2 || f.sample > last + 2)
    return off(Told::elsewhere, known + words(program, r));
  const bool kind = f.kind == "off the path" || (least < 1.1 * kTolerance && f.kind == "out of order");
  if (!kind || !holds(f.distance, least, most)) return off(Told::otherwise, known + words(program, r));
  return {};
}

// C is off in the middle of a block.
std::optional<Outcome> rotary_bump(Random& random, const Program& program) {
  if (!program.tip) return std::nullopt;
  Tape tape = exact_tape(program, random_step(random));
  noise(random, program, tape, 0.2);
  stamp(random, tape, false);
  const std::size_t k = 1 + below(random, program.blocks.size() - 1);
  const double by = kRotary * uniform(random, 3, 30);
  std::size_t first = 0;
  std::size_t last = 0;
  for (std::size_t s = 0; s < tape.size(); ++s)
    if (tape[s].block == k && tape[s].t > 0.3 && tape[s].t < 0.6) {
      tape[s].at[4] += by;
      last = s;
      if (first == 0) first = s;
    }
  const TraceResult r = judged(program, tape);
  if (r.findings_total == 0) return off(Told::missed, words(program, r));
  const TraceFinding& f = r.findings[0];
  const std::string known =
      fmt::format("line {} samples {} to {}: C by {}\n", program.blocks[k].line, first + 2, last + 2, by);
  if (f.line != program.blocks[k].line || f.sample < first + 2 || f.sample > last + 2)
    return off(Told::elsewhere, known + words(program, r));
  // Elsewhere on the block C may be as recorded, and X Y Z off: the larger of both counts.
  if (f.kind != "off the path" || f.rotary.lower > by + 0.2 * kRotary + kFine ||
      std::max(f.rotary.upper / kRotary, f.distance.upper / kTolerance) <= 1)
    return off(Told::otherwise, known + words(program, r));
  return Outcome{};
}

Outcome exchanged(Random& random, const Program& program) {
  Tape tape = exact_tape(program, random_step(random));
  noise(random, program, tape, 0.3);
  stamp(random, tape, false);
  std::optional<std::size_t> beyond;
  for (std::size_t s = 0; s < tape.size(); ++s) {
    std::swap(tape[s].at[0], tape[s].at[1]);
    if (!beyond && to_path(program, 0, program.blocks.size(), tape[s].at) > 1.1 * kTolerance) beyond = s;
  }
  const TraceResult r = judged(program, tape, true);
  if (r.findings_total == 0) return off(Told::missed, words(program, r));
  if (beyond && r.findings[0].sample > *beyond + 2)
    return off(Told::elsewhere, fmt::format("sample {}\n", *beyond + 2) + words(program, r));
  if (r.cause != "axes X and Y are exchanged")
    return off(Told::otherwise, r.cause.value_or("no cause") + "\n" + words(program, r));
  return {};
}

// The recording moves away, evenly, by several tolerances in the end.
Outcome drift(Random& random, const Program& program) {
  Tape tape = exact_tape(program, random_step(random));
  AxisPoint by{};
  for (std::size_t i = 0; i < std::min<std::size_t>(3, program.axes); ++i) by.at(i) = uniform(random, -1, 1);
  const double scale = kTolerance * uniform(random, 3, 8) / length(by, {});
  constexpr double kNoise = 0.1;
  noise(random, program, tape, kNoise);
  stamp(random, tape, false);
  // Before `earliest` nothing can be beyond the tolerance, and that sample is farther from the whole path.
  std::optional<std::size_t> earliest;
  std::optional<std::size_t> latest;
  for (std::size_t s = 0; s < tape.size(); ++s) {
    const double part = static_cast<double>(s) / static_cast<double>(tape.size() - 1);
    for (std::size_t i = 0; i < 3; ++i) tape[s].at.at(i) += part * scale * by.at(i);
    if (!earliest && part * scale * length(by, {}) > (1 - kNoise - 0.12) * kTolerance) earliest = s;
    if (earliest && !latest && to_path(program, 0, program.blocks.size(), tape[s].at) > 1.05 * kTolerance) latest = s;
  }
  const TraceResult r = judged(program, tape);
  if (r.findings_total == 0) return off(Told::missed, words(program, r));
  const TraceFinding& f = r.findings[0];
  const std::string known = fmt::format("samples {} to {}\n", *earliest + 2, latest.value_or(0) + 2);
  if (f.sample < *earliest + 2 || (latest && f.sample > *latest + 2))
    return off(Told::elsewhere, known + words(program, r));
  // At a corner, one block or the other.
  const std::size_t here = tape[f.sample - 2].block;
  const auto line_of = [&](std::size_t k) { return program.blocks[std::min(k, program.blocks.size() - 1)].line; };
  if (f.last_line < line_of(here == 0 ? 0 : here - 1) || f.line > line_of(here + 1))
    return off(Told::elsewhere, known + fmt::format("line {}\n", line_of(here)) + words(program, r));
  for (const TraceFinding& each : r.findings) {
    if (each.worst_sample == 0) continue;
    const std::size_t worst = each.worst_sample - 2;
    const double least = to_path(program, 0, program.blocks.size(), tape[worst].at);
    // Evenly, it is nearer than `away` to where it should be. But it is compared with the path from where it left on,
    // and a recording that runs ahead leaves ahead of where it should be: by no more than it was off there and the
    // tolerance, for the place is within that of the sample. So what is short of that place is off by so much more.
    const double away =
        scale * length(by, {}) * static_cast<double>(worst) / static_cast<double>(tape.size() - 1) + kTolerance;
    if (!holds(each.distance, least, 2 * away))
      return off(Told::otherwise,
                 known + fmt::format("sample {} by {} to {}\n", worst + 2, least, 2 * away) + words(program, r));
  }
  return {};
}

// --- The campaign ----------------------------------------------------------------------------------------------------

std::size_t recordings() {
  const std::size_t kUsual = test::effort(40U, 200U);
  const char* const asked = std::getenv("TOOLCOMP_TRACE_RECORDINGS");
  return asked == nullptr ? kUsual : std::stoul(asked);
}

TEST(TraceCampaign, HonestRecordingsAreNotAccused) {
  Random random = numbers_of(1);
  std::map<std::size_t, std::size_t> by_axes;
  std::size_t accused = 0;
  double worst = 0;
  for (std::size_t i = 0; i < recordings() / 2; ++i) {
    const Program program = Maker(random).made();
    Tape tape = exact_tape(program, random_step(random));
    // Noise, lag and the chords of the recording are 0.95 of the tolerance together.
    const double late = below(random, 2) == 0 ? uniform(random, 0, 0.4) : 0;
    if (late > 0) lag(tape, uniform(random, 0.2, 0.9), late);
    if (below(random, 2) == 0) dwell(random, tape);
    noise(random, program, tape, 0.85 - late);
    stamp(random, tape, below(random, 2) == 0);
    const TraceResult r = judged(program, tape);
    ++by_axes[program.axes];
    worst = std::max(worst, r.worst.upper);
    if (exit_status(r) == 0) continue;
    ++accused;
    EXPECT_TRUE(false) << i << "\n" << words(program, r);
    if (accused > 5) return;
  }
  fmt::print("honest: {} of 2 axes, {} of 3, {} under tool center point control; {} accused; worst accepted {:.4f}\n",
             by_axes[2], by_axes[3], by_axes[5], accused, worst);
  EXPECT_GT(worst, 0.7 * kTolerance);
  EXPECT_GT(by_axes[5], 0U);
}

TEST(TraceCampaign, EveryFaultIsFoundAtItsBlock) {
  using Fault = std::function<std::optional<Outcome>(Random&, const Program&)>;
  const std::vector<std::pair<std::string, Fault>> faults{{"corner cut", corner_cut},
                                                          {"gap", gap},
                                                          {"block left out", left_out},
                                                          {"bump", bump},
                                                          {"bump of C", rotary_bump},
                                                          {"axes exchanged", exchanged},
                                                          {"drift", drift}};
  std::vector<std::array<std::size_t, 4>> told(faults.size());
  std::size_t wrong = 0;
  Random random = numbers_of(2);
  const std::size_t each = recordings() / 2 / faults.size() + 1;
  for (std::size_t kind = 0; kind < faults.size(); ++kind)
    for (std::size_t made = 0; made < each;) {
      const Program program = Maker(random).made();
      const std::optional<Outcome> outcome = faults[kind].second(random, program);
      if (!outcome) continue;
      ++made;
      ++told[kind].at(static_cast<std::size_t>(outcome->told));
      if (outcome->told == Told::right || ++wrong > 20) continue;
      EXPECT_TRUE(false) << faults[kind].first << ", " << program.axes << " axes: " << outcome->why;
    }
  for (std::size_t kind = 0; kind < faults.size(); ++kind)
    fmt::print("{}: {} found, {} missed, {} at a wrong block or sample, {} of another kind or size\n",
               faults[kind].first, told[kind][0], told[kind][1], told[kind][2], told[kind][3]);
  EXPECT_EQ(wrong, 0U);
}

}  // namespace
}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
// One mistake made all along is named: recordings of exact paths, spoiled by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "certify/causes/least.h"
#include "certify/trace/program_path.h"
#include "certify/trace/trace.h"

namespace toolcomp::certify {
namespace {

constexpr double kTolerance = 0.005;

spec::Case program(std::string text) {
  spec::Case c;
  c.id = "causes";
  c.section = "fanuc/tool-length-offset";
  c.program = std::move(text);
  return c;
}

spec::Case five_axes(std::string text) {
  spec::Case c = program(std::move(text));
  c.section = "fanuc/tool-center-point-control";
  c.setup.axes = spec::Axes("XYZAC");
  const auto set = [&](std::uint32_t number, std::string_view value) {
    c.setup.parameters[{number, -1}] = *spec::parse_decimal(value);
  };
  // A table of A carrying C, with the axes of both through (10, 20, 30).
  set(19680, "12");
  set(19681, "4");
  set(19682, "1");
  set(19686, "5");
  set(19687, "3");
  set(19700, "10");
  set(19701, "20");
  set(19702, "30");
  return c;
}

struct Recorder {
  std::vector<AxisPoint> at;
  std::vector<double> time;

  // Along the path of a case at an even 100 mm/s (or degrees/s), a sample each millisecond, standing at both ends.
  static Recorder along(const spec::Case& c) {
    TraceSpace space;
    for (std::size_t i = 0; i < c.setup.axes.size(); ++i)
      (spec::is_rotary_axis(c.setup.axes.letter(i)) ? space.rotary : space.linear).push_back(i);
    ProgramPath path(c, space, {kTolerance, kTolerance});
    Recorder r;
    AxisPoint last{};
    for (PathPiece piece; path.next(piece);) {
      if (r.at.empty()) r.stand(piece.begin);
      double length = 0;
      for (std::size_t i = 0; i < piece.end.size(); ++i)
        length = std::max(length, std::fabs(piece.end[i] - piece.begin[i]));
      const int steps = std::max(1, static_cast<int>(std::ceil(length / 0.1)));
      for (int k = 1; k <= steps; ++k) {
        AxisPoint p = piece.begin;
        for (std::size_t i = 0; i < p.size(); ++i) p[i] += (piece.end[i] - piece.begin[i]) * k / steps;
        r.add(p);
      }
      last = piece.end;
    }
    r.stand(last);
    return r;
  }
  void add(const AxisPoint& p) {
    time.push_back(static_cast<double>(at.size()) / 1000);
    at.push_back(p);
  }
  void stand(const AxisPoint& p) {
    for (int k = 0; k < 100; ++k) add(p);
  }
  [[nodiscard]] std::string csv(const spec::Axes& axes) const {
    std::ostringstream text;
    text.precision(17);
    text << "time";
    for (std::size_t i = 0; i < axes.size(); ++i) text << ',' << axes.letter(i);
    text << '\n';
    for (std::size_t k = 0; k < at.size(); ++k) {
      text << time[k];
      for (std::size_t i = 0; i < axes.size(); ++i) text << ',' << at[k][i];
      text << '\n';
    }
    return text.str();
  }
};

// What is said of a recording along `made` for a run of `wanted`, spoiled.
std::string cause(const spec::Case& wanted, const spec::Case& made, const std::function<void(Recorder&)>& spoil = {}) {
  Recorder recorder = Recorder::along(made);
  if (spoil) spoil(recorder);
  std::istringstream csv(recorder.csv(wanted.setup.axes));
  TraceOptions options;
  options.tolerance = kTolerance;
  const TraceResult result = judge_trace(wanted, csv, "trace.csv", options);
  if (result.findings_total == 0) return "conforms";
  return result.cause.value_or("none");
}

std::string cause(const spec::Case& c, const std::function<void(AxisPoint&)>& spoil) {
  return cause(c, c, [&](Recorder& recorder) {
    for (AxisPoint& at : recorder.at) spoil(at);
  });
}

// A part of a circle and lines, nothing symmetric.
const spec::Case kContour = program("G90 G01 X40. F100\nG03 X60. Y20. R20.\nG01 Y70. Z-8.\nX5.\n");

TEST(TraceCauses, NoneIsLookedForWhereNothingIsFound) { EXPECT_EQ(cause(kContour, kContour), "conforms"); }

TEST(TraceCauses, AxesExchanged) {
  EXPECT_EQ(cause(kContour, [](AxisPoint& at) { std::swap(at[0], at[1]); }), "axes X and Y are exchanged");
  EXPECT_EQ(cause(kContour, [](AxisPoint& at) { std::swap(at[0], at[2]); }), "axes X and Z are exchanged");
}

TEST(TraceCauses, AnAxisReversed) {
  EXPECT_EQ(cause(kContour, [](AxisPoint& at) { at[1] = -at[1]; }), "axis Y runs in the opposite direction");
}

TEST(TraceCauses, Shifted) {
  EXPECT_EQ(cause(kContour,
                  [](AxisPoint& at) {
                    at[0] += 0.25;
                    at[2] -= 12;
                  }),
            "the recording is shifted by X 0.25, Z -12");
}

// 5 millionths of 600 mm are 3 µm at tolerance 1 µm… here 20 millionths of 60 m: told apart from a shift.
TEST(TraceCauses, Scaled) {
  const spec::Case c = program("G90 G01 X600. F100\nY300.\nX0\n");
  EXPECT_EQ(cause(c, [](AxisPoint& at) { at[0] *= 1.00005; }), "the recording is scaled: X by 1.00005");
}

TEST(TraceCauses, AnAxisThatIsLate) {
  const spec::Case circle = program("G90 G01 X20. F100\nG03 I-20.\n");
  const std::string found = cause(circle, circle, [](Recorder& recorder) {
    const std::vector<AxisPoint> exact = recorder.at;
    for (std::size_t k = 0; k < exact.size(); ++k) recorder.at[k][0] = exact[k < 3 ? 0 : k - 3][0];
  });
  EXPECT_EQ(found, "axis X is late by 3 ms");
}

TEST(TraceCauses, Offsets) {
  spec::Case c = program("G90 G00 G43 Z100. H1\nG01 G41 D1 X40. F100\nY40.\nX-20.\nG40 Y0\n");
  c.section = "fanuc/cutter-compensation-c";
  c.setup.memory = spec::OffsetMemory::c;
  c.setup.h[1] = {spec::decimal(25), {}};
  c.setup.h[2] = {spec::decimal(40), {}};
  c.setup.d[1] = {spec::decimal(4), *spec::parse_decimal("0.5")};
  const auto with = [&](auto change) {
    spec::Case other = c;
    change(other.setup);
    return other;
  };
  EXPECT_EQ(cause(c, with([](spec::Setup& s) { s.h[1] = {}; })), "H1 (here 25) is ignored: it counts as 0");
  EXPECT_EQ(cause(c, with([](spec::Setup& s) { s.h[1] = s.h[2]; })), "H1 (here 25) has the value of H2, 40");
  EXPECT_EQ(cause(c, with([](spec::Setup& s) { s.d[1].wear = {}; })), "D1 (here 4.5) is taken without its wear");
  EXPECT_EQ(cause(c, with([](spec::Setup& s) { s.d[1] = {spec::decimal(-4), *spec::parse_decimal("-0.5")}; })),
            "D1 (here 4.5) has the opposite sign");
  EXPECT_EQ(cause(c, with([](spec::Setup& s) { s.d[1].wear = *spec::parse_decimal("0.52"); })).substr(0, 28),
            "D1 (here 4.5) is off by +0.0");
}

// Only where the axis turns back is anything to be seen, and no sample is off the line.
TEST(TraceCauses, AnOffsetThatShowsInTurnsAlone) {
  spec::Case c = program("G90 G01 X40. F100\nG43 H1 Z-20.\nG43 H1 Z30.\nG49 Z60.\n");
  c.setup.h[1] = {spec::decimal(-5), {}};
  spec::Case other = c;
  other.setup.h[1] = {*spec::parse_decimal("-4.97"), {}};
  EXPECT_EQ(cause(c, other).substr(0, 26), "H1 (here -5) is off by +0.");
}

// A mistake that explains what was recorded explains no end that is missing.
TEST(TraceCauses, ARecordingThatEndsTooEarlyHasNone) {
  EXPECT_EQ(cause(kContour, kContour,
                  [](Recorder& recorder) {
                    recorder.at.resize(recorder.at.size() * 3 / 4);
                    recorder.time.resize(recorder.at.size());
                    for (AxisPoint& at : recorder.at) std::swap(at[0], at[1]);
                  }),
            "none");
}

const char* const kTip =
    "G90 G00 G43.4 H0 X0 Y0 Z0 A0 C0\nG01 X40. Y10. A20. C30. F100\nY-30. A-10. C75.\nX0 C-20.\nG49\n";

TEST(TraceCauses, NoTipControl) {
  const spec::Case c = five_axes(kTip);
  spec::Case straight = c;
  straight.program = "G90 G00 X0 Y0 Z0 A0 C0\nG01 X40. Y10. A20. C30. F100\nY-30. A-10. C75.\nX0 C-20.\n";
  EXPECT_EQ(cause(c, straight), "tool center point control is not in force");
}

// The same in machine coordinates, seven from those of G54.
TEST(TraceCauses, NoTipControlInMachineCoordinates) {
  spec::Case c = five_axes(kTip);
  c.setup.workpiece[0]['X'] = spec::decimal(7);
  spec::Case straight = c;
  straight.program = "G90 G00 X0 Y0 Z0 A0 C0\nG01 X40. Y10. A20. C30. F100\nY-30. A-10. C75.\nX0 C-20.\n";
  Recorder recorder = Recorder::along(straight);
  for (AxisPoint& at : recorder.at) at[0] += 7;
  std::istringstream csv(recorder.csv(c.setup.axes));
  TraceOptions options;
  options.tolerance = kTolerance;
  options.frame = PathFrame::machine;
  EXPECT_EQ(judge_trace(c, csv, "trace.csv", options).cause, "tool center point control is not in force");
}

TEST(TraceCauses, Geometry) {
  const spec::Case c = five_axes(kTip);
  spec::Case other = c;
  other.setup.parameters[{19701, -1}] = *spec::parse_decimal("20.04");
  EXPECT_EQ(cause(c, other).substr(0, 49), "the machine's No. 19701 (here 20) is off by +0.04");
}

TEST(TraceCauses, SensesOfRotation) {
  const spec::Case c = five_axes(kTip);
  spec::Case other = c;
  other.setup.parameters[{19689, -1}] = spec::decimal(1);
  EXPECT_EQ(cause(c, other), "a rotary axis turns in the opposite direction (No. 19689)");
}

TEST(TraceCauses, ABumpHasNone) {
  EXPECT_EQ(cause(kContour, kContour, [](Recorder& recorder) { recorder.at[300][1] += 0.1; }), "none");
}

TEST(LeastOf, FindsTheLeast) {
  const auto least = least_of([](double x) { return std::fabs(x - 0.037) + 0.001; }, 2);
  ASSERT_TRUE(least);
  EXPECT_NEAR(*least, 0.037, 1e-6);
  EXPECT_FALSE(least_of([](double) { return 1.0; }, 2));
}

}  // namespace
}  // namespace toolcomp::certify

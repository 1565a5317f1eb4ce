// SPDX-License-Identifier: Apache-2.0
// Machines and checks for tests of tool center point control in the fast engine.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <initializer_list>
#include <numeric>
#include <string>

#include "tests/unit/fanuc/fast_run.h"

namespace toolcomp::fast::tip_control {

inline constexpr double kTolerance = 2e-13;

inline std::string machine(const std::string& axes, const std::string& parameters, const std::string& position,
                           const std::string& rest) {
  return "control=\"fanuc\"\nunits=\"mm\"\naxes=[" + axes + "]\n[position]\n" + position + "[parameters]\n" +
         parameters + "[offsets.H]\n1=100\n2=150\n3=80\n[offsets.D]\n1=10\n2=5\n" + rest;
}
// A machine of the worked examples (corpus/examples/fanuc/machines.h): HC, C carries B.
inline std::string machine_head(const std::string& parameters, const std::string& position,
                                const std::string& rest = "") {
  return machine(R"("X","Y","Z","B","C")", "19680=2\n19681=5\n19682=3\n19686=4\n19687=2\n" + parameters, position,
                 rest);
}
// N45: the slave about (0, 1, 1).
inline std::string machine_nutating_head(const std::string& parameters, const std::string& position) {
  return machine(R"("X","Y","Z","B","C")", "19680=2\n19681=5\n19682=3\n19686=4\n19687=5\n19688=45\n" + parameters,
                 position, "");
}
// TAC: the A table carries the C table.
inline std::string machine_table(const std::string& parameters, const std::string& position,
                                 const std::string& rest = "") {
  return machine(R"("X","Y","Z","A","C")",
                 "19680=12\n19681=4\n19682=1\n19684=1\n19686=5\n19687=3\n19689=1\n" + parameters, position, rest);
}
// MBC: B turns the tool, C the table.
inline std::string machine_b_c_mixed(const std::string& parameters, const std::string& position,
                                     const std::string& rest = "") {
  return machine(R"("X","Y","Z","B","C")", "19680=21\n19681=4\n19682=2\n19686=5\n19687=3\n19689=1\n" + parameters,
                 position, rest);
}

// The last move of a line that is no turn: its own one, where corner moves of the line go before it.
inline std::size_t move_at(const ProgramRun& run, std::uint64_t line) {
  std::size_t found = run.events.size();
  for (std::size_t i = 0; i < run.events.size(); ++i) {
    const Event& event = run.events[i];
    if (event.kind == spec::EventKind::move && event.line == line && event.cause != spec::Cause::pre_turn &&
        event.cause != spec::Cause::post_turn && event.cause != spec::Cause::corner)
      found = i;
  }
  EXPECT_LT(found, run.events.size()) << "line " << line;
  return found;
}
inline std::size_t sample_at(const ProgramRun& run, std::uint64_t line, unsigned numerator, unsigned denominator) {
  const unsigned divisor = std::gcd(numerator, denominator);
  numerator /= divisor;
  denominator /= divisor;
  for (std::size_t i = 0; i < run.events.size(); ++i) {
    const Event& event = run.events[i];
    if (event.kind == spec::EventKind::sample && event.line == line && event.t_numerator == numerator &&
        event.t_denominator == denominator)
      return i;
  }
  ADD_FAILURE() << "no sample " << numerator << "/" << denominator << " in line " << line;
  return run.events.size();
}

inline void expect_axis(const ProgramRun& run, std::size_t i, char letter, double value,
                        double tolerance = kTolerance) {
  EXPECT_NEAR(run.axis(i, letter), value, tolerance) << letter << " of event " << i;
}
inline void expect_axes(const ProgramRun& run, std::size_t i, const std::string& letters,
                        std::initializer_list<double> values, double tolerance = kTolerance) {
  std::size_t k = 0;
  for (const double value : values) expect_axis(run, i, letters.at(k++), value, tolerance);
}
inline void expect_point(const ProgramRun& run, std::size_t i, const std::array<double, 3>& point) {
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(run.point(i, static_cast<char>('X' + k)), point[k], kTolerance) << k << " of event " << i;
}
inline void expect_direction(const ProgramRun& run, std::size_t i, const std::array<double, 3>& direction,
                             double tolerance = 2e-15) {
  ASSERT_TRUE(run.events.at(i).tool_axis) << "event " << i;
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR((*run.events.at(i).tool_axis)[k], direction[k], tolerance) << k << " of event " << i;
}

}  // namespace toolcomp::fast::tip_control

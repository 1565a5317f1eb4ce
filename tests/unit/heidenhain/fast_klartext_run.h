// SPDX-License-Identifier: Apache-2.0
// Runs a Klartext program through the fast engine and keeps its events.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "fast/heidenhain/engine.h"
#include "spec/language/heidenhain/klartext_reader.h"
#include "spec/language/setup_format.h"

namespace toolcomp::fast::klartext {

using Triple = std::array<double, 3>;

class KlartextRun final : public EventSink {
 public:
  KlartextRun(const std::string& setup_toml, std::string_view program)
      : setup_(spec::read_setup_toml("control = \"heidenhain\"\n" + setup_toml, "setup")) {
    Engine engine(setup_, *this);
    spec::klartext::Reader reader(spec::text_source(program), setup_);
    for (spec::klartext::Block block; reader.next(block);) engine.block(block);
    engine.end();
  }
  void on(const Event& event) override {
    events.push_back(event);
    if (event.kind == spec::EventKind::move) moves.push_back(event);
  }

  // Of move i.
  [[nodiscard]] Triple programmed(std::size_t i) const { return triple(moves.at(i).programmed); }
  [[nodiscard]] Triple tip(std::size_t i) const { return triple(moves.at(i).point); }
  [[nodiscard]] Triple axes(std::size_t i) const { return triple(moves.at(i).axes); }
  [[nodiscard]] Triple tool_axis(std::size_t i) const { return *moves.at(i).tool_axis; }
  [[nodiscard]] Triple center(std::size_t i) const { return moves.at(i).space->tool_center; }
  [[nodiscard]] Triple shift(std::size_t i) const { return moves.at(i).space->shift; }
  [[nodiscard]] Triple tool_shift(std::size_t i) const { return moves.at(i).space->tool_shift; }
  [[nodiscard]] Triple contact(std::size_t i) const { return moves.at(i).space->contact.value().point; }
  [[nodiscard]] bool flat(std::size_t i) const { return moves.at(i).space->contact.value().flat; }
  [[nodiscard]] double angle(std::size_t i) const { return moves.at(i).space->contact.value().angle.value(); }
  // Of the last move.
  [[nodiscard]] std::size_t last() const { return moves.size() - 1; }

  // Everything but moves: "W_DIGITS@3 E_TOOL@4".
  [[nodiscard]] std::string messages() const {
    std::string text;
    for (const Event& event : events) {
      if (event.kind == spec::EventKind::move) continue;
      if (!text.empty()) text += ' ';
      text += std::string(event.number.view()) + "@" + std::to_string(event.line);
    }
    return text;
  }

  std::vector<Event> events;
  std::vector<Event> moves;

 private:
  [[nodiscard]] Triple triple(const spec::AxisValues<double>& values) const {
    return {values[setup_.axes.index('X')], values[setup_.axes.index('Y')], values[setup_.axes.index('Z')]};
  }
  spec::Setup setup_;
};

// To 15 decimals and one ulp, of `scale` at least: sums cannot be better than their terms.
inline void expect_triple(const Triple& actual, const Triple& expected, double scale = 4) {
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(actual[i], expected[i], 5e-16 + 0x1p-52 * std::max(std::abs(expected[i]), scale)) << "component " << i;
}
inline void expect_shift(const Triple& actual, const Triple& expected) { expect_triple(actual, expected, 0.25); }

}  // namespace toolcomp::fast::klartext

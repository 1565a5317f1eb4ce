// SPDX-License-Identifier: Apache-2.0
// Runs a program through the fast engine and keeps its events.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fast/fanuc/engine.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/setup_format.h"
#include "tests/support/setup_with_feed.h"

namespace toolcomp::fast {

class ProgramRun final : public EventSink {
 public:
  ProgramRun(std::string_view setup_toml, std::string_view program, std::uint32_t samples = 0)
      : ProgramRun(test::setup_with_feed(setup_toml), program, samples) {}
  ProgramRun(const spec::Setup& setup, std::string_view program, std::uint32_t samples = 0) : axes_(setup.axes) {
    Engine engine(setup, *this, samples);
    spec::ProgramReader reader(spec::text_source(program), setup.axes);
    for (spec::Block block; reader.next(block);) engine.block(block);
    engine.end();
  }
  void on(const Event& event) override { events.push_back(event); }

  // The value of an axis of event `i`: what the axes are sent to, the compensated point, machine coordinates.
  [[nodiscard]] double axis(std::size_t i, char letter) const { return events.at(i).axes[axes_.index(letter)]; }
  [[nodiscard]] double point(std::size_t i, char letter) const { return events.at(i).point[axes_.index(letter)]; }
  [[nodiscard]] double programmed(std::size_t i, char letter) const {
    return events.at(i).programmed[axes_.index(letter)];
  }
  [[nodiscard]] double machine(std::size_t i, char letter) const { return events.at(i).machine[axes_.index(letter)]; }
  // The number of the alarm that ended the run, with its line ("PS0010@3"), or "".
  [[nodiscard]] std::string alarm() const {
    if (events.empty() || events.back().kind != spec::EventKind::alarm) return "";
    return std::string(events.back().number.view()) + "@" + std::to_string(events.back().line);
  }
  [[nodiscard]] std::size_t moves() const {
    std::size_t n = 0;
    for (const Event& event : events) n += event.kind == spec::EventKind::move ? 1 : 0;
    return n;
  }
  // The Z of every move, in order.
  [[nodiscard]] std::vector<double> axis_path(char letter) const {
    std::vector<double> path;
    for (const Event& event : events)
      if (event.kind == spec::EventKind::move) path.push_back(event.axes[axes_.index(letter)]);
    return path;
  }

  std::vector<Event> events;

 private:
  spec::Axes axes_;
};

}  // namespace toolcomp::fast

// SPDX-License-Identifier: Apache-2.0
// Runs a program in the exact engine and gives its events as short lines, so that a test reads like the
// example it is typed in from.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/basis/recorder.h"
#include "model/fanuc/engine.h"
#include "spec/language/event_names.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/setup_format.h"
#include "tests/support/setup_with_feed.h"

namespace toolcomp::test {

struct Collector final : model::EventSink {
  void on(const model::Event& event) override { events.push_back(event); }
  std::vector<model::Event> events;
};

struct Run {
  spec::Setup setup;
  model::Recorder recorder{true};
  Collector sink;

  const std::vector<model::Event>& events() const { return sink.events; }
};

// `force`: one decision by sign and the outcome it is made to have. `samples`: N of the fractions k/N inside blocks.
inline Run run(std::string_view setup, std::string_view program, std::pair<std::size_t, exact::Sign>* force = nullptr,
               std::uint32_t samples = 0) {
  Run result{setup_with_feed(setup), model::Recorder(true), {}};
  if (force != nullptr) result.recorder.force(force->first, force->second);
  spec::ProgramReader reader(spec::text_source(program), result.setup.axes);
  model::Engine engine(result.setup, result.recorder, result.sink, samples);
  spec::Block block;
  while (!engine.stopped() && reader.next(block)) engine.block(block);
  engine.end();
  return result;
}

inline std::string text(const spec::AxisValues<exact::Real>& values, const spec::Axes& axes, int digits) {
  std::string line;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (values.has(i)) line += (line.empty() ? "" : " ") + std::string(1, axes.letter(i)) + values[i].decimal(digits);
  return line;
}

// What a line shows of a move.
enum class Show { axes, point, machine };

// "2 rapid X0 Y0 Z-36"; causes other than programmed behind: "5 linear X1 (start-up)". Alarms: "7 PS0027"; settings:
// "3 H1=12"; samples: "5 1/4 X1 …".
inline std::vector<std::string> lines(const Run& run, Show show = Show::axes, int digits = 15) {
  std::vector<std::string> result;
  for (const model::Event& event : run.events()) {
    std::string line = std::to_string(event.line) + ' ';
    switch (event.kind) {
      case spec::EventKind::move: {
        const auto& values = show == Show::axes ? event.axes : show == Show::point ? event.point : event.machine;
        line += std::string(spec::name(event.type)) + ' ' + text(values, run.setup.axes, digits);
        if (event.cause != spec::Cause::programmed) line += " (" + std::string(spec::name(event.cause)) + ')';
        break;
      }
      case spec::EventKind::setting:
        line += std::string(event.setting.view()) + '=' + event.value.decimal(digits);
        break;
      case spec::EventKind::sample:
        line += std::to_string(event.t_numerator) + '/' + std::to_string(event.t_denominator) + ' ' +
                text(show == Show::point ? event.point : event.axes, run.setup.axes, digits);
        break;
      default:
        line += event.number.view();
    }
    result.push_back(line);
  }
  return result;
}

using Lines = std::vector<std::string>;

}  // namespace toolcomp::test

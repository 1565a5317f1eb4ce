// SPDX-License-Identifier: Apache-2.0
// The reader and the engines of a control. Only this file chooses them by the control of a setup.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "fast/fanuc/engine.h"
#include "fast/heidenhain/engine.h"
#include "judge/oracle/verdict.h"
#include "model/fanuc/engine.h"
#include "model/heidenhain/engine.h"
#include "spec/language/alarm.h"
#include "spec/language/byte_source.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/heidenhain/klartext_reader.h"
#include "spec/language/reader_options.h"
#include "spec/language/setup.h"

namespace toolcomp::judge {

// `file` is the name in messages. Every function throws spec::InputError for a setup the control could not have.
struct FanucControl {
  using Reader = spec::ProgramReader;
  using Block = spec::Block;
  using Model = model::Engine;
  using Fast = fast::Engine;
  static Reader reader(std::unique_ptr<spec::ByteSource> text, const spec::Setup& setup, std::string file,
                       spec::CalledProgram called = {}) {
    return {std::move(text), setup.axes, spec::reader_options(setup, std::move(file), std::move(called))};
  }
  static Model model(const spec::Setup& setup, model::Recorder& recorder, model::EventSink& sink,
                     std::uint32_t samples) {
    return {setup, recorder, sink, samples};
  }
  static Fast fast(const spec::Setup& setup, fast::EventSink& sink, std::uint32_t samples) {
    return {setup, sink, samples};
  }
};

// Only tool center point control has samples, so there are none here.
struct HeidenhainControl {
  using Reader = spec::klartext::Reader;
  using Block = spec::klartext::Block;
  using Model = model::klartext::Engine;
  using Fast = fast::klartext::Engine;
  static Reader reader(std::unique_ptr<spec::ByteSource> text, const spec::Setup& setup, std::string file,
                       spec::CalledProgram called = {}) {
    return {std::move(text), setup, spec::reader_options(setup, std::move(file), std::move(called))};
  }
  static Model model(const spec::Setup& setup, model::Recorder& recorder, model::EventSink& sink, std::uint32_t) {
    return {setup, recorder, sink};
  }
  static Fast fast(const spec::Setup& setup, fast::EventSink& sink, std::uint32_t) { return {setup, sink}; }
};

// Whether, and where, the run ends at this block without an alarm. `events`: the number of events given before it.
inline std::optional<Beyond> beyond_of(const spec::Block& block, std::size_t events) {
  if (const char* const what = spec::beyond(block)) return Beyond{block.line, block.alarm->column, what, events};
  return std::nullopt;
}
inline std::optional<Beyond> beyond_of(const spec::klartext::Block& block, std::size_t events) {
  if (const char* const what = spec::beyond(block)) return Beyond{block.alarm->line, block.alarm->column, what, events};
  return std::nullopt;
}

// Calls `visit` with the control of the setup.
template <class Visit>
decltype(auto) with_control(const spec::Setup& setup, Visit&& visit) {
  return setup.control == spec::Control::heidenhain ? std::forward<Visit>(visit)(HeidenhainControl{})
                                                    : std::forward<Visit>(visit)(FanucControl{});
}

}  // namespace toolcomp::judge

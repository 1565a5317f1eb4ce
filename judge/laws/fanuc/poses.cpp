// SPDX-License-Identifier: Apache-2.0
#include "judge/laws/fanuc/poses.h"

#include <algorithm>

#include "judge/laws/fanuc/stops.h"
#include "judge/laws/numbers.h"

namespace toolcomp::judge::laws {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

bool is_mode(const FanucBlock& b) { return b.length == kG43_4 || b.length == kG43_5; }
bool says_mode(const FanucBlock& b) { return b.has_code(kG43_4) || b.has_code(kG43_5); }

bool changes_frames(const FanucProgram& program) {
  return program.has_code(
      {kG10, kG37, kG92, kG52, kG53, kG28, kG29, kG30, kG30_1, kG54, kG54_1, kG55, kG56, kG57, kG58, kG59});
}

std::optional<std::array<Real, 2>> rotary(const Machine& machine, const spec::AxisValues<Real>& values) {
  std::array<Real, 2> degrees;
  for (std::size_t i = 0; i < 2; ++i) {
    const std::size_t axis = machine.axes().at(i);
    if (!values.has(axis)) return std::nullopt;
    degrees.at(i) = values[axis];
  }
  return degrees;
}

// Samples give no machine coordinates: theirs are axes and workpiece zeros.
std::optional<Pose> pose_of(const spec::Axes& axes, const Machine& machine, const Mode& mode,
                            const model::Event& event) {
  Pose pose;
  pose.event = &event;
  const bool given = !event.machine.empty();
  const auto degrees = rotary(machine, given && mode.by_machine ? event.machine : event.axes);
  const auto place = xyz(axes, given ? event.machine : event.axes);
  if (!degrees || !place) return std::nullopt;
  pose.degrees = *degrees;
  pose.control_point = *place;
  if (!given) {
    pose.control_point = pose.control_point + mode.origin;
    // 0 where the angles are the programmed ones.
    for (std::size_t i = 0; i < 2; ++i) pose.degrees.at(i) += mode.rotary_zeros.at(i);
  }
  pose.turns = machine.turns(pose.degrees);
  return pose;
}

std::optional<Mode> mode_of(const spec::Setup& setup, const FanucProgram& program, const Machine& machine,
                            std::size_t block, const model::Event& event) {
  const auto place = xyz(setup.axes, event.machine);
  const auto place_in_workpiece = xyz(setup.axes, event.axes);
  const bool by_machine = setup.rotary_angles == spec::RotaryAngles::machine;
  const auto degrees = rotary(machine, by_machine ? event.machine : event.axes);
  const auto degrees_in_workpiece = rotary(machine, event.axes);
  if (!place || !place_in_workpiece || !degrees || !degrees_in_workpiece) return std::nullopt;
  Mode mode;
  mode.block = block;
  mode.by_machine = by_machine;
  mode.turns = machine.turns(*degrees);
  mode.origin = *place - *place_in_workpiece;
  for (std::size_t i = 0; i < 2; ++i) mode.rotary_zeros.at(i) = degrees->at(i) - degrees_in_workpiece->at(i);
  const FanucBlock& b = program.blocks()[block];
  if (b.has('H') && b.h)
    if (const auto value = length_value(setup, *b.h)) mode.length = Real(*value) + machine.holder_offset();
  return mode;
}

}  // namespace

std::vector<Run> runs_of(const spec::Setup& setup, const FanucProgram& program, std::span<const model::Event> events,
                         const Machine& machine) {
  std::vector<Run> runs;
  if (changes_frames(program)) return runs;
  const spec::Axes& axes = setup.axes;
  const auto& blocks = program.blocks();
  std::size_t latest = kNone;  // block that began the mode of the last run
  std::size_t seen = 0;        // blocks whose codes were read
  bool spoiled = false;        // a second G43.4 within one mode, or holes
  bool other_length = false;
  bool in_mode = false;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const model::Event& event = events[i];
    if (event.kind != spec::EventKind::move && event.kind != spec::EventKind::sample) continue;
    const std::size_t block = program.index(event.line);
    if (block == blocks.size()) break;
    for (; seen <= block; ++seen) {
      const FanucBlock& b = blocks[seen];
      if (says_mode(b)) {
        if (in_mode) spoiled = true;
        if (!in_mode) other_length = false;
        in_mode = true;
        latest = seen;
      } else if (!is_mode(b)) {
        in_mode = spoiled = false;
      } else if (b.has('H')) {
        other_length = true;
      }
      // Holes stand among no poses: the next block would begin elsewhere.
      if (in_mode && b.drills) spoiled = true;
    }
    if (!in_mode || spoiled) continue;
    if (runs.empty() || runs.back().mode.block != latest || block == latest) {
      // The end of the mode's own block is where it begins; more moves of it only lead there.
      if (block != latest || event.kind != spec::EventKind::move) continue;
      const auto mode = mode_of(setup, program, machine, latest, event);
      if (!mode) continue;
      if (runs.empty() || runs.back().mode.block != latest) runs.emplace_back();
      runs.back() = {*mode, {}};
    }
    if (other_length) runs.back().mode.length.reset();
    auto pose = pose_of(axes, machine, runs.back().mode, event);
    if (!pose) continue;
    pose->index = i;
    pose->block = block;
    runs.back().poses.push_back(std::move(*pose));
  }
  return runs;
}

}  // namespace toolcomp::judge::laws

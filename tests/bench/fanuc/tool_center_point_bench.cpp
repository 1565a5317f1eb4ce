// SPDX-License-Identifier: Apache-2.0
// Tool center point control and tool posture control: nanoseconds a block end, and a sample inside a block, around a
// wavy ring with a tool that turns in every block; of the block end the inverse kinematics alone.
#include <array>
#include <cmath>
#include <numbers>

#include "fast/fanuc/tool_posture_control/posture.h"
#include "fast/kinematics/machine.h"
#include "tests/bench/fanuc/leaning_tool.h"

namespace {

using namespace toolcomp::bench;

// C (about Z) carries B, about Y or inclined by 45 degrees.
std::string head(std::string_view axis) {
  return "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"B\", \"C\"]\n[parameters]\n19680 = 2\n19681 = 5\n"
         "19682 = 3\n19686 = 4\n" +
         std::string(axis) + "[offsets.H]\n1 = 100\n";
}
constexpr std::string_view kUpright = "19687 = 2\n";
constexpr std::string_view kInclined = "19687 = 5\n19688 = 45\n";

template <class Tool>
Program around_with(std::string_view axis, std::string_view mode, const Tool& tool, std::uint32_t samples = 0) {
  Program program{head(axis), "G90 G01 F1000 " + std::string(mode) + "\n", "", samples};
  for (const Place& place : places()) program.body += place.position + tool(place) + "\n";
  return program;
}

Program tip_rotary_words() { return around_with(kUpright, "G43.4 H1 P0", rotary_words); }
Program tip_ijk() { return around_with(kUpright, "G43.5 H1 P0", vector_words); }
Program posture_rotary_words() { return around_with(kUpright, "G43.4 H1 P1", rotary_words); }
Program posture_ijk() { return around_with(kUpright, "G43.5 H1 P1", vector_words); }
Program posture_ijk_inclined() { return around_with(kInclined, "G43.5 H1 P1", vector_words); }
Program tip_samples() { return around_with(kUpright, "G43.5 H1 P0", vector_words, 100); }
Program posture_samples() { return around_with(kUpright, "G43.5 H1 P1", vector_words, 100); }

TOOLCOMP_ROW(tip_rotary_words);
TOOLCOMP_ROW(tip_ijk);
TOOLCOMP_ROW(posture_rotary_words);
TOOLCOMP_ROW(posture_ijk);
TOOLCOMP_ROW(posture_ijk_inclined);
TOOLCOMP_ROW(tip_samples);
TOOLCOMP_ROW(posture_samples);

// --- inverse kinematics and the choice of the pair ---

// B turns the tool, C the table.
constexpr std::string_view kMixed =
    "control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"B\", \"C\"]\n[parameters]\n19680 = 21\n19681 = 4\n19682 = 2\n"
    "19686 = 5\n19687 = 3\n";

// Directions once around Z, at 10 to 60 degrees from it, no two the same: I J K of six places.
std::vector<toolcomp::fast::Direction> directions() {
  constexpr int kDirections = 1000;
  std::vector<toolcomp::fast::Direction> list(kDirections);
  for (int i = 0; i < kDirections; ++i) {
    const double around = 2 * std::numbers::pi * i / kDirections;
    const double slope = std::tan((35 + 25 * std::sin(7 * around)) * std::numbers::pi / 180);
    toolcomp::fast::set_small_direction(list[static_cast<std::size_t>(i)], std::llround(1e6 * slope * std::cos(around)),
                                        std::llround(1e6 * slope * std::sin(around)), 1'000'000);
  }
  return list;
}

// What the interpreter calls for I J K: each block starts where the one before ended.
void inverse(benchmark::State& state, const std::string& text, bool posture) {
  using toolcomp::fast::Pose;
  using toolcomp::fast::PosturePlan;
  const toolcomp::spec::Setup setup = toolcomp::spec::read_setup_toml(text, "setup");
  toolcomp::fast::Kinematics kinematics(setup);
  toolcomp::fast::Machine machine(setup, kinematics);
  const toolcomp::fast::ToolPostureControl control(setup, machine);
  const auto list = directions();
  Pose zero;
  machine.pose({}, 0, zero);
  machine.freeze(zero);
  Pose start;
  if (!machine.choose(list.back(), zero, start)) state.SkipWithError("out of reach");
  std::array<PosturePlan, 8> plans;  // as ToolCenterPointControl keeps them
  std::size_t last = 0;
  control.stand(start, plans[last]);
  bool good = true;
  for (auto _ : state)
    for (const toolcomp::fast::Direction& direction : list) {
      const std::size_t next = (last + 1) % plans.size();
      control.plan(plans[last].end, direction, posture, plans[next]);
      good &= plans[next].outcome == PosturePlan::Outcome::good;
      benchmark::DoNotOptimize(plans[next].end.axis[0].degrees);
      last = next;
    }
  if (!good) state.SkipWithError("out of reach");
  count_blocks(state, list.size());
}

// P0: the pair by the moving angles; P1: by the branch.
void inverse_head(benchmark::State& state) { inverse(state, head(kUpright), false); }
void inverse_mixed(benchmark::State& state) { inverse(state, std::string(kMixed), false); }
void inverse_inclined(benchmark::State& state) { inverse(state, head(kInclined), false); }
void inverse_head_posture(benchmark::State& state) { inverse(state, head(kUpright), true); }
void inverse_mixed_posture(benchmark::State& state) { inverse(state, std::string(kMixed), true); }
void inverse_inclined_posture(benchmark::State& state) { inverse(state, head(kInclined), true); }
BENCHMARK(inverse_head);
BENCHMARK(inverse_mixed);
BENCHMARK(inverse_inclined);
BENCHMARK(inverse_head_posture);
BENCHMARK(inverse_mixed_posture);
BENCHMARK(inverse_inclined_posture);

}  // namespace

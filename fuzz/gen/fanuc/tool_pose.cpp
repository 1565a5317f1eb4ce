// SPDX-License-Identifier: Apache-2.0
#include "fuzz/gen/fanuc/tool_pose.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fuzz/gen/fanuc/tool_turns.h"

namespace toolcomp::fuzz {
namespace {

// Whole directions of whole length: a² + b² + c² is a square.
constexpr SpaceCounts kRational[] = {{3, 0, 4},  {4, 0, 3},    {0, 3, 4},       {5, 0, 12}, {0, 8, 15}, {1, 2, 2},
                                     {2, 3, 6},  {1, 4, 8},    {2, 6, 9},       {4, 4, 7},  {6, 6, 7},  {20, 0, 21},
                                     {0, 0, 1},  {0, 0, 1},    {1, 0, 0},       {0, 1, 0},  {1, 0, 1},  {1, 1, 1},
                                     {0, -1, 1}, {12, 15, 16}, {400, 0, 39'999}};

constexpr double kMostWhole = 12;             // of a direction in whole numbers
constexpr std::int64_t kOne = 1'000'000'000;  // in billionths

}  // namespace

ToolPose::ToolPose(Choices& choose, ProgramWriter& write, const spec::Setup& setup)
    : choose_(choose), write_(write), setup_(setup), kinematic_(tool_direction(setup, {}).has_value()) {
  for (const std::uint32_t parameter : {19681U, 19686U, 19610U, 19615U}) {
    const auto number = setup.parameter(parameter);
    if (number && number->digits > 0 && number->digits <= setup.axes.size())
      if (const char letter = setup.axes.letter(number->digits - 1); rotary_.find(letter) == std::string::npos)
        rotary_ += letter;
  }
}

ToolAim ToolPose::aim() const {
  if (by_words_ && words_) return {as_direction(*words_), words_};
  const Direction d = tool_direction(setup_, write_.pose()).value_or(Direction{0, 0, 1});
  return {d, whole_along(d, kMostWhole)};
}

void ToolPose::turn() {
  if (by_words_)
    any_direction();
  else if (turns())
    rotary();
}

void ToolPose::rotary() {
  for (const char letter : rotary_) {
    if (rotary_.size() > 1 && choose_.chance(35)) continue;
    const std::int64_t target = rotary_target(choose_, write_, letter, {25, 12, 10, 20, 25, 8});
    write_.axis(letter, target - write_.at(letter));
  }
}

// Rational, any decimals, or along an axis.
void ToolPose::any_direction() {
  SpaceCounts d{};
  if (choose_.chance(75)) {
    d = choose_.one_of(kRational);
    if (choose_.chance(30)) std::swap(d[0], d[1]);
    d = of_any_sense(choose_, d);
  } else {
    const std::int64_t most = choose_.chance(60) ? 9 : 9'999 * write_.one();
    for (std::int64_t& x : d) x = choose_.between(-most, most);
  }
  if (d == SpaceCounts{}) d[2] = 1;
  direction(d);
}

void ToolPose::direction(const SpaceCounts& whole) {
  words_ = whole;
  direction_words(choose_, write_, whole, 30);
}

std::int64_t ToolPose::thousandths(std::int64_t counts) const {
  constexpr std::int64_t in_one = 1000;
  return write_.one() >= in_one ? counts * (write_.one() / in_one) : counts / (in_one / write_.one());
}

void ToolPose::turn_by(std::int64_t counts) {
  const ToolAim now = aim();
  if (by_words_) {
    const Direction about =
        turned(beside(now.direction), now.direction, static_cast<double>(choose_.between(0, 23) * 15));
    const Direction to = turned(now.direction, about, static_cast<double>(counts) / 1000);
    const double size = 9'000 * static_cast<double>(write_.one());
    SpaceCounts d{};
    for (std::size_t i = 0; i < 3; ++i) d[i] = std::llround(to[i] * size);
    direction(d);
    return;
  }
  // The axis that turns it most.
  char best = 0;
  double least = 2;
  for (const char letter : rotary_) {
    Pose pose = write_.pose();
    pose[letter] += 90;
    const double cosine = dot(now.direction, tool_direction(setup_, pose).value_or(now.direction));
    if (cosine < least) best = letter, least = cosine;
  }
  if (best != 0 && billionths(least) < kOne) write_.axis(best, thousandths(choose_.chance(50) ? counts : -counts));
}

void ToolPose::align() {
  if (by_words_) {
    SpaceCounts d{};
    d[choose_.weighted({25, 25, 50})] = choose_.chance(80) ? 1 : -1;
    direction(d);
    return;
  }
  if (!turns()) return;
  // All quarter turns of both axes.
  struct Candidate {
    std::int64_t first;
    std::int64_t second;
  };
  std::vector<Candidate> found;
  const char first = rotary_[0];
  const char second = rotary_.size() > 1 ? rotary_[1] : rotary_[0];
  for (std::int64_t i = -2; i < 2; ++i)
    for (std::int64_t k = -2; k < 2; ++k) {
      Pose pose = write_.pose();
      pose[first] = static_cast<double>(90 * i);
      pose[second] = static_cast<double>(90 * k);
      const Direction d = tool_direction(setup_, pose).value_or(Direction{0, 0, 1});
      for (const double x : d)
        if (std::abs(billionths(x)) == kOne) found.push_back({90 * i, 90 * k});
    }
  if (found.empty()) return;
  const Candidate to = found[choose_.below(found.size())];
  const std::int64_t one = write_.one();
  const std::int64_t first_travel = to.first * one - write_.at(first);
  if (first != second && (first_travel != 0 || choose_.chance(30))) write_.axis(first, first_travel);
  const std::int64_t second_travel = to.second * one - write_.at(second);
  if (second_travel != 0 || choose_.chance(30)) write_.axis(second, second_travel);
}

}  // namespace toolcomp::fuzz

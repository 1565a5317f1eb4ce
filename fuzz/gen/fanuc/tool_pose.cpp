#include "fuzz/gen/fanuc/tool_pose.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace toolcomp::fuzz {
namespace {

// Whole directions of whole length: a² + b² + c² is a square.
constexpr SpaceCounts kRational[] = {{3, 0, 4},  {4, 0, 3},    {0, 3, 4},       {5, 0, 12}, {0, 8, 15}, {1, 2, 2},
                                     {2, 3, 6},  {1, 4, 8},    {2, 6, 9},       {4, 4, 7},  {6, 6, 7},  {20, 0, 21},
                                     {0, 0, 1},  {0, 0, 1},    {1, 0, 0},       {0, 1, 0},  {1, 0, 1},  {1, 1, 1},
                                     {0, -1, 1}, {12, 15, 16}, {400, 0, 39'999}};

constexpr std::int64_t kOne = 1'000'000'000;  // in billionths

// The small whole vector along `d`, if one is.
std::optional<SpaceCounts> whole_along(const Direction& d) {
  constexpr double few = 12;
  double least = 1;
  for (const double x : d)
    if (billionths(x) != 0) least = std::min(least, std::fabs(x));
  SpaceCounts whole{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = d[i] / least;
    if (std::fabs(x) > few || billionths(x - std::round(x)) != 0) return std::nullopt;
    whole[i] = std::llround(x);
  }
  return whole;
}

Direction as_direction(const SpaceCounts& c) {
  return unit({static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])});
}

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
  return {d, whole_along(d)};
}

void ToolPose::turn() {
  if (by_words_)
    any_direction();
  else if (turns())
    rotary();
}

void ToolPose::rotary() {
  const std::int64_t one = write_.one();
  for (const char letter : rotary_) {
    if (rotary_.size() > 1 && choose_.chance(35)) continue;
    std::int64_t target = 0;
    switch (choose_.weighted({25, 12, 10, 20, 25, 8})) {
      case 0:
        target = choose_.between(-12, 12) * 15 * one;
        break;
      case 1:
        target = choose_.between(-4, 4) * 90 * one;
        break;
      case 2:
        target = choose_.between(-8, 8) * 45 * one;
        break;
      case 3:
        target = choose_.between(-60 * one, 60 * one);
        break;
      case 4:
        target = write_.at(letter) + choose_.between(-3 * one, 3 * one);
        break;
      default:
        target = write_.at(letter) + choose_.between(-180, 180) * one;
        break;
    }
    write_.axis(letter, target - write_.at(letter));
  }
}

// Rational, any decimals, or along an axis.
void ToolPose::any_direction() {
  SpaceCounts d{};
  if (choose_.chance(75)) {
    d = choose_.one_of(kRational);
    if (choose_.chance(30)) std::swap(d[0], d[1]);
    for (std::int64_t& x : d)
      if (choose_.chance(30)) x = -x;
    if (d[2] < 0 && choose_.chance(70)) d[2] = -d[2];
  } else {
    const std::int64_t most = choose_.chance(60) ? 9 : 9'999 * write_.one();
    for (std::int64_t& x : d) x = choose_.between(-most, most);
  }
  if (d == SpaceCounts{}) d[2] = 1;
  direction(d);
}

// As whole numbers where they are small, else as counts.
void ToolPose::direction(const SpaceCounts& whole) {
  words_ = whole;
  const std::int64_t most = std::max({std::abs(whole[0]), std::abs(whole[1]), std::abs(whole[2])});
  constexpr std::int64_t digits = 99'999;
  const std::int64_t factor = most > digits        ? 1
                              : choose_.chance(70) ? write_.one()
                              : choose_.chance(50) ? 1
                                                   : choose_.between(2, 9);
  for (std::size_t i = 0; i < 3; ++i)
    if (whole[i] != 0 || choose_.chance(30)) write_.number("IJK"[i], whole[i] * factor);
}

std::int64_t ToolPose::thousandths(std::int64_t counts) const {
  constexpr std::int64_t in_one = 1000;
  return write_.one() >= in_one ? counts * (write_.one() / in_one) : counts / (in_one / write_.one());
}

void ToolPose::turn_by(std::int64_t counts) {
  const ToolAim now = aim();
  if (by_words_) {
    const Direction helper = std::fabs(now.direction[0]) < 0.6 ? Direction{1, 0, 0} : Direction{0, 1, 0};
    Direction about = unit(cross(now.direction, helper));
    about = turned(about, now.direction, static_cast<double>(choose_.between(0, 23) * 15));
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

// SPDX-License-Identifier: Apache-2.0
// G41.3 programs: every way the tool can lie to the movement, and what may stand between movements.
#include <fmt/format.h>

#include <cmath>

#include "fuzz/gen/fanuc/program_writer.h"
#include "fuzz/gen/fanuc/setups.h"
#include "fuzz/gen/fanuc/tool_direction.h"
#include "fuzz/gen/fanuc/tool_turns.h"
#include "fuzz/gen/sections.h"

namespace toolcomp::fuzz {
namespace {

constexpr double kRadiansPerDegree = 0.017453292519943295;

// Integer directions of rational length: a² + b² + c² is a square.
constexpr SpaceCounts kRational[] = {{3, 0, 4}, {4, 0, 3}, {0, 3, 4}, {5, 0, 12},   {0, 8, 15},     {1, 2, 2},
                                     {2, 3, 6}, {1, 4, 8}, {2, 6, 9}, {4, 4, 7},    {6, 6, 7},      {20, 0, 21},
                                     {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {12, 15, 16}, {400, 0, 39999}};

// Directions at exactly 45, 60, 30 and 90 degrees: with 19631 one of Niven's angles they lie on the end of a range.
struct Pair {
  SpaceCounts tool;
  SpaceCounts movement;
};
constexpr Pair kNiven[] = {{{0, 0, 1}, {1, 0, 1}},  {{0, 0, 1}, {0, -1, -1}}, {{1, 1, 0}, {1, 0, 1}},
                           {{1, 0, 1}, {-1, 1, 0}}, {{1, 1, 0}, {2, 1, 1}},   {{0, 1, 1}, {-1, -1, -2}},
                           {{3, 0, 4}, {1, 0, 7}},  {{0, 3, 4}, {5, 4, -3}},  {{1, 2, 2}, {2, 1, -2}},
                           {{0, 4, 3}, {0, 7, -1}}};

class LeadingEdge {
 public:
  LeadingEdge(Choices& choose, spec::Case& c) : choose_(choose), case_(c), write_(choose, c.setup) {
    for (const char letter : c.setup.axes.letters())
      if (spec::is_rotary_axis(letter)) rotary_ += letter;
  }

  std::string program(std::uint32_t blocks) {
    preamble();
    while (write_.blocks() + 3 <= blocks || !compensated_once_) cycle(blocks);
    if (choose_.chance(30)) movement(Kind::any);
    if (tool_words_ && choose_.chance(30)) write_.word("G49").end_block();
    if (choose_.chance(15)) write_.word(choose_.one_of({"M30", "M02"})).end_block();
    return write_.text();
  }

 private:
  enum class Kind : std::uint8_t {
    any,
    parallel,
    perpendicular,
    threshold,
    reversal,
    tiny,
    huge,
    niven,
    multiple,
    normal
  };

  void preamble() {
    write_.units();
    if (choose_.chance(50)) {
      write_.incremental(choose_.chance(60));
      write_.word(write_.incremental() ? "G91" : "G90");
    }
    if (choose_.chance(70)) write_.word("G01").number('F', choose_.between(1, 50) * 100 * write_.one());
    const bool kinematic = tool_direction(case_.setup, {}).has_value();
    // Tables have no G43.5 yet: an alarm, seldom wanted.
    const auto type = case_.setup.parameter(19680);
    const bool table = type && (type->digits == 12 || type->digits == 21);
    if (choose_.chance(table ? 4 : kinematic ? 30 : 75)) {
      // G43.5 has its own block: direction by I J K from here on.
      if (choose_.chance(60)) linear({choose_.between(1, 20) * write_.one(), 0, 0});
      write_.end_block();
      write_.word("G43.5").word(
          fmt::format("H{}", choose_.between(0, static_cast<std::int64_t>(case_.setup.h.size()))));
      direction();
      tool_words_ = true;
    } else {
      if (kinematic && choose_.chance(80)) rotate(true);
      linear({choose_.between(1, 20) * write_.one(), 0, 0});
    }
    write_.end_block();
  }

  void cycle(std::uint32_t blocks) {
    write_.switch_units();
    write_.word("G41.3");
    if (!compensated_once_ || choose_.chance(50)) offset_number();
    write_.end_block();
    compensated_once_ = true;
    last_ = {};
    movement(choose_.chance(80) ? Kind::normal : choose_.chance(50) ? Kind::perpendicular : Kind::any);
    const std::int64_t inside =
        choose_.between(1, std::max<std::int64_t>(1, static_cast<std::int64_t>(blocks) - write_.blocks() - 1));
    for (std::int64_t i = 1; i < inside; ++i) inside_block();
    if (!choose_.chance(12)) write_.word(choose_.chance(85) ? "G40" : "D0").end_block();
  }

  void inside_block() {
    switch (choose_.weighted({70, 9, 6, 6, 4, 3, 2})) {
      case 0:
        return movement(Kind::any);
      case 1:
        return rotation_only();
      case 2:
        no_movement();
        if (choose_.chance(40)) rotation_only();
        return;
      case 3:
        offset_number();
        return choose_.chance(70) ? movement(Kind::any) : write_.end_block();
      case 4:
        if (tool_words_) return movement(Kind::any);
        write_.word(choose_.one_of({"G43 H1", "G44 H2", "G43 Z5. H1", "H2", "G49", "H0"}));
        return write_.end_block();
      case 5:
        write_.incremental(!write_.incremental());
        write_.word(write_.incremental() ? "G91" : "G90");
        return choose_.chance(70) ? movement(Kind::any) : write_.end_block();
      default:
        return forbidden();
    }
  }

  void offset_number() {
    write_.word(fmt::format("D{}", choose_.chance(94)
                                       ? choose_.between(1, static_cast<std::int64_t>(case_.setup.h.size()))
                                       : choose_.one_of<std::int64_t>({0, 399, 400, 401})));
  }

  // What the manual forbids here, or what ends the run.
  void forbidden() {
    write_.word(choose_.one_of({"G04 P100", "G02 X10. Y10. R10.", "G41.3 D1", "G54", "G92 X0", "G28 Z0", "M00", "M01",
                                "M30", "G53 Z0", "G10 L10 P1 R1.", "X1. M08", "T1", "G20", "G30 X0", "G40 X1."}));
    write_.end_block();
  }

  void no_movement() {
    switch (choose_.below(5)) {
      case 0:
        write_.number('F', choose_.between(1, 99) * write_.one());
        break;
      case 1:
        write_.axis(choose_.one_of({'X', 'Y', 'Z'}), 0);
        break;
      case 2:
        write_.word(choose_.one_of({"M08", "S500", "T2"}));
        break;
      case 3:
        write_.word(choose_.one_of({"G00", "G01", "G17", "G18"}));
        break;
      default:
        linear({0, 0, 0});
        break;
    }
    write_.end_block();
  }

  void rotation_only() {
    if (tool_words_) {
      direction();
    } else if (!rotary_.empty()) {
      rotate(false);
    } else {
      return no_movement();
    }
    write_.end_block();
  }

  // I J K: rational, any decimals, along an axis, or opposed to the last.
  void direction() {
    SpaceCounts d{};
    if (choose_.chance(60)) {
      d = choose_.one_of(kRational);
      d = of_any_sense(choose_, d);
      const std::int64_t factor = choose_.chance(50) ? write_.one() : choose_.one_of<std::int64_t>({1, 10, 100});
      for (std::int64_t& x : d) x *= factor;
    } else {
      const std::int64_t most = choose_.chance(60) ? write_.one() : 9'999 * write_.one();
      for (std::int64_t& x : d) x = choose_.between(-most, most);
    }
    if (d == SpaceCounts{}) d[2] = write_.one();
    words_of(d, 1);
  }

  void words_of(const SpaceCounts& d, std::int64_t factor) {
    tool_counts_ = d;
    tool_ = as_direction(d);
    for (std::size_t i = 0; i < 3; ++i)
      if (d[i] != 0 || choose_.chance(30)) write_.number("IJK"[i], d[i] * factor);
  }

  void rotate(bool all) {
    for (const char letter : rotary_) {
      if (!all && rotary_.size() > 1 && choose_.chance(40)) continue;
      const std::int64_t target = rotary_target(choose_, write_, letter, {35, 15, 0, 25, 25, 0});
      write_.axis(letter, target - write_.at(letter));
    }
  }

  [[nodiscard]] Direction tool() const {
    if (tool_words_) return tool_;
    return tool_direction(case_.setup, write_.pose()).value_or(Direction{0, 0, 1});
  }

  // A direction perpendicular to the tool, turned about it at random.
  Direction anywhere_beside(const Direction& tool) {
    return turned(beside(tool), tool, static_cast<double>(choose_.between(0, 359)));
  }

  double threshold() const {
    const auto range = case_.setup.parameter(19631);
    return range ? static_cast<double>(range->digits) * std::pow(10, -range->decimals) : 1.0;
  }

  static SpaceCounts rounded(const Direction& d, double length) {
    SpaceCounts c{};
    for (std::size_t i = 0; i < 3; ++i) c[i] = std::llround(d[i] * length);
    return c;
  }

  void movement(Kind kind) {
    if (kind == Kind::any) kind = static_cast<Kind>(1 + choose_.weighted({10, 14, 12, 8, 5, 3, 6, 4, 38}));
    if (kind == Kind::niven && !tool_words_) kind = Kind::threshold;
    if (kind == Kind::multiple && !tool_words_) kind = Kind::parallel;
    const bool turn = choose_.chance(20);
    if (turn && tool_words_ && kind != Kind::niven) direction();
    const double length = static_cast<double>(write_.one()) * static_cast<double>(choose_.between(1, 100));
    const SpaceCounts move = travel(kind, length);
    if (choose_.chance(8)) write_.word(choose_.one_of({"G00", "G01"}));
    linear(move);
    if (turn && !tool_words_ && !rotary_.empty() && tool_direction(case_.setup, {})) rotate(false);
    if (choose_.chance(6)) write_.number('F', choose_.between(1, 500) * write_.one());
    last_ = move;
    write_.end_block();
  }

  SpaceCounts travel(Kind kind, double length) {
    SpaceCounts move{};
    switch (kind) {
      case Kind::parallel:
        return rounded(tool(), choose_.chance(50) ? length : -length);
      case Kind::perpendicular:
        return rounded(anywhere_beside(tool()), length);
      case Kind::threshold:
        return at_threshold(length);
      case Kind::reversal:
        for (std::size_t i = 0; i < 3; ++i) move[i] = -last_[i];
        return move;
      case Kind::tiny:
        for (std::int64_t& x : move) x = choose_.between(-2, 2);
        return move;
      case Kind::huge:
        for (std::int64_t& x : move) x = choose_.between(-9'000 * write_.one(), 9'000 * write_.one());
        return move;
      case Kind::niven:
        return between_directions();
      case Kind::multiple: {  // exactly along the tool, in numbers whose products no double holds
        const auto factor = choose_.one_of<std::int64_t>({-3, -1, 1, 2, 7});
        for (std::size_t i = 0; i < 3; ++i) move[i] = tool_counts_[i] * factor;
        if (move == SpaceCounts{}) move[2] = write_.one();
        return move;
      }
      case Kind::any:
      case Kind::normal:
        break;
    }
    for (std::int64_t& x : move)
      x = choose_.chance(25)   ? 0
          : choose_.chance(60) ? choose_.between(-20, 20) * 5 * write_.one()
                               : choose_.between(-100 * write_.one(), 100 * write_.one());
    if (move == SpaceCounts{}) move[choose_.below(3)] = 10 * write_.one();
    return move;
  }

  SpaceCounts at_threshold(double length) {
    const Direction t = tool();
    const double base = choose_.one_of({0.0, 90.0, 180.0});
    const double angle = (base + (choose_.chance(50) ? threshold() : -threshold())) * kRadiansPerDegree;
    const Direction side = anywhere_beside(t);
    Direction d{};
    for (std::size_t i = 0; i < 3; ++i) d[i] = t[i] * std::cos(angle) + side[i] * std::sin(angle);
    SpaceCounts move = rounded(d, length);
    // One unit to either side of the threshold.
    if (choose_.chance(60)) move[choose_.below(3)] += choose_.one_of<std::int64_t>({-1, 1});
    return move;
  }

  // Writes the direction, too.
  SpaceCounts between_directions() {
    const Pair& pair = choose_.one_of(kNiven);
    words_of(pair.tool, write_.one());
    const std::int64_t unit = choose_.chance(50) ? write_.one() : 1;
    const std::int64_t factor = choose_.between(1, 30) * unit;
    SpaceCounts move{};
    for (std::size_t i = 0; i < 3; ++i) move[i] = pair.movement[i] * factor;
    return move;
  }

  void linear(const SpaceCounts& move) {
    for (std::size_t i = 0; i < 3; ++i)
      if (case_.setup.axes.has("XYZ"[i]) && (move[i] != 0 || choose_.chance(15))) write_.axis("XYZ"[i], move[i]);
  }

  Choices& choose_;
  spec::Case& case_;
  ProgramWriter write_;
  std::string rotary_;
  Direction tool_ = {0, 0, 1};
  SpaceCounts tool_counts_{};  // I J K as last written
  SpaceCounts last_{};
  bool tool_words_ = false;  // under G43.5
  bool compensated_once_ = false;
};

}  // namespace

spec::Case leading_edge_offset(Choices& choose, std::uint32_t blocks) {
  spec::Case c;
  c.setup = random_setup(choose, Kinematics::always);
  c.program = LeadingEdge(choose, c).program(blocks);
  return c;
}

}  // namespace toolcomp::fuzz

// SPDX-License-Identifier: Apache-2.0
// Modal groups G40 to G42 with G39, G41.2 and G42.2, and G45 to G48, as state machines: random sequences of blocks
// against plain abstract controls written here. Cutter compensation B moves along the axes, so that every vector is (0,
// ±d) or (±d, 0); C goes straight on along X, so that every vector is (0, ±d). Numbers are whole thousandths.
#include <fmt/format.h>
#include <rapidcheck/state.h>

#include <memory>
#include <vector>

#include "tests/property/support.h"

namespace toolcomp::laws {
namespace {

constexpr std::int64_t kD[] = {0, 10'000, -4'000, 2'500};  // D0 to D3

std::string number(std::int64_t thousandths) {
  const std::int64_t magnitude = thousandths < 0 ? -thousandths : thousandths;
  return fmt::format("{}{}.{:03}", thousandths < 0 ? "-" : "", magnitude / 1000, magnitude % 1000);
}

struct Point {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

struct Seen {
  Point programmed;
  Point point;
  spec::Cause cause = spec::Cause::programmed;
};

spec::Setup setup(spec::CutterCompensationType type) {
  spec::Setup s;
  s.cutter_compensation = type;
  for (std::uint32_t d = 1; d <= 3; ++d) s.d[d].geometry = *spec::parse_decimal(number(kD[d]));
  return s;
}

// The program must give exactly these moves, in the model and in the fast engine.
void check(const std::string& section, const spec::Setup& setup, const std::string& program,
           const std::vector<Seen>& expected) {
  spec::Case c;
  c.section = section;
  c.setup = setup;
  c.program = program;
  RC_LOG() << program;
  const auto run = model_run(c);
  RC_ASSERT(run.has_value());
  RC_ASSERT(run->events.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const model::Event& e = run->events[i];
    RC_LOG() << "event " << i << '\n';
    RC_ASSERT(e.kind == EventKind::move);
    RC_ASSERT(e.cause == expected[i].cause);
    RC_ASSERT(e.programmed[0] == Real(Rational(expected[i].programmed.x, 1000)));
    RC_ASSERT(e.programmed[1] == Real(Rational(expected[i].programmed.y, 1000)));
    RC_ASSERT(e.point[0] == Real(Rational(expected[i].point.x, 1000)));
    RC_ASSERT(e.point[1] == Real(Rational(expected[i].point.y, 1000)));
  }
  if (!expected.empty()) fast_agrees(c, *run);
}

// Cutter compensation B.

struct ControlB {
  bool on = false;
  bool left = true;
  std::size_t d = 1;
  Point at;
  Point vector;

  // The perpendicular of a direction along an axis, on the side and of the value in force.
  [[nodiscard]] Point normal(Point direction) const {
    const std::int64_t length = direction.x + direction.y;  // one of them is zero
    const std::int64_t value = (length < 0 ? -1 : 1) * (left ? kD[d] : -kD[d]);
    return direction.x != 0 ? Point{0, value} : Point{-value, 0};
  }
};
struct ProgramB {
  std::string text;
  std::vector<Seen> expected;
  void see(const ControlB& c, spec::Cause cause = spec::Cause::programmed) {
    expected.push_back({c.at, {c.at.x + c.vector.x, c.at.y + c.vector.y}, cause});
  }
};
using CommandB = rc::state::Command<ControlB, ProgramB>;

// A travel along X or Y that is not zero.
Point any_travel() {
  const bool along_x = *rc::gen::arbitrary<bool>();
  const bool back = *rc::gen::arbitrary<bool>();
  const std::int64_t length = *rc::gen::inRange<std::int64_t>(1, 50'001);
  const std::int64_t travel = back ? -length : length;
  return along_x ? Point{travel, 0} : Point{0, travel};
}
std::string words(Point p) { return p.x != 0 ? fmt::format("X{}", number(p.x)) : fmt::format("Y{}", number(p.y)); }

// A straight block, with or without a code and a number: G41, G42 and D count at its end.
struct MoveB final : CommandB {
  Point travel = any_travel();
  int code = *rc::gen::weightedElement<int>({{4, 0}, {2, 41}, {2, 42}});
  int d = *rc::gen::inRange(-2, 4);  // below 1: no D word
  void apply(ControlB& c) const override {
    c.at = {c.at.x + travel.x, c.at.y + travel.y};
    if (d > 0) c.d = static_cast<std::size_t>(d);
    if (code != 0) {
      c.on = true;
      c.left = code == 41;
    }
    if (c.on) c.vector = c.normal(travel);
  }
  void run(const ControlB& before, ProgramB& p) const override {
    ControlB after = before;
    apply(after);
    if (code != 0) p.text += fmt::format("G{} ", code);
    p.text += words(travel);
    if (d > 0) p.text += fmt::format(" D{}", d);
    p.text += '\n';
    p.see(after, after.on && !before.on ? spec::Cause::start_up : spec::Cause::programmed);
  }
  void show(std::ostream& os) const override { os << "G" << code << ' ' << words(travel) << " D" << d; }
};

struct CancelB final : CommandB {
  bool moves = *rc::gen::arbitrary<bool>();
  Point travel = any_travel();
  void apply(ControlB& c) const override {
    if (moves) c.at = {c.at.x + travel.x, c.at.y + travel.y};
    c.on = false;
    c.vector = {};
  }
  void run(const ControlB& before, ProgramB& p) const override {
    ControlB after = before;
    apply(after);
    p.text += moves ? fmt::format("G40 {}\n", words(travel)) : "G40\n";
    if (moves || before.on) p.see(after, before.on ? spec::Cause::cancel : spec::Cause::programmed);
  }
  void show(std::ostream& os) const override { os << "G40 " << (moves ? words(travel) : ""); }
};

// G39 turns the vector to the perpendicular of I or J; no event where it stands there already.
struct CornerB final : CommandB {
  Point direction = any_travel();
  void checkPreconditions(const ControlB& c) const override { RC_PRE(c.on); }
  void apply(ControlB& c) const override { c.vector = c.normal(direction); }
  void run(const ControlB& before, ProgramB& p) const override {
    ControlB after = before;
    apply(after);
    p.text += direction.x != 0 ? fmt::format("G39 I{}\n", number(direction.x))
                               : fmt::format("G39 J{}\n", number(direction.y));
    if (after.vector.x != before.vector.x || after.vector.y != before.vector.y) p.see(after, spec::Cause::corner);
  }
  void show(std::ostream& os) const override { os << "G39"; }
};

// A block that does not move in the plane keeps the vector.
struct OtherB final : CommandB {
  std::string word = *rc::gen::element<std::string>("Z1.", "M08", "S500", "G04 P10", "G17", "N7", "F200");
  void apply(ControlB&) const override {}
  void run(const ControlB& before, ProgramB& p) const override {
    p.text += word + '\n';
    if (word[0] == 'Z') p.see(before);
  }
  void show(std::ostream& os) const override { os << word; }
};

RC_GTEST_PROP(ModalGroups, CutterCompensationB, ()) {
  ProgramB program;
  const auto commands = *rc::state::gen::commands(
      ControlB(), rc::state::gen::execOneOfWithArgs<MoveB, MoveB, CancelB, CornerB, OtherB>());
  rc::state::runAll(commands, ControlB(), program);
  check("fanuc/cutter-compensation-b", setup(spec::CutterCompensationType::b), "G91 G01 F100 D1\n" + program.text,
        program.expected);
}

// Cutter compensation C, straight on along X. What a block's end gets depends on the block after it, so that the
// sequence is kept and read at its end.

struct BlockC {
  int code = 0;             // 0, 40, 41, 42
  int d = -1;               // -1: no D word
  std::int64_t travel = 0;  // along X; 0: a Z block
};
struct ControlC {
  bool wanted = false;
  bool left = true;
  std::size_t d = 1;
  int since_start = 0;  // moving blocks since the start-up
  bool idle = true;     // the last block did not move in the plane
  [[nodiscard]] std::int64_t rho() const { return left ? kD[d] : -kD[d]; }
};
using ProgramC = std::vector<BlockC>;
using CommandC = rc::state::Command<ControlC, ProgramC>;

struct MoveC final : CommandC {
  BlockC block{*rc::gen::weightedElement<int>({{5, 0}, {2, 41}, {2, 42}, {2, 40}}), *rc::gen::inRange(-2, 4),
               *rc::gen::inRange<std::int64_t>(1, 50'001)};
  static std::int64_t sign(std::int64_t v) { return v < 0 ? -1 : 1; }
  void checkPreconditions(const ControlC& c) const override {
    RC_PRE(block.d != 0);
    // The side may not change in the block after the start-up.
    ControlC after = c;
    apply(after);
    if (c.wanted && after.wanted && c.since_start < 2) RC_PRE(sign(c.rho()) == sign(after.rho()));
  }
  void apply(ControlC& c) const override {
    const bool before = c.wanted;
    if (block.d > 0) c.d = static_cast<std::size_t>(block.d);
    if (block.code == 40) c.wanted = false;
    if (block.code > 40) {
      c.wanted = true;
      c.left = block.code == 41;
    }
    c.since_start = c.wanted ? (before ? c.since_start + 1 : 1) : 0;
    c.idle = false;
  }
  void run(const ControlC&, ProgramC& p) const override { p.push_back(block); }
  void show(std::ostream& os) const override { os << "G" << block.code << " X" << block.travel << " D" << block.d; }
};

// One block between that does not move in the plane changes nothing.
struct IdleC final : CommandC {
  void checkPreconditions(const ControlC& c) const override { RC_PRE(!c.idle); }
  void apply(ControlC& c) const override { c.idle = true; }
  void run(const ControlC&, ProgramC& p) const override { p.push_back({}); }
  void show(std::ostream& os) const override { os << "Z1."; }
};

// `suffix` of G41 and G42: the side of a tool along Z follows the same rules here.
void straight_on(const std::string& section, const std::string& suffix) {
  ProgramC blocks;
  const auto commands = *rc::state::gen::commands(ControlC(), rc::state::gen::execOneOfWithArgs<MoveC, MoveC, IdleC>());
  rc::state::runAll(commands, ControlC(), blocks);

  std::string text = "G91 G01 F100 D1\n";
  std::vector<Seen> expected;
  ControlC control;
  std::int64_t x = 0;
  std::int64_t y = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const BlockC& b = blocks[i];
    if (b.travel == 0) {
      text += "Z1.\n";
      expected.push_back({{x, 0}, {x, y}});
      continue;
    }
    if (b.code != 0) text += fmt::format("G{}{} ", b.code, b.code > 40 ? suffix : "");
    text += fmt::format("X{}{}\n", number(b.travel), b.d > 0 ? fmt::format(" D{}", b.d) : "");
    const ControlC before = control;
    const auto step = [](ControlC& c, const BlockC& block) {
      if (block.d > 0) c.d = static_cast<std::size_t>(block.d);
      if (block.code == 40) c.wanted = false;
      if (block.code > 40) {
        c.wanted = true;
        c.left = block.code == 41;
      }
    };
    step(control, b);
    x += b.travel;
    // The next block that moves: where it wants the other side, the perpendicular of that side.
    ControlC next = control;
    std::size_t j = i + 1;
    while (j < blocks.size() && blocks[j].travel == 0) ++j;
    if (j < blocks.size()) step(next, blocks[j]);
    const bool turns = next.wanted && MoveC::sign(next.rho()) != MoveC::sign(control.rho());
    y = !control.wanted ? 0 : turns ? -control.rho() : control.rho();
    expected.push_back({{x, 0},
                        {x, y},
                        control.wanted && !before.wanted   ? spec::Cause::start_up
                        : !control.wanted && before.wanted ? spec::Cause::cancel
                                                           : spec::Cause::programmed});
  }
  check(section, setup(spec::CutterCompensationType::c), text, expected);
}

RC_GTEST_PROP(ModalGroups, CutterCompensationCStraightOn, ()) { straight_on("fanuc/cutter-compensation-c", ""); }
RC_GTEST_PROP(ModalGroups, ToolSideStraightOn, ()) { straight_on("fanuc/tool-side-compensation", ".2"); }

// G45 to G48 along X: the shift between the programmed and the actual position persists.

struct ControlT {
  bool incremental = false;
  std::size_t d = 1;
  std::int64_t programmed = 0;
  std::int64_t actual = 0;
};
struct ProgramT {
  std::string text;
  std::vector<Seen> expected;
};
using CommandT = rc::state::Command<ControlT, ProgramT>;

struct MoveT final : CommandT {
  int code = *rc::gen::weightedElement<int>({{2, 0}, {1, 45}, {1, 46}, {1, 47}, {1, 48}});
  int d = *rc::gen::inRange(-3, 4);  // below 0: no D word
  std::int64_t value = *rc::gen::weightedOneOf<std::int64_t>(
      {{1, rc::gen::just<std::int64_t>(0)}, {5, rc::gen::inRange<std::int64_t>(-50'000, 50'001)}});
  bool minus_zero = *rc::gen::arbitrary<bool>();
  void apply(ControlT& c) const override {
    if (d >= 0) c.d = static_cast<std::size_t>(d);
    const std::int64_t travel = c.incremental ? value : value - c.programmed;
    c.programmed += travel;
    if (code == 0) {
      // An ordinary block carries the shift along.
      c.actual += travel;
      return;
    }
    if (travel == 0 && !c.incremental) return;
    const bool negative = travel < 0 || (travel == 0 && minus_zero);
    const std::int64_t times = code == 45 ? 1 : code == 46 ? -1 : code == 47 ? 2 : -2;
    c.actual += travel + (negative ? -1 : 1) * times * kD[c.d];
  }
  void run(const ControlT& before, ProgramT& p) const override {
    ControlT after = before;
    apply(after);
    if (code != 0) p.text += fmt::format("G{} ", code);
    p.text += value == 0 && minus_zero ? "X-0" : "X" + number(value);
    p.text += d >= 0 ? fmt::format(" D{}\n", d) : "\n";
    p.expected.push_back({{after.programmed, 0}, {after.actual, 0}});
  }
  void show(std::ostream& os) const override { os << "G" << code << " X" << value << " D" << d; }
};
struct DistanceT final : CommandT {
  bool incremental = *rc::gen::arbitrary<bool>();
  void apply(ControlT& c) const override { c.incremental = incremental; }
  void run(const ControlT&, ProgramT& p) const override { p.text += incremental ? "G91\n" : "G90\n"; }
  void show(std::ostream& os) const override { os << (incremental ? "G91" : "G90"); }
};

RC_GTEST_PROP(ModalGroups, ToolOffset, ()) {
  ProgramT program;
  const auto commands =
      *rc::state::gen::commands(ControlT(), rc::state::gen::execOneOfWithArgs<MoveT, MoveT, DistanceT>());
  rc::state::runAll(commands, ControlT(), program);
  check("fanuc/tool-offset", setup(spec::CutterCompensationType::c), "G90 G01 F100 D1\n" + program.text,
        program.expected);
}

}  // namespace
}  // namespace toolcomp::laws

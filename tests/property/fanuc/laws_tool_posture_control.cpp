// SPDX-License-Identifier: Apache-2.0
// Laws of tool center point control and tool posture control.
#include "spec/language/setup_format.h"
#include "tests/property/fanuc/tool_paths.h"

namespace toolcomp::laws {
namespace {

constexpr std::size_t kB = 3;
constexpr std::size_t kC = 4;

// B tilts the tool and C is the work-side axis, on a head, a table, and one on each; axes X Y Z B C.
const std::string kHead = "19680 = 2\n19681 = 5\n19682 = 3\n19686 = 4\n19687 = 2\n";
const std::string kTable = "19680 = 12\n19681 = 4\n19682 = 2\n19684 = 1\n19686 = 5\n19687 = 3\n19689 = 1\n";
const std::string kMixed = "19680 = 21\n19681 = 4\n19682 = 2\n19686 = 5\n19687 = 3\n19689 = 1\n";
// The axis of B inclined by 45 degrees.
const std::string kNutating = "19680 = 2\n19681 = 5\n19682 = 3\n19686 = 4\n19687 = 5\n19688 = 45\n";

spec::Case make(const std::string& parameters, std::uint32_t samples = 3) {
  spec::Case c;
  c.section = "fanuc/tool-posture-control";
  c.setup = spec::read_setup_toml("control = \"fanuc\"\naxes = [\"X\", \"Y\", \"Z\", \"B\", \"C\"]\n[parameters]\n" +
                                      parameters + "[offsets.H]\n1 = 50\n[workpiece.G54]\nX = 30\nY = -20\n",
                                  "setup");
  c.samples = samples;
  return c;
}

// Directions over the plane of X and Y and beside Z: no two of them are opposite, none is singular on these machines,
// and a nutating one reaches them.
Vector direction() {
  Vector v{};
  do {
    v = *not_zero();
    v[2] = std::abs(v[2]);
  } while (v[0] == 0 || v[2] == 0);
  return v;
}

struct Posture {
  Vector tip{};
  Vector tool{};
};

std::vector<Posture> path(std::size_t least = 1) {
  std::vector<Posture> blocks(*rc::gen::inRange<std::size_t>(least, 5));
  for (Posture& block : blocks) {
    block.tip = *not_zero();
    block.tool = direction();
  }
  return blocks;
}

// From a pose, with I J K in every block.
std::string program(const std::vector<Posture>& blocks, int b, int c, const std::string& posture = "P1") {
  std::string text = fmt::format("B{} C{}\nG43.5 H1 {}\nG01 F1000\n", b, c, posture);
  for (const Posture& block : blocks) text += words("XYZ", block.tip).substr(1) + words("IJK", block.tool) + '\n';
  return text;
}

std::vector<const model::Event*> of_line(const judge::ModelRun& run, std::uint64_t line) {
  std::vector<const model::Event*> events;
  for (const model::Event& e : run.events)
    if (e.line == line && (e.kind == EventKind::move || e.kind == EventKind::sample)) events.push_back(&e);
  return events;
}

using Axis = std::array<Real, 3>;
Real dot(const Axis& a, const Axis& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
bool same_direction(const Axis& a, const Axis& b) {
  return equal(a[0], b[0]) && equal(a[1], b[1]) && equal(a[2], b[2]);
}

// The same positions of B and C with every type of machine: the tool goes the same way relative to the work.
void twins(const std::string& text) {
  const auto head = model_run([&] {
    spec::Case c = make(kHead);
    c.program = text;
    return c;
  }());
  for (const std::string& parameters : {kTable, kMixed}) {
    spec::Case c = make(parameters);
    c.program = text;
    const auto other = model_run(c);
    RC_LOG() << fuzz::encode(c);
    RC_ASSERT(head->events.size() == other->events.size());
    for (std::size_t i = 0; i < head->events.size(); ++i) {
      const model::Event& e = head->events[i];
      const model::Event& f = other->events[i];
      RC_ASSERT(e.kind == f.kind);
      RC_ASSERT(e.number == f.number);
      if (!e.tool_axis || e.line < 3) continue;
      RC_ASSERT(same(e.point, f.point));
      RC_ASSERT(same_direction(*e.tool_axis, *f.tool_axis));
      RC_ASSERT(equal(e.axes[kB], f.axes[kB]));
      RC_ASSERT(equal(e.axes[kC], f.axes[kC]));
    }
    fast_agrees(c, *other);
  }
}

RC_GTEST_PROP(LawsOfPosture, HeadAndTableGoTheSameWayByDirections, ()) {
  std::vector<Posture> blocks = path();
  blocks.insert(blocks.begin(), Posture{{1000, 0, 0}, {1000, 0, 2000}});  // a pair that every order of judgement takes
  twins(program(blocks, 0, 0));
}

RC_GTEST_PROP(LawsOfPosture, HeadAndTableGoTheSameWayByPositions, ()) {
  std::string text = fmt::format("X0\nG43.4 H1 P{}\nG01 F1000\n", *rc::gen::inRange(0, 2));
  const std::size_t blocks = *rc::gen::inRange<std::size_t>(1, 5);
  for (std::size_t i = 0; i < blocks; ++i) {
    const Vector tip = *not_zero();
    const int b = *rc::gen::inRange(-120, 121);
    const int c = *rc::gen::inRange(-400, 401);
    text += fmt::format("{} B{} C{}\n", words("XYZ", tip).substr(1), b, c);
  }
  twins(text);
}

// Whole turns of the position at the start are those of every position.
RC_GTEST_PROP(LawsOfPosture, WholeTurnsOnlyWind, ()) {
  const std::string machine = *rc::gen::element(kHead, kTable, kMixed, kNutating);
  const std::string posture = *rc::gen::element<std::string>("P0", "P1");
  const std::vector<Posture> blocks = path();
  const int b = *rc::gen::inRange(-80, 81);
  const int c = *rc::gen::inRange(-180, 181);
  const int turns_b = *rc::gen::inRange(-3, 4);
  const int turns_c = *rc::gen::inRange(-3, 4);
  spec::Case plain = make(machine);
  spec::Case wound = make(machine);
  plain.program = program(blocks, b, c, posture);
  wound.program = program(blocks, b + 360 * turns_b, c + 360 * turns_c, posture);
  mapped(plain, wound, [&](const spec::Axes&, const Table& t) {
    Table result = t;
    if (t.has(kB)) result.set(kB, t[kB] + 360 * turns_b);
    if (t.has(kC)) result.set(kC, t[kC] + 360 * turns_c);
    return result;
  });
}

// On orthogonal axes the pose (-B, C + 180) is the same posture, and stays so.
RC_GTEST_PROP(LawsOfPosture, TheOtherPairGoesTheSameWay, ()) {
  const std::vector<Posture> blocks = path();
  const int b = *rc::gen::inRange(1, 90);
  const int c = *rc::gen::inRange(-180, 181);
  const std::string near = fmt::format("19738 = {}\n19739 = {}\n", *rc::gen::inRange(0, 90), *rc::gen::inRange(0, 180));
  spec::Case one = make(kHead + near);
  spec::Case other = make(kHead + near);
  one.program = program(blocks, b, c);
  other.program = program(blocks, -b, c + 180);
  mapped(one, other, [](const spec::Axes&, const Table& t) {
    Table result = t;
    if (t.has(kB)) result.set(kB, -t[kB]);
    if (t.has(kC)) result.set(kC, t[kC] + 180);
    return result;
  });
}

// Work and program turned about the work-side axis by a quarter turn.
RC_GTEST_PROP(LawsOfPosture, TurningTheWorkTurnsTheWorkSideAxis, ()) {
  const std::string machine = *rc::gen::element(kHead, kNutating);
  const std::vector<Posture> blocks = path();
  const int b = *rc::gen::inRange(1, 90);
  const int c = *rc::gen::inRange(-180, 181);
  std::vector<Posture> turned = blocks;
  const auto turn = [](const Vector& v) { return Vector{-v[1], v[0], v[2]}; };
  for (Posture& block : turned) block = {turn(block.tip), turn(block.tool)};
  spec::Case one = make(machine);
  spec::Case other = make(machine);
  other.setup.workpiece = one.setup.workpiece = {};
  one.program = program(blocks, b, c);
  other.program = program(turned, b, c + 90);
  mapped(one, other, [](const spec::Axes&, const Table& t) {
    Table result = t;
    if (t.has(0)) result.set(0, -t[1]);
    if (t.has(1)) result.set(1, t[0]);
    if (t.has(kC)) result.set(kC, t[kC] + 90);
    return result;
  });
}

// Back along the same block everything comes in the opposite order.
RC_GTEST_PROP(LawsOfPosture, TheWayBackIsTheSameWay, ()) {
  const std::string machine = *rc::gen::element(kHead, kTable, kMixed, kNutating);
  std::vector<Posture> blocks = path(2);
  blocks.resize(2);
  blocks.push_back(blocks[0]);
  spec::Case c = make(machine, 6);
  c.program = program(blocks, 20, 10);
  const auto run = model_run(c);
  RC_LOG() << fuzz::encode(c);
  const auto there = of_line(*run, 5);
  const auto back = of_line(*run, 6);
  RC_PRE(there.size() == 6U && back.size() == 6U);  // in reach all the way
  for (std::size_t i = 0; i < 5; ++i) {
    RC_ASSERT(same(there[i]->point, back[4 - i]->point));
    RC_ASSERT(same(there[i]->axes, back[4 - i]->axes));
    RC_ASSERT(same_direction(*there[i]->tool_axis, *back[4 - i]->tool_axis));
  }
}

// Under posture control the tool stays in the plane of its ends and turns at a constant rate.
RC_GTEST_PROP(LawsOfPosture, TheToolTurnsEvenlyInThePlaneOfItsEnds, ()) {
  const std::string machine = *rc::gen::element(kHead, kTable, kMixed, kNutating);
  std::vector<Posture> blocks = path(2);
  blocks.resize(2);
  spec::Case c = make(machine, 5);
  c.program = program(blocks, 20, 10);
  const auto run = model_run(c);
  RC_LOG() << fuzz::encode(c);
  const auto start = of_line(*run, 4);
  const auto events = of_line(*run, 5);
  RC_PRE(!start.empty() && events.size() == 5U);
  std::vector<Axis> tools{*start.back()->tool_axis};
  for (const model::Event* e : events) tools.push_back(*e->tool_axis);
  const Axis& a = tools.front();
  const Axis& b = tools.back();
  const Axis normal{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  const Real step = dot(tools[0], tools[1]);
  for (std::size_t i = 0; i < tools.size(); ++i) {
    RC_ASSERT(equal(dot(tools[i], tools[i]), Real(1)));
    RC_ASSERT(equal(dot(tools[i], normal), Real(0)));
    if (i != 0) RC_ASSERT(equal(dot(tools[i - 1], tools[i]), step));
  }
  fast_agrees(c, *run);
}

// An end that is changed is changed within wider limits too; without 19738 none is.
RC_GTEST_PROP(LawsOfPosture, WiderLimitsChangeMore, ()) {
  const std::string machine = *rc::gen::element(kHead, kTable, kNutating);
  const std::vector<Posture> blocks{{*not_zero(), direction()}};
  const int b = *rc::gen::inRange(1, 60);
  const int near = *rc::gen::inRange(1, 60);
  const int veto = *rc::gen::inRange(0, 180);
  const int wider_near = near + *rc::gen::inRange(0, 30);
  const int wider_veto = veto + *rc::gen::inRange(0, 30);
  const auto end = [&](int limit, int limit_of_veto) {
    spec::Case c = make(machine + fmt::format("19738 = {}\n19739 = {}\n", limit, limit_of_veto), 0);
    c.program = program(blocks, b, 0);
    const auto run = model_run(c);
    RC_LOG() << fuzz::encode(c);
    fast_agrees(c, *run);
    const auto events = of_line(*run, 4);
    return events.empty() ? std::optional<Axis>() : events.back()->tool_axis;
  };
  const auto unchanged = end(0, 180);
  RC_PRE(unchanged.has_value());
  const auto narrow = end(near, veto);
  const auto wide = end(wider_near, wider_veto);
  const bool changed = !same_direction(*unchanged, *narrow);
  RC_CLASSIFY(changed);
  if (changed) RC_ASSERT(same_direction(*narrow, *wide));
}

// On orthogonal axes a standing work-side axis makes posture control and conventional control the same.
RC_GTEST_PROP(LawsOfPosture, WithAStandingWorkSideAxisBothControlsAgree, ()) {
  const std::string machine = *rc::gen::element(kHead, kTable, kMixed);
  std::string text;
  const std::size_t blocks = *rc::gen::inRange<std::size_t>(1, 5);
  for (std::size_t i = 0; i < blocks; ++i) {
    const Vector tip = *not_zero();
    text += fmt::format("{} B{}\n", words("XYZ", tip).substr(1), *rc::gen::inRange(-89, 90));
  }
  spec::Case posture = make(machine);
  spec::Case conventional = make(machine);
  const int c = *rc::gen::inRange(-180, 181);
  posture.program = fmt::format("B10 C{}\nG43.4 H1 P1\nG01 F1000\n", c) + text;
  conventional.program = fmt::format("B10 C{}\nG43.4 H1 P0\nG01 F1000\n", c) + text;
  mapped(posture, conventional, identity);
}

}  // namespace
}  // namespace toolcomp::laws

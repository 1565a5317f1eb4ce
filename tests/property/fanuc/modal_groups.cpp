// SPDX-License-Identifier: Apache-2.0
// Modal groups as a state machine: random sequences of blocks against a plain abstract control written here. The
// control knows G90 G91, G00 G01, G43 G44 G49 with H in a type A memory, and whether G41.3 is on; numbers are whole
// thousandths.
#include <fmt/format.h>
#include <rapidcheck/state.h>

#include <memory>
#include <vector>

#include "tests/property/support.h"

namespace toolcomp::laws {
namespace {

constexpr std::int64_t kH[] = {0, 20'000, -7'500};  // H0, H1, H2

// What a block does to the programmed point and the offset, and the events it must yield.
struct Control {
  bool incremental = false;
  bool linear = false;
  int length = 49;
  int h = 0;
  std::int64_t offset = 0;
  bool edge = false;
  std::int64_t x = 0;
  std::int64_t z = 0;

  [[nodiscard]] std::int64_t wanted() const { return length == 49 ? 0 : length == 43 ? kH[h] : -kH[h]; }
};

struct Seen {
  std::int64_t x = 0;
  std::int64_t z = 0;
  std::int64_t offset = 0;
  bool rapid = false;
};

// The program so far, run as a whole at the end.
struct Program {
  std::string text;
  std::vector<Seen> expected;
};

std::string number(std::int64_t thousandths) {
  const std::int64_t magnitude = thousandths < 0 ? -thousandths : thousandths;
  return fmt::format("{}{}.{:03}", thousandths < 0 ? "-" : "", magnitude / 1000, magnitude % 1000);
}

using Command = rc::state::Command<Control, Program>;

// A block: words, and what the abstract control makes of them.
class Block : public Command {
 public:
  void apply(Control& control) const override { step(control); }

  void run(const Control& before, Program& program) const override {
    Control after = before;
    step(after);
    program.text += text(before) + '\n';
    const bool moves = has_axis() || after.offset != before.offset;
    if (moves) program.expected.push_back({after.x, after.z, after.offset, !after.linear});
  }

  void show(std::ostream& os) const override { os << text(Control()); }

 protected:
  virtual void step(Control& control) const = 0;
  [[nodiscard]] virtual std::string text(const Control& control) const = 0;
  [[nodiscard]] virtual bool has_axis() const { return false; }
};

struct Distance final : Block {
  bool incremental = *rc::gen::arbitrary<bool>();
  void step(Control& c) const override { c.incremental = incremental; }
  [[nodiscard]] std::string text(const Control&) const override { return incremental ? "G91" : "G90"; }
};

struct Interpolation final : Block {
  bool linear = *rc::gen::arbitrary<bool>();
  void step(Control& c) const override { c.linear = linear; }
  [[nodiscard]] std::string text(const Control&) const override { return linear ? "G01 F100" : "G00"; }
};

struct Move final : Block {
  bool along_z = *rc::gen::arbitrary<bool>();
  std::int64_t value = *rc::gen::inRange<std::int64_t>(-50'000, 50'001);
  void step(Control& c) const override {
    std::int64_t& at = along_z ? c.z : c.x;
    at = c.incremental ? at + value : value;
  }
  [[nodiscard]] std::string text(const Control&) const override {
    return fmt::format("{}{}", along_z ? 'Z' : 'X', number(value));
  }
  [[nodiscard]] bool has_axis() const override { return true; }
};

// G43, G44 with or without H and Z; a number stays in force (5001#2 = 0).
struct Length final : Block {
  int code = *rc::gen::element(43, 44);
  int h = *rc::gen::inRange(-1, 3);  // -1: no H word
  bool move = *rc::gen::arbitrary<bool>();
  std::int64_t value = *rc::gen::inRange<std::int64_t>(-50'000, 50'001);
  void step(Control& c) const override {
    c.length = code;
    if (h >= 0) c.h = h;
    c.offset = c.wanted();
    if (move) c.z = c.incremental ? c.z + value : value;
  }
  [[nodiscard]] std::string text(const Control&) const override {
    return fmt::format("G{}{}{}", code, h >= 0 ? fmt::format(" H{}", h) : "", move ? " Z" + number(value) : "");
  }
  [[nodiscard]] bool has_axis() const override { return move; }
};

struct LoneNumber final : Block {
  int h = *rc::gen::inRange(0, 3);
  void step(Control& c) const override {
    c.h = h;
    c.offset = c.wanted();
  }
  [[nodiscard]] std::string text(const Control&) const override { return fmt::format("H{}", h); }
};

struct Cancel final : Block {
  bool move = *rc::gen::arbitrary<bool>();
  void step(Control& c) const override {
    c.length = 49;
    c.offset = 0;
    if (move) c.x = c.incremental ? c.x + 1000 : 1000;
  }
  [[nodiscard]] std::string text(const Control&) const override { return move ? "G49 X1." : "G49"; }
  [[nodiscard]] bool has_axis() const override { return move; }
};

// Words of other groups in a block, or none at all, leave these groups as they are.
struct Other final : Block {
  std::string word =
      *rc::gen::element<std::string>("G17", "G94", "G40", "G54", "M08", "S500", "(NOTHING)", "N7", "D1", "F200");
  void step(Control&) const override {}
  [[nodiscard]] std::string text(const Control&) const override { return word; }
};

// The program must give exactly the events the abstract control expects, in the model and in the fast engine.
void check(const Program& program, const spec::Setup& setup) {
  spec::Case c;
  c.section = "fanuc/tool-length-offset";
  c.setup = setup;
  c.program = program.text;
  RC_LOG() << program.text;
  const auto run = model_run(c);
  RC_ASSERT(run.has_value());
  RC_ASSERT(run->events.size() == program.expected.size());
  for (std::size_t i = 0; i < program.expected.size(); ++i) {
    const model::Event& e = run->events[i];
    const Seen& seen = program.expected[i];
    RC_ASSERT(e.kind == EventKind::move);
    RC_ASSERT((e.type == spec::MoveType::rapid) == seen.rapid);
    RC_ASSERT(e.programmed[0] == Real(Rational(seen.x, 1000)));
    RC_ASSERT(e.programmed[2] == Real(Rational(seen.z, 1000)));
    RC_ASSERT(e.axes[0] == Real(Rational(seen.x, 1000)));
    RC_ASSERT(e.axes[2] == Real(Rational(seen.z + seen.offset, 1000)));
  }
  if (!program.expected.empty()) fast_agrees(c, *run);
}

spec::Setup setup() {
  spec::Setup s;
  for (std::uint32_t h = 1; h <= 2; ++h) s.h[h].geometry = *spec::parse_decimal(number(kH[h]));
  return s;
}

RC_GTEST_PROP(ModalGroups, LengthOffsetDistanceAndInterpolation, ()) {
  Program program;
  const auto commands = *rc::state::gen::commands(
      Control(), rc::state::gen::execOneOfWithArgs<Distance, Interpolation, Move, Length, LoneNumber, Cancel, Other>());
  rc::state::runAll(commands, Control(), program);
  check(program, setup());
}

// The leading edge along X with the tool leaning over it: every vector is one of two, by the sign of the movement's
// lean, which is the same for both ways; G40 and D0 remove it. The tool is (3,0,4)/5 under G43.5: VC = R·(-4/5, 0,
// 3/5).
struct EdgeControl {
  bool on = false;
  std::int64_t d = 1;
};
struct EdgeProgram {
  std::string text;
  std::vector<std::int64_t> radius;  // expected at each event; thousandths
};
using EdgeCommand = rc::state::Command<EdgeControl, EdgeProgram>;
constexpr std::int64_t kD[] = {0, 10'000, -5'000};

struct EdgeOn final : EdgeCommand {
  std::int64_t d = *rc::gen::inRange<std::int64_t>(1, 3);
  void checkPreconditions(const EdgeControl& c) const override { RC_PRE(!c.on); }
  void apply(EdgeControl& c) const override { c = {true, d}; }
  void run(const EdgeControl&, EdgeProgram& p) const override {
    // A movement must follow at once; it belongs to this command.
    p.text += fmt::format("G41.3 D{}\nX10.\n", d);
    p.radius.insert(p.radius.end(), {kD[d], kD[d]});
  }
  void show(std::ostream& os) const override { os << "G41.3 D" << d; }
};
struct EdgeOff final : EdgeCommand {
  bool by_number = *rc::gen::arbitrary<bool>();
  void checkPreconditions(const EdgeControl& c) const override { RC_PRE(c.on); }
  void apply(EdgeControl& c) const override { c.on = false; }
  void run(const EdgeControl&, EdgeProgram& p) const override {
    p.text += by_number ? "D0\n" : "G40\n";
    p.radius.push_back(0);
  }
  void show(std::ostream& os) const override { os << (by_number ? "D0" : "G40"); }
};
struct EdgeMove final : EdgeCommand {
  bool back = *rc::gen::arbitrary<bool>();
  void apply(EdgeControl&) const override {}
  void run(const EdgeControl& c, EdgeProgram& p) const override {
    p.text += back ? "X-25.\n" : "X15.\n";
    p.radius.push_back(c.on ? kD[c.d] : 0);
  }
  void show(std::ostream& os) const override { os << "X"; }
};
struct EdgeNumber final : EdgeCommand {
  std::int64_t d = *rc::gen::inRange<std::int64_t>(1, 3);
  void checkPreconditions(const EdgeControl& c) const override { RC_PRE(c.on); }
  void apply(EdgeControl& c) const override { c.d = d; }
  void run(const EdgeControl&, EdgeProgram& p) const override {
    // In force from the end of its own block.
    p.text += fmt::format("X5. D{}\n", d);
    p.radius.push_back(kD[d]);
  }
  void show(std::ostream& os) const override { os << "D" << d; }
};

RC_GTEST_PROP(ModalGroups, LeadingEdgeOnOffAndNumbers, ()) {
  EdgeProgram program;
  const auto commands = *rc::state::gen::commands(
      EdgeControl(), rc::state::gen::execOneOfWithArgs<EdgeOn, EdgeOff, EdgeMove, EdgeNumber>());
  rc::state::runAll(commands, EdgeControl(), program);

  // The last block has no next movement and keeps the vector before it.
  program.text += "X1.\n";
  program.radius.push_back(program.radius.empty() ? 0 : program.radius.back());

  spec::Case c;
  c.section = "fanuc/leading-edge-offset";
  for (std::uint32_t d = 1; d <= 2; ++d) c.setup.d[d].geometry = *spec::parse_decimal(number(kD[d]));
  c.program = "G91 G01 F100 G43.5 H0 I3. K4.\n" + program.text;
  RC_LOG() << c.program;
  const auto run = model_run(c);
  RC_ASSERT(run.has_value());
  RC_ASSERT(run->events.size() == program.radius.size() + 1);
  for (std::size_t i = 0; i < program.radius.size(); ++i) {
    const model::Event& e = run->events[i + 1];
    RC_ASSERT(e.kind == EventKind::move);
    RC_ASSERT(e.point[0] - e.programmed[0] == Real(Rational(-4 * program.radius[i], 5000)));
    RC_ASSERT(e.point[1] == e.programmed[1]);
    RC_ASSERT(e.point[2] - e.programmed[2] == Real(Rational(3 * program.radius[i], 5000)));
  }
  fast_agrees(c, *run);
}

}  // namespace
}  // namespace toolcomp::laws

// SPDX-License-Identifier: Apache-2.0
// Laws of automatic tool length measurement (14.2): where the two moves end and what is written, from positions in
// whole thousandths; approach from either side; what later moves do.
#include <fmt/format.h>

#include "tests/property/support.h"

namespace toolcomp::laws {
namespace {

std::string number(std::int64_t thousandths) {
  const std::int64_t magnitude = thousandths < 0 ? -thousandths : thousandths;
  return fmt::format("{}{}.{:03}", thousandths < 0 ? "-" : "", magnitude / 1000, magnitude % 1000);
}

Real thousandths(std::int64_t n) { return Rational(n, 1000); }

struct Measurement {
  std::int64_t start = 0;
  std::int64_t commanded = 0;
  std::int64_t deceleration = 0;  // 6251
  std::int64_t range = 0;         // 6254
  std::int64_t touch = 0;
  std::int64_t offset = 0;  // H1 before

  [[nodiscard]] std::int64_t sense() const { return commanded > start ? 1 : -1; }
  // Positions along the motion, from the start.
  [[nodiscard]] std::int64_t along(std::int64_t position) const { return sense() * (position - start); }
  [[nodiscard]] std::int64_t slow() const {
    return along(commanded) > deceleration ? commanded - sense() * deceleration : start;
  }
  // Where the signal stops the tool: the slow part's start if it is on there already, its end if it never comes.
  [[nodiscard]] std::int64_t reached() const {
    const std::int64_t end = commanded + sense() * range;
    const std::int64_t p = along(touch) < along(slow()) ? slow() : touch;
    return along(p) > along(end) ? end : p;
  }
  [[nodiscard]] bool measured() const {
    const std::int64_t off = sense() * (touch - commanded);
    const std::int64_t from_slow = sense() * (slow() - commanded);
    return std::max(off, from_slow) >= -range && off <= range;
  }
};

Measurement any_measurement() {
  Measurement m;
  m.range = *rc::gen::inRange<std::int64_t>(0, 8'000);
  m.deceleration = m.range + *rc::gen::inRange<std::int64_t>(1, 20'000);
  m.commanded = *rc::gen::inRange<std::int64_t>(-100'000, 100'001);
  const std::int64_t way =
      *rc::gen::suchThat(rc::gen::inRange<std::int64_t>(-90'000, 90'001), [](std::int64_t w) { return w != 0; });
  m.start = m.commanded + way;
  // About the permitted range, its ends among them.
  m.touch = m.commanded + *rc::gen::oneOf(rc::gen::inRange<std::int64_t>(-12'000, 12'001), rc::gen::just(m.range),
                                          rc::gen::just(-m.range));
  m.offset = *rc::gen::inRange<std::int64_t>(-50'000, 50'001);
  return m;
}

spec::Case make(const Measurement& m) {
  spec::Case c;
  c.section = "fanuc/tool-length-measurement";
  const auto value = [](std::int64_t n) { return *spec::parse_decimal(number(n)); };
  c.setup.parameters[{6241, -1}] = spec::decimal(1000);
  c.setup.parameters[{6251, -1}] = value(m.deceleration);
  c.setup.parameters[{6254, -1}] = value(m.range);
  c.setup.position['Z'] = value(m.start);
  c.setup.measurement['Z'] = value(m.touch);
  c.setup.h[1].geometry = value(m.offset);
  c.program = fmt::format("H01\nG37 Z{}\n", number(m.commanded));
  return c;
}

RC_GTEST_PROP(LawsOfMeasurement, MovesAndValueFollowFromThePositions, ()) {
  const Measurement m = any_measurement();
  const spec::Case c = make(m);
  const auto run = model_run(c);
  RC_LOG() << fuzz::encode(c);
  RC_ASSERT(run.has_value());
  std::size_t i = 0;
  // A block with an axis word makes a move, even one of no length.
  if (m.slow() != m.start || m.reached() == m.slow()) {
    RC_ASSERT(run->events[i].type == spec::MoveType::rapid);
    RC_ASSERT(run->events[i++].point[2] == thousandths(m.slow()));
  }
  if (m.reached() != m.slow()) {
    RC_ASSERT(run->events[i].cause == spec::Cause::measure);
    RC_ASSERT(run->events[i++].point[2] == thousandths(m.reached()));
  }
  RC_ASSERT(run->events.size() == i + 1);
  const model::Event& last = run->events[i];
  if (m.measured()) {
    RC_ASSERT(last.kind == EventKind::setting);
    RC_ASSERT(last.setting == spec::Name("H1"));
    RC_ASSERT(last.value == thousandths(m.offset + m.reached() - m.commanded));
  } else {
    RC_ASSERT(last.kind == EventKind::alarm);
    RC_ASSERT(last.number == spec::Name("PS0080"));
  }
  fast_agrees(c, *run);
}

// Under G43 with the new value the tool goes to the place of the signal when the commanded coordinate is programmed.
RC_GTEST_PROP(LawsOfMeasurement, TheNewValueTakesTheToolToTheSignal, ()) {
  Measurement m = any_measurement();
  m.offset = 0;
  RC_PRE(m.measured() && m.reached() == m.touch);
  spec::Case c = make(m);
  c.program += fmt::format("G90 G43 Z{} H01\n", number(m.commanded));
  const auto run = model_run(c);
  RC_LOG() << fuzz::encode(c);
  RC_ASSERT(run->events.back().kind == EventKind::move);
  RC_ASSERT(run->events.back().axes[2] == thousandths(m.touch));
  fast_agrees(c, *run);
}

RC_GTEST_PROP(LawsOfMeasurement, Mirror, ()) {
  const Measurement m = any_measurement();
  Measurement other = m;
  other.start = -m.start;
  other.commanded = -m.commanded;
  other.touch = -m.touch;
  other.offset = -m.offset;
  mapped(make(m), make(other), [](const spec::Axes&, const Table& t) {
    Table result = t;
    if (t.has(2)) result.set(2, -t[2]);
    return result;
  });
}

}  // namespace
}  // namespace toolcomp::laws

// SPDX-License-Identifier: Apache-2.0
// Laws of the tool length offset (chapter 14, 14.1.1): what the axes are sent to is the programmed point plus one
// vector.
#include <fmt/format.h>

#include <vector>

#include "tests/property/support.h"

namespace toolcomp::laws {
namespace {

std::string number(std::int64_t thousandths) {
  const std::int64_t magnitude = thousandths < 0 ? -thousandths : thousandths;
  return fmt::format("{}{}.{:03}", thousandths < 0 ? "-" : "", magnitude / 1000, magnitude % 1000);
}

std::int64_t any_length() { return *rc::gen::inRange<std::int64_t>(-400'000, 400'001); }

Real thousandths(std::int64_t n) { return Rational(n, 1000); }

// Type A with as many H numbers as offsets.
spec::Case make(const std::vector<std::int64_t>& offsets) {
  spec::Case c;
  c.section = "fanuc/tool-length-offset";
  for (std::size_t i = 0; i < offsets.size(); ++i)
    c.setup.h[static_cast<std::uint32_t>(i + 1)].geometry = *spec::parse_decimal(number(offsets[i]));
  return c;
}

Real offset_of(const model::Event& e) { return e.axes[2] - e.point[2]; }

// A new number replaces the old one, however many came before; G44 subtracts; H0 and G49 leave nothing.
RC_GTEST_PROP(LawsOfLengthOffset, ANewNumberReplacesTheOldOne, ()) {
  std::vector<std::int64_t> offsets(*rc::gen::inRange<std::size_t>(1, 6));
  for (std::int64_t& offset : offsets) offset = any_length();
  spec::Case c = make(offsets);
  std::vector<Real> expected;
  for (std::size_t n = *rc::gen::inRange<std::size_t>(1, 10); n > 0; --n) {
    const std::size_t h = *rc::gen::inRange<std::size_t>(0, offsets.size() + 1);
    const bool minus = *rc::gen::arbitrary<bool>();
    const Real value = h == 0 ? Real(0) : thousandths(offsets[h - 1]);
    c.program += fmt::format("{} Z{} H{}\n", minus ? "G44" : "G43", number(any_length()), h);
    expected.push_back(minus ? -value : value);
  }
  c.program += "G49 Z0\n";
  expected.emplace_back(0);
  const auto run = model_run(c);
  RC_LOG() << fuzz::encode(c);
  RC_ASSERT(run->events.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) RC_ASSERT(offset_of(run->events[i]) == expected[i]);
  fast_agrees(c, *run);
}

// The same points commanded absolutely and by increments.
RC_GTEST_PROP(LawsOfLengthOffset, AbsoluteIsIncremental, ()) {
  spec::Case absolute = make({any_length(), any_length()});
  spec::Case incremental = absolute;
  absolute.program = "G90\n";
  incremental.program = "G91\n";
  std::int64_t at = 0;
  for (std::size_t n = *rc::gen::inRange<std::size_t>(1, 10); n > 0; --n) {
    const std::int64_t move = any_length();
    at += move;
    const std::string code =
        *rc::gen::element<std::string>("", "G43 H1 ", "G43 H2 ", "G44 H1 ", "H2 ", "G49 ", "H0 ", "G01 F100 ");
    absolute.program += fmt::format("{}Z{}\n", code, number(at));
    incremental.program += fmt::format("{}Z{}\n", code, number(move));
  }
  mapped(absolute, incremental, [](const spec::Axes&, const Table& t) { return t; });
}

// G44 with the opposite offsets is G43.
RC_GTEST_PROP(LawsOfLengthOffset, G44IsG43OfTheOppositeValues, ()) {
  spec::Case c = generated("fanuc/tool-length-offset");
  RC_PRE(!has_word(c.program, [](const std::string& w) { return is_one_of(w, {"G10", "G43.5"}); }));
  spec::Case other = c;
  other.program = each_word(c.program, [](std::string& word) {
    if (word == "G43")
      word = "G44";
    else if (word == "G44")
      word = "G43";
  });
  for (auto* memory : {&other.setup.h, &other.setup.d})
    for (auto& [h, entry] : *memory) {
      entry.geometry.negative = !entry.geometry.negative;
      entry.wear.negative = !entry.wear.negative;
    }
  mapped(c, other, [](const spec::Axes&, const Table& t) { return t; });
}

// Blocks between start and cancel change nothing but the axes: without any length offset the programmed points are the
// same, and the axes are there. Not under tool center point control, where a table that turns takes the axes
// along.
RC_GTEST_PROP(LawsOfLengthOffset, OffsetsOfZeroAreTheIdentity, ()) {
  spec::Case c = generated("fanuc/tool-length-offset");
  RC_PRE(!has_word(c.program, [](const std::string& w) { return w == "G10" || w == "G43.4" || w == "G43.5"; }));
  c.setup.h.clear();
  c.setup.d.clear();
  const auto run = model_run(c);
  RC_PRE(run.has_value());
  RC_LOG() << fuzz::encode(c);
  for (const model::Event& e : run->events) {
    if (e.kind != EventKind::move) continue;
    for (std::size_t i = 0; i < c.setup.axes.size(); ++i)
      if (e.point.has(i)) RC_ASSERT(e.axes[i] == e.point[i]);
  }
  fast_agrees(c, *run);
}

// Geometry and wear count by their sum, wherever the parts lie.
RC_GTEST_PROP(LawsOfLengthOffset, OnlyTheSumOfGeometryAndWearCounts, ()) {
  const std::int64_t wear = *rc::gen::inRange<std::int64_t>(-99'000, 99'001);
  const std::int64_t length = any_length();
  spec::Case one = make({length});
  one.setup.memory = spec::OffsetMemory::c;
  spec::Case two = make({length - wear});
  two.setup.memory = spec::OffsetMemory::c;
  two.setup.h[1].wear = *spec::parse_decimal(number(wear));
  one.program = two.program = fmt::format("G43 Z{} H1\nX10.\nG44 Z5.\nG49\n", number(any_length()));
  mapped(one, two, [](const spec::Axes&, const Table& t) { return t; });
}

}  // namespace
}  // namespace toolcomp::laws

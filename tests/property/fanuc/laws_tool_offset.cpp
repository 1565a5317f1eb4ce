// SPDX-License-Identifier: Apache-2.0
// Laws of tool offset G45 to G48 (14.3): pairs that undo each other, scaling, mirror, doubling.
#include <fmt/format.h>

#include <array>
#include <vector>

#include "tests/property/support.h"

namespace toolcomp::laws {
namespace {

std::string number(std::int64_t thousandths) {
  const std::int64_t magnitude = thousandths < 0 ? -thousandths : thousandths;
  return fmt::format("{}{}.{:03}", thousandths < 0 ? "-" : "", magnitude / 1000, magnitude % 1000);
}

std::int64_t any_length() { return *rc::gen::inRange<std::int64_t>(-60'000, 60'001); }

// A block: a code or none, and a travel that is not zero.
struct Block {
  int code = 0;  // 0: none
  std::int64_t x = 0;
  std::int64_t y = 0;
};

std::vector<Block> any_blocks() {
  std::vector<Block> blocks(*rc::gen::inRange<std::size_t>(1, 7));
  for (Block& b : blocks) {
    b.code = *rc::gen::element(0, 45, 46, 47, 48);
    b.x = *rc::gen::suchThat(rc::gen::exec(any_length), [](std::int64_t v) { return v != 0; });
    b.y = *rc::gen::suchThat(rc::gen::exec(any_length), [](std::int64_t v) { return v != 0; });
  }
  return blocks;
}

spec::Case make(std::int64_t offset, const std::vector<Block>& blocks, bool absolute = false) {
  spec::Case c;
  c.section = "fanuc/tool-offset";
  c.setup.d[1].geometry = *spec::parse_decimal(number(offset));
  c.program = fmt::format("{} G01 F1000 D1\n", absolute ? "G90" : "G91");
  std::int64_t x = 0;
  std::int64_t y = 0;
  for (const Block& b : blocks) {
    x += b.x;
    y += b.y;
    if (b.code != 0) c.program += fmt::format("G{} ", b.code);
    c.program += fmt::format("X{} Y{}\n", number(absolute ? x : b.x), number(absolute ? y : b.y));
  }
  return c;
}

Table identity(const spec::Axes&, const Table& t) { return t; }

RC_GTEST_PROP(LawsOfToolOffset, AbsoluteIsIncremental, ()) {
  const std::int64_t offset = any_length();
  const std::vector<Block> blocks = any_blocks();
  mapped(make(offset, blocks), make(offset, blocks, true), identity);
}

// G45 with -d is G46 with d, G47 with -d is G48 with d.
RC_GTEST_PROP(LawsOfToolOffset, TheOppositeValueIsTheOppositeCode, ()) {
  const std::int64_t offset = any_length();
  const std::vector<Block> blocks = any_blocks();
  std::vector<Block> opposite = blocks;
  for (Block& b : opposite)
    if (b.code != 0) b.code = b.code == 45 ? 46 : b.code == 46 ? 45 : b.code == 47 ? 48 : 47;
  mapped(make(offset, blocks), make(-offset, opposite), identity);
}

// G47 and G48 are G45 and G46 with twice the value.
RC_GTEST_PROP(LawsOfToolOffset, TwiceIsTwiceTheValue, ()) {
  const std::int64_t offset = any_length();
  std::vector<Block> once = any_blocks();
  std::vector<Block> twice = once;
  for (std::size_t i = 0; i < once.size(); ++i) {
    if (once[i].code > 46) once[i].code -= 2;
    if (twice[i].code == 45 || twice[i].code == 46) twice[i].code += 2;
  }
  mapped(make(2 * offset, once), make(offset, twice), identity);
}

// X turned round: what was added in one sense is added in the other.
RC_GTEST_PROP(LawsOfToolOffset, Mirror, ()) {
  const std::int64_t offset = any_length();
  const std::vector<Block> blocks = any_blocks();
  std::vector<Block> mirrored = blocks;
  for (Block& b : mirrored) b.x = -b.x;
  mapped(make(offset, blocks), make(offset, mirrored), [](const spec::Axes&, const Table& t) {
    Table result = t;
    if (t.has(0)) result.set(0, -t[0]);
    return result;
  });
}

// A block with a code and its opposite after it, in the same sense: nothing of the offset is left.
RC_GTEST_PROP(LawsOfToolOffset, TheOppositeCodeTakesItAway, ()) {
  const std::int64_t offset = any_length();
  std::vector<Block> blocks = any_blocks();
  std::vector<Block> undone;
  for (const Block& b : blocks) {
    undone.push_back(b);
    if (b.code == 0) continue;
    const int opposite = b.code == 45 ? 46 : b.code == 46 ? 45 : b.code == 47 ? 48 : 47;
    undone.push_back({opposite, b.x, b.y});
  }
  const spec::Case c = make(offset, undone);
  const auto run = model_run(c);
  RC_LOG() << fuzz::encode(c);
  RC_ASSERT(run.has_value());
  RC_ASSERT(run->events.size() == undone.size());
  std::size_t i = 0;
  for (const Block& b : blocks) {
    if (b.code != 0) ++i;
    RC_ASSERT(same(run->events[i].programmed, run->events[i].point));
    ++i;
  }
  fast_agrees(c, *run);
}

// The table with written signs of zero: the travel of G45 X0 is what G45 X1 and X-1 give more than their programmed 1.
RC_GTEST_PROP(LawsOfToolOffset, TravelOfZeroGoesByItsWrittenSign, ()) {
  const std::int64_t offset = any_length();
  const int code = *rc::gen::element(45, 46, 47, 48);
  for (const char* sign : {"", "-"}) {
    spec::Case zero = make(offset, {});
    spec::Case one = zero;
    zero.program += fmt::format("G{} X{}0\n", code, sign);
    one.program += fmt::format("G{} X{}1.\n", code, sign);
    const auto a = model_run(zero);
    const auto b = model_run(one);
    RC_LOG() << fuzz::encode(zero);
    RC_ASSERT(a->events.size() == 1U);
    const Real left = *sign == '-' ? Real(-1) : Real(1);
    RC_ASSERT(a->events[0].point[0] + left == b->events[0].point[0]);
    fast_agrees(zero, *a);
  }
}

}  // namespace
}  // namespace toolcomp::laws

// SPDX-License-Identifier: Apache-2.0
// Klartext blocks survive their text, however it is laid out; any bytes are blocks or one error.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "spec/language/heidenhain/klartext_reader.h"
#include "spec/language/input_error.h"
#include "tests/support/usual_number.h"

namespace {

using namespace toolcomp::spec;
using namespace toolcomp::spec::klartext;
using klartext::Block;
using rc::gen::inRange;

constexpr std::size_t kSlots = kAxisLetters.size();

toolcomp::spec::Setup any_axes() {
  toolcomp::spec::Setup setup;
  setup.control = Control::heidenhain;
  setup.axes = Axes(kAxisLetters);
  setup.tcs[7] = {};
  return setup;
}

bool coin() { return *rc::gen::arbitrary<bool>(); }

Decimal any_number(int most = Decimal::kMaxDigits) {
  Decimal value;
  const int count = *inRange(1, most + 1);
  for (int i = 0; i < count; ++i) value.digits = value.digits * 10 + *inRange<std::uint64_t>(0, 10);
  value.decimals = static_cast<std::uint8_t>(*inRange(0, count + 1));
  // Leading zeros are digits too, but not kept.
  while (value.decimals > 0 && to_string(value).size() > Decimal::kMaxDigits) --value.decimals;
  value.point = value.decimals != 0;
  value.negative = coin();
  return value;
}

Value any_value() {
  Value value;
  const int kind = *inRange(0, 6);
  if (kind < 3) {
    value.number = any_number();
    return value;
  }
  value.number.negative = coin();
  value.parameter.kind = kind == 3 ? ParameterKind::q : kind == 4 ? ParameterKind::ql : ParameterKind::qr;
  value.parameter.index = *inRange<std::uint16_t>(0, kind == 3 ? kMostQ + 1 : kMostLocal + 1);
  return value;
}

std::array<Decimal, 3> any_vector() {
  std::array<Decimal, 3> vector{any_number(1), any_number(1), any_number(1)};
  if (coin()) vector[0] = {*inRange<std::uint64_t>(0, 99'999'999), 8, coin(), true};
  vector[2].digits = *inRange<std::uint64_t>(1, 10);  // not 0
  return vector;
}

// Functions that end the reading, or need a word of their own, are in tests/unit.
std::uint16_t any_function() {
  const auto number = *inRange<std::uint16_t>(0, 10000);
  constexpr std::array kApart{89, 97, 98, 99, 114, 120, 124, 140, 144, 197};
  return std::ranges::find(kApart, number) == kApart.end() ? number : std::uint16_t{30};
}

void fill_functions(Block& block) {
  block.functions = static_cast<std::uint8_t>(*inRange<std::size_t>(0, Block::kMostFunctions + 1));
  for (std::size_t i = 0; i < block.functions; ++i) block.function[i] = any_function();
}

void fill_feed(Block& block) {
  block.feed =
      *rc::gen::element(FeedWord::none, FeedWord::f, FeedWord::f_max, FeedWord::f_auto, FeedWord::f_z, FeedWord::f_u);
  block.feed_value = any_value();
}

void fill_axes(Block& block, std::string_view letters) {
  for (std::size_t slot = 0; slot < kSlots; ++slot) {
    if (letters.find(kAxisLetters[slot]) == std::string_view::npos || coin()) continue;
    block.axes = static_cast<std::uint16_t>(block.axes | 1U << slot);
    if (coin()) block.incremental = static_cast<std::uint16_t>(block.incremental | 1U << slot);
    block.axis[slot] = any_value();
  }
}

void fill_tool_call(Block& block) {
  block.tool = *rc::gen::element(ToolWord::none, ToolWord::number, ToolWord::name, ToolWord::string_parameter);
  block.tool_number = *inRange<std::uint32_t>(0, 327680);
  block.tool_name = std::string_view(*rc::gen::element<std::string>("BALL_6", "; ~ \xE4 X1", "a  b"));
  block.tool_axis = *rc::gen::elementOf(std::string("\0XYZ", 4));
  fill_feed(block);
  for (std::optional<Value>* delta : {&block.dl, &block.dr, &block.dr2})
    if (coin()) *delta = any_value();
}

Block any_block() {
  Block block;
  if (coin()) block.n = *inRange<std::uint64_t>(0, 1'000'000'000'000'000'000);
  block.statement = static_cast<Statement>(
      *inRange(static_cast<int>(Statement::block_form), static_cast<int>(Statement::miscellaneous) + 1));
  // Calls are followed: they have tests of their own.
  if (block.statement >= Statement::label && block.statement <= Statement::program_return)
    block.statement = Statement::assignment;
  block.unit = coin() ? Units::mm : Units::inch;
  block.contour = coin();
  block.reference = *rc::gen::element(ReferenceWord::tip_tip, ReferenceWord::tip_center, ReferenceWord::center_center);
  block.corrections = *rc::gen::element(CorrectionTable::tcs, CorrectionTable::wpl);
  block.row = 7;
  block.target.kind = *rc::gen::element(ParameterKind::q, ParameterKind::ql, ParameterKind::qr);
  block.target.index = *inRange<std::uint16_t>(0, kMostLocal + 1);
  block.value = any_value();
  block.radius = *rc::gen::element(RadiusWord::none, RadiusWord::r0, RadiusWord::rl, RadiusWord::rr);
  switch (block.statement) {
    case Statement::line:
      fill_axes(block, kAxisLetters);
      fill_feed(block);
      fill_functions(block);
      break;
    case Statement::line_with_vectors:
      block.axes = 7;
      for (std::size_t i = 0; i < 3; ++i) block.axis[i] = any_value();
      block.has_normal = coin();
      block.has_tool_vector = !block.has_normal || coin();
      block.normal = any_vector();
      block.tool_vector = any_vector();
      fill_feed(block);
      fill_functions(block);
      break;
    case Statement::tool_call:
      fill_tool_call(block);
      break;
    case Statement::reset_corrections:
      if (coin()) block.corrections = CorrectionTable::both;
      break;
    case Statement::cycle:
      block.cycle = *rc::gen::element<std::uint32_t>(7, 32, 247);
      block.cycle_part = *inRange<std::uint32_t>(0, 4);
      if (block.cycle == 7 && block.cycle_part != 0) fill_axes(block, "XYZUVW");
      break;
    case Statement::stop:
    case Statement::miscellaneous:
      fill_functions(block);
      if (block.functions == 0) block.function[block.functions++] = 30;
      break;
    default:
      break;
  }
  return block;
}

// The same words in another layout. Within quotes nothing changes.
std::string laid_out(const Block& block) {
  const bool moves = block.statement == Statement::line || block.statement == Statement::line_with_vectors;
  std::string text = coin() ? " " : "";
  bool quoted = false;
  for (const char c : to_string(block)) {
    if (c == '"') quoted = !quoted;
    if (quoted)
      text += c;
    else if (c == ' ')
      text += *rc::gen::element<std::string>(" ", " ", " ", "  ", "\t \r", " ~\n ", " ; X1 \" ~\n\t", "~\n");
    else if (c == '.' && moves && coin())
      text += ',';
    else if (c == '-' && moves && coin())
      text += coin() ? "\u2212" : "\u2013";
    else if (c >= 'A' && c <= 'Z' && coin())
      text += static_cast<char>(c - 'A' + 'a');
    else
      text += c;
  }
  return text + *rc::gen::element<std::string>("", " ", "\r", " ; text", " ~\n", ";~\n");
}

bool holds(const std::string& what, const std::function<void()>& property) { return rc::check(what, property); }

TEST(KlartextText, BlocksSurviveTheirText) {
  const toolcomp::spec::Setup setup = any_axes();
  EXPECT_TRUE(holds("blocks", [&] {
    const std::vector<Block> blocks =
        *rc::gen::container<std::vector<Block>>(*inRange<std::size_t>(0, 5), rc::gen::exec(any_block));
    std::string text;
    for (const Block& block : blocks) {
      text += laid_out(block);
      text += *rc::gen::element<std::string>("\n", "\n", "\r\n", "\n\n", "\n;\n", "\n12\n", "\n* text\n");
    }
    RC_LOG() << text;
    Reader reader(text_source(text), setup);
    Block read;
    for (const Block& block : blocks) {
      RC_ASSERT(reader.next(read));
      RC_ASSERT(!read.alarm);
      RC_ASSERT(read.n == block.n);
      RC_ASSERT(read.statement == block.statement);
      RC_ASSERT(to_string(read) == to_string(block));
    }
    RC_ASSERT(!reader.next(read));
  }));
}

TEST(KlartextText, NumbersAreThoseOfTheText) {
  const toolcomp::spec::Setup setup = any_axes();
  EXPECT_TRUE(holds("numbers", [&] {
    const Decimal number = any_number();
    const std::string sign = number.negative ? "" : *rc::gen::element<std::string>("", "+");
    const std::string text = "L X" + sign + to_string(number);
    Reader reader(text_source(text), setup);
    Block block;
    RC_ASSERT(reader.next(block));
    RC_ASSERT(block.axis[0] == (Value{number, {}}));
  }));
}

// A sound block in which a few bytes change is read, or refused at a place in the text.
TEST(KlartextText, DamagedTextsAreBlocksOrAnError) {
  const toolcomp::spec::Setup setup = any_axes();
  EXPECT_TRUE(holds("damaged", [&] {
    std::string text = laid_out(any_block()) + "\n" + laid_out(any_block());
    for (int i = *inRange(0, 4); i > 0; --i)
      text[*inRange<std::size_t>(0, text.size())] =
          *rc::gen::elementOf(std::string("\0 \n~;\"XLMQ#*/1.,-+\xE2\x88\x92", 21));
    const auto lines = static_cast<std::uint64_t>(std::ranges::count(text, '\n')) + 1;
    Reader reader(text_source(text), setup);
    Block block;
    try {
      while (reader.next(block)) {
        RC_ASSERT(block.line >= 1);
        RC_ASSERT(block.line <= lines);
        if (!block.alarm) continue;
        RC_ASSERT(toolcomp::spec::is_beyond(block.alarm->cause) ||
                  toolcomp::test::usual_number(block.alarm->cause).starts_with("E_"));
        RC_ASSERT(block.alarm->line >= block.line);
        RC_ASSERT(block.alarm->line <= lines);
        RC_ASSERT(block.alarm->column >= 1);
        RC_ASSERT(block.alarm->column <= text.size() + 1);
      }
    } catch (const InputError& error) {
      RC_ASSERT(error.line() >= 1);
      RC_ASSERT(error.line() <= lines);
    }
    RC_ASSERT(!reader.next(block));
  }));
}

}  // namespace

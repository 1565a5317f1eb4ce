// SPDX-License-Identifier: Apache-2.0
// What a writer writes, the reader reads back equal; what is no input at all is refused, and nothing else happens.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "spec/language/case_format.h"
#include "spec/language/event_format.h"
#include "spec/language/event_map.h"
#include "spec/language/fanuc/not_supported.h"
#include "spec/language/fanuc/program_reader.h"
#include "spec/language/input_error.h"
#include "spec/language/number_text.h"
#include "spec/language/parameter.h"
#include "spec/language/setup_format.h"
#include "spec/language/setup_key.h"

namespace {

using namespace toolcomp::spec;
namespace spec = toolcomp::spec;
using rc::gen::inRange;

// A decimal of at most `most` digits that the flags of its address admit.
Decimal any_decimal(int most, bool sign = true, bool point = true) {
  const int count = *inRange(1, most + 1);
  Decimal value;
  for (int i = 0; i < count; ++i) value.digits = value.digits * 10 + *inRange<std::uint64_t>(0, 10);
  value.negative = sign && *rc::gen::arbitrary<bool>();
  value.point = point && *rc::gen::arbitrary<bool>();
  if (value.point) value.decimals = static_cast<std::uint8_t>(*inRange(0, count + 1));
  return value;
}

std::string any_text(const std::string& alphabet) {
  return *rc::gen::container<std::string>(rc::gen::elementOf(alphabet));
}

// A word that a block keeps, whatever stands beside it: it calls no program, and is none that is not supported.
bool is_plain(const Word& word) {
  const std::uint64_t number = word.value.digits;
  if (word.address == 'G') return code_not_supported(word.value) == nullptr;
  if (word.address == 'M') return number != 98 && number != 99 && number != 198;
  return word.address != 'L' || (number != 3 && (number < 50 || number > 52));
}

Word any_word() {
  const char address = *rc::gen::elementOf(std::string("GMOFSTDHPQRLIJKXYZBC"));
  const bool no_sign = std::string_view("GMOTDHL").find(address) != std::string_view::npos;
  const bool no_point = std::string_view("MOTDHL").find(address) != std::string_view::npos;
  Word word{address, any_decimal(15, !no_sign, !no_point), 0};
  while (!is_plain(word)) word.value = any_decimal(15, !no_sign, !no_point);
  return word;
}

Block any_block() {
  Block block;
  if (*rc::gen::arbitrary<bool>()) block.n = *inRange<std::uint64_t>(0, 1'000'000'000'000'000);
  block.size = *inRange<std::size_t>(1, Block::kMaxWords + 1);
  for (std::size_t i = 0; i < block.size; ++i) block.word[i] = any_word();
  return block;
}

bool holds(const std::string& what, const std::function<void()>& property) { return rc::check(what, property); }

TEST(RoundTrip, Decimal) {
  EXPECT_TRUE(holds("decimal", [] {
    const Decimal value = any_decimal(Decimal::kMaxDigits);
    RC_ASSERT(parse_decimal(to_string(value)) == value);
  }));
}

TEST(RoundTrip, Blocks) {
  EXPECT_TRUE(holds("blocks", [] {
    const std::vector<Block> blocks =
        *rc::gen::container<std::vector<Block>>(*inRange<std::size_t>(0, 5), rc::gen::exec(any_block));
    std::string text = "%\n";
    for (const Block& block : blocks) text += to_string(block) + (*rc::gen::arbitrary<bool>() ? "\n" : ";");
    ProgramReader reader(text_source(text), Axes("XYZBC"));
    Block read;
    for (const Block& block : blocks) {
      RC_ASSERT(reader.next(read));
      RC_ASSERT(!read.alarm);
      RC_ASSERT(read.n == block.n);
      RC_ASSERT(std::ranges::equal(read.words(), block.words()));
    }
    RC_ASSERT(!reader.next(read));
  }));
}

// Any text is blocks and at most one InputError; columns lie in their line.
TEST(RoundTrip, AnyBytesAreBlocksOrAnError) {
  EXPECT_TRUE(holds("any bytes", [] {
    const std::string text =
        *rc::gen::arbitrary<bool>() ? *rc::gen::arbitrary<std::string>() : any_text("GXN123.-+ \n;()%/\t:ax5\x1A");
    ProgramReader reader(text_source(text), Axes("XYZ"), {.file = "p", .block_skip = *rc::gen::arbitrary<bool>()});
    const auto lines = static_cast<std::uint64_t>(std::ranges::count(text, '\n')) + 1;
    Block block;
    try {
      while (reader.next(block)) {
        RC_ASSERT(block.size != 0 || block.alarm);
        RC_ASSERT(block.line >= 1 && block.line <= lines);
        for (const Word& word : block.words()) RC_ASSERT(word.column >= 1 && word.column <= text.size());
        if (block.alarm) RC_ASSERT(block.alarm->column >= 1 && block.alarm->column <= text.size() + 1);
      }
    } catch (const InputError& error) {
      RC_ASSERT(error.line() >= 1 && error.line() <= lines);
    }
    RC_ASSERT(!reader.next(block));
  }));
}

AxisTable any_axis_table(const Axes& axes) {
  AxisTable table;
  for (const char letter : axes.letters())
    if (*rc::gen::arbitrary<bool>()) table[letter] = any_decimal(18);
  return table;
}

std::string any_name() {
  const std::string name = any_text("AB-_.1 #\\\xC3").substr(0, 32);
  return name.find('\xC3') == std::string::npos && !name.empty() ? name : "T";
}

void choose_keys(spec::Setup& setup) {
  for (const KeyInfo& key : keys())
    if (key.is_of(setup.control)) key.set(setup, *inRange<std::size_t>(0, key.values.size()));
}

spec::Setup any_heidenhain_setup() {
  spec::Setup setup;
  setup.control = Control::heidenhain;
  choose_keys(setup);
  setup.axes = Axes(*rc::gen::elementOf(std::vector<std::string>{"XYZ", "XYZABC", "ZYX", "ABCUVWXYZ"}));
  setup.position = any_axis_table(setup.axes);
  for (int i = *inRange(0, 3); i > 0; --i) {
    DeviationTable& table = setup.dr2_tables[any_name()];
    table.clear();
    for (int angle = *inRange(0, 9); table.empty() || angle < 180; angle += *inRange(1, 99))
      table.emplace_back(decimal(angle), any_decimal(18));
  }
  for (int i = *inRange(0, 4); i > 0; --i) setup.tcs[*inRange<std::uint32_t>(0, 1'000'000'000)].dr = any_decimal(18);
  std::uint32_t number = 10;
  for (int i = *inRange(0, 4); i > 0; --i) {
    ToolRow row;
    row.number = number;
    number += *inRange<std::uint32_t>(1, 50);
    if (*rc::gen::arbitrary<bool>()) row.name = "TOOL \\ " + std::to_string(number);
    for (Decimal* value : {&row.r, &row.r2, &row.dl, &row.dr, &row.dr2}) *value = any_decimal(18);
    if (*rc::gen::arbitrary<bool>()) row.l = any_decimal(18);
    if (!setup.dr2_tables.empty() && *rc::gen::arbitrary<bool>()) row.dr2_table = setup.dr2_tables.begin()->first;
    setup.tools.push_back(row);
  }
  return setup;
}

spec::Setup any_setup() {
  if (*rc::gen::arbitrary<bool>()) return any_heidenhain_setup();
  spec::Setup setup;
  choose_keys(setup);
  setup.axes = Axes(*rc::gen::elementOf(std::vector<std::string>{"XYZ", "XYZBC", "ZAX", "ABCUVWXYZ"}));
  for (int i = *inRange(0, 6); i > 0; --i) {
    const ParameterInfo& p = parameters()[*inRange<std::size_t>(0, parameters().size())];
    // A bit is written without a point.
    const Decimal value = any_decimal(18, true, p.id.bit < 0);
    setup.parameters[p.id] = allows(p.id, value, setup.axes) ? value : p.default_value.value_or(p.least);
  }
  setup.memory = *rc::gen::element(OffsetMemory::a, OffsetMemory::b, OffsetMemory::c);
  setup.offset_count = *inRange<std::uint32_t>(1, 1000);
  for (auto* entries : {&setup.h, &setup.d})
    for (int i = *inRange(0, 4); i > 0; --i)
      (*entries)[*inRange<std::uint32_t>(1, setup.offset_count + 1)] = {
          any_decimal(18), setup.memory == OffsetMemory::a ? Decimal{} : any_decimal(18)};
  for (AxisTable& table : setup.workpiece) table = any_axis_table(setup.axes);
  setup.position = any_axis_table(setup.axes);
  for (int i = 1; i <= 4; ++i)
    if (AxisTable table = any_axis_table(setup.axes); !table.empty()) setup.reference[i] = std::move(table);
  setup.floating_reference = any_axis_table(setup.axes);
  setup.measurement = any_axis_table(setup.axes);
  return setup;
}

TEST(RoundTrip, Setups) {
  EXPECT_TRUE(holds("setups", [] {
    const spec::Setup setup = any_setup();
    RC_ASSERT(read_setup_toml(write_setup_toml(setup), "t") == setup);
    RC_ASSERT(read_setup_json(write_setup_json(setup), "j") == setup);
  }));
}

NumberText any_number() {
  NumberText number;
  number.v = to_string(any_decimal(18));
  if (*rc::gen::arbitrary<bool>()) number.r = to_string(any_decimal(18, false));
  if (*rc::gen::arbitrary<bool>()) number.q = "-3/4";
  return number;
}

AxisValues<NumberText> any_values() {
  AxisValues<NumberText> values;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (*rc::gen::arbitrary<bool>()) values.set(axis, any_number());
  return values;
}

std::array<NumberText, 3> any_vector() { return {any_number(), any_number(), any_number()}; }

SpaceCompensation<NumberText> any_space() {
  SpaceCompensation<NumberText> space{any_vector(), any_vector(), any_vector(), {}, {}};
  if (*rc::gen::arbitrary<bool>()) space.carrier = any_vector();
  if (!*rc::gen::arbitrary<bool>()) return space;
  space.contact = Contact<NumberText>{any_vector(), any_vector(), *rc::gen::arbitrary<bool>(), {}};
  if (*rc::gen::arbitrary<bool>()) space.contact->angle = any_number();
  return space;
}

void fill_move(TextEvent& event) {
  event.type = *rc::gen::element(MoveType::rapid, MoveType::linear, MoveType::arc);
  event.cause = static_cast<Cause>(*inRange<std::size_t>(0, kNames<Cause>.size()));
  event.programmed = any_values();
  event.machine = any_values();
  if (*rc::gen::arbitrary<bool>()) event.feed = any_number();
  if (*rc::gen::arbitrary<bool>()) event.space = any_space();
  if (event.type != MoveType::arc) return;
  event.arc.emplace();
  event.arc->center.set(0, any_number());
  event.arc->plane = *rc::gen::element(Plane::xy, Plane::zx, Plane::yz);
  event.arc->direction = *rc::gen::element(ArcDirection::cw, ArcDirection::ccw);
  if (*rc::gen::arbitrary<bool>()) event.arc->sweep = any_number();
  if (*rc::gen::arbitrary<bool>()) event.arc->radius.emplace(any_number(), any_number());
}

TextEvent any_event() {
  TextEvent event;
  event.kind = static_cast<EventKind>(*inRange<std::size_t>(0, kNames<EventKind>.size()));
  event.line = *inRange<std::uint64_t>(0, 1'000'000);
  if (*rc::gen::arbitrary<bool>()) event.n = *inRange<std::uint64_t>(0, 1'000'000);
  if (event.kind == EventKind::move) fill_move(event);
  if (event.kind == EventKind::move || event.kind == EventKind::sample) {
    event.point = any_values();
    event.axes = any_values();
    if (*rc::gen::arbitrary<bool>()) event.tool_axis = {any_number(), any_number(), any_number()};
  }
  if (event.kind == EventKind::hole) {
    // Of the three linear axes the position has two; the third is the drilling axis.
    event.point.set(0, any_number());
    event.point.set(1, any_number());
    event.axes = any_values();
    event.axes.set(2, any_number());
    event.hole = {2, any_number(), any_number(), any_number()};
  }
  if (event.kind == EventKind::sample) {
    event.t_numerator = *inRange<std::uint32_t>(1, 9);
    event.t_denominator = *inRange<std::uint32_t>(1, 9);
  }
  if (event.kind == EventKind::setting) {
    event.setting = "H1.wear";
    event.value = any_number();
  } else if (event.kind != EventKind::move && event.kind != EventKind::sample && event.kind != EventKind::hole) {
    event.number = "PS0041";
  }
  if (event.kind == EventKind::undecided) event.permitted.tie = *rc::gen::arbitrary<bool>();
  if (event.kind == EventKind::undecided) event.out_of_scope = *rc::gen::arbitrary<bool>();
  return event;
}

Case any_case() {
  Case c;
  c.id = any_text("ab.\"\\\n");
  c.section = "fanuc/tool-length-offset";
  c.comment = any_text("ab \xC3");
  c.clauses = *rc::gen::container<std::vector<std::string>>(rc::gen::just(std::string("a.clause")));
  c.setup = any_setup();
  c.dialect = dialect_of(c.setup.control);
  c.program = any_text("GX1 \n();\t");
  c.samples = *inRange<std::uint32_t>(0, 9);
  c.source.seed = any_text("0123456789");
  c.has_expect = *rc::gen::arbitrary<bool>();
  if (c.has_expect)
    c.expect = *rc::gen::container<std::vector<TextEvent>>(*inRange<std::size_t>(0, 4), rc::gen::exec(any_event));
  return c;
}

TEST(RoundTrip, Cases) {
  EXPECT_TRUE(holds("cases", [] {
    const Case c = any_case();
    const std::string line = write_case_line(c);
    const Case read = read_case(line, "c");
    RC_ASSERT(write_case_line(read) == line);
    RC_ASSERT(write_case(read_case(write_case(c), "c")) == write_case(c));
    RC_ASSERT(read.setup == c.setup);
    RC_ASSERT(read.program == c.program);
    RC_ASSERT(read.expect.size() == c.expect.size());
  }));
}

// A valid text with a few bytes changed is read or refused, with a position.
template <class Read>
void damaged(std::string text, const Read& read) {
  for (int i = *inRange(1, 4); i > 0; --i)
    text[*inRange<std::size_t>(0, text.size())] = *rc::gen::elementOf(std::string("\0\"{}[],:.-=#\n1e\\\xFF", 17));
  try {
    (void)read(text, "f");
  } catch (const InputError& error) {
    RC_ASSERT(error.line() >= 1);
    RC_ASSERT(error.column() >= 1);
  }
}

TEST(RoundTrip, DamagedTextsAreReadOrRefused) {
  EXPECT_TRUE(holds("damaged TOML", [] { damaged(write_setup_toml(any_setup()), read_setup_toml); }));
  EXPECT_TRUE(holds("damaged JSON", [] { damaged(write_setup_json(any_setup()), read_setup_json); }));
  EXPECT_TRUE(holds("damaged case", [] { damaged(write_case(any_case()), read_case); }));
}

}  // namespace

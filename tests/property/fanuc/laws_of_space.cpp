// SPDX-License-Identifier: Apache-2.0
// Laws that hold for every program: motions of space, units, ways to write the same program. Cases come from the
// generators; equality is that of exact values in the model, and the fast engine must agree with the model on the
// changed case too.
#include "tests/property/support.h"

namespace toolcomp::laws {
namespace {

constexpr const char* kLengthOffset = "fanuc/tool-length-offset";
constexpr const char* kLeadingEdge = "fanuc/leading-edge-offset";

// Programs in G17 alone, with axes X Y Z: a plane or a normal axis has to turn with space.
void only_xy_plane(const spec::Case& c) {
  RC_PRE(c.setup.axes.has('X') && c.setup.axes.has('Y') && c.setup.axes.has('Z'));
  RC_PRE(!has_word(c.program, [](const std::string& w) { return is_one_of(w, {"G18", "G19"}); }));
}

// x → -x for linear axis `letter` and its vector letter.
spec::Case mirrored(spec::Case c, char letter, char vector) {
  c.program = each_word(c.program, [&](std::string& word) {
    if (word[0] == letter || word[0] == vector)
      negate(word);
    else if (word == "G02")
      word = "G03";
    else if (word == "G03")
      word = "G02";
  });
  each_table(c.setup, [&](spec::AxisTable& table) {
    const auto entry = table.find(letter);
    if (entry != table.end()) entry->second.negative = !entry->second.negative;
  });
  return c;
}

Table mirror(const spec::Axes& axes, const Table& values, char letter) {
  Table result = values;
  const std::size_t i = axes.index(letter);
  if (result.has(i)) result.set(i, -values[i]);
  return result;
}

// Mirror in X: the leading edge needs no left or right; G02 and G03 change.
RC_GTEST_PROP(LawsOfSpace, MirrorLeadingEdge, ()) {
  spec::Case c = generated(kLeadingEdge);
  without_kinematics(c.setup);
  only_xy_plane(c);
  mapped(c, mirrored(c, 'X', 'I'), [](const spec::Axes& axes, const Table& t) { return mirror(axes, t, 'X'); });
}

RC_GTEST_PROP(LawsOfSpace, MirrorLengthOffset, ()) {
  spec::Case c = generated(kLengthOffset);
  without_kinematics(c.setup);
  only_xy_plane(c);
  // An offset of type C on the mirrored axis would keep its sign.
  c.setup.parameters[{5001, 0}] = spec::decimal(0);
  mapped(c, mirrored(c, 'X', 'I'), [](const spec::Axes& axes, const Table& t) { return mirror(axes, t, 'X'); });
}

// A quarter turn about Z: X becomes Y, Y becomes -X.
spec::Case turned(spec::Case c) {
  c.program = each_word(c.program, [](std::string& word) {
    const auto turn = [&](char first, char second) {
      if (word[0] == first) {
        word[0] = second;
      } else if (word[0] == second) {
        word[0] = first;
        negate(word);
      }
    };
    if (word[0] == 'X' || word[0] == 'Y') turn('X', 'Y');
    if (word[0] == 'I' || word[0] == 'J') turn('I', 'J');
  });
  each_table(c.setup, [](spec::AxisTable& table) {
    spec::AxisTable result = table;
    result.erase('X');
    result.erase('Y');
    if (table.contains('X')) result['Y'] = table['X'];
    if (table.contains('Y')) {
      result['X'] = table['Y'];
      result['X'].negative = !result['X'].negative;
    }
    table = result;
  });
  return c;
}

Table turn(const spec::Axes& axes, const Table& values) {
  Table result = values;
  const std::size_t x = axes.index('X');
  const std::size_t y = axes.index('Y');
  result.clear(x);
  result.clear(y);
  if (values.has(x)) result.set(y, values[x]);
  if (values.has(y)) result.set(x, -values[y]);
  return result;
}

RC_GTEST_PROP(LawsOfSpace, QuarterTurnAboutZLeadingEdge, ()) {
  spec::Case c = generated(kLeadingEdge);
  without_kinematics(c.setup);
  only_xy_plane(c);
  mapped(c, turned(c), turn);
}

RC_GTEST_PROP(LawsOfSpace, QuarterTurnAboutZLengthOffset, ()) {
  spec::Case c = generated(kLengthOffset);
  without_kinematics(c.setup);
  only_xy_plane(c);
  c.setup.parameters[{5001, 0}] = spec::decimal(0);
  mapped(c, turned(c), turn);
}

// v · factor / 10, digits for digits.
spec::Decimal scaled(const spec::Decimal& value, std::uint64_t factor) {
  spec::Decimal result = value;
  result.digits *= factor;
  ++result.decimals;
  result.point = true;
  return result;
}

// Inch programs on a millimetre control run as 25.4 times the program: G20 in front, lengths of the setup times 25.4.
spec::Case in_inches(spec::Case c) {
  constexpr std::uint64_t tenths_of_mm = 254;
  each_table(c.setup, [](spec::AxisTable& table) {
    for (auto& [letter, value] : table)
      if (spec::is_linear_axis(letter)) value = scaled(value, tenths_of_mm);
  });
  for (auto* memory : {&c.setup.h, &c.setup.d})
    for (auto& [number, entry] : *memory)
      entry = {scaled(entry.geometry, tenths_of_mm), scaled(entry.wear, tenths_of_mm)};
  c.program = "G20\n" + c.program;
  return c;
}

Table in_mm(const spec::Axes& axes, const Table& values) {
  Table result = values;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (values.has(i) && spec::is_linear_axis(axes.letter(i))) result.set(i, values[i] * Real(Rational(127, 5)));
  return result;
}

void inches(std::string_view section) {
  spec::Case c = generated(section);
  c.setup.units = spec::Units::mm;
  c.setup.parameters.erase({3401, 0});
  // Offsets stay inside the memory's range after scaling, and no word of the program writes them or changes units.
  const auto shorten = [](spec::Decimal& value, std::uint64_t most) {
    for (int n = value.decimals; n > 0; --n) most *= 10;
    value.digits %= most;
  };
  for (auto* memory : {&c.setup.h, &c.setup.d})
    for (auto& [number, entry] : *memory) {
      shorten(entry.geometry, 15);
      shorten(entry.wear, 1);
    }
  RC_PRE(!has_word(c.program, [](const std::string& w) { return is_one_of(w, {"G10", "G20", "G21"}); }));
  mapped(c, in_inches(c), in_mm, 1);
}
RC_GTEST_PROP(LawsOfSpace, InchesAreMillimetresTimes254LeadingEdge, ()) { inches(kLeadingEdge); }
RC_GTEST_PROP(LawsOfSpace, InchesAreMillimetresTimes254LengthOffset, ()) { inches(kLengthOffset); }

// I J K is a direction: ten times as long is the same (no arc stands in a program with G43.5).
RC_GTEST_PROP(LawsOfSpace, LengthOfIJKDoesNotMatter, ()) {
  const spec::Case c = generated(kLeadingEdge);
  RC_PRE(!has_word(c.program, [](const std::string& w) { return is_one_of(w, {"G02", "G03"}); }));
  RC_PRE(c.setup.bit(3401, 0, true));
  spec::Case longer = c;
  longer.program = each_word(c.program, [](std::string& word) {
    if (word[0] != 'I' && word[0] != 'J' && word[0] != 'K') return;
    const std::size_t point = word.find('.');
    if (point == std::string::npos) {
      word += "0";
    } else if (point + 1 == word.size()) {
      word.insert(point, "0");
    } else {
      std::swap(word[point], word[point + 1]);
    }
  });
  mapped(c, longer, [](const spec::Axes&, const Table& t) { return t; });
}

// With offset value 0 the compensated point is the programmed one.
RC_GTEST_PROP(LawsOfSpace, RadiusZeroIsTheIdentity, ()) {
  spec::Case c = generated(kLeadingEdge);
  RC_PRE(!has_word(c.program, [](const std::string& w) { return w == "G10"; }));
  c.setup.d.clear();
  if (c.setup.memory != spec::OffsetMemory::c) c.setup.h.clear();
  const auto run = model_run(c);
  RC_PRE(run.has_value());
  RC_LOG() << fuzz::encode(c);
  for (const model::Event& e : run->events)
    if (e.kind == EventKind::move) RC_ASSERT(same(e.programmed, e.point));
  fast_agrees(c, *run);
}

// Blocks with parts that mean nothing to the model read the same: comments, spaces, sequence numbers, leading zeros.
RC_GTEST_PROP(LawsOfSpace, WaysToWriteTheSame, ()) {
  const spec::Case c = generated(*rc::gen::element(kLeadingEdge, kLengthOffset));
  spec::Case other = c;
  other.program.clear();
  for (const std::string& line : fuzz::lines(c.program)) {
    fuzz::WordTexts words = fuzz::words(line);
    for (std::string& word : words)
      if (word == "G01")
        word = "G1";
      else if (word == "G00")
        word = "G0";
    other.program += "  " + fuzz::joined_words(words) + " (SAME)\n";
  }
  mapped(c, other, [](const spec::Axes&, const Table& t) { return t; });
}

}  // namespace
}  // namespace toolcomp::laws

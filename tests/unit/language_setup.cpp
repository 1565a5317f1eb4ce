// SPDX-License-Identifier: Apache-2.0
// Setups: every key, every error with its position (counted by hand), and both formats alike.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"
#include "spec/language/setup_key.h"
#include "tests/setup_members.h"

namespace {

using namespace toolcomp::spec;
namespace spec = toolcomp::spec;  // spec::Setup inside tests, where Setup is a member of testing::Test

Setup toml(std::string_view text) { return read_setup_toml(text, "f.toml"); }
Setup json(std::string_view text) { return read_setup_json(text, "f.json"); }

std::string toml_error(std::string_view text) {
  try {
    toml(text);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}
std::string json_error(std::string_view text) {
  try {
    json(text);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

constexpr std::string_view kToml = R"(
control = "fanuc"
units = "inch"
axes = ["X", "Z", "B"]
increment = "IS-C"
cutter_compensation = "B"
type_b_without_perpendicular = true
rotary_angles = "programmed"
block_skip = true
[parameters]
"5001#2" = true
"5001#3" = "0"
19631 = 1.50
19680 = "2"
[offsets]
memory = "B"
count = 99
[offsets.H]
1 = -4.0
2 = { geometry = "120", wear = -0.25 }
[offsets.D]
99 = 5
[workpiece.G54]
X = -0
[workpiece.G59]
B = 1_000.5
[position]
Z = +100
[reference.1]
X = 0.001
[reference.4]
X = 4
[reference.floating]
Z = 7
[measurement]
Z = "198.0"
)";

constexpr std::string_view kJson = R"({
  "control": "fanuc", "units": "inch", "axes": ["X", "Z", "B"], "increment": "IS-C",
  "cutter_compensation": "B", "type_b_without_perpendicular": true, "rotary_angles": "programmed", "block_skip": true,
  "parameters": { "5001#2": true, "5001#3": "0", "19631": 1.50, "19680": "2" },
  "offsets": { "memory": "B", "count": 99,
    "H": { "1": -4.0, "2": { "geometry": "120", "wear": -0.25 } }, "D": { "99": 5 } },
  "workpiece": { "G54": { "X": -0 }, "G59": { "B": 1000.5 } },
  "position": { "Z": "+100" },
  "reference": { "1": { "X": 0.001 }, "4": { "X": 4 }, "floating": { "Z": 7 } },
  "measurement": { "Z": "198.0" }
})";

TEST(Setup, EveryKeyIsRead) {
  const spec::Setup setup = toml(kToml);
  EXPECT_EQ(setup.units, Units::inch);
  EXPECT_EQ(setup.axes.letters(), "XZB");
  EXPECT_EQ(setup.increment, IncrementSystem::is_c);
  EXPECT_EQ(setup.cutter_compensation, CutterCompensationType::b);
  EXPECT_TRUE(setup.type_b_without_perpendicular);
  EXPECT_EQ(setup.rotary_angles, spec::RotaryAngles::programmed);
  EXPECT_TRUE(setup.block_skip);
  EXPECT_EQ(setup.parameter(19631), (Decimal{150, 2, false, true}));
  EXPECT_EQ(setup.parameter(19680), decimal(2));
  EXPECT_TRUE(setup.bit(5001, 2));
  EXPECT_FALSE(setup.bit(5001, 3, true));
  EXPECT_EQ(setup.memory, OffsetMemory::b);
  EXPECT_EQ(setup.offset_count, 99U);
  EXPECT_EQ(setup.h.at(1).geometry, (Decimal{40, 1, true, true}));
  EXPECT_EQ(setup.h.at(2).geometry, decimal(120));
  EXPECT_EQ(setup.h.at(2).wear, (Decimal{25, 2, true, true}));
  EXPECT_EQ(setup.d.at(99).geometry, decimal(5));
  EXPECT_EQ(setup.workpiece[0].at('X'), (Decimal{0, 0, true, false}));  // the sign of -0 stays
  EXPECT_EQ(setup.workpiece[5].at('B'), (Decimal{10005, 1, false, true}));
  EXPECT_EQ(setup.position.at('Z'), decimal(100));
  EXPECT_EQ(setup.reference.at(1).at('X'), (Decimal{1, 3, false, true}));
  EXPECT_EQ(setup.reference.at(4).at('X'), decimal(4));
  EXPECT_EQ(setup.floating_reference.at('Z'), decimal(7));
  EXPECT_EQ(setup.measurement.at('Z'), (Decimal{1980, 1, false, true}));
}

TEST(Setup, TomlAndJsonOfTheSameSetupReadEqual) { EXPECT_EQ(toml(kToml), json(kJson)); }

TEST(Setup, NothingIsTheDefault) {
  EXPECT_EQ(toml(""), spec::Setup{});
  EXPECT_EQ(json("{}"), spec::Setup{});
}

TEST(Setup, RoundTrips) {
  const spec::Setup setup = toml(kToml);
  EXPECT_EQ(toml(write_setup_toml(setup)), setup);
  EXPECT_EQ(json(write_setup_json(setup)), setup);
  EXPECT_EQ(write_setup_json(setup).find('\n'), std::string::npos);
  EXPECT_EQ(toml(write_setup_toml({})), spec::Setup{});
  EXPECT_EQ(json(write_setup_json({})), spec::Setup{});
}

TEST(Setup, EveryMemberIsWrittenAndRead) {
  for (const toolcomp::test::Changed& c : toolcomp::test::changed_setups()) {
    for (const spec::Setup& setup : {c.plain, c.changed}) {
      EXPECT_EQ(toml(write_setup_toml(setup)), setup) << c.what;
      EXPECT_EQ(json(write_setup_json(setup)), setup) << c.what;
    }
    EXPECT_NE(write_setup_toml(c.changed), write_setup_toml(c.plain)) << c.what;
    EXPECT_NE(write_setup_json(c.changed), write_setup_json(c.plain)) << c.what;
  }
}

TEST(Setup, EveryValueOfEveryKeyIsRead) {
  for (const KeyInfo& key : keys())
    for (const Control control : {Control::fanuc, Control::heidenhain}) {
      const std::string head = control == Control::fanuc ? "" : "control = \"heidenhain\"\n";
      for (std::size_t value = 0; key.is_of(control) && value < key.values.size(); ++value) {
        const std::string line = std::string(key.id) + " = " + value_text(key, value);
        spec::Setup expected = toml(head);
        key.set(expected, value);
        EXPECT_EQ(toml(head + line), expected) << line;
        EXPECT_EQ(key.get(expected), value) << line;
        EXPECT_EQ(key.is_default(toml(head)), true) << line;
      }
      const std::string error = toml_error(head + std::string(key.id) + " = 1");
      EXPECT_EQ(error.find("belongs to control") == std::string::npos, key.is_of(control)) << error;
      EXPECT_EQ(error.substr(0, 9), control == Control::fanuc ? "f.toml:1:" : "f.toml:2:");
    }
}

// The schema names what the reader names, in the same order, with the same values.
TEST(Setup, SchemaHasTheNamesOfTheReader) {
  const auto schema = nlohmann::ordered_json::parse(setup_schema());
  for (const Control control : {Control::fanuc, Control::heidenhain}) {
    const bool fanuc = control == Control::fanuc;
    const auto& properties = schema["$defs"][fanuc ? "fanuc" : "heidenhain"]["properties"];
    std::string names;
    for (const auto& [name, property] : properties.items()) names += (names.empty() ? "" : ", ") + name;
    const std::string error = toml_error((fanuc ? "" : "control = \"heidenhain\"\n") + std::string("colour = 1"));
    EXPECT_EQ(error.substr(error.find("one of ") + 7), names);
    for (const KeyInfo& key : keys()) {
      if (!key.is_of(control)) continue;
      const auto& property = properties.at(std::string(key.id));
      EXPECT_EQ(property["default"].dump(), value_text(key, key.default_value));
      EXPECT_TRUE(key.boolean ? property["type"] == "boolean" : property["enum"].size() == key.values.size()) << key.id;
    }
  }
}

// A setup as it is: the example gives every key, with its default.
TEST(Setup, ExampleHasEveryKey) {
  for (const KeyInfo& key : keys())
    for (const Control control : {Control::fanuc, Control::heidenhain}) {
      const std::string line = "\n" + std::string(key.id) + " = " + value_text(key, key.default_value) + " ";
      EXPECT_EQ(setup_example(control).find(line) != std::string_view::npos, key.is_of(control)) << line;
    }
}

TEST(Setup, ExampleReads) {
  const spec::Setup setup = toml(setup_example(Control::fanuc));
  EXPECT_EQ(setup.axes.letters(), "XYZBC");
  EXPECT_EQ(setup.h.at(2).wear, (Decimal{25, 2, true, true}));
  EXPECT_EQ(setup.cutter_compensation, CutterCompensationType::c);
  for (const std::uint32_t number : {5010U, 6241U, 6251U, 6254U}) EXPECT_TRUE(setup.parameter(number)) << number;
  EXPECT_EQ(setup.measurement.at('Z'), (Decimal{1980, 1, false, true}));
}

TEST(Setup, ExampleOfHeidenhainReads) {
  const spec::Setup setup = toml(setup_example(Control::heidenhain));
  EXPECT_EQ(setup.control, Control::heidenhain);
  EXPECT_EQ(setup.axes.letters(), "XYZBC");
  ASSERT_EQ(setup.tools.size(), 3U);
  EXPECT_EQ(setup.tools[0].name, "BALL_6");
  EXPECT_EQ(setup.tools[0].dr2, (Decimal{1, 1, true, true}));
  EXPECT_EQ(setup.tools[0].l, (Decimal{8025, 2, false, true}));
  EXPECT_EQ(setup.tools[1].l, std::nullopt);
  EXPECT_EQ(setup.tools[2].number, 51U);
  EXPECT_EQ(setup.tcs.at(1).dl, (Decimal{5, 3, true, true}));
  EXPECT_EQ(setup.dr2_tables.at(setup.tools[2].dr2_table).size(), 4U);
  EXPECT_EQ(toml(write_setup_toml(setup)), setup);
  EXPECT_EQ(json(write_setup_json(setup)), setup);
}

TEST(Setup, BitsComeFromTheirOwnKeyFirst) {
  spec::Setup setup = toml("[parameters]\n5001 = 5\n\"5001#0\" = 0\n");
  setup.parameters[{5002, -1}] = Decimal{15, 1, false, true};
  EXPECT_FALSE(setup.bit(5001, 0));
  EXPECT_FALSE(setup.bit(5001, 1));
  EXPECT_TRUE(setup.bit(5001, 2));
  EXPECT_TRUE(setup.bit(5002, 0, true));  // no integer: not given
  EXPECT_TRUE(setup.bit(5003, 0, true));
  EXPECT_FALSE(setup.bit(5003, 0));
  EXPECT_EQ(setup.parameter(5003), std::nullopt);
}

TEST(Setup, OffsetMemoryFollowsTheEntries) {
  EXPECT_EQ(toml("[offsets.H]\n1 = 2").memory, OffsetMemory::a);
  EXPECT_EQ(toml("[offsets.D]\n1 = { wear = 2 }").memory, OffsetMemory::c);
  EXPECT_EQ(toml("offsets.memory = \"C\"\n[offsets.H]\n1 = 2").memory, OffsetMemory::c);
}

TEST(Setup, RotaryAnglesAreOfTheMachineUnlessSaidOtherwise) {
  EXPECT_EQ(toml("").rotary_angles, spec::RotaryAngles::machine);
  EXPECT_EQ(toml("rotary_angles = \"machine\"").rotary_angles, spec::RotaryAngles::machine);
  EXPECT_EQ(toml_error("rotary_angles = \"workpiece\""),
            "f.toml:1:17: rotary_angles: unknown value \"workpiece\"; expected one of machine, programmed");
}

TEST(Setup, TypeOfCutterCompensation) {
  EXPECT_EQ(toml("").cutter_compensation, CutterCompensationType::c);
  EXPECT_EQ(toml("cutter_compensation = \"B\"").cutter_compensation, CutterCompensationType::b);
  EXPECT_EQ(toml_error("cutter_compensation = \"A\""),
            "f.toml:1:23: cutter_compensation: unknown value \"A\"; expected one of B, C");
  EXPECT_EQ(toml_error("cutter_compensation = 1").substr(0, 12), "f.toml:1:23:");
}

TEST(Setup, MeasurementNamesAxesOfTheSetup) {
  EXPECT_TRUE(toml("").measurement.empty());
  EXPECT_EQ(toml("[reference.1]"), toml("")) << "a table without axes says nothing";
  EXPECT_EQ(toml("[measurement]\nX = -0.5\nZ = 198").measurement.at('X'), (Decimal{5, 1, true, true}));
  EXPECT_EQ(toml_error("[measurement]\nW = 1"),
            "f.toml:2:1: measurement: \"W\" is not an axis of this setup; its axes are XYZ");
  EXPECT_EQ(toml_error("measurement = 198").substr(0, 9), "f.toml:1:");
}

TEST(Setup, ErrorsNamePlaceFaultAndExpectation) {
  EXPECT_EQ(toml_error("units = \"cm\""),
            "f.toml:1:9: units: unknown value \"cm\"; expected one of mm, inch; did you mean mm?");
  const std::string unknown = toml_error("\n unit = 1");  // between its ends further second readings may stand
  EXPECT_TRUE(unknown.starts_with(
      "f.toml:2:2: setup: unknown key \"unit\"; expected one of control, series, units, axes, increment, "
      "cutter_compensation, type_b_without_perpendicular, rotary_angles, "))
      << unknown;
  EXPECT_TRUE(unknown.ends_with(
      ", block_skip, parameters, alarms, offsets, workpiece, position, reference, measurement; did you mean units?"))
      << unknown;
  EXPECT_EQ(toml_error("axes = [\"X\", \"Q\"]"),
            "f.toml:1:14: axes: \"Q\" is not an axis; expected one of A B C U V W X Y Z");
  EXPECT_EQ(toml_error("axes = [\"X\", \"X\"]"), "f.toml:1:14: axes: axis X is given twice");
  EXPECT_EQ(toml_error("axes = []"), "f.toml:1:8: axes: expected at least one axis");
  EXPECT_EQ(toml_error("axes = \"XYZ\""), "f.toml:1:8: axes: expected an array, found a string");
  EXPECT_EQ(toml_error("block_skip = 1"), "f.toml:1:14: block_skip: expected true or false, found a number");
  EXPECT_EQ(
      toml_error("[parameters]\n\"5001#8\" = 1"),
      "f.toml:2:1: parameters: \"5001#8\" is not a parameter; expected a number up to 99999, or number#bit with a "
      "bit from 0 to 7");
  EXPECT_EQ(toml_error("[parameters]\n05001 = 1").substr(0, 24), "f.toml:2:1: parameters: ");
  EXPECT_EQ(toml_error("[parameters]\n\"5001#2\" = 2"), "f.toml:2:12: 5001#2: expected 0 or 1, found \"2\"");
  EXPECT_EQ(toml_error("[parameters]\n5001 = true"),
            "f.toml:2:8: 5001: expected a decimal number, found true or false");
  EXPECT_EQ(toml_error("[offsets.H]\n0 = 1"),
            "f.toml:2:1: offsets.H: \"0\" is not an offset number; expected 1 to offsets.count = 400");
  EXPECT_EQ(toml_error("offsets.count = 32\n[offsets.D]\n33 = 1"),
            "f.toml:3:1: offsets.D: \"33\" is not an offset number; expected 1 to offsets.count = 32");
  EXPECT_EQ(toml_error("offsets.count = 1000"),
            "f.toml:1:17: offsets.count: expected an integer from 1 to 999, found \"1000\"");
  EXPECT_EQ(toml_error("offsets.memory = \"A\"\n[offsets.H]\n1 = { wear = 1 }"),
            "f.toml:3:5: offsets: memory A has one value for each entry; expected a number, or memory B or C");
  EXPECT_EQ(toml_error("[offsets.H]\n1 = { ware = 1 }"),
            "f.toml:2:7: offsets.H.1: unknown key \"ware\"; expected one of geometry, wear; did you mean wear?");
  EXPECT_EQ(toml_error("[position]\nB = 1"),
            "f.toml:2:1: position: \"B\" is not an axis of this setup; its axes are XYZ");
  EXPECT_EQ(toml_error("[workpiece.G53]\nX = 1").substr(0, 35), "f.toml:1:12: workpiece: unknown key");
  EXPECT_EQ(toml_error("[reference.5]\nX = 1").substr(0, 35), "f.toml:1:12: reference: unknown key");
}

// The table stands in spec/parameters.toml; what is expected here are the numbers and values of the manuals.
TEST(Setup, UnknownParametersAreRefusedWithTheNearest) {
  const auto unknown = [](const std::string& key, const std::string& nearest) {
    return "parameters: \"" + key + "\" is not known (`toolcomp spec parameters` lists them); did you mean " + nearest +
           "?";
  };
  // Two digits exchanged; a bit of a whole number; a bit that the manual leaves free; a neighbour.
  EXPECT_EQ(toml_error("units = \"mm\"\n[parameters]\n  19860 = 2"), "f.toml:3:3: " + unknown("19860", "19680"));
  EXPECT_EQ(toml_error("[parameters]\n\"19631#3\" = 1"), "f.toml:2:1: " + unknown("19631#3", "19631"));
  EXPECT_EQ(toml_error("[parameters]\n\"5001#7\" = 0"), "f.toml:2:1: " + unknown("5001#7", "5001#6"));
  EXPECT_EQ(toml_error("[parameters]\n\"5002#1\" = 0"), "f.toml:2:1: " + unknown("5002#1", "5001#1"));
  EXPECT_EQ(toml_error("[parameters]\n19706 = 0"), "f.toml:2:1: " + unknown("19706", "19705"));
  EXPECT_EQ(json_error("{\n \"parameters\": {\"5001#2\": 1, \"19860\": 2}}"),
            "f.json:2:30: " + unknown("19860", "19680"));
  EXPECT_EQ(json_error("{\"parameters\": {\"19631#3\": true}}"), "f.json:1:17: " + unknown("19631#3", "19631"));
}

TEST(Setup, ValuesOfParametersAreOfTheirTypeAndRange) {
  const auto at = [](const std::string& line) { return toml_error("[parameters]\n" + line); };
  EXPECT_EQ(at("19680 = 3"), "f.toml:2:9: parameters.19680: expected 0, 2, 12 or 21, found \"3\"");
  EXPECT_EQ(at("19680 = \"2.5\""), "f.toml:2:9: parameters.19680: expected 0, 2, 12 or 21, found \"2.5\"");
  EXPECT_EQ(at("19697 = 0"), "f.toml:2:9: parameters.19697: expected 1, 2 or 3, found \"0\"");
  EXPECT_EQ(at("6261 = 180.001"),
            "f.toml:2:8: parameters.6261: expected an angle (degrees) from 0 to 180, found \"180.001\"");
  EXPECT_EQ(at("19631 = -90.001"),
            "f.toml:2:9: parameters.19631: expected an angle (degrees) from -90 to 90, found \"-90.001\"");
  EXPECT_EQ(at("5010 = 1000000"),
            "f.toml:2:8: parameters.5010: expected a length (mm or inch, as the setup) from -999999.999 to 999999.999, "
            "found \"1000000\"");
  EXPECT_EQ(at("19681 = 4"),
            "f.toml:2:9: parameters.19681: expected the number of an axis, 0 to 3 (axes XYZ), found \"4\"");
  EXPECT_EQ(at("19681 = 1.5").substr(0, 39), "f.toml:2:9: parameters.19681: expected ");
  EXPECT_EQ(at("19680 = true"), "f.toml:2:9: 19680: expected a decimal number, found true or false");
  EXPECT_EQ(at("\"5001#2\" = 0.5"), "f.toml:2:12: 5001#2: expected 0 or 1, found \"0.5\"");
  // All bits of the number, given to one of them; its last digit is the bit, or is not.
  EXPECT_EQ(at("\"5003#1\" = \"00000001\""), "f.toml:2:12: 5003#1: expected 0 or 1, found \"00000001\"");
  EXPECT_EQ(at("\"5003#1\" = \"00000010\""), "f.toml:2:12: 5003#1: expected 0 or 1, found \"00000010\"");
  EXPECT_EQ(at("\"5003#1\" = \"00\""), "f.toml:2:12: 5003#1: expected 0 or 1, found \"00\"");
  EXPECT_EQ(json_error("{\"parameters\":\n{\"5003#1\": \"00000000\"}}"),
            "f.json:2:12: 5003#1: expected 0 or 1, found \"00000000\"");
  EXPECT_EQ(json_error("{\"parameters\":\n{\"6261\": -1}}"),
            "f.json:2:10: parameters.6261: expected an angle (degrees) from 0 to 180, found \"-1\"");
  for (const char* good :
       {"19680 = 12.0", "19697 = \"3\"", "6261 = 180.000", "6261 = -0", "19631 = -90", "5010 = -0.001",
        "19738 = -999999.999", "19681 = 3", "\"19696#7\" = true", "\"19696#7\" = \"1\""})
    EXPECT_EQ(at(good), "no error") << good;
}

TEST(Setup, BitsAsOneNumberAreThoseThatAreKnown) {
  const auto at = [](const std::string& line) { return toml_error("[parameters]\n" + line); };
  EXPECT_EQ(at("5001 = 127"), "no error");
  const std::string expected =
      "f.toml:2:8: parameters.5003: expected a whole number that sets no bits except 0, 1 or 2, found ";
  EXPECT_EQ(at("5003 = 8"), expected + "\"8\"");
  EXPECT_EQ(at("5003 = -1"), expected + "\"-1\"");
  EXPECT_EQ(at("5003 = 1.0"), expected + "\"1.0\"");
}

// Avoidance of interference: by name, however it is written.
TEST(Setup, WhatIsNotSupportedIsRefused) {
  const auto at = [](const std::string& line) { return toml_error("[parameters]\n" + line); };
  const std::string expected =
      "expected 0 (CAV of series 30i: avoidance of interference, which is not supported), found ";
  EXPECT_EQ(at("\"19607#5\" = 1"), "f.toml:2:13: parameters.19607#5: " + expected + "\"1\"");
  EXPECT_EQ(at("\"19607#5\" = true"), "f.toml:2:13: parameters.19607#5: " + expected + "true");
  EXPECT_EQ(at("19607 = 32"), "f.toml:2:9: parameters.19607: " + expected + "\"32\"");
  EXPECT_EQ(at("\"19607#5\" = 0"), "no error");
  EXPECT_EQ(at("19607 = 0"), "no error");
}

// 00000100 is bit 2 on a control, and would be bits 6, 5 and 2 as a decimal number: 100 = 64 + 32 + 4.
TEST(Setup, ARowOfBitsIsNoNumber) {
  const auto at = [](const std::string& line) { return toml_error("[parameters]\n" + line); };
  const std::string one_by_one = ": bits must be given one by one, as in ";
  EXPECT_EQ(at("5001 = \"00000100\""),
            "f.toml:2:8: parameters.5001" + one_by_one + "\"5001#2\" = 1, found \"00000100\"");
  EXPECT_EQ(at("5003 = \"10000010\""),
            "f.toml:2:8: parameters.5003" + one_by_one + "\"5003#1\" = 1, found \"10000010\"");
  EXPECT_EQ(at("5003 = \"00000000\""),
            "f.toml:2:8: parameters.5003" + one_by_one + "\"5003#0\" = 1, found \"00000000\"");
  EXPECT_EQ(json_error("{\"parameters\":\n{\"5001\": \"00000100\"}}"),
            "f.json:2:10: parameters.5001" + one_by_one + "\"5001#2\" = 1, found \"00000100\"");
  EXPECT_EQ(at("5001 = \"100\""), "no error");
  EXPECT_EQ(at("5010 = \"00000100\""), "no error");
}

TEST(Setup, NumbersAreExactOrRefused) {
  EXPECT_EQ(toml_error("[position]\nX = 1e5"),
            "f.toml:2:5: position.X: \"1e5\" has an exponent; expected a plain decimal number such as 0.001");
  EXPECT_EQ(json_error("{\"position\": {\"X\": 1E5}}"),
            "f.json:1:20: position.X: \"1E5\" has an exponent; expected a plain decimal number such as 0.001");
  EXPECT_EQ(toml_error("[position]\nX = 123456789.0123456789"),
            "f.toml:2:5: position.X: \"123456789.0123456789\" has more than 18 digits");
  EXPECT_EQ(toml_error("[position]\nX = \"1,5\""),
            "f.toml:2:5: position.X: \"1,5\" is not a decimal number such as -4.0");
  for (const char* number : {"inf", "nan", "0x10", "0b1", "2024-01-01"})
    EXPECT_NE(toml_error("[position]\nX = " + std::string(number)).find("f.toml:2:"), std::string::npos) << number;
  // Eighteen digits survive where a double keeps seventeen.
  EXPECT_EQ(toml("[position]\nX = 0.123456789012345678").position.at('X'),
            (Decimal{123'456'789'012'345'678, 18, false, true}));
}

TEST(Setup, ColumnsCountBytes) {
  // The ä of the first value is bytes 19 and 20, so the second key begins at byte 24.
  EXPECT_EQ(toml_error("[offsets.H]\n1 = { geometry = \"ä\", ware = 1 }"),
            "f.toml:2:24: offsets.H.1: unknown key \"ware\"; expected one of geometry, wear; did you mean wear?");
  EXPECT_EQ(json_error("{\"offsets\":{\"H\":{\"1\":{\"geometry\":\"ä\",\"ware\":1}}}}").substr(0, 14),
            "f.json:1:39: o");
}

constexpr const char* kHeidenhain = "control = \"heidenhain\"\n";

TEST(Setup, KeysOfAControlAreRefusedUnderTheOther) {
  EXPECT_EQ(toml_error("[[tool]]\nR = 3"), "f.toml:1:3: setup: \"tool\" belongs to control \"heidenhain\"");
  EXPECT_EQ(toml_error("[[correction.tcs]]").substr(12), "setup: \"correction\" belongs to control \"heidenhain\"");
  EXPECT_EQ(toml_error("[[dr2table]]").substr(12), "setup: \"dr2table\" belongs to control \"heidenhain\"");
  for (const char* key : {"increment", "cutter_compensation", "type_b_without_perpendicular", "rotary_angles",
                          "parameters", "offsets", "workpiece", "reference", "measurement"})
    EXPECT_EQ(toml_error(kHeidenhain + std::string(key) + " = 1"),
              "f.toml:2:1: setup: \"" + std::string(key) + "\" belongs to control \"fanuc\"");
  EXPECT_EQ(toml_error(kHeidenhain + std::string("tools = 1")),
            "f.toml:2:1: setup: unknown key \"tools\"; expected one of control, units, axes, m128_reference, "
            "block_skip, alarms, position, tool, "
            "correction, dr2table; did you mean tool?");
}

TEST(Setup, HeidenhainDefaults) {
  const spec::Setup setup = toml(kHeidenhain);
  EXPECT_EQ(setup.axes.letters(), "XYZABC");
  EXPECT_EQ(setup.units, Units::mm);
  EXPECT_TRUE(setup.tools.empty());
  EXPECT_EQ(write_setup_json(setup),
            R"({"control":"heidenhain","units":"mm","axes":["X","Y","Z","A","B","C"],"block_skip":false})");
  EXPECT_EQ(toml(write_setup_toml(setup)), setup);
  EXPECT_EQ(toml_error(kHeidenhain + std::string("axes = [\"X\", \"Z\"]")),
            "f.toml:2:8: axes: without Y; control \"heidenhain\" needs X, Y and Z");
  EXPECT_EQ(toml_error(kHeidenhain + std::string("[position]\nU = 1")),
            "f.toml:3:1: position: \"U\" is not an axis of this setup; its axes are XYZABC");
}

std::string tool_error(const std::string& row) { return toml_error(kHeidenhain + ("[[tool]]\n" + row)); }

TEST(Setup, ToolRows) {
  const spec::Setup setup = toml(kHeidenhain + std::string("[[tool]]\nnumber = 5\n[[tool]]\nnumber = 32767.9\n"));
  ASSERT_EQ(setup.tools.size(), 2U);
  ToolRow fifth;
  fifth.number = 50;
  EXPECT_EQ(setup.tools[0], fifth);
  EXPECT_EQ(setup.tools[1].number, 327679U);
  for (const char* number : {"0", "0.5", "32768", "-1", "5.0", "5.12", "\"5.\"", "\".5\""})
    EXPECT_EQ(tool_error("number = " + std::string(number)).substr(0, 63),
              "f.toml:3:10: tool.number: expected a number from 1 to 32767, or")
        << number;
  EXPECT_EQ(tool_error("R = 1"), "f.toml:2:1: tool: without number");
  EXPECT_EQ(tool_error("number = 1\nr = 2"),
            "f.toml:4:1: tool: unknown key \"r\"; expected one of number, name, R, R2, L, DL, DR, DR2, DR2TABLE; "
            "did you mean R?");
  EXPECT_EQ(tool_error("number = 1\n[[tool]]\nnumber = \"1\""), "f.toml:5:10: tool.number: tool 1 is given twice");
  EXPECT_EQ(tool_error("number = 1\nname = \"A\"\n[[tool]]\nnumber = 2\nname = \"A\""),
            "f.toml:7:8: tool.name: the name \"A\" is given twice");
  EXPECT_EQ(tool_error("number = 1\nname = \"\""),
            "f.toml:4:8: tool.name: expected 1 to 32 characters without quotes and control characters, found \"\"");
  EXPECT_EQ(tool_error("number = 1\nname = \"" + std::string(32, 'A') + "\""), "no error");
  EXPECT_NE(tool_error("number = 1\nname = \"" + std::string(33, 'A') + "\""), "no error");
  EXPECT_NE(tool_error("number = 1\nname = 'A\"B'"), "no error");
  EXPECT_EQ(tool_error("number = 1\nDR2TABLE = \"T\""),
            "f.toml:4:12: tool.DR2TABLE: there is no [[dr2table]] named \"T\"");
  EXPECT_EQ(tool_error("number = 1\nR = 1e3"),
            "f.toml:4:5: tool.R: \"1e3\" has an exponent; expected a plain decimal number such as 0.001");
}

TEST(Setup, CorrectionRows) {
  const spec::Setup setup = toml(
      kHeidenhain + std::string("[[correction.tcs]]\nnumber = 0\nDL = 1\n[[correction.tcs]]\nnumber = 999999999\n"));
  ASSERT_EQ(setup.tcs.size(), 2U);
  EXPECT_EQ(setup.tcs.at(0), (CorrectionRow{decimal(1), {}, {}}));
  EXPECT_EQ(setup.tcs.at(999'999'999), CorrectionRow{});
  EXPECT_EQ(toml_error(kHeidenhain + std::string("[[correction.tcs]]\nDL = 1")),
            "f.toml:2:1: correction.tcs: without number");
  EXPECT_EQ(toml_error(kHeidenhain + std::string("[[correction.wpl]]\nnumber = 1")),
            "f.toml:2:14: correction: unknown key \"wpl\"; expected one of tcs");
  EXPECT_EQ(toml_error(kHeidenhain + std::string("[[correction.tcs]]\nnumber = 7\n[[correction.tcs]]\nnumber = 7")),
            "f.toml:5:10: correction.tcs.number: row 7 is given twice");
}

TEST(Setup, DeviationTables) {
  const auto table = [](const std::string& points) {
    return kHeidenhain + ("[[dr2table]]\nname = \"T\"\npoints = " + points);
  };
  const spec::Setup setup = toml(table(R"([["0.0", 0], ["0.000000000000000001", 1], [180, "-0.02"]])"));
  ASSERT_EQ(setup.dr2_tables.at("T").size(), 3U);
  EXPECT_EQ(setup.dr2_tables.at("T")[2].second, (Decimal{2, 2, true, true}));
  EXPECT_EQ(toml(write_setup_toml(setup)), setup);
  EXPECT_EQ(toml_error(table("[]")), "f.toml:4:10: dr2table.points: expected at least one point");
  EXPECT_EQ(toml_error(table("[[1]]")), "f.toml:4:11: dr2table.points: expected [angle, deviation]");
  EXPECT_EQ(toml_error(table("[[10, 0], [\"10.0\", 1]]")),
            "f.toml:4:20: dr2table.points: the angles must ascend; they do not at \"10.0\"");
  EXPECT_EQ(toml_error(table("[[-1, 0]]")),
            "f.toml:4:11: dr2table.points: expected an angle from 0 to 180 degrees, found \"-1\"");
  EXPECT_EQ(toml_error(table("[[180.0001, 0]]")),
            "f.toml:4:11: dr2table.points: expected an angle from 0 to 180 degrees, found \"180.0001\"");
  EXPECT_EQ(toml_error(table("[[1, 0]]\n[[dr2table]]\nname = \"T\"\npoints = [[1, 0]]")),
            "f.toml:6:8: dr2table.name: the table \"T\" is given twice");
}

TEST(Setup, MalformedTextHasItsPosition) {
  EXPECT_EQ(toml_error("units = \"mm\"\nunits = \"mm\"").substr(0, 9), "f.toml:2:");
  EXPECT_EQ(toml_error("a = = 1").substr(0, 12), "f.toml:1:5: ");
  EXPECT_EQ(json_error("{\n  \"units\": }"), "f.json:2:12: expected a JSON value");
  EXPECT_EQ(json_error("{\"units\": \"mm\",\n \"units\": \"mm\"}"), "f.json:2:2: \"units\" is given twice");
  EXPECT_EQ(json_error("[]"), "f.json:1:1: setup: expected a table, found an array");
  EXPECT_EQ(json_error(""), "f.json:1:1: expected a JSON value");
}

TEST(Setup, DeepNestingIsRefused) {
  std::string keys = "a";
  for (int i = 0; i < 100'000; ++i) keys += ".a";
  EXPECT_EQ(toml_error(keys + " = 1"), "f.toml:1:1: a line with more than 100 points");
  EXPECT_NE(toml_error("a = " + std::string(100'000, '[')).find("f.toml:1:"), std::string::npos);
  EXPECT_EQ(json_error(std::string(100'000, '[')), "f.json:1:66: nested too deep");
}

TEST(Setup, SchemaFileIsTheSchema) {
  std::ifstream file(TOOLCOMP_SOURCE_DIR "/corpus/schema/setup.schema.json", std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), setup_schema());
}

}  // namespace

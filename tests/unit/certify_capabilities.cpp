// SPDX-License-Identifier: Apache-2.0
// What controllers say of themselves.
#include "certify/capabilities.h"

#include <gtest/gtest.h>

#include "spec/language/input_error.h"
#include "tests/setup_members.h"

namespace toolcomp::certify {
namespace {

const std::string kWhole =
    R"({"name":"CNC","version":"3","protocol":1,"sections":["fanuc/tool-length-offset"],"fields":["kind","line","axes"],)"
    R"("resolution":"0.001","setup":{"units":"inch"},"vendor":"ignored"})";

TEST(Capabilities, AreReadWhole) {
  const Capabilities c = read_capabilities(kWhole);
  EXPECT_EQ(c.name, "CNC");
  EXPECT_EQ(c.version, "3");
  EXPECT_EQ(c.sections, std::vector<std::string>{"fanuc/tool-length-offset"});
  EXPECT_EQ(c.fields.size(), 3U);
  EXPECT_EQ(c.resolution.words(), "0.01 mm, 0.001 inch, 0.001 degrees, 0.001 of unit vectors");  // it has inches alone
  EXPECT_EQ(c.setup, R"({"units":"inch"})");
  EXPECT_TRUE(meets_minimum(c));
}

TEST(Capabilities, AreWrittenAsTheyAreRead) {
  const Capabilities c = read_capabilities(kWhole);
  const Capabilities again = read_capabilities(write_capabilities(c));
  EXPECT_EQ(again.name, c.name);
  EXPECT_EQ(again.fields, c.fields);
  EXPECT_EQ(again.resolution.words(), c.resolution.words());
  EXPECT_EQ(again.setup, c.setup);
}

TEST(Capabilities, AResolutionByUnit) {
  const auto read = [](const std::string& members) {
    return read_capabilities(R"({"protocol":1,)" + members + "}").resolution;
  };
  EXPECT_EQ(read(R"("resolution":"0.001")").words(), "0.001 mm, 0.0001 inch, 0.001 degrees, 0.001 of unit vectors");
  EXPECT_EQ(read(R"("resolution":"5")").words(), "5 mm, 0.5 inch, 5 degrees, 5 of unit vectors");
  EXPECT_EQ(read(R"("resolution":{"mm":"0.0001","degrees":"0.001"},"rounding":"nearest")").words(),
            "0.0001 mm, 0.001 degrees, rounded to nearest");
  EXPECT_EQ(read(R"("resolution":{"inch":"0.00001"},"rounding":"toward zero")").numbers().inch, 0.00001);
  EXPECT_EQ(read(R"("rounding":"down")").words(), "double precision");
  for (const char* wrong :
       {R"("resolution":{"mm":0.001})", R"("resolution":{"metre":"1"})", R"("resolution":{"mm":"-1"})",
        R"("resolution":"0.001","rounding":"up")", R"("rounding":1)"})
    EXPECT_THROW(read(wrong), spec::InputError) << wrong;
}

// The text a user sees, with the unit the controller has, and no line of a file.
TEST(Capabilities, ACoarseResolutionHasToBeAccepted) {
  const auto refused = [](const std::string& members, const std::string& accepted = {}) -> std::string {
    try {
      expect_fine_resolution(read_capabilities(R"({"protocol":1,)" + members + "}"), accepted);
    } catch (const spec::InputError& error) {
      return error.what();
    }
    return "";
  };
  const auto text = [](const std::string& announced, const std::string& unit) {
    return "--controller: the controller announces a resolution of " + announced + unit +
           ", coarser than 0.01 mm (0.0004 inch); to accept it, give --accept-resolution " + announced;
  };
  EXPECT_EQ(refused(R"("resolution":"0.01")"), "");
  EXPECT_EQ(refused(R"("resolution":"0.02")"), text("0.02", " mm"));
  EXPECT_EQ(refused(R"("resolution":"0.02")", "0.02"), "");
  EXPECT_EQ(refused(R"("resolution":"0.02")", "0.01"), text("0.02", " mm"));
  EXPECT_EQ(refused(R"("resolution":{"inch":"0.0004"})"), "");
  EXPECT_EQ(refused(R"("resolution":{"inch":"0.001"})"), text("0.001", " inch"));
  EXPECT_EQ(refused(R"("resolution":"0.001","setup":{"units":"inch"})"), text("0.001", " inch"));
  EXPECT_EQ(refused(R"("rounding":"down")"), "");
}

TEST(Capabilities, RefuseWhatIsNone) {
  for (const char* line :
       {"", "hello", "[1]", "{}", R"({"protocol":2})", R"({"protocol":1,"name":7})",
        R"({"protocol":1,"fields":"axes"})", R"({"protocol":1,"sections":[1]})", R"({"protocol":1,"resolution":"0"})",
        R"({"protocol":1,"resolution":"-1"})", R"({"protocol":1,"resolution":"fine"})", R"({"protocol":1,"setup":[]})",
        R"({"protocol":1,"setup":{"colour":1}})"})
    EXPECT_THROW(read_capabilities(line), spec::InputError) << line;
}

TEST(Capabilities, TheMinimumIsKindLineAndAPosition) {
  const auto with = [](std::vector<std::string> fields) {
    Capabilities c;
    c.fields = std::move(fields);
    return meets_minimum(c);
  };
  EXPECT_TRUE(with({"kind", "line", "point"}));
  EXPECT_TRUE(with({"axes", "line", "kind"}));
  EXPECT_FALSE(with({"kind", "line", "programmed"}));
  EXPECT_FALSE(with({"kind", "axes"}));
  EXPECT_FALSE(with({}));
}

Capabilities fixed(const std::string& setup) {
  return read_capabilities(R"({"protocol":1,"sections":["s"],"fields":["kind","line","axes"],"setup":)" + setup + "}");
}

spec::Case a_case() {
  spec::Case c;
  c.section = "s";
  c.setup.axes = spec::Axes("XYZBC");
  c.setup.parameters[{5001, 2}] = spec::decimal(1);
  c.setup.h[1] = {spec::decimal(20), {}};
  return c;
}

bool applies(const std::string& setup, const spec::Case& c = a_case()) {
  return why_not_applicable(fixed(setup), c).empty();
}

TEST(Capabilities, ACaseAppliesUnlessItContradictsAFixedSetting) {
  EXPECT_TRUE(applies("{}"));
  EXPECT_TRUE(applies(R"({"units":"mm"})"));
  EXPECT_FALSE(applies(R"({"units":"inch"})"));
  EXPECT_TRUE(applies(R"({"axes":["X","Y","Z","B","C"]})"));
  EXPECT_FALSE(applies(R"({"axes":["X","Y","Z"]})"));
  EXPECT_TRUE(applies(R"({"parameters":{"5001#2":1}})"));
  EXPECT_FALSE(applies(R"({"parameters":{"5001#2":0}})"));
  EXPECT_TRUE(applies(R"({"parameters":{"5001":4}})"));
  EXPECT_TRUE(applies(R"({"offsets":{"H":{"1":"20.0"}}})"));
  EXPECT_FALSE(applies(R"({"offsets":{"H":{"1":"21"}}})"));
}

TEST(Capabilities, WhatACaseLeavesOpenCountsAsItsDefault) {
  EXPECT_TRUE(applies(R"({"parameters":{"5001#0":0}})"));
  EXPECT_FALSE(applies(R"({"parameters":{"5001#0":1}})"));
  EXPECT_TRUE(applies(R"({"parameters":{"3401#0":1}})"));
  EXPECT_FALSE(applies(R"({"parameters":{"3401#0":0}})"));
  EXPECT_TRUE(applies(R"({"parameters":{"19697":3}})"));
  EXPECT_TRUE(applies(R"({"parameters":{"3401":1}})"));
  EXPECT_FALSE(applies(R"({"parameters":{"3401":0}})"));
  EXPECT_TRUE(applies(R"({"parameters":{"19631":"1.000","6251":20,"6254":5,"19680":0}})"));
  EXPECT_FALSE(applies(R"({"parameters":{"19631":0}})"));
  EXPECT_FALSE(applies(R"({"parameters":{"6251":0}})"));
  EXPECT_FALSE(applies(R"({"parameters":{"6241":100}})"));  // not given: F counts
  EXPECT_TRUE(applies(R"({"workpiece":{"G54":{"X":"0.000"}}})"));
  EXPECT_FALSE(applies(R"({"workpiece":{"G54":{"X":5}}})"));
}

TEST(Capabilities, NoMemberOfASetupIsForgotten) {
  for (const test::Changed& c : test::changed_setups()) {
    EXPECT_TRUE(same_meaning(c.plain, c.plain)) << c.what;
    EXPECT_TRUE(same_meaning(c.changed, c.changed)) << c.what;
    EXPECT_FALSE(same_meaning(c.plain, c.changed)) << c.what;
    EXPECT_FALSE(same_meaning(c.changed, c.plain)) << c.what;
  }
}

// By hand: a second reading that the controller has fixed contradicts a case that says nothing.
TEST(Capabilities, ASecondReadingIsASetting) {
  EXPECT_TRUE(applies(R"({"rotary_angles":"machine","type_b_without_perpendicular":false,"cutter_compensation":"C"})"));
  EXPECT_FALSE(applies(R"({"rotary_angles":"programmed"})"));
  EXPECT_FALSE(applies(R"({"type_b_without_perpendicular":true})"));
  EXPECT_FALSE(applies(R"({"cutter_compensation":"B"})"));
}

TEST(Capabilities, ASectionMustBeAnnounced) {
  spec::Case c = a_case();
  c.section = "another";
  EXPECT_FALSE(applies("{}", c));
  c.section.clear();  // a program of the user's own
  EXPECT_TRUE(applies("{}", c));
}

TEST(Capabilities, NamesWhatIsNotJudged) {
  Capabilities c;
  c.fields = all_fields();
  EXPECT_TRUE(fields_not_judged(c).empty());
  std::erase(c.fields, "feed");
  EXPECT_EQ(fields_not_judged(c), std::vector<std::string>{"feed"});
}

}  // namespace
}  // namespace toolcomp::certify

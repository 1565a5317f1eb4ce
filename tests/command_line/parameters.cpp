// SPDX-License-Identifier: Apache-2.0
// The generator of keys and parameters refuses a registry with a fault, naming its place (counted by hand).
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/command_line/command.h"

namespace {

using toolcomp::test::Folder;
using toolcomp::test::Outcome;

// Behind every text of a test, so that lines are counted without them.
const std::string kGoodKey =
    "[[key]]\nid = \"a_key\"\ncontrol = \"both\"\ndefault = false\nletter = \"Z\"\nclauses = [\"a.b.c\"]\ntext = "
    "\"One.\"\n";
const std::string kGoodParameter =
    "[[parameter]]\nid = \"5010\"\ntype = \"bit\"\nclauses = [\"a.b.c\"]\ntext = \"One.\"\n";

class Registry : public testing::Test {
 protected:
  Registry() {
    toolcomp::test::fs::create_directory(folder.path("clauses"));
    (void)folder.write("clauses/c.toml",
                       "[[clause]]\nid = \"a.b.c\"\n[[clause]]\nid = \"a.b.d\"\n[[clause]]\nid = \"a.b.old\"\n"
                       "replaced_by = \"a.b.c\"\n");
  }
  [[nodiscard]] Outcome generate(const std::string& text) const {
    return toolcomp::test::command(
        TOOLCOMP_BINARY_DIR "/toolcomp_parameters " + folder.write("p.toml", text) + ' ' +
        folder.write("a.toml", "[a]\nnumber = \"PS0001\"\ntext = \"one\"\nsource = \"ours\"\n") + ' ' +
        folder.path("clauses") + ' ' + folder.path(""));
  }
  void refused(const std::string& text, const std::string& what) const {
    const Outcome outcome = generate(text);
    EXPECT_EQ(outcome.status, 2) << text;
    EXPECT_EQ(outcome.err, folder.path("p.toml") + ':' + what + '\n') << text;
  }
  void expect_parts(const std::string& file, const std::vector<std::string>& parts) const {
    const std::string text = toolcomp::test::read(folder.path(file));
    for (const std::string& part : parts) EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  }
  Folder folder;
};

class ParameterRegistry : public Registry {
 protected:
  // One parameter with a fault in its lines.
  void refused(const std::string& lines, const std::string& what) const {
    Registry::refused("[[parameter]]\n" + lines + kGoodKey, what);
  }
};

class KeyRegistry : public Registry {
 protected:
  // One key with a fault in its lines.
  void refused(const std::string& lines, const std::string& what) const {
    Registry::refused("[[key]]\n" + lines + kGoodParameter, what);
  }
};

TEST_F(ParameterRegistry, BecomesATable) {
  const Outcome outcome = generate(
      "[[parameter]]\nid = \"5010\"\ntype = \"length\"\nrange = [0, \"1.50\"]\ndefault = \"-0.5\"\n"
      "clauses = [\"a.b.c\", \"a.b.d\"]\ntext = \"A \\\"word\\\".\"\n" +
      kGoodKey);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  expect_parts("table.h", {"ParameterInfo{{5010, -1}, ParameterType::length, ", "Decimal{0U, 0, false, false}",
                           "Decimal{150U, 2, false, true}", "Decimal{5U, 1, true, true}", R"("a.b.c\na.b.d")",
                           R"("A \"word\".")", "std::array<ParameterInfo, 1>"});
}

TEST_F(ParameterRegistry, Faults) {
  const std::string good = "id = \"5010\"\ntype = \"bit\"\nclauses = [\"a.b.c\"]\ntext = \"One.\"\n";
  refused(good + "colour = 1\n", "6:10: unknown key colour");
  refused("id = \"5001#8\"\ntype = \"bit\"\nclauses = [\"a.b.c\"]\n",
          "2:6: id: a number or number#bit must stand here");
  refused("id = \"05001\"\ntype = \"bit\"\nclauses = [\"a.b.c\"]\n", "2:6: id: a number or number#bit must stand here");
  refused("type = \"bit\"\nclauses = [\"a.b.c\"]\n", "1:1: id: a number or number#bit must stand here");
  refused("id = \"5010\"\ntype = \"colour\"\n", "1:1: type must be bit, integer, decimal, length, angle or axis");
  refused("id = \"5010\"\ntype = \"bit\"\ntext = \"One.\"\n", "1:1: clauses must name what rules the entry");
  refused(good + "range = [0, 1]\n", "1:1: range or values must stand here, for a bit or an axis neither");
  refused(good + "default = 0.5\n", "6:11: an integer or a quoted decimal must stand here");
  refused("id = \"1\"\ntype = \"angle\"\nrange = [0]\nclauses = [\"a.b.c\"]\n",
          "4:9: range must be the least and the greatest value");
  refused("id = \"1\"\ntype = \"integer\"\nvalues = [\"a\"]\nclauses = [\"a.b.c\"]\n", "4:11: values must be integers");
  refused("id = \"5010\"\ntype = \"bit\"\nclauses = [\"a.b.e\"]\n", "4:11: there is no clause a.b.e");
  refused("id = \"5010\"\ntype = \"bit\"\nclauses = [\"a.b.old\"]\n",
          "4:11: the clause a.b.old is replaced by another");
  EXPECT_NE(generate("[[parameter]\n").err.find("p.toml:1:"), std::string::npos);
  EXPECT_EQ(generate("").status, 2);
}

// The header that everything includes has the values; texts stand in the table.
TEST_F(KeyRegistry, BecomesAStructAndATable) {
  const Outcome outcome = generate(
      "[[key]]\nid = \"sense_of_turns\"\ncontrol = \"fanuc\"\nvalues = [\"IS-A\", \"b\"]\ndefault = \"b\"\nletter = "
      "\"z\"\npercent = 20\nclauses = [\"a.b.c\"]\ntext = \"One.\"\n" +
      kGoodKey + kGoodParameter);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  expect_parts("keys.h", {"enum class SenseOfTurns : std::uint8_t { is_a, b };",
                          "SenseOfTurns sense_of_turns = SenseOfTurns::b;", "bool a_key = false;"});
  EXPECT_EQ(toolcomp::test::read(folder.path("keys.h")).find("One."), std::string::npos);
  expect_parts("key_table.h",
               {R"(KeyInfo{"sense_of_turns", {true, false}, false, kSenseOfTurnsValues, 1, false, 'z', {}, 20,)",
                R"(KeyInfo{"a_key", {true, true}, true, kAKeyValues, 0, false, 'Z', {}, 0,)", R"("One.")",
                "std::array<KeyInfo, 2>"});
}

TEST_F(KeyRegistry, Faults) {
  const std::string rest = "clauses = [\"a.b.c\"]\ntext = \"One.\"\n";
  const std::string good = "id = \"some\"\ncontrol = \"fanuc\"\ndefault = false\nletter = \"z\"\n" + rest;
  refused(good + "colour = 1\n", "8:10: unknown key colour");
  refused(good + "[[key]]\n" + good, "9:6: id: there is some already");
  refused("id = \"axes\"\n", "2:6: id: there is axes already");
  refused("id = \"Some\"\n", "2:6: id: lower-case letters, digits and _ must stand here");
  refused("control = \"fanuc\"\n", "1:1: id must stand here");
  refused("id = \"some\"\ncontrol = \"lathe\"\n", "1:1: control must be fanuc, heidenhain or both");
  const std::string begin = "id = \"some\"\ncontrol = \"fanuc\"\n";
  refused(begin, "1:1: default must stand here");
  refused(begin + "default = 1\n", "4:11: default must be true or false");
  refused(begin + "values = [\"a\"]\ndefault = \"a\"\n", "4:10: values: two at least must stand here, each once");
  refused(begin + "values = [\"a\", \"a\"]\ndefault = \"a\"\n",
          "4:10: values: two at least must stand here, each once");
  refused(begin + "values = [\"a\", \"b\"]\ndefault = \"c\"\n", "5:11: default must be one of the values");
  const std::string value = begin + "default = true\n";
  refused(value, "1:1: letter must stand here");
  refused(value + "letter = \"zz\"\n", "5:10: letter: one letter must stand here");
  refused(value + "letter = \"p\"\n", "5:10: letter: p begins other lines");
  refused(good + "[[key]]\nid = \"other\"\ncontrol = \"fanuc\"\ndefault = false\nletter = \"z\"\n" + rest,
          "12:10: letter: z begins other lines");
  refused(value + "letter = \"z\"\nwords = [\"a\"]\n",
          "5:10: words: one for each value must stand here; none where there are two");
  refused(begin + "values = [\"a\", \"b\", \"c\"]\ndefault = \"c\"\nletter = \"z\"\n",
          "6:10: words: one for each value must stand here; none where there are two");
  refused(value + "letter = \"z\"\npercent = 0\n", "6:11: percent: 1 to 99 must stand here");
  refused(value + "letter = \"z\"\npercent = \"all\"\n", "6:11: percent: 1 to 99 must stand here");
  refused(value + "letter = \"z\"\ntext = \"One.\"\n", "1:1: clauses must name what rules the entry");
  refused(value + "letter = \"z\"\nclauses = [\"a.b.e\"]\n", "6:11: there is no clause a.b.e");
  refused(value + "letter = \"z\"\nclauses = [\"a.b.old\"]\n", "6:11: the clause a.b.old is replaced by another");
  refused(value + "letter = \"z\"\nclauses = [\"a.b.c\"]\n", "1:1: text must stand here");
  refused(good + "heidenhain.text = \"Two.\"\n", "8:1: heidenhain: text and comment of a key of both controls");
}

}  // namespace

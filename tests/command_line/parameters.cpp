// The generator of the table of parameters refuses a registry with a fault, naming its place (counted by hand).
#include <gtest/gtest.h>

#include <string>

#include "tests/command_line/command.h"

namespace {

using toolcomp::test::Folder;
using toolcomp::test::Outcome;

class ParameterRegistry : public testing::Test {
 protected:
  Outcome generate(const std::string& text) const {
    return toolcomp::test::command(TOOLCOMP_BINARY_DIR "/toolcomp_parameters " + folder.write("p.toml", text) + ' ' +
                                   folder.path(""));
  }
  // One parameter with a fault in its lines.
  void refused(const std::string& lines, const std::string& what) const {
    const Outcome outcome = generate("[[parameter]]\n" + lines);
    EXPECT_EQ(outcome.status, 2) << lines;
    EXPECT_EQ(outcome.err, folder.path("p.toml") + ':' + what + '\n') << lines;
  }
  Folder folder;
};

TEST_F(ParameterRegistry, BecomesATable) {
  const Outcome outcome = generate(
      "[[parameter]]\nid = \"5010\"\ntype = \"length\"\nrange = [0, \"1.50\"]\ndefault = \"-0.5\"\n"
      "clauses = [\"a.b.c\", \"a.b.d\"]\ntext = \"A \\\"word\\\".\"\n");
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::string table = toolcomp::test::read(folder.path("table.h"));
  for (const char* part : {"ParameterInfo{{5010, -1}, ParameterType::length, ", "Decimal{0U, 0, false, false}",
                           "Decimal{150U, 2, false, true}", "Decimal{5U, 1, true, true}", R"("a.b.c\na.b.d")",
                           R"("A \"word\".")", "std::array<ParameterInfo, 1>"})
    EXPECT_NE(table.find(part), std::string::npos) << part << " in\n" << table;
}

TEST_F(ParameterRegistry, Faults) {
  const std::string good = "id = \"5010\"\ntype = \"bit\"\nclauses = [\"a.b.c\"]\ntext = \"One.\"\n";
  refused(good + "colour = 1\n", "6:10: unknown key colour");
  refused("id = \"5001#8\"\ntype = \"bit\"\nclauses = [\"a.b.c\"]\n",
          "2:6: id: a number or number#bit must stand here");
  refused("id = \"05001\"\ntype = \"bit\"\nclauses = [\"a.b.c\"]\n", "2:6: id: a number or number#bit must stand here");
  refused("type = \"bit\"\nclauses = [\"a.b.c\"]\n", "1:1: id: a number or number#bit must stand here");
  refused("id = \"5010\"\ntype = \"colour\"\n", "1:1: type must be bit, integer, decimal, length, angle or axis");
  refused("id = \"5010\"\ntype = \"bit\"\ntext = \"One.\"\n", "1:1: clauses must name what rules the parameter");
  refused(good + "range = [0, 1]\n", "1:1: range or values must stand here, for a bit or an axis neither");
  refused(good + "default = 0.5\n", "6:11: an integer or a quoted decimal must stand here");
  refused("id = \"1\"\ntype = \"angle\"\nrange = [0]\nclauses = [\"a.b.c\"]\n",
          "4:9: range must be the least and the greatest value");
  refused("id = \"1\"\ntype = \"integer\"\nvalues = [\"a\"]\nclauses = [\"a.b.c\"]\n", "4:11: values must be integers");
  EXPECT_NE(generate("[[parameter]\n").err.find("p.toml:1:"), std::string::npos);
  EXPECT_EQ(generate("").status, 2);
}

}  // namespace

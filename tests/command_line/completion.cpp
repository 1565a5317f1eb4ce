// SPDX-License-Identifier: Apache-2.0
// Completion: what the command answers, and what bash, zsh and fish make of it on a terminal.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "tests/command_line/command.h"

namespace {

using toolcomp::test::command;
using toolcomp::test::Folder;
using toolcomp::test::Outcome;
using toolcomp::test::toolcomp;

std::set<std::string> words(const std::string& arguments) {
  const std::string text = toolcomp("complete " + arguments).out;
  std::set<std::string> set;
  for (std::size_t from = 0, to = text.find('\n'); to != std::string::npos; from = to + 1, to = text.find('\n', from))
    set.insert(text.substr(from, std::min(text.find('\t', from), to) - from));
  return set;
}

using Set = std::set<std::string>;

TEST(Completion, AnswersByPlace) {
  EXPECT_EQ(words("ex"), Set{"explain"});
  EXPECT_FALSE(words("''").contains("fuzz-worker"));
  EXPECT_EQ(words("run --eng"), Set{"--engine"});
  EXPECT_EQ(words("run --engine ''"), (Set{"fast", "model", "spec"}));
  EXPECT_EQ(words("run --engine=f"), Set{"fast"});
  EXPECT_EQ(words("run --engine = f"), Set{"fast"});
  EXPECT_EQ(words("run p"), Set{":files"});
  EXPECT_EQ(words("run p.nc x"), Set{}) << "one program";
  EXPECT_EQ(words("run --setup s"), Set{":files"});
  EXPECT_EQ(words("certify --report r"), Set{":folders"});
  EXPECT_EQ(words("kit ''"), (Set{"judge", "make"}));
  EXPECT_EQ(words("kit judge k"), Set{":folders"});
  EXPECT_EQ(words("kit judge k r"), Set{":files"});
  EXPECT_EQ(words("corpus contour --va"), Set{"--variant"});
  EXPECT_FALSE(words("corpus lint --").contains("--variant"));
  EXPECT_EQ(words("config schema e"), Set{"event"});
  EXPECT_EQ(words("config check e"), Set{":files"});
  EXPECT_EQ(words("config example ''"), Set{});
  EXPECT_EQ(words("help expl"), Set{"explain"});
  EXPECT_EQ(words("--color never ru"), Set{"run"});
  EXPECT_EQ(words("--color n"), Set{"never"});
  EXPECT_EQ(words("run -- -"), Set{":files"});
  EXPECT_EQ(words("nothing ''"), Set{});
  EXPECT_EQ(words("completion f"), Set{"fish"});
}

TEST(Completion, KnowsSectionsClausesTargetsAndAdapters) {
  EXPECT_EQ(words("fuzz --section heidenhain/fa"), Set{"heidenhain/face-milling"});
  EXPECT_EQ(words("spec show fanuc.cutter-b.mod"), Set{"fanuc.cutter-b.mode"});
  EXPECT_EQ(words("spec list fanuc"), Set{}) << "no clause there";
  EXPECT_TRUE(words("fuzz --target tool_off").contains("tool_offset_directed"));
  EXPECT_EQ(words("certify --controller linuxcnc-"), Set{"linuxcnc-motion"});
  EXPECT_EQ(words("certify --controller sp"), Set{"spec"});
}

TEST(Completion, OptionsComeOnceUnlessTheyMayBeRepeated) {
  EXPECT_FALSE(words("run --engine fast --").contains("--engine"));
  EXPECT_TRUE(words("fuzz --section fanuc/tool-offset --").contains("--section"));
}

class Shells : public testing::Test {
 protected:
  void SetUp() override {
    for (const std::string shell : {"bash", "zsh", "fish"}) {
      const Outcome outcome = toolcomp("completion " + shell);
      ASSERT_EQ(outcome.status, 0);
      static_cast<void>(folder.write(shell == "zsh" ? "_toolcomp" : "toolcomp." + shell, outcome.out));
    }
    static_cast<void>(folder.write("part.nc", "G00 X1.\n"));
  }

  // What a terminal shows where these lines are typed into the shell, up to what must come.
  [[nodiscard]] Outcome typed(const std::string& shell, const std::string& begin, const std::string& text,
                              const std::string& comes) const {
    return command("cd " + folder.path(".") + " && HOME=" + folder.path(".") +
                   " TERM=xterm PATH=" TOOLCOMP_BINARY_DIR ":$PATH /usr/bin/python3 " TOOLCOMP_SOURCE_DIR
                   "/tests/command_line/terminal.py --type '" +
                   begin + "; echo rea\"\"dy\\n' --until ready --type '" + text + "' --until '" + comes + "' -- " +
                   shell);
  }

  Folder folder;
};

struct Typed {
  std::string text;
  std::string becomes;
};
const std::vector<Typed> kTyped{
    {"toolcomp expl", "toolcomp explain "},
    {"toolcomp run --eng", "toolcomp run --engine "},
    {"toolcomp run --format js", "toolcomp run --format jsonl "},
    {"toolcomp spec show fanuc.cutter-b.mod", "toolcomp spec show fanuc.cutter-b.mode "},
    {"toolcomp fuzz --section heidenhain/fa", "toolcomp fuzz --section heidenhain/face-milling "},
    {"toolcomp run pa", "toolcomp run part.nc "},
    {"toolcomp run --engine=fa", "toolcomp run --engine=fast "}};

TEST_F(Shells, Bash) {
  for (const Typed& t : kTyped) {
    const Outcome shown = typed("bash --noprofile --norc -i", ". ./toolcomp.bash", t.text + "\\t", t.becomes);
    EXPECT_EQ(shown.status, 0) << t.text << '\n' << shown.out << shown.err;
  }
}

// A terminal shows what zsh adds, not the line again: the whole line is echoed behind it, without the blank that zsh
// takes back.
TEST_F(Shells, Zsh) {
  for (const Typed& t : kTyped) {
    const Outcome shown =
        typed("zsh -f -i", "fpath=($PWD $fpath); autoload -Uz compinit; compinit -u -D; PS1=",
              t.text + "\\t\\x01echo \"[\\x05]\"\\n", '[' + t.becomes.substr(0, t.becomes.size() - 1) + ']');
    EXPECT_EQ(shown.status, 0) << t.text << '\n' << shown.out << shown.err;
  }
}

TEST_F(Shells, Fish) {
  for (const Typed& t : kTyped) {
    const Outcome outcome =
        command("cd " + folder.path(".") + " && HOME=" + folder.path(".") +
                " PATH=" TOOLCOMP_BINARY_DIR ":$PATH fish -c 'source toolcomp.fish; complete -C \"" + t.text + "\"'");
    const std::string last = t.becomes.substr(t.becomes.rfind(' ', t.becomes.size() - 2) + 1);
    EXPECT_EQ(outcome.out.substr(0, outcome.out.find_first_of("\t\n")) + ' ', last) << t.text << '\n'
                                                                                    << outcome.out << outcome.err;
  }
}

}  // namespace

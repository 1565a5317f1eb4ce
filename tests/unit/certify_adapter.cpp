// SPDX-License-Identifier: Apache-2.0
// Manifests of adapters: what is read, and what is refused, with its place.
#include "certify/adapter.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "spec/language/input_error.h"
#include "tests/command_line/command.h"

namespace toolcomp::certify {
namespace {

using test::Folder;
namespace fs = std::filesystem;

const std::string kPipe = "[[adapter]]\nname = \"one\"\nkind = \"pipe\"\ncommand = \"sh answer.sh\"\n";
const std::string kTrace =
    "[[adapter]]\nname = \"two\"\nkind = \"trace\"\ncommand = \"sh record.sh\"\npackages = [\"a\", \"b\"]\n"
    "programs = [\"sh\"]\ntolerance = \"0.0025\"\nsetups = [\"machine.toml\"]\nknown_differences = \"known.toml\"\n";
const std::string kKnown =
    "[[difference]]\nid = \"corner\"\nreason = \"round\"\nrecognised = \"by eye\"\nsetup = \"machine.toml\"\n"
    "program = \"G01 X1\"\nalarms = [\"PS0041\"]\n";

class Manifest : public testing::Test {
 protected:
  Folder folder;

  void SetUp() override {
    ASSERT_FALSE(folder.write("machine.toml", "axes = [\"X\"]\n").empty());
    ASSERT_FALSE(folder.write("known.toml", kKnown).empty());
  }
  [[nodiscard]] std::vector<Adapter> read(const std::string& text) const {
    return read_manifest(folder.write("manifest.toml", text));
  }
  // "LINE:COLUMN" of the fault and, behind a blank, what is wrong.
  [[nodiscard]] std::string fault(const std::string& text) const {
    try {
      static_cast<void>(read(text));
    } catch (const spec::InputError& error) {
      EXPECT_NE(error.file().find("manifest.toml"), std::string::npos);
      return std::to_string(error.line()) + ":" + std::to_string(error.column()) + " " + error.message();
    }
    return "none";
  }
};

TEST_F(Manifest, IsReadWhole) {
  const std::vector<Adapter> adapters = read(kPipe + kTrace);
  ASSERT_EQ(adapters.size(), 2U);
  EXPECT_EQ(adapters[0].name, "one");
  EXPECT_EQ(adapters[0].kind, AdapterKind::pipe);
  EXPECT_TRUE(adapters[0].setups.empty());
  const Adapter& two = adapters[1];
  EXPECT_EQ(two.kind, AdapterKind::trace);
  EXPECT_EQ(two.packages, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(two.programs, std::vector<std::string>{"sh"});
  EXPECT_EQ(two.tolerance, 0.0025);
  ASSERT_EQ(two.setups.size(), 1U);
  EXPECT_EQ(two.setups[0].filename(), "machine.toml");
  ASSERT_EQ(two.known.size(), 1U);
  EXPECT_EQ(two.known_difference("corner"), two.known.data());
  EXPECT_EQ(two.known_difference("edge"), nullptr);
  EXPECT_EQ(two.without_alarm("PS0041"), two.known.data());
  EXPECT_EQ(two.without_alarm("PS0042"), nullptr);
}

TEST_F(Manifest, TheCommandRunsInItsFolder) {
  const Adapter adapter = read(kPipe).front();
  EXPECT_EQ(adapter.folder, fs::absolute(folder.path("")).parent_path());
  EXPECT_EQ(adapter.shell_command({"--ask", "it's"}),
            "cd '" + adapter.folder.string() + R"(' && sh answer.sh '--ask' 'it'\''s')");
}

TEST_F(Manifest, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(fault("[[adapter]\n").substr(0, 2), "1:");
  EXPECT_EQ(fault("name = \"one\"\n").substr(0, 4), "1:1 ");
  EXPECT_NE(fault(kPipe + "colour = 1\n").find("5:1 "), std::string::npos);
  EXPECT_NE(fault("[[adapter]]\nname = \"one\"\nkind = \"wire\"\ncommand = \"sh\"\n").find("3:8 "), std::string::npos);
  EXPECT_NE(fault("[[adapter]]\nname = \"One\"\nkind = \"pipe\"\ncommand = \"sh\"\n").find("2:8 name"),
            std::string::npos);
  EXPECT_NE(fault("[[adapter]]\nname = \"one\"\nkind = \"pipe\"\n").find("\"command\" is missing"), std::string::npos);
  EXPECT_NE(fault("[[adapter]]\nname = \"one\"\nkind = \"pipe\"\ncommand = \"\"\n").find("4:11 command"),
            std::string::npos);
  EXPECT_NE(fault(kPipe + kPipe).find("5:"), std::string::npos);
  EXPECT_NE(fault(kPipe + "tolerance = 1\n").find("5:13 tolerance"), std::string::npos);
}

TEST_F(Manifest, ATraceAdapterNeedsToleranceAndSetups) {
  const std::string head = "[[adapter]]\nname = \"two\"\nkind = \"trace\"\ncommand = \"sh\"\n";
  EXPECT_NE(fault(head).find("\"tolerance\" is missing"), std::string::npos);
  EXPECT_NE(fault(head + "tolerance = 0\n").find("5:13 tolerance"), std::string::npos);
  EXPECT_NE(fault(head + "tolerance = \"-1\"\n").find("5:13 tolerance"), std::string::npos);
  EXPECT_NE(fault(head + "tolerance = 1\nsetups = []\n").find("6:10 setups"), std::string::npos);
  EXPECT_NE(fault(head + "tolerance = 1\nsetups = [\"none.toml\"]\n").find("6:11 setups: there is no file"),
            std::string::npos);
}

TEST_F(Manifest, AFileOfKnownDifferencesHasPlacesOfItsOwn) {
  ASSERT_FALSE(folder.write("known.toml", kKnown + kKnown).empty());
  try {
    static_cast<void>(read(kTrace));
    FAIL();
  } catch (const spec::InputError& error) {
    EXPECT_NE(error.file().find("known.toml"), std::string::npos);
    EXPECT_EQ(error.line(), 8U);
  }
}

TEST(Adapters, NamesAreNoCommands) {
  EXPECT_TRUE(is_adapter_name("linuxcnc-motion"));
  for (const char* text : {"", "./linuxcnc", "toolcomp serve", "LinuxCNC", "a_b", "a.b"})
    EXPECT_FALSE(is_adapter_name(text)) << text;
}

// The first folder wins; a folder that is not there is none.
TEST(Adapters, AreFoundInOrder) {
  const Folder first;
  const Folder second;
  for (const Folder* folder : {&first, &second}) {
    fs::create_directories(folder->path("a"));
    ASSERT_FALSE(folder->write("a/manifest.toml", kPipe).empty());
  }
  const std::vector<fs::path> folders = adapter_folders({"/nowhere", second.path("."), first.path(".")});
  ASSERT_GE(folders.size(), 4U);
  EXPECT_EQ(folders.back(), fs::path(TOOLCOMP_SOURCE_DIR) / "adapters");
  const auto found = find_adapter("one", folders);
  ASSERT_TRUE(found);
  EXPECT_TRUE(fs::equivalent(found->folder, second.path("a")));
  EXPECT_FALSE(find_adapter("no-such-adapter", folders));
}

TEST(Adapters, OfTheSourceTreeAreSound) {
  for (const char* name : {"linuxcnc", "linuxcnc-motion"})
    EXPECT_TRUE(find_adapter(name, {fs::path(TOOLCOMP_SOURCE_DIR) / "adapters"})) << name;
}

TEST(Adapters, AMissingProgramIsNamedWithThePackages) {
  Adapter adapter;
  adapter.name = "one";
  adapter.programs = {"sh"};
  EXPECT_NO_THROW(expect_programs(adapter));
  adapter.programs = {"no-such-program"};
  adapter.packages = {"some-package"};
  try {
    expect_programs(adapter);
    FAIL();
  } catch (const spec::InputError& error) {
    EXPECT_NE(error.message().find("no-such-program"), std::string::npos);
    EXPECT_NE(error.message().find("some-package"), std::string::npos);
  }
}

}  // namespace
}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
// The rules of the house that a compiler does not enforce: who may include whom, and where doubles and tolerances live.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
const fs::path kSource = TOOLCOMP_SOURCE_DIR;

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Comments and string literals blanked, so that only code is searched.
std::string code_of(const std::string& text) {
  static const std::regex kNoise(R"(//[^\n]*|/\*[\s\S]*?\*/|"(\\.|[^"\\\n])*")");
  return std::regex_replace(text, kNoise, " ");
}

std::vector<fs::path> sources(const std::string& room) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(kSource / room)) {
    const std::string extension = entry.path().extension();
    if (extension == ".h" || extension == ".cpp" || extension == ".c" || extension == ".inc")
      files.push_back(entry.path());
  }
  return files;
}

// A room with all the rooms that it may include.
struct Room {
  std::string name;
  std::set<std::string> includes;
};

// From below: a room may include only rooms above it in this list.
const std::vector<Room>& rooms() {
  static const std::vector<Room> kRooms{
      {"spec", {}},
      {"host", {"spec"}},
      {"model", {"spec"}},
      {"fast", {"spec"}},
      {"spec_engine", {"spec", "model"}},
      {"c", {"spec", "fast"}},
      {"judge", {"spec", "model", "fast"}},
      {"fuzz", {"spec", "host", "model", "fast", "judge"}},
      {"corpus", {"spec", "host", "model", "fast", "spec_engine", "judge", "fuzz"}},
      {"certify", {"spec", "host", "model", "fast", "spec_engine", "judge", "fuzz", "corpus"}},
      {"cli", {"spec", "host", "model", "fast", "spec_engine", "judge", "fuzz", "corpus", "certify"}},
      {"python", {"spec", "host", "model", "fast", "spec_engine", "judge", "fuzz", "corpus", "certify"}},
      {"playground", {"spec", "model", "fast", "judge", "fuzz", "certify", "cli"}}};
  return kRooms;
}

TEST(Architecture, DependenciesRunOneWay) {
  const std::regex include(R"re(#include "([a-z_]+)/)re");
  std::size_t seen = 0;
  std::set<std::string> below;
  for (const Room& room : rooms()) {
    EXPECT_TRUE(std::ranges::includes(below, room.includes)) << room.name << " includes a room that is not below it";
    for (const fs::path& file : sources(room.name)) {
      const std::string text = read(file);
      for (auto it = std::sregex_iterator(text.begin(), text.end(), include); it != std::sregex_iterator(); ++it) {
        ++seen;
        const std::string other = (*it)[1].str();
        EXPECT_TRUE(other == room.name || room.includes.contains(other)) << file << " includes " << other;
      }
    }
    below.insert(room.name);
  }
  EXPECT_GT(seen, 100U);
  // A room that is not in the list would escape.
  for (const fs::directory_entry& folder : fs::directory_iterator(kSource)) {
    const std::string name = folder.path().filename();
    if (name != "tests" && fs::exists(folder.path() / "CMakeLists.txt") && !sources(name).empty()) {
      EXPECT_TRUE(below.contains(name)) << name << " is not in the list of rooms";
    }
  }
}

// The formal specification shares the model's numbers, and nothing else of it.
TEST(Architecture, TheFormalSpecificationSharesNumbersAlone) {
  const std::regex include(R"re(#include "(model/[a-z_/]+)/[a-z_]+\.h")re");
  std::set<std::string> folders;
  for (const fs::path& file : sources("spec_engine")) {
    const std::string text = read(file);
    for (auto it = std::sregex_iterator(text.begin(), text.end(), include); it != std::sregex_iterator(); ++it)
      folders.insert((*it)[1].str());
  }
  EXPECT_EQ(folders, std::set<std::string>{"model/exact"});
}

// What each folder of both engines includes of the others.
std::map<std::string, std::set<std::string>> includes_of_folders() {
  const std::regex include(R"re(#include "((model|fast)/[a-z_/]+)/[a-z_0-9]+\.)re");
  std::map<std::string, std::set<std::string>> result;
  for (const std::string room : {"model", "fast"})
    for (const fs::path& file : sources(room)) {
      const std::string folder = fs::relative(file.parent_path(), kSource).generic_string();
      std::set<std::string>& others = result[folder];
      const std::string text = read(file);
      for (auto it = std::sregex_iterator(text.begin(), text.end(), include); it != std::sregex_iterator(); ++it)
        if ((*it)[1].str() != folder) others.insert((*it)[1].str());
    }
  return result;
}

// A folder is read when those it includes have been: there is an order in which the house can be read.
TEST(Architecture, FoldersHaveAnOrder) {
  std::map<std::string, std::set<std::string>> left = includes_of_folders();
  EXPECT_GT(left.size(), 30U);
  std::set<std::string> read_before;
  for (bool goes_on = true; goes_on;) {
    goes_on = std::erase_if(left, [&](const auto& folder) {
                const bool next = std::ranges::includes(read_before, folder.second);
                if (next) read_before.insert(folder.first);
                return next;
              }) > 0;
  }
  for (const auto& [folder, others] : left)
    for (const std::string& other : others)
      EXPECT_TRUE(read_before.contains(other)) << folder << " and " << other << " are in a circle";
}

// Two types of one name in one namespace would be taken for each other where programs are linked, and no linker says
// so.
TEST(Architecture, ATypeIsDefinedOnce) {
  const std::regex opens(R"(namespace ([a-z_:]*) ?\{)");
  const std::regex type(R"((?:struct|class|enum class|enum) (\w+)(?: final)?(?: :[^:].*)?\s*\{.*)");
  std::map<std::string, std::set<std::string>> definitions;
  for (const std::string room :
       {"spec", "host", "model", "fast", "judge", "fuzz", "corpus", "certify", "cli", "c", "python"})
    for (const fs::path& file : sources(room)) {
      std::ifstream lines(file);
      std::string name;
      bool own = false;
      std::smatch found;
      for (std::string line; std::getline(lines, line);) {
        if (line == "}  // namespace") own = false;
        if (line.empty() || std::string("nsce").find(line.front()) == std::string::npos) continue;
        if (std::regex_match(line, found, opens)) {
          own = found[1].length() == 0;
          if (!own) name = found[1];
        } else if (!own && std::regex_match(line, found, type)) {
          definitions[name + "::" + found[1].str()].insert(fs::relative(file, kSource).generic_string());
        }
      }
    }
  EXPECT_GT(definitions.size(), 500U);
  for (const auto& [name, files] : definitions)
    EXPECT_EQ(files.size(), 1U) << name << " in " << testing::PrintToString(files);
}

// What is divided by dialect, and the files above both that choose one by the control of a case.
const std::set<std::string> kDivided{"model",      "fast",         "spec/language",  "fuzz/gen",
                                     "judge/laws", "fuzz/targets", "corpus/examples"};
const std::set<std::string> kChooseADialect{
    "fast/batch/dialect.cpp",         "fuzz/gen/mutate.cpp",    "fuzz/gen/slip.cpp", "fuzz/gen/unrestricted.cpp",
    "judge/laws/changed_program.cpp", "judge/laws/registry.cpp"};

// The dialects stand side by side above what they share, and what they share knows neither.
TEST(Architecture, DialectsKnowNothingOfEachOther) {
  const auto dialect = [](const std::string& path) -> std::string {
    for (const std::string name : {"fanuc", "heidenhain"})
      if (path.find("/" + name + "/") != std::string::npos) return name;
    return "";
  };
  const std::regex include(R"re(#include "([a-z_]+/[^"]*)")re");
  std::set<std::string> know_both;
  for (const std::string& room : kDivided) {
    std::map<std::string, int> files;
    for (const fs::path& path : sources(room)) {
      const std::string file = fs::relative(path, kSource).generic_string();
      ++files[dialect(file)];
      const std::string text = read(path);
      std::set<std::string> known;
      for (auto it = std::sregex_iterator(text.begin(), text.end(), include); it != std::sregex_iterator(); ++it)
        if (!dialect((*it)[1]).empty()) known.insert(dialect((*it)[1]));
      if (known.size() > 1) know_both.insert(file);
      known.erase(dialect(file));
      EXPECT_TRUE(known.empty() || kChooseADialect.contains(file)) << file << " knows " << *known.begin();
    }
    EXPECT_TRUE(files["fanuc"] > 0 && files["heidenhain"] > 0) << room;
  }
  EXPECT_EQ(know_both, kChooseADialect);
}

// Who may know a section of an engine: a file, or all of a folder, and why.
struct KnowsSection {
  std::string who;
  std::string section;
  std::string why;
};

const std::vector<KnowsSection>& known_sections() {
  const std::string registry = "the list of the sections";
  const std::string adds = "no stage: it adds to the programmed end while the step is made";
  const std::string offsets = "no stage: they are part of where the axes are";
  const std::string contour = "what is programmed, a contour or a tool, counts in both";
  static const std::vector<KnowsSection> kKnown{
      {"model/fanuc/cutter_compensation_b", "model/fanuc/cutter_compensation", "B and C have the same words"},
      {"model/fanuc/cutter_compensation_c", "model/fanuc/cutter_compensation", "B and C have the same words"},
      {"model/fanuc/step_maker.h", "model/fanuc/tool_offset", adds},
      {"model/fanuc/step_maker.h", "model/fanuc/tool_length_offset", adds},
      {"model/fanuc/step_maker.h", "model/fanuc/tool_length_measurement", adds},
      {"model/fanuc/step_maker.h", "model/fanuc/canned_cycle", "no pass: holes stand where moves would"},
      {"model/fanuc/step_maker.h", "model/fanuc/tool_center_point_control",
       "no stage: the pose is known before any is"},
      {"model/fanuc/reporter.h", "model/fanuc/tool_center_point_control",
       "axes follow from the compensated tip at last"},
      {"model/fanuc/tool_center_point_control", "model/fanuc/tool_length_offset", "one modal group, and one length"},
      {"model/fanuc/tool_center_point_control", "model/fanuc/tool_posture_control", "how a block of it turns the tool"},
      {"model/heidenhain/engine.cpp", "model/heidenhain/face_milling", "the order of the rules"},
      {"model/heidenhain/engine.cpp", "model/heidenhain/peripheral_milling", "the order of the rules"},
      {"model/heidenhain/engine.cpp", "model/heidenhain/programmed_contour", "the order of the rules"},
      {"model/heidenhain/face_milling", "model/heidenhain/programmed_contour", contour},
      {"model/heidenhain/peripheral_milling", "model/heidenhain/programmed_contour", contour},
      {"fast/fanuc/stages.cpp", "fast/fanuc/leading_edge_offset", registry},
      {"fast/fanuc/stages.cpp", "fast/fanuc/tool_side_compensation", registry},
      {"fast/fanuc/stages.cpp", "fast/fanuc/cutter_compensation", registry},
      {"fast/fanuc/stages.cpp", "fast/fanuc/cutter_compensation_b", registry},
      {"fast/fanuc/stages.cpp", "fast/fanuc/cutter_compensation_c", registry},
      {"fast/fanuc/cutter_compensation", "fast/fanuc/cutter_compensation_b", "B and C have the same words"},
      {"fast/fanuc/cutter_compensation", "fast/fanuc/cutter_compensation_c", "B and C have the same words"},
      {"fast/fanuc/control", "fast/fanuc/tool_offset", offsets},
      {"fast/fanuc/control", "fast/fanuc/tool_length_offset", offsets},
      {"fast/fanuc/control", "fast/fanuc/tool_center_point_control", "how the tool stands is known before any stage"},
      {"fast/fanuc/control", "fast/fanuc/tool_posture_control", "how the tool stands is known before any stage"},
      {"fast/fanuc/interpreter", "fast/fanuc/tool_length_measurement", "no stage: the moves of one block"},
      {"fast/fanuc/interpreter", "fast/fanuc/canned_cycle", "no stage: the holes of one block"},
      {"fast/fanuc/tool_center_point_control", "fast/fanuc/tool_posture_control", "how a block of it turns the tool"},
      {"fast/heidenhain/interpreter", "fast/heidenhain/face_milling", "the order of the rules"},
      {"fast/heidenhain/interpreter", "fast/heidenhain/peripheral_milling", "the order of the rules"},
      {"fast/heidenhain/interpreter", "fast/heidenhain/programmed_contour", "the order of the rules"},
      {"fast/heidenhain/face_milling", "fast/heidenhain/programmed_contour", contour},
  };
  return kKnown;
}

// A section of an engine is known in its own folder and in the places listed, which are all needed; elsewhere a
// stage is known by its interface only. Tests of a section know it.
TEST(Architecture, SectionsAreKnownWhereItIsListed) {
  const std::regex include(R"re(#include "((?:model|fast)/(fanuc|heidenhain)/([a-z_]+))/[a-z_]+\.h")re");
  const std::set<std::string> no_sections{"program", "corner", "passes", "control", "interpreter"};
  std::set<const KnowsSection*> needed;
  for (const std::string room : {"model", "fast", "judge", "fuzz", "corpus", "certify", "cli", "c", "python"})
    for (const fs::path& path : sources(room)) {
      const std::string file = fs::relative(path, kSource).generic_string();
      const std::string folder = fs::relative(path.parent_path(), kSource).generic_string();
      const std::string text = read(path);
      for (auto it = std::sregex_iterator(text.begin(), text.end(), include); it != std::sregex_iterator(); ++it) {
        const std::string section = (*it)[1].str();
        if (section == folder || no_sections.contains((*it)[3].str())) continue;
        const auto known = std::ranges::find_if(known_sections(), [&](const KnowsSection& k) {
          return k.section == section && (k.who == file || k.who == folder);
        });
        const bool listed = known != known_sections().end();
        EXPECT_TRUE(listed) << file << " knows " << section;
        if (listed) needed.insert(&*known);
      }
    }
  for (const KnowsSection& known : known_sections())
    EXPECT_TRUE(needed.contains(&known)) << known.who << " no longer knows " << known.section << ": " << known.why;
}

// A law is worth what its independence is worth: of the model it knows the events and the numbers.
TEST(Architecture, LawsKnowNoEngine) {
  const std::regex include(R"re(#include "([a-z_]+/[^"]*)")re");
  const std::set<std::string> known{"model/basis/event.h", "model/exact/real.h"};
  for (const fs::path& file : sources("judge/laws")) {
    const std::string text = read(file);
    for (auto it = std::sregex_iterator(text.begin(), text.end(), include); it != std::sregex_iterator(); ++it) {
      const std::string name = (*it)[1].str();
      EXPECT_TRUE(known.contains(name) || name.starts_with("judge/laws/") || name.starts_with("spec/language/"))
          << file << " includes " << name;
    }
    EXPECT_EQ(text.find("spec::Clause"), std::string::npos) << file;
    EXPECT_EQ(text.find(".clauses"), std::string::npos) << file;
  }
}

TEST(Architecture, SpecificationOfLanguageDoesNotKnowMeaning) {
  for (const fs::path& file : sources("spec/language"))
    EXPECT_EQ(read(file).find("boost/multiprecision"), std::string::npos) << file << ": syntax does no arithmetic";
}

// A name is syntax, and shared; what a code does is not (spec/language/fanuc/g_codes.h).
TEST(Architecture, GCodesHaveNames) {
  const std::string compared = R"(\b(code|compensation|one_shot|cycle|motion_?)(\([a-zA-Z:]*\))? (==|!=|<=|>=|<|>) )";
  const std::regex number(compared + R"([1-9][0-9]+|has_code\(\{?[0-9][0-9]|\bcase [1-9][0-9][0-9])");
  for (const std::string room : {"model/fanuc", "fast/fanuc", "judge/laws/fanuc"})
    for (const fs::path& file : sources(room)) EXPECT_FALSE(std::regex_search(code_of(read(file)), number)) << file;
}

// Examples and what people feed to toolcomp have none: .reuse/dep5 speaks for them.
TEST(Architecture, EveryFileOfCodeNamesItsLicense) {
  const std::set<std::string> code{".c", ".cc",  ".cmake", ".cpp", ".css", ".gappa",
                                   ".h", ".inc", ".js",    ".py",  ".sh",  ".v"};
  const std::string wanted = "SPDX-License-Identifier: Apache-2.0";
  std::size_t seen = 0;
  for (const char* room : {"adapters",  "c",          "certify", "cli",  "cmake",       "corpus", "docs",
                           "engines",   "fast",       "fuzz",    "host", "judge",       "model",  "oss-fuzz",
                           "packaging", "playground", "python",  "spec", "spec_engine", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kSource / room)) {
      const fs::path& file = entry.path();
      const bool is_code = file.filename() == "CMakeLists.txt" || code.contains(file.extension());
      const auto is_in = [&](const char* folder) { return file.string().find(folder) != std::string::npos; };
      if (!entry.is_regular_file() || !is_code || is_in("/corpus/seeds/") || is_in("/corpus/field/") ||
          is_in("/adapters/examples/"))
        continue;
      ++seen;
      EXPECT_LT(read(file).find(wanted), 100U) << file;
    }
  }
  EXPECT_GT(seen, 1500U);
}

// Nothing in the model passes through double. The one way out is model/exact's enclosure rounded outwards.
TEST(Architecture, ModelHasNoDoubles) {
  const std::regex floating(R"(\b(double|float)\b)");
  // Bounds, rounded outwards, and nearest doubles: for verdicts and for people.
  const std::set<std::string> ways_out{
      "real.h",       "real.cpp",    "interval.h",         "interval.cpp",         "rational.h",
      "rational.cpp", "decimal.cpp", "double_enclosure.h", "double_enclosure.cpp", "double_functions.cpp"};
  for (const fs::path& file : sources("model")) {
    if (file.parent_path().filename() == "exact" && ways_out.contains(file.filename())) continue;
    EXPECT_FALSE(std::regex_search(code_of(read(file)), floating)) << file;
  }
}

// What the oracle makes of a clause or a section stands in the policy, too.
TEST(Architecture, TheOracleNamesClausesInThePolicy) {
  const std::regex clause_or_section(R"(Clause::[a-z]|"(fanuc|heidenhain)[/.])");
  for (const fs::path& file : sources("judge/oracle"))
    if (file.filename() != "policy.h") {
      EXPECT_FALSE(std::regex_search(read(file), clause_or_section)) << file;
    }
}

// Tolerances stand in the one policy table and nowhere else.
TEST(Architecture, NoToleranceOutsideThePolicy) {
  const std::regex small_literal(R"([0-9.]e-[0-9]+|0x1p-)");
  for (const std::string room : {"judge", "fuzz", "certify", "corpus", "cli", "python"}) {
    for (const fs::path& file : sources(room)) {
      if (file.filename() == "policy.h") continue;
      EXPECT_FALSE(std::regex_search(code_of(read(file)), small_literal)) << file;
    }
  }
}

}  // namespace

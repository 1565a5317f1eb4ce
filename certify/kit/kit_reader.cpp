// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "certify/bundle/plain_name.h"
#include "certify/kit/kit_json.h"
#include "certify/kit/marks.h"
#include "spec/language/document.h"
#include "spec/language/input_error.h"
#include "spec/language/parameter.h"
#include "spec/language/setup_format.h"

namespace toolcomp::certify::kit {
namespace {

using spec::document::Kind;
using spec::document::Node;

// Reads one table after another with positions for messages.
class KitReader {
 public:
  explicit KitReader(std::string file) : file_(std::move(file)), read_(file_) {}

  Kit kit(std::string_view json) const {
    const Node root = spec::document::parse_json(json, file_);
    read_.keys(root, "kit",
               {"kit", "dialect", "tool", "corpus", "corpus_hash", "sections", "machine", "travels", "tolerance",
                "rests", "offsets", "groups", "programs", "outcomes", "recorded", "noted", "missing", "files"});
    static_cast<void>(read_.integer(read_.needed(root, "kit"), "kit", 1, 1));
    Kit kit;
    kit.tool = text(root, "tool");
    kit.corpus = text(root, "corpus");
    kit.corpus_hash = text(root, "corpus_hash");
    kit.sections = read_.strings(read_.needed(root, "sections"), "sections");
    kit.offsets_program = file_name(root, "offsets");
    kit.tolerance = read_.decimal(read_.needed(root, "tolerance"), "tolerance");
    kit.outcomes = number(root, "outcomes");
    kit.recorded = number(root, "recorded");
    kit.noted = number(root, "noted");
    kit.machine.setup = spec::read_setup_toml(text(root, "machine"), file_ + " machine");
    for (const Node& item : list(root, "travels")) travel(item, kit.machine);
    for (const Node& item : list(root, "groups")) kit.groups.push_back(group(item));
    for (const Node& item : list(root, "programs")) kit.programs.push_back(program(item, kit.groups.size()));
    for (const Node& item : list(root, "missing"))
      kit.missing.push_back({text(item, "outcome"), text(item, "text"), text(item, "why")});
    files(read_.needed(root, "files"), kit);
    return kit;
  }

 private:
  std::string text(const Node& table, std::string_view key) const {
    return read_.string(read_.needed(table, key), key);
  }
  // A file of the kit: nothing outside its folder is opened.
  std::string file_name(const Node& table, std::string_view key) const {
    expect_file_name(read_.needed(table, key).at, text(table, key));
    return text(table, key);
  }
  void expect_file_name(spec::document::Position at, const std::string& name) const {
    if (!name.empty() && !bundle::is_plain_name(name))
      read_.fail(at, spec::document::in_quotes(name) + " is not a file name that a kit can have");
  }
  std::uint64_t number(const Node& table, std::string_view key) const {
    constexpr std::uint64_t kMost = 1'000'000'000;
    return read_.integer(read_.needed(table, key), key, 0, kMost);
  }
  const std::vector<Node>& list(const Node& table, std::string_view key) const {
    read_.expect(read_.needed(table, key), Kind::array, key);
    return read_.needed(table, key).items;
  }

  void travel(const Node& node, Machine& machine) const {
    try {
      add_travel(machine, read_.string(node, "travels"));
    } catch (const spec::InputError& error) {
      read_.fail(node.at, error.message());
    }
  }

  KitGroup group(const Node& node) const {
    KitGroup group;
    group.program = file_name(node, "program");
    read_.expect(read_.needed(node, "parameters"), Kind::table, "parameters");
    for (const auto& member : read_.needed(node, "parameters").members) {
      const auto id = spec::parse_parameter_id(member.name);
      if (!id) read_.fail(member.at, spec::document::in_quotes(member.name) + " is not a parameter");
      group.parameters[*id] = read_.decimal(member.value, member.name);
    }
    return group;
  }

  KitProgram program(const Node& node, std::size_t groups) const {
    KitProgram program;
    program.number = static_cast<unsigned>(
        read_.integer(read_.needed(node, "number"), "number", kFirstProgram + 1, kFirstProgram + kMostNumber));
    if (groups == 0) read_.fail(node.at, "a program without a group");
    program.group = static_cast<std::size_t>(read_.integer(read_.needed(node, "group"), "group", 0, groups - 1));
    program.file = file_name(node, "file");
    program.setup = file_name(node, "setup");
    if (node.find("alarm") != nullptr) {
      program.alarm = text(node, "alarm");
      program.alarm_n = number(node, "alarm_n");
    } else {
      program.expected = file_name(node, "expected");
      program.marks = marks(node);
    }
    for (const Node& item : list(node, "cases"))
      program.cases.push_back({text(item, "id"),
                               text(item, "section"),
                               text(item, "machine") == "same",
                               {number(item, "first_line"), number(item, "last_line"), number(item, "end_line")},
                               read_.strings(read_.needed(item, "shows"), "shows")});
    return program;
  }

  MarkLines marks(const Node& node) const {
    const std::vector<Node>& lines = list(node, "mark_lines");
    if (lines.size() != 3) read_.fail(read_.needed(node, "mark_lines").at, "mark_lines: expected three lines");
    const auto line = [&](std::size_t i) { return read_.integer(lines[i], "mark_lines", 1, 1'000'000); };
    return {line(0), line(1), line(2)};
  }

  void files(const Node& node, Kit& kit) const {
    read_.expect(node, Kind::table, "files");
    for (const auto& member : node.members) {
      expect_file_name(member.at, member.name);
      kit.files[member.name] = read_.string(member.value, member.name);
    }
    for (const KitProgram& program : kit.programs)
      if (!kit.files.contains(program.file) || !kit.files.contains(program.setup))
        read_.fail(node.at, program.file + " or " + program.setup + " is missing");
  }

  std::string file_;
  spec::document::Reader read_;
};

}  // namespace

Kit read_kit_json(std::string_view text, const std::string& file) { return KitReader(file).kit(text); }

}  // namespace toolcomp::certify::kit

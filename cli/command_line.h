// SPDX-License-Identifier: Apache-2.0
// The command line: verbs with their options, and what help, manual pages and completion are made of.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cli/manners.h"

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace toolcomp::cli {

// An option, or an argument that stands by its place.
struct OptionText {
  std::vector<std::string> names;  // "-q", "--quiet"; of an argument its name alone
  std::string value;               // what it takes: FILE, FOLDER, SECTION, N, "a|b|c", …; empty: nothing, a flag
  std::string text;                // one or two sentences without the last point
  bool argument = false;
  bool required = false;
  bool repeated = false;
  bool common = false;  // every verb has it

  // The long name, or the only one.
  [[nodiscard]] const std::string& name() const { return names.back(); }
};

struct VerbText {
  std::string name;
  std::string about;
  bool listed = true;
  std::vector<OptionText> options;  // arguments first, common ones last
};

// One parser, one action: each verb adds its options, and the call to make.
class CommandLine {
 public:
  CommandLine();
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  // A verb to which options can be added; `action` is called with what the command line gave, and returns the exit
  // status. One that is not listed is for this program alone.
  CLI::App* verb(const std::string& name, const std::string& about, std::function<int()> action);
  CLI::App* unlisted(const std::string& name, const std::string& about, std::function<int()> action);

  // The verbs in the order of their definition.
  [[nodiscard]] std::vector<VerbText> verbs() const;
  // Options before any verb.
  [[nodiscard]] std::vector<OptionText> options() const;

  // The words of the command line, and the same as a shell reads them.
  [[nodiscard]] const std::vector<std::string>& words() const { return words_; }
  [[nodiscard]] std::string typed() const;

  // Reads the words, does what they say, returns the exit status. Throws what verbs throw, and spec::InputError for a
  // verb that there is not.
  int execute(int argc, char** argv);

 private:
  void take_manners(CLI::App* app);
  void expect_verb(const std::string& word) const;
  [[nodiscard]] const CLI::App* called() const;
  int refuse(const CLI::ParseError& error) const;

  std::unique_ptr<CLI::App> app_;
  std::function<int()> action_;
  std::vector<std::string> words_;
  Loudness loudness_ = Loudness::usual;
  Coloring coloring_ = Coloring::automatic;
};

// The verbs, file by file (options_*.cpp).
void define_programs(CommandLine& line);      // run, diff, explain, serve
void define_certificates(CommandLine& line);  // certify, verify, replay, kit
void define_fuzzing(CommandLine& line);       // fuzz, and what a campaign calls
void define_reference(CommandLine& line);     // corpus, spec, config
void define_shell(CommandLine& line);         // completion, manual

}  // namespace toolcomp::cli

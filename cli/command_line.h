// SPDX-License-Identifier: Apache-2.0
// The command line: verbs with their options, declared once with CLI11; help, completion and manual pages are made by
// walking them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cli/manners.h"

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace toolcomp::cli {

// One parser, one action: each verb adds its options, and the call to make.
class CommandLine {
 public:
  CommandLine();
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  // A verb to which options can be added; `action` is called with what the command line gave, and returns the exit
  // status. `about` begins with a line that says what it does, without a point; the lines that follow are paragraphs.
  CLI::App* verb(const std::string& name, const std::string& about, std::function<int()> action);
  // One that has verbs of its own, and one of these.
  CLI::App* family(const std::string& name, const std::string& about);
  CLI::App* verb(CLI::App* family, const std::string& name, const std::string& about, std::function<int()> action);
  // One for this program alone.
  CLI::App* unlisted(const std::string& name, const std::string& about, std::function<int()> action);

  [[nodiscard]] const CLI::App& program() const { return *app_; }

  // The words of the command line, and the same as a shell reads them.
  [[nodiscard]] const std::vector<std::string>& words() const { return words_; }
  [[nodiscard]] std::string typed() const;

  // Reads the words, does what they say, returns the exit status. Throws what verbs throw.
  int execute(int argc, char** argv);

 private:
  void take_manners(CLI::App* app);
  int refuse(const CLI::ParseError& error) const;

  std::unique_ptr<CLI::App> app_;
  std::function<int()> action_;
  std::vector<std::string> words_;
  Loudness loudness_ = Loudness::usual;
  Coloring coloring_ = Coloring::automatic;
};

// The verbs, file by file (options_*.cpp).
void define_programs(CommandLine& line);      // run, diff, explain, view, serve
void define_certificates(CommandLine& line);  // certify, results, verify, replay, kit
void define_fuzzing(CommandLine& line);       // fuzz, and what a campaign calls
void define_reference(CommandLine& line);     // corpus, spec, config
void define_shell(CommandLine& line);         // completion, manual

}  // namespace toolcomp::cli

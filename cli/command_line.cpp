// SPDX-License-Identifier: Apache-2.0
#include "cli/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <iostream>
#include <map>
#include <string_view>
#include <utility>

#include "cli/completion.h"
#include "cli/help.h"
#include "cli/manners.h"
#include "cli/options.h"
#include "cli/verbs.h"
#include "spec/language/printable.h"
#include "spec/language/suggestion.h"

namespace toolcomp::cli {
namespace {

const std::map<std::string, Coloring> kColorings{
    {"auto", Coloring::automatic}, {"always", Coloring::always}, {"never", Coloring::never}};

constexpr const char* kAbout =
    "Exact reference model of CNC tool compensation, and judge of controls\n"
    "toolcomp computes what a numerical control does with a program under tool compensation. It computes exactly, "
    "block by block, by the rules of the control's manual. It also judges controls against these rules.\n"
    "Data goes to standard output, progress and diagnostics go to standard error. A fault in an input is reported as "
    "one line, FILE:LINE:COLUMN: what is wrong and what was expected. Lines and columns count from 1, and columns "
    "count characters.";

constexpr const char* kFooter = R"(Exit status:
  0  Both sides agree, or the command is done.
  1  A difference was found, or a certificate was refused.
  2  Bad usage or bad input: one line on standard error says what.
  3  A result could not be decided, nothing was judged, or a part of the
     program was not judged or is not supported.
  4  A self-check failed: toolcomp itself has an error.
  If several of them apply, the first in the order 4, 2, 1, 3 counts.

Environment:
  NO_COLOR           If it is set and not empty, output has no colors.
  CLICOLOR_FORCE     If it is set and not 0, output always has colors.
  CLICOLOR           If it is 0, output has no colors.
  COLUMNS            Width of the output; otherwise that of the terminal.
  TERM               If it is dumb: no progress, no colors.
  TOOLCOMP_ADAPTERS  Folders of adapters, separated by colons, searched first.
  SOURCE_DATE_EPOCH  Seconds since 1970: the date in reports.

Files:
  setup.toml           In the folder of a program: its setup, without --setup.
  /usr/share/toolcomp  Corpus, adapters, schemas and files for editors.

Examples:
  Write a setup to start from:
    $ toolcomp config example > setup.toml
  Run a program:
    $ toolcomp run part.nc --setup setup.toml
  List the sections and their rules:
    $ toolcomp spec sections)";

// Without any word.
constexpr const char* kFirstSteps =
    "usage: toolcomp VERB [ARGUMENT…]\n"
    "\n"
    "  toolcomp config example > setup.toml      write a setup to start from\n"
    "  toolcomp run PART.nc --setup setup.toml   run a program exactly\n"
    "  toolcomp explain PART.nc                  explain the result, block by block\n"
    "  toolcomp certify --controller COMMAND     judge a control\n"
    "\n"
    "`toolcomp --help` lists the verbs, `toolcomp VERB --help` describes one.\n";

CLI::App* add(CLI::App* of, const std::string& name, const std::string& about) {
  return of->add_subcommand(name, about)->group("Verbs");
}

// What is wrong with a word that is neither an option nor a verb, or with none.
std::string why_no_verb(const std::string& word, const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* verb : listed_verbs(app)) names.push_back(verb->get_name());
  const std::string meant = spec::did_you_mean(word, names);
  return (word.empty() ? "a verb is missing" : "no verb \"" + word + '"') +
         (meant.empty() ? "; expected one of " + CLI::detail::join(names, ", ") : meant);
}

std::string why_no_option(const std::string& word, const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : names_of(*option)) names.push_back(name);
  return "no option " + word + spec::did_you_mean(word, names);
}

}  // namespace

CommandLine::CommandLine() : app_(std::make_unique<CLI::App>(kAbout, "toolcomp")) {
  app_->require_subcommand(1);
  app_->formatter(std::make_shared<Help>(columns_of(Stream::out)));
  define_programs(*this);
  define_certificates(*this);
  define_fuzzing(*this);
  define_reference(*this);
  define_shell(*this);
  app_->footer(kFooter);
  app_->set_version_flag("-V,--version", "toolcomp " TOOLCOMP_VERSION, "Print the version")->group(kCommonOptions);
  take_manners(app_.get());
}

CommandLine::~CommandLine() = default;

// Last, and of every verb. Where a program is started once more, the later word counts.
void CommandLine::take_manners(CLI::App* app) {
  app->add_flag_callback(
         "-q,--quiet", [this] { loudness_ = Loudness::quiet; },
         "No progress and no notes on standard error; errors and data are still written")
      ->group(kCommonOptions);
  app->add_flag_callback(
         "-v,--verbose", [this] { loudness_ = Loudness::verbose; },
         "Write the files read, the engine, the seed and the time spent to standard error")
      ->group(kCommonOptions);
  choose(app, "--color", coloring_, kColorings,
         "Use colors: auto means on a terminal only (default: auto; NO_COLOR and CLICOLOR_FORCE are respected)")
      ->group(kCommonOptions);
  app->set_help_flag("-h,--help", "Print this help")->group(kCommonOptions);
  for (CLI::App* verb : app->get_subcommands({})) take_manners(verb);
}

CLI::App* CommandLine::verb(const std::string& name, const std::string& about, std::function<int()> action) {
  return verb(app_.get(), name, about, std::move(action));
}

CLI::App* CommandLine::family(const std::string& name, const std::string& about) {
  return add(app_.get(), name, about)->require_subcommand(1);
}

CLI::App* CommandLine::verb(CLI::App* family, const std::string& name, const std::string& about,
                            std::function<int()> action) {
  return add(family, name, about)->callback([this, action = std::move(action)] { action_ = action; });
}

CLI::App* CommandLine::unlisted(const std::string& name, const std::string& about, std::function<int()> action) {
  return verb(name, about, std::move(action))->group("");
}

std::string CommandLine::typed() const {
  constexpr std::string_view kUnquoted = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789+,-./:=@_";
  std::string line = "toolcomp";
  for (std::size_t i = 1; i < words_.size(); ++i) {
    const std::string& word = words_[i];
    line += ' ';
    if (!word.empty() && word.find_first_not_of(kUnquoted) == std::string::npos) {
      line += word;
      continue;
    }
    line += '\'';
    for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += '\'';
  }
  return line;
}

// One line that says what is wrong with the verb that was read, or with the program itself.
int CommandLine::refuse(const CLI::ParseError& error) const {
  const CLI::App* app = app_.get();
  std::string name = app->get_name();
  while (app->remaining().empty() && !app->get_subcommands().empty()) {
    app = app->get_subcommands().front();
    name += ' ' + app->get_name();
  }
  const bool has_verbs = !listed_verbs(*app).empty();
  std::string what = has_verbs ? why_no_verb("", *app) : error.what();
  // Whatever else is missing: a word that is not known is what went wrong first.
  for (const std::string& word : app->remaining()) {
    const bool option = word.size() > 1 && word.front() == '-';
    if (!option && !has_verbs) continue;
    what = option ? why_no_option(word.substr(0, word.find('=')), *app) : why_no_verb(word, *app);
    break;
  }
  const std::string more = what.ends_with('?') ? "" : "; `" + name + " --help` gives more";
  std::cerr << painted_diagnostic(spec::printable(name + ": " + what + more, 2000)) << '\n';
  return kBadInput;
}

int CommandLine::execute(int argc, char** argv) {
  words_.assign(argv, argv + argc);
  std::vector<std::string> words(words_.begin() + 1, words_.end());
  if (words.empty()) {
    std::cerr << kFirstSteps;
    return kBadInput;
  }
  // `toolcomp help run`, as other commands have it.
  if (words.front() == "help") {
    words.erase(words.begin());
    words.emplace_back("--help");
  }
  // What a completion script asks: any words, finished or not.
  if (words.front() == "complete") {
    std::cout << completions(*app_, {words.begin() + 1, words.end()});
    return kAgrees;
  }
  try {
    std::ranges::reverse(words);
    app_->parse(words);
  } catch (const CLI::CallForHelp&) {
    std::cout << app_->help();
    return kAgrees;
  } catch (const CLI::CallForVersion& version) {
    std::cout << version.what() << '\n';
    return kAgrees;
  } catch (const CLI::ParseError& error) {
    return refuse(error);
  }
  set_manners({loudness_, coloring_});
  const auto begun = std::chrono::steady_clock::now();
  const int status = action_();
  if (is_verbose()) {
    std::cout.flush();
    detail(fmt::format("{:.2f} s", std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count()));
  }
  return status;
}

}  // namespace toolcomp::cli

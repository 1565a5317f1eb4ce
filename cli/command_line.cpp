// SPDX-License-Identifier: Apache-2.0
#include "cli/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <iostream>
#include <iterator>
#include <map>
#include <utility>

#include "cli/completion.h"
#include "cli/help.h"
#include "cli/manners.h"
#include "cli/options.h"
#include "cli/verbs.h"
#include "spec/language/input_error.h"
#include "spec/language/suggestion.h"

namespace toolcomp::cli {
namespace {

const std::string kCommon = "Common";

const std::map<std::string, Coloring> kColorings{
    {"auto", Coloring::automatic}, {"always", Coloring::always}, {"never", Coloring::never}};

OptionText text_of(const CLI::Option& option) {
  OptionText text;
  for (const std::string& name : option.get_snames()) text.names.push_back('-' + name);
  for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
  text.argument = option.get_positional();
  if (text.argument) text.names = {option.get_name(true, false)};
  if (option.get_type_size() != 0 && option.get_items_expected_max() > 0) text.value = option.get_type_name();
  text.text = option.get_description();
  if (const std::string& usual = option.get_default_str(); !usual.empty()) text.text += " (default: " + usual + ')';
  text.required = option.get_required();
  text.repeated = option.get_expected_max() > 1;
  text.common = option.get_group() == kCommon;
  return text;
}

// Arguments, options, common options; each in the order of their definitions.
std::vector<OptionText> options_of(const CLI::App& app) {
  std::vector<OptionText> arguments, options, common;
  for (const CLI::Option* option : app.get_options([](const CLI::Option* o) { return !o->get_group().empty(); })) {
    OptionText text = text_of(*option);
    (text.argument ? arguments : text.common ? common : options).push_back(std::move(text));
  }
  std::ranges::move(options, std::back_inserter(arguments));
  std::ranges::move(common, std::back_inserter(arguments));
  return arguments;
}

}  // namespace

CommandLine::CommandLine() : app_(std::make_unique<CLI::App>("", "toolcomp")) {
  app_->require_subcommand(1);
  app_->set_version_flag("-V,--version", "toolcomp " TOOLCOMP_VERSION, "Print the version")->group(kCommon);
  take_manners(app_.get());
  define_programs(*this);
  define_certificates(*this);
  define_fuzzing(*this);
  define_reference(*this);
  define_shell(*this);
}

CommandLine::~CommandLine() = default;

// Where a program is started once more, the later word counts.
void CommandLine::take_manners(CLI::App* app) {
  app->add_flag_callback(
         "-q,--quiet", [this] { loudness_ = Loudness::quiet; },
         "No progress and no notes on standard error; errors and data stay")
      ->group(kCommon);
  app->add_flag_callback(
         "-v,--verbose", [this] { loudness_ = Loudness::verbose; },
         "Say what is read, engine, seed and time spent, on standard error")
      ->group(kCommon);
  choose(app, "--color", coloring_, kColorings,
         "When output has colors (default: auto, on a terminal; NO_COLOR and CLICOLOR_FORCE are honoured)")
      ->group(kCommon);
  app->set_help_flag("-h,--help", "Print this help")->group(kCommon);
}

CLI::App* CommandLine::verb(const std::string& name, const std::string& about, std::function<int()> action) {
  CLI::App* sub = unlisted(name, about, std::move(action));
  sub->group("Verbs");
  return sub;
}

CLI::App* CommandLine::unlisted(const std::string& name, const std::string& about, std::function<int()> action) {
  CLI::App* sub = app_->add_subcommand(name, about);
  take_manners(sub);
  sub->callback([this, action = std::move(action)] { action_ = action; });
  return sub->group("");
}

std::vector<VerbText> CommandLine::verbs() const {
  std::vector<VerbText> list;
  for (const CLI::App* sub : app_->get_subcommands({}))
    list.push_back({sub->get_name(), sub->get_description(), !sub->get_group().empty(), options_of(*sub)});
  return list;
}

std::vector<OptionText> CommandLine::options() const { return options_of(*app_); }

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

void CommandLine::expect_verb(const std::string& word) const {
  std::vector<std::string> names;
  for (const CLI::App* sub : app_->get_subcommands({})) {
    if (sub->get_name() == word) return;
    if (!sub->get_group().empty()) names.push_back(sub->get_name());
  }
  std::string meant = spec::did_you_mean(word, names);
  if (meant.empty())
    for (const std::string& name : names) meant += (meant.empty() ? "; there are " : ", ") + name;
  throw spec::InputError("toolcomp", 0, 0, "no verb \"" + word + '"' + meant);
}

// The verb that was read, or the program itself.
const CLI::App* CommandLine::called() const {
  const auto subs = app_->get_subcommands();
  return subs.empty() ? app_.get() : subs.front();
}

// One line that says what is wrong.
int CommandLine::refuse(const CLI::ParseError& error) const {
  const CLI::App* const verb = called();
  const std::string name = verb == app_.get() ? "toolcomp" : "toolcomp " + verb->get_name();
  std::string what = error.what();
  // Whatever else is missing: a word that is no option is what went wrong first.
  for (const std::string& word : verb->remaining()) {
    if (word.size() < 2 || word.front() != '-') continue;
    const std::string given = word.substr(0, word.find('='));
    std::vector<std::string> names;
    for (const OptionText& option : options_of(*verb))
      if (!option.argument) names.insert(names.end(), option.names.begin(), option.names.end());
    what = "no option " + given + spec::did_you_mean(given, names);
    break;
  }
  const std::string more = what.ends_with('?') ? "" : "; `" + name + " --help` says more";
  std::cerr << painted_diagnostic(name + ": " + what + more) << '\n';
  return kBadInput;
}

int CommandLine::execute(int argc, char** argv) {
  words_.assign(argv, argv + argc);
  std::vector<std::string> words(words_.begin() + 1, words_.end());
  if (words.empty()) {
    std::cerr << first_steps();
    return kBadInput;
  }
  // `toolcomp help run`, as other commands have it.
  if (words.front() == "help") {
    words.erase(words.begin());
    words.emplace_back("--help");
  }
  // What a completion script asks: any words, finished or not.
  if (words.front() == "complete") {
    std::cout << completions(*this, {words.begin() + 1, words.end()});
    return kAgrees;
  }
  if (!words.front().starts_with('-')) expect_verb(words.front());
  try {
    std::ranges::reverse(words);
    app_->parse(words);
  } catch (const CLI::CallForHelp&) {
    const CLI::App* const verb = called();
    const std::size_t columns = columns_of(Stream::out);
    if (verb == app_.get())
      std::cout << help(verbs(), options(), columns);
    else
      std::cout << help({verb->get_name(), verb->get_description(), true, options_of(*verb)}, columns);
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

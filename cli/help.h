// SPDX-License-Identifier: Apache-2.0
// What verbs and options are called and what is said of them: for --help, completion and manual pages.
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace toolcomp::cli {

// The group of the options that every verb has.
inline constexpr const char* kCommonOptions = "Common options";

// The verbs of the program, or of a verb, without those for this program alone; in the order of their definition.
std::vector<const CLI::App*> listed_verbs(const CLI::App& app);
// What it does, in one line without a point; and the paragraphs that follow.
std::string summary_of(const CLI::App& app);
std::vector<std::string> paragraphs_of(const CLI::App& app);
// "toolcomp run program [OPTION…]"; `name` is all that is typed up to here.
std::string usage_of(const CLI::App& app, const std::string& name);

// The arguments, which stand by their place, and the options that are listed.
std::vector<const CLI::Option*> arguments_of(const CLI::App& app);
std::vector<const CLI::Option*> options_of(const CLI::App& app);
// "-q", "--quiet"; of an argument none.
std::vector<std::string> names_of(const CLI::Option& option);
bool takes_value(const CLI::Option& option);
bool is_repeated(const CLI::Option& option);
// "-q, --quiet", "--engine fast|model"; of an argument its name.
std::string form_of(const CLI::Option& option);
// What it is, without the last point.
std::string text_of(const CLI::Option& option);

// CLI11's help, in lines as wide as the terminal.
class Help : public CLI::Formatter {
 public:
  explicit Help(std::size_t columns);

  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
  std::string make_description(const CLI::App* app) const override;
  std::string make_usage(const CLI::App* app, std::string name) const override;
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_subcommand(const CLI::App* sub) const override;

 private:
  [[nodiscard]] std::string entry(std::string_view name, std::string_view text) const;

  std::size_t columns_;
};

}  // namespace toolcomp::cli

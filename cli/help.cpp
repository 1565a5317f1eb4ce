// SPDX-License-Identifier: Apache-2.0
#include "cli/help.h"

#include <algorithm>

namespace toolcomp::cli {
namespace {

constexpr std::size_t kNarrowest = 40;
constexpr std::size_t kWidest = 100;
constexpr std::size_t kIndent = 2;
constexpr std::size_t kTexts = 28;  // where texts begin

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

// The words of a text in lines of so many columns; the first line goes on at `column`.
std::string wrapped(std::string_view text, std::size_t column, std::size_t indent, std::size_t columns) {
  std::string out;
  bool first = true;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(text.size(), end + 1));
    const std::size_t size = characters(word);
    if (!first && column + 1 + size > columns) {
      out.append(1, '\n').append(indent, ' ');
      column = indent;
      first = true;
    }
    if (!first) out += ' ';
    out += word;
    column += size + (first ? 0 : 1);
    first = false;
  }
  return out + '\n';
}

}  // namespace

std::vector<const CLI::App*> listed_verbs(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* verb) { return !verb->get_group().empty(); });
}

std::string summary_of(const CLI::App& app) {
  return app.get_description().substr(0, app.get_description().find('\n'));
}

std::vector<std::string> paragraphs_of(const CLI::App& app) {
  std::vector<std::string> list = CLI::detail::split(app.get_description(), '\n');
  list.erase(list.begin());
  return list;
}

std::string usage_of(const CLI::App& app, const std::string& name) {
  std::string text = name;
  for (const CLI::Option* argument : arguments_of(app))
    text += ' ' + (argument->get_required() ? form_of(*argument) : '[' + form_of(*argument) + ']');
  for (const CLI::Option* option : options_of(app))
    if (option->get_required()) text += ' ' + names_of(*option).back() + ' ' + option->get_type_name();
  return text + (listed_verbs(app).empty() ? "" : " VERB [ARGUMENT…]") + " [OPTION…]";
}

std::vector<const CLI::Option*> arguments_of(const CLI::App& app) {
  return app.get_options([](const CLI::Option* option) { return option->get_positional(); });
}

std::vector<const CLI::Option*> options_of(const CLI::App& app) {
  return app.get_options(
      [](const CLI::Option* option) { return !option->get_positional() && !option->get_group().empty(); });
}

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back('-' + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

bool takes_value(const CLI::Option& option) {
  return option.get_type_size() != 0 && option.get_items_expected_max() > 0;
}

bool is_repeated(const CLI::Option& option) { return option.get_expected_max() > 1; }

std::string form_of(const CLI::Option& option) {
  if (option.get_positional()) return option.get_name(true, false) + (is_repeated(option) ? "…" : "");
  return CLI::detail::join(names_of(option), ", ") + (takes_value(option) ? ' ' + option.get_type_name() : "");
}

std::string text_of(const CLI::Option& option) {
  const std::string usual = option.get_default_str();
  return option.get_description() + (usual.empty() ? "" : " (default: " + usual + ')');
}

Help::Help(std::size_t columns) : columns_(std::clamp(columns, kNarrowest, kWidest)) {
  label("Positionals", "Arguments");
}

std::string Help::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  std::string text = make_description(app) + '\n' + make_usage(app, std::move(name)) + make_positionals(app) +
                     make_subcommands(app, mode) + make_groups(app, mode);
  if (!app->get_footer().empty()) text += '\n' + make_footer(app);
  return CLI::detail::find_and_replace(text, "\n\n\n", "\n\n");
}

std::string Help::make_description(const CLI::App* app) const {
  std::string text = wrapped(summary_of(*app) + '.', 0, 0, columns_);
  for (const std::string& paragraph : paragraphs_of(*app)) text += '\n' + wrapped(paragraph, 0, 0, columns_);
  return text;
}

std::string Help::make_usage(const CLI::App* app, std::string name) const {
  constexpr std::string_view kUsage = "Usage: ";
  return std::string(kUsage) + wrapped(usage_of(*app, name), kUsage.size(), kUsage.size() + kIndent, columns_);
}

std::string Help::make_option(const CLI::Option* option, bool /*is_positional*/) const {
  return entry(form_of(*option), text_of(*option));
}

std::string Help::make_subcommand(const CLI::App* sub) const { return entry(sub->get_name(), summary_of(*sub)); }

std::string Help::entry(std::string_view name, std::string_view text) const {
  // Little room: texts below names.
  const std::size_t texts = columns_ < 2 * kTexts ? 2 * kIndent : kTexts;
  std::string out = std::string(kIndent, ' ').append(name);
  std::size_t column = kIndent + characters(name);
  if (column + 2 > texts) {
    out += '\n';
    column = 0;
  }
  return out.append(texts - column, ' ') + wrapped(text, texts, texts, columns_);
}

}  // namespace toolcomp::cli

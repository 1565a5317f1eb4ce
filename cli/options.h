// SPDX-License-Identifier: Apache-2.0
// How verbs name their options: what each takes is a word, which help, manual pages and completion read.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace toolcomp::cli {

template <class Value>
inline constexpr bool kIsList = false;
template <class Value>
inline constexpr bool kIsList<std::vector<Value>> = true;

// An option (or an argument, without hyphens) that takes what `word` says: FILE, FOLDER, SECTION, N, … One that may be
// given several times takes one value each time.
template <class Value>
CLI::Option* take(CLI::App* sub, const std::string& name, Value& value, const std::string& word,
                  const std::string& text) {
  CLI::Option* const option = sub->add_option(name, value, text)->type_name(word);
  if (kIsList<Value> && name.starts_with('-')) option->allow_extra_args(false);
  return option;
}

// One that takes a number from `least` to `most`.
template <class Value, class Bound>
CLI::Option* take(CLI::App* sub, const std::string& name, Value& value, const std::string& word,
                  const std::string& text, Bound least, Bound most) {
  return take(sub, name, value, word, text + " (" + std::to_string(least) + " to " + std::to_string(most) + ')')
      ->check(CLI::Range(least, most).description(""));
}

// Empty where the word is one of the names; otherwise what is wrong, and which may be meant.
std::string why_not_one_of(const std::string& word, const std::vector<std::string>& names);

// Must be one of the names; what it takes is "a|b|c".
CLI::Option* one_of(CLI::Option* option, const std::vector<std::string>& names);

// An option that takes a name of the map, given on as its value. The map must outlive it.
template <class Value, class Named>
CLI::Option* choose(CLI::App* sub, const std::string& name, Value& value, const std::map<std::string, Named>& names,
                    const std::string& text) {
  std::string word;
  for (const auto& [known, named] : names) word += (word.empty() ? "" : "|") + known;
  return sub->add_option(name, value, text)
      ->type_name(word)
      ->transform(CLI::Validator(
          [&names](std::string& given) {
            std::vector<std::string> known;
            known.reserve(names.size());
            for (const auto& [other, named] : names) known.push_back(other);
            if (std::string why = why_not_one_of(given, known); !why.empty()) return why;
            given = std::to_string(static_cast<int>(names.at(given)));
            return std::string();
          },
          ""));
}

// One that takes one of the names.
inline CLI::Option* choose(CLI::App* sub, const std::string& name, std::string& value,
                           const std::vector<std::string>& names, const std::string& text) {
  return one_of(sub->add_option(name, value, text), names);
}

// What several verbs take.
void take_program(CLI::App* sub, std::string& program, std::string& setup);
void take_samples(CLI::App* sub, std::optional<std::uint32_t>& samples);
void take_sections(CLI::App* sub, std::vector<std::string>& sections);
void take_accept_resolution(CLI::App* sub, std::string& resolution);
void take_timeout(CLI::App* sub, double& seconds, const std::string& text);

}  // namespace toolcomp::cli

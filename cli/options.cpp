// SPDX-License-Identifier: Apache-2.0
#include "cli/options.h"

#include <algorithm>

#include "fuzz/gen/generator.h"
#include "spec/language/case.h"
#include "spec/language/decimal.h"
#include "spec/language/suggestion.h"

namespace toolcomp::cli {

std::string why_not_one_of(const std::string& word, const std::vector<std::string>& names) {
  if (std::ranges::find(names, word) != names.end()) return "";
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  const std::string meant = spec::did_you_mean(word, names);
  return '"' + word + "\" is none of " + all + meant;
}

CLI::Option* one_of(CLI::Option* option, const std::vector<std::string>& names) {
  std::string word;
  for (const std::string& name : names) word += (word.empty() ? "" : "|") + name;
  return option->type_name(word)->check([names](const std::string& text) { return why_not_one_of(text, names); });
}

void take_program(CLI::App* sub, std::string& program, std::string& setup) {
  take(sub, "program", program, "PROGRAM", "Case (JSON) or program; - reads standard input")->required();
  take(sub, "--setup", setup, "SETUP", "Setup (TOML or JSON); without it, setup.toml beside the program");
}

void take_samples(CLI::App* sub, std::optional<std::uint32_t>& samples) {
  take(sub, "--samples", samples, "N",
       "Divide each block under tool center point control into N parts, and give a sample wherever two parts meet", 0U,
       spec::kMostSamples);
}

void take_sections(CLI::App* sub, std::vector<std::string>& sections) {
  take(sub, "--section", sections, "SECTION", "Section, e.g. fanuc/leading-edge-offset (repeatable; default: all)")
      ->check([](const std::string& section) {
        if (std::ranges::find(fuzz::sections(), section) != fuzz::sections().end()) return std::string();
        const std::string meant = spec::did_you_mean(section, fuzz::sections());
        return "no section \"" + section + '"' + (meant.empty() ? "; `toolcomp spec sections` lists them" : meant);
      });
}

void take_accept_resolution(CLI::App* sub, std::string& resolution) {
  take(sub, "--accept-resolution", resolution, "LENGTH",
       "Also judge a controller that announces a resolution coarser than 0.01 mm (0.0004 inch), up to this length")
      ->check([](const std::string& text) {
        const auto value = spec::parse_decimal(text);
        return value && !value->negative && !value->is_zero() ? "" : "\"" + text + "\" is no positive decimal";
      });
}

void take_timeout(CLI::App* sub, double& seconds, const std::string& text) {
  take(sub, "--timeout", seconds, "SECONDS", text)->check(CLI::PositiveNumber.description(""));
}

}  // namespace toolcomp::cli

// SPDX-License-Identifier: Apache-2.0
// What the manual page of a verb says besides its options.
#pragma once

#include <string_view>
#include <vector>

namespace toolcomp::cli {

struct ExampleText {
  std::string_view text;     // what it does
  std::string_view command;  // as it is typed; a test runs it
};

struct NamedText {
  std::string_view name;
  std::string_view text;
};

struct ManualText {
  std::string_view verb;
  std::vector<std::string_view> description;  // paragraphs
  std::vector<ExampleText> examples;          // in the order in which they can be run, in one folder
  std::vector<NamedText> files;
  std::vector<std::string_view> see_also;  // other verbs
};

// That of a verb; of "" that of the program.
const ManualText& manual_text(std::string_view verb);

// Environment variables that the command reads.
const std::vector<NamedText>& environment_texts();

}  // namespace toolcomp::cli

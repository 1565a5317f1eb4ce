// SPDX-License-Identifier: Apache-2.0
// What --help prints, as wide as the terminal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command_line.h"

namespace toolcomp::cli {

// Without any word: what to do next, in a few lines.
std::string first_steps();

// Of the program, and of a verb.
std::string help(const std::vector<VerbText>& verbs, const std::vector<OptionText>& options, std::size_t columns);
std::string help(const VerbText& verb, std::size_t columns);

// "toolcomp run PROGRAM [OPTION…]"
std::string usage(const VerbText& verb);
// "-q, --quiet", "--engine fast|model"; of an argument its name.
std::string usage(const OptionText& option);

// One line a verb of what the exit status means.
struct StatusText {
  int status;
  std::string_view text;
};
inline constexpr StatusText kStatusTexts[] = {
    // NOLINT(*-avoid-c-arrays)
    {0, "It agrees, or it is done."},
    {1, "A difference was found, or a certificate was refused."},
    {2, "Bad usage or bad input: one line FILE:LINE:COLUMN: on standard error says what."},
    {3, "It could not be decided, or nothing was judged."},
    {4, "A self-check failed: an error of this program."},
};

}  // namespace toolcomp::cli

// SPDX-License-Identifier: Apache-2.0
// Completion on the command line: scripts of shells, and the answers they ask for.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace toolcomp::cli {

// The script of "bash", "zsh" or "fish". It asks `toolcomp complete WORD…` at every word.
std::string_view completion_script(std::string_view shell);

// What may stand for the last of these words, which follow `toolcomp`: lines of a word, a tab and what it is; or
// ":files", ":folders" where names of files or folders may. Of "--option=wo" the words are those behind "=".
std::string completions(const CLI::App& program, std::vector<std::string> words);

}  // namespace toolcomp::cli

// SPDX-License-Identifier: Apache-2.0
// Verbs for a shell and for the build: completion, and the making of manual pages.
#include <iostream>
#include <memory>
#include <string>

#include "cli/command_line.h"
#include "cli/completion.h"
#include "cli/manual.h"
#include "cli/options.h"
#include "cli/verbs.h"

namespace toolcomp::cli {
namespace {

void define_completion(CommandLine& line) {
  const auto shell = std::make_shared<std::string>();
  CLI::App* sub = line.verb(
      "completion",
      "Print the completion script of a shell\n"
      "The script completes verbs, options, their values, sections, clauses, adapters and files. An installed command "
      "has its scripts where shells look for them.",
      [shell] {
        std::cout << completion_script(*shell);
        return kAgrees;
      });
  sub->footer(R"(Examples:
  For this shell:
    $ toolcomp completion bash > completion.bash && . ./completion.bash)");
  choose(sub, "shell", *shell, {"bash", "zsh", "fish"}, "bash, zsh or fish")->required();
}

void define_manual(CommandLine& line) {
  struct Wanted {
    std::string date;
    std::string folder;
  };
  const auto wanted = std::make_shared<Wanted>();
  CLI::App* sub = line.unlisted("manual", "Write the manual pages", [wanted, &line] {
    write_manual(line.program(), wanted->date, wanted->folder);
    return kAgrees;
  });
  take(sub, "folder", wanted->folder, "FOLDER", "Folder to write to")->required();
  take(sub, "--date", wanted->date, "DATE", "Date on the pages, as 2026-01-31")->required();
}

}  // namespace

void define_shell(CommandLine& line) {
  define_completion(line);
  define_manual(line);
}

}  // namespace toolcomp::cli

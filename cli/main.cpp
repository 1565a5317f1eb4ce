// SPDX-License-Identifier: Apache-2.0
// The toolcomp command: calls a verb, turns errors into exit statuses.
#include <csignal>
#include <exception>
#include <iostream>
#include <string>

#include "cli/command_line.h"
#include "cli/manners.h"
#include "cli/shown_place.h"
#include "cli/stop.h"
#include "cli/verbs.h"
#include "spec/language/input_error.h"

int main(int argc, char** argv) {
  namespace cli = toolcomp::cli;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) static_cast<void>(std::signal(signal, cli::on_signal));
  try {
    cli::CommandLine command_line;
    return command_line.execute(argc, argv);
  } catch (const toolcomp::spec::InputError& error) {
    std::cout.flush();
    std::cerr << cli::painted_diagnostic(cli::in_characters(error).what()) << '\n';
    return cli::kBadInput;
  } catch (const std::exception& error) {
    std::cout.flush();
    std::cerr << "toolcomp: internal error: " << error.what() << '\n';
    return cli::kSelfCheckFailed;
  }
}

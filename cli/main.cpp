// SPDX-License-Identifier: Apache-2.0
// The toolcomp command: calls a verb, turns errors into exit statuses.
#include <malloc.h>

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
  // What a run of the model gives back is kept for the next one. Asked of the system anew, it costs a sixth of the time
  // of many short programs.
  mallopt(M_MMAP_THRESHOLD, 1 << 25);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
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

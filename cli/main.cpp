// SPDX-License-Identifier: Apache-2.0
// The toolcomp command: calls a verb, turns errors into exit statuses.
#include <malloc.h>

#include <csignal>
#include <exception>
#include <iostream>
#include <new>
#include <string>

#include "cli/command_line.h"
#include "cli/manners.h"
#include "cli/output.h"
#include "cli/shown_place.h"
#include "cli/stop.h"
#include "cli/verbs.h"
#include "spec/language/input_error.h"
#include "spec/language/printable.h"

int main(int argc, char** argv) {
  namespace cli = toolcomp::cli;
  // What a run of the model gives back is kept for the next one. Asked of the system anew, it costs a sixth of the time
  // of many short programs.
  mallopt(M_MMAP_THRESHOLD, 1 << 25);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  cli::keep_standard_streams();
  // Beyond the limit of a file's size a write fails, and says so.
  static_cast<void>(std::signal(SIGXFSZ, SIG_IGN));
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) static_cast<void>(std::signal(signal, cli::on_signal));
  try {
    cli::CommandLine command_line;
    const int status = command_line.execute(argc, argv);
    cli::check_output();
    return status;
  } catch (const toolcomp::spec::InputError& error) {
    std::cout.flush();
    std::cerr << cli::painted_diagnostic(cli::in_characters(error).what()) << '\n';
    return cli::kBadInput;
  } catch (const std::bad_alloc&) {
    std::cerr << "toolcomp: not enough memory for this input\n";
    return cli::kBadInput;
  } catch (const std::exception& error) {
    // What formats text throws where it cannot be written.
    if (cli::output_lost()) {
      std::cerr << "standard output: cannot be written\n";
      return cli::kBadInput;
    }
    std::cout.flush();
    std::cerr << "toolcomp: internal error: " << toolcomp::spec::printable(error.what()) << '\n';
    return cli::kSelfCheckFailed;
  }
}

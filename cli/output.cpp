// SPDX-License-Identifier: Apache-2.0
#include "cli/output.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <system_error>

#include "cli/verbs.h"
#include "spec/language/input_error.h"

namespace toolcomp::cli {

void keep_standard_streams() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(descriptor, F_GETFD) == -1) static_cast<void>(::open("/dev/null", O_RDONLY));
}

bool output_lost() { return !std::cout || std::ferror(stdout) != 0; }

void check_output() {
  errno = 0;
  std::cout.flush();
  const bool arrived = std::fflush(stdout) == 0;
  const int why = errno;
  if (arrived && !output_lost()) return;
  if (why == EPIPE) std::_Exit(kBadInput);
  throw spec::InputError("standard output", 0, 0,
                         "cannot be written" + (why == 0 ? "" : ": " + std::generic_category().message(why)));
}

}  // namespace toolcomp::cli

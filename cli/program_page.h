// SPDX-License-Identifier: Apache-2.0
// The page of a program, from its files: what `view` writes and serves, and `run --format html` prints.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/program.h"
#include "cli/verbs.h"

namespace toolcomp::cli {

struct ProgramAlarm {
  Place place;
  std::string number;
  std::string message;
};

struct ProgramPage {
  std::string html;
  bool undecided = false;            // an event was left undecided
  std::vector<ProgramAlarm> alarms;  // in the order of the run
  std::vector<std::string> called_files;
};

// The alarms on standard error, as `run` reports them.
void report_alarms(const ProgramPage& page);

// `live`: certify::PageOptions::live. `with_fast`: the path of the fast engine is drawn beside the exact one.
// `on_block` is called before each block and may throw. Throws spec::InputError for what cannot be read.
ProgramPage program_page(const ViewOptions& options, const std::string& live, bool with_fast,
                         const std::function<void()>& on_block);

// The setup that counts, as a user knows it; empty for a case.
std::string setup_of(const ViewOptions& options);

}  // namespace toolcomp::cli

// SPDX-License-Identifier: Apache-2.0
// The page of `toolcomp view`: a program to step through, with its blocks next to the drawing.
#pragma once

#include <string>

#include "certify/path_svg.h"
#include "certify/view/program_data.h"
#include "spec/language/case.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify {

// The names at the head of the page, and whether it is served.
struct ProgramPageNames {
  std::string program;  // as the user gave it
  std::string setup;    // empty: the setup of the case
  std::string live;     // PageOptions::live
};

// One self-contained HTML page. `drawing`: its start, unit and tool; `other` in it is drawn next to the exact path.
std::string program_page(const spec::Case& c, const ProgramView& view, const PathOptions& drawing,
                         const ProgramPageNames& names);

// The page that is shown if the program or its setup cannot be read: the fault, and its line.
std::string fault_page(const spec::InputError& fault, const ProgramPageNames& names);

// The page that is shown until the first real page is ready.
std::string waiting_page(const ProgramPageNames& names);

}  // namespace toolcomp::certify

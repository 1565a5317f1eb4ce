// SPDX-License-Identifier: Apache-2.0
// The page of `toolcomp view`: a program to step through, its blocks beside the drawing.
#pragma once

#include <string>

#include "certify/path_svg.h"
#include "certify/view/program_data.h"
#include "spec/language/case.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify {

// What stands at its head, and whether it is served.
struct ProgramPageNames {
  std::string program;  // as the user knows it
  std::string setup;    // empty: the case's own
  std::string live;     // PageOptions::live
};

// One self-contained HTML page. `drawing`: its start, unit and tool; `other` there is drawn beside the exact path.
std::string program_page(const spec::Case& c, const ProgramView& view, const PathOptions& drawing,
                         const ProgramPageNames& names);

// In its place where the program or its setup cannot be read: the fault, and the line it is in.
std::string fault_page(const spec::InputError& fault, const ProgramPageNames& names);

// In its place until it is made for the first time.
std::string waiting_page(const ProgramPageNames& names);

}  // namespace toolcomp::certify

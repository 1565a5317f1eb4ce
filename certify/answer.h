// SPDX-License-Identifier: Apache-2.0
// What a controller is asked, and what its answer says: lines of the protocol, which may be anything.
#pragma once

#include <string>
#include <string_view>

#include "certify/subject.h"

namespace toolcomp::certify {

// The line that asks a controller for a case: without what is expected.
std::string request_line(const spec::Case& c);

// How the answer to another case is told.
inline constexpr std::string_view kAnotherCase = "an answer to ";

// What a line says that came as the answer to `c`. A line that breaks the protocol is a fault that names nothing but
// the line: neither the end of a process nor its standard error.
Answer read_answer(const Capabilities& capabilities, const spec::Case& c, std::string line);

// The beginning of a text that may be anything, in quotes, for messages.
std::string excerpt(std::string_view text);

}  // namespace toolcomp::certify

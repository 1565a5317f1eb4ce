// SPDX-License-Identifier: Apache-2.0
// Requests to a controller, and its answers: lines of the protocol. An answer may be anything.
#pragma once

#include <string>
#include <string_view>

#include "certify/subject.h"

namespace toolcomp::certify {

// The line that asks a controller for a case, without the expected events.
std::string request_line(const spec::Case& c);

// The beginning of the message about an answer to another case.
inline constexpr std::string_view kAnotherCase = "an answer to ";

// Reads the line that came as the answer to `c`. A line that breaks the protocol is a fault. The fault has only the
// line, and neither the end of a process nor its standard error.
Answer read_answer(const Capabilities& capabilities, const spec::Case& c, std::string line);

// The beginning of a text that may be anything, in quotes, for messages.
std::string excerpt(std::string_view text);

}  // namespace toolcomp::certify

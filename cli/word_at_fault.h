// SPDX-License-Identifier: Apache-2.0
// The word at which a block cannot be read, and what may have been meant by it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "spec/language/axes.h"
#include "spec/language/setup.h"

namespace toolcomp::cli {

// `"X1,5": a decimal comma; numbers have a point`; without a likely meaning the word alone. `line`: the text of the
// line that is at fault; `column`: where, in bytes from 1.
std::string word_at_fault(std::string_view line, std::uint64_t column, spec::Control control);
// The code of the block that G43.4 and G43.5 do not allow (clause fanuc.tool-center-point.forbidden), and its column in
// bytes from 1; nothing where the line has none.
struct CodeAt {
  std::string code;
  std::uint64_t column = 0;
};
std::optional<CodeAt> code_not_allowed(std::string_view line, const spec::Axes& axes);
// What follows the text of an alarm, as one of both has it, and the column the alarm then points to; nothing and
// `column` for an alarm that neither is about. `line`: the text of the line that is at fault.
struct AtFault {
  std::string more;
  std::uint64_t column = 0;
};
AtFault at_fault(spec::AlarmCause cause, std::string_view line, std::uint64_t column, const spec::Setup& setup);

}  // namespace toolcomp::cli

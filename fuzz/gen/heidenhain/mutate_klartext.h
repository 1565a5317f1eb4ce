// SPDX-License-Identifier: Apache-2.0
// Changes to a Klartext case (mutate.h chooses how many).
#pragma once

#include "fuzz/gen/choices.h"

namespace toolcomp::fuzz {

void change_klartext(Choices& choose, spec::Case& c, Mode mode);
void change_tool_tables(Choices& choose, spec::Setup& setup, Mode mode);

}  // namespace toolcomp::fuzz

// SPDX-License-Identifier: Apache-2.0
// Changes to a FANUC case (mutate.h chooses how many).
#pragma once

#include "fuzz/gen/choices.h"

namespace toolcomp::fuzz {

void change_program(Choices& choose, spec::Case& c, Mode mode);
void change_setup(Choices& choose, spec::Setup& setup, Mode mode);

}  // namespace toolcomp::fuzz

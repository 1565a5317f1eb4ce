// SPDX-License-Identifier: Apache-2.0
// Programs that are too long to be run here.
#pragma once

#include "spec/language/case.h"

namespace toolcomp::fuzz {

// Programs that call others may be as long as they like: whether this one has more than 4,000 blocks as they run.
bool repeats_much(const spec::Case& c);

}  // namespace toolcomp::fuzz

// SPDX-License-Identifier: Apache-2.0
// How far a compensation looks ahead.
#pragma once

#include "spec/language/setup.h"

namespace toolcomp::model {

// How many blocks are read at a time in the mode, the one before a corner included: No. 19625 of the 30i, else 3.
// Throws spec::InputError for another number. Clauses: fanuc.cutter-c.two-non-motion-blocks,
// fanuc.tool-side.look-ahead.
int blocks_read(const spec::Setup& setup);

}  // namespace toolcomp::model

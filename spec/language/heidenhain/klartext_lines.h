// SPDX-License-Identifier: Apache-2.0
// Reads usual LN blocks as columns. Internal to the reader.
#pragma once

#include "spec/language/line_columns.h"

namespace toolcomp::spec::klartext {

// Reads the LN block that begins at `at` into row `to.size`, and returns the place after its end: a block number or
// none, X Y Z, NX NY NZ, perhaps TX TY TZ, in upper case, with the digits that a control takes, one blank between
// words, and nothing else. Row 0 says which words the others have. nullptr: the block is not usual. Reads up to a
// character that is none of these, and kDigitsRead more.
const char* read_usual_line(const char* at, LineColumns& to);

}  // namespace toolcomp::spec::klartext

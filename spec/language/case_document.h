// SPDX-License-Identifier: Apache-2.0
// Turns the tree of a case into a Case. For readers of files that contain cases among other things.
#pragma once

#include "spec/language/case.h"
#include "spec/language/document.h"

namespace toolcomp::spec {

// Throws InputError, with the position of the fault, for anything that is not a case (read_case).
Case case_from(const document::Node& root, const document::Reader& read);

}  // namespace toolcomp::spec

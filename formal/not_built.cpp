// SPDX-License-Identifier: Apache-2.0
// Where there is no Coq or no OCaml.
#include <stdexcept>

#include "formal/engine.h"

namespace toolcomp::formal {

bool available() { return false; }

std::vector<std::string> sections() { return {}; }

Run run(const spec::Case& /*c*/) { throw std::logic_error("built without the formal specification"); }

}  // namespace toolcomp::formal

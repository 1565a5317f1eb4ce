// SPDX-License-Identifier: Apache-2.0
// Where there is no Coq or no OCaml.
#include <stdexcept>

#include "spec_engine/engine.h"

namespace toolcomp::spec_engine {

bool available() { return false; }

std::vector<std::string> sections() { return {}; }

Run run(const spec::Case& /*c*/) { throw std::logic_error("built without the formal specification"); }

}  // namespace toolcomp::spec_engine

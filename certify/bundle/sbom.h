// SPDX-License-Identifier: Apache-2.0
// The bill of materials: toolcomp and the components from which it was built.
#pragma once

#include <string>

namespace toolcomp::certify::bundle {

// SPDX 2.3 as JSON. `made`: UTC, of the document; `tool_hash`: SHA-256 of the executable, or empty.
std::string sbom(const std::string& made, const std::string& tool_hash);

}  // namespace toolcomp::certify::bundle

// SPDX-License-Identifier: Apache-2.0
// Names of files in bundles and kits. They cannot lead outside.
#pragma once

#include <string_view>

namespace toolcomp::certify::bundle {

// One or two parts of letters, digits, '.', '_' and '-', none of which begins with a dot; at most 120 characters.
bool is_plain_name(std::string_view name);

}  // namespace toolcomp::certify::bundle

// SPDX-License-Identifier: Apache-2.0
// The style and the script of the interactive view, bundled when this is built (CMakeLists.txt), in pieces: some
// compilers do not accept long literals.
#pragma once

#include <span>
#include <string_view>

namespace toolcomp::certify {

std::span<const std::string_view> view_style();
std::span<const std::string_view> view_script();

}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
#include "spec/language/fanuc/macro_variables.h"

#include <algorithm>
#include <string_view>

namespace toolcomp::spec {

void MacroVariables::follow(const Block& block) {
  may_be_set_ = std::ranges::all_of(block.words(), [](const Word& word) {
    return std::string_view("GMSTFO").find(word.address) != std::string_view::npos;
  });
}

}  // namespace toolcomp::spec

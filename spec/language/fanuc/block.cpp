// SPDX-License-Identifier: Apache-2.0
#include "spec/language/fanuc/block.h"

namespace toolcomp::spec {

std::string to_string(const Block& block) {
  std::string text;
  if (block.n) text = 'N' + std::to_string(*block.n);
  for (const Word& word : block.words()) {
    if (!text.empty()) text += ' ';
    text += word.address;
    text += to_string(word.value);
  }
  return text;
}

}  // namespace toolcomp::spec

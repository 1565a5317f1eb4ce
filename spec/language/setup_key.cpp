// SPDX-License-Identifier: Apache-2.0
#include "spec/language/setup_key.h"

#include "spec/parameters/key_table.h"

namespace toolcomp::spec {

std::span<const KeyInfo> keys() { return kKeys; }

std::string value_text(const KeyInfo& key, std::size_t value) {
  const std::string text(key.values[value]);
  return key.boolean ? text : '"' + text + '"';
}

}  // namespace toolcomp::spec

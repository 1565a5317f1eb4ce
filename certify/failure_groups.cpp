// SPDX-License-Identifier: Apache-2.0
#include "certify/failure_groups.h"

#include "certify/program_text.h"

namespace toolcomp::certify {

bool FailureGroups::add(const FailureKey& key, std::size_t index, const std::string& program) {
  ++cases_;
  Group& group = groups_[key];
  const std::pair size{count_blocks(program), program.size()};
  if (group.cases++ > 0 && std::pair{group.size, group.index} < std::pair{size, index}) return false;
  group.size = size;
  group.index = index;
  return true;
}

bool FailureGroups::keep(const FailureKey& key, std::size_t index, Witness witness) {
  Group& group = groups_.at(key);
  if (group.index != index) return false;
  group.witness = std::move(witness);
  return true;
}

}  // namespace toolcomp::certify

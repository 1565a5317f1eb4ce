// SPDX-License-Identifier: Apache-2.0
// The failures of a campaign by key: how many cases, and of the smallest all that was seen.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "certify/evidence.h"

namespace toolcomp::certify {

class FailureGroups {
 public:
  struct Group {
    std::uint64_t cases = 0;
    std::size_t index = 0;                     // of the smallest, among all cases
    std::pair<std::size_t, std::size_t> size;  // its blocks and bytes
    Witness witness;
  };

  // One more case with this key. Whether it is the smallest so far: then its witness is wanted (`keep`). Of two of one
  // size the earlier counts, so that the order in which cases are judged does not.
  bool add(const FailureKey& key, std::size_t index, const std::string& program);
  // What was seen in the case; false: meanwhile another is the smallest.
  bool keep(const FailureKey& key, std::size_t index, Witness witness);

  [[nodiscard]] const std::map<FailureKey, Group>& all() const { return groups_; }
  // Of all groups.
  [[nodiscard]] std::size_t cases() const { return cases_; }

 private:
  std::map<FailureKey, Group> groups_;
  std::size_t cases_ = 0;
};

}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
// JUnit XML for tools of continuous integration.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace toolcomp::certify::junit {

class Suite {
 public:
  // Adds a test case. `inside` is XML: empty, or <failure>, <error>, <skipped>.
  void add(std::string_view group, std::string_view name, const std::string& inside);
  [[nodiscard]] std::string xml(std::string_view name) const;

 private:
  std::string cases_;
  std::size_t tests_ = 0;
  std::size_t failures_ = 0;
  std::size_t errors_ = 0;
  std::size_t skipped_ = 0;
};

// The whole file from the XML of the suites.
std::string document(const std::string& suites);

}  // namespace toolcomp::certify::junit

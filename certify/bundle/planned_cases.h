// SPDX-License-Identifier: Apache-2.0
// The cases that a certificate has to have: the golden vectors of its sections, the generated cases of its seed, and
// the cases given by name.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "certify/certification.h"

namespace toolcomp::certify::bundle {

struct Plan {
  std::vector<std::string> sections;  // asked for; empty: all
  std::vector<std::string> known;     // sections that the controller knows
  std::filesystem::path corpus;       // folder of the golden corpus; empty: none was asked for
  std::uint64_t seed = 0;
  std::uint32_t generated = 0;  // cases in each section
  bool of_adapter = false;      // whether the adapter adds its own generated cases
  bool interrupted = false;     // if true, some cases may be missing
  bool regenerate = false;      // whether generated cases are generated again and compared
};

// Takes the cases one by one, then checks that none is missing. Throws Refused for a case that is not planned or comes
// twice.
class PlannedCases {
 public:
  explicit PlannedCases(const Plan& plan);

  // `request`: the line that asked for the case.
  void take(const spec::Case& c, Origin origin, const std::string& request);
  void finish() const;

 private:
  struct Planned {
    std::uint64_t times = 1;  // still to come
    std::string digest;       // of the request; empty: any request
  };
  void plan_golden(const Plan& plan);
  void plan_generated(const Plan& plan);

  std::map<std::string, Planned> golden_, generated_;  // by id
  bool of_adapter_, interrupted_;
};

}  // namespace toolcomp::certify::bundle

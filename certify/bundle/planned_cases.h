// SPDX-License-Identifier: Apache-2.0
// Which cases a certificate has to have: the golden vectors of its sections, generated ones by their seed, and those
// given by name.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "certify/campaign.h"

namespace toolcomp::certify::bundle {

struct Plan {
  std::vector<std::string> sections;  // asked for; empty: all
  std::vector<std::string> known;     // to the controller
  std::filesystem::path corpus;       // folder of the golden corpus; empty: none was asked for
  std::uint64_t seed = 0;
  std::uint32_t generated = 0;  // cases a section
  bool of_adapter = false;      // it adds generated cases of its own
  bool interrupted = false;     // then some may be missing
  bool regenerate = false;      // generated cases are made again and compared
};

// Takes the cases one by one, then says what is missing; throws Refused for one that is not planned or comes twice.
class PlannedCases {
 public:
  explicit PlannedCases(const Plan& plan);

  // `request`: the line that asked for it.
  void take(const spec::Case& c, Origin origin, const std::string& request);
  void finish() const;

 private:
  struct Planned {
    std::uint64_t times = 1;  // still to come
    std::string digest;       // of the request; empty: any
  };
  void plan_golden(const Plan& plan);
  void plan_generated(const Plan& plan);

  std::map<std::string, Planned> golden_, generated_;  // by id
  bool of_adapter_, interrupted_;
};

}  // namespace toolcomp::certify::bundle

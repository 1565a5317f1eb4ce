// SPDX-License-Identifier: Apache-2.0
// One machine's share of work that is divided among N machines.
#pragma once

#include <cstddef>
#include <string>

namespace toolcomp::corpus {

struct Share {
  std::size_t index = 1;  // 1 … count
  std::size_t count = 1;
};
// Reads "I/N"; throws spec::InputError for anything else.
void set_shard(Share& share, const std::string& text);

}  // namespace toolcomp::corpus

// SPDX-License-Identifier: Apache-2.0
// The requests to one process, as evidence for its next answers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "certify/subject.h"

namespace toolcomp::certify {

// The requests since the process was started, the last ten thousand; `Request` is a case, or its index.
template <class Request>
class Asked {
 public:
  // Called after each answer.
  void add(const Subject& subject, Request request) {
    constexpr std::size_t kMost = 10'000;
    if (subject.starts() != starts_) requests_.clear();
    starts_ = subject.starts();
    requests_.push_back(std::move(request));
    if (requests_.size() > kMost + 1) requests_.pop_front();
  }
  // The requests before the last one.
  [[nodiscard]] std::vector<Request> before() const {
    if (requests_.empty()) return {};
    return {requests_.begin(), requests_.end() - 1};
  }

 private:
  std::uint64_t starts_ = 0;
  std::deque<Request> requests_;
};

}  // namespace toolcomp::certify

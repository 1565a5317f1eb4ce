// SPDX-License-Identifier: Apache-2.0
// libc++ for WASI has no file streams, and toml++ names one. Here is one that opens nothing.
#pragma once

#include <fstream>
#include <sstream>
#include <string>

template <>
class std::basic_ifstream<char> : public std::istream {
 public:
  basic_ifstream() : std::istream(&nothing_) {}
  void open(const std::string& /*file*/, std::ios::openmode /*mode*/) {}
  [[nodiscard]] bool is_open() const { return false; }

 private:
  std::stringbuf nothing_;
};

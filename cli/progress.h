// SPDX-License-Identifier: Apache-2.0
// Progress on a terminal: one line on standard error, rewritten; nothing where it is no terminal
// that can be drawn over, or with --quiet.
#pragma once

#include <cstdint>
#include <string>

namespace toolcomp::cli {

class Progress {
 public:
  explicit Progress(const char* unit);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // Shows the count of the progress alive on this thread; at most a few times a second.
  static void count(std::uint64_t done);
  // A whole line of text instead of a count.
  static void line(const std::string& text);
};

}  // namespace toolcomp::cli

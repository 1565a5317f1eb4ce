// SPDX-License-Identifier: Apache-2.0
// An end asked for from outside: by a signal, or by a time limit.
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace toolcomp::cli {

// While one is there, the first SIGINT, SIGTERM or SIGHUP ends no more than the controllers, and why() says so: what
// was found so far can be written. The second ends the program.
class Stop {
 public:
  explicit Stop(std::optional<std::chrono::seconds> limit = std::nullopt);
  ~Stop();
  Stop(const Stop&) = delete;
  Stop& operator=(const Stop&) = delete;

  // "interrupted (SIGINT)", "time limit of 60 s"; empty: go on.
  [[nodiscard]] std::string why() const;

 private:
  std::optional<std::chrono::seconds> limit_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

// For main: the handler of these signals. Async-signal-safe.
void on_signal(int signal);

// "90", "90s", "10m", "1h"; `option` is for messages. Throws spec::InputError for anything else.
std::chrono::seconds duration_of(const std::string& text, const std::string& option);

}  // namespace toolcomp::cli

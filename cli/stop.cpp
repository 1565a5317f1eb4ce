// SPDX-License-Identifier: Apache-2.0
#include "cli/stop.h"

#include <fmt/format.h>

#include <atomic>
#include <csignal>
#include <stdexcept>

#include "host/process.h"
#include "spec/language/input_error.h"

namespace toolcomp::cli {
namespace {

std::atomic<bool> stoppable{false};
std::atomic<int> signalled{0};

}  // namespace

Stop::Stop(std::optional<std::chrono::seconds> limit) : limit_(limit) { stoppable = true; }

Stop::~Stop() { stoppable = false; }

std::string Stop::why() const {
  switch (signalled) {
    case 0:
      break;
    case SIGINT:
      return "interrupted (SIGINT)";
    case SIGTERM:
      return "interrupted (SIGTERM)";
    default:
      return "interrupted (SIGHUP)";
  }
  if (limit_ && std::chrono::steady_clock::now() - begun_ >= *limit_)
    return fmt::format("time limit of {} s", limit_->count());
  return {};
}

void on_signal(int signal) {
  int none = 0;
  const bool first = stoppable && signalled.compare_exchange_strong(none, signal);
  // Controllers run in process groups of their own, which the terminal's interrupt does not reach.
  host::kill_processes();
  if (first) return;
  static_cast<void>(std::signal(signal, SIG_DFL));
  static_cast<void>(std::raise(signal));
}

std::chrono::seconds duration_of(const std::string& text, const std::string& option) {
  std::size_t used = 0;
  std::uint64_t number = 0;
  try {
    number = std::stoull(text, &used);
  } catch (const std::exception&) {
    used = 0;
  }
  const std::string unit = text.substr(used);
  const std::uint64_t factor = unit.empty() || unit == "s" ? 1 : unit == "m" ? 60 : unit == "h" ? 3600 : 0;
  if (used == 0 || text[0] == '-' || number == 0 || number > 1'000'000 || factor == 0)
    throw spec::InputError(option, 0, 0, "takes a time such as 60s, 10m or 1h, found \"" + text + "\"");
  return std::chrono::seconds(number * factor);
}

}  // namespace toolcomp::cli

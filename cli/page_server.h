// SPDX-License-Identifier: Apache-2.0
// One page over HTTP on 127.0.0.1, and word to the browsers that have it when it has changed.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace toolcomp::cli {

struct PageServerState;

// Answers GET / with the page and GET /events with server-sent events: the version of the page, now and whenever it
// changes. Requests that name another host are refused, which keeps out the pages of other sites; so is every method
// but GET. No client can hold it up: each has some seconds to ask and to take its answer, and there are at most so
// many.
class PageServer {
 public:
  // Listens on `port`, 0: any that is free. Without a port the usual one (8600) if it is free, else any. Throws
  // spec::InputError where the port is taken.
  explicit PageServer(std::optional<std::uint16_t> port);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  // "http://127.0.0.1:8600/"
  [[nodiscard]] std::string address() const;
  // From any thread.
  void show(std::string page, std::string version);
  // Serves until stop(); calls `at_times` every `interval`.
  void run(std::chrono::milliseconds interval, const std::function<void()>& at_times);
  void stop();

 private:
  std::unique_ptr<PageServerState> state_;
};

}  // namespace toolcomp::cli

// SPDX-License-Identifier: Apache-2.0
// A command in its own process group, with line by line communication through pipes.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace toolcomp::host {

using Clock = std::chrono::steady_clock;

// How an exchange ended.
enum class Exchange : std::uint8_t {
  line,       // a whole line came back
  timed_out,  // no whole line came in time
  closed,     // the process ended or closed its output
  too_long,   // more than `limit` bytes came without a line end
};

// The whole process group is killed with the object. Only one thread at a time may use it.
class Process {
 public:
  // Runs `command` by /bin/sh -c. Throws std::runtime_error if no process can be made.
  explicit Process(const std::string& command);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  // Sends `line` and a line feed, then waits for one line, and stores it in `reply` without its line end. It reads
  // while it writes, so that neither side can block the other with a long line. Memory is bounded by `limit`.
  Exchange exchange(std::string_view line, std::string& reply, Clock::time_point deadline, std::size_t limit);
  // Waits for one more line.
  Exchange receive_line(std::string& reply, Clock::time_point deadline, std::size_t limit);
  // Takes a line that has already come; false if there is none.
  bool take_line(std::string& reply);

  // Kills the group and waits for it. Returns how the process ended: "exit status 3", "killed by signal 11
  // (Segmentation fault)". First waits up to `patience` for the process to end by itself.
  std::string finish(std::chrono::milliseconds patience = std::chrono::milliseconds(0));
  // The exit status after finish(); -1 if it did not exit by itself.
  [[nodiscard]] int exit_status() const { return exit_status_; }

  // The last 4 KiB of standard error.
  [[nodiscard]] std::string errors() const;  // in a form that may be shown

 private:
  [[nodiscard]] bool send();  // false if the process accepts no more input
  bool receive(std::size_t limit, Exchange& end);
  void receive_errors();

  pid_t pid_ = -1;
  int in_ = -1;   // to its standard input
  int out_ = -1;  // from its standard output
  int err_ = -1;  // from its standard error
  int exit_status_ = -1;
  std::string ended_;
  std::string outgoing_;  // the last request, and how much of it has been sent
  std::size_t sent_ = 0;
  std::string pending_;      // not yet taken
  std::size_t scanned_ = 0;  // bytes of pending_ known to hold no line end
  std::string errors_;
};

// The text as one word of a shell command.
std::string shell_quoted(std::string_view text);

// Kills every living process group. Async-signal-safe, for the handler of an interrupt.
void kill_processes() noexcept;

}  // namespace toolcomp::host

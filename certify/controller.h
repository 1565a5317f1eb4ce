// SPDX-License-Identifier: Apache-2.0
// A controller under test: any command that speaks the protocol (docs/protocol.md) on its standard input and output.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "certify/answer.h"
#include "certify/subject.h"
#include "host/process.h"

namespace toolcomp::certify {

struct ControllerOptions {
  std::string command;                              // run by /bin/sh -c
  std::chrono::milliseconds timeout{10'000};        // for one answer, and for hello
  std::size_t reply_limit = std::size_t{64} << 20;  // bytes of one answer
};

// Starts the command when it is first needed. Starts it again if it has ended, did not answer, or answered out of step,
// so that each case meets a working process.
class Controller final : public Subject {
 public:
  explicit Controller(ControllerOptions options) : options_(std::move(options)) {}

  // Throws spec::InputError if the shell cannot run the command at all (exit status 126 or 127 without an answer).
  std::variant<Capabilities, Fault> capabilities() override;
  Answer run(const spec::Case& c, std::optional<std::chrono::milliseconds> patience = {}) override;

  [[nodiscard]] std::chrono::milliseconds slowest() const override { return slowest_; }
  [[nodiscard]] std::uint64_t answers() const override { return answers_; }
  [[nodiscard]] std::uint64_t starts() const override { return starts_; }
  void restart() override;
  [[nodiscard]] std::string errors() const override { return process_ ? process_->errors() : std::string(); }
  [[nodiscard]] std::string chatter() const override { return chatter_; }
  [[nodiscard]] std::string hello() const override { return hello_; }

 private:
  std::optional<Fault> start(std::chrono::milliseconds timeout);
  // Sends one line and waits for one line; anything else is a fault and ends the process. Lines that are not JSON
  // objects are not answers: the first one is kept, and the wait goes on. If such a wait was in vain once, it does not
  // wait again, and then the process goes on.
  std::variant<std::string, Fault> exchange(std::string_view line, std::chrono::milliseconds timeout);
  Fault fault(FaultKind kind, std::string what, std::chrono::milliseconds wait_for_end = std::chrono::milliseconds(0));
  bool is_chatter(std::string_view line);

  ControllerOptions options_;
  std::unique_ptr<host::Process> process_;
  std::optional<Capabilities> capabilities_;  // of its first answer to hello
  std::string hello_;                         // that answer as it came
  std::chrono::milliseconds slowest_{0};
  int exit_status_ = -1;
  std::uint64_t answers_ = 0;
  std::uint64_t starts_ = 0;
  std::string chatter_;               // the first
  std::string last_chatter_;          // the last since the request
  bool greeted_ = false;              // the process has answered hello
  bool chatter_for_answers_ = false;  // once nothing but chatter came in time: no more waiting after chatter
};

}  // namespace toolcomp::certify

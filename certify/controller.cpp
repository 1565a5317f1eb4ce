// SPDX-License-Identifier: Apache-2.0
#include "certify/controller.h"

#include <algorithm>
#include <utility>

#include "spec/language/input_error.h"

namespace toolcomp::certify {
namespace {

// A process whose output has ended is given this long to end itself, so that its exit status can be told.
constexpr std::chrono::milliseconds kEndPatience{2000};

}  // namespace

Fault Controller::fault(FaultKind kind, std::string what, std::chrono::milliseconds wait_for_end) {
  const std::string ended = process_->finish(wait_for_end);
  exit_status_ = process_->exit_status();
  if (kind == FaultKind::crash) what += ": " + ended;
  if (!last_chatter_.empty()) what += ", but wrote " + last_chatter_;
  Fault result{kind, std::move(what), ended, process_->errors()};
  process_.reset();
  return result;
}

void Controller::restart() { process_.reset(); }

bool Controller::is_chatter(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t");
  if (begin != std::string_view::npos && line[begin] == '{') return false;
  last_chatter_ = excerpt(line);
  if (chatter_.empty()) chatter_ = last_chatter_;
  return true;
}

std::variant<std::string, Fault> Controller::exchange(std::string_view line, std::chrono::milliseconds timeout) {
  last_chatter_.clear();
  std::string reply;
  while (process_->take_line(reply))
    if (!is_chatter(reply)) return fault(FaultKind::malformed, "more than one line for one request");
  const host::Clock::time_point begin = host::Clock::now();
  host::Exchange end = process_->exchange(line, reply, begin + timeout, options_.reply_limit);
  while (end == host::Exchange::line && is_chatter(reply)) {
    if (chatter_for_answers_ && greeted_)
      return Fault{FaultKind::malformed, "no answer, but wrote " + last_chatter_, {}, process_->errors()};
    end = process_->receive_line(reply, begin + timeout, options_.reply_limit);
  }
  const auto elapsed = std::chrono::duration_cast<std::chrono::milliseconds>(host::Clock::now() - begin);
  switch (end) {
    case host::Exchange::line:
      break;
    case host::Exchange::timed_out:
      chatter_for_answers_ = !last_chatter_.empty();
      return fault(chatter_for_answers_ ? FaultKind::malformed : FaultKind::hang,
                   "no answer within " + std::to_string(timeout.count()) + " ms");
    case host::Exchange::closed:
      return fault(FaultKind::crash, "ended before it answered", kEndPatience);
    case host::Exchange::too_long:
      return fault(FaultKind::too_long, "an answer of more than " + std::to_string(options_.reply_limit) + " bytes");
  }
  slowest_ = std::max(slowest_, elapsed);
  return reply;
}

std::optional<Fault> Controller::start(std::chrono::milliseconds timeout) {
  if (process_) return std::nullopt;
  process_ = std::make_unique<host::Process>(options_.command);
  greeted_ = false;
  ++starts_;
  auto reply = exchange(R"({"hello":1})", timeout);
  if (auto* failure = std::get_if<Fault>(&reply)) {
    // What a shell says of a command that is not there; only the first time, because later it was there.
    if (failure->kind == FaultKind::crash && !capabilities_ && (exit_status_ == 126 || exit_status_ == 127))
      throw spec::InputError("--controller", 0, 0, "the command cannot be run: " + excerpt(failure->errors));
    failure->what = "hello: " + failure->what;
    return std::move(*failure);
  }
  try {
    Capabilities said = read_capabilities(std::get<std::string>(reply));
    if (!capabilities_) {
      capabilities_ = std::move(said);
      hello_ = std::get<std::string>(reply);
    }
  } catch (const spec::InputError& error) {
    return fault(FaultKind::malformed, "hello: " + error.message() + " but " + excerpt(std::get<std::string>(reply)));
  }
  greeted_ = true;
  return std::nullopt;
}

std::variant<Capabilities, Fault> Controller::capabilities() {
  if (!capabilities_) {
    if (auto failure = start(options_.timeout)) return std::move(*failure);
  }
  return *capabilities_;
}

Answer Controller::run(const spec::Case& c, std::optional<std::chrono::milliseconds> patience) {
  const std::chrono::milliseconds timeout = patience.value_or(options_.timeout);
  const auto failed = [](Fault failure) {
    Answer answer;
    answer.result = std::move(failure);
    return answer;
  };
  if (auto failure = start(timeout)) return failed(std::move(*failure));
  auto reply = exchange(request_line(c), timeout);
  if (auto* failure = std::get_if<Fault>(&reply)) return failed(std::move(*failure));
  ++answers_;
  Answer answer = read_answer(*capabilities_, c, std::move(std::get<std::string>(reply)));
  if (auto* failure = std::get_if<Fault>(&answer.result)) {
    // A process that answers in step goes on, whatever it says.
    if (failure->what.starts_with(kAnotherCase))
      *failure = fault(failure->kind, std::move(failure->what));
    else
      failure->errors = process_->errors();
  }
  return answer;
}

}  // namespace toolcomp::certify

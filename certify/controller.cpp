// SPDX-License-Identifier: Apache-2.0
#include "certify/controller.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "certify/event_fields.h"
#include "spec/language/case_format.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify {
namespace {

// A process whose output has ended is given this long to end itself, so that its exit status can be told.
constexpr std::chrono::milliseconds kEndPatience{2000};

// How an answer out of step is told.
const std::string kAnotherCase = "an answer to ";

using spec::Field;

// Fields that every event of a kind has. Those that only some have are missed by the verdict, which knows the event
// that is expected.
std::span<const Field> fields_of(spec::EventKind kind) {
  static constexpr std::array move{Field::type, Field::cause};
  static constexpr std::array sample{Field::t};
  static constexpr std::array alarm{Field::number};
  static constexpr std::array setting{Field::name, Field::value};
  static constexpr std::array undecided{Field::permitted};
  switch (kind) {
    case spec::EventKind::move:
      return move;
    case spec::EventKind::sample:
      return sample;
    case spec::EventKind::alarm:
    case spec::EventKind::warning:
      return alarm;
    case spec::EventKind::setting:
      return setting;
    case spec::EventKind::undecided:
      return undecided;
  }
  return {};
}

std::optional<MissingField> find_missing(const Capabilities& capabilities, const spec::Reply& reply) {
  for (std::size_t i = 0; i < reply.events.size(); ++i)
    for (const Field field : fields_of(reply.events[i].kind)) {
      const std::string_view name = spec::field_name(field);
      const bool announced = std::ranges::find(capabilities.fields, name) != capabilities.fields.end();
      if (announced && !reply.fields[i].has(field)) return MissingField{reply.events[i].line, i, std::string(name)};
    }
  return std::nullopt;
}

// The beginning of a text that may be anything, for messages.
std::string excerpt(std::string_view text) {
  constexpr std::size_t kMost = 80;
  std::string quoted = "\"" + std::string(text.substr(0, kMost)) + "\"";
  for (char& c : quoted)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  return text.size() > kMost ? quoted + "…" : quoted;
}

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
  const Clock::time_point begin = Clock::now();
  Exchange end = process_->exchange(line, reply, begin + timeout, options_.reply_limit);
  while (end == Exchange::line && is_chatter(reply)) {
    if (chatter_for_answers_ && greeted_)
      return Fault{FaultKind::malformed, "no answer, but wrote " + last_chatter_, {}, process_->errors()};
    end = process_->receive_line(reply, begin + timeout, options_.reply_limit);
  }
  const auto elapsed = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - begin);
  switch (end) {
    case Exchange::line:
      break;
    case Exchange::timed_out:
      chatter_for_answers_ = !last_chatter_.empty();
      return fault(chatter_for_answers_ ? FaultKind::malformed : FaultKind::hang,
                   "no answer within " + std::to_string(timeout.count()) + " ms");
    case Exchange::closed:
      return fault(FaultKind::crash, "ended before it answered", kEndPatience);
    case Exchange::too_long:
      return fault(FaultKind::too_long, "an answer of more than " + std::to_string(options_.reply_limit) + " bytes");
  }
  slowest_ = std::max(slowest_, elapsed);
  return reply;
}

std::optional<Fault> Controller::start(std::chrono::milliseconds timeout) {
  if (process_) return std::nullopt;
  process_ = std::make_unique<Process>(options_.command);
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

std::string request_line(const spec::Case& c) {
  spec::Case request = c;
  request.expect.clear();
  request.has_expect = false;
  return spec::write_case_line(request);
}

Answer read_answer(const Capabilities& capabilities, const spec::Case& c, std::string line) {
  Answer answer;
  answer.line = std::move(line);
  const auto fault = [&answer](FaultKind kind, std::string what) {
    answer.result = Fault{kind, std::move(what), {}, {}};
    return std::move(answer);
  };
  try {
    spec::Reply read = spec::read_reply(answer.line, c.setup.axes, "reply");
    if (!read.error.empty() && (read.id.empty() || read.id == c.id))
      return fault(FaultKind::error, excerpt(read.error));
    if (read.id != c.id)
      return fault(FaultKind::malformed, kAnotherCase + excerpt(read.id) + " instead of " + excerpt(c.id));
    if (!read.not_applicable.empty()) {
      answer.result = NotApplicable{std::move(read.not_applicable)};
      return answer;
    }
    answer.missing = find_missing(capabilities, read);
    for (const spec::FieldSet& fields : read.fields) answer.sent.add(fields);
    answer.result = std::move(read.events);
    return answer;
  } catch (const spec::InputError& error) {
    return fault(FaultKind::malformed, error.message() + ": " + excerpt(answer.line));
  }
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

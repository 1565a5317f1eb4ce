// SPDX-License-Identifier: Apache-2.0
#include "certify/answer.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "spec/language/case_format.h"
#include "spec/language/input_error.h"
#include "spec/language/printable.h"

namespace toolcomp::certify {
namespace {

using spec::Field;

// Fields that every event of a kind has. Those that only some have are missed by the verdict, which knows the event
// that is expected.
std::span<const Field> fields_by_kind(spec::EventKind kind) {
  static constexpr std::array move{Field::type, Field::cause};
  static constexpr std::array sample{Field::t};
  static constexpr std::array alarm{Field::number};
  static constexpr std::array setting{Field::name, Field::value};
  static constexpr std::array hole{Field::r, Field::bottom, Field::level};
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
    case spec::EventKind::hole:
      return hole;
    case spec::EventKind::undecided:
      return undecided;
    case spec::EventKind::not_supported:
    case spec::EventKind::not_judged:
      break;
  }
  return {};
}

std::optional<MissingField> find_missing(const Capabilities& capabilities, const spec::Reply& reply) {
  for (std::size_t i = 0; i < reply.events.size(); ++i)
    for (const Field field : fields_by_kind(reply.events[i].kind)) {
      const std::string_view name = spec::field_name(field);
      const bool announced = std::ranges::find(capabilities.fields, name) != capabilities.fields.end();
      if (announced && !reply.fields[i].has(field)) return MissingField{reply.events[i].line, i, std::string(name)};
    }
  return std::nullopt;
}

}  // namespace

std::string excerpt(std::string_view text) {
  constexpr std::size_t kMost = 80;
  const std::string beginning = spec::printable(text.substr(0, kMost));
  return "\"" + beginning + (text.size() > kMost ? "\"…" : "\"");
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
      return fault(FaultKind::malformed, std::string(kAnotherCase) + excerpt(read.id) + " instead of " + excerpt(c.id));
    if (!read.not_applicable.empty()) {
      answer.result = NotApplicable{std::move(read.not_applicable), std::move(read.known_difference)};
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

}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
// Any bytes as a case and as the reply of a controller: read or refused; the text of what is read is a fixed point of
// reading and writing, in both layouts.
#include <string>
#include <string_view>

#include "fuzz/targets/worker.h"
#include "spec/language/case_format.h"
#include "spec/language/input_error.h"

namespace {

using namespace toolcomp::spec;
using toolcomp::fuzz::require;

void as_case(std::string_view text) {
  Case c;
  try {
    c = read_case(text, "case");
  } catch (const InputError& error) {
    require(error.line() != 0);
    return;
  }
  const std::string line = write_case_line(c);
  require(line.find('\n') == std::string::npos);
  require(write_case_line(read_case(line, "again")) == line);
  require(write_case_line(read_case(write_case(c), "again")) == line);
}

void as_reply(std::string_view text) {
  try {
    const Reply reply = read_reply(text, Axes("XYZ"), "reply");
    require(reply.events.size() == reply.fields.size());
  } catch (const InputError& error) {
    require(error.line() != 0);
  }
}

void hold(std::string_view text) {
  as_case(text);
  as_reply(text);
}

}  // namespace

TOOLCOMP_READER_TARGET("read_case", hold)

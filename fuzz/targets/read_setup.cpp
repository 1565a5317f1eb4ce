// SPDX-License-Identifier: Apache-2.0
// Any bytes as a setup, JSON if they begin with {, else TOML: read or refused; what is read is read back equal from
// both formats.
#include <optional>
#include <string_view>

#include "fuzz/targets/worker.h"
#include "spec/language/input_error.h"
#include "spec/language/setup_format.h"

namespace {

using namespace toolcomp::spec;
using toolcomp::fuzz::require;

std::optional<Setup> read(std::string_view text) {
  try {
    return text.starts_with('{') ? read_setup_json(text, "setup") : read_setup_toml(text, "setup");
  } catch (const InputError& error) {
    require(error.line() != 0);
    return std::nullopt;
  }
}

void hold(std::string_view text) {
  const std::optional<Setup> setup = read(text);
  if (!setup) return;
  require(read_setup_toml(write_setup_toml(*setup), "again") == *setup);
  require(read_setup_json(write_setup_json(*setup), "again") == *setup);
}

}  // namespace

TOOLCOMP_READER_TARGET("read_setup", hold)

// SPDX-License-Identifier: Apache-2.0
// The setup of a program that is no test of F: where it gives none at power-on (1411), the control has F100 there, for
// a cutting move without F is an alarm (clause fanuc.program.no-feed).
#pragma once

#include <string_view>

#include "spec/language/setup_format.h"

namespace toolcomp::test {

inline spec::Setup with_feed(spec::Setup setup) {
  if (setup.control == spec::Control::fanuc) setup.parameters.try_emplace({1411, -1}, spec::decimal(100));
  return setup;
}

// Throws as spec::read_setup_toml.
inline spec::Setup setup_with_feed(std::string_view toml) {
  return with_feed(spec::read_setup_toml(toml, "setup.toml"));
}

}  // namespace toolcomp::test

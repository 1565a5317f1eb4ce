// SPDX-License-Identifier: Apache-2.0
// The formal specification (spec/formal/program), run: its functions as Coq extracts them, over the exact numbers of
// the model. Only these numbers are shared with the model, no rule.
#pragma once

#include <string>
#include <vector>

#include "model/exact/real.h"
#include "spec/language/case.h"
#include "spec/language/event.h"

namespace toolcomp::spec_engine {

// Whether this command was built with it: where Coq and OCaml are.
bool available();

// The sections whose every code the specification says so far.
std::vector<std::string> sections();

struct Run {
  std::vector<spec::Event<exact::Real>> events;
  std::string not_said;  // why there is no run; empty: there is one
};

// Requires available(). From one thread, always the same. Throws spec::InputError for a program that
// is no text.
Run run(const spec::Case& c);

}  // namespace toolcomp::spec_engine

// SPDX-License-Identifier: Apache-2.0
// How a number was made, for comparing states: equal bytes are equal expressions, with what they share, how far they
// have been refined and what could not be decided. From there the same operations give the same signs and the same
// digits. Enclosures in double and of 128 bits are left out: made at the first question, they say how soon a sign is
// found, not which.
#pragma once

#include "model/exact/real.h"
#include "spec/language/state_writer.h"

namespace toolcomp::spec {

template <>
struct StateOf<exact::Real> {
  static void write(StateWriter& out, const exact::Real& value);
};
template <>
struct StateOf<exact::Rational> {
  static void write(StateWriter& out, const exact::Rational& value);
};

}  // namespace toolcomp::spec

// How a number was made, for comparing states: equal bytes are equal expressions, with what they share and how far they
// have been refined. From equal expressions the same operations give the same answers, bit for bit.
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

// SPDX-License-Identifier: Apache-2.0
// How numbers of the engines cross over, inside events as JSON (toolcomp/numbers.py reads them).
#pragma once

#include <string>

#include "fast/basis/print.h"
#include "model/basis/print.h"

namespace toolcomp::python {

// A fraction as text, "10/3"; any other number as a pair of texts: a decimal of so many places, and how far off it may
// be. Throws exact::Undecided where the digits cannot be certified.
struct ExactNumber {
  int digits = 15;
  void operator()(std::string& out, const exact::Real& value) const {
    const spec::NumberText text = model::number_text(value, digits);
    if (!text.q.empty() || is_zero(value, text))
      out += '"' + (text.q.empty() ? text.v : text.q) + '"';
    else
      out += "[\"" + text.v + "\",\"" + text.r + "\"]";
  }

 private:
  // What is written as 0 mostly is, and not every number that is rational is known to be.
  static bool is_zero(const exact::Real& value, const spec::NumberText& text) {
    try {
      return text.v == "0" && value.sign() == exact::Sign::zero;
    } catch (const exact::Undecided&) {
      return false;
    }
  }
};

// A double, bit for bit.
struct DoubleNumber {
  void operator()(std::string& out, double value) const { fast::append_number(out, value); }
};

}  // namespace toolcomp::python

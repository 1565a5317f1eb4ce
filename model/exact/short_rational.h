// SPDX-License-Identifier: Apache-2.0
// Sums, products and quotients of rationals. Where numerators and denominators are numbers of one machine word, as
// those of programs mostly are, they are computed here, in a third of GMP's time; else by GMP.
#pragma once

#include <gmp.h>

namespace toolcomp::exact {

// The result is another object than the operands, and in lowest terms, as they are.
void add(mpq_ptr result, mpq_srcptr x, mpq_srcptr y);
void subtract(mpq_ptr result, mpq_srcptr x, mpq_srcptr y);
void multiply(mpq_ptr result, mpq_srcptr x, mpq_srcptr y);
/// The divisor is not zero.
void divide(mpq_ptr result, mpq_srcptr x, mpq_srcptr y);

}  // namespace toolcomp::exact

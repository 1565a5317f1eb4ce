// SPDX-License-Identifier: Apache-2.0
// Enclosures of a whole expression, recomputed at a higher precision.
#pragma once

#include "model/exact/node.h"
#include "model/exact/work.h"

namespace toolcomp::exact {

/// Sets the enclosure of an operation from those of its operands.
void enclose(Interval& result, const Node& node, const Interval* left, const Interval* right);
/// The same in double; what there is no operand for is not looked at.
DoubleEnclosure enclosed_in_double(const Node& node, const DoubleEnclosure& left, const DoubleEnclosure& right);

/// Recomputes `root` and everything below it at `precision`, where not done before, and narrows the enclosures at
/// base_precision with the result. Throws OutOfWork; what was done until then stays valid.
void refine(Node& root, mpfr_prec_t precision, Work& work);

}  // namespace toolcomp::exact

// SPDX-License-Identifier: Apache-2.0
// Enclosures of a whole expression, recomputed at a higher precision.
#pragma once

#include "model/exact/node.h"
#include "model/exact/work.h"

namespace toolcomp::exact {

/// Sets the enclosure of an operation from those of its operands.
void enclose(Interval& result, const Node& node, const Interval* left, const Interval* right);
/// The same in double. The parameters of missing operands are ignored.
DoubleEnclosure enclosed_in_double(const Node& node, const DoubleEnclosure& left, const DoubleEnclosure& right);

/// Recomputes `root` and everything below it at `precision`, unless this was done before, and narrows the enclosures at
/// base_precision with the result. Throws OutOfWork; the results until then stay valid.
void refine(Node& root, mpfr_prec_t precision, Work& work);

}  // namespace toolcomp::exact

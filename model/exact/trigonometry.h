// SPDX-License-Identifier: Apache-2.0
// Enclosures of sines and cosines of degrees, and of arc tangents.
#pragma once

#include "model/exact/interval.h"

namespace toolcomp::exact {

/// Encloses sin and cos of `degrees` at the precision of the results. Arb computes both together. The last angles at
/// base_precision are remembered, so that sine and cosine of one angle cost one computation.
void sine_and_cosine(Interval* sine, Interval* cosine, const mpq_t degrees);

/// Encloses the angle of a tangent, in degrees.
void arctangent_degrees(Interval& result, const Interval& tangent);
/// Enclose sine and cosine of an enclosed angle.
void sine_of_degrees(Interval& result, const Interval& degrees);
void cosine_of_degrees(Interval& result, const Interval& degrees);

/// Gives back what the functions above hold for this thread.
void free_trigonometry();

}  // namespace toolcomp::exact

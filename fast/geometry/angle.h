// SPDX-License-Identifier: Apache-2.0
// Polar angles in degrees.
#pragma once

namespace toolcomp::fast {

// The polar angle of (x, y), not both zero, in degrees from -180 to 180, of the sign of y: relative error below 2^-51,
// multiples of 45 degrees are exact. No libm: the result is the same everywhere.
double polar_angle(double x, double y);

}  // namespace toolcomp::fast

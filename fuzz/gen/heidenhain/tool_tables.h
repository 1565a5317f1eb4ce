// SPDX-License-Identifier: Apache-2.0
// Random setups of a Heidenhain control that could exist.
#pragma once

#include "fuzz/gen/choices.h"
#include "spec/language/setup.h"

namespace toolcomp::fuzz {

// For 3D tool compensation on a Heidenhain control: a tool table of one to three end mills, toroid cutters and balls,
// seldom of what is no tool; deltas, rows of corrections, tables of deviations.
spec::Setup random_heidenhain_setup(Choices& choose);

}  // namespace toolcomp::fuzz

// SPDX-License-Identifier: Apache-2.0
// By how much the paths cross where the control raises its interference alarm (PS0041).
#pragma once

#include <optional>

#include "cli/program.h"
#include "model/basis/event.h"

namespace toolcomp::cli {

// Of the alarm that ends the run, from the exact model, setup units: how far the tool would run backwards in the block,
// or by how much the offset of an arc is larger than its radius. Nothing where it is another alarm, where the reason is
// no length (an arc's sweep, a change of the compensation plane), or where the model does not get there.
std::optional<double> crossing(const model::Event& alarm);
// The same from a run of the model over the program; nothing, too, where it cannot be read again.
std::optional<double> crossing(const Program& program);

}  // namespace toolcomp::cli

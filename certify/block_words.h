// SPDX-License-Identifier: Apache-2.0
// The parts of an explanation of a block other than clauses and decisions: text with exact figures.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "model/basis/event.h"
#include "spec/language/setup.h"

namespace toolcomp::certify {

// The corner at the end of the block whose own move is events[own]: its heads and vectors (X Y Z as they differ from
// the programmed corner), and the line of the block they lead to. Empty if there is no compensation vector.
std::string corner_words(std::span<const model::Event> events, std::size_t own, const spec::Axes& axes, int digits);

// G37: by how much the measured position may be off, and how far the tool runs on, at the measuring feed (parameter
// 6241, in setup units a minute): ERRmax = Fm/60 * Ts/1000 with Ts = 2 ms, Qmax = Fm/60 * 16/1000.
std::string measuring_words(const spec::Setup& setup, int digits);

}  // namespace toolcomp::certify

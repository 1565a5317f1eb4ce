// SPDX-License-Identifier: Apache-2.0
// What guides a search: which new things make an input worth keeping, and how inputs are changed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "fuzz/campaign/features.h"
#include "fuzz/gen/generator.h"
#include "judge/oracle/verdict.h"

namespace toolcomp::fuzz {

// Behind the features of a run (features.h): pairs of clauses that events of one block rest on, and shapes, three
// events in a row by kind, motion, inserted or not, and the clause that names them; both by their hashes.
inline constexpr std::size_t kPairSlots = 8192;
inline constexpr std::size_t kShapeSlots = 8192;
inline constexpr std::size_t kSteeringSlots = kFeatures + kPairSlots + kShapeSlots;

// What the runs of a search have reached.
class Coverage {
 public:
  // Whether there was something new.
  bool add(const judge::ModelRun& run);

 private:
  std::vector<bool> slots_ = std::vector<bool>(kSteeringSlots, false);
};

// Adds what a run reached to counters, saturating: one for each slot.
void count_reached(const judge::ModelRun& run, std::span<std::uint8_t> counters);

// One change of a case; with `push` it may ask the model: some change then moves one number so that one decision comes
// nearer to its boundary.
void change(spec::Case& c, Mode mode, bool push, ChoiceSource& source);

}  // namespace toolcomp::fuzz

// SPDX-License-Identifier: Apache-2.0
// What guides a search: which new things make an input worth keeping, and which mutations ask the model first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/campaign/features.h"
#include "fuzz/gen/generator.h"
#include "fuzz/oracle/verdict.h"

namespace toolcomp::fuzz {

struct Steering {
  bool outcomes = true;  // clause × outcome
  bool margins = true;   // clause × side × size of the margin
  bool pairs = true;     // two clauses that events of one block rest on
  bool shapes = true;    // three events in a row, by kind, motion, inserted or not, and the clause that names them
  bool push = true;      // mutations that push a decision toward its boundary

  friend bool operator==(const Steering&, const Steering&) = default;
};

// "outcomes,push", "all", "none". Throws spec::InputError of `where`, naming what is unknown.
Steering parse_steering(std::string_view text, const char* where);
std::string to_string(const Steering& steering);
// What the variable TOOLCOMP_STEERING says: for experiments (`./dev experiment steering`). Everything without it.
// Throws as parse_steering().
const Steering& steering_of_process();

// Behind the features of a run (features.h): pairs and shapes, by their hashes.
inline constexpr std::size_t kPairSlots = 8192;
inline constexpr std::size_t kShapeSlots = 8192;
inline constexpr std::size_t kSteeringSlots = kFeatures + kPairSlots + kShapeSlots;

// How much has been reached, each thing once.
struct Reach {
  std::uint64_t outcomes = 0;
  std::uint64_t margins = 0;
  std::uint64_t pairs = 0;
  std::uint64_t shapes = 0;

  [[nodiscard]] std::uint64_t total() const { return outcomes + margins + pairs + shapes; }
};

// What the runs of a search have reached, looked for or not.
class Coverage {
 public:
  // Whether there was something new among what is looked for. That is added to `counters` too, saturating: one for each
  // slot, or none.
  bool add(const ModelRun& run, const Steering& steering, std::span<std::uint8_t> counters = {});
  [[nodiscard]] const Reach& reach() const { return reach_; }

 private:
  std::vector<bool> slots_ = std::vector<bool>(kSteeringSlots, false);
  Reach reach_;
};

// One change of a case as steering says.
void change(spec::Case& c, Mode mode, const Steering& steering, ChoiceSource& source);

}  // namespace toolcomp::fuzz

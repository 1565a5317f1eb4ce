// SPDX-License-Identifier: Apache-2.0
#include "fuzz/campaign/steering.h"

#include <algorithm>
#include <utility>

#include "fuzz/gen/choices.h"
#include "fuzz/gen/mutate.h"
#include "fuzz/gen/push.h"
#include "spec/language/naming_clause.h"

namespace toolcomp::fuzz {
namespace {

// One change in so many pushes: it runs the model some ten times, where executing a case runs it once.
constexpr std::uint64_t kPushEvery = 24;

// The same on every machine.
constexpr std::uint32_t mixed(std::uint32_t hash, std::uint32_t value) {
  hash = (hash ^ value) * 0x9E3779B1U;
  return hash ^ (hash >> 15U);
}

std::uint32_t shape_of(const model::Event& event) {
  std::uint32_t hash = mixed(1, static_cast<std::uint32_t>(event.kind));
  hash = mixed(hash, static_cast<std::uint32_t>(event.type));
  hash = mixed(hash, static_cast<std::uint32_t>(event.cause));
  const auto clause = spec::naming_clause(event.clauses);
  return mixed(hash, clause ? static_cast<std::uint32_t>(*clause) + 1 : 0);
}

template <class Take>
void for_each_pair(const std::vector<model::Event>& events, Take take) {
  spec::ClauseList block;
  const auto close = [&] {
    for (std::size_t i = 0; i < block.size(); ++i)
      for (std::size_t k = i + 1; k < block.size(); ++k) {
        const auto one = static_cast<std::uint32_t>(block[i]);
        const auto other = static_cast<std::uint32_t>(block[k]);
        take(kFeatures + mixed(mixed(1, std::min(one, other)), std::max(one, other)) % kPairSlots, 1);
      }
    block = {};
  };
  std::uint64_t line = 0;
  for (const model::Event& event : events) {
    if (event.line != line) close();
    line = event.line;
    block.add(event.clauses);
  }
  close();
}

template <class Take>
void for_each_shape(const std::vector<model::Event>& events, Take take) {
  std::uint32_t last = 0;
  std::uint32_t before = 0;
  for (const model::Event& event : events) {
    const std::uint32_t now = shape_of(event);
    take(kFeatures + kPairSlots + mixed(mixed(now, last), before) % kShapeSlots, 1);
    before = std::exchange(last, now);
  }
}

template <class Take>
void for_each_slot(const judge::ModelRun& run, Take take) {
  for (const auto& [feature, count] : counted_features(run.recorder)) take(feature, count);
  for_each_pair(run.events, take);
  for_each_shape(run.events, take);
}

}  // namespace

bool Coverage::add(const judge::ModelRun& run) {
  bool fresh = false;
  for_each_slot(run, [&](std::size_t slot, std::uint64_t) {
    fresh = fresh || !slots_[slot];
    slots_[slot] = true;
  });
  return fresh;
}

void count_reached(const judge::ModelRun& run, std::span<std::uint8_t> counters) {
  constexpr std::uint64_t most = 255;
  for_each_slot(run, [&](std::size_t slot, std::uint64_t count) {
    counters[slot] = static_cast<std::uint8_t>(std::min(most, counters[slot] + count));
  });
}

void change(spec::Case& c, Mode mode, bool push, ChoiceSource& source) {
  Choices choose(source);
  if (push && choose.below(kPushEvery) == 0 && push_toward_boundary(c, choose)) return;
  mutate(c, mode, source);
}

}  // namespace toolcomp::fuzz

// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/passes/passes.h"

#include <utility>

namespace toolcomp::model {

std::vector<PassMaker> passes_of(const spec::Setup& setup) {
  const bool type_b = setup.cutter_compensation == spec::CutterCompensationType::b;
  return {leading_edge_offset, type_b ? cutter_compensation_b : cutter_compensation_c, tool_side_compensation};
}

Passes::Passes(const std::vector<PassMaker>& makers, const Pass::Place& place) {
  for (const PassMaker make : makers) passes_.push_back(make(place));
}

Passes::InForce Passes::in_force(Extent extent, const Command& command) const {
  InForce result;
  for (const auto& pass : passes_) {
    if (pass->extent() != extent) continue;
    result.before = result.before || pass->on();
    result.after = result.after || pass->on_after(command);
  }
  return result;
}

void Passes::refuse_rotary_word(const Command& command) const {
  for (const auto& pass : passes_) pass->refuse_rotary_word(command);
}

void Passes::read(Extent extent, const BlockWords& now, StepWords& words) {
  for (const auto& pass : passes_)
    if (pass->extent() == extent) pass->read(now, words);
}

void Passes::see(const BlockWay& way, StepWords& words) const {
  for (const auto& pass : passes_) pass->see(way, words);
}

OwnedStep Passes::next_of(std::size_t count) {
  if (count == 0) return std::move(made_);
  Pass& last = *passes_[count - 1];
  for (;;) {
    if (auto step = last.next()) return step;
    auto step = next_of(count - 1);
    if (!step && !ended_) return nullptr;
    if (!step) {
      last.end();
      return last.next();
    }
    if (!last.has(step->words)) return step;
    last.take(std::move(step));
  }
}

}  // namespace toolcomp::model

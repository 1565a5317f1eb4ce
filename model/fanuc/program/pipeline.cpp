// SPDX-License-Identifier: Apache-2.0
#include "model/fanuc/program/pipeline.h"

#include <algorithm>
#include <utility>

namespace toolcomp::model {

Pipeline::Pipeline(const std::vector<StageMaker>& makers, const spec::Setup& setup, const OffsetMemory& memory,
                   Recorder& recorder, Stage::Output output)
    : output_(std::move(output)) {
  for (std::size_t slot = 0; slot < makers.size(); ++slot)
    stages_.push_back(
        makers[slot]({setup, memory, recorder, slot, [this, slot](const Step& step) { pass(slot + 1, step); }}));
}

void Pipeline::pass(std::size_t slot, const Step& step) {
  if (slot < stages_.size())
    stages_[slot]->take(step);
  else
    output_(step);
}

Pipeline::InForce Pipeline::in_force(Extent extent, const Command& command) const {
  InForce result;
  for (const auto& stage : stages_) {
    if (stage->extent() != extent) continue;
    result.before = result.before || stage->on();
    result.after = result.after || stage->on_after(command);
  }
  return result;
}

bool Pipeline::takes_arc_about_its_start(const Command& command) const {
  return std::ranges::any_of(stages_, [&](const auto& stage) { return stage->takes_arc_about_its_start(command); });
}

void Pipeline::refuse_rotary_word(const Command& command) const {
  for (const auto& stage : stages_) stage->refuse_rotary_word(command);
}

void Pipeline::read(Extent extent, const StageCommand& now, Words& words) {
  words.resize(stages_.size());
  for (std::size_t slot = 0; slot < stages_.size(); ++slot)
    if (stages_[slot]->extent() == extent) words[slot] = stages_[slot]->read(now);
}

void Pipeline::add_way(Words& words, const BlockWay& way) const {
  for (std::size_t slot = 0; slot < stages_.size(); ++slot)
    if (words[slot]) stages_[slot]->add_way(*words[slot], way);
}

void Pipeline::complete(Words& words, const Step& step) const {
  for (std::size_t slot = 0; slot < stages_.size(); ++slot)
    if (words[slot]) stages_[slot]->complete(*words[slot], step);
}

bool Pipeline::has_words(const Words& words) {
  return std::ranges::any_of(words, [](const auto& of_stage) { return of_stage != nullptr; });
}

void Pipeline::take(const Step& step) { pass(0, step); }

void Pipeline::finish() {
  for (const auto& stage : stages_) stage->finish();
}

}  // namespace toolcomp::model

// SPDX-License-Identifier: Apache-2.0
// The stages of compensation of one run, one behind the other.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "model/fanuc/program/stage.h"

namespace toolcomp::model {

// Makes a stage at its place.
using StageMaker = std::unique_ptr<Stage> (*)(const Stage::Place& place);

// Asks every stage alike, and knows none of them.
class Pipeline {
 public:
  // What a block says to the stages, by slot; nothing for those it does not concern.
  using Words = std::vector<std::shared_ptr<StageWords>>;
  // Before and after a block.
  struct InForce {
    bool before = false;
    bool after = false;
    [[nodiscard]] bool any() const { return before || after; }
  };

  // `makers` in the order in which a step passes. Throws spec::InputError as the stages do.
  Pipeline(const std::vector<StageMaker>& makers, const spec::Setup& setup, const OffsetMemory& memory,
           Recorder& recorder, Stage::Output output);
  Pipeline(const Pipeline&) = delete;
  Pipeline& operator=(const Pipeline&) = delete;

  // Whether a compensation of this extent is on: Stage::on, Stage::on_after.
  [[nodiscard]] InForce in_force(Extent extent, const Command& command) const;
  // Stage::takes_arc_about_its_start, Stage::refuse_rotary_word.
  [[nodiscard]] bool takes_arc_about_its_start(const Command& command) const;
  void refuse_rotary_word(const Command& command) const;

  // Stage::read of the stages of this extent, in order.
  void read(Extent extent, const StageCommand& now, Words& words);
  // Stage::add_way and Stage::complete, where there are words.
  void add_way(Words& words, const BlockWay& way) const;
  void complete(Words& words, const Step& step) const;

  [[nodiscard]] static bool has_words(const Words& words);

  // The step passes through the stages.
  void take(const Step& step);
  // What the stages hold goes out as if nothing followed.
  void finish();

 private:
  // To the stage of this slot, or out behind the last one.
  void pass(std::size_t slot, const Step& step);

  std::vector<std::unique_ptr<Stage>> stages_;
  Stage::Output output_;
};

}  // namespace toolcomp::model

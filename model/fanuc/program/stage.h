// SPDX-License-Identifier: Apache-2.0
// What a section must be to stand in the pipeline: a stage of compensation.
//
// A stage reads what every command says to it, takes the steps in order, and hands them on in order with the vectors
// of their moves. In between it may hold steps until the vector at their end is known.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "model/basis/recorder.h"
#include "model/fanuc/program/interpreter.h"
#include "model/fanuc/program/offset_memory.h"
#include "model/fanuc/program/step.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// What the words of one block mean to one stage. A step carries one for each stage; only the stage itself, or the
// sections that share it, look inside.
class StageWords {
 public:
  StageWords() = default;
  StageWords(const StageWords&) = default;
  StageWords(StageWords&&) = default;
  StageWords& operator=(const StageWords&) = default;
  StageWords& operator=(StageWords&&) = default;
  virtual ~StageWords() = default;
};

// Where the vectors of a stage lie. It decides when its words are read, in the fixed order of alarms.
enum class Extent : std::uint8_t {
  space,  // read before the block renames the position or changes the workpiece system
  plane   // read behind that
};

// A command as the stages read it.
struct StageCommand {
  const Command& command;
  const Interpreter& interpreter;  // the position is where the block starts
  bool directed = false;           // G43.5 is in force in the block: I J K are a tool direction

  // An axis word, or I J K as a tool direction.
  [[nodiscard]] bool moves() const { return command.axes != 0 || (directed && command.direction); }
};

// The way of a block, before compensation, once it is known.
struct BlockWay {
  const Leg& start;  // stays where the block starts
  const std::vector<Leg>& legs;
  // The tool where the axes stand at a position, in the coordinates in force. It is then in force.
  std::function<Direction(const Position&)> tool_at;
};

// One of them at most is on; the others hand on what they take.
class Stage {
 public:
  using Output = std::function<void(const Step& step)>;
  // What a stage is made of. `slot`: where a step carries its words; `output`: what comes behind it.
  struct Place {
    const spec::Setup& setup;
    const OffsetMemory& memory;
    Recorder& recorder;
    std::size_t slot;
    Output output;
  };

  explicit Stage(const Place& place) : recorder_(place.recorder), slot_(place.slot), output_(place.output) {}
  virtual ~Stage() = default;
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  [[nodiscard]] virtual Extent extent() const = 0;
  // A block goes out at the latest with the block this many behind it; blocks without words are not counted.
  [[nodiscard]] virtual int look_ahead() const = 0;

  // The mode is on before the next command that is read.
  [[nodiscard]] virtual bool on() const = 0;
  // By its words it is on after this command, which is read next or has been read last.
  [[nodiscard]] virtual bool on_after(const Command& command) const = 0;
  // In this block an arc whose centre is its start is for the stage to judge.
  [[nodiscard]] virtual bool takes_arc_about_its_start(const Command& /*command*/) const { return false; }
  // There is a rotary axis word under G43.5. Throws the alarm of the stage, where it has one of its own.
  virtual void refuse_rotary_word(const Command& /*command*/) const {}

  // Four times for each block, in this order. What its words mean, without its way; nothing before the first words of
  // the stage in a program. Throws the alarms that words alone raise; the block is then not taken.
  virtual std::shared_ptr<StageWords> read(const StageCommand& now) = 0;
  // Where it had words: its way is known.
  virtual void add_way(StageWords& /*words*/, const BlockWay& /*way*/) const {}
  // Where it had words: its step is made, but for the clauses applied up to now.
  virtual void complete(StageWords& /*words*/, const Step& /*step*/) const {}
  // The step itself. An Alarm without a line is one of this step: what is held goes out by finish(). An Alarm with a
  // line belongs to an earlier block; what may go out before it has gone.
  virtual void take(const Step& step) = 0;
  // No block follows: the end of the program, or a block that ends the run by an alarm.
  virtual void finish() = 0;

 protected:
  [[nodiscard]] Recorder& recorder() const { return recorder_; }
  [[nodiscard]] std::size_t slot() const { return slot_; }
  void hand_on(const Step& step) const { output_(step); }

 private:
  Recorder& recorder_;
  std::size_t slot_;
  Output output_;
};

// A stage and the words of its own.
template <class Words>
class StageOf : public Stage {
 public:
  using Stage::Stage;

 protected:
  [[nodiscard]] bool has_words(const Step& step) const { return step.words.at(slot()) != nullptr; }
  // What the block of a step says to this stage, where it says anything.
  [[nodiscard]] const Words& said(const Step& step) const { return static_cast<const Words&>(*step.words.at(slot())); }
  [[nodiscard]] static Words& own(StageWords& words) { return static_cast<Words&>(words); }
};

}  // namespace toolcomp::model

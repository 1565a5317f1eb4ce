// SPDX-License-Identifier: Apache-2.0
// What a section of compensation is: a pass over the blocks of a program.
//
// A pass reads the words of every block, plans the block, and makes its moves as soon as the blocks that follow it are
// known far enough: (vectors in force, this block, the blocks that follow) -> (moves of this block, vectors in force).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "model/basis/recorder.h"
#include "model/fanuc/program/interpreter.h"
#include "model/fanuc/program/offset_memory.h"
#include "model/fanuc/program/step.h"
#include "spec/language/setup.h"

namespace toolcomp::model {

// Where the vectors of a pass lie. It decides when its words are read, in the fixed order of alarms.
enum class Extent : std::uint8_t {
  space,  // read before the block renames the position or changes the workpiece system
  plane   // read after that
};

// The words of a block as the passes read them.
struct BlockWords {
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

// One of them at most is on.
class Pass {
 public:
  struct Place {
    const spec::Setup& setup;
    const OffsetMemory& memory;
    Recorder& recorder;
  };

  explicit Pass(const Place& place) : place_(place) {}
  virtual ~Pass() = default;
  Pass(const Pass&) = delete;
  Pass& operator=(const Pass&) = delete;

  [[nodiscard]] virtual Extent extent() const = 0;
  // A block goes out at the latest with the block this many after it; blocks without words are not counted.
  [[nodiscard]] virtual int look_ahead() const = 0;

  // The mode is on before the next command that is read.
  [[nodiscard]] virtual bool on() const = 0;
  // By its words it is on after this command, which is read next or has been read last.
  [[nodiscard]] virtual bool on_after(const Command& command) const = 0;
  // There is a rotary axis word under G43.5. Throws the alarm of the pass, if it has one of its own.
  virtual void refuse_rotary_word(const Command& /*command*/) const {}

  // The words of the next block, without its way; nothing before the first words of the pass in a program. Throws the
  // alarms that words alone raise; the block is then not taken.
  virtual void read(const BlockWords& now, StepWords& words) = 0;
  // Its way is known.
  virtual void see(const BlockWay& /*way*/, StepWords& /*words*/) const {}
  // Whether the block is one for this pass. Before one that is not, nothing waits in it.
  [[nodiscard]] virtual bool has(const StepWords& words) const = 0;
  // Plans a block for this pass. Throws Alarm or LeftOpen, and the block is then not taken.
  virtual void take(OwnedStep step) = 0;
  // No block follows: the end of the program, or a block that ends the run.
  virtual void end() = 0;
  // The next block with its moves; nothing as long as it has to wait for others. An Alarm or LeftOpen without a line is
  // one of the block taken last. With a line it belongs to an earlier block, and nothing is left.
  virtual OwnedStep next() = 0;

 protected:
  [[nodiscard]] Recorder& recorder() const { return place_.recorder; }
  [[nodiscard]] const spec::Setup& setup() const { return place_.setup; }
  [[nodiscard]] const OffsetMemory& memory() const { return place_.memory; }

 private:
  Place place_;
};

}  // namespace toolcomp::model

// What lemmas about tool center point control read from setup, program and events.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "corpus/proofs/fanuc/tool.h"

namespace toolcomp::corpus {

// A machine whose rotary axes lie along X, Y or Z, with the tool in Z where they stand at 0.
struct RotaryMachine {
  bool head = false;
  std::size_t tool_axis = 0;  // controlled axis on the tool side, and on the work side
  std::size_t work_axis = 0;
  std::string tool_line;  // "ex"
  std::string work_line;
  int tool_sense = 1;  // as it acts on the direction of the tool
  int work_sense = 1;
};

// Nothing for inclined axes, tilted tools, hypothetical axes and offsets of the head.
std::optional<RotaryMachine> rotary_machine(const spec::Setup& setup);

// The direction that the block of this line commands under G43.5 by I J K, where that is the direction at its end in
// the zero frame of the table. Nothing where the program leans the tool, changes end postures, or starts G43.5 with the
// table turned.
std::optional<Exact3> commanded_direction(const spec::Case& c, const Blocks& blocks, std::uint64_t line);

// The recorded number as a fraction, exact or its decimal.
Rational decimal_of(const spec::NumberText& number);
Exact3 decimal_of(const std::array<spec::NumberText, 3>& numbers);

}  // namespace toolcomp::corpus

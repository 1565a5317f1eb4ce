// SPDX-License-Identifier: Apache-2.0
#include "certify/view/tool_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "judge/laws/fanuc/fanuc_program.h"
#include "judge/laws/heidenhain/klartext_program.h"
#include "judge/oracle/number.h"

namespace toolcomp::certify {
namespace {

double in_double(const std::optional<exact::Rational>& value) {
  return value ? judge::approximate(exact::Real(*value)) : 0;
}

std::optional<ToolShape> shape_of(const spec::Setup& setup, const judge::laws::FanucBlock& block) {
  ToolShape shape;
  if (block.d.value_or(0) > 0) {
    shape.radius = std::abs(in_double(judge::laws::cutter_value(setup, *block.d)));
    shape.name = fmt::format("D{}", *block.d);
  }
  if (block.h.value_or(0) > 0) {
    shape.length = std::max(0.0, in_double(judge::laws::length_value(setup, *block.h)));
    shape.name += fmt::format("{}H{}", shape.name.empty() ? "" : " ", *block.h);
  }
  return shape.radius > 0 ? std::optional(shape) : std::nullopt;
}

std::optional<ToolShape> shape_of(const judge::laws::Cutter& cutter) {
  ToolShape shape;
  shape.corner = std::max(0.0, judge::approximate(cutter.effective_r2));
  shape.radius = std::max(judge::approximate(cutter.effective_ring) + shape.corner, shape.corner);
  if (cutter.length) shape.length = std::max(0.0, judge::approximate(*cutter.length));
  shape.name = "tool table and deltas";
  return shape.radius > 0 ? std::optional(shape) : std::nullopt;
}

}  // namespace

ToolShapes::ToolShapes(const spec::Case& c) {
  if (c.setup.control == spec::Control::fanuc) {
    const judge::laws::FanucProgram program(c);
    for (const judge::laws::FanucBlock& block : program.blocks()) by_line_[block.line] = shape_of(c.setup, block);
    return;
  }
  const judge::laws::KlartextProgram program(c);
  const auto lines = static_cast<std::uint64_t>(std::ranges::count(c.program, '\n')) + 1;
  for (std::uint64_t line = 1; line <= lines; ++line)
    if (const judge::laws::KlartextBlock* block = program.block(line))
      by_line_[line] = block->cutter ? shape_of(*block->cutter) : std::nullopt;
}

std::optional<ToolShape> ToolShapes::at(std::uint64_t line) const {
  const auto later = by_line_.upper_bound(line);
  return later == by_line_.begin() ? std::nullopt : std::prev(later)->second;
}

}  // namespace toolcomp::certify

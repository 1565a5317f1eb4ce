#include "certify/trace/causes/programmed_path.h"

#include <utility>
#include <vector>

#include "certify/convert.h"
#include "certify/trace/causes/listed_path.h"
#include "certify/trace/metric.h"
#include "certify/trace/program_path.h"
#include "fuzz/oracle/number.h"
#include "fuzz/oracle/verdict.h"

namespace toolcomp::certify {
std::unique_ptr<PathSource> programmed_path(const spec::Case& c, const TraceSpace& space) {
  if (!c.setup.parameter(19680)) return nullptr;
  std::vector<PathPiece> pieces;
  bool controlled = false;
  AxisPoint at{};
  for (const auto& [letter, start] : c.setup.position)
    if (const std::size_t axis = c.setup.axes.index(letter); axis != spec::Axes::kNone)
      at.at(axis) = fuzz::approximate(start);
  spec::Case own = c;
  own.samples = 0;
  for (const model::Event& exact : fuzz::run_model(own).events) {
    if (exact.kind == spec::EventKind::undecided) return nullptr;
    if (exact.kind != spec::EventKind::move) continue;
    // Turns of the work-side axis before and behind a block are made for the tool's sake alone.
    if (exact.cause == spec::Cause::pre_turn || exact.cause == spec::Cause::post_turn) continue;
    const spec::Event<double> event = in_double(exact);
    controlled = controlled || event.tool_axis;
    PathPiece piece;
    piece.begin = at;
    for (const std::size_t axis : space.linear) at.at(axis) = event.programmed[axis];
    for (const std::size_t axis : space.rotary) at.at(axis) = event.axes[axis];
    piece.end = at;
    piece.line = event.line;
    piece.n = event.n;
    pieces.push_back(piece);
  }
  if (!controlled) return nullptr;
  return std::make_unique<ListedPath>(std::make_shared<const std::vector<PathPiece>>(std::move(pieces)));
}

}  // namespace toolcomp::certify

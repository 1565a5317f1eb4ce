// SPDX-License-Identifier: Apache-2.0
#include "judge/laws/heidenhain/scene.h"

#include "judge/laws/numbers.h"

namespace toolcomp::judge::laws {
namespace {

std::vector<SpaceMove> moves_of(const spec::Axes& axes, const KlartextProgram& program,
                                std::span<const model::Event> events) {
  std::vector<SpaceMove> moves;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const model::Event& event = events[i];
    if (event.kind != spec::EventKind::move || !event.space || !event.tool_axis) continue;
    const KlartextBlock* block = program.block(event.line);
    const auto programmed = xyz(axes, event.programmed);
    const auto tip = xyz(axes, event.point);
    if (block == nullptr || !programmed || !tip) continue;
    Vector side;
    if (event.space->contact) side = cross(event.space->contact->normal, *event.tool_axis);
    moves.push_back({&event, i, block, *programmed, *tip, *event.tool_axis, side});
  }
  return moves;
}

}  // namespace

KlartextScene::KlartextScene(const spec::Case& made, std::span<const model::Event> given)
    : c(made), events(given), klartext(made), moves(moves_of(made.setup.axes, klartext, given)) {}

}  // namespace toolcomp::judge::laws

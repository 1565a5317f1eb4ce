#include <algorithm>
#include <array>
#include <stdexcept>

#include "fuzz/laws/beside_the_path.h"
#include "fuzz/laws/commanded_direction.h"
#include "fuzz/laws/contact.h"
#include "fuzz/laws/laws.h"
#include "fuzz/laws/leading_edge.h"
#include "fuzz/laws/offsets.h"
#include "fuzz/laws/tool_center_point.h"

namespace toolcomp::fuzz::laws {
namespace {

struct Law {
  LawInfo info;
  void (*ask)(const Scene&, Holding&);
};

constexpr Law kLaws[] = {
    {{"perpendicular-to-the-tool",
      "the vector at the end of a block displaced across its own tool is perpendicular to it"},
     perpendicular_to_the_tool},
    {{"not-nearer-than-the-radius", "no head is nearer to its corner than the radius"}, not_nearer_than_the_radius},
    {{"beside-the-line-before", "the first head at a corner is at the radius from the line before"},
     beside_the_line_before},
    {{"beside-the-line-after", "the last head at a corner is at the radius from the line after"},
     beside_the_line_after},
    {{"beside-the-arc", "heads of an arc lie on the circle parallel to it"}, beside_the_arc},
    {{"normal-of-the-block", "type B: the vector is the radius along the normal of its block"}, normal_of_the_block},
    {{"on-the-path-without-a-mode", "without a mode there is no vector, and cancelling ends on the programmed path"},
     on_the_path_without_a_mode},
    {{"leading-edge-vector", "the vector is across the tool, in the plane of tool and movement, of the radius long"},
     leading_edge_vector},
    {{"length-offset", "the axes go to the point plus the offset of the block"}, length_offset},
    {{"length-offset-stays", "the length offset changes only where a block says so"}, length_offset_stays},
    {{"signed-sums", "the shift grows by the signed offset in every commanded axis"}, signed_sums},
    {{"measured-difference", "the new offset is the old one plus the difference measured"}, measured_difference},
    {{"axis-of-the-positions", "the tool axis is that of the rotary positions"}, axis_of_the_positions},
    {{"tip-of-the-axes", "the tip that belongs to the axes, seen from the table, is the point"}, tip_of_the_axes},
    {{"tip-on-the-path", "seen from the table the tip runs on its line or arc, in proportion"}, tip_on_the_path},
    {{"commanded-direction", "the tool axis is the commanded direction, leant toward the travel by Q"},
     commanded_direction},
    {{"changed-end",
      "an end that P1 changes lies beyond the singular posture the tool comes near, with the work side still"},
     changed_end},
    {{"great-circle", "under P1 the tool stays in the plane of both ends and turns by equal angles"}, great_circle},
    {{"positions-in-proportion", "under P0 rotary axes go in proportion"}, positions_in_proportion},
    {{"positions-as-programmed", "rotary axes end at their words"}, positions_as_programmed},
    {{"touches-the-contact-plane", "the effective tool touches the plane of contact point and normal in that point"},
     touches_the_contact_plane},
    {{"nominal-tool-touches", "the nominal tool at the programmed point touches it in the same point"},
     nominal_tool_touches},
    {{"direction-of-the-tool", "tool axis and normal have their programmed directions"}, direction_of_the_tool},
    {{"length-along-the-tool", "lengths act along the tool"}, length_along_the_tool},
    {{"shift-of-the-tip", "the shift leads from the nominal tip to the effective one"}, shift_of_the_tip},
    {{"cylinder-beside-the-line", "under RL and RR the cylinder is tangent to its lines, at delta from them"},
     cylinder_beside_the_line},
};

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

// A law with a question that cannot be answered (a sign that is not certified) says nothing more: it is left open.
void ask(const Law& law, const Scene& scene, Verdict& verdict) {
  Holding holding(law.info.name, scene.events);
  try {
    law.ask(scene, holding);
  } catch (const exact::Undecided&) {
    ++verdict.left_open;
  }
  verdict.checks += holding.checks();
  if (!verdict.violation) verdict.violation = holding.violation();
}

}  // namespace

Scene::Scene(const spec::Case& made, std::span<const model::Event> given)
    : c(made), events(given), program(made), klartext(made) {
  if (c.setup.control != spec::Control::fanuc) {
    moves = moves_of(c.setup.axes, klartext, events);
    return;
  }
  stops = stops_of(c.setup.axes, program, events);
  if (program.has_code({434, 435})) machine = Machine::of(c.setup);
  if (machine) runs = runs_of(c.setup, program, events, *machine);
}

std::span<const LawInfo> all() {
  static const auto infos = [] {
    std::array<LawInfo, std::size(kLaws)> list;
    std::ranges::transform(kLaws, list.begin(), &Law::info);
    return list;
  }();
  return infos;
}

Verdict hold(const spec::Case& c, std::span<const model::Event> events) {
  const Scene scene(c, events);
  Verdict verdict;
  for (const Law& law : kLaws)
    if (!verdict.violation) ask(law, scene, verdict);
  return verdict;
}

Verdict hold(std::string_view name, const spec::Case& c, std::span<const model::Event> events) {
  const auto* law = std::ranges::find_if(kLaws, [name](const Law& l) { return l.info.name == name; });
  if (law == std::end(kLaws)) throw std::invalid_argument("no law " + std::string(name));
  Verdict verdict;
  ask(*law, Scene(c, events), verdict);
  return verdict;
}

}  // namespace toolcomp::fuzz::laws

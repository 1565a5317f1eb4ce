// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <stdexcept>

#include "judge/laws/fanuc/beside_the_path.h"
#include "judge/laws/fanuc/commanded_direction.h"
#include "judge/laws/fanuc/holes.h"
#include "judge/laws/fanuc/leading_edge.h"
#include "judge/laws/fanuc/offsets.h"
#include "judge/laws/fanuc/tool_center_point.h"
#include "judge/laws/heidenhain/contact.h"
#include "judge/laws/heidenhain/holes.h"
#include "judge/laws/laws.h"

namespace toolcomp::judge::laws {
namespace {

template <class Scene>
struct Law {
  LawInfo info;
  void (*ask)(const Scene&, Holding&);
};

constexpr Law<FanucScene> kFanucLaws[] = {
    {{"perpendicular-to-the-tool",
      "the vector at the end of a block displaced across its own tool is perpendicular to it"},
     perpendicular_to_the_tool},
    {{"not-nearer-than-the-radius", "no head is nearer to its corner than the radius"}, not_nearer_than_the_radius},
    {{"beside-the-line-before", "the first head at a corner is one radius away from the line before"},
     beside_the_line_before},
    {{"beside-the-line-after", "the last head at a corner is one radius away from the line after"},
     beside_the_line_after},
    {{"beside-the-arc", "heads of an arc lie on the circle parallel to it"}, beside_the_arc},
    {{"normal-of-the-block", "type B: the vector is along the normal of its block, and as long as the radius"},
     normal_of_the_block},
    {{"on-the-path-without-a-mode", "without a mode there is no vector, and cancelling ends on the programmed path"},
     on_the_path_without_a_mode},
    {{"where-the-tool-is-said-to-be", "G92 gives the place of the tool: there is no vector at that place"},
     where_the_tool_is_said_to_be},
    {{"leading-edge-vector",
      "the vector is at right angles to the tool, in the plane of tool and movement, and as long as the radius"},
     leading_edge_vector},
    {{"length-offset", "the axes go to the point plus the offset of the block"}, length_offset},
    {{"length-offset-stays", "the length offset changes only where a block says so"}, length_offset_stays},
    {{"by-the-words-alone", "a length offset that shifts the system moves nothing: under G91 the axes go by the words"},
     by_the_words_alone},
    {{"signed-sums", "the shift grows by the signed offset in every commanded axis"}, signed_sums},
    {{"hole-where-commanded", "a block drills the commanded number of holes, at the commanded places"},
     hole_where_commanded},
    {{"hole-levels", "point R, bottom and level of return are those of the words, from where the mode began"},
     hole_levels},
    {{"hole-axes", "after a hole the axes are at its position and level, plus the length offset in force"}, hole_axes},
    {{"measured-difference", "the new offset is the old one plus the difference measured"}, measured_difference},
    {{"axis-of-the-positions", "the tool axis is that of the rotary positions"}, axis_of_the_positions},
    {{"tip-of-the-axes", "the tip that belongs to the axes, seen from the table, is the point"}, tip_of_the_axes},
    {{"offset-taken-back", "a G49 that removes the offset sends the axes to the place where the tip was"},
     offset_taken_back},
    {{"tip-on-the-path", "seen from the table, the tip runs evenly on its line or arc"}, tip_on_the_path},
    {{"commanded-direction", "the tool axis is the commanded direction, leant toward the travel by Q"},
     commanded_direction},
    {{"changed-end",
      "an end that P1 changes is beyond the singular posture that the tool comes near, and the work-side axis does not "
      "turn"},
     changed_end},
    {{"great-circle", "under P1 the tool stays in the plane of both ends and turns by equal angles"}, great_circle},
    {{"positions-in-proportion", "under P0 rotary axes turn evenly"}, positions_in_proportion},
    {{"positions-as-programmed", "rotary axes end at the positions of their words"}, positions_as_programmed},
};

constexpr Law<KlartextScene> kKlartextLaws[] = {
    {{"touches-the-contact-plane", "the effective tool touches the plane of contact point and normal in that point"},
     touches_the_contact_plane},
    {{"nominal-tool-touches", "the nominal tool at the programmed point touches it in the same point"},
     nominal_tool_touches},
    {{"direction-of-the-tool", "tool axis and normal have their programmed directions"}, direction_of_the_tool},
    {{"tool-as-the-axes-stand", "under TCPM the tool has the direction that its rotary axes give"},
     tool_as_the_axes_stand},
    {{"length-along-the-tool", "lengths act along the tool"}, length_along_the_tool},
    {{"shift-of-the-tip", "the shift leads from the nominal tip to the effective one"}, shift_of_the_tip},
    {{"cylinder-beside-the-line", "under RL and RR the cylinder is tangent to its lines, at delta from them"},
     cylinder_beside_the_line},
    {{"hole-where-programmed", "a call drills one hole at the place of the tool, and the next move starts there"},
     hole_where_programmed},
    {{"hole-by-its-parameters",
      "Q200, Q201, Q203 and Q204 give the beginning, the bottom and the level of return of a hole"},
     hole_by_its_parameters},
    {{"hole-with-length", "after a hole the axes are at its position and level, plus the deltas of the length"},
     hole_with_length},
};

// A law with a question that cannot be answered (a sign that is not certified) says nothing more: it is left open.
template <class Scene>
void ask(const Law<Scene>& law, const Scene& scene, LawResult& result) {
  Holding holding(law.info.name, scene.events);
  try {
    law.ask(scene, holding);
  } catch (const exact::Undecided&) {
    ++result.left_open;
  }
  result.checks += holding.checks();
  if (!result.violation) result.violation = holding.violation();
}

// The laws of one dialect up to the first that is broken; `only` one of them, or all.
template <class Scene, std::size_t N>
LawResult ask_all(const Law<Scene> (&laws)[N], const Scene& scene, std::string_view only) {
  LawResult result;
  for (const Law<Scene>& law : laws)
    if (!result.violation && (only.empty() || law.info.name == only)) ask(law, scene, result);
  return result;
}

LawResult ask_all(const spec::Case& c, std::span<const model::Event> events, std::string_view only) {
  if (c.setup.control == spec::Control::fanuc) {
    const FanucScene scene(c, events);
    // Laws find the block of an event by its line; where programs are called a line may run more than once.
    return scene.program.calls() ? LawResult() : ask_all(kFanucLaws, scene, only);
  }
  return ask_all(kKlartextLaws, KlartextScene(c, events), only);
}

}  // namespace

std::span<const LawInfo> all() {
  static const auto infos = [] {
    std::array<LawInfo, std::size(kFanucLaws) + std::size(kKlartextLaws)> list;
    auto* const behind = std::ranges::transform(kFanucLaws, list.begin(), &Law<FanucScene>::info).out;
    std::ranges::transform(kKlartextLaws, behind, &Law<KlartextScene>::info);
    return list;
  }();
  return infos;
}

LawResult hold(const spec::Case& c, std::span<const model::Event> events) { return ask_all(c, events, ""); }

LawResult hold(std::string_view name, const spec::Case& c, std::span<const model::Event> events) {
  if (std::ranges::find(all(), name, &LawInfo::name) == all().end())
    throw std::invalid_argument("no law " + std::string(name));
  return ask_all(c, events, name);
}

}  // namespace toolcomp::judge::laws

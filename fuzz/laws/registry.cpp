#include <algorithm>
#include <array>
#include <stdexcept>

#include "fuzz/laws/beside_the_path.h"
#include "fuzz/laws/laws.h"

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
};

// A law whose questions cannot be answered (a sign that is not certified) has said nothing more.
void ask(const Law& law, const Scene& scene, Verdict& verdict) {
  Holding holding(law.info.name, scene.events);
  try {
    law.ask(scene, holding);
  } catch (const exact::Undecided&) {
  }
  verdict.checks += holding.checks();
  if (!verdict.violation) verdict.violation = holding.violation();
}

}  // namespace

Scene::Scene(const spec::Case& made, std::span<const model::Event> given) : c(made), events(given), program(made) {
  if (c.setup.control == spec::Control::fanuc) stops = stops_of(c.setup.axes, program, events);
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

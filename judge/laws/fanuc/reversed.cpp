// SPDX-License-Identifier: Apache-2.0
// A contour run from its end.
#include <optional>
#include <string>

#include "judge/laws/fanuc/changed.h"
#include "judge/laws/fanuc/scene.h"
#include "judge/laws/numbers.h"

namespace toolcomp::judge::laws {
namespace {

// A contour of compensated lines in one piece: the stops from start-up to the last before the cancelling move.
struct Contour {
  std::size_t first = 0;
  std::size_t cancel = 0;
};

std::optional<Contour> contour_of(const FanucScene& s) {
  const auto plain_line = [&](const Stop& stop) {
    const FanucBlock& b = s.block(stop);
    if (stop.own->type == spec::MoveType::arc || (b.motion != kG00 && b.motion != kG01) || !b.is_plain()) return false;
    // In the plane: Z-X for G18, Y-Z for G19.
    const std::size_t across = b.plane == kG19 ? 0 : b.plane == kG18 ? 1 : 2;
    bool moves = false;
    for (std::size_t i = 0; stop.displacement && i < 3; ++i)
      moves = moves || (i != across && certainly_not_zero(stop.displacement->at(i)));
    return moves;
  };
  for (std::size_t k = 1; k < s.stops.size(); ++k) {
    const FanucBlock& begun = s.block(s.stops[k]);
    if (s.stops[k].own->cause != spec::Cause::start_up || !begun.d || *begun.d == 0 || !plain_line(s.stops[k]))
      continue;
    if (begun.compensation != kG41 && begun.compensation != kG42) continue;
    for (std::size_t i = k + 1; i < s.stops.size(); ++i) {
      const Stop& stop = s.stops[i];
      const FanucBlock& b = s.block(stop);
      if (!plain_line(stop) || stop.block != s.stops[i - 1].block + 1 || b.plane != begun.plane || b.d != begun.d)
        break;
      if (stop.own->cause == spec::Cause::cancel && b.compensation == kG40 && !b.has('I') && !b.has('J') &&
          !b.has('K')) {
        if (i > k + 1) return Contour{k, i};
        break;
      }
      if (stop.own->cause != spec::Cause::programmed || b.says_compensation()) break;
    }
  }
  return std::nullopt;
}

// "X10. Y-20. Z0."; nothing where a coordinate is no decimal.
std::optional<std::string> words_of(const Vector& point) {
  std::string text;
  for (std::size_t i = 0; i < point.size(); ++i) {
    const auto number = point.at(i).is_rational() ? decimal(point.at(i).rational()) : std::nullopt;
    if (!number) return std::nullopt;
    text += std::string(" ") + "XYZ"[i] + to_string(*number);
  }
  return text;
}

}  // namespace

void reversed(const spec::Case& c, std::span<const model::Event> events, const Runner& run, Holding& holding) {
  if (!c.setup.bit(5008, 0) || c.setup.bit(5003, 1) || c.setup.bit(5001, 2) ||
      c.setup.cutter_compensation != spec::CutterCompensationType::c)
    return;
  if (const auto limit = c.setup.parameter(5010); limit && !limit->is_zero()) return;
  const FanucScene scene(c, events);
  if (scene.program.has_code(
          {kG10, kG20, kG21, kG28, kG29, kG30, kG30_1, kG37, kG43_4, kG43_5, kG45, kG46, kG47, kG48, kG52, kG53, kG92}))
    return;
  const auto contour = contour_of(scene);
  if (!contour) return;
  const FanucBlock& begun = scene.block(scene.stops[contour->first]);
  std::string text = "G90 G01 F100 G" + std::to_string(begun.plane / 10);
  for (std::size_t i = contour->cancel + 1; i-- + 1 > contour->first;) {
    const auto words = words_of(scene.stops[i].programmed);
    if (!words) return;
    if (i + 1 == contour->cancel) text += (begun.compensation == kG41 ? "G42 D" : "G41 D") + std::to_string(*begun.d);
    if (i + 1 == contour->first) text += "G40";
    text += *words + '\n';
    if (i + 1 == contour->first) break;
  }
  spec::Case changed = c;
  changed.program = text;
  const std::vector<model::Event> other = run(changed);
  if (is_open(other)) return;
  const FanucScene image(changed, other);
  for (std::size_t i = contour->first; i < contour->cancel; ++i) {
    const std::vector<Head>& heads = scene.stops[i].heads;
    const std::size_t event = scene.stops[i].event;
    const std::size_t at = contour->cancel - i;
    holding.holds(at < image.stops.size() && image.stops[at].heads.size() == heads.size(), event,
                  "as many heads as at the corner of the reversed contour");
    if (at >= image.stops.size() || image.stops[at].heads.size() != heads.size()) return;
    for (std::size_t k = 0; k < heads.size(); ++k)
      holding.zero(heads[k].vector - image.stops[at].heads[heads.size() - 1 - k].vector, heads[k].event,
                   "head, less that of the reversed contour");
  }
}

}  // namespace toolcomp::judge::laws

// How far samples are from the path between two matched places.
#include <algorithm>
#include <limits>

#include "certify/trace/fault.h"

namespace toolcomp::certify {
namespace {

struct NearestPlace {
  std::size_t piece = 0;
  double at = 0;
  double in_tolerances = std::numeric_limits<double>::infinity();
};

Part part_between(std::size_t piece, const PathPlace& from, const PathPlace& to) {
  return {piece == from.piece ? from.at : 0,
          piece == to.piece ? std::max(to.at, piece == from.piece ? from.at : 0) : 1};
}

NearestPlace nearest(const PathWindow& path, const Metric& metric, const AxisPoint& p, const PathPlace& from,
                     const PathPlace& to) {
  NearestPlace best;
  path.boxes().visit(
      from.piece, to.piece + 1,
      [&](const Box& box) { return metric.in_tolerances(metric.outside(box, p)) >= best.in_tolerances; },
      [&](std::size_t number) {
        const PathPiece& piece = path[number].piece;
        const double t = metric.closest(piece.begin, piece.end, p, part_between(number, from, to));
        const double d = metric.in_tolerances(metric.at(piece.begin, piece.end, t, p));
        if (d < best.in_tolerances) best = {number, t, d};
      });
  return best;
}

// On a move whose inside is not judged no sample is off the path.
bool holds_free_move(const FaultScene& scene, std::size_t from, std::size_t to) {
  for (std::size_t piece = from; piece <= to; ++piece)
    if (scene.path[piece].piece.free) return true;
  return false;
}

bool near_any_piece(const FaultScene& scene, const AxisPoint& p) {
  bool any = false;
  scene.path.near(scene.path.first(), scene.path.end(), p, [&](std::size_t, const Part&) { any = true; });
  return any;
}

}  // namespace

SamplesOff samples_off(const Fault& fault, const FaultScene& scene) {
  SamplesOff off;
  const Metric& metric = scene.metric;
  const PathPlace to = fault.end ? PathPlace{scene.path.end() - 1, 1} : fault.back_high;
  if (holds_free_move(scene, fault.left_low.piece, to.piece)) return off;
  const Metric linear = metric.linear_only();
  const Metric rotary = metric.rotary_only();
  // From the sample to the nearest place of that kind.
  const auto alone = [&](const Metric& kind, const AxisPoint& p) {
    const NearestPlace place = nearest(scene.path, kind, p, fault.left_low, to);
    const PathPiece& piece = scene.path[place.piece].piece;
    return kind.at(piece.begin, piece.end, place.at, p);
  };
  for (const RunSample& s : scene.run.samples()) {
    const std::uint64_t number = s.sample.number;
    const bool matched = (number <= fault.from && !fault.begin) || (number >= fault.to && !fault.end);
    if (matched || number < fault.from || number > fault.to) continue;
    off.any = true;
    const AxisPoint& p = s.sample.at;
    const NearestPlace place = nearest(scene.path, metric, p, fault.left_low, to);
    const PathPiece& piece = scene.path[place.piece].piece;
    const Distance distance = metric.at(piece.begin, piece.end, place.at, p);
    if (!metric.exceeds(distance, scene.path.limit(place.piece, s.sample.magnitude))) continue;
    if (off.count == 0) {
      off.csv_line = s.sample.line;
      off.move = {piece.line, piece.n};
    }
    off.count += s.stands_for;
    off.on_other_path = off.on_other_path && near_any_piece(scene, p);
    const Distance& thinned = scene.run.error();
    off.farthest.take(p, point_at(piece.begin, piece.end, place.at),
                      {piece.error.linear + thinned.linear, piece.error.rotary + thinned.rotary}, metric,
                      s.sample.line);
    if (!metric.mixed()) continue;
    Distance& least = off.farthest.alone;
    least = {std::max(least.linear, alone(linear, p).linear), std::max(least.rotary, alone(rotary, p).rotary)};
  }
  return off;
}

}  // namespace toolcomp::certify

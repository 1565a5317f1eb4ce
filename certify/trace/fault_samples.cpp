// SPDX-License-Identifier: Apache-2.0
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

// Finds the nearest place between two; samples in a row are near the same piece.
class NearestOnPath {
 public:
  NearestOnPath(const PathWindow& path, const Metric& metric, const PathPlace& from, const PathPlace& to)
      : path_(path), metric_(metric), from_(from), to_(to), near_(from.piece) {}

  NearestPlace to(const AxisPoint& p) {
    NearestPlace best;
    try_piece(near_, p, best);
    path_.boxes().visit(
        from_.piece, to_.piece + 1,
        [&](const AxisBox& box) { return metric_.in_tolerances(metric_.outside(box, p)) >= best.in_tolerances; },
        [&](std::size_t number) { try_piece(number, p, best); });
    near_ = best.piece;
    return best;
  }
  Distance distance(const AxisPoint& p) {
    const NearestPlace place = to(p);
    const PathPiece& piece = path_[place.piece].piece;
    return metric_.at(piece.begin, piece.end, place.at, p);
  }

 private:
  void try_piece(std::size_t number, const AxisPoint& p, NearestPlace& best) const {
    const PathPiece& piece = path_[number].piece;
    const Part part = part_between(number, from_, to_);
    if (metric_.at_least(piece.begin, piece.end, p, part) >= best.in_tolerances) return;
    const double t = metric_.closest(piece.begin, piece.end, p, part);
    const double d = metric_.in_tolerances(metric_.at(piece.begin, piece.end, t, p));
    if (d < best.in_tolerances) best = {number, t, d};
  }

  const PathWindow& path_;
  const Metric& metric_;
  PathPlace from_;
  PathPlace to_;
  std::size_t near_;
};

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

SamplesOff samples_off(const LostMatch& fault, const FaultScene& scene) {
  SamplesOff off;
  const Metric& metric = scene.metric;
  const PathPlace to = fault.end ? PathPlace{scene.path.end() - 1, 1} : fault.back_high;
  if (holds_free_move(scene, fault.left_low.piece, to.piece)) return off;
  const Metric linear = metric.linear_only();
  const Metric rotary = metric.rotary_only();
  NearestOnPath nearest(scene.path, metric, fault.left_low, to);
  NearestOnPath nearest_linear(scene.path, linear, fault.left_low, to);
  NearestOnPath nearest_rotary(scene.path, rotary, fault.left_low, to);
  for (const RunSample& s : scene.run.samples()) {
    const std::uint64_t number = s.sample.number;
    const bool matched = (number <= fault.from && !fault.begin) || (number >= fault.to && !fault.end);
    if (matched || number < fault.from || number > fault.to) continue;
    off.any = true;
    const AxisPoint& p = s.sample.at;
    const NearestPlace place = nearest.to(p);
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
    least = {std::max(least.linear, nearest_linear.distance(p).linear),
             std::max(least.rotary, nearest_rotary.distance(p).rotary)};
  }
  return off;
}

}  // namespace toolcomp::certify

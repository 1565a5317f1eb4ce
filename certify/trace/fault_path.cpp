// SPDX-License-Identifier: Apache-2.0
// How far the path between two matched places is from the recording, and what was left out of it.
#include <algorithm>
#include <vector>

#include "certify/trace/fault.h"

namespace toolcomp::certify {
namespace {

// Finer than this, in tolerances, no distance is searched.
constexpr double kFine = 0.001;

// Takes the farthest point of the line from `a` to `b` into account. The distance from one line of the run is convex
// along it, so the larger one of both ends bounds what lies between. What is not beyond `enough` is not told apart.
void search(const AxisPoint& a, const AxisPoint& b, RunDistance& run, const Distance& error, const Metric& metric,
            double enough, Farthest& farthest) {
  struct End {
    AxisPoint at;
    RunDistance::Nearest nearest;
  };
  const auto look = [&](const AxisPoint& p) {
    End end{p, run.nearest(p)};
    farthest.take(p, end.nearest.at, error, metric);
    return end;
  };
  std::vector<std::pair<End, End>> lines{{look(a), look(b)}};
  while (!lines.empty()) {
    const auto [begin, end] = lines.back();
    lines.pop_back();
    const double upper = std::min(std::max(begin.nearest.in_tolerances, run.from(end.at, begin.nearest.line)),
                                  std::max(end.nearest.in_tolerances, run.from(begin.at, end.nearest.line)));
    const double length = metric.in_tolerances(metric.between(begin.at, end.at));
    if (upper <= std::max(enough, farthest.lower * (1 + kFine) + kFine) || length <= kFine) {
      farthest.upper = std::max(farthest.upper, upper);
      continue;
    }
    const End middle = look(point_at(begin.at, end.at, 0.5));
    lines.emplace_back(begin, middle);
    lines.emplace_back(middle, end);
  }
}

// Goes through the path left out, move by move.
class LeftOut {
 public:
  LeftOut(const LostMatch& fault, const FaultScene& scene, RunDistance& run, std::pair<std::size_t, std::size_t> kept)
      : fault_(fault),
        scene_(scene),
        run_(run),
        kept_(kept),
        linear_(scene.metric.linear_only()),
        rotary_(scene.metric.rotary_only()),
        linear_run_(scene.run, linear_, scene.run.approach(kept.first), kept.second),
        rotary_run_(scene.run, rotary_, scene.run.approach(kept.first), kept.second) {}

  PathLeftOut follow() {
    PathWindow& path = scene_.path;
    const PathPlace from = fault_.left_high;
    const WindowPiece& left = path[from.piece];
    move_.whole = left.move_first >= path.first() && !left.piece.free &&
                  stands_near(kept_.first, path[left.move_first].piece.begin);
    for (std::size_t number = from.piece; fault_.end ? path.has(number) : number <= fault_.back_low.piece; ++number) {
      const Part part{number == from.piece ? from.at : 0,
                      !fault_.end && number == fault_.back_low.piece ? fault_.back_low.at : 1};
      if (part.low <= part.high) take(number, part);
      // The rest of a path may be longer than what is held.
      constexpr std::size_t kHeld = 4096;
      if (fault_.end && number > path.first() + kHeld && number + 1 == path.end()) path.drop_before(number);
    }
    if (!fault_.end && move_.beyond && !begin_missed_) missed(ends_near() && move_.whole ? left_out_ : gap_, move_);
    return result();
  }

 private:
  struct Move {
    bool whole = true;    // its begin was left out too, or the recording stood there
    bool beyond = false;  // some of it is beyond the tolerance of the recording
    MoveName name;
  };
  struct Group {
    std::uint64_t count = 0;
    MoveName first, last, first_whole;
    bool whole = false;
  };

  static void missed(Group& group, const Move& move) {
    if (group.count++ == 0) group.first = move.name;
    if (move.whole && !group.whole) {
      group.whole = true;
      group.first_whole = move.name;
    }
    group.last = move.name;
  }

  [[nodiscard]] bool stands_near(std::size_t kept, const AxisPoint& p) const {
    const Sample& sample = scene_.run.samples()[kept].sample;
    const Limit limit = scene_.metric.limit({}, std::max(sample.magnitude, scene_.metric.magnitude(p)));
    return !fault_.begin && !scene_.metric.exceeds(scene_.metric.between(sample.at, p), limit);
  }

  // Whether the recording came back at the end of a move.
  [[nodiscard]] bool ends_near() const {
    for (std::size_t number = fault_.back_low.piece; number < scene_.path.end(); ++number) {
      const PathPiece& piece = scene_.path[number].piece;
      if (!stands_near(kept_.second, piece.end)) return false;
      if (piece.corner) return true;
    }
    return false;
  }

  void take(std::size_t number, const Part& part) {
    const WindowPiece& w = scene_.path[number];
    const PathPiece piece = w.piece;
    length_ += scene_.path.linear_length(number) * (part.high - part.low);
    move_.name = {piece.line, piece.n};
    const Distance error{piece.error.linear + scene_.run.error().linear,
                         piece.error.rotary + scene_.run.error().rotary};
    const Limit limit = scene_.metric.limit(error, w.magnitude);
    const AxisPoint end = point_at(piece.begin, piece.end, part.high);
    const AxisPoint begin = piece.free || fault_.continued ? end : point_at(piece.begin, piece.end, part.low);
    // What came before a cut is not held any more, but it was off the path.
    const bool last = fault_.end && !scene_.path.has(number + 1);
    if (fault_.continued && !last) {
      corners_ += piece.corner && !piece.jump ? 1 : 0;
      return;
    }
    Farthest here;
    // Whether it is beyond the tolerance, and whether it is the farthest.
    const double enough = move_.beyond ? farthest_.lower : std::min(1.0, farthest_.lower);
    search(begin, end, run_, error, scene_.metric, enough, here);
    Farthest linear;
    Farthest rotary;
    search(begin, end, linear_run_, error, linear_, linear_.in_tolerances(farthest_.alone), linear);
    search(begin, end, rotary_run_, error, rotary_, rotary_.in_tolerances(farthest_.alone), rotary);
    here.alone = {linear.most.linear, rotary.most.rotary};
    move_.beyond = move_.beyond || scene_.metric.exceeds(here.most, limit);
    farthest_.take(here);
    if (!piece.corner || part.high < 1) return;
    const bool corner_missed = scene_.metric.exceeds(run_.nearest(piece.end).distance, limit);
    if (corner_missed) {
      corners_ += piece.jump ? 0 : 1;
      missed(corner_, move_);
    } else if (move_.beyond && !begin_missed_) {
      missed(move_.whole ? left_out_ : gap_, move_);
    }
    begin_missed_ = corner_missed;
    move_ = {};
  }

  PathLeftOut result() {
    PathLeftOut out;
    out.corners = corners_;
    out.length = length_;
    out.farthest = farthest_;
    out.first = out.last = move_.name;
    const Group& group = corner_.count > 0 ? corner_ : left_out_.count > 0 ? left_out_ : gap_;
    if (group.count == 0) {
      const PathPiece& piece = scene_.path[std::max(fault_.left_high.piece, scene_.path.first())].piece;
      out.first = out.last = {piece.line, piece.n};
      return out;
    }
    const bool gap = &group == &gap_;
    out.is_gap = gap;
    if (fault_.end)
      out.kind = "end not reached";
    else if (gap)
      out.kind = "gap";
    else
      out.kind = group.whole ? "move left out" : "corner not reached";
    out.first = group.whole && !gap && !fault_.end && !fault_.begin ? group.first_whole : group.first;
    out.last = group.last;
    return out;
  }

  const LostMatch& fault_;
  const FaultScene& scene_;
  RunDistance& run_;
  std::pair<std::size_t, std::size_t> kept_;  // the run's first and last sample
  // Each kind of axes by itself, and what was recorded before besides: for lower bounds.
  const Metric linear_;
  const Metric rotary_;
  RunDistance linear_run_;
  RunDistance rotary_run_;
  Move move_;
  bool begin_missed_ = false;
  Group corner_, left_out_, gap_;
  std::uint64_t corners_ = 0;
  double length_ = 0;
  Farthest farthest_;
};

}  // namespace

PathLeftOut path_left_out(const LostMatch& fault, const FaultScene& scene) {
  const auto kept = scene.run.between(fault.from, fault.to);
  RunDistance run(scene.run, scene.metric, kept.first, kept.second);
  return LeftOut(fault, scene, run, kept).follow();
}

}  // namespace toolcomp::certify

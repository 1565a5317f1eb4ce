// SPDX-License-Identifier: Apache-2.0
// A recording matched with the path, and found again where it is lost.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "certify/trace/deviations.h"
#include "certify/trace/fault.h"
#include "certify/trace/findings.h"
#include "certify/trace/free_space.h"
#include "certify/trace/path_window.h"
#include "certify/trace/run.h"

namespace toolcomp::certify {

// Decides by the free space whether the recording is within the tolerance of the path (free_space.h). Where nothing is
// reached any more, the match is lost, and the recording does not conform, whatever is found out behind that.
//
// What is found out is the alignment of least cost. From the places last reached, hypotheses leave out recording, at
// the cost of its length, and path, at the cost of its length, and pay a constant besides, to go on wherever a sample
// lies near the path. They are followed side by side, each through the free space, until one is left:
// * A match is left only where it breaks, and taken up only at a sample.
// * A hypothesis goes if another can be where it is for no more: one that overlaps it, or one behind it that leaves out
//   the path between.
// * Once one is matched again, those dearer than twice its cost and a constant go: the one that stays off the path is
//   given up when the recording has been followed again for about as long as it was lost.
// * Searched is the path from where it was left up to kWindow pieces ahead, whole moves or not: of straight moves so
//   many, of curves that are divided most finely some twenty turns. Pieces near a sample are found by their boxes, so a
//   sample costs about the same however much path lies ahead, and each piece is fetched and dropped once: time grows
//   with samples and pieces, not with their product.
// * A recording that is off the path for as long as half of that is taken to have left out the first quarter, and so
//   on: then what it is compared with stays beside it. Where more than kWindow pieces were left out at once, it is not
//   found again: the rest is said to be off the path.
// * The oldest fault of the cheapest is decided on when as many samples are held as a run keeps (run.h).
// * At most kHypotheses are followed, the cheapest. If the path held gets longer than kWindow while several are, the
//   cheapest is taken.
// A move whose inside is not judged accepts every sample between its ends, axis by axis, so a match may not break there
// where it should: while one is inside, hypotheses that did not come to the end of that move are followed besides. One
// without a fault is never given up for them. Lengths of the recording are counted in steps of at least the tolerance:
// noise of a standing machine has none.
class Matcher {
 public:
  static constexpr std::size_t kWindow = 131072;
  static constexpr std::size_t kHypotheses = 32;

  Matcher(PathSource& path, const Metric& metric, const spec::Axes& axes, TraceResult& result, Findings& findings);
  void take(const AxisPoint& at, std::uint64_t line);
  void end();
  // Where the last sample is on the path, as far as one can tell. While the recording is not followed that is no place,
  // unless `also_left`: then what is nearest behind the place where it left.
  [[nodiscard]] PlaceOnPath place(bool also_left) const;
  // The move that the recording is on, as far as one can tell.
  [[nodiscard]] MoveName move() const;

 private:
  // What leaving the path costs besides the lengths, in tolerances: places that differ by a few tolerances are the same
  // to a match, so faults closer than about that are one.
  static constexpr double kFault = 16;
  // Pieces kept behind those matched: a recording that goes back is told from one that leaves the path.
  static constexpr std::size_t kBehind = 4096;

  // The largest accepted distances so far.
  struct Accepted {
    Bounds linear, rotary;
    std::uint64_t linear_line = 0, rotary_line = 0;
  };
  struct History {
    double cost = 0;                                       // in tolerances
    std::vector<std::shared_ptr<const LostMatch>> faults;  // not yet reported
    Accepted accepted;
  };
  // On the path.
  struct Hypothesis {
    History history;
    Reach reach;
    std::optional<NearestReached> nearest;  // to the last sample
    // Inside a move that is not judged: where it came closest to its end.
    std::size_t free_piece = static_cast<std::size_t>(-1);
    double closest = 0;        // in tolerances
    double closest_after = 0;  // length of the recording
    std::uint64_t closest_sample = 0;
  };
  // Off the path since `sample`.
  struct Left {
    History history;
    std::uint64_t sample = 0;
    std::uint64_t line = 0;  // of the CSV: where that was noticed
    bool begin = false;
    PathPlace low, high;
    double recorded = 0;     // length of the recording up to there
    bool continued = false;  // part of it was told already
  };

  void begin(const Sample& sample);
  void advance(const Sample& sample);
  void recover(const std::vector<Hypothesis>& lost, const Sample& sample);
  void leave(const Hypothesis& lost, std::uint64_t noticed);
  void leave_free_moves(const Sample& sample);
  [[nodiscard]] std::vector<Hypothesis> come_back(const Sample& sample, std::size_t first_left, double recorded) const;
  [[nodiscard]] Hypothesis come_back_to(const Reach& group, const Sample& sample, std::size_t first_left,
                                        double recorded) const;
  [[nodiscard]] bool is_dominated(const std::vector<Hypothesis>& by, const Hypothesis& hypothesis) const;
  void keep(std::vector<Hypothesis> candidates);
  [[nodiscard]] double most_cost() const;
  void prune();
  void settle();
  void take_cheapest();
  void move_on(const Sample& sample);
  void decide_oldest();
  void report_common();
  [[nodiscard]] std::vector<History*> histories();
  void report_all(const History& history);
  void drop_behind();
  void keep_approach(const Sample& sample);
  [[nodiscard]] std::size_t first_needed() const;
  void measure(Hypothesis& hypothesis, const Sample& sample) const;
  void leave_uncovered(const PathPlace& until);
  void finish(const History& history);
  [[nodiscard]] bool in_free_move(const Hypothesis& hypothesis) const;
  [[nodiscard]] bool following() const {
    return hypotheses_.size() == 1 && left_.empty() && !in_free_move(hypotheses_.front());
  }

  const Metric& metric_;
  PathWindow path_;
  FreeSpace free_;
  Run run_;
  FaultScene scene_;
  TraceResult& result_;
  Findings& findings_;

  std::vector<Hypothesis> hypotheses_;
  std::vector<Left> left_;
  Sample last_;
  Reach ahead_;
  double recorded_ = 0;         // length of the recording, in tolerances
  double recorded_before_ = 0;  // up to the last sample
  AxisPoint counted_{};         // up to here
  // The last samples, and the length of the recording up to each: as far as kApproach goes (run.h).
  std::deque<std::pair<Sample, double>> approach_;
  std::uint64_t samples_ = 0;
};

}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
// Matches a recording with the path, and finds it again after it was lost.
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

// Decides by the free space whether the recording is within the tolerance of the path (free_space.h). If no place is
// reached any more, the match is lost, and the recording does not conform, whatever the matcher finds afterwards.
//
// Afterwards it looks for the alignment with the lowest cost. From the places last reached, hypotheses leave out a part
// of the recording and a part of the path. The cost is the length of each part plus a constant. A hypothesis goes on
// wherever a sample is near the path. Hypotheses are followed in parallel, each through the free space, until one is
// left:
// * A match is left only if it breaks, and taken up only at a sample.
// * A hypothesis is dropped if another one can be at its place at no higher cost: one that overlaps it, or one behind
//   it that leaves out the path in between.
// * When a hypothesis is matched again, those that cost more than twice its cost plus a constant are dropped. The one
//   that stays off the path is dropped when the recording has been matched again for about as long as it was lost.
// * The search covers the path from the place where it was left up to kWindow pieces ahead, whether these are whole
//   moves or not: this is kWindow straight moves, or about twenty turns of curves with the finest division. Pieces near
//   a sample are found by their boxes, so a sample costs about the same however much path lies ahead, and each piece is
//   fetched and dropped once: time grows with samples and pieces, not with their product.
// * A recording that is off the path for half of that length is assumed to have left out the first quarter, and so on,
//   so that the search stays near it. If more than kWindow pieces were left out at once, the recording is not found
//   again, and its rest is reported as off the path.
// * The oldest fault of the cheapest hypothesis is decided when as many samples are held as a run keeps (run.h).
// * At most kHypotheses are followed, the cheapest. If the held path gets longer than kWindow while there are several
//   hypotheses, the cheapest is taken.
// A move whose inside is not judged accepts every sample between its ends, axis by axis, so a match may not break there
// when it should. While a match is inside such a move, hypotheses that did not come to its end are followed too. A
// hypothesis without a fault is never dropped for them. Lengths of the recording are counted in steps of at least the
// tolerance, so that the noise of a standing machine counts as no length.
class Matcher {
 public:
  static constexpr std::size_t kWindow = 131072;
  static constexpr std::size_t kHypotheses = 32;

  Matcher(PathSource& path, const Metric& metric, const spec::Axes& axes, TraceResult& result, Findings& findings);
  void take(const AxisPoint& at, std::uint64_t line);
  void end();
  // The place of the last sample on the path, as far as it is known. While the recording is not matched there is no
  // place, unless `also_left` is true: then it is the nearest place after the place at which the recording left.
  [[nodiscard]] PlaceOnPath place(bool also_left) const;
  // The move of the recording, as far as it is known.
  [[nodiscard]] MoveName move() const;

 private:
  // The constant cost of leaving the path, in tolerances. To a match, places that differ by a few tolerances are the
  // same, so faults that are closer together than about that are one fault.
  static constexpr double kFault = 16;
  // Number of pieces kept before the matched ones, to distinguish a recording that goes back from one that leaves the
  // path.
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
  // A hypothesis that is on the path.
  struct Hypothesis {
    History history;
    Reach reach;
    std::optional<NearestReached> nearest;  // to the last sample
    // Inside a move that is not judged: where the recording was closest to its end.
    std::size_t free_piece = static_cast<std::size_t>(-1);
    double closest = 0;        // in tolerances
    double closest_after = 0;  // length of the recording
    std::uint64_t closest_sample = 0;
  };
  // A hypothesis that has been off the path since `sample`.
  struct Left {
    History history;
    std::uint64_t sample = 0;
    std::uint64_t line = 0;  // line of the CSV at which that was noticed
    bool begin = false;
    PathPlace low, high;
    double recorded = 0;     // length of the recording up to there
    bool continued = false;  // part of it was already reported
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

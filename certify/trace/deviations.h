// SPDX-License-Identifier: Apache-2.0
// How far a recording is from the path, sample by sample: for pictures.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "certify/trace/space.h"

namespace toolcomp::certify {

enum class SampleKind : std::uint8_t {
  followed,
  off,         // where the recording is not followed
  not_judged,  // on a move whose inside is not judged
};

// Where a sample is on the path, or what is nearest where the recording is not followed.
struct PlaceOnPath {
  SampleKind kind = SampleKind::off;
  std::optional<AxisPoint> exact;  // nothing: no place is known, and what follows says nothing
  Distance distance;
  std::uint64_t line = 0;  // of the program: the move
  std::optional<std::uint64_t> n;
};

// Kept in bounded memory: of long recordings some samples stand for those between, of long programs the dearest of
// several moves in a row.
class Deviations {
 public:
  static constexpr std::size_t kMostPoints = 4096;
  static constexpr std::size_t kMostMoves = 1024;
  static constexpr std::size_t kBins = 20;

  // A recorded position and its place.
  struct Point {
    AxisPoint recorded{};
    std::optional<AxisPoint> exact;
    SampleKind kind = SampleKind::off;
  };
  // What of a move was followed, and what stands for it.
  struct Move {
    std::uint64_t line = 0;
    std::optional<std::uint64_t> n;
    Distance largest;
    bool off = false;  // a sample behind it was not followed
  };

  Deviations() = default;
  explicit Deviations(Distance tolerance) : tolerance_(tolerance) {}
  // Whether the next sample will be a point: of other ones that are off no place is needed.
  [[nodiscard]] bool keeps_next() const { return taken_ % stride_ == 0; }
  void take(const AxisPoint& recorded, const PlaceOnPath& place);

  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  [[nodiscard]] const std::vector<Move>& moves() const { return moves_; }
  // Samples by distance, each bin a twentieth of the tolerance; the larger of the linear and the rotary one counts.
  [[nodiscard]] const std::array<std::uint64_t, kBins>& histogram() const { return histogram_; }
  [[nodiscard]] std::uint64_t off() const { return off_; }  // samples that were not followed
  [[nodiscard]] std::uint64_t not_judged() const { return not_judged_; }

 private:
  void take_move(const PlaceOnPath& place);

  Distance tolerance_;
  std::vector<Point> points_;
  std::uint64_t stride_ = 1;
  std::uint64_t taken_ = 0;
  std::vector<Move> moves_;
  std::uint64_t last_line_ = 0;  // of the move that comes last
  std::uint64_t moves_of_one_ = 1;
  std::uint64_t in_last_ = 0;
  std::array<std::uint64_t, kBins> histogram_{};
  std::uint64_t off_ = 0;
  std::uint64_t not_judged_ = 0;
};

}  // namespace toolcomp::certify

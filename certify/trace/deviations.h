// SPDX-License-Identifier: Apache-2.0
// The distance of a recording from the path, sample by sample, for pictures.
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
  off,         // the recording is not matched with the path here
  not_judged,  // on a move whose inside is not judged
};

// The place of a sample on the path, or the nearest place if the recording is not matched there.
struct PlaceOnPath {
  SampleKind kind = SampleKind::off;
  std::optional<AxisPoint> exact;  // std::nullopt: no place is known, and the other members have no meaning
  Distance distance;
  std::uint64_t line = 0;  // program line of the move
  std::optional<std::uint64_t> n;
};

// Needs bounded memory. Of a long recording only some samples are kept. Of a long program, the worst of several
// consecutive moves is kept.
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
  // The matched part of a move, or of several moves.
  struct Move {
    std::uint64_t line = 0;
    std::optional<std::uint64_t> n;
    Distance largest;
    bool off = false;  // a sample after it was not matched
  };

  Deviations() = default;
  explicit Deviations(Distance tolerance) : tolerance_(tolerance) {}
  // Whether the next sample will be kept as a point. For other samples that are off no place is needed.
  [[nodiscard]] bool keeps_next() const { return taken_ % stride_ == 0; }
  void take(const AxisPoint& recorded, const PlaceOnPath& place);

  [[nodiscard]] const std::vector<Point>& points() const { return points_; }
  [[nodiscard]] const std::vector<Move>& moves() const { return moves_; }
  // Number of samples by distance. Each bin is a twentieth of the tolerance. The larger of linear and rotary distance
  // counts.
  [[nodiscard]] const std::array<std::uint64_t, kBins>& histogram() const { return histogram_; }
  [[nodiscard]] std::uint64_t off() const { return off_; }  // samples that were not matched
  [[nodiscard]] std::uint64_t not_judged() const { return not_judged_; }

 private:
  void take_move(const PlaceOnPath& place);

  Distance tolerance_;
  std::vector<Point> points_;
  std::uint64_t stride_ = 1;
  std::uint64_t taken_ = 0;
  std::vector<Move> moves_;
  std::uint64_t last_line_ = 0;  // of the last move
  std::uint64_t moves_of_one_ = 1;
  std::uint64_t in_last_ = 0;
  std::array<std::uint64_t, kBins> histogram_{};
  std::uint64_t off_ = 0;
  std::uint64_t not_judged_ = 0;
};

}  // namespace toolcomp::certify

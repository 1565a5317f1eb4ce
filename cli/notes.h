// SPDX-License-Identifier: Apache-2.0
// What a reader of a FANUC program should know, and no verdict depends on: words that do less than they seem to, and
// paths that run backwards.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "cli/radii_note.h"
#include "fast/arrays/line_moves.h"
#include "spec/language/event.h"
#include "spec/language/fanuc/block.h"
#include "spec/language/heidenhain/klartext_block.h"
#include "spec/language/setup.h"

namespace toolcomp::cli {

struct Note {
  std::uint64_t line = 0;
  std::string text;
};

// Follows one run: its blocks as they are read, and its events. Of each kind the first few are told, and at the end how
// many there were. Approximate where it speaks of positions: it tells, and decides nothing.
class Notes {
 public:
  explicit Notes(const spec::Setup& setup);

  void read(const spec::Block& block);
  void read(const spec::klartext::Block& /*block*/) {}
  // `nearest` makes a double of a number of the event.
  template <class Number, class Nearest>
  void on(const spec::Event<Number>& event, Nearest nearest) {
    radii_.on(event, nearest);
    if (event.hole) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t axis = axes_.index("XYZ"[i]);
        if (axis == event.hole->axis)
          programmed_.at(i) = nearest(event.hole->level);
        else if (axis != spec::Axes::kNone && event.point.has(axis))
          programmed_.at(i) = nearest(event.point[axis]);
      }
      point_ = programmed_;
    }
    if (event.kind != spec::EventKind::move) return;
    const auto [programmed, point] = places(event, nearest);
    moved(event.line, event.cause, event.type, programmed, point);
  }
  // Whether there is nothing to say of moves of lines; then they have been seen. Otherwise each goes to on().
  [[nodiscard]] bool passes(fast::LineMoves& moves);
  // Those since the last call, where there are any.
  [[nodiscard]] bool wait() const { return !waiting_.empty(); }
  std::vector<Note> take();
  // What is said of all, after the end.
  [[nodiscard]] std::vector<Note> summary() const;

 private:
  using Place = std::array<double, 3>;
  enum Kind : std::uint8_t { kNoRadius, kRadiusByH, kG10, kMachine, kShort, kFeed, kBackwards, kKinds };

  // X, Y, Z of a move: programmed, and of the tool.
  template <class Number, class Nearest>
  [[nodiscard]] std::pair<Place, Place> places(const spec::Event<Number>& move, Nearest nearest) const {
    std::pair<Place, Place> result;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t axis = axes_.index("XYZ"[i]);
      if (axis == spec::Axes::kNone || !move.point.has(axis) || !move.programmed.has(axis)) continue;
      result.first.at(i) = nearest(move.programmed[axis]);
      result.second.at(i) = nearest(move.point[axis]);
    }
    return result;
  }
  [[nodiscard]] bool run_back(const fast::LineMoves& moves, const Place& programmed, const Place& point) const;
  void moved(std::uint64_t line, spec::Cause cause, spec::MoveType type, const Place& programmed, const Place& point);
  void add(Kind kind, std::uint64_t line, std::string text);

  const spec::Setup& setup_;
  const spec::Axes& axes_;
  RadiiNote radii_;
  bool watches_;
  bool incremental_ = false;
  bool d_given_ = false;  // a D other than 0 is in force
  bool feed_given_ = false;
  bool cutting_ = false;  // the code of group 01 is other than G00
  Place programmed_{};
  Place point_{};
  std::array<std::uint64_t, kKinds> count_{};
  std::vector<Note> waiting_;
};

}  // namespace toolcomp::cli

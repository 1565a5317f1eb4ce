// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/cutter_compensation_c/usual_line.h"

#include <algorithm>
#include <cmath>

#include "fast/basis/short_cut.h"
#include "fast/fanuc/control/read_words.h"
#include "fast/fanuc/control/usual_place.h"
#include "fast/fanuc/corner/usual_corner.h"
#include "fast/fanuc/cutter_compensation_c/cutter_compensation_c.h"
#include "fast/geometry/heading.h"

namespace toolcomp::fast {
namespace {

constexpr std::uint32_t kFeed = UsualWords::set('F');

}  // namespace

bool UsualCutterLines::await() {
  if (!is_open(ShortCut::cutter_line) || !compensation_.awaits_lines() || !usual_lines_may_come(control_)) return false;
  if (!find_usual_place(control_, at_)) return false;
  axis_ = control_.modal.plane_axis();
  for (std::size_t i = 0; i < 2; ++i) letter_[i] = std::size_t{control_.axes.letters.index[axis_[i]]} + 1U;
  words_.permit(std::uint32_t{1} << letter_[0] | std::uint32_t{1} << letter_[1] | UsualWords::set_of("FG"));
  at_value_ = to_doubles(at_);
  compensation_.lend(line_);
  handover_.take(*this);
  return true;
}

void UsualCutterLines::block(const spec::Block& block) {
  if (take(block)) [[likely]]
    return;
  leave().block(block);
}

BlockTaker& UsualCutterLines::leave() {
  BlockTaker& others = handover_.back();
  if (line_.start == UsualLine::Start::lent) return others;
  for (std::size_t i = 0; i < 2; ++i) control_.positions.place_small(axis_[i], at_[i]);
  place_in_plane(*line_.event, axis_, at_value_, DoublePair{});
  compensation_.take_back(line_, at_);
  return others;
}

// From the first vector to the last, where the line starts.
void UsualCutterLines::send_corner_move() {
  line_.event->cause = spec::Cause::corner;
  place_in_plane(*line_.event, axis_, at_value_ - to_doubles(line_.way), line_.vector);
  line_.sink->on(*line_.event);
  line_.event->cause = spec::Cause::programmed;
}

// Vectors as head_vector() makes them.
[[gnu::always_inline]] inline bool UsualCutterLines::make_corner(const std::array<std::int64_t, 2>& way, double norm,
                                                                 DoublePair unit, Corner& corner) const {
  const std::int64_t c = line_.way[0] * way[1] - line_.way[1] * way[0];
  const std::int64_t k = line_.way[0] * way[0] + line_.way[1] * way[1];
  // No way at all, or straight back.
  if (c == 0 && k <= 0) [[unlikely]]
    return false;
  corner.acute = k < 0 && (c < 0) == (line_.offset > 0);
  if (corner.acute) {
    corner.first = left_of(line_.unit) * line_.offset + line_.unit * line_.radius;
    corner.last = left_of(unit) * line_.offset - unit * line_.radius;
    // Beyond No. 5010 in one of the axes for certain.
    const DoublePair change = corner.first - corner.last;
    const double over = std::max(std::abs(change[0]), std::abs(change[1])) - line_.limit;
    return over > 0x1p-46 * (4 * line_.radius + std::abs(line_.limit));
  }
  const Turn turned{static_cast<double>(c), static_cast<double>(k), line_.norm * norm};
  corner.first = corner.last = (left_of(line_.unit) - line_.unit * half_tangent(turned)) * line_.offset;
  return true;
}

[[gnu::always_inline]] inline bool UsualCutterLines::take(const spec::Block& block) {
  if (block.alarm) [[unlikely]]
    return false;
  const bool incremental = control_.modal.incremental();
  std::uint32_t letters = 0;
  std::array<std::int64_t, 2> to{};
  if (!UsualWords::read_two(block, letter_, to)) {
    for (std::size_t i = 0; i < 2; ++i) words_[letter_[i]] = incremental ? 0 : at_[i];
    if (!words_.read(block, control_.modal.motion(), letters)) [[unlikely]]
      return false;
    to = {words_[letter_[0]], words_[letter_[1]]};
  }
  if (incremental) [[unlikely]] {
    to[0] += at_[0];
    to[1] += at_[1];
    if (!Count::is_small(to[0]) || !Count::is_small(to[1])) return false;
  }
  const std::array<std::int64_t, 2> way{to[0] - at_[0], to[1] - at_[1]};
  if (!is_usual_way(way)) [[unlikely]]
    return false;
  const DoublePair at = to_doubles(to);
  const DoublePair change = at - at_value_;
  const DoublePair squares = change * change;
  const double norm = std::sqrt(squares[0] + squares[1]);
  const DoublePair unit = change / norm;
  Corner corner;
  if (!make_corner(way, norm, unit, corner)) [[unlikely]]
    return false;
  if (!goes_forward(line_.unit, line_.norm, line_.vector, corner.first)) [[unlikely]]
    return false;

  if (line_.start == UsualLine::Start::two_vectors) send_corner_move();
  place_in_plane(*line_.event, axis_, at_value_, corner.first);
  line_.start = corner.acute ? UsualLine::Start::two_vectors : UsualLine::Start::one_vector;
  // One by one: a pair is not to be read of what has just been written apart.
  line_.before[0] = line_.way[0];
  line_.before[1] = line_.way[1];
  line_.way[0] = way[0];
  line_.way[1] = way[1];
  line_.unit = unit;
  line_.norm = norm;
  line_.vector = corner.last;
  at_[0] = to[0];
  at_[1] = to[1];
  at_value_ = at;
  Event& event = *line_.event;
  line_.sink->on(event);
  // Now it is that of the line that is held now.
  event.line = block.line;
  event.n = block.n;
  if ((letters & kFeed) != 0) [[unlikely]]
    set_feed();
  return true;
}

void UsualCutterLines::set_feed() {
  control_.modal.set_feed(words_.feed());
  Event& event = *line_.event;
  if (event.type != spec::MoveType::rapid) event.feed = control_.modal.feed();
}

}  // namespace toolcomp::fast

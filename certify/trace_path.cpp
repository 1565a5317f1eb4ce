#include "certify/trace_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "spec/language/fanuc/program_reader.h"

namespace toolcomp::certify {
namespace {

// Accepts a distance of exactly the tolerance: coordinates and distances carry a few roundings.
double widened(const PathSpace& space, const AxisPoint& p) {
  double scale = space.tolerance;
  for (const auto* axes : {&space.linear, &space.rotary})
    for (const std::size_t axis : *axes) scale = std::max(scale, std::fabs(p[axis]));
  return space.tolerance + 16 * std::numeric_limits<double>::epsilon() * scale;
}

// The lines after which coordinates may jump.
std::vector<std::uint64_t> system_changes(const spec::Case& c) {
  std::vector<std::uint64_t> lines;
  // Events of Klartext programs all count from the preset.
  if (c.setup.control == spec::Control::heidenhain) return lines;
  const bool one_system =
      std::ranges::all_of(c.setup.workpiece, [&](const auto& w) { return w == c.setup.workpiece[0]; });
  spec::ProgramReader reader(spec::text_source(c.program), c.setup.axes, {"program", c.setup.block_skip});
  spec::Block block;
  while (reader.next(block))
    for (const spec::Word& word : block.words()) {
      if (word.address != 'G' || !word.value.is_integer()) continue;
      const std::uint64_t g = word.value.digits;
      if (g == 92 || (g >= 54 && g <= 59 && !one_system)) lines.push_back(block.line);
    }
  return lines;
}

double linear_length(const PathSpace& space, const AxisPoint& a, const AxisPoint& b) {
  double square = 0;
  for (const std::size_t axis : space.linear) square += (b[axis] - a[axis]) * (b[axis] - a[axis]);
  return std::sqrt(square);
}

class Builder {
 public:
  Builder(const spec::Case& c, const PathSpace& space, bool judge_rapids)
      : axes_(c.setup.axes), space_(space), judge_rapids_(judge_rapids), changes_(system_changes(c)) {
    for (std::size_t i = 0; i < axes_.size(); ++i)
      if (const auto start = c.setup.position.find(axes_.letter(i)); start != c.setup.position.end()) {
        const double magnitude = static_cast<double>(start->second.digits) / std::pow(10.0, start->second.decimals);
        at_[i] = start->second.negative ? -magnitude : magnitude;
      }
  }

  void add(const spec::Event<double>& event) {
    if (event.kind != spec::EventKind::move && event.kind != spec::EventKind::sample) return;
    AxisPoint end = at_;
    for (std::size_t i = 0; i < axes_.size(); ++i)
      if (event.axes.has(i)) end[i] = event.axes[i];
    if (event.kind == spec::EventKind::sample) {
      sampled_.push_back(end);
      return;
    }
    PathPiece piece;
    piece.line = event.line;
    piece.n = event.n;
    // A change in the block of the move itself comes before it.
    const auto first = std::ranges::lower_bound(changes_, line_ + 1);
    piece.ends_only =
        (first != changes_.end() && *first <= event.line) || (!judge_rapids_ && event.type == spec::MoveType::rapid);
    line_ = event.line;
    if (!sampled_.empty() && !piece.ends_only) {
      PathPiece chord = piece;
      chord.corner = false;
      for (const AxisPoint& p : sampled_) add_piece(chord, p);
      add_piece(piece, end);
    } else if (event.arc && !piece.ends_only) {
      add_arc(event, piece, end);
    } else {
      add_piece(piece, end);
    }
    sampled_.clear();
  }

  std::vector<PathPiece> take() { return std::move(pieces_); }

 private:
  void add_piece(PathPiece piece, const AxisPoint& end) {
    piece.begin = at_;
    piece.end = end;
    piece.length = linear_length(space_, at_, end);
    pieces_.push_back(piece);
    at_ = end;
  }

  void add_arc(const spec::Event<double>& event, const PathPiece& piece, const AxisPoint& end) {
    const spec::Arc<double>& arc = *event.arc;
    constexpr std::array<std::array<char, 2>, 3> letters{{{'X', 'Y'}, {'Z', 'X'}, {'Y', 'Z'}}};
    const auto [first, second] = letters.at(static_cast<std::size_t>(arc.plane));
    const std::size_t u = axes_.index(first);
    const std::size_t v = axes_.index(second);
    if (u == spec::Axes::kNone || v == spec::Axes::kNone || !arc.sweep) {
      add_piece(piece, end);
      return;
    }
    // The centre of the axes' circle: that of the tool point, moved by the length offset.
    const auto center = [&](std::size_t axis) {
      const double offset = event.point.has(axis) && event.axes.has(axis) ? event.axes[axis] - event.point[axis] : 0;
      return (arc.center.has(axis) ? arc.center[axis] : at_[axis]) + offset;
    };
    const double cu = center(u);
    const double cv = center(v);
    const double radius_begin = std::hypot(at_[u] - cu, at_[v] - cv);
    const double radius_end = std::hypot(end[u] - cu, end[v] - cv);
    const double radius = std::max(radius_begin, radius_end);
    const double sweep = *arc.sweep * std::numbers::pi / 180 * (arc.direction == spec::ArcDirection::ccw ? 1 : -1);
    const double sagitta = space_.tolerance / 1000;
    const double step = radius > sagitta ? 2 * std::acos(1 - sagitta / radius) : std::numbers::pi;
    constexpr double most = 65536;
    const int chords =
        static_cast<int>(std::clamp(std::ceil(std::fabs(sweep) / std::max(step, std::fabs(sweep) / most)), 1.0, most));
    const double angle = std::atan2(at_[v] - cv, at_[u] - cu);
    const AxisPoint begin = at_;
    for (int i = 1; i < chords; ++i) {
      const double t = static_cast<double>(i) / chords;
      AxisPoint p = begin;
      for (std::size_t axis = 0; axis < axes_.size(); ++axis) p[axis] += t * (end[axis] - begin[axis]);
      const double r = radius_begin + t * (radius_end - radius_begin);
      p[u] = cu + r * std::cos(angle + t * sweep);
      p[v] = cv + r * std::sin(angle + t * sweep);
      PathPiece chord = piece;
      chord.corner = false;
      add_piece(chord, p);
    }
    add_piece(piece, end);
  }

  const spec::Axes& axes_;
  const PathSpace& space_;
  bool judge_rapids_;
  std::vector<std::uint64_t> changes_;
  std::vector<PathPiece> pieces_;
  std::vector<AxisPoint> sampled_;  // of the move to come
  AxisPoint at_{};
  std::uint64_t line_ = 0;
};

}  // namespace

std::vector<PathPiece> path_pieces(const spec::Case& c, std::span<const spec::Event<double>> events,
                                   const PathSpace& space, bool judge_rapids) {
  Builder builder(c, space, judge_rapids);
  for (const auto& event : events) builder.add(event);
  return builder.take();
}

double largest_sagitta(const spec::Case& c, std::span<const spec::Event<double>> events, const PathSpace& space) {
  const std::vector<PathPiece> pieces = path_pieces(c, events, space, true);
  double largest = 0;
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    // Two chords of one move: their common end against the middle of both other ends, four sagittas of one chord away.
    if (pieces[i - 1].corner) continue;
    AxisPoint middle{};
    for (std::size_t axis = 0; axis < middle.size(); ++axis)
      middle[axis] = (pieces[i - 1].begin[axis] + pieces[i].end[axis]) / 2;
    const Distance d = distance_at(space, middle, middle, 0, pieces[i].begin);
    largest = std::max({largest, d.linear / 4, d.rotary / 4});
  }
  return largest;
}

double closest(const PathSpace& space, const AxisPoint& begin, const AxisPoint& end, const AxisPoint& p, double low,
               double high) {
  double along = 0;
  double square = 0;
  for (const std::size_t axis : space.linear.empty() ? space.rotary : space.linear) {
    const double d = end[axis] - begin[axis];
    along += d * (p[axis] - begin[axis]);
    square += d * d;
  }
  return square > 0 ? std::clamp(along / square, low, high) : low;
}

Distance distance_at(const PathSpace& space, const AxisPoint& begin, const AxisPoint& end, double t,
                     const AxisPoint& p) {
  // From the nearer end, so that the ends themselves are met exactly.
  const auto off = [&](std::size_t axis) {
    const double d = end[axis] - begin[axis];
    return t <= 0.5 ? p[axis] - begin[axis] - t * d : p[axis] - end[axis] + (1 - t) * d;
  };
  double square = 0;
  for (const std::size_t axis : space.linear) square += off(axis) * off(axis);
  Distance distance{std::sqrt(square), 0};
  for (const std::size_t axis : space.rotary) distance.rotary = std::max(distance.rotary, std::fabs(off(axis)));
  return distance;
}

std::optional<std::pair<double, double>> part_near(const PathSpace& space, const AxisPoint& begin, const AxisPoint& end,
                                                   const AxisPoint& p) {
  const double tolerance = widened(space, p);
  double low = 0;
  double high = 1;
  double square = 0;
  double along = 0;
  for (const std::size_t axis : space.linear) {
    const double d = end[axis] - begin[axis];
    square += d * d;
    along += d * (p[axis] - begin[axis]);
  }
  const double foot = square > 0 ? along / square : 0;
  const double height = distance_at(space, begin, end, foot, p).linear;
  if (height > tolerance) return std::nullopt;
  if (square > 0) {
    const double half = std::sqrt((tolerance - height) * (tolerance + height) / square);
    low = std::max(low, foot - half);
    high = std::min(high, foot + half);
  }
  for (const std::size_t axis : space.rotary) {
    const double d = end[axis] - begin[axis];
    const double off = p[axis] - begin[axis];
    if (d == 0) {
      if (std::fabs(off) > tolerance) return std::nullopt;
      continue;
    }
    const auto [from, to] = std::minmax({(off - tolerance) / d, (off + tolerance) / d});
    low = std::max(low, from);
    high = std::min(high, to);
  }
  if (low > high) return std::nullopt;
  return std::pair(low, high);
}

}  // namespace toolcomp::certify

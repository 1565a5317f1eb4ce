#include "certify/trace/old_program_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "certify/convert.h"
#include "fuzz/oracle/verdict.h"
#include "spec/language/fanuc/program_reader.h"

namespace toolcomp::certify {
namespace {

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

class Builder {
 public:
  Builder(const spec::Case& c, double sagitta, bool judge_rapids)
      : axes_(c.setup.axes), sagitta_(sagitta), judge_rapids_(judge_rapids), changes_(system_changes(c)) {
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
    piece.free =
        (first != changes_.end() && *first <= event.line) || (!judge_rapids_ && event.type == spec::MoveType::rapid);
    line_ = event.line;
    if (!sampled_.empty() && !piece.free) {
      PathPiece chord = piece;
      chord.corner = false;
      chord.curved = true;
      chord.error = {sagitta_, sagitta_};
      for (const AxisPoint& p : sampled_) add_piece(chord, p);
      chord.corner = true;
      add_piece(chord, end);
    } else if (event.arc && !piece.free) {
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
    const double step = radius > sagitta_ ? 2 * std::acos(1 - sagitta_ / radius) : std::numbers::pi;
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
      chord.curved = true;
      chord.error = {sagitta_, sagitta_};
      add_piece(chord, p);
    }
    PathPiece last = piece;
    last.curved = true;
    last.error = {sagitta_, sagitta_};
    add_piece(last, end);
  }

  const spec::Axes& axes_;
  double sagitta_;
  bool judge_rapids_;
  std::vector<std::uint64_t> changes_;
  std::vector<PathPiece> pieces_;
  std::vector<AxisPoint> sampled_;  // of the move to come
  AxisPoint at_{};
  std::uint64_t line_ = 0;
};

// The events of the model; why it could not decide goes to `undecided`.
std::vector<spec::Event<double>> model_events(const spec::Case& c, std::string& undecided) {
  std::vector<spec::Event<double>> events;
  for (const model::Event& event : fuzz::run_model(c).events) {
    if (event.kind == spec::EventKind::undecided) {
      undecided = "the model could not decide line " + std::to_string(event.line) + " (" +
                  std::string(event.number.view()) + ")";
      break;
    }
    events.push_back(in_double(event));
  }
  return events;
}

}  // namespace

OldProgramPath::OldProgramPath(const spec::Case& c, const TraceSpace& space, double tolerance, bool judge_rapids) {
  constexpr std::uint32_t kFewSamples = 16;
  constexpr std::uint32_t kMostSamples = 1024;
  const double sagitta = tolerance / 1000;
  const auto build = [&](std::uint32_t samples) {
    spec::Case sampled = c;
    sampled.samples = samples;
    events_ = model_events(sampled, undecided_);
    Builder builder(c, sagitta, judge_rapids);
    for (const auto& event : events_) builder.add(event);
    pieces_ = builder.take();
  };
  build(kFewSamples);
  if (std::ranges::none_of(events_, [](const auto& event) { return event.kind == spec::EventKind::sample; })) return;
  // Two chords of one move: their common end against the middle of both other ends, four sagittas of one chord away.
  double largest = 0;
  for (std::size_t i = 1; i < pieces_.size(); ++i)
    for (const auto* axes : {&space.linear, &space.rotary})
      for (const std::size_t axis : *axes)
        if (!pieces_[i - 1].corner)
          largest = std::max(
              largest, std::fabs(pieces_[i].begin[axis] - (pieces_[i - 1].begin[axis] + pieces_[i].end[axis]) / 2) / 4);
  const double finer = std::sqrt(largest / sagitta);
  if (finer > 1) build(static_cast<std::uint32_t>(std::min<double>(kMostSamples, std::ceil(finer * kFewSamples))));
}

bool OldProgramPath::next(PathPiece& piece) {
  if (next_ == pieces_.size()) return false;
  piece = pieces_[next_++];
  return true;
}

}  // namespace toolcomp::certify

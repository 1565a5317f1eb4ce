#include "certify/trace.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "certify/convert.h"
#include "certify/trace_csv.h"
#include "certify/trace_path.h"
#include "fuzz/oracle/verdict.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify {
namespace {

// Follows a recording along the path. After each sample it knows every piece on which the sample may lie, and the least
// parameter there that agrees with all samples before: a greedy choice would be wrong where the path crosses itself.
class Follower {
 public:
  Follower(std::vector<PathPiece> pieces, PathSpace space, const TraceOptions& options, TraceResult& result)
      : pieces_(std::move(pieces)), space_(std::move(space)), options_(options), result_(result) {}

  void take(const TraceSample& sample) {
    const AxisPoint p = sample.axes.value;
    ++result_.samples;
    Places next = result_.samples == 1 ? first_places(p) : next_places(p);
    if (next.empty()) next = missed_corner(sample, p);
    if (next.empty()) {
      off_the_path(sample, p);
      if (places_.empty()) places_[0] = 0;
    } else {
      off_run_ = false;
      places_ = std::move(next);
      measure(sample, p);
    }
    last_ = p;
    last_line_ = sample.line;
  }

  void end() {
    if (result_.samples == 0 || pieces_.empty()) return;
    // The last sample stands at the end, or the corners from there on were not reached.
    std::size_t at = places_.rbegin()->first;
    bool reached = true;
    for (; at < pieces_.size(); ++at) {
      if (!pieces_[at].corner || passes(pieces_[at], last_, last_)) continue;
      reached = false;
      ++result_.corners_missed;
    }
    if (!reached) add(corner_finding("end not reached", pieces_.back(), last_line_));
  }

 private:
  // Piece → least parameter.
  using Places = std::map<std::size_t, double>;

  static void put(Places& places, std::size_t piece, double parameter) {
    const auto [place, added] = places.try_emplace(piece, parameter);
    if (!added) place->second = std::min(place->second, parameter);
  }

  [[nodiscard]] std::optional<std::pair<double, double>> part(const PathPiece& piece, const AxisPoint& p) const {
    if (piece.ends_only) return std::pair(0.0, 1.0);
    return part_near(space_, piece.begin, piece.end, p);
  }

  // Whether the straight line from `a` to `b` passes the end of the piece.
  [[nodiscard]] bool passes(const PathPiece& piece, const AxisPoint& a, const AxisPoint& b) const {
    return part_near(space_, a, b, piece.end).has_value();
  }

  // Anywhere on the first move, or behind it if the sample stands at its end.
  Places first_places(const AxisPoint& p) {
    Places places;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (const auto near = part(pieces_[i], p)) put(places, i, near->first);
      if (pieces_[i].corner && !passes(pieces_[i], p, p)) break;
    }
    return places;
  }

  Places next_places(const AxisPoint& p) {
    Places places;
    double chord = 0;
    for (const std::size_t axis : space_.linear) chord += (p[axis] - last_[axis]) * (p[axis] - last_[axis]);
    // An arc of up to half a turn is at most pi/2 times as long as the chord between its ends.
    const double longest = std::numbers::pi / 2 * (std::sqrt(chord) + 2 * space_.tolerance);
    for (const auto& [from, parameter] : places_) {
      if (const auto near = part(pieces_[from], p); near && std::max(near->first, parameter) <= near->second)
        put(places, from, std::max(near->first, parameter));
      double skipped = 0;
      for (std::size_t i = from; i + 1 < pieces_.size(); ++i) {
        if (i > from) skipped += pieces_[i].length;
        if (pieces_[i].corner) skipped = 0;
        const bool beside = !pieces_[i].corner && skipped <= longest;
        if (!beside && !passes(pieces_[i], last_, p)) break;
        if (const auto near = part(pieces_[i + 1], p)) put(places, i + 1, near->first);
      }
    }
    return places;
  }

  // The sample lies further on, but a corner before it was not reached, or a curve not followed: told once, and
  // followed on from there.
  Places missed_corner(const TraceSample& sample, const AxisPoint& p) {
    constexpr std::size_t kLookAhead = 64;  // corners
    if (places_.empty()) return {};
    const std::size_t from = places_.begin()->first;
    std::vector<std::size_t> missed;
    std::size_t corners = 0;
    for (std::size_t i = from; i + 1 < pieces_.size() && corners < kLookAhead; ++i) {
      if (pieces_[i].corner) {
        ++corners;
        if (!passes(pieces_[i], last_, p)) missed.push_back(i);
      }
      const PathPiece& piece = pieces_[i + 1];
      // A move whose inside is not judged accepts everything: no proof that the corner before it was passed.
      if (piece.ends_only) continue;
      if (const auto near = part_near(space_, piece.begin, piece.end, p)) {
        result_.corners_missed += missed.size();
        for (const std::size_t corner : missed)
          add(corner_finding("corner not reached", pieces_[corner], sample.line, p));
        if (missed.empty()) add(corner_finding("move left out", pieces_[i], sample.line, p));
        return {{i + 1, near->first}};
      }
    }
    return {};
  }

  void off_the_path(const TraceSample& sample, const AxisPoint& p) {
    ++result_.off;
    // The move it should have been on, and how far that is.
    std::size_t nearest = places_.empty() ? 0 : places_.begin()->first;
    Distance least{std::numeric_limits<double>::infinity(), 0};
    std::size_t corners = 0;
    for (std::size_t i = nearest; i < pieces_.size() && corners < 3; ++i) {
      const PathPiece& piece = pieces_[i];
      const Distance d = distance_at(space_, piece.begin, piece.end, closest(space_, piece.begin, piece.end, p), p);
      if (std::max(d.linear, d.rotary) < std::max(least.linear, least.rotary)) {
        least = d;
        nearest = i;
      }
      if (piece.corner) ++corners;
    }
    double distance = std::max(least.linear, least.rotary);
    // On the path, but before what was reached already.
    const bool behind = part_near(space_, pieces_[nearest].begin, pieces_[nearest].end, p).has_value();
    if (behind && !places_.empty()) {
      nearest = places_.begin()->first;
      const PathPiece& piece = pieces_[nearest];
      const double t = closest(space_, piece.begin, piece.end, p, std::min(1.0, places_.begin()->second));
      const Distance back = distance_at(space_, piece.begin, piece.end, t, p);
      distance = std::max(back.linear, back.rotary);
    }
    if (off_run_ && run_ < result_.findings.size()) {
      TraceFinding& run = result_.findings[run_];
      ++run.samples;
      if (distance > run.distance) {
        run.distance = distance;
        run.at = sample.axes;
        run.sample = sample.line;
        run.line = pieces_[nearest].line;
        run.n = pieces_[nearest].n;
      }
      return;
    }
    if (off_run_) return;
    off_run_ = true;
    run_ = result_.findings.size();
    TraceFinding finding;
    finding.kind = behind ? "out of order" : "off the path";
    finding.sample = sample.line;
    finding.line = pieces_[nearest].line;
    finding.n = pieces_[nearest].n;
    finding.distance = distance;
    finding.at = sample.axes;
    add(std::move(finding));
  }

  [[nodiscard]] TraceFinding corner_finding(std::string kind, const PathPiece& piece, std::uint64_t sample,
                                            std::optional<AxisPoint> to = {}) const {
    TraceFinding finding;
    finding.kind = std::move(kind);
    finding.sample = sample;
    finding.line = piece.line;
    finding.n = piece.n;
    const AxisPoint& b = to ? *to : last_;
    const Distance d = distance_at(space_, last_, b, closest(space_, last_, b, piece.end), piece.end);
    finding.distance = std::max(d.linear, d.rotary);
    for (const auto* axes : {&space_.linear, &space_.rotary})
      for (const std::size_t axis : *axes) finding.at.set(axis, piece.end[axis]);
    return finding;
  }

  void add(TraceFinding finding) {
    ++result_.findings_total;
    if (result_.findings.size() < options_.most_findings) result_.findings.push_back(std::move(finding));
  }

  void measure(const TraceSample& sample, const AxisPoint& p) {
    Distance best{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (const auto& [i, parameter] : places_) {
      const PathPiece& piece = pieces_[i];
      if (piece.ends_only) return;
      const auto near = part(piece, p);
      const double high = near ? std::max(near->second, parameter) : 1;
      const Distance d =
          distance_at(space_, piece.begin, piece.end, closest(space_, piece.begin, piece.end, p, parameter, high), p);
      if (d.linear < best.linear || (d.linear == best.linear && d.rotary < best.rotary)) best = d;
    }
    if (best.linear > result_.worst) {
      result_.worst = best.linear;
      result_.worst_sample = sample.line;
    }
    result_.worst_rotary = std::max(result_.worst_rotary, best.rotary);
  }

  std::vector<PathPiece> pieces_;
  PathSpace space_;
  const TraceOptions& options_;
  TraceResult& result_;
  Places places_;
  AxisPoint last_{};
  std::uint64_t last_line_ = 0;
  bool off_run_ = false;  // the sample before was off the path
  std::size_t run_ = 0;   // its finding
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

// The path of the axes: under tool center point control it bends inside blocks, so it is sampled until the chords are
// within a thousandth of the tolerance, as far as `kMostSamples` do that.
std::vector<spec::Event<double>> exact_path(spec::Case c, const PathSpace& space, std::string& undecided) {
  constexpr std::uint32_t kFewSamples = 16;
  constexpr std::uint32_t kMostSamples = 1024;
  c.samples = kFewSamples;
  std::vector<spec::Event<double>> events = model_events(c, undecided);
  const bool sampled = std::ranges::any_of(
      events, [](const spec::Event<double>& event) { return event.kind == spec::EventKind::sample; });
  if (!sampled || !undecided.empty()) return events;
  const double finer = std::sqrt(1000 * largest_sagitta(c, events, space) / space.tolerance);
  if (!(finer > 1)) return events;
  c.samples = static_cast<std::uint32_t>(std::min<double>(kMostSamples, std::ceil(finer * kFewSamples)));
  return model_events(c, undecided);
}

}  // namespace

TraceResult judge_trace(const spec::Case& c, std::istream& csv, const std::string& file, const TraceOptions& options) {
  if (!(options.tolerance > 0) || !std::isfinite(options.tolerance))
    throw spec::InputError("--tolerance", 0, 0, "must be a positive number of setup units");
  TraceResult result;
  TraceReader reader(csv, file, c.setup.axes);
  PathSpace space;
  space.tolerance = options.tolerance;
  for (std::size_t i = 0; i < c.setup.axes.size(); ++i) {
    const char letter = c.setup.axes.letter(i);
    if (std::ranges::find(reader.recorded(), i) == reader.recorded().end()) {
      result.not_recorded += letter;
      continue;
    }
    result.recorded += letter;
    (spec::is_rotary_axis(letter) ? space.rotary : space.linear).push_back(i);
  }
  result.events = exact_path(c, space, result.undecided);
  if (!result.undecided.empty()) return result;
  std::vector<PathPiece> pieces = path_pieces(c, result.events, space, options.judge_rapids);
  for (const PathPiece& piece : pieces) {
    result.corners += piece.corner ? 1 : 0;
    result.not_judged_moves += piece.ends_only ? 1 : 0;
  }
  if (pieces.empty()) return result;
  Follower follower(std::move(pieces), std::move(space), options, result);
  TraceSample sample;
  while (reader.next(sample)) follower.take(sample);
  follower.end();
  return result;
}

int exit_status(const TraceResult& result) {
  if (result.findings_total > 0) return 1;
  return !result.undecided.empty() || result.samples == 0 || result.corners == 0 ? 3 : 0;
}

}  // namespace toolcomp::certify

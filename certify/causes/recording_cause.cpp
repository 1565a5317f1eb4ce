// SPDX-License-Identifier: Apache-2.0
#include "certify/causes/recording_cause.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "certify/causes/follow.h"
#include "certify/causes/least.h"
#include "certify/causes/listed_path.h"
#include "certify/causes/mistakes.h"
#include "certify/causes/programmed_path.h"
#include "spec/language/input_error.h"

namespace toolcomp::certify {
namespace {

// Of longer paths no cause is found that leaves the path as it is.
constexpr std::size_t kMostPieces = 100000;
// Values are searched by the recording up to so many samples behind the first finding.
constexpr std::size_t kSearchedBehind = 5000;
constexpr double kNever = std::numeric_limits<double>::infinity();

using MakePath = std::function<std::unique_ptr<PathSource>(Distance tolerance)>;

class Causes {
 public:
  Causes(const spec::Case& c, const RecordedRun& run, const Metric& metric, ProgramPathOptions options,
         const TraceResult& found)
      : c_(c), run_(run), metric_(metric), options_(std::move(options)) {
    options_.on_event = {};
    for (const TraceFinding& finding : found.findings) {
      off_.linear = std::max(off_.linear, finding.distance.upper);
      off_.rotary = std::max(off_.rotary, finding.rotary.upper);
    }
    if (!found.findings.empty()) {
      const auto first =
          std::ranges::lower_bound(run.samples, found.findings.front().sample, {}, &RecordedSample::line);
      searched_ = std::min(run.samples.size(), static_cast<std::size_t>(first - run.samples.begin()) + kSearchedBehind);
    }
    for (const std::size_t axis : metric.space().linear) axes_.push_back(axis);
    for (const std::size_t axis : metric.space().rotary) axes_.push_back(axis);
  }

  std::optional<std::string> find() {
    // What was found is not about the path.
    if (conforms(path(), as_recorded())) return std::nullopt;
    for (const OtherCase& other : with_mistakes(c_))
      if (conforms(path_of(other.c), as_recorded())) return other.cause;
    if (auto cause = no_tip_control()) return cause;
    if (auto cause = exchanged()) return cause;
    if (auto cause = stretched()) return cause;
    if (auto cause = late()) return cause;
    return off_value();
  }

 private:
  [[nodiscard]] char letter(std::size_t axis) const { return c_.setup.axes.letter(axis); }
  [[nodiscard]] bool is_linear(std::size_t axis) const { return spec::is_linear_axis(letter(axis)); }
  [[nodiscard]] double tolerance(std::size_t axis) const {
    return is_linear(axis) ? metric_.tolerance().linear : metric_.tolerance().rotary;
  }
  [[nodiscard]] Recorded as_recorded() const {
    return [this](std::size_t i) { return run_.samples[i].at; };
  }
  [[nodiscard]] MakePath path_of(const spec::Case& c) const {
    return [this, &c](Distance tolerance) -> std::unique_ptr<PathSource> {
      return std::make_unique<ProgramPath>(c, metric_.space(), tolerance, options_);
    };
  }
  // The exact path; it is made once for each tolerance.
  [[nodiscard]] MakePath path() const {
    return [this](Distance tolerance) -> std::unique_ptr<PathSource> {
      Pieces& kept = tolerance.linear == metric_.tolerance().linear ? pieces_ : wide_pieces_;
      if (!kept) {
        ProgramPath made(c_, metric_.space(), tolerance, options_);
        kept = pieces_of(made);
      }
      return std::make_unique<ListedPath>(kept);
    };
  }

  static Pieces pieces_of(PathSource& path) {
    auto pieces = std::make_shared<std::vector<PathPiece>>();
    for (PathPiece piece; pieces->size() < kMostPieces && path.next(piece);) pieces->push_back(piece);
    return pieces;
  }

  // The largest distance in tolerances of `metric`, of all samples or of the first ones; nothing where the recording is
  // beyond them, or there is no path.
  [[nodiscard]] std::optional<double> distance(const MakePath& make, const Recorded& recorded, const Metric& metric,
                                               std::size_t count) const {
    try {
      return followed(*make(metric.tolerance()), metric, count, count == run_.samples.size(), recorded);
    } catch (const spec::InputError&) {
      return std::nullopt;  // no control could have such a setup
    }
  }
  [[nodiscard]] bool conforms(const MakePath& make, const Recorded& recorded) const {
    return distance(make, recorded, metric_, run_.samples.size()).has_value();
  }
  // Compared with what was found: some tolerances, or infinite where it is much more.
  [[nodiscard]] double worst(const MakePath& make, const Recorded& recorded) const {
    return distance(make, recorded, wide(), searched_).value_or(kNever);
  }
  // The least tolerance within which the recording follows, in those that it is searched with. Dearer; it also sees
  // what no sample shows: an axis that turns back on the same line too early.
  [[nodiscard]] double least_tolerance(const MakePath& make, const Recorded& recorded) const {
    constexpr int kBisections = 7;
    Pieces pieces;
    const auto kept = [&](Distance tolerance) -> std::unique_ptr<PathSource> {
      if (!pieces) pieces = pieces_of(*make(tolerance));
      return std::make_unique<ListedPath>(pieces);
    };
    const auto follows = [&](double scale) {
      // Of the axes that were found off; the others keep the judge's.
      Distance least = wide().tolerance();
      if (off_.linear > metric_.tolerance().linear) least.linear *= scale;
      if (off_.rotary > metric_.tolerance().rotary) least.rotary *= scale;
      const Metric metric(metric_.space(), least);
      return distance(kept, recorded, metric, searched_).has_value();
    };
    if (!follows(1)) return kNever;
    double low = 0;
    double high = 1;
    for (int i = 0; i < kBisections; ++i) {
      const double middle = (low + high) / 2;
      (follows(middle) ? high : low) = middle;
    }
    return high;
  }
  // Twice what was found, the judge's at least.
  [[nodiscard]] Metric wide() const {
    const Distance& t = metric_.tolerance();
    return {metric_.space(), {std::max(t.linear, 2 * off_.linear), std::max(t.rotary, 2 * off_.rotary)}};
  }

  std::optional<std::string> no_tip_control() const {
    const MakePath make = [this](Distance) { return programmed_path(c_, metric_.space(), options_.frame); };
    if (!make({})) return std::nullopt;
    std::string cause = "tool center point control is not in force";
    if (conforms(make, as_recorded())) return cause;
    // The length may be taken off along an axis all the same.
    const std::vector<Line> lines = lines_through(make);
    const auto shifted = [&](std::size_t i) {
      AxisPoint at = run_.samples[i].at;
      for (const std::size_t axis : metric_.space().linear) at[axis] -= lines[axis].shift;
      return at;
    };
    if (conforms(make, shifted)) return cause + shift_text(lines, " and the axes are shifted by");
    return std::nullopt;
  }

  std::optional<std::string> exchanged() const {
    for (std::size_t i = 0; i < axes_.size(); ++i)
      for (std::size_t k = i + 1; k < axes_.size(); ++k) {
        const std::size_t a = axes_[i];
        const std::size_t b = axes_[k];
        const auto back = [&](std::size_t sample) {
          AxisPoint at = run_.samples[sample].at;
          std::swap(at[a], at[b]);
          return at;
        };
        if (is_linear(a) == is_linear(b) && conforms(path(), back))
          return fmt::format("axes {} and {} are exchanged", letter(a), letter(b));
      }
    return std::nullopt;
  }

  // Recorded = scale · exact + shift, of one axis.
  struct Line {
    double scale = 1;
    double shift = 0;
    double mirrored = 0;  // the shift with the scale -1: its range is that of the exact one, the other way round
    bool moves = false;
  };

  // By the least and the largest position of each axis.
  [[nodiscard]] std::vector<Line> lines_through(const MakePath& make) const {
    AxisBox exact;
    const std::unique_ptr<PathSource> path = make(metric_.tolerance());
    for (PathPiece piece; path->next(piece);) {
      if (exact.low[axes_.front()] > exact.high[axes_.front()]) exact.add(piece.begin);
      exact.add(piece.end);
    }
    AxisBox recorded;
    for (const RecordedSample& sample : run_.samples) recorded.add(sample.at);
    std::vector<Line> lines(spec::kMaxAxes);
    for (const std::size_t axis : axes_) {
      const double width = exact.high[axis] - exact.low[axis];
      Line& line = lines[axis];
      line.moves = width > 8 * tolerance(axis);
      if (line.moves) line.scale = (recorded.high[axis] - recorded.low[axis]) / width;
      // What the ends of the range cannot tell from 1.
      if (std::fabs(line.scale - 1) * width < tolerance(axis) / 4) line.scale = 1;
      const double twice_recorded = recorded.low[axis] + recorded.high[axis];
      const double twice_exact = exact.low[axis] + exact.high[axis];
      line.shift = (twice_recorded - line.scale * twice_exact) / 2;
      line.mirrored = (twice_recorded + twice_exact) / 2;
      if (std::fabs(line.mirrored) < tolerance(axis) / 4) line.mirrored = 0;
      if (std::fabs(line.shift) < tolerance(axis) / 16) line.shift = 0;
    }
    return lines;
  }

  [[nodiscard]] Recorded undone(std::vector<Line> lines) const {
    return [this, lines = std::move(lines)](std::size_t i) {
      AxisPoint at = run_.samples[i].at;
      for (const std::size_t axis : axes_) at[axis] = (at[axis] - lines[axis].shift) / lines[axis].scale;
      return at;
    };
  }

  std::optional<std::string> stretched() const {
    const std::vector<Line> lines = lines_through(path());
    std::vector<Line> shifted = lines;
    for (Line& line : shifted) line.scale = 1;
    if (conforms(path(), undone(shifted))) return "the recording is shifted by" + shift_text(shifted, "");
    for (const std::size_t axis : axes_) {
      std::vector<Line> reversed(spec::kMaxAxes);
      reversed[axis].scale = -1;
      reversed[axis].shift = lines[axis].mirrored;
      if (lines[axis].moves && conforms(path(), undone(reversed)))
        return fmt::format("axis {} runs in the opposite direction", letter(axis)) +
               shift_text(reversed, ", shifted by");
    }
    if (!conforms(path(), undone(lines))) return std::nullopt;
    std::string text;
    for (const std::size_t axis : axes_)
      if (lines[axis].scale != 1)
        text += fmt::format("{}{} by {:.9g}", text.empty() ? " " : ", ", letter(axis), lines[axis].scale);
    return "the recording is scaled:" + text + shift_text(lines, ", and shifted by");
  }

  // " X 0.5, Z -25" behind `before`; nothing where nothing is shifted.
  [[nodiscard]] std::string shift_text(const std::vector<Line>& lines, std::string_view before) const {
    std::string text;
    for (const std::size_t axis : axes_)
      if (lines[axis].shift != 0)
        text += fmt::format("{}{} {:.6g}", text.empty() ? " " : ", ", letter(axis), lines[axis].shift);
    return text.empty() ? text : std::string(before) + text;
  }

  // One axis, all axes before it or behind it in time.
  std::optional<std::string> late() const {
    if (!run_.has_time || run_.samples.size() < 3) return std::nullopt;
    const double period =
        (run_.samples.back().time - run_.samples.front().time) / static_cast<double>(run_.samples.size() - 1);
    for (const std::size_t axis : axes_) {
      const auto moved = [&](double seconds) {
        return [this, axis, seconds](std::size_t i) {
          AxisPoint at = run_.samples[i].at;
          at[axis] = recorded_at(axis, run_.samples[i].time + seconds);
          return at;
        };
      };
      const auto least = least_of([&](double seconds) { return worst(path(), moved(seconds)); }, 64 * period);
      if (least && conforms(path(), moved(*least)))
        return fmt::format("axis {} is {} by {:.3g} ms", letter(axis), *least > 0 ? "late" : "early",
                           std::fabs(*least) * 1000);
    }
    return std::nullopt;
  }

  // Between two samples evenly, before the first and behind the last standing.
  [[nodiscard]] double recorded_at(std::size_t axis, double time) const {
    const auto behind = std::ranges::upper_bound(run_.samples, time, {}, &RecordedSample::time);
    if (behind == run_.samples.begin()) return behind->at[axis];
    const RecordedSample& before = *(behind - 1);
    if (behind == run_.samples.end()) return before.at[axis];
    const double t = (time - before.time) / (behind->time - before.time);
    return before.at[axis] + t * (behind->at[axis] - before.at[axis]);
  }

  std::optional<std::string> off_value() const {
    const double off = off_.linear > 0 ? off_.linear : metric_.tolerance().linear;
    // A length that is off by far more is a mistake of another kind.
    if (off > 1000 * metric_.tolerance().linear) return std::nullopt;
    // Where the samples are nearer to the path than what was found, they do not show it.
    const bool hidden = worst(path(), as_recorded()) * wide().tolerance().linear < off_.linear / 2;
    for (const OtherValue& value : other_values(c_)) {
      const auto least = least_of(
          [&](double by) {
            const spec::Case other = value.by(by);
            const MakePath make = path_of(other);
            return hidden ? least_tolerance(make, as_recorded()) : worst(make, as_recorded());
          },
          value.reach * off);
      if (!least) continue;
      const spec::Case other = value.by(*least);
      if (conforms(path_of(other), as_recorded())) return fmt::format("{} by {:+.4g}", value.cause, *least);
    }
    return std::nullopt;
  }

  const spec::Case& c_;
  const RecordedRun& run_;
  const Metric& metric_;
  ProgramPathOptions options_;
  Distance off_;  // the farthest that was found
  std::vector<std::size_t> axes_;
  std::size_t searched_ = 0;  // samples that values are searched by
  mutable Pieces pieces_;
  mutable Pieces wide_pieces_;
};

}  // namespace

std::optional<std::string> common_cause(const spec::Case& c, const RecordedRun& run, const Metric& metric,
                                        const ProgramPathOptions& options, const TraceResult& found) {
  if (run.samples.size() < 2) return std::nullopt;
  // Where samples are missing, nothing is known that could be explained.
  if (std::ranges::all_of(found.findings, [](const TraceFinding& f) { return f.kind == "gap"; })) return std::nullopt;
  return Causes(c, run, metric, options, found).find();
}

}  // namespace toolcomp::certify

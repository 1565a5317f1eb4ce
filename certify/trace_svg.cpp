// SPDX-License-Identifier: Apache-2.0
#include "certify/trace_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "certify/label_places.h"
#include "certify/markup.h"
#include "certify/path_view.h"

namespace toolcomp::certify {
namespace {

constexpr double kSide = 480;  // of a panel
constexpr double kHeader = 30;
constexpr double kMargin = 34;
constexpr double kShown = 60;  // the largest deviation on the paper
constexpr std::size_t kMostMarks = 8;
constexpr double kSqrt3Half = 0.8660254037844386;

constexpr View kTop{"top", "X", "Y", {1, 0, 0}, {0, 1, 0}};
constexpr View kFront{"side", "X", "Z", {1, 0, 0}, {0, 0, 1}};
constexpr View kCorner{"axonometric", "", "", {kSqrt3Half, -kSqrt3Half, 0}, {0.5, 0.5, 1}, true};

constexpr std::string_view kStyle = R"(<style>
.tr-paper{fill:#fff;stroke:#ccd2d9}.tr-grid{stroke:#edf0f3;fill:none}.tr-text{font:11px system-ui,sans-serif;fill:#57606a}
.tr-exact{fill:none;stroke:#8b949e;stroke-width:3.2;stroke-linejoin:round}.tr-recorded{fill:none;stroke:#0969da;stroke-width:1.3;stroke-linejoin:round}
.tr-off{fill:none;stroke:#cf222e;stroke-width:2;stroke-linejoin:round}.tr-free{fill:none;stroke:#0969da;stroke-width:1;stroke-dasharray:2 3}.tr-mark{fill:none;stroke:#cf222e;stroke-width:2.4}.tr-number{font:bold 12px system-ui,sans-serif;fill:#cf222e}
.tr-bar{fill:#0969da}.tr-bad{fill:#cf222e}.tr-limit{stroke:#9a6700;stroke-dasharray:5 3;fill:none}
@media(prefers-color-scheme:dark){.tr-paper{fill:#0d1117;stroke:#30363d}.tr-grid{stroke:#1b2129}.tr-text{fill:#9aa4af}.tr-exact{stroke:#57606a}
.tr-recorded,.tr-free{stroke:#58a6ff}.tr-off,.tr-mark{stroke:#ff7b72}.tr-number,.tr-bad{fill:#ff7b72}.tr-bar{fill:#58a6ff}.tr-limit{stroke:#d29922}}
</style>
)";

Point3 place(const AxisPoint& p, const std::array<std::size_t, 3>& xyz) {
  Point3 at{};
  for (std::size_t i = 0; i < 3; ++i)
    if (xyz[i] != spec::Axes::kNone) at[i] = p.at(xyz[i]);
  return at;
}

std::string opening(double width, double height, std::string_view label) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\" role=\"img\" aria-label=\"{2}\">\n",
      width, height, label);
}

// What is drawn: places on the exact path, recorded ones, and where findings are.
struct Scene {
  std::vector<Point3> exact;
  struct Recorded {
    Point3 at{};
    Point3 off{};  // from its place on the path
    SampleKind kind = SampleKind::off;
  };
  std::vector<Recorded> recorded;
  std::vector<Point3> marks;
  double largest = 0;  // of `off`

  Scene(const TraceResult& result, const spec::Axes& axes) {
    const std::array<std::size_t, 3> xyz{axes.index('X'), axes.index('Y'), axes.index('Z')};
    for (const AxisPoint& p : result.course) exact.push_back(place(p, xyz));
    double found = result.worst.upper;
    for (const TraceFinding& finding : result.findings) found = std::max(found, finding.distance.upper);
    for (const Deviations::Point& point : result.deviations.points()) {
      Recorded r{place(point.recorded, xyz), {}, point.kind};
      if (point.exact) r.off = plus(r.at, -1, place(*point.exact, xyz));
      // While a recording was lost, what was nearest may have been another part of the path.
      const double off = std::sqrt(dot(r.off, r.off));
      if (off > found)
        r.off = {};
      else
        largest = std::max(largest, off);
      recorded.push_back(r);
    }
    for (const TraceFinding& finding : result.findings) {
      if (marks.size() == kMostMarks) break;
      AxisPoint at{};
      for (std::size_t i = 0; i < axes.size(); ++i)
        if (finding.at.has(i)) at.at(i) = finding.at[i];
      marks.push_back(place(at, xyz));
    }
  }
  [[nodiscard]] Box box(const View& view) const {
    Box box;
    for (const Point3& p : exact) box.add(project(view, p));
    for (const Recorded& r : recorded) box.add(project(view, r.at));
    return box;
  }
  [[nodiscard]] bool solid() const {
    const Box side = box(kFront);
    const Box top = box(kTop);
    return side.top > side.bottom && top.top > top.bottom;
  }
};

class Panel {
 public:
  Panel(const View& view, const Scene& scene) : view_(view), scene_(scene) {
    const Box box = scene.box(view);
    const double size = std::max(box.right - box.left, box.top - box.bottom);
    scale_ = (kSide - 2 * kMargin) / (size > 0 ? size : 1);
    middle_ = {(box.left + box.right) / 2, (box.bottom + box.top) / 2};
  }
  [[nodiscard]] double scale() const { return scale_; }

  [[nodiscard]] std::string draw(double factor, std::string_view unit) const {
    std::string out = opening(kSide, kSide, fmt::format("exact path and recording, {}", view_.title));
    out += fmt::format("<rect class=\"tr-paper\" width=\"{0}\" height=\"{0}\"/>\n", kSide);
    const double step = grid_step(kSide / scale_);
    if (!view_.solid) {
      const std::string lines = grid_lines(middle_, step, scale_, kSide);
      if (!lines.empty()) out += fmt::format("<path class=\"tr-grid\" d=\"{}\"/>\n", lines);
    }
    out +=
        fmt::format("<text class=\"tr-text\" x=\"6\" y=\"14\">{}{}</text>\n", view_.title,
                    view_.solid ? "" : fmt::format(" {}{}, grid {} {}", view_.right, view_.up, plain(step, 9), unit));
    return out + exact() + recorded(factor) + marks() + "</svg>\n";
  }

 private:
  [[nodiscard]] std::string to(const Point3& p, bool begin) const {
    const Point2 q = at(p);
    return fmt::format("{}{:.2f} {:.2f}", begin ? 'M' : 'L', q.first, q.second);
  }
  [[nodiscard]] Point2 at(const Point3& p) const {
    const Point2 q = project(view_, p);
    return {kSide / 2 + (q.first - middle_.first) * scale_, kSide / 2 - (q.second - middle_.second) * scale_};
  }
  [[nodiscard]] std::string exact() const {
    std::string d;
    for (const Point3& p : scene_.exact) d += to(p, d.empty());
    return d.empty() ? d : fmt::format("<path class=\"tr-exact\" d=\"{}\"/>\n", d);
  }
  // Its deviations `factor` times as large; in red where it is not followed, dotted where it is not judged.
  [[nodiscard]] std::string recorded(double factor) const {
    std::string followed;
    std::string off;
    std::string free;
    const auto line_of = [&](SampleKind kind) -> std::string& {
      return kind == SampleKind::followed ? followed : kind == SampleKind::off ? off : free;
    };
    const auto drawn = [&](const Scene::Recorded& r) { return plus(r.at, factor - 1, r.off); };
    const Scene::Recorded* last = nullptr;
    const std::string* line = nullptr;  // the one that ends at the last sample
    for (const Scene::Recorded& r : scene_.recorded) {
      // What leads away and back belongs to what is off, and else to what is not judged.
      SampleKind kind = r.kind;
      if (last != nullptr && r.kind != SampleKind::off && last->kind != SampleKind::followed) kind = last->kind;
      std::string& d = line_of(kind);
      if (last != nullptr && line != &d) d += to(drawn(*last), true);
      d += to(drawn(r), last == nullptr);
      line = &d;
      last = &r;
    }
    std::string out;
    if (!followed.empty()) out += fmt::format("<path class=\"tr-recorded\" d=\"{}\"/>\n", followed);
    if (!free.empty()) out += fmt::format("<path class=\"tr-free\" d=\"{}\"/>\n", free);
    if (!off.empty()) out += fmt::format("<path class=\"tr-off\" d=\"{}\"/>\n", off);
    return out;
  }
  [[nodiscard]] std::string marks() const {
    constexpr double kRadius = 10;
    LabelPlaces places(kSide, 12);
    for (const Point3& mark : scene_.marks) places.keep_free(at(mark), kRadius);
    std::string out;
    for (std::size_t i = 0; i < scene_.marks.size(); ++i) {
      const Point2 q = at(scene_.marks[i]);
      out += fmt::format(R"(<circle class="tr-mark" cx="{:.2f}" cy="{:.2f}" r="{}"/>)", q.first, q.second, kRadius);
      const std::string number = std::to_string(i + 1);
      if (const auto p = places.beside(q, number.size(), kRadius))
        out += fmt::format(R"(<text class="tr-number" x="{:.2f}" y="{:.2f}">{}</text>)", p->first, p->second, number);
      out += '\n';
    }
    return out;
  }

  const View& view_;
  const Scene& scene_;
  double scale_ = 1;
  Point2 middle_;
};

std::string bar(double x, double bottom, double width, double height, std::string_view style, std::string_view title) {
  return fmt::format(
      "<rect class=\"{}\" x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"><title>{}</title></rect>\n",
      style, x, bottom - height, width, height, escape(title));
}

std::string text(double x, double y, std::string_view what) {
  return fmt::format("<text class=\"tr-text\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x, y, escape(what));
}

constexpr double kChart = 470;
constexpr double kTall = 180;
constexpr double kBase = 150;  // where bars stand
constexpr double kHigh = 120;  // of the largest bar

}  // namespace

std::string trace_svg(const TraceResult& result, const spec::Axes& axes, std::string_view unit) {
  const Scene scene(result, axes);
  if (std::ranges::none_of(result.recorded, spec::is_linear_axis) || (scene.exact.empty() && scene.recorded.empty()))
    return {};
  std::vector<const View*> views{&kTop, &kFront};
  if (scene.solid()) views.push_back(&kCorner);
  double scale = 0;
  for (const View* view : views) scale = std::max(scale, Panel(*view, scene).scale());
  const double factor = scene.largest > 0 ? std::max(1.0, round_down(kShown / (scene.largest * scale))) : 1;
  std::string out = std::string(kStyle) + opening(kSide, kHeader, "legend");
  out += R"(<path class="tr-exact" d="M6 15h22"/>)" + text(34, 19, "exact path");
  out += R"(<path class="tr-recorded" d="M106 15h22"/>)" +
         text(134, 19, fmt::format("recording, deviations {} times as large", plain(factor, 0)));
  out += R"(<path class="tr-off" d="M376 15h22"/>)" + text(404, 19, "off the path") + "</svg><br/>\n";
  if (result.deviations.not_judged() > 0)
    out += opening(kSide, kHeader, "legend, not judged") + R"(<path class="tr-free" d="M106 15h22"/>)" +
           text(134, 19, "recording on moves judged at their ends only") + "</svg><br/>\n";
  for (const View* view : views) out += Panel(*view, scene).draw(factor, unit);
  return out;
}

std::vector<ViewSample> view_samples(const TraceResult& result, const spec::Axes& axes) {
  std::vector<ViewSample> samples;
  for (const Scene::Recorded& r : Scene(result, axes).recorded)
    samples.push_back({r.at, plus(r.at, -1, r.off), r.kind == SampleKind::off});
  return samples;
}

std::string deviation_svg(const TraceResult& result, const TraceOptions& options, std::string_view unit) {
  const Deviations& d = result.deviations;
  std::string out = std::string(kStyle) + opening(kChart, kTall, "largest deviation by move");
  // By move: the height is the part of the tolerance, a little more than all of it at most.
  const Distance tolerance{options.tolerance, options.rotary_tolerance.value_or(options.tolerance)};
  out += text(6, 14,
              fmt::format("largest deviation by move; line: the tolerance, {} {}", plain(options.tolerance, 9), unit));
  const double each = d.moves().empty() ? 0 : (kChart - 12) / static_cast<double>(d.moves().size());
  for (std::size_t i = 0; i < d.moves().size(); ++i) {
    const Deviations::Move& move = d.moves()[i];
    const double height = std::max(1.0, std::min(in_tolerances(move.largest, tolerance), 1.1) * kHigh);
    std::string title = fmt::format("line {}: {} {}", move.line, plain(move.largest.linear, 6), unit);
    if (move.largest.rotary > 0) title += fmt::format(", {} degrees", plain(move.largest.rotary, 6));
    if (move.off) title += ", left";
    out += bar(6 + static_cast<double>(i) * each, kBase, std::max(each * 0.85, 0.4), move.off ? 1.1 * kHigh : height,
               move.off ? "tr-bad" : "tr-bar", title);
  }
  out += fmt::format("<path class=\"tr-limit\" d=\"M6 {0}H{1}\"/>\n", kBase - kHigh, kChart - 6);
  if (!d.moves().empty()) {
    out += text(6, kBase + 16, fmt::format("line {}", d.moves().front().line));
    out += text(kChart - 70, kBase + 16, fmt::format("line {}", d.moves().back().line));
  }
  out += "</svg>\n" + opening(kChart, kTall, "samples by deviation");
  // By size; heights go with the logarithm, so that few samples are seen beside many.
  out += text(6, 14, "samples by deviation, from 0 to the tolerance; red: not on the path (logarithmic)");
  if (d.not_judged() > 0)
    out += text(6, 28, fmt::format("without {} samples on moves judged at their ends only", d.not_judged()));
  const std::uint64_t most = std::max<std::uint64_t>(std::ranges::max(d.histogram()), d.off());
  const auto height = [&](std::uint64_t count) {
    return count == 0
               ? 0.0
               : kHigh * (1 + std::log10(static_cast<double>(count))) / (1 + std::log10(static_cast<double>(most)));
  };
  const double bin = (kChart - 50) / static_cast<double>(Deviations::kBins);
  for (std::size_t i = 0; i < Deviations::kBins; ++i) {
    const std::uint64_t count = d.histogram().at(i);
    out += bar(6 + static_cast<double>(i) * bin, kBase, bin * 0.85, height(count), "tr-bar",
               fmt::format("{} to {} % of the tolerance: {} samples", i * 5, i * 5 + 5, count));
  }
  out += bar(12 + bin * Deviations::kBins, kBase, bin * 0.85, height(d.off()), "tr-bad",
             fmt::format("{} samples not on the path", d.off()));
  out += text(6, kBase + 16, "0") + text(bin * Deviations::kBins - 40, kBase + 16, "tolerance");
  return out + "</svg>\n";
}

}  // namespace toolcomp::certify

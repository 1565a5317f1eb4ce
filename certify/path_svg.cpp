#include "certify/path_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <ranges>
#include <string_view>
#include <utility>
#include <vector>

#include "certify/markup.h"

namespace toolcomp::certify {
namespace {

constexpr double kPanel = 320;  // width and height of a panel
constexpr double kMargin = 34;  // around the drawing in a panel
constexpr double kHeader = 48;  // legend above the panels
constexpr std::size_t kMostLabels = 40;

struct Layer {
  Path path;
  std::string style;  // CSS class
  std::string name;
};

// A projection onto the paper, x to the right and y up.
struct View {
  std::string_view title;
  std::string_view right;
  std::string_view up;
  std::array<double, 3> x;
  std::array<double, 3> y;
  bool solid = false;  // shows tool directions
};

constexpr double kCos30 = 0.8660254037844386;
constexpr View kTop{"top", "X", "Y", {1, 0, 0}, {0, 1, 0}};
constexpr View kSide{"side", "X", "Z", {1, 0, 0}, {0, 0, 1}};
constexpr View kCorner{"axonometric", "", "", {kCos30, -kCos30, 0}, {-0.5, -0.5, 1}, true};

using Point2 = std::pair<double, double>;

Point2 project(const View& view, const Point3& p) {
  Point2 q{0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    q.first += view.x[i] * p[i];
    q.second += view.y[i] * p[i];
  }
  return q;
}

struct Box {
  double left = std::numeric_limits<double>::infinity();
  double right = -left;
  double bottom = left;
  double top = -left;
  void add(const Point2& p) {
    left = std::min(left, p.first);
    right = std::max(right, p.first);
    bottom = std::min(bottom, p.second);
    top = std::max(top, p.second);
  }
};

// The largest of 1, 2, 5 · 10^n of which about five fit into `size`.
double grid_step(double size) {
  const double rough = size / 5;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  const double mantissa = rough / power;
  return power * (mantissa >= 5 ? 5 : mantissa >= 2 ? 2 : 1);
}

std::string label_of(const spec::Event<double>& event) {
  return event.n ? fmt::format("N{}", *event.n) : fmt::format("{}", event.line);
}

std::string coordinates(const Point3& p) {
  return fmt::format("X{} Y{} Z{}", plain(p[0], 6), plain(p[1], 6), plain(p[2], 6));
}

// One panel of the picture.
class Panel {
 public:
  Panel(const View& view, const std::vector<Layer>& layers, std::string_view unit) : view_(view), unit_(unit) {
    Box box;
    for (const Layer& layer : layers) {
      box.add(project(view, layer.path.start));
      for (const PathMove& move : layer.path.moves)
        for (const Point3& p : move.points) box.add(project(view, p));
    }
    size_ = std::max({box.right - box.left, box.top - box.bottom});
    // A path that is one point still gets a paper.
    if (!(size_ > 0)) size_ = 1;
    scale_ = (kPanel - 2 * kMargin) / size_;
    middle_ = {(box.left + box.right) / 2, (box.bottom + box.top) / 2};
  }

  [[nodiscard]] std::string draw(double left, const std::vector<Layer>& layers,
                                 std::span<const spec::Event<double>> events, const PathOptions& options) const {
    std::string out = fmt::format("<g transform=\"translate({:.1f} {:.1f})\">\n", left, kHeader);
    out += fmt::format("<rect class=\"tp-paper\" width=\"{0}\" height=\"{0}\"/>\n", kPanel);
    out += grid();
    for (const Layer& layer : layers) out += course(layer);
    if (view_.solid) out += tools(layers, events);
    out += ends(layers.front(), events);
    if (options.marked && *options.marked < events.size()) out += mark(layers, *options.marked);
    return out + "</g>\n";
  }

 private:
  [[nodiscard]] Point2 place(const Point3& p) const {
    const Point2 q = project(view_, p);
    return {kPanel / 2 + (q.first - middle_.first) * scale_, kPanel / 2 - (q.second - middle_.second) * scale_};
  }

  [[nodiscard]] std::string grid() const {
    const double step = grid_step(size_ * kPanel / (kPanel - 2 * kMargin));
    std::string lines;
    if (!view_.solid) {
      const double half = kPanel / 2 / scale_;
      const auto first_line = [&](double middle) {
        return static_cast<std::int64_t>(std::ceil((middle - half) / step));
      };
      const auto last_line = [&](double middle) {
        return static_cast<std::int64_t>(std::floor((middle + half) / step));
      };
      const auto at = [&](std::int64_t line, double middle) {
        return (static_cast<double>(line) * step - middle) * scale_;
      };
      for (std::int64_t line = first_line(middle_.first); line <= last_line(middle_.first); ++line)
        lines += fmt::format("M{0:.2f} 0V{1}", kPanel / 2 + at(line, middle_.first), kPanel);
      for (std::int64_t line = first_line(middle_.second); line <= last_line(middle_.second); ++line)
        lines += fmt::format("M0 {0:.2f}H{1}", kPanel / 2 - at(line, middle_.second), kPanel);
    }
    std::string out = lines.empty() ? "" : fmt::format("<path class=\"tp-grid\" d=\"{}\"/>\n", lines);
    out +=
        fmt::format("<text class=\"tp-note\" x=\"6\" y=\"14\">{}{}</text>\n", view_.title,
                    view_.solid ? "" : fmt::format(" {}{}, grid {} {}", view_.right, view_.up, plain(step, 9), unit_));
    return out + cross();
  }

  // The directions of the axes, in the lower left corner.
  [[nodiscard]] std::string cross() const {
    constexpr double length = 20;
    std::string out;
    constexpr std::array<std::string_view, 3> names{"X", "Y", "Z"};
    for (std::size_t i = 0; i < 3; ++i) {
      const double dx = view_.x[i] * length;
      const double dy = -view_.y[i] * length;
      if (dx == 0 && dy == 0) continue;
      const double x = view_.solid ? 34 : 12;
      const double y = kPanel - (view_.solid ? 24 : 12);
      out += fmt::format(R"(<path class="tp-cross" d="M{} {}l{:.1f} {:.1f}"/>)", x, y, dx, dy);
      out += fmt::format("<text class=\"tp-note\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x + dx * 1.25 - 3,
                         y + dy * 1.25 + 4, names[i]);
    }
    return out;
  }

  [[nodiscard]] std::string course(const Layer& layer) const {
    std::string rapid;
    std::string feed;
    Point2 from = place(layer.path.start);
    for (const PathMove& move : layer.path.moves) {
      std::string& d = move.rapid ? rapid : feed;
      d += fmt::format("M{:.2f} {:.2f}", from.first, from.second);
      for (const Point3& p : move.points) {
        from = place(p);
        d += fmt::format("L{:.2f} {:.2f}", from.first, from.second);
      }
    }
    std::string out;
    if (!rapid.empty()) out += fmt::format("<path class=\"tp-path tp-rapid {}\" d=\"{}\"/>\n", layer.style, rapid);
    if (!feed.empty()) out += fmt::format("<path class=\"tp-path {}\" d=\"{}\"/>\n", layer.style, feed);
    return out;
  }

  // Short strokes from the tool point towards the holder.
  [[nodiscard]] std::string tools(const std::vector<Layer>& layers, std::span<const spec::Event<double>> events) const {
    std::string d;
    const auto layer = std::ranges::find(layers, "tp-point", &Layer::style);
    const Path& path = layer == layers.end() ? layers.front().path : layer->path;
    for (const PathMove& move : path.moves) {
      const auto& axis = events[move.event].tool_axis;
      if (!axis) continue;
      const Point3& p = move.points.back();
      Point3 tip{};
      for (std::size_t i = 0; i < 3; ++i) tip[i] = p[i] + (*axis)[i] * size_ * 0.08;
      const Point2 a = place(p);
      const Point2 b = place(tip);
      if (std::isfinite(b.first) && std::isfinite(b.second))
        d += fmt::format("M{:.2f} {:.2f}L{:.2f} {:.2f}", a.first, a.second, b.first, b.second);
    }
    return d.empty() ? "" : fmt::format("<path class=\"tp-tool\" d=\"{}\"/>\n", d);
  }

  // A dot, a tooltip and, while they can be read, a label where each programmed move ends.
  [[nodiscard]] std::string ends(const Layer& layer, std::span<const spec::Event<double>> events) const {
    std::string out;
    Point2 last{-1e9, -1e9};
    std::size_t labels = 0;
    for (const PathMove& move : layer.path.moves) {
      const Point2 p = place(move.points.back());
      const std::string label = label_of(events[move.event]);
      out += fmt::format(R"(<circle class="tp-end" cx="{:.2f}" cy="{:.2f}" r="2"><title>{} {}</title></circle>)",
                         p.first, p.second, escape(label), coordinates(move.points.back()));
      if (labels < kMostLabels && std::hypot(p.first - last.first, p.second - last.second) > 14) {
        out += fmt::format(R"(<text class="tp-label" x="{:.2f}" y="{:.2f}">{}</text>)", p.first + 4, p.second - 4,
                           escape(label));
        last = p;
        ++labels;
      }
      out += '\n';
    }
    return out;
  }

  [[nodiscard]] std::string mark(const std::vector<Layer>& layers, std::size_t event) const {
    for (const Layer& layer : std::views::reverse(layers)) {
      if (layer.style == "tp-other") continue;
      for (const PathMove& move : layer.path.moves)
        if (move.event == event) {
          const Point2 p = place(move.points.back());
          return fmt::format("<circle class=\"tp-mark\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"8\"/>\n", p.first, p.second);
        }
    }
    return {};
  }

  const View& view_;
  std::string_view unit_;
  double size_ = 1;
  double scale_ = 1;
  Point2 middle_;
};

constexpr std::string_view kStyle = R"(<style>
.tp-paper{fill:#fff;stroke:#ccd2d9}.tp-grid{stroke:#edf0f3;fill:none}.tp-cross{stroke:#6b7580;fill:none}
.tp-note,.tp-label,.tp-legend{font:11px system-ui,sans-serif;fill:#57606a}.tp-label{font-size:9px}
.tp-path{fill:none;stroke-width:1.6;stroke-linejoin:round}.tp-rapid{stroke-dasharray:5 3}
.tp-programmed{stroke:#8b949e;stroke-width:3}.tp-point{stroke:#0969da}.tp-axes{stroke:#1a7f37}.tp-other{stroke:#cf222e;stroke-dasharray:2 2}
.tp-tool{stroke:#9a6700;fill:none}.tp-end{fill:#57606a}.tp-mark{fill:none;stroke:#cf222e;stroke-width:2}
@media(prefers-color-scheme:dark){.tp-paper{fill:#0d1117;stroke:#30363d}.tp-grid{stroke:#1b2129}.tp-cross{stroke:#8b949e}
.tp-note,.tp-label,.tp-legend{fill:#9aa4af}.tp-point{stroke:#58a6ff}.tp-axes{stroke:#3fb950}.tp-other{stroke:#ff7b72}
.tp-tool{stroke:#d29922}.tp-end{fill:#9aa4af}.tp-mark{stroke:#ff7b72}}
</style>
)";

std::vector<Layer> make_layers(std::span<const spec::Event<double>> events, const spec::Axes& axis_names,
                               const PathOptions& options) {
  std::vector<Layer> layers;
  layers.push_back({follow(axis_names, options.start, events, PathOf::programmed), "tp-programmed", "programmed"});
  Path point = follow(axis_names, options.start, events, PathOf::point);
  Path axes = follow(axis_names, options.start, events, PathOf::axes);
  const bool axes_apart = !same_course(axes, point);
  if (!point.moves.empty() && !same_course(point, layers.front().path))
    layers.push_back({point, "tp-point", "compensated (tool point)"});
  if (!axes.moves.empty() && axes_apart && !same_course(axes, layers.front().path))
    layers.push_back({std::move(axes), "tp-axes", "axes, with length offset"});
  // What can be compared with the layer above it: the axes where the other side gives them.
  Path other = follow(axis_names, options.start, options.other, PathOf::axes);
  if (other.moves.empty()) other = follow(axis_names, options.start, options.other, PathOf::point);
  if (!other.moves.empty()) layers.push_back({std::move(other), "tp-other", options.other_name});
  return layers;
}

// Whether the paths need all three coordinates.
bool is_solid(const std::vector<Layer>& layers) {
  std::array<bool, 3> used{};
  for (const Layer& layer : layers)
    for (const PathMove& move : layer.path.moves)
      for (const Point3& p : move.points)
        for (std::size_t i = 0; i < 3; ++i) used[i] = used[i] || p[i] != layers.front().path.start[i];
  return used[0] && used[1] && used[2];
}

std::string legend(const std::vector<Layer>& layers, double width) {
  std::string out;
  double x = 6;
  double y = 16;
  for (const Layer& layer : layers) {
    const double needed = 40 + 6.2 * static_cast<double>(layer.name.size());
    if (x + needed > width && x > 6) {
      x = 6;
      y += 18;
    }
    out += fmt::format(
        "<path class=\"tp-path {}\" d=\"M{:.1f} {:.1f}h22\"/><text class=\"tp-legend\" x=\"{:.1f}\" "
        "y=\"{:.1f}\">{}</text>\n",
        layer.style, x, y, x + 28, y + 4, escape(layer.name));
    x += needed;
  }
  return out;
}

}  // namespace

std::string path_svg(std::span<const spec::Event<double>> events, const spec::Axes& axes, const PathOptions& options) {
  const std::vector<Layer> layers = make_layers(events, axes, options);
  std::vector<const View*> views{&kTop, &kSide};
  if (is_solid(layers)) views.push_back(&kCorner);
  const double width = kPanel * static_cast<double>(views.size()) + 10 * static_cast<double>(views.size() - 1);
  const double height = kPanel + kHeader;
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "role=\"img\" "
      "aria-label=\"programmed and compensated path\">\n",
      width, height);
  out += kStyle;
  out += legend(layers, width);
  double left = 0;
  for (const View* view : views) {
    out += Panel(*view, layers, options.unit).draw(left, layers, events, options);
    left += kPanel + 10;
  }
  return out + "</svg>\n";
}

PathOptions path_options(const spec::Setup& setup) {
  PathOptions options;
  options.start = start_of(setup);
  options.unit = setup.units == spec::Units::mm ? "mm" : "inch";
  return options;
}

}  // namespace toolcomp::certify

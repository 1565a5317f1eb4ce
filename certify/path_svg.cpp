// SPDX-License-Identifier: Apache-2.0
#include "certify/path_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <ranges>
#include <string_view>
#include <utility>
#include <vector>

#include "certify/contact_svg.h"
#include "certify/label_places.h"
#include "certify/markup.h"
#include "certify/path_detail.h"
#include "certify/path_view.h"
#include "judge/oracle/number.h"
#include "judge/oracle/program_facts.h"

namespace toolcomp::certify {
namespace {

constexpr double kPanel = 320;       // width and height of a panel
constexpr double kSolidPanel = 480;  // of a path that leaves a plane
constexpr double kGap = 10;          // between panels
constexpr double kMargin = 34;       // around the drawing in a panel
constexpr double kHeader = 48;       // legend above the panels
constexpr std::size_t kMostLabels = 40;
constexpr std::size_t kMostLabelsOfALongOne = 10;
// Long programs: what lies closer together on the paper is not drawn.
constexpr std::size_t kLong = 500;    // moves
constexpr double kThinnest = 0.5;     // from point to point of a course
constexpr double kBetweenEnds = 50;   // from dot to dot
constexpr double kBetweenTools = 22;  // from tool stroke to tool stroke
constexpr double kLabel = 9;          // height of a label
constexpr double kStroke = 0.08;      // length of a tool stroke, of the path's

constexpr std::size_t kMostContacts = 6;

struct Layer {
  Path path;
  std::string style;  // CSS class
  std::string name;
};

constexpr double kCos30 = 0.8660254037844386;
constexpr View kTop{"top", "X", "Y", {1, 0, 0}, {0, 1, 0}};
constexpr View kSide{"side", "X", "Z", {1, 0, 0}, {0, 0, 1}};
constexpr View kCorner{"axonometric", "", "", {kCos30, -kCos30, 0}, {0.5, 0.5, 1}, true};

double distance(const Point2& a, const Point2& b) { return std::hypot(a.first - b.first, a.second - b.second); }

std::string label_of(const spec::Event<double>& event) {
  return event.n ? fmt::format("N{}", *event.n) : fmt::format("{}", event.line);
}

std::string coordinates(const Point3& p) {
  return fmt::format("X{} Y{} Z{}", plain(p[0], 6), plain(p[1], 6), plain(p[2], 6));
}

// One panel of the picture.
class Panel {
 public:
  Panel(const View& view, const std::vector<Layer>& layers, const spec::Axes& axes, std::string_view unit, double side)
      : view_(view), axes_(axes), unit_(unit), side_(side) {
    Box box;
    for (const Layer& layer : layers) {
      box.add(project(view, layer.path.start));
      for (const PathMove& move : layer.path.moves)
        for (const Point3& p : move.points) box.add(project(view, p));
    }
    size_ = std::max({box.right - box.left, box.top - box.bottom});
    // A path that is one point still gets a paper.
    if (!(size_ > 0)) size_ = 1;
    scale_ = (side_ - 2 * kMargin) / size_;
    middle_ = {(box.left + box.right) / 2, (box.bottom + box.top) / 2};
  }

  [[nodiscard]] std::string draw(double left, double top, const std::vector<Layer>& layers,
                                 std::span<const spec::Event<double>> events, const PathOptions& options) const {
    std::string out = fmt::format("<g transform=\"translate({:.1f} {:.1f})\">\n", left, top);
    out += fmt::format("<rect class=\"tp-paper\" width=\"{0}\" height=\"{0}\"/>\n", side_);
    out += grid();
    for (const Layer& layer : layers) out += course(layer);
    if (view_.solid) out += tools(layers, events, options.start);
    out += ends(layers.front(), events);
    if (options.marked && *options.marked < events.size()) out += mark(layers, events, *options.marked);
    return out + "</g>\n";
  }

 private:
  [[nodiscard]] Point2 place(const Point3& p) const {
    const Point2 q = project(view_, p);
    return {side_ / 2 + (q.first - middle_.first) * scale_, side_ / 2 - (q.second - middle_.second) * scale_};
  }

  [[nodiscard]] std::string grid() const {
    const double step = grid_step(side_ / scale_);
    const std::string lines = view_.solid ? "" : grid_lines(middle_, step, scale_, side_);
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
      const double y = side_ - (view_.solid ? 24 : 12);
      out += fmt::format(R"(<path class="tp-cross" d="M{} {}l{:.1f} {:.1f}"/>)", x, y, dx, dy);
      out += fmt::format("<text class=\"tp-note\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x + dx * 1.25 - 3,
                         y + dy * 1.25 + 4, names[i]);
    }
    return out;
  }

  [[nodiscard]] std::string course(const Layer& layer) const {
    std::string rapid;
    std::string feed;
    Point2 drawn = place(layer.path.start);
    Point2 at = drawn;
    const std::string* last = nullptr;  // the course that goes on
    const bool is_long = layer.path.moves.size() > kLong;
    for (const PathMove& move : layer.path.moves) {
      std::string& d = move.rapid ? rapid : feed;
      if (last != &d) d += fmt::format("M{:.2f} {:.2f}", at.first, at.second);
      if (last != &d) drawn = at;
      last = &d;
      for (const Point3& p : move.points) {
        at = place(p);
        if (is_long && &move != &layer.path.moves.back() && distance(at, drawn) < kThinnest) continue;
        d += fmt::format("L{:.2f} {:.2f}", at.first, at.second);
        drawn = at;
      }
    }
    std::string out;
    if (!rapid.empty()) out += fmt::format("<path class=\"tp-path tp-rapid {}\" d=\"{}\"/>\n", layer.style, rapid);
    if (!feed.empty()) out += fmt::format("<path class=\"tp-path {}\" d=\"{}\"/>\n", layer.style, feed);
    return out;
  }

  // Strokes from the tool point towards the holder and, where it is another, from the programmed point to it. Inside a
  // move its samples show how the tool gets from one end to the other: their strokes are thin, and a line joins their
  // heads.
  [[nodiscard]] std::string tools(const std::vector<Layer>& layers, std::span<const spec::Event<double>> events,
                                  const Point3& start) const {
    std::string strokes;
    std::string thin;
    std::string heads;
    std::string vectors;
    const auto layer = std::ranges::find(layers, "tp-point", &Layer::style);
    auto programmed = layers.front().path.moves.begin();
    const auto end = layers.front().path.moves.end();
    const std::vector<ToolStroke> tools = tool_strokes(axes_, start, events);
    const bool is_long = tools.size() > kLong;
    const bool sampled = std::ranges::any_of(tools, &ToolStroke::sample);
    Point2 last{-1e9, -1e9};
    for (const ToolStroke& tool : tools) {
      const Point2 a = place(tool.tip);
      const Point2 b = place(plus(tool.tip, size_ * kStroke, tool.axis));
      if (!std::isfinite(b.first) || !std::isfinite(b.second)) continue;
      if (sampled) heads += fmt::format("{}{:.2f} {:.2f}", heads.empty() ? 'M' : 'L', b.first, b.second);
      if (is_long && (tool.rapid || distance(a, last) < kBetweenTools)) continue;
      (tool.sample ? thin : strokes) +=
          fmt::format("M{:.2f} {:.2f}L{:.2f} {:.2f}", a.first, a.second, b.first, b.second);
      last = a;
      while (programmed != end && programmed->event < tool.event) ++programmed;
      if (layer == layers.end() || programmed == end || programmed->event != tool.event) continue;
      const Point2 p = place(programmed->points.back());
      vectors += fmt::format("M{:.2f} {:.2f}L{:.2f} {:.2f}", p.first, p.second, a.first, a.second);
    }
    std::string out;
    if (!heads.empty()) out += fmt::format("<path class=\"tp-tool tp-thin\" d=\"{}\"/>\n", heads);
    if (!thin.empty()) out += fmt::format("<path class=\"tp-tool tp-thin\" d=\"{}\"/>\n", thin);
    if (!strokes.empty()) out += fmt::format("<path class=\"tp-tool\" d=\"{}\"/>\n", strokes);
    if (!vectors.empty()) out += fmt::format("<path class=\"tp-vector\" d=\"{}\"/>\n", vectors);
    return out;
  }

  // A dot, a tooltip and, where there is room, a label where each programmed move ends; before them the alarms, each
  // where the path stands when it is raised.
  [[nodiscard]] std::string ends(const Layer& layer, std::span<const spec::Event<double>> events) const {
    LabelPlaces places(side_, kLabel);
    for (const double corner : {0.0, side_}) places.keep_free({0, corner}, 2 * kLabel);  // title and axes
    std::string out = alarms(layer, events, places);
    Point2 dot{-1e9, -1e9};
    const bool is_long = layer.path.moves.size() > kLong;
    std::size_t labels = is_long ? kMostLabels - kMostLabelsOfALongOne : 0;
    for (const PathMove& move : layer.path.moves) {
      const Point2 p = place(move.points.back());
      if (is_long && distance(p, dot) < kBetweenEnds) continue;
      dot = p;
      const std::string label = label_of(events[move.event]);
      out += fmt::format(R"(<circle class="tp-end" cx="{:.2f}" cy="{:.2f}" r="2"><title>{} {}</title></circle>)",
                         p.first, p.second, escape(label), coordinates(move.points.back()));
      if (labels < kMostLabels)
        if (const auto at = places.beside(p, label.size(), 2)) {
          out += fmt::format(R"(<text class="tp-label" x="{:.2f}" y="{:.2f}">{}</text>)", at->first, at->second,
                             escape(label));
          ++labels;
        }
      out += '\n';
    }
    return out;
  }

  [[nodiscard]] std::string alarms(const Layer& layer, std::span<const spec::Event<double>> events,
                                   LabelPlaces& places) const {
    std::string out;
    for (std::size_t i = 0; i < events.size(); ++i) {
      if (!spec::ends_run(events[i].kind)) continue;
      const auto next = std::ranges::lower_bound(layer.path.moves, i, {}, &PathMove::event);
      const Point2 p = place(next == layer.path.moves.begin() ? layer.path.start : std::prev(next)->points.back());
      places.keep_free(p, 5);
      const std::string_view number = events[i].number.view();
      out += fmt::format(R"(<path class="tp-alarm" d="M{:.2f} {:.2f}l8 8m0 -8l-8 8"><title>{}: {} {}</title></path>)",
                         p.first - 4, p.second - 4, label_of(events[i]), escape(number), escape(events[i].message));
      if (const auto at = places.beside(p, number.size(), 5))
        out += fmt::format(R"(<text class="tp-label tp-alarm-name" x="{:.2f}" y="{:.2f}">{}</text>)", at->first,
                           at->second, escape(number));
      out += '\n';
    }
    return out;
  }

  // At the end of a move; of a sample, where the tool stands.
  [[nodiscard]] std::string mark(const std::vector<Layer>& layers, std::span<const spec::Event<double>> events,
                                 std::size_t event) const {
    const auto circle = [this](const Point3& at) {
      const Point2 p = place(at);
      return fmt::format("<circle class=\"tp-mark\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"8\"/>\n", p.first, p.second);
    };
    if (events[event].kind == spec::EventKind::sample)
      for (const ToolStroke& tool : tool_strokes(axes_, layers.front().path.start, events))
        if (tool.event == event) return circle(tool.tip);
    for (const Layer& layer : std::views::reverse(layers)) {
      if (layer.style == "tp-other") continue;
      for (const PathMove& move : layer.path.moves)
        if (move.event == event) return circle(move.points.back());
    }
    return {};
  }

  const View& view_;
  const spec::Axes& axes_;
  std::string_view unit_;
  double side_;
  double size_ = 1;
  double scale_ = 1;
  Point2 middle_;
};

constexpr std::string_view kStyle = R"(<style>
.tp-paper{fill:#fff;stroke:#ccd2d9}.tp-grid{stroke:#edf0f3;fill:none}.tp-cross{stroke:#6b7580;fill:none}
.tp-note,.tp-label,.tp-legend{font:11px system-ui,sans-serif;fill:#57606a}.tp-label{font-size:9px}
.tp-path{fill:none;stroke-width:1.6;stroke-linejoin:round}.tp-rapid{stroke-dasharray:5 3}
.tp-programmed{stroke:#8b949e;stroke-width:3}.tp-nominal{stroke-width:1.6;stroke-dasharray:6 3}.tp-wall{fill:#edf0f3;stroke:#57606a}.tp-point{stroke:#0969da}.tp-axes{stroke:#1a7f37}.tp-other{stroke:#cf222e;stroke-dasharray:2 2}
.tp-tool{stroke:#9a6700;fill:none}.tp-thin{stroke-width:.6}.tp-vector,.tp-round{stroke:#bf3989;fill:none}.tp-round{stroke-dasharray:4 3}.tp-end{fill:#57606a}.tp-mark,.tp-alarm{fill:none;stroke:#cf222e;stroke-width:2}.tp-alarm-name{fill:#cf222e}
@media(prefers-color-scheme:dark){.tp-paper{fill:#0d1117;stroke:#30363d}.tp-wall{fill:#1b2129;stroke:#9aa4af}.tp-grid{stroke:#1b2129}.tp-cross{stroke:#8b949e}
.tp-note,.tp-label,.tp-legend{fill:#9aa4af}.tp-point{stroke:#58a6ff}.tp-axes{stroke:#3fb950}.tp-other{stroke:#ff7b72}
.tp-tool{stroke:#d29922}.tp-vector,.tp-round{stroke:#f778ba}.tp-end{fill:#9aa4af}.tp-mark,.tp-alarm{stroke:#ff7b72}.tp-alarm-name{fill:#ff7b72}}
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

// Whether any move says where the tool points, and away from Z.
bool is_tilted(std::span<const spec::Event<double>> events) {
  return std::ranges::any_of(events, [](const spec::Event<double>& event) {
    return event.tool_axis && ((*event.tool_axis)[0] != 0 || (*event.tool_axis)[1] != 0);
  });
}

// The tool of the table in the unit of the events.
std::optional<CutterShape> tool_of(const PathOptions& options) {
  constexpr double kInch = 25.4;  // mm
  if (!options.tool || options.unit != "inch") return options.tool;
  return CutterShape{options.tool->flat / kInch, options.tool->corner / kInch};
}

std::string legend(const std::vector<Layer>& layers, bool tools, double width) {
  std::vector<std::pair<std::string, std::string>> entries;  // class, name
  entries.reserve(layers.size() + 2);
  for (const Layer& layer : layers) entries.emplace_back("tp-path " + layer.style, layer.name);
  if (tools) {
    entries.emplace_back("tp-tool", "tool axis");
    if (std::ranges::find(layers, "tp-point", &Layer::style) != layers.end())
      entries.emplace_back("tp-vector", "compensation vector");
  }
  std::string out;
  double x = 6;
  double y = 16;
  for (const auto& [style, name] : entries) {
    const double needed = 44 + 7 * static_cast<double>(name.size());
    if (x + needed > width && x > 6) {
      x = 6;
      y += 18;
    }
    out += fmt::format(
        "<path class=\"{}\" d=\"M{:.1f} {:.1f}h22\"/><text class=\"tp-legend\" x=\"{:.1f}\" "
        "y=\"{:.1f}\">{}</text>\n",
        style, x, y, x + 28, y + 4, escape(name));
    x += needed;
  }
  return out;
}

}  // namespace

std::string path_svg(std::span<const spec::Event<double>> events, const spec::Axes& axes, const PathOptions& options) {
  const std::vector<Layer> layers = make_layers(events, axes, options);
  const bool tilted = is_tilted(events);
  const bool solid = is_solid(layers) || tilted;
  std::vector<const View*> views{&kTop, &kSide};
  if (solid) views.push_back(&kCorner);
  const auto point = std::ranges::find(layers, "tp-point", &Layer::style);
  std::optional<Detail> detail;
  if (tilted && point != layers.end()) detail = detail_of(events, layers.front().path, point->path, options.marked);

  // Two panels a row.
  const double side = solid ? kSolidPanel : kPanel;
  const std::vector<ContactPicture> contacts =
      contact_pictures(axes, events, tool_of(options), kMostContacts, options.marked);
  const std::size_t panels = views.size() + (detail ? 1 : 0) + contacts.size();
  const double width = 2 * side + kGap;
  const std::size_t rows = (panels + 1) / 2;
  const double height = kHeader + static_cast<double>(rows) * (side + kGap) - kGap;
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "role=\"img\" "
      "aria-label=\"programmed and compensated path\">\n",
      width, height);
  out += kStyle;
  out += legend(layers, tilted, width);
  const auto left = [&](std::size_t i) { return static_cast<double>(i % 2) * (side + kGap); };
  const auto top = [&](std::size_t i) {
    const std::size_t row = i / 2;
    return kHeader + static_cast<double>(row) * (side + kGap);
  };
  for (std::size_t i = 0; i < views.size(); ++i)
    out += Panel(*views[i], layers, axes, options.unit, side).draw(left(i), top(i), layers, events, options);
  if (detail)
    out += detail_svg(*detail, layers.front().path, point->path, left(views.size()), top(views.size()), side,
                      label_of(events[detail->event]), options.unit);
  std::size_t next = views.size() + (detail ? 1 : 0);
  for (const ContactPicture& contact : contacts) {
    out += contact_svg(contact, left(next), top(next), side, label_of(events[contact.event]), options.unit);
    ++next;
  }
  return out + "</svg>\n";
}

PathOptions path_options(const spec::Setup& setup) {
  PathOptions options;
  options.start = start_of(setup);
  options.unit = setup.units == spec::Units::mm ? "mm" : "inch";
  if (!setup.tools.empty()) {
    const double corner = judge::approximate(setup.tools.front().r2);
    options.tool = {judge::approximate(setup.tools.front().r) - corner, corner};
  }
  return options;
}

PathOptions path_options(const spec::Case& c) {
  PathOptions options = path_options(c.setup);
  options.unit = judge::ProgramFacts::of(c).units().value_or(c.setup.units) == spec::Units::mm ? "mm" : "inch";
  return options;
}

}  // namespace toolcomp::certify

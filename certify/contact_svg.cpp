// SPDX-License-Identifier: Apache-2.0
#include "certify/contact_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "certify/markup.h"
#include "certify/path_view.h"

namespace toolcomp::certify {
namespace {

// Below this 1 - n.t the tool stands along the normal, as far as the shapes are concerned.
constexpr double kAlong = 1.0 / 1'000'000'000;
constexpr double kWidth = 1.5;     // of the picture, in tool radii to either side
constexpr double kAboveTip = 2.2;  // how high the tool is drawn, in picture half widths
constexpr double kArrow = 46;      // length of the vectors on the paper

double length(const Point3& v) { return std::sqrt(dot(v, v)); }

Point3 place_of(const spec::Axes& axes, const spec::AxisValues<double>& values) {
  Point3 p{};
  for (std::size_t i = 0; i < p.size(); ++i)
    if (const std::size_t axis = axes.index("XYZ"[i]); axis != spec::Axes::kNone && values.has(axis))
      p[i] = values[axis];
  return p;
}

// Any direction at right angles to v.
Point3 aside(const Point3& v) {
  const Point3 other = std::fabs(v[0]) < 0.5 ? Point3{1, 0, 0} : Point3{0, 1, 0};
  const Point3 across = plus(other, -dot(other, v), v);
  return plus({}, 1 / length(across), across);
}

std::optional<ContactPicture> picture_of(const spec::Axes& axes, const spec::Event<double>& event, std::size_t index,
                                         const std::optional<CutterShape>& known) {
  if (event.kind != spec::EventKind::move || !event.space || !event.space->contact || !event.tool_axis)
    return std::nullopt;
  const spec::SpaceCompensation<double>& space = *event.space;
  ContactPicture p;
  p.event = index;
  p.contact = space.contact->point;
  p.normal = space.contact->normal;
  p.tool = *event.tool_axis;
  p.programmed = place_of(axes, event.programmed);
  p.effective_tip = place_of(axes, event.point);
  p.nominal_tip = plus(p.effective_tip, -1, space.shift);
  const Point3 stretch = plus(space.tool_shift, -1, space.shift);
  p.lengthened = length(stretch) > 0;
  p.table_tip = plus(p.effective_tip, 1, stretch);
  const double c = dot(p.normal, p.tool);
  const Point3 lateral = plus(p.normal, -c, p.tool);
  const double s = length(lateral);
  p.across = space.contact->flat || !(s > 0) ? aside(p.tool) : plus({}, 1 / s, lateral);
  p.effective.corner = dot(plus(space.tool_center, -1, p.effective_tip), p.tool);
  if (space.contact->flat || 1 - c < kAlong) {
    p.nominal = known.value_or(CutterShape{0, p.effective.corner});
    p.effective.flat = std::max(0.0, p.nominal.flat);
  } else {
    // tip - q = R2 n + rho u - R2 t, along the tool and across it.
    const Point3 up = plus(p.nominal_tip, -1, p.contact);
    p.nominal.corner = -dot(up, p.tool) / (1 - c);
    p.nominal.flat = dot(up, p.across) - p.nominal.corner * s;
    p.effective.flat = dot(plus(p.effective_tip, -1, p.contact), p.across) - p.effective.corner * s;
  }
  const auto finite = [](const Point3& v) { return std::ranges::all_of(v, [](double x) { return std::isfinite(x); }); };
  const bool drawable = finite(p.contact) && finite(p.across) && finite(p.effective_tip) && finite(p.nominal_tip) &&
                        p.nominal.flat + p.nominal.corner > 0;
  return drawable ? std::optional(p) : std::nullopt;
}

// Whether the two would be the same picture.
bool alike(const ContactPicture& a, const ContactPicture& b) {
  constexpr double kSame = 1.0 / 1000;  // of the radius; of unit vectors
  const double size = kSame * std::max(a.nominal.flat + a.nominal.corner, b.nominal.flat + b.nominal.corner);
  const auto near = [](double x, double y, double by) { return std::fabs(x - y) <= by; };
  const Point3 shift_a = plus(a.effective_tip, -1, a.nominal_tip);
  const Point3 shift_b = plus(b.effective_tip, -1, b.nominal_tip);
  return near(dot(a.normal, a.tool), dot(b.normal, b.tool), kSame) && near(a.nominal.corner, b.nominal.corner, size) &&
         near(a.nominal.flat, b.nominal.flat, size) &&
         near(dot(shift_a, a.across), dot(shift_b, b.across), size / 10) &&
         near(dot(shift_a, a.tool), dot(shift_b, b.tool), size / 10) &&
         near(dot(plus(a.programmed, -1, a.nominal_tip), a.tool), dot(plus(b.programmed, -1, b.nominal_tip), b.tool),
              size);
}

class Panel {
 public:
  Panel(const ContactPicture& picture, double side) : picture_(picture), side_(side) {
    const double radius =
        std::max(picture.nominal.flat + picture.nominal.corner, picture.effective.flat + picture.effective.corner);
    half_ = kWidth * radius;
    scale_ = side / (2 * half_);
    middle_ = plus(picture.nominal_tip, half_ / 2, picture.tool);
  }

  [[nodiscard]] Point2 at(const Point3& p) const {
    const Point3 v = plus(p, -1, middle_);
    return {side_ / 2 + dot(v, picture_.across) * scale_, side_ / 2 - dot(v, picture_.tool) * scale_};
  }

  // The half plane of the workpiece.
  [[nodiscard]] std::string wall() const {
    const Point3 along = plus(plus({}, dot(picture_.normal, picture_.tool), picture_.across),
                              -dot(picture_.normal, picture_.across), picture_.tool);
    const double far = 8 * half_;
    const Point3 a = plus(picture_.contact, far, along);
    const Point3 b = plus(picture_.contact, -far, along);
    std::string d;
    for (const Point3& p : {a, b, plus(b, -far, picture_.normal), plus(a, -far, picture_.normal)}) {
      const Point2 q = at(p);
      d += fmt::format("{}{:.2f} {:.2f}", d.empty() ? 'M' : 'L', q.first, q.second);
    }
    return fmt::format("<path class=\"tp-wall\" d=\"{}Z\"/>\n", d);
  }

  // The outline of a cutter whose tip is there.
  [[nodiscard]] std::string outline(const Point3& tip, const CutterShape& shape, std::string_view style) const {
    const double radius = shape.flat + shape.corner;
    const double top = kAboveTip * half_;
    const double r = shape.corner * scale_;
    const auto point = [&](double x, double y) {
      const Point2 q = at(plus(plus(tip, x, picture_.across), y, picture_.tool));
      return fmt::format("{:.2f} {:.2f}", q.first, q.second);
    };
    const std::string d = fmt::format("M{}L{}A{:.2f} {:.2f} 0 0 0 {}L{}A{:.2f} {:.2f} 0 0 0 {}L{}", point(-radius, top),
                                      point(-radius, shape.corner), r, r, point(-shape.flat, 0), point(shape.flat, 0),
                                      r, r, point(radius, shape.corner), point(radius, top));
    return fmt::format("<path class=\"tp-path {}\" d=\"{}\"/>\n", style, d);
  }

  [[nodiscard]] std::string arrow(const Point3& from, const Point3& direction, std::string_view name) const {
    const Point2 a = at(from);
    const double x = dot(direction, picture_.across) * kArrow;
    const double y = -dot(direction, picture_.tool) * kArrow;
    return fmt::format(
        "<path class=\"tp-vector\" d=\"M{0:.2f} {1:.2f}l{2:.2f} {3:.2f}m{4:.2f} {5:.2f}l{6:.2f} {7:.2f}l{8:.2f} "
        "{9:.2f}\"/><text class=\"tp-label\" x=\"{10:.2f}\" y=\"{11:.2f}\">{12}</text>\n",
        a.first, a.second, x, y, (-x - y) / 8, (x - y) / 8, (x + y) / 8, (y - x) / 8, (-x + y) / 8, (-x - y) / 8,
        a.first + 1.15 * x, a.second + 1.15 * y, name);
  }

  [[nodiscard]] std::string dot_at(const Point3& p, std::string_view name, double dx, double dy) const {
    const Point2 q = at(p);
    return fmt::format(
        "<circle class=\"tp-end\" cx=\"{0:.2f}\" cy=\"{1:.2f}\" r=\"2.5\"/><text class=\"tp-label\" x=\"{2:.2f}\" "
        "y=\"{3:.2f}\">{4}</text>\n",
        q.first, q.second, q.first + dx, q.second + dy, name);
  }

  // A cross: where it lies in the plane or before it is not asked.
  [[nodiscard]] std::string cross_at(const Point3& p, std::string_view name) const {
    const Point2 q = at(p);
    return fmt::format(
        "<path class=\"tp-cross\" d=\"M{0:.2f} {1:.2f}m-5 -5l10 10m0 -10l-10 10\"/><text class=\"tp-label\" "
        "x=\"{2:.2f}\" y=\"{3:.2f}\">{4}</text>\n",
        q.first, q.second, q.first - 70, q.second + 18, name);
  }

 private:
  const ContactPicture& picture_;
  double side_;
  double half_ = 1;
  double scale_ = 1;
  Point3 middle_{};
};

std::string shape_text(const CutterShape& shape) {
  return fmt::format("R {} R2 {}", plain(shape.flat + shape.corner, 6), plain(shape.corner, 6));
}

}  // namespace

std::vector<ContactPicture> contact_pictures(const spec::Axes& axes, std::span<const spec::Event<double>> events,
                                             const std::optional<CutterShape>& table, std::size_t most,
                                             std::optional<std::size_t> marked) {
  std::vector<ContactPicture> pictures;
  std::optional<CutterShape> known = table;
  const auto take = [&](std::size_t i) {
    auto picture = picture_of(axes, events[i], i, known);
    if (!picture) return;
    known = picture->nominal;
    if (std::ranges::none_of(pictures, [&](const ContactPicture& p) { return alike(p, *picture); }))
      pictures.push_back(*picture);
  };
  if (marked && *marked < events.size()) take(*marked);
  for (std::size_t i = 0; i < events.size() && pictures.size() < most; ++i) take(i);
  std::ranges::sort(pictures, {}, &ContactPicture::event);
  return pictures;
}

std::string contact_svg(const ContactPicture& picture, double left, double top, double side, std::string_view label,
                        std::string_view unit) {
  const Panel panel(picture, side);
  std::string out =
      fmt::format("<svg x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\">\n", left, top, side, side);
  out += fmt::format("<rect class=\"tp-paper\" width=\"{0}\" height=\"{0}\"/>\n", side);
  out += panel.wall();
  out += panel.outline(picture.nominal_tip, picture.nominal, "tp-programmed tp-nominal");
  if (picture.lengthened) out += panel.outline(picture.table_tip, picture.nominal, "tp-axes tp-thin");
  out += panel.outline(picture.effective_tip, picture.effective, "tp-point");
  out += panel.arrow(picture.contact, picture.normal, "N");
  out += panel.arrow(plus(picture.effective_tip, picture.effective.corner, picture.tool), picture.tool, "T");
  out += panel.dot_at(plus(picture.nominal_tip, picture.nominal.corner, picture.tool), "", 0, 0);
  out += panel.dot_at(plus(picture.effective_tip, picture.effective.corner, picture.tool), "centre", 7, -4);
  out += panel.dot_at(picture.contact, "contact", 7, 12);
  out += panel.dot_at(picture.effective_tip, "tip", 7, 12);
  out += panel.cross_at(picture.programmed, "programmed");
  out += fmt::format("<text class=\"tp-note\" x=\"6\" y=\"14\">contact at {}, cut by the plane of N and T</text>\n",
                     escape(label));
  out += fmt::format("<text class=\"tp-note\" x=\"6\" y=\"30\">nominal (grey) {}, effective (blue) {} {}</text>\n",
                     shape_text(picture.nominal), shape_text(picture.effective), unit);
  const Point3 shift = plus(picture.effective_tip, -1, picture.nominal_tip);
  const auto note = [&](double y, const std::string& text) {
    out += fmt::format("<text class=\"tp-note\" x=\"6\" y=\"{:.0f}\">{}</text>\n", y, text);
  };
  if (picture.lengthened)
    note(side - 24, fmt::format("a tool as in the table (green) stays {} away from the wall",
                                plain(dot(plus(picture.table_tip, -1, picture.nominal_tip), picture.normal), 6)));
  note(side - 8, fmt::format("tip moved by {} along N, {} in all", plain(dot(shift, picture.normal), 6),
                             plain(length(shift), 6)));
  return out + "</svg>\n";
}

}  // namespace toolcomp::certify

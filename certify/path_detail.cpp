// SPDX-License-Identifier: Apache-2.0
#include "certify/path_detail.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "certify/markup.h"
#include "certify/path_view.h"

namespace toolcomp::certify {
namespace {

constexpr double kAround = 3;  // tool radii from the middle of the picture to its edges
constexpr std::size_t kMostDots = 60;

double length(const Point3& v) { return std::sqrt(dot(v, v)); }

// The place at the end of a move, if it is one that can be shown.
std::optional<Detail> place(const spec::Event<double>& event, const Point3& from, const PathMove& programmed,
                            const PathMove& point) {
  if (programmed.rapid || !event.tool_axis || event.cause != spec::Cause::programmed) return std::nullopt;
  Detail d;
  d.event = programmed.event;
  d.programmed = programmed.points.back();
  d.point = point.points.back();
  d.along = *event.tool_axis;
  const Point3 before = programmed.points.size() > 1 ? programmed.points[programmed.points.size() - 2] : from;
  const Point3 travel = plus(d.programmed, -1, before);
  const Point3 across = plus(travel, -dot(travel, d.along), d.along);
  const Point3 vector = plus(d.point, -1, d.programmed);
  if (!(length(across) > 0) || !(length(vector) > 0)) return std::nullopt;
  d.travel = plus({}, 1 / length(across), across);
  d.distance = length(plus(vector, -dot(vector, d.travel), d.travel));
  // A vector that lies along the travel, as at the leading edge, has no line beside it.
  if (!(d.distance > length(vector) / 5)) return std::nullopt;
  return d;
}

// Consecutive moves around the place: first and one past the last.
struct Range {
  std::size_t first = 0;
  std::size_t end = 0;
};

class DetailPicture {
 public:
  DetailPicture(const Detail& detail, double side)
      : detail_(detail),
        left_(cross(detail.along, detail.travel)),
        side_(side),
        scale_(side / (2 * kAround * detail.distance)) {}

  [[nodiscard]] double scale() const { return scale_; }

  [[nodiscard]] Point2 at(const Point3& p) const {
    const Point3 v = plus(p, -1, detail_.programmed);
    return {side_ / 2 + dot(v, detail_.travel) * scale_, side_ / 2 - dot(v, left_) * scale_};
  }

  // The moves of the pass that the place lies on, as far as they are near.
  [[nodiscard]] Range near(const Path& path) const {
    const std::vector<PathMove>& moves = path.moves;
    std::size_t at = 0;
    while (at < moves.size() && moves[at].event < detail_.event) ++at;
    Range range{at, at};
    while (range.first > 0 && is_near(moves[range.first - 1])) --range.first;
    while (range.end < moves.size() && is_near(moves[range.end])) ++range.end;
    // The move that leaves the picture belongs to it.
    if (range.end < moves.size() && !moves[range.end].rapid) ++range.end;
    return range;
  }

  [[nodiscard]] std::string course(const Path& path, std::string_view style) const {
    const Range range = near(path);
    if (range.first == range.end) return {};
    Point2 p = at(range.first == 0 ? path.start : path.moves[range.first - 1].points.back());
    std::string d = fmt::format("M{:.2f} {:.2f}", p.first, p.second);
    std::string dots;
    for (std::size_t i = range.first; i < range.end; ++i) {
      for (const Point3& q : path.moves[i].points) {
        p = at(q);
        d += fmt::format("L{:.2f} {:.2f}", p.first, p.second);
      }
      if (range.end - range.first <= kMostDots)
        dots += fmt::format(R"(<circle class="tp-end" cx="{:.2f}" cy="{:.2f}" r="2"/>)", p.first, p.second);
    }
    return fmt::format("<path class=\"tp-path {}\" d=\"{}\"/>\n{}", style, d, dots);
  }

 private:
  [[nodiscard]] bool is_near(const PathMove& move) const {
    if (move.rapid) return false;
    const Point3 v = plus(move.points.back(), -1, detail_.programmed);
    return length(v) < 2 * kAround * detail_.distance;
  }

  const Detail& detail_;
  Point3 left_;
  double side_;
  double scale_;
};

}  // namespace

std::optional<Detail> detail_of(std::span<const spec::Event<double>> events, const Path& programmed, const Path& point,
                                std::optional<std::size_t> marked) {
  std::vector<Detail> places;
  std::size_t other = 0;
  Point3 from = programmed.start;
  for (const PathMove& move : programmed.moves) {
    while (other < point.moves.size() && point.moves[other].event < move.event) ++other;
    if (other < point.moves.size() && point.moves[other].event == move.event)
      if (const auto found = place(events[move.event], from, move, point.moves[other])) {
        if (marked && found->event == *marked) return found;
        places.push_back(*found);
      }
    from = move.points.back();
  }
  if (places.empty()) return std::nullopt;
  // The middle of the run that the middle one belongs to: away from start-up and cancel.
  const auto follows = [&](std::size_t i) { return places[i].event == places[i - 1].event + 1; };
  std::size_t first = places.size() / 2;
  std::size_t last = first;
  while (first > 0 && follows(first)) --first;
  while (last + 1 < places.size() && follows(last + 1)) ++last;
  return places[first + (last - first) / 2];
}

std::string detail_svg(const Detail& detail, const Path& programmed, const Path& point, double left, double top,
                       double side, std::string_view label, std::string_view unit) {
  const DetailPicture picture(detail, side);
  const double step = grid_step(side / picture.scale());
  const Point2 from = picture.at(detail.programmed);
  const Point2 to = picture.at(detail.point);
  // A drawing of its own: what lies outside is cut off.
  std::string out =
      fmt::format("<svg x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\">\n", left, top, side, side);
  out += fmt::format("<rect class=\"tp-paper\" width=\"{0}\" height=\"{0}\"/>\n", side);
  out += fmt::format("<path class=\"tp-grid\" d=\"{}\"/>\n", grid_lines({0, 0}, step, picture.scale(), side));
  out += picture.course(programmed, "tp-programmed");
  out += picture.course(point, "tp-point");
  out += fmt::format("<circle class=\"tp-round\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"/>\n", to.first, to.second,
                     detail.distance * picture.scale());
  out += fmt::format("<path class=\"tp-vector\" d=\"M{:.2f} {:.2f}L{:.2f} {:.2f}\"/>\n", from.first, from.second,
                     to.first, to.second);
  out += fmt::format("<text class=\"tp-note\" x=\"6\" y=\"14\">along the tool at {}, grid {} {}</text>\n",
                     escape(label), plain(step, 9), unit);
  out += fmt::format(
      "<text class=\"tp-note\" x=\"6\" y=\"{:.0f}\">travel to the right; distance of the lines {} {}</text>\n",
      side - 8, plain(detail.distance, 9), unit);
  return out + "</svg>\n";
}

}  // namespace toolcomp::certify

// SPDX-License-Identifier: Apache-2.0
#include "certify/label_places.h"

#include <algorithm>

namespace toolcomp::certify {

void LabelPlaces::keep_free(const Point2& middle, double radius) {
  taken_.push_back({middle.first - radius, middle.second - radius, middle.first + radius, middle.second + radius});
}

bool LabelPlaces::is_free(const Rectangle& r) const {
  if (r.left < 0 || r.top < 0 || r.right > side_ || r.bottom > side_) return false;
  return std::ranges::none_of(taken_, [&](const Rectangle& t) {
    return t.left < r.right && r.left < t.right && t.top < r.bottom && r.top < t.bottom;
  });
}

std::optional<Point2> LabelPlaces::beside(const Point2& mark, std::size_t characters, double radius) {
  constexpr double kWide = 0.62;  // of a character, of its height
  const double width = static_cast<double>(characters) * kWide * size_;
  const double right = mark.first + radius + 2;
  const double left = mark.first - radius - 2 - width;
  const double above = mark.second - radius - 2;
  const double below = mark.second + radius + 2 + size_;
  for (const Point2& at : {Point2{right, above}, {right, below}, {left, above}, {left, below}}) {
    const Rectangle box{at.first, at.second - size_, at.first + width, at.second + size_ / 4};
    if (!is_free(box)) continue;
    taken_.push_back(box);
    return at;
  }
  return std::nullopt;
}

}  // namespace toolcomp::certify

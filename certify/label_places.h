// SPDX-License-Identifier: Apache-2.0
// Finds places for the labels of a picture, so that no label covers another.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "certify/path_view.h"

namespace toolcomp::certify {

class LabelPlaces {
 public:
  // For a square paper of `side`, y downwards, and text of height `size`.
  LabelPlaces(double side, double size) : side_(side), size_(size) {}

  // A mark of this radius that no label may cover.
  void keep_free(const Point2& middle, double radius);
  // The beginning of the base line of a text with this number of characters, next to a mark of this radius;
  // std::nullopt if there is no room. The place is then taken.
  std::optional<Point2> beside(const Point2& mark, std::size_t characters, double radius);

 private:
  struct Rectangle {
    double left, top, right, bottom;
  };
  [[nodiscard]] bool is_free(const Rectangle& r) const;

  double side_;
  double size_;
  std::vector<Rectangle> taken_;
};

}  // namespace toolcomp::certify

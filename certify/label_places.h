// SPDX-License-Identifier: Apache-2.0
// Where labels of a picture can stand: none covers another.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "certify/path_view.h"

namespace toolcomp::certify {

class LabelPlaces {
 public:
  // On a square paper of `side`, y downwards, of text `size` high.
  LabelPlaces(double side, double size) : side_(side), size_(size) {}

  // What nothing may cover: a mark of that radius.
  void keep_free(const Point2& middle, double radius);
  // Where a text of so many characters begins (its base line), beside a mark of that radius; nothing if there is no
  // room. The place is then taken.
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

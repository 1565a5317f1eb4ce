// SPDX-License-Identifier: Apache-2.0
// The controlled axes of a setup and values keyed by them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace toolcomp::spec {

inline constexpr std::size_t kMaxAxes = 9;

// X Y Z U V W are linear axes (mm or inch), A B C are rotary axes (degrees).
constexpr bool is_linear_axis(char letter) { return letter >= 'U' && letter <= 'Z'; }
constexpr bool is_rotary_axis(char letter) { return letter >= 'A' && letter <= 'C'; }

// The controlled axes in the order of the setup: axis number n of a parameter is letter(n - 1).
class Axes {
 public:
  static constexpr std::size_t kNone = kMaxAxes;

  Axes() : Axes("XYZ") {}
  explicit Axes(std::string_view letters) : letters_(letters) {
    index_.fill(static_cast<std::uint8_t>(kNone));
    for (std::size_t i = 0; i < letters_.size(); ++i)
      index_[static_cast<unsigned char>(letters_[i])] = static_cast<std::uint8_t>(i);
  }

  [[nodiscard]] std::size_t size() const { return letters_.size(); }
  [[nodiscard]] char letter(std::size_t index) const { return letters_[index]; }
  // kNone if no axis has this letter.
  [[nodiscard]] std::size_t index(char letter) const { return index_[static_cast<unsigned char>(letter)]; }
  [[nodiscard]] bool has(char letter) const { return index(letter) != kNone; }
  [[nodiscard]] const std::string& letters() const { return letters_; }
  friend bool operator==(const Axes& a, const Axes& b) { return a.letters_ == b.letters_; }

 private:
  std::string letters_;
  std::array<std::uint8_t, 256> index_{};
};

// A number for each of some axes, by axis index.
template <class Number>
struct AxisValues {
  std::array<Number, kMaxAxes> value{};
  std::uint16_t present = 0;  // bit i: axis i has a value

  [[nodiscard]] bool has(std::size_t axis) const { return (present >> axis & 1U) != 0; }
  [[nodiscard]] bool empty() const { return present == 0; }
  void set(std::size_t axis, Number number) {
    value[axis] = std::move(number);
    present = static_cast<std::uint16_t>(present | 1U << axis);
  }
  void clear(std::size_t axis) { present = static_cast<std::uint16_t>(present & ~(1U << axis)); }
  [[nodiscard]] const Number& operator[](std::size_t axis) const { return value[axis]; }
};

}  // namespace toolcomp::spec

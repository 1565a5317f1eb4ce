// SPDX-License-Identifier: Apache-2.0
// Exact real numbers: rationals, and expressions over square roots, sines and cosines with certified signs.
#pragma once

#include <cstdint>
#include <exception>
#include <string>
#include <string_view>

#include "model/exact/rational.h"

namespace toolcomp::exact {

enum class Sign : std::int8_t { negative = -1, zero = 0, positive = 1 };
constexpr Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<int>(s)); }

// The sign could not be certified within the budget: not zero within the enclosure, and no proof of zero.
class Undecided : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override { return "sign undecided within the budget"; }
};

// Rational bounds: lower <= value <= upper.
struct Enclosure {
  Rational lower;
  Rational upper;
};
// The same, rounded outwards to double.
struct DoubleEnclosure {
  double lower = 0;
  double upper = 0;
};

struct Node;  // pooled, one thread

// A value. Cheap to copy (a counted reference into a pool of one thread; values do not cross threads).
class Real {
 public:
  Real();                       // 0
  Real(int value);              // NOLINT(google-explicit-constructor)
  Real(const Rational& value);  // NOLINT(google-explicit-constructor)
  Real(const Real&);
  Real(Real&&) noexcept;
  Real& operator=(const Real&);
  Real& operator=(Real&&) noexcept;
  ~Real();

  // Certified; throws Undecided.
  [[nodiscard]] Sign sign() const;
  // Rational as known without further proof.
  [[nodiscard]] bool is_rational() const;
  // Requires is_rational().
  [[nodiscard]] Rational rational() const;

  // Bounds of relative width about 2^-bits (exact for rationals, wider if undecided; Undecided if there are none).
  [[nodiscard]] Enclosure enclosure(int bits = 100) const;
  [[nodiscard]] DoubleEnclosure double_enclosure() const;
  // Available bounds: some ulps wide, and wider if much cancels. Their ends may be infinite.
  [[nodiscard]] DoubleEnclosure rough_enclosure() const;
  // Correctly rounded to `digits` decimals (half to even), trailing zeros removed, never "-0". Throws Undecided.
  [[nodiscard]] std::string decimal(int digits) const;

  friend Real operator-(const Real& a);
  friend Real operator+(const Real& a, const Real& b);
  friend Real operator-(const Real& a, const Real& b);
  friend Real operator*(const Real& a, const Real& b);
  friend Real operator/(const Real& a, const Real& b);  // std::domain_error if b is zero; its sign is certified
  Real& operator+=(const Real& b) { return *this = *this + b; }
  Real& operator-=(const Real& b) { return *this = *this - b; }
  Real& operator*=(const Real& b) { return *this = *this * b; }
  Real& operator/=(const Real& b) { return *this = *this / b; }

  friend Real sqrt(const Real& a);  // std::domain_error if a is negative; its sign is certified
  friend Real sin_degrees(const Rational& degrees);
  friend Real cos_degrees(const Rational& degrees);
  friend Real pi();

 private:
  explicit Real(Node* node) : node_(node) {}
  Node* node_;
  friend struct Node;
};

Real operator-(const Real& a);
Real operator+(const Real& a, const Real& b);
Real operator-(const Real& a, const Real& b);
Real operator*(const Real& a, const Real& b);
Real operator/(const Real& a, const Real& b);
Real sqrt(const Real& a);
Real sin_degrees(const Rational& degrees);
Real cos_degrees(const Rational& degrees);
// The angle of this tangent, in degrees between -90 and 90. A sum with it is proven to be zero only if that holds
// for any number in its place.
Real arctangent_degrees(const Real& tangent);
// Sine and cosine of any angle in degrees. For a rational angle, as above; for other angles, the same is true of zeros
// as for arc tangents.
Real sin_real_degrees(const Real& degrees);
Real cos_real_degrees(const Real& degrees);
// For values that depend on the length of an arc. Pi is transcendental, so every zero among algebraic numbers and pi is
// proven.
Real pi();
Real square(const Real& a);

// Zero as known without further proof.
inline bool known_zero(const Real& a) { return a.is_rational() && a.sign() == Sign::zero; }

inline Sign sign(const Real& a) { return a.sign(); }
inline Sign compare(const Real& a, const Real& b) { return (a - b).sign(); }
// Certified comparisons; they throw Undecided.
inline bool operator==(const Real& a, const Real& b) { return compare(a, b) == Sign::zero; }
inline bool operator<(const Real& a, const Real& b) { return compare(a, b) == Sign::negative; }
inline bool operator>(const Real& a, const Real& b) { return b < a; }
inline bool operator<=(const Real& a, const Real& b) { return !(b < a); }
inline bool operator>=(const Real& a, const Real& b) { return !(a < b); }

// The number of living nodes on this thread, for the test that limits it.
std::size_t live_nodes();

}  // namespace toolcomp::exact

// SPDX-License-Identifier: Apache-2.0
// Numbers with bounds of their value and of their first two derivatives by t.
#pragma once

#include <array>
#include <boost/numeric/interval.hpp>
#include <cstddef>
#include <limits>

namespace toolcomp::certify {

// Rounds outwards as long as an object of Rounding exists.
using ProtectedInterval = boost::numeric::interval<
    double, boost::numeric::interval_lib::policies<
                boost::numeric::interval_lib::save_state<boost::numeric::interval_lib::rounded_transc_opp<double>>,
                boost::numeric::interval_lib::checking_base<double>>>;
using Rounding = ProtectedInterval::traits_type::rounding;
using Interval = boost::numeric::interval_lib::unprotect<ProtectedInterval>::type;

// The library uses the functions of libm, which may be off by one ulp of a value of at most 1.
inline Interval of_libm(const Interval& x) {
  constexpr double ulps = 2 * std::numeric_limits<double>::epsilon();
  return x + Interval(-ulps, ulps);
}
inline Interval cosine(const Interval& radians) { return of_libm(boost::numeric::cos(radians)); }
inline Interval sine(const Interval& radians) { return of_libm(boost::numeric::sin(radians)); }

struct Jet {
  Interval value = 0;
  Interval rate = 0;
  Interval second = 0;

  Jet() = default;
  Jet(const Interval& constant) : value(constant) {}  // NOLINT(google-explicit-constructor): a constant is one
  Jet(const Interval& v, const Interval& r, const Interval& s) : value(v), rate(r), second(s) {}
};

inline Jet operator-(const Jet& a) { return {-a.value, -a.rate, -a.second}; }
inline Jet operator+(const Jet& a, const Jet& b) { return {a.value + b.value, a.rate + b.rate, a.second + b.second}; }
inline Jet operator-(const Jet& a, const Jet& b) { return {a.value - b.value, a.rate - b.rate, a.second - b.second}; }
inline Jet operator*(const Interval& k, const Jet& a) { return {k * a.value, k * a.rate, k * a.second}; }
inline Jet operator*(const Jet& a, const Jet& b) {
  return {a.value * b.value, a.rate * b.value + a.value * b.rate,
          a.second * b.value + 2.0 * a.rate * b.rate + a.value * b.second};
}
inline Jet square(const Jet& a) {
  return {boost::numeric::square(a.value), 2.0 * a.value * a.rate,
          2.0 * (boost::numeric::square(a.rate) + a.value * a.second)};
}
// 1 / a.
inline Jet inverse(const Jet& a) {
  const Interval r = 1.0 / a.value;
  const Interval r2 = boost::numeric::square(r);
  return {r, -a.rate * r2, (2.0 * boost::numeric::square(a.rate) * r - a.second) * r2};
}
// The root of a value that is not negative, though its bounds may be negative. From f = s²: f' = 2 s s', f" = 2 (s'² +
// s s").
inline Jet root(const Jet& a) {
  const Interval s = boost::numeric::sqrt(a.value);
  const Interval half = 0.5 / s;
  const Interval rate = a.rate * half;
  return {s, rate, (a.second - 2.0 * boost::numeric::square(rate)) * half};
}

// Cosine and sine of an angle.
struct Turned {
  Jet cosine{1.0};
  Jet sine;
};
// An angle in radians that begins at `start` and changes at a constant rate.
inline Turned turning(const Interval& t, const Interval& start, const Interval& rate) {
  const Interval angle = start + t * rate;
  const Interval c = cosine(angle);
  const Interval s = sine(angle);
  const Interval rate2 = boost::numeric::square(rate);
  return {{c, -s * rate, -c * rate2}, {s, c * rate, -s * rate2}};
}
// The sum of both angles.
inline Turned operator+(const Turned& a, const Turned& b) {
  return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
}
inline Turned operator-(const Turned& a) { return {a.cosine, -a.sine}; }
// The second derivative of the angle, radians: the derivative of c s' - s c'.
inline Interval second_of_angle(const Turned& a) {
  return a.cosine.value * a.sine.second - a.sine.value * a.cosine.second;
}

// X Y Z.
using IntervalVector = std::array<Interval, 3>;
using JetVector = std::array<Jet, 3>;

inline JetVector operator+(const JetVector& a, const JetVector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline JetVector operator-(const JetVector& a, const JetVector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline JetVector operator*(const Jet& k, const JetVector& a) { return {k * a[0], k * a[1], k * a[2]}; }
inline Jet dot(const JetVector& a, const JetVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline JetVector cross(const JetVector& a, const JetVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline JetVector constant(const IntervalVector& v) { return {Jet(v[0]), Jet(v[1]), Jet(v[2])}; }

}  // namespace toolcomp::certify

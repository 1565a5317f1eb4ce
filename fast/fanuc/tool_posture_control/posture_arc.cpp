// SPDX-License-Identifier: Apache-2.0
#include "fast/fanuc/tool_posture_control/posture_arc.h"

#include <cmath>
#include <type_traits>

namespace toolcomp::fast {
namespace {

// Signs of numbers whose error is below a bound.
template <class T>
class Judge {
 public:
  static constexpr bool kRough = std::is_same_v<T, double>;
  // `scale` of the terms. Unit vectors carry a few roundings a component, products of two or three of them up to 30; in
  // double-double what a component loses below 2^-96 counts too, times the `factor` it is multiplied by.
  int sign(const T& value, double scale, double factor = 1) {
    const double bound = kRough ? 0x1p-46 * scale : kPoseTie * scale + 0x1p-96 * factor;
    if (leading(value) > bound) return 1;
    if (leading(value) < -bound) return -1;
    if (kRough && bound != 0) unsure_ = true;
    return 0;
  }
  void doubt() { unsure_ = true; }
  [[nodiscard]] bool unsure() const { return unsure_; }

 private:
  bool unsure_ = false;
};

// The pole (+1, -1) that a direction is parallel to, if it exists.
template <class T>
int pole_of(const PolarFrame& polar, const Vector3<T>& v, bool relative, Judge<T>& judge) {
  const double n2 = leading(v.x * v.x + v.y * v.y);
  constexpr double kNear = Judge<T>::kRough ? 0x1p-80 : kPoseTie * kPoseTie;
  if (relative ? n2 > 0 : n2 > kNear) return 0;
  if (Judge<T>::kRough && !relative) judge.doubt();
  if (leading(v.z) > 0) return polar.has_plus() ? 1 : 0;
  return polar.has_minus() ? -1 : 0;
}

template <class T>
T larger(const T& a, const T& b) {
  return leading(a - b) > 0 ? a : b;
}

// What is asked of one arc, in the order in which the questions rest on each other. Each fills in its part of the
// findings; false where a double cannot tell.
template <class T>
class Search {
 public:
  Search(const PolarFrame& polar, const PostureArc<T>& arc, ArcFindings& found)
      : polar_(polar), arc_(arc), s_(arc.start), e_(arc.end), found_(found), n_(cross(s_, e_)), nn_(dot(n_, n_)) {}

  // Nearly equal or opposite: double-double.
  [[nodiscard]] bool is_parallel() const { return leading(nn_) <= (kRough ? 0x1p-40 : kPoseTie * kPoseTie); }
  bool singular_ends();
  bool azimuth();
  // Whether the highest and the lowest point of the circle are inside the arc.
  bool feet();
  // Through an axis in the plane of the arc: from one side of it to the other.
  void crossing();
  // Neither end is singular.
  [[nodiscard]] bool is_free() const { return found_.start_pole == 0 && found_.end_pole == 0; }
  // It turns back on a side where no singular posture is.
  [[nodiscard]] bool may_leave() const { return (top_ && !polar_.has_plus()) || (bottom_ && !polar_.has_minus()); }
  bool edge_of_reach();
  bool nearness(const NearLimit& limit);

 private:
  static constexpr bool kRough = Judge<T>::kRough;

  [[nodiscard]] T reach(bool plus) const;
  int upward();
  int nearer_pole();

  const PolarFrame& polar_;
  const PostureArc<T>& arc_;
  const Vector3<T>& s_;
  const Vector3<T>& e_;
  ArcFindings& found_;
  Judge<T> judge_;
  Vector3<T> n_;
  T nn_;
  // Of the horizontal parts of both ends.
  T across_{};
  T ss_{}, ee_{}, se_{};
  double lengths_ = 0;
  // Where the horizontal components have no small relative error (double only) the bounds are absolute.
  bool relative_ = true;
  bool top_ = false;  // the highest point is inside the arc; the lowest
  bool bottom_ = false;
  T n2_{};
  T high_{};         // the height of the highest point
  double blur_ = 1;  // n carries an absolute error: the shorter it is the less it tells of its direction
};

template <class T>
bool Search<T>::singular_ends() {
  found_.start_pole = pole_of(polar_, s_, arc_.relative, judge_);
  found_.end_pole = pole_of(polar_, e_, arc_.relative, judge_);
  return !judge_.unsure();
}

template <class T>
bool Search<T>::azimuth() {
  across_ = arc_.meridian ? number<T>(0) : n_.z;
  relative_ = arc_.relative || !kRough;
  ss_ = s_.x * s_.x + s_.y * s_.y;
  ee_ = e_.x * e_.x + e_.y * e_.y;
  se_ = s_.x * e_.x + s_.y * e_.y;
  lengths_ = std::sqrt(leading(ss_)) + std::sqrt(leading(ee_));
  if (!is_free()) return true;
  const double terms = std::abs(leading(s_.x) * leading(e_.y)) + std::abs(leading(s_.y) * leading(e_.x));
  found_.azimuth = arc_.meridian ? 0 : judge_.sign(across_, relative_ ? terms : 1, lengths_);
  return !judge_.unsure();
}

template <class T>
bool Search<T>::feet() {
  const double s_length = std::sqrt(leading(ss_));
  const double e_length = std::sqrt(leading(ee_));
  // e.z - (s.e) s.z and the like, by the horizontal parts: near a singular posture they are small.
  const auto foot = [&](const T& square, double length, const T& far, const T& near, double other) {
    const double scale = length * (length * std::abs(leading(far)) + other * std::abs(leading(near)));
    return judge_.sign(square * far - near * se_, relative_ ? scale : lengths_, lengths_);
  };
  const int behind = foot(ss_, s_length, e_.z, s_.z, e_length);
  const int before = foot(ee_, e_length, s_.z, e_.z, s_length);
  top_ = behind >= 0 && before >= 0;
  bottom_ = behind <= 0 && before <= 0;
  return !judge_.unsure();
}

template <class T>
void Search<T>::crossing() {
  if (!is_free() || found_.azimuth != 0 || !(leading(se_) < 0)) return;
  if (top_ && polar_.has_plus())
    found_.crossing = 1;
  else if (bottom_ && polar_.has_minus())
    found_.crossing = -1;
}

// The height at which the directions that can be reached end.
template <class T>
T Search<T>::reach(bool plus) const {
  if constexpr (kRough)
    return plus ? polar_.constants().top : polar_.constants().bottom;
  else
    return plus ? polar_.fine_constants().top : polar_.fine_constants().bottom;
}

template <class T>
bool Search<T>::edge_of_reach() {
  n2_ = across_ * across_;
  high_ = root(number<T>(1) - n2_ / nn_);
  const double per_length = 1 / std::sqrt(leading(nn_));
  blur_ = kRough ? per_length : 1 + 0x1p-30 * per_length;
  if (top_ && !polar_.has_plus() && judge_.sign(reach(true) - high_, blur_) < 0) found_.leaves = true;
  if (bottom_ && !polar_.has_minus() && judge_.sign(-high_ - reach(false), blur_) < 0) found_.leaves = true;
  return !judge_.unsure();
}

// The sign of s.z + e.z; of one above and one below by their horizontal parts, which near singular postures tell more.
template <class T>
int Search<T>::upward() {
  if (leading(s_.z) * leading(e_.z) >= 0) return judge_.sign(s_.z + e_.z, 1);
  const int wider = judge_.sign(ee_ - ss_, relative_ ? leading(ss_ + ee_) : lengths_, lengths_);
  return leading(s_.z) > 0 ? wider : -wider;
}

// That on whose side the circle turns back, if it does; 0 where there is none.
template <class T>
int Search<T>::nearer_pole() {
  if (polar_.has_plus() && polar_.has_minus()) return top_ || (!bottom_ && upward() >= 0) ? 1 : -1;
  return polar_.has_plus() ? 1 : polar_.has_minus() ? -1 : 0;
}

template <class T>
bool Search<T>::nearness(const NearLimit& limit) {
  // Which of two equally near ones only matters where they are near.
  const int pole = nearer_pole();
  if (pole == 0) return true;
  // The cosine of its distance.
  const T of_ends = pole > 0 ? larger(s_.z, e_.z) : larger(-s_.z, -e_.z);
  const bool inside = pole > 0 ? top_ : bottom_;
  T square;
  T cosine;
  if constexpr (kRough) {
    square = limit.square;
    cosine = limit.cosine;
  } else {
    square = limit.fine.sine * limit.fine.sine;
    cosine = limit.fine.cosine;
  }
  bool near = false;
  if (inside)
    near = limit.above_90 || judge_.sign(square * nn_ - n2_, leading(nn_) * blur_, std::sqrt(leading(nn_))) > 0;
  else
    near = limit.above_180 || judge_.sign(of_ends - cosine, 1) > 0;
  if (near) found_.near = pole;
  return !judge_.unsure();
}

}  // namespace

template <class T>
bool find(const PolarFrame& polar, const PostureArc<T>& arc, const NearLimit& limit, ArcFindings& found) {
  found = ArcFindings{};
  Search<T> search(polar, arc, found);
  if (search.is_parallel()) {
    found.parallel = true;
    return !Judge<T>::kRough;
  }
  if (!search.singular_ends() || !search.azimuth() || !search.feet()) return false;
  search.crossing();
  // The usual block needs no more.
  const bool looks_near = limit && search.is_free() && found.crossing == 0;
  if (!search.may_leave() && !looks_near) return true;
  if (!search.edge_of_reach()) return false;
  return !looks_near || found.leaves || search.nearness(limit);
}

template bool find(const PolarFrame&, const PostureArc<double>&, const NearLimit&, ArcFindings&);
template bool find(const PolarFrame&, const PostureArc<DoubleDouble>&, const NearLimit&, ArcFindings&);

}  // namespace toolcomp::fast

#include "fast/fanuc/tool_posture_control/posture_arc.h"

#include <cmath>
#include <type_traits>

#include "fast/basis/fault.h"

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

}  // namespace

template <class T>
bool find(const PolarFrame& polar, const PostureArc<T>& arc, const NearLimit& limit, ArcFindings& found) {
  Judge<T> judge;
  found = ArcFindings{};
  const Vector3<T>& s = arc.start;
  const Vector3<T>& e = arc.end;
  const Vector3<T> n = cross(s, e);
  const T nn = dot(n, n);
  // Nearly equal or opposite: double-double.
  if (leading(nn) <= (Judge<T>::kRough ? 0x1p-40 : kPoseTie * kPoseTie)) {
    found.parallel = true;
    return !Judge<T>::kRough;
  }
  found.start_pole = pole_of(polar, s, arc.relative, judge);
  found.end_pole = pole_of(polar, e, arc.relative, judge);
  if (judge.unsure()) return false;

  T across = n.z;
  if (arc.meridian) across = number<T>(0);
  // Where the horizontal components have no small relative error (double only) the bounds are absolute.
  const bool relative = arc.relative || !Judge<T>::kRough;
  const double terms = std::abs(leading(s.x) * leading(e.y)) + std::abs(leading(s.y) * leading(e.x));
  const T ss = s.x * s.x + s.y * s.y;
  const T ee = e.x * e.x + e.y * e.y;
  const T se = s.x * e.x + s.y * e.y;
  const double s_length = std::sqrt(leading(ss));
  const double e_length = std::sqrt(leading(ee));
  const double lengths = s_length + e_length;
  if (found.start_pole == 0 && found.end_pole == 0) {
    found.azimuth = arc.meridian ? 0 : judge.sign(across, relative ? terms : 1, lengths);
    if (judge.unsure()) return false;
  }
  // The feet of u_w (the highest point of the circle) and of -u_w (the lowest): inside the arc? e.z - (s.e) s.z and the
  // like, by the horizontal parts: near a singular posture they are small.
  const auto foot = [&](const T& square, double length, const T& far, const T& near, double other) {
    const double scale = length * (length * std::abs(leading(far)) + other * std::abs(leading(near)));
    return judge.sign(square * far - near * se, relative ? scale : lengths, lengths);
  };
  const int behind = foot(ss, s_length, e.z, s.z, e_length);
  const int before = foot(ee, e_length, s.z, e.z, s_length);
  if (judge.unsure()) return false;
  const bool top = behind >= 0 && before >= 0;
  const bool bottom = behind <= 0 && before <= 0;
  const bool free = found.start_pole == 0 && found.end_pole == 0;
  // Through an axis in the plane of the arc: from one side of it to the other.
  if (free && found.azimuth == 0 && leading(se) < 0) {
    if (top && polar.has_plus())
      found.crossing = 1;
    else if (bottom && polar.has_minus())
      found.crossing = -1;
  }

  // The usual block needs no more.
  const bool looks_near = limit && free && found.crossing == 0;
  if (!(top && !polar.has_plus()) && !(bottom && !polar.has_minus()) && !looks_near) return true;

  const T n2 = across * across;
  const T high = root(number<T>(1) - n2 / nn);  // the height of the highest point
  // N carries an absolute error: the shorter it is the less it tells of its direction.
  const double per_length = 1 / std::sqrt(leading(nn));
  const double blur = Judge<T>::kRough ? per_length : 1 + 0x1p-30 * per_length;
  const auto reach = [&](bool plus) {
    if constexpr (Judge<T>::kRough)
      return plus ? polar.constants().top : polar.constants().bottom;
    else
      return plus ? polar.fine_constants().top : polar.fine_constants().bottom;
  };
  if (top && !polar.has_plus() && judge.sign(reach(true) - high, blur) < 0) found.leaves = true;
  if (bottom && !polar.has_minus() && judge.sign(-high - reach(false), blur) < 0) found.leaves = true;
  if (judge.unsure()) return false;
  if (!limit || !free || found.crossing != 0 || found.leaves) return true;

  // The cosine of its distance from either singular posture.
  const auto largest = [](const T& a, const T& b) { return leading(a - b) > 0 ? a : b; };
  const T to_plus = top ? high : largest(s.z, e.z);
  const T to_minus = bottom ? high : largest(-s.z, -e.z);
  // The sign of s.z + e.z; of one above and one below by their horizontal parts, which near singular postures tell
  // more.
  const auto upward = [&] {
    if (leading(s.z) * leading(e.z) >= 0) return judge.sign(s.z + e.z, 1);
    const int wider = judge.sign(ee - ss, relative ? leading(ss + ee) : lengths, lengths);
    return leading(s.z) > 0 ? wider : -wider;
  };
  // The nearer one: that on whose side the circle turns back, if it does.
  int pole = 0;
  if (polar.has_plus() && polar.has_minus())
    pole = top || (!bottom && upward() >= 0) ? 1 : -1;
  else if (polar.has_plus())
    pole = 1;
  else if (polar.has_minus())
    pole = -1;
  else
    return true;
  // Which of two equally near ones only matters where they are near.
  const bool by_ends = fault(Fault::posture_near_by_ends);
  const bool inside = (pole > 0 ? top : bottom) && !by_ends;
  T square;
  T cosine;
  if constexpr (Judge<T>::kRough) {
    square = limit.square;
    cosine = limit.cosine;
  } else {
    square = limit.fine.sine * limit.fine.sine;
    cosine = limit.fine.cosine;
  }
  bool near = false;
  if (inside)
    near = limit.above_90 || judge.sign(square * nn - n2, leading(nn) * blur, std::sqrt(leading(nn))) > 0;
  else
    near = limit.above_180 || judge.sign((pole > 0 ? to_plus : to_minus) - cosine, 1) > 0;
  if (by_ends) near = leading(pole > 0 ? largest(s.z, e.z) : largest(-s.z, -e.z)) > leading(cosine);
  if (near) found.near = pole;
  return !judge.unsure();
}

template bool find(const PolarFrame&, const PostureArc<double>&, const NearLimit&, ArcFindings&);
template bool find(const PolarFrame&, const PostureArc<DoubleDouble>&, const NearLimit&, ArcFindings&);

}  // namespace toolcomp::fast

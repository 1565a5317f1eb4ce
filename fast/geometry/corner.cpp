#include "fast/geometry/corner.h"

#include <algorithm>
#include <cmath>

#include "fast/basis/fault.h"

namespace toolcomp::fast {
namespace {

// One derivation serves lines and arcs of every combination. With p the signed curvature (+1/R counterclockwise, 0 for
// a line), c = t1 x t2, k = t1 . t2 and
//   e = rho (p1 + p2 - rho p1 p2), that is 1 - e = (1 - rho p1)(1 - rho p2), the product of the radii of the offset
//       circles over the radii,
// the offset paths meet where 1 + k - 2 e >= 0, and the vector X to the nearer point is
//   X = [rho (p1 - p2)(a N1 - b t1) + sign(c) S (a t1 + b N1)] / (a^2 + b^2),   a = p1 k - p2, b = p1 c,
//   S = sqrt(1 - k)(sqrt(1 + k) - sqrt(1 + k - 2 e)) = 2 e sqrt(1 - k) / (sqrt(1 + k) + sqrt(1 + k - 2 e)).
// a^2 + b^2 is the squared distance of the centres over (R1 R2)^2, S is free of cancellation, and the two brackets are
// perpendicular. A latter path offset to the other side is the same path run backward: c, k and p2 change their signs.
template <class T>
struct Numbers {
  Vector2<T> t1;
  Vector2<T> t2;
  T c{};
  T k{};
  T plus{};   // 1 + k
  T minus{};  // 1 - k
  T p1{};
  T p2{};
  T rho{};
  T rho2{};
  T r{};
  int turned = 0;  // the sign of c
};

int sign_of(double value) { return static_cast<int>(value > 0) - static_cast<int>(value < 0); }

template <class T>
void complete(Numbers<T>& n) {
  if (leading(n.k) >= 0) {
    n.plus = number<T>(1) + n.k;
    n.minus = n.c * n.c / n.plus;
  } else {
    n.minus = number<T>(1) - n.k;
    n.plus = n.c * n.c / n.minus;
  }
}

Numbers<double> numbers(const Corner& corner) {
  Numbers<double> n;
  n.t1 = corner.last->unit;
  n.t2 = corner.next->unit;
  n.c = corner.turn.c / corner.turn.norms;
  n.k = corner.turn.k / corner.turn.norms;
  // As complete() does, without a quotient of a quotient.
  const double norms = corner.turn.norms;
  const double square = corner.turn.c * corner.turn.c;
  if (corner.turn.k >= 0) {
    n.plus = 1 + n.k;
    n.minus = square / (norms * (norms + corner.turn.k));
  } else {
    n.minus = 1 - n.k;
    n.plus = square / (norms * (norms - corner.turn.k));
  }
  n.turned = sign_of(corner.turn.c);
  n.r = corner.offset->nearest;
  n.rho = corner.first_side * n.r;
  n.rho2 = corner.second_side * n.r;
  if (corner.first->arc) n.p1 = corner.first->sigma / corner.first->radius_end;
  if (corner.second != nullptr && corner.second->arc) n.p2 = corner.second->sigma / corner.second->radius_start;
  return n;
}

Numbers<DoubleDouble> fine_numbers(const Corner& corner) {
  const auto signed_by = [](int sign, const DoubleDouble& value) { return sign < 0 ? -value : value; };
  Numbers<DoubleDouble> n;
  n.t1 = fine_unit(*corner.last);
  n.t2 = fine_unit(*corner.next);
  n.turned = sign_of(corner.turn.c);
  n.c = n.turned == 0 ? DoubleDouble{} : cross(n.t1, n.t2);
  n.k = corner.turn.k == 0 ? DoubleDouble{} : dot(n.t1, n.t2);
  complete(n);
  n.r = to_double_double(corner.offset->exact.units()) / to_double_double(Count::kRestPerOne);
  n.rho = signed_by(corner.first_side, n.r);
  n.rho2 = signed_by(corner.second_side, n.r);
  const auto curvature = [&](const PlanePath* path, bool at_end) {
    if (path == nullptr || !path->arc) return DoubleDouble{};
    return signed_by(path->sigma, DoubleDouble{1, 0} / fine_radius(*path, at_end));
  };
  n.p1 = curvature(corner.first, true);
  n.p2 = curvature(corner.second, false);
  return n;
}

// The latter path run backward.
template <class T>
void reverse_second(Numbers<T>& n) {
  n.c = -n.c;
  n.k = -n.k;
  n.p2 = -n.p2;
  n.turned = -n.turned;
  const T plus = n.plus;
  n.plus = n.minus;
  n.minus = plus;
}

template <class T>
T curvature_term(const Numbers<T>& n) {
  return n.rho * (n.p1 + n.p2 - n.rho * n.p1 * n.p2);
}

// What errors of 1 + k - 2 e are relative to.
template <class T>
double discriminant_scale(const Numbers<T>& n) {
  const double first = std::abs(leading(n.rho) * leading(n.p1));
  const double second = std::abs(leading(n.rho) * leading(n.p2));
  return leading(n.plus) + 2 * (first + second + first * second);
}

constexpr double kBound = 0x1p-48;
constexpr double kFineBound = 0x1p-92;

template <class T>
Vector2<T> tangents_meet(const Numbers<T>& n) {
  const T along = leading(n.k) >= 0 ? n.c / n.plus : n.minus / n.c;
  return (left_of(n.t1) - n.t1 * along) * n.rho;
}

// `discriminant`: 1 + k - 2 e, not negative.
template <class T>
Vector2<T> paths_meet(const Numbers<T>& n, const T& e, const T& discriminant) {
  const T sum = root(n.plus) + root(discriminant);
  const T difference = n.p1 - n.p2;
  const T a = leading(n.k) >= 0 ? difference - n.p1 * n.minus : n.p1 * n.plus - (n.p1 + n.p2);
  const T b = n.p1 * n.c;
  const Vector2<T> n1 = left_of(n.t1);
  const Vector2<T> across = n1 * a - n.t1 * b;
  const Vector2<T> along = n.t1 * a + n1 * b;
  const T square = a * a + b * b;
  T s = number<T>(2) * e * root(n.minus) / (sum * square);
  if (fault(Fault::c_far_root)) s = root(n.minus) * sum / square;
  if (n.turned < 0) s = -s;
  const T q = n.rho * difference / square;
  return {across.x * q + along.x * s, across.y * q + along.y * s};
}

template <class T>
bool has_arcs(const Numbers<T>& n) {
  return leading(n.p1) != 0 || leading(n.p2) != 0;
}

Vector2<DoubleDouble> fine_paths_meet(const Numbers<DoubleDouble>& n) {
  if (!has_arcs(n)) return tangents_meet(n);
  const DoubleDouble e = curvature_term(n);
  DoubleDouble discriminant = n.plus - e * 2.0;
  if (discriminant.hi < kFineBound * discriminant_scale(n)) discriminant = {};
  return paths_meet(n, e, discriminant);
}

// Down to which (a^2 + b^2) / (p1^2 + p2^2) doubles make the vector of paths_meet well. The error of a curvature moves
// it along the path only, by rho p b / (a^2 + b^2) times as much, which is little where the paths hardly turn; the
// error of a turn that is not exact by rho p / sqrt(a^2 + b^2).
double least_spread(const Corner& corner, double c) {
  const double turn = corner.turn.error;
  return std::clamp(std::max(std::abs(c) / 4, 0x1p-6 * turn * turn), 0x1p-20, 0x1p-6);
}

Vector2<double> nearest(const Vector2<DoubleDouble>& v) { return {to_double(v.x), to_double(v.y)}; }

}  // namespace

Vector2<DoubleDouble> fine_head_vector(const Corner& corner, HeadKind kind) {
  if (kind == HeadKind::zero) return {};
  Numbers<DoubleDouble> n = fine_numbers(corner);
  switch (kind) {
    case HeadKind::zero:
      break;
    case HeadKind::first_normal:
      return left_of(n.t1) * n.rho;
    case HeadKind::second_normal:
      return left_of(n.t2) * n.rho2;
    case HeadKind::first_extended:
      return left_of(n.t1) * n.rho + n.t1 * n.r;
    case HeadKind::second_extended:
      return left_of(n.t2) * n.rho - n.t2 * n.r;
    case HeadKind::tangents_meet:
      return tangents_meet(n);
    case HeadKind::paths_cross:
      reverse_second(n);
      return fine_paths_meet(n);
    case HeadKind::paths_meet:
      return fine_paths_meet(n);
  }
  return {};
}

bool offset_paths_meet(const Corner& corner, HeadKind kind, Vector2<double>& vector) {
  const bool crossing = kind == HeadKind::paths_cross;
  Numbers<double> n = numbers(corner);
  if (crossing) reverse_second(n);
  if (!has_arcs(n)) {
    if (n.turned == 0 && n.k <= 0) return false;
    vector = tangents_meet(n);
    return true;
  }
  const double e = curvature_term(n);
  const double discriminant = n.plus - 2 * e;
  const double scale = discriminant_scale(n);
  const double difference = n.p1 - n.p2;
  const double spread = difference * difference + 2 * n.p1 * n.p2 * n.minus;
  if (discriminant >= 0x1p-6 * scale && spread >= least_spread(corner, n.c) * (n.p1 * n.p1 + n.p2 * n.p2)) [[likely]] {
    vector = paths_meet(n, e, discriminant);
    return true;
  }
  if (discriminant < -kBound * scale) return false;
  // Near tangent contact a root, near equal circles the distance of the centres lose what doubles have.
  Numbers<DoubleDouble> fine = fine_numbers(corner);
  if (crossing) reverse_second(fine);
  if (discriminant <= kBound * scale &&
      (fine.plus - curvature_term(fine) * 2.0).hi <= -kFineBound * discriminant_scale(fine))
    return false;
  vector = nearest(fine_paths_meet(fine));
  return true;
}

}  // namespace toolcomp::fast

// SPDX-License-Identifier: Apache-2.0
#include "fast/kinematics/polar_frame.h"

#include <cmath>

namespace toolcomp::fast {
namespace {

using Fine = Vector3<DoubleDouble>;

Fine vector(const FineVector& v) { return {v[0], v[1], v[2]}; }
DoubleDouble length(const Fine& v) { return sqrt(dot(v, v)); }
// Far above the rounding of double-double, far below a millionth of a degree squared.
DoubleDouble snapped(const DoubleDouble& x) { return std::abs(x.hi) < 0x1p-88 ? DoubleDouble{} : x; }
bool along_axis(const Fine& v) {
  int zero = 0;
  for (std::size_t i = 0; i < 3; ++i) zero += v[i].hi == 0 ? 1 : 0;
  return zero == 2;
}

// The roots where |C| < rho or = rho: f1 = top - k and f2 = k - bottom, both >= 0.
void fill(const PolarFrame::Constants<DoubleDouble>& c, const Fine& seen, const DoubleDouble& f1,
          const DoubleDouble& f2, PolarRoots& roots) {
  roots.cos_psi = (seen.z - c.cc) / c.ss;
  roots.sin_psi = root(f1 * f2) / c.ss;
  // cos a sin b - sin a cos b cos psi, without cancellation at the end that is near.
  roots.hx = f1.hi <= f2.hi ? c.skew + c.sc * f1 / c.ss : c.sum - c.sc * f2 / c.ss;
  roots.hy = -(c.sa * roots.sin_psi);
  const DoubleDouble n2 = seen.x * seen.x + seen.y * seen.y;
  const DoubleDouble xx = seen.x * roots.hx;
  const DoubleDouble yy = seen.y * roots.hy;
  const DoubleDouble yx = seen.y * roots.hx;
  const DoubleDouble xy = seen.x * roots.hy;
  roots.work[0] = {(yx - xy) / n2, (xx + yy) / n2};
  roots.work[1] = {(yx + xy) / n2, (xx - yy) / n2};
}

}  // namespace

PolarFrame::PolarFrame(const FineVector& tool_side, const FineVector& work_side, const FineVector& zero) {
  const Fine ut = vector(tool_side);
  const Fine uw = vector(work_side);
  const Fine t0 = vector(zero);
  const DoubleDouble ca = snapped(dot(ut, t0));
  const DoubleDouble sa = snapped(length(cross(ut, t0)));
  const DoubleDouble cb = snapped(dot(ut, uw));
  const DoubleDouble sb = snapped(length(cross(ut, uw)));
  invertible_ = sa.hi > 0 && sb.hi > 0;
  fine_.row[2] = uw;
  if (!invertible_) return;
  fine_.row[0] = (ut - uw * cb) * (DoubleDouble{1, 0} / sb);
  for (auto* x : {&fine_.row[0].x, &fine_.row[0].y, &fine_.row[0].z}) *x = snapped(*x);
  fine_.row[1] = cross(uw, fine_.row[0]);
  fine_.cc = ca * cb;
  fine_.ss = sa * sb;
  fine_.sc = sa * cb;
  fine_.sa = sa;
  fine_.per_ss = DoubleDouble{1, 0} / fine_.ss;
  fine_.sc_per_ss = fine_.sc / fine_.ss;
  fine_.skew = snapped(sb * ca - cb * sa);
  fine_.sum = snapped(sa * cb + ca * sb);
  fine_.top = ca * cb + sa * sb;
  fine_.bottom = ca * cb - sa * sb;
  plus_ = fine_.skew.hi == 0;
  minus_ = fine_.sum.hi == 0;
  if (plus_) fine_.top = {1, 0};
  if (minus_) fine_.bottom = {-1, 0};
  fine_.above = DoubleDouble{1, 0} - fine_.top;
  fine_.below = DoubleDouble{1, 0} + fine_.bottom;
  orthogonal_ = ca.hi == 0 && cb.hi == 0;
  along_axes_ = along_axis(fine_.row[0]) && along_axis(fine_.row[1]) && along_axis(fine_.row[2]);
  // Where the tool is nearest to u_w: A = u_w.q, B = u_w.r.
  const Fine q = t0 - ut * ca;
  const Fine r = cross(ut, t0);
  const DoubleDouble a = snapped(dot(uw, q));
  const DoubleDouble b = snapped(dot(uw, r));
  phase_ = fine_arctangent(b, a);
  phase_degrees_ = phase_.nearest();
  fine_.phase = {b / fine_.ss, a / fine_.ss};

  for (std::size_t i = 0; i < 3; ++i) rough_.row[i] = nearest(fine_.row[i]);
  const auto round = [](const DoubleDouble& x) { return x.hi; };
  rough_.cc = round(fine_.cc);
  rough_.ss = round(fine_.ss);
  rough_.sc = round(fine_.sc);
  rough_.sa = round(fine_.sa);
  rough_.per_ss = round(fine_.per_ss);
  rough_.sc_per_ss = round(fine_.sc_per_ss);
  rough_.skew = round(fine_.skew);
  rough_.sum = round(fine_.sum);
  rough_.top = round(fine_.top);
  rough_.bottom = round(fine_.bottom);
  rough_.above = round(fine_.above);
  rough_.below = round(fine_.below);
  rough_.phase = {round(fine_.phase.sine), round(fine_.phase.cosine)};
}

Reach PolarFrame::solve(const Vector3<DoubleDouble>& seen, PolarRoots& roots) const {
  const DoubleDouble n2 = seen.x * seen.x + seen.y * seen.y;
  const DoubleDouble& k = seen.z;
  if (!invertible_) return Reach::none;
  const bool parallel = n2.hi < kPoseTie * kPoseTie;
  if (parallel && (k.hi > 0 ? plus_ : minus_)) {
    roots.cos_psi = {k.hi > 0 ? 1.0 : -1.0, 0};
    roots.sin_psi = {};
    return Reach::singular;
  }
  DoubleDouble f1 = fine_.top - k;
  DoubleDouble f2 = k - fine_.bottom;
  const DoubleDouble one{1, 0};
  if (plus_ && k.hi > 0) f1 = n2 / (one + k);
  if (minus_ && k.hi < 0) f2 = n2 / (one - k);
  if (f1.hi < -kPoseTie || f2.hi < -kPoseTie || parallel) return Reach::none;
  // Near an existing pole f is small without being at the edge.
  const bool toward_plus = plus_ && k.hi > 0;
  const bool toward_minus = minus_ && k.hi < 0;
  const bool at_top = f1.hi <= kPoseTie && !toward_plus;
  const bool at_bottom = f2.hi <= kPoseTie && !toward_minus;
  if (at_top) f1 = {};
  if (at_bottom) f2 = {};
  fill(fine_, seen, f1, f2, roots);
  if (!at_top && !at_bottom) return Reach::two_pairs;
  roots.cos_psi = {at_top ? 1.0 : -1.0, 0};
  return Reach::edge;
}

}  // namespace toolcomp::fast

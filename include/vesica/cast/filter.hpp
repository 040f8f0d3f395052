// SPDX-License-Identifier: Apache-2.0
/// The decision of exact.hpp in double, with bounds on its errors: most casts are decided here, and what is decided is
/// certain. u = 2^-53 in comments, which state errors to first order; constants in the code leave room for the rest.
#pragma once

#include <limits>
#include <vesica/cast/body.hpp>
#include <vesica/form/placement.hpp>

namespace vesica::detail::cast {

/// A body's numbers, each with a relative error of at most u, and whether they are usable: valid, and in a range in
/// which products neither overflow nor lose what counts.
struct Sketch {
  form::Corners<double> place;
  double ux, uy, hx, hy;
  bool round, usable;
  double radius = 0;
};

inline constexpr double least_usable = 0x1p-200, most_usable = 0x1p200;

template <class V>
VESICA_INLINE auto in_usable_range(V x) noexcept {
  return both(x >= V(least_usable), x <= V(most_usable));
}

template <class Shape>
VESICA_INLINE Sketch sketch(const Shape& s) noexcept {
  constexpr form::AsStored<double> number;
  const auto f = form::of(s);
  const double ux = number(f.ux), uy = number(f.uy), hx = number(f.hx), hy = number(f.hy);
  const bool round = f.outline != form::Outline::straight && hx > 0 && hy > 0;
  const bool point = f.axis_may_vanish && ux == 0 && uy == 0;
  const bool usable = (point || in_usable_range(abs(ux) + abs(uy))) && hx >= 0 && hy >= 0 && hx + hy <= most_usable;
  return {form::corners(f.place), ux, uy, hx, hy, round, usable, 0};
}
VESICA_INLINE Sketch sketch(const Body& body) noexcept {
  Sketch out = with_shape(body, [](const auto& s) { return sketch(s); });
  out.radius = body.radius;
  out.usable = out.usable && body.radius >= 0 && body.radius <= most_usable;
  return out;
}

/// Reach h across v as in exact.hpp, the reach along v, and errors.
///
/// Proved: h is off by at most 6u R for a box and 8u R for an ellipse, where R = (hx + hy) A V, and A and V are the
/// sums of the components of axis and velocity. For c and k are off by 3u A V, and sizes by u of themselves.
struct Reach {
  double c, k, h, h_error, forward, size;
};

VESICA_INLINE Reach reach(const Sketch& s, const Motion& v, double speed) noexcept {
  constexpr double u = 0x1p-53;
  const double c = s.ux * v.vx + s.uy * v.vy, k = s.ux * v.vy - s.uy * v.vx;
  const double size = (s.hx + s.hy) * ((abs(s.ux) + abs(s.uy)) * speed);
  const double p = s.hx * k, q = s.hy * c, p_along = s.hx * c, q_along = s.hy * k;
  if (!s.round) return {c, k, abs(p) + abs(q), 16 * u * size, abs(p_along) + abs(q_along), size};
  return {c, k, sqrt(p * p + q * q), 12 * u * size, sqrt(p_along * p_along + q_along * q_along), size};
}

/// x.v of exact.hpp and its error.
///
/// Proved: a wrong sign of k or c of a box does no harm. The point x then lies at the other end of an edge that is
/// nearly along v, and the true reach of that end is within 6u R of h. That end will do, so this counts in the error of
/// h alone. Of an ellipse the product m has an error of 8u R^2.
struct Along {
  double x, error;
};

VESICA_INLINE Along along(const Sketch& s, const Reach& r) noexcept {
  constexpr double u = 0x1p-53;
  if (!s.round) {
    return {lane::flip_sign(-(s.hx * r.c), r.k) + lane::flip_sign(s.hy * r.k, r.c), 8 * u * r.size};
  }
  // Each factor is a reach: the product of two lengths alone would underflow where the axis is long.
  const double x = ((s.hy - s.hx) * r.c) * ((s.hy + s.hx) * r.k) / r.h;
  return {x, u * (10 * r.size * r.size + 16 * r.size * abs(x)) / r.h + 2 * u * abs(x)};
}

/// A certain result of the filter. `reached`: contact within the time; `missed`: no contact; `passed`: none except
/// perhaps at the start; `late`: contact, and a witness after the end.
enum class Verdict { undecided, missed, passed, reached, late };

/// apart: certainly no contact at the start.
struct Filtered {
  Verdict verdict;
  bool apart;
};

/// Offset of the centres along a coordinate: the mean of two differences, each rounded, and none larger than |D| + R /
/// V. So the error is below 2u |D| + u R / V.
template <class V>
VESICA_INLINE V offset(V to0, V to1, V from0, V from1) noexcept {
  return V(0.5) * ((to0 - from0) + (to1 - from1));
}

VESICA_INLINE Filtered filter(const Sketch& a, const Sketch& b, const Motion& v) noexcept {
  constexpr double u = 0x1p-53;
  const double speed = abs(v.vx) + abs(v.vy);
  const double dx = offset(b.place.x0, b.place.x1, a.place.x0, a.place.x1);
  const double dy = offset(b.place.y0, b.place.y1, a.place.y0, a.place.y1);
  const Reach ra = reach(a, v, speed), rb = reach(b, v, speed);
  const double size = ra.size + rb.size, d_size = (abs(dx) + abs(dy)) * speed, all = size + d_size;
  // Underflow: an error of 2^-537 at most in the reach of an ellipse, and less elsewhere.
  const bool usable = a.usable && b.usable && in_usable_range(speed) && abs(dx) + abs(dy) <= most_usable &&
                      all >= 0x1p-400 && !(a.round && !(ra.size >= 0x1p-400)) && !(b.round && !(rb.size >= 0x1p-400));
  if (!usable) return {Verdict::undecided, false};

  const double w = v.vx * dy - v.vy * dx, q = v.vx * dx + v.vy * dy, d_error = u * (6 * d_size + 2 * size);
  // A radius reaches as far across v as along it. Its own terms are off by 5u.
  const double radius = a.radius + b.radius, around = radius > 0 ? radius * sqrt(v.vx * v.vx + v.vy * v.vy) : 0;
  const double h = ra.h + rb.h + around, h_error = ra.h_error + rb.h_error + 4 * u * h + 8 * u * around,
               gap = abs(w) - h;
  const double forward = ra.forward + rb.forward + around, forward_error = d_error + h_error + 4 * u * forward;
  const bool has_end = v.end <= most_usable;
  const double vv = v.vx * v.vx + v.vy * v.vy, whole = has_end ? v.end * vv : 0;
  // Beside the line; moving away; out of reach at the end. Usually one holds for a miss; unpredictable, so no branch.
  const bool beside = gap > d_error + h_error, away = q - forward > forward_error;
  const bool short_of = -q - forward - whole > forward_error + 8 * u * whole;
  if (lane::either(lane::either(beside, away), lane::both(has_end, short_of))) return {Verdict::missed, true};
  const bool apart = -q - forward > forward_error;
  const auto answer = [apart](Verdict verdict) { return Filtered{verdict, apart}; };
  if (!(gap < -(d_error + h_error))) return answer(Verdict::undecided);

  const Along xa = along(a, ra), xb = along(b, rb);
  const double along = xa.x + xb.x, along_error = xa.error + xb.error + 2 * u * abs(along);
  const double first = w * along, second = q * h;
  const double error = 1.25 * ((abs(w) + d_error) * along_error + abs(along) * d_error + abs(q) * h_error +
                               (h + h_error) * d_error + 4 * u * (abs(first) + abs(second)));
  const double after_start = first - second;
  if (after_start < -error) return answer(Verdict::passed);
  if (!(after_start > error)) return answer(Verdict::undecided);
  if (v.end == std::numeric_limits<double>::infinity()) return answer(Verdict::reached);
  if (!has_end) return answer(Verdict::undecided);
  const double rest = whole * h, rest_error = whole * h_error + 8 * u * rest, after_end = after_start - rest;
  const double end_error = error + rest_error + 2 * u * abs(after_end);
  return answer(after_end < -end_error ? Verdict::reached : after_end > end_error ? Verdict::late : Verdict::undecided);
}

}  // namespace vesica::detail::cast

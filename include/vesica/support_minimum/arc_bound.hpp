// SPDX-License-Identifier: Apache-2.0
/// Lower bounds of a combination of support functions on an arc of directions, from its values, slopes and curvatures
/// at the ends.
#pragma once

#include <vesica/support_minimum/plane_vector.hpp>

namespace vesica::detail::support_minimum {

/// A combination F = h1 + sign h2 + n.e of support functions at one unit normal: its value, its derivative by the
/// angle, and the radii of curvature of the two shapes (0 for a box: between the normals of its faces a corner rules).
struct Sample {
  PlaneVector n;
  double value, slope, radius1, radius2;
};

struct Range {
  double low, high;
};

/// The products of a number x > 0 and a number k, each between two ends.
inline Range range_of_product(double x0, double x1, double k0, double k1) noexcept {
  using namespace lane;
  const double x_low = min(x0, x1), x_high = max(x0, x1), k_low = min(k0, k1), k_high = max(k0, k1);
  return {k_low * (k_low < 0 ? x_high : x_low), k_high * (k_high < 0 ? x_low : x_high)};
}

inline Range common(const Range& r, const Range& s) noexcept {
  return {lane::max(r.low, s.low), lane::min(r.high, s.high)};
}

/// F'' + F = radius1 + sign radius2 on the arc between two samples, along which both radii and their ratio must be
/// monotone. The ratio matters where the radii nearly cancel, as they do all round for nearly equal ellipses.
inline Range curvature(const Sample& a, const Sample& b, double sign) noexcept {
  using namespace lane;
  const Range r1{min(a.radius1, b.radius1), max(a.radius1, b.radius1)};
  const Range r2{min(a.radius2, b.radius2), max(a.radius2, b.radius2)};
  if (sign > 0) return {r1.low + r2.low, r1.high + r2.high};
  Range r{r1.low - r2.high, r1.high - r2.low};
  if (r1.low > 0 && r2.low > 0) {
    const double da = a.radius1 - a.radius2, db = b.radius1 - b.radius2;
    r = common(r, range_of_product(a.radius1, b.radius1, da / a.radius1, db / b.radius1));
    r = common(r, range_of_product(a.radius2, b.radius2, da / a.radius2, db / b.radius2));
  }
  return r;
}

/// The least value on [0, t] of the function g with g'' + g = curvature, g(0) = value and g'(0) = slope; t at most a
/// quarter turn. Written so that a large curvature does not cancel.
inline double least(double value, double slope, double curvature, double cos_t, double sin_t) noexcept {
  const double k = curvature - value;
  if (slope < 0 && k * sin_t + slope * cos_t > 0) {
    const double swing = lane::sqrt(k * k + slope * slope);
    return k > 0 ? value - slope * (slope / (k + swing)) : curvature - swing;
  }
  return lane::min(value, value + slope * sin_t + k * (sin_t * sin_t / (1 + cos_t)));
}

/// On a shorter arc there is no representable direction between the ends.
inline constexpr double shortest_arc = 0x1p-53;

/// A lower bound of F on the arc from a to b, which is at most a quarter turn. The search may discard an arc only
/// because this bound is never too high, so it is proved here: let g solve g'' + g = low with F's value and slope at a.
/// Then F - g is the convolution of (F'' + F) - low >= 0 with the sine, so F >= g (Sturm comparison); the same holds
/// for the g that starts at b. The bound is the least value of the greater of the two.
inline double lower_bound(const Sample& a, const Sample& b, const Range& curvature) noexcept {
  const double cos_t = dot(a.n, b.n), sin_t = cross(a.n, b.n), ends = lane::min(a.value, b.value);
  const bool concave = curvature.high <= ends;
  const bool convex = curvature.low >= lane::max(a.value, b.value);
  if (!(sin_t > shortest_arc) || concave || (convex && (a.slope >= 0 || b.slope <= 0))) return ends;
  // The difference of the two is along * cos + across * sin of the angle from a: positive at a, negative at b.
  const double rise = curvature.low * (sin_t * sin_t / (1 + cos_t));
  const double along = lane::max(a.value - b.value * cos_t - rise + b.slope * sin_t, 0.0);
  const double across = a.slope + (curvature.low - b.value) * sin_t - b.slope * cos_t;
  PlaneVector meeting{cos_t, sin_t};
  if (across < 0) {
    const PlaneVector m = unit({-across, along});
    if (cross(m, meeting) > 0) meeting = m;
  }
  const double back_cos = cos_t * meeting.x + sin_t * meeting.y, back_sin = sin_t * meeting.x - cos_t * meeting.y;
  return lane::min(least(a.value, a.slope, curvature.low, meeting.x, meeting.y),
                   least(b.value, -b.slope, curvature.low, back_cos, back_sin));
}

}  // namespace vesica::detail::support_minimum

// SPDX-License-Identifier: Apache-2.0
/// ratio(which, a, b): intersection over union and similar ratios, by which detections and regions are compared.
///
/// Laws, each tested: over_union is iou(). over_first, over_second and over_smaller are from 0 to 1: 0 where no area is
/// shared, and 1 where the divisor's shape lies in the other one. Exchanging the shapes exchanges over_first and
/// over_second, and changes no bit of the others. generalized, distance and complete are at most over_union, at least
/// -1 for the first two, and -2 for the third. Two equal shapes have 1; generalized is less by the share of their box
/// that they leave empty. Scaling both shapes by 2^k changes nothing, unless digits are lost to subnormal numbers.
///
/// Accuracy: as area() and iou(), and 8u more (u = 2^-53), where lengths, and areas, are from 2^-400 to 2^400.
/// An area beyond is a little less accurate; none overflows.
///
/// H. Rezatofighi et al., "Generalized Intersection over Union", CVPR 2019. Z. Zheng et al., "Distance-IoU Loss", AAAI
/// 2020. For turned shapes both are taken with the box along the coordinate axes about the two.
#pragma once

#include <vesica/arithmetic/angle.hpp>
#include <vesica/iou.hpp>
#include <vesica/ratio/facts.hpp>

namespace vesica {

enum class Ratio : std::int32_t {
  over_union = 0,    ///< shared area / area of a and b together: IoU
  over_first = 1,    ///< shared area / area of a: IoF
  over_second = 2,   ///< shared area / area of b: IoA
  over_smaller = 3,  ///< shared area / lesser of the areas: IoS
  generalized = 4,   ///< IoU - (hull - union) / hull, the hull being the box about both: GIoU
  distance = 5,      ///< IoU - (distance of the centres / diagonal of the hull)^2: DIoU
  complete = 6,      ///< DIoU - v^2 / (1 - IoU + v), v = (angle between the shapes' (height, width), in right angles)^2
};

inline constexpr int ratio_count = 7;

constexpr bool is_ratio(std::int32_t number) noexcept { return number >= 0 && number < ratio_count; }

namespace detail::ratio {

/// True for ratios that need the shared area, but not the union's.
constexpr bool is_of_area(Ratio which) noexcept {
  return which == Ratio::over_first || which == Ratio::over_second || which == Ratio::over_smaller;
}

/// The double nearest to x / y, whatever exponents the two carry: also among the subnormal ones.
inline double quotient(const area::Measure& x, const area::Measure& y) noexcept {
  if (x.exponent == 0 && y.exponent == 0 && !(x.value > 0 && x.value < 0x1p-900)) [[likely]]
    return x.value / y.value;
  const area::Measure s = area::standard(x), t = area::standard(y);
  const double high = s.value / t.value, low = std::fma(-high, t.value, s.value) / t.value;
  return arithmetic::scale_rounded(high, low, s.exponent - t.exponent);
}

inline const area::Measure& divisor(Ratio which, const Facts& a, const Facts& b) noexcept {
  if (which == Ratio::over_smaller) return area::less(b.area, a.area) ? b.area : a.area;
  return which == Ratio::over_first ? a.area : b.area;
}

/// True if a shared area as a double (NaN if there is none) suffices for its share of another: 0 may be what a small
/// area underflows to; over an area of 1 or more its share would, too.
inline bool tells_share(double shared, const area::Measure& whole) noexcept {
  return shared == 0 ? !area::less(whole, {1, 0}) : shared >= 0x1p-900;
}

/// The shared area of valid shapes, also beyond the range of doubles.
template <class A, class B>
area::Measure shared_measure(const A& a, const B& b) noexcept {
  if constexpr (!in_order<A, B>) {
    return shared_measure(b, a);
  } else {
    area::Measure shared{0, 0};
    detail::shared_measure(a, b, shared);
    return shared;
  }
}

/// (The hull's area - the union's) / the hull's.
inline double empty_share(double r, const Facts& a, const Facts& b) noexcept {
  const Hull h = hull(a, b);
  const int unit = h.unit_x + h.unit_y;
  const double sum = area::in_units(a.area, unit) + area::in_units(b.area, unit);
  return std::fmax(0, 1 - sum / (1 + r) / (h.width * h.height));
}

/// (Distance of the centres / diagonal of the hull)^2.
inline double distance_share(const Facts& a, const Facts& b) noexcept {
  Hull h = hull(a, b);
  if (const int less = h.unit_x - h.unit_y; less < 0) {
    h.dx = arithmetic::scale_far(h.dx, less), h.width = arithmetic::scale_far(h.width, less);
  } else if (less > 0) {
    h.dy = arithmetic::scale_far(h.dy, -less), h.height = arithmetic::scale_far(h.height, -less);
  }
  const double diagonal = h.width * h.width + h.height * h.height;
  const double least = std::fmax(0x1p-500, 0x1p-400 * std::fmax(h.width, h.height));
  if (std::fmax(std::fabs(h.dx), std::fabs(h.dy)) >= least) return (h.dx * h.dx + h.dy * h.dy) / diagonal;
  // Squares would underflow, and lose digits that they keep at another scale.
  const double dx = h.dx * 0x1p500, dy = h.dy * 0x1p500;
  return (dx * dx + dy * dy) / diagonal * 0x1p-500 * 0x1p-500;
}

/// Half lengths along and across the axis; of a shape without size (0, 0).
struct Sides {
  double along, across;
};
inline Sides sides(const Facts& s) noexcept {
  if (s.radius > 0) {
    const int axis = arithmetic::exponent_of(std::fmax(std::fabs(s.ux), std::fabs(s.uy)));
    const double ux = arithmetic::scale_far(s.ux, -axis), uy = arithmetic::scale_far(s.uy, -axis);
    const double length = std::sqrt(ux * ux + uy * uy);
    const int unit = std::max(
        {form::length_exponent(s.along, axis), form::length_exponent(s.across, axis), form::length_exponent(s.radius)});
    const double radius = arithmetic::scale_far(s.radius, -unit);
    return {arithmetic::scale_far(s.along, axis - unit) * length + radius,
            arithmetic::scale_far(s.across, axis - unit) * length + radius};
  }
  if (s.ux == 0 && s.uy == 0) return {0, 0};
  const double most = std::fmax(s.along, s.across);
  if (is_moderate(most)) return {s.along, s.across};
  const int exponent = arithmetic::exponent_of(most);
  return {arithmetic::scale_far(s.along, -exponent), arithmetic::scale_far(s.across, -exponent)};
}

/// CIoU's penalty for unlike ratios of width to height.
inline double aspect_share(double r, const Facts& a, const Facts& b) noexcept {
  const Sides p = sides(a), q = sides(b);
  const double cross = std::fabs(p.along * q.across - q.along * p.across);
  const double angle = arithmetic::angle_of(p.across * q.across + p.along * q.along, cross) / arithmetic::right_angle,
               v = angle * angle;
  return v == 0 ? 0 : v * (v / ((1 - r) + v));
}

/// From IoU.
inline double less_than_union(double r, Ratio which, const Facts& a, const Facts& b) noexcept {
  switch (which) {
    case Ratio::generalized:
      return r - empty_share(r, a, b);
    case Ratio::distance:
      return r - distance_share(a, b);
    case Ratio::complete:
      return r - distance_share(a, b) - aspect_share(r, a, b);
    default:
      return r;
  }
}

/// From the shared area. Returns 0 or error_argument.
inline std::int32_t over_area(const area::Measure& shared, Ratio which, const Facts& a, const Facts& b,
                              double& out) noexcept {
  const area::Measure& whole = divisor(which, a, b);
  if (whole.value == 0) return error_argument;
  out = std::fmin(1, quotient(shared, whole));
  return 0;
}

}  // namespace detail::ratio

/// The checked form: writes the ratio. Returns 0, error_shape, or error_argument for a `which` that is no Ratio, and
/// where the divisor is 0: the area of a shape for those over it, else the areas of both. On error `out` is untouched.
/// A float is the double rounded.
template <template <class> class A, template <class> class B, class T>
std::int32_t ratio_or_error(Ratio which, const A<T>& a, const B<T>& b, T& out) noexcept {
  if (!is_ratio(static_cast<std::int32_t>(which))) return error_argument;
  if (check(a) != 0 || check(b) != 0) return error_shape;
  const auto first = widen(a);
  const auto second = widen(b);
  const auto facts = [](const auto& shape) { return detail::ratio::facts(shape, shape_area(shape)); };
  double result = 0;
  std::int32_t error;
  if (detail::ratio::is_of_area(which)) {
    error = detail::ratio::over_area(detail::ratio::shared_measure(first, second), which, facts(first), facts(second),
                                     result);
  } else {
    error = iou_or_error(first, second, result);
    if (error == 0 && which != Ratio::over_union) {
      result = detail::ratio::less_than_union(result, which, facts(first), facts(second));
    }
  }
  if (error == 0) out = static_cast<T>(result);
  return error;
}

/// The ratio. For valid shapes: it is 0 where ratio_or_error(), the checked form, returns an error.
template <template <class> class A, template <class> class B, class T>
T ratio(Ratio which, const A<T>& a, const B<T>& b) noexcept {
  T out = 0;
  ratio_or_error(which, a, b, out);
  return out;
}

}  // namespace vesica

// SPDX-License-Identifier: Apache-2.0
/// The one mapping from each shape to its form, a box or an ellipse { C + s u + t perp(u) } with an axis u and half
/// sizes hx along it and hy across it. A new shape needs one function of() here; the exact stage, the filters and the
/// placements in double follow from it.
///
/// The mapping computes nothing. It says from which stored numbers each number of the form is made. Each stage computes
/// them in its own arithmetic: exact, rounded, lanes of a vector, twofolds or double-doubles.
#pragma once

#include <type_traits>
#include <utility>
#include <vesica/shapes.hpp>

namespace vesica::detail::form {

/// A centre that is stored.
template <class V>
struct Centre {
  V x, y;
};
/// Two stored points whose mean is the centre. The mean itself need not be a double.
template <class V>
struct Corners {
  V x0, y0, x1, y1;
};

/// A stored length.
template <class V>
struct Length {
  V x;
};
/// A stored size in units of the axis, which does not change when all lengths are scaled.
template <class V>
struct Ratio {
  V x;
};
/// The difference of two stored coordinates.
template <class V>
struct Difference {
  V to, from;
};
/// A known number in units of the axis.
struct Constant {
  float x;
};
/// Half the difference of two stored coordinates, beside an axis of length 1. Only exact numbers are halved; elsewhere
/// the axis has length 1/2 and the width is whole, so that nothing is lost among subnormals and min > max shows.
template <class V>
struct HalfWidth {
  V to, from;
};
/// The axis that goes with half widths.
struct WidthAxis {};

enum class Outline {
  straight,  ///< |s| <= hx and |t| <= hy
  round,     ///< (s / hx)^2 + (t / hy)^2 <= 1
  disc,      ///< round, with hx = hy = r and an axis of length 1
};

template <class Part>
inline constexpr bool is_difference = false;
template <class V>
inline constexpr bool is_difference<Difference<V>> = true;

template <class Place>
inline constexpr bool is_corners = false;
template <class V>
inline constexpr bool is_corners<Corners<V>> = true;

template <class Axis>
inline constexpr bool is_fixed_axis = false;
template <>
inline constexpr bool is_fixed_axis<Constant> = true;
template <>
inline constexpr bool is_fixed_axis<WidthAxis> = true;

template <Outline outline_, class Place, class Ux, class Uy, class Size>
struct Form {
  static constexpr Outline outline = outline_;
  /// A difference of end points is 0 for a segment of no length; the stages that need an axis then take any.
  static constexpr bool axis_may_vanish = is_difference<Ux>;
  static constexpr bool has_corners = is_corners<Place>;
  /// It may have an area: its size across is no constant.
  static constexpr bool has_area = !std::is_same_v<Size, Constant>;
  /// Along the coordinate axes, whatever its numbers are.
  static constexpr bool is_upright = outline_ == Outline::straight && is_fixed_axis<Ux>;
  Place place;
  Ux ux;
  Uy uy;
  Size hx, hy;
};

template <Outline outline, class Place, class Ux, class Uy, class Size>
VESICA_INLINE constexpr Form<outline, Place, Ux, Uy, Size> make(const Place& place, Ux ux, Uy uy, Size hx,
                                                                Size hy) noexcept {
  return {place, ux, uy, hx, hy};
}

template <class V>
VESICA_INLINE constexpr auto of(const Point<V>& s) noexcept {
  return make<Outline::straight>(Centre<V>{s.x, s.y}, Constant{1}, Constant{0}, Constant{0}, Constant{0});
}
/// The axis is the difference of the end points and the half extent 1/2.
template <class V>
VESICA_INLINE constexpr auto of(const Segment<V>& s) noexcept {
  return make<Outline::straight>(Corners<V>{s.x0, s.y0, s.x1, s.y1}, Difference<V>{s.x1, s.x0},
                                 Difference<V>{s.y1, s.y0}, Constant{0.5f}, Constant{0});
}
template <class V>
VESICA_INLINE constexpr auto of(const Circle<V>& s) noexcept {
  return make<Outline::disc>(Centre<V>{s.cx, s.cy}, Constant{1}, Constant{0}, Length<V>{s.r}, Length<V>{s.r});
}
template <class V>
VESICA_INLINE constexpr auto of(const Aabb<V>& s) noexcept {
  return make<Outline::straight>(Corners<V>{s.min_x, s.min_y, s.max_x, s.max_y}, WidthAxis{}, Constant{0},
                                 HalfWidth<V>{s.max_x, s.min_x}, HalfWidth<V>{s.max_y, s.min_y});
}
template <class V>
VESICA_INLINE constexpr auto of(const Rect<V>& s) noexcept {
  return make<Outline::straight>(Centre<V>{s.cx, s.cy}, Length<V>{s.ux}, Length<V>{s.uy}, Ratio<V>{s.hx},
                                 Ratio<V>{s.hy});
}
template <class V>
VESICA_INLINE constexpr auto of(const Ellipse<V>& s) noexcept {
  return make<Outline::round>(Centre<V>{s.cx, s.cy}, Length<V>{s.ux}, Length<V>{s.uy}, Ratio<V>{s.a}, Ratio<V>{s.b});
}

template <class Shape>
concept HasForm = requires(const Shape& shape) {
  of(shape);
};

template <class Shape>
using FormOf = decltype(of(std::declval<const Shape&>()));

/// The parts of a form as numbers of the stored type, differences rounded.
template <class V>
struct AsStored {
  VESICA_INLINE constexpr V operator()(const Length<V>& l) const noexcept { return l.x; }
  VESICA_INLINE constexpr V operator()(const Ratio<V>& r) const noexcept { return r.x; }
  VESICA_INLINE constexpr V operator()(const Difference<V>& d) const noexcept { return d.to - d.from; }
  VESICA_INLINE constexpr V operator()(const HalfWidth<V>& w) const noexcept { return w.to - w.from; }
  VESICA_INLINE constexpr V operator()(Constant c) const noexcept { return V(c.x); }
  VESICA_INLINE constexpr V operator()(WidthAxis) const noexcept { return V(0.5f); }
};

/// A place as two points.
template <class V>
constexpr const Corners<V>& corners(const Corners<V>& p) noexcept {
  return p;
}
template <class V>
constexpr Corners<V> corners(const Centre<V>& p) noexcept {
  return {p.x, p.y, p.x, p.y};
}

}  // namespace vesica::detail::form

// SPDX-License-Identifier: Apache-2.0
/// Plane vectors. Directions are kept as unit vectors and never as angles, so no answer depends on the trigonometric
/// functions of a mathematics library.
#pragma once

#include <vesica/scalar.hpp>

namespace vesica::detail::support_minimum {

template <class V>
struct PlaneVectorOf {
  V x, y;
};
using PlaneVector = PlaneVectorOf<double>;

template <class V>
VESICA_INLINE PlaneVectorOf<V> operator+(const PlaneVectorOf<V>& v, const PlaneVectorOf<V>& w) noexcept {
  return {v.x + w.x, v.y + w.y};
}
inline PlaneVector operator-(const PlaneVector& v) noexcept { return {-v.x, -v.y}; }
template <class V>
VESICA_INLINE PlaneVectorOf<V> operator*(std::type_identity_t<V> k, const PlaneVectorOf<V>& v) noexcept {
  return {k * v.x, k * v.y};
}
inline double dot(const PlaneVector& v, const PlaneVector& w) noexcept { return v.x * w.x + v.y * w.y; }
inline double cross(const PlaneVector& v, const PlaneVector& w) noexcept { return v.x * w.y - v.y * w.x; }
inline PlaneVector perp(const PlaneVector& v) noexcept { return {-v.y, v.x}; }

/// v at unit length; its larger component must be within 2^+-500.
inline PlaneVector unit(const PlaneVector& v) noexcept {
  const double length = lane::sqrt(v.x * v.x + v.y * v.y);
  return {v.x / length, v.y / length};
}

/// The same for any finite v but 0.
inline PlaneVector unit_of_any(const PlaneVector& v) noexcept {
  const double size = lane::max(lane::abs(v.x), lane::abs(v.y));
  return unit({v.x / size, v.y / size});
}

/// From the frame whose first axis is `axis` to the one that is given in, and back.
inline PlaneVector out_of_frame(const PlaneVector& axis, const PlaneVector& v) noexcept {
  return {v.x * axis.x - v.y * axis.y, v.x * axis.y + v.y * axis.x};
}
inline PlaneVector into_frame(const PlaneVector& axis, const PlaneVector& v) noexcept {
  return {dot(axis, v), cross(axis, v)};
}

}  // namespace vesica::detail::support_minimum

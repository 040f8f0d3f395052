// SPDX-License-Identifier: Apache-2.0
/// Plane vectors, most of them unit vectors: directions are kept as such and never as angles, so that no answer hangs
/// on a mathematics library.
#pragma once

#include <vesica/scalar.hpp>

namespace vesica::outline {

struct Vector {
  double x, y;
};

inline Vector operator+(const Vector& v, const Vector& w) noexcept { return {v.x + w.x, v.y + w.y}; }
inline Vector operator-(const Vector& v) noexcept { return {-v.x, -v.y}; }
inline Vector operator*(double k, const Vector& v) noexcept { return {k * v.x, k * v.y}; }
inline double dot(const Vector& v, const Vector& w) noexcept { return v.x * w.x + v.y * w.y; }
inline double cross(const Vector& v, const Vector& w) noexcept { return v.x * w.y - v.y * w.x; }
inline Vector perp(const Vector& v) noexcept { return {-v.y, v.x}; }

/// v at unit length; its larger component must be within 2^+-500.
inline Vector unit(const Vector& v) noexcept {
  const double length = lane::sqrt(v.x * v.x + v.y * v.y);
  return {v.x / length, v.y / length};
}

/// The same for any finite v but 0.
inline Vector unit_of_any(const Vector& v) noexcept {
  const double size = lane::max(lane::abs(v.x), lane::abs(v.y));
  return unit({v.x / size, v.y / size});
}

/// From the frame whose first axis is `axis` to the one that is given in, and back.
inline Vector out_of_frame(const Vector& axis, const Vector& v) noexcept {
  return {v.x * axis.x - v.y * axis.y, v.x * axis.y + v.y * axis.x};
}
inline Vector into_frame(const Vector& axis, const Vector& v) noexcept { return {dot(axis, v), cross(axis, v)}; }

}  // namespace vesica::outline

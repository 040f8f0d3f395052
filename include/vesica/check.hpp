// SPDX-License-Identifier: Apache-2.0
/// Is a shape valid, and if not, which rule does it break? Rules are checked in the order of their error codes.
#pragma once

#include <vesica/shapes.hpp>

namespace vesica {

namespace detail {

template <class Shape>
constexpr bool finite(const Shape& s) noexcept {
  return with_numbers(s, [](auto... numbers) { return all_finite(numbers...); });
}

template <class T>
constexpr int check_axis_and_sizes(T ux, T uy, T size_0, T size_1) noexcept {
  if (size_0 < 0 || size_1 < 0) return error_negative_size;
  if (ux == 0 && uy == 0) return error_zero_axis;
  return 0;
}

}  // namespace detail

/// 0 when valid, else error_not_finite, error_negative_size, error_zero_axis or error_inverted.
template <class T>
constexpr int check(const Point<T>& s) noexcept {
  return detail::finite(s) ? 0 : error_not_finite;
}

template <class T>
constexpr int check(const Segment<T>& s) noexcept {
  return detail::finite(s) ? 0 : error_not_finite;
}

template <class T>
constexpr int check(const Circle<T>& s) noexcept {
  if (!detail::finite(s)) return error_not_finite;
  return s.r < 0 ? error_negative_size : 0;
}

template <class T>
constexpr int check(const Aabb<T>& s) noexcept {
  if (!detail::finite(s)) return error_not_finite;
  return s.min_x > s.max_x || s.min_y > s.max_y ? error_inverted : 0;
}

template <class T>
constexpr int check(const Rect<T>& s) noexcept {
  if (!detail::finite(s)) return error_not_finite;
  return detail::check_axis_and_sizes(s.ux, s.uy, s.hx, s.hy);
}

template <class T>
constexpr int check(const Ellipse<T>& s) noexcept {
  if (!detail::finite(s)) return error_not_finite;
  return detail::check_axis_and_sizes(s.ux, s.uy, s.a, s.b);
}

template <class T>
constexpr int check(const Capsule<T>& s) noexcept {
  if (!detail::finite(s)) return error_not_finite;
  return s.r < 0 ? error_negative_size : 0;
}

template <class T>
constexpr int check(const RoundRect<T>& s) noexcept {
  if (!detail::finite(s)) return error_not_finite;
  return s.r < 0 ? error_negative_size : detail::check_axis_and_sizes(s.ux, s.uy, s.hx, s.hy);
}

}  // namespace vesica

// SPDX-License-Identifier: Apache-2.0
/// The library's C structs from C++: spans for arrays, exceptions for errors. (include/vesica is the C++ core itself.)
#pragma once

#include <vesica.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>

namespace shapes {

class Error : public std::runtime_error {
 public:
  explicit Error(std::int32_t error) : std::runtime_error(vesica_strerror(error)), code(error) {}
  const std::int32_t code;
};

/// The answer, or the error thrown.
template <class Integer>
Integer checked(Integer answer) {
  return answer < 0 ? throw Error(static_cast<std::int32_t>(answer)) : answer;
}

/// Once, before the first call.
inline void require_version() {
  if (vesica_version() < VESICA_VERSION)
    throw std::runtime_error("vesica " + std::to_string(vesica_version()) + " is older than " +
                             std::to_string(VESICA_VERSION));
}

template <class Shape>
constexpr std::int32_t kind = VESICA_E_KIND;
template <>
inline constexpr std::int32_t kind<vesica_point_f64> = VESICA_POINT;
template <>
inline constexpr std::int32_t kind<vesica_segment_f64> = VESICA_SEGMENT;
template <>
inline constexpr std::int32_t kind<vesica_circle_f64> = VESICA_CIRCLE;
template <>
inline constexpr std::int32_t kind<vesica_aabb_f64> = VESICA_AABB;
template <>
inline constexpr std::int32_t kind<vesica_rect_f64> = VESICA_RECT;
template <>
inline constexpr std::int32_t kind<vesica_ellipse_f64> = VESICA_ELLIPSE;
template <>
inline constexpr std::int32_t kind<vesica_capsule_f64> = VESICA_CAPSULE;
template <>
inline constexpr std::int32_t kind<vesica_round_rect_f64> = VESICA_ROUND_RECT;

/// Do two shapes share a point? Touching counts.
template <class A, class B>
bool overlap(const A& a, const B& b) {
  static_assert(kind<A> >= 0 && kind<B> >= 0, "not a shape");
  return checked(vesica_overlap_f64(kind<A>, reinterpret_cast<const double*>(&a), kind<B>,
                                    reinterpret_cast<const double*>(&b))) == 1;
}

inline void need(std::int32_t kind, std::size_t count) {
  if (count < static_cast<std::size_t>(checked(vesica_field_count(kind))))
    throw std::length_error("too few numbers for a shape");
}

/// The same of flat numbers, whose kinds are known at run time only.
inline bool overlap(std::int32_t kind_a, std::span<const double> a, std::int32_t kind_b, std::span<const double> b) {
  need(kind_a, a.size()), need(kind_b, b.size());
  return checked(vesica_overlap_f64(kind_a, a.data(), kind_b, b.data())) == 1;
}
inline bool overlap(std::int32_t kind_a, std::span<const float> a, std::int32_t kind_b, std::span<const float> b) {
  need(kind_a, a.size()), need(kind_b, b.size());
  return checked(vesica_overlap_f32(kind_a, a.data(), kind_b, b.data())) == 1;
}

/// How far apart are two shapes, and which of their points are closest?
template <class A, class B>
vesica_closest_points_f64 nearest(const A& a, const B& b) {
  static_assert(kind<A> >= 0 && kind<B> >= 0, "not a shape");
  vesica_closest_points_f64 out;
  checked(vesica_nearest_f64(kind<A>, reinterpret_cast<const double*>(&a), kind<B>, reinterpret_cast<const double*>(&b),
                             &out));
  return out;
}

template <class Shape>
vesica_shapes_f64 array(std::span<const Shape> shapes) {
  static_assert(kind<Shape> >= 0, "not a shape");
  vesica_shapes_f64 out;
  const auto count = static_cast<std::int64_t>(shapes.size());
  checked(vesica_shapes_from_records_f64(kind<Shape>, count, shapes.data(), sizeof(Shape), &out));
  return out;
}

/// Two arrays in step, or one shape against an array: out[i] is 1 where they overlap, else 0; returns how many are 1.
/// Throws if a shape is invalid. Then out has 0 for that shape, and the answers for all others.
template <class A, class B>
std::int64_t overlap_many(std::span<const A> a, std::span<const B> b, std::span<std::uint8_t> out) {
  if (out.size() < (a.empty() || b.empty() ? 0 : std::max(a.size(), b.size())))
    throw std::length_error("out is too short");
  const vesica_shapes_f64 shapes_a = array(a), shapes_b = array(b);
  return checked(vesica_overlap_many_f64(&shapes_a, &shapes_b, out.data()));
}

}  // namespace shapes

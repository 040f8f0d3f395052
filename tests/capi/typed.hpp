// SPDX-License-Identifier: Apache-2.0
/// The typed functions of the C face, callable with flat numbers, so that one test body can serve all 21 pairs.
#pragma once

#include <vesica.h>

#include <cstdint>
#include <cstring>

namespace capi {

/// Kind and scalar of a C struct.
template <class Struct>
struct KindOf;

template <>
struct KindOf<vesica_point_f64> {
  using Scalar = double;
  static constexpr std::int32_t kind = VESICA_POINT;
};
template <>
struct KindOf<vesica_segment_f64> {
  using Scalar = double;
  static constexpr std::int32_t kind = VESICA_SEGMENT;
};
template <>
struct KindOf<vesica_circle_f64> {
  using Scalar = double;
  static constexpr std::int32_t kind = VESICA_CIRCLE;
};
template <>
struct KindOf<vesica_aabb_f64> {
  using Scalar = double;
  static constexpr std::int32_t kind = VESICA_AABB;
};
template <>
struct KindOf<vesica_rect_f64> {
  using Scalar = double;
  static constexpr std::int32_t kind = VESICA_RECT;
};
template <>
struct KindOf<vesica_ellipse_f64> {
  using Scalar = double;
  static constexpr std::int32_t kind = VESICA_ELLIPSE;
};
template <>
struct KindOf<vesica_point_f32> {
  using Scalar = float;
  static constexpr std::int32_t kind = VESICA_POINT;
};
template <>
struct KindOf<vesica_segment_f32> {
  using Scalar = float;
  static constexpr std::int32_t kind = VESICA_SEGMENT;
};
template <>
struct KindOf<vesica_circle_f32> {
  using Scalar = float;
  static constexpr std::int32_t kind = VESICA_CIRCLE;
};
template <>
struct KindOf<vesica_aabb_f32> {
  using Scalar = float;
  static constexpr std::int32_t kind = VESICA_AABB;
};
template <>
struct KindOf<vesica_rect_f32> {
  using Scalar = float;
  static constexpr std::int32_t kind = VESICA_RECT;
};
template <>
struct KindOf<vesica_ellipse_f32> {
  using Scalar = float;
  static constexpr std::int32_t kind = VESICA_ELLIPSE;
};

/// A typed function of two shapes, as its structs and as a function of flat numbers. NULL is passed on as NULL.
template <auto function>
struct Typed;

template <class First, class Second, std::int32_t (*function)(const First*, const Second*)>
struct Typed<function> {
  using A = First;
  using B = Second;
  using Scalar = typename KindOf<A>::Scalar;
  static constexpr std::int32_t kind_a = KindOf<A>::kind;
  static constexpr std::int32_t kind_b = KindOf<B>::kind;

  static std::int32_t call(const Scalar* numbers_a, const Scalar* numbers_b) {
    A a{};
    B b{};
    if (numbers_a != nullptr) std::memcpy(&a, numbers_a, sizeof a);
    if (numbers_b != nullptr) std::memcpy(&b, numbers_b, sizeof b);
    return function(numbers_a != nullptr ? &a : nullptr, numbers_b != nullptr ? &b : nullptr);
  }
};

}  // namespace capi

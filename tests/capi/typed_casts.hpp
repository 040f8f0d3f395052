// SPDX-License-Identifier: Apache-2.0
/// The typed casts of the C interface, callable with flat numbers, which are passed on as they lie.
#pragma once

#include "capi/typed.hpp"

namespace capi {

template <class T, class Impact>
struct TypedCast {
  std::int32_t kind_a, kind_b;
  std::int32_t (*cast)(const T*, const T*, T, T, T, Impact*);
};

template <auto function>
struct TypedCastOf;
template <class A, class B, class T, class Impact, std::int32_t (*function)(const A*, const B*, T, T, T, Impact*)>
struct TypedCastOf<function> {
  static std::int32_t call(const T* a, const T* b, T vx, T vy, T t_end, Impact* out) {
    return function(reinterpret_cast<const A*>(a), reinterpret_cast<const B*>(b), vx, vy, t_end, out);
  }
  static constexpr TypedCast<T, Impact> entry{KindOf<A>::kind, KindOf<B>::kind, call};
};

#define VESICA_CASTS(s)                                                                                  \
  TypedCastOf<vesica_cast_point_point_##s>::entry, TypedCastOf<vesica_cast_segment_point_##s>::entry,    \
      TypedCastOf<vesica_cast_circle_point_##s>::entry, TypedCastOf<vesica_cast_aabb_point_##s>::entry,  \
      TypedCastOf<vesica_cast_rect_point_##s>::entry, TypedCastOf<vesica_cast_ellipse_point_##s>::entry, \
      TypedCastOf<vesica_cast_circle_circle_##s>::entry, TypedCastOf<vesica_cast_rect_rect_##s>::entry
inline constexpr TypedCast<double, vesica_impact_f64> typed_casts_f64[] = {VESICA_CASTS(f64)};
inline constexpr TypedCast<float, vesica_impact_f32> typed_casts_f32[] = {VESICA_CASTS(f32)};
#undef VESICA_CASTS

/// The calls of one scalar type.
inline const auto& typed_casts(double) { return typed_casts_f64; }
inline const auto& typed_casts(float) { return typed_casts_f32; }

}  // namespace capi

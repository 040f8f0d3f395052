// SPDX-License-Identifier: Apache-2.0
/// The typed overlap functions, which pairs of shapes with a form have.
#pragma once

#include <vesica/each_shape.hpp>

#include "capi/typed.hpp"

namespace capi {

template <class T>
struct TypedPair {
  std::int32_t kind_a, kind_b;
  std::int32_t (*overlap)(const T*, const T*);
};

template <auto function>
constexpr auto typed_pair() {
  return TypedPair<typename Typed<function>::Scalar>{Typed<function>::kind_a, Typed<function>::kind_b,
                                                     Typed<function>::call};
}

#define VESICA_PAIR_F64(a, A, b, B) typed_pair<vesica_overlap_##a##_##b##_f64>(),
#define VESICA_PAIR_F32(a, A, b, B) typed_pair<vesica_overlap_##a##_##b##_f32>(),
inline constexpr TypedPair<double> typed_pairs_f64[] = {VESICA_EACH_PAIR_OF_FORMS(VESICA_PAIR_F64)};
inline constexpr TypedPair<float> typed_pairs_f32[] = {VESICA_EACH_PAIR_OF_FORMS(VESICA_PAIR_F32)};
#undef VESICA_PAIR_F64
#undef VESICA_PAIR_F32

/// The functions of one scalar type under one name each.
template <class T>
struct Api;

template <>
struct Api<double> {
  using Box = vesica_aabb_f64;
  static constexpr auto check = vesica_check_f64;
  static constexpr auto overlap = vesica_overlap_f64;
  static constexpr auto bounds = vesica_bounds_f64;
  static constexpr const auto& typed_pairs = typed_pairs_f64;
};
template <>
struct Api<float> {
  using Box = vesica_aabb_f32;
  static constexpr auto check = vesica_check_f32;
  static constexpr auto overlap = vesica_overlap_f32;
  static constexpr auto bounds = vesica_bounds_f32;
  static constexpr const auto& typed_pairs = typed_pairs_f32;
};

}  // namespace capi

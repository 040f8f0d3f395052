// SPDX-License-Identifier: Apache-2.0
/// The typed functions of the C interface, callable with flat numbers, so that one test body can serve all pairs.
#pragma once

#include <vesica.h>

#include <cstdint>
#include <cstring>
#include <vesica/each_shape.hpp>
#include <vesica/shapes.hpp>

namespace capi {

/// Kind and scalar of a C struct.
template <class Struct>
struct KindOf;

#define VESICA_SET_KIND(name, Name)                                               \
  template <>                                                                     \
  struct KindOf<vesica_##name##_f64> {                                            \
    using Scalar = double;                                                        \
    static constexpr auto kind = static_cast<std::int32_t>(::vesica::Kind::name); \
  };                                                                              \
  template <>                                                                     \
  struct KindOf<vesica_##name##_f32> {                                            \
    using Scalar = float;                                                         \
    static constexpr auto kind = static_cast<std::int32_t>(::vesica::Kind::name); \
  };
VESICA_EACH_SHAPE(VESICA_SET_KIND)
#undef VESICA_SET_KIND

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

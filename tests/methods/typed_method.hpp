// SPDX-License-Identifier: Apache-2.0
/// A method of the C interface in both scalars as one function of flat numbers, and what it must answer to invalid
/// input.
#pragma once

#include <gtest/gtest.h>
#include <vesica_methods.h>

#include <array>
#include <cstdint>
#include <limits>

#include "capi/typed.hpp"
#include "methods/method_pairs.hpp"

namespace method_pairs {

template <auto f64, auto f32>
std::int32_t call(Scalar scalar, const Pair& pair) {
  if (scalar == Scalar::f64) return capi::Typed<f64>::call(pair.a.data(), pair.b.data());
  const auto a = properties::narrow(pair.a), b = properties::narrow(pair.b);
  return capi::Typed<f32>::call(a.data(), b.data());
}

template <auto f64, auto f32>
Method method(Scalar scalar) {
  return [scalar](const Pair& pair) { return call<f64, f32>(scalar, pair); };
}

/// Numbers of one shape, and what a call with them must answer.
template <auto function>
class InvalidInput {
  using Typed = capi::Typed<function>;
  using T = typename Typed::Scalar;
  using Numbers = properties::NumbersOf<T>;

 public:
  /// NULL before all else, then every field of either shape, not finite, and each rule of its kind.
  static void expect_errors() {
    const Numbers a = valid(Typed::kind_a), b = valid(Typed::kind_b);
    ASSERT_GE(Typed::call(a.data(), b.data()), 0);
    Numbers broken = a;
    broken[0] = std::numeric_limits<T>::quiet_NaN();
    EXPECT_EQ(Typed::call(nullptr, b.data()), VESICA_E_NULL);
    EXPECT_EQ(Typed::call(broken.data(), nullptr), VESICA_E_NULL);
    each_broken(Typed::kind_a, [&](const Numbers& s) { return Typed::call(s.data(), b.data()); });
    each_broken(Typed::kind_b, [&](const Numbers& s) { return Typed::call(a.data(), s.data()); });
  }

 private:
  static Numbers valid(std::int32_t kind) {
    if (kind == VESICA_AABB) return {1, 2, 3, 4};
    return {1, 2, 3, 4, 2, 1};
  }

  template <class Call>
  static void expect_shape_error(std::int32_t kind, std::size_t field, T number, const Call& with) {
    Numbers s = valid(kind);
    s[field] = number;
    EXPECT_EQ(with(s), VESICA_E_SHAPE) << "kind " << kind << " field " << field << " number " << number;
  }

  template <class Call>
  static void each_broken(std::int32_t kind, const Call& with) {
    using Limits = std::numeric_limits<T>;
    const auto fields = static_cast<std::size_t>(vesica_field_count(kind));
    for (std::size_t i = 0; i < fields; ++i) {
      for (const T bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity()}) {
        expect_shape_error(kind, i, bad, with);
      }
    }
    if (kind == VESICA_AABB) expect_shape_error(kind, 2, T{0}, with);
    if (kind == VESICA_CIRCLE) expect_shape_error(kind, 2, -Limits::denorm_min(), with);
    if (kind < VESICA_RECT) return;
    for (const std::size_t size : {4U, 5U}) expect_shape_error(kind, size, -Limits::denorm_min(), with);
    Numbers s = valid(kind);
    s[2] = s[3] = 0;
    EXPECT_EQ(with(s), VESICA_E_SHAPE) << "kind " << kind << " zero axis";
  }
};

}  // namespace method_pairs

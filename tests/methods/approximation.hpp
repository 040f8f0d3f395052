// SPDX-License-Identifier: Apache-2.0
/// The methods that halve, as functions of two shapes alone, and what all of them must keep.
#pragma once

#include <string>

#include "methods/approximate_method.hpp"

namespace method_pairs {

/// Arguments and result of a function (a, b, n, out).
template <class Function>
struct Halving;
template <class First, class Second, class Result>
struct Halving<std::int32_t (*)(const First*, const Second*, std::int32_t, Result*)> {
  using A = First;
  using B = Second;
  using Out = Result;
};

/// The function with n iterations allowed, and its answer alone.
template <auto function, std::int32_t n>
std::int32_t with_iterations(const typename Halving<decltype(function)>::A* a,
                             const typename Halving<decltype(function)>::B* b) {
  typename Halving<decltype(function)>::Out out;
  return function(a, b, n, &out);
}

template <auto f64, auto f32, std::int32_t n>
Method method_with(Scalar scalar) {
  return method<with_iterations<f64, n>, with_iterations<f32, n>>(scalar);
}

/// Invalid shapes, n out of range, no place for the result; which stays as it is.
template <auto function>
void expect_errors(const typename Halving<decltype(function)>::A& a, const typename Halving<decltype(function)>::B& b) {
  InvalidInput<with_iterations<function, 5>>::expect_errors();
  typename Halving<decltype(function)>::Out out{};
  out.outline_error = 1;
  out.iterations = 2;
  for (const std::int32_t n : {-1, 31, INT32_MIN, INT32_MAX})
    EXPECT_EQ(function(&a, &b, n, &out), VESICA_E_ARGUMENT) << n;
  EXPECT_EQ(function(&a, &b, 5, nullptr), VESICA_E_NULL);
  EXPECT_EQ(function(nullptr, &b, 5, &out), VESICA_E_NULL);
  auto broken = a;
  broken.cx = std::numeric_limits<decltype(broken.cx)>::quiet_NaN();
  EXPECT_EQ(function(&broken, &b, 5, &out), VESICA_E_SHAPE);
  EXPECT_EQ(function(&broken, &b, -1, &out), VESICA_E_SHAPE);
  EXPECT_EQ(out.outline_error, 1);
  EXPECT_EQ(out.iterations, 2);
  for (const std::int32_t n : {0, 1, 30}) EXPECT_GE(function(&a, &b, n, &out), 0) << n;
}

/// Every yes and every no is true, with few, many and too many iterations.
template <auto f64, auto f32>
void expect_never_wrong_with_any_n(const std::string& name, int kind_a, int kind_b) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    expect_never_wrong(name + " n = 2", method_with<f64, f32, 2>(scalar), kind_a, kind_b, scalar, 3000);
    expect_never_wrong(name + " n = 12", method_with<f64, f32, 12>(scalar), kind_a, kind_b, scalar, 9000);
    expect_never_wrong(name + " n = 30", method_with<f64, f32, 30>(scalar), kind_a, kind_b, scalar, 3000);
  }
}

/// With enough iterations nothing of ordinary proportions, 1e-9 off contact, is left uncertain.
inline void expect_decided_beyond_gap(const Method& method, int kind_a, int kind_b) {
  for (const properties::Workload workload : {properties::Workload::random, properties::Workload::far}) {
    properties::Stream stream(workload, kind_a, kind_b, Scalar::f64, properties::seed());
    for (int i = 0; i < 5000 * properties::repeat(); ++i) {
      const Pair pair = stream.next();
      if (method(pair) == VESICA_UNCERTAIN) {
        EXPECT_TRUE(within_gap(pair, 1e-9)) << properties::describe(pair);
      }
    }
  }
}

}  // namespace method_pairs

// SPDX-License-Identifier: Apache-2.0
// The C++ core's own function, which the library does not call, has the bits of the C interface: every ratio, shapes
// in and out of order, with and without an area, in double and in float.
#include <gtest/gtest.h>
#include <vesica.h>

#include <bit>
#include <cstdint>
#include <vesica/ratio.hpp>

#include "filter/inputs.hpp"
#include "properties/generators.hpp"

namespace {

using properties::Pair;

std::int32_t of_library(std::int32_t which, const Pair& p, double& out) {
  return vesica_ratio_f64(which, p.kind_a, p.a.data(), p.kind_b, p.b.data(), &out);
}
std::int32_t of_library(std::int32_t which, const Pair& p, float& out) {
  const auto a = properties::narrow(p.a), b = properties::narrow(p.b);
  return vesica_ratio_f32(which, p.kind_a, a.data(), p.kind_b, b.data(), &out);
}

template <class Shape>
Shape shape(const properties::Numbers& n) {
  if constexpr (sizeof(typename vesica::ShapeTraits<Shape>::Scalar) == sizeof(float)) {
    return inputs::shape_at<Shape>(properties::narrow(n).data());
  } else {
    return inputs::shape_at<Shape>(n.data());
  }
}

template <class A, class B>
void expect_the_same_bits() {
  using T = typename vesica::ShapeTraits<A>::Scalar;
  constexpr auto scalar = sizeof(T) == sizeof(float) ? properties::Scalar::f32 : properties::Scalar::f64;
  constexpr int a = static_cast<int>(vesica::ShapeTraits<A>::kind), b = static_cast<int>(vesica::ShapeTraits<B>::kind);
  int above_zero = 0;
  for (const properties::Workload workload : {properties::Workload::random, properties::Workload::degenerate,
                                              properties::Workload::huge, properties::Workload::tiny}) {
    properties::Stream stream(workload, a < b ? a : b, a < b ? b : a, scalar, properties::seed());
    for (int i = 0; i < 200 * properties::repeat(); ++i) {
      const Pair drawn = stream.next(), p = a <= b ? drawn : swapped(drawn);
      for (std::int32_t which = 0; which <= vesica::ratio_count; ++which) {
        T of_core = 7, expected = 7;
        const std::int32_t code =
            vesica::ratio_or_error(static_cast<vesica::Ratio>(which), shape<A>(p.a), shape<B>(p.b), of_core);
        ASSERT_EQ(code, of_library(which, p, expected)) << which << ' ' << properties::describe(p);
        ASSERT_EQ(of_core, expected) << which << ' ' << properties::describe(p);
        above_zero += code == 0 && of_core > 0;
      }
    }
  }
  EXPECT_EQ(above_zero > 0, a > VESICA_SEGMENT && b > VESICA_SEGMENT);
}

TEST(RatioOfTheCore, HasTheBitsOfTheLibrary) {
  expect_the_same_bits<vesica::Rect<double>, vesica::Rect<double>>();
  expect_the_same_bits<vesica::Ellipse<double>, vesica::Aabb<double>>();
  expect_the_same_bits<vesica::Circle<double>, vesica::Ellipse<double>>();
  expect_the_same_bits<vesica::Segment<double>, vesica::Point<double>>();
  expect_the_same_bits<vesica::Rect<float>, vesica::Rect<float>>();
}

/// A quotient of areas times any powers of two; both areas may be beyond doubles, or nearly 0.
TEST(RatioOfTheCore, QuotientsOfMeasures) {
  const auto quotient = [](double x, int power_of_x, double y, int power_of_y) {
    return vesica::detail::ratio::quotient({x, power_of_x}, {y, power_of_y});
  };
  EXPECT_EQ(quotient(6, 0, 3, 0), 2);
  EXPECT_EQ(quotient(6, -1500, 3, -1490), 0x1p-9);
  EXPECT_EQ(quotient(6, 0, 3, 1000), 0x1p-999);
  EXPECT_EQ(quotient(6, 1020, 3, 0), 0x1p1021);
  EXPECT_EQ(quotient(0x1p-950, 0, 0x1p-940, 0), 0x1p-10);
  EXPECT_EQ(quotient(0x1p-950, 0, 1, 0), 0x1p-950);
  EXPECT_EQ(quotient(0, 0, 3, 0), 0);
  EXPECT_EQ(quotient(0, -2000, 3, 1000), 0);
  EXPECT_EQ(quotient(6, -1500, 3, 0), 0) << "too small";
}

}  // namespace

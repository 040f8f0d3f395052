// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <vesica/methods/rect_rect_bounds.hpp>

#include "methods/approximate_method.hpp"

namespace rect_rect_bounds_test {
namespace {

using namespace method_pairs;

constexpr auto f64 = vesica_method_rect_rect_bounds_f64;
constexpr auto f32 = vesica_method_rect_rect_bounds_f32;

std::int32_t answer(const vesica_rect_f64& a, const vesica_rect_f64& b) { return f64(&a, &b); }
std::int32_t answer(const vesica_rect_f32& a, const vesica_rect_f32& b) { return f32(&a, &b); }

TEST(RectRectBounds, KnownAnswers) {
  EXPECT_EQ(answer(vesica_rect_f64{0, 0, 1, 0, 1, 1}, vesica_rect_f64{3, 0, 1, 0, 1, 1}), VESICA_NO);
  EXPECT_EQ(answer(vesica_rect_f64{0, 0, 1, 0, 1, 1}, vesica_rect_f64{0, -3, 0, 2, 0.5, 1}), VESICA_NO);
  EXPECT_EQ(answer(vesica_rect_f64{0, 0, 1, 0, 1, 1}, vesica_rect_f64{2, 0, 1, 0, 1, 1}), VESICA_UNCERTAIN);
  EXPECT_EQ(answer(vesica_rect_f64{0, 0, 1, 0, 1, 1}, vesica_rect_f64{0, 0, 1, 0, 1, 1}), VESICA_UNCERTAIN);
  // Boxes of diamonds meet before the diamonds do: (1, 1) / 2 with half extents 1 reaches to 1 along x and y.
  EXPECT_EQ(answer(vesica_rect_f64{0, 0, 0.5, 0.5, 1, 1}, vesica_rect_f64{1.5, 1.5, 0.5, 0.5, 1, 1}), VESICA_UNCERTAIN);
  EXPECT_EQ(answer(vesica_rect_f64{0, 0, 0.5, 0.5, 1, 1}, vesica_rect_f64{2.25, 1.5, 0.5, 0.5, 1, 1}), VESICA_NO);
  EXPECT_EQ(answer(vesica_rect_f32{0, 0, 3, 4, 1, 1}, vesica_rect_f32{14.25F, 0, 4, 3, 1, 1}), VESICA_NO);
  EXPECT_EQ(answer(vesica_rect_f32{0, 0, 3, 4, 1, 1}, vesica_rect_f32{13.75F, 0, 4, 3, 1, 1}), VESICA_UNCERTAIN);
}

// Half widths 1 and 1: the bound is 16 roundoffs of 2, which is 2^-48 (2^-19); twice that is decided.
TEST(RectRectBounds, NarrowestNo) {
  EXPECT_EQ(answer(vesica_rect_f64{0, 0, 1, 0, 1, 1}, vesica_rect_f64{2 + 0x1p-47, 0, 1, 0, 1, 1}), VESICA_NO);
  EXPECT_EQ(answer(vesica_rect_f32{0, 0, 1, 0, 1, 1}, vesica_rect_f32{2 + 0x1p-18F, 0, 1, 0, 1, 1}), VESICA_NO);
  EXPECT_EQ(answer(vesica_rect_f64{0, 0, 1, 0, 1, 1}, vesica_rect_f64{2 + 0x1p-51, 0, 1, 0, 1, 1}), VESICA_UNCERTAIN);
  constexpr double least = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(answer(vesica_rect_f64{0, 0, 1, 0, 0, 0}, vesica_rect_f64{9 * least, 0, 1, 0, 0, 0}), VESICA_NO);
  EXPECT_EQ(answer(vesica_rect_f64{0, 0, 1, 0, 0, 0}, vesica_rect_f64{0, 0, 1, 0, 0, 0}), VESICA_UNCERTAIN);
}

TEST(RectRectBounds, BeyondTheRange) {
  constexpr double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(answer(vesica_rect_f64{-largest, 0, 1, 0, 1, 1}, vesica_rect_f64{largest, 0, 1, 0, 1, 1}), VESICA_NO);
  EXPECT_EQ(answer(vesica_rect_f64{-largest, 0, 1, 0, largest, 1}, vesica_rect_f64{largest, 0, 1, 0, largest, 1}),
            VESICA_UNCERTAIN);
  EXPECT_EQ(answer(vesica_rect_f64{0, 0, largest, 0, largest, 1}, vesica_rect_f64{largest, 0, 1, 0, 1, 1}),
            VESICA_UNCERTAIN);
}

TEST(RectRectBounds, InvalidInput) {
  InvalidInput<f64>::expect_errors();
  InvalidInput<f32>::expect_errors();
}

TEST(RectRectBounds, EveryNoIsTrue) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    expect_never_wrong("rect_rect_bounds", method<f64, f32>(scalar), VESICA_RECT, VESICA_RECT, scalar, 25000);
  }
}

// The stated bound: where it is uncertain, boxes 32 roundoffs of their size larger meet. Where they do not, it says no.
TEST(RectRectBounds, UncertainIsNearOrMeets) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    const double larger = 1 + (scalar == Scalar::f64 ? 0x1p-48 : 0x1p-19);
    properties::Stream stream(properties::Workload::random, VESICA_RECT, VESICA_RECT, scalar, properties::seed());
    int apart = 0;
    for (int i = 0; i < 20000 * properties::repeat(); ++i) {
      const Pair pair = stream.next();
      vesica_aabb_f64 a, b;
      ASSERT_EQ(vesica_bounds_f64(VESICA_RECT, pair.a.data(), &a), 0);
      ASSERT_EQ(vesica_bounds_f64(VESICA_RECT, pair.b.data(), &b), 0);
      const bool meet =
          std::abs(pair.a[0] - pair.b[0]) <= larger * ((a.max_x - a.min_x) / 2 + (b.max_x - b.min_x) / 2) &&
          std::abs(pair.a[1] - pair.b[1]) <= larger * ((a.max_y - a.min_y) / 2 + (b.max_y - b.min_y) / 2);
      if (meet) continue;
      ++apart;
      ASSERT_EQ((call<f64, f32>(scalar, pair)), VESICA_NO) << properties::describe(pair);
    }
    EXPECT_GT(apart, 2000 * properties::repeat());
  }
}

}  // namespace
}  // namespace rect_rect_bounds_test

// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <vesica/methods/rect_corners.hpp>

#include "methods/typed_method.hpp"

namespace rect_corners_test {
namespace {

using namespace method_pairs;

TEST(RectCorners, KnownCorners) {
  const vesica_rect_f64 rect{10, 20, 3, 4, 2, 1};
  double out[8];
  ASSERT_EQ(vesica_method_rect_corners_f64(&rect, out), 0);
  // C -+ 2 (3, 4) -+ (-4, 3).
  const double expected[8] = {8, 9, 20, 25, 12, 31, 0, 15};
  for (int i = 0; i < 8; ++i) EXPECT_EQ(out[i], expected[i]) << i;
  const vesica_rect_f32 upright{1, 2, 0, 1, 4, 0.5F};
  float out_f32[8];
  ASSERT_EQ(vesica_method_rect_corners_f32(&upright, out_f32), 0);
  const float expected_f32[8] = {1.5F, -2, 1.5F, 6, 0.5F, 6, 0.5F, -2};
  for (int i = 0; i < 8; ++i) EXPECT_EQ(out_f32[i], expected_f32[i]) << i;
}

TEST(RectCorners, ZeroSizes) {
  const vesica_rect_f64 segment{1, 1, 2, 0, 3, 0}, point{5, 6, 1, 1, 0, 0};
  double out[8];
  ASSERT_EQ(vesica_method_rect_corners_f64(&segment, out), 0);
  const double ends[8] = {-5, 1, 7, 1, 7, 1, -5, 1};
  for (int i = 0; i < 8; ++i) EXPECT_EQ(out[i], ends[i]) << i;
  ASSERT_EQ(vesica_method_rect_corners_f64(&point, out), 0);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(out[i], i % 2 == 0 ? 5 : 6) << i;
}

TEST(RectCorners, InvalidInput) {
  const vesica_rect_f64 valid{0, 0, 1, 0, 1, 1}, no_axis{0, 0, 0, 0, 1, 1}, negative{0, 0, 1, 0, 1, -1};
  const vesica_rect_f64 infinite{0, std::numeric_limits<double>::infinity(), 1, 0, 1, 1};
  double out[8] = {1, 2, 3, 4, 5, 6, 7, 8};
  float out_f32[8] = {};
  const vesica_rect_f32 not_finite{0, 0, std::numeric_limits<float>::quiet_NaN(), 0, 1, 1};
  EXPECT_EQ(vesica_method_rect_corners_f64(nullptr, out), VESICA_E_NULL);
  EXPECT_EQ(vesica_method_rect_corners_f64(&valid, nullptr), VESICA_E_NULL);
  for (const vesica_rect_f64& rect : {no_axis, negative, infinite}) {
    EXPECT_EQ(vesica_method_rect_corners_f64(&rect, out), VESICA_E_SHAPE);
  }
  EXPECT_EQ(vesica_method_rect_corners_f32(&not_finite, out_f32), VESICA_E_SHAPE);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(out[i], i + 1);
}

TEST(RectCorners, Range) {
  constexpr double largest = std::numeric_limits<double>::max();
  double out[8] = {1, 2, 3, 4, 5, 6, 7, 8};
  const vesica_rect_f64 beyond{largest, 0, 1, 0, 0x1p1000, 1};
  EXPECT_EQ(vesica_method_rect_corners_f64(&beyond, out), VESICA_E_RANGE);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(out[i], i + 1);
  // Corners at the largest powers of two.
  const vesica_rect_f64 wide{0, 0, 0x1p600, 0, 0x1p423, 0}, tilted{0, 0, 0x1p1023, 0x1p1023, 0.5, 0.5};
  ASSERT_EQ(vesica_method_rect_corners_f64(&wide, out), 0);
  EXPECT_EQ(out[2], 0x1p1023);
  EXPECT_EQ(vesica_method_rect_corners_f64(&tilted, out), 0);
  const double expected[8] = {0, -0x1p1023, 0x1p1023, 0, 0, 0x1p1023, -0x1p1023, 0};
  for (int i = 0; i < 8; ++i) EXPECT_EQ(out[i], expected[i]) << i;
}

// Two terms of 2^1023 each make 2^1024, which is no number; with the centre's -2^1023 they make 2^1023 again.
TEST(RectCorners, SumPassesBeyondTheRange) {
  const vesica_rect_f64 rect{-0x1p1023, 0, 0x1p1022, 0x1p1022, 2, 2};
  double out[8];
  EXPECT_EQ(vesica_method_rect_corners_f64(&rect, out), VESICA_E_RANGE);  // the opposite corner is beyond it
  EXPECT_EQ(vesica::methods::detail::coordinate(-0x1p1023, 2.0, 0x1p1022, 2.0, 0x1p1022), 0x1p1023);
}

/// The largest error of a corner in roundoffs of |c| + |hx u| + |hy u|, in a longer format.
template <class Rect, class T>
long double largest_error(std::int32_t (*corners)(const Rect*, T*), Scalar scalar) {
  properties::Stream stream(properties::Workload::random, VESICA_RECT, VESICA_RECT, scalar, properties::seed());
  const long double roundoff = std::numeric_limits<T>::epsilon() / 2;
  constexpr int signs[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  long double largest = 0;
  for (int i = 0; i < 50000 * properties::repeat(); ++i) {
    const auto [cx, cy, ux, uy, hx, hy, radius] = stream.next().a;
    const Rect rect{static_cast<T>(cx), static_cast<T>(cy), static_cast<T>(ux),
                    static_cast<T>(uy), static_cast<T>(hx), static_cast<T>(hy)};
    T out[8];
    EXPECT_EQ(corners(&rect, out), 0);
    for (int k = 0; k < 4; ++k) {
      const long double s = signs[k][0] * static_cast<long double>(hx), t = signs[k][1] * static_cast<long double>(hy);
      const long double x = cx + (s * ux - t * uy), y = cy + (s * uy + t * ux);
      const long double size_x = std::abs(cx) + std::abs(hx * ux) + std::abs(hy * uy);
      const long double size_y = std::abs(cy) + std::abs(hx * uy) + std::abs(hy * ux);
      largest = std::max({largest, std::abs(out[2 * k] - x) / size_x, std::abs(out[2 * k + 1] - y) / size_y});
    }
  }
  return largest / roundoff;
}

TEST(RectCorners, Accuracy) {
  const long double f64 = largest_error(vesica_method_rect_corners_f64, Scalar::f64);
  const long double f32 = largest_error(vesica_method_rect_corners_f32, Scalar::f32);
  std::printf("rect_corners: largest error %.2Lf (f64), %.2Lf (f32) roundoffs, bound 3\n", f64, f32);
  EXPECT_LE(f64, 3);
  EXPECT_LE(f32, 3);
}

// The constructor from corners gives the rectangle again: exactly, on integers.
TEST(RectCorners, ReadByRectFromCorners) {
  const vesica_rect_f64 rect{10, 20, 1, 0, 6, 2};
  double out[8];
  vesica_rect_f64 again;
  ASSERT_EQ(vesica_method_rect_corners_f64(&rect, out), 0);
  ASSERT_EQ(vesica_rect_from_corners_f64(out, &again), 0);
  EXPECT_EQ(again.cx, 10);
  EXPECT_EQ(again.cy, 20);
  EXPECT_EQ(again.ux, 1);
  EXPECT_EQ(again.uy, 0);
  EXPECT_EQ(again.hx, 6);
  EXPECT_EQ(again.hy, 2);
}

}  // namespace
}  // namespace rect_corners_test

// SPDX-License-Identifier: Apache-2.0
/// Distances known beforehand, one number short of them and one beyond, at every scale; errors; arrays.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "within/face.hpp"

namespace {

using namespace within_test;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Known {
  Pair pair;
  double distance;
};

/// 3, 4, 5 and 5, 12, 13: from corner to corner, corner to edge, rim to rim.
const Known known[] = {
    {{VESICA_POINT, VESICA_POINT, {0, 0}, {3, 4}}, 5},
    {{VESICA_POINT, VESICA_SEGMENT, {0, 5}, {-1, 0, 8, 0}}, 5},
    {{VESICA_POINT, VESICA_SEGMENT, {0, 0}, {3, 4, 9, 12}}, 5},
    {{VESICA_POINT, VESICA_CIRCLE, {0, 0}, {5, 12, 6}}, 7},
    {{VESICA_POINT, VESICA_AABB, {0, 0}, {5, 12, 6, 13}}, 13},
    // From the middle of the edge at C - u, (7, -4), twice its normal u away.
    {{VESICA_POINT, VESICA_RECT, {1, -12}, {10, 0, 3, 4, 1, 1}}, 10},
    {{VESICA_SEGMENT, VESICA_SEGMENT, {0, 0, 0, 10}, {7, 1, 7, 2}}, 7},
    {{VESICA_SEGMENT, VESICA_SEGMENT, {0, 0, -4, -4}, {3, 4, 3, 9}}, 5},
    {{VESICA_SEGMENT, VESICA_CIRCLE, {0, 0, 10, 0}, {5, 9, 2}}, 7},
    {{VESICA_SEGMENT, VESICA_AABB, {0, 0, -1, 9}, {5, -14, 8, -12}}, 13},
    {{VESICA_CIRCLE, VESICA_CIRCLE, {0, 0, 1}, {3, 4, 2}}, 2},
    {{VESICA_CIRCLE, VESICA_AABB, {0, 0, 1}, {3, 4, 5, 6}}, 4},
    {{VESICA_CIRCLE, VESICA_RECT, {1, -12, 2}, {10, 0, 3, 4, 1, 1}}, 8},
    {{VESICA_AABB, VESICA_AABB, {0, 0, 1, 1}, {4, 5, 6, 7}}, 5},
    {{VESICA_AABB, VESICA_RECT, {-9, -20, 1, -12}, {10, 0, 3, 4, 1, 1}}, 10},
    {{VESICA_RECT, VESICA_RECT, {0, 0, 3, 4, 1, 1}, {12, 16, 3, 4, 1, 0.5}}, 10},
    // From the point (27, 20) of an ellipse, where its normal is (5, 12) / 13, to (32, 32) and (37, 44).
    {{VESICA_POINT, VESICA_ELLIPSE, {32, 32}, {0, 0, 1, 0, 45, 25}}, 13},
    {{VESICA_POINT, VESICA_ELLIPSE, {-32, 224}, {0, 0, 3, 4, 45, 25}}, 65},
    {{VESICA_CIRCLE, VESICA_ELLIPSE, {37, 44, 13}, {0, 0, 1, 0, 45, 25}}, 13},
    {{VESICA_SEGMENT, VESICA_ELLIPSE, {44, 27, 20, 37}, {0, 0, 1, 0, 45, 25}}, 13},
    {{VESICA_SEGMENT, VESICA_ELLIPSE, {32, 32, 32, 100}, {0, 0, 1, 0, 45, 25}}, 13},
    {{VESICA_SEGMENT, VESICA_ELLIPSE, {40, 90, 32, 32}, {0, 0, 1, 0, 45, 25}}, 13},
    {{VESICA_AABB, VESICA_ELLIPSE, {32, 32, 40, 50}, {0, 0, 1, 0, 45, 25}}, 13},
    {{VESICA_AABB, VESICA_ELLIPSE, {50, -1, 60, 2}, {0, 0, 1, 0, 45, 25}}, 5},
    {{VESICA_AABB, VESICA_ELLIPSE, {-4, 32, 7, 50}, {0, 0, 1, 0, 45, 25}}, 7},
    {{VESICA_RECT, VESICA_ELLIPSE, {42, 56, 12, -5, 0.5, 2}, {0, 0, 1, 0, 45, 25}}, 13},
    {{VESICA_RECT, VESICA_ELLIPSE, {34, 43, 3, 4, 2, 1}, {0, 0, 1, 0, 45, 25}}, 13},
};

Pair scaled(Pair p, double k) {
  for (auto [kind, numbers] : {std::pair{p.kind_a, &p.a}, {p.kind_b, &p.b}}) {
    for (std::size_t i = 0; i < 6; ++i) {
      if (properties::role(kind, static_cast<int>(i)) != properties::Role::size) {
        (*numbers)[i] *= k;
      }
    }
  }
  return p;
}

// Distances beyond the range of double are compared in smaller units, in which segments shrink too.
TEST(KnownWithin, FartherThanTheGreatestNumber) {
  constexpr double most = std::numeric_limits<double>::max();
  const Pair pairs[] = {{VESICA_POINT, VESICA_ELLIPSE, {most, most}, {-most, -most, 1, 0, 1, 2}},
                        {VESICA_SEGMENT, VESICA_ELLIPSE, {most, most, most, most / 2}, {-most, -most, 1, 0, 1, 2}},
                        {VESICA_CIRCLE, VESICA_ELLIPSE, {most, most, 1}, {-most, -most, 0x1p-9, 0, 1, 2}},
                        {VESICA_AABB, VESICA_ELLIPSE, {most / 2, 0, most, most}, {-most, -most, 1, 0, 1, 2}}};
  for (const Pair& p : pairs) {
    EXPECT_EQ(within(Scalar::f64, p, most), 0) << properties::describe(p);
    EXPECT_EQ(within(Scalar::f64, swapped(p), most), 0) << properties::describe(p);
  }
  // From the end (most / 4, 0) of a segment to a rim at -most / 4: half of the greatest number, beside 2^-52 of it.
  const Pair near{VESICA_SEGMENT, VESICA_ELLIPSE, {most / 4, 0, most, most}, {-most / 2, 0, 1, 0, most / 4, 1}};
  EXPECT_EQ(within(Scalar::f64, near, most / 2 * (1 + 0x1p-48)), 1);
  EXPECT_EQ(within(Scalar::f64, near, most / 2 * (1 - 0x1p-48)), 0);
}

// Along one axis alone: were a coordinate lost in the smaller unit, the shapes would be within the greatest number.
TEST(KnownWithin, FartherThanTheGreatestNumberAlongEitherAxis) {
  constexpr double most = std::numeric_limits<double>::max(), far = 0.7 * most;
  for (const auto [x, y] : {std::array{far, 0.0}, {0.0, far}}) {
    const Pair pairs[] = {{VESICA_POINT, VESICA_ELLIPSE, {x, y}, {-x, -y, 1, 0, 1, 2}},
                          {VESICA_SEGMENT, VESICA_ELLIPSE, {x, y, x + y / 8, y + x / 8}, {-x, -y, 1, 0, 1, 2}},
                          {VESICA_SEGMENT, VESICA_ELLIPSE, {x + y / 8, y + x / 8, x, y}, {-x, -y, 1, 0, 1, 2}},
                          {VESICA_CIRCLE, VESICA_ELLIPSE, {x, y, 1}, {-x, -y, 1, 0, 1, 2}},
                          {VESICA_AABB, VESICA_ELLIPSE, {x, y, x + far / 8, y + far / 8}, {-x, -y, 1, 0, 1, 2}},
                          {VESICA_AABB, VESICA_ELLIPSE, {-x - far / 8, -y - far / 8, -x, -y}, {x, y, 1, 0, 1, 2}},
                          {VESICA_RECT, VESICA_ELLIPSE, {x, y, 3, 4, 1, 2}, {-x, -y, 1, 0, 1, 2}},
                          {VESICA_ELLIPSE, VESICA_ELLIPSE, {x, y, 3, 4, 1, 2}, {-x, -y, 1, 0, 1, 2}}};
    for (const Pair& p : pairs) {
      EXPECT_EQ(within(Scalar::f64, p, most), VESICA_WITHIN_NO) << properties::describe(p);
      EXPECT_EQ(within(Scalar::f64, swapped(p), most), VESICA_WITHIN_NO) << properties::describe(p);
    }
  }
  // Sizes count there too: 1.4 of the greatest number less a radius of 0.5, or half sizes of 0.5.
  const Pair wide[] = {{VESICA_CIRCLE, VESICA_ELLIPSE, {far, 0, most / 2}, {-far, 0, 1, 0, 1, 2}},
                       {VESICA_AABB, VESICA_ELLIPSE, {far - most / 2, 0, far, 1}, {-far, 0, 1, 0, 1, 2}},
                       {VESICA_RECT, VESICA_ELLIPSE, {far, 0, 1, 0, most / 2, 2}, {-far, 0, 1, 0, 1, 2}},
                       {VESICA_RECT, VESICA_ELLIPSE, {far, 0, most / 2, 0, 1, 2}, {-far, 0, 1, 0, 1, 2}},
                       {VESICA_ELLIPSE, VESICA_ELLIPSE, {far, 0, 0, 1, 2, most / 2}, {-far, 0, 1, 0, 1, 2}}};
  for (const Pair& p : wide) {
    EXPECT_EQ(within(Scalar::f64, p, 0.95 * most), VESICA_WITHIN_YES) << properties::describe(p);
    EXPECT_EQ(within(Scalar::f64, p, 0.85 * most), VESICA_WITHIN_NO) << properties::describe(p);
  }
}

TEST(KnownWithin, ContactsAtEveryScale) {
  for (const Known& c : known) {
    for (const int exponent : {-1060, -700, -100, 0, 100, 700, 1015}) {
      const double k = std::ldexp(1, exponent), d = k * c.distance;
      const Pair p = scaled(c.pair, k);
      SCOPED_TRACE(properties::describe(p));
      EXPECT_EQ(within(Scalar::f64, p, d), 1);
      EXPECT_EQ(within(Scalar::f64, p, std::nextafter(d, infinity)), 1);
      EXPECT_EQ(within(Scalar::f64, p, std::nextafter(d, 0)), 0);
      EXPECT_EQ(within(Scalar::f64, swapped(p), d), 1);
      EXPECT_EQ(within(Scalar::f64, swapped(p), std::nextafter(d, 0)), 0);
    }
    const float d = static_cast<float>(c.distance);
    EXPECT_EQ(within(Scalar::f32, c.pair, c.distance), 1);
    EXPECT_EQ(within(Scalar::f32, c.pair, static_cast<double>(std::nextafter(d, 0.0f))), 0);
  }
}

/// The sum of two radii and the distance is exact, not rounded.
TEST(KnownWithin, SumsAreNotRounded) {
  const Pair p{VESICA_CIRCLE, VESICA_CIRCLE, {0, 0, 1}, {3, 0, 0x1p-60}};
  EXPECT_EQ(within(Scalar::f64, p, 2), 1);
  EXPECT_EQ(within(Scalar::f64, p, std::nextafter(2, 0)), 0);
  const Pair q{VESICA_CIRCLE, VESICA_POINT, {0, 0, 0x1p-60}, {3, 0}};
  EXPECT_EQ(within(Scalar::f64, q, std::nextafter(3, 0)), 0);
  const Pair r{VESICA_CIRCLE, VESICA_POINT, {0, 0, 0x1p-52}, {3, 0}};
  EXPECT_EQ(within(Scalar::f64, r, std::nextafter(3, 0)), 0);
  const Pair s{VESICA_CIRCLE, VESICA_POINT, {0, 0, 0x1p-51}, {3, 0}};
  EXPECT_EQ(within(Scalar::f64, s, std::nextafter(3, 0)), 1);
}

TEST(KnownWithin, ACrossedPairIsWithinThoughNoCornerIs) {
  const Pair p{VESICA_RECT, VESICA_RECT, {0, 0, 1, 0, 100, 1}, {0, 0, 1, 0, 1, 100}};
  EXPECT_EQ(within(Scalar::f64, p, 0x1p-1074), 1);
  EXPECT_EQ(within(Scalar::f64, p, 1), 1);
}

TEST(KnownWithin, TwoEllipsesAreCertainAwayFromTheirDistance) {
  const Pair p{VESICA_ELLIPSE, VESICA_ELLIPSE, {0, 0, 1, 0, 3, 2}, {12, 0, 1, 0, 2, 1}};
  EXPECT_EQ(within(Scalar::f64, p, 7 + 1e-14), VESICA_WITHIN_YES);
  EXPECT_EQ(within(Scalar::f64, p, 7), VESICA_WITHIN_NEARLY);
  EXPECT_EQ(within(Scalar::f64, p, 7 - 1e-14), VESICA_WITHIN_NO);
  EXPECT_EQ(within(Scalar::f64, p, 0), VESICA_WITHIN_NO);
  // Without an area they are segments.
  const Pair q{VESICA_ELLIPSE, VESICA_POINT, {0, 0, 1, 0, 3, 0}, {10, 0}};
  EXPECT_EQ(within(Scalar::f64, q, 7), VESICA_WITHIN_YES);
  EXPECT_EQ(within(Scalar::f64, q, std::nextafter(7, 0)), VESICA_WITHIN_NO);
  // As long as no finite number is, beside what is as short: nearest() knows nothing of a distance so much smaller. The
  // rectangle's half lengths are 2^1800 and 2^900, the ellipse's 2^-1000 and 2^-900, its centre 2^1000 above.
  const Pair unlike{
      VESICA_RECT, VESICA_ELLIPSE, {0, 0, 0x1p900, 0, 0x1p900, 1}, {0, 0x1p1000, 0x1p-900, 0, 0x1p-100, 1}};
  EXPECT_EQ(within(Scalar::f64, unlike, 0x1p999), VESICA_WITHIN_NO);
  EXPECT_EQ(within(Scalar::f64, unlike, 0x1p1000), VESICA_WITHIN_YES);
  EXPECT_EQ(within(Scalar::f64, unlike, 0x1p1001), VESICA_WITHIN_YES);
  EXPECT_EQ(within(Scalar::f64, unlike, 0), VESICA_WITHIN_NO);
  // Farther apart than any finite number.
  const Pair far{VESICA_ELLIPSE, VESICA_POINT, {-1.7e308, 0, 1e307, 0, 3, 2}, {1.7e308, 0}};
  EXPECT_EQ(within(Scalar::f64, far, 1.79e308), VESICA_WITHIN_NO);
  const Pair near{VESICA_ELLIPSE, VESICA_POINT, {-1.7e308, 0, 1e307, 0, 17, 2}, {1.7e308, 0}};
  EXPECT_EQ(within(Scalar::f64, near, 1.71e308), VESICA_WITHIN_YES);
}

TEST(KnownWithin, Errors) {
  const double point[2] = {0, 0}, bad[3] = {0, 0, -1}, huge[3] = {0, 0, infinity}, circle[3] = {0, 0, 1};
  const auto ask = [](int kind_a, const double* a, int kind_b, const double* b, double d) {
    return vesica_within_f64(kind_a, a, kind_b, b, d);
  };
  EXPECT_EQ(ask(VESICA_POINT, nullptr, 9, point, nan), VESICA_E_NULL);
  EXPECT_EQ(ask(VESICA_POINT, point, VESICA_POLYLINE + 1, point, nan), VESICA_E_KIND);
  EXPECT_EQ(ask(VESICA_POINT, point, VESICA_CIRCLE, bad, nan), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(VESICA_POINT, point, VESICA_CIRCLE, circle, nan), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(VESICA_POINT, point, VESICA_CIRCLE, circle, -0.0), 1);
  for (const double d : {0.0, 1.0, 1e308, infinity, -0x1p-1074, -1.0, -1e308, -infinity}) {
    EXPECT_EQ(ask(VESICA_POINT, point, VESICA_CIRCLE, bad, d), VESICA_E_SHAPE);
    EXPECT_EQ(ask(VESICA_CIRCLE, huge, VESICA_CIRCLE, circle, d), VESICA_E_SHAPE);
  }
  const double far[2] = {1.7e308, 1.7e308}, other[2] = {-1.7e308, -1.7e308};
  EXPECT_EQ(ask(VESICA_POINT, far, VESICA_POINT, other, 1.79e308), 0);
  EXPECT_EQ(ask(VESICA_POINT, far, VESICA_POINT, other, infinity), 1);
}

/// Records with an element that is invalid, against single calls.
TEST(KnownWithin, Arrays) {
  const std::vector<vesica_circle_f64> circles{{0, 0, 1}, {3, 4, 2}, {0, 0, nan}, {9, 9, 0}};
  const std::vector<vesica_rect_f64> rects{
      {0, 0, 1, 0, 1, 1}, {10, 0, 3, 4, 1, 1}, {5, 5, 1, 1, 1, 2}, {0, 0, 1, 0, 0, 0}};
  vesica_shapes_f64 a, b;
  vesica_shapes_from_records_f64(VESICA_CIRCLE, 4, circles.data(), sizeof circles[0], &a);
  vesica_shapes_from_records_f64(VESICA_RECT, 4, rects.data(), sizeof rects[0], &b);
  std::array<std::uint8_t, 20> out{};
  EXPECT_EQ(vesica_within_matrix_f64(&a, &b, 2, out.data(), 5), VESICA_E_SHAPE);
  std::int64_t count = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const std::int32_t one = vesica_within_f64(VESICA_CIRCLE, &circles[i].cx, VESICA_RECT, &rects[j].cx, 2);
      EXPECT_EQ(out[5 * i + j], one < 0 ? 0 : one);
      count += i != 2 && one > 0;
    }
    EXPECT_EQ(out[5 * i + 4], 0);
  }
  EXPECT_GT(count, 3);
  EXPECT_LT(count, 12);
  a.count = b.count = 2;
  const std::int64_t counted = vesica_within_many_f64(&a, &b, 2, out.data());
  EXPECT_EQ(out[0], 1);
  EXPECT_EQ(out[1], vesica_within_f64(VESICA_CIRCLE, &circles[1].cx, VESICA_RECT, &rects[1].cx, 2));
  EXPECT_EQ(counted, out[0] + out[1]);
  // The second pair is 1 apart, those of the matrix off the diagonal 1.6 and more.
  EXPECT_EQ(vesica_within_many_f64(&a, &b, 0.5, out.data()), 1);
  EXPECT_EQ(out[0], 1);
  EXPECT_EQ(out[1], 0);
  EXPECT_EQ(vesica_within_matrix_f64(&a, &b, 0.5, out.data(), 2), 1);
  EXPECT_EQ(vesica_within_many_f64(&a, &b, nan, out.data()), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_within_many_f64(&a, nullptr, nan, out.data()), VESICA_E_NULL);
  EXPECT_EQ(vesica_within_matrix_f64(&a, &b, nan, out.data(), 2), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_within_matrix_f64(&a, &b, infinity, out.data(), 2), 4);
}

}  // namespace

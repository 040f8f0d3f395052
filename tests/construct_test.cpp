// SPDX-License-Identifier: Apache-2.0
// Constructors by literal expectations: exact results, degenerate input, and every documented error.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "capi/constructors.hpp"

namespace {

template <class Api>
class Construct : public testing::Test {
 protected:
  using Scalar = typename Api::Scalar;
  using Rect = typename Api::Rect;
  using Ellipse = typename Api::Ellipse;
  using Capsule = typename Api::Capsule;
  using RoundRect = typename Api::RoundRect;
  using Limits = std::numeric_limits<Scalar>;

  /// Each number equal to the wanted one, or within `ulps` units in the wanted number's last place.
  template <class Shape, std::size_t n>
  static void expect(const Shape& found, const Scalar (&wanted)[n], int ulps = 0) {
    Scalar numbers[n];
    static_assert(sizeof found == sizeof numbers);
    std::memcpy(numbers, &found, sizeof found);
    for (std::size_t i = 0; i < n; ++i) {
      const Scalar size = std::fabs(wanted[i]), ulp = size - std::nextafter(size, Scalar{0});
      EXPECT_LE(std::fabs(numbers[i] - wanted[i]), static_cast<Scalar>(ulps) * ulp)
          << "number " << i << " is " << numbers[i] << ", not " << wanted[i];
    }
  }

  static Rect rect_from_corners(const Scalar (&corners)[8], std::int32_t result = 0) {
    Rect out{1, 2, 3, 4, 5, 6};
    EXPECT_EQ(Api::rect_from_corners(corners, &out), result);
    return out;
  }

  static RoundRect round_rect(Scalar angle, Scalar width, Scalar height, Scalar radius) {
    RoundRect out{};
    EXPECT_EQ(Api::round_rect_from_angle(1, 2, angle, width, height, radius, &out), 0);
    return out;
  }

  static Capsule capsule(Scalar cx, Scalar cy, Scalar angle, Scalar length) {
    Capsule out{};
    EXPECT_EQ(Api::capsule_from_angle(cx, cy, angle, length, 7, &out), 0);
    return out;
  }

  static Scalar misfit(const Scalar (&corners)[8], const Rect& rect) {
    Scalar out = -1;
    EXPECT_EQ(Api::rect_corners_misfit(corners, &rect, &out), 0);
    return out;
  }

  static Ellipse covariance(Scalar cxx, Scalar cxy, Scalar cyy, Scalar k, std::int32_t result = 0) {
    Ellipse out{1, 2, 3, 4, 5, 6};
    EXPECT_EQ(Api::ellipse_from_covariance(7, 8, cxx, cxy, cyy, k, &out), result);
    return out;
  }

  static Ellipse matrix(Scalar mxx, Scalar mxy, Scalar myy, std::int32_t result = 0) {
    Ellipse out{1, 2, 3, 4, 5, 6};
    EXPECT_EQ(Api::ellipse_from_matrix(7, 8, mxx, mxy, myy, &out), result);
    return out;
  }
};

using Scalars = testing::Types<capi::F64, capi::F32>;
TYPED_TEST_SUITE(Construct, Scalars);

TYPED_TEST(Construct, AabbFromCorners) {
  typename TypeParam::Aabb out{};
  EXPECT_EQ(TypeParam::aabb_from_corners(3, -1, 1, 5, &out), 0);
  this->expect(out, {1, -1, 3, 5});
  EXPECT_EQ(TypeParam::aabb_from_corners(1, 5, 3, -1, &out), 0);
  this->expect(out, {1, -1, 3, 5});
  EXPECT_EQ(TypeParam::aabb_from_corners(2, 2, 2, 2, &out), 0);
  this->expect(out, {2, 2, 2, 2});
}

TYPED_TEST(Construct, FromAngleZero) {
  typename TypeParam::Rect rect{};
  EXPECT_EQ(TypeParam::rect_from_angle(1, 2, 0, 6, 4, &rect), 0);
  this->expect(rect, {1, 2, 1, 0, 3, 2});
  typename TypeParam::Ellipse ellipse{};
  EXPECT_EQ(TypeParam::ellipse_from_angle(1, 2, 0, 6, 4, &ellipse), 0);
  this->expect(ellipse, {1, 2, 1, 0, 6, 4});
  EXPECT_EQ(TypeParam::rect_from_angle(1, 2, 0, 0, 4, &rect), 0);
  this->expect(rect, {1, 2, 1, 0, 0, 2});
}

// Half the smallest number is not a number: the axis is halved in its place, and the size stays exact.
TYPED_TEST(Construct, SizesThatCannotBeHalved) {
  using T = typename TypeParam::Scalar;
  const T tiny = std::numeric_limits<T>::denorm_min(), max = std::numeric_limits<T>::max(), half = T{1} / 2;
  typename TypeParam::Rect rect{};
  EXPECT_EQ(TypeParam::rect_from_angle(0, 0, 0, tiny, 4, &rect), 0);
  this->expect(rect, {0, 0, half, 0, tiny, 4});
  EXPECT_EQ(TypeParam::rect_from_angle(0, 0, 0, max, 3 * tiny, &rect), 0);
  this->expect(rect, {0, 0, half, 0, max, 3 * tiny});
  EXPECT_EQ(TypeParam::rect_from_angle(0, 0, 0, 2 * tiny, 4 * tiny, &rect), 0);
  this->expect(rect, {0, 0, 1, 0, tiny, 2 * tiny});
}

TYPED_TEST(Construct, EighthTurnsHaveEqualComponents) {
  using T = typename TypeParam::Scalar;
  const T eighth = static_cast<T>(std::acos(0.0) / 2), root = std::sqrt(T{1} / 2);
  typename TypeParam::Rect rect{};
  typename TypeParam::Ellipse ellipse{};
  for (const T sign : {T{1}, T{-1}}) {
    EXPECT_EQ(TypeParam::rect_from_angle(1, 2, sign * eighth, 6, 4, &rect), 0);
    this->expect(rect, {1, 2, root, sign * root, 3, 2});
    EXPECT_EQ(TypeParam::ellipse_from_angle(1, 2, sign * 3 * eighth, 6, 4, &ellipse), 0);
    this->expect(ellipse, {1, 2, -root, sign * root, 6, 4});
  }
}

TYPED_TEST(Construct, RoundRectFromOuterSize) {
  using T = typename TypeParam::Scalar;
  this->expect(this->round_rect(0, 6, 4, 1), {1, 2, 1, 0, 2, 1, 1});
  this->expect(this->round_rect(0, 6, 4, 2), {1, 2, 1, 0, 1, 0, 2});  // a capsule
  this->expect(this->round_rect(0, 4, 4, 2), {1, 2, 1, 0, 0, 0, 2});  // a disc
  const T max = std::numeric_limits<T>::max();
  this->expect(this->round_rect(0, max, max, max / 4), {1, 2, 1, 0, max / 4, max / 4, max / 4});
  // 1 - 2 radius is a tie: it is rounded once, to the even number.
  const T epsilon = std::numeric_limits<T>::epsilon();
  this->expect(this->round_rect(0, 1, 2, epsilon / 8), {1, 2, 1, 0, T{1} / 2, 1, epsilon / 8});
}

// The core of 3 of the smallest numbers cannot be halved, so the axis is halved. The radius is no multiple of it.
TYPED_TEST(Construct, RoundRectWhoseCoreCannotBeHalved) {
  using T = typename TypeParam::Scalar;
  const T tiny = std::numeric_limits<T>::denorm_min(), half = T{1} / 2;
  this->expect(this->round_rect(0, 5 * tiny, 4, tiny), {1, 2, half, 0, 3 * tiny, 4, tiny});
  this->expect(this->round_rect(0, 4, 7 * tiny, 3 * tiny), {1, 2, half, 0, 4, tiny, 3 * tiny});
  this->expect(this->round_rect(0, 4, 8 * tiny, 3 * tiny), {1, 2, 1, 0, 2, tiny, 3 * tiny});
}

TYPED_TEST(Construct, RoundRectWithoutRadiusIsTheRect) {
  using T = typename TypeParam::Scalar;
  const T tiny = std::numeric_limits<T>::denorm_min(), max = std::numeric_limits<T>::max();
  for (const T angle : {T{0}, T{1}, T{-2.5f}, T{1e10f}}) {
    for (const T width : {T{0}, tiny, T{1} / 3, max}) {
      typename TypeParam::Rect rect{};
      EXPECT_EQ(TypeParam::rect_from_angle(1, 2, angle, width, 5, &rect), 0);
      const auto made = this->round_rect(angle, width, 5, 0);
      EXPECT_EQ(std::memcmp(&made, &rect, sizeof rect), 0);
      EXPECT_EQ(made.r, 0);
    }
  }
}

TYPED_TEST(Construct, CapsuleFromAngle) {
  using T = typename TypeParam::Scalar;
  const T tiny = std::numeric_limits<T>::denorm_min(), max = std::numeric_limits<T>::max();
  this->expect(this->capsule(1, 2, 0, 6), {-2, 2, 4, 2, 7});
  this->expect(this->capsule(1, 2, T{0.75f}, 0), {1, 2, 1, 2, 7});  // a disc
  this->expect(this->capsule(0, 0, 0, max), {-max / 2, 0, max / 2, 0, 7});
  this->expect(this->capsule(max / 2, max, 0, max), {0, max, max, max, 7});
  // Half of an odd multiple of the smallest number is a tie, so it goes to the even one.
  this->expect(this->capsule(0, 0, 0, tiny), {0, 0, 0, 0, 7});
  this->expect(this->capsule(0, 0, 0, 3 * tiny), {-2 * tiny, 0, 2 * tiny, 0, 7});
  this->expect(this->capsule(tiny, 0, 0, 2 * tiny), {0, 0, 2 * tiny, 0, 7});
  // The sine of the smallest angle is that angle; half of it is not lost.
  const T long_one = std::ldexp(T{1}, std::numeric_limits<T>::max_exponent - 1);
  this->expect(this->capsule(0, 0, tiny, long_one),
               {-long_one / 2, -long_one / 2 * tiny, long_one / 2, long_one / 2 * tiny, 7});
}

// Both components are equal at an eighth turn, so that the ends are mirror images in the diagonals.
TYPED_TEST(Construct, CapsuleAtEighthTurns) {
  using T = typename TypeParam::Scalar;
  const T eighth = static_cast<T>(std::acos(0.0) / 2), root = std::sqrt(T{1} / 2);
  for (const T sign : {T{1}, T{-1}}) {
    this->expect(this->capsule(0, 0, sign * eighth, 6), {-3 * root, sign * -3 * root, 3 * root, sign * 3 * root, 7}, 1);
    for (const T angle : {sign * eighth, sign * 3 * eighth}) {
      const auto c = this->capsule(0, 0, angle, T{1} / 3);
      EXPECT_EQ(std::fabs(c.x1), std::fabs(c.y1));
      EXPECT_EQ(c.x0, -c.x1);
      EXPECT_EQ(c.y0, -c.y1);
      EXPECT_EQ(c.x1 > 0, angle == sign * eighth);
      EXPECT_EQ(c.y1 > 0, angle > 0);
    }
  }
}

TYPED_TEST(Construct, CapsuleFromWidth) {
  using T = typename TypeParam::Scalar;
  const T tiny = std::numeric_limits<T>::denorm_min(), max = std::numeric_limits<T>::max(), third = T{1} / 3;
  const auto make = [](T x0, T y0, T x1, T y1, T width) {
    typename TypeParam::Capsule out{};
    EXPECT_EQ(TypeParam::capsule_from_width(x0, y0, x1, y1, width, &out), 0);
    return out;
  };
  this->expect(make(1, 2, third, 4, 5), {1, 2, third, 4, 2.5});
  this->expect(make(1, 2, 1, 2, third), {1, 2, 1, 2, third / 2});
  this->expect(make(max, -max, -max, tiny, max), {max, -max, -max, tiny, max / 2});
  // Half an odd multiple of the smallest number is rounded to an even multiple.
  this->expect(make(0, 0, 0, 0, 2 * tiny), {0, 0, 0, 0, tiny});
  this->expect(make(0, 0, 0, 0, tiny), {0, 0, 0, 0, 0});
  this->expect(make(0, 0, 0, 0, 3 * tiny), {0, 0, 0, 0, 2 * tiny});
  this->expect(make(0, 0, 0, 0, 5 * tiny), {0, 0, 0, 0, 2 * tiny});
}

TYPED_TEST(Construct, FromRadiusVectorIsExact) {
  using T = typename TypeParam::Scalar;
  const T third = T{1} / 3, tiny = std::numeric_limits<T>::denorm_min(), max = std::numeric_limits<T>::max();
  typename TypeParam::Ellipse out{};
  EXPECT_EQ(TypeParam::ellipse_from_radius_vector(1, 2, 3, 4, third, &out), 0);
  this->expect(out, {1, 2, 3, 4, 1, third});
  EXPECT_EQ(TypeParam::ellipse_from_radius_vector(1, 2, tiny, -max, max, &out), 0);
  this->expect(out, {1, 2, tiny, -max, 1, max});
  EXPECT_EQ(TypeParam::ellipse_from_radius_vector(1, 2, 0, 0, 5, &out), 0);
  this->expect(out, {1, 2, 1, 0, 0, 0});
}

TYPED_TEST(Construct, RectFromAxisParallelCorners) {
  this->expect(this->rect_from_corners({1, 2, 7, 2, 7, 4, 1, 4}), {4, 3, 1, 0, 3, 1});
  this->expect(this->rect_from_corners({7, 2, 1, 2, 1, 4, 7, 4}), {4, 3, -1, 0, 3, 1});
  this->expect(this->rect_from_corners({1, 2, 1, 4, 7, 4, 7, 2}), {4, 3, 0, 1, 1, 3});   // shorter edge first
  this->expect(this->rect_from_corners({1, 4, 1, 2, 7, 2, 7, 4}), {4, 3, 0, -1, 1, 3});  // and downward
  this->expect(this->rect_from_corners({0, 0, 1, 0, 1, 1, 0, 1}), {0.5, 0.5, 1, 0, 0.5, 0.5});
}

TYPED_TEST(Construct, RectFromObliqueCorners) {
  using T = typename TypeParam::Scalar;
  // Edges (3, 4) and (-8, 6): half extents 5/2 and 5.
  this->expect(this->rect_from_corners({0, 0, 3, 4, -5, 10, -8, 6}), {-2.5, 5, T{3} / 5, T{4} / 5, 2.5, 5}, 1);
}

TYPED_TEST(Construct, RectFromCornersOfNoRectangle) {
  // A parallelogram with edges (4, 0) and (1, 1): the longer edge stays, the other counts by its part across.
  this->expect(this->rect_from_corners({0, 0, 4, 0, 5, 1, 1, 1}), {2.5, 0.5, 1, 0, 2, 0.5});
  // A trapezoid with parallel edges 6 and 2 has the mean edge 4.
  this->expect(this->rect_from_corners({0, 0, 6, 0, 4, 2, 2, 2}), {3, 1, 1, 0, 2, 1});
}

// The order of a table's rows gave a segment. Of 24 orders 8 go round the outline: 4 starts, 2 senses.
TYPED_TEST(Construct, CrossedCornersAreRefused) {
  using T = typename TypeParam::Scalar;
  this->expect(this->rect_from_corners({355, 853, 491, 853, 355, 904, 491, 904}, VESICA_E_ARGUMENT),
               {1, 2, 3, 4, 5, 6});
  this->rect_from_corners({1, 1, 5, 1, 1, 1, 5, 1}, VESICA_E_ARGUMENT);  // a segment walked to and fro twice
  const T max = std::numeric_limits<T>::max(), tiny = std::numeric_limits<T>::denorm_min();
  const T outlines[][8] = {{355, 853, 491, 853, 491, 904, 355, 904},
                           {0, 0, 3, 4, -5, 10, -8, 6},
                           {1, 1, 1, 2, 1001, 2, 1001, 1},
                           {-max, -max, max, -max, max, max, -max, max},
                           {0, 0, 8 * tiny, 0, 8 * tiny, 2 * tiny, 0, 2 * tiny}};
  for (const auto& outline : outlines) {
    int order[] = {0, 1, 2, 3}, in_order = 0, refused = 0;
    do {
      T p[8];
      for (int i = 0; i < 4; ++i) {
        p[2 * i] = outline[2 * order[i]];
        p[2 * i + 1] = outline[2 * order[i] + 1];
      }
      const bool goes_round = (order[0] - order[2]) % 2 == 0;
      this->rect_from_corners(p, goes_round ? 0 : VESICA_E_ARGUMENT);
      ++(goes_round ? in_order : refused);
    } while (std::next_permutation(order, order + 4));
    EXPECT_EQ(in_order, 8);
    EXPECT_EQ(refused, 16);
  }
}

// Edges of 8 roundoffs of the largest coordinate may be rounding; a longer pair that crosses is refused.
TYPED_TEST(Construct, EdgesOfAFewRoundoffsMayCross) {
  using T = typename TypeParam::Scalar;
  const T least = 512 * 8 * std::numeric_limits<T>::epsilon();
  this->rect_from_corners({-512, 0, 512, 0, 512, -least, -512, least});
  this->rect_from_corners({-512, 0, 512, 0, 512, -2 * least, -512, 2 * least}, VESICA_E_ARGUMENT);
  this->rect_from_corners({-512, 0, 512, 0, 512, 2 * least, -512, 2 * least});
}

TYPED_TEST(Construct, MisfitOfCorners) {
  using T = typename TypeParam::Scalar;
  using Made = typename TypeParam::Rect;
  const T parallelogram[] = {0, 0, 4, 0, 5, 1, 1, 1};
  EXPECT_EQ(this->misfit(parallelogram, this->rect_from_corners(parallelogram)), T{0.5f});
  const T trapezoid[] = {0, 0, 6, 0, 4, 2, 2, 2};
  EXPECT_EQ(this->misfit(trapezoid, this->rect_from_corners(trapezoid)), 1);
  // Crossed corners of a rectangle 6 wide and 2 high: two of them stand at each other's places.
  const Made rect{4, 3, 1, 0, 3, 1};
  EXPECT_EQ(this->misfit({1, 2, 7, 2, 1, 4, 7, 4}, rect), 6);
  EXPECT_EQ(this->misfit({1, 2, 7, 4, 7, 2, 1, 4}, rect), 2);
  // One corner is (3, 4) off. The axis need not be a unit, and the centre may be anywhere.
  EXPECT_EQ(this->misfit({1, 2, 7, 2, 10, 8, 1, 4}, rect), 5);
  EXPECT_EQ(this->misfit({-1, -3, 3, 3, 1, 3, -3, -3}, Made{0, 0, 2, 3, 1, 0}), 1);
  EXPECT_EQ(this->misfit({0, 0, 0, 0, 0, 0, 0, 0}, Made{3, 4, 1, 0, 0, 0}), 5);
  const T max = std::numeric_limits<T>::max();
  EXPECT_EQ(this->misfit({-max, -max, max, -max, max, max, -max, max}, Made{0, 0, 1, 0, max, max}), 0);
  EXPECT_EQ(this->misfit({max, 0, max, 0, max, 0, max, 0}, Made{max / 2, 0, 1, 0, 0, 0}), max / 2);
}

// Which corner comes first, and the sense, make no difference.
TYPED_TEST(Construct, MisfitOfEveryCyclicOrder) {
  using T = typename TypeParam::Scalar;
  const T corners[] = {1, 2, 7, 2, T{6.5f}, 5, 1, 4};
  const auto rect = this->rect_from_corners(corners);
  const T expected = this->misfit(corners, rect);
  EXPECT_GT(expected, 0);
  for (int start = 0; start < 4; ++start) {
    for (const int step : {1, 3}) {
      T p[8];
      for (int i = 0; i < 4; ++i) {
        const int from = (start + step * i) % 4;
        p[2 * i] = corners[2 * from];
        p[2 * i + 1] = corners[2 * from + 1];
      }
      EXPECT_EQ(this->misfit(p, rect), expected);
    }
  }
}

TYPED_TEST(Construct, RectFromEqualCorners) {
  this->expect(this->rect_from_corners({3, 4, 3, 4, 3, 4, 3, 4}), {3, 4, 1, 0, 0, 0});
  this->expect(this->rect_from_corners({1, 1, 5, 1, 5, 1, 1, 1}), {3, 1, 1, 0, 2, 0});
  this->expect(this->rect_from_corners({1, 1, 1, 1, 1, 5, 1, 5}), {1, 3, 1, 0, 0, 2});
}

TYPED_TEST(Construct, RectFromCornersAtTheEndsOfTheRange) {
  using T = typename TypeParam::Scalar;
  const T max = std::numeric_limits<T>::max(), tiny = std::numeric_limits<T>::denorm_min();
  this->expect(this->rect_from_corners({-max, -max, max, -max, max, max, -max, max}), {0, 0, 1, 0, max, max});
  this->expect(this->rect_from_corners({0, 0, 8 * tiny, 0, 8 * tiny, 2 * tiny, 0, 2 * tiny}),
               {4 * tiny, tiny, 1, 0, 4 * tiny, tiny});
  // A square on its corner with diagonal 2 max: half extents max / sqrt(2) fit. With edges 2 max each way they do not.
  EXPECT_EQ(this->rect_from_corners({max, 0, 0, max, -max, 0, 0, -max}).cx, 0);
  this->expect(this->rect_from_corners({-max, -max, max, max, max, max, -max, -max}, VESICA_E_RANGE),
               {1, 2, 3, 4, 5, 6});
}

// A covariance that the diagonal mirrors gives an ellipse that the diagonal mirrors.
TYPED_TEST(Construct, EqualVariancesGiveTheDiagonal) {
  using T = typename TypeParam::Scalar;
  for (const T variance : {T{5}, T{1} / 3, T{1e-30f}}) {
    for (const T correlation : {T{-0.8f}, T{1e-6f}, T{0.5f}, T{1}}) {
      const auto e = this->covariance(variance, correlation * variance, variance, 1);
      EXPECT_EQ(e.ux, std::fabs(e.uy)) << variance << ' ' << correlation;
      EXPECT_EQ(e.uy < 0, correlation < 0);
      if (correlation == 1) continue;
      const auto m = this->matrix(variance, correlation * variance, variance);
      EXPECT_EQ(m.ux, std::fabs(m.uy)) << variance << ' ' << correlation;
    }
  }
  const auto e = this->covariance(7, 3, 2, 1), exchanged = this->covariance(2, 3, 7, 1);
  this->expect(exchanged, {e.cx, e.cy, e.uy, e.ux, e.a, e.b});
}

TYPED_TEST(Construct, EllipseFromCovariance) {
  using T = typename TypeParam::Scalar;
  this->expect(this->covariance(4, 0, 1, 1), {7, 8, 1, 0, 2, 1});
  this->expect(this->covariance(1, 0, 4, 3), {7, 8, 0, 1, 6, 3});
  this->expect(this->covariance(9, 0, 9, 2), {7, 8, 1, 0, 6, 6});  // a circle
  // Eigenvalues 100 and 25, along (4, 3) / 5 and across it.
  this->expect(this->covariance(73, 36, 52, 1), {7, 8, T{4} / 5, T{3} / 5, 10, 5}, 1);
  this->expect(this->covariance(73, -36, 52, 1), {7, 8, T{4} / 5, -T{3} / 5, 10, 5}, 1);
  this->expect(this->covariance(52, 36, 73, 1), {7, 8, T{3} / 5, T{4} / 5, 10, 5}, 1);
  this->expect(this->covariance(52, -36, 73, 1), {7, 8, T{3} / 5, -T{4} / 5, 10, 5}, 1);
}

TYPED_TEST(Construct, EllipseFromSingularCovariance) {
  using T = typename TypeParam::Scalar;
  this->expect(this->covariance(0, 0, 0, 3), {7, 8, 1, 0, 0, 0});
  this->expect(this->covariance(4, 0, 0, 1), {7, 8, 1, 0, 2, 0});
  this->expect(this->covariance(0, 0, 4, 1), {7, 8, 0, 1, 2, 0});
  this->expect(this->covariance(9, 12, 16, 2), {7, 8, T{3} / 5, T{4} / 5, 10, 0}, 1);
  EXPECT_EQ(this->covariance(9, 12, 16, 2).b, 0);
  EXPECT_EQ(this->covariance(73, 36, 52, 0).a, 0);
  EXPECT_EQ(this->covariance(73, 36, 52, 0).b, 0);
}

// One place away from singular: valid below, no covariance above. A rounded determinant cannot decide.
TYPED_TEST(Construct, CovarianceNextToSingular) {
  using T = typename TypeParam::Scalar;
  const T eps = std::numeric_limits<T>::epsilon();
  const T x = 1 + eps;  // x^2 = 1 + 2 eps + eps^2 is above 1 * (1 + 2 eps)
  this->covariance(1, x, 1 + 2 * eps, 1, VESICA_E_ARGUMENT);
  EXPECT_EQ(this->covariance(1 + 2 * eps, x, 1, 1, VESICA_E_ARGUMENT).a, 5);
  // (1 + 3 eps)(1 - eps) - 1 = 2 eps - 3 eps^2 > 0 and (1 + eps)(1 - eps) - 1 = -eps^2 < 0.
  EXPECT_GT(this->covariance(1 + 3 * eps, 1, 1 - eps, 1).b, 0);
  this->covariance(1 + eps, 1, 1 - eps, 1, VESICA_E_ARGUMENT);
}

TYPED_TEST(Construct, CovarianceAtTheEndsOfTheRange) {
  using T = typename TypeParam::Scalar;
  const T max = std::numeric_limits<T>::max(), tiny = std::numeric_limits<T>::denorm_min();
  constexpr int top = std::numeric_limits<T>::max_exponent;  // even
  const T large = std::ldexp(T{1}, top - 2), root = std::ldexp(T{1}, top / 2 - 1);
  this->expect(this->covariance(large, 0, large, 1), {7, 8, 1, 0, root, root});
  this->expect(this->covariance(tiny, 0, tiny, 1), {7, 8, 1, 0, std::sqrt(tiny), std::sqrt(tiny)}, 1);
  this->expect(this->covariance(4 * tiny, 4 * tiny, 4 * tiny, 0), {7, 8, std::sqrt(T{0.5}), std::sqrt(T{0.5}), 0, 0},
               1);
  this->expect(this->covariance(large, 0, tiny, 1), {7, 8, 1, 0, root, std::sqrt(tiny)}, 1);
  // The smallest rotation decides the direction of an almost circular ellipse.
  this->expect(this->covariance(large, tiny, large, 1), {7, 8, std::sqrt(T{0.5}), std::sqrt(T{0.5}), root, root}, 1);
  this->expect(this->covariance(large, -tiny, large, 1), {7, 8, std::sqrt(T{0.5}), -std::sqrt(T{0.5}), root, root}, 1);
  this->covariance(tiny, max, tiny, 1, VESICA_E_ARGUMENT);
  this->covariance(0, tiny, max, 1, VESICA_E_ARGUMENT);
  this->expect(this->covariance(4, 0, 1, max, VESICA_E_RANGE), {1, 2, 3, 4, 5, 6});
  this->expect(this->covariance(1, 0, 1, max), {7, 8, 1, 0, max, max});
  this->expect(this->covariance(T{1} / 4, 0, T{1} / 4, tiny * 2), {7, 8, 1, 0, tiny, tiny});
}

TYPED_TEST(Construct, EllipseFromMatrix) {
  using T = typename TypeParam::Scalar;
  const T quarter = T{1} / 4, max = std::numeric_limits<T>::max(), tiny = std::numeric_limits<T>::denorm_min();
  this->expect(this->matrix(quarter, 0, 1), {7, 8, 1, 0, 2, 1});
  this->expect(this->matrix(1, 0, quarter), {7, 8, 0, 1, 2, 1});
  this->expect(this->matrix(quarter, 0, quarter), {7, 8, 1, 0, 2, 2});
  // Eigenvalues 100 across and 25 along (4, 3) / 5.
  this->expect(this->matrix(52, -36, 73), {7, 8, T{4} / 5, T{3} / 5, T{1} / 5, T{1} / 10}, 1);
  this->expect(this->matrix(52, 36, 73), {7, 8, T{4} / 5, -T{3} / 5, T{1} / 5, T{1} / 10}, 1);
  this->expect(this->matrix(tiny, 0, max), {7, 8, 1, 0, 1 / std::sqrt(tiny), 1 / std::sqrt(max)}, 1);
}

TYPED_TEST(Construct, MatrixNotPositiveDefinite) {
  using T = typename TypeParam::Scalar;
  const T eps = std::numeric_limits<T>::epsilon();
  this->expect(this->matrix(9, 12, 16, VESICA_E_ARGUMENT), {1, 2, 3, 4, 5, 6});
  this->matrix(0, 0, 0, VESICA_E_ARGUMENT);
  this->matrix(1, 0, 0, VESICA_E_ARGUMENT);
  this->matrix(-1, 0, 1, VESICA_E_ARGUMENT);
  this->matrix(1, 0, -1, VESICA_E_ARGUMENT);
  this->matrix(0, 1, 1, VESICA_E_ARGUMENT);
  this->matrix(1, 1, 0, VESICA_E_ARGUMENT);
  this->matrix(-2, 1, -2, VESICA_E_ARGUMENT);
  this->matrix(1, 2, 1, VESICA_E_ARGUMENT);
  this->matrix(1 + eps, 1, 1 - eps, VESICA_E_ARGUMENT);
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// Rectangles of arrays of corners, and their misfits, have the bits of single calls; crossed corners lose no neighbour.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "capi/constructors.hpp"
#include "capi/face.hpp"
#include "properties/random.hpp"

namespace corner_arrays_test {
namespace {

template <class T>
using Corners = std::array<T, 8>;

/// Corners near a rectangle's. In one row of three they are in another order than round the outline.
template <class T>
Corners<T> draw(properties::Random& random, bool crossed) {
  const double x = random.between(-9, 9), y = random.between(-9, 9), ux = random.between(1, 9);
  const double uy = random.between(-9, 9), ratio = random.sign() * random.between(0.1, 2);
  const double along[] = {0, 1, 1, 0}, across[] = {0, 0, ratio, ratio};
  const std::array<std::size_t, 4> order =
      crossed ? std::array<std::size_t, 4>{0, 2, 1, 3} : std::array<std::size_t, 4>{0, 1, 2, 3};
  Corners<T> corners{};
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t from = order[k];
    corners[2 * k] = static_cast<T>(x + along[from] * ux - across[from] * uy + random.between(-0.01, 0.01));
    corners[2 * k + 1] = static_cast<T>(y + along[from] * uy + across[from] * ux + random.between(-0.01, 0.01));
  }
  return corners;
}

template <class Api>
class CornerArrays : public testing::Test {
 public:
  using Scalar = typename Api::Scalar;
  using Rect = typename Api::Rect;
  static constexpr std::size_t n = 257;
  static constexpr std::ptrdiff_t row = 8 * sizeof(Scalar) + 3;  // rows are not aligned

  CornerArrays() : bytes_(1 + n * row), many_(n) {
    properties::Random random(properties::seed());
    for (std::size_t i = 0; i < n; ++i) {
      rows_.push_back(draw<Scalar>(random, i % 3 == 0));
      if (i == 7) rows_[i][3] = std::numeric_limits<Scalar>::quiet_NaN();
      std::memcpy(bytes_.data() + 1 + i * row, rows_[i].data(), sizeof rows_[i]);
    }
  }
  const Scalar* at(std::size_t i) const { return reinterpret_cast<const Scalar*>(bytes_.data() + 1 + i * row); }
  static bool same(const Rect& a, const Rect& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

  std::vector<Corners<Scalar>> rows_;
  std::vector<unsigned char> bytes_;
  std::vector<Rect> many_;
};

using Scalars = testing::Types<capi::F64, capi::F32>;
TYPED_TEST_SUITE(CornerArrays, Scalars, );

TYPED_TEST(CornerArrays, HaveTheBitsOfSingleCalls) {
  using T = typename TypeParam::Scalar;
  using F = capi_tests::Face<T>;
  ASSERT_EQ(F::rects_from_corners(this->at(0), this->n, this->row, this->many_.data()), VESICA_E_SHAPE);
  typename F::Shapes shapes;
  ASSERT_EQ(F::from_records(VESICA_RECT, this->n, this->many_.data(), sizeof(this->many_[0]), &shapes), 0);
  std::vector<T> misfit(this->n);
  ASSERT_EQ(F::rect_corners_misfit_many(this->at(0), this->row, &shapes, misfit.data()), VESICA_E_SHAPE);
  for (std::size_t i = 0; i < this->n; ++i) {
    const typename TypeParam::Rect& made = this->many_[i];
    typename TypeParam::Rect single;
    const std::int32_t code = TypeParam::rect_from_corners(this->rows_[i].data(), &single);
    ASSERT_EQ(code, i == 7 ? VESICA_E_NOT_FINITE : i % 3 == 0 ? VESICA_E_ARGUMENT : 0) << i;
    if (code != 0) {
      for (const T number : {made.cx, made.cy, made.ux, made.uy, made.hx, made.hy, misfit[i]}) {
        EXPECT_TRUE(std::isnan(number)) << i;
      }
      continue;
    }
    EXPECT_TRUE(this->same(made, single)) << i;
    T of_one = -1;
    EXPECT_EQ(TypeParam::rect_corners_misfit(this->rows_[i].data(), &single, &of_one), 0);
    EXPECT_EQ(misfit[i], of_one) << i;
    EXPECT_LT(misfit[i], T(0.1)) << i;
  }
}

TYPED_TEST(CornerArrays, OfANegativeStride) {
  using F = capi_tests::Face<typename TypeParam::Scalar>;
  std::vector<typename TypeParam::Rect> backwards(this->n);
  F::rects_from_corners(this->at(0), this->n, this->row, this->many_.data());
  F::rects_from_corners(this->at(this->n - 1), this->n, -this->row, backwards.data());
  for (std::size_t i = 2; i < this->n; i += 3) {
    EXPECT_TRUE(this->same(backwards[this->n - 1 - i], this->many_[i])) << i;
  }
}

TEST(Corners, OutOfRange) {
  constexpr double huge = 1.7e308;
  const Corners<double> corners[] = {{0, 0, 1, 0, 1, 1, 0, 1}, {-huge, -huge, huge, huge, huge, huge, -huge, -huge}};
  vesica_rect_f64 out[2];
  EXPECT_EQ(vesica_rects_from_corners_f64(corners[0].data(), 2, sizeof corners[0], out), VESICA_E_RANGE);
  EXPECT_EQ(out[0].hx, 0.5);
  EXPECT_TRUE(std::isnan(out[1].hx));
}

TEST(Corners, Errors) {
  const Corners<double> square{0, 0, 1, 0, 1, 1, 0, 1};
  const double* const corners = square.data();
  vesica_rect_f64 out{7, 7, 7, 7, 7, 7};
  EXPECT_EQ(vesica_rects_from_corners_f64(nullptr, 1, 0, &out), VESICA_E_NULL);
  EXPECT_EQ(vesica_rects_from_corners_f64(corners, 1, 0, nullptr), VESICA_E_NULL);
  EXPECT_EQ(vesica_rects_from_corners_f64(nullptr, 0, 0, nullptr), 0);
  EXPECT_EQ(vesica_rects_from_corners_f64(corners, -1, 0, &out), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_rects_from_corners_f64(corners, INT64_MAX, 64, &out), VESICA_E_ARGUMENT);
  EXPECT_EQ(out.cx, 7);
}

TEST(Corners, ErrorsOfMisfits) {
  const Corners<double> square{0, 0, 1, 0, 1, 1, 0, 1};
  const double* const corners = square.data();
  const vesica_rect_f64 rect{0.5, 0.5, 1, 0, 0.5, 1};
  vesica_shapes_f64 rects, circle, none, negative, large;
  ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_RECT, 1, &rect, 0, &rects), 0);
  circle = none = negative = large = rects;
  circle.kind = VESICA_CIRCLE, none.count = 0, negative.count = -1, large.count = INT64_MAX;
  double misfit = 7;
  const auto ask = vesica_rect_corners_misfit_many_f64;
  EXPECT_EQ(ask(nullptr, 0, &rects, &misfit), VESICA_E_NULL);
  EXPECT_EQ(ask(corners, 0, nullptr, &misfit), VESICA_E_NULL);
  EXPECT_EQ(ask(corners, 0, &rects, nullptr), VESICA_E_NULL);
  EXPECT_EQ(ask(nullptr, 0, &none, nullptr), 0);
  EXPECT_EQ(ask(corners, 0, &circle, &misfit), VESICA_E_KIND);
  EXPECT_EQ(ask(corners, 0, &negative, &misfit), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(corners, 64, &large, &misfit), VESICA_E_ARGUMENT);
  EXPECT_EQ(misfit, 7);
  EXPECT_EQ(ask(corners, 0, &rects, &misfit), 0);
  EXPECT_EQ(misfit, 0.5);
}

}  // namespace
}  // namespace corner_arrays_test

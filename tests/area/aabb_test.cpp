// SPDX-License-Identifier: Apache-2.0
// Two AABBs share an AABB of stored numbers: the area is the nearest double to its area, in arrays too.
#include <gtest/gtest.h>
#include <mpfr.h>
#include <vesica.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "properties/random.hpp"

namespace area_of_aabbs {
namespace {

using properties::Random;
using Box = vesica_aabb_f64;

/// By exact differences and a product that is rounded once.
double rounded_area(const Box& s) {
  if (!(s.min_x < s.max_x && s.min_y < s.max_y)) return 0;
  mpfr_t w, h, x, product;
  mpfr_inits2(2200, w, h, x, static_cast<mpfr_ptr>(nullptr));
  mpfr_init2(product, 53);
  mpfr_set_d(w, s.max_x, MPFR_RNDN);
  mpfr_set_d(x, s.min_x, MPFR_RNDN);
  EXPECT_EQ(mpfr_sub(w, w, x, MPFR_RNDN), 0);
  mpfr_set_d(h, s.max_y, MPFR_RNDN);
  mpfr_set_d(x, s.min_y, MPFR_RNDN);
  EXPECT_EQ(mpfr_sub(h, h, x, MPFR_RNDN), 0);
  mpfr_mul(product, w, h, MPFR_RNDN);
  const double area = mpfr_get_d(product, MPFR_RNDN);
  mpfr_clears(w, h, x, product, static_cast<mpfr_ptr>(nullptr));
  return area;
}

Box common(const Box& a, const Box& b) {
  return {std::max(a.min_x, b.min_x), std::max(a.min_y, b.min_y), std::min(a.max_x, b.max_x),
          std::min(a.max_y, b.max_y)};
}

/// Numbers on a grid meet and nest often; others have all their digits. Areas stay normal numbers.
std::vector<Box> draw(Random& random, std::size_t count) {
  std::vector<Box> boxes(count);
  for (Box& box : boxes) {
    const bool grid = random.chance(0.4);
    const double far = random.chance(0.1) ? 0x1p40 : 0, scale = random.chance(0.1) ? 0x1p-150 : 1;
    const auto side = [&](double& low, double& high) {
      const double at = grid ? random.integer(0, 8) : random.between(0, 8);
      const double size = grid ? random.integer(0, 5) : random.chance(0.1) ? 0x1p-48 : random.between(0, 5);
      low = (at + far) * scale;
      high = std::max(low, (at + size + far) * scale);
    };
    side(box.min_x, box.max_x);
    side(box.min_y, box.max_y);
  }
  return boxes;
}

TEST(AreaOfAabbs, IsRoundedOnce) {
  Random random(91);
  int shared = 0;
  for (int round = 0; round < 20 * properties::repeat(); ++round) {
    const std::vector<Box> a = draw(random, 1000), b = draw(random, 1000);
    std::vector<double> many(a.size());
    vesica_shapes_f64 first{}, second{};
    ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_AABB, 1000, a.data(), sizeof(Box), &first), 0);
    ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_AABB, 1000, b.data(), sizeof(Box), &second), 0);
    ASSERT_GE(vesica_area_many_f64(&first, &second, many.data()), 0);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double expected = rounded_area(common(a[i], b[i]));
      double area = -1, exchanged = -1;
      ASSERT_EQ(vesica_area_f64(VESICA_AABB, &a[i], VESICA_AABB, &b[i], &area), 0);
      ASSERT_EQ(vesica_area_f64(VESICA_AABB, &b[i], VESICA_AABB, &a[i], &exchanged), 0);
      ASSERT_EQ(area, expected) << i;
      ASSERT_EQ(exchanged, expected) << i;
      ASSERT_EQ(many[i], expected) << i;
      shared += expected > 0;
    }
  }
  EXPECT_GT(shared, 500);
}

/// By the areas above, in a matrix as alone: flat ones have a ratio only with one that is not.
TEST(AreaOfAabbs, RatiosOfMatricesAreThoseOfCalls) {
  Random random(92);
  for (int round = 0; round < 4 * properties::repeat(); ++round) {
    const std::vector<Box> a = draw(random, 37), b = draw(random, 300);
    vesica_shapes_f64 first{}, second{};
    ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_AABB, 37, a.data(), sizeof(Box), &first), 0);
    ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_AABB, 300, b.data(), sizeof(Box), &second), 0);
    std::vector<double> matrix(37 * 300);
    vesica_iou_matrix_f64(&first, &second, matrix.data(), 300);
    for (std::size_t i = 0; i < 37 * 300; ++i) {
      const Box &p = a[i / 300], &q = b[i % 300];
      double iou = -1;
      const std::int32_t error = vesica_iou_f64(VESICA_AABB, &p, VESICA_AABB, &q, &iou);
      const double shared = rounded_area(common(p, q)), of_p = rounded_area(p), of_q = rounded_area(q);
      if (of_p == 0 && of_q == 0) {
        ASSERT_EQ(error, VESICA_E_ARGUMENT);
        ASSERT_TRUE(std::isnan(matrix[i]));
        continue;
      }
      ASSERT_EQ(error, 0);
      ASSERT_EQ(iou, matrix[i]) << i;
      ASSERT_EQ(iou, shared / (std::max(of_p, of_q) + (std::min(of_p, of_q) - shared))) << i;
    }
  }
}

/// Beyond the middle of the format, where nothing is computed in lanes.
TEST(AreaOfAabbs, AnyMagnitude) {
  for (const double scale : {0x1p-1060, 0x1p-540, 0x1p-300, 0x1p300, 0x1p500}) {
    const Box a{0, 0, 4 * scale, 4 * scale}, b{scale, -scale, 8 * scale, 3 * scale},
        c{scale, scale, 2 * scale, 2 * scale};
    double iou = -1;
    ASSERT_EQ(vesica_iou_f64(VESICA_AABB, &a, VESICA_AABB, &b, &iou), 0);
    EXPECT_EQ(iou, 9.0 / (28 + (16 - 9))) << scale;
    ASSERT_EQ(vesica_iou_f64(VESICA_AABB, &a, VESICA_AABB, &c, &iou), 0);
    EXPECT_EQ(iou, 1.0 / 16) << scale;
  }
  const double most = 0x1.fffffffffffffp+1023;
  const Box all{-most, -most, most, most}, right{0, -most, most, most};
  double iou = -1, area = -1;
  ASSERT_EQ(vesica_iou_f64(VESICA_AABB, &all, VESICA_AABB, &right, &iou), 0);
  EXPECT_EQ(iou, 0.5);
  EXPECT_EQ(vesica_area_f64(VESICA_AABB, &all, VESICA_AABB, &right, &area), VESICA_E_RANGE);
  const Box bad{1, 0, 0, 1};
  EXPECT_EQ(vesica_area_f64(VESICA_AABB, &all, VESICA_AABB, &bad, &area), VESICA_E_SHAPE);
}

}  // namespace
}  // namespace area_of_aabbs

// SPDX-License-Identifier: Apache-2.0
#include <vesica/methods/aabb_intervals.hpp>

#include "methods/typed_method.hpp"

namespace {

using namespace method_pairs;

constexpr auto point_f64 = vesica_method_point_aabb_intervals_f64;
constexpr auto point_f32 = vesica_method_point_aabb_intervals_f32;
constexpr auto boxes_f64 = vesica_method_aabb_aabb_intervals_f64;
constexpr auto boxes_f32 = vesica_method_aabb_aabb_intervals_f32;

TEST(AabbIntervals, KnownAnswers) {
  const vesica_aabb_f64 box{1, 2, 3, 4}, touching{3, 4, 5, 6}, apart{3.125, 2, 5, 6}, below{1, 0, 3, 1.875};
  const vesica_aabb_f64 tall{1.5, -9, 2, 9}, point{2, 3, 2, 3};
  EXPECT_EQ(boxes_f64(&box, &touching), 1);
  EXPECT_EQ(boxes_f64(&box, &apart), 0);
  EXPECT_EQ(boxes_f64(&box, &below), 0);
  EXPECT_EQ(boxes_f64(&box, &tall), 1) << "crossing like a plus sign";
  EXPECT_EQ(boxes_f64(&box, &point), 1);
  const vesica_point_f64 corner{1, 4}, above{2, 4.125}, left{0.875, 3};
  EXPECT_EQ(point_f64(&corner, &box), 1);
  EXPECT_EQ(point_f64(&above, &box), 0);
  EXPECT_EQ(point_f64(&left, &box), 0);
}

TEST(AabbIntervals, InvalidInput) {
  InvalidInput<point_f64>::expect_errors();
  InvalidInput<point_f32>::expect_errors();
  InvalidInput<boxes_f64>::expect_errors();
  InvalidInput<boxes_f32>::expect_errors();
}

// Comparisons do not round: never wrong.
TEST(AabbIntervals, AlwaysExact) {
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    for (const properties::Workload workload : properties::all_workloads) {
      const auto wrong = [&](const Method& method, int kind_a) {
        return count(method, workload, kind_a, VESICA_AABB, scalar, 5000).wrong;
      };
      EXPECT_EQ(wrong(method<point_f64, point_f32>(scalar), VESICA_POINT), 0) << properties::name(workload);
      EXPECT_EQ(wrong(method<boxes_f64, boxes_f32>(scalar), VESICA_AABB), 0) << properties::name(workload);
    }
  }
}

}  // namespace

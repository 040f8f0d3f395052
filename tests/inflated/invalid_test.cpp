// SPDX-License-Identifier: Apache-2.0
// Invalid capsules and rounded rectangles beside, across and inside every other kind: each question refuses them.
#include <gtest/gtest.h>
#include <vesica.h>
#include <vesica_topology.h>

#include <array>
#include <limits>
#include <vector>

namespace refused {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

struct Shape {
  std::int32_t kind;
  std::array<double, 7> numbers;
};

const std::vector<Shape> valid = {{VESICA_POINT, {1, 1}},
                                  {VESICA_SEGMENT, {0, 0, 9, 1}},
                                  {VESICA_CIRCLE, {0, 0, 50}},
                                  {VESICA_AABB, {-50, -50, 50, 50}},
                                  {VESICA_RECT, {0, 0, 3, 4, 9, 9}},
                                  {VESICA_ELLIPSE, {0, 0, 0.6, 0.8, 50, 40}},
                                  {VESICA_CAPSULE, {-9, 0, 9, 0, 30}},
                                  {VESICA_ROUND_RECT, {0, 0, 1, 1, 9, 9, 20}}};

std::vector<Shape> invalid() {
  std::vector<Shape> shapes;
  for (const double x : {0.5, 55.0, 500.0}) {
    for (const double size : {0.0, 1.0}) {
      for (const double axis : {0.0, nan, infinity})
        shapes.push_back({VESICA_ROUND_RECT, {x, 0, axis, 0, size, size, 1}});
      for (const double bad : {-1.0, nan, infinity}) {
        shapes.push_back({VESICA_ROUND_RECT, {x, 0, 1, 0, size, size, bad}});
        shapes.push_back({VESICA_ROUND_RECT, {x, 0, 1, 0, bad, size, 1}});
        shapes.push_back({VESICA_ROUND_RECT, {x, 0, 1, 0, size, bad, 1}});
        shapes.push_back({VESICA_CAPSULE, {x, 0, x + size, 0, bad}});
      }
      for (const double bad : {nan, infinity}) shapes.push_back({VESICA_CAPSULE, {x, 0, bad, 0, 1}});
    }
  }
  return shapes;
}

void expect_refused(const Shape& a, const Shape& b) {
  const auto kind_a = a.kind, kind_b = b.kind;
  const double *const p = a.numbers.data(), *const q = b.numbers.data();
  double out[8];
  const auto refused = [&](const char* what, std::int64_t code) {
    // Kinds that a question does not take yet are refused first.
    EXPECT_TRUE(code == VESICA_E_SHAPE || code == VESICA_E_KIND)
        << what << ": " << code << ", " << vesica_kind_name(kind_a) << ' ' << testing::PrintToString(a.numbers) << ", "
        << vesica_kind_name(kind_b) << ' ' << testing::PrintToString(b.numbers);
  };
  vesica_closest_points_f64 gap;
  vesica_penetration_f64 way;
  vesica_impact_f64 impact;
  const vesica_turn_f64 still = {0, 0, 0}, moved = {1, 0, 1};
  EXPECT_EQ(vesica_overlap_f64(kind_a, p, kind_b, q), VESICA_E_SHAPE);
  refused("overlap", vesica_overlap_f64(kind_a, p, kind_b, q));
  refused("interiors", vesica_interiors_overlap_f64(kind_a, p, kind_b, q));
  refused("relation", vesica_relation_f64(kind_a, p, kind_b, q));
  refused("contains", vesica_contains_f64(kind_a, p, kind_b, q));
  refused("nearest", vesica_nearest_f64(kind_a, p, kind_b, q, &gap));
  refused("boundary", vesica_boundary_distance_f64(kind_a, p, kind_b, q, &gap));
  refused("depth", vesica_depth_f64(kind_a, p, kind_b, q, &way));
  refused("signed", vesica_signed_distance_f64(kind_a, p, kind_b, q, out));
  for (const double d : {-infinity, -2.0, -0.0, 2.0, infinity})
    refused("within", vesica_within_f64(kind_a, p, kind_b, q, d));
  refused("area", vesica_area_f64(kind_a, p, kind_b, q, out));
  refused("iou", vesica_iou_f64(kind_a, p, kind_b, q, out));
  for (const std::int32_t ratio : {VESICA_RATIO_OVER_UNION, VESICA_RATIO_GENERALIZED})
    refused("ratio", vesica_ratio_f64(ratio, kind_a, p, kind_b, q, out));
  std::int32_t shared = 0;
  vesica_point_f64 places[8];
  char matrix[VESICA_DE9IM_SIZE];
  refused("crossings", vesica_crossings_f64(kind_a, p, kind_b, q, places, 8, &shared));
  refused("de9im", vesica_de9im_f64(kind_a, p, kind_b, q, matrix));
  refused("intersection", vesica_intersection_f64(kind_a, p, kind_b, q, places, 8));
  refused("cast", vesica_cast_f64(kind_a, p, kind_b, q, 1, 0.25, 1e3, &impact));
  refused("impact_time", vesica_impact_time_f64(kind_a, p, &still, kind_b, q, &moved, 1e-3, &impact, out));
}

TEST(Invalid, IsRefusedBesideEveryKind) {
  for (const Shape& bad : invalid()) {
    for (const Shape& good : valid) {
      expect_refused(good, bad);
      expect_refused(bad, good);
      if (HasFailure()) return;
    }
  }
}

}  // namespace
}  // namespace refused

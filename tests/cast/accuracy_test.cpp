// SPDX-License-Identifier: Apache-2.0
/// The point of contact lies on a's outline, and beside b's place at the time: in units of the header's bound.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "cast/motions.hpp"
#include "properties/generators.hpp"

namespace {

using namespace cast_test;

double size_of(int kind, const Numbers& n) {
  if (kind == VESICA_POINT) return 0;
  if (kind == VESICA_CIRCLE) return n[2];
  if (kind == VESICA_SEGMENT || kind == VESICA_AABB)
    return std::max(std::fabs(n[2] - n[0]), std::fabs(n[3] - n[1])) / 2;
  return std::hypot(n[2], n[3]) * std::max(n[4], n[5]);
}

/// The distance of a point from a shape's outline.
double off_outline(int kind, const Numbers& n, double x, double y) {
  const double point[2] = {x, y};
  vesica_closest_points_f64 out{};
  EXPECT_EQ(vesica_boundary_distance_f64(VESICA_POINT, point, kind, n.data(), &out), 0);
  return out.distance;
}

TEST(Accuracy, OfThePoint) {
  constexpr double u = 0x1p-53;
  double worst = 0;
  int hits = 0;
  for (const properties::Workload workload : {properties::Workload::random, properties::Workload::grid,
                                              properties::Workload::degenerate, properties::Workload::thin}) {
    for (int a = 0; a < properties::kinds; ++a) {
      for (int b = 0; b < properties::kinds; ++b) {
        properties::Stream stream(workload, a, b, Scalar::f64, properties::seed() + 41);
        properties::Random random(properties::seed() + 42);
        for (int i = 0; i < 60 * properties::repeat(); ++i) {
          const Pair p = stream.next();
          const Motion m = draw_motion(p, Scalar::f64, random);
          const Answer r = cast(Scalar::f64, p, m);
          if (r.code != VESICA_CAST_HIT) continue;
          SCOPED_TRACE(describe(p, m));
          const double offset = std::max(std::fabs(p.b[0] - p.a[0]), std::fabs(p.b[1] - p.a[1]));
          const double scale = std::max({offset, size_of(a, p.a), size_of(b, p.b)});
          const double rounding = u * (std::fabs(r.x) + std::fabs(r.y));
          const double off = std::max(off_outline(a, p.a, r.x, r.y) - rounding, 0.0) / (u * scale);
          EXPECT_LE(off, 8);
          worst = std::max(worst, off);
          ++hits;
          if (HasFailure()) return;
        }
      }
    }
  }
  EXPECT_GT(hits, 1000 * properties::repeat());
  std::printf("%d hits, the point up to %.2f u scale off\n", hits, worst);
}

}  // namespace

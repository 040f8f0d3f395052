// SPDX-License-Identifier: Apache-2.0
/// The point of contact lies on a's outline, and that of a ray at the ray's own place at the time: in units of the
/// header's bounds.
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
  const double radius = properties::is_inflated(kind) ? properties::radius(kind, n) : 0;
  if (kind == VESICA_SEGMENT || kind == VESICA_AABB || kind == VESICA_CAPSULE)
    return std::max(std::fabs(n[2] - n[0]), std::fabs(n[3] - n[1])) / 2 + radius;
  return std::hypot(n[2], n[3]) * std::max(n[4], n[5]) + radius;
}

/// The greatest radius of curvature of an ellipse with an area, else 0: straight sides are met where they are.
double bend_of(int kind, const Numbers& n) {
  if (kind != VESICA_ELLIPSE || n[4] == 0 || n[5] == 0) return 0;
  const double longer = std::max(n[4], n[5]), shorter = std::min(n[4], n[5]);
  return std::hypot(n[2], n[3]) * longer * (longer / shorter);
}

/// Whether a ray comes along no face of a straight shape, or nearly so: where the angle is below 2^-80 the header
/// promises the face's corner.
bool meets_faces(int kind, const Numbers& n, const Motion& m) {
  if (properties::is_round(kind)) return true;
  const bool is_segment = kind == VESICA_SEGMENT || kind == VESICA_CAPSULE;
  const bool has_axis = kind == VESICA_RECT || kind == VESICA_ROUND_RECT;
  const double ux = is_segment ? n[2] - n[0] : has_axis ? n[2] : 1, uy = is_segment ? n[3] - n[1] : has_axis ? n[3] : 0;
  const double length = std::hypot(ux, uy), speed = std::hypot(m.vx, m.vy);
  const double c = (ux / length) * (m.vx / speed) + (uy / length) * (m.vy / speed);
  const double k = (ux / length) * (m.vy / speed) - (uy / length) * (m.vx / speed);
  return length == 0 || (std::fabs(c) > 0x1p-40 && std::fabs(k) > 0x1p-40);
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

// How far the point is from the place of the ray at t, which is b + v t but for v times the step after t.
TEST(Accuracy, AlongTheOutline) {
  constexpr double u = 0x1p-53;
  double worst = 0;
  int hits = 0, needles = 0;
  for (const properties::Workload workload : {properties::Workload::random, properties::Workload::grid,
                                              properties::Workload::degenerate, properties::Workload::thin}) {
    for (int a = 0; a < properties::kinds; ++a) {
      properties::Stream stream(workload, a, VESICA_POINT, Scalar::f64, properties::seed() + 43);
      properties::Random random(properties::seed() + 44);
      for (int i = 0; i < 400 * properties::repeat(); ++i) {
        const Pair p = stream.next();
        const Motion m = draw_motion(p, Scalar::f64, random);
        const Answer r = cast(Scalar::f64, p, m);
        const double speed = std::hypot(m.vx, m.vy), straight = -(r.nx * (m.vx / speed) + r.ny * (m.vy / speed));
        if (r.code != VESICA_CAST_HIT || !(straight > 1e-12) || !std::isfinite(speed)) continue;
        if (!meets_faces(a, p.a, m)) continue;
        SCOPED_TRACE(describe(p, m));
        const double offset = std::max(std::fabs(p.b[0] - p.a[0]), std::fabs(p.b[1] - p.a[1]));
        const double scale = std::max(offset, size_of(a, p.a)), bend = bend_of(a, p.a);
        const double step = std::max(2 * u * r.t, 0x1p-1074),
                     rounding = u * (std::fabs(r.x) + std::fabs(r.y)) + step * speed;
        const double off = std::hypot(std::fma(m.vx, r.t, p.b[0] - r.x), std::fma(m.vy, r.t, p.b[1] - r.y));
        const double share = off / ((8 * u * scale + 4 * u * bend) / straight + rounding + u * scale);
        EXPECT_LE(share, 1);
        worst = std::max(worst, share);
        ++hits;
        needles += bend > 1e6 * scale;
        if (HasFailure()) return;
      }
    }
  }
  EXPECT_GT(hits, 500 * properties::repeat());
  EXPECT_GT(needles, 0);
  std::printf("%d hits, %d of needles, the point up to %.2f of the bound off\n", hits, needles, worst);
}

}  // namespace

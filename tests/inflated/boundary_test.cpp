// SPDX-License-Identifier: Apache-2.0
// The distance of outlines, against the support functions of nested shapes and by the points found.
#include <gtest/gtest.h>
#include <vesica_topology.h>

#include <algorithm>
#include <cmath>

#include "inflated/shapes.hpp"

namespace inflated_boundary {
namespace {

using namespace inflated;
using properties::Random;

/// Sizes are about 1 and places within 6 of the origin.
constexpr double tolerance = 12 * 6 * 0x1p-53;

vesica_closest_points_f64 boundary_distance(const Shape& a, const Shape& b) {
  vesica_closest_points_f64 found{-1, 0, 0, 0, 0};
  EXPECT_EQ(vesica_boundary_distance_f64(a.kind, a.number.data(), b.kind, b.number.data(), &found), 0);
  return found;
}

/// A core as a rectangle with a unit axis.
struct Frame {
  long double x, y, ux, uy, hx, hy, radius;
};
Frame frame(const Shape& s) {
  const Shape k = core(s);
  const auto& n = k.number;
  Frame f{n[0], n[1], 1, 0, 0, 0, radius(s)};
  if (k.kind == VESICA_SEGMENT || k.kind == VESICA_AABB) {
    f.x = (static_cast<long double>(n[0]) + n[2]) / 2;
    f.y = (static_cast<long double>(n[1]) + n[3]) / 2;
    f.hx = (static_cast<long double>(n[2]) - n[0]) / 2;
    f.hy = (static_cast<long double>(n[3]) - n[1]) / 2;
  }
  if (k.kind == VESICA_SEGMENT) f.ux = f.hx, f.uy = f.hy, f.hx = 1, f.hy = 0;
  if (k.kind == VESICA_RECT) f.ux = n[2], f.uy = n[3], f.hx = n[4], f.hy = n[5];
  const long double length = std::hypot(f.ux, f.uy);
  if (length == 0) return {f.x, f.y, 1, 0, 0, 0, f.radius};
  return {f.x, f.y, f.ux / length, f.uy / length, f.hx * length, f.hy * length, f.radius};
}

/// How far a point is from the outline.
double off(const Shape& s, double px, double py) {
  const Frame f = frame(s);
  const long double dx = px - f.x, dy = py - f.y;
  const long double x = std::fabs(dx * f.ux + dy * f.uy) - f.hx, y = std::fabs(dy * f.ux - dx * f.uy) - f.hy;
  const long double outside = std::hypot(std::max(x, 0.0L), std::max(y, 0.0L));
  return static_cast<double>(std::fabs((outside > 0 ? outside : std::max(x, y)) - f.radius));
}

long double support(const Shape& s, long double nx, long double ny) {
  const Frame f = frame(s);
  return f.x * nx + f.y * ny + f.hx * std::fabs(f.ux * nx + f.uy * ny) + f.hy * std::fabs(f.ux * ny - f.uy * nx) +
         f.radius;
}

/// The least way from the inner shape to the outer one's outline, over many directions and the outer one's sides.
double least_room(const Shape& outer, const Shape& inner) {
  long double least = 100;
  const auto consider = [&](long double x, long double y) {
    least = std::min(least, support(outer, x, y) - support(inner, x, y));
  };
  const Frame f = frame(outer);
  for (const long double sign : {-1.0L, 1.0L}) {
    consider(sign * f.ux, sign * f.uy);
    consider(-sign * f.uy, sign * f.ux);
  }
  for (int k = 0; k < 512; ++k) consider(std::cos(k * 0.012271846L), std::sin(k * 0.012271846L));
  return static_cast<double>(least);
}

/// Moves the second shape's centre near the first one's and makes it smaller.
void nest(const Shape& outer, Shape& inner, Random& random) {
  const Frame f = frame(outer), g = frame(inner);
  const double k = std::exp2(-random.between(0, 6)), x = static_cast<double>(f.x) + random.between(-0.5, 0.5),
               y = static_cast<double>(f.y) + random.between(-0.5, 0.5);
  const bool has_ends = inner.kind == VESICA_SEGMENT || inner.kind == VESICA_AABB || inner.kind == VESICA_CAPSULE;
  const int fields = vesica_field_count(inner.kind);
  for (int i = 0; i < fields; ++i) {
    double& n = inner.number[static_cast<std::size_t>(i)];
    const double from = static_cast<double>(i % 2 == 0 ? g.x : g.y), to = i % 2 == 0 ? x : y;
    if (i < 2 || (has_ends && i < 4)) {
      n = to + k * (n - from);
    } else if (!(inner.kind == VESICA_RECT || inner.kind == VESICA_ROUND_RECT) || i >= 4) {
      n *= k;
    }
  }
}

TEST(InflatedBoundary, IsTheLeastDistanceOfTheOutlines) {
  Random random(properties::seed());
  int nested = 0, met = 0, apart = 0;
  for (int i = 0; i < 20000 * properties::repeat(); ++i) {
    Shape a = any_shape(random, 5), b = inflated_shape(random);
    if (random.below(4) == 0) a = inflated_shape(random);
    if (i % 2 == 0) random.below(2) == 0 ? nest(a, b, random) : nest(b, a, random);
    const auto found = boundary_distance(a, b), exchanged = boundary_distance(b, a);
    ASSERT_EQ(found.distance, exchanged.distance);
    ASSERT_EQ((std::array{found.ax, found.ay, found.bx, found.by}),
              (std::array{exchanged.bx, exchanged.by, exchanged.ax, exchanged.ay}));
    ASSERT_LE(off(a, found.ax, found.ay), tolerance) << i;
    ASSERT_LE(off(b, found.bx, found.by), tolerance) << i;
    ASSERT_NEAR(found.distance, std::hypot(found.bx - found.ax, found.by - found.ay), 2 * tolerance) << i;
    const int relation = vesica_relation_f64(a.kind, a.number.data(), b.kind, b.number.data());
    const bool inside = relation == VESICA_INSIDE, contains = relation == VESICA_CONTAINS;
    ASSERT_EQ(found.distance > 0, relation == VESICA_DISJOINT || inside || contains) << i;
    if (inside || contains) {
      ++nested;
      ASSERT_LE(found.distance, (inside ? least_room(b, a) : least_room(a, b)) + tolerance) << i;
    } else if (relation == VESICA_DISJOINT) {
      ++apart;
    } else {
      ++met;
      ASSERT_EQ(found.ax, found.bx);
      ASSERT_EQ(found.ay, found.by);
    }
  }
  EXPECT_GT(nested, 100 * properties::repeat());
  EXPECT_GT(met, 100 * properties::repeat());
  EXPECT_GT(apart, 100 * properties::repeat());
}

TEST(InflatedBoundary, KnownPoints) {
  const vesica_capsule_f64 capsule{0, 0, 10, 0, 1};
  const vesica_point_f64 point{9, 0.5};
  vesica_closest_points_f64 found;
  ASSERT_EQ(vesica_boundary_distance_f64(VESICA_POINT, &point, VESICA_CAPSULE, &capsule, &found), 0);
  EXPECT_EQ((std::array{found.distance, found.ax, found.ay, found.bx, found.by}),
            (std::array{0.5, 9.0, 0.5, 9.0, 1.0}));
  const vesica_round_rect_f64 rect{5, 0, 1, 0, 8, 4, 2};
  ASSERT_EQ(vesica_boundary_distance_f64(VESICA_CAPSULE, &capsule, VESICA_ROUND_RECT, &rect, &found), 0);
  EXPECT_EQ(found.distance, 4);
  EXPECT_EQ(found.ax, -1);
  EXPECT_EQ(found.bx, -5);
  // A capsule around the centre of a disc that just holds it: the closest points are at the caps.
  const vesica_circle_f64 circle{5, 0, 6.25};
  ASSERT_EQ(vesica_boundary_distance_f64(VESICA_CIRCLE, &circle, VESICA_CAPSULE, &capsule, &found), 0);
  EXPECT_EQ(found.distance, 0.25);
  EXPECT_EQ(std::fabs(found.bx - 5), 6);
}

/// Contact from inside and outside, along a stretch, and equal sets of points.
TEST(InflatedBoundary, OutlinesThatTouch) {
  const Shape capsule{VESICA_CAPSULE, {0, 0, 10, 0, 1}};
  for (const Shape& other :
       {Shape{VESICA_CAPSULE, {0, 0, 10, 0, 1}}, Shape{VESICA_CAPSULE, {10, 0, 0, 0, 1}},
        Shape{VESICA_CIRCLE, {0, 0, 1}}, Shape{VESICA_CIRCLE, {3, 0, 1}}, Shape{VESICA_CIRCLE, {3, 3, 2}},
        Shape{VESICA_CAPSULE, {2, 0, 4, 0, 1}}, Shape{VESICA_SEGMENT, {2, 1, 4, 1}}, Shape{VESICA_POINT, {-1, 0}},
        Shape{VESICA_AABB, {2, 1, 20, 3}}, Shape{VESICA_RECT, {5, 0, 1, 0, 6, 1}},
        Shape{VESICA_ROUND_RECT, {5, 0, 3, 4, 0.125, 0.0625, 0.0}},
        Shape{VESICA_ROUND_RECT, {5, 0, 2, 0, 2.5, 0, 1}}}) {
    const auto found = boundary_distance(capsule, other);
    const bool clear = other.kind == VESICA_ROUND_RECT && other.number[3] == 4;
    EXPECT_EQ(found.distance > 0, clear) << other.kind;
    EXPECT_LE(off(capsule, found.ax, found.ay), tolerance) << other.kind;
    EXPECT_LE(off(other, found.bx, found.by), tolerance) << other.kind;
  }
}

/// Where shapes overlap: without a radius the core's answer, without a size a circle's, to the bit.
TEST(InflatedBoundary, IsThatOfTheSimplestKind) {
  Random random(properties::seed());
  for (int i = 0; i < 5000 * properties::repeat(); ++i) {
    Shape a = inflated_shape(random), b = any_shape(random, 5);
    Shape simple;
    if (random.below(2) == 0) {
      a.number[a.kind == VESICA_CAPSULE ? 4 : 6] = 0;
      simple = core(a);
    } else {
      if (a.kind == VESICA_CAPSULE) a.number[2] = a.number[0], a.number[3] = a.number[1];
      if (a.kind == VESICA_ROUND_RECT) a.number[4] = a.number[5] = 0;
      simple = {VESICA_CIRCLE, {a.number[0], a.number[1], radius(a)}};
    }
    if (i % 2 == 0) nest(simple, b, random);
    if (vesica_relation_f64(a.kind, a.number.data(), b.kind, b.number.data()) == VESICA_DISJOINT) continue;
    const auto found = boundary_distance(a, b), expected = boundary_distance(simple, b);
    ASSERT_EQ((std::array{found.distance, found.ax, found.ay, found.bx, found.by}),
              (std::array{expected.distance, expected.ax, expected.ay, expected.bx, expected.by}))
        << i;
  }
}

/// At any scale a length of the pair may be lost beside a far larger one, but no answer becomes 0 or NaN.
TEST(InflatedBoundary, AtAnyScale) {
  for (const int exponent : {-1060, -500, 0, 500, 1015}) {
    const double k = std::ldexp(1, exponent);
    const Shape outer{VESICA_ROUND_RECT, {0, 0, 1, 0, 8 * k, 4 * k, 2 * k}};
    const Shape inner{VESICA_CAPSULE, {-4 * k, k, 4 * k, k, k}};
    const auto found = boundary_distance(outer, inner);
    EXPECT_EQ(found.distance, 4 * k) << exponent;
    EXPECT_EQ(found.ay, 6 * k);
    EXPECT_EQ(found.by, 2 * k);
    const Shape crossing{VESICA_CAPSULE, {0, 0, 40 * k, 0, k}};
    const auto met = boundary_distance(outer, crossing);
    EXPECT_EQ(met.distance, 0);
    EXPECT_EQ(met.ax, 10 * k);
    EXPECT_EQ(std::fabs(met.ay), k);
  }
}

TEST(InflatedBoundary, BadInput) {
  vesica_closest_points_f64 found{7, 7, 7, 7, 7};
  const vesica_capsule_f64 good{0, 0, 1, 0, 1}, negative{0, 0, 1, 0, -1}, nan{0, 0, NAN, 0, 1};
  const vesica_ellipse_f64 bad{0, 0, 1, 0, 2, -1};
  EXPECT_EQ(vesica_boundary_distance_f64(VESICA_CAPSULE, &good, VESICA_CAPSULE, &negative, &found), VESICA_E_SHAPE);
  EXPECT_EQ(vesica_boundary_distance_f64(VESICA_CAPSULE, &nan, VESICA_CAPSULE, &good, &found), VESICA_E_SHAPE);
  EXPECT_EQ(vesica_boundary_distance_f64(VESICA_CAPSULE, &good, VESICA_ELLIPSE, &bad, &found), VESICA_E_SHAPE);
  EXPECT_EQ(found.distance, 7);
}

}  // namespace
}  // namespace inflated_boundary

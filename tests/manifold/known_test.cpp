// SPDX-License-Identifier: Apache-2.0
// Contacts that one can see, and bad input.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vesica/manifold.hpp>
#include <vesica/polygon/manifold.hpp>

#include "vesica.h"

namespace manifold_known {

using Manifold = vesica_contacts_f64;

constexpr double inf = std::numeric_limits<double>::infinity();

inline void expect_same(const Manifold& m, const Manifold& expected) {
  EXPECT_EQ(m.count, expected.count);
  for (const auto field : {&Manifold::nx, &Manifold::ny, &Manifold::x0, &Manifold::y0, &Manifold::depth0, &Manifold::x1,
                           &Manifold::y1, &Manifold::depth1}) {
    EXPECT_EQ(m.*field, expected.*field);
  }
  for (const auto field : {&Manifold::a0, &Manifold::b0, &Manifold::a1, &Manifold::b1})
    EXPECT_EQ(m.*field, expected.*field);
}

template <class A, class B>
Manifold ask(std::int32_t kind_a, const A& a, std::int32_t kind_b, const B& b) {
  Manifold m;
  std::memset(&m, 0x55, sizeof m);
  EXPECT_EQ(vesica_manifold_f64(kind_a, &a, kind_b, &b, &m), m.count);
  return m;
}

constexpr vesica_rect_f64 ground{0, 0, 1, 0, 4, 1};

/// A box that sinks in by 1/8: contacts at both of its lower corners, from right to left.
TEST(ManifoldKnown, BoxOnBox) {
  const vesica_rect_f64 box{1, 1.875, 1, 0, 1, 1};
  expect_same(ask(VESICA_RECT, ground, VESICA_RECT, box), {0, 1, 2, 0.9375, 0.125, 0, 0.9375, 0.125, 2, 1, 3, 0, 2});
  expect_same(ask(VESICA_RECT, box, VESICA_RECT, ground), {0, -1, 0, 0.9375, 0.125, 2, 0.9375, 0.125, 0, 3, 1, 2, 2});
}

/// Beyond the ground's end the contact is at the ground's corner, under the same numbers.
TEST(ManifoldKnown, BoxOverTheEnd) {
  const vesica_rect_f64 box{4.5, 1.875, 1, 0, 1, 1};
  expect_same(ask(VESICA_RECT, ground, VESICA_RECT, box), {0, 1, 4, 0.9375, 0.125, 3.5, 0.9375, 0.125, 2, 1, 3, 0, 2});
}

TEST(ManifoldKnown, FlushBoxesTouchTwice) {
  const vesica_aabb_f64 low{0, 0, 2, 1}, high{-1, 1, 1, 3}, beside{2, 1, 3, 2};
  expect_same(ask(VESICA_AABB, low, VESICA_AABB, high), {0, 1, 1, 1, 0, 0, 1, 0, 2, 1, 3, 0, 2});
  // Corner at corner: one contact.
  EXPECT_EQ(ask(VESICA_AABB, low, VESICA_AABB, beside).count, 1);
}

/// A slope of 3/4 sinks in by 1/8 with its corner: the other corner is far out.
TEST(ManifoldKnown, CornerInFace) {
  const vesica_rect_f64 box{0, 2.275, 0.8, 0.6, 1, 1};
  const Manifold m = ask(VESICA_RECT, ground, VESICA_RECT, box);
  EXPECT_EQ(m.count, 1);
  EXPECT_NEAR(m.x0, -0.2, 1e-15);
  EXPECT_NEAR(m.y0, 0.9375, 1e-15);
  EXPECT_NEAR(m.depth0, 0.125, 1e-15);
  EXPECT_EQ(m.b0, 0);
}

/// Lowered further, the edge's other corner sinks in too: then there are two.
TEST(ManifoldKnown, TiltedBoxSinks) {
  const vesica_rect_f64 box{0, 1.875, 1, 0.0625, 1, 1};  // its corners are at 0.8125 and 0.9375
  const Manifold m = ask(VESICA_RECT, ground, VESICA_RECT, box);
  EXPECT_EQ(m.count, 2);
  EXPECT_NEAR(m.depth0, 0.0625, 1e-15);
  EXPECT_NEAR(m.depth1, 0.1875, 1e-15);
}

TEST(ManifoldKnown, RoundShapes) {
  const vesica_circle_f64 one{0, 0, 1}, two{3, 0, 2.5};
  expect_same(ask(VESICA_CIRCLE, one, VESICA_CIRCLE, two), {1, 0, 0.75, 0, 0.5, 0, 0, 0, 0, 0, 0, 0, 1});
  const vesica_ellipse_f64 ellipse{0, 1.5, 1, 0, 3, 1};
  expect_same(ask(VESICA_RECT, ground, VESICA_ELLIPSE, ellipse), {0, 1, 0, 0.75, 0.5, 0, 0, 0, 2, 0, 0, 0, 1});
  const vesica_capsule_f64 low{-1, 0, 1, 0, 0.5}, high{0, 0.75, 3, 0.75, 0.5}, behind{1.75, 0, 3, 0, 0.5};
  expect_same(ask(VESICA_CAPSULE, low, VESICA_CAPSULE, high), {0, 1, 1, 0.375, 0.25, 0, 0.375, 0.25, 1, 1, 0, 0, 2});
  // End to end.
  expect_same(ask(VESICA_CAPSULE, low, VESICA_CAPSULE, behind), {1, 0, 1.375, 0, 0.25, 0, 0, 0, 1, 0, 0, 0, 1});
  const vesica_round_rect_f64 round{0, 1.75, 1, 0, 1, 0.5, 0.5};
  expect_same(ask(VESICA_RECT, ground, VESICA_ROUND_RECT, round),
              {0, 1, 1, 0.875, 0.25, -1, 0.875, 0.25, 2, 1, 3, 0, 2});
}

TEST(ManifoldKnown, ShapesWithoutArea) {
  const vesica_point_f64 point{0.5, 0.75};
  expect_same(ask(VESICA_RECT, ground, VESICA_POINT, point), {0, 1, 0.5, 0.875, 0.25, 0, 0, 0, 2, 0, 0, 0, 1});
  const vesica_segment_f64 along{-1, 1, 1, 1}, upright{0, 0.75, 0, 3}, other{0, 1, 5, 1};
  expect_same(ask(VESICA_RECT, ground, VESICA_SEGMENT, along), {0, 1, 1, 1, 0, -1, 1, 0, 2, 1, 3, 0, 2});
  expect_same(ask(VESICA_RECT, ground, VESICA_SEGMENT, upright), {0, 1, 0, 0.875, 0.25, 0, 0, 0, 2, 0, 0, 0, 1});
  EXPECT_EQ(ask(VESICA_SEGMENT, along, VESICA_SEGMENT, other).count, 2);
  EXPECT_EQ(ask(VESICA_POINT, point, VESICA_POINT, point).count, 1);
  const vesica_rect_f64 dot{0, 0.75, 1, 0, 0, 0};
  EXPECT_EQ(ask(VESICA_RECT, ground, VESICA_RECT, dot).count, 1);
}

TEST(ManifoldKnown, Apart) {
  const vesica_circle_f64 far{9, 9, 1};
  expect_same(ask(VESICA_RECT, ground, VESICA_CIRCLE, far), {});
}

/// The ground as a polygon, its upper edge in three parts, clockwise, its first vertex repeated.
TEST(ManifoldKnown, CollinearEdgesAreOne) {
  const double x[] = {4, 4, -4, -4, -1, 1, 4}, y[] = {1, -1, -1, 1, 1, 1, 1};
  const vesica_polygon_f64 polygon{x, y, sizeof(double), nullptr, 7};
  for (const double at : {0.0, 2.0, -1.5}) {
    const vesica_rect_f64 box{at, 1.875, 1, 0, 1, 1};
    const Manifold m = ask(VESICA_POLYGON, polygon, VESICA_RECT, box);
    EXPECT_EQ(m.count, 2);
    EXPECT_EQ(m.x0, at + 1);
    EXPECT_EQ(m.x1, at - 1);
    EXPECT_EQ(m.depth0, 0.125);
    EXPECT_EQ(m.depth1, 0.125);
    EXPECT_TRUE(m.a0 == 0 || m.a0 == 6);
    EXPECT_EQ(m.a1, 3);
  }
}

TEST(ManifoldKnown, VertexNumbersCountFromTheFirstStored) {
  const double x[] = {9, 9, 0, 2, 2, 0}, y[] = {9, 9, 0, 0, 1, 1};
  const std::int32_t rings[] = {2, 6};
  const vesica_polygon_f64 polygon{x, y, sizeof(double), rings, 1};
  const vesica_aabb_f64 box{1, 0.75, 3, 3};
  const Manifold m = ask(VESICA_POLYGON, polygon, VESICA_AABB, box);
  expect_same(m, {0, 1, 2, 0.875, 0.25, 1, 0.875, 0.25, 4, 1, 5, 0, 2});
}

TEST(ManifoldKnown, Macro) {
  const vesica_aabb_f32 low{0, 0, 2, 1}, high{-1, 0.75f, 1, 3};
  vesica_contacts_f32 m;
  ASSERT_EQ(vesica_manifold_f32(VESICA_AABB, &low, VESICA_AABB, &high, &m), 2);
  EXPECT_EQ(m.depth0, 0.25f);
  EXPECT_EQ(m.x0, 1);
}

TEST(ManifoldKnown, CoreFunctions) {
  const vesica::Rect<float> a{0, 0, 1, 0, 4, 1}, b{1, 1.875f, 1, 0, 1, 1};
  const vesica::Contacts<float> m = vesica::manifold(a, b);
  EXPECT_EQ(m.count, 2);
  EXPECT_EQ(m.x0, 2);
  EXPECT_EQ(m.depth1, 0.125f);
  const float x[] = {-4, 4, 4, -4}, y[] = {-1, -1, 1, 1};
  const vesica::Polygon<float> floor{x, y, sizeof(float), nullptr, 4};
  vesica::Contacts<float> n{};
  EXPECT_EQ(vesica::manifold_or_error(b, floor, n), 2);
  EXPECT_EQ(n.ny, -1);
  EXPECT_EQ(n.x1, 2);
  EXPECT_EQ(n.b1, 2);
  EXPECT_EQ(vesica::manifold_or_error(vesica::Circle<float>{0, 0, -1}, a, n), vesica::error_shape);
  EXPECT_EQ(vesica::manifold(vesica::Circle<float>{0, 0, -1}, a).count, 0);
}

TEST(ManifoldKnown, Errors) {
  Manifold m, before;
  std::memset(&m, 0x55, sizeof m);
  before = m;
  const vesica_rect_f64 bad{0, 0, 0, 0, 1, 1};
  const double notch_x[] = {0, 4, 4, 2, 0}, notch_y[] = {0, 0, 4, 1, 4};
  const vesica_polygon_f64 notched{notch_x, notch_y, sizeof(double), nullptr, 5};
  const vesica_aabb_f64 huge{-1.5e308, -1.5e308, 1.5e308, 1.5e308};
  EXPECT_EQ(vesica_manifold_f64(VESICA_RECT, nullptr, VESICA_RECT, &ground, &m), VESICA_E_NULL);
  EXPECT_EQ(vesica_manifold_f64(VESICA_RECT, &ground, VESICA_RECT, nullptr, &m), VESICA_E_NULL);
  EXPECT_EQ(vesica_manifold_f64(VESICA_RECT, &ground, VESICA_RECT, &ground, nullptr), VESICA_E_NULL);
  EXPECT_EQ(vesica_manifold_f64(-1, &ground, VESICA_RECT, &ground, &m), VESICA_E_KIND);
  EXPECT_EQ(vesica_manifold_f64(VESICA_RECT, &ground, 10, &ground, &m), VESICA_E_KIND);
  EXPECT_EQ(vesica_manifold_f64(VESICA_RECT, &ground, VESICA_RECT, &bad, &m), VESICA_E_SHAPE);
  EXPECT_EQ(vesica_manifold_f64(VESICA_POLYGON, &notched, VESICA_RECT, &bad, &m), VESICA_E_SHAPE);
  EXPECT_EQ(vesica_manifold_f64(VESICA_RECT, &ground, VESICA_POLYGON, &notched, &m), VESICA_E_NOT_CONVEX);
  EXPECT_EQ(vesica_manifold_f64(VESICA_AABB, &huge, VESICA_AABB, &huge, &m), VESICA_E_RANGE);
  EXPECT_EQ(std::memcmp(&m, &before, sizeof m), 0);
}

TEST(ManifoldKnown, Arrays) {
  const vesica_rect_f64 boxes[] = {
      {0, 1.875, 1, 0, 1, 1}, {0, 9, 1, 0, 1, 1}, {0, NAN, 1, 0, 1, 1}, {2, 1.9, 1, 0.1, 1, 1}};
  vesica_shapes_f64 many, one;
  ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_RECT, 4, boxes, sizeof *boxes, &many), 0);
  ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_RECT, 1, &ground, sizeof ground, &one), 0);
  Manifold out[5];
  std::memset(out, 0x55, sizeof out);
  EXPECT_EQ(vesica_manifold_many_f64(&one, &many, out), VESICA_E_SHAPE);
  for (const int i : {0, 1, 3}) expect_same(out[i], ask(VESICA_RECT, ground, VESICA_RECT, boxes[i]));
  expect_same(out[2], {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, VESICA_E_SHAPE});
  EXPECT_EQ(out[4].count, 0x5555555555555555);
  many.count = 2;
  EXPECT_EQ(vesica_manifold_many_f64(&many, &one, out), 1);
  EXPECT_EQ(out[0].ny, -1);
  EXPECT_EQ(vesica_manifold_many_f64(&many, &many, nullptr), VESICA_E_NULL);
  EXPECT_EQ(vesica_manifold_many_f64(nullptr, &many, out), VESICA_E_NULL);
  vesica_shapes_f64 three = many;
  three.count = 3;
  EXPECT_EQ(vesica_manifold_many_f64(&many, &three, out), VESICA_E_ARGUMENT);
  many.count = 0;
  EXPECT_EQ(vesica_manifold_many_f64(&many, &one, nullptr), 0);
  many.kind = 10;
  EXPECT_EQ(vesica_manifold_many_f64(&many, &one, out), VESICA_E_KIND);
}

TEST(ManifoldKnown, ArraysOfPolygons) {
  const double quads[] = {0, 0, 2, 0, 2, 1, 0, 1, 0, 0, 4, 0, 4, 4, 2, 1};  // the second has a notch
  vesica_shapes_f64 many{}, one;
  many.kind = VESICA_POLYGON;
  many.count = 2;
  many.field[0] = quads, many.field[1] = quads + 1;
  many.stride = 2 * sizeof(double);
  many.each = 4;
  const vesica_aabb_f64 box{1, 0.75, 3, 3};
  ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_AABB, 1, &box, sizeof box, &one), 0);
  Manifold out[2];
  const std::int64_t found = vesica_manifold_many_f64(&many, &one, out);
  expect_same(out[0], {0, 1, 2, 0.875, 0.25, 1, 0.875, 0.25, 2, 1, 3, 0, 2});
  EXPECT_EQ(found, out[1].count < 0 ? out[1].count : 2);
}

TEST(ManifoldKnown, Infinite) {
  const vesica_circle_f64 round{0, 0, inf};
  Manifold m;
  EXPECT_EQ(vesica_manifold_f64(VESICA_RECT, &ground, VESICA_CIRCLE, &round, &m), VESICA_E_SHAPE);
}

}  // namespace manifold_known

// SPDX-License-Identifier: Apache-2.0
// Convex hulls and the smallest rectangles: against their definitions in integers, laws, near-ties, bad input.
#include <gtest/gtest.h>
#include <vesica_boxes.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "polygon/shapes.hpp"
#include "properties/random.hpp"

namespace polygon_hull {

using namespace polygons;
using Points = std::vector<vesica_point_f64>;

inline vesica_polygon_f64 as_path(const Points& points) {
  return {&points[0].x, &points[0].y, sizeof(vesica_point_f64), nullptr, static_cast<std::int64_t>(points.size())};
}
inline Points hull(const Points& points) {
  const vesica_polygon_f64 path = as_path(points);
  Points out(points.size());
  const std::int64_t corners = vesica_convex_hull_f64(&path, out.data(), path.count);
  EXPECT_GE(corners, 1);
  out.resize(static_cast<std::size_t>(std::max<std::int64_t>(corners, 0)));
  return out;
}
inline bool operator_same(const vesica_point_f64& a, const vesica_point_f64& b) { return a.x == b.x && a.y == b.y; }
inline bool same(const Points& a, const Points& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), operator_same);
}
inline void scale(Points& points, double factor) {
  for (vesica_point_f64& p : points) p = {p.x * factor, p.y * factor};
}
inline void move(Points& points, double dx, double dy) {
  for (vesica_point_f64& p : points) p = {p.x + dx, p.y + dy};
}

/// (b - a) x (c - a) of integers.
inline long double cross(const vesica_point_f64& a, const vesica_point_f64& b, const vesica_point_f64& c) {
  const long double ax = a.x, ay = a.y;
  return (b.x - ax) * (c.y - ay) - (b.y - ay) * (c.x - ax);
}
inline long double dot(const vesica_point_f64& a, const vesica_point_f64& b, const vesica_point_f64& c) {
  const long double ax = a.x, ay = a.y;
  return (b.x - ax) * (c.x - ax) + (b.y - ay) * (c.y - ay);
}

/// The hull of integers by its definition: the next corner is the point that has all others on the left, the farthest.
inline Points wrapped(const Points& points) {
  const auto before = [](const auto& a, const auto& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
  const vesica_point_f64 first = *std::min_element(points.begin(), points.end(), before);
  Points out;
  vesica_point_f64 at = first;
  do {
    out.push_back(at);
    vesica_point_f64 next = at;
    for (const vesica_point_f64& p : points) {
      const long double c = cross(at, next, p);
      if (operator_same(next, at) || c < 0 || (c == 0 && dot(at, p, p) > dot(at, next, next))) next = p;
    }
    at = next;
  } while (!operator_same(at, first));
  return out;
}

/// The least area and perimeter of all rectangles with a side along an edge of a hull with area.
struct Least {
  long double area, perimeter;
};
inline Least least_of(const Points& corners) {
  constexpr long double most = std::numeric_limits<long double>::infinity();
  Least least{most, most};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto &p = corners[i], &q = corners[(i + 1) % corners.size()];
    long double ahead = -most, behind = most, top = 0;
    for (const auto& r : corners) {
      ahead = std::max(ahead, dot(p, q, r));
      behind = std::min(behind, dot(p, q, r));
      top = std::max(top, cross(p, q, r));
    }
    const long double squared = dot(p, q, q);
    least.area = std::min(least.area, (ahead - behind) * top / squared);
    least.perimeter = std::min(least.perimeter, 2 * (ahead - behind + top) / std::sqrt(squared));
  }
  return least;
}

/// The distance of the farthest point outside a rectangle, and of the farthest side from its nearest point.
struct Fit {
  long double outside = 0, loose = 0;
};
inline Fit fit(const Points& points, const vesica_rect_f64& r) {
  constexpr long double most = std::numeric_limits<long double>::infinity();
  long double reach[4] = {-most, -most, -most, -most};
  const long double length = std::hypot(static_cast<long double>(r.ux), static_cast<long double>(r.uy));
  for (const auto& p : points) {
    const long double dx = static_cast<long double>(p.x) - r.cx, dy = static_cast<long double>(p.y) - r.cy;
    const long double u = (dx * r.ux + dy * r.uy) / length, v = (dy * r.ux - dx * r.uy) / length;
    const long double from[] = {u - r.hx * length, -u - r.hx * length, v - r.hy * length, -v - r.hy * length};
    for (int k = 0; k < 4; ++k) reach[k] = std::max(reach[k], from[k]);
  }
  Fit out;
  for (const long double d : reach) {
    out.outside = std::max(out.outside, d);
    out.loose = std::max(out.loose, -d);
  }
  return out;
}
inline double largest(const Points& points) {
  double most = 0;
  for (const auto& p : points) most = std::max({most, std::abs(p.x), std::abs(p.y)});
  return most;
}
constexpr double u = 0x1p-53;

inline vesica_rect_f64 rect_about(const Points& points, bool perimeter = false) {
  const vesica_polygon_f64 path = as_path(points);
  vesica_rect_f64 r{9, 9, 9, 9, 9, 9};
  EXPECT_EQ(perimeter ? vesica_min_perimeter_rect_f64(&path, &r) : vesica_min_area_rect_f64(&path, &r), 0);
  return r;
}
inline void expect_same(const vesica_rect_f64& a, const vesica_rect_f64& b) {
  EXPECT_EQ(a.cx, b.cx);
  EXPECT_EQ(a.cy, b.cy);
  EXPECT_EQ(a.ux, b.ux);
  EXPECT_EQ(a.uy, b.uy);
  EXPECT_EQ(a.hx, b.hx);
  EXPECT_EQ(a.hy, b.hy);
}

inline Points lattice(Random& random) {
  const int size = random.integer(1, 9), n = random.integer(1, 14);
  Points points;
  for (int i = 0; i < n; ++i) {
    points.push_back({static_cast<double>(random.below(size)), static_cast<double>(random.below(size))});
  }
  return points;
}
inline Points shuffled(Points points, Random& random) {
  for (std::size_t i = points.size(); i > 1; --i) {
    std::swap(points[i - 1], points[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  }
  return points;
}

TEST(PolygonHull, IsThatOfItsDefinition) {
  Random random(41);
  int corners_seen[16] = {};
  for (int n = 100000 * properties::repeat(); n > 0; --n) {
    Points points = lattice(random);
    const Points expected = wrapped(points);
    ++corners_seen[std::min<std::size_t>(expected.size(), 15)];
    ASSERT_TRUE(same(hull(points), expected));
    ASSERT_TRUE(same(hull(shuffled(points, random)), expected));
    // Near the ends of the range, and far from the origin, where integers are exact still.
    for (const double factor : {0x1p-1060, 0x1p1015}) {
      Points scaled = points, corners = expected;
      scale(scaled, factor);
      scale(corners, factor);
      ASSERT_TRUE(same(hull(scaled), corners));
    }
    Points moved = points, corners = expected;
    move(moved, 1e15, -1e15);
    move(corners, 1e15, -1e15);
    ASSERT_TRUE(same(hull(moved), corners));
  }
  for (int k = 1; k <= 8; ++k) EXPECT_GT(corners_seen[k], 20) << k;
}

// A middle point is a corner or not by one unit in its last place, where products of doubles are equal.
TEST(PolygonHull, IsExactBesideALine) {
  Random random(42);
  for (int n = 20000 * properties::repeat(); n > 0; --n) {
    const vesica_point_f64 a{random.between(-1, 1), random.between(-1, 1)};
    const double dx = random.between(0.001, 1), dy = random.between(-1, 1);
    const vesica_point_f64 m{a.x + dx, a.y + dy}, b{a.x + 2 * dx, a.y + 2 * dy};
    for (const double to : {-2.0, 2.0}) {
      const vesica_point_f64 beside{m.x, std::nextafter(m.y, to)};
      // The third corner is on one side, so that the middle is a corner if it is on the other.
      const vesica_point_f64 third{m.x, m.y + 5};
      const __float128 side = (static_cast<__float128>(b.x) - a.x) * (static_cast<__float128>(beside.y) - a.y) -
                              (static_cast<__float128>(b.y) - a.y) * (static_cast<__float128>(beside.x) - a.x);
      EXPECT_EQ(hull({beside, third, b, a}).size(), side < 0 ? 4u : 3u);
    }
  }
}

TEST(PolygonHull, TakesManyPoints) {
  Random random(43);
  Points cloud, circle;
  for (int i = 0; i < 200000; ++i) cloud.push_back({random.between(-1, 1), random.between(-1, 1)});
  for (int i = 0; i < 5000; ++i) circle.push_back({std::cos(i * 1e-3), std::sin(i * 1e-3)});
  const Points corners = hull(cloud);
  EXPECT_LT(corners.size(), 200u);
  EXPECT_TRUE(same(hull(corners), corners));
  EXPECT_LE(fit(cloud, rect_about(cloud)).outside, 8 * u);
  expect_same(rect_about(cloud), rect_about(corners));
  EXPECT_EQ(hull(circle).size(), 5000u);
  // In order the ring is convex, and taken in place. In any other order it has too many corners.
  EXPECT_LE(fit(circle, rect_about(circle)).outside, 8 * u);
  const Points mixed = shuffled(circle, random);
  const vesica_polygon_f64 path = as_path(mixed);
  vesica_rect_f64 out{9, 9, 9, 9, 9, 9};
  EXPECT_EQ(vesica_min_area_rect_f64(&path, &out), VESICA_E_NOT_CONVEX);
  EXPECT_EQ(out.cx, 9);
  expect_same(rect_about(hull(mixed)), rect_about(circle));
}

TEST(SmallestRect, HasTheLeastAreaAndPerimeter) {
  Random random(44);
  int areas = 0, unlike = 0;
  for (int n = 50000 * properties::repeat(); n > 0; --n) {
    const Points points = lattice(random), corners = wrapped(points);
    const vesica_rect_f64 by_area = rect_about(points), by_perimeter = rect_about(points, true);
    for (const auto& r : {by_area, by_perimeter}) {
      EXPECT_NEAR(std::hypot(r.ux, r.uy), 1, 4 * u);
      const Fit f = fit(points, r);
      ASSERT_LE(f.outside, 8 * u * 20);
      ASSERT_LE(f.loose, 8 * u * 20);
    }
    expect_same(by_area, rect_about(corners));
    expect_same(by_area, rect_about(shuffled(points, random)));
    if (corners.size() < 3) {
      EXPECT_EQ(by_area.hy, 0);
      continue;
    }
    ++areas;
    const Least least = least_of(corners);
    const auto perimeter = [](const vesica_rect_f64& r) { return 4 * (r.hx + r.hy); };
    ASSERT_NEAR(static_cast<double>(4 * by_area.hx * by_area.hy / least.area), 1, 1e-14);
    ASSERT_NEAR(static_cast<double>(perimeter(by_perimeter) / least.perimeter), 1, 1e-14);
    unlike += perimeter(by_area) > perimeter(by_perimeter) * (1 + 1e-12);
  }
  EXPECT_GT(areas, 1000);
  EXPECT_GT(unlike, 50);
}

// Thin to 1e-12, far away, tiny, huge: the rectangle of a turned box is that box.
TEST(SmallestRect, FindsATurnedBox) {
  Random random(45);
  for (int n = 20000 * properties::repeat(); n > 0; --n) {
    const double angle = random.between(0, 1.5), c = std::cos(angle), s = std::sin(angle);
    const double hx = random.between(0.5, 1), hy = hx * std::pow(10, -random.between(0, 12));
    const double factor = std::ldexp(1, random.integer(-900, 900)), far = random.chance(0.5) ? 0 : factor * 1e3;
    Points points;
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      points.push_back({far + factor * (x * hx * c - y * hy * s), far + factor * (x * hx * s + y * hy * c)});
    }
    const vesica_rect_f64 r = rect_about(shuffled(points, random));
    const double allowed = 8 * u * largest(points);
    EXPECT_LE(fit(points, r).outside, allowed);
    EXPECT_LE(fit(points, r).loose, allowed);
    const bool along = std::abs(r.ux * c + r.uy * s) > 0.7;
    EXPECT_NEAR(along ? r.hx : r.hy, factor * hx, 4 * allowed);
    EXPECT_NEAR(along ? r.hy : r.hx, factor * hy, 4 * allowed);
  }
}

TEST(SmallestRect, OfBoxesAlongTheAxesIsExact) {
  expect_same(rect_about({{5, 1}, {5, 3}, {1, 3}, {1, 1}, {2, 2}}), {3, 2, 1, 0, 2, 1});
  expect_same(rect_about({{0, 0}, {4, 0}, {4, 2}, {0, 2}}), {2, 1, 1, 0, 2, 1});
  expect_same(rect_about({{7, -8}}), {7, -8, 1, 0, 0, 0});
  expect_same(rect_about({{1, 1}, {1, 1}, {4, 5}}), {2.5, 3, 0.6, 0.8, 2.5, 0});
}

// An edge that is nothing beside the extent; an extent that is nothing beside the place; the whole range.
TEST(SmallestRect, OfUnlikeSizes) {
  const double big = 0x1p1000;
  for (const Points& points : {Points{{0, 0}, {0x3p-74, 0x2p-74}, {0, big}, {-big, 2.5 * big}},
                               Points{{0, 0}, {0x1p-71, 0x1p-72}, {8 * big, 1.5 * big}, {7 * big, 5 * big}},
                               Points{{0, 0}, {5e-324, 0}, {0, 5e-324}}, Points{{0, 1e308}, {1e-300, 1e308}},
                               Points{{1e292, 0}, {1e292, 1e-300}}, Points{{0, 0}, {0x1p-1000, 0x1p-1001}, {1, 1}}}) {
    for (const bool perimeter : {false, true}) {
      const Fit f = fit(points, rect_about(points, perimeter));
      const long double allowed = 16 * static_cast<long double>(u) * largest(points) + 8 * 5e-324L;
      EXPECT_LE(f.outside, allowed) << points[1].x;
    }
  }
  expect_same(rect_about({{0, 1e308}, {1e-300, 1e308}}), {5e-301, 1e308, 1, 0, 5e-301, 0});
  const double most = std::numeric_limits<double>::max();
  expect_same(rect_about({{-most, -1}, {most, -1}, {most, 1}, {-most, 1}}), {0, 0, 1, 0, most, 1});
}

TEST(SmallestRect, TakesMoreCornersAtFirstThanInTheEnd) {
  Points points;
  for (int i = 0; i < 1024; ++i) points.push_back({std::cos(i * 0.0061359), std::sin(i * 0.0061359)});
  points.resize(760);
  for (const double x : {-5.0, 5.0}) {
    for (const double y : {-5.0, 5.0}) points.push_back({x, y});
  }
  expect_same(rect_about(points), {0, 0, 1, 0, 5, 5});
}

TEST(SmallestRect, ScalesWithPowersOfTwo) {
  Random random(46);
  for (int n = 10000 * properties::repeat(); n > 0; --n) {
    Points points;
    for (int i = random.integer(3, 9); i > 0; --i) points.push_back({random.between(-1, 1), random.between(-1, 1)});
    const vesica_rect_f64 r = rect_about(points);
    const double factor = std::ldexp(1, random.integer(-800, 900));
    scale(points, factor);
    expect_same(rect_about(points), {r.cx * factor, r.cy * factor, r.ux, r.uy, r.hx * factor, r.hy * factor});
  }
}

TEST(SmallestRect, OfArraysAreThoseOfEach) {
  Random random(47);
  std::vector<double> quads;
  for (int i = 0; i < 80; ++i) quads.push_back(random.between(-3, 3));
  quads[17] = std::numeric_limits<double>::quiet_NaN();
  const vesica_shapes_f64 array = {.kind = VESICA_POLYGON,
                                   .reserved = 0,
                                   .count = 10,
                                   .stride = 16,
                                   .field = {&quads[0], &quads[1]},
                                   .rings = nullptr,
                                   .polygons = nullptr,
                                   .each = 4};
  std::vector<vesica_rect_f64> out(10);
  for (const bool perimeter : {false, true}) {
    EXPECT_EQ(perimeter ? vesica_min_perimeter_rect_many_f64(&array, out.data())
                        : vesica_min_area_rect_many_f64(&array, out.data()),
              VESICA_E_SHAPE);
    for (std::size_t i = 0; i < 10; ++i) {
      if (i == 2) {
        EXPECT_TRUE(std::isnan(out[i].cx) && std::isnan(out[i].hy));
        continue;
      }
      Points quad;
      for (std::size_t k = 0; k < 4; ++k) quad.push_back({quads[8 * i + 2 * k], quads[8 * i + 2 * k + 1]});
      expect_same(out[i], rect_about(quad, perimeter));
    }
  }
}

TEST(SmallestRect, OfFloatsIsThatOfDoublesRounded) {
  Random random(48);
  for (int n = 2000 * properties::repeat(); n > 0; --n) {
    std::vector<vesica_point_f32> narrow;
    Points wide;
    for (int i = random.integer(1, 9); i > 0; --i) {
      narrow.push_back({static_cast<float>(random.between(-1, 1)), static_cast<float>(random.between(-1, 1))});
      wide.push_back({narrow.back().x, narrow.back().y});
    }
    const auto count = static_cast<std::int64_t>(narrow.size());
    const vesica_polygon_f32 path{&narrow[0].x, &narrow[0].y, sizeof narrow[0], nullptr, count};
    std::vector<vesica_point_f32> corners(narrow.size());
    const Points expected = hull(wide);
    ASSERT_EQ(vesica_convex_hull_f32(&path, corners.data(), count), static_cast<std::int64_t>(expected.size()));
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(corners[i].x, expected[i].x);
    vesica_rect_f32 r;
    EXPECT_EQ(vesica_min_area_rect_f32(&path, &r), 0);
    const vesica_rect_f64 w = rect_about(wide);
    EXPECT_EQ(r.cx, static_cast<float>(w.cx));
    EXPECT_EQ(r.hy, static_cast<float>(w.hy));
    EXPECT_EQ(r.ux, static_cast<float>(w.ux));
  }
}

TEST(PolygonHull, RefusesBadInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), most = std::numeric_limits<double>::max();
  Points points{{0, 0}, {1, 0}, {0, 1}}, out(3);
  vesica_polygon_f64 path = as_path(points);
  vesica_rect_f64 r{9, 9, 9, 9, 9, 9};
  EXPECT_EQ(vesica_convex_hull_f64(nullptr, out.data(), 3), VESICA_E_NULL);
  EXPECT_EQ(vesica_convex_hull_f64(&path, nullptr, 3), VESICA_E_NULL);
  EXPECT_EQ(vesica_convex_hull_f64(&path, out.data(), 2), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_min_area_rect_f64(nullptr, &r), VESICA_E_NULL);
  EXPECT_EQ(vesica_min_perimeter_rect_f64(&path, nullptr), VESICA_E_NULL);
  path.count = 0;
  EXPECT_EQ(vesica_convex_hull_f64(&path, out.data(), 3), VESICA_E_SHAPE);
  EXPECT_EQ(vesica_min_area_rect_f64(&path, &r), VESICA_E_SHAPE);
  points[1].y = nan;
  path = as_path(points);
  EXPECT_EQ(vesica_convex_hull_f64(&path, out.data(), 3), VESICA_E_SHAPE);
  EXPECT_EQ(vesica_min_area_rect_f64(&path, &r), VESICA_E_SHAPE);
  EXPECT_EQ(out[0].x, 0);
  EXPECT_EQ(r.cx, 9);
  // Half the diagonal overflows.
  points = {{-most, -most}, {most, most}};
  path = as_path(points);
  EXPECT_EQ(vesica_min_area_rect_f64(&path, &r), VESICA_E_RANGE);
  points = {{-most, 0}, {most, 0}};
  expect_same(rect_about(points), {0, 0, 1, 0, most, 0});
}

}  // namespace polygon_hull

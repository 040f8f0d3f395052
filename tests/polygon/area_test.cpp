// SPDX-License-Identifier: Apache-2.0
// Areas of polygons: against slabs in more digits, counted unit cells, other kinds with the same points, and integrals.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "inflated/shapes.hpp"
#include "polygon/area_oracle.hpp"
#include "polygon/shapes.hpp"
#include "properties/random.hpp"

namespace polygon_area {

using namespace polygons;

constexpr double pi = 3.14159265358979323846;

inline double area(std::int32_t kind_a, const void* a, std::int32_t kind_b, const void* b) {
  double out = -1;
  EXPECT_EQ(vesica_area_f64(kind_a, a, kind_b, b, &out), 0);
  return out;
}
inline double area(const Path& a, const Path& b) {
  const auto p = a.view(), q = b.view();
  return area(VESICA_POLYGON, &p, VESICA_POLYGON, &q);
}
inline double area(const Path& a, const inflated::Shape& b) {
  const auto p = a.view();
  return area(VESICA_POLYGON, &p, b.kind, b.number.data());
}
inline double own_area(const Path& a) {
  const auto p = a.view();
  double out = -1;
  EXPECT_EQ(vesica_shape_area_f64(VESICA_POLYGON, &p, &out), 0);
  return out;
}

/// Simple rings about a centre: a shell, perhaps a hole, perhaps an island in it. In any order and direction.
inline Path nested_path(int n, double cx, double cy, double radius, Random& random) {
  Path path;
  std::vector<std::vector<double>> rings;
  const int count = random.chance(0.5) ? 1 : random.integer(2, 3);
  // The chords of at least 8 vertices at angles that are not too uneven stay outside 0.3 of the least radius.
  for (int j = 0; j < count; ++j, radius *= 0.15) {
    std::vector<double> ring;
    const int m = std::max(n, 8);
    const double turn = random.between(0, 1);
    for (int i = 0; i < m; ++i) {
      const double angle = 2 * pi * (i + random.between(0.2, 0.8) + turn) / m, r = radius * random.between(0.5, 1);
      ring.push_back(cx + r * std::cos(angle));
      ring.push_back(cy + r * std::sin(angle));
    }
    rings.push_back(ring);
  }
  if (random.chance(0.5)) std::reverse(rings.begin(), rings.end());
  for (const auto& ring : rings) path.add_ring(ring);
  return rewritten(path, random);
}

/// A star around its centre: if the centre were outside, edges might cross.
inline Path simple_star(int n, double x, double y, Random& random) {
  const double radius = random.between(0.3, 2), least = random.chance(0.5) ? 1 : 0.3;
  for (;;) {
    Path path;
    path.add_ring(star(n, x, y, radius, least, random));
    bool around = true;
    for (std::size_t i = 0, m = path.xy.size(); i < m; i += 2) {
      const double *const p = &path.xy[i], *const q = &path.xy[(i + 2) % m];
      around &= (p[0] - x) * (q[1] - y) > (p[1] - y) * (q[0] - x);
    }
    if (around) return path;
  }
}
inline Path some_path(double x, double y, Random& random) {
  if (random.chance(0.4)) return nested_path(random.integer(8, 40), x, y, random.between(0.3, 2), random);
  return simple_star(random.integer(3, 20), x, y, random);
}

TEST(PolygonArea, AgreesWithSlabs) {
  Random random(159);
  int positive = 0, zero = 0;
  const int pairs = 5000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const double shift = random.chance(0.3) ? 1000 : 0;
    const Path a = some_path(shift, 0, random),
               b = some_path(shift + random.between(-2, 2), random.between(-2, 2), random);
    const double expected = static_cast<double>(area_by_slabs(a, b)), found = area(a, b), bound = area_bound(a, b);
    ASSERT_LE(std::fabs(found - expected), bound) << i;
    ASSERT_EQ(area(b, a), found) << i;
    ASSERT_LE(found, std::min(own_area(a), own_area(b)));
    positive += found > 0;
    zero += found == 0;
    ASSERT_LE(std::fabs(own_area(a) - static_cast<double>(area_by_slabs(a, a))), area_bound(a, a));
    ASSERT_EQ(area(a, a), own_area(a));
    const Path other = rewritten(b, random);
    ASSERT_LE(std::fabs(area(a, other) - expected), bound);
  }
  EXPECT_GT(positive, pairs / 3);
  EXPECT_GT(zero, pairs / 20);
}

/// Long outlines take the walk over blocks.
TEST(PolygonArea, OfManyVertices) {
  Random random(160);
  const int pairs = 60 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const Path a = nested_path(random.integer(100, 700), 0, 0, 1, random);
    const Path b = nested_path(random.integer(8, 300), random.between(-1, 1), random.between(-1, 1), 1, random);
    ASSERT_LE(std::fabs(area(a, b) - static_cast<double>(area_by_slabs(a, b))), area_bound(a, b)) << i;
    ASSERT_EQ(area(b, a), area(a, b));
  }
}

/// Columns of unit cells side by side, from bottom[i] to top[i] over [x + i, x + i + 1].
struct Columns {
  int x;
  std::vector<int> bottom, top;

  /// Its outline, with all vertices where heights change.
  Path path() const {
    std::vector<double> ring;
    const std::size_t n = bottom.size();
    for (std::size_t i = 0; i < n; ++i) {
      ring.insert(ring.end(), {double(x) + double(i), double(bottom[i]), double(x) + double(i + 1), double(bottom[i])});
    }
    for (std::size_t i = n; i-- > 0;) {
      ring.insert(ring.end(), {double(x) + double(i + 1), double(top[i]), double(x) + double(i), double(top[i])});
    }
    Path path;
    path.add_ring(ring);
    return path;
  }
};
inline Columns columns(int x, int y, Random& random) {
  Columns c{x, {}, {}};
  const int n = random.integer(1, 7);
  for (int i = 0; i < n; ++i) {
    c.bottom.push_back(y - random.below(4));
    c.top.push_back(y + 1 + random.below(4));
  }
  return c;
}
inline int shared_cells(const Columns& a, const Columns& b) {
  int cells = 0;
  for (int i = 0; i < static_cast<int>(a.bottom.size()); ++i) {
    const int j = a.x + i - b.x;
    if (j < 0 || j >= static_cast<int>(b.bottom.size())) continue;
    const auto k = static_cast<std::size_t>(i), m = static_cast<std::size_t>(j);
    cells += std::max(0, std::min(a.top[k], b.top[m]) - std::max(a.bottom[k], b.bottom[m]));
  }
  return cells;
}

/// Contact in edges and corners shares exactly nothing, and a part of another polygon exactly its own area, at any
/// place and turn that keeps the vertices on one line with each other.
TEST(PolygonArea, OfCells) {
  Random random(161);
  int touching = 0, nested = 0;
  const int pairs = 50000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const Columns a = columns(random.below(9), 0, random), b = columns(random.below(9), random.integer(-6, 6), random);
    Path p = rewritten(a.path(), random), q = rewritten(b.path(), random);
    const int cells = shared_cells(a, b), least = std::min(shared_cells(a, a), shared_cells(b, b));
    // Turned, longer by a square root, and moved: no vertex is rounded.
    const int c = random.integer(-20, 20), s = random.integer(1, 20), x = random.integer(-1000, 1000);
    for (Path* path : {&p, &q}) {
      for (std::size_t k = 0; k < path->xy.size(); k += 2) {
        const double u = path->xy[k], v = path->xy[k + 1];
        path->xy[k] = c * u - s * v + x;
        path->xy[k + 1] = s * u + c * v;
      }
    }
    const double unit = c * c + s * s, found = area(p, q);
    ASSERT_EQ(found == 0, cells == 0) << i;
    ASSERT_EQ(found == std::min(own_area(p), own_area(q)), cells == least) << i;
    ASSERT_NEAR(found, cells * unit, 1e-11 * unit);
    const auto pv = p.view(), qv = q.view();
    touching += cells == 0 && vesica_overlap_f64(VESICA_POLYGON, &pv, VESICA_POLYGON, &qv) == 1;
    nested += cells == least;
  }
  EXPECT_GT(touching, pairs / 100);
  EXPECT_GT(nested, pairs / 100);
}

/// An AABB or a rectangle whose corners are numbers has the same area as the polygon of its corners, with every kind.
TEST(PolygonArea, OfBoxesAsPolygons) {
  Random random(162);
  int positive = 0, whole = 0;
  const int pairs = 30000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    inflated::Shape other = inflated::any_shape(random);
    inflated::Shape box{VESICA_RECT, {}};
    if (random.chance(0.5)) {
      const double x = random.between(-3, 3), y = random.between(-3, 3);
      box = {VESICA_AABB, {x, y, x + random.between(0, 3), y + random.between(0, 3)}};
    } else {
      // Small integers have exact corners.
      box.number = {double(random.integer(-3, 3)), double(random.integer(-3, 3)), double(random.integer(-4, 4)), 1,
                    random.integer(1, 4) / 8.0,    random.integer(1, 4) / 8.0};
    }
    if (random.chance(0.1)) other = box;
    const auto& n = box.number;
    Path path;
    if (box.kind == VESICA_AABB) {
      path.add_ring({n[0], n[1], n[2], n[1], n[2], n[3], n[0], n[3]});
    } else {
      std::vector<double> ring;
      for (const auto& [p, q] : {std::array{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
        const double s = p * n[4], t = q * n[5];
        ring.insert(ring.end(), {n[0] + s * n[2] - t * n[3], n[1] + s * n[3] + t * n[2]});
      }
      path.add_ring(ring);
    }
    const Path polygon = rewritten(path, random);
    const double expected = area(box.kind, n.data(), other.kind, other.number.data()), found = area(polygon, other);
    ASSERT_NEAR(found, expected, 3e-13) << i << ' ' << other.kind;
    if (expected == 0) {
      ASSERT_EQ(found, 0) << i;
    }
    double own = 0;
    vesica_shape_area_f64(other.kind, other.number.data(), &own);
    if (expected == own) {
      ASSERT_EQ(found, std::min(own, own_area(polygon))) << i;
    }
    positive += found > 0;
    whole += found > 0 && found == own;
    const auto view = polygon.view();
    ASSERT_EQ(area(other.kind, other.number.data(), VESICA_POLYGON, &view), found);
    ASSERT_NEAR(own_area(polygon), area(box.kind, n.data(), box.kind, n.data()), 1e-13);
    for (const std::int32_t ratio : {VESICA_RATIO_OVER_UNION, VESICA_RATIO_OVER_FIRST, VESICA_RATIO_GENERALIZED,
                                     VESICA_RATIO_DISTANCE, VESICA_RATIO_COMPLETE, VESICA_RATIO_OVER_SECOND}) {
      if (ratio == VESICA_RATIO_COMPLETE && box.kind != VESICA_AABB) continue;  // a path's sides are its box's
      double of_polygon = 7, of_box = 7;
      ASSERT_EQ(vesica_ratio_f64(ratio, VESICA_POLYGON, &view, other.kind, other.number.data(), &of_polygon),
                vesica_ratio_f64(ratio, box.kind, n.data(), other.kind, other.number.data(), &of_box));
      ASSERT_NEAR(of_polygon, of_box, 1e-9) << ratio << ' ' << i;
    }
  }
  EXPECT_GT(positive, pairs / 5);
  EXPECT_GT(whole, pairs / 50);
}

/// The interval of a row of numbers over x; empty where it is not.
struct Interval {
  double low = 1, high = -1;
};
inline Interval hull(const Interval& a, const Interval& b) {
  if (!(a.low <= a.high)) return b;
  if (!(b.low <= b.high)) return a;
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}
inline Interval disc_over(double cx, double cy, double r, double x) {
  const double square = r * r - (x - cx) * (x - cx);
  return square < 0 ? Interval{} : Interval{cy - std::sqrt(square), cy + std::sqrt(square)};
}
/// A convex polygon.
inline Interval corners_over(const std::vector<std::array<double, 2>>& corner, double x) {
  Interval all;
  for (std::size_t i = 0; i < corner.size(); ++i) {
    const auto &p = corner[i], &q = corner[(i + 1) % corner.size()];
    if ((p[0] < x) == (q[0] < x)) continue;
    const double y = p[1] + (q[1] - p[1]) * ((x - p[0]) / (q[0] - p[0]));
    all = hull(all, {y, y});
  }
  return all;
}
inline Interval over(const inflated::Shape& s, double x) {
  const auto& n = s.number;
  const auto corners = [&](double cx, double cy, double ux, double uy, double hx, double hy) {
    std::vector<std::array<double, 2>> at;
    for (const auto& [p, q] : {std::array{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
      at.push_back({cx + p * hx * ux - q * hy * uy, cy + p * hx * uy + q * hy * ux});
    }
    return at;
  };
  switch (s.kind) {
    case VESICA_CIRCLE:
      return disc_over(n[0], n[1], n[2], x);
    case VESICA_AABB:
      return x < n[0] || x > n[2] ? Interval{} : Interval{n[1], n[3]};
    case VESICA_RECT:
      return corners_over(corners(n[0], n[1], n[2], n[3], n[4], n[5]), x);
    case VESICA_ELLIPSE: {
      // a x^2 + 2 b x y + c y^2 = 1 about the centre
      const double ux = n[2], uy = n[3], p = 1 / (n[4] * n[4]), q = 1 / (n[5] * n[5]), d = x - n[0];
      const double a = ux * ux * p + uy * uy * q, b = ux * uy * (p - q), c = uy * uy * p + ux * ux * q;
      const double square = b * b * d * d - c * (a * d * d - 1);
      return square < 0 ? Interval{}
                        : Interval{n[1] + (-b * d - std::sqrt(square)) / c, n[1] + (-b * d + std::sqrt(square)) / c};
    }
    case VESICA_CAPSULE: {
      const double cx = (n[0] + n[2]) / 2, cy = (n[1] + n[3]) / 2, hx = (n[2] - n[0]) / 2, hy = (n[3] - n[1]) / 2;
      return hull(hull(disc_over(n[0], n[1], n[4], x), disc_over(n[2], n[3], n[4], x)),
                  corners_over(corners(cx, cy, hx, hy, 1, n[4] / std::hypot(hx, hy)), x));
    }
    case VESICA_ROUND_RECT: {
      Interval all;
      const double r = n[6];
      for (const auto& c : corners(n[0], n[1], n[2], n[3], n[4], n[5])) all = hull(all, disc_over(c[0], c[1], r, x));
      all = hull(all, corners_over(corners(n[0], n[1], n[2], n[3], n[4] + r, n[5]), x));
      return hull(all, corners_over(corners(n[0], n[1], n[2], n[3], n[4], n[5] + r), x));
    }
    default:
      return {};
  }
}
inline double area_by_integral(const Path& path, const inflated::Shape& s, int steps) {
  std::vector<RealEdge> edges;
  add_edges(path, false, edges);
  double low = 1e300, high = -1e300, sum = 0;
  for (const RealEdge& e : edges) {
    low = std::min(low, static_cast<double>(e.x0));
    high = std::max(high, static_cast<double>(e.x1));
  }
  const double width = (high - low) / steps;
  std::vector<double> heights;
  for (int i = 0; i < steps; ++i) {
    const double x = low + (i + 0.5) * width;
    const Interval row = over(s, x);
    if (!(row.low < row.high)) continue;
    heights.clear();
    for (const RealEdge& e : edges) {
      if (static_cast<double>(e.x0) < x && x < static_cast<double>(e.x1))
        heights.push_back(static_cast<double>(e.at(x)));
    }
    std::sort(heights.begin(), heights.end());
    for (std::size_t k = 0; k + 1 < heights.size(); k += 2) {
      sum += width * std::max(0.0, std::min(row.high, heights[k + 1]) - std::max(row.low, heights[k]));
    }
  }
  return sum;
}

/// Any polygon with any row: integrals find a wrong formula, and sums over triangles a lost digit.
TEST(PolygonArea, WithRows) {
  Random random(163);
  int positive = 0;
  const int pairs = 3000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const inflated::Shape row = inflated::shape(random.integer(VESICA_CIRCLE, VESICA_ROUND_RECT), random);
    const Path path =
        some_path(row.number[0] + random.between(-1.5, 1.5), row.number[1] + random.between(-1.5, 1.5), random);
    const double found = area(path, row);
    // Two upright edges, of at most 4, each half a strip away, which is at most 4 / 2000 wide.
    ASSERT_NEAR(found, area_by_integral(path, row, 2000), 8e-3) << i << ' ' << row.kind;
    // The triangles of a point and each edge, with the sign of their turn; the first ring is to the left of its edges.
    if (path.ring_count() == 1) {
      double sum = 0;
      const std::size_t n = path.xy.size() / 2;
      for (std::size_t k = 0; k < n; ++k) {
        const double* const p = &path.xy[2 * k];
        const double* const q = &path.xy[2 * ((k + 1) % n)];
        const double turn = (p[0] - 0.25) * (q[1] - 0.5) - (p[1] - 0.5) * (q[0] - 0.25);
        Path triangle;
        triangle.add_ring({0.25, 0.5, p[0], p[1], q[0], q[1]});
        sum += (turn > 0 ? 1 : -1) * area(triangle, row);
      }
      ASSERT_NEAR(found, std::fabs(sum), 4e-13) << i << ' ' << row.kind;
    }
    positive += found > 0;
  }
  EXPECT_GT(positive, pairs / 2);
}

TEST(PolygonArea, Laws) {
  Random random(164);
  const int pairs = 3000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    Path a = some_path(0, 0, random), b = some_path(random.between(-2, 2), random.between(-2, 2), random);
    for (Path* path : {&a, &b}) {
      for (double& c : path->xy) c = static_cast<double>(static_cast<float>(c));
    }
    const inflated::Shape row = inflated::any_shape(random);
    const double found = area(a, b), with_row = area(a, row);
    // Float: the double rounded.
    const auto narrow = [](const Path& path) { return std::vector<float>(path.xy.begin(), path.xy.end()); };
    const std::vector<float> p = narrow(a), q = narrow(b);
    const auto view = [](const Path& path, const std::vector<float>& xy) {
      const auto v = path.view();
      return vesica_polygon_f32{xy.data(), xy.data() + 1, 2 * sizeof(float), v.rings, v.count};
    };
    const vesica_polygon_f32 pv = view(a, p), qv = view(b, q);
    float rounded = -1;
    ASSERT_EQ(vesica_area_f32(VESICA_POLYGON, &pv, VESICA_POLYGON, &qv, &rounded), 0);
    ASSERT_EQ(rounded, static_cast<float>(found));
    // Powers of two, an even one for an axis.
    for (const int exponent : {-500, -160, 3, 160, 500}) {
      const double k = std::ldexp(1.0, exponent);
      Path s = a, t = b;
      for (Path* path : {&s, &t}) {
        for (double& c : path->xy) c *= k;
      }
      ASSERT_EQ(area(s, t), std::ldexp(found, 2 * exponent)) << i << ' ' << exponent;
      double iou = -1, scaled = -1;
      const auto av = a.view(), bv = b.view(), sv = s.view(), tv = t.view();
      ASSERT_EQ(vesica_iou_f64(VESICA_POLYGON, &av, VESICA_POLYGON, &bv, &iou), 0);
      ASSERT_EQ(vesica_iou_f64(VESICA_POLYGON, &sv, VESICA_POLYGON, &tv, &scaled), 0);
      ASSERT_NEAR(scaled, iou, 1e-15);
      inflated::Shape larger = row;
      const bool has_axis = row.kind == VESICA_RECT || row.kind == VESICA_ELLIPSE || row.kind == VESICA_ROUND_RECT;
      for (std::size_t f = 0; f < larger.number.size(); ++f) larger.number[f] *= has_axis && f / 2 == 1 ? 1 : k;
      ASSERT_NEAR(std::ldexp(area(s, larger), -2 * exponent), with_row, 1e-13) << i << ' ' << row.kind;
    }
  }
}

TEST(PolygonArea, RatiosOfPolygons) {
  Path a, b;
  a.add_ring({0, 0, 2, 0, 2, 2, 0, 2});
  b.add_ring({1, 1, 3, 1, 3, 3, 1, 3});
  const auto p = a.view(), q = b.view();
  const auto ratio = [&](std::int32_t which, const auto& s, const auto& t) {
    double out = 7;
    EXPECT_EQ(vesica_ratio_f64(which, VESICA_POLYGON, &s, VESICA_POLYGON, &t, &out), 0);
    return out;
  };
  EXPECT_EQ(ratio(VESICA_RATIO_OVER_UNION, p, q), 1.0 / 7);
  EXPECT_EQ(ratio(VESICA_RATIO_OVER_UNION, p, p), 1);
  EXPECT_EQ(ratio(VESICA_RATIO_OVER_SMALLER, p, q), 0.25);
  EXPECT_NEAR(ratio(VESICA_RATIO_GENERALIZED, p, q), 1.0 / 7 - 2.0 / 9, 1e-15);
  EXPECT_NEAR(ratio(VESICA_RATIO_DISTANCE, p, q), 1.0 / 7 - 2.0 / 18, 1e-15);
  EXPECT_NEAR(ratio(VESICA_RATIO_COMPLETE, p, q), 1.0 / 7 - 2.0 / 18, 1e-15);
  Path big;
  big.add_ring({-10, -10, 10, -9, 10, 9, -9, 10});
  const auto outer = big.view();
  EXPECT_EQ(ratio(VESICA_RATIO_OVER_FIRST, p, outer), 1);
  EXPECT_EQ(ratio(VESICA_RATIO_OVER_SECOND, outer, p), 1);
}

/// Points, segments and polylines have no area, nor have polygons whose vertices lie on one line.
TEST(PolygonArea, OfNothing) {
  Random random(165);
  Path square, flat;
  square.add_ring({0, 0, 2, 0, 2, 2, 0, 2});
  // Multiples of one vector, exactly on a line.
  std::vector<double> ring;
  for (int i = 0; i < 7; ++i) {
    const double t = random.integer(-20, 20);
    ring.insert(ring.end(), {t * 0.1171875, t * 0.3359375});
  }
  flat.add_ring(ring);
  flat.add_ring({1, 1, 1, 1, 1.5, 1.25});
  const auto p = square.view(), q = flat.view();
  const auto line = square.view<vesica_polyline_f64>();
  EXPECT_EQ(own_area(flat), 0);
  EXPECT_EQ(area(VESICA_POLYGON, &p, VESICA_POLYGON, &q), 0);
  EXPECT_EQ(area(VESICA_POLYGON, &p, VESICA_POLYLINE, &line), 0);
  for (const std::int32_t kind : {VESICA_POINT, VESICA_SEGMENT}) {
    const double numbers[] = {0.5, 0.5, 1, 1};
    EXPECT_EQ(area(VESICA_POLYGON, &p, kind, numbers), 0);
    double out = 7;
    EXPECT_EQ(vesica_iou_f64(kind, numbers, VESICA_POLYGON, &p, &out), 0);
    EXPECT_EQ(out, 0);
    EXPECT_EQ(vesica_iou_f64(kind, numbers, VESICA_POLYGON, &q, &out), VESICA_E_ARGUMENT);
    EXPECT_EQ(vesica_iou_f64(kind, numbers, VESICA_POLYLINE, &line, &out), VESICA_E_ARGUMENT);
  }
  // A needle has an area, however little.
  Path needle;
  needle.add_ring({0, 0, 1, 1, 0.5, std::nextafter(0.5, 1)});
  EXPECT_GT(own_area(needle), 0);
  EXPECT_LE(own_area(needle), 0x1p-48);
}

/// A bad element of an array spoils its own result.
TEST(PolygonArea, OfArrays) {
  Random random(166);
  std::vector<double> xy;
  const int n = 40;
  for (int i = 0; i < n; ++i) {
    const auto quad = star(4, random.between(-1, 1), random.between(-1, 1), 1, 1, random);
    xy.insert(xy.end(), quad.begin(), quad.end());
  }
  xy[8 * 7 + 3] = std::numeric_limits<double>::quiet_NaN();
  vesica_shapes_f64 quads{};
  quads.kind = VESICA_POLYGON;
  quads.count = n;
  quads.stride = 16;
  quads.field[0] = xy.data();
  quads.field[1] = xy.data() + 1;
  quads.each = 4;
  std::vector<double> out(static_cast<std::size_t>(n * n), 9), one(static_cast<std::size_t>(n), 9);
  for (std::int32_t which = 0; which < 8; ++which) {
    const auto answer = [&](const vesica_polygon_f64& p, const vesica_polygon_f64& q, double* number) {
      if (which == 7) return vesica_area_f64(VESICA_POLYGON, &p, VESICA_POLYGON, &q, number);
      return vesica_ratio_f64(which, VESICA_POLYGON, &p, VESICA_POLYGON, &q, number);
    };
    const std::int64_t matrix = which == 7 ? vesica_area_matrix_f64(&quads, &quads, out.data(), n)
                                           : vesica_ratio_matrix_f64(which, &quads, &quads, out.data(), n);
    EXPECT_EQ(matrix, VESICA_E_SHAPE);
    const std::int64_t many = which == 7 ? vesica_area_many_f64(&quads, &quads, one.data())
                                         : vesica_ratio_many_f64(which, &quads, &quads, one.data());
    EXPECT_EQ(many, VESICA_E_SHAPE);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const double* const p = xy.data() + 8 * i;
        const double* const q = xy.data() + 8 * j;
        double number = 5;
        const std::int32_t error = answer({p, p + 1, 16, nullptr, 4}, {q, q + 1, 16, nullptr, 4}, &number);
        const double found = out[static_cast<std::size_t>(i * n + j)];
        ASSERT_EQ(error, i == 7 || j == 7 ? VESICA_E_SHAPE : 0);
        if (error != 0) {
          ASSERT_EQ(number, 5);
          ASSERT_TRUE(std::isnan(found));
        } else {
          ASSERT_EQ(found, number);
          if (i == j) {
            ASSERT_EQ(one[static_cast<std::size_t>(i)], number);
          }
        }
      }
    }
  }
}

}  // namespace polygon_area

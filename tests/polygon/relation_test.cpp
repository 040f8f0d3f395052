// SPDX-License-Identifier: Apache-2.0
// relation, contains and interiors_overlap of polygons and polylines.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "inflated/shapes.hpp"
#include "polygon/cells.hpp"
#include "polygon/shapes.hpp"
#include "properties/random.hpp"

namespace polygon_relation {

using namespace polygons;

constexpr std::array<std::int32_t, 8> converse{VESICA_DISJOINT,     VESICA_TOUCH,          VESICA_CROSS,
                                               VESICA_CONTAINS,     VESICA_CONTAINS_TOUCH, VESICA_INSIDE,
                                               VESICA_INSIDE_TOUCH, VESICA_EQUAL};

inline std::int32_t kind_of(const Figure& f) { return f.closed ? VESICA_POLYGON : VESICA_POLYLINE; }

/// All three questions, in both orders.
inline void expect(std::int32_t kind_a, const void* a, std::int32_t kind_b, const void* b, std::int32_t relation,
                   bool insides, const std::string& what) {
  ASSERT_EQ(vesica_relation_f64(kind_a, a, kind_b, b), relation) << what;
  ASSERT_EQ(vesica_relation_f64(kind_b, b, kind_a, a), converse[static_cast<std::size_t>(relation)]) << what;
  ASSERT_EQ(vesica_contains_f64(kind_a, a, kind_b, b), relation >= VESICA_CONTAINS) << what;
  ASSERT_EQ(vesica_contains_f64(kind_b, b, kind_a, a),
            relation == VESICA_INSIDE || relation == VESICA_INSIDE_TOUCH || relation == VESICA_EQUAL)
      << what;
  ASSERT_EQ(vesica_interiors_overlap_f64(kind_a, a, kind_b, b), insides) << what;
  ASSERT_EQ(vesica_interiors_overlap_f64(kind_b, b, kind_a, a), insides) << what;
  ASSERT_EQ(vesica_overlap_f64(kind_a, a, kind_b, b), relation != VESICA_DISJOINT) << what;
}

inline std::string text(const Path& path) {
  std::string out;
  for (std::size_t j = 0; j < path.ring_count(); ++j) {
    out += "(";
    for (std::int32_t i = path.rings[j]; i < path.rings[j + 1]; ++i) {
      out += std::to_string(path.xy[static_cast<std::size_t>(2 * i)]) + " " +
             std::to_string(path.xy[static_cast<std::size_t>(2 * i + 1)]) + ", ";
    }
    out += ") ";
  }
  return out;
}

inline void compare_with_cells(const Grid& grid, const Figure& a, const Figure& b, Random& random,
                               std::array<int, 8>& seen) {
  const std::string m = matrix_of(a, b);
  const std::int32_t relation = relation_of(m);
  ++seen[static_cast<std::size_t>(relation)];
  const Map map(random);
  const Path path_a = map.of(a.path), path_b = map.of(b.path);
  const auto view_a = path_a.view(), view_b = path_b.view();
  expect(kind_of(a), &view_a, kind_of(b), &view_b, relation, m[0] != 'F',
         grid.size() < 5 ? m + " " + text(a.path) + "and " + text(b.path) : m);
}

/// Often all of the grid, or next to nothing.
inline double density(Random& random) {
  return random.chance(0.15) ? 1 : random.chance(0.15) ? 0.01 : random.between(0.1, 0.8);
}

TEST(PolygonRelation, OfRegionsAndLinesOfAGrid) {
  Random random(590);
  std::array<int, 8> seen_areas{}, seen_lines{}, seen_both{};
  const int pairs = 25000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const Grid grid(random.integer(1, 3));
    const auto figure = [&](bool closed) {
      return closed ? region(grid, density(random), random) : lines(grid, 6, random);
    };
    const bool closed_a = random.chance(0.7), closed_b = random.chance(0.7);
    const Figure a = figure(closed_a);
    const Figure b = closed_a && closed_b && random.chance(0.4) ? neighbour(a, grid, random) : figure(closed_b);
    std::array<int, 8>& seen = closed_a && closed_b ? seen_areas : closed_a || closed_b ? seen_both : seen_lines;
    compare_with_cells(grid, a, b, random, seen);
    if (HasFatalFailure()) return;
  }
  if (!properties::draws_all()) return;
  for (const int relation : {VESICA_DISJOINT, VESICA_TOUCH, VESICA_CROSS, VESICA_INSIDE, VESICA_INSIDE_TOUCH,
                             VESICA_CONTAINS, VESICA_CONTAINS_TOUCH, VESICA_EQUAL}) {
    const auto k = static_cast<std::size_t>(relation);
    EXPECT_GT(seen_areas[k], 5) << relation;
    EXPECT_GT(seen_lines[k], 5) << relation;
    EXPECT_EQ(seen_both[k] > 5, relation != VESICA_EQUAL) << relation;
  }
}

/// Many edges: the walk over blocks.
TEST(PolygonRelation, OfManyEdges) {
  Random random(591);
  std::array<int, 8> seen{};
  const int pairs = 60 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const Grid grid(random.integer(8, 20));
    const Figure a = region(grid, random.between(0.3, 0.95), random);
    const Figure b = random.chance(0.7) ? neighbour(a, grid, random) : lines(grid, 40, random);
    compare_with_cells(grid, a, b, random, seen);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(seen[VESICA_CONTAINS_TOUCH] + seen[VESICA_INSIDE_TOUCH], 0);
}

using Numbers = inflated::Numbers;

inline void compare_with_row(std::int32_t kind, const void* shape, std::int32_t row_kind, const void* row,
                             const inflated::Shape& other, const std::string& what) {
  const std::int32_t relation = vesica_relation_f64(row_kind, row, other.kind, other.number.data());
  const bool insides = vesica_interiors_overlap_f64(row_kind, row, other.kind, other.number.data()) == 1;
  expect(kind, shape, other.kind, other.number.data(), relation, insides, what + std::to_string(other.kind));
}

/// A box, also one without area, as a polygon of its corners.
TEST(PolygonRelation, OfBoxesAsPolygons) {
  Random random(592);
  const int pairs = 60000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const inflated::Shape other = inflated::any_shape(random);
    std::array<double, 4> at{};
    for (std::size_t k = 0; k < 4; ++k) {
      at[k] = random.chance(0.3)   ? other.number[k % 2]
              : random.chance(0.3) ? random.integer(-2, 2)
                                   : random.between(-2, 2);
    }
    if (random.chance(0.1)) at[2] = at[0];
    if (random.chance(0.1)) at[3] = at[1];
    const vesica_aabb_f64 box{std::min(at[0], at[2]), std::min(at[1], at[3]), std::max(at[0], at[2]),
                              std::max(at[1], at[3])};
    Path path;
    path.add_ring({box.min_x, box.min_y, box.max_x, box.min_y, box.max_x, box.max_y, box.min_x, box.max_y});
    path = rewritten(path, random);
    const auto view = path.view();
    compare_with_row(VESICA_POLYGON, &view, VESICA_AABB, &box, other, "aabb ");
    if (HasFatalFailure()) return;
    if (other.kind == VESICA_AABB) {
      const auto* b = other.number.data();
      Path second;
      second.add_ring({b[0], b[1], b[2], b[1], b[2], b[3], b[0], b[3]});
      const auto view_b = second.view();
      const inflated::Shape as_box = other;
      const std::int32_t relation = vesica_relation_f64(VESICA_AABB, &box, VESICA_AABB, as_box.number.data());
      expect(VESICA_POLYGON, &view, VESICA_POLYGON, &view_b, relation,
             vesica_interiors_overlap_f64(VESICA_AABB, &box, VESICA_AABB, b) == 1, "two");
      if (HasFatalFailure()) return;
    }
  }
}

/// A rectangle whose corners are integers, with sizes of 0 too.
TEST(PolygonRelation, OfRectanglesAsPolygons) {
  Random random(593);
  const int pairs = 60000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    inflated::Shape other = inflated::any_shape(random);
    if (random.chance(0.7)) {
      for (std::size_t k = 0; k < 7; ++k) other.number[k] = std::round(2 * other.number[k]);
    }
    vesica_rect_f64 rect{0,
                         0,
                         static_cast<double>(random.integer(-3, 3)),
                         static_cast<double>(random.integer(-3, 3)),
                         static_cast<double>(random.below(3)),
                         static_cast<double>(random.below(3))};
    if (rect.ux == 0 && rect.uy == 0) rect.ux = 1;
    if (vesica_check_f64(other.kind, other.number.data()) != 0) continue;
    rect.cx = random.chance(0.5) ? std::round(other.number[0]) : random.integer(-4, 4);
    rect.cy = random.integer(-4, 4);
    std::vector<double> ring;
    for (const auto& [s, t] : std::vector<std::pair<double, double>>{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      ring.push_back(rect.cx + s * rect.hx * rect.ux - t * rect.hy * rect.uy);
      ring.push_back(rect.cy + s * rect.hx * rect.uy + t * rect.hy * rect.ux);
    }
    Path path;
    path.add_ring(ring);
    path = rewritten(path, random);
    const auto view = path.view();
    compare_with_row(VESICA_POLYGON, &view, VESICA_RECT, &rect, other, "rect ");
    if (HasFatalFailure()) return;
  }
}

/// Segments in other words, whose ends are integers, meet regions and lines as a chain of two vertices does.
TEST(PolygonRelation, OfThinShapes) {
  Random random(594);
  std::array<int, 8> seen{};
  const int pairs = 5000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const Grid grid(random.integer(1, 3));
    const Figure figure = random.chance(0.7) ? region(grid, random.between(0.2, 0.8), random) : lines(grid, 6, random);
    const auto view = figure.path.view();
    const double ux = random.integer(-2, 2), uy = random.integer(-2, 2), h = random.integer(0, 2),
                 cx = random.integer(-1, 2 * grid.size()), cy = random.integer(-1, 2 * grid.size());
    if (ux == 0 && uy == 0) continue;
    Path chain;
    chain.add_ring({cx - h * ux, cy - h * uy, cx + h * ux, cy + h * uy});
    const auto line = chain.view();
    const std::int32_t kind = kind_of(figure), relation = vesica_relation_f64(kind, &view, VESICA_POLYLINE, &line);
    const bool insides = vesica_interiors_overlap_f64(kind, &view, VESICA_POLYLINE, &line) == 1;
    ++seen[static_cast<std::size_t>(relation)];
    const double* at = chain.xy.data();
    const std::vector<std::pair<std::int32_t, std::vector<double>>> shapes{
        {VESICA_SEGMENT, {at[0], at[1], at[2], at[3]}}, {VESICA_CAPSULE, {at[2], at[3], at[0], at[1], 0}},
        {VESICA_RECT, {cx, cy, ux, uy, h, 0}},          {VESICA_RECT, {cx, cy, uy, -ux, 0, h}},
        {VESICA_ELLIPSE, {cx, cy, ux, uy, h, 0}},       {VESICA_ROUND_RECT, {cx, cy, -uy, ux, 0, h, 0}},
    };
    for (const auto& [row_kind, numbers] : shapes) {
      expect(kind, &view, row_kind, numbers.data(), relation, insides,
             std::to_string(row_kind) + " " + text(figure.path) + "and " + text(chain));
      if (HasFatalFailure()) return;
    }
    expect(kind, &view, VESICA_POLYGON, &line, relation, insides, "polygon");
    if (HasFatalFailure()) return;
  }
  for (const int r : {VESICA_DISJOINT, VESICA_TOUCH, VESICA_CROSS, VESICA_CONTAINS, VESICA_CONTAINS_TOUCH}) {
    EXPECT_GT(seen[static_cast<std::size_t>(r)], 0) << r;
  }
}

/// A convex shape with area, and a polygon that is a union of squares: what each square says.
TEST(PolygonRelation, OfConvexShapesAndUnionsOfSquares) {
  Random random(595);
  std::array<int, 8> seen{};
  const int pairs = 6000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const Grid grid(random.integer(1, 4));
    Figure figure(grid);
    const double density = random.between(0.2, 1);
    for (std::size_t t = 0; t < grid.triangles.size(); t += 4) {
      const CellPart part = t == 0 || random.chance(density) ? in : out;
      for (std::size_t k = 0; k < 4; ++k) figure.triangle[t + k] = part;
    }
    trace(figure, grid, 0.5, random);
    const auto view = figure.path.view();
    inflated::Shape other = inflated::any_shape(random);
    if (other.kind == VESICA_POINT || other.kind == VESICA_SEGMENT) continue;
    const double size = random.between(0.3, 4), whole = random.chance(0.6) ? 1 : 0;
    for (double& number : other.number) number = whole != 0 ? std::round(size * number) : size * number;
    if (vesica_check_f64(other.kind, other.number.data()) != 0) continue;
    double area = 0;
    if (vesica_shape_area_f64(other.kind, other.number.data(), &area) != 0 || area <= 0) continue;
    vesica_aabb_f64 bounds;
    ASSERT_EQ(vesica_bounds_f64(other.kind, other.number.data(), &bounds), 0);
    bool met = false, insides = false, leaves = false, met_outside = false, contained = true, strictly = true;
    const int low = static_cast<int>(std::floor(std::min(bounds.min_x, bounds.min_y) / 2)) - 1,
              high = static_cast<int>(std::ceil(std::max(bounds.max_x, bounds.max_y) / 2)) + 1;
    for (int x = std::min(low, 0); x <= std::max(high, grid.size()); ++x) {
      for (int y = std::min(low, 0); y <= std::max(high, grid.size()); ++y) {
        const vesica_aabb_f64 square{2.0 * x, 2.0 * y, 2.0 * x + 2, 2.0 * y + 2};
        const bool known = x >= 0 && y >= 0 && x < grid.size() && y < grid.size();
        const bool mine = known && figure.triangle[static_cast<std::size_t>(4 * (y * grid.size() + x))] == in;
        const std::int32_t r = vesica_relation_f64(VESICA_AABB, &square, other.kind, other.number.data());
        const bool inner = vesica_interiors_overlap_f64(VESICA_AABB, &square, other.kind, other.number.data()) == 1;
        (mine ? met : met_outside) |= r != VESICA_DISJOINT;
        (mine ? insides : leaves) |= inner;
        if (mine) contained = contained && (r == VESICA_INSIDE || r == VESICA_INSIDE_TOUCH || r == VESICA_EQUAL);
        if (mine) strictly = strictly && r == VESICA_INSIDE;
      }
    }
    const std::int32_t relation = contained && !leaves ? VESICA_EQUAL
                                  : contained          ? (strictly ? VESICA_INSIDE : VESICA_INSIDE_TOUCH)
                                  : !leaves            ? (met_outside ? VESICA_CONTAINS_TOUCH : VESICA_CONTAINS)
                                  : insides            ? VESICA_CROSS
                                  : met                ? VESICA_TOUCH
                                                       : VESICA_DISJOINT;
    ++seen[static_cast<std::size_t>(relation)];
    expect(VESICA_POLYGON, &view, other.kind, other.number.data(), relation, insides,
           std::to_string(other.kind) + " " + text(figure.path));
    if (HasFatalFailure()) return;
  }
  if (!properties::draws_all()) return;
  for (std::size_t r = 0; r < VESICA_EQUAL; ++r) EXPECT_GT(seen[r], 5) << r;
}

/// Float shapes are the doubles that they are.
TEST(PolygonRelation, OfFloats) {
  Random random(596);
  const int pairs = 4000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const Grid grid(random.integer(1, 3));
    const Figure a = region(grid, 0.5, random),
                 b = random.chance(0.5) ? neighbour(a, grid, random) : lines(grid, 5, random);
    const auto view_a = a.path.view(), view_b = b.path.view();
    const auto narrow = [](const Figure& f, std::vector<float>& xy) {
      xy.assign(f.path.xy.begin(), f.path.xy.end());
      const auto wide = f.path.view();
      return vesica_polygon_f32{xy.data(), xy.data() + 1, 8, wide.rings, wide.count};
    };
    std::vector<float> xy_a, xy_b;
    const auto narrow_a = narrow(a, xy_a), narrow_b = narrow(b, xy_b);
    ASSERT_EQ(vesica_relation_f32(kind_of(a), &narrow_a, kind_of(b), &narrow_b),
              vesica_relation_f64(kind_of(a), &view_a, kind_of(b), &view_b));
    ASSERT_EQ(vesica_interiors_overlap_f32(kind_of(b), &narrow_b, kind_of(a), &narrow_a),
              vesica_interiors_overlap_f64(kind_of(b), &view_b, kind_of(a), &view_a));
    const vesica_circle_f32 disc{2, 1, 0.5f};
    const vesica_circle_f64 wide_disc{2, 1, 0.5};
    ASSERT_EQ(vesica_contains_f32(kind_of(a), &narrow_a, VESICA_CIRCLE, &disc),
              vesica_contains_f64(kind_of(a), &view_a, VESICA_CIRCLE, &wide_disc));
  }
}

/// Any vertices, whose edges cross and overlap: an answer of the eight, and the same twice.
TEST(PolygonRelation, OfAnyVertices) {
  Random random(597);
  const int pairs = 20000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const Path a = lattice_path(random.integer(2, 6), random), b = lattice_path(random.integer(2, 6), random);
    const auto view_a = a.view(), view_b = b.view();
    const std::int32_t kind_a = random.chance(0.7) ? VESICA_POLYGON : VESICA_POLYLINE,
                       kind_b = random.chance(0.7) ? VESICA_POLYGON : VESICA_POLYLINE;
    const std::int32_t relation = vesica_relation_f64(kind_a, &view_a, kind_b, &view_b);
    ASSERT_GE(relation, VESICA_DISJOINT);
    ASSERT_LE(relation, VESICA_EQUAL);
    ASSERT_EQ(vesica_relation_f64(kind_a, &view_a, kind_b, &view_b), relation);
    const inflated::Shape other = inflated::any_shape(random);
    ASSERT_GE(vesica_relation_f64(kind_a, &view_a, other.kind, other.number.data()), VESICA_DISJOINT);
  }
}

/// Two equal outlines of 50,000 edges, and a smaller one inside: not every edge against every other.
TEST(PolygonRelation, OfManyVertices) {
  std::vector<double> ring, smaller;
  constexpr int n = 50000;
  for (int i = 0; i < n; ++i) {
    const double t = i * (6.283185307179586 / n), r = 1 + 0.01 * (i % 2);
    ring.insert(ring.end(), {r * std::cos(t), r * std::sin(t)});
    smaller.insert(smaller.end(), {0.97 * r * std::cos(t), 0.97 * r * std::sin(t)});
  }
  Path a, b;
  a.add_ring(ring);
  b.add_ring(smaller);
  const auto view_a = a.view(), view_b = b.view();
  expect(VESICA_POLYGON, &view_a, VESICA_POLYGON, &view_a, VESICA_EQUAL, true, "equal");
  expect(VESICA_POLYGON, &view_a, VESICA_POLYGON, &view_b, VESICA_CONTAINS, true, "inside");
  expect(VESICA_POLYGON, &view_a, VESICA_POLYLINE, &view_b, VESICA_CONTAINS, true, "chain");
}

/// Arrays, and joins by each question.
TEST(PolygonRelation, Arrays) {
  const std::vector<double> xy{0, 0, 4, 0, 4, 4, 0, 4, 4, 0, 8, 0, 8, 4, 4, 4, 1, 1, 2, 1, 2, 2, 1, 2};
  vesica_shapes_f64 quads{};
  quads.kind = VESICA_POLYGON;
  quads.count = 3;
  quads.stride = 16;
  quads.field[0] = xy.data();
  quads.field[1] = xy.data() + 1;
  quads.each = 4;
  std::array<std::uint8_t, 9> out{};
  ASSERT_EQ(vesica_relation_matrix_f64(&quads, &quads, out.data(), 3), 7);
  EXPECT_EQ(out, (std::array<std::uint8_t, 9>{7, 1, 5, 1, 7, 0, 3, 0, 7}));
  ASSERT_EQ(vesica_contains_matrix_f64(&quads, &quads, out.data(), 3), 4);
  EXPECT_EQ(out, (std::array<std::uint8_t, 9>{1, 0, 1, 0, 1, 0, 0, 0, 1}));
  ASSERT_EQ(vesica_interiors_overlap_matrix_f64(&quads, &quads, out.data(), 3), 5);
  EXPECT_EQ(out, (std::array<std::uint8_t, 9>{1, 0, 1, 0, 1, 0, 1, 0, 1}));
  std::array<std::uint8_t, 3> row{};
  const vesica_circle_f64 disc{4, 2, 1};
  vesica_shapes_f64 one;
  ASSERT_EQ(vesica_shapes_from_records_f64(VESICA_CIRCLE, 1, &disc, sizeof disc, &one), 0);
  ASSERT_EQ(vesica_relation_many_f64(&one, &quads, row.data()), 2);
  EXPECT_EQ(row, (std::array<std::uint8_t, 3>{2, 2, 0}));
  std::array<std::int64_t, 3> found{};
  ASSERT_EQ(vesica_interiors_overlap_select_f64(&one, &quads, found.data(), 3), 2);
  EXPECT_EQ(found, (std::array<std::int64_t, 3>{0, 1, -1}));
}

}  // namespace polygon_relation

// SPDX-License-Identifier: Apache-2.0
// Nine-intersection matrices of polygons and polylines, against cells of a grid that are known by construction.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "inflated/shapes.hpp"
#include "polygon/cells.hpp"
#include "polygon/shapes.hpp"
#include "properties/random.hpp"

namespace polygon_de9im {

using namespace polygons;

inline std::string matrix(std::int32_t kind_a, const void* a, std::int32_t kind_b, const void* b) {
  std::array<char, VESICA_DE9IM_SIZE> m{};
  const std::int32_t code = vesica_de9im_f64(kind_a, a, kind_b, b, m.data());
  return code == 0 ? m.data() : vesica_strerror(code);
}
inline std::string transposed(const std::string& m) { return {m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]}; }
inline void expect(std::int32_t kind_a, const void* a, std::int32_t kind_b, const void* b, const std::string& expected,
                   const std::string& what) {
  ASSERT_EQ(matrix(kind_a, a, kind_b, b), expected) << what;
  ASSERT_EQ(matrix(kind_b, b, kind_a, a), transposed(expected)) << what;
  ASSERT_EQ(vesica_relation_f64(kind_a, a, kind_b, b), relation_of(expected)) << what;
}
inline std::string text(const Path& path) {
  std::string out;
  for (std::size_t j = 0; j < path.ring_count(); ++j) {
    out += "(";
    for (std::int32_t i = path.rings[j]; i < path.rings[j + 1]; ++i) {
      const auto at = static_cast<std::size_t>(2 * i);
      out += std::to_string(path.xy[at]) + " " + std::to_string(path.xy[at + 1]) + ", ";
    }
    out += ") ";
  }
  return out;
}

TEST(PolygonDe9im, OfRegionsAndLinesOfAGrid) {
  Random random(605);
  std::set<std::string> seen;
  const int pairs = 15000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const Grid grid(random.integer(1, 3));
    const auto figure = [&](bool closed) {
      return closed ? region(grid, random.between(0.05, 0.9), random) : lines(grid, 6, random);
    };
    const bool closed_a = random.chance(0.6), closed_b = random.chance(0.6);
    const Figure a = figure(closed_a);
    const Figure b = closed_a && closed_b && random.chance(0.4) ? neighbour(a, grid, random) : figure(closed_b);
    const std::string m = matrix_of(a, b);
    seen.insert(m);
    const Map map(random);
    const Path path_a = map.of(a.path), path_b = map.of(b.path);
    const auto view_a = path_a.view(), view_b = path_b.view();
    expect(a.closed ? VESICA_POLYGON : VESICA_POLYLINE, &view_a, b.closed ? VESICA_POLYGON : VESICA_POLYLINE, &view_b,
           m, text(a.path) + "and " + text(b.path));
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(seen.size(), 60u);
}

/// A box as a polygon of its corners has the box's matrix, with shapes of every kind.
TEST(PolygonDe9im, OfBoxesAsPolygons) {
  Random random(606);
  const int pairs = 20000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    inflated::Shape other = random.chance(0.5) ? inflated::any_shape(random) : inflated::lattice_shape(random);
    if (random.chance(0.5)) {
      for (double& number : other.number) number = std::round(2 * number);
    }
    if (vesica_check_f64(other.kind, other.number.data()) != 0) continue;
    std::array<double, 4> at{};
    for (std::size_t k = 0; k < 4; ++k) {
      at[k] = random.chance(0.3)   ? other.number[k % 2]
              : random.chance(0.5) ? random.integer(-2, 2)
                                   : random.between(-2, 2);
    }
    if (random.chance(0.1)) at[2] = at[0];
    if (random.chance(0.1)) at[3] = at[1];
    const vesica_aabb_f64 box{std::min(at[0], at[2]), std::min(at[1], at[3]), std::max(at[0], at[2]),
                              std::max(at[1], at[3])};
    // Collinear vertices change nothing.
    const double middle = random.chance(0.5) ? box.max_x : std::round(0.5 * box.min_x + 0.5 * box.max_x);
    Path path;
    path.add_ring({box.min_x, box.min_y, std::max(std::min(middle, box.max_x), box.min_x), box.min_y, box.max_x,
                   box.min_y, box.max_x, box.max_y, box.min_x, box.max_y});
    path = rewritten(path, random);
    const auto view = path.view();
    expect(VESICA_POLYGON, &view, other.kind, other.number.data(),
           matrix(VESICA_AABB, &box, other.kind, other.number.data()), inflated::described(other) + " " + text(path));
    if (HasFatalFailure()) return;
    // A chain of two vertices is a segment.
    const vesica_segment_f64 segment{at[0], at[1], at[2], at[3]};
    Path chain;
    chain.add_ring({at[0], at[1], at[2], at[3]});
    const auto line = chain.view();
    expect(VESICA_POLYLINE, &line, other.kind, other.number.data(),
           matrix(VESICA_SEGMENT, &segment, other.kind, other.number.data()), inflated::described(other));
    if (HasFatalFailure()) return;
    // Cut in two, it is the same.
    if (at[0] + at[2] != 2 * std::round((at[0] + at[2]) / 2) || at[1] + at[3] != 2 * std::round((at[1] + at[3]) / 2)) {
      continue;
    }
    Path cut;
    cut.add_ring({at[0], at[1], 0.5 * (at[0] + at[2]), 0.5 * (at[1] + at[3]), at[2], at[3]});
    const auto two = cut.view();
    expect(VESICA_POLYLINE, &two, other.kind, other.number.data(),
           matrix(VESICA_SEGMENT, &segment, other.kind, other.number.data()), inflated::described(other) + text(cut));
    if (HasFatalFailure()) return;
  }
}

/// Unions of squares and any convex shape: what each open square, side and corner shares with that.
TEST(PolygonDe9im, OfUnionsOfSquares) {
  Random random(607);
  std::set<std::string> seen;
  const int pairs = 4000 * properties::repeat();
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
    inflated::Shape other = random.chance(0.6) ? inflated::any_shape(random) : inflated::lattice_shape(random);
    const double size = random.between(0.3, 4), whole = random.chance(0.7) ? 1 : 0;
    for (double& number : other.number) number = whole != 0 ? std::round(size * number) : size * number;
    if (vesica_check_f64(other.kind, other.number.data()) != 0) continue;
    vesica_aabb_f64 bounds;
    ASSERT_EQ(vesica_bounds_f64(other.kind, other.number.data(), &bounds), 0);
    const int low = std::min(0, static_cast<int>(std::floor(std::min(bounds.min_x, bounds.min_y) / 2))) - 1,
              high = std::max(grid.size(), static_cast<int>(std::ceil(std::max(bounds.max_x, bounds.max_y) / 2))) + 1;
    const auto filled = [&](int x, int y) {
      const bool known = x >= 0 && y >= 0 && x < grid.size() && y < grid.size();
      return known && figure.triangle[static_cast<std::size_t>(4 * (y * grid.size() + x))] == in;
    };
    std::string m = "FFFFFFFF2";
    const auto note = [&](int squares, int of, std::int32_t kind, const void* cell) {
      const std::string of_cell = matrix(kind, cell, other.kind, other.number.data());
      const std::size_t row = squares == of ? 0 : squares == 0 ? 2 : 1;
      for (std::size_t k = 0; k < 3; ++k) {
        char& known = m[3 * row + k];
        if (of_cell[k] != 'F' && (known == 'F' || known < of_cell[k])) known = of_cell[k];
      }
    };
    for (int x = low; x <= high; ++x) {
      for (int y = low; y <= high; ++y) {
        const double px = 2 * x, py = 2 * y;
        const int here = filled(x, y) ? 1 : 0, left = filled(x - 1, y) ? 1 : 0, below = filled(x, y - 1) ? 1 : 0,
                  across = filled(x - 1, y - 1) ? 1 : 0;
        const vesica_aabb_f64 square{px, py, px + 2, py + 2};
        const vesica_segment_f64 upright{px, py, px, py + 2}, level{px, py, px + 2, py};
        const vesica_point_f64 corner{px, py};
        note(here, 1, VESICA_AABB, &square);
        note(here + left, 2, VESICA_SEGMENT, &upright);
        note(here + below, 2, VESICA_SEGMENT, &level);
        note(here + left + below + across, 4, VESICA_POINT, &corner);
      }
    }
    seen.insert(m);
    expect(VESICA_POLYGON, &view, other.kind, other.number.data(), m,
           inflated::described(other) + " " + text(figure.path));
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(seen.size(), 15u);
}

/// Floats are the doubles that they are; errors leave the matrix alone.
TEST(PolygonDe9im, FloatsAndErrors) {
  const std::vector<double> wide{0, 0, 4, 0, 4, 4, 0, 4};
  const std::vector<float> narrow(wide.begin(), wide.end());
  const vesica_polygon_f64 polygon{wide.data(), wide.data() + 1, 16, nullptr, 4};
  const vesica_polygon_f32 narrow_polygon{narrow.data(), narrow.data() + 1, 8, nullptr, 4};
  const vesica_circle_f32 disc{4, 2, 1};
  std::array<char, VESICA_DE9IM_SIZE> m{};
  EXPECT_EQ(vesica_de9im_f32(VESICA_POLYGON, &narrow_polygon, VESICA_CIRCLE, &disc, m.data()), 0);
  EXPECT_STREQ(m.data(), "212101212");
  const vesica_circle_f64 invalid{0, 0, -1};
  EXPECT_EQ(vesica_de9im_f64(VESICA_POLYGON, &polygon, VESICA_CIRCLE, &invalid, m.data()), VESICA_E_SHAPE);
  EXPECT_EQ(vesica_de9im_f64(VESICA_POLYGON, &polygon, VESICA_CIRCLE, &invalid, nullptr), VESICA_E_NULL);
  EXPECT_STREQ(m.data(), "212101212");
}

}  // namespace polygon_de9im

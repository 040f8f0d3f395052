// SPDX-License-Identifier: Apache-2.0
// Shares of cells: against the area that each cell has in common with the shape, whole cells, laws, bad input.
#include <gtest/gtest.h>
#include <vesica.h>
#include <vesica_measures.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "inflated/shapes.hpp"
#include "polygon/shapes.hpp"
#include "properties/random.hpp"

namespace coverage_of_cells {

using properties::Random;
using Image = std::vector<double>;

struct Subject {
  std::int32_t kind;
  const void* shape;
};

inline Image coverage(const Subject& s, const vesica_grid_f64& grid) {
  Image out(static_cast<std::size_t>(grid.columns * grid.rows), -1.0);
  EXPECT_EQ(vesica_coverage_f64(s.kind, s.shape, &grid, out.data(), grid.columns), 0);
  return out;
}
inline vesica_aabb_f64 cell(const vesica_grid_f64& g, std::int64_t i, std::int64_t j) {
  const auto x = static_cast<double>(i), y = static_cast<double>(j);
  return {g.x + x * g.dx, g.y + y * g.dy, g.x + (x + 1) * g.dx, g.y + (y + 1) * g.dy};
}
/// The share by the area in common.
inline double expected(const Subject& s, const vesica_grid_f64& g, std::int64_t i, std::int64_t j) {
  const vesica_aabb_f64 box = cell(g, i, j);
  double area = -1;
  EXPECT_EQ(vesica_area_f64(s.kind, s.shape, VESICA_AABB, &box, &area), 0);
  return area / (g.dx * g.dy);
}
inline vesica_aabb_f64 bounds(const Subject& s) {
  vesica_aabb_f64 box{};
  EXPECT_EQ(vesica_bounds_f64(s.kind, s.shape, &box), 0);
  return box;
}
/// A grid with some cells about the shape, or about a part of it.
inline vesica_grid_f64 any_grid(const Subject& s, Random& random) {
  const vesica_aabb_f64 box = bounds(s);
  const double width = box.max_x - box.min_x + 1e-3, height = box.max_y - box.min_y + 1e-3;
  const double dx = width / random.between(0.5, 12), dy = height / random.between(0.5, 12);
  return {box.min_x - width * random.between(-0.6, 0.3),
          box.min_y - height * random.between(-0.6, 0.3),
          dx,
          dy,
          random.integer(1, 14),
          random.integer(1, 14)};
}
/// How far the shares are off at most, in a unit of the largest coordinate in cells.
inline double largest_error(const Subject& s, const vesica_grid_f64& g) {
  const Image shares = coverage(s, g);
  const vesica_aabb_f64 box = bounds(s);
  const double most_x = std::max({std::abs(box.min_x), std::abs(box.max_x), std::abs(g.x)}) / g.dx;
  const double most_y = std::max({std::abs(box.min_y), std::abs(box.max_y), std::abs(g.y)}) / g.dy;
  double most = 0;
  for (std::int64_t j = 0; j < g.rows; ++j) {
    for (std::int64_t i = 0; i < g.columns; ++i) {
      const double share = shares[static_cast<std::size_t>(j * g.columns + i)];
      EXPECT_GE(share, 0);
      EXPECT_LE(share, 1);
      most = std::max(most, std::abs(share - expected(s, g, i, j)));
    }
  }
  return most / (0x1p-53 * (16 + most_x + most_y));
}

TEST(Coverage, IsTheAreaInCommonWithEachCell) {
  Random random(51);
  double most = 0;
  for (int n = 4000 * properties::repeat(); n > 0; --n) {
    const inflated::Shape s = inflated::any_shape(random);
    const Subject subject{s.kind, s.number.data()};
    const double error = largest_error(subject, any_grid(subject, random));
    ASSERT_LE(error, 4) << inflated::described(s);
    most = std::max(most, error);
  }
  RecordProperty("most", std::to_string(most));
}

TEST(Coverage, OfPolygonsWithHoles) {
  Random random(52);
  for (int n = 1000 * properties::repeat(); n > 0; --n) {
    polygons::Path path;
    const double x = random.between(-3, 3), y = random.between(-3, 3);
    path.add_ring(polygons::star(random.integer(3, 40), x, y, 2, 0.6, random));
    if (random.chance(0.6)) path.add_ring(polygons::star(random.integer(3, 9), x, y, 0.5, 0.3, random));
    const polygons::Path other = polygons::rewritten(path, random);
    for (const polygons::Path* each : {static_cast<const polygons::Path*>(&path), &other}) {
      const auto view = each->view();
      if (vesica_check_f64(VESICA_POLYGON, &view) != 0) continue;
      const Subject subject{VESICA_POLYGON, &view};
      // Areas of polygons have a bound that grows with their edges.
      ASSERT_LE(largest_error(subject, any_grid(subject, random)), 200);
    }
  }
}

TEST(Coverage, OfWholeCellsIsExact) {
  Random random(53);
  int whole = 0, empty = 0;
  for (int n = 2000 * properties::repeat(); n > 0; --n) {
    const inflated::Shape s = inflated::any_shape(random);
    const Subject subject{s.kind, s.number.data()};
    vesica_grid_f64 g = any_grid(subject, random);
    g.dx /= 3, g.dy /= 3;
    const Image shares = coverage(subject, g);
    for (std::int64_t j = 0; j < g.rows; ++j) {
      for (std::int64_t i = 0; i < g.columns; ++i) {
        const double share = shares[static_cast<std::size_t>(j * g.columns + i)];
        vesica_aabb_f64 box = cell(g, i, j);
        const double mx = 1e-12 * (1 + std::abs(box.min_x)), my = 1e-12 * (1 + std::abs(box.min_y));
        box = {box.min_x - mx, box.min_y - my, box.max_x + mx, box.max_y + my};
        if (vesica_contains_f64(s.kind, subject.shape, VESICA_AABB, &box) == 1) {
          ASSERT_EQ(share, 1);
          ++whole;
        } else if (vesica_overlap_f64(s.kind, subject.shape, VESICA_AABB, &box) == 0) {
          ASSERT_EQ(share, 0);
          ++empty;
        }
      }
    }
  }
  EXPECT_GT(whole, 1000 * properties::repeat());
  EXPECT_GT(empty, 1000 * properties::repeat());
}

// Larger than the parts in which cells are found.
TEST(Coverage, OfManyCellsSumsToTheArea) {
  const double angle = 0.3;
  const vesica_circle_f64 circle{100.3, 99.1, 90};
  const vesica_ellipse_f64 ellipse{300, 100, std::cos(angle), std::sin(angle), 280, 60};
  const vesica_capsule_f64 capsule{50, 20, 500, 170, 15.5};
  const vesica_round_rect_f64 card{300, 100, std::cos(angle), std::sin(angle), 200, 30, 7.25};
  const vesica_rect_f64 rect{300, 100, std::cos(angle), std::sin(angle), 250, 20};
  const Subject subjects[] = {{VESICA_CIRCLE, &circle},
                              {VESICA_ELLIPSE, &ellipse},
                              {VESICA_CAPSULE, &capsule},
                              {VESICA_ROUND_RECT, &card},
                              {VESICA_RECT, &rect}};
  for (const Subject& s : subjects) {
    double area = 0;
    EXPECT_EQ(vesica_shape_area_f64(s.kind, s.shape, &area), 0);
    for (const double size : {1.0, 0.37, 3.0}) {
      const auto columns = static_cast<std::int64_t>(620 / size), rows = static_cast<std::int64_t>(260 / size);
      const vesica_grid_f64 g{-5, -20, size, size, columns, rows};
      long double sum = 0;
      for (const double share : coverage(s, g)) sum += share;
      EXPECT_NEAR(static_cast<double>(sum * size * size / area), 1, 1e-13) << s.kind;
    }
  }
}

TEST(Coverage, OfShapesWithoutAreaIsNothing) {
  const vesica_point_f64 point{1.5, 1.5};
  const vesica_segment_f64 segment{0, 0, 3, 3};
  const vesica_circle_f64 disc{1, 1, 0};
  const vesica_rect_f64 rect{1, 1, 0.6, 0.8, 2, 0};
  const vesica_ellipse_f64 ellipse{1, 1, 0.6, 0.8, 2, 0}, other{1, 1, 0.6, 0.8, 0, 2};
  const vesica_capsule_f64 capsule{0, 0, 3, 2, 0};
  const vesica_round_rect_f64 card{1, 1, 0.6, 0.8, 0, 2, 0};
  const double xy[] = {0, 0, 3, 0, 3, 3};
  const vesica_polyline_f64 line{xy, xy + 1, 16, nullptr, 3};
  const vesica_polygon_f64 flat{xy, xy + 1, 16, nullptr, 2};
  const Subject subjects[] = {{VESICA_POINT, &point},     {VESICA_SEGMENT, &segment}, {VESICA_CIRCLE, &disc},
                              {VESICA_RECT, &rect},       {VESICA_ELLIPSE, &ellipse}, {VESICA_ELLIPSE, &other},
                              {VESICA_CAPSULE, &capsule}, {VESICA_ROUND_RECT, &card}, {VESICA_POLYLINE, &line},
                              {VESICA_POLYGON, &flat}};
  for (const Subject& s : subjects) {
    for (const double share : coverage(s, {-1, -1, 0.5, 0.25, 10, 20})) EXPECT_EQ(share, 0) << s.kind;
  }
}

TEST(Coverage, KnowsFewFigures) {
  const vesica_aabb_f64 box{0.5, 0.25, 2.5, 1.75};
  EXPECT_EQ(coverage({VESICA_AABB, &box}, {0, 0, 1, 1, 3, 2}), (Image{0.375, 0.75, 0.375, 0.375, 0.75, 0.375}));
  const vesica_rect_f64 diamond{1, 1, 1, 1, 0.5, 0.5};
  EXPECT_EQ(coverage({VESICA_RECT, &diamond}, {0, 0, 1, 1, 2, 2}), (Image{0.5, 0.5, 0.5, 0.5}));
  // A disc of radius 1 about a corner of the cells: a quarter of pi each.
  const vesica_circle_f64 disc{1, 1, 1};
  for (const double share : coverage({VESICA_CIRCLE, &disc}, {0, 0, 1, 1, 2, 2})) {
    EXPECT_NEAR(share, 0.78539816339744831, 2e-16);
  }
  // Larger than all cells, and inside one of them.
  const vesica_circle_f64 large{1, 1, 100}, little{1.5, 0.5, 0.25};
  EXPECT_EQ(coverage({VESICA_CIRCLE, &large}, {0, 0, 1, 1, 2, 1}), (Image{1, 1}));
  const Image one = coverage({VESICA_CIRCLE, &little}, {0, 0, 1, 1, 2, 1});
  EXPECT_EQ(one[0], 0);
  EXPECT_NEAR(one[1], 0.19634954084936207, 1e-16);
  EXPECT_EQ(coverage({VESICA_CIRCLE, &little}, {0, 0, 1, 1, 0, 5}), Image{});
}

TEST(Coverage, ScalesWithPowersOfTwo) {
  Random random(54);
  for (int n = 500 * properties::repeat(); n > 0; --n) {
    const inflated::Shape s = inflated::any_shape(random);
    const Subject subject{s.kind, s.number.data()};
    const vesica_grid_f64 g = any_grid(subject, random);
    const double factor = std::ldexp(1, random.integer(-900, 900));
    const inflated::Shape t = inflated::times(s, factor);
    EXPECT_EQ(coverage({t.kind, t.number.data()},
                       {g.x * factor, g.y * factor, g.dx * factor, g.dy * factor, g.columns, g.rows}),
              coverage(subject, g));
  }
}

TEST(Coverage, OfNearlyNothingAndOfTheWholeRange) {
  // Half extents whose inverse overflows.
  const vesica_ellipse_f64 thin{2, 0, 1, 1e-310, 3, 1e-310}, tiny{0, 0, 1, 1, 1e-200, 0.5e-200};
  for (const double share : coverage({VESICA_ELLIPSE, &thin}, {0, 0, 1, 1, 4, 4})) EXPECT_EQ(share, 0);
  for (const double share : coverage({VESICA_ELLIPSE, &tiny}, {-1e-200, 0, 1e-200, 1e110, 4, 4})) EXPECT_EQ(share, 0);
  const vesica_round_rect_f64 card{2, 2, 1, 0, 1, 1, 1e-310};
  EXPECT_EQ(coverage({VESICA_ROUND_RECT, &card}, {0, 0, 1, 1, 4, 1}), Image(4, 0.0));
  EXPECT_EQ(coverage({VESICA_ROUND_RECT, &card}, {0, 1, 1, 1, 4, 1}), (Image{0, 1, 1, 0}));
  // Extents that overflow.
  const vesica_aabb_f64 wide{-1.5e308, 0, 1.5e308, 1};
  EXPECT_EQ(coverage({VESICA_AABB, &wide}, {-1.5e308, 0, 1e308, 1, 3, 1}), (Image{1, 1, 1}));
}

TEST(Coverage, ListsTheCellsThatAreCovered) {
  const vesica_capsule_f64 capsule{10, 5, 600, 40, 6};
  const vesica_grid_f64 g{0, 0, 1, 1, 700, 60};
  const Image all = coverage({VESICA_CAPSULE, &capsule}, g);
  std::vector<std::int64_t> cells(all.size());
  Image shares(all.size()), again(all.size(), 0.0);
  const std::int64_t count = vesica_coverage_cells_f64(VESICA_CAPSULE, &capsule, &g, cells.data(), shares.data(),
                                                       static_cast<std::int64_t>(cells.size()));
  ASSERT_EQ(count, std::count_if(all.begin(), all.end(), [](double share) { return share > 0; }));
  for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
    again[static_cast<std::size_t>(cells[k])] = shares[k];
  }
  EXPECT_EQ(again, all);
  // Without room it counts.
  EXPECT_EQ(vesica_coverage_cells_f64(VESICA_CAPSULE, &capsule, &g, nullptr, nullptr, 0), count);
  std::fill(cells.begin(), cells.end(), -1);
  EXPECT_EQ(vesica_coverage_cells_f64(VESICA_CAPSULE, &capsule, &g, cells.data(), shares.data(), 5), count);
  EXPECT_EQ(cells[5], -1);
  EXPECT_NE(cells[4], -1);
}

TEST(Coverage, OfFloatsIsThatOfDoublesRounded) {
  const vesica_ellipse_f32 narrow{3.1F, 2.2F, 0.6F, 0.8F, 2.5F, 1.25F};
  const vesica_ellipse_f64 wide{narrow.cx, narrow.cy, narrow.ux, narrow.uy, narrow.a, narrow.b};
  const vesica_grid_f32 grid{0.1F, 0.2F, 0.3F, 0.7F, 30, 9};
  const vesica_grid_f64 cells{grid.x, grid.y, grid.dx, grid.dy, 30, 9};
  std::vector<float> out(40 * 9, -1.0F);
  EXPECT_EQ(vesica_coverage_f32(VESICA_ELLIPSE, &narrow, &grid, out.data(), 40), 0);
  const Image shares = coverage({VESICA_ELLIPSE, &wide}, cells);
  for (std::size_t j = 0; j < 9; ++j) {
    for (std::size_t i = 0; i < 30; ++i) EXPECT_EQ(out[40 * j + i], static_cast<float>(shares[30 * j + i]));
    EXPECT_EQ(out[40 * j + 30], -1.0F);
  }
}

TEST(Coverage, RefusesBadInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const vesica_circle_f64 disc{1, 1, 1}, bad{1, 1, -1}, distant{1e300, 0, 1};
  const vesica_grid_f64 good{0, 0, 1, 1, 2, 2};
  Image out(4, 9.0);
  const auto ask = [&](const void* shape, vesica_grid_f64 g, std::ptrdiff_t row = 2) {
    return vesica_coverage_f64(VESICA_CIRCLE, shape, &g, out.data(), row);
  };
  EXPECT_EQ(ask(nullptr, good), VESICA_E_NULL);
  EXPECT_EQ(vesica_coverage_f64(VESICA_CIRCLE, &disc, nullptr, out.data(), 2), VESICA_E_NULL);
  EXPECT_EQ(vesica_coverage_f64(VESICA_CIRCLE, &disc, &good, nullptr, 2), VESICA_E_NULL);
  EXPECT_EQ(vesica_coverage_f64(99, &disc, &good, out.data(), 2), VESICA_E_KIND);
  EXPECT_EQ(ask(&bad, good), VESICA_E_SHAPE);
  EXPECT_EQ(ask(&distant, good), VESICA_E_RANGE);
  EXPECT_EQ(ask(&disc, good, 1), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(&disc, good, -2), VESICA_E_ARGUMENT);
  for (const double wrong : {0.0, -1.0, nan, infinite}) {
    EXPECT_EQ(ask(&disc, {0, 0, wrong, 1, 2, 2}), VESICA_E_ARGUMENT);
    EXPECT_EQ(ask(&disc, {0, 0, 1, wrong, 2, 2}), VESICA_E_ARGUMENT);
  }
  EXPECT_EQ(ask(&disc, {nan, 0, 1, 1, 2, 2}), VESICA_E_ARGUMENT);
  EXPECT_EQ(ask(&disc, {0, 0, 1, 1, -2, 2}), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_coverage_cells_f64(VESICA_CIRCLE, &disc, &good, nullptr, nullptr, 4), VESICA_E_NULL);
  std::int64_t cells[4];
  EXPECT_EQ(vesica_coverage_cells_f64(VESICA_CIRCLE, &disc, &good, cells, out.data(), -1), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_coverage_cells_f64(VESICA_CIRCLE, &bad, &good, cells, out.data(), 4), VESICA_E_SHAPE);
  EXPECT_EQ(out, Image(4, 9.0));
}

}  // namespace coverage_of_cells

// SPDX-License-Identifier: Apache-2.0
/// Cells of a grid, shaded by the share of each that a disc, and a polygon with a hole, cover.
#include "figures.hpp"
#include "shapes.hpp"

namespace figures {
namespace {

constexpr int columns = 12, rows = 10;
constexpr vesica::Grid<double> cells{0, 0, 1, 1, columns, rows};
constexpr double side = 30;

/// Hundredths of a cell that is neither empty nor whole.
std::string label(double share) {
  const double hundredths = std::round(100 * share);
  return hundredths == 0 ? "<1" : hundredths == 100 ? ">99" : format("%.0f", hundredths);
}

/// The cells of a shape; returns the sum of all shares. Cells between empty and whole have their share in hundredths.
template <class Shape>
double draw_cells(Svg& svg, const Plane& plane, const Shape& shape, std::string_view colour) {
  double sum = 0;
  const auto draw = [&](std::int64_t row, std::int64_t first, const double* shares, std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i) {
      const double share = shares[i];
      sum += share;
      const Point corner{static_cast<double>(first + i), static_cast<double>(row)};
      const std::vector<Point> square{corner, corner + Point{1, 0}, corner + Point{1, 1}, corner + Point{0, 1}};
      svg.path(plane(square), true, {light, 1, share > 0 ? colour : "none", 0.75 * share, ""});
      if (share == 0 || share == 1) continue;
      svg.text(plane(corner + Point{0.5, 0.37}), label(share), Anchor::middle, 10);
    }
  };
  require(vesica::coverage_or_error(shape, cells, true, draw) == 0, "cells have shares");
  return sum;
}

void draw_disc(Svg& svg) {
  const Circle disc{5.8, 5.1, 4.3};
  const Plane plane{{15, 315}, side};
  const double sum = draw_cells(svg, plane, disc, blue);
  const double area = std::numbers::pi * disc.r * disc.r;
  require(std::fabs(sum - area) < 1e-12, "shares add up to the disc's area");
  svg.path(plane(outline(disc)), true, {blue, 2});
  svg.text({15, 340}, format("A disc: shares add up to its area, %.4f.", sum), Anchor::start, 14);
}

void draw_polygon(Svg& svg) {
  constexpr double x[] = {0.6, 11.2, 9.3, 10.7, 5.9, 1.4, 4.2, 7.6, 6.9, 4.6};
  constexpr double y[] = {1.3, 0.7, 5.2, 9.4, 8.3, 9.1, 3.3, 3.7, 6.6, 6.2};
  constexpr std::int32_t rings[] = {0, 6, 10};
  const vesica::Polygon<double> polygon{x, y, sizeof(double), rings, 2};
  double area = 0;
  require(vesica::shape_area_or_error(polygon, area) == 0, "the polygon has an area");
  const Plane plane{{405, 315}, side};
  const double sum = draw_cells(svg, plane, polygon, green);
  require(std::fabs(sum - area) < 1e-12, "shares add up to the polygon's area");
  for (int r = 0; r < 2; ++r) {
    std::vector<Point> ring;
    for (int k = rings[r]; k < rings[r + 1]; ++k) ring.push_back({x[k], y[k]});
    svg.path(plane(ring), true, {green, 2});
  }
  svg.text({405, 340}, format("A polygon with a hole: %.4f.", sum), Anchor::start, 14);
}

}  // namespace

std::string coverage() {
  Svg svg(780, 355, "The share of each cell that a disc, and a polygon with a hole, cover");
  draw_disc(svg);
  draw_polygon(svg);
  return svg.str();
}

}  // namespace figures

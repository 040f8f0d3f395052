// SPDX-License-Identifier: Apache-2.0
/// Boost.Geometry: intersection() of two polygons in double, and its area. Only that is timed, not
/// the making of the polygons.
#include <boost/geometry/algorithms/area.hpp>
#include <boost/geometry/algorithms/intersection.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <memory>
#include <vector>

#include "relation/area_peer.hpp"

namespace vesica::bench {
namespace {

using Point = boost::geometry::model::d2::point_xy<double>;
using Polygon = boost::geometry::model::polygon<Point, false, false>;  // counter-clockwise, not closed
using Multipolygon = boost::geometry::model::multi_polygon<Polygon>;

constexpr int corners_of_ellipse = 64;

Polygon polygon(std::int32_t kind, const Numbers& n) {
  const bool circle = kind == VESICA_CIRCLE, box = kind == VESICA_RECT;
  const double ux = circle ? 1 : n[2], uy = circle ? 0 : n[3], a = circle ? n[2] : n[4], b = circle ? n[2] : n[5];
  Polygon result;
  const int count = box ? 4 : corners_of_ellipse;
  for (int i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * i / count;
    const double s = box ? (i == 1 || i == 2 ? a : -a) : a * std::cos(angle);
    const double t = box ? (i >= 2 ? b : -b) : b * std::sin(angle);
    result.outer().emplace_back(n[0] + s * ux - t * uy, n[1] + s * uy + t * ux);
  }
  return result;
}

double shared_area(const Polygon& a, const Polygon& b) {
  Multipolygon both;
  boost::geometry::intersection(a, b, both);
  return boost::geometry::area(both);
}

}  // namespace

struct BoostPairs::Polygons {
  std::vector<Polygon> a, b;
};

BoostPairs::BoostPairs() : polygons_(std::make_unique<Polygons>()) {}
BoostPairs::~BoostPairs() = default;

void BoostPairs::add(std::int32_t kind_a, const Numbers& a, std::int32_t kind_b, const Numbers& b) {
  polygons_->a.push_back(polygon(kind_a, a));
  polygons_->b.push_back(polygon(kind_b, b));
}

double BoostPairs::area(std::size_t pair) const { return shared_area(polygons_->a[pair], polygons_->b[pair]); }

struct BoostRows::Polygons {
  std::vector<Polygon> rows, columns;
  std::vector<double> row_areas, column_areas;
};

BoostRows::BoostRows() : polygons_(std::make_unique<Polygons>()) {}
BoostRows::BoostRows(BoostRows&&) noexcept = default;
BoostRows& BoostRows::operator=(BoostRows&&) noexcept = default;
BoostRows::~BoostRows() = default;

void BoostRows::add_row(const Numbers& rect) {
  polygons_->rows.push_back(polygon(VESICA_RECT, rect));
  polygons_->row_areas.push_back(boost::geometry::area(polygons_->rows.back()));
}

void BoostRows::add_column(const Numbers& rect) {
  polygons_->columns.push_back(polygon(VESICA_RECT, rect));
  polygons_->column_areas.push_back(boost::geometry::area(polygons_->columns.back()));
}

double BoostRows::iou(std::size_t row, std::size_t column) const {
  const double both = shared_area(polygons_->rows[row], polygons_->columns[column]);
  return both / (polygons_->row_areas[row] + polygons_->column_areas[column] - both);
}

}  // namespace vesica::bench

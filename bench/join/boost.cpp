// SPDX-License-Identifier: Apache-2.0
/// Boost.Geometry's packed R-tree.
#include <boost/function_output_iterator.hpp>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>

#include "join/peers.hpp"

namespace vesica::bench {
namespace {

namespace bg = boost::geometry;
using Point = bg::model::point<double, 2, bg::cs::cartesian>;
using Box = bg::model::box<Point>;
using Value = std::pair<Box, std::uint32_t>;
using Tree = bg::index::rtree<Value, bg::index::rstar<16>>;

Box box(const BoxRecord& b) { return {Point(b.min_x, b.min_y), Point(b.max_x, b.max_y)}; }

Tree tree_of(const std::vector<RectRecord>& shapes) {
  std::vector<Value> values(shapes.size());
  for (std::size_t i = 0; i < shapes.size(); ++i) values[i] = {box(box_of(shapes[i])), static_cast<std::uint32_t>(i)};
  return Tree(values.begin(), values.end());
}

PeerJoin join(const std::vector<RectRecord>& a, const std::vector<RectRecord>& b) {
  const double begin = seconds();
  const Tree tree = tree_of(b);
  const double built = seconds();
  std::int64_t pairs = 0;
  for (const std::uint32_t i : hilbert_order(a)) {
    tree.query(bg::index::intersects(box(box_of(a[i]))), boost::make_function_output_iterator([&](const Value& v) {
                 pairs += overlap_naively(a[i], b[v.second]);
               }));
  }
  return {built - begin, seconds() - built, pairs};
}

double windows(const std::vector<RectRecord>& a, const std::vector<BoxRecord>& windows, int repeats) {
  const Tree tree = tree_of(a);
  return quickest(repeats, [&] {
    std::int64_t hits = 0;
    for (const BoxRecord& w : windows) {
      tree.query(bg::index::intersects(box(w)), boost::make_function_output_iterator([&](const Value&) { ++hits; }));
    }
    keep(hits);
  });
}

PeerNearest nearest(const std::vector<BoxRecord>& boxes, const std::vector<PointRecord>& points, unsigned k,
                    int repeats) {
  std::vector<Value> values(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) values[i] = {box(boxes[i]), static_cast<std::uint32_t>(i)};
  const Tree tree(values.begin(), values.end());
  double sum = 0;
  const double taken = quickest(repeats, [&] {
    sum = 0;
    for (const PointRecord& p : points) {
      const Point point(p.x, p.y);
      double farthest = 0;
      tree.query(bg::index::nearest(point, k), boost::make_function_output_iterator([&](const Value& v) {
                   farthest = std::max(farthest, bg::comparable_distance(point, v.first));
                 }));
      sum += std::sqrt(farthest);
    }
  });
  return {taken, sum};
}

[[maybe_unused]] const bool listed = (peers().push_back({"Boost", join, windows, nearest}), true);

}  // namespace
}  // namespace vesica::bench

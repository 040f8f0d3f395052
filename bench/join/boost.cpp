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
Box shape_of(const BoxRecord& b) { return box(b); }
Point shape_of(const PointRecord& p) { return {p.x, p.y}; }

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

/// Points are in a tree of points.
template <class Record>
PeerNearest nearest(const std::vector<Record>& records, const std::vector<PointRecord>& asked, unsigned k,
                    int repeats) {
  using Entry = std::pair<decltype(shape_of(records[0])), std::uint32_t>;
  std::vector<Entry> entries(records.size());
  for (std::size_t i = 0; i < records.size(); ++i) entries[i] = {shape_of(records[i]), static_cast<std::uint32_t>(i)};
  const bg::index::rtree<Entry, bg::index::rstar<16>> tree(entries.begin(), entries.end());
  double sum = 0;
  auto next = asked.begin();
  const double taken = quickest(repeats, [&] {
    sum = 0;
    for (const auto end = next + std::ptrdiff_t(asked.size()) / repeats; next != end; ++next) {
      const Point point(next->x, next->y);
      double farthest = 0;
      tree.query(bg::index::nearest(point, k), boost::make_function_output_iterator([&](const Entry& entry) {
                   farthest = std::max(farthest, bg::comparable_distance(point, entry.first));
                 }));
      sum += std::sqrt(farthest);
    }
  });
  return {taken, sum};
}

[[maybe_unused]] const bool listed =
    (peers().push_back({"Boost", join, windows, nearest<BoxRecord>, nearest<PointRecord>}), true);

}  // namespace
}  // namespace vesica::bench

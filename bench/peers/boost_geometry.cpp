// SPDX-License-Identifier: Apache-2.0
/// Boost.Geometry: intersects() of two rings in double.
#include <boost/geometry/algorithms/intersects.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "peer.hpp"

namespace vesica::bench {
namespace {

using Point = boost::geometry::model::d2::point_xy<double>;
using Ring = boost::geometry::model::ring<Point, false, false>;  // counter-clockwise, not closed

class BoostPairs final : public NativePairs {
 public:
  void add(const Outline& a, const Outline& b) override { pairs_.emplace_back(ring(a), ring(b)); }

  std::int64_t hits(std::span<const std::size_t> indices) override {
    std::int64_t hits = 0;
    for (const std::size_t i : indices) hits += boost::geometry::intersects(pairs_[i].first, pairs_[i].second);
    return hits;
  }

 private:
  static Ring ring(const Outline& outline) {
    Ring ring;
    for (const Vertex& vertex : outline) ring.emplace_back(vertex.x, vertex.y);
    return ring;
  }

  std::vector<std::pair<Ring, Ring>> pairs_;
};

const bool added =
    add_peer("boost_geometry", 64, []() -> std::unique_ptr<NativePairs> { return std::make_unique<BoostPairs>(); });

}  // namespace
}  // namespace vesica::bench

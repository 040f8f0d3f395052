// SPDX-License-Identifier: Apache-2.0
/// Boost.Geometry: distance() of two rings, circles and ellipses as 64-gons.
#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/ring.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <utility>

#include "nearest/contestant.hpp"

namespace vesica::bench {
namespace {

using Point = boost::geometry::model::d2::point_xy<double>;
using Ring = boost::geometry::model::ring<Point, false, false>;  // counter-clockwise, not closed

class Rings final : public DistancePairs {
 public:
  Rings(std::int32_t kind_a, std::int32_t kind_b, std::span<const OutlinePair> pairs) {
    for (const OutlinePair& p : pairs) pairs_.emplace_back(ring(kind_a, p.a), ring(kind_b, p.b));
  }
  double distance(std::size_t pair) override {
    return boost::geometry::distance(pairs_[pair].first, pairs_[pair].second);
  }

 private:
  static Ring ring(std::int32_t kind, const Numbers& shape) {
    Ring result;
    for (const PlanePoint& p : outline_of(kind, shape)) result.emplace_back(p.x, p.y);
    return result;
  }

  std::vector<std::pair<Ring, Ring>> pairs_;
};

std::unique_ptr<DistancePairs> make(std::int32_t kind_a, std::int32_t kind_b, std::span<const OutlinePair> pairs) {
  return std::make_unique<Rings>(kind_a, kind_b, pairs);
}

const bool added = add_contestant({"Boost.Geometry, 64-gons", any_kinds, make, 4});

}  // namespace
}  // namespace vesica::bench

// SPDX-License-Identifier: Apache-2.0
/// CGAL: do_intersect of two polygons over the kernel of exact predicates and constructions.
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "peer.hpp"

namespace vesica::bench {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Kernel>;

class CgalPairs final : public NativePairs {
 public:
  void add(const Outline& a, const Outline& b) override { pairs_.emplace_back(polygon(a), polygon(b)); }

  std::int64_t hits(std::span<const std::size_t> indices) override {
    std::int64_t hits = 0;
    for (const std::size_t i : indices) hits += CGAL::do_intersect(pairs_[i].first, pairs_[i].second);
    return hits;
  }

 private:
  static Polygon polygon(const Outline& outline) {
    Polygon polygon;
    for (const Vertex& vertex : outline) polygon.push_back(Kernel::Point_2(vertex.x, vertex.y));
    return polygon;
  }

  std::vector<std::pair<Polygon, Polygon>> pairs_;
};

const bool added = add_peer("cgal", 64, []() -> std::unique_ptr<NativePairs> { return std::make_unique<CgalPairs>(); });

}  // namespace
}  // namespace vesica::bench

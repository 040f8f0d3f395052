// SPDX-License-Identifier: Apache-2.0
/// Box2D 2.4, in float: the contact manifold of two polygons, and its overlap test by GJK. The skin Box2D puts round
/// polygons is set to 0, so that it is asked the same question.
#include <box2d/b2_collision.h>
#include <box2d/b2_polygon_shape.h>

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "peer.hpp"

namespace vesica::bench {
namespace {

const b2Transform identity(b2Vec2(0, 0), b2Rot(0));

bool meet_by_manifold(const b2PolygonShape& a, const b2PolygonShape& b) {
  b2Manifold manifold;
  b2CollidePolygons(&manifold, &a, identity, &b, identity);
  return manifold.pointCount > 0;
}

bool meet_by_gjk(const b2PolygonShape& a, const b2PolygonShape& b) {
  return b2TestOverlap(&a, 0, &b, 0, identity, identity);
}

template <auto meet>
class Box2dPairs final : public NativePairs {
 public:
  void add(const Outline& a, const Outline& b) override { pairs_.emplace_back(polygon(a), polygon(b)); }

  std::int64_t hits(std::span<const std::size_t> indices) override {
    std::int64_t hits = 0;
    for (const std::size_t i : indices) hits += meet(pairs_[i].first, pairs_[i].second);
    return hits;
  }

 private:
  static b2PolygonShape polygon(const Outline& outline) {
    std::vector<b2Vec2> vertices;
    for (const Vertex& vertex : outline)
      vertices.emplace_back(static_cast<float>(vertex.x), static_cast<float>(vertex.y));
    b2PolygonShape shape;
    shape.Set(vertices.data(), static_cast<int32>(vertices.size()));
    shape.m_radius = 0;
    return shape;
  }

  std::vector<std::pair<b2PolygonShape, b2PolygonShape>> pairs_;
};

template <auto meet>
std::unique_ptr<NativePairs> make() {
  return std::make_unique<Box2dPairs<meet>>();
}

const bool added = add_peer("box2d_manifold", b2_maxPolygonVertices, make<meet_by_manifold>) &&
                   add_peer("box2d_gjk", b2_maxPolygonVertices, make<meet_by_gjk>);

}  // namespace
}  // namespace vesica::bench

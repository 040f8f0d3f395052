// SPDX-License-Identifier: Apache-2.0
/// Chipmunk 7, in double: the contact points of two polygon shapes on a body that stays at the origin.
#include <chipmunk/chipmunk.h>

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "peer.hpp"

namespace vesica::bench {
namespace {

struct FreeBody {
  void operator()(cpBody* body) const { cpBodyFree(body); }
};
struct FreeShape {
  void operator()(cpShape* shape) const { cpShapeFree(shape); }
};
using Body = std::unique_ptr<cpBody, FreeBody>;
using Shape = std::unique_ptr<cpShape, FreeShape>;

class ChipmunkPairs final : public NativePairs {
 public:
  void add(const Outline& a, const Outline& b) override { pairs_.emplace_back(polygon(a), polygon(b)); }

  std::int64_t hits(std::span<const std::size_t> indices) override {
    std::int64_t hits = 0;
    for (const std::size_t i : indices) {
      hits += cpShapesCollide(pairs_[i].first.get(), pairs_[i].second.get()).count > 0;
    }
    return hits;
  }

 private:
  Shape polygon(const Outline& outline) const {
    std::vector<cpVect> vertices;
    for (const Vertex& vertex : outline) vertices.push_back(cpv(vertex.x, vertex.y));
    Shape shape(cpPolyShapeNewRaw(body_.get(), static_cast<int>(vertices.size()), vertices.data(), 0));
    cpShapeUpdate(shape.get(), cpTransformIdentity);
    return shape;
  }

  Body body_{cpBodyNewStatic()};
  std::vector<std::pair<Shape, Shape>> pairs_;
};

// Rectangles only: on 64-gons its penetration search exceeds its own limit and prints a warning a call.
const bool added =
    add_peer("chipmunk", 4, []() -> std::unique_ptr<NativePairs> { return std::make_unique<ChipmunkPairs>(); });

}  // namespace
}  // namespace vesica::bench

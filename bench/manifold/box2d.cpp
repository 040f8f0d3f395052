// SPDX-License-Identifier: Apache-2.0
#include "manifold/box2d.hpp"

#include <box2d/b2_collision.h>
#include <box2d/b2_polygon_shape.h>

#include <cmath>
#include <vector>

namespace vesica::bench {
namespace {

struct Body {
  b2PolygonShape shape;
  b2Transform place;

  explicit Body(const vesica_rect_f64& r) {
    shape.SetAsBox(static_cast<float>(r.hx), static_cast<float>(r.hy));
    place.Set({static_cast<float>(r.cx), static_cast<float>(r.cy)},
              std::atan2(static_cast<float>(r.uy), static_cast<float>(r.ux)));
  }
};

}  // namespace

struct Box2dManifolds::Pairs {
  std::vector<Body> a, b;
};

Box2dManifolds::Box2dManifolds() : pairs_(std::make_unique<Pairs>()) {}
Box2dManifolds::~Box2dManifolds() = default;
void Box2dManifolds::clear() {
  pairs_->a.clear();
  pairs_->b.clear();
}
void Box2dManifolds::add(const vesica_rect_f64& a, const vesica_rect_f64& b) {
  pairs_->a.emplace_back(a);
  pairs_->b.emplace_back(b);
}

int Box2dManifolds::ask(std::size_t pair) const {
  const Body &a = pairs_->a[pair], &b = pairs_->b[pair];
  b2Manifold manifold;
  b2CollidePolygons(&manifold, &a.shape, a.place, &b.shape, b.place);
  return manifold.pointCount;
}

}  // namespace vesica::bench

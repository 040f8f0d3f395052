// SPDX-License-Identifier: Apache-2.0
#include <box2d/b2_distance.h>
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_time_of_impact.h>

#include <vector>

#include "cast/peer.hpp"

namespace vesica::bench {
namespace {

b2Vec2 vec(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

b2PolygonShape polygon(const vesica_rect_f64& r) {
  b2PolygonShape shape;
  shape.SetAsBox(static_cast<float>(r.hx), static_cast<float>(r.hy), vec(0, 0),
                 std::atan2(static_cast<float>(r.uy), static_cast<float>(r.ux)));
  return shape;
}

struct Pair {
  b2PolygonShape a, b;
  b2Vec2 centre_a, centre_b, way;
  float angle;
};

}  // namespace

struct Box2dCasts::Pairs {
  std::vector<Pair> pairs;
};

Box2dCasts::Box2dCasts() : pairs_(std::make_unique<Pairs>()) {}
Box2dCasts::~Box2dCasts() = default;
void Box2dCasts::clear() { pairs_->pairs.clear(); }
void Box2dCasts::add(const vesica_rect_f64& a, const vesica_rect_f64& b, double vx, double vy, double angle) {
  pairs_->pairs.push_back(
      {polygon(a), polygon(b), vec(a.cx, a.cy), vec(b.cx, b.cy), vec(vx, vy), static_cast<float>(angle)});
}

bool Box2dCasts::shape_cast(std::size_t pair) const {
  const Pair& p = pairs_->pairs[pair];
  b2ShapeCastInput input;
  input.proxyA.Set(&p.a, 0);
  input.proxyB.Set(&p.b, 0);
  input.transformA.Set(p.centre_a, 0);
  input.transformB.Set(p.centre_b, 0);
  input.translationB = p.way;
  b2ShapeCastOutput output;
  return b2ShapeCast(&output, &input);
}

bool Box2dCasts::time_of_impact(std::size_t pair) const {
  const Pair& p = pairs_->pairs[pair];
  b2TOIInput input;
  input.proxyA.Set(&p.a, 0);
  input.proxyB.Set(&p.b, 0);
  input.sweepA = {b2Vec2(0, 0), p.centre_a, p.centre_a, 0, 0, 0};
  input.sweepB = {b2Vec2(0, 0), p.centre_b, p.centre_b + p.way, 0, p.angle, 0};
  input.tMax = 1;
  b2TOIOutput output;
  b2TimeOfImpact(&output, &input);
  return output.state == b2TOIOutput::e_touching || output.state == b2TOIOutput::e_overlapped;
}

}  // namespace vesica::bench

// SPDX-License-Identifier: Apache-2.0
/// Contacts of pairs that overlap a little, as boxes on one another do, in random directions; beside their depth alone,
/// and beside Box2D's manifolds, which are in float. Each pass has new pairs in the same buffers.
#include <vesica.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include "manifold/box2d.hpp"
#include "quantile.hpp"
#include "random.hpp"

namespace vesica::bench {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t pairs_per_pass = 256;
constexpr int passes = 300;

struct Body {
  vesica_rect_f64 rect;
  vesica_capsule_f64 capsule;
  double x[4], y[4];
  vesica_polygon_f64 quad;
};

void fill(Body& body, const vesica_rect_f64& r) {
  body.rect = r;
  const double ax = r.ux * r.hx, ay = r.uy * r.hx, bx = -r.uy * r.hy, by = r.ux * r.hy;
  for (int i = 0; i < 4; ++i) {
    const double s = i == 1 || i == 2 ? 1 : -1, t = i >= 2 ? 1 : -1;
    body.x[i] = r.cx + s * ax + t * bx;
    body.y[i] = r.cy + s * ay + t * by;
  }
  body.quad = {body.x, body.y, sizeof(double), nullptr, 4};
  body.capsule = {r.cx - ax, r.cy - ay, r.cx + ax, r.cy + ay, r.hy};
}

template <class Call>
double nanoseconds(const Call& call, std::int64_t& sum) {
  const Clock::time_point start = Clock::now();
  for (std::size_t i = 0; i < pairs_per_pass; ++i) sum += call(i);
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / pairs_per_pass;
}

struct Row {
  const char* name;
  std::int32_t kind;
  std::vector<double> depth, manifold, box2d;
};

const void* shape_of(const Row& row, const Body& body) {
  if (row.kind == VESICA_RECT) return &body.rect;
  return row.kind == VESICA_CAPSULE ? static_cast<const void*>(&body.capsule) : &body.quad;
}

void measure(Row& row, const std::vector<Body>& a, const std::vector<Body>& b, const Box2dManifolds* peer,
             std::int64_t& sum) {
  row.depth.push_back(nanoseconds(
      [&](std::size_t i) {
        vesica_penetration_f64 out;
        return vesica_depth_f64(row.kind, shape_of(row, a[i]), row.kind, shape_of(row, b[i]), &out);
      },
      sum));
  row.manifold.push_back(nanoseconds(
      [&](std::size_t i) {
        vesica_contacts_f64 out;
        return vesica_manifold_f64(row.kind, shape_of(row, a[i]), row.kind, shape_of(row, b[i]), &out);
      },
      sum));
#ifdef VESICA_HAS_BOX2D
  if (peer != nullptr) row.box2d.push_back(nanoseconds([&](std::size_t i) { return peer->ask(i); }, sum));
#else
  static_cast<void>(peer);
#endif
}

void run() {
  Row rows[] = {{"rect rect", VESICA_RECT, {}, {}, {}},
                {"quad quad", VESICA_POLYGON, {}, {}, {}},
                {"capsule capsule", VESICA_CAPSULE, {}, {}, {}}};
  std::vector<Body> a(pairs_per_pass), b(pairs_per_pass);
  Random random(1);
  std::int64_t sum = 0;
#ifdef VESICA_HAS_BOX2D
  Box2dManifolds box2d;
#endif
  for (int pass = 0; pass < passes; ++pass) {
#ifdef VESICA_HAS_BOX2D
    box2d.clear();
#endif
    for (std::size_t i = 0; i < pairs_per_pass; ++i) {
      const double angle = random.between(0, 6.28), c = std::cos(angle), s = std::sin(angle),
                   tilt = angle + random.between(-0.01, 0.01), along = random.between(-1.5, 1.5), up = 1.95;
      fill(a[i], {0.5, 0.25, c, s, 1, 1});
      fill(b[i], {0.5 + along * c - up * s, 0.25 + along * s + up * c, std::cos(tilt), std::sin(tilt), 1, 1});
#ifdef VESICA_HAS_BOX2D
      box2d.add(a[i].rect, b[i].rect);
#endif
    }
    for (Row& row : rows) {
      const Box2dManifolds* peer = nullptr;
#ifdef VESICA_HAS_BOX2D
      if (row.kind == VESICA_RECT) peer = &box2d;
#endif
      measure(row, a, b, peer, sum);
    }
  }
  std::printf("%-20s %10s %10s %8s %10s\n", "nanoseconds a pair", "depth", "manifold", "ratio", "Box2D");
  for (const Row& row : rows) {
    const double depth = median(row.depth), manifold = median(row.manifold);
    std::printf("%-20s %10.0f %10.0f %8.2f", row.name, depth, manifold, manifold / depth);
    if (row.box2d.empty()) {
      std::printf(" %10s\n", "");
    } else {
      std::printf(" %10.0f\n", median(row.box2d));
    }
  }
  std::printf("(%lld contacts and more)\n", static_cast<long long>(sum));
}

}  // namespace
}  // namespace vesica::bench

int main() { vesica::bench::run(); }

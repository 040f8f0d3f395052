// SPDX-License-Identifier: Apache-2.0
/// Times of distances of polygons. All contestants of a row meet the same new pairs, and who goes first takes turns.
/// GEOS's geometries, and its prepared ones, are made before the clock starts.
#include <vesica.h>
#include <vesica_boxes.h>
#include <vesica_measures.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "quantile.hpp"
#include "random.hpp"

#if defined(VESICA_HAS_GEOS)
#include <geos_c.h>
#endif

namespace vesica::bench {
namespace {

using Clock = std::chrono::steady_clock;

struct Ring {
  std::vector<double> xy;
  vesica_polygon_f64 view() const {
    return {xy.data(), xy.data() + 1, 16, nullptr, static_cast<std::int64_t>(xy.size() / 2)};
  }
};

/// A ring about a centre, with radii from `least` to 1.
Ring ring(int n, double x, double y, double least, Random& random) {
  Ring r;
  const double start = random.between(0, 6.283185307179586);
  for (int i = 0; i < n; ++i) {
    const double t = start + 6.283185307179586 * i / n, radius = random.between(least, 1);
    r.xy.push_back(x + radius * std::cos(t));
    r.xy.push_back(y + radius * std::sin(t));
  }
  return r;
}

/// beside: about a radius apart. near: a hundredth of one. around: one inside the other's ring, outlines apart.
enum class Data { beside, near, around };
const char* name_of(Data data) { return data == Data::beside ? "beside" : data == Data::near ? "near" : "around"; }

struct Pair {
  Ring a, b;
  vesica_ellipse_f64 ellipse;  // in the place of b
#if defined(VESICA_HAS_GEOS)
  GEOSGeometry *geos_a, *geos_b;
  const GEOSPreparedGeometry* prepared;
#endif
};

#if defined(VESICA_HAS_GEOS)
GEOSContextHandle_t geos() {
  static const GEOSContextHandle_t context = GEOS_init_r();
  return context;
}
/// A polygon or its outline.
GEOSGeometry* made(const Ring& r, bool outline) {
  const auto n = static_cast<unsigned>(r.xy.size() / 2);
  GEOSCoordSequence* s = GEOSCoordSeq_create_r(geos(), n + 1, 2);
  for (unsigned i = 0; i <= n; ++i) GEOSCoordSeq_setXY_r(geos(), s, i, r.xy[2 * (i % n)], r.xy[2 * (i % n) + 1]);
  GEOSGeometry* line = GEOSGeom_createLinearRing_r(geos(), s);
  return outline ? line : GEOSGeom_createPolygon_r(geos(), line, nullptr, 0);
}
#endif

Pair draw(int n, double least, Data data, Random& random) {
  const double turn = random.between(0, 6.283185307179586), far = data == Data::beside ? 3 : 2.01;
  const double x = far * std::cos(turn), y = far * std::sin(turn);
  Pair p;
  p.a = ring(n, 0, 0, least, random);
  p.b = data == Data::around ? ring(n, 0, 0, least, random) : ring(n, x, y, least, random);
  if (data == Data::around) {
    for (double& c : p.b.xy) c *= 0.9 * least * std::cos(3.14159 / std::max(n, 8));
  }
  p.ellipse = {x, y, std::cos(3 * turn), std::sin(3 * turn), 0.9, 0.45};
#if defined(VESICA_HAS_GEOS)
  p.geos_a = made(p.a, data == Data::around);
  p.geos_b = made(p.b, data == Data::around);
  p.prepared = GEOSPrepare_r(geos(), p.geos_a);
#endif
  return p;
}
void release([[maybe_unused]] Pair& p) {
#if defined(VESICA_HAS_GEOS)
  GEOSPreparedGeom_destroy_r(geos(), p.prepared);
  GEOSGeom_destroy_r(geos(), p.geos_a);
  GEOSGeom_destroy_r(geos(), p.geos_b);
#endif
}

struct Contestant {
  std::string name;
  std::function<double(const Pair&)> ask;
};

double distance(const Pair& p) {
  const auto a = p.a.view(), b = p.b.view();
  vesica_closest_points_f64 c{};
  vesica_boundary_distance_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &b, &c);
  return c.distance;
}
double of_ellipse(const Pair& p) {
  const auto a = p.a.view();
  vesica_closest_points_f64 c{};
  vesica_nearest_f64(VESICA_POLYGON, &a, VESICA_ELLIPSE, &p.ellipse, &c);
  return c.distance;
}
double within(const Pair& p) {
  const auto a = p.a.view(), b = p.b.view();
  return vesica_within_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &b, 1);
}
/// The pass over the vertices of both.
double bounds(const Pair& p) {
  const auto a = p.a.view(), b = p.b.view();
  vesica_aabb_f64 box_a{}, box_b{};
  vesica_bounds_f64(VESICA_POLYGON, &a, &box_a);
  vesica_bounds_f64(VESICA_POLYGON, &b, &box_b);
  return box_a.min_x + box_b.min_x;
}
/// Vertices against edges, in plain arithmetic.
double from_vertices(const Ring& a, const Ring& b) {
  double least = 1e300;
  const std::size_t n = b.xy.size() / 2;
  for (std::size_t i = 0; i < a.xy.size(); i += 2) {
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t next = k + 1 == n ? 0 : k + 1;
      const double x = b.xy[2 * k], y = b.xy[2 * k + 1], vx = b.xy[2 * next] - x, vy = b.xy[2 * next + 1] - y;
      const double wx = a.xy[i] - x, wy = a.xy[i + 1] - y;
      const double t = std::min(1.0, std::max(0.0, (vx * wx + vy * wy) / (vx * vx + vy * vy)));
      const double dx = wx - t * vx, dy = wy - t * vy;
      least = std::min(least, dx * dx + dy * dy);
    }
  }
  return std::sqrt(least);
}
double all_pairs(const Pair& p) { return std::min(from_vertices(p.a, p.b), from_vertices(p.b, p.a)); }

void row(int n, double least, Data data) {
  std::vector<Contestant> all{{"vesica", distance}, {"bounds", bounds}, {"within", within}};
  if (data != Data::around) all.push_back({"ellipse", of_ellipse});
  const bool quadratic = n <= 1024;
  if (quadratic) all.push_back({"all pairs", all_pairs});
#if defined(VESICA_HAS_GEOS)
  if (quadratic) {
    all.push_back({"GEOS", [](const Pair& p) {
                     double d = 0;
                     GEOSDistance_r(geos(), p.geos_a, p.geos_b, &d);
                     return d;
                   }});
  }
  all.push_back({"GEOS indexed", [](const Pair& p) {
                   double d = 0;
                   GEOSDistanceIndexed_r(geos(), p.geos_a, p.geos_b, &d);
                   return d;
                 }});
  all.push_back({"GEOS prepared", [](const Pair& p) {
                   double d = 0;
                   GEOSPreparedDistance_r(geos(), p.prepared, p.geos_b, &d);
                   return d;
                 }});
#endif
  Random random(5);
  const int passes = 15, pairs = std::max(1, 512 / n);
  std::vector<std::vector<double>> times(all.size());
  double worst = 0, sum = 0;
  for (int pass = 0; pass < passes; ++pass) {
    std::vector<Pair> drawn;
    for (int i = 0; i < pairs; ++i) drawn.push_back(draw(n, least, data, random));
#if defined(VESICA_HAS_GEOS)
    for (const Pair& p : drawn) sum += all.back().ask(p);  // the index of a prepared geometry is made by its first call
#endif
    for (std::size_t k = 0; k < all.size(); ++k) {
      const std::size_t which = (k + static_cast<std::size_t>(pass)) % all.size();
      const auto begin = Clock::now();
      for (const Pair& p : drawn) sum += all[which].ask(p);
      const std::chrono::duration<double, std::nano> took = Clock::now() - begin;
      times[which].push_back(took.count() / pairs);
    }
    if (quadratic) {
      for (const Pair& p : drawn) worst = std::max(worst, std::fabs(distance(p) - all_pairs(p)));
    }
    for (Pair& p : drawn) release(p);
  }
  std::printf("%5d  %-6s  %3.1f ", n, name_of(data), least);
  for (std::size_t k = 0; k < all.size(); ++k) {
    std::printf("  %s %.0f ns", all[k].name.c_str(), *std::min_element(times[k].begin(), times[k].end()));
  }
  if (quadratic) std::printf("  (off by %.1g)", worst);
  std::printf("%s\n", sum == 1 ? " " : "");
}

}  // namespace

void report() {
  std::printf(
      "Distance of outlines of two polygons of n vertices, ns a pair, least of 15; radii from the number to 1\n");
  for (const double least : {0.5, 0.99}) {
    for (const Data data : {Data::beside, Data::near, Data::around}) {
      for (const int n : {4, 16, 64, 256, 1024, 4096}) row(n, least, data);
    }
  }
}

}  // namespace vesica::bench

int main() { vesica::bench::report(); }

// SPDX-License-Identifier: Apache-2.0
/// Times of overlap of two triangles or quadrilaterals: calls, arrays in step and matrices, beside GEOS, Boost and
/// Box2D, which have their geometries made before the clock starts. New pairs in each pass; who goes first takes turns.
/// Wrong answers of each, against the edges' exact ones.
#include <vesica.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>
#include <vesica/polygon/overlap.hpp>

#include "random.hpp"

#if defined(VESICA_HAS_BOOST)
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#endif
#if defined(VESICA_HAS_GEOS)
#include <geos_c.h>
#endif
#if defined(VESICA_HAS_BOX2D)
#include <box2d/b2_collision.h>
#include <box2d/b2_polygon_shape.h>
#endif

namespace vesica::bench {
namespace {

using Clock = std::chrono::steady_clock;
namespace path = vesica::detail::polygon;

constexpr std::size_t count = 4096;

/// Pairs of rings of n vertices, x y x y ..., of numbers that float has too.
struct Pairs {
  int n;
  std::vector<double> a, b;
  std::vector<float> float_a, float_b;

  std::size_t place(std::size_t i) const { return 2 * i * static_cast<std::size_t>(n); }
};

vesica_polygon_f64 view(const double* xy, int n) { return {xy, xy + 1, 2 * sizeof(double), nullptr, n}; }
vesica_polygon_f32 view(const float* xy, int n) { return {xy, xy + 1, 2 * sizeof(float), nullptr, n}; }

/// Without the filter.
bool by_edges(const double* a, const double* b, int n) {
  return path::overlap_or_error(path::Edges<double>(Polygon<double>{a, a + 1, 16, nullptr, n}),
                                path::Edges<double>(Polygon<double>{b, b + 1, 16, nullptr, n})) == 1;
}

/// Convex: n vertices of an ellipse.
void draw(double* xy, int n, double x, double y, Random& random) {
  const double start = random.between(0, 6.283185307179586), turn = random.between(0, 6.283185307179586);
  const double p = random.between(0.4, 1), q = random.between(0.4, 1);
  for (int i = 0; i < n; ++i) {
    const double t = start + 6.283185307179586 * (i + random.between(0, 0.6)) / n;
    const double along = p * std::cos(t), across = q * std::sin(t);
    xy[2 * i] = static_cast<float>(x + along * std::cos(turn) - across * std::sin(turn));
    xy[2 * i + 1] = static_cast<float>(y + along * std::sin(turn) + across * std::cos(turn));
  }
}

Pairs draw(int n, int percent, Random& random) {
  Pairs pairs{n, {}, {}, {}, {}};
  const auto size = count * 2 * static_cast<std::size_t>(n);
  pairs.a.resize(size);
  pairs.b.resize(size);
  for (std::size_t i = 0; i < count; ++i) {
    const bool wanted = random.between(0, 100) < percent;
    const double near = wanted ? 1.6 : 3, x = random.between(0, 10), y = random.between(0, 10);
    double *const a = &pairs.a[pairs.place(i)], *const b = &pairs.b[pairs.place(i)];
    do {
      draw(a, n, x, y, random);
      draw(b, n, x + random.between(-near, near), y + random.between(-near, near), random);
    } while (by_edges(a, b, n) != wanted);
  }
  pairs.float_a.assign(pairs.a.begin(), pairs.a.end());
  pairs.float_b.assign(pairs.b.begin(), pairs.b.end());
  return pairs;
}

/// Answers all pairs.
using Bytes = std::vector<std::uint8_t>;
struct Contestant {
  std::string name;
  std::function<void(const Pairs&)> prepare;  // before the clock starts
  std::function<void(const Pairs&, Bytes&)> ask;
};

template <class Ask>
void each(const Pairs& pairs, Bytes& out, Ask ask) {
  for (std::size_t i = 0; i < count; ++i) out[i] = static_cast<std::uint8_t>(ask(pairs.place(i)));
}

template <class T>
auto array(const std::vector<T>& xy, int n) {
  std::conditional_t<std::is_same_v<T, float>, vesica_shapes_f32, vesica_shapes_f64> s{};
  s.kind = VESICA_POLYGON;
  s.count = count;
  s.stride = 2 * sizeof(T);
  s.field[0] = xy.data();
  s.field[1] = xy.data() + 1;
  s.each = n;
  return s;
}

void add_ours(std::vector<Contestant>& all) {
  all.push_back({"edges alone", {}, [](const Pairs& p, Bytes& out) {
                   each(p, out, [&](std::size_t k) { return by_edges(&p.a[k], &p.b[k], p.n); });
                 }});
  all.push_back({"call f64", {}, [](const Pairs& p, Bytes& out) {
                   each(p, out, [&](std::size_t k) {
                     const auto a = view(&p.a[k], p.n), b = view(&p.b[k], p.n);
                     return vesica_overlap_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &b);
                   });
                 }});
  all.push_back({"call f32", {}, [](const Pairs& p, Bytes& out) {
                   each(p, out, [&](std::size_t k) {
                     const auto a = view(&p.float_a[k], p.n), b = view(&p.float_b[k], p.n);
                     return vesica_overlap_f32(VESICA_POLYGON, &a, VESICA_POLYGON, &b);
                   });
                 }});
  all.push_back({"many f64", {}, [](const Pairs& p, Bytes& out) {
                   const auto a = array(p.a, p.n), b = array(p.b, p.n);
                   vesica_overlap_many_f64(&a, &b, out.data());
                 }});
  all.push_back({"many f32", {}, [](const Pairs& p, Bytes& out) {
                   const auto a = array(p.float_a, p.n), b = array(p.float_b, p.n);
                   vesica_overlap_many_f32(&a, &b, out.data());
                 }});
}

/// 64 by all the others, whose hits are few: not compared.
double matrix_time(const Pairs& pairs, bool is_float) {
  static std::vector<std::uint8_t> out(64 * count);
  const auto begin = Clock::now();
  if (is_float) {
    auto a = array(pairs.float_a, pairs.n);
    const auto b = array(pairs.float_b, pairs.n);
    a.count = 64;
    vesica_overlap_matrix_f32(&a, &b, out.data(), count);
  } else {
    auto a = array(pairs.a, pairs.n);
    const auto b = array(pairs.b, pairs.n);
    a.count = 64;
    vesica_overlap_matrix_f64(&a, &b, out.data(), count);
  }
  const std::chrono::duration<double, std::nano> took = Clock::now() - begin;
  return took.count() / (64.0 * count);
}

#if defined(VESICA_HAS_GEOS)
struct Geos {
  GEOSContextHandle_t context = GEOS_init_r();
  std::vector<GEOSGeometry*> a, b;
  std::vector<const GEOSPreparedGeometry*> prepared;

  GEOSGeometry* made(const double* xy, int n) const {
    GEOSCoordSequence* const s = GEOSCoordSeq_create_r(context, static_cast<unsigned>(n) + 1, 2);
    for (int i = 0; i <= n; ++i) {
      GEOSCoordSeq_setXY_r(context, s, static_cast<unsigned>(i), xy[2 * (i % n)], xy[2 * (i % n) + 1]);
    }
    return GEOSGeom_createPolygon_r(context, GEOSGeom_createLinearRing_r(context, s), nullptr, 0);
  }
  void prepare(const Pairs& p) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      GEOSPreparedGeom_destroy_r(context, prepared[i]);
      GEOSGeom_destroy_r(context, a[i]);
      GEOSGeom_destroy_r(context, b[i]);
    }
    a.clear();
    b.clear();
    prepared.clear();
    for (std::size_t i = 0; i < count; ++i) {
      a.push_back(made(&p.a[p.place(i)], p.n));
      b.push_back(made(&p.b[p.place(i)], p.n));
      prepared.push_back(GEOSPrepare_r(context, a.back()));
      GEOSPreparedIntersects_r(context, prepared.back(), b.back());  // makes the index
    }
  }
};
#endif

#if defined(VESICA_HAS_BOOST)
namespace bg = boost::geometry;
using BoostPolygon = bg::model::polygon<bg::model::d2::point_xy<double>, false>;
BoostPolygon in_boost(const double* xy, int n) {
  BoostPolygon polygon;
  for (int i = 0; i <= n; ++i) polygon.outer().emplace_back(xy[2 * (i % n)], xy[2 * (i % n) + 1]);
  return polygon;
}
#endif

void add_peers([[maybe_unused]] std::vector<Contestant>& all) {
#if defined(VESICA_HAS_BOX2D)
  static std::vector<b2PolygonShape> first, second;
  static const b2Transform identity(b2Vec2(0, 0), b2Rot(0));
  const auto made = [](const float* xy, int n) {
    b2Vec2 vertices[4];
    for (int i = 0; i < n; ++i) vertices[i] = b2Vec2(xy[2 * i], xy[2 * i + 1]);
    b2PolygonShape shape;
    shape.Set(vertices, n);
    shape.m_radius = 0;
    return shape;
  };
  all.push_back({"Box2D manifold",
                 [made](const Pairs& p) {
                   first.clear();
                   second.clear();
                   for (std::size_t i = 0; i < count; ++i) {
                     first.push_back(made(&p.float_a[p.place(i)], p.n));
                     second.push_back(made(&p.float_b[p.place(i)], p.n));
                   }
                 },
                 [](const Pairs&, Bytes& out) {
                   for (std::size_t i = 0; i < count; ++i) {
                     b2Manifold manifold;
                     b2CollidePolygons(&manifold, &first[i], identity, &second[i], identity);
                     out[i] = manifold.pointCount > 0;
                   }
                 }});
  all.push_back({"Box2D GJK", {}, [](const Pairs&, Bytes& out) {
                   for (std::size_t i = 0; i < count; ++i)
                     out[i] = b2TestOverlap(&first[i], 0, &second[i], 0, identity, identity);
                 }});
#endif
#if defined(VESICA_HAS_BOOST)
  static std::vector<BoostPolygon> boost_a, boost_b;
  all.push_back({"Boost",
                 [](const Pairs& p) {
                   boost_a.clear();
                   boost_b.clear();
                   for (std::size_t i = 0; i < count; ++i) {
                     boost_a.push_back(in_boost(&p.a[p.place(i)], p.n));
                     boost_b.push_back(in_boost(&p.b[p.place(i)], p.n));
                   }
                 },
                 [](const Pairs&, Bytes& out) {
                   for (std::size_t i = 0; i < count; ++i) out[i] = bg::intersects(boost_a[i], boost_b[i]);
                 }});
#endif
#if defined(VESICA_HAS_GEOS)
  static Geos geos;
  all.push_back({"GEOS prepared", [](const Pairs& p) { geos.prepare(p); },
                 [](const Pairs&, Bytes& out) {
                   for (std::size_t i = 0; i < count; ++i) {
                     out[i] =
                         static_cast<std::uint8_t>(GEOSPreparedIntersects_r(geos.context, geos.prepared[i], geos.b[i]));
                   }
                 }});
  all.push_back({"GEOS", {}, [](const Pairs&, Bytes& out) {
                   for (std::size_t i = 0; i < count; ++i)
                     out[i] = static_cast<std::uint8_t>(GEOSIntersects_r(geos.context, geos.a[i], geos.b[i]));
                 }});
#endif
}

void row(int n, int percent) {
  std::vector<Contestant> all;
  add_ours(all);
  add_peers(all);
  Random random(13);
  std::vector<double> least(all.size(), 1e300);
  std::vector<std::size_t> wrong(all.size());
  double least_matrix[2] = {1e300, 1e300};
  Bytes truth(count), out(count);
  for (std::size_t pass = 0; pass < 15; ++pass) {
    const Pairs pairs = draw(n, percent, random);
    all[0].ask(pairs, truth);
    for (const Contestant& c : all) {
      if (c.prepare) c.prepare(pairs);
    }
    for (std::size_t k = 0; k < all.size(); ++k) {
      const std::size_t which = (k + pass) % all.size();
      const auto begin = Clock::now();
      all[which].ask(pairs, out);
      const std::chrono::duration<double, std::nano> took = Clock::now() - begin;
      least[which] = std::min(least[which], took.count() / count);
      for (std::size_t i = 0; i < count; ++i) wrong[which] += out[i] != truth[i];
    }
    for (const bool is_float : {false, true}) {
      double& best = least_matrix[is_float ? 1 : 0];
      best = std::min(best, matrix_time(pairs, is_float));
    }
  }
  std::printf("%d vertices, %3d %% overlap:", n, percent);
  for (std::size_t k = 0; k < all.size(); ++k) {
    std::printf("  %s %.1f", all[k].name.c_str(), least[k]);
    if (wrong[k] != 0) std::printf(" (%zu wrong)", wrong[k]);
  }
  std::printf("  matrix f64 %.2f  matrix f32 %.2f\n", least_matrix[0], least_matrix[1]);
}

}  // namespace
}  // namespace vesica::bench

int main() {
  std::printf("Overlap of two convex polygons, ns a pair, least of 15; arrays by %s\n", vesica_isa_name());
  for (const int n : {3, 4}) {
    for (const int percent : {0, 10, 50, 100}) vesica::bench::row(n, percent);
  }
}

// SPDX-License-Identifier: Apache-2.0
/// Times of the areas that two polygons share, beside the overlays of Boost and GEOS, and how far apart the areas are;
/// and of overlap and relation for the same pairs. Then of arrays.
/// New pairs in each pass; who goes first takes turns. `near` is the distance of the centres at most, of polygons of
/// radius 1: it decides how many pairs share an area.
#include <vesica.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "quantile.hpp"
#include "random.hpp"

#if defined(VESICA_HAS_BOOST)
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#endif
#if defined(VESICA_HAS_GEOS)
#include <geos_c.h>
#endif

namespace vesica::bench {
namespace {

using Clock = std::chrono::steady_clock;
using Ring = std::vector<double>;

struct Pair {
  Ring a, b;
};

/// Vertices at ascending angles; convex at radius 1, a star at radii from 0.3 on.
Ring draw(int n, bool convex, double near, Random& random) {
  const double cx = random.between(-near, near), cy = random.between(-near, near);
  std::vector<double> angles;
  const double turn = random.between(0, 1);
  // Gaps of less than half a turn: else edges might cross.
  for (int i = 0; i < n; ++i) angles.push_back(6.283185307179586 * (i + turn + random.between(0, 0.9)) / n);
  Ring ring;
  for (const double angle : angles) {
    const double r = convex ? 1 : random.between(0.3, 1);
    ring.push_back(cx + r * std::cos(angle));
    ring.push_back(cy + r * std::sin(angle));
  }
  return ring;
}

vesica_polygon_f64 view(const Ring& ring) {
  return {ring.data(), ring.data() + 1, 2 * sizeof(double), nullptr, static_cast<std::int64_t>(ring.size() / 2)};
}
double area_of_vesica(const Pair& p) {
  const vesica_polygon_f64 a = view(p.a), b = view(p.b);
  double area = 0;
  vesica_area_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &b, &area);
  return area;
}
double iou_of_vesica(const Pair& p) {
  const vesica_polygon_f64 a = view(p.a), b = view(p.b);
  double iou = 0;
  vesica_iou_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &b, &iou);
  return iou;
}

double overlap_of_vesica(const Pair& p) {
  const vesica_polygon_f64 a = view(p.a), b = view(p.b);
  return vesica_overlap_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &b);
}
double relation_of_vesica(const Pair& p) {
  const vesica_polygon_f64 a = view(p.a), b = view(p.b);
  return vesica_relation_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &b);
}

#if defined(VESICA_HAS_BOOST)
namespace bg = boost::geometry;
using BoostPolygon = bg::model::polygon<bg::model::d2::point_xy<double>, false>;
BoostPolygon in_boost(const Ring& ring) {
  BoostPolygon polygon;
  for (std::size_t i = 0; i <= ring.size(); i += 2) {
    polygon.outer().emplace_back(ring[i % ring.size()], ring[i % ring.size() + 1]);
  }
  return polygon;
}
double area_of_boost(const Pair& p) {
  std::vector<BoostPolygon> shared;
  bg::intersection(in_boost(p.a), in_boost(p.b), shared);
  double area = 0;
  for (const BoostPolygon& polygon : shared) area += bg::area(polygon);
  return area;
}
#endif

#if defined(VESICA_HAS_GEOS)
GEOSContextHandle_t geos() {
  static const GEOSContextHandle_t handle = GEOS_init_r();
  return handle;
}
GEOSGeometry* in_geos(const Ring& ring) {
  const auto n = static_cast<unsigned>(ring.size() / 2);
  GEOSCoordSequence* const sequence = GEOSCoordSeq_create_r(geos(), n + 1, 2);
  for (unsigned i = 0; i <= n; ++i) GEOSCoordSeq_setXY_r(geos(), sequence, i, ring[2 * (i % n)], ring[2 * (i % n) + 1]);
  return GEOSGeom_createPolygon_r(geos(), GEOSGeom_createLinearRing_r(geos(), sequence), nullptr, 0);
}
double area_of_geos(const Pair& p) {
  GEOSGeometry *const a = in_geos(p.a), *const b = in_geos(p.b), *const shared = GEOSIntersection_r(geos(), a, b);
  double area = 0;
  if (shared != nullptr) GEOSArea_r(geos(), shared, &area);
  for (GEOSGeometry* g : {a, b, shared}) GEOSGeom_destroy_r(geos(), g);
  return area;
}
#endif

struct Contestant {
  const char* name;
  double (*ask)(const Pair&);
  bool compare;  // its area with ours
};

void row(int n, bool convex, double near) {
  std::vector<Contestant> all{{"overlap", overlap_of_vesica, false},
                              {"relation", relation_of_vesica, false},
                              {"area", area_of_vesica, false},
                              {"iou", iou_of_vesica, false}};
#if defined(VESICA_HAS_BOOST)
  all.push_back({"Boost", area_of_boost, true});
#endif
#if defined(VESICA_HAS_GEOS)
  all.push_back({"GEOS", area_of_geos, true});
#endif
  Random random(7);
  const std::size_t pairs_per_pass = n <= 16 ? 256 : n <= 256 ? 16 : 2;
  std::vector<std::vector<double>> times(all.size());
  std::vector<double> differs(all.size());
  std::size_t positive = 0, drawn = 0;
  std::vector<double> areas(pairs_per_pass), others(pairs_per_pass);
  for (int pass = 0; pass < 40; ++pass) {
    std::vector<Pair> pairs(pairs_per_pass);
    for (Pair& p : pairs) p = {draw(n, convex, near, random), draw(n, convex, near, random)};
    for (std::size_t i = 0; i < pairs_per_pass; ++i) positive += (areas[i] = area_of_vesica(pairs[i])) > 0;
    drawn += pairs_per_pass;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const std::size_t which = (k + static_cast<std::size_t>(pass)) % all.size();
      const auto begin = Clock::now();
      for (std::size_t i = 0; i < pairs_per_pass; ++i) others[i] = all[which].ask(pairs[i]);
      const std::chrono::duration<double, std::nano> took = Clock::now() - begin;
      times[which].push_back(took.count() / static_cast<double>(pairs_per_pass));
      for (std::size_t i = 0; i < pairs_per_pass && all[which].compare; ++i)
        differs[which] = std::max(differs[which], std::fabs(others[i] - areas[i]));
    }
  }
  std::printf("%4d vertices, %s, %3.0f %% share an area:", n, convex ? "convex" : "stars ",
              100.0 * static_cast<double>(positive) / static_cast<double>(drawn));
  for (std::size_t k = 0; k < all.size(); ++k) {
    std::printf("  %s %.0f ns", all[k].name, median(times[k]));
    if (all[k].compare) std::printf(" (differs by %.1e)", differs[k]);
  }
  std::printf("\n");
}

template <class T>
struct Arrays;
template <>
struct Arrays<double> {
  using Shapes = vesica_shapes_f64;
  static constexpr auto iou_matrix = vesica_iou_matrix_f64;
  using Polygon = vesica_polygon_f64;
  static constexpr auto iou_many = vesica_iou_many_f64;
  static constexpr auto iou = vesica_iou_f64;
};
template <>
struct Arrays<float> {
  using Shapes = vesica_shapes_f32;
  static constexpr auto iou_matrix = vesica_iou_matrix_f32;
  using Polygon = vesica_polygon_f32;
  static constexpr auto iou_many = vesica_iou_many_f32;
  static constexpr auto iou = vesica_iou_f32;
};

template <class T>
typename Arrays<T>::Shapes shapes(const std::vector<T>& xy, int n, std::size_t count) {
  typename Arrays<T>::Shapes s{};
  s.kind = VESICA_POLYGON;
  s.field[0] = xy.data();
  s.field[1] = xy.data() + 1;
  s.stride = 2 * sizeof(T);
  s.each = n;
  s.count = static_cast<std::int64_t>(count);
  return s;
}

/// IoU of arrays of polygons of radius 1 in a square of side 2 `near`, a pair: all pairs, pairs in step, and by a call
/// for each of the latter.
template <class T>
void arrays_row(int n, double near) {
  constexpr std::size_t count = 256;
  Random random(8);
  std::vector<double> matrix_times, step_times, call_times;
  std::vector<T> out(count * count);
  std::int64_t positive = 0, drawn = 0;
  for (int pass = 0; pass < 20; ++pass) {
    std::vector<T> a, b;
    for (std::size_t i = 0; i < count; ++i) {
      for (const double z : draw(n, true, near, random)) a.push_back(static_cast<T>(z));
      for (const double z : draw(n, true, near, random)) b.push_back(static_cast<T>(z));
    }
    const auto first = shapes(a, n, count), second = shapes(b, n, count);
    auto begin = Clock::now();
    positive += Arrays<T>::iou_matrix(&first, &second, out.data(), count);
    const std::chrono::duration<double, std::nano> of_matrix = Clock::now() - begin;
    begin = Clock::now();
    Arrays<T>::iou_many(&first, &second, out.data());
    const std::chrono::duration<double, std::nano> of_step = Clock::now() - begin;
    begin = Clock::now();
    for (std::size_t i = 0; i < count; ++i) {
      const T *const p = &a[2 * i * static_cast<std::size_t>(n)], *const q = &b[2 * i * static_cast<std::size_t>(n)];
      const typename Arrays<T>::Polygon one{p, p + 1, 2 * sizeof(T), nullptr, n},
          other{q, q + 1, 2 * sizeof(T), nullptr, n};
      Arrays<T>::iou(VESICA_POLYGON, &one, VESICA_POLYGON, &other, &out[i]);
    }
    const std::chrono::duration<double, std::nano> of_calls = Clock::now() - begin;
    drawn += static_cast<std::int64_t>(count * count);
    matrix_times.push_back(of_matrix.count() / static_cast<double>(count * count));
    step_times.push_back(of_step.count() / static_cast<double>(count));
    call_times.push_back(of_calls.count() / static_cast<double>(count));
  }
  std::printf(
      "%4d vertices, %s, %5.1f %% share an area:  iou matrix %.1f ns a pair, in step %.0f ns, by calls %.0f ns\n", n,
      sizeof(T) == 8 ? "double" : "float ", 100.0 * static_cast<double>(positive) / static_cast<double>(drawn),
      median(matrix_times), median(step_times), median(call_times));
}

}  // namespace
}  // namespace vesica::bench

int main() {
  for (const double near : {0.3, 1.0, 3.0, 10.0, 30.0}) vesica::bench::arrays_row<double>(4, near);
  for (const double near : {0.3, 1.0, 3.0, 10.0, 30.0}) vesica::bench::arrays_row<float>(4, near);
  for (const int n : {3, 6, 8}) vesica::bench::arrays_row<double>(n, 3);
  for (const double near : {0.3, 1.0, 3.0}) vesica::bench::row(4, true, near);
  for (const int n : {8, 16, 64, 256, 1024}) vesica::bench::row(n, true, 0.7);
  for (const int n : {8, 16, 64, 256, 1024}) vesica::bench::row(n, false, 0.7);
}

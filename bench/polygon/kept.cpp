// SPDX-License-Identifier: Apache-2.0
/// Times of many questions about one large polygon: single calls, calls with kept boxes, one call on an array, and
/// GEOS's prepared geometry. And the join of zones with boxes, beside the join of their bounds alone. Points are new in
/// each pass, who goes first takes turns, and the least of the passes counts.
#include <vesica.h>
#include <vesica_index.h>
#include <vesica_measures.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "random.hpp"

#if defined(VESICA_HAS_GEOS)
#include <geos_c.h>
#endif

namespace vesica::bench {
namespace {

using Clock = std::chrono::steady_clock;

double nanoseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::nano>(Clock::now() - begin).count();
}

/// A coast: its radius is a random walk between 0.5 and 1.
std::vector<double> coast(int n, double x, double y, double size, Random& random) {
  std::vector<double> xy;
  double radius = 0.75;
  for (int i = 0; i < n; ++i) {
    const double t = 6.283185307179586 * i / n;
    radius = std::min(1.0, std::max(0.5, radius + 0.02 * random.between(-1, 1)));
    xy.push_back(x + size * radius * std::cos(t));
    xy.push_back(y + size * radius * std::sin(t));
  }
  return xy;
}
vesica_polygon_f64 view(const std::vector<double>& xy) {
  return {xy.data(), xy.data() + 1, 16, nullptr, static_cast<std::int64_t>(xy.size() / 2)};
}

struct Question {
  std::string name;
  int points;  // of the pass
  std::function<double(const std::vector<vesica_point_f64>&, int)> ask;
};

void row(const char* what, const std::vector<Question>& questions) {
  constexpr int passes = 9, most = 4096;
  Random random(11);
  std::vector<double> least(questions.size(), 1e300);
  double sum = 0;
  for (int pass = 0; pass < passes; ++pass) {
    std::vector<vesica_point_f64> points;
    for (int i = 0; i < most; ++i) points.push_back({random.between(-1, 1), random.between(-1, 1)});
    for (std::size_t k = 0; k < questions.size(); ++k) {
      const Question& question = questions[(k + static_cast<std::size_t>(pass)) % questions.size()];
      const auto begin = Clock::now();
      sum += question.ask(points, question.points);
      double& best = least[(k + static_cast<std::size_t>(pass)) % questions.size()];
      best = std::min(best, nanoseconds_since(begin) / question.points);
    }
  }
  std::printf("%s", what);
  for (std::size_t k = 0; k < questions.size(); ++k) std::printf("  %s %.0f", questions[k].name.c_str(), least[k]);
  std::printf("%s\n", sum == 1 ? " " : "");
}

void one_polygon(int n) {
  Random random(3);
  const std::vector<double> xy = coast(n, 0, 0, 1, random);
  const vesica_polygon_f64 path = view(xy);
  const std::int64_t size = vesica_polygon_boxes_size(n);
  std::vector<std::int64_t> memory(static_cast<std::size_t>(size + 7) / 8);
  void* const boxes = memory.data();
  double made = 1e300;
  for (int pass = 0; pass < 9; ++pass) {
    const auto begin = Clock::now();
    vesica_polygon_boxes_f64(VESICA_POLYGON, &path, boxes, size);
    made = std::min(made, nanoseconds_since(begin) / n);
  }
  std::printf("%d vertices: boxes made in %.2f ns a vertex, %.1f kB of them\n", n, made,
              static_cast<double>(size) / 1e3);
  const int few = std::clamp(400000 / n, 4, 4096), many = 4096;
  using Points = std::vector<vesica_point_f64>;
  std::vector<Question> inside{
      {"a call", few,
       [&](const Points& p, int count) {
         double s = 0;
         for (int i = 0; i < count; ++i)
           s += vesica_overlap_f64(VESICA_POLYGON, &path, VESICA_POINT, &p[static_cast<std::size_t>(i)]);
         return s;
       }},
      {"kept boxes", many,
       [&](const Points& p, int count) {
         double s = 0;
         for (int i = 0; i < count; ++i) {
           s += vesica_polygon_boxes_overlap_f64(VESICA_POLYGON, &path, boxes, size, VESICA_POINT,
                                                 &p[static_cast<std::size_t>(i)]);
         }
         return s;
       }},
      {"an array", many, [&](const Points& p, int count) {
         vesica_shapes_f64 one, all;
         vesica_shapes_from_records_f64(VESICA_POLYGON, 1, &path, sizeof path, &one);
         vesica_shapes_from_records_f64(VESICA_POINT, count, p.data(), sizeof p[0], &all);
         std::vector<std::uint8_t> out(static_cast<std::size_t>(count));
         return static_cast<double>(vesica_overlap_many_f64(&one, &all, out.data()));
       }}};
  std::vector<Question> distance{
      {"a call", few,
       [&](const Points& p, int count) {
         double s = 0;
         for (int i = 0; i < count; ++i) {
           vesica_closest_points_f64 c{};
           vesica_nearest_f64(VESICA_POLYLINE, &path, VESICA_POINT, &p[static_cast<std::size_t>(i)], &c);
           s += c.distance;
         }
         return s;
       }},
      {"an array", many, [&](const Points& p, int count) {
         vesica_shapes_f64 one, all;
         vesica_shapes_from_records_f64(VESICA_POLYLINE, 1, &path, sizeof path, &one);
         vesica_shapes_from_records_f64(VESICA_POINT, count, p.data(), sizeof p[0], &all);
         std::vector<double> out(static_cast<std::size_t>(count));
         return static_cast<double>(
             vesica_nearest_many_f64(&one, &all, out.data(), nullptr, nullptr, nullptr, nullptr));
       }}};
#if defined(VESICA_HAS_GEOS)
  const GEOSContextHandle_t geos = GEOS_init_r();
  GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(geos, static_cast<unsigned>(n) + 1, 2);
  for (int i = 0; i <= n; ++i) {
    const auto at = 2 * static_cast<std::size_t>(i % n);
    GEOSCoordSeq_setXY_r(geos, sequence, static_cast<unsigned>(i), xy[at], xy[at + 1]);
  }
  GEOSGeometry* const line = GEOSGeom_createLinearRing_r(geos, sequence);
  GEOSGeometry* const polygon = GEOSGeom_createPolygon_r(geos, GEOSGeom_clone_r(geos, line), nullptr, 0);
  const GEOSPreparedGeometry *const prepared = GEOSPrepare_r(geos, polygon), *const outline = GEOSPrepare_r(geos, line);
  const auto with_points = [&](const Points& p, int count, const auto& ask) {
    double s = 0;
    for (int i = 0; i < count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      GEOSGeometry* const point = GEOSGeom_createPointFromXY_r(geos, p[at].x, p[at].y);
      s += ask(point);
      GEOSGeom_destroy_r(geos, point);
    }
    return s;
  };
  inside.push_back({"GEOS prepared", many, [&](const Points& p, int count) {
                      return with_points(p, count, [&](GEOSGeometry* point) {
                        return static_cast<double>(GEOSPreparedIntersects_r(geos, prepared, point));
                      });
                    }});
  distance.push_back({"GEOS prepared", many, [&](const Points& p, int count) {
                        return with_points(p, count, [&](GEOSGeometry* point) {
                          double d = 0;
                          GEOSPreparedDistance_r(geos, outline, point, &d);
                          return d;
                        });
                      }});
#endif
  row("  point in, ns:         ", inside);
  row("  distance to edges, ns:", distance);
#if defined(VESICA_HAS_GEOS)
  GEOSPreparedGeom_destroy_r(geos, prepared);
  GEOSPreparedGeom_destroy_r(geos, outline);
  GEOSGeom_destroy_r(geos, polygon);
  GEOSGeom_destroy_r(geos, line);
  GEOS_finish_r(geos);
#endif
}

/// Memory aligned as an index must be.
class Block {
 public:
  explicit Block(std::int64_t size) : size_(size), words_(static_cast<std::size_t>(size) / 8 + 16) {}
  void* data() { return reinterpret_cast<void*>((reinterpret_cast<std::uintptr_t>(words_.data()) + 63) / 64 * 64); }
  std::int64_t size() const { return size_; }

 private:
  std::int64_t size_;
  std::vector<std::int64_t> words_;
};

/// An array of shapes and its index.
struct Indexed {
  Indexed(std::int32_t kind, std::int64_t count, const void* base, std::ptrdiff_t stride)
      : index(vesica_index_size(count)) {
    vesica_shapes_from_records_f64(kind, count, base, stride, &set);
    Block scratch(vesica_index_scratch(count));
    vesica_index_build_f64(&set, 1, index.data(), index.size(), scratch.data(), scratch.size());
  }
  vesica_shapes_f64 set{};
  Block index;
};

/// Zones of n vertices side by side, and a million boxes over all of them.
void zones(int n) {
  Random random(7);
  constexpr int side = 30, boxes = 1000000;
  std::vector<std::vector<double>> coasts;
  std::vector<vesica_polygon_f64> views;
  for (int i = 0; i < side * side; ++i) coasts.push_back(coast(n, 2 * (i % side), 2 * (i / side), 1.2, random));
  for (const std::vector<double>& xy : coasts) views.push_back(view(xy));
  std::vector<vesica_aabb_f64> all;
  for (int i = 0; i < boxes; ++i) {
    const double x = random.between(-1, 2 * side), y = random.between(-1, 2 * side);
    all.push_back({x, y, x + random.between(0, 0.02), y + random.between(0, 0.02)});
  }
  Indexed a(VESICA_POLYGON, side * side, views.data(), sizeof views[0]),
      b(VESICA_AABB, boxes, all.data(), sizeof all[0]);
  const auto joined = [&](std::int32_t query, std::int64_t& pairs) {
    double least = 1e300;
    for (int pass = 0; pass < 3; ++pass) {
      Block scratch(vesica_join_scratch());
      const auto begin = Clock::now();
      pairs = vesica_join_f64(query, a.index.data(), &a.set, 1, b.index.data(), &b.set, 1, 0, 1, scratch.data(),
                              scratch.size(), nullptr, nullptr, 0, nullptr);
      least = std::min(least, nanoseconds_since(begin) / 1e6);
    }
    return least;
  };
  std::int64_t near = 0, meeting = 0;
  const double of_bounds = joined(VESICA_JOIN_BOUNDS, near), of_shapes = joined(VESICA_JOIN_OVERLAP, meeting);
  std::printf("%d zones of %d vertices with %d boxes: bounds alone %.0f ms (%lld pairs), overlap %.0f ms (%lld)\n",
              side * side, n, boxes, of_bounds, static_cast<long long>(near), of_shapes,
              static_cast<long long>(meeting));
}

}  // namespace

void report() {
  std::printf("Many questions about one polygon, least of 9 passes\n");
  for (const int n : {64, 1000, 40000}) one_polygon(n);
  for (const int n : {4, 64, 1000}) zones(n);
}

}  // namespace vesica::bench

int main() { vesica::bench::report(); }

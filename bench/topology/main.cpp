// SPDX-License-Identifier: Apache-2.0
/// Times of the questions of vesica_topology.h and the newer ones of vesica_measures.h, each beside the older question
/// that it builds on, and DE-9IM and intersections of polygons beside GEOS, with how often GEOS says otherwise. All
/// contestants of a row meet the same pairs, 256 new ones a pass, and who goes first takes turns.
#include <vesica.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "quantile.hpp"
#include "random.hpp"
#include "shapes.hpp"

#if defined(VESICA_HAS_GEOS)
#include <geos_c.h>
#endif

namespace vesica::bench {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t pairs_per_pass = 256;
constexpr int passes = 200;

struct Pair {
  Numbers a, b;
};

/// random: sizes and distances about 1. grid: sides on halves, so that many touch or share a side.
enum class Data { random, grid };

Numbers draw_shape(std::int32_t kind, Data data, Random& random) {
  const bool grid = data == Data::grid;
  const auto place = [&] { return grid ? 0.5 * random.integer(-4, 4) : random.between(-2, 2); };
  const auto size = [&] { return grid ? 0.5 * random.integer(1, 3) : random.between(0.2, 1.2); };
  const double x = place(), y = place(), angle = grid ? 0 : random.between(0, 6.283185307179586);
  const double a = size(), b = size();
  return shape_about(kind, x, y, std::cos(angle), std::sin(angle), a, b);
}

/// Takes the numbers of a pair and says something of it, so that nothing is left out.
using Ask = std::function<std::int64_t(const Pair&)>;

struct Contestant {
  std::string name;
  Ask ask;
};

void row(const std::string& what, std::int32_t kind_a, std::int32_t kind_b, Data data, std::vector<Contestant> all) {
  Random random(7);
  std::vector<Pair> pairs(pairs_per_pass);
  std::int64_t sum = 0;
  std::vector<std::vector<double>> times(all.size());
  for (int pass = 0; pass < passes; ++pass) {
    for (Pair& p : pairs) p = {draw_shape(kind_a, data, random), draw_shape(kind_b, data, random)};
    for (std::size_t k = 0; k < all.size(); ++k) {
      const std::size_t which = (k + static_cast<std::size_t>(pass)) % all.size();
      const auto begin = Clock::now();
      for (const Pair& p : pairs) sum += all[which].ask(p);
      const std::chrono::duration<double, std::nano> took = Clock::now() - begin;
      times[which].push_back(took.count() / static_cast<double>(pairs_per_pass));
    }
  }
  std::printf("%-28s", what.c_str());
  for (std::size_t k = 0; k < all.size(); ++k) {
    std::printf("  %s %.0f ns", all[k].name.c_str(), median(times[k]));
  }
  std::printf("%s\n", sum == 1 ? " " : "");
}

const char* name_of(std::int32_t kind) { return vesica_kind_name(kind); }
std::string named(std::int32_t a, std::int32_t b, Data data) {
  return std::string(name_of(a)) + " " + name_of(b) + (data == Data::grid ? " grid" : "");
}

Ask overlap(std::int32_t a, std::int32_t b) {
  return [=](const Pair& p) { return vesica_overlap_f64(a, p.a.data(), b, p.b.data()); };
}
Ask relation(std::int32_t a, std::int32_t b) {
  return [=](const Pair& p) { return vesica_relation_f64(a, p.a.data(), b, p.b.data()); };
}
Ask within(std::int32_t a, std::int32_t b) {
  return [=](const Pair& p) { return vesica_within_f64(a, p.a.data(), b, p.b.data(), 0.5); };
}
Ask nearest(std::int32_t a, std::int32_t b) {
  return [=](const Pair& p) {
    vesica_closest_points_f64 c;
    vesica_nearest_f64(a, p.a.data(), b, p.b.data(), &c);
    return c.distance > 0.5;
  };
}
Ask signed_distance(std::int32_t a, std::int32_t b) {
  return [=](const Pair& p) {
    double d = 0;
    vesica_signed_distance_f64(a, p.a.data(), b, p.b.data(), &d);
    return d > 0;
  };
}
/// The code that a caller would write without it.
Ask distance_then_depth(std::int32_t a, std::int32_t b) {
  return [=](const Pair& p) {
    vesica_closest_points_f64 c;
    vesica_penetration_f64 d{0, 0, 0};
    vesica_nearest_f64(a, p.a.data(), b, p.b.data(), &c);
    if (c.distance == 0) vesica_depth_f64(a, p.a.data(), b, p.b.data(), &d);
    return c.distance - d.depth > 0;
  };
}
Ask de9im(std::int32_t a, std::int32_t b) {
  return [=](const Pair& p) {
    char m[10];
    vesica_de9im_f64(a, p.a.data(), b, p.b.data(), m);
    return m[0] == 'F';
  };
}
Ask intersection(std::int32_t a, std::int32_t b) {
  return [=](const Pair& p) {
    vesica_point_f64 v[8];
    return vesica_intersection_f64(a, p.a.data(), b, p.b.data(), v, 8);
  };
}

Ask crossings(std::int32_t a, std::int32_t b) {
  return [=](const Pair& p) {
    vesica_point_f64 v[8];
    return vesica_crossings_f64(a, p.a.data(), b, p.b.data(), v, 8, nullptr);
  };
}

#if defined(VESICA_HAS_GEOS)
GEOSContextHandle_t geos() {
  static const GEOSContextHandle_t context = GEOS_init_r();
  return context;
}

GEOSGeometry* made(std::int32_t kind, const Numbers& n) {
  double c[8] = {n[0], n[1], n[2], n[1], n[2], n[3], n[0], n[3]};
  if (kind == VESICA_RECT) {
    vesica_shapes_f64 one;
    vesica_shapes_from_records_f64(kind, 1, n.data(), sizeof n, &one);
    vesica_corners_of_shapes_f64(&one, c);
  }
  const bool line = kind == VESICA_SEGMENT;
  const unsigned count = line ? 2 : 5;
  if (line) std::memcpy(c, n.data(), 4 * sizeof(double));
  GEOSCoordSequence* s = GEOSCoordSeq_create_r(geos(), count, 2);
  for (unsigned i = 0; i < count; ++i) GEOSCoordSeq_setXY_r(geos(), s, i, c[2 * (i % 4)], c[2 * (i % 4) + 1]);
  if (line) return GEOSGeom_createLineString_r(geos(), s);
  return GEOSGeom_createPolygon_r(geos(), GEOSGeom_createLinearRing_r(geos(), s), nullptr, 0);
}

/// Both geometries made, as a caller who has numbers must; the time of making them is printed apart.
template <class Action>
Ask with_geos(std::int32_t a, std::int32_t b, Action action) {
  return [=](const Pair& p) {
    GEOSGeometry *first = made(a, p.a), *second = made(b, p.b);
    const std::int64_t result = action(first, second);
    GEOSGeom_destroy_r(geos(), first);
    GEOSGeom_destroy_r(geos(), second);
    return result;
  };
}
std::int64_t relate(GEOSGeometry* a, GEOSGeometry* b) {
  char* m = GEOSRelate_r(geos(), a, b);
  const std::int64_t result = m[0] == 'F';
  GEOSFree_r(geos(), m);
  return result;
}
std::int64_t intersect(GEOSGeometry* a, GEOSGeometry* b) {
  GEOSGeometry* g = GEOSIntersection_r(geos(), a, b);
  const std::int64_t result = GEOSGeomTypeId_r(geos(), g);
  GEOSGeom_destroy_r(geos(), g);
  return result;
}

/// How many matrices are those of GEOS. On a grid both have the same numbers; elsewhere GEOS has rounded corners.
void agreement(std::int32_t a, std::int32_t b, Data data) {
  Random random(11);
  constexpr int cases = 20000;
  int same = 0;
  for (int i = 0; i < cases; ++i) {
    const Pair p{draw_shape(a, data, random), draw_shape(b, data, random)};
    char m[10];
    vesica_de9im_f64(a, p.a.data(), b, p.b.data(), m);
    GEOSGeometry *first = made(a, p.a), *second = made(b, p.b);
    char* theirs = GEOSRelate_r(geos(), first, second);
    same += std::strcmp(m, theirs) == 0;
    GEOSFree_r(geos(), theirs);
    GEOSGeom_destroy_r(geos(), first);
    GEOSGeom_destroy_r(geos(), second);
  }
  std::printf("%-28s  GEOS has the same matrix of %d of %d\n", named(a, b, data).c_str(), same, cases);
}
#endif

void topology(std::int32_t a, std::int32_t b, Data data) {
  const std::string name = named(a, b, data);
  std::vector<Contestant> relate_row{{"relation", relation(a, b)}, {"de9im", de9im(a, b)}};
  std::vector<Contestant> region_row{{"overlap", overlap(a, b)}, {"intersection", intersection(a, b)}};
#if defined(VESICA_HAS_GEOS)
  const Ask only_made = with_geos(a, b, [](GEOSGeometry*, GEOSGeometry*) { return std::int64_t{0}; });
  relate_row.push_back({"GEOS relate", with_geos(a, b, relate)});
  relate_row.push_back({"GEOS making both", only_made});
  region_row.push_back({"GEOS intersection", with_geos(a, b, intersect)});
#endif
  row(name, a, b, data, relate_row);
  row(name, a, b, data, region_row);
}

/// Vertices of a ring, and the struct that reads them.
struct Ring {
  std::vector<double> xy;
  vesica_polygon_f64 view() const {
    return {xy.data(), xy.data() + 1, 2 * sizeof(double), nullptr, static_cast<std::int64_t>(xy.size() / 2)};
  }
};

/// About one place near the origin: on a circle, or between half of its radius and all of it.
Ring ring_of(int vertices, bool convex, Random& random) {
  Ring ring;
  const double x = random.between(-0.7, 0.7), y = random.between(-0.7, 0.7), start = random.between(0, 1);
  for (int k = 0; k < vertices; ++k) {
    const double angle = 6.283185307179586 * (k + start) / vertices, r = convex ? 1 : random.between(0.5, 1);
    ring.xy.insert(ring.xy.end(), {x + r * std::cos(angle), y + r * std::sin(angle)});
  }
  return ring;
}

#if defined(VESICA_HAS_GEOS)
GEOSGeometry* made(const Ring& ring, bool line) {
  const auto n = static_cast<unsigned>(ring.xy.size() / 2);
  GEOSCoordSequence* s = GEOSCoordSeq_create_r(geos(), line ? n : n + 1, 2);
  for (unsigned i = 0; i < (line ? n : n + 1); ++i) {
    GEOSCoordSeq_setXY_r(geos(), s, i, ring.xy[2 * (i % n)], ring.xy[2 * (i % n) + 1]);
  }
  if (line) return GEOSGeom_createLineString_r(geos(), s);
  return GEOSGeom_createPolygon_r(geos(), GEOSGeom_createLinearRing_r(geos(), s), nullptr, 0);
}
#endif

/// A polygon and another one, both convex, or one that is not and a segment across it. GEOS has both made.
void shared_with_polygon(int vertices, bool segment) {
  Random random(17);
  constexpr int count = 256;
  std::vector<Ring> first, second;
  for (int i = 0; i < count; ++i) {
    first.push_back(ring_of(vertices, !segment, random));
    second.push_back(ring_of(segment ? 2 : vertices, true, random));
  }
  std::vector<vesica_point_f64> room(static_cast<std::size_t>(2 * vertices + 2));
  std::vector<std::pair<std::string, std::function<std::int64_t(std::size_t)>>> all;
  const auto with = [&](std::size_t i, const auto& action) {
    const auto a = first[i].view(), b = second[i].view();
    const void* other = segment ? static_cast<const void*>(second[i].xy.data()) : &b;
    return static_cast<std::int64_t>(action(VESICA_POLYGON, &a, segment ? VESICA_SEGMENT : VESICA_POLYGON, other));
  };
  all.emplace_back("overlap", [&](std::size_t i) { return with(i, vesica_overlap_f64); });
  all.emplace_back("intersection", [&](std::size_t i) {
    return with(i, [&](auto... shapes) {
      return vesica_intersection_f64(shapes..., room.data(), static_cast<std::int64_t>(room.size()));
    });
  });
#if defined(VESICA_HAS_GEOS)
  std::vector<GEOSGeometry*> a, b;
  for (std::size_t i = 0; i < first.size(); ++i) {
    a.push_back(made(first[i], false));
    b.push_back(made(second[i], segment));
  }
  all.emplace_back("GEOS intersection", [&](std::size_t i) { return intersect(a[i], b[i]); });
#endif
  std::vector<std::vector<double>> times(all.size());
  std::int64_t sum = 0;
  for (std::size_t pass = 0; pass < 15; ++pass) {
    for (std::size_t k = 0; k < all.size(); ++k) {
      const std::size_t which = (k + pass) % all.size();
      const auto begin = Clock::now();
      for (std::size_t i = 0; i < first.size(); ++i) sum += all[which].second(i);
      const std::chrono::duration<double, std::nano> took = Clock::now() - begin;
      times[which].push_back(took.count() / count);
    }
  }
  std::printf("%-28s",
              (std::string(segment ? "segment " : "polygon ") + "polygon " + std::to_string(vertices)).c_str());
  for (std::size_t k = 0; k < all.size(); ++k) std::printf("  %s %.0f ns", all[k].first.c_str(), median(times[k]));
  std::printf("%s\n", sum == 1 ? " " : "");
#if defined(VESICA_HAS_GEOS)
  for (const auto* geometries : {&a, &b}) {
    for (GEOSGeometry* g : *geometries) GEOSGeom_destroy_r(geos(), g);
  }
#endif
}

/// ns a comparison of a kept shape with one that is left.
void suppression(std::int32_t decay) {
  constexpr std::size_t n = 2000;
  Random random(3);
  std::vector<vesica_rect_f64> shapes(n);
  std::vector<double> scores(n), decayed(n), scratch(static_cast<std::size_t>(vesica_suppress_soft_scratch(n)) / 8);
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = random.between(0, 3);
    shapes[i] = {random.between(0, 40), random.between(0, 40), std::cos(angle), std::sin(angle), 1,
                 random.between(0.3, 2)};
    scores[i] = random.unit();
  }
  vesica_shapes_f64 view;
  vesica_shapes_from_records_f64(VESICA_RECT, n, shapes.data(), sizeof shapes[0], &view);
  std::vector<std::int64_t> keep(n);
  std::int64_t kept = 0;
  double best = 1e300;
  for (int i = 0; i < 5; ++i) {
    const auto begin = Clock::now();
    vesica_suppress_soft_f64(&view, scores.data(), nullptr, VESICA_RATIO_OVER_UNION, decay, 0.5, 0, 500, scratch.data(),
                             static_cast<std::int64_t>(scratch.size() * 8), keep.data(), decayed.data(), &kept);
    const std::chrono::duration<double, std::nano> took = Clock::now() - begin;
    best = std::min(best, took.count());
  }
  const double compared = static_cast<double>(kept) * (static_cast<double>(n) - static_cast<double>(kept) / 2);
  std::printf("%-28s  %.1f ns a comparison, %lld of %zu kept in %.2f ms\n",
              decay == VESICA_DECAY_LINEAR ? "soft suppression, linear" : "soft suppression, Gaussian", best / compared,
              static_cast<long long>(kept), n, best * 1e-6);
}

/// A join within a distance of rectangles spread so that each has about one other near, beside the join by overlap.
void join(std::size_t n) {
  Random random(5);
  std::vector<vesica_rect_f64> shapes(n);
  const double side = std::sqrt(static_cast<double>(n)) * 4;
  for (vesica_rect_f64& s : shapes) {
    const double angle = random.between(0, 3);
    s = {random.between(0, side), random.between(0, side), std::cos(angle), std::sin(angle), 1, random.between(0.3, 1)};
  }
  vesica_shapes_f64 view;
  const auto count = static_cast<std::int64_t>(n);
  vesica_shapes_from_records_f64(VESICA_RECT, count, shapes.data(), sizeof shapes[0], &view);
  const auto memory = [](std::int64_t bytes) {
    return std::aligned_alloc(64, static_cast<std::size_t>((bytes + 63) / 64 * 64));
  };
  void *index = memory(vesica_index_size(count)), *scratch = memory(vesica_index_scratch(count));
  vesica_index_build_f64(&view, 1, index, vesica_index_size(count), scratch, vesica_index_scratch(count));
  void* work = memory(vesica_join_scratch());
  for (const double distance : {0.0, 1.0}) {
    auto begin = Clock::now();
    const std::int64_t near =
        vesica_join_within_f64(index, &view, 1, index, &view, 1, distance, 0, 1, nullptr, nullptr, 0, nullptr);
    const std::chrono::duration<double, std::nano> took = Clock::now() - begin;
    std::printf("join within %g, %zu rects      %.0f ns a shape, %lld pairs\n", distance, n,
                took.count() / static_cast<double>(n), static_cast<long long>(near));
  }
  const auto begin = Clock::now();
  const std::int64_t pairs = vesica_join_f64(VESICA_JOIN_OVERLAP, index, &view, 1, index, &view, 1, 0, 1, work,
                                             vesica_join_scratch(), nullptr, nullptr, 0, nullptr);
  const std::chrono::duration<double, std::nano> took = Clock::now() - begin;
  std::printf("join by overlap, %zu rects     %.0f ns a shape, %lld pairs\n", n, took.count() / static_cast<double>(n),
              static_cast<long long>(pairs));
  std::free(index);
  std::free(scratch);
  std::free(work);
}

void all() {
  std::puts("Within 1/2, beside overlap and distance; signed distance, beside distance and then depth. Medians.");
  for (const auto& [a, b] : {std::pair{VESICA_POINT, VESICA_POINT},
                             {VESICA_POINT, VESICA_SEGMENT},
                             {VESICA_POINT, VESICA_RECT},
                             {VESICA_SEGMENT, VESICA_SEGMENT},
                             {VESICA_CIRCLE, VESICA_RECT},
                             {VESICA_AABB, VESICA_AABB},
                             {VESICA_RECT, VESICA_RECT},
                             {VESICA_POINT, VESICA_ELLIPSE},
                             {VESICA_RECT, VESICA_ELLIPSE},
                             {VESICA_ELLIPSE, VESICA_ELLIPSE}}) {
    row(named(a, b, Data::random), a, b, Data::random,
        {{"overlap", overlap(a, b)},
         {"within", within(a, b)},
         {"distance", nearest(a, b)},
         {"signed", signed_distance(a, b)},
         {"distance, depth", distance_then_depth(a, b)}});
  }
  row(named(VESICA_AABB, VESICA_AABB, Data::grid), VESICA_AABB, VESICA_AABB, Data::grid,
      {{"overlap", overlap(VESICA_AABB, VESICA_AABB)}, {"within", within(VESICA_AABB, VESICA_AABB)}});
  std::puts("DE-9IM and shared regions.");
  for (const Data data : {Data::random, Data::grid}) {
    for (const auto& [a, b] : {std::pair{VESICA_SEGMENT, VESICA_SEGMENT},
                               {VESICA_SEGMENT, VESICA_RECT},
                               {VESICA_AABB, VESICA_AABB},
                               {VESICA_RECT, VESICA_RECT}}) {
      topology(a, b, data);
    }
  }
  std::puts("Regions that polygons share, both made before.");
  for (const int vertices : {4, 8, 16, 64, 256}) shared_with_polygon(vertices, false);
  for (const int vertices : {4, 16, 64, 1024}) shared_with_polygon(vertices, true);
  std::puts("Round shapes, beside rectangles.");
  for (const Data data : {Data::random, Data::grid}) {
    for (const std::int32_t kind : {VESICA_RECT, VESICA_CIRCLE, VESICA_ELLIPSE, VESICA_CAPSULE, VESICA_ROUND_RECT}) {
      row(named(VESICA_SEGMENT, kind, data), VESICA_SEGMENT, kind, data,
          {{"relation", relation(VESICA_SEGMENT, kind)},
           {"de9im", de9im(VESICA_SEGMENT, kind)},
           {"crossings", crossings(VESICA_SEGMENT, kind)},
           {"intersection", intersection(VESICA_SEGMENT, kind)}});
    }
    for (const auto& [a, b] : {std::pair{VESICA_RECT, VESICA_RECT},
                               {VESICA_CIRCLE, VESICA_RECT},
                               {VESICA_ELLIPSE, VESICA_ELLIPSE},
                               {VESICA_CIRCLE, VESICA_CAPSULE},
                               {VESICA_RECT, VESICA_CAPSULE},
                               {VESICA_CAPSULE, VESICA_CAPSULE},
                               {VESICA_RECT, VESICA_ROUND_RECT},
                               {VESICA_ROUND_RECT, VESICA_ROUND_RECT}}) {
      row(named(a, b, data), a, b, data,
          {{"relation", relation(a, b)}, {"de9im", de9im(a, b)}, {"crossings", crossings(a, b)}});
    }
  }
#if defined(VESICA_HAS_GEOS)
  for (const Data data : {Data::random, Data::grid}) {
    agreement(VESICA_SEGMENT, VESICA_SEGMENT, data);
    agreement(VESICA_SEGMENT, VESICA_AABB, data);
    agreement(VESICA_AABB, VESICA_AABB, data);
    agreement(VESICA_AABB, VESICA_RECT, data);
  }
#endif
  suppression(VESICA_DECAY_LINEAR);
  suppression(VESICA_DECAY_GAUSSIAN);
  join(200000);
}

}  // namespace
}  // namespace vesica::bench

int main() { vesica::bench::all(); }

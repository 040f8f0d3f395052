// SPDX-License-Identifier: Apache-2.0
// Pieces of segments in polygons and polylines, and regions that convex polygons share: against rational numbers.
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <vesica_topology.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "polygon/cells.hpp"
#include "polygon/convex_pairs.hpp"
#include "polygon/shapes.hpp"

namespace polygon_intersection {

using namespace polygons;

using Places = std::vector<std::pair<double, double>>;
struct Answer {
  std::int64_t count;
  Places places;
};
inline bool operator==(const Answer& a, const Answer& b) { return a.count == b.count && a.places == b.places; }

inline Answer ask(std::int32_t kind_a, const void* a, std::int32_t kind_b, const void* b) {
  std::array<vesica_point_f64, 512> room{};
  Answer answer{vesica_intersection_f64(kind_a, a, kind_b, b, room.data(), room.size()), {}};
  for (std::int64_t i = 0; i < answer.count; ++i) {
    const vesica_point_f64& p = room[static_cast<std::size_t>(i)];
    EXPECT_FALSE(std::signbit(p.x) && p.x == 0);
    EXPECT_FALSE(std::signbit(p.y) && p.y == 0);
    answer.places.emplace_back(p.x, p.y);
  }
  return answer;
}

struct Vector {
  mpq_class x, y;
};
inline bool operator==(const Vector& p, const Vector& q) { return p.x == q.x && p.y == q.y; }
inline Vector operator-(const Vector& p, const Vector& q) { return {p.x - q.x, p.y - q.y}; }
inline mpq_class cross(const Vector& p, const Vector& q) { return p.x * q.y - p.y * q.x; }
inline mpq_class dot(const Vector& p, const Vector& q) { return p.x * q.x + p.y * q.y; }
inline int turn(const Vector& a, const Vector& b, const Vector& c) { return sgn(cross(b - a, c - a)); }

struct Side {
  Vector from, to;
};
inline bool is_on(const Vector& p, const Side& e) {
  return turn(e.from, e.to, p) == 0 && sgn(dot(p - e.from, p - e.to)) <= 0;
}

/// The edges of a path, those of chains and rings of one vertex too.
inline std::vector<Side> sides(const Path& path, bool closed) {
  std::vector<Side> all;
  const auto vertex = [&](std::int32_t i) {
    const auto k = static_cast<std::size_t>(2 * i);
    return Vector{path.xy[k], path.xy[k + 1]};
  };
  for (std::size_t j = 0; j < path.ring_count(); ++j) {
    const std::int32_t first = path.rings[j], last = path.rings[j + 1];
    for (std::int32_t i = first; i + 1 < last; ++i) all.push_back({vertex(i), vertex(i + 1)});
    if (closed || last - first == 1) all.push_back({vertex(last - 1), vertex(first)});
  }
  return all;
}

/// Is a point in the path? By edges above it.
inline bool holds(const std::vector<Side>& path, bool closed, const Vector& p) {
  bool odd = false;
  for (const Side& e : path) {
    if (is_on(p, e)) return true;
    if ((e.from.x <= p.x) == (e.to.x <= p.x)) continue;
    if (e.from.x <= p.x ? turn(e.from, e.to, p) < 0 : turn(e.from, e.to, p) > 0) odd = !odd;
  }
  return closed && odd;
}

/// The pieces of a segment, by all places at which an edge may change something, and the middles between them.
inline std::vector<Side> pieces(const std::vector<Side>& path, bool closed, const Side& s) {
  const Vector along = s.to - s.from;
  if (s.from == s.to) return holds(path, closed, s.from) ? std::vector<Side>{s} : std::vector<Side>{};
  std::vector<mpq_class> places{0, 1};
  const mpq_class length = dot(along, along);
  for (const Side& e : path) {
    for (const Vector& v : {e.from, e.to}) {
      if (turn(s.from, s.to, v) == 0) places.push_back(dot(v - s.from, along) / length);
    }
    const mpq_class whole = cross(along, e.to - e.from);
    if (sgn(whole) != 0) places.push_back(cross(e.from - s.from, e.to - e.from) / whole);
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  places.erase(std::remove_if(places.begin(), places.end(), [](const mpq_class& t) { return t < 0 || t > 1; }),
               places.end());
  const auto at = [&](const mpq_class& t) { return Vector{s.from.x + t * along.x, s.from.y + t * along.y}; };
  std::vector<Side> found;
  bool joined = false;  // the part before is in the path
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Vector p = at(places[k]);
    const bool in = holds(path, closed, p);
    const bool behind = k + 1 < places.size() && holds(path, closed, at((places[k] + places[k + 1]) / 2));
    if (joined) found.back().to = p;
    if (in && !joined) found.push_back({p, p});
    joined = behind;
  }
  return found;
}

inline double largest(std::initializer_list<double> numbers, const Path& path) {
  double most = 0;
  for (const double v : numbers) most = std::max(most, std::abs(v));
  for (const double v : path.xy) most = std::max(most, std::abs(v));
  return most;
}

/// 4u of the largest number, and half of the least number.
inline bool is_near(const std::pair<double, double>& p, const Vector& v, double largest) {
  const mpq_class room = mpq_class(largest) * mpq_class(0x1p-51) + mpq_class(0x1p-1074);
  return abs(mpq_class(p.first) - v.x) <= room && abs(mpq_class(p.second) - v.y) <= room;
}

inline Path mirrored_ends(const Path& s) {
  Path turned;
  turned.add_ring({s.xy[2], s.xy[3], s.xy[0], s.xy[1]});
  return turned;
}

TEST(PolygonIntersection, PiecesKnown) {
  Path u, frame;
  u.add_ring({0, 0, 6, 0, 6, 4, 4, 4, 4, 2, 2, 2, 2, 4, 0, 4});
  frame.add_ring({0, 0, 8, 0, 8, 8, 0, 8});
  frame.add_ring({2, 2, 6, 2, 6, 6, 2, 6});
  const auto a = u.view(), b = frame.view();
  const auto of = [](std::int32_t kind, const vesica_polygon_f64& path, vesica_segment_f64 s) {
    const Answer answer = ask(kind, &path, VESICA_SEGMENT, &s);
    EXPECT_EQ(answer, ask(VESICA_SEGMENT, &s, kind, &path));
    return answer.places;
  };
  EXPECT_EQ(of(VESICA_POLYGON, a, {-1, 3, 9, 3}), (Places{{0, 3}, {2, 3}, {4, 3}, {6, 3}}));
  EXPECT_EQ(of(VESICA_POLYGON, a, {9, 3, -1, 3}), (Places{{6, 3}, {4, 3}, {2, 3}, {0, 3}}));
  EXPECT_EQ(of(VESICA_POLYGON, a, {-1, 2, 9, 2}), (Places{{0, 2}, {6, 2}}));
  EXPECT_EQ(of(VESICA_POLYGON, a, {-1, 4, 9, 4}), (Places{{0, 4}, {2, 4}, {4, 4}, {6, 4}}));
  EXPECT_EQ(of(VESICA_POLYGON, a, {1, 1, 5, 1}), (Places{{1, 1}, {5, 1}}));
  EXPECT_EQ(of(VESICA_POLYGON, a, {-1, 1, 1, -1}), (Places{{0, 0}, {0, 0}}));
  EXPECT_EQ(of(VESICA_POLYGON, a, {3, 1, 3, 2}), (Places{{3, 1}, {3, 2}}));
  EXPECT_EQ(of(VESICA_POLYGON, a, {3, 3, 3, 4}), Places{});
  EXPECT_EQ(of(VESICA_POLYGON, a, {3, 3, 3, 2}), (Places{{3, 2}, {3, 2}}));
  EXPECT_EQ(of(VESICA_POLYGON, a, {1, 1, 1, 1}), (Places{{1, 1}, {1, 1}}));
  EXPECT_EQ(of(VESICA_POLYGON, a, {3, 3, 3, 3}), Places{});
  EXPECT_EQ(of(VESICA_POLYGON, b, {0, 4, 8, 4}), (Places{{0, 4}, {2, 4}, {6, 4}, {8, 4}}));
  EXPECT_EQ(of(VESICA_POLYGON, b, {4, 4, 8, 8}), (Places{{6, 6}, {8, 8}}));
  EXPECT_EQ(of(VESICA_POLYGON, b, {2, 2, 6, 2}), (Places{{2, 2}, {6, 2}}));
  EXPECT_EQ(of(VESICA_POLYGON, b, {3, 3, 5, 5}), Places{});
  EXPECT_EQ(of(VESICA_POLYLINE, a, {-1, 2, 9, 2}), (Places{{2, 2}, {4, 2}, {6, 2}, {6, 2}}));
  EXPECT_EQ(of(VESICA_POLYLINE, a, {1, 1, 5, 1}), Places{});
}

TEST(PolygonIntersection, RegionsKnown) {
  Path square, other, inner, beside, corner, lying;
  square.add_ring({0, 0, 2, 0, 4, 0, 4, 4, 0, 4});
  other.add_ring({2, 2, 2, 6, 6, 6, 6, 2, 2, 2});
  inner.add_ring({1, 1, 2, 1, 2, 2});
  beside.add_ring({4, 1, 8, 1, 8, 6, 4, 6});
  corner.add_ring({4, 4, 8, 4, 8, 8});
  lying.add_ring({1, 0, 3, 0, 1, 0});
  const auto a = square.view();
  const auto of = [&](std::int32_t kind, const void* b) {
    const Answer answer = ask(VESICA_POLYGON, &a, kind, b);
    EXPECT_EQ(answer, ask(kind, b, VESICA_POLYGON, &a));
    return answer.places;
  };
  const auto with = [&](const Path& path) {
    const auto b = path.view();
    return of(VESICA_POLYGON, &b);
  };
  EXPECT_EQ(with(square), (Places{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
  EXPECT_EQ(with(other), (Places{{2, 2}, {4, 2}, {4, 4}, {2, 4}}));
  EXPECT_EQ(with(inner), (Places{{1, 1}, {2, 1}, {2, 2}}));
  EXPECT_EQ(with(beside), (Places{{4, 1}, {4, 4}}));
  EXPECT_EQ(with(corner), (Places{{4, 4}}));
  EXPECT_EQ(with(lying), (Places{{1, 0}, {3, 0}}));
  const vesica_aabb_f64 box{1, -1, 3, 9}, line{1, 2, 9, 2};
  EXPECT_EQ(of(VESICA_AABB, &box), (Places{{1, 0}, {3, 0}, {3, 4}, {1, 4}}));
  EXPECT_EQ(of(VESICA_AABB, &line), (Places{{1, 2}, {4, 2}}));
  const vesica_rect_f64 turned{4, 2, 3, 4, 0.25, 0.25}, flat{4, 2, 1, 0, 1, 0}, across{2, 2, 0, 1, 4, 0};
  EXPECT_EQ(of(VESICA_RECT, &turned), (Places{{4, 0.4375}, {4, 3.5625}, {3.75, 3.75}, {2.25, 1.75}}));
  EXPECT_EQ(of(VESICA_RECT, &flat), (Places{{3, 2}, {4, 2}}));
  EXPECT_EQ(of(VESICA_RECT, &across), (Places{{2, 0}, {2, 4}}));
  const vesica_point_f64 on{2, 0}, off{2, -1};
  EXPECT_EQ(of(VESICA_POINT, &on), (Places{{2, 0}}));
  EXPECT_EQ(of(VESICA_POINT, &off), Places{});
}

TEST(PolygonIntersection, RoomAndErrors) {
  Path square, bent, other;
  square.add_ring({0, 0, 4, 0, 4, 4, 0, 4});
  bent.add_ring({0, 0, 4, 0, 4, 4, 3, 1});
  other.add_ring({2, 2, 6, 2, 6, 6, 2, 6});
  const auto a = square.view(), b = bent.view(), c = other.view();
  std::array<vesica_point_f64, 4> room{};
  room.fill({7, 7});
  EXPECT_EQ(vesica_intersection_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &c, room.data(), 3), 4);
  EXPECT_EQ(room[2].y, 4);
  EXPECT_EQ(room[3].x, 7);
  EXPECT_EQ(vesica_intersection_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &c, nullptr, 0), 4);
  EXPECT_EQ(vesica_intersection_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &c, nullptr, 1), VESICA_E_NULL);
  EXPECT_EQ(vesica_intersection_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &c, room.data(), -1), VESICA_E_ARGUMENT);
  EXPECT_EQ(vesica_intersection_f64(VESICA_POLYGON, &a, VESICA_POLYGON, &b, room.data(), 4), VESICA_E_NOT_CONVEX);
  const vesica_aabb_f64 box{9, 9, 10, 10}, inverted{1, 0, 0, 1};
  EXPECT_EQ(vesica_intersection_f64(VESICA_AABB, &box, VESICA_POLYGON, &b, room.data(), 4), VESICA_E_NOT_CONVEX);
  EXPECT_EQ(vesica_intersection_f64(VESICA_AABB, &inverted, VESICA_POLYGON, &a, room.data(), 4), VESICA_E_SHAPE);
  const vesica_rect_f64 rect{0, 0, 1, 0, 1, 1}, axisless{0, 0, 0, 0, 1, 1};
  EXPECT_EQ(vesica_intersection_f64(VESICA_RECT, &rect, VESICA_POLYGON, &b, room.data(), 4), VESICA_E_NOT_CONVEX);
  EXPECT_EQ(vesica_intersection_f64(VESICA_RECT, &axisless, VESICA_POLYGON, &a, room.data(), 4), VESICA_E_SHAPE);
  const vesica_circle_f64 disc{0, 0, 1};
  const vesica_segment_f64 segment{0, 0, 1, 1};
  for (const std::int64_t capacity : {std::int64_t{4}, std::int64_t{-1}}) {
    const auto call = [&](std::int32_t kind_a, const void* p, std::int32_t kind_b, const void* q) {
      return vesica_intersection_f64(kind_a, p, kind_b, q, room.data(), capacity);
    };
    EXPECT_EQ(call(VESICA_POLYGON, &a, VESICA_CIRCLE, &disc), VESICA_E_KIND);
    EXPECT_EQ(call(VESICA_POLYLINE, &a, VESICA_AABB, &box), VESICA_E_KIND);
    EXPECT_EQ(call(VESICA_POLYLINE, &a, VESICA_POLYGON, &c), VESICA_E_KIND);
    EXPECT_EQ(call(VESICA_POLYGON, &a, VESICA_POLYLINE, &c), VESICA_E_KIND);
    EXPECT_EQ(call(VESICA_POLYLINE, &a, VESICA_POLYLINE, &c), VESICA_E_KIND);
  }
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Path invalid;
  invalid.add_ring({0, 0, nan, 0, 4, 4});
  const auto d = invalid.view();
  EXPECT_EQ(vesica_intersection_f64(VESICA_POLYGON, &d, VESICA_SEGMENT, &segment, room.data(), 4), VESICA_E_SHAPE);
  const std::vector<float> xy{0, 0, 4, 0, 4, 4, 0, 4};
  const vesica_polygon_f32 narrow{xy.data(), xy.data() + 1, 8, nullptr, 4};
  const vesica_segment_f32 across{1, -1, 1, 9};
  std::array<vesica_point_f32, 2> narrow_room{};
  EXPECT_EQ(vesica_intersection_f32(VESICA_POLYGON, &narrow, VESICA_SEGMENT, &across, narrow_room.data(), 2), 2);
  EXPECT_EQ(narrow_room[0].x, 1);
  EXPECT_EQ(narrow_room[1].y, 4);
}

/// Asks for pieces, compares with the truth, and asks again with everything written in another way.
inline void expect_pieces(const Path& path, bool closed, const Path& s, Random& random, std::array<int, 3>& seen) {
  const std::int32_t kind = closed ? VESICA_POLYGON : VESICA_POLYLINE;
  const auto view = path.view();
  const Answer answer = ask(kind, &view, VESICA_SEGMENT, s.xy.data());
  const Side segment{{s.xy[0], s.xy[1]}, {s.xy[2], s.xy[3]}};
  const std::vector<Side> truth = pieces(sides(path, closed), closed, segment);
  ASSERT_EQ(answer.count, static_cast<std::int64_t>(2 * truth.size()));
  const double most = largest({s.xy[0], s.xy[1], s.xy[2], s.xy[3]}, path);
  for (std::size_t k = 0; k < truth.size(); ++k) {
    const auto &from = answer.places[2 * k], &to = answer.places[2 * k + 1];
    ASSERT_TRUE(is_near(from, truth[k].from, most)) << k;
    ASSERT_TRUE(is_near(to, truth[k].to, most)) << k;
    const bool point = truth[k].from == truth[k].to;
    if (point) {
      ASSERT_EQ(from, to);
    }
    ++seen[point ? 0 : 1];
  }
  if (truth.size() > 1) ++seen[2];
  Answer back = ask(VESICA_SEGMENT, mirrored_ends(s).xy.data(), kind, &view);
  std::reverse(back.places.begin(), back.places.end());
  ASSERT_EQ(answer, back);
  if (!closed) return;
  const Path other = rewritten(path, random);
  const auto other_view = other.view();
  ASSERT_EQ(answer, ask(kind, &other_view, VESICA_SEGMENT, s.xy.data()));
}

TEST(PolygonIntersection, PiecesOfLatticePaths) {
  Random random(7101);
  std::array<int, 3> seen{};
  const int cases = 20000 * properties::repeat();
  for (int i = 0; i < cases; ++i) {
    const int size = random.integer(2, 6);
    const Map map(random);
    const Path path = map.of(lattice_path(size, random));
    Path s;
    s.add_ring(lattice_ring(2, size, random));
    ASSERT_NO_FATAL_FAILURE(expect_pieces(path, random.chance(0.7), map.of(s), random, seen)) << i;
  }
  EXPECT_GT(*std::min_element(seen.begin(), seen.end()), cases / 20);
}

/// A segment through, along and nearly along vertices and edges of a star with holes, here or far away.
TEST(PolygonIntersection, PiecesOfStars) {
  Random random(7102);
  std::array<int, 3> seen{};
  const int cases = 2000 * properties::repeat();
  for (int i = 0; i < cases; ++i) {
    const bool is_far = random.chance(0.3);
    const double x = is_far ? 1e15 : 0, radius = is_far ? 100 : 1;
    Path path;
    path.add_ring(star(random.integer(3, 40), x, -x, radius, 0.4, random));
    if (random.chance(0.5)) path.add_ring(star(random.integer(3, 12), x, -x, 0.4 * radius, 0.4, random));
    const auto pick = [&] {
      const auto k = static_cast<std::size_t>(random.below(static_cast<int>(path.xy.size() / 2)));
      const double kept = random.chance(0.4) ? 1 : random.chance(0.3) ? 1.5 : random.between(-2, 2);
      Corner c{x + (path.xy[2 * k] - x) * kept, -x + (path.xy[2 * k + 1] + x) * kept};
      if (random.chance(0.3)) c = {nudged(c[0], random), nudged(c[1], random)};
      return c;
    };
    const Corner p = pick(), q = pick();
    Path s;
    s.add_ring({p[0], p[1], q[0], q[1]});
    ASSERT_NO_FATAL_FAILURE(expect_pieces(path, random.chance(0.8), s, random, seen)) << i;
  }
  EXPECT_GT(*std::min_element(seen.begin(), seen.end()), cases / 50);
}

/// More pieces than are found at a time.
TEST(PolygonIntersection, ManyPieces) {
  constexpr int n = 2000;
  Path comb;
  std::vector<double> xy{0, -2};
  for (int i = 0; i < n; ++i) xy.insert(xy.end(), {2.0 * i, 1, 2.0 * i + 1, -1});
  xy.insert(xy.end(), {2.0 * n, -2});
  comb.add_ring(xy);
  const auto view = comb.view();
  const vesica_segment_f64 s{-1, 0, 2 * n, 0};
  std::vector<vesica_point_f64> room(2 * n);
  ASSERT_EQ(vesica_intersection_f64(VESICA_POLYGON, &view, VESICA_SEGMENT, &s, room.data(), 2 * n), 2 * n);
  for (int i = 0; i < n; ++i) {
    ASSERT_EQ(room[static_cast<std::size_t>(2 * i)].x, i == 0 ? 0 : 2 * i - 0.5);
    ASSERT_EQ(room[static_cast<std::size_t>(2 * i + 1)].x, 2 * i + 0.5);
  }
}

using Ring = std::vector<Vector>;

inline Ring ring_of(const std::vector<Corner>& corners) {
  Ring ring;
  for (const Corner& c : corners) ring.push_back({c[0], c[1]});
  return ring;
}
/// Corners of a rectangle, counter-clockwise, none twice.
inline Ring ring_of(const vesica_rect_f64& r) {
  const mpq_class cx(r.cx), cy(r.cy), ax = mpq_class(r.ux) * r.hx, ay = mpq_class(r.uy) * r.hx,
                                      bx = mpq_class(-r.uy) * r.hy, by = mpq_class(r.ux) * r.hy;
  Ring ring;
  for (const auto& [s, t] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    const Vector v{cx + s * ax + t * bx, cy + s * ay + t * by};
    if (std::find(ring.begin(), ring.end(), v) == ring.end()) ring.push_back(v);
  }
  return ring;
}
inline bool holds(const Ring& ring, const Vector& p) {
  if (ring.size() == 1) return ring[0] == p;
  if (ring.size() == 2) return is_on(p, {ring[0], ring[1]});
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (turn(ring[i], ring[(i + 1) % ring.size()], p) < 0) return false;
  }
  return true;
}

/// The region that two convex rings share, counter-clockwise: corners of one in the other, and edges that cross.
inline Ring shared(const Ring& a, const Ring& b) {
  Ring all;
  const auto add = [&](const Vector& v) {
    if (std::find(all.begin(), all.end(), v) == all.end()) all.push_back(v);
  };
  for (const Vector& v : a) {
    if (holds(b, v)) add(v);
  }
  for (const Vector& v : b) {
    if (holds(a, v)) add(v);
  }
  const auto edges = [](const Ring& ring) { return ring.size() > 2 ? ring.size() : ring.size() - 1; };
  for (std::size_t i = 0; i < edges(a); ++i) {
    for (std::size_t j = 0; j < edges(b); ++j) {
      const Vector &p = a[i], &q = a[(i + 1) % a.size()], &r = b[j], &s = b[(j + 1) % b.size()];
      if (turn(p, q, r) * turn(p, q, s) >= 0 || turn(r, s, p) * turn(r, s, q) >= 0) continue;
      const mpq_class t = cross(r - p, s - r) / cross(q - p, s - r);
      add({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  if (all.size() > 2) {
    std::sort(all.begin() + 1, all.end(), [&](const Vector& v, const Vector& w) { return turn(all[0], v, w) > 0; });
  }
  return all;
}

/// From some vertex on they are the same, and the first written is the lowest, the left one of two.
inline void expect_region(const Answer& answer, const Ring& truth, double most) {
  ASSERT_EQ(answer.count, static_cast<std::int64_t>(truth.size()));
  bool found = truth.empty();
  for (std::size_t shift = 0; shift < truth.size() && !found; ++shift) {
    found = true;
    for (std::size_t i = 0; i < truth.size() && found; ++i) {
      found = is_near(answer.places[i], truth[(i + shift) % truth.size()], most);
    }
  }
  EXPECT_TRUE(found) << "not these vertices in this order";
  for (const auto& [x, y] : answer.places) {
    const auto& first = answer.places[0];
    EXPECT_TRUE(y > first.second || (y == first.second && x >= first.first));
  }
}

/// With vertices in the middle of edges where these are numbers, and repeated ones.
inline Path with_more_vertices(const std::vector<Corner>& corners, Random& random) {
  std::vector<Corner> ring;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner &p = corners[i], &q = corners[(i + 1) % corners.size()];
    for (int n = random.chance(0.8) ? 1 : 2; n > 0; --n) ring.push_back(p);
    const Corner middle{(p[0] + q[0]) / 2, (p[1] + q[1]) / 2};
    if (mpq_class(middle[0]) * 2 == mpq_class(p[0]) + mpq_class(q[0]) &&
        mpq_class(middle[1]) * 2 == mpq_class(p[1]) + mpq_class(q[1]) && random.chance(0.5)) {
      ring.push_back(middle);
    }
  }
  return path_of(ring);
}

inline std::vector<Corner> corners_of(const Path& path) {
  std::vector<Corner> corners;
  for (std::size_t i = 0; i < path.xy.size(); i += 2) corners.push_back({path.xy[i], path.xy[i + 1]});
  return corners;
}

TEST(PolygonIntersection, RegionsOfConvexPolygons) {
  Random random(7103);
  std::array<int, 4> seen{};
  const int pairs = 10000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    Two pair;
    if (!convex_pair(pair, random)) continue;
    const std::vector<Corner> a = corners_of(pair.a), b = corners_of(pair.b);
    const Ring truth = shared(ring_of(a), ring_of(b));
    const auto view_a = pair.a.view(), view_b = pair.b.view();
    const Answer answer = ask(VESICA_POLYGON, &view_a, VESICA_POLYGON, &view_b);
    const double most = std::max(largest({}, pair.a), largest({}, pair.b));
    ASSERT_NO_FATAL_FAILURE(expect_region(answer, truth, most)) << i;
    ASSERT_EQ(answer, ask(VESICA_POLYGON, &view_b, VESICA_POLYGON, &view_a)) << i;
    const Path other_a = rewritten(pair.a, random), other_b = rewritten(pair.b, random);
    const auto other_view_a = other_a.view(), other_view_b = other_b.view();
    ASSERT_EQ(answer, ask(VESICA_POLYGON, &other_view_a, VESICA_POLYGON, &other_view_b)) << i;
    const Path more_a = rewritten(with_more_vertices(a, random), random),
               more_b = rewritten(with_more_vertices(b, random), random);
    const auto more_view_a = more_a.view(), more_view_b = more_b.view();
    const Answer more = ask(VESICA_POLYGON, &more_view_a, VESICA_POLYGON, &more_view_b);
    ASSERT_NO_FATAL_FAILURE(expect_region(more, truth, most)) << i;
    ASSERT_EQ(more, ask(VESICA_POLYGON, &more_view_b, VESICA_POLYGON, &more_view_a)) << i;
    ++seen[std::min<std::size_t>(truth.size(), 3)];
    if (HasFailure()) FAIL() << i;
  }
  EXPECT_GT(*std::min_element(seen.begin(), seen.end()), pairs / 400);
}

TEST(PolygonIntersection, RegionsWithBoxesAndRectangles) {
  Random random(7104);
  std::array<int, 4> seen{};
  const int pairs = 20000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    const bool lattice = random.chance(0.6);
    std::vector<Corner> a = convex(lattice, random);
    if (random.chance(0.1)) a.resize(std::min<std::size_t>(a.size(), 2));
    const double scale = random.chance(0.7) ? 1 : random.chance(0.5) ? 0x1p-500 : 0x1p300;
    const auto pick = [&] { return a[static_cast<std::size_t>(random.below(static_cast<int>(a.size())))]; };
    const auto size = [&] {
      return random.chance(0.2) ? 0 : lattice ? 0.5 * random.integer(1, 8) : random.between(0, 2);
    };
    const Corner at = random.chance(0.5) ? pick() : Corner{1.0 * random.integer(-2, 12), 1.0 * random.integer(-2, 12)};
    vesica_rect_f64 r{at[0], at[1], 1, 0, size(), size()};
    if (random.chance(0.6)) {
      r.ux = random.integer(-3, 3);
      r.uy = random.integer(1, 3);
      if (random.chance(0.3)) r.ux = random.between(-1, 1);
    }
    if (random.chance(0.3)) {  // along an edge
      const Corner p = a[0], q = a[1 % a.size()];
      if (p != q)
        r = {(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, q[0] - p[0], q[1] - p[1], 0.5, random.chance(0.5) ? 0 : 0.5};
    }
    for (Corner& c : a) c = {c[0] * scale, c[1] * scale};
    r.cx *= scale;
    r.cy *= scale;
    r.hx *= scale;
    r.hy *= scale;
    const Path path = rewritten(with_more_vertices(a, random), random);
    const auto view = path.view();
    const bool upright = r.uy == 0 && r.ux == 1;
    const vesica_aabb_f64 box{r.cx - r.hx, r.cy - r.hy, r.cx + r.hx, r.cy + r.hy};
    const vesica_rect_f64 same{box.min_x / 2 + box.max_x / 2, box.min_y / 2 + box.max_y / 2, 1, 0,
                               box.max_x / 2 - box.min_x / 2, box.max_y / 2 - box.min_y / 2};
    for (const bool as_box : {false, true}) {
      if (as_box && (!upright || !lattice)) continue;
      const std::int32_t kind = as_box ? VESICA_AABB : VESICA_RECT;
      const void* other = as_box ? static_cast<const void*>(&box) : &r;
      const Ring truth = shared(ring_of(a), ring_of(as_box ? same : r));
      const double reach = std::hypot(r.ux, r.uy) * std::max(r.hx, r.hy);
      const double most = largest({r.cx, r.cy, reach, std::abs(r.cx) + reach, std::abs(r.cy) + reach}, path);
      const Answer answer = ask(VESICA_POLYGON, &view, kind, other);
      ASSERT_NO_FATAL_FAILURE(expect_region(answer, truth, most)) << i;
      ASSERT_EQ(answer, ask(kind, other, VESICA_POLYGON, &view)) << i;
      ++seen[std::min<std::size_t>(truth.size(), 3)];
    }
    if (HasFailure()) FAIL() << i;
  }
  EXPECT_GT(*std::min_element(seen.begin(), seen.end()), pairs / 50);
}

/// Floats are the double vertices, rounded.
TEST(PolygonIntersection, InFloat) {
  Random random(7105);
  int most = 0;
  const int pairs = 2000 * properties::repeat();
  for (int i = 0; i < pairs; ++i) {
    std::array<std::vector<float>, 2> narrow;
    std::array<Path, 2> wide;
    for (std::size_t k = 0; k < 2; ++k) {
      for (const Corner& c : convex(false, random)) {
        narrow[k].insert(narrow[k].end(), {static_cast<float>(c[0]), static_cast<float>(c[1])});
      }
      wide[k].add_ring({narrow[k].begin(), narrow[k].end()});
    }
    const auto view = [&](std::size_t k) {
      return vesica_polygon_f32{narrow[k].data(), narrow[k].data() + 1, 8, nullptr,
                                static_cast<std::int64_t>(narrow[k].size() / 2)};
    };
    const vesica_polygon_f32 a = view(0), b = view(1);
    const auto wide_a = wide[0].view(), wide_b = wide[1].view();
    const vesica_segment_f32 s{narrow[1][0], narrow[1][1], -narrow[1][0], narrow[0][0]};
    const std::array<double, 4> wide_s{s.x0, s.y0, s.x1, s.y1};
    std::array<vesica_point_f32, 64> room{};
    for (const bool segment : {false, true}) {
      const std::int64_t count = segment
                                     ? vesica_intersection_f32(VESICA_POLYGON, &a, VESICA_SEGMENT, &s, room.data(), 64)
                                     : vesica_intersection_f32(VESICA_POLYGON, &a, VESICA_POLYGON, &b, room.data(), 64);
      const Answer truth = segment ? ask(VESICA_POLYGON, &wide_a, VESICA_SEGMENT, wide_s.data())
                                   : ask(VESICA_POLYGON, &wide_a, VESICA_POLYGON, &wide_b);
      ASSERT_EQ(count, truth.count) << i;
      Places answer, rounded;
      for (std::size_t k = 0; k < truth.places.size(); ++k) {
        answer.emplace_back(room[k].x, room[k].y);
        rounded.emplace_back(static_cast<float>(truth.places[k].first), static_cast<float>(truth.places[k].second));
      }
      if (!segment) {  // equal after rounding, another one may be the lowest
        std::sort(answer.begin(), answer.end());
        std::sort(rounded.begin(), rounded.end());
      }
      ASSERT_EQ(answer, rounded) << i;
      most = std::max(most, static_cast<int>(count));
    }
  }
  EXPECT_GT(most, 6);
}

}  // namespace polygon_intersection

// SPDX-License-Identifier: Apache-2.0
// Contacts against their definition, by all edges in rational numbers, for the normal that the library gives.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "polygon/convex_pairs.hpp"
#include "properties/random.hpp"
#include "vesica.h"

namespace manifold_definition {

using polygons::Corner;
using polygons::Path;
using properties::Random;
using Manifold = vesica_contacts_f64;

struct Exact {
  mpq_class x, y;
};
inline Exact operator+(const Exact& p, const Exact& q) { return {p.x + q.x, p.y + q.y}; }
inline Exact operator-(const Exact& p, const Exact& q) { return {p.x - q.x, p.y - q.y}; }
inline Exact operator*(const mpq_class& k, const Exact& p) { return {k * p.x, k * p.y}; }
inline mpq_class dot(const Exact& p, const Exact& q) { return p.x * q.x + p.y * q.y; }
inline mpq_class cross(const Exact& p, const Exact& q) { return p.x * q.y - p.y * q.x; }
inline Exact exact(double x, double y) { return {mpq_class(x), mpq_class(y)}; }

/// A shape without a curve but its radius: the corners of its core, counter-clockwise, by their numbers.
struct Shape {
  std::int32_t kind;
  std::vector<double> numbers;
  Path path;
  vesica_polygon_f64 view;

  const void* data() const { return kind == VESICA_POLYGON ? static_cast<const void*>(&view) : numbers.data(); }
  double radius() const {
    const bool has_one = kind == VESICA_CIRCLE || kind == VESICA_CAPSULE || kind == VESICA_ROUND_RECT;
    return has_one ? numbers.back() : 0;
  }
  std::vector<Exact> corners() const {
    const auto& n = numbers;
    switch (kind) {
      case VESICA_SEGMENT:
      case VESICA_CAPSULE:
        return {exact(n[0], n[1]), exact(n[2], n[3])};
      case VESICA_AABB:
        return {exact(n[0], n[1]), exact(n[2], n[1]), exact(n[2], n[3]), exact(n[0], n[3])};
      case VESICA_RECT:
      case VESICA_ROUND_RECT: {
        const Exact c = exact(n[0], n[1]), u = mpq_class(n[4]) * exact(n[2], n[3]),
                    v = mpq_class(n[5]) * exact(-n[3], n[2]);
        return {c - u - v, c + u - v, c + u + v, c - u + v};
      }
      case VESICA_POLYGON: {
        std::vector<Exact> ring;
        for (std::size_t i = 0; i < path.xy.size(); i += 2) ring.push_back(exact(path.xy[i], path.xy[i + 1]));
        return ring;
      }
      default:
        return {exact(n[0], n[1])};
    }
  }
};

struct Edge {
  Exact p, q;
  std::int64_t from, to;
  double deviation;  // the sine of the angle from the normal, or 2 if it is behind
  double slope;
  double joined;  // how far it may be from the edges that it stands for, in scales
};

/// The edges whose outward normals are nearest to a direction, up to rounding; also continued over vertices that are on
/// their line up to rounding.
inline std::vector<Edge> facing_edges(const Shape& s, const Exact& to, double scale) {
  const std::vector<Exact> ring = s.corners();
  const std::size_t size = ring.size();
  std::vector<Edge> edges;
  double least = 3;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t j = (i + 1) % size;
    const Exact way = ring[j] - ring[i], normal{way.y, -way.x};
    const mpq_class length = dot(way, way);
    if (length == 0) continue;
    const mpq_class along = dot(normal, to), across = cross(normal, to);
    const double deviation = along < 0 ? 2 : std::sqrt(mpq_class(across * across / (length * dot(to, to))).get_d());
    const double slope = along == 0 ? 1e300 : std::fabs(mpq_class(across / along).get_d());
    edges.push_back(
        {ring[i], ring[j], static_cast<std::int64_t>(i), static_cast<std::int64_t>(j), deviation, slope, 0});
    least = std::min(least, deviation);
  }
  std::erase_if(edges, [&](const Edge& e) { return e.deviation > least + 2e-15; });
  if (s.kind != VESICA_POLYGON) return edges;
  const mpq_class allowed(0x1p-46 * scale);
  std::vector<Edge> all;
  for (const Edge& e : edges) {
    const Exact way = e.q - e.p;
    const auto continues = [&](std::size_t next, std::size_t before, int forward) {
      const mpq_class area = cross(way, ring[next % size] - e.p);
      return mpq_class(area * area) <= allowed * allowed * dot(way, way) &&
             forward * sgn(dot(way, ring[next % size] - ring[before % size])) >= 0;
    };
    std::size_t first = static_cast<std::size_t>(e.from) + size, last = first + 1;
    while (last - first < size - 1 && continues(first - 1, first, -1)) --first;
    while (last - first < size - 1 && continues(last + 1, last, 1)) ++last;
    for (std::size_t i = first; i <= static_cast<std::size_t>(e.from) + size; ++i) {
      for (std::size_t j = static_cast<std::size_t>(e.from) + size + 1; j <= last; ++j) {
        all.push_back({ring[i % size], ring[j % size], static_cast<std::int64_t>(i % size),
                       static_cast<std::int64_t>(j % size), e.deviation, e.slope, last - first > 1 ? 0x1p-46 : 0});
      }
    }
  }
  return all;
}

inline double scale_of(const Shape& a, const Shape& b) {
  mpq_class most = 0;
  const Exact origin = a.corners()[0];
  for (const Shape* s : {&a, &b}) {
    for (const Exact& p : s->corners())
      most = std::max(most, mpq_class(std::max(abs(p.x - origin.x), abs(p.y - origin.y))));
  }
  return most.get_d();
}

/// How far a contact is from where two edges have it, over the allowed error; or what else is wrong.
struct Judge {
  const Manifold& m;
  Exact n, across;
  mpq_class square;
  double radius_a, radius_b, scale;

  double along(const Exact& p) const { return mpq_class(dot(n, p) / square).get_d(); }

  std::string point(double x, double y, const Exact& on_a, const Exact& on_b, double tolerance) const {
    // Midway between the outlines.
    const Exact middle = mpq_class(0.5) * (on_a + on_b + (mpq_class(radius_a) - mpq_class(radius_b)) * n);
    const Exact off = exact(x, y) - middle;
    const double error = std::hypot(off.x.get_d(), off.y.get_d());
    const double size = std::max(std::fabs(x), std::fabs(y)) + radius_a + radius_b;
    // A second depth may be 0 for one that is less by 2^-48 of the unit, which is less than 4 scales.
    const double raised = std::min(m.depth0, m.depth1) == 0 ? 0x1p-47 * scale : 0;
    return error <= 16 * 0x1p-53 * size + tolerance + raised + 1e-320
               ? ""
               : "the point is off by " + std::to_string(error / (size + scale) / 0x1p-53);
  }

  std::string operator()(const Edge& e, const Edge& f) const {
    const auto place = [&](const Exact& p) { return dot(across, p); };
    // e goes counter-clockwise about a, up along `across`; f the other way.
    const mpq_class low = std::max(place(e.p), place(f.q)), high = std::min(place(e.q), place(f.p));
    const auto at = [&](const Exact& p, const Exact& q, const mpq_class& s) -> Exact {
      const mpq_class length = place(q) - place(p);
      return length == 0 ? p : p + mpq_class((s - place(p)) / length) * (q - p);
    };
    const double span = mpq_class(high - low).get_d() / scale;
    if (span > 0x1p-50 && span < 0x1p-45) return "";  // either is right
    const double slope = std::max(e.slope, f.slope),
                 tolerance = (16 * 0x1p-53 * (1 + slope) + e.joined + f.joined) * scale;
    if (span < 0x1p-47) {
      if (m.count != 1) return "count";
      const double depth = m.depth0;
      return std::isfinite(depth) && m.depth1 == 0 ? "" : "depth";
    }
    const auto gap = [&](const mpq_class& s) { return along(at(e.p, e.q, s) - at(f.p, f.q, s)); };
    const double first = gap(low), second = gap(high), most = std::max(first, second);
    const double depth = std::max(m.depth0, m.depth1);
    if (std::fabs(most + radius_a + radius_b - depth) > tolerance + 16 * 0x1p-53 * (radius_a + radius_b + scale)) {
      return "depth " + std::to_string(most + radius_a + radius_b - depth);
    }
    const double less = depth - std::fabs(second - first);
    if (less > tolerance && m.count != 2) return "count";
    if (less < -0x1p-46 * scale - tolerance && m.count != 1) return "count";
    const bool from_low = m.count == 2 || first >= second;
    if (m.count == 2) {
      if (std::fabs(std::max(less, 0.0) - std::min(m.depth0, m.depth1)) > tolerance + 0x1p-48 * scale) return "less";
      const bool clear = m.depth0 != m.depth1 && std::fabs(first - second) > tolerance;
      if (clear && (m.depth0 > m.depth1) != (first > second)) return "order";
      if (m.a0 != e.from || m.b0 != f.to || m.a1 != e.to || m.b1 != f.from) return "numbers";
      const std::string wrong = point(m.x1, m.y1, at(e.p, e.q, high), at(f.p, f.q, high), tolerance);
      if (!wrong.empty()) return wrong;
    } else if (std::fabs(first - second) > tolerance) {
      if (m.a0 != (from_low ? e.from : e.to) || m.b0 != (from_low ? f.to : f.from)) return "numbers of one";
    } else {
      return "";
    }
    const mpq_class s = from_low ? low : high;
    return point(m.x0, m.y0, at(e.p, e.q, s), at(f.p, f.q, s), tolerance);
  }

  /// A shape without an edge, and its only point.
  std::string operator()(const std::vector<Edge>& edges, const Exact& p, bool of_a) const {
    if (m.count != 1) return "count";
    if ((of_a ? m.a0 : m.b0) != 0) return "number";
    bool known = edges.empty();
    for (const Edge& e : edges) known = known || (of_a ? m.b0 : m.a0) == e.from;
    if (!known) return "number of the edge";
    const Exact beyond = mpq_class(of_a ? radius_a - m.depth0 / 2 : m.depth0 / 2 - radius_b) * n;
    const Exact off = exact(m.x0, m.y0) - (p + beyond);
    const double size = scale + std::max(std::fabs(m.x0), std::fabs(m.y0)) + radius_a + radius_b;
    return std::hypot(off.x.get_d(), off.y.get_d()) <= 16 * 0x1p-53 * size ? "" : "the point is off";
  }
};

inline std::string judge(const Shape& a, const Shape& b, const Manifold& m) {
  const Exact n = exact(m.nx, m.ny), across{-n.y, n.x};
  const double scale = scale_of(a, b);
  const std::vector<Edge> of_a = facing_edges(a, n, scale), of_b = facing_edges(b, Exact{-n.x, -n.y}, scale);
  const Judge ask{m, n, across, dot(n, n), a.radius(), b.radius(), scale};
  if (of_b.empty()) return ask(of_a, b.corners()[0], false);
  if (of_a.empty()) return ask(of_b, a.corners()[0], true);
  std::string all;
  for (const Edge& e : of_a) {
    for (const Edge& f : of_b) {
      const std::string wrong = ask(e, f);
      if (wrong.empty()) return wrong;
      all += " edges " + std::to_string(e.from) + " and " + std::to_string(f.from) + ": " + wrong;
    }
  }
  return all;
}

inline std::string describe(const Shape& s) {
  std::string text = "\n kind " + std::to_string(s.kind);
  char number[40];
  for (const double x : s.kind == VESICA_POLYGON ? s.path.xy : s.numbers) {
    std::snprintf(number, sizeof number, " %a", x);
    text += number;
  }
  return text;
}

inline Shape polygon(const Path& path) {
  Shape s{VESICA_POLYGON, {}, path, {}};
  s.view = s.path.view();
  return s;
}

struct Seen {
  int one = 0, two = 0;
};

inline void expect_definition(Shape a, Shape b, Seen& seen) {
  // The vertices may have been moved with the shape.
  a.view = a.path.view(), b.view = b.path.view();
  vesica_penetration_f64 d;
  Manifold m;
  const std::int32_t error = vesica_depth_f64(a.kind, a.data(), b.kind, b.data(), &d);
  const std::int32_t count = vesica_manifold_f64(a.kind, a.data(), b.kind, b.data(), &m);
  const std::string what = describe(a) + describe(b);
  if (error != 0) {
    ASSERT_EQ(count, error) << what;
    return;
  }
  ASSERT_EQ(count, m.count) << what;
  ASSERT_EQ(count > 0, d.x != 0 || d.y != 0) << what;
  ASSERT_TRUE(m.nx == d.x && m.ny == d.y && std::max(m.depth0, m.depth1) == d.depth) << what;
  if (count == 0) return;
  ++(count == 1 ? seen.one : seen.two);
  const std::string wrong = judge(a, b, m);
  ASSERT_EQ(wrong, "") << what << "\n n " << m.nx << ' ' << m.ny << " count " << count << " depths " << m.depth0 << ' '
                       << m.depth1 << " at " << m.x0 << ' ' << m.y0 << " and " << m.x1 << ' ' << m.y1 << " numbers "
                       << m.a0 << ' ' << m.b0 << ' ' << m.a1 << ' ' << m.b1;
}

/// About a place, along a direction, of moderate size; nearly level if the angle is small.
inline Shape row(std::int32_t kind, double x, double y, double angle, Random& random) {
  const double c = std::cos(angle), s = std::sin(angle), w = random.between(0.2, 2), h = random.between(0.2, 2),
               r = random.between(0, 0.5), axis = random.chance(0.5) ? 1 : random.between(0.1, 10);
  switch (kind) {
    case VESICA_POINT:
      return {kind, {x, y}, {}, {}};
    case VESICA_SEGMENT:
      return {kind, {x - w * c, y - w * s, x + w * c, y + w * s}, {}, {}};
    case VESICA_CIRCLE:
      return {kind, {x, y, w}, {}, {}};
    case VESICA_AABB:
      return {kind, {x - w, y - h, x + w, y + h}, {}, {}};
    case VESICA_RECT:
      return {kind, {x, y, axis * c, axis * s, w / axis, h / axis}, {}, {}};
    case VESICA_CAPSULE:
      return {kind, {x - w * c, y - w * s, x + w * c, y + w * s, r}, {}, {}};
    default:
      return {kind, {x, y, axis * c, axis * s, w / axis, h / axis, r}, {}, {}};
  }
}

constexpr std::int32_t straight[] = {VESICA_POINT, VESICA_SEGMENT, VESICA_CIRCLE,    VESICA_AABB,
                                     VESICA_RECT,  VESICA_CAPSULE, VESICA_ROUND_RECT};

TEST(ManifoldDefinition, RowsOfNumbers) {
  Random random(properties::seed());
  Seen seen;
  for (int i = 0; i < 20'000 * properties::repeat() && !testing::Test::HasFatalFailure(); ++i) {
    const std::int32_t ka = straight[random.below(7)], kb = straight[random.below(7)];
    const double near[] = {0, 1e-3, 1e-9, 1e-15, 3}, turn = near[random.below(5)],
                 quarter = random.below(4) * std::acos(0.0);
    const double level = random.chance(0.5) ? 0 : random.between(0, 6);
    Shape a = row(ka, random.between(-1, 1), random.between(-1, 1), level + turn * random.between(-1, 1), random);
    Shape b =
        row(kb, random.between(-1, 1), random.between(-1, 1), level + quarter + turn * random.between(-1, 1), random);
    const double lift = random.chance(0.7) ? 0 : random.chance(0.5) ? 1e9 : 0x1p40;
    for (Shape* s : {&a, &b}) {
      s->numbers[0] += lift;
      if (s->kind == VESICA_SEGMENT || s->kind == VESICA_CAPSULE || s->kind == VESICA_AABB) s->numbers[2] += lift;
    }
    expect_definition(a, b, seen);
  }
  EXPECT_TRUE(!properties::draws_all() || (seen.one > 3'000 && seen.two > 3'000)) << seen.one << ' ' << seen.two;
}

/// Boxes one on another, with or without a radius, up to a few units in the last place.
TEST(ManifoldDefinition, Stacked) {
  Random random(properties::seed());
  Seen seen;
  for (int i = 0; i < 5'000 * properties::repeat() && !testing::Test::HasFatalFailure(); ++i) {
    const double angle = random.between(0, 7), c = std::cos(angle), s = std::sin(angle), w = random.between(0.1, 3),
                 h = random.between(0.1, 3), r = random.chance(0.5) ? 0 : random.between(0, 1),
                 sunk = random.between(0, 1e-3);
    const double aside = random.chance(0.4) ? 0 : random.chance(0.5) ? 2 * w : random.between(-2.2, 2.2) * w;
    const double up = 2 * h + 2 * r - (random.chance(0.3) ? 0 : sunk);
    Shape a{VESICA_ROUND_RECT, {0.3, 0.2, c, s, w, h, r}, {}, {}};
    Shape b{VESICA_ROUND_RECT, {0.3 + aside * c - up * s, 0.2 + aside * s + up * c, c, s, w, h, r}, {}, {}};
    if (random.chance(0.5)) {
      for (double& x : b.numbers) x = x == 0 ? 0 : polygons::nudged(x, random);
    }
    if (r == 0) a.kind = b.kind = VESICA_RECT, a.numbers.pop_back(), b.numbers.pop_back();
    expect_definition(a, b, seen);
  }
  EXPECT_TRUE(!properties::draws_all() || (seen.one > 100 && seen.two > 1'000)) << seen.one << ' ' << seen.two;
}

/// Thin, far and tiny ones too, that share vertices and edges.
TEST(ManifoldDefinition, Polygons) {
  Random random(properties::seed());
  Seen seen;
  for (int i = 0; i < 10'000 * properties::repeat() && !testing::Test::HasFatalFailure(); ++i) {
    polygons::Two pair;
    if (polygons::convex_pair(pair, random)) expect_definition(polygon(pair.a), polygon(pair.b), seen);
  }
  EXPECT_TRUE(!properties::draws_all() || (seen.one > 300 && seen.two > 3'000)) << seen.one << ' ' << seen.two;
}

TEST(ManifoldDefinition, PolygonsAndRows) {
  Random random(properties::seed());
  Seen seen;
  for (int i = 0; i < 10'000 * properties::repeat() && !testing::Test::HasFatalFailure(); ++i) {
    const std::vector<Corner> ring = polygons::convex(random.chance(0.5), random);
    if (ring.size() < 3) continue;
    Shape a = polygon(polygons::path_of(ring));
    Shape b =
        row(straight[random.below(7)], random.between(-1, 2), random.between(-1, 2), random.between(0, 7), random);
    if (random.chance(0.5)) std::swap(a, b);
    expect_definition(a, b, seen);
  }
  EXPECT_TRUE(!properties::draws_all() || (seen.one > 1'000 && seen.two > 1'000)) << seen.one << ' ' << seen.two;
}

}  // namespace manifold_definition

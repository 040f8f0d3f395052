// SPDX-License-Identifier: Apache-2.0
// Shapes with a radius that move: answers and times against rational numbers, and the laws of casts.
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <vesica_motion.h>
#include <vesica_topology.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>

#include "inflated/shapes.hpp"

namespace inflated_cast {
namespace {

using namespace inflated;
using properties::Random;

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Result {
  std::int32_t code;
  vesica_impact_f64 at;
};
Result cast(const Shape& a, const Shape& b, double vx, double vy, double end) {
  Result r{0, {7, 7, 7, 7, 7}};
  r.code = vesica_cast_f64(a.kind, a.number.data(), b.kind, b.number.data(), vx, vy, end, &r.at);
  return r;
}

struct Vector {
  mpq_class x, y;
};
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
mpq_class dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }
mpq_class cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }

/// The corners of a core, in order around it.
std::vector<Vector> corners(const Shape& s) {
  const Shape k = core(s);
  const auto& n = k.number;
  if (k.kind == VESICA_POINT) return {{n[0], n[1]}};
  if (k.kind == VESICA_SEGMENT) return {{n[0], n[1]}, {n[2], n[3]}};
  if (k.kind == VESICA_AABB) return {{n[0], n[1]}, {n[2], n[1]}, {n[2], n[3]}, {n[0], n[3]}};
  const mpq_class ax = mpq_class(n[4]) * n[2], ay = mpq_class(n[4]) * n[3], bx = mpq_class(n[5]) * -n[3],
                  by = mpq_class(n[5]) * n[2];
  std::vector<Vector> out;
  for (const int turn : {0, 1, 2, 3}) {
    const int i = turn == 0 || turn == 3 ? 1 : -1, j = turn < 2 ? 1 : -1;
    out.push_back({n[0] + i * ax + j * bx, n[1] + i * ay + j * by});
  }
  return out;
}

mpq_class squared_distance(const Vector& p, const Vector& from, const Vector& to) {
  const Vector along = to - from, way = p - from;
  const mpq_class length = dot(along, along), place = dot(along, way);
  if (length == 0 || place <= 0) return dot(way, way);
  if (place >= length) return dot(p - to, p - to);
  const mpq_class across = cross(along, way);
  return across * across / length;
}
/// The squared distance of two segments.
mpq_class squared_distance(const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
  const auto side = [](const Vector& p, const Vector& q, const Vector& r) { return sgn(cross(q - p, r - p)); };
  if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return 0;
  mpq_class least = squared_distance(a, c, d);
  for (const mpq_class& other : {squared_distance(b, c, d), squared_distance(c, a, b), squared_distance(d, a, b)}) {
    if (other < least) least = other;
  }
  return least;
}

/// Two shapes, b moving. Cores that overlap at the start are not looked for: then no edge of one need meet the other.
class Truth {
 public:
  Truth(const Shape& a, const Shape& b, double vx, double vy) : v_{vx, vy} {
    const auto p = corners(a), q = corners(b);
    for (std::size_t i = 0; i < p.size(); ++i) {
      for (std::size_t j = 0; j < q.size(); ++j) {
        add(p[i] - q[j], p[(i + 1) % p.size()] - q[j]);
        add(p[i] - q[j], p[i] - q[(j + 1) % q.size()]);
      }
    }
    const mpq_class radius = mpq_class(radius_of(a)) + radius_of(b);
    squared_ = radius * radius;
  }
  /// The sign of the least distance of b from a up to a time, less the radii.
  int gap_until(const mpq_class& time) const {
    const Vector end{time * v_.x, time * v_.y};
    mpq_class least = -1;
    for (const auto& [from, to] : edges_) {
      const mpq_class squared = squared_distance({0, 0}, end, from, to);
      if (least < 0 || squared < least) least = squared;
    }
    return cmp(least, squared_);
  }

 private:
  static double radius_of(const Shape& s) { return radius(s); }
  void add(const Vector& from, const Vector& to) { edges_.push_back({from, to}); }

  struct Edge {
    Vector from, to;
  };
  std::vector<Edge> edges_;
  Vector v_;
  mpq_class squared_;
};

/// How far a point is from a core that was moved, in long double.
long double core_distance(const Shape& s, long double x, long double y) {
  const auto p = corners(s);
  const Vector at{mpq_class(static_cast<double>(x)), mpq_class(static_cast<double>(y))};
  mpq_class least = -1;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const mpq_class squared = squared_distance(at, p[i], p[(i + 1) % p.size()]);
    if (least < 0 || squared < least) least = squared;
  }
  return std::sqrt(static_cast<long double>(least.get_d()));
}

/// Small multiples of a power of two, sizes of 0 included: contact is often exact.
Shape lattice_shape(std::int32_t kind, Random& random) {
  constexpr std::array<std::array<int, 2>, 6> axes{{{1, 0}, {0, 1}, {3, 4}, {-4, 3}, {2, 1}, {1, -1}}};
  const auto place = [&] { return random.integer(-12, 12) * 0.5; };
  const auto size = [&] { return random.integer(0, 8) * 0.25; };
  const double x = place(), y = place();
  const auto& axis = axes[static_cast<std::size_t>(random.below(6))];
  switch (kind) {
    case VESICA_POINT:
      return {kind, {x, y}};
    case VESICA_SEGMENT:
      return {kind, {x, y, place(), place()}};
    case VESICA_CIRCLE:
      return {kind, {x, y, size()}};
    case VESICA_AABB:
      return {kind, {x, y, x + size(), y + size()}};
    case VESICA_CAPSULE:
      return {kind, {x, y, place(), place(), size()}};
    default:
      return {kind,
              {x, y, static_cast<double>(axis[0]), static_cast<double>(axis[1]), size(), size(),
               kind == VESICA_ROUND_RECT ? size() : 0}};
  }
}

struct Tally {
  int missed = 0, hit = 0, started = 0;
};

/// Returns the result after comparing it with the truth.
Result expect_exact(const Shape& a, const Shape& b, double vx, double vy, double end, Tally& tally) {
  const Result r = cast(a, b, vx, vy, end);
  const bool start = vesica_overlap_f64(a.kind, a.number.data(), b.kind, b.number.data()) == 1;
  EXPECT_EQ(r.code == VESICA_CAST_START, start);
  if (start) {
    ++tally.started;
    return r;
  }
  const Truth truth(a, b, vx, vy);
  EXPECT_GT(truth.gap_until(0), 0);
  EXPECT_EQ(r.code, truth.gap_until(end == infinity ? mpq_class(1000) : mpq_class(end)) <= 0 ? VESICA_CAST_HIT
                                                                                             : VESICA_CAST_MISS);
  if (r.code != VESICA_CAST_HIT) {
    ++tally.missed;
    EXPECT_EQ(r.at.t, infinity);
    EXPECT_TRUE(std::isnan(r.at.x));
    return r;
  }
  ++tally.hit;
  // No contact before t: the gap up to t is at least 0. A number later there is contact before it, or there is at t.
  const int at_t = truth.gap_until(r.at.t), next = truth.gap_until(std::nextafter(r.at.t, infinity));
  EXPECT_GE(at_t, 0);
  // A way that only grazes has no contact but that of outlines.
  const bool grazes = truth.gap_until(1000) == 0;
  EXPECT_TRUE(at_t == 0 || next < 0 || (grazes && next == 0)) << at_t << next;
  // The point is on a, and on b where it is then; the normal leads from one core to the other.
  const long double t = r.at.t, back_x = r.at.x - t * vx, back_y = r.at.y - t * vy;
  EXPECT_NEAR(std::hypot(r.at.nx, r.at.ny), 1, 4 * 0x1p-53);
  EXPECT_NEAR(static_cast<double>(core_distance(a, r.at.x, r.at.y)), radius(a), 0x1p-46);
  EXPECT_NEAR(static_cast<double>(core_distance(b, back_x, back_y)), radius(b), 0x1p-40);
  EXPECT_LE(r.at.nx * vx + r.at.ny * vy, 0x1p-40);
  return r;
}

TEST(InflatedCast, IsExact) {
  Random random(properties::seed());
  Tally tally;
  for (int i = 0; i < 8000 * properties::repeat(); ++i) {
    static constexpr std::array<std::int32_t, 7> others{VESICA_POINT, VESICA_SEGMENT, VESICA_CIRCLE,    VESICA_AABB,
                                                        VESICA_RECT,  VESICA_CAPSULE, VESICA_ROUND_RECT};
    const Shape a = lattice_shape(others[static_cast<std::size_t>(random.below(7))], random);
    const Shape b = lattice_shape(kinds[static_cast<std::size_t>(random.below(2))], random);
    const double vx = random.integer(-4, 4), vy = random.integer(-4, 4);
    const double end = random.below(3) == 0 ? infinity : random.integer(0, 16) * 0.25;
    SCOPED_TRACE(i);
    const Result r = expect_exact(a, b, vx, vy, end, tally);
    const Result swapped = cast(b, a, -vx, -vy, end);
    ASSERT_EQ(swapped.code, r.code);
    if (r.code != VESICA_CAST_HIT) continue;
    ASSERT_EQ(swapped.at.t, r.at.t);
    ASSERT_EQ(cast(a, b, 2 * vx, 2 * vy, infinity).at.t, r.at.t / 2);
    ASSERT_EQ(cast(a, b, vx, vy, r.at.t + 100).at.t, r.at.t);
    if (HasFailure()) return;
  }
  EXPECT_GT(tally.hit, 100 * properties::repeat());
  EXPECT_GT(tally.missed, 100 * properties::repeat());
  EXPECT_GT(tally.started, 100 * properties::repeat());
}

/// Any numbers, at ways that pass near the rim.
TEST(InflatedCast, IsExactForAnyNumbers) {
  Random random(properties::seed());
  Tally tally;
  for (int i = 0; i < 2000 * properties::repeat(); ++i) {
    Shape a = any_shape(random, 5), b = inflated_shape(random);
    if (random.below(3) == 0) a = inflated_shape(random);
    const double turn = random.between(-4, 4);
    SCOPED_TRACE(i);
    expect_exact(a, b, std::cos(turn), std::sin(turn), random.below(2) == 0 ? infinity : random.between(0, 4), tally);
    if (HasFailure()) return;
  }
  EXPECT_GT(tally.hit, 50 * properties::repeat());
  EXPECT_GT(tally.missed, 50 * properties::repeat());
}

/// At the last place of 40 bits before the time there is no contact, and at the next one there is.
TEST(InflatedCast, OfAnEllipseIsThatOfTheExactOverlap) {
  Random random(properties::seed());
  int hits = 0;
  for (int i = 0; i < 4000 * properties::repeat(); ++i) {
    Shape a = lattice_shape(VESICA_RECT, random);
    a.kind = VESICA_ELLIPSE;
    a.number[4] += 0.25, a.number[5] += 0.25;
    const Shape b = lattice_shape(kinds[static_cast<std::size_t>(random.below(2))], random);
    const double vx = random.integer(-4, 4), vy = random.integer(-4, 4);
    const Result r = cast(a, b, vx, vy, infinity), swapped = cast(b, a, -vx, -vy, infinity);
    ASSERT_EQ(r.code, swapped.code) << i;
    const auto overlaps_at = [&](double t) {
      Shape c = b;
      for (std::size_t k = 0; k < (b.kind == VESICA_CAPSULE ? 4 : 2); k += 2) {
        c.number[k] += t * vx;
        c.number[k + 1] += t * vy;
      }
      return vesica_overlap_f64(a.kind, a.number.data(), c.kind, c.number.data());
    };
    ASSERT_EQ(overlaps_at(0) == 1, r.code == VESICA_CAST_START) << i;
    if (r.code == VESICA_CAST_MISS) {
      for (int k = 1; k < 64; ++k) ASSERT_EQ(overlaps_at(k * 0.25), 0) << i;
      continue;
    }
    if (r.code != VESICA_CAST_HIT) continue;
    ++hits;
    ASSERT_EQ(r.at.t, swapped.at.t) << i;
    const double before = std::floor(r.at.t * 0x1p40) * 0x1p-40, after = before + 0x1p-40;
    if (before < r.at.t) {
      ASSERT_EQ(overlaps_at(before), 0) << i;
    }
    // A way that only grazes has contact at one time alone; past an ellipse that is a little smaller it has none.
    Shape smaller = a;
    smaller.number[4] *= 1 - 0x1p-30, smaller.number[5] *= 1 - 0x1p-30;
    const bool grazes = cast(smaller, b, vx, vy, infinity).code == VESICA_CAST_MISS;
    ASSERT_TRUE(grazes || overlaps_at(after) == 1) << i << " " << r.at.t;
    ASSERT_NEAR(std::hypot(r.at.nx, r.at.ny), 1, 4 * 0x1p-53);
    const Shape point{VESICA_POINT, {r.at.x, r.at.y}};
    vesica_closest_points_f64 near;
    ASSERT_EQ(vesica_boundary_distance_f64(VESICA_POINT, point.number.data(), a.kind, a.number.data(), &near), 0);
    ASSERT_LE(near.distance, 0x1p-44) << i;
  }
  EXPECT_GT(hits, 100 * properties::repeat());
}

/// An ellipse that is a circle has its times to the bit.
TEST(InflatedCast, OfACircleAsAnEllipse) {
  Random random(properties::seed());
  int hits = 0;
  for (int i = 0; i < 20000 * properties::repeat(); ++i) {
    const Shape circle = shape(VESICA_CIRCLE, random), b = inflated_shape(random);
    const Shape ellipse{VESICA_ELLIPSE, {circle.number[0], circle.number[1], 1, 0, circle.number[2], circle.number[2]}};
    const double turn = random.between(-4, 4), vx = std::cos(turn), vy = std::sin(turn);
    const Result r = cast(circle, b, vx, vy, 8), s = cast(ellipse, b, vx, vy, 8);
    ASSERT_EQ(r.code, s.code) << i;
    if (r.code != VESICA_CAST_HIT) continue;
    ++hits;
    ASSERT_EQ(r.at.t, s.at.t) << i;
    ASSERT_NEAR(r.at.x, s.at.x, 0x1p-44);
    ASSERT_NEAR(r.at.nx, s.at.nx, 0x1p-44);
  }
  EXPECT_GT(hits, 100 * properties::repeat());
}

/// Without a radius the core's answer, without a size a circle's, to the bit.
TEST(InflatedCast, IsThatOfTheSimplestKind) {
  Random random(properties::seed());
  for (int i = 0; i < 5000 * properties::repeat(); ++i) {
    Shape a = inflated_shape(random);
    const Shape b = any_shape(random);
    Shape simple;
    if (random.below(2) == 0) {
      a.number[a.kind == VESICA_CAPSULE ? 4 : 6] = 0;
      simple = core(a);
    } else {
      if (a.kind == VESICA_CAPSULE) a.number[2] = a.number[0], a.number[3] = a.number[1];
      if (a.kind == VESICA_ROUND_RECT) a.number[4] = a.number[5] = 0;
      simple = {VESICA_CIRCLE, {a.number[0], a.number[1], radius(a)}};
    }
    const double turn = random.between(-4, 4), vx = std::cos(turn), vy = std::sin(turn);
    const Result r = cast(a, b, vx, vy, infinity), s = cast(simple, b, vx, vy, infinity);
    ASSERT_EQ(r.code, s.code) << i;
    if (r.code != VESICA_CAST_HIT) continue;
    ASSERT_EQ((std::array{r.at.t, r.at.x, r.at.y, r.at.nx, r.at.ny}),
              (std::array{s.at.t, s.at.x, s.at.y, s.at.nx, s.at.ny}))
        << i;
  }
}

TEST(InflatedCast, KnownContacts) {
  const Shape bar{VESICA_CAPSULE, {0, 0, 10, 0, 1}};
  const auto expect = [&](const Shape& b, double vx, double vy, const std::array<double, 5>& at) {
    const Result r = cast(bar, b, vx, vy, infinity);
    EXPECT_EQ(r.code, VESICA_CAST_HIT);
    EXPECT_EQ((std::array{r.at.t, r.at.x, r.at.y, r.at.nx, r.at.ny}), at) << b.kind;
  };
  expect({VESICA_POINT, {12, 5}}, -1, -2, {2, 10, 1, 0, 1});
  expect({VESICA_POINT, {20, 0}}, -3, 0, {3, 11, 0, 1, 0});
  expect({VESICA_CAPSULE, {5, 10, 7, 14, 0.5}}, 0, -1, {8.5, 5, 1, 0, 1});
  expect({VESICA_ROUND_RECT, {15, 0, 0, 1, 2, 1, 0.5}}, -1, 0, {2.5, 11, 0, 1, 0});
  // Two stretches that meet: the middle of what they share.
  expect({VESICA_CAPSULE, {8, 9, 14, 9, 1}}, 0, -1, {7, 9, 1, 0, 1});
  expect({VESICA_ELLIPSE, {5, 10, 1, 0, 4, 2}}, 0, -1, {7, 5, 1, 0, 1});
  // Past each other by the least number, and along the rim.
  const double above = std::nextafter(2.0, 3.0);
  EXPECT_EQ(cast(bar, {VESICA_CIRCLE, {20, above, 1}}, -1, 0, infinity).code, VESICA_CAST_MISS);
  EXPECT_EQ(cast(bar, {VESICA_CIRCLE, {20, 2, 1}}, -1, 0, infinity).at.t, 10);
  EXPECT_EQ(cast(bar, {VESICA_CIRCLE, {20, 2, 1}}, -1, 0, std::nextafter(10.0, 0)).code, VESICA_CAST_MISS);
}

/// The same answers, scaled, wherever numbers are neither subnormal nor infinite; and any scale gives an answer.
TEST(InflatedCast, AtAnyScale) {
  Random random(properties::seed());
  for (int i = 0; i < 300 * properties::repeat(); ++i) {
    const Shape a = lattice_shape(VESICA_ROUND_RECT, random), b = lattice_shape(VESICA_CAPSULE, random);
    const double vx = random.integer(-4, 4), vy = random.integer(-4, 4);
    const Result r = cast(a, b, vx, vy, infinity);
    for (const int exponent : {-1060, -400, 400, 1010}) {
      const auto scaled = [exponent](Shape s) {
        for (std::size_t k = 0; k < 7; ++k) {
          const bool of_axis = s.kind == VESICA_ROUND_RECT && k >= 2 && k < 4;
          if (!of_axis) s.number[k] = std::ldexp(s.number[k], exponent);
        }
        return s;
      };
      const double wx = std::ldexp(vx, exponent), wy = std::ldexp(vy, exponent);
      const Result s = cast(scaled(a), scaled(b), wx, wy, infinity);
      ASSERT_EQ(s.code, r.code) << i << " " << exponent;
      if (r.code != VESICA_CAST_HIT) continue;
      ASSERT_EQ(s.at.t, r.at.t) << i << " " << exponent;
      ASSERT_NEAR(s.at.nx, r.at.nx, 0x1p-50);
    }
  }
}

Result cast_floats(const Shape& a, const Shape& b, float vx, float vy, float end) {
  std::array<float, 7> p, q;
  std::ranges::transform(a.number, p.begin(), [](double x) { return static_cast<float>(x); });
  std::ranges::transform(b.number, q.begin(), [](double x) { return static_cast<float>(x); });
  vesica_impact_f32 at{};
  const std::int32_t code = vesica_cast_f32(a.kind, p.data(), b.kind, q.data(), vx, vy, end, &at);
  return {code, {at.t, at.x, at.y, at.nx, at.ny}};
}

void expect_same(const Result& found, const Result& expected) {
  const std::array p{found.at.t, found.at.x, found.at.y, found.at.nx, found.at.ny};
  const std::array q{expected.at.t, expected.at.x, expected.at.y, expected.at.nx, expected.at.ny};
  for (std::size_t k = 0; k < 5; ++k) EXPECT_TRUE(p[k] == q[k] || (std::isnan(p[k]) && std::isnan(q[k])));
}

constexpr int count = 301;  // not a multiple of any vector

TEST(InflatedCast, ArraysAsSingleCalls) {
  Random random(properties::seed());
  for (std::int32_t kind = 0; kind < 8; ++kind) {
    for (const std::int32_t other : kinds) {
      for (const bool exchanged : {false, true}) {
        const Columns<double> first(exchanged ? other : kind, count, random),
            second(exchanged ? kind : other, count, random);
        const Columns<float> p(first.kind, count, random), q(second.kind, count, random);
        const auto a = array(first), b = array(second);
        const auto c = array(p), d = array(q);
        std::vector<double> vx(count), vy(count), column[5];
        std::vector<float> wx(count), wy(count), floats[5];
        for (auto& x : column) x.resize(count);
        for (auto& x : floats) x.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
          wx[i] = static_cast<float>(vx[i] = random.between(-2, 2));
          wy[i] = static_cast<float>(vy[i] = random.between(-2, 2));
        }
        std::int64_t touched = 0, of_floats = 0;
        const std::int64_t found =
            vesica_cast_many_f64(&a, &b, vx.data(), vy.data(), sizeof(double), 2, column[0].data(), column[1].data(),
                                 column[2].data(), column[3].data(), column[4].data());
        const std::int64_t found_floats =
            vesica_cast_many_f32(&c, &d, wx.data(), wy.data(), sizeof(float), 2, floats[0].data(), floats[1].data(),
                                 floats[2].data(), floats[3].data(), floats[4].data());
        for (std::size_t i = 0; i < count; ++i) {
          SCOPED_TRACE(i);
          const Result one = cast(first.at(i), second.at(i), vx[i], vy[i], 2);
          touched += one.code;
          if (one.code == VESICA_CAST_START) --touched;
          expect_same({0, {column[0][i], column[1][i], column[2][i], column[3][i], column[4][i]}}, one);
          const Result single = cast_floats(p.at(i), q.at(i), wx[i], wy[i], 2);
          of_floats += single.code > 0;
          expect_same({0, {floats[0][i], floats[1][i], floats[2][i], floats[3][i], floats[4][i]}}, single);
        }
        ASSERT_EQ(found, touched);
        ASSERT_EQ(found_floats, of_floats);
        ASSERT_FALSE(HasFailure()) << kind << ", " << other;
      }
    }
  }
}

TEST(InflatedCast, FirstOfManyAndThroughAnIndex) {
  Random random(properties::seed());
  std::vector<Columns<double>> columns;
  for (std::int32_t kind = 0; kind < 8; ++kind) columns.emplace_back(kind, 50, random);
  std::vector<vesica_shapes_f64> sets;
  for (const auto& c : columns) sets.push_back(array(c));
  const std::unique_ptr<void, decltype(&std::free)> index(std::aligned_alloc(64, 1 << 20), std::free),
      scratch(std::aligned_alloc(64, 1 << 20), std::free);
  ASSERT_GT(vesica_index_build_f64(sets.data(), 8, index.get(), vesica_index_size(400), scratch.get(),
                                   vesica_index_scratch(400)),
            0);
  int hits = 0;
  for (int i = 0; i < 200 * properties::repeat(); ++i) {
    const std::int32_t kind = i % 4 == 0 ? random.below(6) : kinds[static_cast<std::size_t>(i % 2)];
    Columns<double> moving(kind, 1, random);
    const double turn = random.between(-4, 4), vx = std::cos(turn), vy = std::sin(turn);
    for (std::size_t k = 0; k < 2; ++k) {
      const double away = 6 * (k == 0 ? vx : vy);
      moving.column[k][0] -= away;
      const bool has_ends = kind == VESICA_SEGMENT || kind == VESICA_AABB || kind == VESICA_CAPSULE;
      if (has_ends) moving.column[k + 2][0] -= away;
    }
    const auto one = array(moving);
    std::vector<std::int64_t> expected, out(400);
    std::int64_t first = 400;
    Result best{0, {infinity, 0, 0, 0, 0}};
    for (std::size_t k = 0; k < 400; ++k) {
      const Result r = cast(columns[k / 50].at(k % 50), moving.at(0), vx, vy, 8);
      if (r.code == VESICA_CAST_MISS) continue;
      expected.push_back(static_cast<std::int64_t>(k));
      if (r.at.t < best.at.t) first = static_cast<std::int64_t>(k), best = r;
    }
    vesica_impact_f64 at{};
    ASSERT_EQ(vesica_index_cast_first_f64(index.get(), sets.data(), 8, &one, vx, vy, 8, &at), first);
    if (first < 400) {
      ++hits;
      expect_same({0, at}, best);
    }
    std::int64_t state[16] = {};
    const std::int64_t n = vesica_index_cast_f64(index.get(), sets.data(), 8, &one, vx, vy, 8, out.data(), 400, state);
    ASSERT_EQ(n, static_cast<std::int64_t>(expected.size()));
    out.resize(expected.size());
    std::ranges::sort(out);
    ASSERT_EQ(out, expected);
    const std::int64_t of_set = vesica_cast_first_f64(&one, &sets[6], vx, vy, 8, &at);
    for (std::int64_t k = 0; k < 50; ++k) {
      const Result r = cast(columns[6].at(static_cast<std::size_t>(k)), moving.at(0), vx, vy, 8);
      ASSERT_TRUE(of_set == 50 ? r.code == VESICA_CAST_MISS : r.at.t >= at.t);
      if (k == of_set) expect_same({0, at}, r);
    }
  }
  EXPECT_GT(hits, 20 * properties::repeat());
}

/// One invalid element gets NaN, and its neighbours their answers.
TEST(InflatedCast, AnInvalidElement) {
  Random random(properties::seed());
  Columns<double> bars(VESICA_CAPSULE, 20, random);
  const Columns<double> points(VESICA_POINT, 20, random);
  bars.column[4][7] = -1;
  const auto a = array(bars), b = array(points);
  const double vx = 1, vy = 0.5;
  std::vector<double> t(20);
  EXPECT_EQ(vesica_cast_many_f64(&a, &b, &vx, &vy, 0, infinity, t.data(), nullptr, nullptr, nullptr, nullptr),
            VESICA_E_SHAPE);
  for (std::size_t i = 0; i < 20; ++i) {
    const double one = cast(bars.at(i), points.at(i), vx, vy, infinity).at.t;
    EXPECT_TRUE(i == 7 ? std::isnan(t[i]) : t[i] == one) << i;
  }
}

/// The box holds the capsule at the end of its way, and where it was.
TEST(InflatedCast, SweptBounds) {
  const vesica_capsule_f64 bar{0, 0, 3, 4, 0.5};
  vesica_aabb_f64 box;
  ASSERT_EQ(vesica_sweep_bounds_f64(VESICA_CAPSULE, &bar, 2, 0, 5, &box), 0);
  EXPECT_EQ(box.min_x, -0.5);
  EXPECT_EQ(box.min_y, -0.5);
  EXPECT_NEAR(box.max_x, 13.5, 1e-14);
  EXPECT_GE(box.max_x, 13.5);
  EXPECT_EQ(box.max_y, 4.5);
}

TEST(InflatedCast, BadInput) {
  const Shape good{VESICA_CAPSULE, {0, 0, 1, 0, 1}}, point{VESICA_POINT, {9, 9}},
      ellipse{VESICA_ELLIPSE, {9, 9, 1, 0, 2, 1}};
  for (const Shape& bad :
       {Shape{VESICA_CAPSULE, {0, 0, 1, 0, -1}}, Shape{VESICA_CAPSULE, {0, 0, 0, 0, -1}},
        Shape{VESICA_CAPSULE, {0, 0, NAN, 0, 1}}, Shape{VESICA_CAPSULE, {0, 0, 1, 0, NAN}},
        Shape{VESICA_ROUND_RECT, {0, 0, 0, 0, 1, 1, 1}}, Shape{VESICA_ROUND_RECT, {0, 0, 0, 0, 0, 0, 1}},
        Shape{VESICA_ROUND_RECT, {0, 0, 1, 0, -1, 1, 0}}, Shape{VESICA_ROUND_RECT, {0, 0, 1, 0, 1, 1, infinity}}}) {
    for (const Shape& other : {good, point, ellipse}) {
      const Result r = cast(bad, other, 1, 0, 1), s = cast(other, bad, 1, 0, 1);
      EXPECT_EQ(r.code, VESICA_E_SHAPE);
      EXPECT_EQ(s.code, VESICA_E_SHAPE);
      EXPECT_EQ(r.at.t, 7);
    }
  }
  EXPECT_EQ(cast(good, point, NAN, 0, 1).code, VESICA_E_ARGUMENT);
  EXPECT_EQ(cast(good, point, 1, 0, -1).code, VESICA_E_ARGUMENT);
}

}  // namespace
}  // namespace inflated_cast

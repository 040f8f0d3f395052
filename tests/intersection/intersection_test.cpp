// SPDX-License-Identifier: Apache-2.0
/// Shared regions: the vertices and their order in exact rational numbers, accuracy, corners to the bit, known answers.
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <vesica.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>
#include <random>
#include <vector>
#include <vesica/intersection.hpp>

#include "capi/face.hpp"
#include "nearest/reference.hpp"
#include "oracle/oracle.hpp"
#include "properties/generators.hpp"
#include "properties/pairs_of_kinds.hpp"

namespace {

using properties::is_round;
using properties::Numbers;
using properties::Pair;
using properties::Scalar;

constexpr double u = 0x1p-53;

struct Vector {
  mpq_class x, y;
  bool operator==(const Vector& o) const { return x == o.x && y == o.y; }
};
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
mpq_class cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }
int turn(const Vector& a, const Vector& b, const Vector& c) { return sgn(cross(b - a, c - a)); }

using Polygon = std::vector<Vector>;

/// Corners of a straight shape, counter-clockwise, none twice.
Polygon polygon(int kind, const Numbers& n) {
  const auto q = [](double x) { return mpq_class(x); };
  if (kind == VESICA_POINT) return {{q(n[0]), q(n[1])}};
  if (kind == VESICA_SEGMENT) {
    const Vector a{q(n[0]), q(n[1])}, b{q(n[2]), q(n[3])};
    return a == b ? Polygon{a} : Polygon{a, b};
  }
  Vector c, along, across;
  if (kind == VESICA_AABB) {
    c = {(q(n[0]) + q(n[2])) / 2, (q(n[1]) + q(n[3])) / 2};
    along = {(q(n[2]) - q(n[0])) / 2, 0};
    across = {0, (q(n[3]) - q(n[1])) / 2};
  } else {
    c = {q(n[0]), q(n[1])};
    along = {q(n[4]) * q(n[2]), q(n[4]) * q(n[3])};
    across = {-q(n[5]) * q(n[3]), q(n[5]) * q(n[2])};
  }
  Polygon all;
  for (const auto& [s, t] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    const Vector v{c.x + s * along.x + t * across.x, c.y + s * along.y + t * across.y};
    if (std::find(all.begin(), all.end(), v) == all.end()) all.push_back(v);
  }
  return all;
}

std::size_t edges(const Polygon& p) { return p.size() == 1 ? 0 : p.size() == 2 ? 1 : 4; }
const Vector& end_of(const Polygon& p, std::size_t edge) { return p[(edge + 1) % p.size()]; }

bool contains(const Polygon& p, const Vector& v) {
  if (p.size() == 1) return p[0] == v;
  if (p.size() == 2) {
    const Vector a = v - p[0], b = v - p[1];
    return turn(p[0], p[1], v) == 0 && sgn(mpq_class(a.x * b.x + a.y * b.y)) <= 0;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    if (turn(p[i], end_of(p, i), v) < 0) return false;
  }
  return true;
}

void add(Polygon& p, const Vector& v) {
  if (std::find(p.begin(), p.end(), v) == p.end()) p.push_back(v);
}

/// The vertices of what two polygons share, in no order: corners of one in the other, and edges that cross.
Polygon shared(const Polygon& a, const Polygon& b) {
  Polygon all;
  for (const Vector& v : a) {
    if (contains(b, v)) add(all, v);
  }
  for (const Vector& v : b) {
    if (contains(a, v)) add(all, v);
  }
  for (std::size_t i = 0; i < edges(a); ++i) {
    for (std::size_t j = 0; j < edges(b); ++j) {
      const Vector &p = a[i], &q = end_of(a, i), &r = b[j], &s = end_of(b, j);
      if (turn(p, q, r) * turn(p, q, s) >= 0 || turn(r, s, p) * turn(r, s, q) >= 0) continue;
      const mpq_class t = cross(r - p, s - r) / cross(q - p, s - r);
      add(all, {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
    }
  }
  return all;
}

/// vesica_intersection of either scalar, as doubles.
struct Answer {
  std::int32_t count;
  std::array<double, 16> at;
};
Answer ask(Scalar scalar, const Pair& p) {
  Answer r{0, {}};
  r.at.fill(7);
  if (scalar == Scalar::f64) {
    r.count = capi_tests::intersection<double>(p.kind_a, p.a.data(), p.kind_b, p.b.data(), r.at.data());
  } else {
    const auto a = properties::narrow(p.a), b = properties::narrow(p.b);
    float at[16];
    std::fill_n(at, 16, 7.0f);
    r.count = capi_tests::intersection<float>(p.kind_a, a.data(), p.kind_b, b.data(), at);
    for (std::size_t i = 0; i < 16; ++i) r.at[i] = static_cast<double>(at[i]);
  }
  return r;
}

bool is_thin(int kind) { return kind <= VESICA_SEGMENT; }
bool is_bent(int kind) { return is_round(kind) || properties::is_inflated(kind); }
bool is_answered(int a, int b) { return (!is_bent(a) && !is_bent(b)) || is_thin(a) || is_thin(b); }

/// The greatest coordinate or size of either shape.
double largest(const Pair& p) {
  double most = 0;
  for (const auto& [kind, n] : {std::pair{p.kind_a, &p.a}, {p.kind_b, &p.b}}) {
    const bool sized = properties::has_axis(kind);
    for (std::size_t i = 0; i < (sized ? 2U : kind == VESICA_CIRCLE ? 3U : 4U); ++i)
      most = std::fmax(most, std::fabs((*n)[i]));
    if (sized) most = std::fmax(most, std::fmax((*n)[4], (*n)[5]) * std::hypot((*n)[2], (*n)[3]));
    if (properties::is_inflated(kind)) most = std::fmax(most, properties::radius(kind, *n));
  }
  return std::fmin(most, std::numeric_limits<double>::max());
}

/// The numbers that a shape's own corners have.
std::vector<std::array<double, 2>> own_corners(int kind, const Numbers& n) {
  if (kind == VESICA_POINT) return {{n[0], n[1]}};
  if (kind == VESICA_SEGMENT) return {{n[0], n[1]}, {n[2], n[3]}};
  if (kind == VESICA_AABB) return {{n[0], n[1]}, {n[2], n[1]}, {n[2], n[3]}, {n[0], n[3]}};
  if (kind != VESICA_RECT) return {};
  double c[8];
  vesica_shapes_f64 one;
  vesica_shapes_from_records_f64(VESICA_RECT, 1, n.data(), sizeof n, &one);
  if (vesica_corners_of_shapes_f64(&one, c) < 0) return {};
  return {{c[0], c[1]}, {c[2], c[3]}, {c[4], c[5]}, {c[6], c[7]}};
}

class Intersection : public testing::TestWithParam<properties::Kinds> {
 protected:
  bool narrow() const { return GetParam().scalar == Scalar::f32; }

  void check(const Pair& p) {
    SCOPED_TRACE(properties::describe(p));
    const Answer r = ask(GetParam().scalar, p), other = ask(GetParam().scalar, swapped(p));
    EXPECT_EQ(r.count, other.count);
    EXPECT_EQ(r.at, other.at);
    ++cases_;
    if (r.count == VESICA_E_RANGE) return;
    EXPECT_EQ(r.count > 0, oracle::overlap(p.kind_a, p.a.data(), p.kind_b, p.b.data()));
    met_ += r.count > 0;
    most_ = std::max(most_, r.count);
    for (std::size_t i = static_cast<std::size_t>(2 * r.count); i < 16; ++i) EXPECT_EQ(r.at[i], 0);
    for (std::size_t i = 1; i < static_cast<std::size_t>(r.count); ++i) {
      EXPECT_TRUE(r.at[2 * i + 1] > r.at[1] || (r.at[2 * i + 1] == r.at[1] && r.at[2 * i] >= r.at[0]));
    }
    if (is_bent(p.kind_b))
      check_round(p, r);
    else
      check_straight(p, r);
  }

  mpq_class allowed(const Pair& p, double x) const {
    const double rounding = narrow() ? std::fabs(x) * 0x1p-24 + 0x1p-149 : 0x1p-1074;
    return mpq_class(4 * u * largest(p)) + mpq_class(rounding);
  }

  /// Each a vertex of its own, and all of them counter-clockwise.
  void check_straight(const Pair& p, const Answer& r) {
    const Polygon exact = shared(polygon(p.kind_a, p.a), polygon(p.kind_b, p.b));
    ASSERT_EQ(static_cast<std::size_t>(r.count), exact.size());
    Polygon ordered = exact;
    if (exact.size() > 2) {
      std::sort(ordered.begin() + 1, ordered.end(),
                [&](const Vector& v, const Vector& w) { return turn(ordered[0], v, w) > 0; });
    }
    // From some vertex on they are the same, as near as is said.
    bool found = exact.empty();
    for (std::size_t shift = 0; shift < exact.size() && !found; ++shift) {
      found = true;
      for (std::size_t i = 0; i < exact.size() && found; ++i) {
        const Vector& v = ordered[(i + shift) % exact.size()];
        const double x = r.at[2 * i], y = r.at[2 * i + 1];
        found = abs(mpq_class(v.x - x)) <= allowed(p, x) && abs(mpq_class(v.y - y)) <= allowed(p, y);
      }
    }
    EXPECT_TRUE(found) << "not these vertices in this order";
    if (!narrow()) check_corners(p, r, exact);
  }

  /// A corner of one shape in the other is among the vertices, with its own numbers: of two at one place, one of them.
  void check_corners(const Pair& p, const Answer& r, const Polygon& exact) {
    for (const auto& [kind, n, other_kind, other] :
         {std::tuple{p.kind_a, &p.a, p.kind_b, &p.b}, {p.kind_b, &p.b, p.kind_a, &p.a}}) {
      const Polygon own = polygon(kind, *n), others = polygon(other_kind, *other);
      const auto numbers = own_corners(kind, *n);
      if (own.size() != numbers.size()) continue;
      for (std::size_t i = 0; i < own.size(); ++i) {
        if (!contains(others, own[i]) || std::find(others.begin(), others.end(), own[i]) != others.end()) continue;
        // The exact corners and the rounded ones begin at the same one.
        bool there = false;
        for (std::size_t k = 0; k < exact.size(); ++k) {
          there = there || (r.at[2 * k] == numbers[i][0] && r.at[2 * k + 1] == numbers[i][1]);
        }
        EXPECT_TRUE(there) << "corner " << i << " of kind " << kind;
        ++corners_;
      }
    }
  }

  /// One or two, on the segment and in the other shape, and ends that are in it to the bit.
  void check_round(const Pair& p, const Answer& r) {
    ASSERT_LE(r.count, 2);
    if (r.count == 0) return;
    nearest_reference::set_precision(p);
    const auto a = nearest_reference::shape(p.kind_a, p.a), b = nearest_reference::shape(p.kind_b, p.b);
    for (std::size_t i = 0; i < static_cast<std::size_t>(r.count); ++i) {
      const double x = r.at[2 * i], y = r.at[2 * i + 1];
      const nearest_reference::Real room(mpq_class(2 * (allowed(p, x) + allowed(p, y))));
      EXPECT_LE(nearest_reference::beyond_outline(a, x, y, room), room);
      EXPECT_LE(nearest_reference::beyond_outline(b, x, y, room), room);
    }
    for (const auto& end : own_corners(p.kind_a, p.a)) {
      const bool in = oracle::overlap(VESICA_POINT, end.data(), p.kind_b, p.b.data());
      bool there = false;
      for (std::size_t i = 0; i < static_cast<std::size_t>(r.count); ++i) {
        there = there || (r.at[2 * i] == end[0] && r.at[2 * i + 1] == end[1]);
      }
      if (in) {
        EXPECT_TRUE(there);
        ++corners_;
      }
    }
  }

  int cases_ = 0, met_ = 0, corners_ = 0, most_ = 0;
};

TEST_P(Intersection, EveryWorkload) {
  std::printf("VESICA_SEED=%llu\n", static_cast<unsigned long long>(properties::seed()));
  const properties::Kinds k = GetParam();
  for (const properties::Workload workload : properties::all_workloads) {
    const bool wild = workload == properties::Workload::mixed_scale || workload == properties::Workload::axis_length ||
                      workload == properties::Workload::thin;
    properties::Stream stream(workload, k.a, k.b, k.scalar, properties::seed() + 51);
    const int count = wild ? 10 : 60;
    for (int i = 0; i < count * properties::repeat(); ++i) check(stream.next());
    if (HasFailure()) FAIL() << properties::name(workload);
  }
  EXPECT_GT(met_, cases_ / 5);
  if (properties::draws_all()) {
    EXPECT_TRUE(corners_ > 0 || narrow() || k.b == VESICA_POINT);  // of two points none is the other's inside
  }
  std::printf("%d cases, %d meet, %d corners, up to %d vertices\n", cases_, met_, corners_, most_);
}

std::vector<properties::Kinds> answered_pairs() {
  std::vector<properties::Kinds> all = properties::all_pairs_of_kinds();
  std::erase_if(all, [](const properties::Kinds& k) { return !is_answered(k.a, k.b); });
  return all;
}
INSTANTIATE_TEST_SUITE_P(All, Intersection, testing::ValuesIn(answered_pairs()), properties::test_name);

/// Two quadrilaterals that share an octagon, or nearly: the most vertices that there may be, and edges that pass
/// through corners of the other, or by them, as near as numbers can be.
class Octagons : public Intersection {
 protected:
  double nudged(double x) {
    const int steps = draw(3) - 1;
    for (int i = 0; i < std::abs(steps); ++i) {
      const double to = steps > 0 ? 2 * x : 0;
      x = narrow() ? static_cast<double>(std::nextafterf(static_cast<float>(x), static_cast<float>(to)))
                   : std::nextafter(x, to);
    }
    return x;
  }
  int draw(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }

  /// A square of half size h and one turned by half a right angle, whose edges are from h / 2 to h of its axis away.
  Pair pair() {
    const bool aabb = GetParam().a == VESICA_AABB;
    const double m = aabb ? 1 : 1 + draw(20), n = aabb ? 0 : draw(20), h = 16 + draw(16);
    const auto size = [&] { return nudged(draw(3) == 0 ? h / 2 : draw(2) == 0 ? h : h / 2 + draw(128) * h / 256); };
    const Numbers turned{draw(3) == 0 ? 0.5 : 0, 0, m - n, m + n, size(), size()};
    if (aabb) return {VESICA_AABB, VESICA_RECT, {-h, -h, h, nudged(h)}, turned};
    return {VESICA_RECT, VESICA_RECT, {0, 0, m, n, h, nudged(h)}, turned};
  }
  std::mt19937_64 random_{properties::seed() + 52};
};

TEST_P(Octagons, HaveTheirVertices) {
  int full = 0;
  for (int i = 0; i < 2000 * properties::repeat(); ++i) {
    most_ = 0;
    check(pair());
    full += most_ == 8;
    if (HasFailure()) return;
  }
  EXPECT_GT(full, cases_ / 5);
  EXPECT_LT(full, cases_);
}
INSTANTIATE_TEST_SUITE_P(Quadrilaterals, Octagons,
                         testing::Values(properties::Kinds{VESICA_AABB, VESICA_RECT, Scalar::f64},
                                         properties::Kinds{VESICA_AABB, VESICA_RECT, Scalar::f32},
                                         properties::Kinds{VESICA_RECT, VESICA_RECT, Scalar::f64},
                                         properties::Kinds{VESICA_RECT, VESICA_RECT, Scalar::f32}),
                         properties::test_name);

using Numbers16 = std::array<double, 16>;

Answer shared_region(int kind_a, const Numbers& a, int kind_b, const Numbers& b) {
  return ask(Scalar::f64, {kind_a, kind_b, a, b});
}

TEST(IntersectionKnown, Literals) {
  Answer r = shared_region(VESICA_AABB, {0, 0, 4, 4}, VESICA_AABB, {1, 2, 9, 9});
  EXPECT_EQ(r.count, 4);
  EXPECT_EQ(r.at, (Numbers16{1, 2, 4, 2, 4, 4, 1, 4}));
  // A square and the same turned by half a right angle: an octagon. The axis (1, 1) makes its corners (+-3, 0), (0,
  // +-3).
  r = shared_region(VESICA_AABB, {-2, -2, 2, 2}, VESICA_RECT, {0, 0, 1, 1, 1.5, 1.5});
  EXPECT_EQ(r.count, 8);
  EXPECT_EQ(r.at, (Numbers16{-1, -2, 1, -2, 2, -1, 2, 1, 1, 2, -1, 2, -2, 1, -2, -1}));
  r = shared_region(VESICA_AABB, {0, 0, 4, 4}, VESICA_AABB, {4, 1, 5, 9});
  EXPECT_EQ(r.count, 2);
  EXPECT_EQ(r.at, (Numbers16{4, 1, 4, 4}));
  r = shared_region(VESICA_AABB, {0, 0, 4, 4}, VESICA_AABB, {4, 4, 5, 9});
  EXPECT_EQ(r.count, 1);
  EXPECT_EQ(r.at, (Numbers16{4, 4}));
  r = shared_region(VESICA_AABB, {0, 0, 4, 4}, VESICA_AABB, {5, 4, 6, 9});
  EXPECT_EQ(r.count, 0);
  EXPECT_EQ(r.at, (Numbers16{}));
  for (const Scalar scalar : {Scalar::f64, Scalar::f32}) {
    for (const int kind : {VESICA_POINT, VESICA_SEGMENT, VESICA_AABB}) {
      const Pair zeros{kind, kind, {0, -0.0, 0, 0}, {-0.0, 0, -0.0, -0.0}};
      for (const Answer& of_zeros : {ask(scalar, zeros), ask(scalar, swapped(zeros))}) {
        EXPECT_EQ(of_zeros.count, 1);
        EXPECT_FALSE(std::signbit(of_zeros.at[0]) || std::signbit(of_zeros.at[1]));
      }
    }
  }
  r = shared_region(VESICA_SEGMENT, {-1, 1, 9, 1}, VESICA_AABB, {0, 0, 4, 4});
  EXPECT_EQ(r.count, 2);
  EXPECT_EQ(r.at, (Numbers16{0, 1, 4, 1}));
  r = shared_region(VESICA_SEGMENT, {-1, 1, 1, -1}, VESICA_AABB, {0, 0, 4, 4});
  EXPECT_EQ(r.count, 1);
  EXPECT_EQ(r.at, (Numbers16{0, 0}));
  r = shared_region(VESICA_SEGMENT, {-9, 3, 9, 3}, VESICA_CIRCLE, {0, 0, 5});
  EXPECT_EQ(r.count, 2);
  EXPECT_EQ(r.at, (Numbers16{-4, 3, 4, 3}));
  r = shared_region(VESICA_SEGMENT, {9, 3, 1, 3}, VESICA_CIRCLE, {0, 0, 5});
  EXPECT_EQ(r.count, 2);
  EXPECT_EQ(r.at, (Numbers16{1, 3, 4, 3}));
  r = shared_region(VESICA_SEGMENT, {9, 5, -9, 5}, VESICA_CIRCLE, {0, 0, 5});
  EXPECT_EQ(r.count, 1);
  EXPECT_EQ(r.at, (Numbers16{0, 5}));
  r = shared_region(VESICA_SEGMENT, {4, 3, 8, 6}, VESICA_CIRCLE, {0, 0, 5});
  EXPECT_EQ(r.count, 1);
  EXPECT_EQ(r.at, (Numbers16{4, 3}));
  r = shared_region(VESICA_SEGMENT, {4, 3, -8, 3}, VESICA_CIRCLE, {0, 0, 5});
  EXPECT_EQ(r.count, 2);
  EXPECT_EQ(r.at, (Numbers16{-4, 3, 4, 3}));
  r = shared_region(VESICA_POINT, {1, 1}, VESICA_ELLIPSE, {0, 0, 1, 0, 3, 2});
  EXPECT_EQ(r.count, 1);
  EXPECT_EQ(r.at, (Numbers16{1, 1}));
  r = shared_region(VESICA_SEGMENT, {0, 0, 4, 0}, VESICA_SEGMENT, {6, 0, 1, 0});
  EXPECT_EQ(r.count, 2);
  EXPECT_EQ(r.at, (Numbers16{1, 0, 4, 0}));
  r = shared_region(VESICA_SEGMENT, {0, 0, 4, 4}, VESICA_SEGMENT, {0, 4, 4, 0});
  EXPECT_EQ(r.count, 1);
  EXPECT_EQ(r.at, (Numbers16{2, 2}));
}

// A box within another, its sizes above and below 1, or one of them 0: all its corners.
TEST(IntersectionKnown, CornersOfSmallBoxes) {
  for (const double k : {0x1p-900, 0x1p-2, 1.0, 0x1p3}) {
    SCOPED_TRACE(k);
    const Numbers all{-9 * k, -9 * k, 9 * k, 9 * k};
    Answer r = shared_region(VESICA_AABB, all, VESICA_RECT, {k, 0, 1, 0, 2 * k, k});
    EXPECT_EQ(r.count, 4);
    EXPECT_EQ(r.at, (Numbers16{-k, -k, 3 * k, -k, 3 * k, k, -k, k}));
    r = shared_region(VESICA_RECT, {k, 0, 1, 0, 2 * k, 0}, VESICA_AABB, all);
    EXPECT_EQ(r.count, 2);
    EXPECT_EQ(r.at, (Numbers16{-k, 0, 3 * k, 0}));
    r = shared_region(VESICA_RECT, {k, 0, 1, 0, 0, 2 * k}, VESICA_AABB, all);
    EXPECT_EQ(r.count, 2);
    EXPECT_EQ(r.at, (Numbers16{k, -2 * k, k, 2 * k}));
  }
}

// The header's plain form, which has no code for an answer.
TEST(IntersectionKnown, OfTheHeader) {
  const vesica::Aabb<double> all{-9, -9, 9, 9}, apart{10, 10, 11, 11}, invalid{1, 0, 0, 1};
  const vesica::Rect<double> rect{1, 0, 1, 0, 2, 1};
  const auto numbers = [](const auto& region) {
    Numbers16 out{};
    std::copy(std::begin(region.at), std::end(region.at), out.begin());
    return out;
  };
  EXPECT_EQ(numbers(vesica::intersection(all, rect)), (Numbers16{-1, -1, 3, -1, 3, 1, -1, 1}));
  EXPECT_EQ(numbers(vesica::intersection(rect, all)), (Numbers16{-1, -1, 3, -1, 3, 1, -1, 1}));
  EXPECT_EQ(numbers(vesica::intersection(vesica::Aabb<float>{0, 0, 4, 4}, vesica::Aabb<float>{1, 2, 9, 9})),
            (Numbers16{1, 2, 4, 2, 4, 4, 1, 4}));
  EXPECT_EQ(numbers(vesica::intersection(all, apart)), Numbers16{});
  EXPECT_EQ(numbers(vesica::intersection(all, invalid)), Numbers16{});
}

TEST(IntersectionKnown, Errors) {
  const double box[4] = {0, 0, 1, 1}, circle[3] = {0, 0, 1}, bad[4] = {1, 0, 0, 1};
  double out[16] = {7};
  EXPECT_EQ(capi_tests::intersection<double>(VESICA_AABB, box, VESICA_CIRCLE, circle, out), VESICA_E_KIND);
  EXPECT_EQ(capi_tests::intersection<double>(VESICA_CIRCLE, circle, VESICA_CIRCLE, circle, out), VESICA_E_KIND);
  EXPECT_EQ(capi_tests::intersection<double>(VESICA_AABB, box, 9, circle, out), VESICA_E_KIND);
  EXPECT_EQ(capi_tests::intersection<double>(VESICA_AABB, box, VESICA_AABB, bad, out), VESICA_E_SHAPE);
  EXPECT_EQ(capi_tests::intersection<double>(VESICA_AABB, box, VESICA_AABB, nullptr, out), VESICA_E_NULL);
  EXPECT_EQ(capi_tests::intersection<double>(VESICA_AABB, box, VESICA_AABB, box, nullptr), VESICA_E_NULL);
  const double huge[6] = {1.7e308, 0, 1e308, 0, 1, 1}, all[4] = {0, -1.7e308, 1.7e308, 1.7e308};
  EXPECT_EQ(capi_tests::intersection<double>(VESICA_RECT, huge, VESICA_RECT, huge, out), VESICA_E_RANGE);
  EXPECT_EQ(out[0], 7);
  EXPECT_EQ(capi_tests::intersection<double>(VESICA_AABB, all, VESICA_AABB, all, out), 4);
}

}  // namespace

// SPDX-License-Identifier: Apache-2.0
// Laws of contacts: exchange, moves, powers of two, mirrors, float; and that nothing jumps or flickers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "polygon/convex_pairs.hpp"
#include "properties/generators.hpp"
#include "vesica.h"

namespace manifold_laws {

using polygons::Corner;
using polygons::Path;
using properties::Numbers;
using properties::Pair;
using properties::Random;
using properties::Scalar;
using properties::Workload;
using Manifold = vesica_contacts_f64;

inline bool equal(const Manifold& m, const Manifold& n) { return std::memcmp(&m, &n, sizeof m) == 0; }

inline Manifold exchanged(const Manifold& m) {
  Manifold r = m;
  r.nx = 0 - m.nx, r.ny = 0 - m.ny;
  if (m.count == 2) {
    r.x0 = m.x1, r.y0 = m.y1, r.depth0 = m.depth1, r.a0 = m.b1, r.b0 = m.a1;
    r.x1 = m.x0, r.y1 = m.y0, r.depth1 = m.depth0, r.a1 = m.b0, r.b1 = m.a0;
  } else {
    std::swap(r.a0, r.b0);
  }
  return r;
}

/// How far a place is from a shape.
inline double distance(double x, double y, int kind, const Numbers& shape) {
  const vesica_point_f64 p{x, y};
  vesica_closest_points_f64 c;
  const int32_t error = vesica_nearest_f64(VESICA_POINT, &p, kind, shape.data(), &c);
  return error == 0 ? c.distance : HUGE_VAL;
}

inline void expect_laws(const Pair& p) {
  Manifold m{}, back{};
  vesica_penetration_f64 d{};
  const int32_t code = vesica_manifold_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data(), &m);
  const int32_t error = vesica_depth_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data(), &d);
  ASSERT_EQ(vesica_manifold_f64(p.kind_b, p.b.data(), p.kind_a, p.a.data(), &back), code) << properties::describe(p);
  if (code < 0) {
    ASSERT_EQ(code, VESICA_E_RANGE) << properties::describe(p);
    return;
  }
  ASSERT_EQ(error, 0);
  ASSERT_EQ(m.count, code);
  ASSERT_EQ(code > 0, d.x != 0 || d.y != 0) << properties::describe(p);
  ASSERT_TRUE(m.nx == d.x && m.ny == d.y && std::max(m.depth0, m.depth1) == d.depth) << properties::describe(p);
  ASSERT_TRUE(m.depth0 >= 0 && m.depth1 >= 0);
  const bool one_place = p.kind_a == p.kind_b
                             ? p.a == p.b
                             : vesica_relation_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data()) == VESICA_EQUAL;
  if (!one_place) {
    ASSERT_TRUE(equal(back, exchanged(m))) << properties::describe(p);
  }
}

/// The contact of a shape without an edge is between two points of the outlines; of sizes that differ by 1e3 at most.
inline void expect_on_outlines(const Pair& p) {
  Manifold m{};
  if (vesica_manifold_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data(), &m) <= 0) return;
  vesica_aabb_f64 box, about;
  ASSERT_EQ(vesica_bounds_f64(p.kind_a, p.a.data(), &box), 0);
  ASSERT_EQ(vesica_bounds_f64(p.kind_b, p.b.data(), &about), 0);
  double size = 0;
  for (const vesica_aabb_f64& b : {box, about})
    size = std::max({size, std::fabs(b.min_x), std::fabs(b.min_y), std::fabs(b.max_x), std::fabs(b.max_y)});
  const double error = 64 * 0x1p-53 * size;
  for (int k = 0; k < m.count; ++k) {
    const double x = k == 0 ? m.x0 : m.x1, y = k == 0 ? m.y0 : m.y1, half = (k == 0 ? m.depth0 : m.depth1) / 2;
    ASSERT_LE(distance(x + half * m.nx, y + half * m.ny, p.kind_a, p.a), error) << properties::describe(p);
    ASSERT_LE(distance(x - half * m.nx, y - half * m.ny, p.kind_b, p.b), error) << properties::describe(p);
  }
}

class ManifoldLaws : public testing::TestWithParam<Workload> {};

TEST_P(ManifoldLaws, EveryPairOfKinds) {
  const int pairs = (GetParam() == Workload::near_contact ? 10 : 60) * properties::repeat();
  for (int ka = 0; ka < properties::kinds; ++ka) {
    for (int kb = ka; kb < properties::kinds; ++kb) {
      properties::Stream stream(GetParam(), ka, kb, Scalar::f64, properties::seed());
      for (int i = 0; i < pairs && !HasFatalFailure(); ++i) {
        const Pair pair = stream.next();
        expect_laws(pair);
        if (GetParam() == Workload::random) expect_on_outlines(pair);
      }
    }
  }
}

TEST_P(ManifoldLaws, FloatIsRounded) {
  for (int ka = 0; ka < properties::kinds; ++ka) {
    for (int kb = 0; kb < properties::kinds; ++kb) {
      properties::Stream stream(GetParam(), ka, kb, Scalar::f32, properties::seed());
      for (int i = 0; i < 20 * properties::repeat(); ++i) {
        const Pair p = stream.next();
        const auto a = properties::narrow(p.a), b = properties::narrow(p.b);
        Manifold wide{};
        vesica_contacts_f32 m{};
        const int32_t code = vesica_manifold_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data(), &wide);
        const int32_t narrow = vesica_manifold_f32(p.kind_a, a.data(), p.kind_b, b.data(), &m);
        if (narrow == VESICA_E_RANGE) continue;
        ASSERT_EQ(narrow, code) << properties::describe(p);
        if (code < 0) continue;
        const auto is = [](float x, double of) {
          return x == static_cast<float>(of) || (of > 0 && of < 0x1p-149 && x == 0x1p-149f);
        };
        ASSERT_TRUE(is(m.nx, wide.nx) && is(m.ny, wide.ny) && is(m.x0, wide.x0) && is(m.y0, wide.y0) &&
                    is(m.depth0, wide.depth0) && is(m.x1, wide.x1) && is(m.y1, wide.y1) && is(m.depth1, wide.depth1))
            << properties::describe(p);
        ASSERT_TRUE(m.a0 == wide.a0 && m.b0 == wide.b0 && m.a1 == wide.a1 && m.b1 == wide.b1 && m.count == wide.count);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Manifold, ManifoldLaws, testing::ValuesIn(properties::all_workloads),
                         [](const auto& test) { return std::string(properties::name(test.param)); });

inline Manifold ask(const Path& a, const Path& b) {
  Manifold m{};
  const vesica_polygon_f64 p = a.view(), q = b.view();
  EXPECT_EQ(vesica_manifold_f64(VESICA_POLYGON, &p, VESICA_POLYGON, &q, &m), m.count);
  return m;
}

TEST(ManifoldLaw, PolygonsExchangedAndScaled) {
  Random random(properties::seed());
  int two = 0;
  for (int i = 0; i < 3'000 * properties::repeat() && !testing::Test::HasFatalFailure(); ++i) {
    polygons::Two pair;
    if (!polygons::convex_pair(pair, random)) continue;
    const Manifold m = ask(pair.a, pair.b);
    if (pair.a.xy != pair.b.xy) {
      ASSERT_TRUE(equal(ask(pair.b, pair.a), exchanged(m)));
    }
    two += m.count == 2;
    // Powers of two as far as no number is rounded.
    double most = 0, least = HUGE_VAL;
    for (const Path* path : {&pair.a, &pair.b}) {
      for (const double v : path->xy) {
        most = std::max(most, std::fabs(v));
        if (v != 0) least = std::min(least, std::fabs(v));
      }
    }
    const double by =
        random.chance(0.5) ? std::ldexp(1.0, 1000 - std::ilogb(most)) : std::ldexp(1.0, -850 - std::ilogb(least));
    Path a = pair.a, b = pair.b;
    bool exact = true;
    for (Path* path : {&a, &b}) {
      for (double& v : path->xy) {
        const double scaled = v * by;
        exact = exact && scaled / by == v && std::isfinite(scaled);
        v = scaled;
      }
    }
    if (!exact || std::ilogb(most) - std::ilogb(least) > 40) continue;
    const Manifold n = ask(a, b);
    ASSERT_EQ(n.count, m.count);
    ASSERT_TRUE(n.nx == m.nx && n.ny == m.ny);
    ASSERT_TRUE(n.depth0 == m.depth0 * by && n.depth1 == m.depth1 * by);
    ASSERT_TRUE(n.x0 == m.x0 * by && n.y0 == m.y0 * by && n.x1 == m.x1 * by && n.y1 == m.y1 * by);
    ASSERT_TRUE(n.a0 == m.a0 && n.b0 == m.b0 && n.a1 == m.a1 && n.b1 == m.b1);
  }
  EXPECT_TRUE(!properties::draws_all() || two > 100) << two;
}

inline Path lattice_ring(Random& random) {
  for (;;) {
    const std::vector<Corner> ring = polygons::convex(true, random);
    if (ring.size() >= 3) return polygons::path_of(ring);
  }
}

/// Integers may be moved without rounding, and mirrored: then the order is reversed, the numbers stay.
TEST(ManifoldLaw, MovedAndMirrored) {
  Random random(properties::seed());
  int compared = 0;
  for (int i = 0; i < 3'000 * properties::repeat() && !testing::Test::HasFatalFailure(); ++i) {
    const Path a = lattice_ring(random), b = lattice_ring(random);
    const Manifold m = ask(a, b);
    Path far_a = a, far_b = b, left = a, right = b;
    const double x = 0x1p49 * random.integer(-1, 1), y = 1e15;
    for (Path* path : {&far_a, &far_b}) {
      for (std::size_t k = 0; k < path->xy.size(); ++k) path->xy[k] += k % 2 == 0 ? x : y;
    }
    for (Path* path : {&left, &right}) {
      for (std::size_t k = 0; k < path->xy.size(); k += 2) path->xy[k] = -path->xy[k];
    }
    const Manifold far = ask(far_a, far_b);
    ASSERT_TRUE(far.count == m.count && far.nx == m.nx && far.ny == m.ny && far.depth0 == m.depth0 &&
                far.depth1 == m.depth1 && far.a0 == m.a0 && far.b0 == m.b0 && far.a1 == m.a1 && far.b1 == m.b1);
    const Manifold n = ask(left, right);
    if (n.count == 0 || std::fabs(n.nx + m.nx) > 1e-9 || std::fabs(n.ny - m.ny) > 1e-9) continue;
    // Another edge may be as near to the normal.
    if (n.count != m.count || m.count != 2) continue;
    const bool same = n.a0 == m.a1 && n.b0 == m.b1 && n.a1 == m.a0 && n.b1 == m.b0;
    if (!same) continue;
    ++compared;
    ASSERT_NEAR(n.depth0, m.depth1, 1e-14);
    ASSERT_NEAR(n.depth1, m.depth0, 1e-14);
    ASSERT_NEAR(n.x0, -m.x1, 1e-14);
    ASSERT_NEAR(n.y1, m.y0, 1e-14);
  }
  EXPECT_TRUE(!properties::draws_all() || compared > 300) << compared;
}

/// As a box turns on the ground, the second depth goes continuously to 0 before its contact is left out.
TEST(ManifoldLaw, SecondDepthFallsToZero) {
  for (const double radius : {0.0, 0.25}) {
    const vesica_round_rect_f64 ground{0.3, 0.1, 1, 0, 5, 1, radius};
    double before = -1;
    int left_out = 0;
    for (double angle = 0; angle < 0.5; angle += 1e-5) {
      const double c = std::cos(angle), s = std::sin(angle);
      const vesica_round_rect_f64 box{1, 2.1 + 2 * radius - 0.01, c, s, 1, 1, radius};
      Manifold m{};
      const int32_t count = vesica_manifold_f64(VESICA_ROUND_RECT, &ground, VESICA_ROUND_RECT, &box, &m);
      ASSERT_GE(count, 1);
      const double less = count == 2 ? std::min(m.depth0, m.depth1) : 0;
      if (before >= 0) {
        ASSERT_LT(std::fabs(less - before), 3e-5) << angle;
      }
      left_out += count == 1 && before > 0;
      before = less;
    }
    EXPECT_EQ(left_out, 1);
  }
}

/// As a box slides off the ground, its contacts come together before there is one.
TEST(ManifoldLaw, ContactsComeTogether) {
  const vesica_aabb_f64 ground{0, 0, 2, 1};
  double apart = 2;
  for (double x = 1; x < 3.1; x += 1e-4) {
    const vesica_rect_f64 box{x, 1.999999, 1, 0, 1, 1};
    Manifold m{};
    const int32_t count = vesica_manifold_f64(VESICA_AABB, &ground, VESICA_RECT, &box, &m);
    const double now = count == 2 ? std::hypot(m.x1 - m.x0, m.y1 - m.y0) : 0;
    ASSERT_LT(std::fabs(now - apart), 2e-4) << x;
    apart = now;
  }
  EXPECT_EQ(apart, 0);
}

/// Equal boxes that are aligned up to rounding, and sunk in more than that: two contacts of the same numbers. Rounding
/// decides there which of them ends first.
TEST(ManifoldLaw, NothingFlickers) {
  Random random(properties::seed());
  for (const double radius : {0.0, 0.125}) {
    for (const double angle : {0.0, 0.4, 1.7, 3.3}) {
      const double c = std::cos(angle), s = std::sin(angle), up = 2 + 2 * radius - 1e-9;
      const vesica_round_rect_f64 low{0.1, 0.7, c, s, 1, 1, radius};
      for (int i = 0; i < 5'000 * properties::repeat(); ++i) {
        vesica_round_rect_f64 high{0.1 - up * s, 0.7 + up * c, c, s, 1, 1, radius};
        for (double* number : {&high.cx, &high.cy, &high.ux, &high.uy, &high.hx}) {
          *number += random.integer(-8, 8) * 0x1p-53;
        }
        Manifold m{};
        ASSERT_EQ(vesica_manifold_f64(VESICA_ROUND_RECT, &low, VESICA_ROUND_RECT, &high, &m), 2);
        ASSERT_TRUE(m.a0 == 2 && m.b0 == 1 && m.a1 == 3 && m.b1 == 0);
        ASSERT_NEAR(m.depth0, 1e-9, 1e-14);
        ASSERT_NEAR(m.depth1, 1e-9, 1e-14);
      }
    }
  }
}

/// Boxes of one direction that touch up to rounding: if they overlap, they do so twice.
TEST(ManifoldLaw, FlushUpToRounding) {
  Random random(properties::seed());
  int touching = 0;
  for (int i = 0; i < 5'000 * properties::repeat(); ++i) {
    const double angle = random.between(0, 7), c = std::cos(angle), s = std::sin(angle), h = random.between(0.5, 1),
                 up = 1 + h, aside = random.between(-1, 1);
    const vesica_rect_f64 low{0.1, 0.7, c, s, 1, 1};
    const vesica_rect_f64 high{0.1 + aside * c - up * s, 0.7 + aside * s + up * c, c, s, 1, h};
    Manifold m{};
    const int32_t count = vesica_manifold_f64(VESICA_RECT, &low, VESICA_RECT, &high, &m);
    ASSERT_TRUE(count == 0 || count == 2) << angle;
    touching += count == 2;
  }
  EXPECT_TRUE(!properties::draws_all() || touching > 1'000) << touching;
}

}  // namespace manifold_laws

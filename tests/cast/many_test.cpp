// SPDX-License-Identifier: Apache-2.0
/// Casts of arrays have the bits of single calls where kernels are most likely to differ: about contact to the last
/// place and about the end, at every length, among wrong elements, with operands that repeat, at the edge of a page.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vesica/cast/place.hpp>

#include "batch/guard_pages.hpp"
#include "cast/arrays.hpp"

namespace {

using namespace cast_test;
using Offset = vesica::detail::cast::Offset;
using batch_tests::Edge;
using batch_tests::GuardedMemory;
using properties::Workload;

template <class T>
constexpr T no_end = std::numeric_limits<T>::infinity();

template <class T>
class CastsOfArrays : public testing::Test {};
using Scalars = testing::Types<double, float>;
TYPED_TEST_SUITE(CastsOfArrays, Scalars);

template <class Action>
void each_pair_of_kinds(const Action& action) {
  for (int kind_a = 0; kind_a < properties::kinds; ++kind_a) {
    for (int kind_b = 0; kind_b < properties::kinds; ++kind_b) action(kind_a, kind_b);
  }
}

/// As many arrays as the run draws (VESICA_REPEAT), at least one.
int arrays(int whole) { return std::max(1, static_cast<int>(whole * properties::repeat().value)); }

/// Pairs of about unit size with a velocity towards the other: `spread` of it at random.
template <class T>
std::vector<Moving> aimed(int kind_a, int kind_b, int n, double spread, properties::Random& random) {
  std::vector<Moving> out;
  for (int i = 0; i < n; ++i) {
    const Pair p = properties::draw(Workload::random, kind_a, kind_b, scalar_of<T>, random);
    Motion m = draw_motion(p, scalar_of<T>, random);
    m.vx = properties::nearest(scalar_of<T>, 2 * (p.a[0] - p.b[0]) + spread * random.between(-1, 1));
    m.vy = properties::nearest(scalar_of<T>, 2 * (p.a[1] - p.b[1]) + spread * random.between(-1, 1));
    out.push_back({p, m});
  }
  return out;
}

TYPED_TEST(CastsOfArrays, OfEveryWorkload) {
  using T = TypeParam;
  each_pair_of_kinds([](int kind_a, int kind_b) {
    for (const Workload workload : properties::all_workloads) {
      Arrays<T> s(workload, kind_a, kind_b, arrays(40));
      for (const T end : {no_end<T>, T(1), T(0)}) check_many<T>(s, end);
    }
    // An end at which places have more digits than anywhere else.
    Arrays<T> s(Workload::random, kind_a, kind_b, 20);
    check_many<T>(s, std::numeric_limits<T>::denorm_min());
  });
}

/// Boxes along the same line, which their axes tell exactly though these have other lengths: two faces meet, and the
/// point is the middle of what they share. Of some the axis is off by a few last places, which a product rounds away.
TYPED_TEST(CastsOfArrays, OfParallelBoxes) {
  using T = TypeParam;
  properties::Random random(properties::seed() + 44);
  std::vector<Moving> pairs;
  for (int i = 0; i < 600; ++i) {
    const double k = random.integer(1, 3), x = i % 2 == 0 ? 3 : 5, y = i % 2 == 0 ? 4 : -12;
    const double off = i % 3 == 0 ? 0 : random.integer(-6, 6) * 0x1p-51;
    const double ux = (i % 4 < 2 ? k * x : -k * y) * (1 + off), uy = i % 4 < 2 ? k * y : k * x;
    const auto half = [&] { return random.integer(1, 15) * 0x1p-7; };
    const double far = random.integer(4, 9), beside = random.integer(-8, 8) * 0x1p-6;
    const double dx = far * x - beside * y, dy = far * y + beside * x;
    pairs.push_back(
        {{VESICA_RECT, VESICA_RECT, {0, 0, x, y, half() * (i % 5), half()}, {dx, dy, ux, uy, half(), half()}},
         {-dx + beside * y, -dy - beside * x, 0}});
  }
  Arrays<T> s(VESICA_RECT, VESICA_RECT, pairs);
  check_many<T>(s, no_end<T>);
}

/// Hits of any share, several blocks, and every length of the last vector.
TYPED_TEST(CastsOfArrays, OfEveryLength) {
  using T = TypeParam;
  properties::Random random(properties::seed() + 40);
  int n = 1;
  each_pair_of_kinds([&](int kind_a, int kind_b) {
    for (const double spread : {0.0, 1.0, 4.0, 20.0}) {
      for (int k = 0; k < arrays(3); ++k) {
        Arrays<T> s(kind_a, kind_b, aimed<T>(kind_a, kind_b, n + 120 * k, spread, random));
        check_many<T>(s, k % 2 == 0 ? T(1) : no_end<T>);
      }
      n = n % 40 + 1;
    }
  });
}

/// Velocities, ends and positions about the very number at which a hit becomes a miss.
TYPED_TEST(CastsOfArrays, AboutGrazing) {
  using T = TypeParam;
  properties::Random random(properties::seed() + 41);
  each_pair_of_kinds([&](int kind_a, int kind_b) {
    int grazed = 0;
    for (int k = 0; k < arrays(40) && grazed < arrays(6); ++k) {
      const Moving m = aimed<T>(kind_a, kind_b, 1, 0.5, random)[0];
      if (cast(scalar_of<T>, m.pair, m.motion).code != VESICA_CAST_HIT) continue;
      const std::vector<Moving> about = about_grazing(m, scalar_of<T>, random, 4);
      if (about.empty()) continue;
      ++grazed;
      Arrays<T> s(kind_a, kind_b, about);
      check_many<T>(s, static_cast<T>(about.front().motion.end));
      check_many<T>(s, static_cast<T>(about.back().motion.end));
    }
    if (properties::draws_all()) {
      EXPECT_GT(grazed, kind_a == VESICA_POINT && kind_b == VESICA_POINT ? -1 : 0) << kind_a << ' ' << kind_b;
    }
  });
}

/// The support of a circle or an ellipse along a direction.
Offset support(int kind, const Numbers& n, const Offset& d) {
  if (kind == VESICA_CIRCLE) {
    const double length = std::sqrt(d.x * d.x + d.y * d.y);
    return {n[2] * d.x / length, n[2] * d.y / length};
  }
  const double p = n[4] * (n[2] * d.x + n[3] * d.y), q = n[5] * (n[2] * d.y - n[3] * d.x), h = std::sqrt(p * p + q * q);
  return {(n[4] * p * n[2] - n[5] * q * n[3]) / h, (n[4] * p * n[3] + n[5] * q * n[2]) / h};
}

/// A round shape meets a corner of a box along the normal of one of its sides, to 2^-54 of it and exactly: where
/// contact goes from the side to the corner.
template <class T>
Moving at_corner(int box, int round, bool box_moves, properties::Random& random) {
  const double t = random.integer(-8, 8) / 8.0, hx = random.between(0.25, 1), hy = random.between(0.25, 1);
  Offset u{1, 0};
  Numbers shape{-hx, -hy, hx, hy};
  if (box == VESICA_SEGMENT) shape = {0, 0, 1 - t * t, 2 * t};
  if (box == VESICA_RECT) shape = {0, 0, 1 - t * t, 2 * t, hx, hy};
  if (box != VESICA_AABB) u = {1 - t * t, 2 * t};
  Offset corner{hx * u.x - hy * u.y, hx * u.y + hy * u.x}, normal = random.chance(0.5) ? u : Offset{-u.y, u.x};
  if (box == VESICA_SEGMENT) corner = u;
  const double beside = random.chance(0.2) ? 0 : random.sign() * std::ldexp(1, -random.below(55));
  normal = {normal.x - beside * normal.y, normal.y + beside * normal.x};
  Numbers other{0, 0, hy};
  if (round == VESICA_ELLIPSE) other = {0, 0, random.between(-1, 1), 1, random.between(0.25, 1), hx};
  const Offset from = support(round, other, normal), place{corner.x + from.x, corner.y + from.y};
  const double across = random.chance(0.2) ? 0 : random.between(-2, 2);
  const Offset v{-normal.x - across * normal.y, -normal.y + across * normal.x};
  other[0] = place.x - v.x;
  other[1] = place.y - v.y;
  Pair p = box_moves ? Pair{round, box, other, shape} : Pair{box, round, shape, other};
  for (Numbers* n : {&p.a, &p.b}) {
    for (double& x : *n) x = properties::nearest(scalar_of<T>, x);
  }
  const double way = box_moves ? -1 : 1;
  return {p, {properties::nearest(scalar_of<T>, way * v.x), properties::nearest(scalar_of<T>, way * v.y), 2}};
}

TYPED_TEST(CastsOfArrays, OfRoundShapesAtCorners) {
  using T = TypeParam;
  properties::Random random(properties::seed() + 46);
  for (const int box : {VESICA_SEGMENT, VESICA_AABB, VESICA_RECT}) {
    for (const int round : {VESICA_CIRCLE, VESICA_ELLIPSE}) {
      for (const bool box_moves : {false, true}) {
        std::vector<Moving> pairs;
        for (int i = 0; i < arrays(1000); ++i) pairs.push_back(at_corner<T>(box, round, box_moves, random));
        Arrays<T> s(pairs[0].pair.kind_a, pairs[0].pair.kind_b, pairs);
        check_many<T>(s, no_end<T>);
        check_many<T>(s, T(1));
      }
    }
  }
}

/// A round shape, and another or a point that meets it at a time from 1/2 to 2 with a normal that is 2^-10 to 2^-59 off
/// a coordinate, or not at all. Of some the velocity is along one too.
template <class T>
Moving nearly_along(int kind_a, int kind_b, properties::Random& random) {
  const auto drawn = [&](int kind) {
    const bool upright = random.chance(0.25);
    const double turn = random.between(-1, 1), t = upright ? 0 : turn;
    const double width = random.between(0.25, 1), height = random.between(0.25, 1);
    if (kind == VESICA_POINT) return Numbers{};
    return kind == VESICA_CIRCLE ? Numbers{0, 0, width} : Numbers{0, 0, 1 - t * t, 2 * t, width, height};
  };
  const Numbers a = drawn(kind_a);
  Numbers b = drawn(kind_b);
  const double sign = random.sign(), side = random.sign();
  const double least = std::ldexp(side, -random.integer(10, 59)), off = random.chance(0.125) ? 0 : least;
  const Offset n = random.chance(0.5) ? Offset{sign, off} : Offset{off, sign};
  Offset at{0, 0};
  if (kind_a != VESICA_POINT) at = support(kind_a, a, n);
  if (kind_b != VESICA_POINT) {
    const Offset of_b = support(kind_b, b, n);
    at = {at.x + of_b.x, at.y + of_b.y};
  }
  const bool straight = random.chance(0.25);
  const double beside = random.between(-2, 2), across = straight ? 0 : beside, time = random.between(0.5, 2);
  Offset v{-n.x - across * n.y, -n.y + across * n.x};
  const bool along = random.chance(0.25);
  if (along) (std::abs(v.x) < std::abs(v.y) ? v.x : v.y) = 0;
  b[0] = at.x - v.x * time;
  b[1] = at.y - v.y * time;
  Moving m{{kind_a, kind_b, a, b}, {v.x, v.y, 2}};
  for (Numbers* shape : {&m.pair.a, &m.pair.b}) {
    for (double& x : *shape) x = properties::nearest(scalar_of<T>, x);
  }
  m.motion.vx = properties::nearest(scalar_of<T>, v.x);
  m.motion.vy = properties::nearest(scalar_of<T>, v.y);
  return m;
}

TYPED_TEST(CastsOfArrays, OfRoundShapesNearlyAlongACoordinate) {
  using T = TypeParam;
  properties::Random random(properties::seed() + 47);
  for (const int kind_a : {VESICA_POINT, VESICA_CIRCLE, VESICA_ELLIPSE}) {
    for (const int kind_b : {VESICA_POINT, VESICA_CIRCLE, VESICA_ELLIPSE}) {
      if (kind_a == VESICA_POINT && kind_b == VESICA_POINT) continue;
      std::vector<Moving> pairs;
      for (int i = 0; i < arrays(1000); ++i) pairs.push_back(nearly_along<T>(kind_a, kind_b, random));
      Arrays<T> s(kind_a, kind_b, pairs);
      check_many<T>(s, no_end<T>);
    }
  }
}

/// The end at the very time of a contact, and beside it.
TYPED_TEST(CastsOfArrays, AboutTheEnd) {
  using T = TypeParam;
  properties::Random random(properties::seed() + 42);
  each_pair_of_kinds([&](int kind_a, int kind_b) {
    Arrays<T> s(kind_a, kind_b, aimed<T>(kind_a, kind_b, 30, 1, random));
    for (std::size_t i = 0; i < 30; i += 10) {
      typename Face<T>::Impact one{};
      if (Face<T>::cast(kind_a, s.a[i].data(), kind_b, s.b[i].data(), s.v[i][0], s.v[i][1], no_end<T>, &one) !=
          VESICA_CAST_HIT) {
        continue;
      }
      for (const T end : {std::nextafter(one.t, T(0)), one.t, std::nextafter(one.t, no_end<T>)}) check_many<T>(s, end);
    }
  });
}

/// Numbers that no kernel may answer for, in the midst of others.
TYPED_TEST(CastsOfArrays, WithOddNumbers) {
  using T = TypeParam;
  properties::Random random(properties::seed() + 43);
  const T odd[] = {0,
                   -T(0),
                   -1,
                   no_end<T>,
                   std::numeric_limits<T>::quiet_NaN(),
                   std::numeric_limits<T>::denorm_min(),
                   std::numeric_limits<T>::max(),
                   std::ldexp(T(1), -70),
                   std::ldexp(T(1), 70)};
  each_pair_of_kinds([&](int kind_a, int kind_b) {
    for (int k = 0; k < arrays(12); ++k) {
      Arrays<T> s(kind_a, kind_b, aimed<T>(kind_a, kind_b, 25, 1, random));
      for (std::size_t i = 0; i < s.a.size(); i += 1 + static_cast<std::size_t>(random.below(4))) {
        const auto place = static_cast<std::size_t>(random.below(6));
        T* const numbers[] = {&s.a[i][place], &s.b[i][place], &s.v[i][place % 2]};
        *numbers[random.below(3)] = odd[random.below(9)];
      }
      check_many<T>(s, k % 2 == 0 ? no_end<T> : T(1));
    }
  });
}

/// One shape or one velocity for all, and columns that nobody wants.
TYPED_TEST(CastsOfArrays, WithOperandsThatRepeat) {
  using T = TypeParam;
  properties::Random random(properties::seed() + 44);
  each_pair_of_kinds([&](int kind_a, int kind_b) {
    constexpr std::size_t n = 150;
    Arrays<T> s(kind_a, kind_b, aimed<T>(kind_a, kind_b, n, 2, random));
    for (int which = 0; which < 8; ++which) {
      auto a = s.shapes_a, b = s.shapes_b;
      if ((which & 1) != 0) a.stride = 0;
      if ((which & 2) != 0) b.stride = 0;
      const std::size_t step = (which & 4) != 0 ? 0 : 1;
      T t[n], y[n];
      Face<T>::cast_many(&a, &b, &s.v[0][0], &s.v[0][1], static_cast<std::ptrdiff_t>(step * sizeof s.v[0]), 2, t,
                         nullptr, y, nullptr, nullptr);
      for (std::size_t i = 0; i < n; ++i) {
        typename Face<T>::Impact one{};
        Face<T>::cast(kind_a, s.a[a.stride == 0 ? 0 : i].data(), kind_b, s.b[b.stride == 0 ? 0 : i].data(),
                      s.v[i * step][0], s.v[i * step][1], 2, &one);
        EXPECT_TRUE(same_bits(&one.t, &t[i], sizeof(T))) << which << ' ' << i << ' ' << s.describe(i);
        EXPECT_TRUE(same_bits(&one.y, &y[i], sizeof(T)) || (std::isnan(one.y) && std::isnan(y[i]))) << s.describe(i);
      }
    }
  });
}

/// Records, velocities and answers against a page that may not be touched.
TYPED_TEST(CastsOfArrays, WithinTheirMemory) {
  using T = TypeParam;
  properties::Random random(properties::seed() + 45);
  GuardedMemory memory[8];
  each_pair_of_kinds([&](int kind_a, int kind_b) {
    const auto fields_a = static_cast<std::size_t>(vesica_field_count(kind_a)),
               fields_b = static_cast<std::size_t>(vesica_field_count(kind_b));
    for (const std::size_t n : {1u, 3u, 5u, 8u, 17u, 131u}) {
      const Arrays<T> s(kind_a, kind_b, aimed<T>(kind_a, kind_b, static_cast<int>(n), 1, random));
      for (const Edge edge : {Edge::before, Edge::after}) {
        const auto place = [&](std::size_t k, std::size_t numbers) {
          return reinterpret_cast<T*>(memory[k].place(numbers * sizeof(T), edge));
        };
        T *const a = place(0, n * fields_a), *const b = place(1, n * fields_b), *const v = place(2, 2 * n);
        for (std::size_t i = 0; i < n; ++i) {
          std::memcpy(a + i * fields_a, s.a[i].data(), fields_a * sizeof(T));
          std::memcpy(b + i * fields_b, s.b[i].data(), fields_b * sizeof(T));
          std::memcpy(v + 2 * i, s.v[i].data(), 2 * sizeof(T));
        }
        typename Face<T>::Shapes shapes_a, shapes_b;
        const auto count = static_cast<std::int64_t>(n);
        Face<T>::from_records(kind_a, count, a, static_cast<std::ptrdiff_t>(fields_a * sizeof(T)), &shapes_a);
        Face<T>::from_records(kind_b, count, b, static_cast<std::ptrdiff_t>(fields_b * sizeof(T)), &shapes_b);
        T* const t = place(3, n);
        EXPECT_GE(Face<T>::cast_many(&shapes_a, &shapes_b, v, v + 1, 2 * sizeof(T), no_end<T>, t, place(4, n),
                                     place(5, n), place(6, n), place(7, n)),
                  0);
        for (std::size_t i = 0; i < n; ++i) {
          typename Face<T>::Impact one{};
          Face<T>::cast(kind_a, s.a[i].data(), kind_b, s.b[i].data(), s.v[i][0], s.v[i][1], no_end<T>, &one);
          EXPECT_TRUE(same_bits(&one.t, &t[i], sizeof(T))) << s.describe(i);
        }
      }
    }
  });
}

}  // namespace

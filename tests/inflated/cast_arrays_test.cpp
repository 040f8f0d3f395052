// SPDX-License-Identifier: Apache-2.0
// Casts of arrays of shapes with a radius have the bits of single casts, and rays those of the general path. They are
// most likely to differ on lattices, beside the ends of faces, at unlike sizes, about the end of the time, and among
// odd numbers.
#include <gtest/gtest.h>
#include <vesica_motion.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>
#include <vesica/cast.hpp>

#include "inflated/shapes.hpp"

namespace inflated_cast_arrays {
namespace {

using namespace inflated;
using properties::Random;

struct Moving {
  Shape a, b;
  double vx, vy;
};

template <class T>
struct Api;
template <>
struct Api<double> {
  using Shapes = vesica_shapes_f64;
  using Impact = vesica_impact_f64;
  static constexpr auto from_records = vesica_shapes_from_records_f64;
  static constexpr auto cast = vesica_cast_f64;
  static constexpr auto many = vesica_cast_many_f64;
};
template <>
struct Api<float> {
  using Shapes = vesica_shapes_f32;
  using Impact = vesica_impact_f32;
  static constexpr auto from_records = vesica_shapes_from_records_f32;
  static constexpr auto cast = vesica_cast_f32;
  static constexpr auto many = vesica_cast_many_f32;
};

template <class T>
std::array<T, 7> numbers(const Shape& s) {
  std::array<T, 7> out;
  std::ranges::transform(s.number, out.begin(), [](double x) { return static_cast<T>(x); });
  return out;
}

/// Compares an array of pairs, all of the kinds of the first, with single calls. Returns the time of the first hit, or
/// NaN.
template <class T>
T expect_as_single(const std::vector<Moving>& pairs, T end, int& hits) {
  using A = Api<T>;
  const std::size_t n = pairs.size();
  const std::int32_t kind_a = pairs[0].a.kind, kind_b = pairs[0].b.kind;
  std::vector<std::array<T, 7>> a, b;
  std::vector<std::array<T, 2>> v;
  for (const Moving& m : pairs) {
    a.push_back(numbers<T>(m.a));
    b.push_back(numbers<T>(m.b));
    v.push_back({static_cast<T>(m.vx), static_cast<T>(m.vy)});
  }
  typename A::Shapes first{}, second{};
  A::from_records(kind_a, static_cast<std::int64_t>(n), a.data(), sizeof a[0], &first);
  A::from_records(kind_b, static_cast<std::int64_t>(n), b.data(), sizeof b[0], &second);
  std::array<std::vector<T>, 5> column;
  for (auto& c : column) c.resize(n);
  const std::int64_t found = A::many(&first, &second, &v[0][0], &v[0][1], sizeof v[0], end, column[0].data(),
                                     column[1].data(), column[2].data(), column[3].data(), column[4].data());
  std::int64_t expected = 0, worst = 0;
  T time = std::numeric_limits<T>::quiet_NaN();
  for (std::size_t i = 0; i < n; ++i) {
    typename A::Impact one{};
    const std::int32_t code = A::cast(kind_a, a[i].data(), kind_b, b[i].data(), v[i][0], v[i][1], end, &one);
    expected += code > 0;
    if (code == VESICA_CAST_HIT && std::isnan(time)) time = one.t;
    if (code < 0) {
      worst = worst == VESICA_E_SHAPE ? worst : code;
      EXPECT_TRUE(std::isnan(column[0][i]));
      continue;
    }
    const std::array<T, 5> of_one{one.t, one.x, one.y, one.nx, one.ny};
    for (std::size_t k = 0; k < 5; ++k) {
      const T x = column[k][i];
      EXPECT_TRUE(std::memcmp(&x, &of_one[k], sizeof x) == 0 || (std::isnan(x) && std::isnan(of_one[k])))
          << kind_a << ' ' << kind_b << ' ' << i << ", number " << k << ": " << x << ", single " << of_one[k];
    }
  }
  EXPECT_EQ(found, worst != 0 ? worst : expected);
  hits += static_cast<int>(expected);
  return time;
}

template <class Action>
void each_pair_of_kinds(const Action& action) {
  for (const std::int32_t kind : kinds) {
    for (std::int32_t other = 0; other < 8; ++other) {
      action(kind, other);
      if (other < 6) action(other, kind);
    }
  }
}

int arrays(int whole) { return std::max(1, static_cast<int>(whole * properties::repeat().value)); }

std::array<double, 2> centre(const Shape& s) {
  const Numbers& n = s.number;
  const bool ends = s.kind == VESICA_SEGMENT || s.kind == VESICA_AABB || s.kind == VESICA_CAPSULE;
  return ends ? std::array{0.5 * (n[0] + n[2]), 0.5 * (n[1] + n[3])} : std::array{n[0], n[1]};
}
void move(Shape& s, double x, double y) {
  const bool ends = s.kind == VESICA_SEGMENT || s.kind == VESICA_AABB || s.kind == VESICA_CAPSULE;
  for (std::size_t k = 0; k < (ends ? 4 : 2); k += 2) s.number[k] += x, s.number[k + 1] += y;
}

/// b towards a, `spread` of the velocity at random.
Moving aimed(const Shape& a, const Shape& b, double spread, Random& random) {
  const auto to = centre(a), from = centre(b);
  return {a, b, 2 * (to[0] - from[0]) + spread * random.between(-1, 1),
          2 * (to[1] - from[1]) + spread * random.between(-1, 1)};
}

template <class T>
class InflatedCastArrays : public ::testing::Test {};
using Scalars = ::testing::Types<double, float>;
TYPED_TEST_SUITE(InflatedCastArrays, Scalars);

TYPED_TEST(InflatedCastArrays, AimedPairsOfEveryLength) {
  using T = TypeParam;
  Random random(properties::seed() + 1);
  int n = 1, hits = 0;
  each_pair_of_kinds([&](std::int32_t kind_a, std::int32_t kind_b) {
    for (int k = 0; k < arrays(12); ++k) {
      std::vector<Moving> pairs;
      for (int i = 0; i < n + 120 * (k % 3); ++i) {
        pairs.push_back(aimed(shape(kind_a, random), shape(kind_b, random), 4, random));
        move(pairs.back().b, random.between(-3, 3), random.between(-3, 3));
      }
      expect_as_single<T>(pairs, k % 2 == 0 ? T(1) : std::numeric_limits<T>::infinity(), hits);
      n = n % 40 + 1;
    }
  });
  EXPECT_GT(hits, 1000 * properties::repeat());
}

/// Few digits: parallel faces, ways along faces, ways that graze, sizes and radii of 0, axes of other lengths.
Shape lattice_shape(std::int32_t kind, Random& random) {
  constexpr std::array<std::array<int, 2>, 6> axes{{{1, 0}, {0, 1}, {3, 4}, {-4, 3}, {2, 1}, {2, 0}}};
  const auto place = [&] { return random.integer(-12, 12) * 0.5; };
  const auto size = [&] { return random.integer(0, 8) * 0.25; };
  const double x = place(), y = place();
  const auto& axis = axes[static_cast<std::size_t>(random.below(6))];
  Shape out{kind, {x, y, size(), size()}};
  Numbers& n = out.number;
  if (kind == VESICA_AABB) n[2] += x, n[3] += y;
  if (kind == VESICA_SEGMENT || kind == VESICA_CAPSULE) {
    const int length = random.integer(0, 3);
    n = {x, y, x + length * axis[0], y + length * axis[1], size()};
  }
  if (kind >= VESICA_RECT && kind != VESICA_CAPSULE) {
    n = {x, y, 1.0 * axis[0], 1.0 * axis[1], size(), size(), kind == VESICA_ROUND_RECT ? size() : 0};
  }
  return out;
}

TYPED_TEST(InflatedCastArrays, Lattices) {
  using T = TypeParam;
  Random random(properties::seed() + 2);
  int hits = 0;
  each_pair_of_kinds([&](std::int32_t kind_a, std::int32_t kind_b) {
    for (int k = 0; k < arrays(8); ++k) {
      std::vector<Moving> pairs;
      for (int i = 0; i < 200; ++i) {
        pairs.push_back({lattice_shape(kind_a, random), lattice_shape(kind_b, random),
                         static_cast<double>(random.integer(-4, 4)), static_cast<double>(random.integer(-4, 4))});
      }
      expect_as_single<T>(pairs, k % 2 == 0 ? T(2) : std::numeric_limits<T>::infinity(), hits);
    }
  });
  EXPECT_GT(hits, 1000 * properties::repeat());
}

/// Sizes and radii of other magnitudes than the rest, and axes that are no unit vectors.
Shape shrunk(Shape s, Random& random) {
  const auto power = [&] { return std::ldexp(1.0, -random.integer(0, 2) * random.integer(0, 30)); };
  Numbers& n = s.number;
  const double k = power();
  if (s.kind == VESICA_SEGMENT || s.kind == VESICA_CAPSULE) {
    n[2] = n[0] + k * (n[2] - n[0]);
    n[3] = n[1] + k * (n[3] - n[1]);
    n[4] *= power();
  } else if (s.kind >= VESICA_RECT) {
    n[2] *= k, n[3] *= k;
    n[4] *= power() / k, n[5] *= power() / k;
    n[6] *= power();
  }
  return s;
}
Moving unlike_sizes(std::int32_t kind_a, std::int32_t kind_b, Random& random) {
  Moving m = aimed(shrunk(shape(kind_a, random), random), shrunk(shape(kind_b, random), random), 0.5, random);
  move(m.b, random.between(-1, 1), random.between(-1, 1));
  return m;
}

TYPED_TEST(InflatedCastArrays, UnlikeSizes) {
  using T = TypeParam;
  Random random(properties::seed() + 3);
  int hits = 0;
  each_pair_of_kinds([&](std::int32_t kind_a, std::int32_t kind_b) {
    for (int k = 0; k < arrays(8); ++k) {
      std::vector<Moving> pairs;
      for (int i = 0; i < 200; ++i) pairs.push_back(unlike_sizes(kind_a, kind_b, random));
      expect_as_single<T>(pairs, std::numeric_limits<T>::infinity(), hits);
    }
  });
  EXPECT_GT(hits, 1000 * properties::repeat());
}

/// A point or a circle that reaches the rim where a face ends and an arc begins, 2^-4 to 2^-56 to either side.
Moving at_end_of_face(std::int32_t kind, std::int32_t other, Random& random) {
  Shape a = shape(kind, random), b{other, {0, 0, other == VESICA_CIRCLE ? random.unit() : 0}};
  Numbers& n = a.number;
  const bool capsule = kind == VESICA_CAPSULE;
  if (random.chance(0.3)) n[capsule ? 3 : 2] = capsule ? n[1] : 1, n[3] = capsule ? n[3] : 0;
  double ux = capsule ? n[2] - n[0] : n[2], uy = capsule ? n[3] - n[1] : n[3];
  const double length = std::hypot(ux, uy), hx = capsule ? 0.5 : n[4], hy = capsule ? 0 : n[5];
  const double x = centre(a)[0] + hx * ux - hy * uy, y = centre(a)[1] + hx * uy + hy * ux;
  ux /= length, uy /= length;
  const double r = radius(a) + radius(b), turn = random.sign() * std::ldexp(1.0, -random.integer(4, 56));
  const double beside = random.between(-2, 2), vx = uy + beside * ux, vy = -ux + beside * uy;
  b.number[0] = x + r * (-uy + turn * ux) - vx;
  b.number[1] = y + r * (ux + turn * uy) - vy;
  return {a, b, vx, vy};
}

TYPED_TEST(InflatedCastArrays, EndsOfFaces) {
  using T = TypeParam;
  Random random(properties::seed() + 4);
  int hits = 0;
  for (const std::int32_t kind : kinds) {
    for (const std::int32_t other : {VESICA_POINT, VESICA_CIRCLE}) {
      for (int k = 0; k < arrays(20); ++k) {
        std::vector<Moving> pairs;
        for (int i = 0; i < 200; ++i) pairs.push_back(at_end_of_face(kind, other, random));
        expect_as_single<T>(pairs, T(2), hits);
      }
    }
  }
  EXPECT_GT(hits, 1000 * properties::repeat());
}

/// Rays: what the early out and the fast hit decide, with either kind of product.
struct Quick {
  int asked = 0, missed = 0, hit = 0;
};
template <class Products, template <class> class A>
void expect_as_general_path(const Moving& m, double end, Quick& quick) {
  namespace cast = vesica::detail::cast;
  const auto a = cast::shape<A>(cast::Body{
      vesica::ShapeTraits<A<double>>::kind,
      {m.a.number[0], m.a.number[1], m.a.number[2], m.a.number[3], m.a.number[4], m.a.number[5], m.a.number[6]}});
  const vesica::Point<double> b{m.b.number[0], m.b.number[1]};
  const cast::Motion motion{m.vx, m.vy, end};
  vesica::Impact<double> found{}, wanted{};
  const cast::EarlyOut early = cast::fast_cast<Products>(a, b, motion, found);
  ++quick.asked;
  if (early == cast::EarlyOut::open) return;
  const std::int32_t code = cast::cast_any(a, b, motion, wanted);
  ASSERT_EQ(code, early == cast::EarlyOut::hit ? vesica::cast_hit : vesica::cast_miss);
  (code == vesica::cast_hit ? quick.hit : quick.missed)++;
  if (code != vesica::cast_hit) return;
  ASSERT_EQ(std::memcmp(&found, &wanted, sizeof found), 0)
      << found.t << ' ' << found.x << ' ' << found.y << ' ' << found.nx << ' ' << found.ny << " / " << wanted.t << ' '
      << wanted.x << ' ' << wanted.y << ' ' << wanted.nx << ' ' << wanted.ny;
}

TEST(InflatedRays, EarlyOutsHaveTheBitsOfTheGeneralPath) {
  using namespace vesica;
  Random random(properties::seed() + 7);
  const double infinity = std::numeric_limits<double>::infinity();
  Quick split[3];
  for (int i = 0; i < 20000 * properties::repeat(); ++i) {
    const std::int32_t kind = kinds[static_cast<std::size_t>(i % 2)];
    Moving ordinary = aimed(shape(kind, random), shape(VESICA_POINT, random), 4, random);
    const double place = random.between(-3, 3);
    move(ordinary.b, place, place);
    const Moving drawn[] = {ordinary,
                            unlike_sizes(kind, VESICA_POINT, random),
                            at_end_of_face(kind, VESICA_POINT, random),
                            {lattice_shape(kind, random), lattice_shape(VESICA_POINT, random),
                             static_cast<double>(random.integer(-4, 4)), static_cast<double>(random.integer(-4, 4))}};
    const double end = random.chance(0.5) ? 1 : infinity;
    for (std::size_t k = 0; k < 4; ++k) {
      SCOPED_TRACE(i);
      Quick& quick = split[k == 3 ? 2 : k];
      if (kind == VESICA_CAPSULE) {
        expect_as_general_path<detail::cast::SplitProducts, Capsule>(drawn[k], end, quick);
      } else {
        expect_as_general_path<detail::cast::SplitProducts, RoundRect>(drawn[k], end, quick);
      }
      ASSERT_FALSE(HasFailure()) << k;
    }
  }
  // A path that is never taken tests nothing.
  EXPECT_GT(split[0].hit + split[0].missed, 0.9 * split[0].asked);
  for (const Quick& quick : split) {
    EXPECT_GT(quick.hit, 0.05 * quick.asked);
    EXPECT_GT(quick.missed, 0.05 * quick.asked);
  }
}

/// The end at the very time of a contact, and beside it.
TYPED_TEST(InflatedCastArrays, AboutTheEnd) {
  using T = TypeParam;
  Random random(properties::seed() + 5);
  int hits = 0;
  each_pair_of_kinds([&](std::int32_t kind_a, std::int32_t kind_b) {
    for (int k = 0; k < arrays(8); ++k) {
      std::vector<Moving> pairs;
      for (int i = 0; i < 12; ++i) {
        pairs.push_back(aimed(shape(kind_a, random), shape(kind_b, random), 1, random));
        move(pairs.back().b, -2 * pairs.back().vx, -2 * pairs.back().vy);
      }
      const T t = expect_as_single<T>(pairs, std::numeric_limits<T>::infinity(), hits);
      if (std::isnan(t)) continue;
      for (const T end : {std::nextafter(t, T(0)), t, std::nextafter(t, T(100))}) expect_as_single<T>(pairs, end, hits);
    }
  });
  EXPECT_GT(hits, 100 * properties::repeat());
}

/// Numbers that no kernel may answer for, among others.
TYPED_TEST(InflatedCastArrays, OddNumbers) {
  using T = TypeParam;
  Random random(properties::seed() + 6);
  const double odd[] = {0,
                        -0.0,
                        -1,
                        std::numeric_limits<double>::infinity(),
                        std::numeric_limits<double>::quiet_NaN(),
                        std::numeric_limits<T>::denorm_min(),
                        std::numeric_limits<T>::max(),
                        0x1p-70,
                        0x1p70};
  int hits = 0;
  each_pair_of_kinds([&](std::int32_t kind_a, std::int32_t kind_b) {
    for (int k = 0; k < arrays(8); ++k) {
      std::vector<Moving> pairs;
      for (int i = 0; i < 40; ++i) {
        Moving m = aimed(shape(kind_a, random), shape(kind_b, random), 1, random);
        move(m.b, -2 * m.vx, -2 * m.vy);
        if (random.below(3) == 0) {
          double* const places[] = {&m.a.number[static_cast<std::size_t>(random.below(7))],
                                    &m.b.number[static_cast<std::size_t>(random.below(7))], &m.vx, &m.vy};
          *places[random.below(4)] = odd[random.below(9)];
        }
        pairs.push_back(m);
      }
      expect_as_single<T>(pairs, k % 2 == 0 ? std::numeric_limits<T>::infinity() : T(1), hits);
    }
  });
}

}  // namespace
}  // namespace inflated_cast_arrays

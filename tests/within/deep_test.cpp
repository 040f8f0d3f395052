// SPDX-License-Identifier: Apache-2.0
/// Negative distances: do shapes overlap at least so deep? Against whole numbers, against containment of a disc, and
/// against the computed depth; known depths at every scale.
#include <gtest/gtest.h>
#include <vesica.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <vector>

#include "inflated/shapes.hpp"
#include "properties/pair.hpp"

namespace deep_test {
namespace {

using inflated::Shape;
using properties::Random;

constexpr double infinity = std::numeric_limits<double>::infinity(), u = 0x1p-53;

/// Are two shapes at least so deep in one another? Also in the other order.
std::int32_t deep(const Shape& a, const Shape& b, double depth) {
  const std::int32_t answer = vesica_within_f64(a.kind, a.number.data(), b.kind, b.number.data(), -depth);
  EXPECT_EQ(vesica_within_f64(b.kind, b.number.data(), a.kind, a.number.data(), -depth), answer);
  return answer;
}

std::int32_t deep_in_float(const Shape& a, const Shape& b, double depth) {
  float first[7], second[7];
  std::copy(a.number.begin(), a.number.end(), first);
  std::copy(b.number.begin(), b.number.end(), second);
  return vesica_within_f32(a.kind, first, b.kind, second, static_cast<float>(-depth));
}

/// All lengths times a power of two.
Shape scaled(Shape s, double k) {
  const bool has_axis = s.kind == VESICA_RECT || s.kind == VESICA_ELLIPSE || s.kind == VESICA_ROUND_RECT;
  for (std::size_t i = 0; i < s.number.size(); ++i) {
    if (!has_axis || (i != 4 && i != 5)) s.number[i] *= k;
  }
  return s;
}

struct Known {
  Shape a, b;
  double depth;
};

const Known known[] = {
    {{VESICA_CIRCLE, {0, 0, 2}}, {VESICA_CIRCLE, {1, 0, 2}}, 3},
    {{VESICA_CIRCLE, {0, 0, 2}}, {VESICA_CIRCLE, {0, 0, 0.5}}, 2.5},
    {{VESICA_POINT, {3, 4}}, {VESICA_CIRCLE, {0, 0, 7}}, 2},
    {{VESICA_POINT, {0, 0}}, {VESICA_RECT, {3, 4, 3, 4, 3, 1}}, 5},
    {{VESICA_SEGMENT, {-1, 0, 1, 0}}, {VESICA_AABB, {-9, -2, 9, 5}}, 2},
    {{VESICA_SEGMENT, {-2, 0, 2, 0}}, {VESICA_SEGMENT, {0, -1, 0, 3}}, 1},
    {{VESICA_AABB, {0, 0, 4, 4}}, {VESICA_AABB, {1, 3, 3, 9}}, 1},
    {{VESICA_CIRCLE, {0, 5, 7}}, {VESICA_AABB, {-9, -9, 9, 0}}, 2},
    // The corner (3, 4) of the box is 5 away from the centre.
    {{VESICA_CIRCLE, {0, 0, 7}}, {VESICA_AABB, {3, 4, 9, 9}}, 2},
    {{VESICA_CAPSULE, {-1, 0, 1, 0, 0.5}}, {VESICA_CAPSULE, {0, -1, 0, 1, 0.25}}, 1.75},
    {{VESICA_CAPSULE, {-1, 0, 1, 0, 2}}, {VESICA_CAPSULE, {4, 4, 4, 9, 4}}, 1},
    {{VESICA_ROUND_RECT, {0, 0, 1, 0, 3, 2, 1}}, {VESICA_RECT, {0, 0, 0, 1, 1, 1}}, 4},
    // The greatest disc about (12, 0) in an ellipse with half lengths 25 and 15 has radius 12.
    {{VESICA_POINT, {12, 0}}, {VESICA_ELLIPSE, {0, 0, 1, 0, 25, 15}}, 12},
    {{VESICA_POINT, {-48, 36}}, {VESICA_ELLIPSE, {0, 0, -4, 3, 25, 15}}, 60},
    {{VESICA_CIRCLE, {0, 12, 3}}, {VESICA_ELLIPSE, {0, 0, 0, 1, 25, 15}}, 15},
    // The centre is 13 from the point (32, 32), and the ellipse's normal there (27, 20) is (5, 12) / 13.
    {{VESICA_CIRCLE, {32, 32, 20}}, {VESICA_ELLIPSE, {0, 0, 1, 0, 45, 25}}, 7},
    {{VESICA_CAPSULE, {32, 32, 40, 50, 20}}, {VESICA_ELLIPSE, {0, 0, 1, 0, 45, 25}}, 7},
    {{VESICA_AABB, {0, 0, 4, 4}}, {VESICA_ELLIPSE, {2, 2, 1, 0, 9, 0}}, 2},
};

TEST(Deep, KnownAtEveryScale) {
  for (const Known& c : known) {
    for (const int exponent : {-1040, -700, -100, 0, 100, 700, 1015}) {
      const double k = std::ldexp(1, exponent), depth = k * c.depth;
      const Shape a = scaled(c.a, k), b = scaled(c.b, k);
      SCOPED_TRACE(testing::Message() << c.a.kind << ' ' << c.b.kind << ", 2^" << exponent);
      EXPECT_EQ(deep(a, b, depth), 1);
      EXPECT_EQ(deep(a, b, std::nextafter(depth, 0)), 1);
      EXPECT_EQ(deep(a, b, std::nextafter(depth, infinity)), 0);
      EXPECT_EQ(deep(a, b, 0x1p-1074), 1);
      EXPECT_EQ(deep(a, b, infinity), 0);
    }
    EXPECT_EQ(deep_in_float(c.a, c.b, c.depth), 1);
    EXPECT_EQ(deep_in_float(c.a, c.b, std::nextafter(static_cast<float>(c.depth), 99.0f)), 0);
  }
}

/// The sum of two radii and the distance is exact, whatever cancels.
TEST(Deep, SumsAreNotRounded) {
  const Shape a{VESICA_CIRCLE, {0, 0, 1}}, b{VESICA_CIRCLE, {0, 0, 0x1p-60}};
  EXPECT_EQ(deep(a, b, 1), 1);
  EXPECT_EQ(deep(a, b, std::nextafter(1, 2)), 0);
  const Shape beside{VESICA_CIRCLE, {0x1p-60, 0, 0x1p-60}}, farther{VESICA_CIRCLE, {0x1.0000000000001p-60, 0, 0x1p-60}};
  EXPECT_EQ(deep(a, beside, 1), 1);
  EXPECT_EQ(deep(a, farther, 1), 0);
  const Shape huge{VESICA_CIRCLE, {0, 0, 0x1.8p1023}}, point{VESICA_POINT, {0, 0}};
  EXPECT_EQ(deep(huge, huge, 0x1.fffffffffffffp1023), 1);
  EXPECT_EQ(deep(huge, point, 0x1.8p1023), 1);
  EXPECT_EQ(deep(huge, point, 0x1.8000000000001p1023), 0);
}

/// Touching is no depth, and shapes on one line have none.
TEST(Deep, NoDepth) {
  const Known without[] = {
      {{VESICA_AABB, {0, 0, 1, 1}}, {VESICA_AABB, {1, 0, 2, 1}}, 0},
      {{VESICA_CIRCLE, {0, 0, 2}}, {VESICA_CIRCLE, {3, 4, 3}}, 0},
      {{VESICA_POINT, {1, 1}}, {VESICA_POINT, {1, 1}}, 0},
      {{VESICA_POINT, {1, 1}}, {VESICA_SEGMENT, {0, 0, 3, 3}}, 0},
      {{VESICA_SEGMENT, {0, 0, 2, 2}}, {VESICA_SEGMENT, {1, 1, 3, 3}}, 0},
      {{VESICA_SEGMENT, {1, 1, 1, 1}}, {VESICA_CIRCLE, {1, 1, 0}}, 0},
      {{VESICA_ELLIPSE, {0, 0, 1, 0, 2, 1}}, {VESICA_ELLIPSE, {4, 0, 1, 0, 2, 1}}, 0},
      {{VESICA_ELLIPSE, {0, 0, 1, 0, 2, 1}}, {VESICA_AABB, {2, 0, 4, 4}}, 0},
      {{VESICA_ELLIPSE, {0, 0, 1, 0, 2, 0}}, {VESICA_SEGMENT, {-9, 0, 9, 0}}, 0},
      {{VESICA_CIRCLE, {0, 0, 1}}, {VESICA_CIRCLE, {9, 0, 1}}, 0},
  };
  for (const Known& c : without) {
    SCOPED_TRACE(testing::Message() << c.a.kind << ' ' << c.b.kind);
    for (const double depth : {0x1p-1074, 1e-300, 1e-9, 1.0, 1e300, infinity}) EXPECT_EQ(deep(c.a, c.b, depth), 0);
    EXPECT_EQ(deep(c.a, c.b, -0.0), deep(c.a, c.b, 0.0));
  }
}

/// No bound on the depth of thin ellipses is stated, so that bounds of the shape decide. Points and circles are exact.
TEST(Deep, ThinEllipses) {
  const Shape needle{VESICA_ELLIPSE, {0, 0, 0, 1, 9, 0x1p-30}};
  const Shape box{VESICA_AABB, {-2, -20, 5, 20}}, other{VESICA_ELLIPSE, {1, 0, 0, 1, 8, 0x1p-22}};
  EXPECT_EQ(deep(needle, box, 2), VESICA_WITHIN_YES);
  EXPECT_EQ(deep(needle, box, 2 + 0x1p-31), VESICA_WITHIN_NEARLY);
  EXPECT_EQ(deep(needle, box, 2 + 0x1p-29), VESICA_WITHIN_NO);
  EXPECT_EQ(deep(needle, other, 0x1p-1074), VESICA_WITHIN_NO);
  EXPECT_EQ(deep(needle, needle, 0x1p-28), VESICA_WITHIN_NO);
  EXPECT_EQ(deep(needle, {VESICA_POINT, {0, 0}}, 0x1p-30), VESICA_WITHIN_YES);
  EXPECT_EQ(deep(needle, {VESICA_POINT, {0, 0}}, 0x1.0000000000001p-30), VESICA_WITHIN_NO);
  const Shape flat{VESICA_RECT, {0, 0, 0, 1, 4, 0x1p-30}}, oval{VESICA_ELLIPSE, {1, 0, 0, 1, 9, 4}};
  EXPECT_EQ(deep(flat, oval, 3 - 0x1p-40), VESICA_WITHIN_YES);
  EXPECT_EQ(deep(flat, oval, 3 + 0x1p-31), VESICA_WITHIN_NEARLY);
  EXPECT_EQ(deep(flat, oval, 3 + 0x1p-28), VESICA_WITHIN_NO);
  // vesica_depth_f64 takes 2^43 for the depth here, which is 1.4 times 2^42.
  const Shape disc{VESICA_CIRCLE, {0, 0, 0x1p46}};
  const Shape line{VESICA_ELLIPSE, {0x1.cp+45, 0x1p+45, 0, 1, 0x1p+42, 0x1p-23}};
  EXPECT_EQ(deep(disc, line, 0x1.98d828p+42), VESICA_WITHIN_NO);
  EXPECT_EQ(deep(disc, line, 0x1.6p+40), VESICA_WITHIN_YES);
}

// ---- Whole numbers ----

struct Place {
  std::int64_t x, y;
};

/// A shape with whole corners, which are those of its core.
struct Lattice {
  Shape shape;
  std::vector<Place> corners;
  std::int64_t radius;
};

/// Multiples of 5 with axes such as (3, 4), so that many depths are whole.
Lattice lattice(Random& random) {
  static constexpr std::int32_t kinds[] = {VESICA_POINT, VESICA_SEGMENT, VESICA_CIRCLE,    VESICA_AABB,
                                           VESICA_RECT,  VESICA_CAPSULE, VESICA_ROUND_RECT};
  static constexpr Place axes[] = {{5, 0}, {0, 5}, {3, 4}, {-4, 3}, {4, -3}, {5, 5}, {2, -1}, {-10, 0}};
  const auto five = [&](int most) { return 5 * random.integer(-most, most); };
  const std::int32_t kind = kinds[random.below(7)];
  const std::int64_t x = five(4), y = five(4), radius = random.integer(0, 12);
  const auto real = [](std::int64_t n) { return static_cast<double>(n); };
  switch (kind) {
    case VESICA_POINT:
    case VESICA_CIRCLE:
      return {{kind, {real(x), real(y), kind == VESICA_CIRCLE ? real(radius) : 0}},
              {{x, y}},
              kind == VESICA_CIRCLE ? radius : 0};
    case VESICA_SEGMENT:
    case VESICA_CAPSULE:
    case VESICA_AABB: {
      const bool is_box = kind == VESICA_AABB;
      const std::int64_t to_x = is_box ? x + std::abs(five(6)) : x + five(6);
      const std::int64_t to_y = is_box ? y + std::abs(five(6)) : y + five(6);
      const double stored = kind == VESICA_CAPSULE ? real(radius) : 0;
      Lattice s{{kind, {real(x), real(y), real(to_x), real(to_y), stored}},
                {{x, y}, {to_x, to_y}},
                kind == VESICA_CAPSULE ? radius : 0};
      if (is_box) s.corners.insert(s.corners.end(), {{x, to_y}, {to_x, y}});
      return s;
    }
    default: {
      const Place axis = axes[random.below(8)];
      const std::int64_t hx = random.integer(0, 5), hy = random.integer(0, 5);
      const bool is_round = kind == VESICA_ROUND_RECT;
      Lattice s{{kind, {real(x), real(y), real(axis.x), real(axis.y), real(hx), real(hy), is_round ? real(radius) : 0}},
                {},
                is_round ? radius : 0};
      for (const std::int64_t i : {-hx, hx}) {
        for (const std::int64_t j : {-hy, hy})
          s.corners.push_back({x + i * axis.x - j * axis.y, y + i * axis.y + j * axis.x});
      }
      return s;
    }
  }
}

std::int64_t cross(Place a, Place b) { return a.x * b.y - a.y * b.x; }
std::int64_t dot(Place a, Place b) { return a.x * b.x + a.y * b.y; }
Place minus(Place a, Place b) { return {a.x - b.x, a.y - b.y}; }

/// Does the hull of some points contain the disc of radius t about the origin? `strictly`: a greater one too.
bool hull_has_disc(const std::vector<Place>& hull, std::int64_t t, bool strictly) {
  bool has_area = false;
  for (const Place& p : hull) {
    for (const Place& q : hull) {
      const Place e = minus(q, p);
      if (dot(e, e) == 0) continue;
      bool is_side = true, is_line = true;
      for (const Place& r : hull) {
        is_side = is_side && cross(e, minus(r, p)) >= 0;
        is_line = is_line && cross(e, minus(r, p)) == 0;
      }
      if (!is_side) continue;
      if (is_line) return false;
      has_area = true;
      const std::int64_t side = -cross(e, p), squares = side * side - t * t * dot(e, e);
      if (side < 0 || (strictly ? side == 0 || squares <= 0 : squares < 0)) return false;
    }
  }
  return has_area;
}

/// Is the hull of some points at most r from the origin, or closer?
bool hull_within(const std::vector<Place>& hull, std::int64_t r, bool closer) {
  const auto near = [&](std::int64_t square, std::int64_t unit) {
    return closer ? square < r * r * unit : square <= r * r * unit;
  };
  for (const Place& p : hull) {
    if (near(dot(p, p), 1)) return true;
    for (const Place& q : hull) {
      const Place e = minus(q, p);
      const bool has_foot = dot(e, p) <= 0 && dot(e, q) >= 0 && dot(e, e) > 0;
      if (has_foot && near(cross(e, p) * cross(e, p), dot(e, e))) return true;
    }
  }
  return (!closer || r > 0) && hull_has_disc(hull, 0, false);
}

/// Is the depth of two shapes at least t > 0, or more?
bool deep_on_lattice(const Lattice& a, const Lattice& b, std::int64_t t, bool more) {
  std::vector<Place> difference;
  for (const Place& p : a.corners) {
    for (const Place& q : b.corners) difference.push_back(minus(q, p));
  }
  const std::int64_t reach = a.radius + b.radius - t;
  if (reach > 0 || (reach == 0 && !more)) return hull_within(difference, reach, more);
  return hull_has_disc(difference, -reach, more);
}

TEST(Deep, OnLattices) {
  std::printf("VESICA_SEED=%llu\n", static_cast<unsigned long long>(properties::seed()));
  Random random(properties::seed() + 41);
  int yes = 0, exactly = 0;
  for (int i = 0; i < 40000 * properties::repeat(); ++i) {
    const Lattice a = lattice(random), b = lattice(random);
    const std::int64_t t = random.integer(1, 20);
    const double k = std::ldexp(1, random.integer(-3, 3) * 330), depth = k * static_cast<double>(t);
    const Shape p = scaled(a.shape, k), q = scaled(b.shape, k);
    const bool at_least = deep_on_lattice(a, b, t, false), more = deep_on_lattice(a, b, t, true);
    ASSERT_EQ(deep(p, q, depth), at_least) << i;
    ASSERT_EQ(deep(p, q, std::nextafter(depth, 0)), at_least) << i;
    ASSERT_EQ(deep(p, q, std::nextafter(depth, infinity)), more) << i;
    ASSERT_EQ(deep_in_float(a.shape, b.shape, static_cast<double>(t)), at_least) << i;
    yes += at_least;
    exactly += at_least != more;
  }
  EXPECT_GT(yes, 1000 * properties::repeat());
  EXPECT_GT(exactly, 200 * properties::repeat());
}

// ---- Containment and depth ----

/// The place of the greatest depth that two shapes have at least, without doubt; 0 if they have none.
std::int64_t greatest(const Shape& a, const Shape& b) {
  std::int64_t low = 0, high = properties::ordinal(properties::Scalar::f64, 0x1p1000);
  while (high - low > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (deep(a, b, properties::at_ordinal(properties::Scalar::f64, middle)) == 1 ? low : high) = middle;
  }
  return low;
}

/// A point is at least t deep in a shape iff the shape contains the disc of radius t about it.
TEST(Deep, OfPointsIsContainmentOfDiscs) {
  Random random(properties::seed() + 42);
  const auto contains = [](const Shape& s, const Shape& disc) {
    return vesica_contains_f64(s.kind, s.number.data(), disc.kind, disc.number.data());
  };
  for (int i = 0; i < 2000 * properties::repeat(); ++i) {
    Shape s = inflated::any_shape(random);
    if (s.kind == VESICA_ELLIPSE && random.chance(0.3)) s.number[5] *= 0x1p-30;
    const double x = s.number[0] + random.between(-1, 1), y = s.number[1] + random.between(-1, 1);
    const double r = random.chance(0.5) ? 0 : std::ldexp(1, random.integer(-60, 1));
    const Shape centre{r == 0 ? VESICA_POINT : VESICA_CIRCLE, {x, y, r}};
    const std::int64_t place = greatest(centre, s);
    for (int k = -2; k <= 2; ++k) {
      const double t = properties::at_ordinal(properties::Scalar::f64, std::max<std::int64_t>(place + k, 1));
      const double rest = t - r;
      if (!(rest > 0) || rest + r != t || t - rest != r) continue;
      ASSERT_EQ(deep(centre, s, t), contains(s, {VESICA_CIRCLE, {x, y, rest}})) << i << ", " << k;
    }
  }
}

/// The answer turns where the computed depth is, but for rounding. Only with ellipses it may be open about there.
TEST(Deep, TurnsAtTheDepth) {
  Random random(properties::seed() + 43);
  int deep_pairs = 0, open = 0;
  for (int i = 0; i < 4000 * properties::repeat(); ++i) {
    const Shape a = inflated::any_shape(random), b = inflated::any_shape(random);
    vesica_penetration_f64 found;
    ASSERT_EQ(vesica_depth_f64(a.kind, a.number.data(), b.kind, b.number.data(), &found), 0);
    // Offsets are below 8, other lengths below 4.
    const double error = 5 * u * (8 + found.depth);
    const bool may_be_open = (a.kind == VESICA_ELLIPSE && b.kind != VESICA_POINT && b.kind != VESICA_CIRCLE) ||
                             (b.kind == VESICA_ELLIPSE && a.kind != VESICA_POINT && a.kind != VESICA_CIRCLE);
    const std::int64_t least = greatest(a, b);
    const double turn = properties::at_ordinal(properties::Scalar::f64, least);
    ASSERT_NEAR(turn, found.depth, 2 * error) << i;
    if (found.depth == 0) continue;
    ++deep_pairs;
    const double next = properties::at_ordinal(properties::Scalar::f64, least + 1);
    ASSERT_EQ(deep(a, b, next), may_be_open && deep(a, b, next) != 0 ? VESICA_WITHIN_NEARLY : VESICA_WITHIN_NO) << i;
    open += deep(a, b, found.depth) == VESICA_WITHIN_NEARLY;
    ASSERT_EQ(deep(a, b, found.depth + 2 * error), VESICA_WITHIN_NO) << i;
    if (found.depth > 2 * error) {
      ASSERT_EQ(deep(a, b, found.depth - 2 * error), VESICA_WITHIN_YES) << i;
    }
    ASSERT_EQ(deep(a, b, found.depth * random.unit() * 0.99), VESICA_WITHIN_YES) << i;
    ASSERT_EQ(deep(a, b, found.depth * 1.01 + random.unit()), VESICA_WITHIN_NO) << i;
  }
  EXPECT_GT(deep_pairs, 200 * properties::repeat());
  EXPECT_GT(open, 0);
}

/// Arrays have the answers of single calls.
TEST(Deep, Arrays) {
  Random random(properties::seed() + 44);
  for (const std::int32_t kind_a : {VESICA_CIRCLE, VESICA_RECT, VESICA_ELLIPSE, VESICA_ROUND_RECT}) {
    for (const std::int32_t kind_b : {VESICA_SEGMENT, VESICA_AABB, VESICA_ELLIPSE, VESICA_CAPSULE}) {
      const inflated::Columns<double> a(kind_a, 12, random), b(kind_b, 12, random);
      const auto first = inflated::array(a), second = inflated::array(b);
      std::uint8_t matrix[144], many[12];
      const double distance = -random.between(0, 0.5);
      std::int64_t count = 0, in_step = 0;
      const std::int64_t of_matrix = vesica_within_matrix_f64(&first, &second, distance, matrix, 12);
      const std::int64_t of_many = vesica_within_many_f64(&first, &second, distance, many);
      for (std::size_t i = 0; i < 12; ++i) {
        for (std::size_t j = 0; j < 12; ++j) {
          const std::int32_t one = deep(a.at(i), b.at(j), -distance);
          ASSERT_EQ(matrix[12 * i + j], one);
          if (i == j) {
            ASSERT_EQ(many[i], one);
          }
          count += one > 0;
          in_step += i == j && one > 0;
        }
      }
      EXPECT_EQ(of_matrix, count);
      EXPECT_EQ(of_many, in_step);
    }
  }
}

}  // namespace
}  // namespace deep_test

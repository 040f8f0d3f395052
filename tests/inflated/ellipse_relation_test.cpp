// SPDX-License-Identifier: Apache-2.0
// Relations of an ellipse and a core with a radius, against rational numbers: each edge and each arc of the core's
// outline, along which the ellipse's quadratic form is a polynomial, whose signs Sturm's theorem finds.
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <vesica.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <utility>
#include <vector>
#include <vesica/relation.hpp>

#include "inflated/shapes.hpp"
#include "oracle/polynomial.hpp"

namespace inflated_ellipse_relation_test {
namespace {

using namespace inflated;
using oracle::Polynomial;
using properties::Random;

struct Vector {
  mpq_class x, y;
};
Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y}; }
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
Vector operator*(const mpq_class& k, const Vector& a) { return {k * a.x, k * a.y}; }

/// A polynomial in t, constant first.
using Rational = std::vector<mpq_class>;

Rational product(const Rational& f, const Rational& g) {
  Rational h(f.size() + g.size() - 1);
  for (std::size_t i = 0; i < f.size(); ++i) {
    for (std::size_t j = 0; j < g.size(); ++j) h[i + j] += f[i] * g[j];
  }
  return h;
}

/// The signs that the ellipse's form takes along an outline: inside it, on its rim, outside.
struct Signs {
  bool inside = false, on = false, outside = false;
};

void add_sign(Signs& signs, int sign) {
  signs.inside |= sign < 0;
  signs.on |= sign == 0;
  signs.outside |= sign > 0;
}

int sign_at_1(const Polynomial& f) {
  mpz_class sum = 0;
  for (const mpz_class& x : f) sum += x;
  return sgn(sum);
}

/// f / (1 - t), for f(1) = 0.
Polynomial divided_by_1_minus_t(const Polynomial& f) {
  Polynomial g;
  mpz_class sum = 0;
  for (std::size_t i = 0; i + 1 < f.size(); ++i) g.push_back(sum += f[i]);
  return g;
}

/// The signs of f on [0, 1].
void add_signs(Signs& signs, const Rational& rational) {
  mpz_class denominator = 1;
  for (const mpq_class& x : rational) denominator = lcm(denominator, x.get_den());
  Polynomial f;
  for (const mpq_class& x : rational) f.push_back(x.get_num() * (denominator / x.get_den()));
  while (!f.empty() && f.back() == 0) f.pop_back();
  if (f.empty()) return add_sign(signs, 0);
  add_sign(signs, sgn(f.front()));
  add_sign(signs, sign_at_1(f));
  while (f.front() == 0) f.erase(f.begin());
  while (sign_at_1(f) == 0) f = divided_by_1_minus_t(f);
  add_sign(signs, sgn(f.front()));
  add_sign(signs, sign_at_1(f));
  // Roots between 0 and 1 of at least each multiplicity: f changes its sign at those of an odd one.
  int changes = 0, sign = 1;
  for (Polynomial g = f; g.size() > 1; g = oracle::repeated_part(g), sign = -sign) {
    const int roots = oracle::distinct_roots_below_1(g);
    if (roots == 0) break;
    signs.on = true;
    changes += sign * roots;
  }
  if (changes > 0) add_sign(signs, 1), add_sign(signs, -1);
}

/// The form of an ellipse, negative inside, times (1 + t^2)^2 at the centre + p + q (1 - t^2) / (1 + t^2) +
/// s 2t / (1 + t^2); or at p + t q.
struct Form {
  Vector centre, axis;
  mpq_class a, b;

  explicit Form(const Numbers& n) : centre{n[0], n[1]}, axis{n[2], n[3]}, a(n[4]), b(n[5]) {}
  Rational along(const Rational& x, const Rational& y, const Rational& scale) const {
    Rational f;
    const auto add = [&f](const mpq_class& k, const Rational& g) {
      if (f.size() < g.size()) f.resize(g.size());
      for (std::size_t i = 0; i < g.size(); ++i) f[i] += k * g[i];
    };
    Rational u(x.size()), v(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      u[i] = b * (axis.x * x[i] + axis.y * y[i]);
      v[i] = a * (axis.x * y[i] - axis.y * x[i]);
    }
    const mpq_class radius = a * b * (axis.x * axis.x + axis.y * axis.y);
    add(1, product(u, u));
    add(1, product(v, v));
    add(-radius * radius, product(scale, scale));
    return f;
  }
  Rational on_arc(const Vector& p, const Vector& q, const Vector& s) const {
    const Vector d = p - centre;
    return along({d.x + q.x, 2 * s.x, d.x - q.x}, {d.y + q.y, 2 * s.y, d.y - q.y}, {1, 0, 1});
  }
  Rational on_edge(const Vector& p, const Vector& q) const {
    const Vector d = p - centre;
    return along({d.x, q.x}, {d.y, q.y}, {1});
  }
};

mpq_class root(const mpq_class& square) {
  mpq_class r;
  mpz_sqrt(r.get_num_mpz_t(), square.get_num_mpz_t());
  mpz_sqrt(r.get_den_mpz_t(), square.get_den_mpz_t());
  EXPECT_EQ(r * r, square);
  return r;
}

/// A core with a radius, on an axis of rational length.
struct Rounded {
  Vector centre, u, v;  ///< u, v: of length 1
  mpq_class hx, hy, r;

  explicit Rounded(const Shape& s) {
    const Numbers& n = s.number;
    Vector axis;
    if (s.kind == VESICA_CAPSULE) {
      const Vector from{n[0], n[1]}, to{n[2], n[3]};
      centre = mpq_class(1, 2) * (from + to);
      axis = to - from;
      hx = mpq_class(1, 2), hy = 0, r = n[4];
      if (axis.x == 0 && axis.y == 0) axis.x = 1, hx = 0;
    } else {
      centre = {n[0], n[1]}, axis = {n[2], n[3]};
      hx = n[4], hy = n[5], r = n[6];
    }
    const mpq_class length = root(axis.x * axis.x + axis.y * axis.y);
    u = 1 / length * axis;
    v = {-u.y, u.x};
    hx *= length, hy *= length;
  }
};

/// By the definition of vesica.h, for r > 0 and an ellipse with an area.
int relation(const Numbers& ellipse, const Shape& shape) {
  const Form form(ellipse);
  const Rounded k(shape);
  Signs signs;
  for (const int i : {-1, 1}) {
    for (const int j : {-1, 1}) {
      const Vector x = mpq_class(i) * k.u, y = mpq_class(j) * k.v, p = k.centre + k.hx * x + k.hy * y;
      add_signs(signs, form.on_arc(p, k.r * x, k.r * y));
      add_signs(signs, form.on_edge(p + k.r * x, -2 * k.hy * y));
      add_signs(signs, form.on_edge(p + k.r * y, -2 * k.hx * x));
    }
  }
  if (!signs.inside && !signs.outside) return VESICA_EQUAL;
  if (signs.inside && signs.outside) return VESICA_CROSS;
  if (signs.inside) return signs.on ? VESICA_CONTAINS_TOUCH : VESICA_CONTAINS;
  const Vector d = form.centre - k.centre;
  const mpq_class x = abs(d.x * k.u.x + d.y * k.u.y) - k.hx, y = abs(d.x * k.v.x + d.y * k.v.y) - k.hy;
  const mpq_class out_x = x > 0 ? x : mpq_class(0), out_y = y > 0 ? y : mpq_class(0);
  if (out_x * out_x + out_y * out_y < k.r * k.r) return signs.on ? VESICA_INSIDE_TOUCH : VESICA_INSIDE;
  return signs.on ? VESICA_TOUCH : VESICA_DISJOINT;
}

int asked(const Shape& a, const Shape& b) {
  return vesica_relation_f64(a.kind, a.number.data(), b.kind, b.number.data());
}

int converse(int code) { return code == 3 || code == 4 ? code + 2 : code == 5 || code == 6 ? code - 2 : code; }

/// By exact numbers alone: the filter decides most pairs.
int exactly(const Shape& ellipse, const Shape& s) {
  const auto &e = ellipse.number, &n = s.number;
  const vesica::Ellipse<double> a{e[0], e[1], e[2], e[3], e[4], e[5]};
  if (s.kind == VESICA_CAPSULE)
    return vesica::detail::decide_relation(a, vesica::Capsule<double>{n[0], n[1], n[2], n[3], n[4]});
  return vesica::detail::decide_relation(a, vesica::RoundRect<double>{n[0], n[1], n[2], n[3], n[4], n[5], n[6]});
}

testing::AssertionResult agrees(const Shape& ellipse, const Shape& s) {
  const int truth = relation(ellipse.number, s), found = asked(ellipse, s), exchanged = asked(s, ellipse);
  const int exact = exactly(ellipse, s);
  if (found == truth && exact == truth && exchanged == converse(truth)) return testing::AssertionSuccess();
  auto failed = testing::AssertionFailure();
  failed << found << ", " << exact << " and " << exchanged << " in place of " << truth << "\n";
  char text[32];
  for (const Shape* shape : {&ellipse, &s}) {
    failed << shape->kind;
    for (const double x : shape->number) std::snprintf(text, sizeof text, " %a", x), failed << text;
    failed << "\n";
  }
  return failed;
}

/// Both shapes alike: turned by a quarter, or mirrored.
Shape turned(Shape s) {
  auto& n = s.number;
  for (const std::size_t i : {std::size_t{0}, std::size_t{2}}) n[i] = -std::exchange(n[i + 1], n[i]);
  return s;
}
Shape mirrored(Shape s) {
  auto& n = s.number;
  n[1] = -n[1], n[3] = -n[3];
  return s;
}
void expect_laws(const Shape& ellipse, const Shape& s, int code) {
  EXPECT_EQ(asked(s, ellipse), converse(code));
  EXPECT_EQ(asked(turned(ellipse), turned(s)), code);
  EXPECT_EQ(asked(mirrored(ellipse), mirrored(s)), code);
  for (const double k : {0x1p-900, 0x1p-30, 0x1p200, 0x1p900}) {
    const Shape a = times(ellipse, k), b = times(s, k);
    EXPECT_EQ(asked(a, b), code) << k;
    EXPECT_EQ(asked(b, a), converse(code)) << k;
  }
  const auto contains = [](const Shape& a, const Shape& b) {
    return vesica_contains_f64(a.kind, a.number.data(), b.kind, b.number.data());
  };
  EXPECT_EQ(contains(ellipse, s), code >= VESICA_CONTAINS);
  EXPECT_EQ(contains(s, ellipse), converse(code) >= VESICA_CONTAINS);
  EXPECT_EQ(vesica_overlap_f64(ellipse.kind, ellipse.number.data(), s.kind, s.number.data()), code != VESICA_DISJOINT);
}

struct Known {
  Shape ellipse, s;
  int code, less, more;  ///< with the radius of s as it is, and a place less and more
};

/// Contacts of each kind. At the point (64, 27) of the ellipse with half lengths 80 and 45 the normal is (3, 4) / 5 and
/// the radius of curvature 60.
TEST(InflatedEllipseRelation, KnownContacts) {
  constexpr int C = VESICA_CAPSULE, R = VESICA_ROUND_RECT, E = VESICA_ELLIPSE;
  const Known all[] = {
      // The ellipse's farthest point from a corner is on the arc there.
      {{E, {0, 0, 1, 0, 80, 45}},
       {R, {-111, -173, 1, 0, 100, 100, 125}},
       VESICA_INSIDE_TOUCH,
       VESICA_CROSS,
       VESICA_INSIDE},
      // Its farthest points are two, mirror images. Both are beside the end of a capsule, one is beside a corner.
      {{E, {0, 0, 1, 0, 240, 135}}, {C, {0, -175, 0, -1000, 320}}, VESICA_INSIDE_TOUCH, VESICA_CROSS, VESICA_INSIDE},
      {{E, {0, 0, 1, 0, 240, 135}},
       {R, {-100, -275, 1, 0, 100, 100, 320}},
       VESICA_INSIDE_TOUCH,
       VESICA_CROSS,
       VESICA_INSIDE},
      {{E, {0, 0, 1, 0, 240, 135}},
       {R, {100, -275, 1, 0, 100, 100, 320}},
       VESICA_INSIDE_TOUCH,
       VESICA_CROSS,
       VESICA_INSIDE},
      // The second farthest point is on the arc, and the farthest one not in the corner's cone.
      {{E, {0, 0, 1, 0, 80, 45}},
       {R, {-441, -173, 15, -8, 20, 20, 75}},
       VESICA_INSIDE_TOUCH,
       VESICA_CROSS,
       VESICA_INSIDE},
      // So is the closest point beside it; or neither is, and both are farther than the radius and closer.
      {{E, {0, 0, 1, 0, 80, 45}},
       {R, {-1180, -835, 99, -20, 10, 10, 90}},
       VESICA_INSIDE_TOUCH,
       VESICA_CROSS,
       VESICA_INSIDE},
      {{E, {0, 0, 1, 0, 80, 45}}, {R, {-690, 55, 4, 3, 100, 100, 89.5}}, VESICA_INSIDE, VESICA_INSIDE, VESICA_INSIDE},
      // The same on the greater axis, which the corner is on.
      {{E, {0, 0, 3, 4, 10, 4}}, {R, {-94, -92, 1, 0, 100, 100, 40}}, VESICA_INSIDE_TOUCH, VESICA_CROSS, VESICA_INSIDE},
      // The farthest point is on the disc, but the arc is elsewhere.
      {{E, {0, 0, 3, 4, 10, 4}}, {R, {-94, -92, 1, 0, 100, 100, 60}}, VESICA_INSIDE, VESICA_INSIDE, VESICA_INSIDE},
      // At the end of the arc the ellipse has the curvature of the disc, and bends more beyond.
      {{E, {0, 0, 1, 0, 80, 45}}, {R, {-252, -61, 3, 4, 40, 40, 60}}, VESICA_INSIDE_TOUCH, VESICA_CROSS, VESICA_INSIDE},
      // It touches a side where the arc begins, and crosses the arc: its distance from the corner has a minimum there.
      {{E, {0, 0, 1, 0, 585, 325}}, {R, {-1479, -752, 5, 12, 100, 100, 338}}, VESICA_CROSS, VESICA_CROSS, VESICA_CROSS},
      // It touches two sides where they end, and its tip is beyond the arc between.
      {{E, {0, 0, 1, 1, 20, 15}}, {R, {-33, -33, 1, 0, 40, 40, 18}}, VESICA_CROSS, VESICA_CROSS, VESICA_CROSS},
      // It touches both sides of a capsule, whose ends are its tips. Then sides alone, which end short of it.
      {{E, {0, 0, 1, 0, 5, 2}}, {C, {-3, 0, 3, 0, 2}}, VESICA_INSIDE_TOUCH, VESICA_CROSS, VESICA_INSIDE},
      {{E, {0, 0, 1, 0, 4, 2}}, {C, {-3, 0, 3, 0, 2}}, VESICA_INSIDE_TOUCH, VESICA_CROSS, VESICA_INSIDE},
      {{E, {0, 0, 1, 0, 6, 2}}, {C, {-3, 0, 3, 0, 2}}, VESICA_CROSS, VESICA_CROSS, VESICA_CROSS},
      // A disc, against an arc, and against an arc of its own radius.
      {{E, {3, 4, 1, 0, 1, 1}}, {R, {-10, -10, 1, 0, 10, 10, 6}}, VESICA_INSIDE_TOUCH, VESICA_CROSS, VESICA_INSIDE},
      {{E, {0, 0, 1, 0, 6, 6}}, {C, {0, 0, 10, 0, 6}}, VESICA_INSIDE_TOUCH, VESICA_CROSS, VESICA_INSIDE},
      // A capsule about an ellipse touches its four vertices. In an ellipse discs of its ends touch.
      {{E, {0, 0, 1, 0, 5, 4}}, {C, {-1, 0, 1, 0, 4}}, VESICA_INSIDE_TOUCH, VESICA_CROSS, VESICA_INSIDE},
      {{E, {0, 0, 1, 0, 5, 4}}, {C, {-2, 0, 2, 0, 3}}, VESICA_CONTAINS_TOUCH, VESICA_CONTAINS, VESICA_CROSS},
      {{E, {0, 0, 1, 0, 25, 20}}, {C, {-9, 0, 0, 0, 16}}, VESICA_CONTAINS_TOUCH, VESICA_CONTAINS, VESICA_CROSS},
      {{E, {0, 0, 1, 0, 80, 45}}, {R, {10, 0, 1, 0, 18, 3, 24}}, VESICA_CONTAINS, VESICA_CONTAINS, VESICA_CONTAINS},
      // From outside.
      {{E, {0, 0, 1, 0, 80, 45}}, {R, {79, 47, 3, 4, 0, 0, 25}}, VESICA_TOUCH, VESICA_DISJOINT, VESICA_CROSS},
      {{E, {0, 0, 1, 0, 80, 45}}, {C, {79, 47, 160, 155, 25}}, VESICA_TOUCH, VESICA_DISJOINT, VESICA_CROSS},
      // One set.
      {{E, {1, 2, 3, 4, 2, 2}}, {C, {1, 2, 1, 2, 10}}, VESICA_EQUAL, VESICA_CONTAINS, VESICA_INSIDE},
      {{E, {1, 2, 3, 4, 2, 2}}, {R, {1, 2, 5, 12, 0, 0, 10}}, VESICA_EQUAL, VESICA_CONTAINS, VESICA_INSIDE},
  };
  for (const Known& known : all) {
    SCOPED_TRACE(&known - all);
    Shape s = known.s;
    double& r = s.number[s.kind == C ? 4 : 6];
    const double radius = r;
    for (const auto& [to, code] : {std::pair{radius, known.code}, std::pair{0.0, known.less},
                                   std::pair{std::numeric_limits<double>::infinity(), known.more}}) {
      r = std::nextafter(radius, to);
      EXPECT_EQ(asked(known.ellipse, s), code) << r - radius;
      EXPECT_TRUE(agrees(known.ellipse, s)) << r - radius;
      expect_laws(known.ellipse, s, code);
    }
  }
}

/// Without a radius a shape is its core, and without a size a circle. An ellipse of one axis is a segment.
TEST(InflatedEllipseRelation, SimplerShapes) {
  Random random(properties::seed());
  for (int i = 0; i < 4000 * properties::repeat(); ++i) {
    const Shape ellipse = shape(VESICA_ELLIPSE, random);
    Shape capsule = shape(VESICA_CAPSULE, random), rect = shape(VESICA_ROUND_RECT, random);
    Shape thin = ellipse;
    thin.number[5] = 0;
    const auto &n = thin.number, &c = capsule.number;
    const Shape segment{VESICA_RECT, {n[0], n[1], n[2], n[3], n[4], 0}};
    ASSERT_EQ(asked(thin, capsule), asked(segment, capsule));
    ASSERT_EQ(asked(rect, thin), asked(rect, segment));
    Shape disc{VESICA_CAPSULE, {c[0], c[1], c[0], c[1], c[4]}}, circle{VESICA_CIRCLE, {c[0], c[1], c[4]}};
    ASSERT_EQ(asked(ellipse, disc), asked(ellipse, circle));
    disc = {VESICA_ROUND_RECT, {c[0], c[1], n[2], n[3], 0, 0, c[4]}};
    ASSERT_EQ(asked(disc, ellipse), asked(circle, ellipse));
    capsule.number[4] = rect.number[6] = 0;
    ASSERT_EQ(asked(ellipse, capsule), asked(ellipse, core(capsule)));
    ASSERT_EQ(asked(rect, ellipse), asked(core(rect), ellipse));
  }
}

/// Axes of rational length.
constexpr std::array<std::array<int, 2>, 8> axes{
    {{1, 0}, {0, -2}, {3, 4}, {-4, 3}, {5, 12}, {8, -15}, {-7, -24}, {20, 21}}};

Shape on_lattice(std::int32_t kind, Random& random) {
  const auto integer = [&](int low, int high) { return static_cast<double>(random.integer(low, high)); };
  const auto& [ux, uy] = axes[static_cast<std::size_t>(random.below(axes.size()))];
  const double x = integer(-16, 16), y = integer(-16, 16), r = integer(1, 24);
  if (kind == VESICA_CAPSULE) {
    const double k = integer(0, 4);
    return {kind, {x, y, x + k * ux, y + k * uy, r}};
  }
  return {kind, {x, y, static_cast<double>(ux), static_cast<double>(uy), integer(0, 3), integer(0, 3), r}};
}
Shape ellipse_on_lattice(Random& random) {
  const auto integer = [&](int low, int high) { return static_cast<double>(random.integer(low, high)); };
  const auto& [ux, uy] = axes[static_cast<std::size_t>(random.below(axes.size()))];
  const bool is_long = random.chance(0.5);
  const double k = std::exp2(random.integer(-3, 3));
  return {VESICA_ELLIPSE,
          {integer(-16, 16), integer(-16, 16), ux * k, uy * k, integer(1, is_long ? 24 : 8) / k / 2,
           integer(1, 8) / k / 2}};
}

TEST(InflatedEllipseRelation, AgreesWithRationalNumbersOnALattice) {
  Random random(properties::seed());
  std::array<int, 8> seen{};
  const int cases = 12000 * properties::repeat();
  for (int i = 0; i < cases; ++i) {
    const Shape ellipse = ellipse_on_lattice(random);
    const Shape s = on_lattice(random.chance(0.5) ? VESICA_CAPSULE : VESICA_ROUND_RECT, random);
    ASSERT_TRUE(agrees(ellipse, s)) << "case " << i;
    ++seen[static_cast<std::size_t>(asked(ellipse, s))];
  }
  for (const int code : {VESICA_DISJOINT, VESICA_TOUCH, VESICA_CROSS, VESICA_INSIDE, VESICA_INSIDE_TOUCH,
                         VESICA_CONTAINS, VESICA_CONTAINS_TOUCH})
    std::printf("%d: %d\n", code, seen[static_cast<std::size_t>(code)]);
}

/// Turns a number between two by halves until the relation no longer changes there.
struct Bracket {
  double from, to;
};

/// Moves one number of the pair until containment ends; a few places on either side are asked.
void expect_agreement_beside_contact(Shape ellipse, Shape s, Random& random, int& found) {
  const auto nested = [&] { return asked(ellipse, s) >= VESICA_INSIDE; };
  // The axis of the core stays, as its length must be rational.
  const bool of_ellipse = random.chance(0.7);
  const std::size_t field = of_ellipse ? static_cast<std::size_t>(random.below(6))
                            : s.kind == VESICA_CAPSULE
                                ? 4
                                : std::array<std::size_t, 5>{0, 1, 4, 5, 6}[static_cast<std::size_t>(random.below(5))];
  double& x = of_ellipse ? ellipse.number[field] : s.number[field];
  const bool is_size = of_ellipse ? field >= 4 : s.kind == VESICA_CAPSULE || field >= 4;
  double from = x, to = is_size ? x * random.between(0.01, 4) : x + random.between(-40, 40);
  if (!nested()) return;
  x = to;
  if (nested()) return;
  ++found;
  for (int k = 0; k < 70; ++k) {
    x = from + (to - from) / 2;
    (nested() ? from : to) = x;
  }
  for (const double end : {from, to}) {
    x = end;
    for (int step = 0; step < 3; ++step) {
      ASSERT_TRUE(agrees(ellipse, s));
      x = std::nextafter(x, random.sign() * std::numeric_limits<double>::infinity());
    }
  }
}

TEST(InflatedEllipseRelation, AgreesWithRationalNumbersBesideContact) {
  Random random(properties::seed());
  int found = 0;
  const int cases = 6000 * properties::repeat();
  for (int i = 0; i < cases; ++i) {
    Shape ellipse = ellipse_on_lattice(random);
    for (std::size_t k = 0; k < 6; ++k) ellipse.number[k] *= random.between(0.8, 1.25);
    Shape s = on_lattice(random.chance(0.5) ? VESICA_CAPSULE : VESICA_ROUND_RECT, random);
    (s.kind == VESICA_CAPSULE ? s.number[4] : s.number[6]) *= random.between(0.8, 1.25);
    expect_agreement_beside_contact(ellipse, s, random, found);
    ASSERT_FALSE(HasFatalFailure()) << "case " << i;
  }
  EXPECT_GT(found, 100 * properties::repeat());
  std::printf("%d contacts\n", found);
}

}  // namespace
}  // namespace inflated_ellipse_relation_test

// SPDX-License-Identifier: Apache-2.0
#include "cast/swept/cases.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

namespace swept {
namespace {

using cast_test::Motion;
using cast_test::Numbers;
using cast_test::Pair;
using properties::Random;
using properties::Role;

struct Vec {
  double x, y;
};
Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y}; }
Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y}; }
Vec operator*(double k, const Vec& a) { return {k * a.x, k * a.y}; }
Vec perp(const Vec& a) { return {-a.y, a.x}; }
double dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y; }

/// A motion of a whole length.
struct Whole {
  int x, y, length;
};
constexpr std::array<Whole, 6> wholes{{{1, 0, 1}, {3, 4, 5}, {4, 3, 5}, {5, 12, 13}, {15, 8, 17}, {20, 21, 29}}};

/// One of `wholes`, in any quadrant.
Vec whole_vector(Random& random, double& length) {
  const Whole& w = wholes[static_cast<std::size_t>(random.below(random.chance(0.7) ? 3 : 6))];
  length = w.length;
  const Vec v = random.chance(0.5) ? Vec{1.0 * w.x, 1.0 * w.y} : Vec{1.0 * w.y, 1.0 * w.x};
  return {random.sign() * v.x, random.sign() * v.y};
}

Vec small_vector(Random& random) {
  while (true) {
    const Vec v{1.0 * random.integer(-4, 4), 1.0 * random.integer(-4, 4)};
    if (v.x != 0 || v.y != 0) return v;
  }
}

double power(int exponent) { return std::ldexp(1.0, exponent); }

/// A shape of any kind: centre, axis, half lengths.
struct Draft {
  int kind;
  Vec c{0, 0}, u{1, 0};
  double hx = 0, hy = 0;

  Numbers numbers() const {
    const Vec half = hx * u;
    switch (kind) {
      case VESICA_POINT:
        return {c.x, c.y};
      case VESICA_SEGMENT:
        return {c.x - half.x, c.y - half.y, c.x + half.x, c.y + half.y};
      case VESICA_CIRCLE:
        return {c.x, c.y, hx};
      case VESICA_AABB:
        return {c.x - hx, c.y - hy, c.x + hx, c.y + hy};
      default:
        return {c.x, c.y, u.x, u.y, hx, hy};
    }
  }
};

bool is_turned(int kind) { return kind == VESICA_SEGMENT || kind == VESICA_RECT || kind == VESICA_ELLIPSE; }

double half_length(Random& random) { return random.chance(0.12) ? 0 : random.integer(1, 8) * power(-random.below(3)); }

/// Without a place yet.
Draft draw_shape(int kind, Random& random) {
  Draft s{kind};
  double unused;
  if (is_turned(kind)) s.u = random.chance(0.5) ? small_vector(random) : whole_vector(random, unused);
  if (kind != VESICA_POINT) s.hx = half_length(random);
  if (kind == VESICA_CIRCLE) s.hy = s.hx;
  if (kind == VESICA_AABB || kind == VESICA_RECT || kind == VESICA_ELLIPSE) s.hy = half_length(random);
  return s;
}

int sign(double x) { return (x > 0) - (x < 0); }

/// The farthest point of a box along n from its centre; of a side across n some point.
Vec box_reach(const Draft& s, const Vec& n, Random& random) {
  const auto towards = [&](double along) { return along == 0 ? random.integer(-2, 2) / 2.0 : sign(along); };
  return towards(dot(n, s.u)) * s.hx * s.u + towards(dot(n, perp(s.u))) * s.hy * perp(s.u);
}

/// Gives an ellipse half lengths for which the farthest point along n is rational, and returns that. For a = m |k| x z
/// and b = m |c| y z, where c = n.u, k = n.perp(u), x^2 + y^2 = z^2, it is m (|k| x^2, |c| y^2), up to signs.
Vec ellipse_reach(Draft& s, const Vec& n, Random& random) {
  const double c = dot(n, s.u), k = dot(n, perp(s.u));
  if (s.hx == 0 || s.hy == 0 || c == 0 || k == 0) {
    return sign(c) * s.hx * s.u + sign(k) * s.hy * perp(s.u);
  }
  const int common = std::gcd(static_cast<int>(c), static_cast<int>(k));
  const double across = std::fabs(k) / common, along = std::fabs(c) / common;
  const Whole& w = wholes[static_cast<std::size_t>(random.integer(1, random.chance(0.7) ? 2 : 5))];
  const double m = power(-random.integer(2, 6));
  s.hx = m * across * w.x * w.length;
  s.hy = m * along * w.y * w.length;
  return m * (sign(c) * across * w.x * w.x * s.u + sign(k) * along * w.y * w.y * perp(s.u));
}

/// The farthest point of a shape along n from its centre. Round shapes are given half lengths for which it is rational.
Vec reach(Draft& s, const Vec& n, double length_of_n, Random& random) {
  if (s.kind == VESICA_ELLIPSE) return ellipse_reach(s, n, random);
  if (s.kind != VESICA_CIRCLE) return box_reach(s, n, random);
  const double m = s.hx / 4;
  s.hx = s.hy = m * length_of_n;
  return m * n;
}

Vec draw_place(Random& random) { return {1.0 * random.integer(-12, 12), 1.0 * random.integer(-12, 12)}; }

/// At random, or so that b moves about a place where the numbers are finest.
void place(Draft& a, Draft& b, const Vec& offset, Random& random) {
  const int mode = random.below(5);
  a.c = mode < 2 ? -1.0 * offset : mode == 2 ? Vec{0, 0} : draw_place(random);
  b.c = mode < 2 ? Vec{0, 0} : a.c + offset;
}

double draw_end(Random& random) {
  const int mode = random.below(4);
  return mode == 0 ? 1 : mode == 1 ? cast_test::infinity : random.integer(0, 24) * power(-random.below(4));
}

Case random_case(int kind_a, int kind_b, Random& random) {
  Draft a = draw_shape(kind_a, random), b = draw_shape(kind_b, random);
  const double distance = power(random.below(6));
  place(a, b, distance * draw_place(random), random);
  const Vec aim = a.c - b.c + distance * Vec{1.0 * random.integer(-3, 3), 1.0 * random.integer(-3, 3)};
  const int mode = random.below(16);
  const Vec v = mode == 0 ? Vec{0, 0} : mode < 6 ? small_vector(random) : power(-random.below(4)) * aim;
  return {{kind_a, kind_b, a.numbers(), b.numbers()}, {v.x, v.y, draw_end(random)}, Class::random};
}

/// Sometimes a step beside the time.
double end_about(double t, cast_test::Scalar scalar, Random& random) {
  const int mode = random.below(8);
  if (mode > 2) return mode < 6 ? cast_test::infinity : draw_end(random);
  const std::int64_t at = properties::ordinal(scalar, t) + mode - 1;
  return properties::at_ordinal(scalar, at < 0 ? 0 : at);
}

/// A point of a's outline meets one of b's, with a common tangent, at a known time.
Case built_case(int kind_a, int kind_b, bool grazing, cast_test::Scalar scalar, Random& random) {
  double length = 0;
  const bool circles = kind_a == VESICA_CIRCLE || kind_b == VESICA_CIRCLE;
  Vec n = circles || random.chance(0.3) ? whole_vector(random, length) : small_vector(random);
  Draft a = draw_shape(kind_a, random), b = draw_shape(kind_b, random);
  // Flat sides often lie along the tangent.
  for (Draft* s : {&a, &b}) {
    const bool is_flat = s->kind == VESICA_SEGMENT || s->kind == VESICA_RECT;
    if (is_flat && random.chance(0.3)) s->u = random.chance(0.5) ? n : perp(n);
  }
  const Vec shared = reach(a, n, length, random) + reach(b, n, length, random);
  const Vec v = grazing ? random.sign() * perp(n) : random.chance(0.5) ? small_vector(random) : -1.0 * n;
  const double t = random.chance(grazing ? 0.05 : 0.2) ? 0 : random.integer(1, 32) * power(-random.below(5));
  place(a, b, shared - t * v, random);
  const double speed = power(random.chance(0.5) ? 0 : random.integer(-12, 12)), meeting = t / speed;
  return {{kind_a, kind_b, a.numbers(), b.numbers()},
          {speed * v.x, speed * v.y, end_about(meeting, scalar, random)},
          grazing ? Class::grazing : Class::at_a_time,
          meeting,
          n.x,
          n.y};
}

/// Changes a number by that much, or to a neighbour where it has not the digits.
void change(double& x, double by, cast_test::Scalar scalar) {
  const double sum = x + by;
  const bool exact = sum - x == by && sum - by == x && properties::representable(scalar, sum);
  x = exact ? sum : properties::at_ordinal(scalar, properties::ordinal(scalar, x) + sign(by));
}

/// One number of the shapes or of the velocity; in half of the cases one that is 0, if there is any.
void change_one(Case& c, cast_test::Scalar scalar, Random& random) {
  std::vector<double*> all, zeros;
  const auto add = [&](double& x) {
    all.push_back(&x);
    if (x == 0) zeros.push_back(&x);
  };
  for (int i = 0; i < properties::field_count(c.pair.kind_a); ++i) add(c.pair.a[static_cast<std::size_t>(i)]);
  for (int i = 0; i < properties::field_count(c.pair.kind_b); ++i) add(c.pair.b[static_cast<std::size_t>(i)]);
  add(c.motion.vx);
  add(c.motion.vy);
  const auto& among = !zeros.empty() && random.chance(0.5) ? zeros : all;
  change(*among[static_cast<std::size_t>(random.below(static_cast<int>(among.size())))],
         random.sign() * power(-random.integer(3, 60)), scalar);
  c.kind = c.kind == Class::grazing ? Class::beside : Class::beside_a_time;
}

/// Both shapes and the velocity by one power of two.
void scale(Case& c, Random& random) {
  const double length = power(random.integer(-8, 8));
  for (int k = 0; k < 2; ++k) {
    const int kind = k == 0 ? c.pair.kind_a : c.pair.kind_b;
    Numbers& numbers = k == 0 ? c.pair.a : c.pair.b;
    // The axis is scaled, or the half lengths along it.
    const bool axis = random.chance(0.5);
    for (int i = 0; i < properties::field_count(kind); ++i) {
      const Role role = properties::role(kind, i);
      if (properties::has_axis(kind) && role == (axis ? Role::size : Role::axis)) continue;
      numbers[static_cast<std::size_t>(i)] *= length;
    }
  }
  c.motion.vx *= length;
  c.motion.vy *= length;
}

bool is_sound(const Case& c, cast_test::Scalar scalar) {
  const auto fits = [&](double x) { return properties::representable(scalar, x); };
  for (const Numbers* numbers : {&c.pair.a, &c.pair.b}) {
    for (const double x : *numbers) {
      if (!fits(x)) return false;
    }
  }
  return fits(c.motion.vx) && fits(c.motion.vy) && (std::isinf(c.motion.end) || fits(c.motion.end)) &&
         c.motion.end >= 0 && properties::valid(c.pair.kind_a, c.pair.a) && properties::valid(c.pair.kind_b, c.pair.b);
}

Case attempt(int kind_a, int kind_b, cast_test::Scalar scalar, Random& random) {
  const int mode = random.below(10);
  Case c = mode < 4 ? random_case(kind_a, kind_b, random) : built_case(kind_a, kind_b, mode >= 6, scalar, random);
  if (random.chance(0.3)) scale(c, random);
  if (mode == 5 || mode >= 8) change_one(c, scalar, random);
  return c;
}

}  // namespace

Case draw(int kind_a, int kind_b, cast_test::Scalar scalar, Random& random) {
  while (true) {
    const Case c = attempt(kind_a, kind_b, scalar, random);
    if (is_sound(c, scalar)) return c;
  }
}

}  // namespace swept

// SPDX-License-Identifier: Apache-2.0
#include "relation/nesting.hpp"

#include <vesica.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "oracle/oracle.hpp"
#include "properties/exact_changes.hpp"
#include "properties/generators.hpp"
#include "properties/shape_maker.hpp"

namespace relations {
namespace {

using namespace properties;

bool a_in_b(int kind_a, const double* a, int kind_b, const double* b) {
  const int code = oracle::relation(kind_a, a, kind_b, b);
  return code == VESICA_INSIDE || code == VESICA_INSIDE_TOUCH || code == VESICA_EQUAL;
}

bool b_in_a(int kind_a, const double* a, int kind_b, const double* b) { return a_in_b(kind_b, b, kind_a, a); }

/// One number of the pair a place up or down.
Pair a_place_off(Pair pair, Scalar scalar, Random& random) {
  const Pair before = pair;
  const bool in_b = random.chance(0.5);
  const int kind = in_b ? pair.kind_b : pair.kind_a;
  Numbers& n = in_b ? pair.b : pair.a;
  double& x = n[static_cast<std::size_t>(random.below(field_count(kind)))];
  x = at_ordinal(scalar, ordinal(scalar, x) + (random.chance(0.5) ? 1 : -1));
  return valid(kind, n) ? pair : before;
}

/// Both at a scale that keeps their integers, below 2^bits.
Pair at_any_scale(Pair pair, int bits, Scalar scalar, Random& random) {
  const int low = scalar == Scalar::f32 ? -140 : -1060, high = (scalar == Scalar::f32 ? 120 : 1000) - bits;
  const int exponent = random.integer(low, high);
  pair.a = scaled(pair.kind_a, pair.a, exponent, random.chance(0.25));
  pair.b = scaled(pair.kind_b, pair.b, exponent, random.chance(0.25));
  return pair;
}

Workload base_workload(Random& numbers) {
  using enum Workload;
  constexpr std::array all{random, random, grid, thin, thin, far, tiny, huge, axis_length};
  return all[static_cast<std::size_t>(numbers.below(static_cast<int>(all.size())))];
}

Pair nested_pair(int kind_a, int kind_b, Scalar scalar, Random& random) {
  Pair pair = draw(base_workload(random), kind_a, kind_b, scalar, random);
  const bool b_moves = random.chance(0.5);
  const int kind = b_moves ? kind_b : kind_a, other_kind = b_moves ? kind_a : kind_b;
  Numbers &inner = b_moves ? pair.b : pair.a, &outer = b_moves ? pair.a : pair.b;
  // Half of the time it keeps the outer one's proportions, thin ones included.
  if (kind == other_kind && random.chance(0.5)) inner = outer;
  inner = scaled(kind, inner, -random.integer(0, 6), false);
  const Vector to = random_point(other_kind, outer, random, random.chance(0.3) ? 0.1 : 0.9);
  const Vector from = random_point(kind, inner, random, 0.1);
  inner = moved(kind, inner, {to.x - from.x, to.y - from.y});
  return {kind_a, kind_b, nearest_shape(scalar, kind_a, pair.a), nearest_shape(scalar, kind_b, pair.b)};
}

std::vector<Pair> near_nested(int kind_a, int kind_b, Scalar scalar, Random& random) {
  for (;;) {
    const Pair base = nested_pair(kind_a, kind_b, scalar, random);
    std::vector<Pair> pairs = about_contact(base, scalar, random, random.chance(0.5) ? a_in_b : b_in_a);
    if (!pairs.empty()) return pairs;
  }
}

Pair one_sided_pair(int kind_a, int kind_b, Scalar scalar, Random& random) {
  Pair pair = touching_from_one_side(kind_a, kind_b, random);
  if (random.chance(0.5)) pair = at_any_scale(pair, 20, scalar, random);
  return random.chance(0.5) ? a_place_off(pair, scalar, random) : pair;
}

std::optional<Shape> rewritten(const Shape& shape, int kind, Scalar scalar, Random& random) {
  if (shape.kind == kind) {
    switch (random.below(5)) {
      case 0:
        return with_negated_axis(shape);
      case 1:
        return with_turned_axis(shape);
      case 2:
        return with_scaled_axis(shape, scalar, random.integer(-40, 40));
      case 3:
        return with_ends_exchanged(shape);
      default:
        return shape;
    }
  }
  for (const Shape& other : as_other_kinds(shape, scalar)) {
    if (other.kind == kind) return other;
    // By way of a third kind, as from a segment to a flat ellipse.
    for (const Shape& third : as_other_kinds(other, scalar)) {
      if (third.kind == kind) return third;
    }
  }
  return std::nullopt;
}

/// A point written as any kind.
Numbers point_as(int kind, double x, double y) {
  if (kind == VESICA_CIRCLE) return {x, y, 0};
  if (role(kind, 2) == Role::axis) return {x, y, 2, -3, 0, 0};
  return kind == VESICA_POINT ? Numbers{x, y} : Numbers{x, y, x, y};
}

Pair equal_pair(int kind_a, int kind_b, Scalar scalar, Random& random) {
  constexpr int attempts = 20;
  for (int i = 0; i < attempts && random.chance(0.95); ++i) {
    const Pair drawn = draw(random.chance(0.5) ? Workload::grid : Workload::degenerate, kind_a, kind_b, scalar, random);
    const std::optional<Shape> b = rewritten({kind_a, drawn.a}, kind_b, scalar, random);
    if (!b) continue;
    const Pair pair{kind_a, kind_b, drawn.a, b->numbers};
    return random.chance(0.5) ? a_place_off(pair, scalar, random) : pair;
  }
  // Kinds that have only points in common.
  const double x = random.integer(-9, 9), y = random.integer(-9, 9);
  const Pair pair{kind_a, kind_b, point_as(kind_a, x, y), point_as(kind_b, x, y)};
  return random.chance(0.5) ? a_place_off(pair, scalar, random) : pair;
}

/// Legs and hypotenuse of a right triangle.
struct Triple {
  double x, y, length;
};

Triple rational_direction(Random& random, bool along_axis) {
  constexpr std::array<Triple, 4> triples{{{3, 4, 5}, {4, 3, 5}, {5, 12, 13}, {15, 8, 17}}};
  Triple t = triples[static_cast<std::size_t>(random.below(4))];
  if (along_axis) t = random.chance(0.5) ? Triple{1, 0, 1} : Triple{0, 1, 1};
  return {t.x * random.sign(), t.y * random.sign(), t.length};
}

/// A point and the centre and radius of the circle of curvature there, of an ellipse about the origin along x.
struct Curvature {
  double a, b, x, y, radius;
};

/// At the end of the half axis a: radius b^2 / a, so that a = m q^2, b = m p q and radius = m p^2.
Curvature at_vertex(Random& random) {
  const double m = random.integer(1, 5), p = random.integer(1, 7), q = random.integer(1, 7);
  const double a = m * q * q, radius = m * p * p;
  return {a, m * p * q, a - radius, 0, radius};
}

/// At (a cos t, b sin t), t the angle of a rational direction: the speed there is the length of (a sin t, b cos t), a
/// second rational direction; the radius is its cube over a b, the centre ((a^2 - b^2) cos^3 t / a,
/// (b^2 - a^2) sin^3 t / b). Times what clears the denominators all are integers.
Curvature at_oblique_point(Random& random) {
  const Triple t = rational_direction(random, false), s = rational_direction(random, false);
  const double sx = std::fabs(s.x), sy = std::fabs(s.y), tx = std::fabs(t.x), ty = std::fabs(t.y);
  const double cube = t.length * t.length * t.length, difference = sx * sx * tx * tx - sy * sy * ty * ty;
  return {sx * sx * sy * cube * tx, sx * sy * sy * cube * ty, difference * t.x * tx * sy, -difference * t.y * ty * sx,
          s.length * s.length * s.length * tx * tx * ty * ty};
}

Numbers round_shape(int kind, double cx, double cy, double ux, double uy, double a, double b) {
  if (kind == VESICA_CIRCLE) return {cx, cy, a};
  return {cx, cy, ux, uy, a, b};
}

}  // namespace

Osculation osculating_circle(int kind_a, int kind_b, Random& random) {
  const bool four_fold = random.chance(0.5);
  Curvature k = four_fold ? at_vertex(random) : at_oblique_point(random);
  while (!four_fold && k.a == k.b) k = at_oblique_point(random);  // a circle is its own circle of curvature
  // If both are circles, the circle of curvature is the circle itself.
  if (kind_a == VESICA_CIRCLE && kind_b == VESICA_CIRCLE) {
    return {{kind_a, kind_b, {0, 0, k.radius}, {0, 0, k.radius}}, true};
  }
  const bool ellipse_first = kind_a == VESICA_ELLIPSE && (kind_b != VESICA_ELLIPSE || random.chance(0.5));
  const Triple u = rational_direction(random, random.chance(0.5));
  const double l = u.length;
  const auto at = [&](int kind, double x, double y, double a, double b, bool turned) {
    // The circle is written about an axis of length l too, or as the circle with l times the radius.
    const double cx = x * u.x - y * u.y, cy = x * u.y + y * u.x;
    if (kind == VESICA_CIRCLE) return round_shape(kind, cx, cy, 0, 0, a * l, 0);
    return turned ? round_shape(kind, cx, cy, l, 0, a, b) : round_shape(kind, cx, cy, u.x, u.y, a, b);
  };
  const int kind_of_ellipse = ellipse_first ? kind_a : kind_b, kind_of_circle = ellipse_first ? kind_b : kind_a;
  const Numbers ellipse = at(kind_of_ellipse, 0, 0, k.a, k.b, false);
  const Numbers circle = at(kind_of_circle, k.x, k.y, k.radius, k.radius, random.chance(0.5));
  return {{kind_a, kind_b, ellipse_first ? ellipse : circle, ellipse_first ? circle : ellipse}, four_fold};
}

namespace {

bool fits(const Pair& pair, Scalar scalar) {
  const auto representable_here = [scalar](double x) { return representable(scalar, x); };
  return std::ranges::all_of(pair.a, representable_here) && std::ranges::all_of(pair.b, representable_here);
}

Pair osculating_pair(int kind_a, int kind_b, Scalar scalar, Random& random) {
  Pair pair = osculating_circle(kind_a, kind_b, random).pair;
  while (!fits(pair, scalar)) pair = osculating_circle(kind_a, kind_b, random).pair;
  if (random.chance(0.5)) pair = at_any_scale(pair, 36, scalar, random);
  return random.chance(0.5) ? a_place_off(pair, scalar, random) : pair;
}

}  // namespace

const char* name(Nesting nesting) {
  constexpr std::array<const char*, all_nestings.size()> names{"nested", "near_nested", "one_sided", "equal",
                                                               "osculating"};
  return names.at(static_cast<std::size_t>(nesting));
}

bool exists(Nesting nesting, int kind_a, int kind_b) {
  return nesting != Nesting::osculating || (is_round(kind_a) && is_round(kind_b));
}

NestingStream::NestingStream(Nesting nesting, int kind_a, int kind_b, Scalar scalar, std::uint64_t seed)
    : nesting_(nesting),
      kind_a_(kind_a),
      kind_b_(kind_b),
      scalar_(scalar),
      random_(seed * 0x9e3779b97f4a7c15U +
              static_cast<std::uint64_t>(((static_cast<int>(nesting) * 6 + kind_a) * 6 + kind_b) * 2 +
                                         static_cast<int>(scalar))) {}

Pair NestingStream::next() {
  switch (nesting_) {
    case Nesting::nested:
      return nested_pair(kind_a_, kind_b_, scalar_, random_);
    case Nesting::one_sided:
      return one_sided_pair(kind_a_, kind_b_, scalar_, random_);
    case Nesting::equal:
      return equal_pair(kind_a_, kind_b_, scalar_, random_);
    case Nesting::osculating:
      return osculating_pair(kind_a_, kind_b_, scalar_, random_);
    case Nesting::near_nested:
      break;
  }
  if (next_pending_ == pending_.size()) {
    pending_ = near_nested(kind_a_, kind_b_, scalar_, random_);
    next_pending_ = 0;
  }
  return pending_[next_pending_++];
}

}  // namespace relations

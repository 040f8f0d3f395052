// SPDX-License-Identifier: Apache-2.0
#include "stress/change.hpp"

#include <cmath>

#include "cast/motions.hpp"
#include "properties/generators.hpp"
#include "stress/call.hpp"

namespace stress {
namespace {

using properties::Random;

constexpr int least_exponent = -1074, most_exponent = 1022;

double scaled(double x, int by) { return properties::nearest(Scalar::f64, std::ldexp(x, by)); }

double with_exponent(double x, int exponent) {
  int own = 0;
  const double mantissa = std::frexp(x, &own);
  return std::ldexp(mantissa == 0 ? 0.5 : mantissa, exponent);
}

int exponent_of(double x) {
  int exponent = 0;
  std::frexp(x, &exponent);
  return exponent;
}

/// A number of either shape.
double& any_number(Pair& p, Random& random) {
  const bool first = random.chance(0.5);
  const int fields = properties::field_count(first ? p.kind_a : p.kind_b);
  return (first ? p.a : p.b)[static_cast<std::size_t>(random.below(fields))];
}

void change_number(Pair& p, Random& random) {
  double& x = any_number(p, random);
  const double other = any_number(p, random);
  switch (random.below(9)) {
    case 0:
      x = with_exponent(x, random.integer(least_exponent, most_exponent));
      break;
    case 1:
      x = with_exponent(x, exponent_of(other) + random.integer(-60, 60));
      break;
    case 2:
      x = scaled(x, random.integer(-70, 70));
      break;
    case 3:
      x = random.chance(0.3) ? 0 : other;
      break;
    case 4:
      x = properties::at_ordinal(Scalar::f64, properties::ordinal(Scalar::f64, x) + random.integer(-4, 4));
      break;
    case 5:
      x = with_exponent(random.chance(0.5) ? 1 : 1 + random.unit(), exponent_of(x));
      break;
    case 6:
      x = -x;
      break;
    case 7:
      x = properties::nearest(Scalar::f64, x + (random.chance(0.5) ? other : -other));
      break;
    default:
      x = properties::nearest(Scalar::f64, std::sqrt(std::fabs(x)) * std::sqrt(std::fabs(other)));
  }
}

/// Every number of one role times a power of two.
void scale_role(Pair& p, Random& random) {
  const auto role = random.chance(0.4)   ? properties::Role::size
                    : random.chance(0.5) ? properties::Role::axis
                                         : properties::Role::x;
  const bool first = random.chance(0.5);
  const int by = random.chance(0.5) ? random.integer(-64, 64) : random.integer(-1500, 1500);
  const int kind = first ? p.kind_a : p.kind_b;
  for (int i = 0; i < properties::field_count(kind); ++i) {
    const auto of_number = properties::role(kind, i);
    if (of_number == role || (is_size(of_number) && is_size(role))) {
      double& x = (first ? p.a : p.b)[static_cast<std::size_t>(i)];
      x = scaled(x, by);
    }
  }
}

std::int32_t relation(const Pair& p) { return ask(Query::relation, Scalar::f64, p).code; }

/// One number bisected to where the relation changes: only exact arithmetic decides there.
void move_to_contact(Pair& p, Random& random) {
  double& x = any_number(p, random);
  const auto relation_at = [&](std::int64_t place) {
    x = properties::at_ordinal(Scalar::f64, place);
    return relation(p);
  };
  const double before = x;
  std::int64_t low = properties::ordinal(Scalar::f64, x);
  std::int64_t high =
      properties::ordinal(Scalar::f64, with_exponent(random.sign(), random.integer(least_exponent, most_exponent)));
  const std::int32_t at_low = relation_at(low);
  if (at_low < 0 || relation_at(high) < 0 || relation_at(high) == at_low) {
    x = before;
    return;
  }
  while (std::abs(high - low) > 1) {
    const std::int64_t middle = low + (high - low) / 2;
    (relation_at(middle) == at_low ? low : high) = middle;
  }
  x = properties::at_ordinal(Scalar::f64, random.chance(0.5) ? low : high);
}

/// Another velocity or end; often the very time of contact, or one beside it.
Motion changed_motion(const Case& c, Random& random) {
  Motion m = c.motion;
  double& v = random.chance(0.5) ? m.vx : m.vy;
  const Numbers& other = random.chance(0.5) ? c.pair.a : c.pair.b;
  switch (random.below(5)) {
    case 0:
      return cast_test::draw_motion(c.pair, Scalar::f64, random);
    case 1:
      v = random.chance(0.2) ? 0 : with_exponent(v, random.integer(least_exponent, most_exponent));
      break;
    case 2:
      v = properties::nearest(Scalar::f64, random.sign() * other[static_cast<std::size_t>(random.below(6))]);
      break;
    case 3:
      m.end = with_exponent(1 + random.unit(), random.integer(least_exponent, most_exponent));
      break;
    default: {
      const Answer r = ask({Query::cast, Scalar::f64, c.pair, {m.vx, m.vy, cast_test::infinity}});
      if (r.code != VESICA_CAST_HIT) break;
      const std::int64_t place = properties::ordinal(Scalar::f64, r.numbers[0]) + random.integer(-2, 2);
      m.end = std::fabs(properties::at_ordinal(Scalar::f64, place));
    }
  }
  return m;
}

}  // namespace

Pair changed(Pair p, Random& random) {
  const int changes = random.chance(0.5) ? 1 : random.integer(2, 4);
  for (int i = 0; i < changes; ++i) {
    if (random.chance(0.15)) {
      scale_role(p, random);
    } else if (random.chance(0.15)) {
      move_to_contact(p, random);
    } else {
      change_number(p, random);
    }
  }
  p.a = properties::nearest_shape(Scalar::f64, p.kind_a, p.a);
  p.b = properties::nearest_shape(Scalar::f64, p.kind_b, p.b);
  return p;
}

Case changed(Case c, Random& random) {
  if (of_motion(c.query) && random.chance(0.5)) {
    c.motion = changed_motion(c, random);
  } else {
    c.pair = changed(c.pair, random);
  }
  if (c.query == Query::within) c.distance = draw_distance(Scalar::f64, c.pair, random);
  return c;
}

}  // namespace stress

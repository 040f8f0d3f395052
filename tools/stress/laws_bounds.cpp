// SPDX-License-Identifier: Apache-2.0
// Bounds: each side holds the shape, and the next number inward does not; decided in whole numbers.
#include <gmpxx.h>
#include <vesica.h>

#include <cfloat>
#include <cmath>

#include "stress/laws.hpp"

namespace stress {
namespace {

constexpr mp_bitcnt_t unit = 1074;

/// x * 2^1074, whole for every finite double.
mpz_class fixed_point(double x) {
  int exponent;
  const double fraction = std::frexp(x, &exponent);
  const mpz_class mantissa(std::ldexp(fraction, 53));
  const int shift = exponent - 53 + 1074;
  return shift >= 0 ? mpz_class(mantissa << static_cast<mp_bitcnt_t>(shift))
                    : mpz_class(mantissa >> static_cast<mp_bitcnt_t>(-shift));
}

/// True if no point of the shape lies beyond m along coordinate i, upward (sign 1) or downward (-1).
bool holds(int kind, const Numbers& n, std::size_t i, int sign, double m) {
  const mpz_class distance = sign * (fixed_point(m) - fixed_point(n[i]));
  if (kind == VESICA_POINT) return distance >= 0;
  if (kind == VESICA_CIRCLE) return distance >= fixed_point(n[2]);
  if (kind == VESICA_CAPSULE) {
    const mpz_class other = sign * (fixed_point(m) - fixed_point(n[i + 2])), radius = fixed_point(n[4]);
    return distance >= radius && other >= radius;
  }
  if (kind == VESICA_SEGMENT || kind == VESICA_AABB) {
    return distance >= 0 && sign * (fixed_point(m) - fixed_point(n[i + 2])) >= 0;
  }
  const mpz_class along = fixed_point(n[2 + i]) * fixed_point(n[4]), across = fixed_point(n[3 - i]) * fixed_point(n[5]);
  if (kind == VESICA_RECT) return distance << unit >= abs(along) + abs(across);
  if (kind == VESICA_ROUND_RECT) {
    const mpz_class beside = distance - fixed_point(n[6]);
    return beside >= 0 && beside << unit >= abs(along) + abs(across);
  }
  return distance >= 0 && (distance * distance) << (2 * unit) >= along * along + across * across;
}

struct Side {
  std::size_t coordinate;
  int sign;
};
constexpr Side sides[] = {{0, -1}, {1, -1}, {0, 1}, {1, 1}};

bool reaches_beyond(Scalar scalar, int kind, const Numbers& n) {
  const double most = scalar == Scalar::f32 ? static_cast<double>(FLT_MAX) : DBL_MAX;
  for (const Side& side : sides) {
    if (!holds(kind, n, side.coordinate, side.sign, side.sign * most)) return true;
  }
  return false;
}

}  // namespace

void judge_bounds(Judge& j, const Case& c, Effort) {
  const Answer r = ask(c.query, c.scalar, c.pair);
  const int kind = c.pair.kind_a;
  const Numbers& n = c.pair.a;
  if (r.code != 0) {
    j.demand(r.code == VESICA_E_RANGE && reaches_beyond(c.scalar, kind, n) && !r.wrote, "code", "0", text(r));
    return;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [coordinate, sign] = sides[i];
    const double m = r.numbers[i];
    j.demand(holds(kind, n, coordinate, sign, m), "holds", "a side beyond the shape", hex(m));
    const double inward = properties::at_ordinal(c.scalar, properties::ordinal(c.scalar, m) - sign);
    j.demand(inward == m || !holds(kind, n, coordinate, sign, inward), "smallest", hex(inward), hex(m));
  }
}

}  // namespace stress

// SPDX-License-Identifier: Apache-2.0
#include "oracle/region.hpp"

#include <vesica.h>

#include <algorithm>
#include <climits>
#include <cmath>

namespace oracle {
namespace {

/// mantissa * 2^exponent.
struct Dyadic {
  mpz_class mantissa;
  long exponent;
};

Dyadic dyadic(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  Dyadic d{mpz_class(std::ldexp(fraction, 53)), exponent - 53L};
  if (d.mantissa == 0) return {0, LONG_MAX};
  // Short mantissas keep small integers small.
  const mp_bitcnt_t zeros = mpz_scan1(d.mantissa.get_mpz_t(), 0);
  d.mantissa >>= zeros;
  d.exponent += static_cast<long>(zeros);
  return d;
}

Dyadic operator*(const Dyadic& a, const Dyadic& b) {
  if (a.mantissa == 0 || b.mantissa == 0) return {0, LONG_MAX};
  return {a.mantissa * b.mantissa, a.exponent + b.exponent};
}

/// A shape's numbers as lengths: axis times half extent in place of the two.
std::vector<Dyadic> lengths(int kind, const double* n) {
  if (kind == VESICA_RECT || kind == VESICA_ELLIPSE || kind == VESICA_ROUND_RECT) {
    const Dyadic ux = dyadic(n[2]), uy = dyadic(n[3]), h = dyadic(n[4]), k = dyadic(n[5]);
    std::vector<Dyadic> result{dyadic(n[0]), dyadic(n[1]), h * ux, h * uy, k * ux, k * uy};
    if (kind == VESICA_ROUND_RECT) result.push_back(dyadic(n[6]));
    return result;
  }
  const int count = kind == VESICA_POINT ? 2 : kind == VESICA_CIRCLE ? 3 : kind == VESICA_CAPSULE ? 5 : 4;
  std::vector<Dyadic> result;
  for (int i = 0; i < count; ++i) result.push_back(dyadic(n[i]));
  return result;
}

std::vector<mpz_class> integers(const std::vector<Dyadic>& numbers, long unit) {
  std::vector<mpz_class> result;
  for (const Dyadic& d : numbers) {
    result.push_back(d.mantissa == 0 ? mpz_class(0)
                                     : mpz_class(d.mantissa << static_cast<mp_bitcnt_t>(d.exponent - unit)));
  }
  return result;
}

Corners parallelogram(const Vector& c, const Vector& p, const Vector& q) {
  const Vector zero{0, 0};
  if (p == zero && q == zero) return {c};
  if (q == zero) return {c - p, c + p};
  if (p == zero) return {c - q, c + q};
  return {c - p - q, c + p - q, c + p + q, c - p + q};
}

Corners box(const Vector& low, const Vector& high) {
  if (low == high) return {low};
  if (low.x == high.x || low.y == high.y) return {low, high};
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

Region round_region(const Vector& c, const Vector& p, const Vector& q) {
  if (sgn(cross(p, q)) == 0) return {parallelogram(c, p, q), {}};
  return {{}, {c, p, q}};
}

Region region(int kind, const std::vector<mpz_class>& n) {
  const Vector first{n[0], n[1]};
  switch (kind) {
    case VESICA_POINT:
      return {{first}, {}};
    case VESICA_SEGMENT: {
      const Vector second{n[2], n[3]};
      return {first == second ? Corners{first} : Corners{first, second}, {}};
    }
    case VESICA_CIRCLE:
      return round_region(first, {n[2], 0}, {0, n[2]});
    case VESICA_AABB:
      return {box(first, {n[2], n[3]}), {}};
    case VESICA_RECT:
      return {parallelogram(first, {n[2], n[3]}, {-n[5], n[4]}), {}};
    case VESICA_CAPSULE:
    case VESICA_ROUND_RECT: {
      Region core = region(kind == VESICA_CAPSULE ? VESICA_SEGMENT : VESICA_RECT, n);
      core.radius = n.back();
      return core;
    }
    default:
      return round_region(first, {n[2], n[3]}, {-n[5], n[4]});
  }
}

}  // namespace

RegionPair regions(int kind_a, const double* a, int kind_b, const double* b) {
  const std::vector<Dyadic> lengths_a = lengths(kind_a, a), lengths_b = lengths(kind_b, b);
  long unit = LONG_MAX;
  for (const Dyadic& d : lengths_a) unit = std::min(unit, d.exponent);
  for (const Dyadic& d : lengths_b) unit = std::min(unit, d.exponent);
  return {region(kind_a, integers(lengths_a, unit)), region(kind_b, integers(lengths_b, unit))};
}

MovingPair regions_on_way(int kind_a, const double* a, int kind_b, const double* b, const Way& way) {
  const bool endless = std::isinf(way.time);
  const std::vector<Dyadic> lengths_a = lengths(kind_a, a), lengths_b = lengths(kind_b, b);
  const Dyadic time = dyadic(endless ? 1.0 : way.time), last{time.mantissa, time.exponent - way.less};
  const std::vector<Dyadic> steps{dyadic(way.vx) * time, dyadic(way.vy) * time, dyadic(way.vx) * last,
                                  dyadic(way.vy) * last};
  long unit = LONG_MAX;
  for (const auto& numbers : {lengths_a, lengths_b, steps}) {
    for (const Dyadic& d : numbers) unit = std::min(unit, d.exponent);
  }
  const std::vector<mpz_class> of_a = integers(lengths_a, unit), of_b = integers(lengths_b, unit);
  const std::vector<mpz_class> by = integers(steps, unit);
  mpz_class reach = 1;
  if (endless) {
    // A step of v is at least 1 along a coordinate in this unit, unless there is none.
    for (const auto& numbers : {of_a, of_b}) {
      for (const mpz_class& x : numbers) reach += 8 * abs(x);
    }
  }
  Vector whole{by[0] * reach, by[1] * reach};
  return {region(kind_a, of_a), region(kind_b, of_b), way.less > 0 ? whole - Vector{by[2], by[3]} : whole};
}

bool contains(const Corners& c, const Vector& x) {
  if (c.size() == 1) return c[0] == x;
  if (c.size() == 2) return orientation(c[0], c[1], x) == 0 && sgn(dot(x - c[0], x - c[1])) <= 0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    if (orientation(c[i], edge_end(c, i), x) < 0) return false;
  }
  return true;
}

Vector to_disc(const Ellipse& e, const Vector& x) {
  const Vector offset = x - e.centre;
  return {cross(offset, e.q), cross(e.p, offset)};
}

}  // namespace oracle

// SPDX-License-Identifier: Apache-2.0
#include "boundary_distance/reference.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "boundary_distance/dense_search.hpp"
#include "vesica.h"

namespace outline_reference {
namespace {

constexpr unsigned digits = 320;  // bits

Real real(double x) { return Real(x, digits); }

Shape of_centre(const Real& cx, const Real& cy, double ux, double uy, const Real& a, const Real& b, bool curved) {
  const Real x = real(ux), y = real(uy), length = sqrt(Real(x * x + y * y));
  return {cx, cy, x / length, y / length, a * length, b * length, curved && a > 0 && b > 0};
}

/// F and its derivatives by the angle at the direction n / |n|.
struct Derivatives {
  Real value, slope, bend;
};

void add(const Shape& s, int sign, const Real& nx, const Real& ny, Derivatives& d) {
  const Real x = s.ux * nx + s.uy * ny, y = s.ux * ny - s.uy * nx;
  const Real p = s.a * x, q = s.b * y;
  if (!s.curved) {
    const Real height = abs(p) + abs(q);
    d.value += sign * height;
    d.slope += sign * Real((q < 0 ? -s.b : s.b) * x - (p < 0 ? -s.a : s.a) * y);
    d.bend -= sign * height;
    return;
  }
  const Real height = sqrt(Real(p * p + q * q)), ab = s.a * s.b;
  d.value += sign * height;
  d.slope += sign * Real((s.b * s.b - s.a * s.a) * x * y / height);
  d.bend += sign * Real(ab * ab / (height * height * height) - height);
}

Derivatives derivatives(const Shape& a, const Shape& b, int sign, Real nx, Real ny) {
  const Real length = sqrt(Real(nx * nx + ny * ny));
  nx /= length, ny /= length;
  Derivatives d{real(0), real(0), real(0)};
  add(a, 1, nx, ny, d);
  add(b, sign, nx, ny, d);
  const Real dx = b.cx - a.cx, dy = b.cy - a.cy;
  const Real along = nx * dx + ny * dy;
  d.value -= along;
  d.slope -= nx * dy - ny * dx;
  d.bend += along;
  return d;
}

/// Newton's method on the slope within a bracket, bisection where that leaves it.
Least refine(const Shape& a, const Shape& b, int sign, const Bracket& bracket) {
  const Real nx = real(bracket.at.x), ny = real(bracket.at.y);
  // The cosine's series in the angle from the middle, at most about 84 degrees.
  const auto tangent = [&](const Direction& n, int side) {
    const Real cosine = nx * n.x + ny * n.y, sine = nx * n.y - ny * n.x;
    return cosine > 0.1 ? Real(sine / cosine) : real(10.0 * side);
  };
  Real low = tangent(bracket.before, -1), high = tangent(bracket.after, 1), t = real(0);
  Real value = real(0), least_t = t;
  for (int i = 0; i < 200; ++i) {
    const Derivatives d = derivatives(a, b, sign, nx - t * ny, ny + t * nx);
    if (i == 0 || d.value < value) value = d.value, least_t = t;
    (d.slope < 0 ? low : high) = t;
    // The angle grows by dt / (1 + t^2).
    Real next = d.bend > 0 ? Real(t - d.slope / d.bend * (1 + t * t)) : Real((low + high) / 2);
    if (!(next > low && next < high)) next = (low + high) / 2;
    if (abs(Real(next - t)) < real(0x1p-110)) break;
    t = next;
  }
  const Real x = nx - least_t * ny, y = ny + least_t * nx;
  const Direction n = unit(x.get_d(), y.get_d());
  return {value, n.x, n.y};
}

/// A box's face normals, where F has a kink.
void try_faces(const Shape& a, const Shape& b, int sign, const Shape& box, Least& best) {
  for (int i = 0; i < 4; ++i) {
    Real x = i % 2 == 0 ? box.ux : Real(-box.uy), y = i % 2 == 0 ? box.uy : box.ux;
    if (i >= 2) x = -x, y = -y;
    const Real value = derivatives(a, b, sign, x, y).value;
    if (value < best.value) best = {value, x.get_d(), y.get_d()};
  }
}

}  // namespace

Shape shape(int kind, const Numbers& n) {
  const Real zero = real(0);
  const auto middle = [&](double p, double q) { return Real((real(p) + real(q)) / 2); };
  switch (kind) {
    case VESICA_POINT:
      return of_centre(real(n[0]), real(n[1]), 1, 0, zero, zero, false);
    case VESICA_SEGMENT: {
      const Real dx = real(n[2]) - real(n[0]), dy = real(n[3]) - real(n[1]), length = sqrt(Real(dx * dx + dy * dy));
      if (length == 0) return of_centre(real(n[0]), real(n[1]), 1, 0, zero, zero, false);
      return {middle(n[0], n[2]), middle(n[1], n[3]), dx / length, dy / length, length / 2, zero, false};
    }
    case VESICA_CIRCLE:
      return of_centre(real(n[0]), real(n[1]), 1, 0, real(n[2]), real(n[2]), true);
    case VESICA_AABB:
      return of_centre(middle(n[0], n[2]), middle(n[1], n[3]), 1, 0, (real(n[2]) - real(n[0])) / 2,
                       (real(n[3]) - real(n[1])) / 2, false);
    case VESICA_CAPSULE:
    case VESICA_ROUND_RECT: {
      Shape core = shape(kind == VESICA_CAPSULE ? VESICA_SEGMENT : VESICA_RECT, n);
      core.radius = real(properties::radius(kind, n));
      return core;
    }
    default:
      return of_centre(real(n[0]), real(n[1]), n[2], n[3], real(n[4]), real(n[5]), kind == VESICA_ELLIPSE);
  }
}

namespace {

constexpr std::size_t most_refined = 24;

bool refined_already(const std::vector<Direction>& done, const Direction& n) {
  return std::any_of(done.begin(), done.end(),
                     [&](const Direction& m) { return std::hypot(m.x - n.x, m.y - n.y) < 1e-9; });
}

/// About a centre of its own, so that nothing of the offset is lost.
DenseShape rounded(const Shape& s, const Real& x = 0, const Real& y = 0) {
  return {x.get_d(), y.get_d(), s.ux.get_d(), s.uy.get_d(), s.a.get_d(), s.b.get_d(), s.curved};
}

/// At a kink bisection would be slow, and try_faces() is exact.
bool is_face_normal(const DenseShape& s, const Direction& n) {
  const double along = std::abs(s.ux * n.x + s.uy * n.y), across = std::abs(s.ux * n.y - s.uy * n.x);
  return !s.curved && std::min(along, across) < 1e-14;
}

/// If F is constant up to the rounding of doubles, as for nearly concentric circles, only many digits show where
/// it is least.
void add_hidden_minimum(const Shape& a, const Shape& b, int sign, const DensePair& f, std::vector<Bracket>& found) {
  constexpr int count = 48;
  Direction n[count];
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (int i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * i / count;
    n[i] = unit(std::cos(angle), std::sin(angle));
    low = std::min(low, f(n[i])), high = std::max(high, f(n[i]));
  }
  if (high - low > 1e-10) return;
  int best = 0;
  Real least = derivatives(a, b, sign, n[0].x, n[0].y).value;
  for (int i = 1; i < count; ++i) {
    const Real value = derivatives(a, b, sign, n[i].x, n[i].y).value;
    if (value < least) least = value, best = i;
  }
  found.insert(found.begin(), {n[(best + count - 1) % count], n[best], n[(best + 1) % count], least.get_d()});
}

Least least_of_moderate(const Shape& a, const Shape& b, int sign) {
  const DensePair f(rounded(a), rounded(b, b.cx - a.cx, b.cy - a.cy), sign);
  std::vector<Bracket> found = local_minima(f);
  for (Bracket& bracket : found) bracket.value = refine(f, bracket);
  // The least first: of a needle more of them than are refined may be about one flat minimum that is not the least.
  std::stable_sort(found.begin(), found.end(), [](const Bracket& p, const Bracket& q) { return p.value < q.value; });
  constexpr double slack = 1e-11;
  const double most = found[0].value + slack;
  add_hidden_minimum(a, b, sign, f, found);
  Least best{real(0), 0, 0};
  std::vector<Direction> done;
  for (const Bracket& bracket : found) {
    const Direction& n = bracket.at;
    if (is_face_normal(f.a, n) || is_face_normal(f.b, n)) continue;
    if (bracket.value > most || refined_already(done, n)) continue;
    if (done.size() == most_refined) break;  // F is constant
    const Least refined = refine(a, b, sign, bracket);
    if (done.empty() || refined.value < best.value) best = refined;
    done.push_back(n);
  }
  if (done.empty())
    best.value = derivatives(a, b, sign, a.ux, a.uy).value, best.nx = a.ux.get_d(), best.ny = a.uy.get_d();
  if (!a.curved) try_faces(a, b, sign, a, best);
  if (!b.curved) try_faces(a, b, sign, b, best);
  return best;
}

/// x 2^exponent
Real scaled(const Real& x, int exponent) {
  Real y(x);
  if (exponent < 0) {
    mpf_div_2exp(y.get_mpf_t(), x.get_mpf_t(), static_cast<mp_bitcnt_t>(-exponent));
  } else {
    mpf_mul_2exp(y.get_mpf_t(), x.get_mpf_t(), static_cast<mp_bitcnt_t>(exponent));
  }
  return y;
}

Shape scaled(const Shape& s, int exponent) {
  return {scaled(s.cx, exponent), scaled(s.cy, exponent), s.ux,    s.uy,
          scaled(s.a, exponent),  scaled(s.b, exponent),  s.curved};
}

}  // namespace

Least least(const Shape& a, const Shape& b, int sign) {
  const double size = scale(a, b);
  const Real radii = a.radius + sign * b.radius;
  if (size == 0) return {radii, 1, 0};
  const int exponent = std::ilogb(size) + 1;
  Least found = least_of_moderate(scaled(a, -exponent), scaled(b, -exponent), sign);
  found.value = scaled(found.value, exponent) + radii;
  return found;
}

double scale(const Shape& a, const Shape& b) {
  const Real dx = abs(b.cx - a.cx), dy = abs(b.cy - a.cy);
  return std::max(
      {dx.get_d(), dy.get_d(), a.a.get_d(), a.b.get_d(), b.a.get_d(), b.b.get_d(), a.radius.get_d(), b.radius.get_d()});
}

double error_in_roundoffs(double computed, const Real& exact, double scale) {
  return Real((real(computed) - exact) / (real(0x1p-53) * real(scale))).get_d();
}

double distance_from_outline(const Shape& s, double px, double py) {
  const Real dx = real(px) - s.cx, dy = real(py) - s.cy;
  const Real x = abs(s.ux * dx + s.uy * dy), y = abs(s.ux * dy - s.uy * dx);
  if (s.curved) {
    const Real p = x / s.a, q = y / s.b, g0 = p / s.a, g1 = q / s.b;
    const Real slope = sqrt(Real(g0 * g0 + g1 * g1));
    const double centre = std::min(s.a.get_d(), s.b.get_d());  // no point inside is further from the outline
    if (slope == 0) return centre;
    const Real excess = p * p + q * q - 1, off = abs(excess) / (2 * slope);
    return excess < 0 ? std::min(off.get_d(), centre) : off.get_d();
  }
  const Real gap_x = x - s.a, gap_y = y - s.b;
  if (gap_x < 0 && gap_y < 0) return Real(s.radius - (gap_x < gap_y ? gap_y : gap_x)).get_d();
  const Real over_x = gap_x < 0 ? real(0) : gap_x, over_y = gap_y < 0 ? real(0) : gap_y;
  return std::fabs(Real(sqrt(Real(over_x * over_x + over_y * over_y)) - s.radius).get_d());
}

double aspect(const Shape& s) {
  if (s.a == 0 || s.b == 0) return 1;
  const Real ratio = s.a > s.b ? Real(s.a / s.b) : Real(s.b / s.a);
  return ratio > 1e300 ? 1e300 : ratio.get_d();
}

}  // namespace outline_reference

// SPDX-License-Identifier: Apache-2.0
#include "cast/swept/plane.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <initializer_list>

namespace swept {
namespace {

/// The least k >= 0 for which x 2^k is an integer.
int places(double x) {
  int k = 0;
  while (x != std::floor(x)) {
    x *= 2;
    ++k;
  }
  return k;
}
int places(std::initializer_list<double> numbers) {
  int most = 0;
  for (const double x : numbers) most = std::max(most, places(x));
  return most;
}

/// x 2^k, an integer.
Integer scaled(double x, int k) {
  const int own = places(x);
  return Integer(std::ldexp(x, own)) << static_cast<unsigned>(k - own);
}

/// A shape by its numbers: half of it has half lengths that are products.
struct Form {
  double cx, cy, ux, uy, hx, hy;
  bool has_axis;

  Form(int kind, const cast_test::Numbers& n)
      : cx(n[0]), cy(n[1]), ux(1), uy(0), hx(0), hy(0), has_axis(kind == VESICA_RECT || kind == VESICA_ELLIPSE) {
    if (kind == VESICA_CIRCLE) hx = hy = n[2];
    if (!has_axis) return;
    ux = n[2];
    uy = n[3];
    hx = n[4];
    hy = n[5];
  }
  int digits() const { return std::max(places({cx, cy}), places({ux, uy}) + places({hx, hy})); }
};

int digits(int kind, const cast_test::Numbers& n) {
  const bool ends = kind == VESICA_SEGMENT || kind == VESICA_AABB;
  return ends ? places({n[0], n[1], n[2], n[3]}) : Form(kind, n).digits();
}

Figure figure(int kind, const cast_test::Numbers& n, int unit) {
  const auto at = [&](double x, double y) { return Vector{scaled(x, unit), scaled(y, unit)}; };
  if (kind == VESICA_POINT) return {{at(n[0], n[1])}, {}, {}, {}};
  if (kind == VESICA_SEGMENT) return {{at(n[0], n[1]), at(n[2], n[3])}, {}, {}, {}};
  if (kind == VESICA_AABB) {
    return {{at(n[0], n[1]), at(n[2], n[1]), at(n[2], n[3]), at(n[0], n[3])}, {}, {}, {}};
  }
  const Form f(kind, n);
  const int axis = places({f.ux, f.uy}), half = unit - axis;
  const Integer ux = scaled(f.ux, axis), uy = scaled(f.uy, axis), hx = scaled(f.hx, half), hy = scaled(f.hy, half);
  const Vector c = at(f.cx, f.cy), p{hx * ux, hx * uy}, q{-hy * uy, hy * ux};
  if (kind != VESICA_RECT && hx != 0 && hy != 0) return {{}, c, p, q, kind == VESICA_CIRCLE};
  return {{c - p - q, c + p - q, c + p + q, c - p + q}, {}, {}, {}};
}

}  // namespace

Scene::Scene(const cast_test::Pair& pair, double vx, double vy) {
  const int length = std::max(digits(pair.kind_a, pair.a), digits(pair.kind_b, pair.b)), speed = places({vx, vy});
  a = figure(pair.kind_a, pair.a, length);
  b = figure(pair.kind_b, pair.b, length);
  velocity = {scaled(vx, speed), scaled(vy, speed)};
  time_unit = speed - length;
}

Time Scene::time(double t) const {
  if (std::isinf(t)) return {1, 0};
  const int k = places(t);
  Time found{scaled(t, k), Integer(1) << static_cast<unsigned>(k)};
  (time_unit < 0 ? found.n : found.d) <<= static_cast<unsigned>(std::abs(time_unit));
  return found;
}

}  // namespace swept

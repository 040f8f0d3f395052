// SPDX-License-Identifier: Apache-2.0
/// Pairs of shapes that are apart, and velocities of the second.
#pragma once

#include <vesica.h>

#include <cmath>
#include <cstdint>

#include "random.hpp"
#include "shapes.hpp"

namespace vesica::bench {

/// How velocities are drawn: of any direction (few hits), towards the other shape (aimed) or away, at a relative
/// distance inside or outside of a line that only grazes.
struct Aim {
  const char* name;
  double spread, graze, spin = 0;
};
inline constexpr Aim any{"few hits", 0, 0}, towards{"aimed", 2.2, 0}, sure{"hits", 0.3, 0};
/// So that about that share of rays hits, and of two discs, which are a larger target.
inline constexpr Aim tenth{"about 10% hit", 10, 0}, half{"about 50% hit", 2.1, 0};
inline constexpr Aim tenth_of_discs{"about 10% hit", 23, 0}, half_of_discs{"about 50% hit", 4.5, 0};

/// Away from the other shape: none hits.
inline constexpr Aim never{"no hits", -0.3, 0};

inline Numbers draw_shape(std::int32_t kind, Random& random) {
  const double x = random.between(-4, 4), y = random.between(-4, 4), angle = random.between(0, 6.283185307179586);
  const double a = random.between(0.2, 1), b = random.between(0.2, 1);
  return shape_about(kind, x, y, std::cos(angle), std::sin(angle), a, b);
}

inline Numbers centre_of(std::int32_t kind, const Numbers& n) {
  const bool corners = kind == VESICA_SEGMENT || kind == VESICA_AABB || kind == VESICA_CAPSULE;
  return corners ? Numbers{0.5 * (n[0] + n[2]), 0.5 * (n[1] + n[3])} : Numbers{n[0], n[1]};
}

struct Pair {
  Numbers a, b;
  double vx, vy, angle = 0;
};

/// For rectangles: how far the shape reaches across v, times |v|.
inline double reach_across(const Numbers& n, double vx, double vy) {
  return n[4] * std::fabs(n[2] * vy - n[3] * vx) + n[5] * std::fabs(n[2] * vx + n[3] * vy);
}

inline Pair draw_pair(std::int32_t kind_a, std::int32_t kind_b, const Aim& aim, Random& random) {
  for (;;) {
    Pair p{draw_shape(kind_a, random), draw_shape(kind_b, random), random.between(-8, 8), random.between(-8, 8)};
    if (aim.spread != 0) {
      const Numbers from = centre_of(kind_b, p.b), to = centre_of(kind_a, p.a);
      const double towards = aim.spread > 0 ? 1.5 : -1.5;
      p.vx = towards * (to[0] - from[0]) + aim.spread * random.between(-1, 1);
      p.vy = towards * (to[1] - from[1]) + aim.spread * random.between(-1, 1);
    }
    p.angle = aim.spin * random.between(-1, 1);
    if (aim.graze != 0) {
      const double vv = p.vx * p.vx + p.vy * p.vy;
      const double h = (reach_across(p.a, p.vx, p.vy) + reach_across(p.b, p.vx, p.vy)) * (1 + aim.graze) / vv;
      p.b[0] = p.a[0] - 0.6 * p.vx - p.vy * h;
      p.b[1] = p.a[1] - 0.6 * p.vy + p.vx * h;
    }
    // Contact at the start is another question.
    if (vesica_overlap_f64(kind_a, p.a.data(), kind_b, p.b.data()) == 0) return p;
  }
}

}  // namespace vesica::bench

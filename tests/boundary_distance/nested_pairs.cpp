// SPDX-License-Identifier: Apache-2.0
#include "boundary_distance/nested_pairs.hpp"

#include <cmath>

#include "properties/shape_maker.hpp"
#include "vesica.h"

namespace nested_pairs {
namespace {

using properties::Numbers;
using properties::Random;

/// A rectangle or an ellipse: place, direction, half lengths, and the length its axis is stored with.
struct Sketch {
  double cx, cy, angle, a, b, axis_length;
};

Numbers numbers(int kind, const Sketch& s, double factor) {
  const properties::Vector u{std::cos(s.angle), std::sin(s.angle)};
  return properties::moved(kind, properties::shape_at_origin(kind, u, factor * s.a, factor * s.b, s.axis_length),
                           {s.cx, s.cy});
}

double power(Random& random, double low, double high) { return std::pow(10, random.between(low, high)); }

Sketch sketch(Random& random, double most_aspect) {
  const double aspect = power(random, 0, most_aspect), angle = random.between(0, 6.283185307179586);
  Sketch s{random.between(-1, 1), random.between(-1, 1), angle, 1, 1 / aspect, std::exp2(random.between(-2, 2))};
  if (random.chance(0.5)) std::swap(s.a, s.b);
  return s;
}

/// Moved by (x, y) in the frame of `frame`.
void move(Sketch& s, const Sketch& frame, double x, double y) {
  s.cx = frame.cx + x * std::cos(frame.angle) - y * std::sin(frame.angle);
  s.cy = frame.cy + x * std::sin(frame.angle) + y * std::cos(frame.angle);
}

Sketch inner_sketch(Style style, const Sketch& outer, Random& random) {
  Sketch s = sketch(random, style == Style::any ? 1.3 : 6);
  double off = 1;  // of the centre, as a share of the outer's half lengths
  switch (style) {
    case Style::any:
      off = random.unit();
      break;
    case Style::thin:
      off = random.unit() * random.unit();
      if (random.chance(0.6)) s.angle = outer.angle + random.sign() * power(random, -9, 0);
      break;
    case Style::nearly_concentric:
      off = random.chance(0.2) ? 0 : power(random, -16, -1);
      break;
    case Style::nearly_equal: {
      const double axis_length = s.axis_length;
      s = outer;
      s.axis_length = axis_length;
      s.a *= 1 - (random.chance(0.3) ? 0 : power(random, -15, -1));
      s.b *= 1 - (random.chance(0.3) ? 0 : power(random, -15, -1));
      s.angle += random.chance(0.3) ? 0 : random.sign() * power(random, -15, -1);
      off = random.chance(0.3) ? 0 : power(random, -16, -1);
      break;
    }
    case Style::near_osculating: {
      // At the end of the longer axis; there the radius of curvature is b^2 / a.
      const bool along = outer.a >= outer.b;
      const double longer = along ? outer.a : outer.b, shorter = along ? outer.b : outer.a;
      const double radius = shorter * shorter / longer * (1 + random.between(-1, 1) * power(random, -9, 0));
      s.a = radius;
      s.b = radius * (random.chance(0.5) ? 1 : 1 + random.between(-1, 0) * power(random, -9, 0));
      s.angle = outer.angle + (along ? 0 : 1.5707963267948966);
      const double room = (longer - radius) * (1 - (random.chance(0.5) ? 0 : power(random, -15, -1)));
      move(s, outer, along ? room : 0, along ? 0 : room);
      return s;
    }
  }
  const double way = random.between(0, 6.283185307179586);
  move(s, outer, off * outer.a * std::cos(way), off * outer.b * std::sin(way));
  return s;
}

}  // namespace

const char* name(Style style) {
  switch (style) {
    case Style::any:
      return "any";
    case Style::thin:
      return "thin";
    case Style::nearly_concentric:
      return "nearly concentric";
    case Style::nearly_equal:
      return "nearly equal";
    default:
      return "near osculating";
  }
}

std::optional<properties::Pair> draw(Style style, int outer, int inner, Random& random) {
  Sketch o = sketch(random, style == Style::any ? 1.3 : 6);
  if (outer == VESICA_CIRCLE) o.b = o.a;
  if (outer == VESICA_AABB) o.angle = 0;
  const Sketch s = inner_sketch(style, o, random);
  properties::Pair pair{outer, inner, numbers(outer, o, 1), {}};
  // The greatest factor that keeps the shape inside, to `steps` bits.
  const int steps = random.integer(3, 30);
  double low = 0, high = 1;
  for (int i = 0; i < steps || low == 0; ++i) {
    if (i == 60) return std::nullopt;
    // At first 1, then powers of 2: the factor may be tiny; then halves.
    const double factor = low == 0 ? std::exp2(i == 0 ? 0 : 1 - i) : (low + high) / 2;
    pair.b = numbers(inner, s, factor);
    const bool inside = vesica_relation_f64(outer, pair.a.data(), inner, pair.b.data()) == VESICA_CONTAINS;
    (inside ? low : high) = factor;
    if (inside && (i == 0 || inner == VESICA_POINT)) break;
    if (inside && factor == 1) break;
  }
  pair.b = numbers(inner, s, low);
  return pair;
}

}  // namespace nested_pairs

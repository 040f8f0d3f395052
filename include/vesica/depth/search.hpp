// SPDX-License-Identifier: Apache-2.0
/// How deep two shapes of any form overlap, by a search over all directions (support_minimum/arc_search.hpp).
#pragma once

#include <vesica/depth/disc_disc.hpp>
#include <vesica/support_minimum/box_faces.hpp>
#include <vesica/support_minimum/frame.hpp>
#include <vesica/support_minimum/order.hpp>

namespace vesica::detail::depth {

using namespace support_minimum;

/// F in plain arithmetic.
inline double rough_value(const Objective& o, const PlaneVector& n) noexcept {
  const auto height = [&n](const CentredShape& s) {
    return s.curved ? ellipse_support(s, n).height : dot(corner(s, n), n);
  };
  return height(o.first) + height(o.second) + dot(n, o.e);
}

/// A direction, and F there to twice the precision.
struct Least {
  PlaneVector n;
  FastDoubleDouble<double> value;
};

/// Cosines and sines of 16ths of a half turn.
inline constexpr double cosines_of_16ths[] = {1,
                                              0x1.f6297cff75cbp-1,
                                              0x1.d906bcf328d46p-1,
                                              0x1.a9b66290ea1a3p-1,
                                              0x1.6a09e667f3bcdp-1,
                                              0x1.1c73b39ae68c8p-1,
                                              0x1.87de2a6aea963p-2,
                                              0x1.8f8b83c69a60bp-3,
                                              0};

/// If F bends less, its slope does not show the minimum.
inline constexpr double least_bend = 0x1p-40;

/// Values that differ by rounding are equal for the search: several faces of boxes, and all directions of two
/// shapes that are nearly circles and nearly concentric. Where they are as near, to rounding, the normals of faces, or
/// the way to the centre and directions all round, are compared to twice the precision.
inline Least least_of_ties(const Frame& frame, const Objective& o, const Minimum& found) noexcept {
  PlaneVector lines[2 * 2 + 1 + 2 * 9];
  int count = 0;
  for (const CentredShape* s : {&o.first, &o.second}) {
    if (!s->curved && s->a + s->b > 0) lines[count++] = s->axis, lines[count++] = perp(s->axis);
  }
  if (lane::abs((found.at.radius1 + found.at.radius2) - found.at.value) <= least_bend) {
    if (o.e.x != 0 || o.e.y != 0) lines[count++] = unit_of_any(o.e);
    for (int k = 0; k <= 8; ++k) {
      lines[count++] = {cosines_of_16ths[k], cosines_of_16ths[8 - k]};
      lines[count++] = {-cosines_of_16ths[k], cosines_of_16ths[8 - k]};
    }
  }
  Least least{found.at.n, frame.value(found.at.n, 1)};
  for (int i = 0; i < count; ++i) {
    const PlaneVector n = dot(lines[i], o.e) > 0 ? -lines[i] : lines[i];
    if (rough_value(o, n) > found.at.value + rough_tie) continue;
    const FastDoubleDouble<double> value = frame.value(n, 1);
    if (rounded(value - least.value) < 0) least = {n, value};
  }
  return least;
}

/// The least over all n of h1(n) + h2(n) - n.D: how far the second shape must move along n until n separates the two.
/// Rounding may make it slightly negative. For disjoint shapes it is negative.
inline Depth searched_depth(const Form& a, const Form& b) noexcept {
  const PlacedPair given = place(a, b);
  const bool exchange = out_of_order(a, b, given);
  const PlacedPair pair = exchange ? exchanged(given) : given;
  const Frame frame(pair);
  const Objective objective = frame.objective(1);
  const Least least = least_of_ties(frame, objective, minimise(objective));
  const PlaneVector direction = unit(frame.world(least.n));
  return {least.value, exchange ? -direction : direction, pair.exponent};
}

}  // namespace vesica::detail::depth

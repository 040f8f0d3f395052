// SPDX-License-Identifier: Apache-2.0
/// The order in which the two shapes of a pair are worked on. It does not depend on the order of the arguments, so
/// (a, b) and (b, a) do the same work and give the same bits.
#pragma once

#include <cstddef>
#include <vesica/support_minimum/placed_pair.hpp>

namespace vesica::detail::support_minimum {

/// Compares two lists of numbers by the first that differ: -1 if x is less there, 1 if y is, 0 if none differ.
template <std::size_t N>
int compare(const double (&x)[N], const double (&y)[N]) noexcept {
  for (std::size_t i = 0; i < N; ++i) {
    if (x[i] != y[i]) return x[i] < y[i] ? -1 : 1;
  }
  return 0;
}

/// The rounding errors of the sizes of a shape that is stored by two points.
inline PlaneVector rest_of_size(const Form& f) noexcept {
  return {sum(f.to.x, -f.from.x).low, sum(f.to.y, -f.from.y).low};
}

/// True if the pair is to be exchanged. Boxes come before ellipses. Two of the same form are ordered by their sizes and
/// axes; if these are equal too, the lower or left one comes first. Only the difference of positions is used.
inline bool out_of_order(const Form& a, const Form& b, const PlacedPair& p) noexcept {
  if (a.curved != b.curved) return a.curved;
  const int rounded = compare<6>({a.a, a.b, a.u.x, a.u.y, -p.lead.x, -p.lead.y}, {b.a, b.b, b.u.x, b.u.y, 0, 0});
  if (rounded != 0) return rounded > 0;
  const PlaneVector m = rest_of_size(a), n = rest_of_size(b);
  return compare<2>({m.x, m.y}, {n.x, n.y}) > 0;
}

}  // namespace vesica::detail::support_minimum

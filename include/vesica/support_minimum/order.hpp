// SPDX-License-Identifier: Apache-2.0
/// The order in which a pair is worked on, whichever way round it was passed: what makes answers symmetric to the bit.
#pragma once

#include <vesica/support_minimum/placed_pair.hpp>

namespace vesica::detail::support_minimum {

/// -1, 0 or 1 as the first numbers that differ are in ascending order or not.
template <int N>
int compare(const double (&x)[N], const double (&y)[N]) noexcept {
  for (int i = 0; i < N; ++i) {
    if (x[i] != y[i]) return x[i] < y[i] ? -1 : 1;
  }
  return 0;
}

/// What the rounded sizes of a shape given by two points lack.
inline PlaneVector rest_of_size(const Form& f) noexcept {
  return {sum(f.to.x, -f.from.x).low, sum(f.to.y, -f.from.y).low};
}

/// Whether the pair is to be exchanged: boxes come before ellipses, shapes of one form in the order of their sizes and
/// axes, and equal ones so that the offset leads up or right. Positions enter by their difference only.
inline bool out_of_order(const Form& a, const Form& b, const PlacedPair& p) noexcept {
  if (a.curved != b.curved) return a.curved;
  const int rounded = compare<6>({a.a, a.b, a.u.x, a.u.y, -p.lead.x, -p.lead.y}, {b.a, b.b, b.u.x, b.u.y, 0, 0});
  if (rounded != 0) return rounded > 0;
  const PlaneVector m = rest_of_size(a), n = rest_of_size(b);
  return compare<2>({m.x, m.y}, {n.x, n.y}) > 0;
}

}  // namespace vesica::detail::support_minimum

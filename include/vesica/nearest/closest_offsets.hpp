// SPDX-License-Identifier: Apache-2.0
/// The distance of an ellipse from a point, or of two ellipses, along a direction near the best one; and the search for
/// that.
#pragma once

#include <vesica/nearest/direction.hpp>

namespace vesica::detail::nearest {

/// By a turn a support point's preimage on the unit circle turns at most longer half axis / h times as far. Turned less
/// than this the point, which is moved along a tangent, stays within some 2^-52 of the longer half axis of its outline.
inline constexpr double settled_turn = 0x1p-26;

/// True if the last turn of a search leaves a point on its outline; flatness: (longer half axis / h)^2.
template <class V>
VESICA_INLINE MaskOf<V> stays_on_outline(V turn, V flatness) noexcept {
  return (turn * turn) * flatness <= V(settled_turn * settled_turn);
}

/// separation(), which is not settled either where the last turn takes a point off its outline.
template <class V, class F>
VESICA_INLINE ClosestOffsets<V> separation(const Vector<V>& d, const Normal<V, F>& n, const Support<V>& of_a,
                                           const Support<V>& of_b, V flatness, V size, V smooth) noexcept {
  ClosestOffsets<V> result = separation(d, n, of_a, of_b, size, smooth);
  const auto stays = either(smooth == V(0.0), stays_on_outline(result.turn, flatness));
  result.settled = both(result.settled, stays);
  return result;
}
template <class V>
VESICA_INLINE V flatness(const SemiAxes<V>& e, const Support<V>& s) noexcept {
  return e.longer_squared * s.inverse_square;
}
/// From a point to an ellipse, or from one ellipse to another.
template <class V, class F>
VESICA_INLINE ClosestOffsets<V> separation(const OneEllipse<V>& s, const Vector<V>& d, const Normal<V, F>& n, V size,
                                           V smooth = V(1.0)) noexcept {
  const Support<V> of_a = support(s.a, n);
  return separation(d, n, no_support<V>(), of_a, flatness(s.sa, of_a), size, smooth);
}
template <class V, class F>
VESICA_INLINE ClosestOffsets<V> separation(const TwoEllipses<V>& s, const Vector<V>& d, const Normal<V, F>& n,
                                           V size) noexcept {
  const Support<V> of_a = support(s.a, n), of_b = support(s.b, n);
  return separation(d, n, of_a, of_b, max(flatness(s.sa, of_a), flatness(s.sb, of_b)), size, V(1.0));
}

/// The distance of disjoint shapes, d from the point or the first centre to the ellipse's. steps: how many the search
/// took, which tests look at.
template <class V, class Shapes>
VESICA_INLINE ClosestOffsets<V> closest_offsets(const Shapes& shapes, const Vector<V>& d, V size, int& steps) noexcept {
  const FoundDirection<V> best = farthest_direction(shapes, Direction<V>{d.x.high, d.y.high}, size);
  steps = best.steps;
  ClosestOffsets<V> result = separation(shapes, d, normal(factor(best.n.x, best.n.y)), size);
  result.settled = both(result.settled, best.found);
  return result;
}

}  // namespace vesica::detail::nearest

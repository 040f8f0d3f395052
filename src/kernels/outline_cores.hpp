// SPDX-License-Identifier: Apache-2.0
// The cores of depth and of boundary distance, in the form that query_cores.hpp describes.
#pragma once

#include <vesica/boundary_distance.hpp>
#include <vesica/depth.hpp>

#include "kernels/query_cores.hpp"

namespace vesica {
namespace {

/// Writes the five numbers of an answer to the lanes in which it is wanted, settled (the search converged) and finite.
/// Returns those lanes.
VESICA_INLINE PairMask put(const detail::nearest::LaneAnswer<Doubles>& c, PairMask wanted, Doubles* out) noexcept {
  const Doubles points[] = {c.distance, c.ax, c.ay, c.bx, c.by};
  const PairMask settled = both(both(wanted, c.settled), detail::all_finite(c.distance, c.ax, c.ay, c.bx, c.by));
  for (int k = 0; k < 5; ++k) out[k] = select(settled, points[k], out[k]);
  return settled;
}

/// The outlines of two shapes, one strictly inside the other.
VESICA_INLINE detail::nearest::LaneAnswer<Doubles> nested_outlines(const Rect<Doubles>& a, const Rect<Doubles>& b,
                                                                   PairMask a_inside, PairMask) noexcept {
  const auto choose = [&](const Rect<Doubles>& yes, const Rect<Doubles>& no) {
    const auto pick = [&](Doubles x, Doubles y) { return select(a_inside, x, y); };
    return Rect<Doubles>{pick(yes.cx, no.cx), pick(yes.cy, no.cy), pick(yes.ux, no.ux),
                         pick(yes.uy, no.uy), pick(yes.hx, no.hx), pick(yes.hy, no.hy)};
  };
  const Rect<Doubles> outer = choose(b, a), inner = choose(a, b);
  const auto f = detail::boundary_distance::nested_boxes(detail::support_minimum::box_pair(outer, inner));
  const detail::nearest::LaneAnswer<Doubles> found{rounded(f.distance),  outer.cx + f.outer_x, outer.cy + f.outer_y,
                                                   inner.cx + f.inner_x, inner.cy + f.inner_y, f.settled};
  return detail::nearest::choose(a_inside, detail::boundary_distance::points_exchanged(found), found);
}
template <class A>
VESICA_INLINE detail::nearest::LaneAnswer<Doubles> nested_outlines(const A& a, const Ellipse<Doubles>& b,
                                                                   PairMask a_inside, PairMask idle) noexcept {
  return detail::boundary_distance::lane_nested(a, b, a_inside, idle);
}

/// True if lanes gain where one shape is inside the other. For a rectangle and an ellipse, two lanes of SSE2 take as
/// long as two scalar calls.
template <class A, class B>
inline constexpr bool lanes_gain = true;
#if defined(__SSE2__) && !defined(__AVX__)
template <>
inline constexpr bool lanes_gain<Rect<Doubles>, Ellipse<Doubles>> = false;
#endif

/// Outlines of disjoint shapes are as far apart as the shapes: `out` holds NearestCore's answer. Nested shapes are
/// answered if the filter is certain that they are nested. Outlines that cross or touch are left to the scalar
/// function.
struct NestedCore {
  static constexpr int results = 5;
  template <class A, class B>
  VESICA_INLINE static PairMask evaluate(const A& a, const B& b, const KnownLanes<Doubles>& known,
                                         Doubles* out) noexcept {
    const Doubles zero(0.0);
    const PairMask overlapping = known.overlap > zero, every = zero == zero;
    const PairMask settled = and_not(out[0] == out[0], overlapping);
    if constexpr (!lanes_gain<A, B>) return settled;
    const auto certain = filter::certain_relation(detail::relation::certain_facts(a, b));
    const PairMask nested = both(overlapping, either(certain.inside, certain.contains)), idle = and_not(every, nested);
    if (all(idle)) return settled;
    return either(settled, put(nested_outlines(a, b, certain.inside, idle), nested, out));
  }
};

/// Disjoint shapes have no depth.
struct DepthCore {
  static constexpr int results = 3;
  template <class A, class B>
  VESICA_INLINE static PairMask evaluate(const A& a, const B& b, const KnownLanes<Doubles>& known,
                                         Doubles* out) noexcept {
    const Doubles zero(0.0);
    const PairMask overlapping = known.overlap > zero, disjoint = known.overlap == zero;
    for (int k = 0; k < 3; ++k) out[k] = zero;
    if (all(disjoint)) return disjoint;
    const auto found = depth(a, b, disjoint);
    const Doubles numbers[] = {found.depth, found.x, found.y};
    for (int k = 0; k < 3; ++k) out[k] = select(overlapping, numbers[k], zero);
    return either(disjoint, both(found.settled, detail::all_finite(out[0], out[1], out[2])));
  }

 private:
  VESICA_INLINE static auto depth(const Rect<Doubles>& a, const Rect<Doubles>& b, PairMask) noexcept {
    const auto found = detail::depth::box_box_depth(detail::support_minimum::box_pair(a, b));
    return detail::depth::LaneDepth<Doubles>{rounded(found.depth), found.x, found.y, found.settled};
  }
  template <class A>
  VESICA_INLINE static auto depth(const A& a, const Ellipse<Doubles>& b, PairMask idle) noexcept {
    return detail::depth::lane_depth(a, b, idle);
  }
};

}  // namespace
}  // namespace vesica

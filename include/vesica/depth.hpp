// SPDX-License-Identifier: Apache-2.0
/// depth(a, b): how far must b be moved, and which way, so that two overlapping shapes only touch?
///
/// Definition: the length of the shortest translation of b after which a line separates the two shapes. Both may touch
/// the line. If at least one shape has area, this is when their insides no longer meet. Two shapes without area that
/// lie on one line are separated by that line as they are, so their depth is 0; so are two equal points, and a point of
/// a segment. Disjoint shapes give three zeros. Overlapping shapes always give a direction, also at depth 0. If several
/// directions are equally short, the answer is one of them.
///
/// Accuracy, with u = 2^-53 and scale the largest coordinate of the offset of centres or half length: the depth is
/// right to 4u scale. For two circles, a point and a circle, and depths of points, segments and AABBs along a
/// coordinate axis, it is right to its last place. It is rounded once, also to subnormals. The direction is a unit
/// vector to 3u. After b is moved along it by the depth, at most 8u scale of overlap is left (the most seen is 5.1u).
/// The decision between 0 and more is exact.
///
/// Laws, each tested: depth(b, a) has the same bits with the opposite direction (except for equal shapes at one place,
/// where both calls are the same); the answer is unchanged when both shapes are moved alike without rounding; b moved
/// by a billionth less than the depth overlaps a, by a billionth more it does not.
#pragma once

#include <limits>
#include <vesica/depth/box_box.hpp>
#include <vesica/depth/disc_disc.hpp>
#include <vesica/depth/exact_zero.hpp>
#include <vesica/depth/lane_pairs.hpp>
#include <vesica/depth/search.hpp>
#include <vesica/nearest.hpp>
#include <vesica/overlap.hpp>
#include <vesica/support_minimum/stored_extents.hpp>

namespace vesica {

/// The result of depth(); members as in the C struct.
template <class T>
struct Penetration {
  T depth;  ///< 0 for shapes that are disjoint or only touch
  T x, y;   ///< unit vector along which b must move; 0 for disjoint shapes
};

namespace detail::depth {

/// Below this share of the pair's scale the sign of a computed depth is uncertain.
inline constexpr double surely_positive = 0x1p-48;

/// Returns false where that is not settled.
VESICA_INLINE bool depth_of_boxes(const Form& f, const Form& g, Penetration<double>& out) noexcept {
  const auto d = box_box_depth(box_pair(f, g));
  if (d.settled) out = {arithmetic::rounded(d.depth), d.x, d.y};
  return d.settled;
}
/// The same as a call: rectangles, which are asked about most, have a copy of their own.
VESICA_CALLED inline bool called_depth_of_boxes(const Form& f, const Form& g, Penetration<double>& out) noexcept {
  return depth_of_boxes(f, g, out);
}

/// Rarely needed, and long: kept out of the hot code.
template <class A, class B>
VESICA_COLD bool has_no_depth_exactly(const A& a, const B& b) noexcept {
  return has_no_depth(exact::form(a), exact::form(b));
}

/// The exact overlap for pairs that the filter leaves undecided; a negative error if a shape is invalid.
template <class A, class B>
VESICA_COLD std::int32_t undecided_overlap(const A& a, const B& b) noexcept {
  if constexpr (ShapeTraits<A>::kind != Kind::point && ShapeTraits<B>::kind == Kind::ellipse) {
    if (check(a) != 0 || check(b) != 0) return error_shape;
    return static_cast<std::int32_t>(overlap_and_depth(exact::form(a), exact::form(b)));
  } else {
    return decide_undecided(a, b, Common::any);
  }
}

/// `value`, or the smallest number above 0 if it is not above 0.
inline double above_zero(double value) noexcept { return std::fmax(value, std::numeric_limits<double>::denorm_min()); }

/// Two boxes in the pair's unit. An offset that underflows there becomes the least one of its signs: it separates equal
/// boxes apart.
inline BoxPair<double> boxes_in_unit(const PlacedPair& pair) noexcept {
  BoxPair<double> boxes = box_pair(pair);
  if (boxes.d.x.high == 0 && boxes.d.y.high == 0) {
    constexpr double least = std::numeric_limits<double>::denorm_min();
    boxes.d = {{least * pair.lead.x, 0}, {least * pair.lead.y, 0}};
  }
  return boxes;
}

/// Boxes in the pair's unit, where no product underflows, by the same closed form; the rest by a search.
inline Depth depth_of_forms(const Form& a, const Form& b) noexcept {
  if (!a.curved && !b.curved) {
    const PlacedPair pair = place(a, b);
    const auto in_unit = box_box_depth_of_ties(boxes_in_unit(pair), out_of_order(a, b, pair));
    if (in_unit.settled) return {in_unit.depth, {in_unit.x, in_unit.y}, pair.exponent};
  }
  return searched_depth(a, b);
}

/// A depth > 0 of shapes that store their extents, along a coordinate axis.
template <class A, class B>
void round_once(const Form& f, const Form& g, Penetration<double>& p) noexcept {
  if constexpr (stores_extents<A> && stores_extents<B>) {
    if (p.x != 0 && p.y != 0) return;
    const double depth = depth_along_axis(f, g, p.x, p.y);
    if (depth > 0) p.depth = depth;  // if not, the direction is an axis only after rounding
  }
}

template <class A, class B>
std::int32_t depth_of_overlapping(const A& a, const B& b, Overlap known, Penetration<double>& out) noexcept {
  const Form f = support_minimum::form(a), g = support_minimum::form(b);
  if (!f.curved && !g.curved) {
    constexpr bool are_rects = ShapeTraits<A>::kind == Kind::rect && ShapeTraits<B>::kind == Kind::rect;
    if (are_rects ? depth_of_boxes(f, g, out) : called_depth_of_boxes(f, g, out)) {
      round_once<A, B>(f, g, out);
      return 0;
    }
  }
  Depth d;
  if constexpr (is_disc<A> && is_disc<B>) {
    d = disc_disc_depth(as_circle(a), as_circle(b));
  } else {
    d = depth_of_forms(f, g);
  }
  Penetration<double> result{0, d.direction.x + 0.0, d.direction.y + 0.0};  // no -0
  if (d.value.high > surely_positive || known == Overlap::some_with_depth ||
      (known == Overlap::some && !has_no_depth_exactly(a, b))) {
    result.depth = above_zero(arithmetic::scale_rounded(d.value.high, d.value.low, d.exponent));
    round_once<A, B>(f, g, result);
  }
  if (!all_finite(result.depth)) return error_range;
  out = result;
  return 0;
}

/// For pairs that batches answer in vector lanes: the same core, so that the bits are the same. Returns false if that
/// core does not reach its accuracy; then the general search must answer.
template <class A, class B>
bool settled_depth(const A&, const B&, Penetration<double>&) noexcept {
  return false;
}
template <class A>
VESICA_CALLED bool settled_depth(const A& a, const Ellipse<double>& b, Penetration<double>& out) noexcept {
  if constexpr (nearest::has_lanes<A, Ellipse<double>>) {
    if (!moderate_pair(a, b)) return false;
    const auto lanes = lane_depth(a, b, false);
    if (lanes.settled) out = {lanes.depth, lanes.x, lanes.y};
    return lanes.settled;
  } else {
    return false;
  }
}

inline bool settled_depth(const Circle<double>& a, const Ellipse<double>& b, Penetration<double>& out) noexcept {
  return settled_depth(as_ellipse(a), b, out);
}

/// Do shapes of kinds in order overlap? 1, 0, or a negative error if one is invalid.
template <class A, class B>
VESICA_INLINE std::int32_t overlap_in_order(const A& a, const B& b) noexcept {
  const std::int32_t answer = decide_by_filter(a, b);
  return answer >= 0 ? answer : undecided_overlap(a, b);
}

/// The caller does not know that.
inline constexpr std::int32_t not_asked = -1;

/// depth_or_error() for kinds in order; overlapping: what overlap_in_order() said, or not_asked.
template <class A, class B>
VESICA_CALLED std::int32_t depth_in_order(const A& a, const B& b, std::int32_t overlapping,
                                          Penetration<double>& out) noexcept {
  if (overlapping == not_asked) overlapping = overlap_in_order(a, b);
  if (overlapping < 0) return overlapping;
  if (overlapping > 0) {
    if (settled_depth(a, b, out)) return 0;
    return depth_of_overlapping(a, b, static_cast<Overlap>(overlapping), out);
  }
  out = {0, 0, 0};
  return 0;
}

/// The direction for cores that are so close that their connection has none: the one of their depth as if they touched.
template <class A, class B>
void direction_of_touching(const A& a, const B& b, Penetration<double>& out) noexcept {
  Penetration<double> found;
  if constexpr (in_order<A, B>) {
    if (depth_of_overlapping(a, b, Overlap::some, found) == 0) out = {out.depth, found.x, found.y};
  } else {
    if (depth_of_overlapping(b, a, Overlap::some, found) == 0) out = {out.depth, 0 - found.x, 0 - found.y};
  }
}

inline Penetration<double> turned_round(const Penetration<double>& p) noexcept {
  return {p.depth, 0.0 - p.x, 0.0 - p.y};
}

/// With a core and a radius (form/inflated.hpp). The points of b less those of a are the cores' with a disc of both
/// radii added, so the radii add to the depth of cores that overlap. Where the cores are apart, the shortest move is
/// along their connection.
template <class A, form::Inflated B>
VESICA_CALLED std::int32_t depth_in_order(const A& a, const B& b, std::int32_t overlapping,
                                          Penetration<double>& out) noexcept {
  if (overlapping == not_asked) overlapping = overlap_in_order(a, b);
  if (overlapping < 0) return overlapping;
  const auto p = form::inflated(a);
  const auto q = form::inflated(b);
  if constexpr (std::is_same_v<A, B>) {
    // Equal cores have one direction in either order, so the lesser radius comes first.
    if (p.radius > q.radius) {
      const std::int32_t error = depth_in_order(b, a, overlapping, out);
      if (error == 0) out = turned_round(out);
      return error;
    }
  }
  Penetration<double> found{0, 0, 0};
  if (overlapping == 0) {
    out = found;
    return 0;
  }
  if (vesica::overlap(p.core, q.core)) {
    const std::int32_t error = depth_or_error(p.core, q.core, found);
    if (error != 0) return error;
    found.depth = found.depth + (p.radius + q.radius);
  } else {
    const nearest::ClosestCores c = nearest::closest_cores(a, b);
    const double depth = nearest::scaled_distance(c.radii - c.distance, c.exponent);
    const bool is_positive = depth > surely_positive * arithmetic::scale_far(c.size, c.exponent) ||
                             decide_undecided(a, b, Common::insides) == 1;
    found = {is_positive ? above_zero(depth) : 0, c.nx + 0.0, c.ny + 0.0};  // no -0
    constexpr double rounding = 0x1p-49;
    if (nearest::rounded(c.distance) <= rounding * c.size) direction_of_touching(p.core, q.core, found);
  }
  if (!all_finite(found.depth)) return error_range;
  out = found;
  return 0;
}

/// Rounds once. A depth that is not 0 stays so. Returns false where it would exceed the finite numbers.
inline bool rounded_to(const Penetration<double>& p, Penetration<float>& out) noexcept {
  // A component that rounds to 0 loses its sign.
  Penetration<float> r{static_cast<float>(p.depth), static_cast<float>(p.x) + 0.0f, static_cast<float>(p.y) + 0.0f};
  if (p.depth > 0 && r.depth == 0) r.depth = std::numeric_limits<float>::denorm_min();
  if (!all_finite(r.depth)) return false;
  out = r;
  return true;
}

}  // namespace detail::depth

/// The checked form: writes the depth of two shapes of any kinds, in either order. Returns 0, error_shape when either
/// is invalid, or error_range when the depth exceeds the largest finite number; on error `out` is untouched.
template <template <class> class A, template <class> class B>
std::int32_t depth_or_error(const A<double>& a, const B<double>& b, Penetration<double>& out) noexcept {
  if constexpr (!detail::in_order<A<double>, B<double>>) {
    const std::int32_t error = depth_or_error(b, a, out);
    if (error == 0) out = detail::depth::turned_round(out);
    return error;
  } else {
    return detail::depth::depth_in_order(a, b, detail::depth::not_asked, out);
  }
}

template <template <class> class A, template <class> class B>
std::int32_t depth_or_error(const A<float>& a, const B<float>& b, Penetration<float>& out) noexcept {
  Penetration<double> wide{0, 0, 0};
  const std::int32_t error = depth_or_error(widen(a), widen(b), wide);
  if (error != 0) return error;
  return detail::depth::rounded_to(wide, out) ? 0 : error_range;
}

/// The depth of two shapes of any kinds, in either order. For valid shapes: it is as of disjoint shapes if
/// depth_or_error(), the checked form, returns an error.
template <template <class> class A, template <class> class B, class T>
Penetration<T> depth(const A<T>& a, const B<T>& b) noexcept {
  Penetration<T> out{0, 0, 0};
  depth_or_error(a, b, out);
  return out;
}

}  // namespace vesica

// SPDX-License-Identifier: Apache-2.0
/// The outlines of an ellipse and of a core with a radius (form/inflated.hpp), where the shapes overlap.
#pragma once

#include <vesica/boundary_distance/common_point.hpp>
#include <vesica/boundary_distance/inflated.hpp>
#include <vesica/boundary_distance/nested.hpp>
#include <vesica/relation.hpp>

namespace vesica::detail::boundary_distance {

/// The shapes as forms, the second without its radius, and both in the pair's unit.
struct EllipseAndCore {
  Form ellipse, core;
  double radius;
  nearest::ScaledPair pair;

  template <class B>
  EllipseAndCore(const Ellipse<double>& a, const B& b) noexcept
      : ellipse(support_minimum::form(a)),
        core(support_minimum::form(form::inflated(b).core)),
        radius(form::inflated(b).radius),
        pair(nearest::scaled_pair(a, b)) {}

  /// The core's outline in the pair's unit, seen from the ellipse's centre.
  RoundedOutline rounded() const noexcept { return {pair.b, {pair.d.x.high, pair.d.y.high}}; }
  PlaneVector in_unit(const PlaneVector& v, int exponent) const noexcept {
    return {arithmetic::scale_far(v.x, exponent - pair.exponent), arithmetic::scale_far(v.y, exponent - pair.exponent)};
  }
};

/// One strictly inside the other. The support functions of the shapes differ from those of the ellipse and the core by
/// the radius, so the least difference does, too.
inline ClosestPoints<double> nested_outlines(const EllipseAndCore& s, bool ellipse_inside) noexcept {
  const Nested n = ellipse_inside ? nested_distance(s.core, s.ellipse) : nested_distance(s.ellipse, s.core);
  const int unit = s.pair.exponent;
  const auto scaled = [&](double x) { return arithmetic::scale_far(x, n.exponent - unit); };
  const double radius = s.pair.b.radius;
  const FastDoubleDouble<double> distance =
      FastDoubleDouble<double>{scaled(n.distance.high), scaled(n.distance.low)} + (ellipse_inside ? radius : -radius);
  const PlaneVector on_ellipse = s.in_unit(ellipse_inside ? n.inner : n.outer, n.exponent);
  const RoundedOutline outline = s.rounded();
  const PlaneVector on_other = outline.closest(on_ellipse) + -outline.centre;
  const PlaneVector p = located(s.ellipse, on_ellipse, unit), q = located(s.core, on_other, unit);
  return {std::fmax(arithmetic::scale_rounded(distance.high, distance.low, unit),
                    std::numeric_limits<double>::denorm_min()),
          p.x, p.y, q.x, q.y};
}

/// The outline of an ellipse about 0: x along + y across for w = (x, y) on the unit circle.
class EllipseOutline {
 public:
  explicit EllipseOutline(const RoundedOutline& s) noexcept : s_(s) {}

  PlaneVector at(const PlaneVector& w) const noexcept { return s_.at(w.x * s_.hx, w.y * s_.hy); }
  /// The w of a point of the outline, given with an error that may exceed a needle's width: from both coordinates, or
  /// from one alone.
  PlaneVector place(const PlaneVector& p) const noexcept {
    const PlaneVector seen = support_minimum::into_frame(s_.axis, p);
    const double x = seen.x / s_.hx, y = seen.y / s_.hy;
    const auto rest = [](double z) { return lane::sqrt(lane::positive_part((1 - z) * (1 + z))); };
    const auto one = [](double z) { return lane::max(-1.0, lane::min(1.0, z)); };
    PlaneVector best{1, 0};
    double least = 0x1p1000;
    for (const PlaneVector& w :
         {x == 0 && y == 0 ? best : support_minimum::unit_of_any({x, y}),
          PlaneVector{one(x), lane::flip_sign(rest(x), y)}, PlaneVector{lane::flip_sign(rest(y), x), one(y)}}) {
      const PlaneVector off = at(w) + -p;
      const double distance = lane::max(lane::abs(off.x), lane::abs(off.y));
      if (distance < least) least = distance, best = w;
    }
    return best;
  }

 private:
  const RoundedOutline& s_;
};

/// The point of the ellipse's outline that is closest to the core's outline.
inline PlaneVector closest_to_core(const EllipseAndCore& s, Relation ellipse_to_core) noexcept {
  if (ellipse_to_core == Relation::disjoint) {
    int steps = 0;
    const nearest::Closest c = nearest::closest_of_forms(s.pair, steps);
    return {c.a.x, c.a.y};
  }
  if (ellipse_to_core == Relation::contains) {
    const Nested n = nested_distance(s.ellipse, s.core);
    return s.in_unit(n.outer, n.exponent);
  }
  const PlacedPair pair = place(s.ellipse, s.core);
  const Frame frame(pair);
  const PlaneVector w = common_point_on_box(frame), seen = frame.second_by_axis(w.x, w.y);
  return s.in_unit(frame.world((1 / frame.axis_length()) * seen), pair.exponent);
}

/// A common point of outlines that meet, in the pair's unit, seen from the ellipse's centre.
///
/// Proved: the ellipse's outline has a point in the other shape, and one that is not inside it. So between the two it
/// has a point of the other outline, which bisection finds.
///
///   - If the ellipse and the core are apart, its point that is closest to the core is at most the radius away. If it
///     holds the core, so is the point closest to the core's outline, as the other shape is not inside the ellipse.
///     Otherwise both outlines meet: the core does not hold the ellipse, since the ellipse is not inside the other.
///   - The point farthest out of the core is not inside the other shape, as the ellipse is not.
///
/// Rounding may exchange the signs of both only where they are within it of the outline.
inline PlaneVector common_point(const EllipseAndCore& s, Relation ellipse_to_core) noexcept {
  const RoundedOutline own(s.pair.a, {0, 0}), other = s.rounded();
  if (!s.pair.a.curved) return CommonOutlinePoint(own, other).best();
  const EllipseOutline outline(own);
  const Nested out = nested_distance(s.core, s.ellipse);
  PlaneVector low = outline.place(closest_to_core(s, ellipse_to_core)),
              high = outline.place(s.in_unit(out.inner, out.exponent));
  if (!(other.beyond(outline.at(low)) < 0)) return outline.at(low);
  if (!(other.beyond(outline.at(high)) > 0)) return outline.at(high);
  for (int i = 0; i < 64; ++i) {
    const PlaneVector sum = low + high;
    const PlaneVector middle = lane::abs(sum.x) + lane::abs(sum.y) < 0x1p-20 ? perp(low) : support_minimum::unit(sum);
    (other.beyond(outline.at(middle)) < 0 ? low : high) = middle;
  }
  return outline.at(high);
}

/// For shapes that overlap, by their relation; the ellipse has an area, and the other a radius.
template <class B>
ClosestPoints<double> closest_outlines(Relation relation, const Ellipse<double>& a, const B& b) noexcept {
  const EllipseAndCore s(a, b);
  if (relation == Relation::inside || relation == Relation::contains)
    return nested_outlines(s, relation == Relation::inside);
  const PlaneVector p =
      located(s.ellipse, common_point(s, vesica::relation(a, form::inflated(b).core)), s.pair.exponent);
  return {0, p.x + 0.0, p.y + 0.0, p.x + 0.0, p.y + 0.0};
}

}  // namespace vesica::detail::boundary_distance

// SPDX-License-Identifier: Apache-2.0
/// Shapes that are a core with a radius (form/inflated.hpp): two of them, and one against an ellipse.
#pragma once

#include <vesica/filter/box_ellipse.hpp>
#include <vesica/filter/disc.hpp>
#include <vesica/filter/within.hpp>
#include <vesica/form/inflated.hpp>

namespace vesica::filter {

using vesica::detail::form::CoreAndRadius;

template <class Shape>
inline constexpr bool is_point = ShapeTraits<Shape>::kind == Kind::point;

/// Two boxes, not inlined: many pairs ask, and the code is long.
template <class V>
VESICA_CALLED constexpr auto called_box_box_within(const Box<V>& a, const Box<V>& b, const Centre<V>& d,
                                                   V reach) noexcept {
  return box_box_within(a, b, d, reach);
}

/// Two cores without a curve: `overlap` stands for at most `reach` apart, `disjoint` for farther. The reach has a
/// relative error of at most 2u.
template <class A, class B, class V>
VESICA_INLINE constexpr auto cores_within(const A& a, const B& b, V reach) noexcept {
  const Centre<V> d = offset(place(a), place(b));
  if constexpr (is_point<A> && is_point<B>) {
    const Estimate<V> gap = beyond_reach(d, reach);
    return in_masks(guarded(both(reach >= V(0.0f), is_finite(gap)), gap));
  } else if constexpr (is_point<A>) {
    return point_box_within(box(b), {-d.x, -d.y}, reach);
  } else if constexpr (is_point<B>) {
    return point_box_within(box(a), d, reach);
  } else {
    return called_box_box_within(box(a), box(b), d, reach);
  }
}

/// Two shapes that are a core with a radius, or a core alone: `overlap` stands for at most `distance` apart.
template <template <class> class A, template <class> class B, class V>
VESICA_INLINE constexpr auto inflated_pair(const CoreAndRadius<A, V>& a, const CoreAndRadius<B, V>& b,
                                           V distance) noexcept {
  const auto within = cores_within(a.core, b.core, (a.radius + b.radius) + distance);
  return guarded(at_least(V(0.0f), a.radius, b.radius), within.overlap, within.disjoint);
}

/// Does the box b contain the box a if it reaches `length` farther? `overlap` if it certainly does and a stays clear of
/// its outline, `disjoint` if it certainly does not. The length is of any sign, with a relative error of at most u; d
/// leads from b's centre to a's. For corners that are outside of b their squared distances are compared, as in
/// least_square(), and their room with less room where the length is negative.
template <class V>
VESICA_INLINE constexpr auto corners_in_box(const Box<V>& a, const Box<V>& b, const Centre<V>& d, V length) noexcept {
  const V zero = V(0.0f), uu = b.ux * b.ux + b.uy * b.uy;
  const V c = b.ux * a.ux + b.uy * a.uy, s = b.ux * a.uy - b.uy * a.ux;
  const V p0 = b.ux * d.x + b.uy * d.y, p1 = b.ux * d.y - b.uy * d.x;
  const V g0 = a.hx * c, g1 = a.hx * s, h0 = -(a.hy * s), h1 = a.hy * c, e0 = b.hx * uu, e1 = b.hy * uu;
  const V e = roundoffs<V>(14) * ((abs(p0) + abs(p1)) + ((e0 + e1) + (a.hx + a.hy) * (abs(c) + abs(s))));
  // Along each axis opposite corners are the farthest: |k0| and |k1| of one corner of either pair.
  const V x0 = abs(p0 + g0 + h0), x1 = abs(p0 + g0 - h0), x2 = abs(p0 - g0 + h0), x3 = abs(p0 - g0 - h0);
  const V y0 = abs(p1 + g1 + h1), y1 = abs(p1 + g1 - h1), y2 = abs(p1 - g1 + h1), y3 = abs(p1 - g1 - h1);
  const auto square = [&](V x, V y) {
    const V out_x = positive_part(x - e0), out_y = positive_part(y - e1);
    return out_x * out_x + out_y * out_y;
  };
  const V farthest = max(max(square(x0, y0), square(x1, y1)), max(square(x2, y2), square(x3, y3)));
  const V error = (e + e) * (((max(max(x0, x1), max(x2, x3))) + max(max(y0, y1), max(y2, y3))) + e);
  const V room = min(e0 - max(max(x0, x1), max(x2, x3)), e1 - max(max(y0, y1), max(y2, y3)));
  const Reached<V> reached(abs(length), uu);
  const V least_room = positive_part(room - e), most_room = positive_part(room + e);
  const auto grows = length > zero, shrinks = length <= zero;
  const auto in = either(
      both(grows, farthest + error < reached.low),
      both(both(shrinks, least_room > zero), least_room * least_room * (V(1.0f) - roundoffs<V>(4)) > reached.high));
  const auto out =
      either(both(grows, farthest - error > reached.high),
             both(shrinks, either(room + e < zero, most_room * most_room * (V(1.0f) + roundoffs<V>(4)) < reached.low)));
  const auto usable = both(within_usable(uu, farthest + error, reached.high), at_least(zero, a.hx, a.hy, b.hx, b.hy));
  return guarded(both(usable, e <= guard_power<V, 100>()), in, out);
}

/// Certain facts about two shapes that are a core with a radius, or a core alone.
template <template <class> class A, template <class> class B, class V>
VESICA_INLINE constexpr auto inflated_certain_facts(const CoreAndRadius<A, V>& a,
                                                    const CoreAndRadius<B, V>& b) noexcept {
  const auto verdict = inflated_pair(a, b, V(0.0f));
  const Centre<V> d = offset(place(a.core), place(b.core));
  const Box<V> p = box(a.core), q = box(b.core);
  // corners_in_box() looks at the axis of the outer box alone.
  const auto axes = both(p.ux * p.ux + p.uy * p.uy > V(0.0f), q.ux * q.ux + q.uy * q.uy > V(0.0f));
  const auto valid = both(at_least(V(0.0f), a.radius, b.radius), axes);
  const auto in_b = corners_in_box(p, q, {-d.x, -d.y}, b.radius - a.radius);
  const auto in_a = corners_in_box(q, p, d, a.radius - b.radius);
  return guarded(valid, CertainFacts<decltype(verdict.overlap)>{verdict.disjoint, verdict.overlap, in_b.overlap,
                                                                in_a.overlap, both(in_b.disjoint, in_a.disjoint)});
}

/// Relative room for rough quotients and roots.
template <class V>
VESICA_INLINE constexpr V roughness() noexcept {
  using T = typename Element<V>::Type;
  return V(sizeof(T) == 4 ? static_cast<T>(0x1p-10) : static_cast<T>(0x1p-22));
}

/// A box with a radius and an ellipse; d from the box's centre to the ellipse's. The ellipse takes the radius over:
/// what contains it with the radius is an ellipse, and so is what is contained in it. If the greater one misses the
/// box, the shapes are disjoint; if the lesser one meets it, they overlap.
///
/// Proved, for half lengths a and b, k the radius in units of the ellipse's axis, h its support function: the ellipse
/// with a radius has support h + k.
///
///   - The ellipse with a + k and b + k is contained in it: a sum of vectors is no longer than both.
///   - The ellipse with the squares (1 + k / m) (a^2 + m k) and (1 + k / m) (b^2 + m k) contains it, for every m > 0:
///     (h + k)^2 <= h^2 + k^2 + (k / m) h^2 + m k, by the means of (k / m) h^2 and m k. They are equal where h = m.
///   - So m is close to h in the direction from the box to the ellipse's centre. Any other positive m is right too.
///   - k, the root and the quotient k / m have relative errors of at most 2^-12 each (double: 2^-25), to which
///     roughness() leaves room. m is at least 2^-20 k (double: 2^-160 k), and half lengths at least 2^-10: what
///     underflows is beneath that room.
///
/// Not inlined, as above.
template <class V>
VESICA_CALLED constexpr auto inflated_box_ellipse(const Box<V>& box, V radius, const Ellipse<V>& e,
                                                  const Centre<V>& d) noexcept {
  const BoxFrame<V> f = box_frame(box, e, d);
  const V one = V(1.0f), room = roughness<V>(), tiny = guard_power<V, -20>();
  const V k = rough_quotient(radius, rough_sqrt(f.vv));
  const V x = flip_sign(positive_part(abs(f.kx) - f.ex), f.kx), y = flip_sign(positive_part(abs(f.ky) - f.ey), f.ky);
  const V along = f.ac * x + f.as * y, across = f.bc * y - f.bs * x;
  const V length = f.uu * f.vv * (x * x + y * y);
  const V m = max(rough_sqrt(rough_quotient((along * along + across * across) + tiny, length + tiny)), tiny * k);
  const V stretch = one + rough_quotient(k, m) * (one + room), mk = m * k * (one + room);
  const auto stretched = [&](V size) { return rough_sqrt(stretch * (size * size + mk)) * (one + room); };
  const V inner_k = k * (one - room), shrink = one - roundoffs<V>(4);
  const Ellipse<V> inner{e.cx, e.cy, e.ux, e.uy, (e.a + inner_k) * shrink, (e.b + inner_k) * shrink};
  const Ellipse<V> outer{e.cx, e.cy, e.ux, e.uy, stretched(e.a), stretched(e.b)};
  const auto valid = at_least(V(0.0f), e.a, e.b, radius);
  return guarded(valid, in_masks(box_ellipse(box, inner, d)).overlap, in_masks(box_ellipse(box, outer, d)).disjoint);
}

}  // namespace vesica::filter

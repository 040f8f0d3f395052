// SPDX-License-Identifier: Apache-2.0
/// Box against box, exactly: the four separating axes. Degree 3.
#pragma once

#include <vesica/exact/form.hpp>

namespace vesica::exact {

namespace detail {

/// Sign of the gap between two intervals on an axis, where p is the distance of their midpoints and r the sum of their
/// half lengths: 1 apart, 0 end to end, -1 overlapping. Two equal points count as overlapping, as any equal intervals.
template <int P, int R>
constexpr int gap(const Number<P>& p, const Number<R>& r) noexcept {
  const int sign = compare(abs(p), r);
  return sign == 0 && p.sign == 0 ? -1 : sign;
}

/// Two boxes, the offset of their centres, and |u.w| and |u x w| of their axes u and w. All predicates share these.
struct BoxPair {
  const Box &a, &b;
  Length dx, dy;
  Number<2> c, s;

  constexpr BoxPair(const Box& first, const Box& second) noexcept
      : a(first),
        b(second),
        dx(b.cx - a.cx),
        dy(b.cy - a.cy),
        c(abs(dot(a.ux, a.uy, b.ux, b.uy))),
        s(abs(cross(a.ux, a.uy, b.ux, b.uy))) {}
};

/// Both boxes in the frame of one of them, in units of its axis.
struct FrameOfBox {
  Number<2> x, y;
  Number<3> hx, hy, other_x, other_y;  ///< half lengths of the box, and how far the other reaches

  constexpr FrameOfBox(const BoxPair& seen, const Box& box, const Box& other) noexcept
      : x(dot(box.ux, box.uy, seen.dx, seen.dy)),
        y(cross(box.ux, box.uy, seen.dx, seen.dy)),
        other_x(other.hx * seen.c + other.hy * seen.s),
        other_y(other.hx * seen.s + other.hy * seen.c) {
    const auto uu = dot(box.ux, box.uy, box.ux, box.uy);
    hx = box.hx * uu;
    hy = box.hy * uu;
  }

  /// The greater gap along the two axes.
  constexpr int widest_gap() const noexcept {
    const int along = gap(x, hx + other_x);
    if (along > 0) return 1;
    const int across = gap(y, hy + other_y);
    return along > across ? along : across;
  }
};

/// How far an interval of half length `extent` stays within one of half length `size`, p between their midpoints:
/// 1 clear of its ends, 0 up to an end, -1 not within. A single point has no ends to reach.
template <int P, int E, int S>
constexpr int clearance(const Number<P>& p, const Number<E>& extent, const Number<S>& size) noexcept {
  const int sign = compare(size, abs(p) + extent);
  return sign == 0 && size.sign == 0 ? 1 : sign;
}

/// The clearance of the other box within the box of the frame.
constexpr int clearance(const FrameOfBox& frame) noexcept {
  const int along = clearance(frame.x, frame.other_x, frame.hx);
  if (along < 0) return -1;
  const int across = clearance(frame.y, frame.other_y, frame.hy);
  return along < across ? along : across;
}

}  // namespace detail

/// -1 when the relative insides of two boxes meet, 0 when only their outlines do, 1 when the boxes are disjoint. The
/// Minkowski sum of two boxes, flat ones included, is bounded by lines across the four axes, so no other direction need
/// be tried; the insides meet iff the offset of centres is in the relative inside of that sum.
constexpr int contact(const Box& a, const Box& b) noexcept {
  const detail::BoxPair seen(a, b);
  const int first = detail::FrameOfBox(seen, a, b).widest_gap();
  if (first > 0) return 1;
  const int second = detail::FrameOfBox(seen, b, a).widest_gap();
  return first > second ? first : second;
}

/// True if the boxes share a point.
constexpr bool overlap(const Box& a, const Box& b) noexcept { return contact(a, b) <= 0; }

/// How far box a stays within box b: 1 clear of b's outline, 0 up to it, -1 not within. b is bounded by its own axes.
constexpr int clearance(const Box& a, const Box& b) noexcept {
  return detail::clearance(detail::FrameOfBox(detail::BoxPair(a, b), b, a));
}

}  // namespace vesica::exact

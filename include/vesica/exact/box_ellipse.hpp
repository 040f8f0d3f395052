// SPDX-License-Identifier: Apache-2.0
/// Box against ellipse, exactly.
#pragma once

#include <type_traits>
#include <vesica/exact/box_at_disc.hpp>

namespace vesica::exact {

namespace detail {

/// An ellipse about the origin, in the frame of a box: { z : z . P^-1 z <= 1 } with P = a^2 (c, s)(c, s)^T + b^2 (-s,
/// c) (-s, c)^T and cc + ss = nn.
template <class Size, class Axis, class Square>
struct FramedEllipse {
  const Size &a, &b;
  const Axis &c, &s;
  const Square& nn;

  /// The sign of 1 - z . P^-1 z for z = (x, y). Degree 12.
  template <class Place>
  constexpr int inside(const Place& x, const Place& y, Signs& sign) const noexcept {
    const auto room = [](const auto& radius, const auto& along, const auto& across) {
      return square(radius) - (square(along) + square(across));
    };
    return sign.of_polynomial(room, a * b * nn, b * (c * x + s * y), a * (c * y - s * x));
  }
  /// The same from room = p00 - x^2 and gap = |p00 y - p01 x|: that of det P room - gap^2. Degree 18, but of numbers
  /// that are there already, and so quicker for short ones.
  template <class Place, int R, int G>
  constexpr int inside(const Place&, const Place&, const Number<R>& room, const Number<G>& gap, Signs&) const noexcept {
    return compare_product_with_square(square(a * b * nn), room, gap);
  }
  template <class Place, int limbs>
  constexpr int inside(const Place& x, const Place& y, const Leading<limbs>&, const Leading<limbs>&,
                       Signs& sign) const noexcept {
    return inside(x, y, sign);
  }
};

/// The rest of segment_gap() for long numbers: no product is formed where its factors' leading digits tell.
template <class P, class Place, class Inside>
VESICA_CALLED constexpr int long_segment_gap(int room_sign, const P& p00, const P& p01, const Place& x,
                                             const Place& from, const Place& to, const Inside& inside,
                                             Signs& sign) noexcept {
  const auto beyond_centre = [](const auto& p, const auto& end, const auto& q, const auto& side) {
    return p * end - q * side;
  };
  if (sign.of_polynomial(beyond_centre, p00, from, p01, x) > 0) return -inside(from);
  return sign.of_polynomial(beyond_centre, p00, to, p01, x) < 0 ? -inside(to) : -room_sign;
}

/// A segment at distance x >= 0 from the ellipse's centre along the first axis of the frame, from `from` to `to` across
/// it: 1 when it misses the ellipse, 0 when it only touches, -1 when it meets the inside. The line cuts the ellipse in
/// a chord with centre p01 x / p00, if p00 >= x^2. Where that lies beyond an end, the end tells.
template <class P, class Place, class Inside>
constexpr int segment_gap(const P& p00, const P& p01, const Place& x, const Place& from, const Place& to,
                          const Inside& inside, Signs& sign) noexcept {
  const auto room = p00 - square(x);
  const int room_sign = sign.of(room);
  if (room_sign < 0) return 1;
  if (is_long(p00) || is_long(p01) || is_long(x)) {
    return long_segment_gap(room_sign, p00, p01, x, from, to, inside, sign);
  }
  const auto centre = p01 * x;
  const auto before = p00 * from - centre;
  if (sign.of(before) > 0) return -inside(from, room, before);
  const auto after = centre - p00 * to;
  return sign.of(after) > 0 ? -inside(to, room, after) : -room_sign;
}

/// A box and an ellipse in the frame of the box, in units of |u|, folded so that the ellipse's centre k lies in the
/// first quadrant. The edges visible from there are those towards +x and +y. Testing these two suffices: a common point
/// of both shapes, seen from the centre, lies behind a visible edge, so the ellipse meets that edge too. If the centre
/// lies beside the box along an axis (x or y is then 0), the tested segment runs inside the box instead, through the
/// centre's foot, so meeting it also proves overlap. The same holds for the inside of the ellipse. The regions are
/// those of D. Eberly, "Intersection of Rectangle and Ellipse" (Geometric Tools).
struct VisibleEdges {
  Number<2> c, s;
  Number<3> near_x, near_y, far_x, far_y;
  const Length &a, &b;
  bool centre_inside;  ///< the ellipse's centre is in the box

  constexpr VisibleEdges(const Box& box, const Ellipse& ellipse) noexcept
      : c(dot(box.ux, box.uy, ellipse.ux, ellipse.uy)),
        s(cross(box.ux, box.uy, ellipse.ux, ellipse.uy)),
        a(ellipse.a),
        b(ellipse.b) {
    const Length dx = ellipse.cx - box.cx, dy = ellipse.cy - box.cy;
    const auto uu = dot(box.ux, box.uy, box.ux, box.uy);
    auto kx = dot(box.ux, box.uy, dx, dy), ky = cross(box.ux, box.uy, dx, dy);
    s.sign *= kx.sign * ky.sign < 0 ? -1 : 1;
    kx.sign *= kx.sign;
    ky.sign *= ky.sign;
    const auto ex = box.hx * uu, ey = box.hy * uu;
    near_x = kx - ex;
    near_y = ky - ey;
    far_x = kx + ex;
    far_y = ky + ey;
    centre_inside = near_x.sign <= 0 && near_y.sign <= 0;
  }

 private:
  static constexpr int not_asked = 2;

  template <class Size, class Axis, class Place>
  static constexpr int least_gap(int enough, Signs& sign, const Size& a, const Size& b, const Axis& c, const Axis& s,
                                 const Place& x0, const Place& x1, const Place& y0, const Place& y1) noexcept {
    const auto aa = square(a), bb = square(b);
    const auto cc = square(c), ss = square(s), nn = cc + ss;
    const FramedEllipse<Size, Axis, std::decay_t<decltype(nn)>> e{a, b, c, s, nn};
    const auto p01 = (aa - bb) * (c * s);
    const Place none;
    const Place &x = x0.sign < 0 ? none : x0, &y = y0.sign < 0 ? none : y0;
    // Both edges have the near corner, whose distance from the ellipse is worked out once.
    const bool has_near_corner = x0.sign >= 0 && y0.sign >= 0;
    int near_corner = not_asked;
    const auto at_x = [&](const Place& end, const auto&... known) {
      const int inside = e.inside(x, end, known..., sign);
      if (has_near_corner && &end == &y0) near_corner = inside;
      return inside;
    };
    const int gap_x = segment_gap(aa * cc + bb * ss, p01, x, y0, y1, at_x, sign);
    if (gap_x <= enough) return gap_x;
    const auto at_y = [&](const Place& end, const auto&... known) {
      if (&end == &x0 && near_corner != not_asked) return near_corner;
      return e.inside(end, y, known..., sign);
    };
    const int gap_y = segment_gap(aa * ss + bb * cc, p01, y, x0, x1, at_y, sign);
    return gap_x < gap_y ? gap_x : gap_y;
  }

 public:
  constexpr bool are_long() const noexcept {
    return is_long(c) || is_long(s) || is_long(near_x) || is_long(far_x) || is_long(near_y) || is_long(far_y);
  }

  /// The lesser gap of the two edges, or not.
  constexpr bool few_digits_tell(int& gap) const noexcept {
    using Few = Leading<few_limbs>;
    Signs sign;
    gap = least_gap(-1, sign, Few(a), Few(b), Few(c), Few(s), Few(near_x), Few(far_x), Few(near_y), Few(far_y));
    return sign.certain;
  }
  /// The lesser gap of the two edges; that of the first if it is at most `enough`.
  constexpr int gap(int enough) const noexcept {
    Signs sign;
    return least_gap(enough, sign, a, b, c, s, near_x, far_x, near_y, far_y);
  }
};

/// A function of its own, as the disc's numbers take stack that the edges do not need.
VESICA_CALLED constexpr int gap_at_disc(const Box& box, const Ellipse& ellipse, const VisibleEdges& edges) noexcept {
  return BoxAtDisc(box, ellipse).gap(edges.near_x, edges.near_y);
}

/// contact(), or what is at most `enough` if it is.
VESICA_CALLED constexpr int contact(const Box& box, const Ellipse& ellipse, int enough) noexcept {
  const VisibleEdges edges(box, ellipse);
  if (edges.centre_inside) return -1;
  if (!edges.are_long()) return edges.gap(enough);
  int gap = 0;
  return edges.few_digits_tell(gap) ? gap : gap_at_disc(box, ellipse, edges);
}

}  // namespace detail

/// -1 when the inside of an ellipse that is not degenerate meets the box, 0 when only its outline does, 1 when they are
/// disjoint. The inside of the ellipse is open, so if it meets the box, it also meets the box's relative inside.
constexpr int contact(const Box& box, const Ellipse& ellipse) noexcept { return detail::contact(box, ellipse, -1); }

/// Whether a box and an ellipse share a point.
VESICA_CALLED constexpr bool overlap(const Box& box, const Ellipse& ellipse) noexcept {
  return degenerate(ellipse) ? overlap(box, as_box(ellipse)) : detail::contact(box, ellipse, 0) <= 0;
}

/// How far a box stays within an ellipse that is not degenerate: 1 clear of the outline, 0 up to it, -1 not within.
/// Degree 8.
constexpr int clearance(const Box& box, const Ellipse& ellipse) noexcept {
  return detail::BoxAtDisc(box, ellipse).clearance();
}

/// How far an ellipse that is not degenerate stays within a box. Its half extent along an axis is a square root:
/// squared once. Degree 6.
constexpr int clearance(const Ellipse& ellipse, const Box& box) noexcept {
  if (box.hx.sign == 0 || box.hy.sign == 0) return -1;
  const Length dx = ellipse.cx - box.cx, dy = ellipse.cy - box.cy;
  const auto uu = dot(box.ux, box.uy, box.ux, box.uy);
  const auto room_x = box.hx * uu - abs(dot(box.ux, box.uy, dx, dy));
  const auto room_y = box.hy * uu - abs(cross(box.ux, box.uy, dx, dy));
  if (room_x.sign <= 0 || room_y.sign <= 0) return -1;
  const auto c = dot(box.ux, box.uy, ellipse.ux, ellipse.uy);
  const auto s = cross(box.ux, box.uy, ellipse.ux, ellipse.uy);
  const auto beyond = [](const auto& room, const auto& x, const auto& y) {
    return square(room) - (square(x) + square(y));
  };
  const int along = sign_of(beyond, room_x, ellipse.a * c, ellipse.b * s);
  if (along < 0) return -1;
  const int across = sign_of(beyond, room_y, ellipse.a * s, ellipse.b * c);
  return along < across ? along : across;
}

}  // namespace vesica::exact

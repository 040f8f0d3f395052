// SPDX-License-Identifier: Apache-2.0
/// The places where outlines of a box and an ellipse meet. Along an edge P + t E the ellipse's quadratic form less 1 is
/// a quadratic in t, whose signs at the corners, slopes and discriminant are exact; and so accurate are its roots.
#pragma once

#include <vesica/arithmetic/spectrum.hpp>
#include <vesica/crossings/box_box.hpp>

namespace vesica::detail::crossings {

/// The frame in which the ellipse is the disc of radius a b V about the origin: lengths along its axis times b, across
/// it times a.
struct DiscFrame {
  const exact::Ellipse& e;
  exact::Number<4> radius;
  Estimate radius_estimate;
  explicit DiscFrame(const exact::Ellipse& ellipse) noexcept
      : e(ellipse),
        radius(ellipse.a * ellipse.b * exact::dot(ellipse.ux, ellipse.uy, ellipse.ux, ellipse.uy)),
        radius_estimate(radius) {}
  template <int Degree>
  exact::Number<4> along(const exact::Number<Degree>& x, const exact::Number<Degree>& y) const noexcept {
    return e.b * exact::dot(e.ux, e.uy, x, y);
  }
  template <int Degree>
  exact::Number<4> across(const exact::Number<Degree>& x, const exact::Number<Degree>& y) const noexcept {
    return e.a * exact::cross(e.ux, e.uy, x, y);
  }
};

/// A box there: its centre and the halves of its edges.
struct DiscBox {
  const DiscFrame& frame;
  exact::Number<4> k0, k1, p0, p1, q0, q1;
  DiscBox(const DiscFrame& f, const exact::Box& box) noexcept : frame(f) {
    const exact::Length dx = box.cx - f.e.cx, dy = box.cy - f.e.cy;
    k0 = f.along(dx, dy);
    k1 = f.across(dx, dy);
    const Position px = box.hx * box.ux, py = box.hx * box.uy;
    p0 = f.along(px, py);
    p1 = f.across(px, py);
    const Position qx = exact::integer(-1) * (box.hy * box.uy), qy = box.hy * box.ux;
    q0 = f.along(qx, qy);
    q1 = f.across(qx, qy);
  }
};

/// A corner there, and its squared distance from the origin less the squared radius, however much of it cancels.
struct DiscCorner {
  exact::Number<4> m0, m1;
  Estimate r0, r1, value;
  void set(const DiscBox& box, const Corners& corners, int i) noexcept {
    const bool right = corners.is_right(i), top = corners.is_top(i);
    m0 = right ? box.k0 + box.p0 : box.k0 - box.p0;
    m1 = right ? box.k1 + box.p1 : box.k1 - box.p1;
    m0 = top ? m0 + box.q0 : m0 - box.q0;
    m1 = top ? m1 + box.q1 : m1 - box.q1;
    r0 = Estimate(m0);
    r1 = Estimate(m1);
    const DiscFrame& frame = box.frame;
    value = square(r0) + square(r1) - square(frame.radius_estimate);
    if (!value.is_precise()) value = Estimate(exact::beyond_rim(m0, m1, frame.radius));
  }
  int sign() const noexcept { return value.sign(); }
};

/// Along an edge m + t e the squared distance less the squared radius is square t^2 + 2 slope t + value.
struct DiscEdge {
  const DiscFrame& frame;
  const DiscCorner &from, &to;
  exact::Number<4> e0, e1;
  Estimate r0, r1, square_, slope, end_slope;

  DiscEdge(const DiscFrame& f, const DiscCorner& start, const DiscCorner& end) noexcept
      : frame(f),
        from(start),
        to(end),
        e0(to.m0 - from.m0),
        e1(to.m1 - from.m1),
        r0(e0),
        r1(e1),
        square_(square(r0) + square(r1)),
        slope(from.r0 * r0 + from.r1 * r1),
        end_slope(to.r0 * r0 + to.r1 * r1) {}
  int slope_sign() const noexcept { return slope.sign_is_known() ? slope.sign() : exact_slope(from).sign; }
  int end_slope_sign() const noexcept { return end_slope.sign_is_known() ? end_slope.sign() : exact_slope(to).sign; }
  Scaled slope_size() const noexcept { return slope.is_precise() ? slope.scaled() : exact::rounded(exact_slope(from)); }
  /// The distance of the edge's line from the origin, times the edge's length.
  VESICA_COLD exact::Number<8> exact_off() const noexcept { return exact::cross(e0, e1, from.m0, from.m1); }
  VESICA_COLD Scaled exact_discriminant() const noexcept {
    const exact::Number<8> off = exact_off();
    return exact::rounded(
        exact::detail::sum_of_products(exact::dot(e0, e1, e0, e1), exact::square(frame.radius), -1, off, off));
  }

 private:
  VESICA_COLD exact::Number<8> exact_slope(const DiscCorner& m) const noexcept {
    return exact::dot(e0, e1, m.m0, m.m1);
  }
};

/// The roots strictly between 0 and 1, ascending; on which side of the chord's middle each is, 0 of a double root; and
/// the discriminant and the chord's distance from the origin, both over powers of the edge's length.
struct Roots {
  double t[2];
  int side[2];
  int count = 0;
  Scaled discriminant{0, 0}, off{0, 0};
  void add(double root, int which) noexcept {
    t[count] = root < 0 ? 0 : root > 1 ? 1 : root;
    side[count++] = which;
  }
};

inline Roots roots_inside(const DiscEdge& edge) noexcept {
  Roots roots;
  const int start = edge.from.sign(), end = edge.to.sign();
  if (start < 0 && end <= 0) return roots;
  if (start == 0 && (end <= 0 || edge.slope_sign() >= 0)) return roots;
  if (end == 0 && edge.end_slope_sign() <= 0) return roots;
  const bool both_outside = start > 0 && end > 0;
  if (both_outside && !(edge.slope_sign() < 0 && edge.end_slope_sign() > 0)) return roots;
  const DiscCorner& m = edge.from;
  // The distance of the edge's line from the origin, times the edge's length.
  const Estimate off = m.r1 * edge.r0 - m.r0 * edge.r1;
  const Estimate discriminant = edge.square_ * square(edge.frame.radius_estimate) - square(off);
  const Scaled d = discriminant.is_precise() ? discriminant.scaled() : edge.exact_discriminant();
  if (d.value < 0 || (d.value == 0 && !both_outside)) return roots;
  roots.off = off.is_precise() ? off.scaled() : exact::rounded(edge.exact_off());
  roots.discriminant = d;
  const Scaled a = edge.square_.scaled(), b = edge.slope_size();
  if (d.value == 0) {
    roots.add(-quotient(b, a), 0);
    return roots;
  }
  // a t^2 + 2 b t + c, c and the discriminant each rounded once. |b| + root does not cancel.
  const Scaled c = m.value.scaled();
  const Scaled all = sum({std::fabs(b.value), b.exponent}, root(d));
  const double larger = quotient(all, a), lesser = quotient(c, all);
  if (start > 0) roots.add(b.value > 0 ? -larger : lesser, -1);
  if (end > 0) roots.add(b.value > 0 ? -lesser : larger, 1);
  return roots;
}

/// The points where the line of an edge meets the ellipse's outline, from the line's point nearest to the origin. The
/// ends of a long edge would lose digits.
class Chord {
 public:
  Chord(const DiscEdge& edge, const Roots& roots) noexcept {
    const Scaled x = edge.r0.scaled(), y = edge.r1.scaled(), off = roots.off, d = roots.discriminant;
    const bool steep = x.value == 0 || (y.value != 0 && y.exponent - x.exponent > 1000);
    const auto unit_edge =
        arithmetic::unit_and_length(x.value, steep ? 0 : arithmetic::scale(y.value, y.exponent - x.exponent));
    ux_ = steep ? 0 : unit_edge.x;
    uy_ = steep ? (y.value < 0 ? -1 : 1) : unit_edge.y;
    // The discriminant's root is half the chord where `off` is its distance.
    const Scaled half = root(d);
    const int unit = off.value == 0 || (half.value != 0 && half.exponent > off.exponent) ? half.exponent : off.exponent;
    off_ = arithmetic::scale(off.value, off.exponent - unit);
    half_ = arithmetic::scale(half.value, half.exponent - unit);
  }
  Real turn(int side) const noexcept {
    const Real half(side * half_);
    return crossings::turn(Real(ux_) * half - Real(uy_) * Real(off_), Real(uy_) * half + Real(ux_) * Real(off_));
  }

 private:
  double ux_, uy_, off_, half_;
};

/// The indices of the places at each corner (-1: none) and inside each edge, in order along it.
struct PlacesOfBox {
  int at_corner[4], of_edge[5];
};

/// Which place is that at which the ellipse's outline begins; -1 where the box's outline does not hold that. Decided
/// exactly, since others may be nearer to it than roundings.
inline int start_of_ellipse(const Corners& box, const DiscCorner* corner, const PlacesOfBox& places, const Position& x,
                            const Position& y) noexcept {
  for (int i = 0; i < box.count; ++i) {
    if (is_corner(box, i, x, y)) return places.at_corner[i];
  }
  for (int i = 0; i < box.edges; ++i) {
    const Edge e(box, i);
    if (side(e, x, y) != 0 || part_of_edge(e, x, y) < 0) continue;
    // In the disc's frame the start is (radius, 0). So an edge that leads away from +x enters the disc there.
    const int first = places.of_edge[i], last = places.of_edge[i + 1] - 1;
    const bool enters = exact::compare(corner[box.next(i)].m0, corner[i].m0) < 0;
    return first > last ? -1 : enters ? first : last;
  }
  return -1;
}

/// The place at which the ellipse's outline begins, if it is one of them, is the first along it.
inline void mend_start(const Corners& box, const DiscCorner* corner, const PlacesOfBox& places, const exact::Ellipse& e,
                       Found& found) noexcept {
  if (!found.is_near_start_of_b()) return;
  const Position x = e.cx + e.a * e.ux, y = e.cy + e.a * e.uy;
  const int start = start_of_ellipse(box, corner, places, x, y);
  if (start < 0) return;
  found.place[start].x = nearest(x);
  found.place[start].y = nearest(y);
  found.place[start].begins_b();
}

inline Found crossings(const exact::Box& box, const exact::Ellipse& ellipse) noexcept {
  const Corners corners(box);
  const DiscFrame frame(ellipse);
  const DiscBox disc_box(frame, box);
  DiscCorner corner[4];
  PlacesOfBox places{{-1, -1, -1, -1}, {}};
  Found found;
  for (int i = 0; i < corners.count; ++i) {
    corner[i].set(disc_box, corners, i);
    if (corner[i].sign() != 0) continue;
    const int unit = frame.radius_estimate.exponent;
    const Real at = turn(two_doubles(corner[i].m0, unit), two_doubles(corner[i].m1, unit));
    places.at_corner[i] = found.count;
    found.add({nearest(corners.x[i]), nearest(corners.y[i]), Real(i), at});
  }
  for (int i = 0; i < corners.edges; ++i) {
    places.of_edge[i] = places.of_edge[i + 1] = found.count;
    const DiscEdge disc_edge(frame, corner[i], corner[corners.next(i)]);
    const Roots roots = roots_inside(disc_edge);
    if (roots.count == 0) continue;
    const RoundedEdge edge(corners, i);
    const Chord chord(disc_edge, roots);
    for (int k = 0; k < roots.count; ++k) {
      const double t = roots.t[k];
      found.add({edge.at_x(t), edge.at_y(t), Real(on_edge(i, t)), chord.turn(roots.side[k])});
    }
    places.of_edge[i + 1] = found.count;
  }
  mend_start(corners, corner, places, ellipse, found);
  return found;
}

}  // namespace vesica::detail::crossings

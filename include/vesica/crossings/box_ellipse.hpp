// SPDX-License-Identifier: Apache-2.0
/// Where the outlines of a box and an ellipse meet. Along an edge P + t E the ellipse's quadratic form less 1 is a
/// quadratic in t, whose signs at the corners, slopes and discriminant are exact; and so accurate are its roots.
#pragma once

#include <optional>
#include <vesica/arithmetic/spectrum.hpp>
#include <vesica/crossings/box_box.hpp>

namespace vesica::detail::crossings {

/// The frame in which the ellipse is the disc of radius a b V about the origin: lengths along its axis times b, across
/// it times a.
struct DiscFrame {
  const exact::Ellipse& e;
  exact::Number<4> radius;
  Rough rough_radius;
  explicit DiscFrame(const exact::Ellipse& ellipse) noexcept
      : e(ellipse),
        radius(ellipse.a * ellipse.b * exact::dot(ellipse.ux, ellipse.uy, ellipse.ux, ellipse.uy)),
        rough_radius(radius) {}
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
  Rough r0, r1, value;
  void set(const DiscBox& box, const Corners& corners, int i) noexcept {
    const bool right = corners.is_right(i), top = corners.is_top(i);
    m0 = right ? box.k0 + box.p0 : box.k0 - box.p0;
    m1 = right ? box.k1 + box.p1 : box.k1 - box.p1;
    m0 = top ? m0 + box.q0 : m0 - box.q0;
    m1 = top ? m1 + box.q1 : m1 - box.q1;
    r0 = Rough(m0);
    r1 = Rough(m1);
    const DiscFrame& frame = box.frame;
    value = square(r0) + square(r1) - square(frame.rough_radius);
    if (!value.is_precise()) value = squares_less(frame.radius, m0, m1);
    if (!value.is_precise()) value = rough(exact::BeyondRim(m0, m1, frame.radius).leading());
  }
  int sign() const noexcept { return value.sign(); }
};

/// The line of an edge h w of a box, w its axis or across it, in the plane itself. The frame's cross products are those
/// of the plane times the radius r = a b V: so the line's distance from the origin, times the edge's length, is 2 h r
/// x, and its discriminant (2 h r)^2 (p^2 + q^2 - x^2), where (p, q) is w in the frame.
class PlaneLine {
 public:
  PlaneLine(const DiscFrame& frame, const Corners& corners, int i) noexcept
      : frame_(frame),
        e_(frame.e),
        corners_(corners),
        edge_(i),
        along_(corners.is_along_axis(i)),
        backward_(corners.is_backward(i)),
        c_(exact::dot(e_.ux, e_.uy, corners.box.ux, corners.box.uy)),
        s_(exact::cross(e_.ux, e_.uy, corners.box.ux, corners.box.uy)),
        p_(e_.b * (along_ ? c_ : s_)),
        q_(e_.a * (along_ ? s_ : c_)),
        half_(along_ ? corners.box.hx : corners.box.hy),
        rough_half_(half_) {}
  VESICA_COLD Scaled off() const noexcept {
    const auto product = [](const auto& a, const auto& b) { return a * b; };
    return nearest_size(scale() * Rough(distance()), product, exact_scale(), distance());
  }
  VESICA_COLD Scaled discriminant() const noexcept {
    const auto& x = distance();
    const bool by_p = is_greater(p_, q_);
    const auto greater = exact::abs(by_p ? p_ : q_), size = exact::abs(x);
    const Rough product = Rough(greater - size) * (Rough(greater) + Rough(size));
    const Rough squared_scale = square(scale());
    Scaled nearest;
    if (rounds_surely(squared_scale * (product + square(Rough(by_p ? q_ : p_))), nearest)) return nearest;
    // Of a degree of 6, where the same of the edge in the frame is one of 16.
    const auto sum = square(p_) + square(q_) - square(x);
    const auto all = [](const auto& s, const auto& factor) { return s * square(factor); };
    return nearest_size(squared_scale * Rough(sum), all, sum, exact_scale());
  }
  /// Of DiscEdge: at the edge's start for an `end` of -1, at its end for 1.
  VESICA_COLD Rough slope(int end) const noexcept {
    if (!slopes_) slopes_ = {slope_in_middle(), times(2, rough_half_ * (square(Rough(p_)) + square(Rough(q_))))};
    const auto& [middle, half] = *slopes_;
    return rough_half_ * (middle + (end < 0 ? -half : half));
  }

 private:
  const DiscFrame& frame_;
  const exact::Ellipse& e_;
  const Corners& corners_;
  int edge_;
  bool along_, backward_;
  Position c_, s_;
  exact::Number<3> p_, q_;
  const exact::Length& half_;
  Rough rough_half_;
  struct Slopes {
    Rough in_middle, from_middle;
  };
  // Worked out where they are asked for.
  mutable std::optional<exact::Number<3>> distance_;
  mutable std::optional<Slopes> slopes_;

  /// 2 h r.
  Rough scale() const noexcept { return times(factor(), rough_half_ * frame_.rough_radius); }
  exact::Number<5> exact_scale() const noexcept { return exact::integer(factor()) * (half_ * frame_.radius); }
  int factor() const noexcept { return backward_ ? -2 : 2; }
  exact::Length offset_x() const noexcept { return corners_.box.cx - e_.cx; }
  exact::Length offset_y() const noexcept { return corners_.box.cy - e_.cy; }
  /// w.m, which is the box's centre's too.
  Position centre_on_way() const noexcept {
    const exact::Box& box = corners_.box;
    return along_ ? exact::dot(box.ux, box.uy, offset_x(), offset_y())
                  : exact::cross(box.ux, box.uy, offset_x(), offset_y());
  }
  /// v x 2 m, or v.2 m.
  exact::Number<3> twice_middle(bool across) const noexcept {
    const int next = corners_.next(edge_);
    const Position x = corners_.x[edge_] + corners_.x[next] - exact::integer(2) * e_.cx;
    const Position y = corners_.y[edge_] + corners_.y[next] - exact::integer(2) * e_.cy;
    return across ? exact::cross(e_.ux, e_.uy, x, y) : exact::dot(e_.ux, e_.uy, x, y);
  }
  /// With m the edge's middle in the plane, as seen from the ellipse, and a > b, w times m is in the frame
  /// b^2 V (w.m) + (a + b) (a - b) (v x w) (v x m): only the sum may cancel. With a < b it is the same by a, and dot
  /// products.
  Rough slope_in_middle() const noexcept {
    const bool across = exact::compare(e_.a, e_.b) > 0;
    const exact::Length &lesser = across ? e_.b : e_.a, &greater = across ? e_.a : e_.b;
    const Rough less(lesser), axis(exact::dot(e_.ux, e_.uy, e_.ux, e_.uy));
    Rough middle = times(2, square(less) * axis * Rough(centre_on_way()));
    const exact::Length excess = greater - lesser;
    if (excess.sign != 0) {
      const Rough of_way(across == along_ ? s_ : c_), of_middle(twice_middle(across));
      const Rough more = (Rough(greater) + less) * Rough(excess) * of_way * of_middle;
      middle = across || along_ ? middle + more : middle - more;
    }
    return backward_ ? -middle : middle;
  }
  /// x.
  const exact::Number<3>& distance() const noexcept {
    if (!distance_) {
      const exact::Box& box = corners_.box;
      const Position squared_axis = exact::dot(box.ux, box.uy, box.ux, box.uy);
      // Edges in order are below the centre, to the right, above, to the left; a segment's is through it.
      const auto off = (along_ ? box.hy : box.hx) * squared_axis;
      const auto centre = along_ ? exact::cross(box.ux, box.uy, offset_x(), offset_y())
                                 : exact::integer(-1) * exact::dot(box.ux, box.uy, offset_x(), offset_y());
      distance_ = backward_ ? centre + off : centre - off;
    }
    return *distance_;
  }
};

/// Along an edge m + t e the squared distance less the squared radius is square t^2 + 2 slope t + value.
struct DiscEdge {
  const DiscFrame& frame;
  const Corners& corners;
  int number;
  const DiscCorner &from, &to;
  exact::Number<4> e0, e1;
  Rough r0, r1, square_, slope, end_slope;

  DiscEdge(const DiscFrame& f, const Corners& box, const DiscCorner* corner, int i) noexcept
      : frame(f),
        corners(box),
        number(i),
        from(corner[i]),
        to(corner[box.next(i)]),
        e0(to.m0 - from.m0),
        e1(to.m1 - from.m1),
        r0(e0),
        r1(e1),
        square_(square(r0) + square(r1)),
        slope(from.r0 * r0 + from.r1 * r1),
        end_slope(to.r0 * r0 + to.r1 * r1) {}
  int slope_sign() const noexcept {
    return sign_of_either(
        slope, [&] { return line().slope(-1); }, SumOfProducts{}, from.m0, e0, from.m1, e1);
  }
  int end_slope_sign() const noexcept {
    return sign_of_either(
        end_slope, [&] { return line().slope(1); }, SumOfProducts{}, to.m0, e0, to.m1, e1);
  }
  /// Worked out where it is asked for.
  const PlaneLine& line() const noexcept { return line_ ? *line_ : line_.emplace(frame, corners, number); }

 private:
  mutable std::optional<PlaneLine> line_;
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
  // Of the edge's line from the origin, times the edge's length.
  const Rough off = m.r1 * edge.r0 - m.r0 * edge.r1;
  const Rough discriminant = edge.square_ * square(edge.frame.rough_radius) - square(off);
  const Scaled d = discriminant.is_precise() ? discriminant.scaled() : edge.line().discriminant();
  if (d.value < 0 || (d.value == 0 && !both_outside)) return roots;
  roots.off = off.is_precise() ? off.scaled() : edge.line().off();
  roots.discriminant = d;
  const Scaled a = edge.square_.scaled();
  const Scaled b = size_of_either(
      edge.slope, [&] { return edge.line().slope(-1); }, SumOfProducts{}, m.m0, edge.e0, m.m1, edge.e1);
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

/// Where the line of an edge meets the ellipse's outline: about the point of it that is nearest to the origin, which a
/// long edge's ends would not tell well.
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

/// Where among the places are those of each corner (-1: none) and those inside each edge, in order along it.
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
    const int unit = frame.rough_radius.exponent;
    const Real at = turn(two_doubles(corner[i].m0, unit), two_doubles(corner[i].m1, unit));
    places.at_corner[i] = found.count;
    found.add({nearest(corners.x[i]), nearest(corners.y[i]), Real(i), at});
  }
  for (int i = 0; i < corners.edges; ++i) {
    places.of_edge[i] = places.of_edge[i + 1] = found.count;
    const DiscEdge disc_edge(frame, corners, corner, i);
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

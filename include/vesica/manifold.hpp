// SPDX-License-Identifier: Apache-2.0
/// manifold(a, b): the contact points of two overlapping convex shapes, for a physics solver.
///
/// Definition: the normal n and the greatest depth are those of depth(). The facing edge of a is the edge of its core
/// whose outward normal is nearest n, and that of b the one nearest -n. Seen along n, both edges are intervals of the
/// line across n. The contacts are at the two ends of what the intervals share. The depth there is how far a's outline
/// is beyond b's along n, where an outline is the facing edge moved out along n by the radius. The point is midway.
/// The greater depth is depth()'s. A contact with a depth below 0 is left out. Points, circles, ellipses and boxes
/// without a size have no edge; beside them the contact is one point. Points nearer than least_share of the scale are
/// one.
///
/// Nothing jumps while the same edges face each other: as an edge turns, the second depth falls to 0 before its contact
/// is left out, and as one shape slides off the other, two contacts become one place. So no threshold decides what
/// counts as parallel.
///
/// Numbers: a contact is named by the vertices at which the facing edges end on its side. Which of the edges is the
/// shorter there does not matter. So the numbers stay while the same two edges face each other. Vertices are numbered
/// as stored; those of boxes counter-clockwise in their frame, from (-hx, -hy). A shape without an edge has number 0,
/// and beside it an edge has the number of the vertex at which it begins, counter-clockwise.
///
/// Laws, each tested: manifold(b, a) has the same bits with the opposite normal, the numbers exchanged, and the order
/// reversed (except for equal shapes at one place); moving both shapes alike without rounding changes no depth.
#pragma once

#include <vesica/depth.hpp>
#include <vesica/support_minimum/core_form.hpp>

namespace vesica {

/// The result of manifold(); members as in the C struct.
template <class T>
struct Contacts {
  T nx, ny;
  T x0, y0, depth0;
  T x1, y1, depth1;
  std::int64_t a0, b0, a1, b1;
  std::int64_t count;
};

namespace detail::manifold {

using support_minimum::CentredShape, support_minimum::CoreForm, support_minimum::PlaneVector;
using support_minimum::dot, support_minimum::perp;

/// Contacts nearer to each other than this share of the pair's scale are one, and a second depth that is less below 0
/// is 0: no more than rounding.
inline constexpr double least_share = 0x1p-48;

struct Vertex {
  PlaneVector at;
  std::int64_t number;
};

/// The part of a core that faces a direction: an edge, counter-clockwise, or the point `from`.
struct Face {
  Vertex from, to;
  bool edge;
  double radius;
};

inline Face point_face(const PlaneVector& at, double radius) noexcept { return {{at, 0}, {at, 0}, false, radius}; }

/// The face of a core about `centre`; outward is a unit vector.
inline Face facing(const CentredShape& s, const PlaneVector& centre, const PlaneVector& outward,
                   const CoreForm& core) noexcept {
  if (s.curved) return point_face(centre + support_minimum::furthest(s, outward), core.radius);
  if (s.a == 0 && s.b == 0) return point_face(centre, core.radius);
  const PlaneVector d = support_minimum::into_frame(s.axis, outward);
  const bool along_axis = s.b == 0 || (s.a > 0 && lane::abs(d.y) >= lane::abs(d.x));
  const int first = along_axis ? (d.y < 0 ? 0 : 2) : (d.x < 0 ? 3 : 1);
  const auto vertex = [&](int i) -> Vertex {
    const bool right = i == 1 || i == 2;
    const PlaneVector corner{right ? s.a : -s.a, i >= 2 ? s.b : -s.b};
    return {centre + support_minimum::out_of_frame(s.axis, corner), core.is_segment ? int{right} : i};
  };
  return {vertex(first), vertex((first + 1) % 4), true, core.radius};
}

/// A facing edge as seen along n: its ends by their places across n.
struct Span {
  Vertex low, high;
  double from, to;

  Span(const Vertex& first, const Vertex& last, const PlaneVector& across) noexcept
      : low(first), high(last), from(dot(across, first.at)), to(dot(across, last.at)) {}
  double length() const noexcept { return to - from; }
  PlaneVector at(double s) const noexcept {
    const double part = lane::min(lane::max((s - from) / (to - from), 0.0), 1.0);
    return low.at + part * (high.at + -low.at);
  }
  const Vertex& nearer(double s) const noexcept { return s - from < to - s ? low : high; }
  const Vertex& farther_along(const PlaneVector& n) const noexcept {
    return dot(n, low.at) > dot(n, high.at) ? low : high;
  }
};

/// The frame of two cores: about the middle of two stored points, in units of 2^exponent. The scale is about `size` of
/// these.
struct View {
  PlaneVector from, to;
  int exponent;
  double size;

  PlaneVector located(const PlaneVector& p) const noexcept {
    using support_minimum::located_coordinate;
    return {located_coordinate(from.x, to.x, arithmetic::scale(p.x, exponent)),
            located_coordinate(from.y, to.y, arithmetic::scale(p.y, exponent))};
  }
};

/// Makes the contacts of two faces of one view.
class FacingPair {
 public:
  FacingPair(const Face& a, const Face& b, const Penetration<double>& p, const View& view) noexcept
      : a_(a), b_(b), n_{p.x, p.y}, most_(p.depth), view_(view), least_span_(least_share * view.size) {}

  Contacts<double> find() const noexcept {
    if (!a_.edge || !b_.edge) {
      const PlaneVector at = a_.edge ? from_b(b_.from.at, most_) : from_a(a_.from.at, most_);
      return one(at, a_.from.number, b_.from.number);
    }
    const PlaneVector across = perp(n_);
    // Counter-clockwise, b's edge runs against `across`.
    const Span a(a_.from, a_.to, across), b(b_.to, b_.from, across);
    const double low = lane::max(a.from, b.from), high = lane::min(a.to, b.to);
    return high - low > least_span_ ? two(a, b, low, high) : touching(a, b, 0.5 * (low + high));
  }

 private:
  /// Midway between the outlines, from a point of a core.
  PlaneVector from_a(const PlaneVector& p, double depth) const noexcept { return moved(p, a_.radius - 0.5 * depth); }
  PlaneVector from_b(const PlaneVector& p, double depth) const noexcept { return moved(p, 0.5 * depth - b_.radius); }
  PlaneVector moved(const PlaneVector& p, double by) const noexcept { return view_.located(p) + by * n_; }

  Contacts<double> one(const PlaneVector& at, std::int64_t a, std::int64_t b) const noexcept {
    return {n_.x, n_.y, at.x, at.y, most_, 0, 0, 0, a, b, 0, 0, 1};
  }

  /// Edges that end where the other begins, or a core seen end on.
  Contacts<double> touching(const Span& a, const Span& b, double s) const noexcept {
    const bool end_a = !(a.length() > least_span_), end_b = !(b.length() > least_span_);
    const Vertex& p = end_a ? a.farther_along(n_) : end_b ? a_.from : a.nearer(s);
    const Vertex& q = end_b ? b.farther_along(-n_) : end_a ? b_.from : b.nearer(s);
    const PlaneVector at = end_a || !end_b ? from_a(p.at, most_) : from_b(q.at, most_);
    return one(at, p.number, q.number);
  }

  Contacts<double> two(const Span& a, const Span& b, double low, double high) const noexcept {
    const auto gap = [&](double s) { return dot(n_, a.at(s) + -b.at(s)); };
    const double rise = gap(high) - gap(low), fall = lane::abs(rise);
    const double less = fall > 0 ? most_ - arithmetic::scale_far(fall, view_.exponent) : most_;
    const double depth0 = rise > 0 ? less : most_, depth1 = rise > 0 ? most_ : less;
    // The end of an edge is a vertex of it.
    const auto place = [&](bool of_a, const Vertex& p, const Vertex& q, double depth) {
      return of_a ? from_a(p.at, depth) : from_b(q.at, depth);
    };
    const bool begins = a.from >= b.from, ends = a.to <= b.to;
    if (less < -arithmetic::scale_far(least_span_, view_.exponent)) {
      return rise > 0 ? one(place(ends, a.high, b.high, most_), a.high.number, b.high.number)
                      : one(place(begins, a.low, b.low, most_), a.low.number, b.low.number);
    }
    const double first = lane::max(depth0, 0.0), second = lane::max(depth1, 0.0);
    const PlaneVector p = place(begins, a.low, b.low, first), q = place(ends, a.high, b.high, second);
    return {n_.x, n_.y, p.x, p.y, first, q.x, q.y, second, a.low.number, b.low.number, a.high.number, b.high.number, 2};
  }

  const Face &a_, &b_;
  PlaneVector n_;
  double most_;
  const View& view_;
  double least_span_;
};

inline constexpr Contacts<double> no_contact{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};

/// The contacts of b and a.
inline Contacts<double> turned_round(const Contacts<double>& m) noexcept {
  Contacts<double> r = m;
  r.nx = 0.0 - m.nx;
  r.ny = 0.0 - m.ny;
  r.a0 = m.b0, r.b0 = m.a0;
  if (m.count < 2) return r;
  r.x0 = m.x1, r.y0 = m.y1, r.depth0 = m.depth1, r.a0 = m.b1, r.b0 = m.a1;
  r.x1 = m.x0, r.y1 = m.y0, r.depth1 = m.depth0, r.a1 = m.b0, r.b1 = m.a0;
  return r;
}

/// The order in which two cores are asked, so that exchanging them changes no bit.
inline bool in_order(const CoreForm& p, const CoreForm& q) noexcept {
  const auto& f = p.form;
  const auto& g = q.form;
  const double first[] = {p.radius, f.a, f.b, f.u.x, f.u.y, f.from.x, f.from.y, f.to.x, f.to.y};
  const double second[] = {q.radius, g.a, g.b, g.u.x, g.u.y, g.from.x, g.from.y, g.to.x, g.to.y};
  if (f.curved != g.curved) return g.curved;
  for (int i = 0; i < 9; ++i) {
    if (first[i] != second[i]) return first[i] < second[i];
  }
  return true;
}

/// The count of contacts, or error_range if a coordinate would overflow.
inline std::int32_t checked(const Contacts<double>& m, Contacts<double>& out) noexcept {
  if (!all_finite(m.x0, m.y0, m.x1, m.y1)) return error_range;
  out = m;
  return static_cast<std::int32_t>(m.count);
}

/// The contacts of two valid shapes whose depth is p.
inline Contacts<double> of_cores(const CoreForm& a, const CoreForm& b, const Penetration<double>& p) noexcept {
  if (p.x == 0 && p.y == 0) return no_contact;
  if (!in_order(a, b)) return turned_round(of_cores(b, a, depth::turned_round(p)));
  const support_minimum::PlacedPair pair = support_minimum::place(a.form, b.form);
  const PlaneVector n{p.x, p.y}, offset{pair.d.x.high, pair.d.y.high};
  const View view{a.form.from, a.form.to, pair.exponent, 1};
  return FacingPair(facing(pair.first.centred, {0, 0}, n, a), facing(pair.second.centred, offset, -n, b), p, view)
      .find();
}

/// Rounds once. The greatest depth stays above 0 if it is.
inline bool rounded_to(const Contacts<double>& m, Contacts<float>& out) noexcept {
  constexpr auto narrow = [](double x) { return static_cast<float>(x) + 0.0f; };
  constexpr auto length = [](double x) {
    const auto rounded = static_cast<float>(x);
    return x > 0 && rounded == 0 ? std::numeric_limits<float>::denorm_min() : rounded;
  };
  const Contacts<float> r{narrow(m.nx), narrow(m.ny), narrow(m.x0),     narrow(m.y0), length(m.depth0),
                          narrow(m.x1), narrow(m.y1), length(m.depth1), m.a0,         m.b0,
                          m.a1,         m.b1,         m.count};
  if (!all_finite(r.x0, r.y0, r.depth0, r.x1, r.y1, r.depth1)) return false;
  out = r;
  return true;
}

}  // namespace detail::manifold

/// The checked form: writes the contacts of two shapes of any kinds. Returns how many there are, 0 for disjoint shapes;
/// or error_shape if a shape is invalid, or error_range if a depth or a coordinate exceeds the largest finite number.
/// On error `out` is untouched.
template <template <class> class A, template <class> class B>
std::int32_t manifold_or_error(const A<double>& a, const B<double>& b, Contacts<double>& out) noexcept {
  using detail::support_minimum::core_form;
  Penetration<double> p{0, 0, 0};
  const std::int32_t error = depth_or_error(a, b, p);
  if (error != 0) return error;
  return detail::manifold::checked(detail::manifold::of_cores(core_form(a), core_form(b), p), out);
}

template <template <class> class A, template <class> class B>
std::int32_t manifold_or_error(const A<float>& a, const B<float>& b, Contacts<float>& out) noexcept {
  Contacts<double> wide = detail::manifold::no_contact;
  const std::int32_t code = manifold_or_error(widen(a), widen(b), wide);
  if (code < 0) return code;
  return detail::manifold::rounded_to(wide, out) ? code : static_cast<std::int32_t>(error_range);
}

/// The contacts of two shapes of any kinds. For valid shapes: there are none if manifold_or_error(), the checked form,
/// returns an error.
template <template <class> class A, template <class> class B, class T>
Contacts<T> manifold(const A<T>& a, const B<T>& b) noexcept {
  Contacts<T> out{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  manifold_or_error(a, b, out);
  return out;
}

}  // namespace vesica

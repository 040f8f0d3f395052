// SPDX-License-Identifier: Apache-2.0
/// The global minimum over all directions n of F(n) = h_a(n) + h_b(n) - n.D, the depth of two ellipses that overlap, or
/// of F(n) = h_a(n) - h_b(n) - n.D, the distance of the outlines where b is inside a: for scalars and for lanes.
///
/// A search starts from the best of eight directions, along and between the axes of the ellipses, and finds a local
/// minimum m as in nearest/direction.hpp (F is -phi there). A certificate then proves that m is the global minimum;
/// only then is the answer settled. With A = h_a^2, B = h_b^2 and L = m + n.D, all three polynomials in the tangent x
/// of half the angle from the minimum,
///   P = 4 A B - (L^2 - A - B)^2 = (h_a + h_b + L) (h_a + h_b - L) (L + h_a - h_b) (L - h_a + h_b),
/// which has a double zero at x = 0 (Heron's formula for a triangle with the sides h_a, h_b and L). For the sum, F >= m
/// wherever P / x^2 > 0, and also where L^2 < A + B + 2 G, G the quadratic form of the geometric mean of the two
/// ellipses' matrices, which is nowhere above h_a h_b (T. Ando, "Concavity of certain maps on positive definite
/// matrices", LAA 26 (1979) 203). n.D < 0 needs no proof, for F(n) >= F(-n) there. For the difference, -P / x^2 > 0 all
/// round shows it: the factors of -P other than F - m are positive at the minimum, and then stay so.
///
/// The certificate fails where two minima are nearly equal, or where a very thin ellipse turns between two cuts: for
/// less than 1% of random pairs at aspects up to 5, 4% up to 20, 20% up to 1000 (tests/depth/core_test.cpp prints it).
/// The search over arcs (arc_search.hpp) then answers.
#pragma once

#include <cstddef>
#include <vesica/support_minimum/positive_polynomial.hpp>

namespace vesica::detail::support_minimum {

/// b inside a.
template <class V>
struct NestedEllipses {
  TwoEllipses<V> pair;
};

template <class V>
VESICA_INLINE Pull<V> pull(const NestedEllipses<V>& s, const Direction<V>& n, V nn) noexcept {
  const Image<V> a = image(s.pair.sa, n), b = image(s.pair.sb, n);
  const V inverse = V(1.0) / (a.square * b.square);
  const Pull<V> p = pull(s.pair.sa, a, n, nn, inverse * b.square), q = pull(s.pair.sb, b, n, nn, inverse * a.square);
  return {p.x - q.x, p.y - q.y, p.bend - q.bend, p.third - q.third, p.fourth - q.fourth, max(p.flatness, q.flatness)};
}
template <class V>
VESICA_INLINE Direction<V> middle(const NestedEllipses<V>& s, const Direction<V>& d, const Bracket<V>& bracket,
                                  int step) noexcept {
  return middle(s.pair, d, bracket, step);
}

/// Unit vectors with n.D >= 0, and F there.
template <int count, class V>
struct Samples {
  Direction<V> n[std::size_t{count}];
  V value[std::size_t{count}];
};

/// Along the axes of an ellipse, and half way between them on its outline: own and other say how the two
/// support functions enter.
template <class V>
VESICA_INLINE void sample(const Axes<V>& e, double own, const SemiAxes<V>& f, double other, const Direction<V>& d,
                          Direction<V>* n, V* value) noexcept {
  const V one(1.0), uu = e.ux * e.ux + e.uy * e.uy;
  const V scale = one / sqrt(uu), oblique = scale / sqrt(e.a * e.a + e.b * e.b);
  const V diagonal = (V(1.4142135623730951) * (e.a * e.b)) * uu;
  const V px = e.b * e.ux, py = e.b * e.uy, qx = e.a * e.uy, qy = e.a * e.ux;
  const Direction<V> normals[4] = {{e.ux, e.uy}, {-e.uy, e.ux}, {px - qx, py + qy}, {px + qx, py - qy}};
  const V heights[4] = {e.a * uu, e.b * uu, diagonal, diagonal}, scales[4] = {scale, scale, oblique, oblique};
  for (int i = 0; i < 4; ++i) {
    const V along = dot(normals[i], d), beyond = sqrt(image(f, normals[i]).square);
    value[i] = ((V(own) * heights[i] + V(other) * beyond) - abs(along)) * scales[i];
    n[i] = {flip_sign(normals[i].x * scales[i], along), flip_sign(normals[i].y * scales[i], along)};
  }
}

/// The best sample, and its neighbours among lines through the samples.
template <class V>
struct Start {
  Direction<V> n;
  Bracket<V> bracket;
};

template <class V>
VESICA_INLINE void narrow(Start<V>& start, const Direction<V>& sample) noexcept {
  const V along = dot(start.n, sample), turn = flip_sign(cross(start.n, sample), along), zero(0.0);
  const Direction<V> n{flip_sign(sample.x, along), flip_sign(sample.y, along)};
  Bracket<V>& bracket = start.bracket;
  bracket.high = choose(both(turn > zero, cross(n, bracket.high) > zero), n, bracket.high);
  bracket.low = choose(both(turn<zero, cross(bracket.low, n)> zero), n, bracket.low);
}

template <int count, class V>
VESICA_INLINE Start<V> start(const Samples<count, V>& s) noexcept {
  Direction<V> n = s.n[0];
  V least = s.value[0];
  for (int i = 1; i < count; ++i) {
    const auto less = s.value[i] < least;
    n = choose(less, s.n[i], n);
    least = select(less, s.value[i], least);
  }
  Start<V> found{n, {{n.y, -n.x}, {-n.y, n.x}}};
  for (int i = 0; i < count; ++i) narrow(found, s.n[i]);
  return found;
}

/// A symmetric matrix.
template <class V>
struct QuadraticForm {
  V xx, xy, yy;
};
/// S of an ellipse in the frame whose first axis is the unit vector n.
template <class V>
VESICA_INLINE QuadraticForm<V> quadratic_form(const SemiAxes<V>& e, const Direction<V>& n) noexcept {
  const V p = e.x0 * n.x + e.y0 * n.y, q = e.x1 * n.x + e.y1 * n.y;
  const V s = e.y0 * n.x - e.x0 * n.y, t = e.y1 * n.x - e.x1 * n.y;
  return {p * p + q * q, p * s + q * t, s * s + t * t};
}

/// Rounding of coefficients, as a share of what they are made of: A and B have coefficients of 8 times their traces at
/// most, L^2 of 4 times the square of its terms.
inline constexpr double coefficient_margin = 0x1p-42;

/// L, and bounds of the coefficients of degrees 4 and 8.
template <class V>
struct Level {
  Polynomial<2, V> l;
  V margin, square_margin;
};
template <class V>
VESICA_INLINE Level<V> level(V least, V dx, V dy, V traces) noexcept {
  const V length = least + (abs(dx) + abs(dy)), size = traces + length * length;
  return {disc_by_half_angle(least, dx, dy), V(coefficient_margin) * size, (V(coefficient_margin) * size) * size};
}

/// Without its two lowest coefficients: over x^2.
template <class V>
VESICA_INLINE Polynomial<6, V> deflated(const Polynomial<8, V>& p) noexcept {
  return {{p.c[2], p.c[3], p.c[4], p.c[5], p.c[6], p.c[7], p.c[8]}};
}
template <class V>
VESICA_INLINE Polynomial<6, V> operator-(const Polynomial<6, V>& p, const Polynomial<6, V>& q) noexcept {
  return {{p.c[0] - q.c[0], p.c[1] - q.c[1], p.c[2] - q.c[2], p.c[3] - q.c[3], p.c[4] - q.c[4], p.c[5] - q.c[5],
           p.c[6] - q.c[6]}};
}
template <class V>
VESICA_INLINE Polynomial<4, V> doubled(const Polynomial<4, V>& p) noexcept {
  return {{p.c[0] + p.c[0], p.c[1] + p.c[1], p.c[2] + p.c[2], p.c[3] + p.c[3], p.c[4] + p.c[4]}};
}

/// The two terms of P / x^2: (2 A) (2 B) and (L^2 - A - B)^2.
template <class V>
struct Heron {
  Polynomial<6, V> product, squared;
};
template <class V>
VESICA_INLINE Heron<V> heron(const Polynomial<4, V>& a, const Polynomial<4, V>& b,
                             const Polynomial<4, V>& ll) noexcept {
  const Polynomial<4, V> rest = (ll - a) - b;
  return {deflated(doubled(a) * doubled(b)), deflated(rest * rest)};
}

/// Beyond this many pieces degree 6 decides little that degree 4 does not.
inline constexpr int heron_pieces = 7;

// The cuts of the circle of directions on either side of the minimum: tangents of half the angles (8 to 165 degrees;
// 45 to 170), chosen by trial on random pairs. Functions, so that objects for different instruction sets share no
// symbol.
consteval Cuts<11> cuts_of_sum() noexcept {
  return Cuts<11>({.07, .16, .28, .42, .6, .81, 1.07, 1.48, 2.14, 3.5, 7.6});
}
consteval Cuts<6> cuts_of_difference() noexcept { return Cuts<6>({.36, .84, 1.43, 2.41, 4.7, 11.4}); }

/// For a unit vector n where h_a + h_b - n.D has a local minimum `least`.
template <class V>
VESICA_INLINE MaskOf<V> is_least_of_sum(const TwoEllipses<V>& s, const Direction<V>& d, const Direction<V>& n,
                                        V least) noexcept {
  const V zero(0.0), one(1.0), two(2.0);
  const QuadraticForm<V> a = quadratic_form(s.sa, n), b = quadratic_form(s.sb, n);
  const V dx = dot(n, d), dy = cross(n, d);
  const Level<V> lev = level(least, dx, dy, (a.xx + a.yy) + (b.xx + b.yy));
  const Polynomial<4, V> ll = square(lev.l);
  const Heron<V> terms = heron(form_by_half_angle(a.xx, a.xy, a.yy), form_by_half_angle(b.xx, b.xy, b.yy), ll);
  const Polynomial<6, V> over = terms.product - terms.squared;
  // The geometric mean of S_a and S_b is (det_b^(1/2) S_a + det_a^(1/2) S_b) / (2 (det_a det_b)^(1/2) + mu)^(1/2).
  const V root_a = (s.a.a * s.a.b) * (s.a.ux * s.a.ux + s.a.uy * s.a.uy);
  const V root_b = (s.b.a * s.b.b) * (s.b.ux * s.b.ux + s.b.uy * s.b.uy);
  const V mu = (a.xx * b.yy + a.yy * b.xx) - two * (a.xy * b.xy);
  const V share = two / sqrt(two * (root_a * root_b) + mu), of_a = one + share * root_b, of_b = one + share * root_a;
  const Polynomial<4, V> room =
      form_by_half_angle(of_a * a.xx + of_b * b.xx, of_a * a.xy + of_b * b.xy, of_a * a.yy + of_b * b.yy) - ll;
  MaskOf<V> proved = zero == zero;
  constexpr Cuts<11> cuts = cuts_of_sum();
  for (int mirrored = 0; mirrored < 2; ++mirrored) {
    const double side = mirrored == 0 ? 1 : -1;
    Polynomial<6, V> p = bernstein(over, side, lev.square_margin);
    Polynomial<4, V> q = bernstein(room, side, lev.margin);
    for (int i = 0; i < heron_pieces; ++i) {
      proved = both(proved, max(cut(p, cuts.powers[i]), cut(q, cuts.powers[i])) > zero);
    }
    V ahead = zero;  // n.D times 1 + x^2 at the last cut; near the minimum it is not asked for
    for (int i = heron_pieces; i < cuts.count; ++i) {
      const double x = cuts.at[i];
      const V next = dx * V(1 - x * x) + dy * V(2 * side * x);
      proved = both(proved, either(cut(q, cuts.powers[i]) > zero, both(ahead < zero, next < zero)));
      ahead = next;
    }
    proved = both(proved, either(least_coefficient(q) > zero, both(ahead<zero, dx> zero)));
  }
  return proved;
}

/// The same of h_a - h_b - n.D.
template <class V>
VESICA_INLINE MaskOf<V> is_least_of_difference(const TwoEllipses<V>& s, const Direction<V>& d, const Direction<V>& n,
                                               V least) noexcept {
  const QuadraticForm<V> a = quadratic_form(s.sa, n), b = quadratic_form(s.sb, n);
  const Level<V> lev = level(least, dot(n, d), cross(n, d), (a.xx + a.yy) + (b.xx + b.yy));
  const Heron<V> terms =
      heron(form_by_half_angle(a.xx, a.xy, a.yy), form_by_half_angle(b.xx, b.xy, b.yy), square(lev.l));
  const Polynomial<6, V> over = terms.squared - terms.product;
  constexpr Cuts<6> cuts = cuts_of_difference();
  V sure = over.c[0];
  for (int mirrored = 0; mirrored < 2; ++mirrored) {
    Polynomial<6, V> p = bernstein(over, mirrored == 0 ? 1 : -1, lev.square_margin);
    for (const double(&powers)[7] : cuts.powers) sure = min(sure, cut(p, powers));
    sure = min(sure, least_coefficient(p));
  }
  return sure > V(0.0);
}

/// Near the evolute F is nearly flat at its minimum, and the direction is known to half its digits or fewer. Returns
/// true if the last turn, from n to `to`, is small enough: a vector turned so far must keep its length, and a point
/// moved so far along the tangent of an outline of radius `curvature` must stay on it, both to rounding.
template <class V>
VESICA_INLINE MaskOf<V> turns_little(const Direction<V>& n, const Direction<V>& to, V curvature, V size) noexcept {
  const V turn = cross(n, to), squared = turn * turn;
  return both(squared <= V(0x1p-55), curvature * squared <= V(0x1p-56) * size);
}

/// A search that takes more steps is left to arc_search.hpp; random pairs take 3 to 8.
inline constexpr int step_limit = 16;

/// Two ellipses that overlap, d from a's centre to b's: `distance` is minus the depth, and b has to move along the unit
/// vector (nx, ny). Nothing is asked of idle lanes.
template <class V>
VESICA_INLINE ClosestOffsets<V> deepest(const Axes<V>& a, const Axes<V>& b, const Vector<V>& d, V size,
                                        MaskOf<V> idle) noexcept {
  const TwoEllipses<V> shapes = two_ellipses(a, b);
  const Direction<V> towards{d.x.high, d.y.high};
  Samples<8, V> samples;
  sample(a, 1, shapes.sb, 1, towards, samples.n, samples.value);
  sample(b, 1, shapes.sa, 1, towards, samples.n + 4, samples.value + 4);
  const Start<V> from = start(samples);
  const FoundDirection<V> best = search_between(shapes, towards, size, from.n, from.bracket, idle, step_limit);
  const auto n = normal(factor(best.n.x, best.n.y));
  ClosestOffsets<V> result = separation(d, n, support(a, n), support(b, n), size);
  const auto straight = turns_little(n.unit, {result.nx, result.ny}, V(0.0), size);
  const auto proved = is_least_of_sum(shapes, towards, n.unit, -rounded(result.distance));
  result.settled = both(both(result.settled, best.found), both(straight, proved));
  return result;
}

/// b inside a: `distance` is minus the outlines' distance, at offsets (ax, ay) and (bx, by) from the centres.
template <class V>
VESICA_INLINE ClosestOffsets<V> closest_inside(const Axes<V>& a, const Axes<V>& b, const Vector<V>& d, V size,
                                               MaskOf<V> idle) noexcept {
  const NestedEllipses<V> shapes{two_ellipses(a, b)};
  const Direction<V> towards{d.x.high, d.y.high};
  Samples<8, V> samples;
  sample(a, 1, shapes.pair.sb, -1, towards, samples.n, samples.value);
  sample(b, -1, shapes.pair.sa, 1, towards, samples.n + 4, samples.value + 4);
  const Start<V> from = start(samples);
  const FoundDirection<V> best = search_between(shapes, towards, size, from.n, from.bracket, idle, step_limit);
  const auto n = normal(factor(best.n.x, best.n.y));
  const Support<V> outer = support(a, n), inner = support(b, n);
  const Support<V> taken{-inner.height, -inner.x, -inner.y, -inner.curvature, inner.inverse_square};
  ClosestOffsets<V> result = separation(d, n, outer, taken, size);
  const V radius = max(outer.curvature, inner.curvature);
  const auto straight = turns_little(n.unit, {result.nx, result.ny}, radius, size);
  const auto proved = is_least_of_difference(shapes.pair, towards, n.unit, -rounded(result.distance));
  result.settled = both(both(result.settled, best.found), both(straight, proved));
  return result;
}

}  // namespace vesica::detail::support_minimum

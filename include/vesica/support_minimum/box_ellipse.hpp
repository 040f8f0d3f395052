// SPDX-License-Identifier: Apache-2.0
/// A rectangle and an ellipse that overlap: the depth, and the distance of the outlines where one is inside the other.
/// The method is as in two_ellipses.hpp with the corners of the rectangle in the place of one ellipse. For a corner v
/// and L = m + n.(D - v), F >= m wherever h^2 > L^2 or L < 0. This is of degree 4 in the tangent of half an angle.
#pragma once

#include <vesica/support_minimum/two_ellipses.hpp>

namespace vesica::detail::support_minimum {

/// A pair in the frame of the rectangle, mirrored so that the ellipse's centre d is in the first quadrant. Lengths are
/// in units of 1 / |u|.
template <class V>
struct MirroredPair {
  V side_x, side_y;  ///< signs: what is mirrored
  V hx, hy;
  Axes<V> e;
  Direction<V> d;
};

template <class V>
VESICA_INLINE MirroredPair<V> mirrored_pair(const Box<V>& box, const Axes<V>& e, V dx, V dy) noexcept {
  const V one(1.0), ux = box.u.x.high, uy = box.u.y.high, uu = ux * ux + uy * uy;
  const V kx = ux * dx + uy * dy, ky = ux * dy - uy * dx;
  return {flip_sign(one, kx),
          flip_sign(one, ky),
          box.hx.high * uu,
          box.hy.high * uu,
          {flip_sign(ux * e.ux + uy * e.uy, kx), flip_sign(ux * e.uy - uy * e.ux, ky), e.a, e.b},
          {abs(kx), abs(ky)}};
}

/// Along the faces that lead to the ellipse, along the ellipse's axes and half way between them, and diagonally.
template <class V>
VESICA_INLINE Samples<8, V> samples(const MirroredPair<V>& p, const QuadraticForm<V>& s) noexcept {
  const V zero(0.0), one(1.0), half(0.7071067811865476);
  const V scale = one / sqrt(p.e.ux * p.e.ux + p.e.uy * p.e.uy), oblique = scale / sqrt(p.e.a * p.e.a + p.e.b * p.e.b);
  const V bx = p.e.b * p.e.ux, by = p.e.b * p.e.uy, ax = p.e.a * p.e.uy, ay = p.e.a * p.e.ux;
  const Direction<V> normals[8] = {{one, zero},
                                   {zero, one},
                                   {half, half},
                                   {half, -half},
                                   {p.e.ux * scale, p.e.uy * scale},
                                   {-p.e.uy * scale, p.e.ux * scale},
                                   {(bx - ax) * oblique, (by + ay) * oblique},
                                   {(bx + ax) * oblique, (by - ay) * oblique}};
  Samples<8, V> result;
  for (int i = 0; i < 8; ++i) {
    const Direction<V>& n = normals[i];
    const V along = dot(n, p.d);
    const V height = sqrt(s.xx * (n.x * n.x) + (V(2.0) * s.xy) * (n.x * n.y) + s.yy * (n.y * n.y));
    result.value[i] = height + ((abs(n.x) * p.hx + abs(n.y) * p.hy) - abs(along));
    result.n[i] = {flip_sign(n.x, along), flip_sign(n.y, along)};
  }
  return result;
}

/// A corner's signs, the quarter of directions it rules in, and where to start there.
template <class V>
struct CornerStart {
  V i, j;
  Start<V> from;
  MaskOf<V> face_x, face_y;  ///< the best sample is a face's normal, and F rises on both sides of it
};

/// A face's normal rules in two quarters: the one is taken in which F falls, if it does.
template <class V>
VESICA_INLINE CornerStart<V> corner_start(const MirroredPair<V>& p, const QuadraticForm<V>& s,
                                          const Samples<8, V>& all_samples) noexcept {
  const V zero(0.0), one(1.0);
  const Start<V> from = start(all_samples);
  const auto on_x = from.n.y == zero, on_y = from.n.x == zero;
  // The ellipse's support point relative to the faces' middles.
  const V beside_x = s.xy / sqrt(s.xx) - p.d.y, beside_y = s.xy / sqrt(s.yy) - p.d.x;
  const V i = flip_sign(one, select(on_y, -beside_y, from.n.x)), j = flip_sign(one, select(on_x, -beside_x, from.n.y));
  CornerStart<V> found{i, j, from, both(on_x, abs(beside_x) <= p.hy), both(on_y, abs(beside_y) <= p.hx)};
  Bracket<V>& bracket = found.from.bracket;
  // Counterclockwise: from (i, 0) to (0, j) where i j > 0.
  const auto x_first = i * j > zero;
  const Direction<V> x{i, zero}, y{zero, j}, first = choose(x_first, x, y), second = choose(x_first, y, x);
  bracket.low = choose(cross(bracket.low, first) > zero, first, bracket.low);
  bracket.high = choose(cross(second, bracket.high) > zero, second, bracket.high);
  return found;
}

/// A quarter of directions, seen from its first face's normal: the ellipse, h^2 - L^2, and -L.
template <class V>
struct Quarter {
  Polynomial<4, V> room;
  Polynomial<2, V> clear;
};
template <class V>
VESICA_INLINE Quarter<V> quarter(const QuadraticForm<V>& s, V least, V dx, V dy) noexcept {
  const Polynomial<2, V> l = disc_by_half_angle(least, dx, dy);
  return {form_by_half_angle(s.xx, s.xy, s.yy) - square(l), {{-l.c[0], -l.c[1], -l.c[2]}}};
}

/// Without a zero at x (from 0 to 1), once or twice.
template <class V>
VESICA_INLINE Polynomial<4, V> deflated(const Polynomial<4, V>& p, V x, MaskOf<V> once, MaskOf<V> twice) noexcept {
  const V zero(0.0), one(1.0);
  const V q3 = p.c[4], q2 = p.c[3] + x * q3, q1 = p.c[2] + x * q2, q0 = p.c[1] + x * q1;
  const V r2 = q3, r1 = q2 + x * r2, r0 = q1 + x * r1;
  // p = (x - zero) q: q is to be negative where the zero is at the upper end.
  const V sign = select(x > zero, -one, one);
  const auto pick = [&](const V& single, const V& twofold, const V& whole) {
    return select(once, sign * single, select(twice, twofold, whole));
  };
  return {{pick(q0, r0, p.c[0]), pick(q1, r1, p.c[1]), pick(q2, r2, p.c[2]), pick(q3, zero, p.c[3]),
           pick(zero, zero, p.c[4])}};
}

/// The cuts of a quarter: close to its first direction, where there is a zero or a thin ellipse turns, or evenly.
consteval Cuts<10> cut_near_first() noexcept { return Cuts<10>({.02, .05, .09, .14, .2, .28, .38, .52, .74, 1}); }
consteval Cuts<7> cut_evenly() noexcept { return Cuts<7>({.08, .22, .4, .6, .8, .92, 1}); }

/// True if on each piece of 0 <= x <= 1 the one or the other is positive.
template <int count, class V>
VESICA_INLINE MaskOf<V> either_positive(const Polynomial<4, V>& p, const Polynomial<2, V>& q, V margin,
                                        const Cuts<count>& cuts) noexcept {
  const V zero(0.0);
  Polynomial<4, V> first = bernstein(p, 1, margin);
  Polynomial<2, V> second = bernstein(q, 1, zero);
  MaskOf<V> proved = zero == zero;
  for (const double(&powers)[7] : cuts.powers) {
    proved = both(proved, max(cut(first, powers), cut(second, powers)) > zero);
  }
  return proved;
}

/// True if F is nowhere less than `least`, its value along a face's normal, or a local minimum in the direction n.
template <class V>
VESICA_INLINE MaskOf<V> is_least_of_corners(const MirroredPair<V>& p, const QuadraticForm<V>& s,
                                            const CornerStart<V>& at, const Direction<V>& n, V least) noexcept {
  const V zero(0.0), one(1.0);
  const auto face = either(at.face_x, at.face_y), never = zero > zero;
  const V length = least + (p.hx + p.hy) + (p.d.x + p.d.y), size = (s.xx + s.yy) + length * length;
  const V margin = V(coefficient_margin) * size;
  const auto here = [&](V i, V j) { return and_not(both(at.i == i, at.j == j), face); };
  // From the face towards x to the one towards y, from that on, and before the first.
  const auto main = here(one, one), after = here(-one, one), before = here(one, -one);
  const V ahead = abs(n.y) / (one + abs(n.x)), aside = abs(n.x) / (one + abs(n.y));
  const V x_main = select(main, ahead, select(at.face_x, zero, one));
  const Quarter<V> q_main = quarter(s, least, p.d.x - p.hx, p.d.y - p.hy);
  const Quarter<V> q_after = quarter(QuadraticForm<V>{s.yy, -s.xy, s.xx}, least, p.d.y - p.hy, -(p.d.x + p.hx));
  const Quarter<V> q_before = quarter(QuadraticForm<V>{s.xx, -s.xy, s.yy}, least, p.d.x - p.hx, -(p.d.y + p.hy));
  constexpr auto evenly = cut_evenly();
  constexpr auto near_first = cut_near_first();
  const auto proved_main = either_positive(deflated(q_main.room, x_main, face, main), q_main.clear, margin, evenly);
  const auto proved_after = either_positive(deflated(q_after.room, select(after, aside, zero), at.face_y, after),
                                            q_after.clear, margin, near_first);
  const auto proved_before = either_positive(deflated(q_before.room, select(before, ahead, zero), at.face_x, before),
                                             q_before.clear, margin, near_first);
  const auto known = either(face, either(main, either(after, before)));
  return both(and_not(known, never), both(proved_main, both(proved_after, proved_before)));
}

/// A box and an ellipse that overlap, d from the box's centre to the ellipse's: `distance` is minus the depth, and the
/// ellipse has to move along the unit vector (nx, ny).
template <class V>
VESICA_INLINE BoxEllipse<V> deepest(const Box<V>& box, const Axes<V>& e, const Vector<V>& d, V size,
                                    MaskOf<V> idle) noexcept {
  const V one(1.0);
  const MirroredPair<V> p = mirrored_pair(box, e, d.x.high, d.y.high);
  const QuadraticForm<V> s = quadratic_form(semi_axes(p.e), Direction<V>{one, V(0.0)});
  const CornerStart<V> at = corner_start(p, s, samples(p, s));
  const auto face = either(at.face_x, at.face_y);
  const V ux = box.u.x.high, uy = box.u.y.high, length = sqrt(ux * ux + uy * uy);
  FoundDirection<V> best{at.from.n, face, 0};
  const Direction<V> from_corner{p.d.x - at.i * p.hx, p.d.y - at.j * p.hy};
  if (!all(either(face, idle))) {
    best = search_between(one_ellipse(p.e), from_corner, size * length, at.from.n, at.from.bracket, either(face, idle),
                          step_limit);
  }
  const V nx = best.n.x * p.side_x, ny = best.n.y * p.side_y;
  const FoundDirection<V> back{{nx * ux - ny * uy, nx * uy + ny * ux}, best.found, best.steps};
  const Feature<V> feature{at.i * p.side_x, at.j * p.side_y, at.face_x, at.face_y};
  const Vector<V> from_vertex = renormalised(d - vertex(box, feature.i, feature.j));
  BoxEllipse<V> result = feature_ellipse(box, one_ellipse(e), d, size, feature, from_vertex, back);
  const Direction<V> n = unit(best.n.x, best.n.y);
  const V least = -rounded(result.distance) * length;
  const V off = (result.nx * result.nx + result.ny * result.ny) - one;
  result.settled = both(both(result.settled, abs(off) <= V(0x1p-51)), is_least_of_corners(p, s, at, n, least));
  return result;
}

/// The ellipse is inside the box, d from the box's centre to the ellipse's: its distance from the nearest face.
template <class V>
VESICA_INLINE ClosestOffsets<V> closest_inside(const Box<V>& box, const Axes<V>& e, const Vector<V>& d) noexcept {
  const V zero(0.0), one(1.0), ux = box.u.x.high, uy = box.u.y.high, uu = ux * ux + uy * uy;
  const SemiAxes<V> semi = semi_axes(e);
  const V kx = ux * d.x.high + uy * d.y.high, ky = ux * d.y.high - uy * d.x.high;
  const V gap_x = (box.hx.high * uu - sqrt(image(semi, Direction<V>{ux, uy}).square)) - abs(kx);
  const V gap_y = (box.hy.high * uu - sqrt(image(semi, Direction<V>{-uy, ux}).square)) - abs(ky);
  const auto across = gap_y < gap_x;
  const V side = select(across, ky, kx), own = select(across, box.hy.high, box.hx.high);
  const V other = select(across, box.hx.high, box.hy.high);
  const auto n = normal(factor(flip_sign(select(across, -uy, ux), side), flip_sign(select(across, ux, uy), side)));
  const Support<V> reach = support(e, n);
  const Twofold<V> wall = factor(square(n.vector.x) + square(n.vector.y)) * factor(own);
  const Twofold<V> phi = factor((dot(n.vector, factor(d)) + reach.height) - wall) * factor(n.inverse_length);
  const V x = n.vector.x.high, y = n.vector.y.high;
  const V level = (x * (d.y.high + reach.y) - y * (d.x.high + reach.x)) / uu, foot = max(-other, min(other, level));
  return {phi, own * x - foot * y, own * y + foot * x, reach.x, reach.y, n.unit.x, n.unit.y, zero < one};
}

/// Corners of a box in the frame of an ellipse around it, in units of the ellipse's axis, folded into the first
/// quadrant.
template <class V>
struct FoldedCorners {
  V x[4], y[4];
};

// Signs of the four corners, counterclockwise.
constexpr double corner_i(int v) noexcept { return v == 0 || v == 3 ? 1 : -1; }
constexpr double corner_j(int v) noexcept { return v < 2 ? 1 : -1; }

/// The corner that seems nearest to the outline, its place in the ellipse's frame, and a direction there to begin with.
template <class V>
struct NearestCorner {
  V i, j, x, y;
  Direction<V> n;  // in the ellipse's frame, folded
};

/// By the outline's normals at five even steps of the ellipse's quadrant.
template <class V>
VESICA_INLINE NearestCorner<V> nearest_corner(const FoldedCorners<V>& c, V a, V b) noexcept {
  constexpr double cosine[] = {1, 0.9238795325112867, 0.7071067811865476, 0.3826834323650898, 0};
  NearestCorner<V> best{V(1.0), V(1.0), c.x[0], c.y[0], {V(1.0), V(0.0)}};
  V least(0x1p1000);
  for (int k = 0; k < 5; ++k) {
    const V nx = b * V(cosine[k]), ny = a * V(cosine[4 - k]), scale = V(1.0) / sqrt(nx * nx + ny * ny);
    V reach = nx * c.x[0] + ny * c.y[0];
    NearestCorner<V> farthest{V(1.0), V(1.0), c.x[0], c.y[0], {nx * scale, ny * scale}};
    for (int v = 1; v < 4; ++v) {
      const V other = nx * c.x[v] + ny * c.y[v];
      const auto more = other > reach;
      reach = select(more, other, reach);
      farthest = {select(more, V(corner_i(v)), farthest.i), select(more, V(corner_j(v)), farthest.j),
                  select(more, c.x[v], farthest.x), select(more, c.y[v], farthest.y), farthest.n};
    }
    const V value = (a * b - reach) * scale;
    const auto less = value < least;
    least = select(less, value, least);
    best = {select(less, farthest.i, best.i), select(less, farthest.j, best.j), select(less, farthest.x, best.x),
            select(less, farthest.y, best.y), choose(less, farthest.n, best.n)};
  }
  return best;
}

/// True if no corner is nearer to the outline than `least`, the least distance of the best one. From a point of a
/// quadrant the outline is nearest in that quadrant, and there it has one minimum only (D. Eberly, "Distance from a
/// Point to an Ellipse"); a point that is nearer to both axes is farther from it.
template <class V>
VESICA_INLINE MaskOf<V> is_nearest_corner(const FoldedCorners<V>& c, const NearestCorner<V>& best, V a, V b,
                                          V least) noexcept {
  const V zero(0.0), length = least + (a + b), margin = V(4 * coefficient_margin) * (length * length);
  const QuadraticForm<V> s{a * a, zero, b * b};
  constexpr auto near_first = cut_near_first();
  MaskOf<V> proved = zero == zero;
  for (int v = 0; v < 4; ++v) {
    const auto inner = both(c.x[v] <= best.x, c.y[v] <= best.y);
    const Quarter<V> q = quarter(s, least, c.x[v], c.y[v]);
    proved = both(proved, either(inner, either_positive(q.room, q.clear, margin, near_first)));
  }
  return proved;
}

/// The box is inside the ellipse, d from the ellipse's centre to the box's: `distance` is minus the outlines' distance;
/// (ax, ay) is on the ellipse, (bx, by) the box's corner, as offsets from their centres.
template <class V>
VESICA_INLINE ClosestOffsets<V> closest_inside(const Axes<V>& given, const Box<V>& box, const Vector<V>& d, V size,
                                               MaskOf<V> idle) noexcept {
  // The shorter half length first: a thin ellipse then turns near the first direction of its quarter.
  const auto turned_axes = given.a > given.b;
  const Axes<V> e{select(turned_axes, -given.uy, given.ux), select(turned_axes, given.ux, given.uy),
                  select(turned_axes, given.b, given.a), select(turned_axes, given.a, given.b)};
  const V zero(0.0), one(1.0), ux = box.u.x.high, uy = box.u.y.high, hx = box.hx.high, hy = box.hy.high;
  const V ww = e.ux * e.ux + e.uy * e.uy, a = e.a * ww, b = e.b * ww;
  const V kx = e.ux * d.x.high + e.uy * d.y.high, ky = e.ux * d.y.high - e.uy * d.x.high;
  const V c = e.ux * ux + e.uy * uy, s = e.ux * uy - e.uy * ux;
  FoldedCorners<V> corners;
  V side_x[4], side_y[4];
  for (int v = 0; v < 4; ++v) {
    const V i(corner_i(v)), j(corner_j(v));
    side_x[v] = (kx + i * (hx * c)) - j * (hy * s);
    side_y[v] = (ky + i * (hx * s)) + j * (hy * c);
    corners.x[v] = abs(side_x[v]);
    corners.y[v] = abs(side_y[v]);
  }
  const NearestCorner<V> best = nearest_corner(corners, a, b);
  // In the folded frame; the corner is in the first quadrant, and so is the normal there.
  const OneEllipse<V> shape{{one, zero, a, b}, semi_axes(Axes<V>{one, zero, a, b})};
  const V length = sqrt(ww);
  const FoundDirection<V> found = search_between(shape, Direction<V>{best.x, best.y}, size * length, best.n,
                                                 Bracket<V>{{one, zero}, {zero, one}}, idle, step_limit);
  const V px = (kx + best.i * (hx * c)) - best.j * (hy * s), py = (ky + best.i * (hx * s)) + best.j * (hy * c);
  const V nx = flip_sign(found.n.x, px), ny = flip_sign(found.n.y, py);
  const auto n = normal(factor(nx * e.ux - ny * e.uy, nx * e.uy + ny * e.ux));
  const Vector<V> to_corner = renormalised(d + vertex(box, best.i, best.j));
  const Support<V> outer = support(e, n);
  ClosestOffsets<V> result = separation(to_corner, n, outer, no_support<V>(), size);
  const auto straight = turns_little(n.unit, {result.nx, result.ny}, outer.curvature, size);
  const V i = best.i * hx, j = best.j * hy;
  result.bx = i * ux - j * uy;
  result.by = i * uy + j * ux;
  const auto proved = is_nearest_corner(corners, best, a, b, -rounded(result.distance) * length);
  result.settled = both(both(result.settled, found.found), both(straight, proved));
  return result;
}

}  // namespace vesica::detail::support_minimum

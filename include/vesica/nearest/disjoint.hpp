// SPDX-License-Identifier: Apache-2.0
/// Two scaled shapes that are disjoint: the distance, and where it is reached. A pair's own search may fail to settle,
/// that is to prove its result, mostly at ties within rounding. Then every vertex and face is tried here.
#pragma once

#include <vesica/nearest/box_ellipse.hpp>
#include <vesica/nearest/fine_direction.hpp>
#include <vesica/nearest/polish.hpp>
#include <vesica/nearest/scaled_pair.hpp>

namespace vesica::detail::nearest {

/// The distance, where it is reached, and a vector from a to b of any length.
struct Closest {
  Twofold<double> distance;
  Contact a, b;
  double nx, ny;
};

inline double scaled_distance(const Twofold<double>& distance, int exponent) noexcept {
  const Twofold<double> d = renormalised(distance);
  return arithmetic::scale_rounded(d.high, d.low, exponent);
}

inline Contact on_box(const Box<double>& box, const Spot<double>& p) noexcept {
  return {p, p.s * box.u.x.high - p.t * box.u.y.high, p.s * box.u.y.high + p.t * box.u.x.high};
}
inline Contact on_ellipse(double x, double y) noexcept { return {{0, 0}, x, y}; }

inline bool less(const Twofold<double>& x, const Twofold<double>& y) noexcept {
  return rounded(renormalised(x - y)) < 0;
}

/// All eight vertices, each against the other box.
inline BoxBox<double> box_box_by_vertices(const Box<double>& a, const Box<double>& b,
                                          const Vector<double>& d) noexcept {
  const bool ordered = in_order(d.x.high, d.y.high);
  BoxBox<double> best{{0x1p1000, 0}, {0, 0}, {0, 0}, 0, 0, true};
  for (int k = 0; k < 8; ++k) {
    const bool of_b = (k < 4) == ordered;
    const double i = (k & 1) != 0 ? 1 : -1, j = (k & 2) != 0 ? 1 : -1;
    const Box<double>&face = of_b ? a : b, &corner = of_b ? b : a;
    const PointBox<double> found = point_box(face, flipped(d, of_b ? 1.0 : -1.0) + vertex(corner, i, j));
    if (!less(found.distance, best.distance)) continue;
    const Spot<double> place{i * corner.hx.high, j * corner.hy.high};
    const Direction<double> out = out_of(face, found);
    best = of_b ? BoxBox<double>{found.distance, found.spot, place, out.x, out.y, true}
                : BoxBox<double>{found.distance, place, found.spot, -out.x, -out.y, true};
  }
  return best;
}

inline Closest closest_boxes(const Box<double>& a, const Box<double>& b, const Vector<double>& d) noexcept {
  BoxBox<double> found = box_box(a, b, d);
  if (!found.settled) found = box_box_by_vertices(a, b, d);
  return {found.distance, on_box(a, found.a), on_box(b, found.b), found.nx, found.ny};
}

/// bracketed_normal() of one ellipse, from each vertex of a box. Those at one place, as the box is far smaller one way
/// than its distance is, are searched once.
class VertexSearch {
 public:
  FoundNormal operator()(const OneEllipse<double>& e, const Vector<double>& d, double size) noexcept {
    for (int k = 0; k < searched_; ++k) {
      if (d.x.high == of_[k].x.high && d.y.high == of_[k].y.high) return found_[k];
    }
    of_[searched_] = d;
    return found_[searched_++] = bracketed_normal(e, d, size, Frame(e.a));
  }

 private:
  Vector<double> of_[4];
  FoundNormal found_[4];
  int searched_ = 0;
};

/// The signs of a feature's vertex, by its number: vertices, faces across x, faces across y.
inline Feature<double> feature(int k) noexcept {
  return {(k & 1) != 0 ? 1.0 : -1.0, (k & 2) != 0 ? 1.0 : -1.0, k >= 4 && k < 8, k >= 8};
}

/// True if vertex k needs no search, being certainly farther than the best feature so far: it is another one with the
/// same place, or behind the best one as seen along the best one's normal, which alone keeps the ellipse farther from
/// it. Or the way to the ellipse's centre is over 8 times as long as the ellipse and over 4 times as long as the best
/// distance. Then the slope that the search sees has the right sign, except within 12 degrees of that way:
/// the ellipse adds at most 1.5 / 8 of it. So the search ends there, and finds a distance of more than half of the way.
inline bool is_vertex_beaten(const Box<double>& box, const Axes<double>& e, const Vector<double>& d, int k,
                             const BoxEllipse<double>& best, double size) noexcept {
  if ((box.hx.high == 0 && (k & 1) != 0) || (box.hy.high == 0 && (k & 2) != 0)) return true;
  const Feature<double> f = feature(k);
  const Vector<double> at = vertex(box, f.i, f.j);
  const Vector<double> from = vertex(box, std::copysign(1.0, best.spot.s), std::copysign(1.0, best.spot.t));
  if (best.nx * (from.x.high - at.x.high) + best.ny * (from.y.high - at.y.high) > 0x1p-45 * size) return true;
  const double way = max(abs(d.x.high - at.x.high), abs(d.y.high - at.y.high));
  return way > 8 * (max(e.a, e.b) * (abs(e.ux) + abs(e.uy))) && way > 4 * best.distance.high;
}

/// How far beyond the ends of a face the ellipse's support point stands, to twice the precision.
inline double beyond_ends(const Box<double>& box, const Axes<double>& e, const Vector<double>& d,
                          const Feature<double>& f) noexcept {
  const auto u = factor(box.u);
  const Vector<double> normal =
      f.face_x ? flipped(box.u, f.i) : Vector<double>{flipped(box.u.y, -f.j), flipped(box.u.x, f.j)};
  const auto point = factor(renormalised(d - fine_support(e, factor(normal)).point));
  const Twofold<double> uu = square(u.x) + square(u.y),
                        place = renormalised(f.face_x ? cross(u, point) : dot(u, point));
  const Twofold<double> end = factor(f.face_x ? box.hy : box.hx) * factor(uu);
  return positive_part(rounded(flipped(place, place.high) - end)) / root(uu).value.high;
}

/// True if a face is as far from the ellipse as their distance along its normal.
inline bool stands_above(const Box<double>& box, const Axes<double>& e, const Vector<double>& d,
                         const Feature<double>& f, double distance) noexcept {
  return beyond_ends(box, e, d, f) <= beyond_face * abs(distance);
}

/// The faces that the ellipse's support point stands above, and all four vertices. The vertex that is likely to be the
/// closest is tried first: then few others need a search. Of equally close features the first counts.
inline BoxEllipse<double> box_ellipse_by_features(const Box<double>& box, const Axes<double>& e,
                                                  const Vector<double>& d, double size) noexcept {
  BoxEllipse<double> best{{0x1p1000, 0}, {0, 0}, 0, 0, 0, 0, false};
  int of_best = 12;
  VertexSearch vertices;
  const auto search = [&vertices](const OneEllipse<double>& of, const Vector<double>& from, double about) {
    return vertices(of, from, about);
  };
  const auto attempt = [&](int k) {
    int steps;
    const BoxEllipse<double> found = searched_feature(box, e, d, size, feature(k), search, steps);
    if (k >= 4 && !(rounded(found.distance) > -0x1p-80 * size)) return;
    if (k >= 4 && !stands_above(box, e, d, feature(k), found.distance.high)) return;
    const double farther = rounded(renormalised(found.distance - best.distance));
    if (!(farther < 0 || (farther == 0 && k < of_best))) return;
    best = found;
    of_best = k;
  };
  const bool is_point = box.hx.high == 0 && box.hy.high == 0;  // its faces are its vertex
  for (int k = is_point ? 12 : 4; k < 12; ++k) attempt(k);
  const Feature<double> guess = closest_feature(box, e, d.x.high, d.y.high);
  const int likely = (guess.i > 0 && box.hx.high != 0 ? 1 : 0) + (guess.j > 0 && box.hy.high != 0 ? 2 : 0);
  for (const int turn : {0, 1, 2, 3}) {
    const int k = turn ^ likely;
    if (!is_vertex_beaten(box, e, d, k, best, size)) attempt(k);
  }
  return best;
}

/// radius: of the circle that the box stands for, which takes so much from the distance.
inline Closest closest_box_ellipse(const Box<double>& box, const Axes<double>& e, const Vector<double>& d, double size,
                                   double radius, int& steps) noexcept {
  const Feature<double> likely = closest_feature(box, e, d.x.high, d.y.high);
  FoundNormal first{};
  const auto search = [&first](const OneEllipse<double>& of, const Vector<double>& from, double about) {
    return first = farthest_normal(of, from, about);
  };
  const auto refine = [&first](const OneEllipse<double>& of, const Vector<double>& from, double about) {
    return refined(of, from, about, {first, offsets_along(of, from, first, about)}).along;
  };
  BoxEllipse<double> found = searched_feature(box, e, d, size, likely, search, steps);
  if (!found.settled) found = searched_feature(box, e, d, size, likely, refine, steps);
  if (!found.settled) {
    found = box_ellipse_by_features(box, e, d, size);
    steps = 0;
  }
  // A face's normal is exact, and leaves no doubt.
  if (found.doubt > 0 && rounded(found.distance) - radius < found.doubt) {
    const Vector<double> corner = vertex(box, std::copysign(1.0, found.spot.s), std::copysign(1.0, found.spot.t));
    found.distance = polished_distance(found.distance, renormalised(d - corner), {found.nx, found.ny}, nullptr, e);
  }
  return {found.distance, on_box(box, found.spot), on_ellipse(found.bx, found.by), found.nx, found.ny};
}

inline Closest closest_ellipses(const Axes<double>& a, const Axes<double>& b, const Vector<double>& d, double size,
                                int& steps) noexcept {
  const TwoEllipses<double> shapes = two_ellipses(a, b);
  const FoundNormal first = farthest_normal(shapes, d, size);
  steps = first.steps;
  ClosestOffsets<double> found = offsets_along(shapes, d, first, size);
  if (!found.settled) found = refined(shapes, d, size, {first, found}).at;
  if (!found.settled) {
    found = offsets_along(shapes, d, bracketed_normal(shapes, d, size, frame_of_flatter(shapes, first)), size);
  }
  if (rounded(found.distance) < found.doubt) {
    found.distance = polished_distance(found.distance, d, {found.nx, found.ny}, &a, b);
  }
  return {found.distance, on_ellipse(found.ax, found.ay), on_ellipse(found.bx, found.by), found.nx, found.ny};
}

inline Closest exchanged(const Closest& c) noexcept { return {c.distance, c.b, c.a, -c.nx, -c.ny}; }

inline Closest closest_of_forms(const ScaledPair& p, int& steps) noexcept {
  if (!p.a.curved && !p.b.curved) return closest_boxes(p.a.box, p.b.box, p.d);
  if (!p.a.curved) return closest_box_ellipse(p.a.box, p.b.axes(), p.d, p.size, p.a.radius, steps);
  if (!p.b.curved) {
    return exchanged(closest_box_ellipse(p.b.box, p.a.axes(), flipped(p.d, -1.0), p.size, p.b.radius, steps));
  }
  return closest_ellipses(p.a.axes(), p.b.axes(), p.d, p.size, steps);
}

/// Circles reach r farther along the line between the closest points.
inline void extend(Closest& c, const ScaledPair& p) noexcept {
  if (p.a.radius == 0 && p.b.radius == 0) return;
  const double larger = max(abs(c.nx), abs(c.ny));
  if (larger == 0) return;  // so near that the radius is nothing to rounding
  const double x = c.nx / larger, y = c.ny / larger;
  const double length = sqrt(x * x + y * y), nx = x / length, ny = y / length;
  c.a.x += p.a.radius * nx, c.a.y += p.a.radius * ny;
  c.b.x -= p.b.radius * nx, c.b.y -= p.b.radius * ny;
  c.distance = c.distance - exact_sum(p.a.radius, p.b.radius);
}

inline Closest closest(const ScaledPair& p, int& steps) noexcept {
  Closest c = closest_of_forms(p, steps);
  extend(c, p);
  return c;
}

}  // namespace vesica::detail::nearest

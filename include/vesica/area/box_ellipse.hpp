// SPDX-License-Identifier: Apache-2.0
/// The area that a box and an ellipse share, in the frame in which the ellipse is the unit disc about the origin and
/// the box a parallelogram.
#pragma once

#include <vesica/area/box_box.hpp>
#include <vesica/area/circular_segment.hpp>

namespace vesica::detail::area {

/// An ellipse's axis and half lengths.
template <class V>
struct Oval {
  V ux, uy, a, b;
};

template <class V>
struct Vector {
  V x, y;
};

template <class V>
V cross(const Vector<V>& p, const Vector<V>& q) noexcept {
  return p.x * q.y - p.y * q.x;
}
template <class V>
V dot(const Vector<V>& p, const Vector<V>& q) noexcept {
  return p.x * q.x + p.y * q.y;
}
template <class V>
Vector<V> operator+(const Vector<V>& p, const Vector<V>& q) noexcept {
  return {p.x + q.x, p.y + q.y};
}
template <class V>
Vector<V> operator-(const Vector<V>& p, const Vector<V>& q) noexcept {
  return {p.x - q.x, p.y - q.y};
}
inline Vector<double> operator*(double t, const Vector<double>& p) noexcept { return {t * p.x, t * p.y}; }
template <class V>
Vector<double> rounded(const Vector<V>& p) noexcept {
  return {rounded(p.x), rounded(p.y)};
}

/// A parallelogram: its centre and half edges, edge_0 x edge_1 > 0, where the ellipse is the unit disc; and by how much
/// areas are smaller there.
template <class V>
struct Parallelogram {
  Vector<V> centre, edge_0, edge_1;
  V scale;
};

/// d: from the ellipse's centre to the box's.
template <class V>
Parallelogram<V> parallelogram(const filter::Box<V>& box, const Oval<V>& e, const filter::Centre<V>& d) noexcept {
  const V vv = e.ux * e.ux + e.uy * e.uy, over_a = V(1.0) / (e.a * vv), over_b = V(1.0) / (e.b * vv);
  const V c = e.ux * box.ux + e.uy * box.uy, s = e.ux * box.uy - e.uy * box.ux;
  return {{(e.ux * d.x + e.uy * d.y) * over_a, (e.ux * d.y - e.uy * d.x) * over_b},
          {box.hx * c * over_a, box.hx * s * over_b},
          {-(box.hy * s * over_a), box.hy * c * over_b},
          e.a * e.b * vv};
}

/// The part of an edge from p to p + e that is in the disc.
struct Inside {
  double from, to;
};

/// By the line's foot and distance: of the quadratic |p + t e|^2 = 1 nothing would be left for a far corner p.
template <class V>
Inside inside_disc(const Vector<V>& p, const Vector<V>& e) noexcept {
  const V one(1.0), square = dot(e, e), length = sqrt(square), distance = cross(p, e) / length;
  const V room = (one - distance) * (one + distance);
  if (!(room > V(0.0))) return {0, 0};
  const V foot = -(dot(p, e) / square), reach = sqrt(room) / length;
  const double from = rounded(foot - reach), to = rounded(foot + reach);
  return {from > 0 ? from : 0, to < 1 ? to : 1};
}

/// The area between a chord and its arc of less than half a turn.
inline double segment_on(const Vector<double>& chord) noexcept {
  const double square = dot(chord, chord);
  return square < 4 ? segment_area(square, 4 - square) : pi_high / 2;
}

/// The area shared with a parallelogram too small to hold half of the disc: so every arc inside is less than half a
/// turn, and the area is a polygon and a segment for each arc, none of them negative. Points are taken from the
/// parallelogram's first corner, so that their differences are those of the smaller shape.
template <class V>
double area_in_small_parallelogram(const Parallelogram<V>& p) noexcept {
  const V two(2.0);
  const Vector<V> e0{two * p.edge_0.x, two * p.edge_0.y}, e1{two * p.edge_1.x, two * p.edge_1.y};
  const Vector<V> corner[4] = {p.centre - p.edge_0 - p.edge_1, p.centre + p.edge_0 - p.edge_1,
                               p.centre + p.edge_0 + p.edge_1, p.centre - p.edge_0 + p.edge_1};
  const Vector<V> edge[4] = {e0, e1, {-e0.x, -e0.y}, {-e1.x, -e1.y}};
  const Vector<double> local[4] = {{0, 0}, rounded(e0), rounded(e0 + e1), rounded(e1)};
  double doubled = 0, segments = 0;
  Vector<double> first{}, last{};
  bool any = false;
  for (int i = 0; i < 4; ++i) {
    const Inside part = inside_disc(corner[i], edge[i]);
    if (!(part.from < part.to)) continue;
    const Vector<double> along = rounded(edge[i]);
    const Vector<double> enter = part.from == 0 ? local[i] : local[i] + part.from * along;
    const Vector<double> leave = part.to == 1 ? local[(i + 1) % 4] : local[i] + part.to * along;
    if (!any) {
      any = true;
      first = enter;
    } else {
      segments += segment_on(enter - last);  // none at a corner inside, where the two are the same
      doubled += cross(last - first, enter - first);
    }
    doubled += cross(enter - first, leave - first);
    last = leave;
  }
  if (!any) return 0;
  segments += segment_on(first - last);
  return 0.5 * doubled + segments;
}

/// The lines of a parallelogram: n0.y between low_0 and high_0, n1.y between low_1 and high_1, n0 x n1 > 0.
struct Lines {
  Vector<double> n0, n1;
  double low_0, high_0, low_1, high_1;
};

/// Half the angle from (d, t0) to (d, t1) about the origin, negative where that turns right. Corners may be so far off
/// that squares overflow; the angle does not depend on the unit.
inline double half_sector(double d, double t0, double t1) noexcept {
  if (std::fabs(d) + (std::fabs(t0) + std::fabs(t1)) > 0x1p400) {
    d *= 0x1p-600;
    t0 *= 0x1p-600;
    t1 *= 0x1p-600;
  }
  const double sine = d * (t1 - t0), half = 0.5 * angle(std::fabs(sine), d * d + t0 * t1);
  return sine < 0 ? -half : half;
}

/// The area of the unit disc between the origin and an edge from t0 to t1 on the line at distance d, negative where the
/// origin is to the right: a triangle within the disc, sectors beside it.
inline double area_under_edge(double d, double t0, double t1) noexcept {
  if (!(d > -1 && d < 1)) return half_sector(d, t0, t1);
  const double reach = std::sqrt((1 - d) * (1 + d));
  const double from = clamp(t0, -reach, reach), to = clamp(t1, -reach, reach);
  double area = 0.5 * d * (to - from);
  if (t0 < -reach) area += half_sector(d, t0, t1 < -reach ? t1 : -reach);
  if (t1 > reach) area += half_sector(d, t0 > reach ? t0 : reach, t1);
  return area;
}

/// The area of the disc within four lines: what lies under the four edges, which go round the parallelogram. For one
/// that is not small beside the disc; its corners may be far away.
inline double area_within_lines(const Lines& l) noexcept {
  const double length_0 = std::sqrt(dot(l.n0, l.n0)), length_1 = std::sqrt(dot(l.n1, l.n1));
  const double det = cross(l.n0, l.n1), mixed = dot(l.n0, l.n1);
  // On a line at n0.y = i, the point with n1.y = j is at (j - i mixed / |n0|^2) |n0| / det.
  const auto along_0 = [&](double i, double j) { return (j * length_0 - i * (mixed / length_0)) / det; };
  const auto along_1 = [&](double i, double j) { return (i * (mixed / length_1) - j * length_1) / det; };
  const double right = area_under_edge(l.high_0 / length_0, along_0(l.high_0, l.low_1), along_0(l.high_0, l.high_1));
  const double left = area_under_edge(-l.low_0 / length_0, -along_0(l.low_0, l.high_1), -along_0(l.low_0, l.low_1));
  const double top = area_under_edge(l.high_1 / length_1, along_1(l.high_1, l.high_0), along_1(l.high_1, l.low_0));
  const double bottom = area_under_edge(-l.low_1 / length_1, -along_1(l.low_1, l.low_0), -along_1(l.low_1, l.high_0));
  return (right + left) + (top + bottom);
}

/// The directions across a box's edges where the ellipse is the unit disc, in lengths times |u|.
inline Lines lines(const filter::Box<double>& box, const Oval<double>& e) noexcept {
  const double c = e.ux * box.ux + e.uy * box.uy, s = e.ux * box.uy - e.uy * box.ux;
  return {{e.a * c, e.b * s}, {-(e.a * s), e.b * c}, 0, 0, 0, 0};
}

/// How large a parallelogram is small: 4 edge_0 x edge_1, half the disc being pi / 2.
inline constexpr double small_parallelogram = 1.5;

inline bool in_clip_range(const filter::Box<double>& box, const Oval<double>& e,
                          const filter::Centre<double>& d) noexcept {
  const filter::Box<double> as_box{e.ux, e.uy, e.a, e.b};
  return in_clip_range(box, as_box, std::fabs(d.x) + std::fabs(d.y), box.ux * box.ux + box.uy * box.uy,
                       e.ux * e.ux + e.uy * e.uy);
}

/// The ratio of a shape's longer to its shorter size.
inline double aspect(double size_0, double size_1) noexcept {
  return size_0 > size_1 ? size_0 / size_1 : size_1 / size_0;
}

/// The sum of the magnitudes that the image of a shape is made of where an ellipse is the unit disc, its radius among
/// them. In these units no number of the image is off by more than 16u times that sum.
inline double span_about(const Oval<double>& e, double ux, double uy, double size_0, double size_1,
                         const filter::Centre<double>& d) noexcept {
  const double x = std::fabs(e.ux), y = std::fabs(e.uy), vv = e.ux * e.ux + e.uy * e.uy;
  const double over = (1 / e.a + 1 / e.b) / vv;
  const double turned = (x + y) * (std::fabs(ux) + std::fabs(uy)), apart = (x + y) * (std::fabs(d.x) + std::fabs(d.y));
  return 1 + over * (turned * (size_0 + size_1) + apart);
}

/// The area of a box and an ellipse, d from the ellipse's centre to the box's. Settled where the error is certain to be
/// as promised, and the area too far from 0 and from either shape's own for anything but crossing: the outline within
/// the disc is at most 8 long, so the error is below 128u times span_about() (observed: 1u times that).
inline Settled<double, bool> crossing_area(const filter::Box<double>& box, const Oval<double>& e,
                                           const filter::Centre<double>& d) noexcept {
  if (!in_clip_range(box, e, d)) return {0, false};
  const Parallelogram<double> p = parallelogram(box, e, d);
  const double whole = 4 * cross(p.edge_0, p.edge_1), least = whole < pi_high ? whole : pi_high;
  const double span = span_about(e, box.ux, box.uy, box.hx, box.hy, d);
  const double a0 = aspect(box.hx, box.hy), a1 = aspect(e.a, e.b);
  if (!(span <= 16 * least * (a0 > a1 ? a0 : a1))) return {0, false};
  double area;
  if (whole <= small_parallelogram) {
    area = area_in_small_parallelogram(p);
  } else {
    const double uu = box.ux * box.ux + box.uy * box.uy;
    const double along = box.ux * d.x + box.uy * d.y, across = box.ux * d.y - box.uy * d.x;
    Lines l = lines(box, e);
    l.low_0 = along - box.hx * uu;
    l.high_0 = along + box.hx * uu;
    l.low_1 = across - box.hy * uu;
    l.high_1 = across + box.hy * uu;
    area = area_within_lines(l);
  }
  const double error = 0x1p-46 * span;
  return {area * p.scale, area > error && least - area > error};
}

}  // namespace vesica::detail::area

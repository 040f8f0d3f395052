// SPDX-License-Identifier: Apache-2.0
#include "inflated/outlines.hpp"

#include <algorithm>
#include <cmath>

namespace inflated {
namespace {

using Real = mpf_class;

constexpr int bits = 640;

struct Point {
  Real x, y;
};

Real real(double x) { return {x, bits}; }
Real hypot(const Real& x, const Real& y) { return sqrt(Real(x * x + y * y)); }
Real dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y; }
Point sum(const Point& a, const Real& k, const Point& b) { return {a.x + k * b.x, a.y + k * b.y}; }
Point difference(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }

/// Equal numbers differ by less than any of these, and unequal ones of the tests by more.
const Real zero_square(1e-100, bits), on_outline(1e-60, bits), same_place(1e-50, bits), step(1e-20, bits);

Point centre(const Outline& o) { return {o.cx, o.cy}; }
Point axis(const Outline& o) { return {o.ux, o.uy}; }
Point across(const Outline& o) { return {Real(-o.uy), o.ux}; }

/// The distance from the core, negative inside.
Real from_core(const Outline& o, const Point& p) {
  const Point d = difference(p, centre(o));
  const Real x = abs(dot(d, axis(o))) - o.hx, y = abs(dot(d, across(o))) - o.hy, none(0, bits);
  if (x <= 0 && y <= 0) return x > y ? x : y;
  return hypot(x > 0 ? x : none, y > 0 ? y : none);
}
bool is_on(const Outline& o, const Point& p) { return abs(Real(from_core(o, p) - o.radius)) < on_outline; }

std::vector<Point> corners(const Outline& o) {
  std::vector<Point> all;
  for (const int i : {-1, 1}) {
    for (const int k : {-1, 1}) all.push_back(sum(sum(centre(o), i * o.hx, axis(o)), k * o.hy, across(o)));
  }
  return all;
}
std::vector<Point> normals(const Outline& o) {
  const Point u = axis(o), v = across(o);
  return {u, v, {Real(-u.x), Real(-u.y)}, {Real(-v.x), Real(-v.y)}};
}

/// Where straight and round parts meet; corners without a radius. A circle has none.
std::vector<Point> joins(const Outline& o) {
  if (o.radius == 0) return corners(o);
  std::vector<Point> all;
  for (const Point& c : corners(o)) {
    for (const Point& n : normals(o)) {
      // A capsule's tip is none: there the normal is along the core.
      const bool is_along = abs(dot(n, axis(o))) > abs(dot(n, across(o)));
      const Point p = sum(c, o.radius, n);
      if ((is_along ? o.hy : o.hx) > 0 && is_on(o, p)) all.push_back(p);
    }
  }
  return all;
}

struct Line {
  Point normal;
  Real at;
};
std::vector<Line> lines(const Outline& o) {
  std::vector<Line> all;
  for (const Point& n : normals(o)) {
    const Real half = abs(dot(n, axis(o))) * o.hx + abs(dot(n, across(o))) * o.hy;
    all.push_back({n, dot(n, centre(o)) + half + o.radius});
  }
  return all;
}

void cross(const Line& a, const Line& b, std::vector<Point>& out) {
  const Real k = a.normal.x * b.normal.y - a.normal.y * b.normal.x;
  if (abs(k) < on_outline) return;
  out.push_back({Real((a.at * b.normal.y - b.at * a.normal.y) / k), Real((b.at * a.normal.x - a.at * b.normal.x) / k)});
}
/// The points of a line's normal through a centre, half a chord to either side.
void cross(const Line& a, const Point& c, const Real& r, std::vector<Point>& out) {
  const Real off = a.at - dot(a.normal, c);
  Real square = r * r - off * off;
  if (abs(square) < zero_square) square = 0;
  if (square < 0) return;
  const Real half = sqrt(square);
  const Point foot = sum(c, off, a.normal), along{Real(-a.normal.y), a.normal.x};
  out.push_back(sum(foot, half, along));
  out.push_back(sum(foot, Real(-half), along));
}
void cross(const Point& p, const Real& r, const Point& q, const Real& s, std::vector<Point>& out) {
  const Point v = difference(q, p);
  const Real length = hypot(v.x, v.y);
  if (length < on_outline) return;
  const Point n{Real(v.x / length), Real(v.y / length)};
  cross({n, dot(n, p) + (length + (r * r - s * s) / length) / 2}, p, r, out);
}

/// Places next to p on an outline.
std::vector<Point> neighbours(const Outline& o, const Point& p) {
  std::vector<Point> all;
  if (o.radius == 0) {
    for (const Point& n : normals(o)) {
      const Point q = sum(p, step, n);
      if (is_on(o, q)) all.push_back(q);
    }
    return all;
  }
  const auto nearest = [&](const Point& q) {
    const Point d = difference(q, centre(o));
    const auto clamped = [](const Real& x, const Real& h) { return x > h ? h : x < -h ? Real(-h) : x; };
    return sum(sum(centre(o), clamped(dot(d, axis(o)), o.hx), axis(o)), clamped(dot(d, across(o)), o.hy), across(o));
  };
  const Point out = difference(p, nearest(p));
  for (const int way : {-1, 1}) {
    const Point beside{Real(p.x - way * step * out.y), Real(p.y + way * step * out.x)}, c = nearest(beside);
    const Point d = difference(beside, c);
    all.push_back(sum(c, o.radius / hypot(d.x, d.y), d));
  }
  return all;
}

bool is_one_of(const std::vector<Point>& all, const Point& p) {
  return std::any_of(all.begin(), all.end(),
                     [&](const Point& q) { return hypot(Real(p.x - q.x), Real(p.y - q.y)) < same_place; });
}

/// The place where an outline begins.
Point start(const Outline& o) {
  const Point corner = sum(sum(centre(o), Real(-o.hx), axis(o)), Real(-o.hy), across(o));
  const bool is_along = o.hx > 0;
  if (o.hx == 0 && o.hy == 0) return sum(corner, o.radius, axis(o));
  return is_along ? sum(corner, Real(-o.radius), across(o)) : sum(corner, o.radius, axis(o));
}

/// An angle about the centre, from the start; of a thin shape the way from its first end.
double position(const Outline& o, const Point& p) {
  const Point d = difference(p, centre(o)), s = difference(start(o), centre(o));
  if (o.radius == 0 && (o.hx == 0 || o.hy == 0)) return -Real(dot(d, s)).get_d();
  const Real turned = s.x * d.y - s.y * d.x, along = dot(s, d);
  const double angle = std::atan2(abs(turned) < on_outline ? 0 : turned.get_d(), along.get_d());
  return angle < 0 ? angle + 6.283185307179586 : angle;
}

}  // namespace

Outline::Outline(const Shape& s)
    : cx(0, bits), cy(0, bits), ux(1, bits), uy(0, bits), hx(0, bits), hy(0, bits), radius(real(inflated::radius(s))) {
  const Shape k = core(s);
  const auto& n = k.number;
  cx = real(n[0]);
  cy = real(n[1]);
  if (k.kind == VESICA_SEGMENT || k.kind == VESICA_AABB) {
    cx = (real(n[0]) + real(n[2])) / 2;
    cy = (real(n[1]) + real(n[3])) / 2;
    hx = (real(n[2]) - real(n[0])) / 2;
    hy = (real(n[3]) - real(n[1])) / 2;
  }
  if (k.kind == VESICA_SEGMENT) {
    const Real half = hypot(hx, hy);
    if (half > 0) ux = hx / half, uy = hy / half;
    hx = half;
    hy = 0;
  }
  if (k.kind == VESICA_RECT) {
    const Real length = hypot(real(n[2]), real(n[3]));
    ux = real(n[2]) / length;
    uy = real(n[3]) / length;
    hx = real(n[4]) * length;
    hy = real(n[5]) * length;
  }
  if (hx == 0 && hy == 0) ux = 1, uy = 0;
}

OutlinePlaces outline_places(const Outline& a, const Outline& b) {
  const std::vector<Point> of_a = joins(a), of_b = joins(b);
  std::vector<Point> all = of_a;
  all.insert(all.end(), of_b.begin(), of_b.end());
  for (const Line& p : lines(a)) {
    for (const Line& q : lines(b)) cross(p, q, all);
    for (const Point& q : corners(b)) cross(p, q, b.radius, all);
  }
  for (const Point& p : corners(a)) {
    for (const Line& q : lines(b)) cross(q, p, a.radius, all);
    for (const Point& q : corners(b)) cross(p, a.radius, q, b.radius, all);
  }
  OutlinePlaces out{{}, false};
  std::vector<Point> found;
  for (const Point& p : all) {
    if (!is_on(a, p) || !is_on(b, p) || is_one_of(found, p)) continue;
    const std::vector<Point> next = neighbours(a, p);
    const auto common = std::count_if(next.begin(), next.end(), [&](const Point& q) { return is_on(b, q); });
    out.shared = out.shared || common > 0;
    if (common >= 2 && !is_one_of(of_a, p) && !is_one_of(of_b, p)) continue;
    found.push_back(p);
    out.places.push_back({p.x, p.y, position(a, p)});
  }
  std::sort(out.places.begin(), out.places.end(), [](const auto& p, const auto& q) { return p.along < q.along; });
  return out;
}

int side_of_outline(const Outline& o, const Real& x, const Real& y) {
  const Real off = o.radius - from_core(o, {x, y});
  return abs(off) < on_outline ? 0 : off > 0 ? 1 : -1;
}

PartOfSegment part_of_segment(const Shape& segment, const Outline& o) {
  const Outline line(segment);
  const OutlinePlaces met = outline_places(line, o);
  PartOfSegment part{met.places, false, met.shared};
  std::vector<Point> known;
  for (const auto& p : met.places) known.push_back({p.x, p.y});
  for (const std::size_t k : {0U, 2U}) {
    const Point end{real(segment.number[k]), real(segment.number[k + 1])};
    if (side_of_outline(o, end.x, end.y) >= 0 && !is_one_of(known, end))
      part.places.push_back({end.x, end.y, position(line, end)});
  }
  std::sort(part.places.begin(), part.places.end(), [](const auto& p, const auto& q) { return p.along < q.along; });
  for (std::size_t i = 0; i + 1 < part.places.size(); ++i) {
    const auto &p = part.places[i], &q = part.places[i + 1];
    part.meets_inside = part.meets_inside || side_of_outline(o, Real((p.x + q.x) / 2), Real((p.y + q.y) / 2)) > 0;
  }
  return part;
}

}  // namespace inflated

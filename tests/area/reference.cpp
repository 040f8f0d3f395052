// SPDX-License-Identifier: Apache-2.0
#include "area/reference.hpp"

#include <vesica.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "area/real.hpp"

namespace reference {
namespace {

const Real pi = 4 * atan(Real(1));

struct Vector {
  Real x, y;
};
Vector operator+(const Vector& p, const Vector& q) { return {p.x + q.x, p.y + q.y}; }
Vector operator-(const Vector& p, const Vector& q) { return {p.x - q.x, p.y - q.y}; }
Vector operator*(const Real& t, const Vector& p) { return {t * p.x, t * p.y}; }
Real dot(const Vector& p, const Vector& q) { return p.x * q.x + p.y * q.y; }
Real cross(const Vector& p, const Vector& q) { return p.x * q.y - p.y * q.x; }

/// centre + s e0 + t e1 with e1 a multiple of perp e0; |s|, |t| <= 1, or s^2 + t^2 <= 1. A radius is added to these;
/// the shape then has its axis beside e0 and e1, which may be 0.
struct Shape {
  bool round;
  Vector centre, e0, e1;
  Real radius = 0;
  Vector axis{};
};

Vector oblique(const Real& size, const double* axis, bool across) {
  return across ? Vector{-size * Real(axis[1]), size * Real(axis[0])}
                : Vector{size * Real(axis[0]), size * Real(axis[1])};
}

Vector unit(const Vector& v) {
  const Real length = sqrt(dot(v, v));
  return length == 0 ? Vector{1, 0} : 1 / length * v;
}
Vector perpendicular(const Vector& v) { return {-v.y, v.x}; }

Shape shape(int kind, const double* n) {
  if (kind == VESICA_CAPSULE) {
    const Vector p{n[0], n[1]}, q{n[2], n[3]}, half = Real(0.5) * (q - p);
    return {false, Real(0.5) * (p + q), half, {0, 0}, n[4], unit(half)};
  }
  if (kind == VESICA_ROUND_RECT) {
    return {false, {n[0], n[1]}, oblique(n[4], n + 2, false), oblique(n[5], n + 2, true), n[6], unit({n[2], n[3]})};
  }
  if (kind == VESICA_CIRCLE) return {true, {n[0], n[1]}, {n[2], 0}, {0, n[2]}};
  if (kind == VESICA_AABB) {
    const Real x0 = n[0], y0 = n[1], x1 = n[2], y1 = n[3];
    return {false, {(x0 + x1) / 2, (y0 + y1) / 2}, {(x1 - x0) / 2, 0}, {0, (y1 - y0) / 2}};
  }
  return {kind == VESICA_ELLIPSE, {n[0], n[1]}, oblique(n[4], n + 2, false), oblique(n[5], n + 2, true)};
}

Real whole_area(const Shape& s) {
  const Real core = (s.round ? pi : Real(4)) * cross(s.e0, s.e1), sides = sqrt(dot(s.e0, s.e0)) + sqrt(dot(s.e1, s.e1));
  return core + s.radius * (4 * sides + pi * s.radius);
}

Real aspect(const Shape& s) {
  const Real l0 = sqrt(dot(s.e0, s.e0)) + s.radius, l1 = sqrt(dot(s.e1, s.e1)) + s.radius;
  return l0 > l1 ? l0 / l1 : l1 / l0;
}

/// A point in the shape's own coordinates (s, t).
Vector coordinates(const Shape& s, const Vector& p) {
  const Vector d = p - s.centre;
  return {dot(d, s.e0) / dot(s.e0, s.e0), dot(d, s.e1) / dot(s.e1, s.e1)};
}

/// The point of a part of an outline that decides if it is inside: not halfway, where symmetric shapes touch.
Real between(const Real& from, const Real& to) { return from + (to - from) * Real("0.4321"); }

bool holds(const Shape& s, const Vector& p) {
  if (s.radius > 0) {
    const Vector d = p - s.centre;
    const Real x = abs(dot(s.axis, d)) - sqrt(dot(s.e0, s.e0)), y = abs(cross(s.axis, d)) - sqrt(dot(s.e1, s.e1));
    const Vector out{std::max(x, Real(0.0)), std::max(y, Real(0.0))};
    return dot(out, out) < s.radius * s.radius;
  }
  const Vector c = coordinates(s, p);
  return s.round ? dot(c, c) < 1 : abs(c.x) < 1 && abs(c.y) < 1;
}

// ---- The parameters at which an outline meets another shape's.

/// s + t e within the shape: where it meets the outline's curve or lines.
void meet_line(const Shape& s, const Vector& from, const Vector& to, std::vector<Real>& at) {
  const Vector p = coordinates(s, from), q = coordinates(s, to) - p;
  if (s.round) {
    const Real a = dot(q, q), b = dot(p, q), c = dot(p, p) - 1, d = b * b - a * c;
    if (d <= 0) return;
    at.push_back((-b - sqrt(d)) / a);
    at.push_back((-b + sqrt(d)) / a);
    return;
  }
  for (const int side : {-1, 1}) {
    if (q.x != 0) at.push_back((side - p.x) / q.x);
    if (q.y != 0) at.push_back((side - p.y) / q.y);
  }
}

struct Complex {
  Real re, im;
};
Complex operator+(const Complex& p, const Complex& q) { return {p.re + q.re, p.im + q.im}; }
Complex operator-(const Complex& p, const Complex& q) { return {p.re - q.re, p.im - q.im}; }
Complex operator*(const Complex& p, const Complex& q) { return {p.re * q.re - p.im * q.im, p.re * q.im + p.im * q.re}; }
Real norm(const Complex& p) { return p.re * p.re + p.im * p.im; }
Complex operator/(const Complex& p, const Complex& q) {
  const Real n = norm(q);
  return {(p.re * q.re + p.im * q.im) / n, (p.im * q.re - p.re * q.im) / n};
}

/// All roots at once (Weierstrass, Durand, Kerner).
std::vector<Complex> roots(std::vector<Complex> polynomial) {
  Real largest = 0;
  for (const Complex& c : polynomial) largest = std::max(largest, norm(c));
  while (!polynomial.empty() && norm(polynomial.back()) <= largest * Real("1e-200")) polynomial.pop_back();
  std::vector<Complex> z;
  if (polynomial.size() < 2) return z;
  Complex start{1, 0};
  for (std::size_t i = 1; i < polynomial.size(); ++i) z.push_back(start = start * Complex{Real("0.4"), Real("0.9")});
  for (int step = 0; step < 600; ++step) {
    Real moved = 0;
    for (std::size_t i = 0; i < z.size(); ++i) {
      Complex value = polynomial.back(), others = polynomial.back();
      for (std::size_t k = polynomial.size() - 1; k-- > 0;) value = value * z[i] + polynomial[k];
      for (std::size_t j = 0; j < z.size(); ++j) {
        if (j != i) others = others * (z[i] - z[j]);
      }
      if (norm(others) == 0) continue;
      const Complex by = value / others;
      z[i] = z[i] - by;
      moved = std::max(moved, Real(norm(by)));
    }
    if (moved < Real("1e-205")) break;
  }
  return z;
}

/// The angles at which the ellipse's outline meets another ellipse's. With z = exp(i angle) the equation is a quartic.
void meet_ellipse(const Shape& ellipse, const Shape& other, std::vector<Real>& angles) {
  const Vector k = coordinates(other, ellipse.centre), p = coordinates(other, ellipse.centre + ellipse.e0) - k,
               q = coordinates(other, ellipse.centre + ellipse.e1) - k;
  // |k + p cos + q sin|^2 - 1
  const Real c0 = dot(k, k) - 1 + (dot(p, p) + dot(q, q)) / 2, cos1 = 2 * dot(k, p), sin1 = 2 * dot(k, q);
  const Real cos2 = (dot(p, p) - dot(q, q)) / 2, sin2 = dot(p, q);
  const std::vector<Complex> quartic{
      {cos2 / 2, sin2 / 2}, {cos1 / 2, sin1 / 2}, {c0, 0}, {cos1 / 2, -sin1 / 2}, {cos2 / 2, -sin2 / 2}};
  for (const Complex& z : roots(quartic)) {
    if (abs(norm(z) - 1) < Real("1e-30")) angles.push_back(atan2(z.im, z.re));
  }
}

void meet_box(const Shape& ellipse, const Shape& box, std::vector<Real>& angles) {
  const Vector k = coordinates(box, ellipse.centre), p = coordinates(box, ellipse.centre + ellipse.e0) - k,
               q = coordinates(box, ellipse.centre + ellipse.e1) - k;
  const auto solve = [&](const Real& a, const Real& b, const Real& c) {  // a cos + b sin = c
    const Real length = sqrt(a * a + b * b);
    if (length == 0 || abs(c) >= length) return;
    const Real middle = atan2(b, a), half = acos(c / length);
    angles.push_back(middle - half);
    angles.push_back(middle + half);
  };
  for (const int side : {-1, 1}) {
    solve(p.x, q.x, side - k.x);
    solve(p.y, q.y, side - k.y);
  }
}

// ---- Half the integral of X x dX along an outline, as far as it is in the other shape.

Real along_arcs(const Shape& s, const Shape& other) {
  std::vector<Real> angles;
  if (other.round) {
    meet_ellipse(s, other, angles);
  } else {
    meet_box(s, other, angles);
  }
  for (Real& angle : angles) {
    while (angle < 0) angle += 2 * pi;
    while (angle >= 2 * pi) angle -= 2 * pi;
  }
  angles.push_back(0);
  angles.push_back(2 * pi);
  std::sort(angles.begin(), angles.end());
  Real sum = 0;
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const Real from = angles[i - 1], to = angles[i], middle = between(from, to);
    if (!holds(other, s.centre + cos(middle) * s.e0 + sin(middle) * s.e1)) continue;
    const Vector step = (cos(to) - cos(from)) * s.e0 + (sin(to) - sin(from)) * s.e1;
    sum += (cross(s.e0, s.e1) * (to - from) + cross(s.centre, step)) / 2;
  }
  return sum;
}

Real along_edges(const Shape& s, const Shape& other) {
  const Vector corner[4] = {s.centre - s.e0 - s.e1, s.centre + s.e0 - s.e1, s.centre + s.e0 + s.e1,
                            s.centre - s.e0 + s.e1};
  Real sum = 0;
  for (int i = 0; i < 4; ++i) {
    const Vector& p = corner[i];
    const Vector& q = corner[(i + 1) % 4];
    std::vector<Real> at{0, 1};
    meet_line(other, p, q, at);
    std::sort(at.begin(), at.end());
    for (std::size_t k = 1; k < at.size(); ++k) {
      const Real from = at[k - 1], to = at[k], middle = between(from, to);
      if (from < 0 || to > 1 || !holds(other, p + middle * (q - p))) continue;
      sum += cross(p, (to - from) * (q - p)) / 2;
    }
  }
  return sum;
}

/// Two boxes may have edges in common, which both or neither would count: the one box is cut by the other's lines.
Real clipped(const Shape& s, const Shape& other) {
  std::vector<Vector> polygon{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (Vector& p : polygon) p = coordinates(other, s.centre + p.x * s.e0 + p.y * s.e1);
  for (int line = 0; line < 4; ++line) {
    const auto room = [line](const Vector& p) -> Real {
      return line == 0 ? 1 - p.x : line == 1 ? 1 + p.x : line == 2 ? 1 - p.y : 1 + p.y;
    };
    std::vector<Vector> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vector &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const Real at_p = room(p), at_q = room(q);
      if (at_p >= 0) kept.push_back(p);
      if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) kept.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
    polygon = std::move(kept);
  }
  Real sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) sum += cross(polygon[i], polygon[(i + 1) % polygon.size()]) / 2;
  return sum * cross(other.e0, other.e1);
}

// ---- Outlines of edges and arcs, where one of the two shapes has a core and a radius.

/// An edge from p to q, or the arc of an ellipse between two angles.
struct Piece {
  bool is_arc;
  Vector p, q;
  Shape ellipse;
  Real from, to;
};

std::vector<Piece> outline(const Shape& s) {
  std::vector<Piece> pieces;
  if (s.round) {
    pieces.push_back({true, {}, {}, s, 0, 2 * pi});
    return pieces;
  }
  const Vector u = s.radius > 0 ? s.axis : Vector{}, v = perpendicular(u), none{0, 0};
  const Vector corner[4] = {s.centre + s.e0 + s.e1, s.centre - s.e0 + s.e1, s.centre - s.e0 - s.e1,
                            s.centre + s.e0 - s.e1};
  const Vector normal[4] = {s.radius * u, s.radius * v, none - s.radius * u, none - s.radius * v};
  for (int i = 0; i < 4; ++i) {
    const Vector& outward = normal[(i + 1) % 4];
    if (s.radius > 0) {
      pieces.push_back({true, {}, {}, {true, corner[i], s.radius * u, s.radius * v}, pi / 2 * i, pi / 2 * (i + 1)});
    }
    pieces.push_back({false, corner[i] + outward, corner[(i + 1) % 4] + outward, {}, 0, 1});
  }
  return pieces;
}

/// Parameters of a piece at which another may meet it.
void meet(const Piece& piece, const Piece& other, std::vector<Real>& at) {
  const auto solve = [&](const Real& a, const Real& b, const Real& c) {  // a cos + b sin = c
    const Real length = sqrt(a * a + b * b);
    if (length == 0 || abs(c) >= length) return;
    const Real middle = atan2(b, a), half = acos(c / length);
    at.push_back(middle - half);
    at.push_back(middle + half);
  };
  const Shape &e = piece.ellipse, &f = other.ellipse;
  if (!piece.is_arc && other.is_arc) {
    meet_line(f, piece.p, piece.q, at);
  } else if (!piece.is_arc) {
    const Vector d = piece.q - piece.p, line = other.q - other.p;
    if (cross(d, line) != 0) at.push_back(cross(other.p - piece.p, line) / cross(d, line));
  } else if (!other.is_arc) {
    const Vector line = perpendicular(other.q - other.p);
    solve(dot(line, e.e0), dot(line, e.e1), dot(line, other.p - e.centre));
  } else if (dot(e.e0, e.e0) == dot(e.e1, e.e1) && dot(f.e0, f.e0) == dot(f.e1, f.e1)) {
    const Vector d = f.centre - e.centre;
    solve(dot(d, e.e0), dot(d, e.e1), (dot(d, d) + dot(e.e0, e.e0) - dot(f.e0, f.e0)) / 2);
  } else {
    meet_ellipse(e, f, at);
  }
}

Real along_pieces(const Shape& s, const Shape& other) {
  Real sum = 0;
  for (const Piece& piece : outline(s)) {
    std::vector<Real> at;
    for (const Piece& one : outline(other)) meet(piece, one, at);
    std::vector<Real> cuts{piece.from, piece.to};
    for (Real t : at) {
      while (piece.is_arc && t < piece.from) t += 2 * pi;
      while (piece.is_arc && t > piece.from + 2 * pi) t -= 2 * pi;
      if (t > piece.from && t < piece.to) cuts.push_back(t);
    }
    std::sort(cuts.begin(), cuts.end());
    const auto point = [&](const Real& t) {
      if (!piece.is_arc) return piece.p + t * (piece.q - piece.p);
      return piece.ellipse.centre + cos(t) * piece.ellipse.e0 + sin(t) * piece.ellipse.e1;
    };
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      if (!holds(other, point(between(cuts[i - 1], cuts[i])))) continue;
      const Vector from = point(cuts[i - 1]), to = point(cuts[i]);
      if (!piece.is_arc) {
        sum += cross(from, to) / 2;
      } else {
        const Real sector = cross(piece.ellipse.e0, piece.ellipse.e1) * (cuts[i] - cuts[i - 1]);
        sum += (sector + cross(piece.ellipse.centre, to - from)) / 2;
      }
    }
  }
  return sum;
}

/// Pieces that coincide would count for both shapes or for neither. So the one is moved and grown by 10^-45 of it.
Real shared_of_pieces(const Shape& a, Shape b) {
  const Real little("1e-45");
  const Real size = sqrt(dot(b.e0, b.e0)) + sqrt(dot(b.e1, b.e1)) + b.radius;
  b.centre = b.centre + little * size * Vector{Real("0.31"), Real("0.77")};
  b.e0 = (1 + little) * b.e0;
  b.e1 = (1 + (b.round ? little : Real(0.5) * little)) * b.e1;
  b.radius = (1 + Real("0.7") * little) * b.radius;
  return along_pieces(a, b) + along_pieces(b, a);
}

/// Returns g < 1: if s is the unit disc, t's outline is between the circles of radius 1 - g and 1 + g.
Real difference_of(const Shape& s, const Shape& t) {
  const Vector k = coordinates(s, t.centre), p = coordinates(s, t.centre + t.e0) - k,
               q = coordinates(s, t.centre + t.e1) - k;
  const Real off = abs(p.x * p.x + q.x * q.x - 1) + abs(p.x * p.y + q.x * q.y) + abs(p.y * p.y + q.y * q.y - 1);
  return abs(k.x) + abs(k.y) + off;
}

/// About a's centre: far from the origin the digits would not do.
Real shared(Shape a, Shape b) {
  b.centre = b.centre - a.centre;
  a.centre = {0, 0};
  if (a.radius > 0 || b.radius > 0) return shared_of_pieces(a, b);
  if (!a.round && !b.round) return whole_area(a) < whole_area(b) ? clipped(b, a) : clipped(a, b);
  // If ellipses are nearly equal, rounding loses the places where they cross, and each arc might count for
  // both or for neither. They share all but 2 g of the lesser, whatever the aspect.
  if (a.round && b.round && difference_of(a, b) < Real("1e-40")) return std::min(whole_area(a), whole_area(b));
  return (a.round ? along_arcs(a, b) : along_edges(a, b)) + (b.round ? along_arcs(b, a) : along_edges(b, a));
}

}  // namespace

Deviation deviation(int kind_a, const double* a, int kind_b, const double* b, double value) {
  const Shape s = shape(kind_a, a), t = shape(kind_b, b);
  const Real truth = shared(s, t), least = std::min(whole_area(s), whole_area(t)),
             most = std::max(aspect(s), aspect(t));
  const Real error = abs(Real(value) - truth) / (least * most) * Real(0x1p53);
  return {static_cast<double>(most), static_cast<double>(error), static_cast<double>(truth / least)};
}

double area(int kind_a, const double* a, int kind_b, const double* b) {
  return static_cast<double>(shared(shape(kind_a, a), shape(kind_b, b)));
}

double difference(int kind_a, const double* a, int kind_b, const double* b) {
  const Shape s = shape(kind_a, a), t = shape(kind_b, b);
  return s.round && t.round ? static_cast<double>(difference_of(s, t)) : 2;
}

double distance_to_outline(int kind, const double* numbers, double x, double y) {
  const Shape s = shape(kind, numbers);
  const Vector c = coordinates(s, {x, y});
  const Real l0 = sqrt(dot(s.e0, s.e0)), l1 = sqrt(dot(s.e1, s.e1));
  if (s.round) {
    const Vector gradient{2 * c.x / l0, 2 * c.y / l1};
    return static_cast<double>(abs(dot(c, c) - 1) / sqrt(dot(gradient, gradient)));
  }
  // Distances from the lines of the nearer edges, and beyond their ends.
  const Real out_x = (abs(c.x) - 1) * l0, out_y = (abs(c.y) - 1) * l1;
  if (out_x <= 0 && out_y <= 0) return static_cast<double>(std::min(Real(-out_x), Real(-out_y)));
  const Real dx = std::max(Real(0.0), out_x), dy = std::max(Real(0.0), out_y);
  return static_cast<double>(sqrt(dx * dx + dy * dy));
}

double distance_to_meeting(int kind_a, const double* a, int kind_b, const double* b, double x, double y) {
  const Shape s = shape(kind_a, a), t = shape(kind_b, b);
  const Shape &ellipse = s.round ? s : t, &other = s.round ? t : s;
  std::vector<Vector> places;
  if (other.round) {
    std::vector<Real> angles;
    meet_ellipse(ellipse, other, angles);
    for (const Real& angle : angles)
      places.push_back(ellipse.centre + cos(angle) * ellipse.e0 + sin(angle) * ellipse.e1);
  } else {
    const Vector corner[4] = {other.centre - other.e0 - other.e1, other.centre + other.e0 - other.e1,
                              other.centre + other.e0 + other.e1, other.centre - other.e0 + other.e1};
    for (int i = 0; i < 4; ++i) {
      const Vector& p = corner[i];
      const Vector& q = corner[(i + 1) % 4];
      // Tangent edges change no sign: their foot counts too.
      const Vector from = coordinates(ellipse, p), step = coordinates(ellipse, q) - from;
      std::vector<Real> at{-dot(from, step) / dot(step, step)};
      const Vector foot = from + at[0] * step;
      if (abs(dot(foot, foot) - 1) > Real("1e-60")) at.clear();
      meet_line(ellipse, p, q, at);
      for (const Real& u : at) {
        if (u > Real("-1e-60") && u < 1 + Real("1e-60")) places.push_back(p + u * (q - p));
      }
    }
  }
  Real nearest = Real("1e300");
  for (const Vector& place : places) {
    const Vector d = place - Vector{x, y};
    nearest = std::min(nearest, Real(sqrt(dot(d, d))));
  }
  return static_cast<double>(nearest);
}

double shape_area_error_in_places(int kind, const double* numbers, double value) {
  int exponent;
  std::frexp(value, &exponent);
  const Real place = ldexp(Real(1), std::max(exponent - 53, -1074));
  return static_cast<double>(abs(whole_area(shape(kind, numbers)) - Real(value)) / place);
}

}  // namespace reference

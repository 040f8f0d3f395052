// SPDX-License-Identifier: Apache-2.0
#include "inflated/ellipse_outline.hpp"

#include <algorithm>
#include <cmath>

#include "inflated/outlines.hpp"

namespace ellipse_outline {
namespace {

using inflated::EllipsePlace, inflated::Outline, inflated::Shape;
using Real = mpf_class;

constexpr int bits = 640;

struct Point {
  Real x, y;
};
Real real(double x) { return {x, bits}; }
Point sum(const Point& a, const Real& k, const Point& b) { return {Real(a.x + k * b.x), Real(a.y + k * b.y)}; }

/// Values of a polynomial whose coefficients are 1 at most: those of zeros are below, others of the tests above.
const Real negligible(1e-100, bits), same_place(1e-40, bits);

using Polynomial = std::vector<Real>;

Real value(const Polynomial& f, const Real& t) {
  Real sum(0, bits);
  for (std::size_t i = f.size(); i-- > 0;) sum = sum * t + f[i];
  return sum;
}
Polynomial derivative(const Polynomial& f) {
  Polynomial d;
  for (std::size_t i = 1; i < f.size(); ++i) d.push_back(Real(f[i] * static_cast<double>(i)));
  return d;
}
void normalise(Polynomial& f) {
  Real most(0, bits);
  for (const Real& c : f) most = std::max(most, Real(abs(c)));
  for (Real& c : f) c = most == 0 ? c : Real(c / most);
  while (!f.empty() && abs(f.back()) < negligible) f.pop_back();
}

/// The zero of a monotonic stretch whose ends have values of unlike signs.
Real zero_between(const Polynomial& f, Real low, Real high) {
  const bool falls = value(f, low) > 0;
  const Polynomial slope = derivative(f);
  for (int i = 1; i < bits; ++i) {
    const Real middle = (low + high) / 2;
    ((value(f, middle) > 0) == falls ? low : high) = middle;
    if (i % 50 != 0) continue;
    Real t = middle;
    for (int k = 0; k < 6 && value(slope, t) != 0; ++k) t -= value(f, t) / value(slope, t);
    if (t >= low && t <= high && abs(value(f, t)) < negligible * negligible) return t;
  }
  return low;
}

/// The zeros from 0 to 1, ascending, each once.
std::vector<Real> zeros(Polynomial f) {
  normalise(f);
  if (f.size() < 2) return {};
  std::vector<Real> stops = zeros(derivative(f)), found;
  stops.insert(stops.begin(), Real(0, bits));
  stops.emplace_back(1, bits);
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const Real here = value(f, stops[i]);
    if (abs(here) < negligible) {
      if (found.empty() || abs(Real(found.back() - stops[i])) > same_place) found.push_back(stops[i]);
      continue;
    }
    if (i + 1 == stops.size()) break;
    const Real next = value(f, stops[i + 1]);
    if (abs(next) > negligible && (next > 0) != (here > 0)) found.push_back(zero_between(f, stops[i], stops[i + 1]));
  }
  return found;
}

struct InDisc {
  Point centre, axis;
  Real a, b;

  explicit InDisc(const Shape& s) : InDisc(s, real(s.number[2]), real(s.number[3])) {}
  Point of(const Point& p) const {
    const Real x = p.x - centre.x, y = p.y - centre.y;
    return {Real((axis.x * x + axis.y * y) / a), Real((axis.x * y - axis.y * x) / b)};
  }
  Real form(const Point& p) const {
    const Point q = of(p);
    return q.x * q.x + q.y * q.y - 1;
  }

 private:
  InDisc(const Shape& s, const Real& ux, const Real& uy) : InDisc(s, ux, uy, sqrt(Real(ux * ux + uy * uy))) {}
  InDisc(const Shape& s, const Real& ux, const Real& uy, const Real& length)
      : centre{real(s.number[0]), real(s.number[1])},
        axis{Real(ux / length), Real(uy / length)},
        a(real(s.number[4]) * length),
        b(real(s.number[5]) * length) {}
};

/// c + (weight of 0: 1 - t^2, of 1: 2 t) / (1 + t^2) from a direction to the next; or c + t d.
struct Piece {
  Point c, from, to;
  bool is_arc;

  Point at(const Real& t) const {
    if (!is_arc) return sum(c, t, to);
    const Real all = 1 + t * t;
    return sum(sum(c, (1 - t * t) / all, from), 2 * t / all, to);
  }
  Real weight(const Real& t) const {
    const Real all = 1 + t * t;
    return is_arc ? Real(all * all) : Real(1, bits);
  }
};

/// The polynomial of this degree that has the values of f at 0, 1, 2 ...
template <class Function>
Polynomial interpolated(int degree, const Function& f) {
  Polynomial all(static_cast<std::size_t>(degree) + 1, Real(0, bits));
  for (int i = 0; i <= degree; ++i) {
    Polynomial term{f(Real(i, bits))};
    for (int k = 0; k <= degree; ++k) {
      if (k == i) continue;
      term.insert(term.begin(), Real(0, bits));
      for (std::size_t j = 0; j + 1 < term.size(); ++j) term[j] -= k * term[j + 1];
      for (Real& c : term) c /= i - k;
    }
    for (std::size_t j = 0; j < term.size(); ++j) all[j] += term[j];
  }
  return all;
}

/// Edges and quarters of arcs, in order from the first corner's edge on.
std::vector<Piece> pieces(const Outline& o) {
  std::vector<Piece> all;
  const Point u{o.ux, o.uy}, v{Real(-u.y), u.x};
  const int first = o.hx > 0 ? 0 : 1;
  Point d = first == 0 ? u : v, corner = sum(sum({o.cx, o.cy}, Real(-o.hx), u), Real(-o.hy), v);
  for (int i = first; i < first + 4; ++i) {
    const Point n{Real(o.radius * d.y), Real(-o.radius * d.x)}, ahead{Real(o.radius * d.x), Real(o.radius * d.y)};
    const Real half = i % 2 == 0 ? o.hx : o.hy;
    if (half > 0)
      all.push_back({sum(corner, Real(1, bits), n), {}, {Real(2 * half * d.x), Real(2 * half * d.y)}, false});
    corner = sum(corner, Real(2 * half), d);
    all.push_back({corner, n, ahead, true});
    d = {Real(-d.y), d.x};
  }
  return all;
}

Polynomial form_along(const Piece& piece, const InDisc& disc) {
  return interpolated(piece.is_arc ? 4 : 2,
                      [&](const Real& t) { return Real(disc.form(piece.at(t)) * piece.weight(t)); });
}

std::vector<EllipsePlace> places(const Shape& round, const Shape& ellipse) {
  const InDisc disc(ellipse);
  std::vector<EllipsePlace> all;
  const auto is_same = [](const EllipsePlace& p, const Point& q) {
    return abs(Real(p.x - q.x)) < same_place && abs(Real(p.y - q.y)) < same_place;
  };
  for (const Piece& piece : pieces(Outline(round))) {
    for (const Real& t : zeros(form_along(piece, disc))) {
      const Point p = piece.at(t), q = disc.of(p);
      if (!all.empty() && (is_same(all.back(), p) || is_same(all.front(), p))) continue;
      const double turn = std::atan2(q.y.get_d(), q.x.get_d());
      all.push_back({p.x, p.y, turn < -1e-30 ? turn + 2 * 3.14159265358979323846 : turn});
    }
  }
  return all;
}

std::vector<std::array<int, 3>> on_arcs(const Shape& round, const Shape& ellipse) {
  const InDisc disc(ellipse);
  std::vector<std::array<int, 3>> all;
  bool goes_on = false;
  for (const Piece& piece : pieces(Outline(round))) {
    if (!piece.is_arc) {
      goes_on = false;
      continue;
    }
    if (!goes_on) all.push_back({0, 0, 0});
    auto& [begin, inside, end] = all.back();
    // The end of the first quarter of a half circle is the begin of the second.
    inside += end;
    end = 0;
    for (const Real& t : zeros(form_along(piece, disc))) {
      const bool is_begin = abs(t) < same_place;
      if (is_begin && goes_on) continue;
      (is_begin ? begin : abs(Real(t - 1)) < same_place ? end : inside) += 1;
    }
    goes_on = true;
  }
  std::rotate(all.begin(), all.end() - 1, all.end());
  return all;
}

}  // namespace
}  // namespace ellipse_outline

std::vector<inflated::EllipsePlace> inflated::places_with_ellipse(const Shape& round, const Shape& ellipse) {
  return ellipse_outline::places(round, ellipse);
}
std::vector<std::array<int, 3>> inflated::places_on_arcs(const Shape& round, const Shape& ellipse) {
  return ellipse_outline::on_arcs(round, ellipse);
}

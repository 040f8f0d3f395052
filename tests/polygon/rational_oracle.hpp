// SPDX-License-Identifier: Apache-2.0
/// Questions of paths with any finite vertices, answered in rational numbers (GMP). Nothing of the library is used.
///
/// Coordinates become integers in units of the last place of all of them. Areas of convex polygons are the integral
/// along the part of each edge that is in the other polygon; those of others are sums of trapezoids between the places
/// where edges end or cross. Each checks the other.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "polygon/shapes.hpp"

namespace rational {

using Integer = mpz_class;
using Rational = mpq_class;

struct Point {
  Integer x, y;
};
struct Edge {
  Point a, b;
};
using Edges = std::vector<Edge>;

inline Rational ratio(const Integer& over, const Integer& under) {
  Rational q(over, under);
  q.canonicalize();
  return q;
}
inline Rational shifted(Rational q, int bits) {
  if (bits >= 0) {
    mpq_mul_2exp(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(bits));
  } else {
    mpq_div_2exp(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(-bits));
  }
  return q;
}

/// Coordinates are multiples of 2^exponent.
inline int unit_of(std::initializer_list<double> numbers, int exponent = 1024) {
  for (const double v : numbers) {
    int e = 0;
    double m = std::frexp(v, &e);
    if (v == 0) continue;
    for (e -= 53, m = std::ldexp(m, 53); std::fmod(m, 2) == 0; m /= 2) ++e;
    exponent = std::min(exponent, e);
  }
  return exponent;
}
inline int unit_of(const polygons::Path& a, const polygons::Path& b) {
  int exponent = 1024;
  for (const polygons::Path* path : {&a, &b}) {
    for (const double v : path->xy) exponent = unit_of({v}, exponent);
  }
  return exponent;
}
inline Integer in_units(double v, int exponent) { return Integer(shifted(Rational(v), -exponent)); }

inline Edges edges(const polygons::Path& path, bool closed, int exponent) {
  Edges out;
  const auto vertex = [&](std::int32_t i) {
    const auto k = static_cast<std::size_t>(2 * i);
    return Point{in_units(path.xy[k], exponent), in_units(path.xy[k + 1], exponent)};
  };
  for (std::size_t j = 0; j < path.ring_count(); ++j) {
    const std::int32_t first = path.rings[j], last = path.rings[j + 1];
    for (std::int32_t i = first; i + 1 < last; ++i) out.push_back({vertex(i), vertex(i + 1)});
    if (last > first && (closed || last - first == 1)) out.push_back({vertex(last - 1), vertex(first)});
  }
  return out;
}

inline Integer cross(const Point& o, const Point& a, const Point& b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}
inline int side(const Point& o, const Point& a, const Point& b) { return sgn(cross(o, a, b)); }
inline bool is_on(const Point& p, const Edge& e) {
  return std::min(e.a.x, e.b.x) <= p.x && p.x <= std::max(e.a.x, e.b.x) && std::min(e.a.y, e.b.y) <= p.y &&
         p.y <= std::max(e.a.y, e.b.y) && side(e.a, e.b, p) == 0;
}
inline bool meet(const Edge& e, const Edge& f) {
  if (is_on(e.a, f) || is_on(e.b, f) || is_on(f.a, e) || is_on(f.b, e)) return true;
  return side(e.a, e.b, f.a) * side(e.a, e.b, f.b) < 0 && side(f.a, f.b, e.a) * side(f.a, f.b, e.b) < 0;
}
inline bool outlines_meet(const Edges& a, const Edges& b) {
  return std::any_of(a.begin(), a.end(), [&](const Edge& e) {
    return std::any_of(b.begin(), b.end(), [&](const Edge& f) { return meet(e, f); });
  });
}

/// The area that both share, and each area.
struct Areas {
  Rational both, a, b;
};

inline Integer doubled_area(const Edges& edges) {
  Integer sum = 0;
  for (const Edge& e : edges) sum += e.a.x * e.b.y - e.a.y * e.b.x;
  return sum;
}

/// Convex polygons, counter-clockwise and without repeated vertices.
inline Areas areas_of_convex(const Edges& a, const Edges& b) {
  Rational sum = 0;
  for (const bool second : {false, true}) {
    for (const Edge& e : second ? b : a) {
      const Integer dx = e.b.x - e.a.x, dy = e.b.y - e.a.y;
      Rational from = 0, to = 1;
      for (const Edge& f : second ? a : b) {
        const Integer fx = f.b.x - f.a.x, fy = f.b.y - f.a.y;
        const Integer left = cross(f.a, f.b, e.a), slope = fx * dy - fy * dx;  // left of f where left + t slope >= 0
        if (sgn(slope) == 0) {
          // Along an edge that both have, the first one's counts.
          if (sgn(left) < 0 || (sgn(left) == 0 && second && sgn(fx * dx + fy * dy) > 0)) to = 0;
        } else if (sgn(slope) > 0) {
          from = std::max(from, ratio(-left, slope));
        } else {
          to = std::min(to, ratio(-left, slope));
        }
      }
      if (from < to) sum += (to - from) * Rational(e.a.x * e.b.y - e.a.y * e.b.x);
    }
  }
  return {sum / 2, Rational(doubled_area(a)) / 2, Rational(doubled_area(b)) / 2};
}

/// Any polygons, by the even-odd rule.
inline Areas areas(const Edges& a, const Edges& b) {
  struct Line {
    Rational x0, y0, x1, y1;
    bool second;
    Rational at(const Rational& x) const { return y0 + (y1 - y0) * (x - x0) / (x1 - x0); }
  };
  std::vector<Line> lines;
  std::vector<Rational> places;
  for (const bool second : {false, true}) {
    for (const Edge& e : second ? b : a) {
      if (e.a.x == e.b.x) continue;
      const Point &p = e.a.x < e.b.x ? e.a : e.b, &q = e.a.x < e.b.x ? e.b : e.a;
      lines.push_back({Rational(p.x), Rational(p.y), Rational(q.x), Rational(q.y), second});
      places.insert(places.end(), {Rational(p.x), Rational(q.x)});
    }
  }
  for (const Line& e : lines) {
    for (const Line& f : lines) {
      const Rational low = std::max(e.x0, f.x0), high = std::min(e.x1, f.x1);
      if (e.second || !f.second || low >= high) continue;
      const Rational p = e.at(low) - f.at(low), q = e.at(high) - f.at(high);
      if (sgn(p) * sgn(q) < 0) places.push_back(low + (high - low) * p / (p - q));
    }
  }
  std::sort(places.begin(), places.end());
  Areas sum{0, 0, 0};
  for (std::size_t i = 1; i < places.size(); ++i) {
    const Rational width = places[i] - places[i - 1], middle = (places[i] + places[i - 1]) / 2;
    if (sgn(width) == 0) continue;
    std::vector<std::pair<Rational, bool>> heights;
    for (const Line& line : lines) {
      if (line.x0 < middle && middle < line.x1) heights.emplace_back(line.at(middle), line.second);
    }
    std::sort(heights.begin(), heights.end());
    bool inside[2] = {false, false};
    for (std::size_t k = 0; k < heights.size(); ++k) {
      const Rational part = k == 0 ? Rational(0) : Rational(width * (heights[k].first - heights[k - 1].first));
      if (inside[0] && inside[1]) sum.both += part;
      if (inside[0]) sum.a += part;
      if (inside[1]) sum.b += part;
      inside[heights[k].second ? 1 : 0] ^= true;
    }
  }
  return sum;
}

/// The first time at which b, moved by t (vx, vy), touches a; both are apart before. False if they never touch.
inline bool first_contact(const Edges& a, const Edges& b, const Integer& vx, const Integer& vy, Rational& first) {
  bool found = false;
  const auto offer = [&](const Rational& t) {
    if (sgn(t) < 0 || (found && t >= first)) return;
    first = t;
    found = true;
  };
  // A point that moves against an edge at rest.
  const auto look = [&](const Point& p, const Integer& wx, const Integer& wy, const Edge& e) {
    const Integer ex = e.b.x - e.a.x, ey = e.b.y - e.a.y, toward = ex * wy - ey * wx;
    if (sgn(toward) == 0) return;
    const Rational t = ratio(-cross(e.a, e.b, p), toward), x = p.x + t * wx - e.a.x, y = p.y + t * wy - e.a.y;
    const Rational along = x * ex + y * ey;
    if (sgn(along) >= 0 && along <= Rational(ex * ex + ey * ey)) offer(t);
  };
  for (const Edge& e : a) {
    for (const Edge& f : b) {
      for (const Point* p : {&f.a, &f.b}) look(*p, vx, vy, e);
      for (const Point* p : {&e.a, &e.b}) look(*p, -vx, -vy, f);
      for (const Point* p : {&e.a, &e.b}) {  // edges along the velocity: an end runs into an end
        for (const Point* q : {&f.a, &f.b}) {
          const Integer dx = p->x - q->x, dy = p->y - q->y;
          if (dx * vy == dy * vx) offer(sgn(vx) != 0 ? ratio(dx, vx) : ratio(dy, vy));
        }
      }
    }
  }
  return found;
}

}  // namespace rational

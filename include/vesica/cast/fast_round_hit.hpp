// SPDX-License-Identifier: Apache-2.0
/// The contact of round shapes, after early_out.hpp has decided that they meet. Points and normals are computed by the
/// operations of first_contact.hpp, in a scene that needs no scaling. The time is one step of Newton's method for
/// f(t) = 0, f being convex along the ray, rounded down; for two ellipses it is T(n), as in bound.hpp.
///
/// Templates on V serve scalars and SIMD lanes: V is double or lanes of it.
#pragma once

#include <vesica/arithmetic/side_by_side.hpp>
#include <vesica/cast/fast_numbers.hpp>

namespace vesica::detail::cast {

/// A time, the bound of its error, and of a round shape how f grows there, in its frame: the contact's own normal.
struct FastTime {
  Twofold<double> value;
  double error, gx, gy;
};

/// One step of Newton's method from `first`, for f = |(X, Y)|^2 - R^2 with (X, Y) moving by `way`. A step d leaves
/// |way|^2 d^2 over the slope; f is off by f_error, and half its slope by slope_error.
VESICA_INLINE FastTime stepped(double first, const Vector& at, double f, const Offset& way, double f_error,
                               double slope_error) noexcept {
  const double x = arithmetic::rounded(at.x), y = arithmetic::rounded(at.y);
  const double over = -0.5 / (x * way.x + y * way.y), step = f * over, size = abs(step);
  const double left = 2 * ((way.x * way.x + way.y * way.y) * size + 2 * slope_error) * size;
  return {{first, step}, over * (f_error + left) + 0x1p-50 * size, x + step * way.x, y + step * way.y};
}

/// An estimate of the first root of |P + t way|^2 = R^2, in double.
VESICA_INLINE double estimated_time(const Offset& p, const Offset& way, double r) noexcept {
  const double q = p.x * way.x + p.y * way.y, w = way.x * p.y - way.y * p.x, ww = way.x * way.x + way.y * way.y;
  return (-q - sqrt((r * r) * ww - w * w)) / ww;
}

/// How far something reaches that reaches p and q along two axes.
template <class Products, class V>
VESICA_INLINE Twofold<V> reach_of(const Twofold<V>& p, const Twofold<V>& q) noexcept {
  return renormalised(Products::root(square(Products::factor(p)) + square(Products::factor(q))).value);
}

/// The disc's terms for direction.hpp, bit for bit.
template <class Products>
VESICA_INLINE Twofold<double> disc_reach(double r, const Motion& v) noexcept {
  const auto factor = Products::factor(r);
  return reach_of<Products>(factor * Products::factor(v.vy), factor * Products::factor(v.vx));
}
VESICA_INLINE Curve disc_curve(double r, const Motion& v) noexcept {
  const double al = (r * v.vy) * (r * v.vy) + (r * v.vx) * (r * v.vx), area = r * r * (v.vx * v.vx + v.vy * v.vy);
  return {0, al, area * area / al, sqrt(al)};
}

/// The point of an ellipse or a disc farthest along the direction (p, q) in its frame.
template <class V>
VESICA_INLINE OffsetOf<V> foremost_of(V a, V b, V p, V q) noexcept {
  const V h = sqrt((a * p) * (a * p) + (b * q) * (b * q));
  return {a * (a * p / h), b * (b * q / h)};
}

/// |D + v t| = r. With the sum of lengths L = r + |D| + |v| t, X and Y are off by 2^-102 L.
template <class Products>
VESICA_INLINE FastTime disc_time(const Vector& d, const Motion& v, const Twofold<double>& r) noexcept {
  const Offset way{v.vx, v.vy};
  const double first = estimated_time({d.x.high, d.y.high}, way, r.high);
  const auto t = Products::factor(first);
  const Vector at{d.x + Products::factor(v.vx) * t, d.y + Products::factor(v.vy) * t};
  const Twofold<double> f =
      (square(Products::factor(at.x)) + square(Products::factor(at.y))) - square(Products::factor(r));
  const double speed = abs(v.vx) + abs(v.vy), sizes = r.high + (abs(d.x.high) + abs(d.y.high)) + speed * first;
  return stepped(first, at, arithmetic::rounded(f), way, 0x1p-98 * r.high * sizes, 0x1p-50 * r.high * speed);
}

/// Two discs.
struct Discs {
  double a, b;

  bool is_usual() const noexcept { return lane::both(is_plain_size(a), is_plain_size(b)); }
  double radius() const noexcept { return a + b; }
  double shortest() const noexcept { return a + b; }

  template <class Products>
  struct Asked {
    double a, b;
    FastTime time;
    Twofold<double> reach;

    double best(const Motion& v, double w, double gap) const noexcept {
      int steps;
      return lane::flip_sign(maximum_of_two(disc_curve(a, v), disc_curve(b, v), gap, steps), w);
    }
    Offset in_frame(const Vector& n) const noexcept { return {n.x.high, n.y.high}; }
    Offset foremost(const Vector& n) const noexcept { return foremost_of(a, a, n.x.high, n.y.high); }
  };
  template <class Products>
  VESICA_INLINE Asked<Products> ask(const Vector& d, const Motion& v) const noexcept {
    return {a, b, disc_time<Products>(d, v, arithmetic::exact_sum(a, b)),
            arithmetic::renormalised(disc_reach<Products>(a, v) + disc_reach<Products>(b, v))};
  }
};

/// An ellipse, which a point meets. A disc is one with the axis (1, 0).
template <class V>
struct FastEllipse {
  V ux, uy, a, b;

  VESICA_INLINE MaskOf<V> is_usual() const noexcept {
    const V uu = ux * ux + uy * uy;
    return both(both(both(is_plain_size(a), is_plain_size(b)), max(a, b) <= V(64.0) * min(a, b)),
                both(both(uu >= V(0.25), uu <= V(4.0)), both(is_plain(ux), is_plain(uy))));
  }
  double radius() const noexcept {
    const double longer = lane::max(a, b);
    return 2 * (longer * longer / lane::min(a, b));
  }
  double shortest() const noexcept { return lane::min(a, b); }

  VESICA_INLINE OffsetOf<V> out_of_frame(const OffsetOf<V>& at) const noexcept {
    return at.x * OffsetOf<V>{ux, uy} + at.y * OffsetOf<V>{-uy, ux};
  }
  template <class Products>
  VESICA_INLINE Twofold<V> reach(const OffsetOf<V>& v) const noexcept {
    const auto u = plain_factor<Products>(ux, uy), along = plain_factor<Products>(v.x, v.y);
    return reach_of<Products>(Products::factor(a) * Products::factor(cross(u, along)),
                              Products::factor(b) * Products::factor(dot(u, along)));
  }

  VESICA_INLINE CurveOf<V> curve(const OffsetOf<V>& v) const noexcept {
    const V c = ux * v.x + uy * v.y, k = ux * v.y - uy * v.x, al = (a * k) * (a * k) + (b * c) * (b * c);
    const V area = a * b * (ux * ux + uy * uy) * (v.x * v.x + v.y * v.y);
    return {((b - a) * (b + a)) * (c * k) / al, al, area * area / al, sqrt(al)};
  }
};

/// True if the search for the best direction ends where it begins, at n. Then n is the normal that the general path
/// finds, bit for bit, and no search is needed. (gx, gy) is the contact's own normal m with a relative error of 2^-48,
/// (p, q) is n in the same frame.
///
/// Proved: a better direction than n would gain less than 2^-72 t, less than the 2^-70 t for which polished() takes
/// another step.
///
///   - If n turns from m by an angle below z, s is off by z |n|^2 / (v.v). That gains less than 4 H z^2 |n| / (v.v)
///     (bound.hpp), H being the greatest radius of curvature.
///   - Here z < 2^-44 and H |n| / (v.v) < 2^13 t.
///   - What support_of() may be off by counts less where lengths are below 2^16 of the shortest.
///
/// Normals almost parallel to a coordinate axis are left open.
VESICA_INLINE bool ends_at(const Vector& n, const Offset& in_frame, const FastTime& time, double radius, double vv,
                           double t) noexcept {
  const double x = abs(n.x.high), y = abs(n.y.high), longer = x + y, p = in_frame.x, q = in_frame.y;
  return abs(time.gx * q - time.gy * p) <= 0x1p-45 * ((abs(time.gx) + abs(time.gy)) * (abs(p) + abs(q))) &&
         radius * longer <= 0x1p12 * (vv * t) && x > 0x1p-24 * y && y > 0x1p-24 * x;
}

/// direction() of direction.hpp.
template <class Products, class V>
VESICA_INLINE arithmetic::Vector<V> normal_of(V s, const OffsetOf<V>& v) noexcept {
  const auto by = Products::factor(s);
  const Twofold<V> x = by * Products::factor(v.y), y = by * Products::factor(v.x);
  return {arithmetic::renormalised(-(x + Twofold<V>{v.x, V(0.0)})),
          arithmetic::renormalised(y - Twofold<V>{v.y, V(0.0)})};
}

VESICA_INLINE Impact<double> round_impact(double t, double cx, double cy, const Offset& at, const Vector& n) noexcept {
  const double x = n.x.high, y = n.y.high, length = sqrt(x * x + y * y);
  return {t, support_minimum::located_coordinate(cx, cx, at.x) + 0.0,
          support_minimum::located_coordinate(cy, cy, at.y) + 0.0, x / length + 0.0, y / length + 0.0};
}

/// The contact of the offset of centres d with the sum of round shapes; (cx, cy) is the first's centre.
template <class Products, class Sum>
VESICA_INLINE EarlyOut round_hit(const Sum& sum, const Vector& d, const Motion& v, double cx, double cy,
                                 Impact<double>& out) noexcept {
  if (!lane::both(is_plain(d, v), sum.is_usual())) return EarlyOut::open;
  const auto asked = sum.template ask<Products>(d, v);
  double t;
  const EarlyOut early = floor_of(asked.time.value, asked.time.error, v.end, t);
  if (early != EarlyOut::hit) return early;
  const Twofold<double> w = arithmetic::renormalised(cross(plain_factor<Products>(v.vx, v.vy), Products::factor(d)));
  const double gap = gap_of(asked.reach, w);
  const Vector n = normal_of<Products>(asked.best(v, w.high, gap), velocity(v));
  const double vv = v.vx * v.vx + v.vy * v.vy, speed = abs(v.vx) + abs(v.vy);
  const double lengths = abs(d.x.high) + abs(d.y.high) + speed * t;
  const bool usual = lane::both(gap >= 0x1p-8 * asked.reach.high, lengths <= 0x1p16 * sum.shortest());
  if (!lane::both(usual, ends_at(n, asked.in_frame(n), asked.time, sum.radius(), vv, t))) return EarlyOut::open;
  out = round_impact(t, cx, cy, asked.foremost(n), n);
  return EarlyOut::hit;
}

/// The terms of a point and one round shape. `squared` is the square of the reach across v, and al its upper part; w is
/// that of direction.hpp, both to twice the precision. `line` is al - w^2 in double, `line_error` bounds its error. s
/// and `area`, a b u.u v.v, are those of direction.hpp.
struct OneRound {
  Twofold<double> squared, w;
  double line, line_error, s, area;
};

/// The search of direction.hpp, which is a formula for one round shape, and an estimate of the time at which the point
/// arrives, from q = P.way, way.way and `scale`, the ratio of half the slope of f there to the root of `line`. `first`
/// is the estimate, `over` half of one over that slope, and `off` its relative error. All roots and quotients are taken
/// side by side. Those of the search have the operands of reach_of(), gap_of() and maximum_of_one(), where al, rounded,
/// is the upper part of `squared`: so they give the same bits.
struct RoundSearch {
  double s, gap, reach, first, over, off;
};
template <class Products>
VESICA_INLINE RoundSearch search_of(const OneRound& e, double q, double ww, double scale) noexcept {
  using arithmetic::Two;
  const double al = e.squared.high, side = abs(e.w.high);
  const Two root = sqrt(Two{al, e.line});
  const double slope = scale * root.y;
  const Two one = Two{1.0, e.area * e.area} / Two{root.x, al}, time = Two{-q - slope, 0.5} / Two{ww, slope};
  const Twofold<double> back = square(Products::factor(root.x));
  const double low = ((al - back.high) + (e.squared.low - back.low)) * (0.5 * one.x);
  const double upper = root.x + low;
  const Twofold<double> reach{upper, low - (upper - root.x)};
  // gap_of(), of what is renormalised.
  const double gap = lane::max(arithmetic::rounded(reach - flipped(e.w, e.w.high)), 0x1p-106 * upper);
  const double part = scale * time.y;
  const Two second = sqrt(Two{one.y, gap * (root.x + side)});
  const Two last = Two{second.x, side} / Two{root.x, second.y};
  return {e.s + lane::flip_sign(last.x * last.y, e.w.high),
          gap,
          reach.high,
          time.x,
          time.y,
          8 * e.line_error * (part * part)};
}

/// One step of Newton's method from `first`, for f = |P + t way|^2 - R^2; f_error bounds the error of f. `over` has the
/// relative error `off`; the slope at the root differs from the slope at `first` by way.way times the step. Each counts
/// once for the slope, and the second half more for the bend of f, for steps as short as floor_of() takes. The sum of
/// squares is nearly R^2, so the upper parts cancel exactly; the remainder is rounded to 2^-53 of f.
template <class Products, class Way, class Radius>
VESICA_INLINE FastTime stepped_once(const Vector& p, const Way& wx, const Way& wy, const Radius& r, const Offset& way,
                                    const RoundSearch& found, double ww, double f_error) noexcept {
  const auto t = Products::factor(found.first);
  const Twofold<double> x = p.x + t * wx, y = p.y + t * wy;
  const Twofold<double> xx = square(Products::factor(x.high)), yy = square(Products::factor(y.high)), rr = square(r);
  const Twofold<double> sum = arithmetic::exact_sum(xx.high, yy.high);
  const double rest = x.low * ((x.high + x.high) + x.low) + y.low * ((y.high + y.high) + y.low);
  const double f = (sum.high - rr.high) + (((sum.low + (xx.low + yy.low)) - rr.low) + rest);
  const double step = f * found.over, size = abs(step);
  const double error = found.over * (2 * f_error + 8 * ww * (size * size)) + size * (found.off + 0x1p-48);
  return {{found.first, step}, error, x.high + step * way.x, y.high + step * way.y};
}

/// The point of the round shape's outline, (p, q) being n in its frame, and n as a unit vector.
struct RoundPoint {
  Offset at;
  double nx, ny;
};
VESICA_INLINE RoundPoint round_point(double a, double b, const Offset& in_frame, const Vector& n) noexcept {
  using arithmetic::Two;
  const double p = a * in_frame.x, q = b * in_frame.y, x = n.x.high, y = n.y.high;
  const Two root = sqrt(Two{p * p + q * q, x * x + y * y});
  const Two at = Two{p, q} / Two{root.x, root.x}, unit = Two{x, y} / Two{root.y, root.y};
  return {{a * at.x, b * at.y}, unit.x, unit.y};
}

/// True if the contact is certain.
VESICA_INLINE bool is_certain(const RoundSearch& found, const Vector& n, const Offset& in_frame, const FastTime& time,
                              double distance, const Motion& v, double radius, double shortest, double t) noexcept {
  const double vv = v.vx * v.vx + v.vy * v.vy, speed = abs(v.vx) + abs(v.vy), lengths = distance + speed * t;
  return found.gap >= 0x1p-8 * found.reach && lengths <= 0x1p16 * shortest && ends_at(n, in_frame, time, radius, vv, t);
}

/// A disc of radius r and a point at d, which moves by `fv`: the time t, and the normal n of the general path. `w` is
/// v x d as that has it, and `others` are lengths whose rounding counts in d and w.
template <class Products, class Velocity>
VESICA_INLINE EarlyOut disc_hit(const Vector& d, const Twofold<double>& w, double r, const Motion& v,
                                const Velocity& fv, double others, double& t, Vector& n) noexcept {
  const double dx = d.x.high, dy = d.y.high, vv = v.vx * v.vx + v.vy * v.vy, dd = dx * dx + dy * dy;
  const double cross_of_highs = v.vx * dy - v.vy * dx;
  const auto fr = Products::factor(r);
  const OneRound asked{square(Products::factor(fr * fv.y)) + square(Products::factor(fr * fv.x)),
                       w,
                       (r * r) * vv - cross_of_highs * cross_of_highs,
                       0x1p-49 * (vv * (dd + r * r)),
                       0,
                       r * r * vv};
  const RoundSearch found = search_of<Products>(asked, v.vx * dx + v.vy * dy, vv, 1);
  const double sizes = r + others + (abs(dx) + abs(dy)) + (abs(v.vx) + abs(v.vy)) * found.first;
  const FastTime time = stepped_once<Products>(d, fv.x, fv.y, fr, velocity(v), found, vv, 0x1p-98 * r * sizes);
  const EarlyOut early = floor_of(time.value, time.error, v.end, t);
  if (early != EarlyOut::hit) return early;
  n = normal_of<Products>(found.s, velocity(v));
  const bool certain = is_certain(found, n, {n.x.high, n.y.high}, time, abs(dx) + abs(dy) + others, v, r, r, t);
  return certain ? EarlyOut::hit : EarlyOut::open;
}

template <class Products>
VESICA_INLINE EarlyOut fast_hit(const Circle<double>& a, const Point<double>& b, const Motion& v,
                                Impact<double>& out) noexcept {
  const Vector d = exact_offset(b.x, b.y, a.cx, a.cy);
  if (!(is_plain(d, v) && is_plain_size(a.r))) return EarlyOut::open;
  const auto fv = plain_factor<Products>(v.vx, v.vy);
  double t;
  Vector n;
  const EarlyOut early =
      disc_hit<Products>(d, arithmetic::renormalised(cross(fv, Products::factor(d))), a.r, v, fv, 0, t, n);
  if (early != EarlyOut::hit) return early;
  const RoundPoint point = round_point(a.r, a.r, {n.x.high, n.y.high}, n);
  out = {t, (a.cx + point.at.x) + 0.0, (a.cy + point.at.y) + 0.0, point.nx + 0.0, point.ny + 0.0};
  return EarlyOut::hit;
}
template <class Products>
VESICA_INLINE EarlyOut fast_hit(const Circle<double>& a, const Circle<double>& b, const Motion& v,
                                Impact<double>& out) noexcept {
  return round_hit<Products>(Discs{a.r, b.r}, exact_offset(b.cx, b.cy, a.cx, a.cy), v, a.cx, a.cy, out);
}
/// |(b X, a Y)| = a b u.u with X = u.(D + v t), Y = u x (D + v t), which are off by 2^-100 of the sum of their terms.
template <class Products>
VESICA_INLINE EarlyOut fast_hit(const Ellipse<double>& ellipse, const Point<double>& point, const Motion& v,
                                Impact<double>& out) noexcept {
  const FastEllipse<double> e{ellipse.ux, ellipse.uy, ellipse.a, ellipse.b};
  const Vector d = exact_offset(point.x, point.y, ellipse.cx, ellipse.cy);
  if (!(is_plain(d, v) && e.is_usual())) return EarlyOut::open;
  const double a = e.a, b = e.b, dx = d.x.high, dy = d.y.high, vv = v.vx * v.vx + v.vy * v.vy;
  const auto fa = Products::factor(a), fb = Products::factor(b);
  const auto u = plain_factor<Products>(e.ux, e.uy), fv = plain_factor<Products>(v.vx, v.vy);
  const auto to = Products::factor(d);
  const Twofold<double> c = dot(u, fv), k = cross(u, fv);
  const Vector p{fb * Products::factor(dot(u, to)), fa * Products::factor(cross(u, to))};
  const Vector way{fb * Products::factor(c), fa * Products::factor(k)};
  const Twofold<double> squared = square(Products::factor(way.y)) + square(Products::factor(way.x));
  const Twofold<double> r = fa * Products::factor(fb * Products::factor(dot(u, u)));
  const double w = v.vx * dy - v.vy * dx, axis = (a + b) * (abs(e.ux) + abs(e.uy)), speed = abs(v.vx) + abs(v.vy);
  const double across = axis * speed, distance = abs(dx) + abs(dy), width = speed * distance, al = squared.high;
  const OneRound asked{squared,
                       arithmetic::renormalised(cross(fv, to)),
                       al - w * w,
                       0x1p-49 * (across * across + width * width),
                       ((b - a) * (b + a)) * (c.high * k.high) / al,
                       a * b * (e.ux * e.ux + e.uy * e.uy) * vv};
  const double q = p.x.high * way.x.high + p.y.high * way.y.high;
  const RoundSearch found = search_of<Products>(asked, q, al, r.high);
  const double sizes = r.high + axis * distance + across * found.first;
  FastTime time = stepped_once<Products>(p, Products::factor(way.x), Products::factor(way.y), Products::factor(r),
                                         {way.x.high, way.y.high}, found, al, 0x1p-96 * r.high * sizes);
  time.gx *= b;
  time.gy *= a;
  double t;
  const EarlyOut early = floor_of(time.value, time.error, v.end, t);
  if (early != EarlyOut::hit) return early;
  const Vector n = normal_of<Products>(found.s, velocity(v));
  const auto along = Products::factor(n);
  const Offset in_frame{arithmetic::rounded(dot(u, along)), arithmetic::rounded(cross(u, along))};
  if (!is_certain(found, n, in_frame, time, distance, v, e.radius(), e.shortest(), t)) return EarlyOut::open;
  const RoundPoint at = round_point(a, b, in_frame, n);
  const Offset from_centre = e.out_of_frame(at.at);
  out = {t, (ellipse.cx + from_centre.x) + 0.0, (ellipse.cy + from_centre.y) + 0.0, at.nx + 0.0, at.ny + 0.0};
  return EarlyOut::hit;
}

/// Two ellipses: no root is at hand. T(n) at the n found is a lower bound of the time. The gain that the slope there
/// may still bring, known to e in double, is bounded as in bound.hpp.
template <class V>
struct FastSupport {
  Twofold<V> h;
  V beside, bend, error, steepness;
  OffsetOf<V> in_frame;
};
template <class Products, class V>
VESICA_INLINE FastSupport<V> fast_support(const FastEllipse<V>& e, const arithmetic::Vector<V>& n,
                                          const OffsetOf<V>& v) noexcept {
  const auto u = plain_factor<Products>(e.ux, e.uy);
  const auto along = Products::factor(n);
  const Twofold<V> p = arithmetic::renormalised(dot(u, along)), q = arithmetic::renormalised(cross(u, along));
  const Twofold<V> ap = Products::factor(e.a) * Products::factor(p), bq = Products::factor(e.b) * Products::factor(q);
  const Twofold<V> h = reach_of<Products>(ap, bq);
  const V c = e.ux * v.x + e.uy * v.y, k = e.ux * v.y - e.uy * v.x, over = V(1.0) / h.high;
  const V vv = v.x * v.x + v.y * v.y, ratio = (e.a * e.b) * (e.ux * e.ux + e.uy * e.uy) * vv * over;
  const V size = (e.a + e.b) * (abs(e.ux) + abs(e.uy)) * (abs(v.x) + abs(v.y));
  return {h,
          (bq.high * (e.b * c) - ap.high * (e.a * k)) * over,
          ratio * ratio * over,
          V(0x1p-48) * size,
          size * over,
          {p.high, q.high}};
}

/// The floor of the time, where from the first's centre, and along which normal, of any length.
template <class V>
struct FastMeeting {
  Floor<V> floor;
  OffsetOf<V> at;
  arithmetic::Vector<V> normal;
};
/// idle: lanes that are not used. is_point: b is a point, whose numbers are 0.
template <class Products, class V>
VESICA_INLINE FastMeeting<V> ellipses_meeting(const FastEllipse<V>& a, const FastEllipse<V>& b,
                                              const arithmetic::Vector<V>& d, const OffsetOf<V>& v, MaskOf<V> idle,
                                              bool is_point) noexcept {
  const auto along = plain_factor<Products>(v.x, v.y);
  const auto to = Products::factor(d);
  const Twofold<V> w = arithmetic::renormalised(cross(along, to));
  Twofold<V> reach = a.template reach<Products>(v);
  CurveOf<V> curve = a.curve(v);
  V best;
  if (is_point) {
    best = maximum_of_one(curve, w.high, gap_of(reach, w));
  } else {
    reach = arithmetic::renormalised(reach + b.template reach<Products>(v));
    CurveOf<V> other = b.curve(v);
    curve.s = flip_sign(curve.s, w.high);
    other.s = flip_sign(other.s, w.high);
    maximum_of_two(curve, other, gap_of(reach, w), idle, best);
    best = flip_sign(best, w.high);
  }
  const arithmetic::Vector<V> n = normal_of<Products>(best, v);
  const FastSupport<V> sa = fast_support<Products>(a, n, v);
  FastSupport<V> sb{};
  if (!is_point) sb = fast_support<Products>(b, n, v);
  const auto nf = Products::factor(n);
  const Twofold<V> room = arithmetic::renormalised(dot(nf, to) - (sa.h + sb.h));
  const Twofold<V> approach = arithmetic::renormalised(-dot(nf, along));
  const V start = room.high / approach.high;
  const Twofold<V> rest = room - Products::factor(start) * Products::factor(approach);
  const V step = arithmetic::rounded(rest) / approach.high;
  const V vv = v.x * v.x + v.y * v.y, speed = abs(v.x) + abs(v.y);
  const V n_size = abs(n.x.high) + abs(n.y.high), error = sa.error + sb.error;
  const V sizes = (abs(d.x.high) + abs(d.y.high)) + speed * abs(start) + V(0x1p48) * error / speed;
  const V slope = abs(w.high - (sa.beside + sb.beside)) + error, bend = sa.bend + sb.bend, off = slope / bend;
  const V gain = V(2.0) * slope * (off / vv);
  const V lost = V(0x1p-94) * n_size * sizes / approach.high + V(0x1p-100) * abs(start);
  const auto ends = both(gain <= V(0x1p-74) * start, V(64.0) * off * max(sa.steepness, sb.steepness) < V(1.0));
  Floor<V> floor = floor_of(Twofold<V>{start, step}, lost + gain);
  floor.certain = both(floor.certain, both(ends, sizes * (V(0x1p-40) * n_size) < sa.h.high + sb.h.high));
  return {floor, a.out_of_frame(foremost_of(a.a, a.b, sa.in_frame.x, sa.in_frame.y)), n};
}

template <class Products>
VESICA_INLINE EarlyOut fast_hit(const Ellipse<double>& first, const Ellipse<double>& second, const Motion& motion,
                                Impact<double>& out) noexcept {
  const FastEllipse<double> a{first.ux, first.uy, first.a, first.b}, b{second.ux, second.uy, second.a, second.b};
  const Vector d = exact_offset(second.cx, second.cy, first.cx, first.cy);
  if (!lane::both(is_plain(d, motion), lane::both(a.is_usual(), b.is_usual()))) return EarlyOut::open;
  const auto [floor, at, n] = ellipses_meeting<Products>(a, b, d, velocity(motion), false, false);
  if (!floor.certain || floor.t == motion.end) return EarlyOut::open;
  if (floor.t > motion.end) return EarlyOut::missed;
  out = round_impact(floor.t, first.cx, first.cy, at, n);
  return EarlyOut::hit;
}

}  // namespace vesica::detail::cast

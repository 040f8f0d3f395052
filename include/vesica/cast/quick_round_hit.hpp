// SPDX-License-Identifier: Apache-2.0
/// The contact of round shapes, after quick.hpp has decided that they meet. Points and normals are computed by the
/// operations of first_contact.hpp, in a scene that needs no scaling. The time is one step of Newton's method for
/// f(t) = 0, f being convex along the ray, rounded down; for two ellipses it is T(n), as in bound.hpp.
#pragma once

#include <vesica/cast/quick_numbers.hpp>

namespace vesica::detail::cast {

/// A time, the bound of its error, and of a round shape how f grows there, in its frame: the contact's own normal.
struct QuickTime {
  Twofold<double> value;
  double error, gx, gy;
};

/// One step of Newton's method from `first`, for f = |(X, Y)|^2 - R^2 with (X, Y) moving by `way`. A step d leaves
/// |way|^2 d^2 over the slope; f is off by f_error, and half its slope by slope_error.
VESICA_INLINE QuickTime stepped(double first, const Vector& at, double f, const Offset& way, double f_error,
                                double slope_error) noexcept {
  const double x = arithmetic::rounded(at.x), y = arithmetic::rounded(at.y);
  const double over = -0.5 / (x * way.x + y * way.y), step = f * over, size = abs(step);
  const double left = 2 * ((way.x * way.x + way.y * way.y) * size + 2 * slope_error) * size;
  return {{first, step}, over * (f_error + left) + 0x1p-50 * size, x + step * way.x, y + step * way.y};
}

/// The first root of |P + t way|^2 = R^2 in double.
VESICA_INLINE double rough_time(const Offset& p, const Offset& way, double r) noexcept {
  const double q = p.x * way.x + p.y * way.y, w = way.x * p.y - way.y * p.x, ww = way.x * way.x + way.y * way.y;
  return (-q - sqrt((r * r) * ww - w * w)) / ww;
}

/// How far something reaches that reaches p and q along two axes.
template <class Products>
VESICA_INLINE Twofold<double> reach_of(const Twofold<double>& p, const Twofold<double>& q) noexcept {
  return renormalised(Products::root(square(Products::factor(p)) + square(Products::factor(q))).value);
}

/// What of a disc direction.hpp asks for, to the bit.
template <class Products>
VESICA_INLINE Twofold<double> disc_reach(double r, const Motion& v) noexcept {
  const auto factor = Products::factor(r);
  return reach_of<Products>(factor * Products::factor(v.vy), factor * Products::factor(v.vx));
}
VESICA_INLINE Curve disc_curve(double r, const Motion& v) noexcept {
  const double al = (r * v.vy) * (r * v.vy) + (r * v.vx) * (r * v.vx), area = r * r * (v.vx * v.vx + v.vy * v.vy);
  return {0, al, area * area / al, sqrt(al)};
}

/// Of an ellipse, or a disc, the point farthest along a direction that is (p, q) in its frame.
VESICA_INLINE Offset foremost_of(double a, double b, double p, double q) noexcept {
  const double h = sqrt((a * p) * (a * p) + (b * q) * (b * q));
  return {a * (a * p / h), b * (b * q / h)};
}

/// |D + v t| = r. With the sum of lengths L = r + |D| + |v| t, X and Y are off by 2^-102 L.
template <class Products>
VESICA_INLINE QuickTime disc_time(const Vector& d, const Motion& v, const Twofold<double>& r) noexcept {
  const Offset way{v.vx, v.vy};
  const double first = rough_time({d.x.high, d.y.high}, way, r.high);
  const auto t = Products::factor(first);
  const Vector at{d.x + Products::factor(v.vx) * t, d.y + Products::factor(v.vy) * t};
  const Twofold<double> f =
      (square(Products::factor(at.x)) + square(Products::factor(at.y))) - square(Products::factor(r));
  const double speed = abs(v.vx) + abs(v.vy), sizes = r.high + (abs(d.x.high) + abs(d.y.high)) + speed * first;
  return stepped(first, at, arithmetic::rounded(f), way, 0x1p-98 * r.high * sizes, 0x1p-50 * r.high * speed);
}

/// A disc, which a point meets.
struct QuickDisc {
  double r;

  bool is_usual() const noexcept { return is_plain_size(r); }
  double radius() const noexcept { return r; }
  double shortest() const noexcept { return r; }

  template <class Products>
  struct Asked {
    double r;
    QuickTime time;
    Twofold<double> reach;

    double best(const Motion& v, double w, double gap) const noexcept {
      return maximum_of_one(disc_curve(r, v), w, gap);
    }
    Offset in_frame(const Vector& n) const noexcept { return {n.x.high, n.y.high}; }
    Offset foremost(const Vector& n) const noexcept { return foremost_of(r, r, n.x.high, n.y.high); }
  };
  template <class Products>
  VESICA_INLINE Asked<Products> ask(const Vector& d, const Motion& v) const noexcept {
    return {r, disc_time<Products>(d, v, {r, 0}), disc_reach<Products>(r, v)};
  }
};

/// Two discs.
struct QuickDiscs {
  double a, b;

  bool is_usual() const noexcept { return lane::both(is_plain_size(a), is_plain_size(b)); }
  double radius() const noexcept { return a + b; }
  double shortest() const noexcept { return a + b; }

  template <class Products>
  struct Asked {
    double a, b;
    QuickTime time;
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

/// An ellipse, which a point meets.
struct QuickEllipse {
  double ux, uy, a, b;

  bool is_usual() const noexcept {
    const double uu = ux * ux + uy * uy;
    return lane::both(
        lane::both(lane::both(is_plain_size(a), is_plain_size(b)), lane::max(a, b) <= 64 * lane::min(a, b)),
        lane::both(lane::both(uu >= 0.25, uu <= 4), lane::both(is_plain(ux), is_plain(uy))));
  }
  double radius() const noexcept { return 2 * (a > b ? a * a / b : b * b / a); }
  double shortest() const noexcept { return lane::min(a, b); }

  template <class Products>
  struct Asked {
    const QuickEllipse& e;
    QuickTime time;
    Twofold<double> reach;

    double best(const Motion& v, double w, double gap) const noexcept { return maximum_of_one(e.curve(v), w, gap); }
    Offset in_frame(const Vector& n) const noexcept {
      const auto u = plain_factor<Products>(e.ux, e.uy);
      const auto along = Products::factor(n);
      return {arithmetic::rounded(dot(u, along)), arithmetic::rounded(cross(u, along))};
    }
    Offset foremost(const Vector& n) const noexcept {
      const Offset of_n = in_frame(n);
      return e.out_of_frame(foremost_of(e.a, e.b, of_n.x, of_n.y));
    }
  };

  VESICA_INLINE Offset out_of_frame(const Offset& at) const noexcept {
    return at.x * Offset{ux, uy} + at.y * Offset{-uy, ux};
  }
  template <class Products>
  VESICA_INLINE Twofold<double> reach(const Motion& v) const noexcept {
    const auto u = plain_factor<Products>(ux, uy), along = plain_factor<Products>(v.vx, v.vy);
    return reach_of<Products>(Products::factor(a) * Products::factor(cross(u, along)),
                              Products::factor(b) * Products::factor(dot(u, along)));
  }

  VESICA_INLINE Curve curve(const Motion& v) const noexcept {
    const double c = ux * v.vx + uy * v.vy, k = ux * v.vy - uy * v.vx, al = (a * k) * (a * k) + (b * c) * (b * c);
    const double area = a * b * (ux * ux + uy * uy) * (v.vx * v.vx + v.vy * v.vy);
    return {((b - a) * (b + a)) * (c * k) / al, al, area * area / al, sqrt(al)};
  }

  /// |(b X, a Y)| = a b u.u with X = u.(D + v t), Y = u x (D + v t), which are off by 2^-100 of the sum of their terms.
  template <class Products>
  VESICA_INLINE Asked<Products> ask(const Vector& d, const Motion& v) const noexcept {
    const auto fa = Products::factor(a), fb = Products::factor(b);
    const auto u = plain_factor<Products>(ux, uy), along = plain_factor<Products>(v.vx, v.vy);
    const auto to = Products::factor(d);
    const Twofold<double> c = dot(u, along), k = cross(u, along);
    const Twofold<double> bx = fb * Products::factor(dot(u, to)), ay = fa * Products::factor(cross(u, to));
    const Twofold<double> bc = fb * Products::factor(c), ak = fa * Products::factor(k);
    const Twofold<double> r = fa * Products::factor(fb * Products::factor(dot(u, u)));
    const Offset way{b * c.high, a * k.high};
    const double first = rough_time({bx.high, ay.high}, way, r.high);
    const auto t = Products::factor(first);
    const Vector at{bx + t * Products::factor(bc), ay + t * Products::factor(ak)};
    const Twofold<double> f =
        (square(Products::factor(at.x)) + square(Products::factor(at.y))) - square(Products::factor(r));
    const double axis = (a + b) * (abs(ux) + abs(uy)), speed = axis * (abs(v.vx) + abs(v.vy));
    const double sizes = r.high + axis * (abs(d.x.high) + abs(d.y.high)) + speed * first;
    QuickTime time =
        stepped(first, at, arithmetic::rounded(f), way, 0x1p-96 * r.high * sizes, 0x1p-48 * r.high * speed);
    time.gx *= b;
    time.gy *= a;
    return {*this, time, reach_of<Products>(fa * Products::factor(k), fb * Products::factor(c))};
  }
};

/// Whether the search for the best direction ends where it begins, at n, whose bits are the normal's. (gx, gy) is the
/// contact's own normal m but for 2^-48 of itself, (p, q) is n in the same frame. Where n turns from m by an angle below
/// z, s is off by z |n|^2 / (v.v), which gains less than 4 H z^2 |n| / (v.v) (bound.hpp), H being the greatest radius of
/// curvature. Here z < 2^-44 and H |n| / (v.v) < 2^13 t, so that the gain is below 2^-72 t. What support_of() may be off by
/// counts less where lengths are below 2^16 of the shortest. What is nearly along a coordinate is left open.
VESICA_INLINE bool ends_at(const Vector& n, const Offset& in_frame, const QuickTime& time, double radius, double vv,
                           double t) noexcept {
  const double x = abs(n.x.high), y = abs(n.y.high), longer = x + y, p = in_frame.x, q = in_frame.y;
  const bool same = abs(time.gx * q - time.gy * p) <= 0x1p-45 * ((abs(time.gx) + abs(time.gy)) * (abs(p) + abs(q)));
  return lane::both(lane::both(same, radius * longer <= 0x1p12 * (vv * t)),
                    lane::both(x > 0x1p-24 * y, y > 0x1p-24 * x));
}

/// direction() of direction.hpp.
template <class Products>
VESICA_INLINE Vector normal_of(double s, const Motion& v) noexcept {
  const auto by = Products::factor(s);
  const Twofold<double> x = by * Products::factor(v.vy), y = by * Products::factor(v.vx);
  return {arithmetic::renormalised(-(x + Twofold<double>{v.vx, 0})),
          arithmetic::renormalised(y - Twofold<double>{v.vy, 0})};
}

VESICA_INLINE Impact<double> round_impact(double t, double cx, double cy, const Offset& at, const Vector& n) noexcept {
  const double x = n.x.high, y = n.y.high, length = sqrt(x * x + y * y);
  return {t, support_minimum::located_coordinate(cx, cx, at.x) + 0.0,
          support_minimum::located_coordinate(cy, cy, at.y) + 0.0, x / length + 0.0, y / length + 0.0};
}

/// Where the offset of centres d meets the sum of round shapes; (cx, cy) is the first's centre.
template <class Products, class Sum>
VESICA_INLINE Quick round_hit(const Sum& sum, const Vector& d, const Motion& v, double cx, double cy,
                              Impact<double>& out) noexcept {
  if (!lane::both(is_plain(d, v), sum.is_usual())) return Quick::open;
  const auto asked = sum.template ask<Products>(d, v);
  double t;
  const Quick quick = floor_of(asked.time.value, asked.time.error, v.end, t);
  if (quick != Quick::hit) return quick;
  const Twofold<double> w = arithmetic::renormalised(cross(plain_factor<Products>(v.vx, v.vy), Products::factor(d)));
  const double gap = gap_of(asked.reach, w);
  const Vector n = normal_of<Products>(asked.best(v, w.high, gap), v);
  const double vv = v.vx * v.vx + v.vy * v.vy, speed = abs(v.vx) + abs(v.vy);
  const double lengths = abs(d.x.high) + abs(d.y.high) + speed * t;
  const bool usual = lane::both(gap >= 0x1p-8 * asked.reach.high, lengths <= 0x1p16 * sum.shortest());
  if (!lane::both(usual, ends_at(n, asked.in_frame(n), asked.time, sum.radius(), vv, t))) return Quick::open;
  out = round_impact(t, cx, cy, asked.foremost(n), n);
  return Quick::hit;
}

template <class Products>
VESICA_INLINE Quick quick_hit(const Circle<double>& a, const Point<double>& b, const Motion& v,
                              Impact<double>& out) noexcept {
  return round_hit<Products>(QuickDisc{a.r}, exact_offset(b.x, b.y, a.cx, a.cy), v, a.cx, a.cy, out);
}
template <class Products>
VESICA_INLINE Quick quick_hit(const Circle<double>& a, const Circle<double>& b, const Motion& v,
                              Impact<double>& out) noexcept {
  return round_hit<Products>(QuickDiscs{a.r, b.r}, exact_offset(b.cx, b.cy, a.cx, a.cy), v, a.cx, a.cy, out);
}
template <class Products>
VESICA_INLINE Quick quick_hit(const Ellipse<double>& a, const Point<double>& b, const Motion& v,
                              Impact<double>& out) noexcept {
  return round_hit<Products>(QuickEllipse{a.ux, a.uy, a.a, a.b}, exact_offset(b.x, b.y, a.cx, a.cy), v, a.cx, a.cy,
                             out);
}

/// Of two ellipses there is no root to go to. T(n) at the n found is a lower bound of the time, and what the slope there,
/// known to e in double, may still gain is as in bound.hpp.
struct QuickSupport {
  Twofold<double> h;
  double beside, bend, error, steepness;
  Offset in_frame;
};
template <class Products>
VESICA_INLINE QuickSupport quick_support(const QuickEllipse& e, const Vector& n, const Motion& v) noexcept {
  const auto u = plain_factor<Products>(e.ux, e.uy);
  const auto along = Products::factor(n);
  const Twofold<double> p = arithmetic::renormalised(dot(u, along)), q = arithmetic::renormalised(cross(u, along));
  const Twofold<double> ap = Products::factor(e.a) * Products::factor(p),
                        bq = Products::factor(e.b) * Products::factor(q);
  const Twofold<double> h = reach_of<Products>(ap, bq);
  const double c = e.ux * v.vx + e.uy * v.vy, k = e.ux * v.vy - e.uy * v.vx, over = 1 / h.high;
  const double vv = v.vx * v.vx + v.vy * v.vy, ratio = (e.a * e.b) * (e.ux * e.ux + e.uy * e.uy) * vv * over;
  const double size = (e.a + e.b) * (abs(e.ux) + abs(e.uy)) * (abs(v.vx) + abs(v.vy));
  return {h,
          (bq.high * (e.b * c) - ap.high * (e.a * k)) * over,
          ratio * ratio * over,
          0x1p-48 * size,
          size * over,
          {p.high, q.high}};
}

template <class Products>
VESICA_INLINE Quick quick_hit(const Ellipse<double>& first, const Ellipse<double>& second, const Motion& v,
                              Impact<double>& out) noexcept {
  const QuickEllipse a{first.ux, first.uy, first.a, first.b}, b{second.ux, second.uy, second.a, second.b};
  const Vector d = exact_offset(second.cx, second.cy, first.cx, first.cy);
  if (!lane::both(is_plain(d, v), lane::both(a.is_usual(), b.is_usual()))) return Quick::open;
  const auto along = plain_factor<Products>(v.vx, v.vy);
  const auto to = Products::factor(d);
  const Twofold<double> w = arithmetic::renormalised(cross(along, to));
  const double gap = gap_of(arithmetic::renormalised(a.reach<Products>(v) + b.reach<Products>(v)), w);
  Curve ca = a.curve(v), cb = b.curve(v);
  ca.s = lane::flip_sign(ca.s, w.high);
  cb.s = lane::flip_sign(cb.s, w.high);
  int steps;
  const Vector n = normal_of<Products>(lane::flip_sign(maximum_of_two(ca, cb, gap, steps), w.high), v);
  const QuickSupport sa = quick_support<Products>(a, n, v), sb = quick_support<Products>(b, n, v);
  const auto nf = Products::factor(n);
  const Twofold<double> room = arithmetic::renormalised(dot(nf, to) - (sa.h + sb.h));
  const Twofold<double> approach = arithmetic::renormalised(-dot(nf, along));
  const double start = room.high / approach.high;
  const Twofold<double> rest = room - Products::factor(start) * Products::factor(approach);
  const double step = arithmetic::rounded(rest) / approach.high;
  const double vv = v.vx * v.vx + v.vy * v.vy, speed = abs(v.vx) + abs(v.vy);
  const double n_size = abs(n.x.high) + abs(n.y.high), error = sa.error + sb.error;
  const double sizes = (abs(d.x.high) + abs(d.y.high)) + speed * abs(start) + 0x1p48 * error / speed;
  const double slope = abs(w.high - (sa.beside + sb.beside)) + error, bend = sa.bend + sb.bend, off = slope / bend;
  const double gain = 2 * slope * (off / vv);
  const double lost = 0x1p-94 * n_size * sizes / approach.high + 0x1p-100 * abs(start);
  const bool ends = lane::both(gain <= 0x1p-74 * start, 64 * off * lane::max(sa.steepness, sb.steepness) < 1);
  if (!lane::both(ends, sizes * (0x1p-40 * n_size) < sa.h.high + sb.h.high)) return Quick::open;
  double t;
  const Quick quick = floor_of({start, step}, lost + gain, v.end, t);
  if (quick != Quick::hit) return quick;
  out = round_impact(t, first.cx, first.cy, a.out_of_frame(foremost_of(a.a, a.b, sa.in_frame.x, sa.in_frame.y)), n);
  return Quick::hit;
}

}  // namespace vesica::detail::cast

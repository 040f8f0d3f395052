// SPDX-License-Identifier: Apache-2.0
/// The contact of what quick.hpp holds for a hit. Points and normals are made of the operations of first_contact.hpp, in
/// a scene that needs no scaling. The time is the floor of a number that is known to twice the precision, by whatever
/// way: of boxes T(n); of round shapes one step of Newton's method for f(t) = 0, f being convex along the ray.
#pragma once

#include <vesica/cast/quick.hpp>

namespace vesica::detail::cast {

/// A time, the bound of its error, and of a round shape how f grows there, in its frame: the contact's own normal.
struct QuickTime {
  Twofold<double> value;
  double error, gx, gy;
};

/// Whether a number is 0 or moderate: products with it are exact to all digits that count.
VESICA_INLINE bool is_plain(double x) noexcept {
  return lane::either(x == 0, lane::both(abs(x) >= least_moderate, abs(x) <= most_moderate));
}

/// The floor of a time, which is before the end.
VESICA_INLINE Quick floor_of(const Twofold<double>& time, double error, double end, double& t) noexcept {
  const Twofold<double> x = arithmetic::renormalised(time);
  if (!(error < 0x1p-56 * x.high && abs(x.low) > error && x.high <= 0x1p100)) return Quick::open;
  t = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x.high) - static_cast<std::uint64_t>(x.low < 0));
  return t < end ? Quick::hit : t > end ? Quick::missed : Quick::open;
}

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

/// Offsets of centres, exact where they are stored.
VESICA_INLINE Vector exact_offset(double x, double y, double cx, double cy) noexcept {
  return {nearest::exact_difference(x, cx), nearest::exact_difference(y, cy)};
}
VESICA_INLINE Vector exact_offset(const Point<double>& p, const form::Corners<double>& place) noexcept {
  const form::Corners<double> to{p.x, p.y, p.x, p.y};
  const auto x = form::twice_offset_x(place, to, 1), y = form::twice_offset_y(place, to, 1);
  return {{0.5 * x.high, 0.5 * x.low}, {0.5 * y.high, 0.5 * y.low}};
}

/// An axis or a velocity, of which nothing was rounded, as factors.
template <class Products>
VESICA_INLINE auto plain_factor(double x, double y) noexcept {
  return arithmetic::VectorFactor<decltype(Products::factor(x))>{Products::factor(x), Products::factor(y)};
}

/// All numbers of a pair that are multiplied are 0 or moderate, and a length is.
VESICA_INLINE bool is_plain(const Vector& d, const Motion& v) noexcept {
  const double far = abs(d.x.high) + abs(d.y.high);
  return lane::both(
      lane::both(lane::both(is_plain(d.x.high), is_plain(d.y.high)), lane::both(is_plain(v.vx), is_plain(v.vy))),
      lane::both(far >= 0x1p-40, far <= 0x1p40));
}
VESICA_INLINE bool is_plain_size(double x) noexcept { return lane::both(x >= 0x1p-40, x <= 0x1p40); }

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
/// counts less where lengths are below 2^16 of the shortest. Nor may n be along a coordinate: there a point is taken to have
/// faces.
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

/// Where a ray meets the face at height `height` along n, which is against v, after the time t: `half` is half of the
/// face.
struct QuickFace {
  Offset normal, middle, half;
};
VESICA_INLINE Impact<double> impact_on(const QuickFace& face, const form::Corners<double>& place, const Vector& d,
                                       const Motion& v, double t) noexcept {
  const Offset offset{d.x.high + t * v.vx, d.y.high + t * v.vy};
  const Offset at = touching_point({face.middle, face.half}, {{0, 0}, {0, 0}}, offset);
  return {t, support_minimum::located_coordinate(place.x0, place.x1, at.x) + 0.0,
          support_minimum::located_coordinate(place.y0, place.y1, at.y) + 0.0, face.normal.x + 0.0,
          face.normal.y + 0.0};
}

/// The point's coordinate, the box's on the side from which the ray comes, and the time at which they agree.
struct QuickSide {
  Twofold<double> way;
  double t;
};
VESICA_INLINE QuickSide quick_side(double from, double low, double high, double v) noexcept {
  const Twofold<double> way = nearest::exact_difference(lane::select(v > 0, low, high), from);
  return {way, way.high / v};
}

/// Of an AABB: the times are quotients of exact numbers, of which that is met is the later one. Its remainder is exact, so
/// that a time which is a double shows.
template <class Products>
VESICA_INLINE Quick quick_hit(const Aabb<double>& a, const Point<double>& b, const Motion& v,
                              Impact<double>& out) noexcept {
  const QuickSide x = quick_side(b.x, a.min_x, a.max_x, v.vx), y = quick_side(b.y, a.min_y, a.max_y, v.vy);
  const double width = a.max_x - a.min_x, height = a.max_y - a.min_y;
  // A ray along a side is between those sides all the time.
  const double tx = lane::select(v.vx == 0, -1.0, x.t), ty = lane::select(v.vy == 0, -1.0, y.t);
  const bool on_x = tx > ty;
  const double first = lane::max(tx, ty), speed = lane::select(on_x, v.vx, v.vy);
  const Twofold<double> way{lane::select(on_x, x.way.high, y.way.high), lane::select(on_x, x.way.low, y.way.low)};
  const form::Corners<double> from = form::corners(form::of(a).place);
  const Vector d = exact_offset(b, from);
  const bool plain = lane::both(is_plain(d, v), lane::both(is_plain_size(width), is_plain_size(height)));
  const bool sure = lane::both(first > 0x1p-40, abs(tx - ty) > 0x1p-48 * (abs(tx) + abs(ty)));
  if (!lane::both(lane::both(plain, sure), lane::both(is_plain(speed), first <= 0x1p60))) return Quick::open;
  const Twofold<double> product = Products::factor(first) * Products::factor(speed);
  const double rest = ((way.high - product.high) - product.low) + way.low, step = rest / speed;
  double t = first;
  const Quick quick =
      rest == 0 ? first <= v.end ? Quick::hit : Quick::missed : floor_of({first, step}, 0x1p-50 * abs(step), v.end, t);
  if (quick != Quick::hit) return quick;
  const double side = lane::select(speed > 0, -1.0, 1.0);
  const QuickFace face{{lane::select(on_x, side, 0.0), lane::select(on_x, 0.0, side)},
                       {lane::select(on_x, side * (width * 0.5), 0.0), lane::select(on_x, 0.0, side * (height * 0.5))},
                       {lane::select(on_x, 0.0, width * 0.5), lane::select(on_x, height * 0.5, 0.0)}};
  out = impact_on(face, from, d, v, t);
  return Quick::hit;
}

/// Of a box about its centre with the axes u and perp(u): the ray enters both slabs, |x.n| <= h u.u, at times that double
/// tells, but for 16u of the sum of terms over |n.v|, where n.v is known to be above its own rounding. The later is told
/// in twofolds. A slab along the ray holds it all the time, as the filter has told.
template <class Products>
VESICA_INLINE Quick box_hit(const Vector& u, double hx, double hy, const form::Corners<double>& place, const Vector& d,
                            const Motion& v, Impact<double>& out) noexcept {
  const double ux = u.x.high, uy = u.y.high, uu = ux * ux + uy * uy, speed = abs(v.vx) + abs(v.vy);
  const double c = ux * v.vx + uy * v.vy, k = ux * v.vy - uy * v.vx;
  const double x = ux * d.x.high + uy * d.y.high, y = ux * d.y.high - uy * d.x.high;
  const bool along_x = lane::both(lane::either(ux == 0, v.vx == 0), lane::either(uy == 0, v.vy == 0));
  const bool along_y = lane::both(lane::either(ux == 0, v.vy == 0), lane::either(uy == 0, v.vx == 0));
  const double tx = lane::select(along_x, -1.0, (-x - lane::flip_sign(hx * uu, c)) / c);
  const double ty = lane::select(along_y, -1.0, (-y - lane::flip_sign(hy * uu, k)) / k);
  const double axis = abs(ux) + abs(uy), size = axis * (abs(d.x.high) + abs(d.y.high)) + (hx + hy) * (axis * axis);
  const auto error = [&](double t, double approach) {
    return 0x1p-48 * (size + axis * (speed * abs(t))) / abs(approach);
  };
  const double x_error = lane::select(along_x, 0.0, error(tx, c)), y_error = lane::select(along_y, 0.0, error(ty, k));
  const double least = 0x1p-40 * (axis * speed);
  const bool crosses = lane::both(lane::either(along_x, abs(c) > least), lane::either(along_y, abs(k) > least));
  const bool on_x = tx > ty;
  const double half = lane::select(on_x, hy, hx), h = lane::select(on_x, hx, hy);
  const bool plain =
      lane::both(lane::both(is_plain(d, v), is_plain_size(axis)),
                 lane::both(lane::both(is_plain(ux), is_plain(uy)), lane::both(is_plain(h), is_plain_size(half))));
  if (!lane::both(lane::both(plain, crosses), abs(tx - ty) > x_error + y_error)) return Quick::open;
  const double turn = lane::select(lane::select(on_x, c, k) > 0, -1.0, 1.0);
  const auto across = [&](double along, double beside) { return turn * lane::select(on_x, along, beside); };
  const Vector n{{across(ux, -uy), across(u.x.low, -u.y.low)}, {across(uy, ux), across(u.y.low, u.x.low)}};
  const auto nf = Products::factor(n);
  const Twofold<double> reach = Products::factor(h) * Products::factor(arithmetic::renormalised(dot(nf, nf)));
  const Twofold<double> room = arithmetic::renormalised(dot(nf, Products::factor(d)) - reach);
  const Twofold<double> approach = arithmetic::renormalised(-dot(nf, Products::factor(Vector{{v.vx, 0}, {v.vy, 0}})));
  const double first = room.high / approach.high;
  const Twofold<double> rest = room - Products::factor(first) * Products::factor(approach);
  const double step = arithmetic::rounded(rest) / approach.high;
  const double off = 0x1p-96 * (size + axis * (speed * abs(first))) / approach.high + 0x1p-100 * abs(first);
  double t;
  const Quick quick = floor_of({first, step}, off, v.end, t);
  if (quick != Quick::hit) return quick;
  const double nx = n.x.high, ny = n.y.high, length = sqrt(nx * nx + ny * ny);
  out = impact_on({{nx / length, ny / length}, {h * nx, h * ny}, {half * -ny, half * nx}}, place, d, v, t);
  return Quick::hit;
}

template <class Products>
VESICA_INLINE Quick quick_hit(const Rect<double>& a, const Point<double>& b, const Motion& v,
                              Impact<double>& out) noexcept {
  return box_hit<Products>(Vector{{a.ux, 0}, {a.uy, 0}}, a.hx, a.hy, form::corners(form::of(a).place),
                           exact_offset(b.x, b.y, a.cx, a.cy), v, out);
}
template <class Products>
VESICA_INLINE Quick quick_hit(const Segment<double>& a, const Point<double>& b, const Motion& v,
                              Impact<double>& out) noexcept {
  const form::Corners<double> place = form::corners(form::of(a).place);
  return box_hit<Products>(exact_offset(a.x1, a.y1, a.x0, a.y0), 0.5, 0, place, exact_offset(b, place), v, out);
}

/// The products that a program without the library has.
#if defined(VESICA_HAS_FUSED)
using UsualProducts = FusedProducts;
#else
using UsualProducts = SplitProducts;
#endif

/// The answer about two shapes whose kinds are known: by hit(a, b), a quick_hit() for a motion that is sound, or by
/// rest(known) from what a filter knows.
template <class A, class B, class Hit, class Rest>
VESICA_INLINE std::int32_t cast_pair(const A& a, const B& b, const Motion& motion, const Hit& hit,
                                     const Rest& rest) noexcept {
  if constexpr (HasQuick<A, B>) {
    Quick quick = quick_filter(a, b, motion);
    if (quick == Quick::missed) return cast_miss;
    if (quick == Quick::hit) quick = hit(a, b);
    if (quick != Quick::open) return quick == Quick::hit ? cast_hit : cast_miss;
  }
  return rest(filter(sketch(a), sketch(b), motion));
}

}  // namespace vesica::detail::cast

// SPDX-License-Identifier: Apache-2.0
/// The time of first contact t0 between bounds. For a direction n with n.v < 0 the shapes are separated along n until
///
///     T(n) = (n.D - h(n)) / -(n.v),    h = h_a + h_b the support function of M
///
/// so T(n) is a lower bound of t0, and t0 is the greatest of them.
///
/// Proved: how far T(n) may be below t0, from numbers that are known at n. So a direction found in double bounds t0 to
/// twice the precision of double, wherever the search for it stopped. With n = -v + s perp(v) the slope of v.v T(n) in
/// s is w - perp(v).x, x being the point of M farthest along n: how far beside x the line passes. It falls with s.
///
///   - If n is the normal of an edge of M, x may be any point of it. If one of them lies on the line, T(n) = t0.
///   - Else the slope falls by bend = sum of (a b u.u v.v)^2 / h_i^3 over the ellipses. Let d = |slope| / bend be below
///     h_i / (8 r_i) for each, r_i being the reach across v. No h_i changes by more than a quarter within 2d, for
///     |h_i'| <= r_i. So bend stays above its half there. If besides no vertex gives way to another, the greatest T
///     lies within 2d, and t0 <= T(n) + slope^2 / (bend v.v).
#pragma once

#include <bit>
#include <cstdint>
#include <vesica/arithmetic/products.hpp>
#include <vesica/cast/body.hpp>
#include <vesica/nearest/scaled_pair.hpp>

namespace vesica::detail::cast {

using nearest::all;
using nearest::MaskOf;
using nearest::Twofold;
using Vector = arithmetic::Vector<double>;
using arithmetic::FusedProducts;
using arithmetic::SplitProducts;

/// Factors of products: SplitProducts or FusedProducts.
template <class Products>
using TwofoldFactor = decltype(Products::factor(Twofold<double>{}));
template <class Products>
using VectorFactor = arithmetic::VectorFactor<TwofoldFactor<Products>>;

/// A shape of a pair at the common scale; a circle is an ellipse with an axis of length 1.
struct Side {
  Vector u;
  Twofold<double> hx, hy;
  bool round;
};

/// A pair and its motion in a common unit of length 2^length and of time 2^time. The largest length, and the longer
/// component of each axis and of v, are about 1. `faithful`: scaling has lost nothing above 2^-900. `exact_axes`: it
/// has lost nothing at all of the axes and of v.
struct Scene {
  Side a, b;
  Twofold<double> radius;  // of both shapes
  Vector d;
  double vx, vy, size;
  int length, time;
  bool faithful, exact_axes;

  double speed() const noexcept { return abs(vx) + abs(vy); }
  bool has_radius() const noexcept { return radius.high > 0; }
  /// The disc that the radii add to both shapes.
  Side disc() const noexcept { return {{{1, 0}, {0, 0}}, radius, radius, true}; }
};

/// True if FusedProducts give the bits of SplitProducts: all numbers of the scene are 0 or in [2^-40, 2^40], lower
/// parts 0 or above 2^-60.
///
/// Proved: no product is above 0 and below 2^-960, so no error of a product underflows. s is a multiple of 2^-102
/// (FusedProducts::holds()), so n = -v + s perp(v) is one of 2^-194. The longest products are squares of a size times
/// u.n, multiples of 2^-836. What is divided by the root of one is at most 2^136.
inline bool has_fused_products(const Scene& s) noexcept {
  std::uint64_t out = 0;
  // By bits, without branches: ordinary casts ask this too.
  const auto look = [&out](double x, double least) {
    const std::uint64_t size = std::bit_cast<std::uint64_t>(abs(x)), from = std::bit_cast<std::uint64_t>(least);
    out |= static_cast<std::uint64_t>(size - from > std::bit_cast<std::uint64_t>(0x1p40) - from) &
           static_cast<std::uint64_t>(size != 0);
  };
  const auto look_at = [&look](const Twofold<double>& x) {
    look(x.high, 0x1p-40);
    look(x.low, 0x1p-60);
  };
  for (const Side* side : {&s.a, &s.b}) {
    look_at(side->u.x);
    look_at(side->u.y);
    look_at(side->hx);
    look_at(side->hy);
  }
  look_at(s.d.x);
  look_at(s.d.y);
  if (s.has_radius()) look_at(s.radius);
  look(s.vx, 0x1p-40);
  look(s.vy, 0x1p-40);
  return out == 0;
}

inline nearest::UnscaledShape form_times(const Body& body, double k) noexcept {
  auto f = with_shape(body, [k](const auto& s) { return nearest::form_times(s, k); });
  if (body.radius > 0) f.radius = k * body.radius;
  return f;
}

/// A circle smaller than this share of the pair is taken for a point: the product of four of its radii would vanish.
inline constexpr double smallest_circle = 0x1p-240;

inline Side side(const nearest::Box<double>& box, bool round) noexcept { return {box.u, box.hx, box.hy, round}; }
inline Side side(const nearest::ScaledShape& p) noexcept {
  if (p.radius > 0) {
    const double r = p.radius >= smallest_circle ? p.radius : 0;
    return {{{1, 0}, {0, 0}}, {r, 0}, {r, 0}, r > 0};
  }
  return side(p.box, p.curved);
}

/// An ellipse smaller than 2^-120 of the pair is taken for a point, a thin one for a segment (nearest/scaled_pair.hpp).
/// The squares of a circle must not underflow either.
inline bool is_faithful(const nearest::UnscaledShape& f, const nearest::ScaledShape& p) noexcept {
  return f.curved == p.curved && (f.radius == 0 || p.radius >= nearest::smallest);
}

VESICA_COLD inline Scene scaled_scene(const Body& a, const Body& b, const Motion& motion) noexcept {
  nearest::UnscaledShape fa = form_times(a, 1), fb = form_times(b, 1);
  int eighths = 0;
  if (overflowed(fa, fb)) {
    fa = form_times(a, 0.125), fb = form_times(b, 0.125);
    eighths = 3;
  }
  const nearest::ScaledPair p = nearest::scaled_pair(fa, fb);
  const int speed = form::axis_exponent(motion.vx, motion.vy), length = p.exponent + eighths;
  const double vx = arithmetic::scale_far(motion.vx, -speed), vy = arithmetic::scale_far(motion.vy, -speed);
  const bool faithful = is_faithful(fa, p.a) && is_faithful(fb, p.b) && eighths == 0;
  const auto kept = [](double x, double in_unit) { return (x == 0) == (in_unit == 0); };
  const auto axis_kept = [&](const nearest::UnscaledShape& f, const nearest::ScaledShape& s) {
    const Vector &from = f.box.u, &to = s.box.u;
    return kept(from.x.high, to.x.high) && kept(from.y.high, to.y.high) && kept(from.x.low, to.x.low) &&
           kept(from.y.low, to.y.low);
  };
  const bool exact_axes = kept(motion.vx, vx) && kept(motion.vy, vy) && axis_kept(fa, p.a) && axis_kept(fb, p.b);
  Scene s{side(p.a), side(p.b), {0, 0}, p.d, vx, vy, p.size, length, length - speed, faithful, exact_axes};
  if (a.radius > 0 || b.radius > 0) {
    const double radius = p.a.radius + p.b.radius;
    if (radius >= smallest_circle) s.radius = arithmetic::exact_sum(p.a.radius, p.b.radius);
    s.a = side(p.a.box, p.a.curved);
    s.b = side(p.b.box, p.b.curved);
  }
  return s;
}

inline Side side(const nearest::UnscaledShape& f) noexcept {
  if (f.radius > 0) return {{{1, 0}, {0, 0}}, {f.radius, 0}, {f.radius, 0}, true};
  return side(f.box, f.curved);
}

/// Numbers whose products of up to twelve neither overflow nor underflow, and sizes that are not too unlike for that.
inline constexpr double least_moderate = 0x1p-60, most_moderate = 0x1p60;
inline bool is_moderate(double x) noexcept { return x >= least_moderate && x <= most_moderate; }
inline bool is_moderate(const Side& s) noexcept {
  const double a = s.hx.high, b = s.hy.high, longer = lane::max(a, b), shorter = lane::min(a, b);
  const bool sizes = longer <= most_moderate && (shorter == 0 || shorter >= least_moderate) &&
                     (longer == 0 || longer >= least_moderate) && (!s.round || shorter > nearest::thinnest * longer);
  return sizes && is_moderate(abs(s.u.x.high) + abs(s.u.y.high));
}
inline double reach(const Side& s) noexcept { return (s.hx.high + s.hy.high) * (abs(s.u.x.high) + abs(s.u.y.high)); }

/// As they are, where all numbers are moderate. All that is computed of a scene is the same then, times powers of two.
/// Written number by number: a structure that is copied right after waits until its parts have reached the memory.
inline void set_scene(const Body& a, const Body& b, const Motion& motion, Scene& s) noexcept {
  const auto place = [](const Body& body, Side& side) {
    return with_shape(body, [&side](const auto& shape) {
      side = cast::side(nearest::form_times(shape, 1));
      return form::corners(form::of(shape).place);
    });
  };
  const form::Corners<double> pa = place(a, s.a), pb = place(b, s.b);
  const auto x = form::twice_offset_x(pa, pb, 1), y = form::twice_offset_y(pa, pb, 1);
  s.radius = arithmetic::exact_sum(a.radius, b.radius);
  s.d = {{0.5 * x.high, 0.5 * x.low}, {0.5 * y.high, 0.5 * y.low}};
  s.vx = motion.vx;
  s.vy = motion.vy;
  s.length = s.time = 0;
  s.faithful = s.exact_axes = true;
  const double distance = abs(x.high) + abs(y.high);
  s.size = distance + (reach(s.a) + reach(s.b)) + 2 * s.radius.high;
  const bool moderate = is_moderate(s.a) && is_moderate(s.b) && (!s.has_radius() || is_moderate(s.radius.high)) &&
                        is_moderate(s.speed()) && is_moderate(distance);
  if (!moderate) s = scaled_scene(a, b, motion);
}

/// t0 is at least `value` - `error`, and if that is certain, at most `value` + `error` + `gain`. To within rounding, s
/// should change by `step`. An error of 0: the direction is across v, certainly or nearly, and gives no bound.
struct TimeBounds {
  Twofold<double> value;
  double error, gain, step;
  bool certain;

  bool is_known() const noexcept { return error > 0; }
};

template <class V>
VESICA_INLINE Twofold<V> magnitude(const Twofold<V>& x) noexcept {
  return flipped(x, x.high);
}
template <class V>
VESICA_INLINE MaskOf<V> is_zero(const Twofold<V>& x) noexcept {
  return both(x.high == V(0.0), x.low == V(0.0));
}

/// The terms of one shape: its support function and perp(v).x. `edge` is the reach across v of an edge whose normal n
/// is, x its middle, and `room` the least |u.n| of the edges beside its vertex, in units of the change of u.n with s.
struct SideSupport {
  Twofold<double> h, beside;
  double edge, bend, steepness, error, room;
};

inline bool has_no_size(const Side& s) noexcept { return s.hx.high == 0 && s.hy.high == 0; }

inline Vector perpendicular(const Vector& u) noexcept { return {-u.y, u.x}; }
inline Vector opposite(const Vector& u) noexcept { return {-u.x, -u.y}; }

/// u.n and u x n. The axis of circles and points is (1, 0), for which these are n itself, to the bit.
struct DotAndCross {
  Twofold<double> dot, cross;
};
template <class Products>
DotAndCross dot_and_cross(const Vector& u, const VectorFactor<Products>& n) noexcept {
  if (u.x.high == 1 && u.y.high == 0 && u.x.low == 0 && u.y.low == 0) {
    return {{n.x.high, n.x.low}, {n.y.high, n.y.low}};
  }
  const auto f = Products::factor(u);
  return {arithmetic::dot(f, n), arithmetic::cross(f, n)};
}

/// The support function of a box.
template <class Products>
Twofold<double> height_of(const Side& s, const VectorFactor<Products>& n) noexcept {
  if (has_no_size(s)) return {0, 0};
  const DotAndCross of_n = dot_and_cross<Products>(s.u, n);
  const Twofold<double> p = Products::factor(s.hx) * Products::factor(renormalised(of_n.dot));
  const Twofold<double> q = Products::factor(s.hy) * Products::factor(renormalised(of_n.cross));
  return magnitude(p) + magnitude(q);
}

/// Right to 2^-99 of |n| size, and `beside` to `error`.
template <class Products>
SideSupport support_of(const Side& s, const VectorFactor<Products>& n, const VectorFactor<Products>& v,
                       double n_size) noexcept {
  if (has_no_size(s)) return {{0, 0}, {0, 0}, 0, 0, 0, 0, 0x1p1000};
  const auto hx = Products::factor(s.hx), hy = Products::factor(s.hy);
  // u.n and u x n; u.perp(v) = -(u x v), and perp(u).perp(v) = u.v.
  const DotAndCross of_n = dot_and_cross<Products>(s.u, n), of_v = dot_and_cross<Products>(s.u, v);
  const Twofold<double> p = renormalised(of_n.dot), q = renormalised(of_n.cross), k = -of_v.cross, c = of_v.dot;
  const Twofold<double> hp = hx * Products::factor(p), hq = hy * Products::factor(q), hk = hx * Products::factor(k),
                        hc = hy * Products::factor(c);
  const double size = reach(s), speed = abs(v.x.high) + abs(v.y.high);
  if (!s.round) {
    // cross(u, n) = perp(u).n
    SideSupport out{magnitude(hp) + magnitude(hq), {0, 0}, 0, 0, 0, 0x1p-96 * size * speed, 0x1p1000};
    const auto add = [&](const Twofold<double>& towards, const Twofold<double>& half, const Twofold<double>& change) {
      if (is_zero(half)) return;
      if (is_zero(towards)) {
        out.edge += abs(half.high);
      } else {
        out.beside = out.beside + flipped(half, towards.high);
        const double room = abs(towards.high) / abs(change.high);
        if (room < out.room) out.room = room;
      }
    };
    add(p, hk, k);
    add(q, hc, c);
    return out;
  }
  const Twofold<double> h =
      renormalised(Products::root(square(Products::factor(hp)) + square(Products::factor(hq))).value);
  const Twofold<double> over_h = Products::inverse(h);
  const Twofold<double> beside =
      Products::factor(Products::factor(hp) * Products::factor(hk) + Products::factor(hq) * Products::factor(hc)) *
      Products::factor(over_h);
  const double area = (s.hx.high * s.hy.high) * (s.u.x.high * s.u.x.high + s.u.y.high * s.u.y.high);
  const double vv = v.x.high * v.x.high + v.y.high * v.y.high, ratio = area * vv * over_h.high;
  const double across = sqrt(hk.high * hk.high + hc.high * hc.high);
  const double thin = size * n_size * over_h.high;
  return {h,       beside, 0, ratio * ratio * over_h.high, across * over_h.high, 0x1p-96 * size * speed * (1 + thin),
          0x1p1000};
}

/// support_of() both shapes, the radii with the first.
template <class Products>
void supports_of(const Scene& scene, const VectorFactor<Products>& n, const VectorFactor<Products>& v, double n_size,
                 SideSupport& a, SideSupport& b) noexcept {
  a = support_of<Products>(scene.a, n, v, n_size);
  b = support_of<Products>(scene.b, n, v, n_size);
  if (!scene.has_radius()) return;
  const SideSupport disc = support_of<Products>(scene.disc(), n, v, n_size);
  a = {a.h + disc.h,
       a.beside + disc.beside,
       a.edge,
       a.bend + disc.bend,
       lane::max(a.steepness, disc.steepness),
       a.error + disc.error,
       a.room};
}

inline bool finite(double x) noexcept { return x - x == 0; }

/// True if n.v = 0 exactly: the products are exact, and one is the negative of the other. A twofold sum does not show
/// it, as it may lose a rest below 2^-106 of its terms. False for an n with lower parts.
template <class Products>
bool is_across(const VectorFactor<Products>& n, const VectorFactor<Products>& v) noexcept {
  const auto product = [](double x, double y, Twofold<double>& out) {
    out = Products::factor(x) * Products::factor(y);
    return x == 0 || y == 0 || abs(out.high) >= 0x1p-960;
  };
  Twofold<double> x, y;
  return n.x.low == 0 && n.y.low == 0 && product(n.x.high, v.x.high, x) && product(n.y.high, v.y.high, y) &&
         x.high == -y.high && x.low == -y.low;
}

/// T(n) from the support function of both shapes. `certain`, across v: that n gives no bound.
template <class Products>
TimeBounds lower_bound(const Scene& scene, const VectorFactor<Products>& n, const VectorFactor<Products>& v,
                       const Twofold<double>& height) noexcept {
  const double n_size = abs(n.x.high) + abs(n.y.high), speed = scene.speed(), unit = 0x1p-97 * n_size;
  const Twofold<double> room = renormalised(dot(n, Products::factor(scene.d)) - height),
                        approach = renormalised(-dot(n, v));
  TimeBounds out{{0, 0}, 0, 0, 0, false};
  if (!(approach.high > 0x1p-80 * n_size * speed)) {
    out.certain = scene.exact_axes && is_across<Products>(n, v);
    return out;
  }
  const double first = room.high / approach.high;
  const Twofold<double> rest = room - Products::factor(first) * Products::factor(approach);
  out.value = {first, arithmetic::rounded(rest) / approach.high};
  out.error = 2 * (unit * scene.size + unit * speed * abs(first)) / approach.high + 0x1p-100 * abs(first) + 0x1p-800;
  return out;
}

template <class Products>
VectorFactor<Products> factor_of_v(const Scene& scene) noexcept {
  return Products::factor(Vector{{scene.vx, 0}, {scene.vy, 0}});
}

/// The bounds of t0 from n. n: -v + s perp(v), or any multiple where it is the normal of an edge.
template <class Products>
TimeBounds time_bounds(const Scene& scene, const Vector& normal) noexcept {
  const auto n = Products::factor(normal), v = factor_of_v<Products>(scene);
  const double n_size = abs(n.x.high) + abs(n.y.high);
  SideSupport a, b;
  supports_of<Products>(scene, n, v, n_size, a, b);
  TimeBounds out = lower_bound<Products>(scene, n, v, a.h + b.h);
  if (!out.is_known()) return out;
  out.certain = false;
  const Twofold<double> w = cross(v, Products::factor(scene.d));
  const double beside = arithmetic::rounded(w - (a.beside + b.beside)), speed = scene.speed();
  const double slope = abs(beside) + a.error + b.error + 0x1p-96 * speed * scene.size, edge = a.edge + b.edge;
  if (edge > 0) {
    out.certain = slope < edge * (1 - 0x1p-40);
    return out;
  }
  const double vv = scene.vx * scene.vx + scene.vy * scene.vy, bend = a.bend + b.bend, distance = slope / bend;
  const double steepness = lane::max(a.steepness, b.steepness), room_for_step = lane::min(a.room, b.room);
  out.step = beside / bend;
  out.gain = 2 * slope * (distance / vv);
  out.certain = bend > 0 && 8 * distance * steepness < 1 && 3 * distance < room_for_step && finite(out.gain);
  return out;
}

}  // namespace vesica::detail::cast

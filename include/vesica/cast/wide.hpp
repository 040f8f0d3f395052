// SPDX-License-Identifier: Apache-2.0
/// The time of first contact where numbers are of unlike exponents: to about 100 bits, by numbers of any exponent with
/// a bound on their error (crossings/rough.hpp), and from exact polynomials where terms cancel. Of two boxes, and of a
/// box and a round shape; for two ellipses see ellipse_trials.hpp.
///
/// t0 is the greatest T(n) (bound.hpp), for a line that enters M after the start and does not graze.
///
///   - Two boxes: of the T(n) of the edges' normals, since M is bounded by their lines.
///   - A box and an ellipse: g(s) (direction.hpp) is concave. At a box's kink its slope, but for the jump of 2p there,
///     is `base`; the greatest g is at the kink if |base| <= p, behind it if base > p, before it if base < -p. At a
///     kink n is normal to a face, and t0 = T(n). Between kinks it is a corner of the box that meets the ellipse. With
///     D' the offset of that corner from the ellipse's centre, and c, k, X, Y the dot and cross products of the
///     ellipse's axis u with v and with D', contact is at the lesser root of al t^2 - 2 B t + C, al = (b c)^2 + (a
///     k)^2, B = -(b^2 c X + a^2 k Y), C = (b X)^2 + (a Y)^2 - (a b u.u)^2. As c Y - k X = u.u (v x D'), the
///     discriminant is (a b u.u)^2 (al - (v x D')^2). C > 0 before contact, so t0 = C / (B + its root), in which
///     nothing cancels.
#pragma once

#include <vesica/arithmetic/rounding.hpp>
#include <vesica/cast/exact.hpp>
#include <vesica/crossings/rough.hpp>

namespace vesica::detail::cast {

/// A time, and whether it is t0 to its error. That may leave open what is asked.
struct WideTime {
  Rough time;
  bool certain = false;

  /// t0 to a few digits more than a double has. It is above 0, and so is what is precise.
  bool tells() const noexcept { return certain && time.is_precise(); }
};

/// The doubles between which a time is.
struct Between {
  double least, most;
};
inline Between between(const Rough& t) noexcept {
  const double value = rounded(t.value), error = 1.01 * t.error + 0x1p-52 * std::fabs(value);
  return {arithmetic::scale_far(value - error, t.exponent) * (1 - 0x1p-52),
          arithmetic::scale_far(value + error, t.exponent) * (1 + 0x1p-52) + std::numeric_limits<double>::denorm_min()};
}

/// x - sqrt(y) for exact numbers, without cancellation; false unless it is positive.
inline bool less_root(const Number<3>& x, const Number<6>& y, Rough& out) noexcept {
  if (x.sign <= 0) return false;
  const Number<6> rest = exact::square(x) - y;
  if (rest.sign <= 0) return false;
  out = y.sign == 0 ? Rough(x) : Rough(rest) / (Rough(x) + root(Rough(y)));
  return true;
}

/// The axes of a box as seen along v: c = u.v, k = u x v.
struct SeenBox {
  const exact::Box& box;
  Number<2> c, k;
  SeenBox(const ExactBody& body, const Number<1>& vx, const Number<1>& vy) noexcept
      : box(body.box), c(exact::dot(box.ux, box.uy, vx, vy)), k(exact::cross(box.ux, box.uy, vx, vy)) {}
};

/// The offset of centres and the velocity.
struct Passage {
  const Number<1>&dx, &dy, &vx, &vy;
};

/// T(n) for the two normals of a box, where that is positive.
inline void latest_of_axes(const SeenBox& seen, const exact::Box& other, const Passage& p, WideTime& latest) noexcept {
  const exact::Box& e = seen.box;
  const auto uu = exact::dot(e.ux, e.uy, e.ux, e.uy);
  const auto c = exact::abs(exact::dot(e.ux, e.uy, other.ux, other.uy));
  const auto s = exact::abs(exact::cross(e.ux, e.uy, other.ux, other.uy));
  const auto look = [&](const Number<2>& along_v, const Number<2>& along_d, const Number<3>& height) {
    if (along_v.sign * along_d.sign >= 0) return;
    const Number<3> gap = exact::abs(along_d) - height;
    if (gap.sign <= 0) return;
    const Rough time = Rough(gap) / Rough(exact::abs(along_v));
    const bool later = !latest.certain || rounded((time - latest.time).value) > 0;
    if (later) latest = {time, true};
  };
  look(seen.c, exact::dot(e.ux, e.uy, p.dx, p.dy), e.hx * uu + other.hx * c + other.hy * s);
  look(seen.k, exact::cross(e.ux, e.uy, p.dx, p.dy), e.hy * uu + other.hx * s + other.hy * c);
}

/// An ellipse about the origin, and what passes it.
struct SeenEllipse {
  const exact::Box& e;
  const ExactReach& reach;
  const Passage& passage;
  Number<2> c, k;

  SeenEllipse(const ExactBody& body, const ExactReach& r, const Passage& p) noexcept
      : e(body.box),
        reach(r),
        passage(p),
        c(exact::dot(e.ux, e.uy, p.vx, p.vy)),
        k(exact::cross(e.ux, e.uy, p.vx, p.vy)) {}

  /// How far it reaches along n, squared, and perp(v).x times that reach, x being its point farthest along n.
  struct Support {
    Number<6> squared, beside;
  };
  Support support(const Number<1>& nx, const Number<1>& ny) const noexcept {
    const Number<3> p = e.hx * exact::dot(e.ux, e.uy, nx, ny), q = e.hy * exact::cross(e.ux, e.uy, nx, ny);
    // u.perp(v) = -(u x v), u x perp(v) = u.v.
    return {exact::square(p) + exact::square(q), q * (e.hy * c) - p * (e.hx * k)};
  }

  /// When a corner at this offset meets it.
  WideTime meets_corner(const Number<2>& x, const Number<2>& y) const noexcept {
    const Number<3> w = passage.vx * y - passage.vy * x;
    const Number<6> rest = reach.squared - exact::square(w);
    const Number<4> along = e.hy * exact::dot(e.ux, e.uy, x, y), across = e.hx * exact::cross(e.ux, e.uy, x, y);
    const Number<4> area = e.hx * e.hy * exact::dot(e.ux, e.uy, e.ux, e.uy);
    const Number<7> b = (e.hy * c) * along + (e.hx * k) * across;
    const Number<8> outside = exact::square(along) + exact::square(across) - exact::square(area);
    if (rest.sign <= 0 || b.sign >= 0 || outside.sign <= 0) return {};
    return {Rough(outside) / (Rough(area) * root(Rough(rest)) - Rough(b)), true};
  }
};

/// Where the greatest g is as seen from a kink.
enum class Beyond { before, here, behind };

/// A kink: the normal there, of a face of half length `own` across v, n.v = `speed`; the jump of the other kink and on
/// which side that is, 1 before; how far the box reaches along the normal.
struct Kink {
  const Number<1>&nx, &ny;
  const Number<2>& speed;
  const Number<3>&own, &other;
  int other_is_before;
  Number<3> height;
};

/// Where the greatest g is as seen from a kink; if it is there, the time of contact with the face.
inline Beyond look_from(const Kink& kink, const SeenEllipse& round, const Number<2>& w, WideTime& out) noexcept {
  Number<1> nx = kink.nx, ny = kink.ny;
  nx.sign *= -kink.speed.sign;  // against v
  ny.sign *= -kink.speed.sign;
  const auto support = round.support(nx, ny);
  Number<3> other = kink.other;
  other.sign *= -kink.other_is_before;
  // base - p and base + p. The straight terms may cancel.
  const Rough beside = Rough(support.beside) / root(Rough(support.squared));
  const auto sign = [&](const Number<3>& straight) {
    const Rough base = Rough(straight) - beside;
    if (base.sign_is_known()) return base.sign();
    return exact::detail::sign_with_root(exact::integer(-1) * support.beside, straight, support.squared);
  };
  if (sign(w + other - kink.own) > 0) return Beyond::behind;
  if (sign(w + other + kink.own) < 0) return Beyond::before;
  Rough gap;
  const Number<3> offset = exact::dot(nx, ny, round.passage.dx, round.passage.dy) - kink.height;
  if (less_root(offset, support.squared, gap)) {
    out.time = gap / Rough(exact::abs(kink.speed));
  } else {
    out.certain = false;
  }
  return Beyond::here;
}

/// Of a box and an ellipse.
inline WideTime wide_time(const SeenBox& seen, const SeenEllipse& round, const Number<2>& w) noexcept {
  const exact::Box& box = seen.box;
  const Number<2>&c = seen.c, &k = seen.k;
  const Passage& p = round.passage;
  const Number<3> jump_x = box.hx * exact::abs(k), jump_y = box.hy * exact::abs(c);
  const auto uu = exact::dot(box.ux, box.uy, box.ux, box.uy);
  // The kink of hx is at s = -c / k, where n is perp(u) turned; that of hy at k / c, where it is u turned.
  const int x_is_first = c.sign * k.sign;
  WideTime out{{}, true};
  int of_x = -c.sign, of_y = -k.sign;  // signs of u.n and u x n where the greatest g is
  if (jump_x.sign != 0) {
    Number<1> perp_x = box.uy;
    perp_x.sign = -perp_x.sign;
    const Beyond at = look_from({perp_x, box.ux, k, jump_x, jump_y, -x_is_first, box.hy * uu}, round, w, out);
    if (at == Beyond::here) return out;
    of_x = at == Beyond::behind ? -k.sign : k.sign;
  }
  if (jump_y.sign != 0) {
    const Beyond at = look_from({box.ux, box.uy, c, jump_y, jump_x, x_is_first, box.hx * uu}, round, w, out);
    if (at == Beyond::here) return out;
    of_y = at == Beyond::behind ? c.sign : -c.sign;
  }
  Number<1> hx = box.hx, hy = box.hy;
  hx.sign *= of_x;
  hy.sign *= of_y;
  return round.meets_corner(p.dx - (hx * box.ux - hy * box.uy), p.dy - (hx * box.uy + hy * box.ux));
}

/// Of two circles: of a point and the circle of both radii. Not certain for other ellipses.
VESICA_COLD inline WideTime wide_time_of_circles(const ExactPair& pair) noexcept {
  const exact::Box &a = pair.a_.box, &b = pair.b_.box;
  const auto are_same = [](const auto& x, const auto& y) { return exact::compare(x, y) == 0; };
  const bool are_circles = are_same(a.hx, a.hy) && are_same(b.hx, b.hy) && are_same(a.ux, b.ux) && are_same(a.uy, b.uy);
  if (!are_circles) return {};
  ExactBody sum = pair.a_;
  sum.box.hx = sum.box.hy = a.hx + b.hx;
  const ExactReach reach(sum, pair.vx_, pair.vy_);
  return SeenEllipse(sum, reach, {pair.dx_, pair.dy_, pair.vx_, pair.vy_}).meets_corner(pair.dx_, pair.dy_);
}

/// Of a pair whose line enters M after the start and does not graze it; of two ellipses nothing is known.
VESICA_COLD inline WideTime wide_time(const ExactPair& pair) noexcept {
  const Passage p{pair.dx_, pair.dy_, pair.vx_, pair.vy_};
  const ExactBody &a = pair.a_, &b = pair.b_;
  if (a.round && b.round) return {};
  if (a.round || b.round) {
    const ExactBody &round = a.round ? a : b, &box = a.round ? b : a;
    return wide_time(SeenBox(box, p.vx, p.vy), SeenEllipse(round, a.round ? pair.reach_a_ : pair.reach_b_, p), pair.w_);
  }
  WideTime latest;
  latest_of_axes(SeenBox(a, p.vx, p.vy), b.box, p, latest);
  latest_of_axes(SeenBox(b, p.vx, p.vy), a.box, p, latest);
  return latest;
}

/// Two ellipses, the one that is less wide first, by powers of two.
struct ByExtent {
  const ExactBody &thin, &other;
  const ExactReach& reach_of_other;
  std::int64_t bits;  ///< about so many powers of two the other is wider

  explicit ByExtent(const ExactPair& pair) noexcept : ByExtent(pair, extent(pair.a_.box), extent(pair.b_.box)) {}

 private:
  ByExtent(const ExactPair& pair, std::int64_t of_a, std::int64_t of_b) noexcept
      : thin(of_a < of_b ? pair.a_ : pair.b_),
        other(of_a < of_b ? pair.b_ : pair.a_),
        reach_of_other(of_a < of_b ? pair.reach_b_ : pair.reach_a_),
        bits(of_a < of_b ? of_b - of_a : of_a - of_b) {}
  static std::int64_t extent(const exact::Box& e) noexcept {
    const auto bit = [](const exact::Length& x) { return x.sign == 0 ? INT64_MIN / 4 : exact::detail::top_bit(x); };
    const std::int64_t x = bit(e.ux), y = bit(e.uy), along = bit(e.hx), across = bit(e.hy);
    return (x > y ? x : y) + (along < across ? along : across);
  }
};

/// Of two ellipses of which one is so small or thin that how it is rounded does not count. It lies in the box of its
/// numbers, and the segment of its longer axis lies in it. So contact begins after that of the box and before that of
/// the segment, where the line meets that one's sum; if not, wide_time() finds no time.
VESICA_COLD inline WideTime wide_time_of_thin(const ExactPair& pair, const ByExtent& by_extent) noexcept {
  const Passage p{pair.dx_, pair.dy_, pair.vx_, pair.vy_};
  const SeenEllipse round(by_extent.other, by_extent.reach_of_other, p);
  ExactBody thin = by_extent.thin;
  const WideTime of_box = wide_time(SeenBox(thin, p.vx, p.vy), round, pair.w_);
  if (!of_box.tells()) return {};
  (exact::compare(thin.box.hx, thin.box.hy) < 0 ? thin.box.hx : thin.box.hy) = {};
  const WideTime of_segment = wide_time(SeenBox(thin, p.vx, p.vy), round, pair.w_);
  if (!of_segment.tells()) return {};
  const Rough later = of_segment.time - of_box.time;
  return {of_box.time + Rough({}, std::fabs(rounded(later.value)) + later.error, later.exponent), true};
}

/// The time at which a line that grazes enters: at the witness, or where the edge along v begins that it meets. As |w|
/// = H, that is (sgn(w) X - q - edge) / v.v; a round shape's part of X is m / h, h being a root.
VESICA_COLD inline WideTime wide_grazing_time(const ExactPair& pair) noexcept {
  const auto turned = [&](auto x) {
    x.sign *= pair.w_.sign;
    return x;
  };
  const ExactReach &a = pair.reach_a_, &b = pair.reach_b_;
  const Number<3> straight = turned(a.along + b.along) - (a.edge + b.edge) - pair.q_;
  const auto part = [&](const ExactReach& r) {
    return r.round ? Rough(turned(r.m)) / root(Rough(r.squared)) : Rough();
  };
  Rough way = Rough(straight) + (part(a) + part(b));
  if (!way.is_precise() && a.round != b.round) {
    // x + y = (x^2 - y^2) / (x - y).
    const ExactReach& round = a.round ? a : b;
    const Number<12> rest = exact::square(straight) * round.squared - exact::square(round.m);
    way = Rough(rest) / (Rough(round.squared) * (Rough(straight) - part(round)));
  }
  return {way / Rough(pair.vv_), way.is_precise()};
}

/// The greatest double that is at most t0 > 0, infinite where that is the largest or beyond. Only where a double is so
/// near that `found` leaves it open, whether there is contact before it is asked. Returns 0, or an error where the
/// place then is beyond exact numbers. The errors of two times of boxes are within 2^-90 of either.
inline std::int32_t floor_of_time(const ExactPair& pair, const Rough& found, double& out) noexcept {
  constexpr double largest = std::numeric_limits<double>::max(), infinity = std::numeric_limits<double>::infinity();
  const auto& [value, error, exponent] = found;
  out = exponent > 1026 ? infinity : 0;
  if (exponent > 1026 || exponent < -1080) return 0;
  // The nearest double in units of 2^exponent: below 2^-1022 a multiple of the least.
  const double least = arithmetic::scale(1, -1074 - exponent), subnormal = 0x1p52 * least;
  const double nearest = value.high < subnormal ? (value.high + subnormal) - subnormal : value.high;
  const double above = (value.high - nearest) + value.low, at = arithmetic::scale(nearest, exponent);
  bool before = above < 0;
  if (!(std::fabs(above) > 1.01 * error + 0x1p-90 * value.high) && at <= largest) {
    const int reached = pair.contact_before(at);
    if (reached < 0) return reached;
    before = reached != 0;
  }
  out = before ? arithmetic::at_rank<double>(arithmetic::rank(at) - 1) : at;
  if (out >= largest) out = infinity;
  return 0;
}

}  // namespace vesica::detail::cast

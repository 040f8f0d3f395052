// SPDX-License-Identifier: Apache-2.0
/// Moving shapes in exact numbers: whether they touch, and when first.
///
/// All shapes are symmetric about their centres. Let D be the vector from a's centre to b's, and M the Minkowski sum of
/// both shapes, centred at the origin. Then b, moved by v t, touches a iff D + v t lies in M. M is convex, so the times
/// of contact are an interval, or there are none.
///
/// Let w = v x D, q = D.v, and H the largest |v x x| over the points x of M. The line of D + v t meets M iff |w| <= H.
/// If it does, D + v t lies in M at the witness
///
///     t_w = (w X / H - q) / v.v,    X = x.v of a point x of M with v x x = H
///
/// because x w / H is on the line, and M contains it with 0 and x. If H = 0, t_w = -q / v.v. So contact within [0, e]
/// takes the signs of |w| - H, of t_w and of t_w - e, and two overlap tests, at 0 and at e. No root is isolated.
///
/// Radii of both shapes add to M the disc of their sum, a third shape about 0. Its reach across v is R = |v| times the
/// sum, at a point with x.v = 0. Any point of M on the line may be the witness. If |w| <= H - R it is that of M without
/// the disc; else it is one with x.v = X sgn w, where X is that of M without the disc.
#pragma once

#include <vesica/arithmetic/rounding.hpp>
#include <vesica/cast/body.hpp>
#include <vesica/depth/exact_zero.hpp>
#include <vesica/exact/within_ellipse.hpp>

namespace vesica::detail::cast {

using exact::Number;

/// A shape in exact numbers; a round one has an area.
struct ExactBody {
  exact::Box box;
  bool round;

  exact::Ellipse ellipse() const noexcept { return {box.cx, box.cy, box.ux, box.uy, box.hx, box.hy}; }
};

inline ExactBody exact_body(const exact::Box& box) noexcept { return {box, false}; }
inline ExactBody exact_body(const exact::Ellipse& e) noexcept { return {exact::as_box(e), !degenerate(e)}; }

VESICA_COLD inline ExactBody exact_body(const Body& body) noexcept {
  return with_shape(body, [](const auto& s) { return exact_body(exact::form(s)); });
}

/// How far the boxes of a pair reach across v together: h, and x.v of a point x at that reach. If an edge lies along v,
/// x is its middle, and `edge` is half its length times |v|.
struct BoxReach {
  Number<3> h, along, edge;

  void add(const exact::Box& box, const Number<1>& vx, const Number<1>& vy) noexcept {
    const auto c = exact::dot(box.ux, box.uy, vx, vy), k = exact::cross(box.ux, box.uy, vx, vy);
    add(box.hx, c, k);
    add(box.hy, k, c, -1);
  }

 private:
  /// One half axis: its length times |u| reaches `forward` along v and `across` it.
  void add(const exact::Length& half, const Number<2>& forward, const Number<2>& across, int turn = 1) noexcept {
    auto reach = half * forward;
    h = h + half * exact::abs(across);
    if (across.sign == 0) edge = edge + exact::abs(reach);
    reach.sign *= -turn * across.sign;
    along = along + reach;
  }
};

/// The reach h of a round shape across v: `squared` = h^2, and m = h x.v.
struct RoundReach {
  Number<6> squared, m;

  void set(const exact::Box& round, const Number<1>& vx, const Number<1>& vy) noexcept {
    const auto c = exact::dot(round.ux, round.uy, vx, vy), k = exact::cross(round.ux, round.uy, vx, vy);
    const auto p = round.hx * k, q = round.hy * c;
    squared = exact::dot(p, q, p, q);
    m = (exact::square(round.hy) - exact::square(round.hx)) * (c * k);
  }
};

/// The reach H of M across v, by boxes and round shapes. A disc of both radii is the last of `round`.
struct ExactReach {
  BoxReach box;
  RoundReach round[2];
  int rounds = 0;
  bool has_disc = false;

  void add(const ExactBody& body, const Number<1>& vx, const Number<1>& vy) noexcept {
    if (body.round) {
      round[rounds++].set(body.box, vx, vy);
    } else {
      box.add(body.box, vx, vy);
    }
  }
  void add_disc(const exact::Length& radius, const Number<1>& vx, const Number<1>& vy) noexcept {
    has_disc = radius.sign > 0;
    if (has_disc) add({{{}, {}, exact::integer(1), {}, radius, radius}, true}, vx, vy);
  }
};

/// Sign of |w| - H, H being that of the boxes and of so many round shapes. Degree 3, 6 or 12.
VESICA_CALLED inline int line_gap(const ExactReach& reach, int rounds, const Number<2>& w) noexcept {
  const RoundReach &a = reach.round[0], &b = reach.round[1];
  const Number<3> beyond = exact::abs(w) - reach.box.h;
  if (rounds == 0 || beyond.sign < 0) return beyond.sign;
  if (rounds == 1) return exact::compare(exact::square(beyond), a.squared);
  const Number<6> rest = exact::square(beyond) - a.squared - b.squared;
  if (rest.sign < 0) return -1;
  return -exact::compare_product_with_square(exact::integer(4) * a.squared, b.squared, rest);
}

/// Sign of t_w - e, with q = D.v + e v.v. Without a disc it is that of w X - q H. Degree 6, 18 or 24.
VESICA_CALLED inline int witness_sign(const ExactReach& reach, const Number<2>& w, const Number<3>& q) noexcept {
  using exact::cross;
  const BoxReach& box = reach.box;
  const RoundReach &a = reach.round[0], &b = reach.round[1];
  const int rounds = reach.has_disc ? reach.rounds - 1 : reach.rounds;
  if (reach.has_disc && line_gap(reach, rounds, w) > 0) {
    const auto rest = w.sign > 0 ? box.along - q : -box.along - q;
    return rounds == 0 ? rest.sign : exact::detail::sign_with_root(w.sign > 0 ? a.m : -a.m, rest, a.squared);
  }
  if (rounds == 0) return box.h.sign == 0 ? -q.sign : exact::compare_products(w, box.along, q, box.h);
  if (rounds == 1) {
    return exact::detail::sign_with_root(cross(w, q, a.squared, a.m), cross(w, q, box.h, box.along), a.squared);
  }
  // The sign of (w m_a - q h_a^2) h_b + (w m_b - q h_b^2) h_a.
  const auto by_b = cross(w, q, a.squared, a.m), by_a = cross(w, q, b.squared, b.m);
  if (by_b.sign * by_a.sign >= 0) return by_b.sign != 0 ? by_b.sign : by_a.sign;
  return by_b.sign * exact::compare_squares_times(by_b, b.squared, by_a, a.squared);
}

/// The range of bits for which exact lengths have storage. Axes are lengths too. All lengths are multiplied by one
/// power of 2^64, so that their bits lie in the range.
class BitRange {
 public:
  template <int Degree>
  void hold(const Number<Degree>& x) noexcept {
    if (x.sign == 0) return;
    const std::int64_t top = exact::detail::top_bit(x);
    const std::int64_t low = 64 * std::int64_t{x.low} + std::countr_zero(x.limb[0]);
    top_ = top > top_ ? top : top_;
    low_ = low < low_ ? low : low_;
  }
  /// Chooses the power of 2^64. Returns false if the bits span more than the range.
  bool place() noexcept {
    if (top_ <= highest && low_ >= lowest) return true;
    // A shift by whole limbs is off by less than 64 bits.
    if (top_ - low_ > widest) return false;
    const std::int64_t shift = lowest - low_ + 63;
    limbs_ = static_cast<std::int32_t>((shift - (shift & 63)) / 64);
    return true;
  }
  template <int Degree>
  exact::Length moved(const Number<Degree>& x) const noexcept {
    exact::Length length;
    if (x.sign == 0) return length;
    length.sign = x.sign;
    length.low = x.low + limbs_;
    length.size = x.size;
    std::memcpy(length.limb, x.limb, static_cast<std::size_t>(x.size) * sizeof(exact::Limb));
    return length;
  }

  static constexpr std::int64_t lowest = -1075, highest = 1026, widest = highest - lowest - 64;

 private:
  std::int64_t top_ = INT64_MIN / 4, low_ = INT64_MAX / 4;
  std::int32_t limbs_ = 0;
};

/// How the shapes touch at a time. `beyond`: the position has more bits than exact numbers hold.
enum class Contact { none, touch, inside, beyond };

/// A pair and its motion, v != 0, in exact numbers.
class ExactPair {
 public:
  ExactPair(const Body& a, const Body& b, const Motion& motion) noexcept
      : a_(a), b_(b), motion_(motion), radius_(exact::from_double(a.radius) + exact::from_double(b.radius)) {
    set();
    gap_ = line_gap(reach_, reach_.rounds, w_);
  }

  bool of_boxes() const noexcept { return reach_.rounds == 0; }
  bool line_misses() const noexcept { return gap_ > 0; }
  /// The line only touches M, or M has no extent across it.
  bool line_grazes() const noexcept { return gap_ == 0; }
  /// On which side of the line through the first centre along v the second lies: the sign of w.
  int side() const noexcept { return w_.sign; }

  /// Sign of t_w - t for a line that meets M.
  int witness_after(double t) const noexcept { return witness_sign(reach_, w_, q_at(t)); }

  /// Remembers the last answer: the end is often the time of contact.
  Contact contact_at(double t) const noexcept {
    if (t != asked_.time) asked_ = {t, find_contact(t)};
    return asked_.contact;
  }

  /// 1 if there is contact before t, else 0, or error_range if the position at t is beyond exact numbers. The shapes
  /// must touch at some time above 0.
  ///
  /// Unless the line grazes, the witness lies inside the interval of contact. So contact of outlines alone, up to the
  /// witness, is the first contact. A line that grazes meets M in an edge along v, the witness being the middle.
  int contact_before(double t) const noexcept {
    if (!(t > 0)) return 0;
    if (line_grazes()) return witness_sign(reach_, w_, q_at(t) + reach_.box.edge) < 0 ? 1 : 0;
    if (t == asked_.time && asked_.contact == Contact::inside) return 1;
    if (witness_after(t) < 0) return 1;
    const Contact contact = contact_at(t);
    return contact == Contact::beyond ? error_range : contact == Contact::inside ? 1 : 0;
  }

 private:
  VESICA_CALLED void set() noexcept {
    const ExactBody a = exact_body(a_), b = exact_body(b_);
    const auto vx = exact::from_double(motion_.vx), vy = exact::from_double(motion_.vy);
    const auto dx = b.box.cx - a.box.cx, dy = b.box.cy - a.box.cy;
    w_ = exact::cross(vx, vy, dx, dy);
    q_ = exact::dot(dx, dy, vx, vy);
    vv_ = exact::dot(vx, vy, vx, vy);
    reach_.add(a, vx, vy);
    reach_.add(b, vx, vy);
    reach_.add_disc(radius_, vx, vy);
  }
  /// D.v + t v.v
  Number<3> q_at(double t) const noexcept { return q_ + exact::from_double(t) * vv_; }

  /// b's place in a's frame at t: the shapes with a's centre at 0.
  VESICA_CALLED bool place(double t, ExactBody& a, ExactBody& b, exact::Length& radius) const noexcept {
    const auto time = exact::from_double(t);
    const Number<2> x = (b.box.cx - a.box.cx) + time * exact::from_double(motion_.vx),
                    y = (b.box.cy - a.box.cy) + time * exact::from_double(motion_.vy);
    BitRange range;
    range.hold(x);
    range.hold(y);
    range.hold(radius);
    for (const ExactBody* body : {&a, &b}) {
      range.hold(body->box.ux);
      range.hold(body->box.uy);
    }
    if (!range.place()) return false;
    for (ExactBody* body : {&a, &b}) {
      body->box.ux = range.moved(body->box.ux);
      body->box.uy = range.moved(body->box.uy);
    }
    radius = range.moved(radius);
    a.box.cx = a.box.cy = {};
    b.box.cx = range.moved(x);
    b.box.cy = range.moved(y);
    return true;
  }
  VESICA_CALLED Contact find_contact(double t) const noexcept {
    ExactBody a = exact_body(a_), b = exact_body(b_);
    exact::Length radius = radius_;
    if (!place(t, a, b, radius)) return Contact::beyond;
    if (radius.sign > 0) {
      if (a.round) return contact(b.box, a.ellipse(), radius);
      return b.round ? contact(a.box, b.ellipse(), radius) : contact(a.box, b.box, radius);
    }
    if (!a.round) return b.round ? contact(a.box, b.ellipse()) : contact(a.box, b.box);
    return b.round ? contact(a.ellipse(), b.ellipse()) : contact(a.ellipse(), b.box);
  }
  template <class B>
  VESICA_CALLED static Contact contact(const exact::Box& a, const B& b, const exact::Length& radius) noexcept {
    const int found = exact::contact(a, b, radius, Common::insides);
    return found < 0 ? Contact::inside : found == 0 ? Contact::touch : Contact::none;
  }
  template <class A, class B>
  VESICA_CALLED static Contact contact(const A& a, const B& b) noexcept {
    const depth::Overlap found = depth::overlap_and_depth(a, b);
    if (found == depth::Overlap::none) return Contact::none;
    return found == depth::Overlap::some_without_depth ? Contact::touch : Contact::inside;
  }

  Body a_, b_;
  Motion motion_;
  exact::Length radius_;
  Number<2> w_, q_, vv_;
  ExactReach reach_;
  int gap_;
  mutable struct {
    double time;
    Contact contact;
  } asked_{-1, Contact::none};
};

/// `meets`: the line meets M after the start. If so, `late`: the witness comes after the end; `grazes`: the line only
/// grazes M; and the side on which it passes, the sign of w.
struct LineMeeting {
  bool meets, late, grazes;
  int side;
};
VESICA_COLD inline LineMeeting exact_line(const ExactPair& pair, double end) noexcept {
  if (pair.line_misses() || pair.witness_after(0) <= 0) return {false, false, false, 0};
  const bool late = end < std::numeric_limits<double>::infinity() && pair.witness_after(end) > 0;
  return {true, late, pair.line_grazes(), pair.side()};
}

/// 1 if the shapes touch at t, else 0, or error_range.
inline std::int32_t exact_contact_at(const ExactPair& pair, double t) noexcept {
  const Contact contact = pair.contact_at(t);
  return contact == Contact::beyond ? static_cast<std::int32_t>(error_range) : contact != Contact::none ? 1 : 0;
}

/// The greatest double with no contact before it, by bisection from a start. Returns 1, or error_range if the time, or
/// a position on the way to it, is beyond the numbers.
VESICA_COLD inline std::int32_t exact_time_from(const ExactPair& pair, double start, double& out) noexcept {
  std::int32_t before = 0;
  const auto has_contact_before = [&](double t) {
    if (before >= 0) before = pair.contact_before(t);
    return before != 0;
  };
  double after;
  if (!arithmetic::search_up(start, has_contact_before, after) || before < 0) return error_range;
  out = arithmetic::at_rank<double>(arithmetic::rank(after) - 1);
  return 1;
}

/// The same from an estimate, or from 1. Requires that the line enters M after the start.
VESICA_COLD inline std::int32_t exact_time(const ExactPair& pair, double estimate, double& out) noexcept {
  constexpr double largest = std::numeric_limits<double>::max();
  const bool is_estimate = estimate > 0 && estimate < largest;
  const double start = is_estimate ? arithmetic::at_rank<double>(arithmetic::rank(estimate) + 1) : 1;
  if (exact_time_from(pair, start, out) > 0) return 1;
  // If boxes have a normal nearly across v, the estimate is poor and may lead to positions of too many bits.
  if (is_estimate && pair.of_boxes() && exact_time_from(pair, 1, out) > 0) return 1;
  // The largest double may be the time of contact.
  out = largest;
  const bool at_largest = pair.contact_before(largest) == 0 && exact_contact_at(pair, largest) > 0;
  return at_largest ? 1 : static_cast<std::int32_t>(error_range);
}

/// exact_time(), or 0 if there is no contact up to the end. `late`: the witness comes after the end.
VESICA_COLD inline std::int32_t exact_time_by(const ExactPair& pair, double end, bool late, double estimate,
                                              double& out) noexcept {
  const std::int32_t at_end = late ? exact_contact_at(pair, end) : 1;
  return at_end > 0 ? exact_time(pair, estimate, out) : at_end;
}

}  // namespace vesica::detail::cast

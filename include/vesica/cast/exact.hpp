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
#pragma once

#include <vesica/arithmetic/rounding.hpp>
#include <vesica/cast/body.hpp>
#include <vesica/depth/exact_zero.hpp>

namespace vesica::detail::cast {

using exact::Leading;
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

/// A shape's reach h across v, and x.v for a point x at that reach. A box has h and x.v; if an edge lies along v, x is
/// the middle of the edge, and `edge` is half the length of the edge times |v|. A round shape has `squared` = h^2 and m
/// = h x.v.
struct ExactReach {
  bool round;
  Number<3> h, along, edge;
  Number<6> squared, m;

  ExactReach(const ExactBody& b, const Number<1>& vx, const Number<1>& vy) noexcept : round(b.round) {
    const auto& [cx, cy, ux, uy, hx, hy] = b.box;
    const auto c = exact::dot(ux, uy, vx, vy), k = exact::cross(ux, uy, vx, vy);
    if (round) {
      squared = exact::square(hx * k) + exact::square(hy * c);
      m = (exact::square(hy) - exact::square(hx)) * (c * k);
      return;
    }
    auto first = hx * c, second = hy * k;
    h = hx * exact::abs(k) + hy * exact::abs(c);
    if (k.sign == 0) edge = exact::abs(first);
    if (c.sign == 0) edge = edge + exact::abs(second);
    first.sign *= -k.sign;
    second.sign *= c.sign;
    along = first + second;
  }

  bool is_long() const noexcept { return exact::is_long(squared) || exact::is_long(h); }
};

/// Sign of |w| - H. Degree 3, 6 or 12.
inline int line_gap(const ExactReach& a, const ExactReach& b, const Number<2>& w) noexcept {
  if (!a.round && !b.round) return exact::compare(exact::abs(w), a.h + b.h);
  if (a.round && b.round) {
    const auto rest = exact::square(w) - a.squared - b.squared;
    if (rest.sign < 0) return -1;
    return -exact::compare_product_with_square(exact::integer(4) * a.squared, b.squared, rest);
  }
  const auto rest = exact::abs(w) - (a.round ? b.h : a.h);
  return rest.sign < 0 ? -1 : exact::compare(exact::square(rest), a.round ? a.squared : b.squared);
}

/// Sign of a sqrt(x) + b sqrt(y), x, y > 0.
template <int A, int B, int X>
int sum_of_roots(const Number<A>& a, const Number<X>& x, const Number<B>& b, const Number<X>& y) noexcept {
  if (a.sign * b.sign >= 0) return a.sign != 0 ? a.sign : b.sign;
  return a.sign * exact::compare_squares_times(a, x, b, y);
}

/// The same from leading digits: 0 where these do not decide.
template <int limbs>
int sum_of_roots(const Leading<limbs>& a, const Leading<limbs>& x, const Leading<limbs>& b,
                 const Leading<limbs>& y) noexcept {
  if (!a.sign_is_certain() || !b.sign_is_certain()) return 0;
  if (a.sign * b.sign >= 0) return a.sign != 0 ? a.sign : b.sign;
  const auto difference = square(a) * x - square(b) * y;
  return difference.sign_is_certain() ? a.sign * difference.sign : 0;
}

/// Sign of w X - q H. With q = D.v + e v.v it is the sign of t_w - e. Degree 6, 18 or 24.
template <int Q>
int witness_sign(const ExactReach& a, const ExactReach& b, const Number<2>& w, const Number<Q>& q) noexcept {
  if (!a.round && !b.round) {
    const auto reach = a.h + b.h;
    return reach.sign == 0 ? -q.sign : exact::compare(w * (a.along + b.along), q * reach);
  }
  const auto of_round = [&](const auto& x, const auto& y, const auto& m_a, const auto& squared_a, const auto& m_b,
                            const auto& squared_b) {
    return sum_of_roots(x * m_a - y * squared_a, squared_b, x * m_b - y * squared_b, squared_a);
  };
  if (a.round && b.round) {
    using Few = Leading<exact::few_limbs>;
    const bool is_long = a.is_long() || b.is_long();
    const int sign = is_long ? of_round(Few(w), Few(q), Few(a.m), Few(a.squared), Few(b.m), Few(b.squared)) : 0;
    return sign != 0 ? sign : of_round(w, q, a.m, a.squared, b.m, b.squared);
  }
  const ExactReach &round = a.round ? a : b, &box = a.round ? b : a;
  return exact::detail::sign_with_root(w * round.m - q * round.squared, w * box.along - q * box.h, round.squared);
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
      : a_(exact_body(a)),
        b_(exact_body(b)),
        vx_(exact::from_double(motion.vx)),
        vy_(exact::from_double(motion.vy)),
        dx_(b_.box.cx - a_.box.cx),
        dy_(b_.box.cy - a_.box.cy),
        w_(exact::cross(vx_, vy_, dx_, dy_)),
        q_(exact::dot(dx_, dy_, vx_, vy_)),
        vv_(exact::dot(vx_, vy_, vx_, vy_)),
        reach_a_(a_, vx_, vy_),
        reach_b_(b_, vx_, vy_),
        gap_(line_gap(reach_a_, reach_b_, w_)) {}

  bool of_boxes() const noexcept { return !a_.round && !b_.round; }
  bool line_misses() const noexcept { return gap_ > 0; }
  /// The line only touches M, or M has no extent across it.
  bool line_grazes() const noexcept { return gap_ == 0; }
  /// On which side of the line through the first centre along v the second lies: the sign of w.
  int side() const noexcept { return w_.sign; }

  /// Sign of t_w - t for a line that meets M.
  int witness_after(double t) const noexcept {
    if (t == 0) return witness_sign(reach_a_, reach_b_, w_, q_);
    return witness_sign(reach_a_, reach_b_, w_, q_ + exact::from_double(t) * vv_);
  }

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
    if (line_grazes()) {
      const auto edge = reach_a_.edge + reach_b_.edge;
      if (edge.sign == 0) return witness_after(t) < 0 ? 1 : 0;
      const auto q = q_ + exact::from_double(t) * vv_ + edge;
      return witness_sign(reach_a_, reach_b_, w_, q) < 0 ? 1 : 0;
    }
    if (t == asked_.time && asked_.contact == Contact::inside) return 1;
    if (witness_after(t) < 0) return 1;
    const Contact contact = contact_at(t);
    return contact == Contact::beyond ? error_range : contact == Contact::inside ? 1 : 0;
  }

 private:
  VESICA_COLD Contact find_contact(double t) const noexcept {
    const auto time = exact::from_double(t);
    const Number<2> x = dx_ + time * vx_, y = dy_ + time * vy_;
    BitRange range;
    range.hold(x);
    range.hold(y);
    for (const ExactBody* body : {&a_, &b_}) {
      range.hold(body->box.ux);
      range.hold(body->box.uy);
    }
    if (!range.place()) return Contact::beyond;
    const ExactBody a = placed(a_, {}, {}, range), b = placed(b_, range.moved(x), range.moved(y), range);
    if (a.round) return b.round ? contact(a.ellipse(), b.ellipse()) : contact(b.box, a.ellipse());
    return b.round ? contact(a.box, b.ellipse()) : contact(a.box, b.box);
  }
  static ExactBody placed(const ExactBody& body, const exact::Length& x, const exact::Length& y,
                          const BitRange& range) noexcept {
    return {{x, y, range.moved(body.box.ux), range.moved(body.box.uy), body.box.hx, body.box.hy}, body.round};
  }
  template <class A, class B>
  static Contact contact(const A& a, const B& b) noexcept {
    const depth::Overlap found = depth::overlap_and_depth(a, b);
    if (found == depth::Overlap::none) return Contact::none;
    return found == depth::Overlap::some_without_depth ? Contact::touch : Contact::inside;
  }

  ExactBody a_, b_;
  Number<1> vx_, vy_, dx_, dy_;
  Number<2> w_, q_, vv_;
  ExactReach reach_a_, reach_b_;
  int gap_;
  mutable struct {
    double time;
    Contact contact;
  } asked_{-1, Contact::none};
};

/// Whether the line meets M after the start. If so: whether the witness comes after the end, whether the line only
/// grazes M, and the side on which it passes (the sign of w).
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
  // Where boxes have a normal nearly across v the estimate is poor, and may lead to positions of too many bits.
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

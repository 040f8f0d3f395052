// SPDX-License-Identifier: Apache-2.0
/// Moving shapes, exactly. All shapes are symmetric about their centres. So a and b, moved by v t, share a point iff D
/// + v t lies in M, the Minkowski sum of both about the origin; D leads from a's centre to b's. M is convex: the times
/// of contact are an interval, or there are none.
///
/// With w = v x D, q = D.v and H the reach of M across v: the line of D + v t meets M iff |w| <= H. Then it is in M at
/// the witness t_w = (w X / H - q) / v.v, where X = x.v of a point x of M that lies farthest across v: x scaled by w /
/// H lies on the line, and M holds it with 0 and x. Of H = 0 the witness is -q / v.v. So whether there is contact
/// within [0, e] takes the signs of |w| - H, of t_w and of t_w - e, and two overlap tests, at 0 and at e. No root is
/// isolated.
#pragma once

#include <vesica/cast/body.hpp>
#include <vesica/crossings/rough.hpp>
#include <vesica/depth/exact_zero.hpp>

namespace vesica::detail::cast {

using crossings::rough;
using crossings::Rough;
using exact::Leading;
using exact::Number;

/// A shape in its exact form; a round one has an area.
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

/// A shape's reach across v, h, and x.v for a point x that lies as far: h and x.v where it is a box, their square
/// `squared` and product m where it is round. `edge` is half the x.v of an edge along v, x being its middle.
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

/// The same from leading digits: 0 where these do not tell.
template <int limbs>
int sum_of_roots(const Leading<limbs>& a, const Leading<limbs>& x, const Leading<limbs>& b,
                 const Leading<limbs>& y) noexcept {
  if (!a.sign_is_certain() || !b.sign_is_certain()) return 0;
  if (a.sign * b.sign >= 0) return a.sign != 0 ? a.sign : b.sign;
  const auto difference = square(a) * x - square(b) * y;
  return difference.sign_is_certain() ? a.sign * difference.sign : 0;
}

/// a / sqrt(x) + b / sqrt(y), x, y > 0, to 2^-50 or better whatever cancels.
template <int A, int X, int B, int Y>
Rough sum_over_roots(const Number<A>& a, const Number<X>& x, const Number<B>& b, const Number<Y>& y) noexcept {
  const Rough p = Rough(a) / root(Rough(x)), q = Rough(b) / root(Rough(y)), sum = p + q;
  if (sum.is_precise()) return sum;
  // (p^2 - q^2) / (p - q).
  const auto difference = [](const auto& a1, const auto& y1, const auto& b1, const auto& x1) {
    return square(a1) * y1 - square(b1) * x1;
  };
  const auto rest = exact::rounded_value(difference, a, y, b, x);
  return Rough(crossings::Real(rest.value), 0x1p-53, rest.exponent) / (Rough(x) * Rough(y) * (p - q));
}

/// Sign of w X - q H, which is that of t_w - e where q = D.v + e v.v. Degree 6, 18 or 24.
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

/// The numbers of some lengths brought into the window for which exact numbers have storage. All lengths are multiplied
/// by one power of 2^64, axes being lengths too. False where their digits span more than the window.
class Window {
 public:
  /// x times a number whose bits are in [below, above).
  template <int Degree>
  void hold(const Number<Degree>& x, std::int64_t below = 0, std::int64_t above = 0) noexcept {
    if (x.sign == 0) return;
    const std::int64_t top = exact::detail::top_bit(x) + above;
    const std::int64_t low = 64 * std::int64_t{x.low} + std::countr_zero(x.limb[0]) + below;
    top_ = top > top_ ? top : top_;
    low_ = low < low_ ? low : low_;
  }
  std::int64_t top() const noexcept { return top_; }
  std::int64_t low() const noexcept { return low_; }
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

  /// By how many limbs lengths are moved up.
  std::int32_t limbs() const noexcept { return limbs_; }

  static constexpr std::int64_t lowest = -1075, highest = 1026, widest = highest - lowest - 64;

 private:
  std::int64_t top_ = INT64_MIN / 4, low_ = INT64_MAX / 4;
  std::int32_t limbs_ = 0;
};

/// Where the bits are of what does not change, axes and the offset at the start, and of the velocity. So it takes no
/// exact sum to see that the place at a time has room: a sum has at most a bit above its terms, and none below.
struct PlaceBits {
  Window fixed, velocity;

  /// At a time t > 0.
  bool have_room(double t) const noexcept {
    const auto bits = std::bit_cast<std::uint64_t>(t);
    const int field = static_cast<int>(bits >> 52);
    const std::uint64_t fraction = bits & 0xfffffffffffffu, digits = field == 0 ? fraction : fraction | 1ull << 52;
    const int place = (field == 0 ? 1 : field) - 1075;
    const Extent e = extent(place + std::countr_zero(digits), place + 64 - std::countl_zero(digits));
    return e.is_within_window() || e.is_as_narrow();
  }
  /// At each time between two, 0 < least <= most. With the exponent of the time the highest and the lowest bit of a
  /// coordinate rise as convex and concave functions. So they span at most what they do at either end.
  bool have_room(double least, double most) const noexcept {
    const int first = arithmetic::exponent_of(least), last = arithmetic::exponent_of(most);
    const Extent low = extent(first - 53, first), high = extent(last - 53, last);
    return Extent{low.low, high.top}.is_within_window() || (low.is_as_narrow() && high.is_as_narrow());
  }

 private:
  struct Extent {
    std::int64_t low, top;

    bool is_within_window() const noexcept { return top <= Window::highest && low >= Window::lowest; }
    bool is_as_narrow() const noexcept { return top - low <= Window::widest; }
  };
  /// At times t > 0 whose bits are in [below, above).
  Extent extent(int below, int above) const noexcept {
    const std::int64_t low = velocity.low() + below, top = velocity.top() + above;
    return {low < fixed.low() ? low : fixed.low(), (top > fixed.top() ? top : fixed.top()) + 1};
  }
};

/// What contact is at a time: none, of outlines alone, or of insides. `beyond` where the place has more digits than
/// exact numbers hold.
enum class Contact { none, touch, inside, beyond };

struct WideTime;
struct ByExtent;
struct KnownCubic;
class LeadingContact;

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
        gap_(line_gap(reach_a_, reach_b_, w_)) {
    if (keeps_witness()) witness_ = find_witness();
  }

  bool line_misses() const noexcept { return gap_ > 0; }
  /// The line only touches M, or M has no extent across it.
  bool line_grazes() const noexcept { return gap_ == 0; }
  /// On which side of the line through the first centre along v the second lies: the sign of w.
  int side() const noexcept { return w_.sign; }

  /// t_w, above 0, for a line that meets M.
  Rough rough_witness() const noexcept { return keeps_witness() ? witness_ : find_witness(); }

  /// Sign of t_w - t for a line that meets M.
  int witness_after(double t) const noexcept {
    if (keeps_witness()) {
      const Rough left = witness_ - Rough(exact::from_double(t));
      if (left.sign_is_known()) return left.sign();
    }
    if (t == 0) return witness_sign(reach_a_, reach_b_, w_, q_);
    return witness_sign(reach_a_, reach_b_, w_, q_ + exact::from_double(t) * vv_);
  }

  /// The end is often the time of contact too, so that the last answer is remembered.
  Contact contact_at(double t) const noexcept {
    if (t != asked_.time) asked_ = {t, find_contact(t)};
    return asked_.contact;
  }

  /// Whether contact_at() has storage for the place at this time.
  bool holds_place(double t) const noexcept { return Place(*this, t).window.place(); }
  PlaceBits place_bits() const noexcept {
    PlaceBits bits;
    for (const ExactBody* body : {&a_, &b_}) {
      bits.fixed.hold(body->box.ux);
      bits.fixed.hold(body->box.uy);
    }
    bits.fixed.hold(dx_);
    bits.fixed.hold(dy_);
    bits.velocity.hold(vx_);
    bits.velocity.hold(vy_);
    return bits;
  }

  /// Whether there is contact before t, given that there is some after 0: 1, 0, or error_range where that is beyond
  /// exact numbers. The witness is in the inside of the interval of contact unless the line grazes. So up to it contact
  /// of outlines is the first. A line that grazes meets M in an edge along v, with the witness in its middle.
  int contact_before(double t) const noexcept {
    if (!(t > 0)) return 0;
    if (line_grazes()) {
      const auto edge = reach_a_.edge + reach_b_.edge;
      if (edge.sign == 0) return witness_after(t) < 0 ? 1 : 0;
      const auto q = q_ + exact::from_double(t) * vv_ + edge;
      return witness_sign(reach_a_, reach_b_, w_, q) < 0 ? 1 : 0;
    }
    // Where insides meet, contact is in the inside of its interval.
    if (t == asked_.time && asked_.contact == Contact::inside) return 1;
    if (witness_after(t) < 0) return 1;
    const Contact contact = contact_at(t);
    return contact == Contact::beyond ? error_range : contact == Contact::inside ? 1 : 0;
  }

  bool of_ellipses() const noexcept { return a_.round && b_.round; }
  bool is_long() const noexcept { return reach_a_.is_long() || reach_b_.is_long(); }

  friend WideTime wide_time(const ExactPair& pair) noexcept;
  friend WideTime wide_time_of_circles(const ExactPair& pair) noexcept;
  friend WideTime wide_time_of_thin(const ExactPair& pair, const ByExtent& by_extent) noexcept;
  friend WideTime wide_grazing_time(const ExactPair& pair) noexcept;
  friend struct ByExtent;
  friend struct KnownCubic;
  friend class LeadingContact;

 private:
  /// Where it saves exact signs: of long numbers they are dear, and of a line that grazes many are asked.
  bool keeps_witness() const noexcept { return !line_misses() && (is_long() || line_grazes()); }
  Rough find_witness() const noexcept {
    const auto reach = [](const ExactReach& r) { return r.round ? root(Rough(r.squared)) : Rough(r.h); };
    const Rough across = reach(reach_a_) + reach(reach_b_);
    if (across.sign() == 0) return -Rough(q_) / Rough(vv_);
    const Rough way = way_to_witness_from_digits();
    return (way.is_precise() ? way : way_to_witness()) / (across * Rough(vv_));
  }
  /// w X - q H from leading digits: precise unless its terms cancel.
  Rough way_to_witness_from_digits() const noexcept {
    using Few = Leading<exact::few_limbs>;
    const Few w(w_), q(q_);
    const auto part = [&](const ExactReach& r) {
      return r.round ? rough(w * Few(r.m) - q * Few(r.squared)) / root(Rough(r.squared))
                     : rough(w * Few(r.along) - q * Few(r.h));
    };
    return part(reach_a_) + part(reach_b_);
  }
  /// To 2^-50 or better whatever cancels.
  Rough way_to_witness() const noexcept {
    const ExactReach &a = reach_a_, &b = reach_b_;
    // Of a round shape over a root.
    const auto round = [this](const ExactReach& r) { return w_ * r.m - q_ * r.squared; };
    if (a.round && b.round) return sum_over_roots(round(a), a.squared, round(b), b.squared);
    const Number<5> straight = w_ * (a.along + b.along) - q_ * (a.h + b.h);
    if (!a.round && !b.round) return Rough(straight);
    const ExactReach& r = a.round ? a : b;
    return sum_over_roots(straight, exact::integer(1), round(r), r.squared);
  }

  /// The offset of centres at a time, and the window of all lengths then.
  struct Place {
    Number<2> x, y;
    Window window;

    Place(const ExactPair& pair, double t) noexcept
        : x(pair.dx_ + exact::from_double(t) * pair.vx_), y(pair.dy_ + exact::from_double(t) * pair.vy_) {
      window.hold(x);
      window.hold(y);
      for (const ExactBody* body : {&pair.a_, &pair.b_}) {
        window.hold(body->box.ux);
        window.hold(body->box.uy);
      }
    }
  };

  /// action(a, b, window) for both bodies as they are at a time; false where there is no storage.
  template <class Action>
  bool with_placed(double t, const Action& action) const noexcept {
    const Place place(*this, t);
    Window window = place.window;
    if (!window.place()) return false;
    action(placed(a_, {}, {}, window), placed(b_, window.moved(place.x), window.moved(place.y), window), window);
    return true;
  }
  VESICA_COLD Contact find_contact(double t) const noexcept {
    Contact found = Contact::beyond;
    with_placed(t, [&found](const ExactBody& a, const ExactBody& b, const Window&) {
      if (a.round) {
        found = b.round ? contact(a.ellipse(), b.ellipse()) : contact(b.box, a.ellipse());
      } else {
        found = b.round ? contact(a.box, b.ellipse()) : contact(a.box, b.box);
      }
    });
    return found;
  }
  static ExactBody placed(const ExactBody& body, const exact::Length& x, const exact::Length& y,
                          const Window& window) noexcept {
    return {{x, y, window.moved(body.box.ux), window.moved(body.box.uy), body.box.hx, body.box.hy}, body.round};
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
  Rough witness_;  ///< where it is kept
  mutable struct {
    double time;
    Contact contact;
  } asked_{-1, Contact::none};
};

}  // namespace vesica::detail::cast

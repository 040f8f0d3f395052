// SPDX-License-Identifier: Apache-2.0
/// The first contact of two ellipses whose exponents are unlike, by trial of doubles, most of them in a microsecond:
/// the cubic of their contact (exact/contact_cubic.hpp) from the leading digits of numbers that do not depend on the
/// time. Where these do not tell, the exact predicate does.
#pragma once

#include <vesica/arithmetic/rounding.hpp>
#include <vesica/cast/wide.hpp>

namespace vesica::detail::cast {

/// What a trial tells: whether there is contact of insides before the time, and where known the discriminant of the
/// cubic, which is positive before contact, and falls through 0 at it.
struct Trial {
  bool known = false, after = false, has_value = false;
  arithmetic::Scaled value{0, 0};
};

/// An ellipse, and another's centre that passes: d + t v in its frame, each coordinate times the other half length.
struct LeadingFrame {
  using Few = exact::Leading<exact::few_limbs>;
  Few at_x, at_y, by_x, by_y, squared_area;

  LeadingFrame(const exact::Box& e, const Passage& p) noexcept
      : at_x(e.hy * exact::dot(e.ux, e.uy, p.dx, p.dy)),
        at_y(e.hx * exact::cross(e.ux, e.uy, p.dx, p.dy)),
        by_x(e.hy * exact::dot(e.ux, e.uy, p.vx, p.vy)),
        by_y(e.hx * exact::cross(e.ux, e.uy, p.vx, p.vy)),
        squared_area(square(Few(e.hx * e.hy * exact::dot(e.ux, e.uy, e.ux, e.uy)))) {}

  /// al or be of the cubic.
  Few offset(const Few& t) const noexcept { return square(at_x + t * by_x) + square(at_y + t * by_y); }
};

/// The cubic at a time.
class LeadingContact {
  using Few = LeadingFrame::Few;

 public:
  LeadingContact(const exact::Box& e, const exact::Box& f, const Passage& p) noexcept
      : first_(e, p), second_(f, p), mixed_(mixed(e, f)), product_(first_.squared_area * second_.squared_area) {}

  /// As exact::overlap decides it: contact if both inner coefficients are not negative or the discriminant is not
  /// positive; of insides unless it is 0.
  Trial at(double time) const noexcept {
    const Few t(exact::from_double(time)), &d1 = first_.squared_area, &d2 = second_.squared_area;
    const Few c1 = d1 + mixed_ - first_.offset(t), c2 = d2 + mixed_ - second_.offset(t);
    Trial trial;
    if (!c1.sign_is_certain() || !c2.sign_is_certain()) return trial;
    if (c1.sign >= 0 && c2.sign >= 0) return {true, true};
    const Few a = square(c2) - times(3, d2 * c1), b = c1 * c2 - times(9, product_), c = square(c1) - times(3, d1 * c2);
    const Few discriminant = times(4, a * c) - square(b);
    if (!discriminant.sign_is_certain() || discriminant.sign == 0) return trial;
    const double value = discriminant.sign * static_cast<double>(discriminant.limb[exact::few_limbs - 1]) * 0x1p-64;
    return {true, discriminant.sign < 0, true, {value, 64 * (discriminant.low + exact::few_limbs)}};
  }

 private:
  static Few mixed(const exact::Box& e, const exact::Box& f) noexcept {
    const Few c(exact::dot(e.ux, e.uy, f.ux, f.uy)), s(exact::cross(e.ux, e.uy, f.ux, f.uy));
    const Few a0 = square(Few(e.hx)), a1 = square(Few(e.hy)), b0 = square(Few(f.hx)), b1 = square(Few(f.hy));
    return square(c) * (a0 * b1 + a1 * b0) + square(s) * (a0 * b0 + a1 * b1);
  }

  LeadingFrame first_, second_;
  Few mixed_, product_;  // mu, and d1 d2
};

/// The sign of t_w - t, as witness_sign() finds it.
class LeadingWitness {
  using Few = LeadingFrame::Few;

 public:
  LeadingWitness(const ExactReach& a, const ExactReach& b, const Number<2>& w, const Number<2>& q,
                 const Number<2>& vv) noexcept
      : squared_a_(a.squared), squared_b_(b.squared), along_a_(w * a.m), along_b_(w * b.m), q_(q), vv_(vv) {}

  /// 0 where these digits do not tell.
  int after(double time) const noexcept {
    const Few q = q_ + Few(exact::from_double(time)) * vv_;
    return sum_of_roots(along_a_ - q * squared_a_, squared_b_, along_b_ - q * squared_b_, squared_a_);
  }

 private:
  Few squared_a_, squared_b_, along_a_, along_b_, q_, vv_;
};

/// y / x for values x, y.
inline double ratio(const arithmetic::Scaled& y, const arithmetic::Scaled& x) noexcept {
  return arithmetic::scale(y.value / x.value, y.exponent - x.exponent);
}

/// The doubles between which contact begins, by their ranks.
class Bracket {
 public:
  Bracket(double no, double yes, const Trial& at_no, const Trial& at_yes) noexcept
      : no_(arithmetic::rank(no)), yes_(arithmetic::rank(yes)), at_no_(at_no), at_yes_(at_yes) {}

  /// No double is between. Else next() is the rank of one.
  bool is_closed() const noexcept { return yes_ - no_ <= 1; }
  double floor() const noexcept { return arithmetic::at_rank<double>(no_); }
  std::uint64_t next() noexcept {
    const std::uint64_t way = yes_ - no_;
    const double whole = static_cast<double>(way);
    double share = 0.5 * whole;
    // Every fourth trial halves the way, unless it is a sixteenth of what it was four trials ago.
    const bool may_halve = ++trials_ % 4 == 0;
    const bool quick = !may_halve || way <= before_ / 16;
    if (may_halve) before_ = way;
    if (quick && at_no_.has_value && at_yes_.has_value) {
      share = whole / (1 - ratio(at_yes_.value, at_no_.value));
    } else if (quick && at_no_.has_value && at_earlier_no_.has_value) {
      // Where contact begins with a double zero no value is negative. Its root falls straight; a little farther than to
      // 0, and then a little less far.
      const double falling = std::sqrt(ratio(at_earlier_no_.value, at_no_.value));
      const double to_zero = static_cast<double>(no_ - earlier_no_) / (falling - 1);
      share = (was_after_ ? 0.98 : repeated_ ? 2 : 1.02) * to_zero;
      if (was_after_ && repeated_) share = 0.5 * whole;
    }
    const double most = static_cast<double>(way - 1);
    if (!(share <= most)) share = 0.5 * whole;
    return no_ + (share < 1 ? 1 : static_cast<std::uint64_t>(share));
  }
  void narrow(std::uint64_t at, const Trial& trial) noexcept {
    repeated_ = trials_ > 1 && trial.after == was_after_;
    was_after_ = trial.after;
    if (trial.after) {
      yes_ = at;
      at_yes_ = trial;
      if (repeated_) at_no_.value.value *= 0.5;  // the Illinois rule: else one end might stay
    } else {
      earlier_no_ = no_;
      at_earlier_no_ = at_no_;
      no_ = at;
      at_no_ = trial;
      if (repeated_) at_yes_.value.value *= 0.5;
    }
  }

 private:
  std::uint64_t no_, yes_, earlier_no_ = 0, before_ = ~std::uint64_t{0};
  Trial at_no_, at_yes_, at_earlier_no_;
  int trials_ = 0;
  bool was_after_ = false, repeated_ = false;
};

/// The greatest double with no contact before it, for which ask(t) is answered by trials; infinite where there is no
/// contact before the largest, negative where it is about that. Where wide formulas do not tell it, it is often 0, or
/// the one before `start`. Else first the power of two is bisected, then the zero of the discriminant is approached by
/// secants.
template <class Ask>
double floor_by_trials(double start, const Ask& ask) noexcept {
  constexpr int least = -1074;
  Trial at_no = ask(arithmetic::scale_far(1, least)), at_yes;
  if (at_no.after) return 0;
  const double before = arithmetic::at_rank<double>(arithmetic::rank(start) - 1);
  if (before > 0 && ask(start).after && !ask(before).after) return before;
  int no = least, yes = 1024;
  while (yes - no > 1) {
    const int middle = (yes + no) / 2;
    const Trial trial = ask(arithmetic::scale_far(1, middle));
    (trial.after ? yes : no) = middle;
    (trial.after ? at_yes : at_no) = trial;
  }
  if (yes == 1024) {
    constexpr double largest = std::numeric_limits<double>::max(), infinity = std::numeric_limits<double>::infinity();
    return ask(largest).after ? -1 : infinity;
  }
  Bracket bracket(arithmetic::scale_far(1, no), arithmetic::scale_far(1, yes), at_no, at_yes);
  while (!bracket.is_closed()) {
    const std::uint64_t at = bracket.next();
    bracket.narrow(at, ask(arithmetic::at_rank<double>(at)));
  }
  return bracket.floor();
}

/// For a pair of ellipses whose line enters M after the start and does not graze it. Negative where the place then is
/// beyond exact numbers.
VESICA_COLD inline double floor_of_ellipses(const ExactPair& pair, double start) noexcept {
  const LeadingContact contact(pair.a_.box, pair.b_.box, {pair.dx_, pair.dy_, pair.vx_, pair.vy_});
  const LeadingWitness witness(pair.reach_a_, pair.reach_b_, pair.w_, pair.q_, pair.vv_);
  bool beyond = false;
  const auto ask = [&](double t) -> Trial {
    const Trial trial = contact.at(t);
    if (trial.known && trial.after) return trial;
    // Without contact it is before the witness or after.
    const int witness_after = witness.after(t);
    if (witness_after < 0) return {true, true};
    if (trial.known && witness_after > 0) return trial;
    const int before = pair.contact_before(t);
    beyond = beyond || before < 0;
    return {true, before != 0};
  };
  const double t = floor_by_trials(start, ask);
  return beyond ? -1 : t;
}

}  // namespace vesica::detail::cast

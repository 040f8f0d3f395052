// SPDX-License-Identifier: Apache-2.0
/// The first contact of two ellipses whose exponents are unlike, by trial of doubles, most of them in a microsecond:
/// the cubic of their contact (exact/contact_cubic.hpp) from the leading digits of numbers that do not depend on the
/// time. Where these do not tell, the exact predicate does.
#pragma once

#include <vesica/arithmetic/rounding.hpp>
#include <vesica/cast/ellipse_contact.hpp>

namespace vesica::detail::cast {

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
/// contact before the largest, negative where it is about that. A guess above 0 is T(n) of some n (bound.hpp), which is
/// not after contact, and mostly not long before it. Where wide formulas do not tell the time, it is often 0, or the
/// one before `start`, or about the witness, which it never is after. Else first the power of two is bisected, from the
/// guess on, then the zero of the discriminant is approached by secants.
template <class Ask>
double floor_by_trials(double start, const Between& witness, double guess, const Ask& ask) noexcept {
  constexpr int least = -1074;
  constexpr double largest = std::numeric_limits<double>::max(), infinity = std::numeric_limits<double>::infinity();
  const auto narrowed = [&ask](Bracket bracket) {
    while (!bracket.is_closed()) {
      const std::uint64_t at = bracket.next();
      bracket.narrow(at, ask(arithmetic::at_rank<double>(at)));
    }
    return bracket.floor();
  };
  if (guess > 0 && guess < 0x1p1023) {
    Trial at_before = ask(guess);
    double before = guess;
    for (std::uint64_t way = 1; way < 0x100000 && !at_before.after; way *= 4) {
      const double later = arithmetic::at_rank<double>(arithmetic::rank(before) + way);
      const Trial at_later = ask(later);
      if (at_later.after) return narrowed({before, later, at_before, at_later});
      before = later;
      at_before = at_later;
    }
  }
  Trial at_no = ask(arithmetic::scale_far(1, least)), at_yes;
  if (at_no.after) return 0;
  const double before = arithmetic::at_rank<double>(arithmetic::rank(start) - 1);
  if (before > 0 && ask(start).after && !ask(before).after) return before;
  int no = least, yes = 1024;
  if (witness.least > 0 && witness.most <= largest) {
    const Trial at_witness = ask(witness.least);
    if (!at_witness.after) return narrowed({witness.least, witness.most, at_witness, {}});
    yes = arithmetic::exponent_of(witness.most);
  }
  int at = guess > 0 ? arithmetic::exponent_of(guess) : yes, step = 1;
  while (yes - no > 1) {
    const bool is_led = no < at && at < yes;
    if (!is_led) at = (yes + no) / 2;
    const Trial trial = ask(arithmetic::scale_far(1, at));
    (trial.after ? yes : no) = at;
    (trial.after ? at_yes : at_no) = trial;
    at = is_led ? (trial.after ? yes - step : no + step) : yes;
    step *= 2;
  }
  if (yes == 1024) {
    return ask(largest).after ? -1 : infinity;
  }
  return narrowed({arithmetic::scale_far(1, no), arithmetic::scale_far(1, yes), at_no, at_yes});
}

/// For a pair of ellipses whose line enters M after the start and does not graze it. Negative where the place then is
/// beyond exact numbers.
VESICA_COLD inline double floor_of_ellipses(const ExactPair& pair, double start, double guess) noexcept {
  const LeadingContact contact{PairDigits<exact::few_limbs>(pair)};
  const Rough witness = pair.rough_witness();
  bool beyond = false, digits_tell = true;
  const auto ask = [&](double t) -> Trial {
    // Without contact it is before the witness or after.
    const Rough left = witness - Rough(exact::from_double(t));
    if (left.sign_is_known() && left.sign() < 0) return {true, true};
    Trial trial = contact.at(t);
    if (!trial.known && digits_tell) {
      trial = LeadingContact::exactly_at(pair, t);
      digits_tell = trial.after || trial.has_value;
    }
    if (trial.known && (trial.after || left.sign_is_known())) return trial;
    const int before = pair.contact_before(t);
    beyond = beyond || before < 0;
    return {true, before != 0};
  };
  const double t = floor_by_trials(start, between(witness), guess, ask);
  return beyond ? -1 : t;
}

}  // namespace vesica::detail::cast

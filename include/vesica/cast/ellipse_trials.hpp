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
    const double most = static_cast<double>(way - 1);
    if (quick && at_no_.has_value && at_yes_.has_value) {
      share = lane::min(whole / (1 - ratio(at_yes_.value, at_no_.value)), most);
    } else if (quick && at_no_.has_value && at_earlier_no_.has_value) {
      // Where contact begins with a double zero no value is negative. Its root falls straight; a little farther than to
      // 0, and then a little less far.
      const double falling = std::sqrt(ratio(at_earlier_no_.value, at_no_.value));
      const double to_zero = static_cast<double>(no_ - earlier_no_) / (falling - 1);
      share = (was_after_ ? 0.98 : repeated_ ? 2 : 1.02) * to_zero;
      if (was_after_ && repeated_) share = 0.5 * whole;
    }
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
/// not after contact, and mostly not long before it. Where wide formulas do not tell the time, it is often 0, or beside
/// `start`, or about the witness, which it never is after. Else first the power of two is bisected, from the guess on,
/// then the zero of the discriminant is approached by secants.
template <class Ask>
double floor_by_trials(double start, const Between& witness, double guess, const Ask& ask) noexcept {
  constexpr double largest = std::numeric_limits<double>::max(), infinity = std::numeric_limits<double>::infinity();
  double no = 0, yes = infinity;
  Trial at_no, at_yes;
  const auto is_after = [&](double t) {
    const Trial trial = ask(t);
    (trial.after ? yes : no) = t;
    (trial.after ? at_yes : at_no) = trial;
    return trial.after;
  };
  const auto narrowed = [&] {
    Bracket bracket(no, yes, at_no, at_yes);
    while (!bracket.is_closed()) {
      const std::uint64_t at = bracket.next();
      bracket.narrow(at, ask(arithmetic::at_rank<double>(at)));
    }
    return bracket.floor();
  };
  // Whether contact begins about a time: a double is tried there, and then others ever farther from it.
  const auto begins_about = [&](double t) {
    if (!(no < t && t < yes && t < 0x1p1023)) return false;
    const bool after = is_after(t);
    for (std::uint64_t way = 1; way < 0x1000000; way *= 16) {
      const std::uint64_t rank = arithmetic::rank(t), least = arithmetic::rank(no);
      if (after && rank <= least + way) break;
      t = arithmetic::at_rank<double>(after ? rank - way : rank + way);
      const Trial earlier = at_no;
      if (is_after(t) != after) return true;
      const bool have_values = !after && earlier.has_value && at_no.has_value;
      if (have_values && ratio(at_no.value, earlier.value) > 1 - 0x1p-12) break;  // it falls to 0 far from here
    }
    return false;
  };
  if (begins_about(guess) || begins_about(start)) return narrowed();
  if (no == 0 && is_after(arithmetic::scale_far(1, -1074))) return 0;
  if (witness.least > 0 && witness.most <= yes && witness.most <= largest &&
      (witness.least <= no || !is_after(witness.least))) {
    yes = witness.most;
    at_yes = {};
    return narrowed();
  }
  int least = arithmetic::exponent_of(no) - 1, most = yes <= largest ? arithmetic::exponent_of(yes) : 1024;
  int at = guess > 0 ? arithmetic::exponent_of(guess) : most, step = 1;
  while (most - least > 1) {
    const bool is_guessed = least < at && at < most;
    if (!is_guessed) at = (most + least) / 2;
    const bool after = is_after(arithmetic::scale_far(1, at));
    (after ? most : least) = at;
    at = is_guessed ? (after ? most - step : least + step) : most;
    step *= 2;
  }
  if (most == 1024 && !is_after(largest)) return infinity;
  return most == 1024 ? -1 : narrowed();
}

/// Trials of a pair of ellipses whose line enters M after the start and does not graze it, at times above 0.
class EllipseTrials {
 public:
  explicit EllipseTrials(const ExactPair& pair) noexcept
      : pair_(pair), contact_(PairDigits<exact::few_limbs>(pair)), witness_(pair.rough_witness()) {}

  Between witness() const noexcept { return between(witness_); }
  /// Whether a place that was tried is beyond exact numbers.
  bool went_beyond() const noexcept { return beyond_; }

  Trial at(double t) noexcept {
    const int left = to_witness(t);
    if (left < 0) return {true, true};
    Trial trial = contact_.at(t);
    if (!trial.known && exact_digits_tell_) {
      trial = LeadingContact::exactly_at(pair_, t);
      exact_digits_tell_ = trial.after || trial.has_value;
    }
    if (trial.known && (trial.after || left > 0)) return trial;
    const int before = pair_.contact_before(t);
    beyond_ = beyond_ || before < 0;
    return {true, before != 0};
  }

  /// What ExactPair::contact_before() answers.
  std::int32_t contact_before(double t) const noexcept {
    const int left = t > 0 ? to_witness(t) : 0;
    if (left < 0) return 1;
    const Trial trial = left > 0 ? contact_.at(t) : Trial{};
    if (!trial.known) return pair_.contact_before(t);
    if (!pair_.holds_place(t)) return error_range;
    return trial.after ? 1 : 0;
  }

 private:
  /// The sign of t_w - t, 0 where a few digits do not tell it. Without contact it is before the witness or after.
  int to_witness(double t) const noexcept {
    const Rough left = witness_ - Rough(exact::from_double(t));
    return left.sign_is_known() ? left.sign() : 0;
  }

  const ExactPair& pair_;
  LeadingContact contact_;
  Rough witness_;
  bool beyond_ = false, exact_digits_tell_ = true;
};

/// Negative where a place that is tried is beyond exact numbers.
VESICA_COLD inline double floor_of_ellipses(const ExactPair& pair, double start, double guess) noexcept {
  EllipseTrials trials(pair);
  const double t = floor_by_trials(start, trials.witness(), guess, [&trials](double x) { return trials.at(x); });
  return trials.went_beyond() ? -1 : t;
}

}  // namespace vesica::detail::cast

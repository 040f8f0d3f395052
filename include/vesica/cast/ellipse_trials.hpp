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
      share = lane::min((was_after_ ? 0.98 : repeated_ ? 2 : 1.02) * to_zero, (1 - 0x1p-8) * whole);
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

/// A search for the greatest double with no contact before it, for which ask(t) is answered by trials. Those at times
/// above 0 and below `least` are likely not to be known.
template <class Ask>
class TrialSearch {
  using Limits = std::numeric_limits<double>;
  static constexpr double least_double = Limits::denorm_min(), largest = Limits::max();

 public:
  explicit TrialSearch(const Ask& ask, double least = least_double) noexcept : ask_(ask), least_(least) {}

  /// Infinite where there is no contact before the largest double, negative where a trial that was needed is not known.
  /// A guess above 0 is T(n) of some n (bound.hpp), which is not after contact, and mostly not long before it. Where
  /// wide formulas do not tell the time, it is often 0, or beside `start`, or about the witness, which it never is
  /// after. Else first the power of two is bisected, from the guess on, then the zero of the discriminant is approached
  /// by secants.
  double floor(double start, const Between& witness, double guess) noexcept {
    if (begins_about(guess) || begins_about(start)) return narrowed();
    if (no_ == 0) {
      const Trial first = ask_(least_);
      if (first.known && first.after) return least_ > least_double ? -1 : 0;
      if (first.known) no_ = least_, at_no_ = first;
    }
    if (!begins_at(witness)) {
      bisect_powers(guess);
      if (!lost_ && yes_ > largest && !is_after(largest)) return yes_;
    }
    return narrowed();
  }

 private:
  VESICA_COLD bool is_after(double t) noexcept {
    const Trial trial = ask_(t);
    lost_ = lost_ || !trial.known;
    (trial.after ? yes_ : no_) = t;
    (trial.after ? at_yes_ : at_no_) = trial;
    return trial.after;
  }

  /// Whether contact begins about a time: that is tried, and then others ever farther from it.
  VESICA_COLD bool begins_about(double t) noexcept {
    if (!(no_ < t && t < yes_)) return false;
    const bool after = is_after(t);
    for (std::uint64_t way = 1; way < 0x100000; way *= 64) {
      const std::uint64_t rank = arithmetic::rank(t);
      if (after ? rank <= arithmetic::rank(no_) + way : rank + way >= arithmetic::rank(yes_)) break;
      t = arithmetic::at_rank<double>(after ? rank - way : rank + way);
      const Trial &at = after ? at_yes_ : at_no_, earlier = at;
      if (is_after(t) != after) return true;
      if (earlier.has_value && ratio(at.value, earlier.value) > 1 - 0x1p-12) break;  // it is 0 far from here
    }
    return false;
  }

  bool begins_at(const Between& witness) noexcept {
    if (!(witness.least > 0 && witness.most <= yes_ && witness.most <= largest)) return false;
    if (witness.least > no_ && is_after(witness.least)) return false;
    yes_ = witness.most;
    at_yes_ = {};
    return true;
  }

  /// Between what is known: from the guess on by steps that double; then where values say that they would be 0 if they
  /// fell straight, for so long as that is quicker than to go halfway.
  void bisect_powers(double guess) noexcept {
    int least = no_ == 0 ? -1074 : arithmetic::exponent_of(no_) - 1;
    int most = yes_ <= largest ? arithmetic::exponent_of(yes_) : 1024;
    int at = guess > 0 ? arithmetic::exponent_of(guess) : most;
    bool values_tell = true;
    for (int step = 1; !lost_ && most - least > 1; step *= 2) {
      const int way = most - least;
      const bool is_guessed = least < at && at < most;
      const bool is_told = !is_guessed && values_tell && at_no_.has_value && at_yes_.has_value;
      if (!is_guessed) at = (most + least) / 2;
      if (is_told) {
        const int told = most + exponent(at_no_.value) - exponent(at_yes_.value);
        at = told <= least ? least + 1 : told >= most ? most - 1 : told;
      }
      const bool after = is_after(arithmetic::scale_far(1, at));
      (after ? most : least) = at;
      values_tell = !is_told || most - least <= way / 2;
      at = is_guessed ? (after ? most - step : least + step) : most;
    }
  }
  static int exponent(const arithmetic::Scaled& x) noexcept { return x.exponent + arithmetic::exponent_of(x.value); }

  VESICA_COLD double narrowed() noexcept {
    Bracket bracket(no_, yes_, at_no_, at_yes_);
    while (!lost_ && !bracket.is_closed()) {
      const std::uint64_t at = bracket.next();
      const Trial trial = ask_(arithmetic::at_rank<double>(at));
      lost_ = !trial.known;
      bracket.narrow(at, trial);
    }
    return lost_ ? -1 : bracket.floor();
  }

  const Ask& ask_;
  double least_, no_ = 0, yes_ = Limits::infinity();
  Trial at_no_, at_yes_;
  bool lost_ = false;
};

/// Trials of a pair of ellipses whose line enters M after the start and does not graze it, at times above 0.
class EllipseTrials {
 public:
  explicit EllipseTrials(const ExactPair& pair) noexcept
      : pair_(pair), contact_(PairDigits<exact::few_limbs>(pair)), witness_(pair.rough_witness()) {}

  /// As of TrialSearch. A trial is not known where the place then is beyond exact numbers.
  VESICA_COLD double floor(double start, double guess) noexcept {
    const auto ask = [this](double t) { return at(t); };
    return TrialSearch(ask, least_held()).floor(start, between(witness_), guess);
  }

  /// What ExactPair::contact_before() answers; mostly known from the trials before.
  std::int32_t contact_before(double t) const noexcept {
    const int left = t > 0 ? to_witness(t) : 0;
    if (left < 0) return 1;
    if (left == 0 || (latest_before_ < t && t < first_after_)) return pair_.contact_before(t);
    return pair_.holds_place(t) ? (t < first_after_ ? 0 : 1) : static_cast<std::int32_t>(error_range);
  }

 private:
  VESICA_COLD Trial at(double t) noexcept {
    const Trial trial = find(t);
    if (trial.known) (trial.after ? first_after_ : latest_before_) = t;
    return trial;
  }
  /// The least power of two at which the place is within exact numbers, 2^1023 where it is at none. The less the time,
  /// the more digits has the place, but where terms cancel.
  double least_held() const noexcept {
    const auto is_held = [this](int exponent) { return pair_.holds_place(arithmetic::scale_far(1, exponent)); };
    int no = -1075, yes = is_held(no + 1) ? no + 1 : 1023;
    while (yes - no > 1) {
      const int middle = (no + yes) / 2;
      (is_held(middle) ? yes : no) = middle;
    }
    return arithmetic::scale_far(1, yes);
  }
  /// Not known where the place is beyond exact numbers.
  Trial find(double t) noexcept {
    const int left = to_witness(t);
    if (left < 0) return {true, true};
    Trial trial = contact_.at(t);
    if (!trial.known) trial = LeadingContact::exactly_at(pair_, t);
    if (trial.known && (trial.after || left > 0)) return trial;
    const std::int32_t before = pair_.contact_before(t);
    return {before >= 0, before != 0};
  }
  /// The sign of t_w - t, 0 where a few digits do not tell it. Without contact it is before the witness or after.
  int to_witness(double t) const noexcept {
    const Rough left = witness_ - Rough(exact::from_double(t));
    return left.sign_is_known() ? left.sign() : 0;
  }

  const ExactPair& pair_;
  LeadingContact contact_;
  Rough witness_;
  double latest_before_ = 0, first_after_ = std::numeric_limits<double>::infinity();
};

}  // namespace vesica::detail::cast

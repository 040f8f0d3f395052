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

/// A time, and what a trial there told.
struct TriedTime {
  double time;
  Trial trial;
};

/// The doubles between which contact begins, by their ranks.
class Bracket {
 public:
  /// Of the last time tried before contact, the one tried before that, and the first tried after contact. Ranks grow as
  /// times do only within a power of two: a time farther off tells nothing.
  Bracket(const TriedTime& no, const TriedTime& earlier_no, const TriedTime& yes) noexcept
      : no_(no),
        yes_(yes),
        earlier_no_(2 * earlier_no.time < no.time ? TriedTime{0, {}} : earlier_no),
        earlier_(earlier_no_),
        before_(way()) {}

  /// No double is between. Else next() is the rank of one.
  bool is_closed() const noexcept { return way() <= 1; }
  double floor() const noexcept { return arithmetic::at_rank<double>(no_.rank); }
  std::uint64_t next() noexcept {
    // Every fourth trial halves the way, unless it is a sixteenth of what it was four trials ago.
    const bool may_halve = ++trials_ % 4 == 0;
    const bool quick = !may_halve || way() <= before_ / 16;
    if (may_halve) before_ = way();
    const double whole = static_cast<double>(way()), most = static_cast<double>(way() - 1);
    double share = quick ? zero_from_no() : 0.5 * whole;
    if (!(share <= most)) share = share <= whole ? most : 0.5 * whole;
    return no_.rank + (share < 1 ? 1 : static_cast<std::uint64_t>(share));
  }
  void narrow(std::uint64_t at, const Trial& trial) noexcept {
    repeated_ = trials_ > 1 && trial.after == was_after_;
    was_after_ = trial.after;
    margin_ = repeated_ ? most_margin : lane::max(margin_ * margin_, 0x1p-30);
    End& end = trial.after ? yes_ : no_;
    if (!trial.after) earlier_no_ = end;
    earlier_ = end;
    end = {at, trial};
  }

 private:
  struct End {
    std::uint64_t rank;
    Trial trial;
    End(std::uint64_t its_rank, const Trial& its_trial) noexcept : rank(its_rank), trial(its_trial) {}
    explicit End(const TriedTime& x) noexcept : End(arithmetic::rank(x.time), x.trial) {}
    bool has_value() const noexcept { return trial.has_value; }
  };

  static constexpr double unknown = std::numeric_limits<double>::quiet_NaN(), most_margin = 0.125;

  std::uint64_t way() const noexcept { return yes_.rank - no_.rank; }

  /// How far the values' zero is from the last time before contact, in ranks.
  double zero_from_no() const noexcept {
    const double whole = static_cast<double>(way());
    if (!no_.has_value()) return unknown;
    if (!yes_.has_value()) return double_zero_from_no(whole);
    // The parabola through three values, scaled to 1 at 0 and y < 0 at 1, is 0 at 1 / (1 + x), x^2 + slope x + y = 0.
    const double y = ratio(yes_.trial.value, no_.trial.value), slope = 1 + y - bend(y, whole);
    const double root = std::sqrt(slope * slope - 4 * y);
    const double x = slope > 0 ? -2 * y / (slope + root) : 0.5 * (root - slope), from_no = whole / (1 + x);
    if (!repeated_) return from_no;
    // Twice as far from an end that has moved twice, so that the other one moves too.
    return was_after_ ? whole - lane::min(2 * (x * from_no), 0.5 * whole) : lane::min(2 * from_no, 0.5 * whole);
  }
  /// The coefficient of the square, of a parabola through the value before too; 0 where that does not tell it.
  double bend(double y, double whole) const noexcept {
    const double u = static_cast<double>(static_cast<std::int64_t>(earlier_.rank - no_.rank)) / whole;
    const bool is_distinct = std::fabs(u) > 0x1p-40 && std::fabs(u - 1) > 0x1p-40;
    if (!earlier_.has_value() || !is_distinct) return 0;
    const double bend = ((ratio(earlier_.trial.value, no_.trial.value) - 1) / u - (y - 1)) / (u - 1);
    return std::fabs(bend) < 0x1p100 ? bend : 0;
  }
  /// Where contact begins with a double zero no value is negative, and the values' roots fall straight. The place where
  /// they are 0 is missed on purpose, first to the one side, then to the other, by less each time.
  double double_zero_from_no(double whole) const noexcept {
    if (!earlier_no_.has_value()) return unknown;
    const double falling = std::sqrt(ratio(earlier_no_.trial.value, no_.trial.value));
    const double to_zero = static_cast<double>(no_.rank - earlier_no_.rank) / (falling - 1);
    if (was_after_ && repeated_) return 0.5 * whole;
    const double factor = was_after_ ? 1 - margin_ : repeated_ ? 2 : 1 + margin_;
    return lane::min(factor * to_zero, (1 - 0x1p-8) * whole);
  }

  End no_, yes_, earlier_no_;
  End earlier_;                  ///< where that end was that has moved last
  double margin_ = most_margin;  ///< by which share a double zero is missed on purpose
  std::uint64_t before_;
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
  /// by parabolas.
  double floor(double start, const Between& witness, double guess) noexcept {
    if (begins_about(guess) || begins_about(start)) return narrowed();
    if (no_.time == 0) {
      const Trial first = ask_(least_);
      if (first.known && first.after) return least_ > least_double ? -1 : 0;
      if (first.known) no_ = {least_, first};
    }
    if (!begins_at(witness)) {
      bisect_powers(guess);
      if (!lost_ && yes_.time > largest && !is_after(largest)) return yes_.time;
    }
    return narrowed();
  }

 private:
  VESICA_COLD bool is_after(double t) noexcept {
    const Trial trial = ask_(t);
    lost_ = lost_ || !trial.known;
    if (!trial.after) earlier_no_ = no_;
    (trial.after ? yes_ : no_) = {t, trial};
    return trial.after;
  }

  /// Whether contact begins about a time: that is tried, and then others ever farther from it.
  VESICA_COLD bool begins_about(double t) noexcept {
    if (!(no_.time < t && t < yes_.time)) return false;
    const bool after = is_after(t);
    for (std::uint64_t way = 1; way < 0x100000; way *= 64) {
      const std::uint64_t rank = arithmetic::rank(t);
      if (after ? rank <= arithmetic::rank(no_.time) + way : rank + way >= arithmetic::rank(yes_.time)) break;
      t = arithmetic::at_rank<double>(after ? rank - way : rank + way);
      const Trial &at = (after ? yes_ : no_).trial, earlier = at;
      if (is_after(t) != after) return true;
      if (earlier.has_value && ratio(at.value, earlier.value) > 1 - 0x1p-12) break;  // it is 0 far from here
    }
    return false;
  }

  bool begins_at(const Between& witness) noexcept {
    if (!(witness.least > 0 && witness.most <= yes_.time && witness.most <= largest)) return false;
    if (witness.least > no_.time && is_after(witness.least)) return false;
    yes_ = {witness.most, {}};
    return true;
  }

  /// Between what is known: from the guess on by steps that double; then where values say that they would be 0 if they
  /// fell straight, for so long as that is quicker than to go halfway.
  void bisect_powers(double guess) noexcept {
    int least = no_.time == 0 ? -1074 : arithmetic::exponent_of(no_.time) - 1;
    int most = yes_.time <= largest ? arithmetic::exponent_of(yes_.time) : 1024;
    int at = guess > 0 ? arithmetic::exponent_of(guess) : most;
    bool values_tell = true;
    for (int step = 1; !lost_ && most - least > 1; step *= 2) {
      const int way = most - least;
      const bool is_guessed = least < at && at < most;
      const bool is_told = !is_guessed && values_tell && no_.trial.has_value && yes_.trial.has_value;
      if (!is_guessed) at = (most + least) / 2;
      if (is_told) {
        const int told = most + exponent(no_.trial.value) - exponent(yes_.trial.value);
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
    Bracket bracket(no_, earlier_no_, yes_);
    while (!lost_ && !bracket.is_closed()) {
      const std::uint64_t at = bracket.next();
      const Trial trial = ask_(arithmetic::at_rank<double>(at));
      lost_ = !trial.known;
      bracket.narrow(at, trial);
    }
    return lost_ ? -1 : bracket.floor();
  }

  const Ask& ask_;
  double least_;
  TriedTime no_{0, {}}, earlier_no_{0, {}}, yes_{Limits::infinity(), {}};
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

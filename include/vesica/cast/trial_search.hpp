// SPDX-License-Identifier: Apache-2.0
/// The greatest double with no contact before it, by trials of doubles of any magnitude.
#pragma once

#include <vesica/cast/bracket.hpp>
#include <vesica/cast/wide.hpp>

namespace vesica::detail::cast {

/// By how much values have fallen since the start, as a power of the time; where they are 0, that is the value at the
/// start. Logarithms are to base 2, and within a tenth.
class FallOfValues {
 public:
  explicit FallOfValues(const Trial& at_start) noexcept : start_(at_start) {}

  void add(double t, const Trial& trial) noexcept {
    if (!start_.has_value || !trial.has_value) return;
    const Point point{logarithm(t), fall(trial.value)};
    if (!(point.fall > least_fall) || point.time == last_.time) return;
    // Values are polynomials of degree 8.
    if (is_known_) power_ = lane::max(1.0, lane::min((point.fall - last_.fall) / (point.time - last_.time), 8.0));
    last_ = point;
    is_known_ = true;
  }
  bool is_known() const noexcept { return is_known_; }
  bool is_of(int time) const noexcept { return last_.time == time; }
  /// The power of two before the zero of values, by the last two of them, between two others.
  int power_before_zero(int least, int most) const noexcept {
    const double told = std::floor(last_.time - last_.fall / power_);
    return told <= least ? least + 1 : told >= most ? most - 1 : static_cast<int>(told);
  }

 private:
  /// Logarithms of a time, and of the fall until then over the value at the start.
  struct Point {
    double time, fall;
  };
  static constexpr double least_fall = -20;  ///< of a lesser one digits have cancelled

  double fall(const arithmetic::Scaled& value) const noexcept {
    const double part = 1 - ratio(value, start_.value);
    if (std::fabs(part) <= std::numeric_limits<double>::max()) return part > 0 ? logarithm(part) : 2 * least_fall;
    return logarithm(value) - logarithm(start_.value);
  }
  static double logarithm(const arithmetic::Scaled& x) noexcept { return logarithm(x.value) + x.exponent; }
  static double logarithm(double x) noexcept {
    const int exponent = arithmetic::exponent_of(x);
    return exponent + 2 * (arithmetic::scale_far(std::fabs(x), -exponent) - 1);
  }

  Trial start_;
  Point last_{0, 0};
  double power_ = 1;
  bool is_known_ = false;
};

/// A search for the greatest double with no contact before it, for which ask(t) is answered by trials. `at_start`: what
/// one tells at 0, before contact. Trials at times above 0 and below `least` are likely not to be known.
template <class Ask>
class TrialSearch {
  using Limits = std::numeric_limits<double>;
  static constexpr double least_double = Limits::denorm_min(), largest = Limits::max();
  static constexpr int longest_step = 8;  ///< of powers of two, from a guess

 public:
  TrialSearch(const Ask& ask, const Trial& at_start, double least = least_double) noexcept
      : ask_(ask), fall_(at_start), least_(least) {}

  /// Infinite where there is no contact before the largest double, negative where a trial that was needed is not known.
  /// A guess above 0 is not after contact, and mostly not long before it. Contact often begins beside the guess or
  /// `start`, or about the witness, which it never is after. Else first the power of two is bisected, then the zero of
  /// the discriminant is approached by parabolas.
  double floor(double start, const Between& witness, double guess) noexcept {
    if (begins_about(guess) || begins_about(start) || begins_at(witness)) return narrowed();
    bisect_powers(guess);
    if (!lost_ && yes_.time > largest && !is_after(largest)) return yes_.time;
    if (!lost_ && no_.time == 0 && is_after(least_)) return least_ > least_double ? -1 : 0;
    return narrowed();
  }

 private:
  VESICA_COLD bool is_after(double t) noexcept {
    const Trial trial = ask_(t);
    lost_ = lost_ || !trial.known;
    if (!trial.after) earlier_no_ = no_;
    (trial.after ? yes_ : no_) = {t, trial};
    fall_.add(t, trial);
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
    if (!(witness.least > no_.time && witness.most <= yes_.time && witness.most <= largest)) return false;
    if (is_after(witness.least)) return false;
    yes_ = {witness.most, {}};
    return true;
  }

  /// From the guess on by steps that double; then from where values say that they would be 0, and half way after they
  /// have misled. Nothing is tried at `least_` and below.
  void bisect_powers(double guess) noexcept {
    int least = arithmetic::exponent_of(no_.time == 0 ? least_ : no_.time) - 1;
    int most = yes_.time <= largest ? arithmetic::exponent_of(yes_.time) : 1024;
    int at = guess > 0 ? arithmetic::exponent_of(guess) : most, step = 1;
    bool is_misled = false;  // by values, which told nothing or did not halve the way
    while (!lost_ && most - least > 1) {
      const int way = most - least;
      const bool is_near = least < at && at < most && step <= longest_step;
      const bool is_told = !is_near && !is_misled && fall_.is_known();
      if (!is_near) at = is_told ? fall_.power_before_zero(least, most) : (most + least) / 2;
      (is_after(arithmetic::scale_far(1, at)) ? most : least) = at;
      if (!is_near) {
        const bool is_new = is_told && fall_.is_of(at);
        is_misled = is_told && !(is_new && most - least <= way / 2);
        step = is_new ? 1 : 2 * longest_step;  // a little before contact
      }
      at += step;
      step *= 2;
    }
  }

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
  FallOfValues fall_;
  double least_;
  TriedTime no_{0, {}}, earlier_no_{0, {}}, yes_{Limits::infinity(), {}};
  bool lost_ = false;
};

}  // namespace vesica::detail::cast

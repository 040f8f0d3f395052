// SPDX-License-Identifier: Apache-2.0
/// Two doubles between which contact begins, brought together by trials.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vesica/arithmetic/rounding.hpp>
#include <vesica/cast/trial.hpp>

namespace vesica::detail::cast {

/// To a few digits, of a number that is not 0; the same on all machines.
inline double cube_root(double x) noexcept {
  const int third = (arithmetic::exponent_of(x) + 3 * 1000) / 3 - 1000;
  const double a = arithmetic::scale_far(std::fabs(x), -3 * third);
  double root = 1;  // of a in [1/2, 4)
  for (int i = 0; i < 5; ++i) root -= (root - a / (root * root)) / 3;
  return std::copysign(arithmetic::scale_far(root, third), x);
}

inline double signed_root(double x) noexcept { return std::copysign(std::sqrt(std::fabs(x)), x); }

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
    // Where four trials did not make the way a sixteenth, the next one halves it; after three times three of four do.
    const int of_four = ++trials_ % 4;
    if (of_four == 0) {
      slow_ = way() > before_ / 16 ? slow_ + 1 : 0;
      before_ = way();
    }
    was_halved_ = halves_;
    halves_ = slow_ > 2 ? of_four != 3 : slow_ > 0 && of_four == 0;
    const double whole = static_cast<double>(way()), most = static_cast<double>(way() - 1);
    double share = halves_ ? 0.5 * whole : zero_from_no();
    if (!(share <= most)) share = share <= whole ? most : 0.5 * whole;
    return no_.rank + (share < 1 ? 1 : static_cast<std::uint64_t>(share));
  }
  void narrow(std::uint64_t at, const Trial& trial) noexcept {
    repeated_ = trials_ > 1 && trial.after == was_after_;
    was_after_ = trial.after;
    margin_ = repeated_ ? most_margin : lane::max(margin_ * margin_, 0x1p-30);
    End& end = trial.after ? yes_ : no_;
    if (!trial.after) earliest_no_ = earlier_no_, earlier_no_ = end;
    earlier_ = end;
    end = {at, trial};
    const bool is_again_after = repeated_ && was_after_ && no_.has_value() && yes_.has_value();
    is_flat_ = is_flat_ || (is_again_after && is_tiny_after());
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
  double zero_from_no() noexcept {
    const double whole = static_cast<double>(way());
    if (!no_.has_value()) return yes_.has_value() ? 0 : unknown;  // it is 0 there
    if (!has_negative()) return earlier_no_.has_value() ? even_zero_from_no(whole) : unknown;
    const Parabola through[] = {parabola(whole, [](double value) { return value; }), parabola(whole, signed_root),
                                parabola(whole, cube_root)};
    if (through[0].bend != 0) {
      int straightest = 0;
      double least = 0x1p-4 * std::fabs(through[0].bend);
      for (int i = 1; i < 3; ++i) {
        const double bend = std::fabs(through[i].bend);
        if (bend != 0 && bend < least) straightest = i, least = bend;
      }
      root_ = straightest;
    }
    const double from_no = whole * through[root_].zero(), from_yes = whole - from_no;
    if (!repeated_ || was_halved_) return from_no;
    // Twice as far from an end that has moved twice, but no nearer to the other than half: so that it moves too.
    return was_after_ ? lane::max(from_no - from_yes, 0.5 * from_no)
                      : whole - lane::max(from_yes - from_no, 0.5 * from_yes);
  }
  /// 1 at 0 and y < 0 at 1, with `bend` as the coefficient of the square.
  struct Parabola {
    double y, bend;
    /// Where it is 0: 1 / (1 + x) with x^2 + slope x + y = 0.
    double zero() const noexcept {
      const double slope = 1 + y - bend, root = std::sqrt(slope * slope - 4 * y);
      return 1 / (1 + (slope > 0 ? -2 * y / (slope + root) : 0.5 * (root - slope)));
    }
  };
  /// Through what `of` makes of the values at both ends, over that at the first, and of the value before; without a
  /// bend where that does not tell it.
  template <class Of>
  Parabola parabola(double whole, const Of& of) const noexcept {
    const auto part = [&](const End& end) { return of(ratio(end.trial.value, no_.trial.value)); };
    const double y = part(yes_), u = static_cast<double>(static_cast<std::int64_t>(earlier_.rank - no_.rank)) / whole;
    const bool is_distinct = std::fabs(u) > 0x1p-40 && std::fabs(u - 1) > 0x1p-40;
    if (!earlier_.has_value() || !is_distinct) return {y, 0};
    const double bend = ((part(earlier_) - 1) / u - (y - 1)) / (u - 1);
    return {y, std::fabs(bend) < 0x1p100 ? bend : 0};
  }
  /// Whether a value after contact tells where the zero is: not if it is next to nothing and has told nothing before.
  bool has_negative() const noexcept { return yes_.has_value() && !(is_flat_ && is_tiny_after()); }
  bool is_tiny_after() const noexcept { return -ratio(yes_.trial.value, no_.trial.value) < 0x1p-16; }
  /// Else by values before contact alone. They fall as to a zero of order 2, 4 or 8, and their roots of that order fall
  /// straight. The place where these are 0 is missed on purpose, first to the one side, then to the other, by less each
  /// time.
  double even_zero_from_no(double whole) const noexcept {
    if (was_after_ && repeated_) return 0.5 * whole;
    const double factor = was_after_ ? 1 - margin_ : repeated_ ? 2 : 1 + margin_;
    return lane::min(factor * even_zero(), (1 - 0x1p-8) * whole);
  }
  /// By the last two values before contact, and the order for which they tell most nearly what the two before told.
  double even_zero() const noexcept {
    const bool has_earliest = earliest_no_.has_value();
    double falling = ratio(earlier_no_.trial.value, no_.trial.value);
    double before = has_earliest ? ratio(earliest_no_.trial.value, earlier_no_.trial.value) : 1;
    double nearest = unknown, least = std::numeric_limits<double>::infinity();
    for (int order = 2; order <= (has_earliest ? 8 : 2); order *= 2) {
      falling = std::sqrt(falling), before = std::sqrt(before);
      const double from_no = ranks(earlier_no_, no_) / (falling - 1);
      const double told = ranks(earliest_no_, earlier_no_) / (before - 1) - ranks(earlier_no_, no_);
      const double off = std::fabs(told / from_no - 1);
      if (order == 2 || off < least) nearest = from_no, least = off;
    }
    return nearest;
  }
  static double ranks(const End& from, const End& to) noexcept { return static_cast<double>(to.rank - from.rank); }

  End no_, yes_, earlier_no_, earliest_no_{0, {}};
  End earlier_;                  ///< where that end was that has moved last
  double margin_ = most_margin;  ///< by which share an even zero is missed on purpose
  std::uint64_t before_;
  int trials_ = 0, slow_ = 0;
  bool halves_ = false, was_halved_ = false, was_after_ = false, repeated_ = false;
  bool is_flat_ = false;  ///< after contact: once a tiny value there was followed by another
  int root_ = 0;          ///< which of values, their roots and their cube roots fall most nearly straight
};

}  // namespace vesica::detail::cast

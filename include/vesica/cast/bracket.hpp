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
  double zero_from_no() noexcept {
    const double whole = static_cast<double>(way());
    if (!no_.has_value()) return yes_.has_value() ? 0 : unknown;  // it is 0 there
    if (!yes_.has_value()) return double_zero_from_no(whole);
    const Parabola of_values = parabola(whole, [](double value) { return value; });
    const Parabola of_roots = parabola(whole, cube_root);
    if (of_values.bend != 0 && of_roots.bend != 0) {
      is_triple_ = std::fabs(of_roots.bend) < 0x1p-4 * std::fabs(of_values.bend);
    }
    const double from_no = whole * (is_triple_ ? of_roots : of_values).zero(), from_yes = whole - from_no;
    if (!repeated_) return from_no;
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
  bool is_triple_ = false;  ///< the zero: cube roots of values fall straight there
};

}  // namespace vesica::detail::cast

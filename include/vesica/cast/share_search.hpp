// SPDX-License-Identifier: Apache-2.0
/// Finds the positive zero of a function over all magnitudes, from its sign and the step of Newton's method alone:
/// first the exponent of the zero, then the zero.
#pragma once

#include <vesica/arithmetic/wide.hpp>

namespace vesica::detail::cast {

using arithmetic::Wide;

/// A search over all magnitudes, for steps too long to be taken.
class ShareSearch {
 public:
  static constexpr int limit = 1 << 20;  ///< beyond the exponents of l

  /// The l to look at after this one, from which such a step leads; 0 where none is left. The exponent is looked for
  /// first, farther each time and then between; or where two steps of one sign say that they become as long as l. Once
  /// it is known nearly, the step is taken if it stays within the bracket.
  Wide next(const Wide& l, const Wide& step) noexcept {
    const int sign = step.sign();
    End& end = sign > 0 ? low_ : high_;
    const End earlier = end;
    end = {l, step.exponent - l.exponent, true};
    const bool is_between = low_.is_known && high_.is_known;
    const int low = low_.is_known ? low_.l.exponent : -limit, high = high_.is_known ? high_.l.exponent : limit;
    if (is_between && high - low <= 2) {
      const Wide there = l + step;
      return low_.l < there && there < high_.l ? there : Wide(0.5, 0) * (low_.l + high_.l);
    }
    // From a step far longer than l to one as long: it is near.
    const bool is_near = earlier.is_known && earlier.excess > 2 && std::abs(end.excess) <= 1;
    const bool is_third = ++looked_ % 3 == 0;
    const int told = is_near ? l.exponent + sign : is_third ? l.exponent : equal_exponent(earlier, end);
    if (low < told && told < high) return {1, told};
    if (is_between) return {1, (low + high) / 2};
    if (way_ > limit / 64) return {};
    const Wide there{1, l.exponent + sign * way_};
    way_ *= 4;
    return there;
  }

 private:
  struct End {
    Wide l;
    int excess = 0;  ///< of the step's exponent over that of l
    bool is_known = false;
  };

  /// The exponent of l where the excess would be 0, as it goes on from one end to the next; that of the latter where it
  /// does not tell.
  static int equal_exponent(const End& earlier, const End& end) noexcept {
    const int way = end.l.exponent - earlier.l.exponent, fall = earlier.excess - end.excess;
    if (!earlier.is_known || fall == 0) return end.l.exponent;
    const double further = static_cast<double>(end.excess) / fall * way;
    return further > -limit && further < limit ? end.l.exponent + static_cast<int>(further) : end.l.exponent;
  }

  End low_, high_;
  int way_ = 1, looked_ = 0;
};

}  // namespace vesica::detail::cast

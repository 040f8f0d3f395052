// SPDX-License-Identifier: Apache-2.0
/// The parts of filters: a computed value with a bound on its error, and the answer that the bound allows.
///
/// Every filter is a template over V: lanes of double or float for batches, and double for scalar calls. Some have an
/// overload for scalar calls, in TwoDoubles: the same formulas, so the same bounds. In the comments
/// u is the greatest relative error of one operation, and errors are to first order in u; the constants in the code
/// leave room for the rest, and tests/filter measures observed error over bound. Fused operations only drop roundings,
/// so the bounds hold with and without them.
///
/// For double u is a whole unit in the last place, 2^-52, so that bounds hold in every rounding mode: calls about two
/// shapes run their filter in the caller's mode. Lanes run in the default mode, where u is half a unit. A directed
/// rounding may give the largest finite number in place of infinity. So every filter limits its error, which includes
/// all magnitudes. If subnormals are flushed, callers do not run filters.
///
/// Checks for validity cost almost nothing. NaN and infinity reach every bound by addition, and no comparison with a
/// bound that is NaN or infinite is true: such input stays undecided. Only negative sizes and zero axes would pass
/// unseen, so the guard of each filter looks at those. What is undecided goes to the exact stage, which first checks.
#pragma once

#include <vesica/scalar.hpp>
#include <vesica/shapes.hpp>
#include <vesica/two_doubles.hpp>

namespace vesica::filter {

using namespace lane;  // for scalars; lanes of a vector bring the same names by argument-dependent lookup

/// |value - true value| <= error, unless error is NaN.
template <class V>
struct Estimate {
  V value;
  V error;
};

template <class V>
VESICA_INLINE constexpr auto certainly_positive(const Estimate<V>& e) noexcept {
  return e.value > e.error;
}

template <class V>
VESICA_INLINE constexpr auto certainly_negative(const Estimate<V>& e) noexcept {
  return e.value < -e.error;
}

/// A filter's answer; both false means undecided. For lanes the two are masks.
template <class Mask>
struct Verdict {
  Mask overlap;
  Mask disjoint;
};

/// A filter's answer that means nothing where it is not decided.
template <class Mask>
struct DecidedVerdict {
  Mask overlap;
  Mask decided;
  constexpr operator Verdict<Mask>() const noexcept { return {both(decided, overlap), and_not(decided, overlap)}; }
};

/// Either kind of answer as two masks.
template <class Mask>
VESICA_INLINE constexpr Verdict<Mask> in_masks(const Verdict<Mask>& v) noexcept {
  return v;
}
template <class Mask>
VESICA_INLINE constexpr Verdict<Mask> in_masks(const DecidedVerdict<Mask>& v) noexcept {
  return v;
}

/// No answer outside the guard.
template <class Mask>
VESICA_INLINE constexpr Verdict<Mask> guarded(Mask guard, Mask overlap, Mask disjoint) noexcept {
  return {both(guard, overlap), both(guard, disjoint)};
}

/// Two shapes overlap where the estimate is certainly negative and are disjoint where it is certainly positive.
template <class Mask, class V>
VESICA_INLINE constexpr Verdict<Mask> guarded(Mask guard, const Estimate<V>& gap) noexcept {
  return guarded(guard, certainly_negative(gap), certainly_positive(gap));
}

/// For one pair, one condition to test instead of two.
VESICA_INLINE constexpr DecidedVerdict<bool> guarded(bool guard, const Estimate<double>& gap) noexcept {
  return {gap.value < 0, both(guard, abs(gap.value) > gap.error)};
}

#if VESICA_HAS_TWO_DOUBLES
/// The same for the greater of two gaps. In every rounding mode a rounded sum has the right sign. No bound is attained,
/// so a sum that is 0 may count as either sign.
VESICA_INLINE DecidedVerdict<bool> guarded(bool guard, const Estimate<TwoDoubles>& gaps) noexcept {
  const bool overlap = signs(gaps.value + gaps.error) == 3, touch = signs(gaps.value - gaps.error) == 3;
  return {overlap, both(guard, overlap == touch)};
}
#endif

/// The element type of V: double or float, or what lanes are made of.
template <class V>
struct Element {
  using Type = typename V::Element;
};
template <>
struct Element<double> {
  using Type = double;
};
template <>
struct Element<float> {
  using Type = float;
};

/// Numbers of one pair of shapes, whose filter runs in its caller's rounding mode.
template <class V>
inline constexpr bool is_scalar = std::is_same_v<V, double>;
#if VESICA_HAS_TWO_DOUBLES
template <>
inline constexpr bool is_scalar<lane::TwoDoubles> = true;
#endif

/// n u.
template <class V>
VESICA_INLINE constexpr V roundoffs(int n) noexcept {
  using T = typename Element<V>::Type;
  constexpr int in_any_mode = is_scalar<V> ? 2 : 1;
  return V(static_cast<T>(in_any_mode * n) * ScalarTraits<T>::roundoff);
}

/// 2^e for float, 2^(8 e) for double: a guard chosen by float's narrower range serves both.
template <class V, int e>
VESICA_INLINE constexpr V guard_power() noexcept {
  using Traits = ScalarTraits<typename Element<V>::Type>;
  return V(Traits::power(Traits::range * e));
}

/// No magnitude of a degree-3 filter is beyond the range where its error is at most this: with axes of at least 2^-200,
/// offsets of the largest finite number would make it 2^770.
template <class V>
VESICA_INLINE constexpr V greatest_error() noexcept {
  using T = typename Element<V>::Type;
  return V(ScalarTraits<T>::power(sizeof(T) == 4 ? 100 : 760));
}

/// Covers what underflow can add to the errors of degree-3 filters, with axes no longer than 2^25 (double: 2^200).
template <class V>
VESICA_INLINE constexpr V underflow_allowance() noexcept {
  return guard_power<V, -87>();
}

/// All values >= bound. Not by min(): of numbers widened from float g++ makes branches.
template <class V, class... W>
VESICA_INLINE constexpr auto at_least(V bound, V first, W... rest) noexcept {
  if constexpr (sizeof...(rest) == 0) {
    return first >= bound;
  } else {
    return both(first >= bound, at_least(bound, rest...));
  }
}

template <class V>
VESICA_INLINE constexpr auto in_range(V x, V low, V high) noexcept {
  return both(x >= low, x <= high);
}

}  // namespace vesica::filter

// SPDX-License-Identifier: Apache-2.0
/// Certain facts about the relation of two shapes, as filters find them.
#pragma once

#include <vesica/filter/estimate.hpp>

namespace vesica::filter {

/// Each member is true only where it is certain; for lanes they are masks.
template <class Mask>
struct CertainFacts {
  Mask disjoint;
  Mask crossing;  ///< the insides meet; whether one shape contains the other is for the rest to say
  Mask inside;    ///< b contains a, and a stays clear of b's outline
  Mask contains;  ///< a contains b, and b stays clear of a's outline
  Mask neither;   ///< neither contains the other

  /// The facts with a and b exchanged.
  constexpr CertainFacts exchanged() const noexcept { return {disjoint, crossing, contains, inside, neither}; }
};

/// The facts about shapes that are known to be disjoint.
VESICA_INLINE constexpr CertainFacts<bool> apart() noexcept { return {true, false, false, false, true}; }

/// Nothing outside the guard.
template <class Mask>
VESICA_INLINE constexpr CertainFacts<Mask> guarded(Mask guard, const CertainFacts<Mask>& s) noexcept {
  return {both(guard, s.disjoint), both(guard, s.crossing), both(guard, s.inside), both(guard, s.contains),
          both(guard, s.neither)};
}

/// The facts from three estimates: the gap between a and b, how far a reaches out of b, and b out of a.
template <class V>
VESICA_INLINE constexpr auto certain_facts(const Estimate<V>& gap, const Estimate<V>& a_out_of_b,
                                           const Estimate<V>& b_out_of_a) noexcept {
  return CertainFacts<decltype(gap.value > gap.error)>{
      certainly_positive(gap), certainly_negative(gap), certainly_negative(a_out_of_b), certainly_negative(b_out_of_a),
      both(certainly_positive(a_out_of_b), certainly_positive(b_out_of_a))};
}

/// The facts if only one known shape of the two can contain the other: `nested` and `neither` say whether it does.
template <class Mask>
VESICA_INLINE constexpr CertainFacts<Mask> certain_facts(const Verdict<Mask>& v, Mask nested, Mask neither,
                                                         Mask first_greater) noexcept {
  const Mask inside = and_not(nested, first_greater), contains = both(nested, first_greater);
  return {v.disjoint, v.overlap, inside, contains, neither};
}

template <class Mask>
VESICA_INLINE constexpr CertainFacts<Mask> certain_facts(const DecidedVerdict<Mask>& v, Mask nested, Mask neither,
                                                         Mask first_greater) noexcept {
  return certain_facts(Verdict<Mask>(v), nested, neither, first_greater);
}

/// The facts about a point, first, and a solid shape, which the point never contains.
template <class Mask>
VESICA_INLINE constexpr CertainFacts<Mask> of_point(const Verdict<Mask>& v) noexcept {
  const Mask never = both(v.overlap, v.disjoint);
  return {v.disjoint, v.overlap, v.overlap, never, v.disjoint};
}

template <class Mask>
VESICA_INLINE constexpr CertainFacts<Mask> of_point(const DecidedVerdict<Mask>& v) noexcept {
  return of_point(Verdict<Mask>(v));
}

/// The relations that are certain; none of them true means undecided.
template <class Mask>
struct CertainRelation {
  Mask disjoint, cross, inside, contains;
};

template <class Mask>
VESICA_INLINE constexpr CertainRelation<Mask> certain_relation(const CertainFacts<Mask>& s) noexcept {
  return {s.disjoint, both(s.crossing, s.neither), s.inside, s.contains};
}

}  // namespace vesica::filter

// SPDX-License-Identifier: Apache-2.0
#include <vesica/nearest.hpp>

#include "query.hpp"

namespace vesica::queries {

namespace {

struct NearestOfPair {
  static constexpr Reversal reversal = Reversal::points;
  template <class T>
  using Result = ClosestPoints<T>;
  template <class A, class B, class Result>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b, Result& out) noexcept {
    return nearest_or_error(a, b, out);
  }
  /// By the function of doubles, which is long: a call costs less than a second one would.
  template <template <class> class A, template <class> class B>
  VESICA_INLINE static std::int32_t answer(const A<float>& a, const B<float>& b, ClosestPoints<float>& out) noexcept {
    const A<double> wide_a = widen(a);
    const B<double> wide_b = widen(b);
    ClosestPoints<double> found;
    const std::int32_t error = answer_pair<NearestOfPair, A<double>, B<double>>(&wide_a, &wide_b, &found);
    if (error != 0) return error;
    return detail::nearest::rounded_to(found, found.distance == 0, out) ? 0 : error_range;
  }
};

}  // namespace

constinit const Query nearest{
    .doubles = pair_table<NearestOfPair, double>(),
    .floats = pair_table<NearestOfPair, float>(),
    .reversal = NearestOfPair::reversal,
    .numbers = 5,
    .is_length = true,
    .counts_zero = true,
    .kernels = &QueryTable::nearest,
    .known = Known::overlap,
};

}  // namespace vesica::queries

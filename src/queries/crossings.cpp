// SPDX-License-Identifier: Apache-2.0
#include <vesica/crossings.hpp>

#include "compiled_once.hpp"
#include "query.hpp"

namespace vesica {

#define VESICA_DEFINE(a, A, b, B) VESICA_ONE_PLACE(template, A, B)
VESICA_EACH_PAIR_OF_FORMS(VESICA_DEFINE)
#undef VESICA_DEFINE

}  // namespace vesica

namespace vesica::queries {

namespace {

struct CrossingsOfPair {
  static constexpr Reversal reversal = Reversal::unknown;
  template <class A, class B>
  static constexpr bool answers = HasCore<A>&& HasCore<B>;
  template <class T>
  using Result = CrossingPoints<T>;
  template <class A, class B, class Result>
  VESICA_INLINE static std::int32_t answer(const A& a, const B& b, Result& out) noexcept {
    return crossings_or_error(a, b, out);
  }
  /// The places of doubles, rounded.
  template <template <class> class A, template <class> class B>
  VESICA_INLINE static std::int32_t answer(const A<float>& a, const B<float>& b, CrossingPoints<float>& out) noexcept {
    const A<double> wide_a = widen(a);
    const B<double> wide_b = widen(b);
    CrossingPoints<double> places;
    const std::int32_t count = answer_pair<CrossingsOfPair, A<double>, B<double>>(&wide_a, &wide_b, &places);
    return count < 0 ? count : detail::crossings::store(places, out);
  }
};

}  // namespace

// Places are in order along the first shape, so the result of (b, a) does not give the result of (a, b). There are no
// batches.
constinit const Query crossings{
    .doubles = pair_table<CrossingsOfPair, double>(),
    .floats = pair_table<CrossingsOfPair, float>(),
    .reversal = CrossingsOfPair::reversal,
    .paths = polygon::crossings,
};

}  // namespace vesica::queries

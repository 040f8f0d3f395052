// SPDX-License-Identifier: Apache-2.0
// The kernels that decide exact contacts. Included once by each src/isa/<set>_ties.cpp, after that set's lanes.
#pragma once

#include <vesica/filter/error_free.hpp>

#include "kernels/block_loop.hpp"

namespace vesica {
namespace {

/// The pair's own filter, and an evaluation without errors where it leaves a lane of the vector undecided.
struct WithTies {
  template <class A, class B>
  VESICA_INLINE static auto filter(const A& a, const B& b) noexcept {
    const auto bounded = detail::overlap::filter(a, b);
    if (all(decided(bounded))) return bounded;
    const auto exact = filter::error_free(a, b);
    return decltype(bounded){either(bounded.overlap, exact.overlap), either(bounded.disjoint, exact.disjoint)};
  }
};

/// Whether lanes gain. Of two boxes, two lanes of SSE2 take as long as two scalar calls or longer: those see at once
/// whether the numbers have few digits.
template <template <class> class A, template <class> class B>
inline constexpr bool ties_gain =
#if defined(__SSE2__) && !defined(__AVX__)
    kind_of<A> == Kind::circle || kind_of<B> == Kind::circle;
#else
    true;
#endif

template <template <class> class A, template <class> class B>
consteval void fill_ties(TieKernels& kernels) noexcept {
  if constexpr (ties_gain<A, B> && filter::HasErrorFree<A<double>, B<double>>) {
    kernels.of[static_cast<int>(kind_of<A>)][static_cast<int>(kind_of<B>)] =
        answer_vectors<WithTies, A, B, double, Repeat::none>;
  }
}

consteval TieKernels make_tie_kernels() noexcept {
  TieKernels kernels{};
#define VESICA_FILL(a, A, b, B) fill_ties<A, B>(kernels);
  VESICA_EACH_PAIR(VESICA_FILL)
#undef VESICA_FILL
  return kernels;
}

}  // namespace
}  // namespace vesica

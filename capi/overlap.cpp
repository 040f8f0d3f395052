// SPDX-License-Identifier: Apache-2.0
#include "queries/overlap.hpp"

#include "environment.hpp"
#include "query.hpp"
#include "vesica.h"

namespace {

/// The answer in the default environment, for a caller in another one.
template <class A, class B>
[[gnu::noinline, gnu::cold]] int32_t elsewhere(const void* a, const void* b) noexcept {
  using Pair = int32_t (*)(const void*, const void*, void*) noexcept;
  return vesica::capi::call_in_default_environment(
      static_cast<Pair>(vesica::answer_pair<vesica::queries::OverlapOfPair, A, B>), a, b, nullptr);
}

/// Asked by calls that have not read the control register. In the default environment a filter left the pair undecided.
template <class A, class B>
int32_t rest_of_call(const void* a, const void* b) noexcept {
  if (!vesica::capi::in_default_environment()) return elsewhere<A, B>(a, b);
  return vesica::detail::decide_undecided(*static_cast<const A*>(a), *static_cast<const B*>(b));
}

/// The C structs are the core's shapes byte for byte, and are read in place.
template <template <class> class A, template <class> class B, class T>
VESICA_INLINE int32_t overlap_typed(const void* a, const void* b) noexcept {
  if (a == nullptr || b == nullptr) return VESICA_E_NULL;
  constexpr auto kind_a = static_cast<int>(vesica::kind_of<A>), kind_b = static_cast<int>(vesica::kind_of<B>);
  const vesica::CallTable* const calls = vesica::chosen_calls();
  if (calls != nullptr) [[likely]]
    return calls->of(T{})[kind_a][kind_b](a, b, rest_of_call<A<T>, B<T>>);
  if (!vesica::capi::in_default_environment()) [[unlikely]]
    return elsewhere<A<T>, B<T>>(a, b);
  return vesica::answer_pair<vesica::queries::OverlapOfPair, A<T>, B<T>>(a, b, nullptr);
}

}  // namespace

int32_t vesica_overlap_f64(int32_t kind_a, const double* numbers_a, int32_t kind_b, const double* numbers_b) {
  VESICA_DEFAULT_ENVIRONMENT(vesica_overlap_f64, kind_a, numbers_a, kind_b, numbers_b);
  return vesica::ask(vesica::queries::overlap, kind_a, numbers_a, kind_b, numbers_b, nullptr);
}

int32_t vesica_overlap_f32(int32_t kind_a, const float* numbers_a, int32_t kind_b, const float* numbers_b) {
  VESICA_DEFAULT_ENVIRONMENT(vesica_overlap_f32, kind_a, numbers_a, kind_b, numbers_b);
  return vesica::ask(vesica::queries::overlap, kind_a, numbers_a, kind_b, numbers_b, nullptr);
}

#define VESICA_PAIR_OF(a, A, b, B, scalar, T)                                                                   \
  int32_t vesica_overlap_##a##_##b##_##scalar(const vesica_##a##_##scalar* s, const vesica_##b##_##scalar* t) { \
    return overlap_typed<vesica::A, vesica::B, T>(s, t);                                                        \
  }
#define VESICA_PAIR(a, A, b, B) VESICA_PAIR_OF(a, A, b, B, f64, double) VESICA_PAIR_OF(a, A, b, B, f32, float)

VESICA_EACH_PAIR(VESICA_PAIR)

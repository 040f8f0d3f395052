// SPDX-License-Identifier: Apache-2.0
#include "queries/overlap.hpp"

#include <utility>

#include "environment.hpp"
#include "query.hpp"
#include "vesica.h"

namespace {

using vesica::ShapeTraits;

template <class Shape>
constexpr auto kind = static_cast<int32_t>(ShapeTraits<Shape>::kind);

/// The answer in the default environment, for a caller in another one.
template <class A, class B>
[[gnu::noinline, gnu::cold]] int32_t overlap_elsewhere(const void* a, const void* b) noexcept {
  using Pair = int32_t (*)(const void*, const void*, void*) noexcept;
  return vesica::capi::call_in_default_environment(
      static_cast<Pair>(vesica::answer_pair<vesica::queries::OverlapOfPair, A, B>), a, b, nullptr);
}

/// For calls that have not read the control register: in the default environment they left the pair undecided.
template <class A, class B>
int32_t rest_of_call(const void* a, const void* b) noexcept {
  if (!vesica::capi::in_default_environment()) return overlap_elsewhere<A, B>(a, b);
  return vesica::detail::decide_undecided(*static_cast<const A*>(a), *static_cast<const B*>(b));
}

/// The same for calls by kind.
struct RestOfCalls {
  vesica::RestOfCall of[vesica::kind_count][vesica::kind_count];
};
template <class T>
consteval RestOfCalls rest_of_calls() noexcept {
  RestOfCalls rest{};
#define VESICA_REST(a, A, b, B) \
  rest.of[kind<vesica::A<T>>][kind<vesica::B<T>>] = rest_of_call<vesica::A<T>, vesica::B<T>>;
  VESICA_EACH_PAIR(VESICA_REST)
#undef VESICA_REST
  return rest;
}
template <class T>
constinit const RestOfCalls rest_by_kind = rest_of_calls<T>();

/// The C structs are the core's shapes byte for byte, and are read in place.
template <class A, class B>
VESICA_INLINE int32_t overlap_typed(const void* a, const void* b) noexcept {
  using T = typename ShapeTraits<A>::Scalar;
  if (a == nullptr || b == nullptr) return VESICA_E_NULL;
  const vesica::CallTable* const calls = vesica::chosen_calls();
  if (calls != nullptr) [[likely]]
    return calls->of(T{})[kind<A>][kind<B>](a, b, rest_of_call<A, B>);
  if (!vesica::capi::in_default_environment()) [[unlikely]]
    return overlap_elsewhere<A, B>(a, b);
  return vesica::answer_pair<vesica::queries::OverlapOfPair, A, B>(a, b, nullptr);
}

template <class T>
int32_t overlap_by_table(int32_t kind_a, const void* a, int32_t kind_b, const void* b) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(overlap_by_table<T>, kind_a, a, kind_b, b);
  return vesica::ask<T>(vesica::queries::overlap, kind_a, a, kind_b, b, nullptr);
}

template <class T>
VESICA_INLINE int32_t overlap_by_kind(int32_t kind_a, const void* a, int32_t kind_b, const void* b) noexcept {
  const vesica::CallTable* const calls = vesica::chosen_calls();
  const bool asked_well = a != nullptr && b != nullptr && vesica::is_kind(kind_a) && vesica::is_kind(kind_b);
  if (calls == nullptr || !asked_well) return overlap_by_table<T>(kind_a, a, kind_b, b);
  if (kind_a > kind_b) {
    std::swap(kind_a, kind_b);
    std::swap(a, b);
  }
  return calls->of(T{})[kind_a][kind_b](a, b, rest_by_kind<T>.of[kind_a][kind_b]);
}

}  // namespace

int32_t vesica_overlap_f64(int32_t kind_a, const void* a, int32_t kind_b, const void* b) {
  return overlap_by_kind<double>(kind_a, a, kind_b, b);
}

int32_t vesica_overlap_f32(int32_t kind_a, const void* a, int32_t kind_b, const void* b) {
  return overlap_by_kind<float>(kind_a, a, kind_b, b);
}

#define VESICA_PAIR_OF(a, A, b, B, scalar, T)                                                                   \
  int32_t vesica_overlap_##a##_##b##_##scalar(const vesica_##a##_##scalar* s, const vesica_##b##_##scalar* t) { \
    return overlap_typed<vesica::A<T>, vesica::B<T>>(s, t);                                                     \
  }
#define VESICA_PAIR(a, A, b, B) VESICA_PAIR_OF(a, A, b, B, f64, double) VESICA_PAIR_OF(a, A, b, B, f32, float)

VESICA_EACH_PAIR_OF_FORMS(VESICA_PAIR)

// SPDX-License-Identifier: Apache-2.0
// The contacts of two shapes, and of arrays.
#include "polygon/manifold.hpp"

#include "arrays.hpp"
#include "environment.hpp"
#include "polygon/arrays.hpp"
#include "vesica_motion.h"

namespace {

using vesica::Contacts;

static_assert(sizeof(Contacts<double>) == sizeof(vesica_contacts_f64));
static_assert(sizeof(Contacts<float>) == sizeof(vesica_contacts_f32));

/// On error the numbers stay.
template <class T, class Out>
int32_t write_manifold(const vesica::Operand& a, const vesica::Operand& b, Out* out) noexcept {
  Contacts<T> m;
  const int32_t code = vesica::polygon::manifold(a, b, m);
  if (code >= 0) std::memcpy(out, &m, sizeof m);
  return code;
}

template <class T, class Out>
int32_t manifold(int32_t kind_a, const void* a, int32_t kind_b, const void* b, Out* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((manifold<T, Out>), kind_a, a, kind_b, b, out);
  if (a == nullptr || b == nullptr || out == nullptr) return VESICA_E_NULL;
  if (!vesica::has_core_or_path(kind_a) || !vesica::has_core_or_path(kind_b)) return VESICA_E_KIND;
  constexpr bool is_float = std::is_same_v<T, float>;
  return write_manifold<T>({kind_a, is_float, a}, {kind_b, is_float, b}, out);
}

template <class T, class Out>
int64_t manifold_many(const vesica::capi::CShapesOf<T>* a, const vesica::capi::CShapesOf<T>* b, Out* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((manifold_many<T, Out>), a, b, out);
  using namespace vesica::capi;
  const int32_t wrong = check_call(a, b, out, anything(a, b), vesica::has_core_or_path);
  if (wrong != 0) return wrong;
  const int64_t n = pairs_in_step(*a, *b);
  if (n < 0) return n;
  const auto first = view<T>(*a), second = view<T>(*b);
  int64_t touching = 0;
  int32_t error = 0;
  for (int64_t i = 0; i < n; ++i) {
    const vesica::batch::Element<T> p(first, first.count == 1 ? 0 : i), q(second, second.count == 1 ? 0 : i);
    Out found{};
    const int32_t code = write_manifold<T>(p.operand(), q.operand(), &found);
    if (code < 0) found.count = code;
    if (code < 0 && error != VESICA_E_SHAPE) error = code;
    touching += code > 0 ? 1 : 0;
    out[i] = found;
  }
  return error != 0 ? error : touching;
}

}  // namespace

#define VESICA_MANIFOLD(scalar, T)                                                                        \
  int32_t vesica_manifold_##scalar(int32_t kind_a, const void* a, int32_t kind_b, const void* b,          \
                                   vesica_contacts_##scalar* out) {                                       \
    return manifold<T>(kind_a, a, kind_b, b, out);                                                        \
  }                                                                                                       \
  int64_t vesica_manifold_many_##scalar(const vesica_shapes_##scalar* a, const vesica_shapes_##scalar* b, \
                                        vesica_contacts_##scalar* out) {                                  \
    return manifold_many<T>(a, b, out);                                                                   \
  }

VESICA_MANIFOLD(f64, double)
VESICA_MANIFOLD(f32, float)

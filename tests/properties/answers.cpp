// SPDX-License-Identifier: Apache-2.0
#include "properties/answers.hpp"

#include <vesica.h>

#include "capi/typed_pairs.hpp"

namespace properties {
namespace {

/// The typed function of two kinds in the order of shapes, called.
template <class T>
std::int32_t call_typed(int kind_a, const T* a, int kind_b, const T* b) {
  for (const capi::TypedPair<T>& pair : capi::Api<T>::typed_pairs) {
    if (pair.kind_a == kind_a && pair.kind_b == kind_b) return pair.overlap(a, b);
  }
  return VESICA_E_KIND;
}

}  // namespace

std::int32_t overlap_by_kind(Scalar scalar, const Pair& p) {
  if (scalar == Scalar::f64) return vesica_overlap_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data());
  return vesica_overlap_f32(p.kind_a, narrow(p.a).data(), p.kind_b, narrow(p.b).data());
}

std::int32_t overlap_typed(Scalar scalar, const Pair& p) {
  if (scalar == Scalar::f64) return call_typed(p.kind_a, p.a.data(), p.kind_b, p.b.data());
  return call_typed(p.kind_a, narrow(p.a).data(), p.kind_b, narrow(p.b).data());
}

}  // namespace properties

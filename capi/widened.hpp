// SPDX-License-Identifier: Apache-2.0
// Queries that take longer than a conversion, on float shapes: a float is a double exactly, so one function serves
// both.
#pragma once

#include "by_kind.hpp"
#include "vesica.h"

namespace vesica::capi {

/// A shape's numbers as doubles; the kind must be one.
class Widened {
 public:
  Widened(int32_t kind, const float* numbers) noexcept {
    for (int32_t i = 0; i < field_count(kind); ++i) numbers_[i] = widen(numbers[i]);
  }
  const double* data() const noexcept { return numbers_; }

 private:
  double numbers_[6];
};

/// ask(a, b) with the numbers as doubles, or the error that comes first of NULL and kind.
template <class Ask>
int32_t answer_widened(int32_t kind_a, const float* a, int32_t kind_b, const float* b, const void* out,
                       Ask ask) noexcept {
  if (a == nullptr || b == nullptr || out == nullptr) return VESICA_E_NULL;
  if (!is_kind(kind_a) || !is_kind(kind_b)) return VESICA_E_KIND;
  return ask(Widened(kind_a, a).data(), Widened(kind_b, b).data());
}

}  // namespace vesica::capi

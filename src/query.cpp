// SPDX-License-Identifier: Apache-2.0
#include "query.hpp"

#include <cmath>
#include <limits>
#include <utility>
#include <vesica/relation/code.hpp>

namespace vesica {

namespace {

/// A shape's numbers as doubles.
struct Widened {
  double number[max_fields];

  Widened(std::int32_t kind, const float* numbers) noexcept {
    for (std::int32_t i = 0; i < field_count(kind); ++i) number[i] = widen(numbers[i]);
  }
};

/// False where a number exceeds the floats; out is then untouched.
bool round_once(const Query& query, const double* numbers, float* out) noexcept {
  float rounded[max_results];
  for (int k = 0; k < query.numbers; ++k) {
    rounded[k] = static_cast<float>(numbers[k]);
    if (!std::isfinite(rounded[k])) return false;
  }
  if (query.is_length && rounded[0] == 0 && numbers[0] > 0) rounded[0] = std::numeric_limits<float>::denorm_min();
  std::memcpy(out, rounded, sizeof(float) * static_cast<std::size_t>(query.numbers));
  return true;
}

}  // namespace

std::int32_t reverse(Reversal reversal, std::int32_t code, double* numbers) noexcept {
  if (code < 0) return code;
  switch (reversal) {
    case Reversal::none:
      break;
    case Reversal::points:
      std::swap(numbers[1], numbers[3]);
      std::swap(numbers[2], numbers[4]);
      break;
    case Reversal::direction:
      numbers[1] = 0 - numbers[1];  // no -0
      numbers[2] = 0 - numbers[2];
      break;
    case Reversal::converse:
      return static_cast<std::int32_t>(converse(static_cast<Relation>(code)));
  }
  return code;
}

std::int32_t ask_widened(const Query& query, std::int32_t kind_a, const float* a, std::int32_t kind_b, const float* b,
                         void* out) noexcept {
  if (a == nullptr || b == nullptr) return error_null;
  if (!is_kind(kind_a) || !is_kind(kind_b)) return error_kind;
  const Widened wide_a(kind_a, a), wide_b(kind_b, b);
  return ask_pair(query, kind_a, wide_a.number, kind_b, wide_b.number, out);
}

std::int32_t ask_rounded(const Query& query, std::int32_t kind_a, const float* a, std::int32_t kind_b, const float* b,
                         float* out) noexcept {
  double numbers[max_results];
  const std::int32_t code = ask_widened(query, kind_a, a, kind_b, b, numbers);
  if (code < 0) return code;
  return round_once(query, numbers, out) ? code : error_range;
}

}  // namespace vesica

// SPDX-License-Identifier: Apache-2.0
// Candidates to verdicts: shapes are gathered from the caller's arrays into columns, and a batch function answers a run
// of pairs of one pair of kinds at a time. Never by scalar calls: these cost three times as much.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "index/shapes.hpp"

namespace vesica::index {

/// Answers n pairs in columns, the first shape repeated where count_a is 1: out[i] = 1 or 0.
using Decide = void (*)(std::int32_t kind_a, const void* const* a, std::int64_t count_a, std::int32_t kind_b,
                        const void* const* b, std::int64_t n, std::uint8_t* out);

/// Pairs decided at once: their columns stay in the nearest cache.
inline constexpr int decided_at_once = 256;

/// Shapes as columns, of whichever scalar they are.
struct Columns {
  alignas(64) unsigned char column[most_fields][decided_at_once * sizeof(double)];
  const void* field[most_fields];

  /// To be called before the first use: columns may lie in scratch.
  void begin() noexcept {
    for (int k = 0; k < most_fields; ++k) field[k] = column[k];
  }
};

template <class T, int Fields>
void gather_records(const Set& set, const std::uint32_t* item, int n, Columns& out) noexcept {
  for (int i = 0; i < n; ++i) {
    T numbers[Fields];
    std::memcpy(numbers, set.field[0] + (static_cast<std::int64_t>(item[i]) - set.first) * set.stride, sizeof numbers);
    for (int k = 0; k < Fields; ++k) reinterpret_cast<T*>(out.column[k])[i] = numbers[k];
  }
}

template <class T>
void gather_number(const Set& set, int k, std::int64_t item, int i, Columns& out) noexcept {
  std::memcpy(out.column[k] + i * sizeof(T), set.field[k] + (item - set.first) * set.stride, sizeof(T));
}

template <class T>
bool lies_in_records(const Set& set) noexcept {
  for (int k = 1; k < fields_of[set.kind]; ++k) {
    if (set.field[k] != set.field[0] + static_cast<std::size_t>(k) * sizeof(T)) return false;
  }
  return true;
}

/// Columns of items of one kind.
template <class T>
void gather_columns(const Sets& sets, std::int32_t kind, const std::uint32_t* item, int n, Columns& out) noexcept {
  if (sets.count == 1 && lies_in_records<T>(sets.set[0])) {
    switch (fields_of[kind]) {
      case 2:
        return gather_records<T, 2>(sets.set[0], item, n, out);
      case 3:
        return gather_records<T, 3>(sets.set[0], item, n, out);
      case 4:
        return gather_records<T, 4>(sets.set[0], item, n, out);
      default:
        return gather_records<T, 6>(sets.set[0], item, n, out);
    }
  }
  for (int i = 0; i < n; ++i) {
    const Set& set = sets.set[sets.of(item[i])];
    for (int k = 0; k < fields_of[kind]; ++k) gather_number<T>(set, k, item[i], i, out);
  }
}

inline void gather_columns(const Sets& sets, std::int32_t kind, const std::uint32_t* item, int n,
                           Columns& out) noexcept {
  return sets.is_float ? gather_columns<float>(sets, kind, item, n, out)
                       : gather_columns<double>(sets, kind, item, n, out);
}

inline void prefetch(const Sets& sets, const std::uint32_t* item, int n) noexcept {
  for (int i = 0; i < n; ++i) {
    const Set& set = sets.set[sets.count == 1 ? 0 : sets.of(item[i])];
    const unsigned char* at = set.field[0] + (static_cast<std::int64_t>(item[i]) - set.first) * set.stride;
    __builtin_prefetch(at);
    __builtin_prefetch(at + 40);
  }
}

}  // namespace vesica::index

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

/// Records are asked for so many places before they are gathered: both of a pair lie anywhere in memory.
inline constexpr int asked_before = 40;

inline void ask_for(const Set& set, std::int64_t item) noexcept {
  const auto at = static_cast<std::ptrdiff_t>((item - set.first) * set.stride);
  __builtin_prefetch(set.field[0] + at);
  __builtin_prefetch(set.field[fields_of[set.kind] - 1] + at);
}

/// Two numbers of a record at a time.
template <class T>
using Two [[gnu::vector_size(2 * sizeof(T)), gnu::aligned(alignof(T))]] = T;

/// n records to columns; `behind` so many more items follow these.
template <class T, int Fields>
void gather_records(const Set& set, const std::uint32_t* item, int n, int behind, Columns& out) noexcept {
  const unsigned char* const base = set.field[0] - set.first * set.stride;
  const auto at = [&](int i) { return base + static_cast<std::int64_t>(item[i]) * set.stride; };
  int i = 0;
  for (; i + 2 <= n; i += 2) {
    const int ahead = i + asked_before;
    if (ahead + 2 <= n + behind) {
      ask_for(set, item[ahead]);
      ask_for(set, item[ahead + 1]);
    }
    const unsigned char *first = at(i), *second = at(i + 1);
    for (int k = 0; k + 2 <= Fields; k += 2) {
      Two<T> a, b;
      std::memcpy(&a, first + static_cast<std::size_t>(k) * sizeof(T), sizeof a);
      std::memcpy(&b, second + static_cast<std::size_t>(k) * sizeof(T), sizeof b);
      const Two<T> low = {a[0], b[0]}, high = {a[1], b[1]};
      std::memcpy(out.column[k] + static_cast<std::size_t>(i) * sizeof(T), &low, sizeof low);
      std::memcpy(out.column[k + 1] + static_cast<std::size_t>(i) * sizeof(T), &high, sizeof high);
    }
    if constexpr (Fields % 2 != 0) {
      std::memcpy(out.column[Fields - 1] + static_cast<std::size_t>(i) * sizeof(T), first + (Fields - 1) * sizeof(T),
                  sizeof(T));
      std::memcpy(out.column[Fields - 1] + static_cast<std::size_t>(i + 1) * sizeof(T),
                  second + (Fields - 1) * sizeof(T), sizeof(T));
    }
  }
  for (; i < n; ++i) {
    for (int k = 0; k < Fields; ++k) {
      std::memcpy(out.column[k] + static_cast<std::size_t>(i) * sizeof(T),
                  at(i) + static_cast<std::size_t>(k) * sizeof(T), sizeof(T));
    }
  }
}

template <class T>
void gather_number(const Set& set, int k, std::int64_t item, int i, Columns& out) noexcept {
  std::memcpy(out.column[k] + static_cast<std::size_t>(i) * sizeof(T), set.field[k] + (item - set.first) * set.stride,
              sizeof(T));
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
void gather_columns(const Sets& sets, std::int32_t kind, const std::uint32_t* item, int n, int behind,
                    Columns& out) noexcept {
  if (sets.count == 1 && lies_in_records<T>(sets.set[0])) {
    switch (fields_of[kind]) {
      case 2:
        return gather_records<T, 2>(sets.set[0], item, n, behind, out);
      case 3:
        return gather_records<T, 3>(sets.set[0], item, n, behind, out);
      case 4:
        return gather_records<T, 4>(sets.set[0], item, n, behind, out);
      default:
        return gather_records<T, 6>(sets.set[0], item, n, behind, out);
    }
  }
  for (int i = 0; i < n; ++i) {
    if (i + asked_before < n + behind) {
      const std::uint32_t ahead = item[i + asked_before];
      ask_for(sets.set[sets.of(ahead)], ahead);
    }
    const Set& set = sets.set[sets.of(item[i])];
    for (int k = 0; k < fields_of[kind]; ++k) gather_number<T>(set, k, item[i], i, out);
  }
}

/// Not inlined: where few are gathered, compilers warn of the asking ahead, which does not happen there.
[[gnu::noinline]] inline void gather_columns(const Sets& sets, std::int32_t kind, const std::uint32_t* item, int n,
                                             int behind, Columns& out) noexcept {
  return sets.is_float ? gather_columns<float>(sets, kind, item, n, behind, out)
                       : gather_columns<double>(sets, kind, item, n, behind, out);
}

}  // namespace vesica::index

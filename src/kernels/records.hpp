// SPDX-License-Identifier: Apache-2.0
// Copies records to columns: those that follow each other without gaps a long vector of records at a time, others two
// fields at a time. Included once by each source in src/isa, after the lanes of its instruction set.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include "by_kind.hpp"
#include "kernels/packed_records.hpp"

namespace vesica {
namespace {

/// Numbers of 16 bytes, within which processors shuffle quickly.
template <class T>
inline constexpr int group = 16 / sizeof(T);

/// Numbers of the vectors that are filled. Wider ones gain nothing: what costs is to fill them.
template <class T>
inline constexpr int record_vector = std::clamp<int>(sizeof(Floats), 16, 32) / sizeof(T);

/// Two adjacent numbers of each of length / 2 records. Every group has those of the first half of as many records, so
/// that two such vectors, the second beginning half a group later, have those of `length` records.
template <class T, int length>
VESICA_INLINE NumberVector<T, length> load_pairs(Unaligned<T> from, std::ptrdiff_t stride) noexcept {
  if constexpr (length == 2) {
    NumberVector<T, 2> pair;
    from.copy_to(pair);
    return pair;
  } else {
    constexpr int records = length == group<T> ? length / 4 : length / 2;
    const auto low = load_pairs<T, length / 2>(from, stride);
    const auto high = load_pairs<T, length / 2>(from.advanced(records * stride), stride);
    return [&]<int... i>(std::integer_sequence<int, i...>) { return __builtin_shufflevector(low, high, i...); }
    (std::make_integer_sequence<int, length>{});
  }
}

/// The first (which = 0) or second numbers of all pairs in each group, a's before b's.
template <int which, int length, class Vector>
VESICA_INLINE Vector one_of_each_pair(const Vector& a, const Vector& b) noexcept {
  constexpr int size = group<std::remove_cvref_t<decltype(a[0])>>;
  return [&]<int... i>(std::integer_sequence<int, i...>) {
    return __builtin_shufflevector(
        a, b, (i - i % size + 2 * (i % size) % size + (2 * (i % size) < size ? 0 : length) + which)...);
  }
  (std::make_integer_sequence<int, length>{});
}

/// Copies the two numbers at `from` of n records, a whole number of vectors, to two columns.
template <class T>
void copy_two_fields(Unaligned<T> from, std::ptrdiff_t stride, std::int32_t n, T* first, T* second) noexcept {
  constexpr int length = record_vector<T>;
  for (std::int32_t i = 0; i < n; i += length) {
    const Unaligned<T> record = from.advanced(i * stride);
    const auto a = load_pairs<T, length>(record, stride);
    const auto b = load_pairs<T, length>(record.advanced(group<T> / 2 * stride), stride);
    const auto firsts = one_of_each_pair<0, length>(a, b), seconds = one_of_each_pair<1, length>(a, b);
    std::memcpy(first + i, &firsts, sizeof firsts);
    std::memcpy(second + i, &seconds, sizeof seconds);
  }
}

/// Copies n records of all fields, a whole number of vectors, without gaps between them.
template <int fields, class T>
void copy_packed(Unaligned<T> from, std::int32_t n, T* columns, std::int32_t column_length) noexcept {
  for (std::int32_t i = 0; i < n; i += packed_length<T>) {
    NumberVector<T, packed_length<T>> number[fields];
    load_packed<fields>(from + i * fields, number);
    [&]<int... k>(std::integer_sequence<int, k...>) {
      (std::memcpy(columns + k * column_length + i, &number[k], sizeof number[k]), ...);
    }
    (std::make_integer_sequence<int, fields>{});
  }
}

/// Copies the first of n records to columns, and returns how many.
template <class T>
std::int32_t copy_whole_vectors(Unaligned<T> from, std::ptrdiff_t stride, int fields, std::int32_t n, T* columns,
                                std::int32_t column_length) noexcept {
  const bool has_no_gaps = stride == fields * static_cast<std::ptrdiff_t>(sizeof(T));
  if (has_long_vectors && has_no_gaps && loads_packed(fields)) {
    const std::int32_t whole = n - n % packed_length<T>;
    with_field_count(fields, [&]<int count>(std::integral_constant<int, count>) {
      if constexpr (loads_packed(count)) copy_packed<count>(from, whole, columns, column_length);
    });
    return whole;
  }
  const std::int32_t whole = n - n % record_vector<T>;
  // If the number of fields is odd, the last two overlap the two before.
  for (int k = 0; k < fields; k += 2) {
    const int field = k + 2 <= fields ? k : fields - 2;
    T* const column = columns + field * column_length;
    copy_two_fields(from + field, stride, whole, column, column + column_length);
  }
  return whole;
}

/// Copies n records, `stride` bytes apart, of `fields` adjacent numbers to columns, `column_length` numbers apart.
template <class T>
VESICA_KERNEL void records_to_columns(Unaligned<T> from, std::ptrdiff_t stride, int fields, std::int32_t n, T* columns,
                                      std::int32_t column_length) noexcept {
  const std::int32_t whole = copy_whole_vectors(from, stride, fields, n, columns, column_length);
  for (std::int32_t i = whole; i < n; ++i) {
    for (int k = 0; k < fields; ++k) columns[k * column_length + i] = from.advanced(i * stride)[k];
  }
}

}  // namespace
}  // namespace vesica

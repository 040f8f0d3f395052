// SPDX-License-Identifier: Apache-2.0
// Copies records to columns by transposing a few records at a time. Vectors of 16 bytes are used, which every supported
// processor has.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include "unaligned.hpp"

namespace vesica::batch {

/// 16 bytes of a record. As many records as a row has numbers are transposed at once.
template <class T>
using Row [[gnu::vector_size(16)]] = T;
template <class T>
inline constexpr int row_length = 16 / sizeof(T);

inline void transpose(Row<float> (&rows)[4]) noexcept {
  const Row<float> a = __builtin_shufflevector(rows[0], rows[1], 0, 4, 1, 5);
  const Row<float> b = __builtin_shufflevector(rows[0], rows[1], 2, 6, 3, 7);
  const Row<float> c = __builtin_shufflevector(rows[2], rows[3], 0, 4, 1, 5);
  const Row<float> d = __builtin_shufflevector(rows[2], rows[3], 2, 6, 3, 7);
  rows[0] = __builtin_shufflevector(a, c, 0, 1, 4, 5);
  rows[1] = __builtin_shufflevector(a, c, 2, 3, 6, 7);
  rows[2] = __builtin_shufflevector(b, d, 0, 1, 4, 5);
  rows[3] = __builtin_shufflevector(b, d, 2, 3, 6, 7);
}

inline void transpose(Row<double> (&rows)[2]) noexcept {
  const Row<double> first = rows[0];
  rows[0] = __builtin_shufflevector(first, rows[1], 0, 2);
  rows[1] = __builtin_shufflevector(first, rows[1], 1, 3);
}

/// Writes the first numbers of n records, `stride` bytes apart and a row of numbers each, to as many columns of
/// `column_length`. n is a multiple of the row's length.
template <class T>
void transpose_rows(Unaligned<T> from, std::ptrdiff_t stride, std::int32_t n, T* columns,
                    std::int32_t column_length) noexcept {
  constexpr int length = row_length<T>;
  // A loop over rows would keep them in memory: g++ does not unroll it under -O2.
  const auto each_row = [](auto action) {
    [&]<int... k>(std::integer_sequence<int, k...>) { (action(k), ...); }
    (std::make_integer_sequence<int, length>{});
  };
  for (std::int32_t i = 0; i < n; i += length) {
    Row<T> rows[length];
    each_row([&](int k) { from.advanced((i + k) * stride).copy_to(rows[k]); });
    transpose(rows);
    each_row([&](int k) { std::memcpy(columns + k * column_length + i, &rows[k], sizeof rows[k]); });
  }
}

/// Copies n records of `fields` adjacent numbers to columns. Where a record is not a whole number of rows, its last row
/// overlaps the one before.
template <class T>
void records_to_columns(Unaligned<T> from, std::ptrdiff_t stride, int fields, std::int32_t n, T* columns,
                        std::int32_t column_length) noexcept {
  constexpr int length = row_length<T>;
  const std::int32_t whole = fields < length ? 0 : n / length * length;
  for (int k = 0; k < fields && whole > 0; k += length) {
    const int first = k + length <= fields ? k : fields - length;
    transpose_rows(from + first, stride, whole, columns + first * column_length, column_length);
  }
  for (std::int32_t i = whole; i < n; ++i) {
    for (int k = 0; k < fields; ++k) columns[k * column_length + i] = from.advanced(i * stride)[k];
  }
}

}  // namespace vesica::batch

// SPDX-License-Identifier: Apache-2.0
// Arrays of shapes, read a block at a time: for overlap (batch.cpp) and for the other queries (queries.cpp).
#pragma once

#include "batch.hpp"
#include "by_kind.hpp"
#include "kernels/table.hpp"

namespace vesica::batch {

/// Elements a block holds: 4 KiB a column, so that six columns of a block stay in the first-level cache.
template <class T>
inline constexpr std::int32_t block_size = 4096 / sizeof(T);

/// Elements a block of pairs holds where an operand is copied: both copies and their sources stay in that cache.
/// Columns that begin 4 KiB apart would be in each other's way there.
template <class T>
inline constexpr std::int32_t copied_block_size = 1024 / sizeof(T);

/// Elements in a block if no operand needs copying: the fixed cost of a block is then shared by more elements.
inline constexpr std::int32_t long_block_size = 4096;

constexpr std::int32_t block_length(std::int64_t rest, std::int32_t size) noexcept {
  return static_cast<std::int32_t>(rest < size ? rest : size);
}

/// One shape of an array, repeated.
template <class T>
Shapes<T> element(const Shapes<T>& shapes, std::int64_t i) noexcept {
  Shapes<T> one = shapes;
  one.stride = 0;
  for (int k = 0; k < field_count(shapes.kind); ++k) one.field[k] = shapes.field[k].advanced(i * shapes.stride);
  return one;
}

/// The numbers of element i as doubles.
template <class T>
void read_element(const Shapes<T>& shapes, std::int64_t i, double (&out)[max_fields]) noexcept {
  for (int k = 0; k < field_count(shapes.kind); ++k) {
    out[k] = static_cast<double>(shapes.field[k].advanced(i * shapes.stride)[0]);
  }
}

/// True if any stretch of the array can be read where it lies.
template <class T>
bool lies_in_columns(const Shapes<T>& shapes) noexcept {
  return shapes.stride == sizeof(T);
}

/// True if each shape's numbers lie side by side.
template <class T>
VESICA_CALLED bool lies_in_records(const Shapes<T>& shapes, int fields) noexcept {
  std::uintptr_t next = shapes.field[0].address();
  for (int k = 1; k < fields; ++k) {
    next += sizeof(T);
    if (shapes.field[k].address() != next) return false;
  }
  return true;
}

/// Copies elements [begin, begin + n) to columns.
template <class T, std::size_t length>
void copy_to_columns(const KernelTable& kernels, const Shapes<T>& shapes, std::int64_t begin, std::int32_t n,
                     T (&columns)[max_fields][length]) noexcept {
  constexpr auto column_length = static_cast<std::int32_t>(length);
  const int fields = field_count(shapes.kind);
  const auto at = [&](int k) { return shapes.field[k].advanced(begin * shapes.stride); };
  if (lies_in_columns(shapes)) {
    for (int k = 0; k < fields; ++k) std::memcpy(columns[k], at(k).bytes(), static_cast<std::size_t>(n) * sizeof(T));
  } else if (lies_in_records(shapes, fields)) {
    kernels.copy_records(T{})(at(0), shapes.stride, fields, n, columns[0], column_length);
  } else {
    for (int k = 0; k < fields; ++k) {
      for (std::int32_t i = 0; i < n; ++i) columns[k][i] = at(k).advanced(i * shapes.stride)[0];
    }
  }
}

/// A stretch of an array as contiguous columns: the array's own where it has them, else a copy of at most `length`.
template <class T, std::int32_t length>
struct Columns {
  Unaligned<T> field[max_fields];
  T copy[max_fields][length];

  /// Elements [begin, begin + n).
  void set(const KernelTable& kernels, const Shapes<T>& shapes, std::int64_t begin, std::int32_t n) noexcept {
    const bool in_place = lies_in_columns(shapes) || n == 1;
    if (!in_place) copy_to_columns(kernels, shapes, begin, n, copy);
    for (int k = 0; k < field_count(shapes.kind); ++k) {
      field[k] = in_place ? shapes.field[k].advanced(begin * shapes.stride) : Unaligned<T>(copy[k]);
    }
  }
};

}  // namespace vesica::batch

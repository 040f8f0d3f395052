// SPDX-License-Identifier: Apache-2.0
// A stretch of an array of shapes as contiguous columns: the array's own where it has them, else a copy.
#pragma once

#include "batch.hpp"
#include "by_kind.hpp"
#include "records.hpp"

namespace vesica::batch {

/// Elements a block holds: 4 KiB a column, so that six columns of a block stay in the first-level cache.
template <class T>
inline constexpr std::int32_t block_size = 4096 / sizeof(T);

/// Elements a block holds where no operand needs copying: what is spent on a block then shows less.
inline constexpr std::int32_t long_block_size = 4096;

/// Whether any stretch of the array can be read where it lies.
template <class T>
bool lies_in_columns(const Shapes<T>& shapes) noexcept {
  return shapes.stride == sizeof(T);
}

/// Whether each shape's numbers lie side by side.
template <class T>
bool lies_in_records(const Shapes<T>& shapes, int fields) noexcept {
  for (int k = 1; k < fields; ++k) {
    if (shapes.field[k] != shapes.field[0] + k) return false;
  }
  return true;
}

template <class T>
struct Columns {
  const T* field[max_fields];
  T copy[max_fields][block_size<T>];

  /// Elements [begin, begin + n); at most block_size if they must be copied.
  void set(const Shapes<T>& shapes, std::int64_t begin, std::int32_t n) noexcept {
    const int fields = field_count(shapes.kind);
    for (int k = 0; k < fields; ++k) field[k] = advance(shapes.field[k], begin * shapes.stride);
    if (lies_in_columns(shapes) || n == 1) return;
    if (lies_in_records(shapes, fields)) {
      records_to_columns(field[0], shapes.stride, fields, n, copy[0], block_size<T>);
    } else {
      for (int k = 0; k < fields; ++k) records_to_columns(field[k], shapes.stride, 1, n, copy[k], block_size<T>);
    }
    for (int k = 0; k < fields; ++k) field[k] = copy[k];
  }
};

}  // namespace vesica::batch

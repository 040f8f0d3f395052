// SPDX-License-Identifier: Apache-2.0
// A stretch of an array of shapes as contiguous columns: the array's own where it has them, else a copy.
#pragma once

#include <cstring>

#include "batch.hpp"
#include "by_kind.hpp"

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

template <class T>
const T* advance(const T* p, std::ptrdiff_t bytes) noexcept {
  return reinterpret_cast<const T*>(reinterpret_cast<const unsigned char*>(p) + bytes);
}

template <class T>
struct Columns {
  const T* field[max_fields];
  T copy[max_fields][block_size<T>];

  /// Elements [begin, begin + n); at most block_size if they must be copied.
  void set(const Shapes<T>& shapes, std::int64_t begin, std::int32_t n) noexcept {
    const int fields = field_count(shapes.kind);
    for (int k = 0; k < fields; ++k) {
      const T* from = advance(shapes.field[k], begin * shapes.stride);
      field[k] = from;
      if (shapes.stride == sizeof(T) || n == 1) continue;
      for (std::int32_t i = 0; i < n; ++i) std::memcpy(&copy[k][i], advance(from, i * shapes.stride), sizeof(T));
      field[k] = copy[k];
    }
  }
};

}  // namespace vesica::batch

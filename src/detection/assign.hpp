// SPDX-License-Identifier: Apache-2.0
// Greedy assignment: of the entries of a sparse matrix the best first, each row and each column once.
#pragma once

#include <cstdint>

namespace vesica::detection {

/// Entries of a sparse matrix: value[k] in row[k] and column[k].
template <class T>
struct Entries {
  const std::int64_t *row, *column;
  const T* value;
  std::int64_t count, rows, columns;
};

/// True if every entry is within the matrix.
template <class T>
bool are_inside(const Entries<T>& entries) noexcept {
  for (std::int64_t k = 0; k < entries.count; ++k) {
    if (entries.row[k] < 0 || entries.row[k] >= entries.rows) return false;
    if (entries.column[k] < 0 || entries.column[k] >= entries.columns) return false;
  }
  return true;
}

/// Bytes of scratch, for up to 2^31 - 1 of each.
std::int64_t assignment_bytes(std::int64_t count, std::int64_t rows, std::int64_t columns) noexcept;

/// Writes which entries are chosen, the best first, ties by row, column and number; returns how many. NaN is never
/// chosen. The scratch is aligned to 8.
template <class T>
std::int64_t assign_greedily(const Entries<T>& entries, void* scratch, std::int64_t* chosen) noexcept;

}  // namespace vesica::detection

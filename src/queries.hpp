// SPDX-License-Identifier: Apache-2.0
// Queries other than overlap, for whole arrays. Every element gets the same bits as from the scalar function.
#pragma once

#include "batch.hpp"
#include "query.hpp"

namespace vesica::batch {

struct QueryTally {
  std::int64_t count = 0;
  std::int32_t error = 0;  // error_shape if any shape was invalid, else an error of a valid pair
};

/// columns[k][i] = number k of the result for a[i] and b[i], i < n; a column may be null. Numbers are rounded to Out
/// once. For an error they are NaN, or 0 if Out is an integer.
template <class T, class Out>
QueryTally query_many(const Query& query, const KernelTable& kernels, const Shapes<T>& a, const Shapes<T>& b,
                      std::int64_t n, Out* const* columns) noexcept;

/// out[i * row_stride + j] = the first number of the result for a[i] and b[j], as above.
template <class T, class Out>
QueryTally query_matrix(const Query& query, const KernelTable& kernels, const Shapes<T>& a, const Shapes<T>& b,
                        Out* out, std::ptrdiff_t row_stride) noexcept;

}  // namespace vesica::batch

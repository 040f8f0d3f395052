// SPDX-License-Identifier: Apache-2.0
/// The queries with batches by one shape of function: a result is `results` numbers, codes among them.
#pragma once

#include <vesica.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "batch/shapes.hpp"
#include "capi/face.hpp"

namespace batch_tests {

using capi_tests::Face;

inline constexpr std::size_t most_results = 5;

template <class T>
using Result = std::array<T, most_results>;

/// One query in one scalar type. Codes, which the library writes as bytes, are numbers here.
template <class T>
struct QueryFace {
  using Shapes = typename Face<T>::Shapes;
  const char* name;
  std::size_t results;
  bool counts_zero;  ///< the batch returns how many first numbers are 0, not how many are positive
  bool is_code;      ///< an invalid element gets 0, not NaN
  std::int32_t (*scalar)(int kind_a, const T* a, int kind_b, const T* b, Result<T>& result);
  /// columns: `results` columns of n numbers.
  std::int64_t (*many)(const Shapes* a, const Shapes* b, std::span<std::vector<T>> columns);
  /// n numbers a row; null where the query has no matrix.
  std::int64_t (*matrix)(const Shapes* a, const Shapes* b, std::vector<T>& out, std::ptrdiff_t row_stride);
};

template <class T>
std::span<const QueryFace<T>> query_faces();

}  // namespace batch_tests

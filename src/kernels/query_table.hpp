// SPDX-License-Identifier: Apache-2.0
// What an instruction set offers for the queries other than overlap: kernels over columns of doubles.
#pragma once

#include <cstdint>
#include <vesica/shapes.hpp>

#include "kernels/table.hpp"

namespace vesica {

/// The most numbers that a query's result has.
inline constexpr int max_results = 5;

/// Pairs a kernel works on at a time, a multiple of every vector's width.
inline constexpr std::int32_t query_block = 128;

/// Columns of n numbers, n a multiple of the vector's width.
struct QueryColumns {
  const double *first[max_fields], *second[max_fields];  // the shapes' numbers, by field
  const double* known;                                   // 1 where the shapes overlap, 0 elsewhere, where asked for
  const double *first_area, *second_area;                // where the query asks for them; any numbers elsewhere
};

/// Fills results[k][i] for i < n. Where a kernel cannot answer, or a shape is invalid, results[0][i] is NaN, and the
/// caller asks the scalar function. A kernel and the scalar function are instances of one template without fused
/// operations, so that they give the same bits.
using QueryKernel = void (*)(const QueryColumns& columns, std::int32_t n, double* const* results) noexcept;

/// By the two kinds in the order of shapes; null where the scalar function does it all.
using QueryKernels = QueryKernel[kind_count][kind_count];

struct QueryTable {
  QueryKernels relation;
  QueryKernels nearest;
  QueryKernels boundary_distance;
  QueryKernels depth;
  QueryKernels area;
  QueryKernels iou;
};

extern const QueryTable kernels_portable_queries;
#if defined(__x86_64__)
extern const QueryTable kernels_sse2_queries, kernels_avx2_queries, kernels_avx512_queries;
#elif defined(__aarch64__)
extern const QueryTable kernels_neon_queries;
#endif

}  // namespace vesica

// SPDX-License-Identifier: Apache-2.0
// Queries other than overlap, of whole arrays. Every element gets the bits that the scalar function gives.
#pragma once

#include "batch.hpp"
#include "kernels/query_table.hpp"

namespace vesica::batch {

/// A query's scalar function: writes its result's numbers for two shapes given by kind and flat numbers. Returns 0 or
/// a negative error.
using Answer = std::int32_t (*)(std::int32_t kind_a, const double* a, std::int32_t kind_b, const double* b,
                                double* results) noexcept;

/// The area of a shape given by kind and flat numbers; NaN for one that is invalid or whose area is beyond the range.
using ShapeArea = double (*)(std::int32_t kind, const double* numbers) noexcept;

/// What a query's kernel must know of each pair: nothing; whether the shapes overlap, as 1 or 0; of rectangles, a
/// circle about each.
enum class Known { nothing, overlap, reach };

/// How the results for (b, a) become those for (a, b): not at all; (distance, ax, ay, bx, by) with the points
/// exchanged; (depth, x, y) with the direction turned round; a relation's code by its converse.
enum class Reversal { none, points, direction, converse };

struct Query {
  int results;       // numbers of a result
  bool is_length;    // the first number is a distance or a depth: a positive one stays so when it is rounded to float
  bool counts_zero;  // the tally counts the pairs whose first number is 0; otherwise those where it is positive
  Answer answer;
  QueryKernels QueryTable::*kernels;
  Reversal reversal;
  Known known;
  ShapeArea shape_area;  // set where a kernel must know the shapes' areas
  // Set where the code of another query, the relation, is all it takes; of this one only from_relation is used then.
  const Query* relation;
  double (*from_relation)(double) noexcept;
};

struct QueryTally {
  std::int64_t count = 0;
  std::int32_t error = 0;  // error_shape if any shape was invalid, else an error of a valid pair
};

/// columns[k][i] = number k of the result for a[i] and b[i], i < n; a column may be null. Numbers are rounded to Out
/// once. Where there is an error they are NaN, or 0 where Out is an integer.
template <class T, class Out>
QueryTally query_many(const Query& query, const KernelTable& kernels, const Shapes<T>& a, const Shapes<T>& b,
                      std::int64_t n, Out* const* columns) noexcept;

/// out[i * row_stride + j] = the first number of the result for a[i] and b[j], as above.
template <class T, class Out>
QueryTally query_matrix(const Query& query, const KernelTable& kernels, const Shapes<T>& a, const Shapes<T>& b,
                        Out* out, std::ptrdiff_t row_stride) noexcept;

}  // namespace vesica::batch

// SPDX-License-Identifier: Apache-2.0
// A query is one descriptor: scalar calls and batches follow from it. Each is defined in queries/<name>.cpp.
#pragma once

#include "by_kind.hpp"
#include "kernels/query_table.hpp"
#include "pair_table.hpp"

namespace vesica {

/// What the kernels of a query must know of each pair.
enum class Known {
  nothing,
  overlap,  // whether the shapes overlap, as 1 or 0
  reach,    // of rectangles, the radius of a circle about each
};

/// The area of a shape given by kind and flat numbers; NaN for one that is invalid or whose area is beyond the range.
using ShapeArea = double (*)(std::int32_t kind, const double* numbers) noexcept;

/// A shape by its kind and flat numbers, with its area as ShapeArea gives it.
struct ShapeOfKind {
  std::int32_t kind;
  const double* numbers;
  double area;
};

/// A number that follows from another query's and the two shapes. Returns 0 or an error; out is then untouched.
using Derive = std::int32_t (*)(double asked, const ShapeOfKind& a, const ShapeOfKind& b, double& out) noexcept;

struct Query {
  PairTable doubles, floats;
  Reversal reversal;

  // What follows is about batches.
  /// Numbers of a result; 0 where it is the returned code.
  int numbers = 0;
  /// The first number is a distance or a depth, of any sign: one that is not 0 stays so when it is rounded to float.
  bool is_length = false;
  /// A batch counts the pairs whose first number is 0 or less; otherwise those where it is positive.
  bool counts_zero = false;
  /// Null where the scalar function does it all.
  QueryKernels QueryTable::*kernels = nullptr;
  Known known = Known::nothing;
  /// Set where a kernel or `derive` must know the shapes' areas.
  ShapeArea shape_area = nullptr;
  /// Set where batches ask another query. Then from_code turns its codes into this one's, where NaN stays NaN, or
  /// derive makes its number, or a NaN for an error, into this one's.
  const Query* asked_instead = nullptr;
  double (*from_code)(double code) noexcept = nullptr;
  Derive derive = nullptr;

  /// Columns that a batch writes.
  constexpr int columns() const noexcept { return numbers == 0 ? 1 : numbers; }
  /// The query that batches ask.
  const Query& asked() const noexcept { return asked_instead == nullptr ? *this : *asked_instead; }
  /// Whether the query knows these kinds; both are kinds.
  bool answers(std::int32_t kind_a, std::int32_t kind_b) const noexcept {
    return asked().doubles.of[kind_a][kind_b] != unknown_pair;
  }
  const PairTable& pairs(double) const noexcept { return doubles; }
  const PairTable& pairs(float) const noexcept { return floats; }
};

namespace queries {

extern const Query overlap, relation, contains, nearest, boundary_distance, depth, area, iou, crossings, signed_distance;

}  // namespace queries

/// Asks about two shapes given by kind and flat numbers. Returns the answer, or the error that comes first of NULL, kind
/// and what the query looks at. `out` has room for the result, and is null where that is the returned code.
template <class T>
VESICA_INLINE std::int32_t ask(const Query& query, std::int32_t kind_a, const T* a, std::int32_t kind_b, const T* b,
                               void* out) noexcept {
  if (a == nullptr || b == nullptr) return error_null;
  if (!is_kind(kind_a) || !is_kind(kind_b)) return error_kind;
  return query.pairs(T{}).of[kind_a][kind_b](a, b, out);
}

}  // namespace vesica

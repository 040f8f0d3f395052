// SPDX-License-Identifier: Apache-2.0
// The descriptor of a query, from which scalar calls and batches follow. queries/<name>.cpp defines each.
#pragma once

#include "by_kind.hpp"
#include "kernels/query_table.hpp"
#include "pair_table.hpp"
#include "polygon/answers.hpp"

namespace vesica {

/// Properties of each pair that the kernels of a query need.
enum class Known {
  nothing,
  overlap,  // whether the shapes overlap, as 1 or 0
  radius,   // for rectangles, the radius of a circle about each
};

/// The area of a shape given by kind and flat numbers; NaN if the shape is invalid or its area overflows.
using ShapeArea = double (*)(std::int32_t kind, const double* numbers) noexcept;

/// A shape by its kind and flat numbers, with its area as ShapeArea gives it.
struct ShapeOfKind {
  std::int32_t kind;
  const double* numbers;
  double area;
};

/// Computes a number from another query's number and the two shapes. Returns 0, or an error and writes nothing.
using Derive = std::int32_t (*)(double asked, const ShapeOfKind& a, const ShapeOfKind& b, double& out) noexcept;

struct Query {
  PairTable doubles, floats;
  Reversal reversal;
  /// With a polygon or a polyline; null if the query does not take them.
  PathFunction paths = nullptr;
  /// For two polygons from their areas; null where these say nothing.
  SharesFunction of_shares = nullptr;
  /// That gives 0 for two polygons with area that share none.
  bool is_none_of_none = false;
  /// Which kinds it takes together, one of which is a path; null for all.
  bool (*takes_path)(std::int32_t kind_a, std::int32_t kind_b) noexcept = nullptr;

  // The rest is for batches.
  /// How many numbers a result has; 0 if it is the returned code.
  int numbers = 0;
  /// The first number is a distance or a depth, of any sign: if it is not 0, rounding to float does not make it 0.
  bool is_length = false;
  /// A batch counts the pairs whose first number is at most 0; otherwise those whose first number is positive.
  bool counts_zero = false;
  /// Null if there are no batches, or if these run another query.
  QueryKernels QueryTable::*kernels = nullptr;
  Known known = Known::nothing;
  /// Set if a kernel or `derive` needs the shapes' areas.
  ShapeArea shape_area = nullptr;
  /// Set if batches run another query and convert its results: from_code converts its codes (NaN stays NaN), or derive
  /// converts its number, which is NaN for an error.
  const Query* asked_instead = nullptr;
  double (*from_code)(double code) noexcept = nullptr;
  Derive derive = nullptr;

  /// Columns that a batch writes.
  constexpr int columns() const noexcept { return numbers == 0 ? 1 : numbers; }
  /// The query that batches run.
  const Query& asked() const noexcept { return asked_instead == nullptr ? *this : *asked_instead; }
  /// True if the query knows these kinds; both are kinds.
  bool answers(std::int32_t kind_a, std::int32_t kind_b) const noexcept {
    if (!is_row(kind_a) || !is_row(kind_b)) {
      return paths != nullptr && has_core_or_path(kind_a) && has_core_or_path(kind_b) &&
             (takes_path == nullptr || takes_path(kind_a, kind_b));
    }
    return asked().doubles.of[kind_a][kind_b] != unknown_pair;
  }
  const PairTable& pairs(double) const noexcept { return doubles; }
  const PairTable& pairs(float) const noexcept { return floats; }
};

namespace queries {

extern const Query overlap, relation, contains, nearest, boundary_distance, depth, area, iou, crossings,
    signed_distance;

}  // namespace queries

/// Answers a query for two shapes of scalar T, each a kind and a pointer to its struct. Returns the answer or the first
/// error: NULL, then the kinds, then the query's own. `out` is null if the result is the returned code.
template <class T>
VESICA_INLINE std::int32_t ask(const Query& query, std::int32_t kind_a, const void* a, std::int32_t kind_b,
                               const void* b, void* out) noexcept {
  if (a == nullptr || b == nullptr) return error_null;
  if (!is_row(kind_a) || !is_row(kind_b)) [[unlikely]] {
    if (!query.answers(kind_a, kind_b)) return error_kind;
    return query.paths({kind_a, std::is_same_v<T, float>, a}, {kind_b, std::is_same_v<T, float>, b}, out);
  }
  return query.pairs(T{}).of[kind_a][kind_b](a, b, out);
}

}  // namespace vesica

// SPDX-License-Identifier: Apache-2.0
// A query is one descriptor: scalar calls and batches follow from it. Each is defined in queries/<name>.cpp.
#pragma once

#include "by_kind.hpp"
#include "kernels/query_table.hpp"
#include "pair_table.hpp"

namespace vesica {

/// How the result for (b, a) becomes the one for (a, b).
enum class Reversal {
  none,       // they are the same
  points,     // (distance, ax, ay, bx, by): the points are exchanged
  direction,  // (depth, x, y): the direction is turned round
  converse,   // a relation's code
};

/// What the kernels of a query must know of each pair.
enum class Known {
  nothing,
  overlap,  // whether the shapes overlap, as 1 or 0
  reach,    // of rectangles, the radius of a circle about each
};

/// The area of a shape given by kind and flat numbers; NaN for one that is invalid or whose area is beyond the range.
using ShapeArea = double (*)(std::int32_t kind, const double* numbers) noexcept;

struct Query {
  PairTable pairs;
  Reversal reversal = Reversal::none;
  /// Doubles that a result has; 0 where it is the returned code.
  int numbers = 0;
  /// The first number is a distance or a depth: one that is not 0 stays so when it is rounded to float.
  bool is_length = false;

  // What follows is about batches.
  /// A batch counts the pairs whose first number is 0; otherwise those where it is positive.
  bool counts_zero = false;
  /// Null where the scalar function does it all.
  QueryKernels QueryTable::*kernels = nullptr;
  Known known = Known::nothing;
  /// Set where a kernel must know the shapes' areas.
  ShapeArea shape_area = nullptr;
  /// Set where batches ask another query, whose code from_code turns into this one's; NaN stays NaN.
  const Query* asked_instead = nullptr;
  double (*from_code)(double code) noexcept = nullptr;

  /// Columns that a batch writes.
  constexpr int columns() const noexcept { return numbers == 0 ? 1 : numbers; }
};

namespace queries {

extern const Query overlap, relation, contains, nearest, boundary_distance, depth, area, iou, crossings;

/// Overlap of floats has functions of its own: widening would show.
extern const PairTable overlap_of_floats;

}  // namespace queries

/// The result for (a, b), given that for (b, a): a code, and the numbers if there are any.
std::int32_t reverse(Reversal reversal, std::int32_t code, double* numbers) noexcept;

/// Asks about two shapes given by kind and flat numbers, the kinds being valid. `out` has room for the result.
inline std::int32_t ask_pair(const Query& query, std::int32_t kind_a, const double* a, std::int32_t kind_b,
                             const double* b, void* out) noexcept {
  const PairFunction answer = query.pairs.of[kind_a][kind_b];
  if (answer != nullptr) [[likely]]
    return answer(a, b, out);
  const std::int32_t code = query.pairs.of[kind_b][kind_a](b, a, out);
  return query.reversal == Reversal::none ? code : reverse(query.reversal, code, static_cast<double*>(out));
}

/// The same for arguments of which nothing is known. Returns the answer, or the error that comes first of NULL, kind
/// and what the query looks at.
inline std::int32_t ask(const Query& query, std::int32_t kind_a, const double* a, std::int32_t kind_b, const double* b,
                        void* out) noexcept {
  if (a == nullptr || b == nullptr) return error_null;
  if (!is_kind(kind_a) || !is_kind(kind_b)) return error_kind;
  return ask_pair(query, kind_a, a, kind_b, b, out);
}

/// Shapes of floats are asked about as doubles, which is exact. `out` has room for the result in doubles.
std::int32_t ask_widened(const Query& query, std::int32_t kind_a, const float* a, std::int32_t kind_b, const float* b,
                         void* out) noexcept;

/// The same with the result's numbers rounded once; error_range where one exceeds the floats, and out is untouched.
std::int32_t ask_rounded(const Query& query, std::int32_t kind_a, const float* a, std::int32_t kind_b, const float* b,
                         float* out) noexcept;

}  // namespace vesica

// SPDX-License-Identifier: Apache-2.0
// An instruction set's table for the queries other than overlap: kernels over columns of doubles.
#pragma once

#include <cstdint>
#include <vesica/shapes.hpp>

#include "kernels/table.hpp"

namespace vesica {

/// The most numbers that a query's result has.
inline constexpr int max_results = 5;

/// Pairs a kernel works on at a time, a multiple of every vector's width.
inline constexpr std::int32_t query_block = 128;

/// The doubles of the widest vectors, two as one.
inline constexpr std::int32_t widest_vector = 16;

/// One operand's columns of n numbers, n a multiple of the vector's width. One shape that is repeated has widest_vector
/// copies of its numbers, whatever n is.
struct QueryOperand {
  const double* number[max_fields];
  /// Set where the query has shape_area, arbitrary elsewhere.
  const double* area;
  /// The radius of a circle about the centre that holds the shape, a relative 2^-48 too large; NaN for an invalid
  /// shape. Set where the query knows radii, arbitrary elsewhere.
  const double* radius;
  bool repeated;
};

struct QueryColumns {
  QueryOperand first, second;
  const double* known;  // 1 where the shapes overlap, else 0; set where the query knows overlaps
};

/// Fills results[k][i] for i < n. If a kernel cannot answer, or a shape is invalid, results[0][i] is NaN, and the
/// caller calls the scalar function. Returns whether all were answered. A kernel and the scalar function are instances
/// of one template without fused operations, so that they give the same bits.
using QueryKernel = bool (*)(const QueryColumns& columns, std::int32_t n, double* const* results) noexcept;

/// Writes 1 to out[i] where the circles of these radii are certainly apart, else 0, for i < n; n as above. The
/// shapes' first two numbers must be their centres.
using ApartKernel = void (*)(const QueryColumns& columns, std::int32_t n, std::uint8_t* out) noexcept;

/// Polygons in columns, number k of polygon i at [k * length + i].
struct RingColumn {
  static constexpr int sides = 8, length = 64;  // the most sides, and polygons
  static constexpr int min_x = 0, min_y = 1, max_x = 2, max_y = 3;
  /// Positive, or NaN: kernels leave others open.
  static constexpr int area = 4;
  /// 0, or NaN where only the box and the area are known: kernels leave pairs open whose boxes share area.
  static constexpr int open = 5;
  /// Coordinates of the vertices, then of the first again and again.
  static constexpr int x = 6, y = x + sides + 1;
  /// Slopes of the sides that begin at the vertices, 0 of an upright one.
  static constexpr int slope = y + sides + 1;
  static constexpr int count = slope + sides;
};

/// From the vertices of n polygons of one ring, not necessarily finite, finds the rest of their columns. n is a
/// multiple of the vector's width. No polygon has more sides than `sides`.
using RingFacts = void (*)(double* columns, int sides, std::int32_t n) noexcept;
/// Writes the shared areas of n pairs; NaN where the scalar function must be asked.
using RingAreas = void (*)(const double* a, const double* b, int sides, std::int32_t n, double* out) noexcept;

/// By the two kinds in the order of shapes; null where the scalar function does it all.
using QueryKernels = QueryKernel[kind_count][kind_count];

struct CastColumns;  // cast_columns.hpp

/// Verdicts of the filter of casts on valid pairs, a byte each, 1 or 0.
struct CastBytes {
  std::uint8_t* missed;  // no contact from 0 to the end
  std::uint8_t* meets;   // not missed, and in contact at some time, which may be before the start
};

/// n: a multiple of the vector's width.
using CastFilter = void (*)(const CastColumns& columns, std::int32_t n, const CastBytes& out) noexcept;

/// The first contacts of pairs that the filter says to meet. results[0][i] is the time, the rest the point and the
/// normal as a single call has them; infinite if it is after the end, NaN where the scalar function must be asked, as
/// where contact may have begun by the start.
using CastKernel = void (*)(const CastColumns& columns, std::int32_t n, double* const* results) noexcept;

struct CastTable {
  CastFilter filter;
  CastKernel contact[kind_count][kind_count];  // by the kinds of the shape at rest and of that which moves, or null
};

/// True if there are kernels of casts, and of one rectangle or ellipse, at all. Two lanes of SSE2 gain nothing: 0.9 to
/// 1.3 of single calls.
#if defined(__x86_64__)
inline constexpr bool has_cast_kernels = true;
#else
inline constexpr bool has_cast_kernels = false;
#endif
inline constexpr bool has_box_kernels = has_cast_kernels;

/// Bounds and corners of n rectangles or ellipses, n as above, by columns of six numbers: the scalar function's bits.
/// results[0][i] is NaN where the scalar function must be called, as for invalid shapes.
struct BoxKernels {
  /// min_x, min_y, max_x, max_y.
  void (*bounds)(const double* const* number, bool is_ellipse, std::int32_t n, double* const* results) noexcept;
  /// x0, y0 and so on to y3, which may be infinite.
  void (*corners)(const double* const* number, std::int32_t n, double* const* results) noexcept;
};

struct QueryTable {
  QueryKernels relation;
  QueryKernels nearest;
  QueryKernels boundary_distance;
  QueryKernels depth;
  QueryKernels area;
  QueryKernels iou;
  ApartKernel apart;
  RingFacts ring_facts;     // null where one lane gains nothing
  RingAreas ring_areas[2];  // likewise; in step, and one against many
  const CastTable* cast;    // null where there are no kernels
  const BoxKernels* boxes;  // likewise
};

extern const QueryTable kernels_portable_queries;
#if defined(__x86_64__)
extern const QueryTable kernels_sse2_queries, kernels_avx2_queries, kernels_avx512_queries;
#elif defined(__aarch64__)
extern const QueryTable kernels_neon_queries;
#elif defined(__wasm_simd128__)
extern const QueryTable kernels_simd128_queries;
#endif

}  // namespace vesica

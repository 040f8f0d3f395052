// SPDX-License-Identifier: Apache-2.0
// Arrays of shapes as callers pass them: their checks, and the view of them that src/ works on.
#pragma once

#include "batch.hpp"
#include "by_kind.hpp"
#include "vesica.h"

namespace vesica::capi {

template <class T>
struct CShapes;
template <>
struct CShapes<double> {
  using Type = vesica_shapes_f64;
};
template <>
struct CShapes<float> {
  using Type = vesica_shapes_f32;
};
template <class T>
using CShapesOf = typename CShapes<T>::Type;

/// Copies the numbers of a shape of scalar T as doubles.
template <class T>
void widen(int32_t kind, const void* shape, double (&out)[max_fields]) noexcept {
  const T* const numbers = static_cast<const T*>(shape);
  for (int k = 0; k < field_count(kind); ++k) out[k] = static_cast<double>(numbers[k]);
}

/// The one of two errors (0: none) that is checked first: NULL, index, kind, argument.
inline int32_t first_error(int32_t a, int32_t b) noexcept {
  for (const int32_t error : {VESICA_E_NULL, VESICA_E_INDEX, VESICA_E_KIND, VESICA_E_ARGUMENT}) {
    if (a == error || b == error) return error;
  }
  return 0;
}

/// count elements of `stride` bytes each, within the address space. The stride of a single one is not looked at.
inline bool addressable(int64_t count, ptrdiff_t stride) noexcept {
  ptrdiff_t extent;
  return count <= 1 || !__builtin_mul_overflow(count, stride, &extent);
}

/// One of the kinds, and of those that queries other than overlap answer.
inline bool have_form(int32_t kind_a, int32_t kind_b) noexcept { return has_form(kind_a) && has_form(kind_b); }

/// True if a function takes a kind; the number may be no kind at all.
using Suits = bool (*)(int32_t kind) noexcept;

/// Offsets are read as C reads them.
inline bool aligned_offsets(const int32_t* offsets) noexcept {
  return reinterpret_cast<std::uintptr_t>(offsets) % alignof(int32_t) == 0;
}

/// An array of polygons or polylines holds structs (neither rings nor each), polygons of `each` vertices, or offsets.
template <class Array>
bool holds_structs(const Array& paths) noexcept {
  return paths.rings == nullptr && paths.each == 0;
}

/// The same for the members that polygons alone have: true if they agree.
template <class Array>
bool paths_agree(const Array& shapes) noexcept {
  if (is_row(shapes.kind)) {
    return shapes.rings == nullptr && shapes.polygons == nullptr && shapes.each == 0 &&
           addressable(shapes.count, shapes.stride);
  }
  if (shapes.each < 0 || !aligned_offsets(shapes.rings) || !aligned_offsets(shapes.polygons)) return false;
  if (shapes.rings != nullptr) return addressable(shapes.each, shapes.stride);
  int64_t vertices;
  if (shapes.polygons != nullptr || __builtin_mul_overflow(shapes.count, shapes.each, &vertices)) return false;
  return addressable(holds_structs(shapes) ? shapes.count : vertices, shapes.stride);
}

/// An array's error except for its pointers: 0, VESICA_E_KIND or VESICA_E_ARGUMENT.
template <class Array>
int32_t check_array(const Array& shapes, Suits suits = is_row) noexcept {
  if (!suits(shapes.kind)) return VESICA_E_KIND;
  return shapes.reserved == 0 && shapes.count >= 0 && paths_agree(shapes) ? 0 : VESICA_E_ARGUMENT;
}

/// How many of an array's fields are pointers to its numbers.
template <class Array>
int columns_read(const Array& shapes) noexcept {
  if (is_row(shapes.kind)) return field_count(shapes.kind);
  return holds_structs(shapes) ? 1 : 2;
}

template <class Array>
bool has_null(const Array& shapes) noexcept {
  for (int k = 0; k < columns_read(shapes); ++k) {
    if (shapes.field[k] == nullptr) return true;
  }
  return false;
}

/// Checks both arrays and the output of a call with something to answer. The order of errors is NULL, kind, argument,
/// except that fields are checked after the kind, which says how many there are.
template <class Array>
int32_t check_call(const Array* a, const Array* b, const void* out, bool anything, Suits suits = is_row) noexcept {
  if (a == nullptr || b == nullptr || (anything && out == nullptr)) return VESICA_E_NULL;
  const int32_t error = first_error(check_array(*a, suits), check_array(*b, suits));
  if (error != 0) return error;
  return anything && (has_null(*a) || has_null(*b)) ? VESICA_E_NULL : 0;
}

template <class T>
constexpr int field_room = std::extent_v<decltype(CShapesOf<T>::field)>;
static_assert(field_room<double> >= max_fields && field_room<float> >= max_fields);

template <class T>
batch::Shapes<T> view(const CShapesOf<T>& shapes) noexcept {
  const bool repeats = shapes.count == 1 && is_row(shapes.kind);
  batch::Shapes<T> v{shapes.kind,     shapes.count, repeats ? 0 : shapes.stride, {}, shapes.rings,
                     shapes.polygons, shapes.each};
  for (int k = 0; k < columns_read(shapes); ++k) v.field[k] = shapes.field[k];
  return v;
}

inline int64_t result(const batch::Tally& tally) noexcept { return tally.invalid ? VESICA_E_SHAPE : tally.overlaps; }

/// True if there are pairs. If not, fields may be NULL, so nothing may be read.
template <class Array>
bool anything(const Array* a, const Array* b) noexcept {
  return a != nullptr && b != nullptr && a->count != 0 && b->count != 0;
}

/// The pairs that two arrays make in step, a count of 1 repeating, or VESICA_E_ARGUMENT.
template <class Array>
int64_t pairs_in_step(const Array& a, const Array& b) noexcept {
  if (a.count != b.count && a.count != 1 && b.count != 1) return VESICA_E_ARGUMENT;
  return a.count == 1 ? b.count : a.count;
}

/// The first of two codes in the order VESICA_E_SHAPE, VESICA_E_ARGUMENT, VESICA_E_RANGE, 0.
inline int32_t more_severe(int32_t a, int32_t b) noexcept {
  for (const int32_t error : {VESICA_E_SHAPE, VESICA_E_ARGUMENT}) {
    if (a == error || b == error) return error;
  }
  return a != 0 ? a : b;
}

/// True if rows of `width` elements, row_stride elements apart, neither overlap nor leave the address space.
inline bool rows_apart(int64_t rows, int64_t width, ptrdiff_t row_stride, ptrdiff_t element) noexcept {
  ptrdiff_t bytes;
  if (rows <= 1) return true;
  if (row_stride < width && row_stride > -width) return false;
  return !__builtin_mul_overflow(row_stride, element, &bytes) && addressable(rows, bytes);
}

}  // namespace vesica::capi

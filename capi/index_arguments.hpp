// SPDX-License-Identifier: Apache-2.0
// Sets of shapes and indexes as callers pass them.
#pragma once

#include "arrays.hpp"
#include "environment.hpp"
#include "index/build.hpp"
#include "index/check.hpp"
#include "index/kernels.hpp"

namespace vesica::capi {

inline const index::Kernels& index_kernels() noexcept { return *kernels().index; }

inline bool aligned(const void* p, std::uintptr_t to = index::alignment) noexcept {
  return reinterpret_cast<std::uintptr_t>(p) % to == 0;
}

template <class T>
index::Set set_of(const CShapesOf<T>& shapes, int64_t first) noexcept {
  index::Set set{shapes.kind, first, shapes.count, shapes.stride, {}, shapes.rings, shapes.polygons, shapes.each};
  for (int k = 0; k < columns_read(shapes); ++k) {
    set.field[k] = reinterpret_cast<const unsigned char*>(shapes.field[k]);
  }
  return set;
}

/// The sets laid end to end; 0 or what is wrong: NULL, a kind, or an argument. Empty sets leave no trace.
template <class T>
int32_t view_sets(const CShapesOf<T>* sets, int32_t set_count, index::Sets& out, Suits suits = has_core) noexcept {
  if (set_count < 0) return VESICA_E_ARGUMENT;
  if (sets == nullptr && set_count > 0) return VESICA_E_NULL;
  out.is_float = sizeof(T) == sizeof(float);
  int32_t worst = 0;
  for (int32_t s = 0; s < set_count; ++s) {
    int32_t error = check_array(sets[s], suits);
    if (error == 0 && sets[s].count > 0 && has_null(sets[s])) error = VESICA_E_NULL;
    if (error == 0 && sets[s].count > index::most_items - out.items) error = VESICA_E_ARGUMENT;
    if (error == 0 && sets[s].count > 0 && out.count == index::most_sets) error = VESICA_E_ARGUMENT;
    worst = first_error(worst, error);
    if (error != 0 || sets[s].count == 0) continue;
    out.set[out.count++] = set_of<T>(sets[s], out.items);
    out.items += sets[s].count;
  }
  return worst;
}

/// Kinds that suppression takes: those with an area.
inline bool may_be_suppressed(int32_t kind) noexcept { return has_area(kind) || kind == polygon_kind; }

/// An index that a query may read: its header is looked at, the rest is vesica_index_check's.
inline int32_t check_index(const void* index) noexcept {
  if (index == nullptr) return VESICA_E_NULL;
  if (!aligned(index)) return VESICA_E_ARGUMENT;
  return index::header_is_sound(index, INT64_MAX) ? 0 : VESICA_E_INDEX;
}

/// One side of a join: an index, and sets of as many items, of kinds that any query takes.
template <class T>
int32_t check_indexed(const void* index, const CShapesOf<T>* sets, int32_t set_count, index::Sets& view) noexcept {
  const int32_t error = first_error(check_index(index), view_sets<T>(sets, set_count, view, has_core_or_path));
  if (error != 0) return error;
  return view.items == index::View(index).items() ? 0 : VESICA_E_ARGUMENT;
}

/// Columns of gathered shapes, as batches take them; a single shape repeats. Paths are structs.
template <class T>
batch::Shapes<T> columns_of(int32_t kind, const void* const* field, int64_t count) noexcept {
  if (!is_row(kind)) return {kind, count, sizeof(Polygon<T>), {static_cast<const T*>(field[0])}};
  batch::Shapes<T> shapes{kind, count, count == 1 ? 0 : static_cast<ptrdiff_t>(sizeof(T)), {}};
  for (int k = 0; k < field_count(kind); ++k) shapes.field[k] = static_cast<const T*>(field[k]);
  return shapes;
}

/// Which of n pairs have a common point that counts.
template <class T, Common common = Common::any>
void decide_overlap(int32_t kind_a, const void* const* a, int64_t count_a, int32_t kind_b, const void* const* b,
                    int64_t n, uint8_t* out) noexcept {
  batch::many<T>(kernels(), columns_of<T>(kind_a, a, count_a), columns_of<T>(kind_b, b, n), n, out, common);
}

}  // namespace vesica::capi

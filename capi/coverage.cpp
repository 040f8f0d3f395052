// SPDX-License-Identifier: Apache-2.0
// Shares of the cells of a grid that a shape covers: all of them, or those above 0.
#include <algorithm>
#include <cstring>
#include <vesica/coverage.hpp>

#include "arrays.hpp"
#include "by_kind.hpp"
#include "environment.hpp"
#include "vesica_measures.h"

namespace {

/// Calls visit as coverage_or_error() does. Returns 0 or an error.
template <class T, class CGrid, class Visit>
int32_t visit_shares(int32_t kind, const void* shape, const CGrid* grid, bool all, const Visit& visit) noexcept {
  static_assert(sizeof(vesica::Grid<T>) == sizeof *grid);
  vesica::Grid<T> cells;
  std::memcpy(&cells, grid, sizeof cells);
  return vesica::with_shape<T>(kind, shape, [&](const vesica::CoreOrPath auto& s) {
    const int32_t error = vesica::coverage_or_error(s, cells, all, visit);
    return error == VESICA_E_ARGUMENT || error == VESICA_E_RANGE || error == 0 ? error : VESICA_E_SHAPE;
  });
}

template <class T, class CGrid>
int32_t coverage(int32_t kind, const void* shape, const CGrid* grid, T* out, ptrdiff_t row_stride) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((coverage<T, CGrid>), kind, shape, grid, out, row_stride);
  if (shape == nullptr || grid == nullptr) return VESICA_E_NULL;
  if (out == nullptr && grid->columns > 0 && grid->rows > 0) return VESICA_E_NULL;
  if (!vesica::has_core_or_path(kind)) return VESICA_E_KIND;
  const bool has_room = grid->rows <= 1 || row_stride >= grid->columns;
  if (!has_room || !vesica::capi::rows_apart(grid->rows, grid->columns, row_stride, sizeof(T)))
    return VESICA_E_ARGUMENT;
  return visit_shares<T>(kind, shape, grid, true, [&](int64_t row, int64_t first, const double* shares, int64_t count) {
    std::transform(shares, shares + count, out + row * row_stride + first,
                   [](double share) { return static_cast<T>(share); });
  });
}

template <class T, class CGrid>
int64_t coverage_cells(int32_t kind, const void* shape, const CGrid* grid, int64_t* cells, T* shares,
                       int64_t capacity) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((coverage_cells<T, CGrid>), kind, shape, grid, cells, shares, capacity);
  if (shape == nullptr || grid == nullptr) return VESICA_E_NULL;
  if (capacity > 0 && (cells == nullptr || shares == nullptr)) return VESICA_E_NULL;
  if (!vesica::has_core_or_path(kind)) return VESICA_E_KIND;
  int64_t cell_count;
  if (capacity < 0 || __builtin_mul_overflow(grid->rows, grid->columns, &cell_count)) return VESICA_E_ARGUMENT;
  int64_t found = 0;
  const int32_t error =
      visit_shares<T>(kind, shape, grid, false, [&](int64_t row, int64_t first, const double* part, int64_t count) {
        for (int64_t i = 0; i < count; ++i) {
          const T share = static_cast<T>(part[i]);
          if (!(share > 0)) continue;
          if (found < capacity) {
            cells[found] = row * grid->columns + first + i;
            shares[found] = share;
          }
          ++found;
        }
      });
  return error == 0 ? found : error;
}

}  // namespace

#define VESICA_COVERAGE(scalar, T)                                                                            \
  int32_t vesica_coverage_##scalar(int32_t kind, const void* shape, const vesica_grid_##scalar* grid, T* out, \
                                   ptrdiff_t row_stride) {                                                    \
    return coverage(kind, shape, grid, out, row_stride);                                                      \
  }                                                                                                           \
  int64_t vesica_coverage_cells_##scalar(int32_t kind, const void* shape, const vesica_grid_##scalar* grid,   \
                                         int64_t* cells, T* shares, int64_t capacity) {                       \
    return coverage_cells(kind, shape, grid, cells, shares, capacity);                                        \
  }

VESICA_COVERAGE(f64, double)
VESICA_COVERAGE(f32, float)

// SPDX-License-Identifier: Apache-2.0
// Arrays of polygons and polylines: each element as the struct of a single one.
#pragma once

#include <cstring>
#include <limits>

#include "columns.hpp"
#include "polygon/element.hpp"
#include "queries.hpp"

namespace vesica::batch {

template <class T>
bool has_path(const Shapes<T>& a, const Shapes<T>& b) noexcept {
  return !is_row(a.kind) || !is_row(b.kind);
}

/// Element i of an array of any kind, as an operand. Its numbers, or the struct of its polygon, are a copy.
template <class T>
class Element {
 public:
  Element(const Shapes<T>& shapes, std::int64_t i) noexcept : kind_(shapes.kind) {
    if (is_row(kind_)) {
      for (int k = 0; k < field_count(kind_); ++k) number_[k] = shapes.field[k].advanced(i * shapes.stride)[0];
    } else {
      path_ = path_at<T>(
          {shapes.field[0].bytes(), shapes.field[1].bytes(), shapes.stride, shapes.rings, shapes.polygons, shapes.each},
          i);
    }
  }

  Operand operand() const noexcept {
    return {kind_, std::is_same_v<T, float>, is_row(kind_) ? static_cast<const void*>(number_) : &path_};
  }

 private:
  std::int32_t kind_;
  T number_[max_fields];
  Polygon<T> path_;  // or a polyline: their structs are the same
};

/// The results of a query for elements of two arrays.
template <class T, class Out>
class PathQuery {
 public:
  explicit PathQuery(const Query& query) noexcept : query_(query) {}

  /// Writes the first number, or all of them, to column[k][at]; columns may be null.
  void ask(const Element<T>& a, const Element<T>& b, Out* const* column, int columns, std::int64_t at) noexcept {
    Out result[max_results];
    void* const out = query_.numbers == 0 ? nullptr : result;
    const std::int32_t code = query_.paths(a.operand(), b.operand(), out);
    if (query_.numbers == 0) result[0] = static_cast<Out>(code < 0 ? 0 : code);
    if (code < 0) {
      for (int k = 0; k < query_.columns(); ++k) result[k] = std::numeric_limits<Out>::quiet_NaN();
      if (tally_.error != error_shape) tally_.error = code;
    } else {
      tally_.count += query_.counts_zero ? result[0] <= 0 : result[0] > 0;
    }
    for (int k = 0; k < columns; ++k) {
      if (column[k] != nullptr) column[k][at] = result[k];
    }
  }

  QueryTally tally() const noexcept { return tally_; }

 private:
  const Query& query_;
  QueryTally tally_;
};

template <class T, class Out>
QueryTally query_paths(const Query& query, const Shapes<T>& a, const Shapes<T>& b, std::int64_t n,
                       Out* const* columns) noexcept {
  PathQuery<T, Out> asked(query);
  for (std::int64_t i = 0; i < n; ++i) {
    asked.ask({a, a.count == 1 ? 0 : i}, {b, b.count == 1 ? 0 : i}, columns, query.columns(), i);
  }
  return asked.tally();
}

template <class T, class Out>
QueryTally query_paths_matrix(const Query& query, const Shapes<T>& a, const Shapes<T>& b, Out* out,
                              std::ptrdiff_t row_stride) noexcept {
  PathQuery<T, Out> asked(query);
  for (std::int64_t i = 0; i < a.count; ++i) {
    const Element<T> first(a, i);
    Out* const row = out + i * row_stride;
    for (std::int64_t j = 0; j < b.count; ++j) asked.ask(first, {b, j}, &row, 1, j);
  }
  return asked.tally();
}

}  // namespace vesica::batch

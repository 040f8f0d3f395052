// SPDX-License-Identifier: Apache-2.0
// Arrays of polygons and polylines: each element as the struct of a single one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>
#include <optional>

#include "columns.hpp"
#include "polygon/element.hpp"
#include "polygon/operand.hpp"
#include "queries.hpp"

namespace vesica::batch {

template <class T>
bool has_path(const Shapes<T>& a, const Shapes<T>& b) noexcept {
  return !is_row(a.kind) || !is_row(b.kind);
}

/// Boxes about the edges of one path, for as long as a call lasts. To make them takes 0.4 to 0.7 of a question without
/// them; then a point in a path of 64 vertices is answered 3.9 times as fast, of 1,000 vertices 40 times (Zen 3,
/// vesica_bench_polygon_kept).
class ElementBoxes {
 public:
  /// True if the path is valid, and large enough to be worth boxes.
  template <class T>
  bool make(const detail::polygon::Edges<T>& edges) noexcept {
    detail::polygon::Box whole;
    if (edges.check(whole) != 0) return false;
    const detail::polygon::Range all = edges.all();
    constexpr std::int64_t few = 64, runs = room / 2;
    if (all.length() < few) return false;
    kept_.emplace(all.first, all.length(), std::max(std::int64_t{8}, (all.length() + runs - 1) / runs));
    kept_->make(edges, whole, box_);
    return true;
  }
  const detail::polygon::KeptBoxes& kept() const noexcept { return *kept_; }

 private:
  static constexpr std::int64_t room = 1024;  // of 16 KiB
  detail::polygon::KeptBox box_[room];
  std::optional<detail::polygon::KeptBoxes> kept_;
};

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
    return {kind_, std::is_same_v<T, float>, is_row(kind_) ? static_cast<const void*>(number_) : &path_, boxes_};
  }

  /// Uses boxes for many questions, if the element is a valid path of many edges.
  void keep_boxes(ElementBoxes& boxes) noexcept {
    if (!is_row(kind_) && boxes.make(polygon::edges<T>(operand()))) boxes_ = &boxes.kept();
  }

 private:
  const detail::polygon::KeptBoxes* boxes_ = nullptr;
  std::int32_t kind_;
  T number_[max_fields];
  Polygon<T> path_{};  // or a polyline: their structs are the same
};

inline constexpr std::int64_t enough_for_boxes = 4;

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
    put(code, result, column, columns, at);
  }

  /// Writes a result, or NaN in place of an error's.
  void put(std::int32_t code, Out (&result)[max_results], Out* const* column, int columns, std::int64_t at) noexcept {
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

/// How many elements from i on are the same path? 0 for rows.
template <class T>
std::int64_t repeats(const Shapes<T>& shapes, std::int64_t i, std::int64_t n) noexcept {
  if (is_row(shapes.kind)) return 0;
  if (shapes.count == 1) return n - i;
  if (shapes.rings != nullptr || shapes.each != 0) return 1;
  const std::byte* const first = shapes.field[0].bytes() + i * shapes.stride;
  std::int64_t count = 1;
  while (i + count < n && std::memcmp(first, first + count * shapes.stride, sizeof(Polygon<T>)) == 0) ++count;
  return count;
}

/// Calls ask(element of a, element of b, i) for pairs in step. A path that is repeated is asked by boxes. Joins
/// repeat a path for each shape near it.
template <class T, class Ask>
void each_in_step(const Shapes<T>& a, const Shapes<T>& b, std::int64_t n, const Ask& ask) noexcept {
  const std::int64_t step_a = a.count == 1 ? 0 : 1, step_b = b.count == 1 ? 0 : 1;
  for (std::int64_t i = 0; i < n;) {
    const std::int64_t of_a = repeats(a, i, n), of_b = repeats(b, i, n), run = std::max(of_a, of_b);
    ElementBoxes boxes;
    Element<T> one(run == of_a ? a : b, i * (run == of_a ? step_a : step_b));
    if (run >= enough_for_boxes) one.keep_boxes(boxes);
    for (const std::int64_t end = i + run; i < end; ++i) {
      if (run == of_a) {
        ask(one, Element<T>(b, i * step_b), i);
      } else {
        ask(Element<T>(a, i * step_a), one, i);
      }
    }
  }
}

/// Calls ask(element i of a, element j of b, i, j) for all pairs.
template <class T, class Ask>
void each_pair(const Shapes<T>& a, const Shapes<T>& b, const Ask& ask) noexcept {
  for (std::int64_t i = 0; i < a.count; ++i) {
    ElementBoxes boxes;
    Element<T> first(a, i);
    if (b.count >= enough_for_boxes) first.keep_boxes(boxes);
    for (std::int64_t j = 0; j < b.count; ++j) ask(first, Element<T>(b, j), i, j);
  }
}

template <class T, class Out>
QueryTally query_paths(const Query& query, const Shapes<T>& a, const Shapes<T>& b, std::int64_t n,
                       Out* const* columns) noexcept {
  PathQuery<T, Out> asked(query);
  each_in_step(a, b, n, [&](const Element<T>& first, const Element<T>& second, std::int64_t i) {
    asked.ask(first, second, columns, query.columns(), i);
  });
  return asked.tally();
}

template <class T, class Out>
QueryTally query_paths_matrix(const Query& query, const Shapes<T>& a, const Shapes<T>& b, Out* out,
                              std::ptrdiff_t row_stride) noexcept {
  PathQuery<T, Out> asked(query);
  each_pair(a, b, [&](const Element<T>& first, const Element<T>& second, std::int64_t i, std::int64_t j) {
    asked.ask(first, second, &out, 1, i * row_stride + j);
  });
  return asked.tally();
}

}  // namespace vesica::batch

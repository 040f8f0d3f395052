// SPDX-License-Identifier: Apache-2.0
// Operands of the queries of numbers: blocks of shapes as columns of doubles.
#pragma once

#include <cmath>
#include <limits>

#include "columns.hpp"
#include "query.hpp"

namespace vesica::batch {
namespace {  // compiled in place by queries.cpp and cast_batch.cpp

/// n rounded up to a multiple of the widest vector's doubles.
constexpr std::int32_t whole_vectors(std::int32_t n) noexcept {
  return (n + widest_vector - 1) / widest_vector * widest_vector;
}

/// The radius of a circle about the centre that holds a rectangle, up to a relative 2^-47 too large. NaN if the
/// rectangle is invalid or its squares are not normal numbers.
inline double bounding_radius(double cx, double cy, double ux, double uy, double hx, double hy) noexcept {
  constexpr double least = 0x1p-400, most = 0x1p400;
  const double uu = ux * ux + uy * uy, hh = hx * hx + hy * hy, square = uu * hh;
  const bool usable = (hx >= 0) & (hy >= 0) & (uu >= least) & (uu <= most) & (hh >= least) & (hh <= most);
  const double zero = 0 * cx + 0 * cy;  // where they are finite
  return usable ? std::sqrt(square) * (1 + 0x1p-48) + zero : std::numeric_limits<double>::quiet_NaN();
}

/// A block of shapes of one kind, all numbers as doubles, in whole vectors.
class NumberColumns {
 public:
  std::int32_t kind() const noexcept { return kind_; }
  bool repeated() const noexcept { return repeated_; }
  /// True if a query that knows radii knows those of this kind.
  bool has_radii() const noexcept { return Kind{kind_} == Kind::rect; }

  /// Elements [begin, begin + n), or one shape repeated.
  template <class T>
  void set(const Shapes<T>& shapes, std::int64_t begin, std::int32_t n, const Query& query,
           const KernelTable& kernels) noexcept {
    const Known known = query.asked().known;
    if (shapes.stride == 0) n = 1;
    // The rest of the columns is set too, since overlap_block() reads whole columns.
    const std::int32_t end = shapes.stride == 0 && known == Known::overlap ? query_block : whole_vectors(n);
    set_numbers(shapes, begin, n, end, kernels);
    if (known == Known::radius && has_radii()) set_radii(query.shape_area != nullptr);
  }

  /// The numbers alone.
  template <class T>
  void set(const Shapes<T>& shapes, std::int64_t begin, std::int32_t n, const KernelTable& kernels) noexcept {
    if (shapes.stride == 0) n = 1;
    set_numbers(shapes, begin, n, whole_vectors(n), kernels);
  }

  /// Computes the areas, if the query has them and unless they are known.
  void find_areas(const Query& query) noexcept {
    if (has_areas_ || query.shape_area == nullptr) return;
    has_areas_ = true;
    for (std::int32_t i = 0; i < n_; ++i) {
      double numbers[max_fields];
      element(i, numbers);
      area_[i] = query.shape_area(kind_, numbers);
    }
    for (std::int32_t i = n_; i < end_; ++i) area_[i] = area_[0];
  }

  /// n > 0 elements of another.
  void gather(const NumberColumns& from, const std::int32_t* list, std::int32_t n) noexcept {
    kind_ = from.kind_;
    repeated_ = false;
    n_ = n;
    end_ = whole_vectors(n);
    has_areas_ = from.has_areas_;
    const auto pick = [&](const double* source, double(&to)[query_block]) {
      for (std::int32_t i = 0; i < end_; ++i) to[i] = source[list[i < n ? i : 0]];
    };
    for (int k = 0; k < field_count(kind_); ++k) {
      pick(from.number_[k], copy_[k]);
      number_[k] = copy_[k];
    }
    for (int k = field_count(kind_); k < max_fields; ++k) number_[k] = number_[0];  // as set_numbers()
    if (has_areas_) pick(from.area_, area_);
    pick(from.radius_, radius_);
  }

  const double* const* numbers() const noexcept { return number_; }

  QueryOperand operand() const noexcept {
    QueryOperand out{{}, area_, radius_, repeated_};
    for (int k = 0; k < max_fields; ++k) out.number[k] = number_[k];
    return out;
  }

  void element(std::int32_t i, double (&out)[max_fields]) const noexcept {
    const std::int32_t at = repeated_ ? 0 : i;
    for (int k = 0; k < max_fields; ++k) out[k] = number_[k][at];
  }

  /// The same with its area, once areas were computed.
  ShapeOfKind shape(std::int32_t i, double (&numbers)[max_fields]) const noexcept {
    element(i, numbers);
    return {kind_, numbers, area_[repeated_ ? 0 : i]};
  }

 private:
  std::int32_t kind_, n_, end_;  // end_: n_ in whole vectors
  bool repeated_, has_areas_;
  const double* number_[max_fields] = {};
  double copy_[max_fields][query_block];
  double area_[query_block] = {};
  double radius_[query_block] = {};

  template <class T>
  void set_numbers(const Shapes<T>& shapes, std::int64_t begin, std::int32_t n, std::int32_t end,
                   const KernelTable& kernels) noexcept {
    kind_ = shapes.kind;
    repeated_ = shapes.stride == 0;
    n_ = n;
    end_ = end;
    has_areas_ = false;
    if (!read_in_place(shapes, begin, n, end)) {
      if (n < widest_vector) {
        read_few(shapes, begin, n);
      } else {
        read(shapes, begin, n, kernels);
      }
      fill_up(n, end);
      for (int k = 0; k < max_fields; ++k) number_[k] = copy_[k];
    }
    // Numbers that the kind does not have repeat the first: loops of a fixed length read elements faster.
    for (int k = field_count(kind_); k < max_fields; ++k) number_[k] = number_[0];
  }

  /// Whole vectors of aligned doubles that lie in columns need no copy.
  bool read_in_place(const Shapes<double>& shapes, std::int64_t begin, std::int32_t n, std::int32_t end) noexcept {
    if (!lies_in_columns(shapes) || n != end) return false;
    for (int k = 0; k < field_count(kind_); ++k) {
      number_[k] = shapes.field[k].advanced(begin * shapes.stride).aligned();
      if (number_[k] == nullptr) return false;
    }
    return true;
  }
  static bool read_in_place(const Shapes<float>&, std::int64_t, std::int32_t, std::int32_t) noexcept { return false; }

  /// Reads number by number. For few shapes a transposition would cost more than it saves.
  template <class T>
  void read_few(const Shapes<T>& shapes, std::int64_t begin, std::int32_t n) noexcept {
    for (int k = 0; k < field_count(kind_); ++k) {
      const Unaligned<T> from = shapes.field[k].advanced(begin * shapes.stride);
      for (std::int32_t i = 0; i < n; ++i) copy_[k][i] = static_cast<double>(from.advanced(i * shapes.stride)[0]);
    }
  }
  void read(const Shapes<double>& shapes, std::int64_t begin, std::int32_t n, const KernelTable& kernels) noexcept {
    copy_to_columns(kernels, shapes, begin, n, copy_);
  }
  void read(const Shapes<float>& shapes, std::int64_t begin, std::int32_t n, const KernelTable& kernels) noexcept {
    float narrow[max_fields][query_block];
    const bool in_place = lies_in_columns(shapes);
    if (!in_place) copy_to_columns(kernels, shapes, begin, n, narrow);
    for (int k = 0; k < field_count(kind_); ++k) {
      const Unaligned<float> lies = shapes.field[k].advanced(begin * shapes.stride);
      kernels.widen_column(in_place ? lies : Unaligned<float>(narrow[k]), n, copy_[k]);
    }
  }

  /// Whole vectors repeat the first element behind the last one.
  void fill_up(std::int32_t n, std::int32_t end) noexcept {
    for (int k = 0; k < field_count(kind_); ++k) {
      for (std::int32_t i = n; i < end; ++i) copy_[k][i] = copy_[k][0];
    }
  }

  void set_radii(bool by_area) noexcept {
    for (std::int32_t i = 0; i < end_; ++i) {
      const double ux = number_[2][i], uy = number_[3][i], hx = number_[4][i], hy = number_[5][i];
      radius_[i] = bounding_radius(number_[0][i], number_[1][i], ux, uy, hx, hy);
      // If areas are compared, one of 0 is an error for some pairs, and one of odd magnitude needs the scalar care.
      const double area = hx * hy * (ux * ux + uy * uy);
      const bool usual = (area >= 0x1p-700) & (area <= 0x1p700);
      if (by_area && !usual) radius_[i] = std::numeric_limits<double>::quiet_NaN();
    }
  }
};

}  // namespace
}  // namespace vesica::batch

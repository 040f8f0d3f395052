// SPDX-License-Identifier: Apache-2.0
// Areas and ratios of arrays of polygons: boxes and own areas are found once for a block, and polygons of few sides
// share areas in lanes. Pairs that these leave open are asked one by one.
#pragma once

#include <cmath>
#include <vesica/polygon/area.hpp>

#include "polygon/areas.hpp"
#include "polygon/arrays.hpp"

namespace vesica::batch {

template <class T>
bool asks_areas(const Query& query, const QueryTable& kernels, const Shapes<T>& a, const Shapes<T>& b) noexcept {
  return query.of_shares != nullptr && kernels.ring_areas[0] != nullptr && a.kind == polygon_kind &&
         b.kind == polygon_kind;
}

/// The polygons of a block in the kernels' columns.
template <class T>
class RingBlockColumns {
 public:
  /// Elements begin to begin + n - 1, and nothing up to a whole vector.
  void set(const QueryTable& kernels, const Shapes<T>& shapes, std::int64_t begin, std::int32_t n) noexcept {
    std::uint8_t large[RingColumn::length];
    sides_ = 0;
    const std::int32_t whole = whole_vectors(n);
    for (std::int32_t i = 0; i < n; ++i) large[i] = !set_vertices(Element<T>(shapes, begin + i), i);
    // By the column: g++ 12 makes aligned stores of two nested loops the other way round, wherever they begin.
    for (int k = RingColumn::x; k < RingColumn::slope; ++k)
      std::fill(number_ + k * RingColumn::length + n, number_ + k * RingColumn::length + whole, nan);
    kernels.ring_facts(number_, sides_, whole);
    for (std::int32_t i = 0; i < n; ++i) {
      if (large[i]) set_large(Element<T>(shapes, begin + i), i);
    }
  }

  const double* numbers() const noexcept { return number_; }
  int sides() const noexcept { return sides_; }
  detail::polygon::Box box(std::int32_t i) const noexcept {
    return {number(RingColumn::min_x, i), number(RingColumn::min_y, i), number(RingColumn::max_x, i),
            number(RingColumn::max_y, i)};
  }
  detail::area::Measure area(std::int32_t i) const noexcept { return {number(RingColumn::area, i), 0}; }

 private:
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();

  double number(int k, std::int32_t i) const noexcept { return number_[k * RingColumn::length + i]; }
  double& number(int k, std::int32_t i) noexcept { return number_[k * RingColumn::length + i]; }

  void set_none(std::int32_t i) noexcept {
    for (int k = RingColumn::x; k < RingColumn::slope; ++k) number(k, i) = nan;
  }
  /// Returns false if there are more vertices or rings, or none.
  bool set_vertices(const Element<T>& element, std::int32_t i) noexcept {
    const auto edges = polygon::edges<T>(element.operand());
    const detail::polygon::Range ring =
        edges.has_null() || edges.rings() != 1 ? detail::polygon::Range{} : edges.ring(0);
    if (ring.first < 0 || ring.length() < 1 || ring.length() > RingColumn::sides) {
      set_none(i);
      return false;
    }
    const auto sides = static_cast<int>(ring.length());
    sides_ = std::max(sides_, sides);
    const Point<double> first = edges.vertex(ring.first);
    for (int k = 0; k <= RingColumn::sides; ++k) {
      const Point<double> v = k < sides ? edges.vertex(ring.first + k) : first;
      number(RingColumn::x + k, i) = v.x;
      number(RingColumn::y + k, i) = v.y;
    }
    return true;
  }
  void set_large(const Element<T>& element, std::int32_t i) noexcept {
    detail::polygon::Box box;
    double area;
    if (!polygon::own_area(element.operand(), box, area)) return;
    number(RingColumn::min_x, i) = box.min_x;
    number(RingColumn::min_y, i) = box.min_y;
    number(RingColumn::max_x, i) = box.max_x;
    number(RingColumn::max_y, i) = box.max_y;
    number(RingColumn::area, i) = area;
    number(RingColumn::open, i) = nan;
  }

  alignas(64) double number_[RingColumn::count * RingColumn::length];
  int sides_ = 0;
};

/// Pairs with elements of two arrays, a block at a time.
template <class T>
class AreaBlocks {
 public:
  AreaBlocks(const Query& query, const QueryTable& kernels, const Shapes<T>& a, const Shapes<T>& b) noexcept
      : query_(query), results_(query), kernels_(kernels), a_(a), b_(b) {}

  void set_a(std::int64_t begin, std::int32_t n) noexcept { columns_a_.set(kernels_, a_, begin_a_ = begin, n); }
  void set_b(std::int64_t begin, std::int32_t n) noexcept { columns_b_.set(kernels_, b_, begin_b_ = begin, n); }

  /// n pairs, with the first element alone of an array that repeats it.
  void answer(std::int32_t n, bool repeats_a, bool repeats_b, T* out) noexcept {
    double areas[RingColumn::length];
    const int sides = std::max(columns_a_.sides(), columns_b_.sides());
    const bool exchanged = repeats_b && !repeats_a;
    const RingBlockColumns<T>&first = exchanged ? columns_b_ : columns_a_,
          &second = exchanged ? columns_a_ : columns_b_;
    const RingAreas ring_areas = kernels_.ring_areas[repeats_a != repeats_b ? 1 : 0];
    ring_areas(first.numbers(), second.numbers(), sides, whole_vectors(n), areas);
    for (std::int32_t i = 0; i < n; ++i) {
      const std::int32_t of_a = repeats_a ? 0 : i, of_b = repeats_b ? 0 : i;
      if (std::isnan(areas[i])) {
        results_.ask({a_, begin_a_ + of_a}, {b_, begin_b_ + of_b}, &out, 1, i);
      } else if (areas[i] == 0 && query_.is_none_of_none) {
        out[i] = 0;
      } else {
        finish(areas[i], of_a, of_b, out, i);
      }
    }
  }

  QueryTally tally() const noexcept { return results_.tally(); }

 private:
  void finish(double area, std::int32_t of_a, std::int32_t of_b, T* out, std::int32_t i) noexcept {
    detail::polygon::PathShares shares;
    shares.shared = {area, 0};
    shares.a = columns_a_.area(of_a);
    shares.b = columns_b_.area(of_b);
    shares.equal = false;
    shares.box_a = columns_a_.box(of_a);
    shares.box_b = columns_b_.box(of_b);
    T result[max_results];
    const std::int32_t code = query_.of_shares(shares, std::is_same_v<T, float>, result);
    results_.put(code, result, &out, 1, i);
  }

  const Query& query_;
  PathQuery<T, T> results_;
  const QueryTable& kernels_;
  const Shapes<T>&a_, &b_;
  std::int64_t begin_a_ = 0, begin_b_ = 0;
  RingBlockColumns<T> columns_a_, columns_b_;
};

template <class T>
QueryTally areas_in_step(const Query& query, const QueryTable& kernels, const Shapes<T>& a, const Shapes<T>& b,
                         std::int64_t n, T* out) noexcept {
  AreaBlocks<T> blocks(query, kernels, a, b);
  const bool repeats_a = a.count == 1 && n > 1, repeats_b = b.count == 1 && n > 1;
  if (repeats_a) blocks.set_a(0, 1);
  if (repeats_b) blocks.set_b(0, 1);
  for (std::int64_t begin = 0; begin < n; begin += RingColumn::length) {
    const std::int32_t length = block_length(n - begin, RingColumn::length);
    if (!repeats_a) blocks.set_a(begin, length);
    if (!repeats_b) blocks.set_b(begin, length);
    blocks.answer(length, repeats_a, repeats_b, out + begin);
  }
  return blocks.tally();
}

template <class T>
QueryTally area_matrix(const Query& query, const QueryTable& kernels, const Shapes<T>& a, const Shapes<T>& b, T* out,
                       std::ptrdiff_t row_stride) noexcept {
  AreaBlocks<T> blocks(query, kernels, a, b);
  for (std::int64_t begin = 0; begin < b.count; begin += RingColumn::length) {
    const std::int32_t length = block_length(b.count - begin, RingColumn::length);
    blocks.set_b(begin, length);
    for (std::int64_t row = 0; row < a.count; ++row) {
      blocks.set_a(row, 1);
      blocks.answer(length, true, false, out + row * row_stride + begin);
    }
  }
  return blocks.tally();
}

}  // namespace vesica::batch

// SPDX-License-Identifier: Apache-2.0
// The one loop behind every batch: load lanes, ask the pair's filter, store bytes, note what it left undecided.
// Included once by each source in src/isa, after the lanes of its instruction set.
#pragma once

#include <cstring>
#include <type_traits>
#include <utility>
#include <vesica/overlap.hpp>

#include "kernels/table.hpp"
#include "kernels/unit_rect_rect.hpp"

namespace vesica {
namespace {

template <class T>
using LanesOf = std::conditional_t<sizeof(T) == 4, Floats, Doubles>;

/// The filter a kernel runs: the pair's own, or the quicker one for unit axes.
struct General {
  template <class A, class B>
  static auto filter(const A& a, const B& b) noexcept {
    return pair::filter(a, b);
  }
};
struct UnitAxes {
  template <class V>
  static auto filter(const Rect<V>& a, const Rect<V>& b) noexcept {
    return filter::unit_box_box(filter::box(a), filter::box(b), filter::offset(filter::place(a), filter::place(b)));
  }
};

/// A shape of lanes from element i on, or one shape in every lane.
template <template <class> class Shape, class T, std::size_t... Field>
Shape<LanesOf<T>> load_lanes(const T* const* field, std::int32_t i, std::index_sequence<Field...>) noexcept {
  return {LanesOf<T>::load(field[Field] + i)...};
}
template <class T>
T load_unaligned(const T* p) noexcept {
  T x;
  std::memcpy(&x, p, sizeof x);
  return x;
}
template <template <class> class Shape, class T, std::size_t... Field>
Shape<LanesOf<T>> broadcast(const T* const* field, std::index_sequence<Field...>) noexcept {
  return {LanesOf<T>(load_unaligned(field[Field]))...};
}

/// One operand of a kernel. Its pointers are copied: stores through a byte pointer could otherwise change them.
template <template <class> class Shape, class T, bool Repeated>
struct Operand {
  static constexpr int fields = ShapeTraits<Shape<T>>::fields;
  using Fields = std::make_index_sequence<fields>;
  const T* field[fields];

  explicit Operand(const T* const* from) noexcept {
    for (int k = 0; k < fields; ++k) field[k] = from[k];
  }
  Shape<LanesOf<T>> at(std::int32_t i) const noexcept { return load_lanes<Shape>(field, i, Fields{}); }
  /// The last, partial vector: copied out, so that nothing beyond the arrays is read; lanes without an element repeat
  /// one.
  Shape<LanesOf<T>> tail(std::int32_t i, std::int32_t rest) const noexcept {
    constexpr int width = LanesOf<T>::width;
    T copy[fields][width];
    const T* copied[fields];
    for (int k = 0; k < fields; ++k) {
      for (int j = 0; j < width; ++j) std::memcpy(&copy[k][j], field[k] + i + (j < rest ? j : 0), sizeof(T));
      copied[k] = copy[k];
    }
    return load_lanes<Shape>(copied, 0, Fields{});
  }
};

template <template <class> class Shape, class T>
struct Operand<Shape, T, true> {
  static constexpr int fields = ShapeTraits<Shape<T>>::fields;
  Shape<LanesOf<T>> shape;

  explicit Operand(const T* const* from) noexcept : shape(broadcast<Shape>(from, std::make_index_sequence<fields>{})) {}
  const Shape<LanesOf<T>>& at(std::int32_t) const noexcept { return shape; }
  const Shape<LanesOf<T>>& tail(std::int32_t, std::int32_t) const noexcept { return shape; }
};

/// Appends the indices of the lanes set in `open`.
inline std::int32_t* append(std::uint32_t open, std::int32_t i, std::int32_t* list) noexcept {
  for (; open != 0; open &= open - 1) *list++ = i + __builtin_ctz(open);
  return list;
}

template <class Filter, template <class> class A, template <class> class B, class T, Repeat repeat>
BlockResult answer_block(const Block<T>& block) noexcept {
  constexpr std::int32_t width = LanesOf<T>::width;
  constexpr std::uint32_t all = width == 32 ? ~0u : (1u << width) - 1;
  const Operand<A, T, repeat == Repeat::first> first(block.first);
  const Operand<B, T, repeat == Repeat::second> second(block.second);
  const std::int32_t n = block.count, whole = n - n % width;
  std::uint8_t* const out = block.out;
  std::int32_t* list = block.undecided;
  std::int32_t overlaps = 0, i = 0;
  for (; i < whole; i += width) {
    const auto verdict = Filter::filter(first.at(i), second.at(i));
    store_bytes(verdict.overlap, out + i);
    overlaps += count(verdict.overlap);
    const std::uint32_t open = ~bits(either(verdict.overlap, verdict.disjoint)) & all;
    if (open != 0) [[unlikely]]
      list = append(open, i, list);
  }
  if (i < n) {
    const std::uint32_t present = (1u << (n - i)) - 1;
    const auto verdict = Filter::filter(first.tail(i, n - i), second.tail(i, n - i));
    std::uint8_t bytes[width];
    store_bytes(verdict.overlap, bytes);
    std::memcpy(out + i, bytes, static_cast<std::size_t>(n - i));
    overlaps += __builtin_popcount(bits(verdict.overlap) & present);
    list = append(~bits(either(verdict.overlap, verdict.disjoint)) & present, i, list);
  }
  return {overlaps, static_cast<std::int32_t>(list - block.undecided)};
}

template <class Filter, template <class> class A, template <class> class B, class T>
constexpr void fill(BlockKernel<T> (&kernel)[repeat_count]) noexcept {
  kernel[static_cast<int>(Repeat::none)] = answer_block<Filter, A, B, T, Repeat::none>;
  kernel[static_cast<int>(Repeat::first)] = answer_block<Filter, A, B, T, Repeat::first>;
  kernel[static_cast<int>(Repeat::second)] = answer_block<Filter, A, B, T, Repeat::second>;
}

template <template <class> class A, template <class> class B, class T>
constexpr void fill_pair(ScalarKernels<T>& kernels) noexcept {
  auto& pair = kernels[static_cast<int>(ShapeTraits<A<T>>::kind)][static_cast<int>(ShapeTraits<B<T>>::kind)];
  fill<General, A, B, T>(pair.general);
  fill<General, A, B, T>(pair.unit);
}

template <class T>
constexpr void fill_pairs(ScalarKernels<T>& kernels) noexcept {
  fill_pair<Point, Point>(kernels);
  fill_pair<Point, Segment>(kernels);
  fill_pair<Point, Circle>(kernels);
  fill_pair<Point, Aabb>(kernels);
  fill_pair<Point, Rect>(kernels);
  fill_pair<Point, Ellipse>(kernels);
  fill_pair<Segment, Segment>(kernels);
  fill_pair<Segment, Circle>(kernels);
  fill_pair<Segment, Aabb>(kernels);
  fill_pair<Segment, Rect>(kernels);
  fill_pair<Segment, Ellipse>(kernels);
  fill_pair<Circle, Circle>(kernels);
  fill_pair<Circle, Aabb>(kernels);
  fill_pair<Circle, Rect>(kernels);
  fill_pair<Circle, Ellipse>(kernels);
  fill_pair<Aabb, Aabb>(kernels);
  fill_pair<Aabb, Rect>(kernels);
  fill_pair<Aabb, Ellipse>(kernels);
  fill_pair<Rect, Rect>(kernels);
  fill_pair<Rect, Ellipse>(kernels);
  fill_pair<Ellipse, Ellipse>(kernels);
  constexpr int rect = static_cast<int>(Kind::rect);
  fill<UnitAxes, Rect, Rect, T>(kernels[rect][rect].unit);
}

/// Everything this instruction set offers, laid down at compile time.
consteval KernelTable make_table(const char* name) noexcept {
  KernelTable table{};
  table.name = name;
  fill_pairs<float>(table.f32);
  fill_pairs<double>(table.f64);
  return table;
}

}  // namespace
}  // namespace vesica

// SPDX-License-Identifier: Apache-2.0
/// The loop around every yardstick. Included once by each source that names an instruction set, after its lanes.
#pragma once

#include <type_traits>
#include <utility>

#include "batch/unfiltered/contact_cubic.hpp"
#include "batch/unfiltered/rect_ellipse.hpp"
#include "batch/unfiltered/rect_rect.hpp"
#include "batch/unfiltered/table.hpp"

namespace vesica::unfiltered {
namespace {  // as the lanes, a type of its own in each object

#if defined(__AVX512F__) || defined(__aarch64__)
constexpr int vector_registers = 32;
#else
constexpr int vector_registers = 16;
#endif

template <class T>
using LanesOf = std::conditional_t<sizeof(T) == 4, Floats, Doubles>;

/// The columns of one operand, in a copy that stores of answers cannot change.
template <template <class> class Shape, class T, bool one>
class Operand {
 public:
  VESICA_INLINE explicit Operand(Columns<T> from) noexcept {
    for (int k = 0; k < fields; ++k) field_[k] = from[k];
  }
  VESICA_INLINE Shape<LanesOf<T>> at(std::int64_t i) const noexcept {
    return load(i, std::make_index_sequence<fields>{});
  }

 private:
  static constexpr int fields = ShapeTraits<Shape<T>>::fields;

  template <std::size_t... k>
  VESICA_INLINE Shape<LanesOf<T>> load(std::int64_t i, std::index_sequence<k...>) const noexcept {
    return {LanesOf<T>::load(field_[k] + i)...};
  }

  const T* field_[fields];
};

/// One shape in every lane.
template <template <class> class Shape, class T>
class Operand<Shape, T, true> {
 public:
  VESICA_INLINE explicit Operand(Columns<T> from) noexcept
      : shape_(broadcast(from, std::make_index_sequence<ShapeTraits<Shape<T>>::fields>{})) {}
  VESICA_INLINE const Shape<LanesOf<T>>& at(std::int64_t) const noexcept { return shape_; }

 private:
  template <std::size_t... k>
  VESICA_INLINE static Shape<LanesOf<T>> broadcast(Columns<T> from, std::index_sequence<k...>) noexcept {
    return {LanesOf<T>(from[k][0])...};
  }

  Shape<LanesOf<T>> shape_;
};

/// Answers two vectors at a time where there are registers enough: their operations interleave, and neither waits long
/// for its own. Measured, 3 to 12% quicker with 32 registers, slower with 16.
template <template <class> class A, template <class> class B, class T, bool one>
std::int64_t answer(Columns<T> first, Columns<T> second, std::int64_t n, std::uint8_t* out) noexcept {
  constexpr std::int64_t width = LanesOf<T>::width;
  constexpr bool in_pairs = vector_registers >= 32 && (one || ShapeTraits<B<T>>::kind == Kind::ellipse);
  const Operand<A, T, one> a(first);
  const Operand<B, T, false> b(second);
  std::int64_t overlaps = 0;
  for (std::int64_t i = 0; i < n; i += in_pairs ? 2 * width : width) {
    const auto mask = overlap(a.at(i), b.at(i));
    if constexpr (in_pairs) {
      const auto next = overlap(a.at(i + width), b.at(i + width));
      store_bytes(next, out + i + width);
      overlaps += count(next);
    }
    store_bytes(mask, out + i);
    overlaps += count(mask);
  }
  return overlaps;
}

/// Eight sums at once, so that additions do not wait for each other, and the two halves in step: two streams are read
/// faster than one.
template <class T>
T sum_of(const T* numbers, std::size_t n) noexcept {
  using V = LanesOf<T>;
  constexpr std::size_t width = V::width, chains = 4;
  const T* const half[] = {numbers, numbers + n / 2};
  V sum[2 * chains];
  for (V& part : sum) part = V(T(0));
  for (std::size_t i = 0; i < n / 2; i += width * chains) {
    for (std::size_t k = 0; k < 2 * chains; ++k) sum[k] = sum[k] + V::load(half[k / chains] + i + k % chains * width);
  }
  for (std::size_t k = 1; k < 2 * chains; ++k) sum[0] = sum[0] + sum[k];
  T parts[width];
  __builtin_memcpy(parts, &sum[0], sizeof parts);
  T total = 0;
  for (const T part : parts) total += part;
  return total;
}

template <template <class> class A, template <class> class B, class T>
constexpr void fill(Kernels<T>& kernels) noexcept {
  kernels[static_cast<int>(ShapeTraits<A<T>>::kind)][static_cast<int>(ShapeTraits<B<T>>::kind)] = {
      answer<A, B, T, false>, answer<A, B, T, true>};
}

template <class T>
constexpr void fill_all(Kernels<T>& kernels) noexcept {
  fill<Rect, Rect>(kernels);
  fill<Rect, Ellipse>(kernels);
  fill<Circle, Ellipse>(kernels);
  fill<Ellipse, Ellipse>(kernels);
}

consteval Table make_table(const char* name) noexcept {
  Table table{name, {}, {}, sum_of<float>, sum_of<double>};
  fill_all(table.f32);
  fill_all(table.f64);
  return table;
}

}  // namespace
}  // namespace vesica::unfiltered

// SPDX-License-Identifier: Apache-2.0
// Checked kernels: for a row of a matrix against a block of columns whose shapes were checked beforehand, all together
// (checked_shapes.hpp). A pair then costs little more than its arithmetic and one comparison. Included after the lanes
// of an instruction set.
#pragma once

#include <cstdint>

#include "kernels/block_loop.hpp"
#include "kernels/checked_rect_ellipse.hpp"
#include "kernels/checked_rect_rect.hpp"

namespace vesica {
namespace {

/// The row's shape in every lane.
template <class Shape>
struct RowOperand {
  Shape shape;
  VESICA_INLINE const Shape& at(std::int32_t) const noexcept { return shape; }
};

struct CheckedMixed {
  template <class V>
  VESICA_INLINE static auto filter(const Rect<V>& r, const filter::PreparedEllipse<V>& e) noexcept {
    return filter::checked_box_ellipse(r, e);
  }
};

template <template <class> class Shape>
inline constexpr bool is_ellipse = kind_of<Shape> == Kind::ellipse;

/// True if the kernel may be used for the row's shape and a block of that extent, see checked_rect_ellipse.hpp.
template <template <class> class One, template <class> class Many, class V>
VESICA_INLINE bool is_usable(const One<V>& one, V extent_of_many) noexcept {
  if (!all(filter::checked(one))) return false;
  if constexpr (is_ellipse<One> == is_ellipse<Many>) return true;
  const V of_rect = is_ellipse<One> ? extent_of_many : filter::extent(one);
  const V of_ellipse = is_ellipse<One> ? filter::extent(one) : extent_of_many;
  return all(of_rect <= V(4096.0f) * of_ellipse);
}

/// Answers a whole number of vectors of a block that check_block() found usable.
template <template <class> class One, template <class> class Many, class T>
[[gnu::noinline]] VESICA_KERNEL BlockResult answer_checked(const Block<T>& block) noexcept {
  using V = LanesOf<T>;
  constexpr bool in_order = kind_of<One> <= kind_of<Many>;
  const Unaligned<T>* const many = in_order ? block.second : block.first;
  const One<V> one = LaneOperand<One, T, true>(in_order ? block.first : block.second).shape;
  if (!is_usable<One, Many>(one, V(block.extent))) return {0, row_is_unusable};
  if constexpr (is_ellipse<Many>) {
    return answer_whole(CheckedMixed{}, RowOperand<Rect<V>>{one}, LaneOperand<filter::PreparedEllipse, T, false>(many),
                        block);
  } else if constexpr (is_ellipse<One>) {
    return answer_whole(CheckedMixed{}, LaneOperand<Rect, T, false>(many),
                        RowOperand<filter::PreparedEllipse<V>>{filter::prepared(one)}, block);
  } else {
    return answer_whole(filter::CheckedBoxBox<V>(one, V(block.extent)), RowOperand<Rect<V>>{one},
                        LaneOperand<Rect, T, false>(many), block);
  }
}

template <class V>
VESICA_INLINE typename V::Element widest(V x, bool greatest) noexcept {
  typename V::Element lane[V::width];
  x.store(lane);
  for (int i = 1; i < V::width; ++i) lane[0] = (lane[i] > lane[0]) == greatest ? lane[i] : lane[0];
  return lane[0];
}

template <class T, class... V>
VESICA_INLINE void store_columns(T* to, std::int32_t stride, V... column) noexcept {
  ((column.store(to), to += stride), ...);
}

/// Checks the columns of a block of at least a vector: may a checked kernel be used for them? If so, it writes their
/// extent to the block. Columns of prepared ellipses go to `space`, one every `stride` numbers, and replace the block's
/// own.
template <template <class> class One, template <class> class Many, class T>
[[gnu::noinline]] VESICA_KERNEL bool check_block(Block<T>& block, T* space, std::int32_t stride) noexcept {
  using V = LanesOf<T>;
  constexpr int prepared_columns = is_ellipse<Many> ? 4 : 0;
  Unaligned<T>* const field = kind_of<One> <= kind_of<Many> ? block.second : block.first;
  const LaneOperand<Many, T, false> many(field);
  if (block.count < V::width) return false;
  V extent = filter::extent(many.at(0));
  for (std::int32_t next = 0; next < block.count; next += V::width) {
    const std::int32_t i = next < block.count - V::width ? next : block.count - V::width;
    const auto shape = many.at(i);
    if (!all(filter::checked(shape))) return false;
    extent = is_ellipse<Many> ? min(extent, filter::extent(shape)) : max(extent, filter::extent(shape));
    if constexpr (prepared_columns > 0) {
      const auto e = filter::prepared(shape);
      store_columns(space + i, stride, e.mean, e.swing_cos, e.swing_sin, e.r);
    }
  }
  block.extent = widest(extent, !is_ellipse<Many>);
  for (int k = 0; k < prepared_columns; ++k)
    field[ShapeTraits<Many<T>>::fields - prepared_columns + k] = space + k * stride;
  return true;
}

template <template <class> class One, template <class> class Many, class T>
consteval void enter_checked(CheckedKernels<T>& kernels) noexcept {
  kernels.of[static_cast<int>(kind_of<One>)][static_cast<int>(kind_of<Many>)] = {check_block<One, Many, T>,
                                                                                 answer_checked<One, Many, T>};
}

/// For vectors of 32 bytes and more: narrower ones were not measured.
///
/// Gains in a matrix of 1,024 x 1,024, double / float, AVX-512 (Zen 5): a rectangle's row of ellipses 1.56 / 1.42, an
/// ellipse's row of rectangles 1.32 / 1.25, two rectangles 1.25 / 1.19. These are kept because matrices of rectangles
/// are what detectors ask for. Two ellipses gained 1.05 and have none.
template <class T>
consteval CheckedKernels<T> make_checked_kernels() noexcept {
  CheckedKernels<T> kernels{};
  if constexpr (LanesOf<T>::width * sizeof(T) >= 32) {
    enter_checked<Rect, Rect>(kernels);
    enter_checked<Rect, Ellipse>(kernels);
    enter_checked<Ellipse, Rect>(kernels);
  }
  return kernels;
}

}  // namespace
}  // namespace vesica

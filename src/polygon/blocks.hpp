// SPDX-License-Identifier: Apache-2.0
// Overlap of arrays that begin with polygons of three or four vertices: in lanes, a block of pairs at a time. Others
// among them, and what the lanes leave undecided, are answered one by one.
#pragma once

#include <algorithm>
#include <cstring>
#include <limits>
#include <vesica/polygon/few_vertices.hpp>

#include "polygon/arrays.hpp"
#include "polygon/topology.hpp"

namespace vesica::batch {

template <class T>
PathArray path_array(const Shapes<T>& s) noexcept {
  return {s.field[0].bytes(), s.field[1].bytes(), s.stride, s.rings, s.polygons, s.each};
}

/// 3 or 4 vertices of element i, or another number if it is no polygon of so few.
template <class T>
std::int64_t ring_size(const Shapes<T>& shapes, std::int64_t i) noexcept {
  if (shapes.kind != polygon_kind) return 0;
  return detail::polygon::few_vertices(detail::polygon::Edges(path_at<T>(path_array(shapes), i))).length();
}

/// Are the first elements alike, and does this instruction set have a kernel for them? Both arrays have elements.
template <class T>
bool begin_as_rings(const KernelTable& kernels, const Shapes<T>& a, const Shapes<T>& b) noexcept {
  const std::int64_t size = ring_size(a, 0);
  return (size == 3 || size == 4) && ring_size(b, 0) == size && kernels.rings(T{})[size - least_ring][0] != nullptr;
}

/// One answer of a question about paths.
template <class T>
std::uint8_t ask_path(Common common, const Element<T>& a, const Element<T>& b, Tally& tally) noexcept {
  const std::int32_t code = polygon::overlap_of(common, a.operand(), b.operand());
  tally.overlaps += code > 0;
  tally.invalid |= code < 0;
  return code > 0;
}

/// Rings of one size in columns, as kernels/rings.hpp takes them.
template <class T>
class RingColumns {
 public:
  /// Elements begin to begin + n - 1. Kernels decide no ring that has NaN: it stands for elements of another size, and
  /// fills the last vector.
  void set(const KernelTable& kernels, const Shapes<T>& shapes, std::int64_t begin, std::int32_t n,
           std::int64_t size) noexcept {
    for (std::int64_t k = 0; k < 2 * size; ++k) std::fill(column(k) + n, column(k) + whole(n), nan);
    const auto fields = static_cast<int>(2 * size);
    if (shapes.rings == nullptr && shapes.each == size && shapes.stride == 2 * sizeof(T) &&
        lies_in_records(shapes, 2)) {
      const std::ptrdiff_t stride = fields * static_cast<std::ptrdiff_t>(sizeof(T));
      kernels.copy_records(T{})(shapes.field[0].advanced(begin * stride), stride, fields, n, column_, ring_column);
      return;
    }
    for (std::int32_t i = 0; i < n; ++i) set_element(shapes, begin + i, i, size);
  }

  Unaligned<T> first() const noexcept { return column_; }
  /// Whole vectors of any instruction set.
  static std::int32_t whole(std::int32_t n) noexcept { return (n + 15) / 16 * 16; }

 private:
  T* column(std::int64_t k) noexcept { return column_ + k * ring_column; }

  void set_element(const Shapes<T>& shapes, std::int64_t element, std::int32_t i, std::int64_t size) noexcept {
    const detail::polygon::Edges<T> edges(path_at<T>(path_array(shapes), element));
    const detail::polygon::Range ring = detail::polygon::few_vertices(edges);
    for (std::int64_t k = 0; k < size; ++k) {
      const Point<double> p = ring.length() == size ? edges.vertex(ring.first + k) : Point<double>{nan, nan};
      column(2 * k)[i] = static_cast<T>(p.x);
      column(2 * k + 1)[i] = static_cast<T>(p.y);
    }
  }

  static constexpr T nan = std::numeric_limits<T>::quiet_NaN();

  alignas(64) T column_[8 * ring_column];
};

/// Pairs with elements of one array, some at a time.
template <class T>
class RingBlock {
 public:
  RingBlock(const KernelTable& kernels, Common common, const Shapes<T>& first, const Shapes<T>& second) noexcept
      : kernels_(kernels), common_(common), first_(first), second_(second) {}

  /// The elements of the second array, at most ring_column. `element` is the first array's that they meet first.
  void begin(std::int64_t begin, std::int32_t n, std::int64_t element) noexcept {
    begin_ = begin;
    n_ = n;
    size_ = ring_size(first_, element);
    in_lanes_ = n >= worth_lanes && (size_ == 3 || size_ == 4) && ring_size(second_, begin) == size_;
    if (in_lanes_) second_columns_.set(kernels_, second_, begin, n, size_);
  }

  /// With elements of the first array from `element` on, or with that one alone.
  void answer(std::int64_t element, Repeat repeat, std::uint8_t* out) noexcept {
    if (!in_lanes_) {
      for (std::int32_t i = 0; i < n_; ++i) out[i] = ask(element, repeat, i);
      return;
    }
    first_columns_.set(kernels_, first_, element, repeat == Repeat::first ? 1 : n_, size_);
    std::uint8_t bytes[ring_column];
    std::int32_t undecided[ring_column];
    Block<T> block{};
    block.first[0] = first_columns_.first();
    block.second[0] = second_columns_.first();
    block.count = RingColumns<T>::whole(n_);
    block.out = bytes;
    block.undecided = undecided;
    const BlockResult result = kernel(repeat)(block);
    std::memcpy(out, bytes, static_cast<std::size_t>(n_));
    std::int32_t overlaps = 0;
    for (std::int32_t i = 0; i < n_; ++i) overlaps += bytes[i];
    tally_.overlaps += overlaps;
    for (std::int32_t k = 0; k < result.undecided && undecided[k] < n_; ++k) {
      out[undecided[k]] = ask(element, repeat, undecided[k]);
    }
  }

  const Tally& tally() const noexcept { return tally_; }

 private:
  /// The number of pairs from which on lanes are quicker than one call after the other.
  static constexpr std::int32_t worth_lanes = 4;

  BlockKernel<T> kernel(Repeat repeat) const noexcept {
    return kernels_.rings(T{})[size_ - least_ring][static_cast<int>(repeat)];
  }

  std::uint8_t ask(std::int64_t element, Repeat repeat, std::int32_t i) noexcept {
    return ask_path<T>(common_, {first_, repeat == Repeat::first ? element : element + i}, {second_, begin_ + i},
                       tally_);
  }

  const KernelTable& kernels_;
  Common common_;
  const Shapes<T>&first_, &second_;
  Tally tally_;
  std::int64_t begin_ = 0, size_ = 0;
  std::int32_t n_ = 0;
  bool in_lanes_ = false;
  RingColumns<T> first_columns_, second_columns_;
};

/// As in_step().
template <class T, class Place, class Done>
Tally rings_in_step(const KernelTable& kernels, Common common, const Shapes<T>& a, const Shapes<T>& b, std::int64_t n,
                    Place place, Done done) noexcept {
  const bool in_order = b.count != 1 || n == 1;
  const Shapes<T>& first = in_order ? a : b;
  const Repeat repeat = first.count == 1 ? Repeat::first : Repeat::none;
  RingBlock<T> block(kernels, common, first, in_order ? b : a);
  for (std::int64_t begin = 0; begin < n; begin += ring_column) {
    const std::int32_t length = block_length(n - begin, ring_column);
    const std::int64_t element = repeat == Repeat::first ? 0 : begin;
    std::uint8_t* const out = place(begin);
    block.begin(begin, length, element);
    block.answer(element, repeat, out);
    done(begin, length, out);
  }
  return block.tally();
}

template <class T>
Tally ring_matrix(const KernelTable& kernels, Common common, const Shapes<T>& a, const Shapes<T>& b, std::uint8_t* out,
                  std::ptrdiff_t row_stride) noexcept {
  RingBlock<T> block(kernels, common, a, b);
  for (std::int64_t begin = 0; begin < b.count; begin += ring_column) {
    block.begin(begin, block_length(b.count - begin, ring_column), 0);
    for (std::int64_t i = 0; i < a.count; ++i) block.answer(i, Repeat::first, out + i * row_stride + begin);
  }
  return block.tally();
}

}  // namespace vesica::batch

// SPDX-License-Identifier: Apache-2.0
// Overlap of whole arrays, or of insides: memory layouts, blocks, and the exact answers of undecided lanes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vesica/contact.hpp>

#include "kernels/table.hpp"

namespace vesica::batch {

/// An array of shapes of one kind, as vesica_shapes_<T>, already validated; a single shape has stride 0.
template <class T>
struct Shapes {
  std::int32_t kind;
  std::int64_t count;
  /// Bytes from one element's number to the next one's; 0 where one shape repeats. Of paths: from vertex to vertex.
  std::ptrdiff_t stride;
  Unaligned<T> field[max_fields];
  /// For paths alone, as in vesica_shapes_<T>.
  const std::int32_t *rings = nullptr, *polygons = nullptr;
  std::int64_t each = 0;
};

/// How many pairs have a common point that counts, and whether any shape was invalid.
struct Tally {
  std::int64_t overlaps = 0;
  bool invalid = false;
};

/// out[i] = 1 where a[i] and b[i] have a common point that counts, else 0, for i < n.
template <class T>
Tally many(const KernelTable& kernels, const Shapes<T>& a, const Shapes<T>& b, std::int64_t n, std::uint8_t* out,
           Common common = Common::any) noexcept;

/// out[i * row_stride + j] = 1 where a[i] and b[j] do, else 0.
template <class T>
Tally matrix(const KernelTable& kernels, const Shapes<T>& a, const Shapes<T>& b, std::uint8_t* out,
             std::ptrdiff_t row_stride, Common common = Common::any) noexcept;

/// Writes the first `capacity` of the indices i, ascending, for which the one shape and many[i] do.
template <class T>
Tally select(const KernelTable& kernels, const Shapes<T>& one, const Shapes<T>& many, std::int64_t* out,
             std::int64_t capacity, Common common = Common::any) noexcept;

/// out[i] as in many() for overlap, for one block of columns, kinds in the order of shapes, n <= 512.
Tally overlap_block(const KernelTable& kernels, std::int32_t kind_first, const double* const* first,
                    std::int32_t kind_second, const double* const* second, std::int32_t n, std::uint8_t* out) noexcept;

}  // namespace vesica::batch

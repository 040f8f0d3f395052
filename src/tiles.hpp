// SPDX-License-Identifier: Apache-2.0
// Tiles of a matrix: some rows by some columns. Where boxes around both are apart, no pair of the tile overlaps, and
// none is looked at. Arrays in spatial order have many such tiles: there it gains 1.5 to 2.2 (1,024 x 1,024, 3% hits,
// AVX-512, Zen 5). In other arrays it costs 2%.
#pragma once

#include <cstring>
#include <limits>

#include "columns.hpp"
#include "index/kernels.hpp"

namespace vesica::batch {

/// A box that holds some shapes; the whole plane unless all of them are valid.
struct Surroundings {
  double min_x, min_y, max_x, max_y;

  bool apart_from(const Surroundings& o) const noexcept {
    return max_x < o.min_x || o.max_x < min_x || max_y < o.min_y || o.max_y < min_y;
  }
};

inline Surroundings around(const index::Boxes& boxes, std::int32_t n) noexcept {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Surroundings all{infinity, infinity, -infinity, -infinity};
  double valid = 0;
  for (std::int32_t i = 0; i < n; ++i) {
    all.min_x = boxes.min_x[i] < all.min_x ? boxes.min_x[i] : all.min_x;
    all.min_y = boxes.min_y[i] < all.min_y ? boxes.min_y[i] : all.min_y;
    all.max_x = boxes.max_x[i] > all.max_x ? boxes.max_x[i] : all.max_x;
    all.max_y = boxes.max_y[i] > all.max_y ? boxes.max_y[i] : all.max_y;
    valid += boxes.valid[i];
  }
  return valid == n ? all : Surroundings{-infinity, -infinity, infinity, infinity};
}

/// The modules for WebAssembly are downloaded: they go without, and look at all pairs.
#if defined(__wasm__)
inline constexpr bool has_tiles = false;
#else
inline constexpr bool has_tiles = true;
#endif

/// Finds which columns of a block some rows may meet.
template <class T>
class Tiles {
 public:
  /// Rows of a tile. A box around each would cost more than narrower tiles gain.
  static constexpr std::int32_t rows = 16;
  /// To put boxes around a block's shapes takes as long as some two rows of its answers.
  static constexpr std::int64_t worth_boxing = 128;

  Tiles(const KernelTable& kernels, const Shapes<T>& a, const Shapes<T>& b) noexcept
      : kernels_(kernels), boxes_(*kernels.index), a_(a), b_(b) {}

  /// Begins a block: the columns from `begin` on.
  void begin(std::int64_t begin, std::int32_t length) noexcept {
    length_ = length;
    vain_ = 0;
    if constexpr (has_tiles) {
      usable_ = a_.count >= worth_boxing && has_core(a_.kind) && has_core(b_.kind);
      for (std::int32_t i = 0; usable_ && i * stretch < length; ++i) {
        around_[i] = around(b_, begin + i * stretch, block_length(length - i * stretch, stretch));
      }
    }
  }

  /// Calls done(begin, length, met) for all columns of the block, in stretches that `n` rows from `row` on may meet, or
  /// surely do not.
  template <class Done>
  void each(std::int64_t row, std::int32_t n, Done done) noexcept {
    if constexpr (!has_tiles) return done(0, length_, true);
    if (!usable_) return done(0, length_, true);
    const Surroundings rows_box = around(a_, row, n);
    const auto met = [&](std::int32_t column) { return !rows_box.apart_from(around_[column / stretch]); };
    for (std::int32_t begin = 0, end = 0; begin < length_; begin = end) {
      const bool met_here = met(begin);
      while (end < length_ && met(end) == met_here) end += block_length(length_ - end, stretch);
      vain_ = met_here && end - begin == length_ ? vain_ + 1 : 0;
      done(begin, end - begin, met_here);
    }
    usable_ = vain_ < patience;
  }

 private:
  static constexpr std::int32_t stretch = 64;
  static constexpr int patience = 8;

  const KernelTable& kernels_;
  const index::Kernels& boxes_;
  const Shapes<T>&a_, &b_;
  bool usable_ = false;
  int vain_ = 0;  // tiles in turn that met all columns: after some, no more are looked at in this block
  std::int32_t length_ = 0;
  Surroundings around_[block_size<T> / stretch];

  [[gnu::noinline]] Surroundings around(const Shapes<T>& shapes, std::int64_t begin, std::int32_t n) const noexcept {
    Columns<T, stretch> columns;
    columns.set(kernels_, shapes, begin, n);
    index::Fields fields{};
    for (int k = 0; k < field_count(shapes.kind); ++k) widen(columns.field[k], n, fields.column[k]);
    index::Boxes boxes;
    boxes_.bounds(shapes.kind, fields, n, boxes);
    return batch::around(boxes, n);
  }

  void widen(Unaligned<T> from, std::int32_t n, double* to) const noexcept {
    if constexpr (sizeof(T) == sizeof(float)) {
      kernels_.widen_column(from, n, to);
    } else {
      std::memcpy(to, from.bytes(), static_cast<std::size_t>(n) * sizeof(double));
    }
  }
};

}  // namespace vesica::batch

// SPDX-License-Identifier: Apache-2.0
// An instruction set's tables: for each pair of kinds and scalar, a kernel that answers one block.
#pragma once

#include <cstdint>
#include <vesica/shapes.hpp>

#include "unaligned.hpp"

/// Hidden symbol: reached without the global offset table.
#if defined(__ELF__)
#define VESICA_HIDDEN [[gnu::visibility("hidden")]]
#else
#define VESICA_HIDDEN
#endif

namespace vesica {

namespace index {
struct Kernels;
}

/// A block of pairs: element i of each field of a shape at first[field][i]; a repeated shape has its numbers at [0].
template <class T>
struct Block {
  Unaligned<T> first[max_fields];
  Unaligned<T> second[max_fields];
  std::int32_t count;       // for kernels a multiple of the vector's width
  std::uint8_t* out;        // count bytes: 1 where the filter is sure of overlap, else 0
  std::int32_t* undecided;  // room for count indices, ascending
  std::int32_t give_up;     // more undecided than this, and the kernel stops: the caller then asks another way
  T extent;                 // for checked kernels: what check_block() found
  // Bytes from one element's number to the next one's, 0 for a repeated shape. Kernels know them.
  std::ptrdiff_t stride_first, stride_second;
};

struct BlockResult {
  std::int32_t overlaps;
  std::int32_t undecided;
};

template <class T>
using BlockKernel = BlockResult (*)(const Block<T>&) noexcept;

/// Which operand, if any, is one shape repeated. Of two shapes of one kind the second has no kernel of its own.
enum class Repeat { none, first, second };
inline constexpr int repeat_count = 3;

/// Kernels by Repeat. `unit` is quicker, but leaves axes whose length is not near 1 and thin ellipses undecided; where
/// nothing is quicker it is `general`.
template <class T>
struct PairKernels {
  BlockKernel<T> general[repeat_count];
  BlockKernel<T> unit[repeat_count];
};

/// Indexed by the two kinds in the order of shapes; the other half is empty.
template <class T>
using ScalarKernels = PairKernels<T>[kind_count][kind_count];

/// Kernels for two shapes of one kind where the second, and unless it is repeated the first, are records without gaps:
/// in step, and one against many. They do what those of `unit` do for columns. Null where there are none.
template <class T>
using PackedKernels = BlockKernel<T>[kind_count][2];
#if defined(__x86_64__)
inline constexpr bool has_packed_kernels = true;
#else
inline constexpr bool has_packed_kernels = false;
#endif

/// Kernels for insides of points or AABBs and AABBs, whose comparisons decide touching too. By the first kind.
template <class T>
struct InsidesKernels {
  PairKernels<T> of[kind_count];
  PackedKernels<T> packed;
};

/// Kernels for polygons of one ring of three or four vertices, in columns that lie one behind the other from the first
/// field on, whole vectors: in step, and one against many. They count nothing. Null for WebAssembly.
inline constexpr int ring_column = 128, least_ring = 3, ring_sizes = 2;
template <class T>
using RingKernels = BlockKernel<T>[ring_sizes][2];

/// Checked kernels: for the shape of a row against a block of columns that was checked before, by the two kinds. Only
/// rectangles and ellipses have them.
template <class T>
struct CheckedKernels {
  struct Pair {
    /// True if answer() may be called; checked.hpp says what else it does.
    bool (*check_block)(Block<T>& block, T* space, std::int32_t stride) noexcept;
    /// Returns row_is_unusable as the number of undecided pairs if it cannot take the row's shape.
    BlockKernel<T> answer;
  };
  Pair of[kind_count][kind_count];  // the row's kind, the columns'
};
inline constexpr std::int32_t row_is_unusable = INT32_MAX;

/// Copies n records, `stride` bytes apart, of `fields` adjacent numbers to columns, `column_length` numbers apart.
template <class T>
using CopyRecords = void (*)(Unaligned<T> from, std::ptrdiff_t stride, int fields, std::int32_t n, T* columns,
                             std::int32_t column_length) noexcept;

/// Fallback of a cast if the early out finds no miss. The filter's verdict is passed on: `open` where subnormals are
/// flushed.
namespace detail::cast {
enum class EarlyOut;
}
template <class T>
using RestOfCast = std::int32_t (*)(const void* a, const void* b, T vx, T vy, T end, void* out,
                                    detail::cast::EarlyOut early) noexcept;

/// Casts by an early out, in any floating-point environment, without reading the control register. By the two kinds;
/// null where there is none. kernels/cast_calls.hpp has the functions.
struct CallTable {
  template <class T>
  using Cast = std::int32_t (*)(const void* a, const void* b, T vx, T vy, T end, void* out,
                                RestOfCast<T> rest) noexcept;
  Cast<float> casts_f32[kind_count][kind_count];
  Cast<double> casts_f64[kind_count][kind_count];

  Cast<float> cast(float, int a, int b) const noexcept { return casts_f32[a][b]; }
  Cast<double> cast(double, int a, int b) const noexcept { return casts_f64[a][b]; }
};

struct QueryTable;

struct KernelTable {
  const char* name;
  const QueryTable* queries;          // of the same instruction set
  const index::Kernels* index;        // likewise
  std::int32_t width_f32, width_f64;  // lanes of a vector
  void (*widen_column)(Unaligned<float> from, std::int32_t n, double* to) noexcept;
  CopyRecords<float> copy_records_f32;
  CopyRecords<double> copy_records_f64;
  ScalarKernels<float> f32;
  ScalarKernels<double> f64;
  CheckedKernels<float> checked_f32;
  CheckedKernels<double> checked_f64;
  PackedKernels<float> packed_f32;
  PackedKernels<double> packed_f64;
  InsidesKernels<float> insides_f32;
  InsidesKernels<double> insides_f64;
  RingKernels<float> rings_f32;
  RingKernels<double> rings_f64;

  std::int32_t width(float) const noexcept { return width_f32; }
  std::int32_t width(double) const noexcept { return width_f64; }
  CopyRecords<float> copy_records(float) const noexcept { return copy_records_f32; }
  CopyRecords<double> copy_records(double) const noexcept { return copy_records_f64; }
  const ScalarKernels<float>& of(float) const noexcept { return f32; }
  const ScalarKernels<double>& of(double) const noexcept { return f64; }
  const CheckedKernels<float>& checked(float) const noexcept { return checked_f32; }
  const CheckedKernels<double>& checked(double) const noexcept { return checked_f64; }
  const PackedKernels<float>& packed(float) const noexcept { return packed_f32; }
  const PackedKernels<double>& packed(double) const noexcept { return packed_f64; }
  const InsidesKernels<float>& insides(float) const noexcept { return insides_f32; }
  const InsidesKernels<double>& insides(double) const noexcept { return insides_f64; }
  const RingKernels<float>& rings(float) const noexcept { return rings_f32; }
  const RingKernels<double>& rings(double) const noexcept { return rings_f64; }
};

/// The instruction sets built for this machine's architecture. The portable one is a single lane and runs anywhere; the
/// library has it only where the architecture's baseline has no vectors that it knows.
extern const KernelTable kernels_portable;
#if defined(__x86_64__)
VESICA_HIDDEN extern const KernelTable kernels_sse2, kernels_avx2, kernels_avx512;
VESICA_HIDDEN extern const CallTable kernels_avx512_calls;
#elif defined(__aarch64__)
extern const KernelTable kernels_neon;
#elif defined(__wasm_simd128__)
extern const KernelTable kernels_simd128;
#endif

/// The table chosen when the library was loaded.
const KernelTable& kernels() noexcept;

#if !defined(__wasm__)
/// The library's only variable: that table, null until it is chosen.
VESICA_HIDDEN extern const KernelTable* chosen_kernels;
#endif

/// The calls of the chosen instruction set; null if it has none, or none is chosen yet.
inline const CallTable* chosen_calls() noexcept {
#if defined(__x86_64__) && !defined(VESICA_PORTABLE_ONLY)
  if (__atomic_load_n(&chosen_kernels, __ATOMIC_RELAXED) == &kernels_avx512) return &kernels_avx512_calls;
#endif
  return nullptr;
}

}  // namespace vesica
